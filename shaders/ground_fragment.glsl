// Grid lines as wide as a pixel at any distance, fading towards the rim of the square.
in vec2 on_ground;

uniform vec2 center;
uniform float reach;

out vec4 fragment_color;

float lines(vec2 at, float spacing) {
    vec2 cell = at / spacing;
    vec2 width = fwidth(cell);
    vec2 near = 1.0 - min(abs(fract(cell - 0.5) - 0.5) / width, vec2(1.0));
    // Lines closer together than pixels would flicker: they fade out instead.
    vec2 readable = clamp(1.0 - 2.0 * width, 0.0, 1.0);
    return max(near.x * readable.x, near.y * readable.y);
}

void main() {
    float strength = max(0.35 * lines(on_ground, 1.0), 0.6 * lines(on_ground, 10.0));
    float fade = 1.0 - smoothstep(0.3, 1.0, length(on_ground - center) / reach);
    float coverage = strength * fade;
    if (coverage <= 0.004) {
        discard;
    }
    fragment_color = vec4(vec3(0.72, 0.76, 0.82), coverage);
}
