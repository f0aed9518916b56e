// Points, lines and triangles of the compatibility layer: position and color as given.
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;

uniform mat4 clip_from_world;
uniform float sprite_size;

out vec4 vertex_color;

void main() {
    vertex_color = color;
    gl_Position = clip_from_world * position;
    gl_PointSize = sprite_size;
}
