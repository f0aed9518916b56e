// Grid lines as wide as a pixel at any distance, and shadows with soft edges, fading into the
// background towards the rim of the square.
in vec2 on_ground;

uniform vec2 center;
uniform float reach;
// As in ground_vertex.glsl.
uniform float near;
#ifdef SHADOWS
// White where the ground has no light, as large as the picture that is drawn, with mipmaps.
uniform sampler2D shadows;
// How far the edge of a shadow fades, in the world.
uniform float softness;
#endif

// 1 if the ground hides what is below it: the background is then drawn anew under all that follows.
uniform float opaque;
// The light that the ground takes round the middle, so that shadows show; 0 seen from below, where
// it would stand before the shapes.
uniform float lit;
// The background, as in background_fragment.glsl, and the height of what is drawn in pixels.
uniform vec3 top;
uniform vec3 bottom;
uniform float lowest;
uniform float part;
uniform float picture_height;
// 1 with the lines of the grid, 0 without.
uniform float grid;

uniform vec3 ground;
uniform vec3 line_color;
// The share of its light that the ground loses in the deepest shadow.
uniform float darkness;

out vec4 fragment_color;

float lines(vec2 at, float spacing) {
    vec2 cell = at / spacing;
    vec2 width = fwidth(cell);
    vec2 near = 1.0 - min(abs(fract(cell - 0.5) - 0.5) / width, vec2(1.0));
    // Lines closer together than pixels would flicker: they fade out instead.
    vec2 readable = clamp(1.0 - 2.0 * width, 0.0, 1.0);
    return max(near.x * readable.x, near.y * readable.y);
}

#ifdef SHADOWS
// The shadow round a point, averaged over as many pixels as the softness takes up there. The flatter the ground is
// seen, the fewer rows these are: ten looks, side by side, at a version of the picture whose pixels are about as
// high as that, or a third as wide, so that thin shadows do not blur away among what is before and behind them.
float shadow(vec2 world_per_pixel) {
    vec2 radius = clamp(softness / world_per_pixel, 1.0, 64.0);
    float level = log2(max(radius.y, radius.x / 3.0));
    vec2 size = vec2(textureSize(shadows, 0));
    float sum = 0.0;
    for (int x = -2; x <= 2; x++) {
        float weight = float(3 - abs(x));
        for (int y = -1; y <= 1; y += 2) {
            vec2 offset = vec2(0.375 * float(x), 0.5 * float(y)) * radius;
            sum += weight * textureLod(shadows, (gl_FragCoord.xy + offset) / size, level).r;
        }
    }
    return sum / 18.0;
}
#endif

void main() {
    if (near > 0.0 && 1.0 / gl_FragCoord.w > near) {
        discard;
    }
    float strength = max(0.35 * lines(on_ground, 1.0), 0.6 * lines(on_ground, 10.0));
    float away = length(on_ground - center) / reach;
    float fade = 1.0 - smoothstep(0.3, 1.0, away);
    float coverage = grid * strength * fade;
    float pool = lit * (1.0 - smoothstep(0.0, 0.3, away));
    float shade = 0.0;
#ifdef SHADOWS
    vec2 world_per_pixel = vec2(length(dFdx(on_ground)), length(dFdy(on_ground)));
    shade = darkness * fade * shadow(max(world_per_pixel, 1e-6));
#endif
    if (max(max(coverage, shade), max(pool, opaque)) <= 0.004) {
        discard;
    }
    // From the bottom up: the background, the lit ground, the shadow, which darkens what is behind the
    // ground as well, and the lines, which lose some of their light, too.
    float up = lowest + part * gl_FragCoord.y / picture_height;
    vec3 background = mix(bottom, top, smoothstep(0.0, 1.0, up));
    vec4 seen = vec4(background * opaque, opaque) * (1.0 - pool) + vec4(ground * pool, pool);
    seen = vec4(seen.rgb * (1.0 - shade), 1.0 - (1.0 - seen.a) * (1.0 - shade));
    vec3 line = line_color * (1.0 - 0.6 * shade);
    fragment_color = vec4(line * coverage, coverage) + (1.0 - coverage) * seen;
}
