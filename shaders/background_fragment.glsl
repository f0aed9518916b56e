// From one color at the bottom of the picture to another at its top.
in vec2 across;

uniform vec3 top;
uniform vec3 bottom;
// Where the drawn part of the picture begins, and its share of the height.
uniform float lowest;
uniform float part;

out vec4 fragment_color;

void main() {
    fragment_color = vec4(mix(bottom, top, smoothstep(0.0, 1.0, lowest + part * across.y)), 1.0);
}
