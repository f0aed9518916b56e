// From one color at the bottom of the picture to another at its top.
in vec2 across;

uniform vec3 top;
uniform vec3 bottom;

out vec4 fragment_color;

void main() {
    fragment_color = vec4(mix(bottom, top, smoothstep(0.0, 1.0, across.y)), 1.0);
}
