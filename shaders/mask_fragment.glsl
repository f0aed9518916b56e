// One flat color, to tell what covers which pixels.
in vec3 world_position;
in vec3 world_normal;
flat in vec3 face_normal;
in vec3 tint;

uniform vec3 color;

out vec4 fragment_color;

void main() {
    fragment_color = vec4(color, 1.0);
}
