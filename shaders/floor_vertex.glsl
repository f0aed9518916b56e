// The whole picture, with the ray that each pixel looks along: one unit ahead of the eye.
layout(location = 0) in vec2 corner;

uniform vec3 ahead;
// Half the picture's width and height, one unit ahead of the eye.
uniform vec3 across;
uniform vec3 upwards;

out vec3 ray;

void main() {
    ray = ahead + corner.x * across + corner.y * upwards;
    gl_Position = vec4(corner, 0.0, 1.0);
}
