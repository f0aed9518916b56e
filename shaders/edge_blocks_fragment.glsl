// One texel a block of pixels: 1 if a line round what the mask covers may pass through the block.
uniform sampler2D mask;
uniform int reach;
// Side of a block in pixels.
uniform int block;

in vec2 across;

out vec4 fragment_color;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * block;
    ivec2 last = textureSize(mask, 0) - ivec2(1);
    vec3 most = vec3(0.0);
    vec3 least = vec3(1.0);
    for (int y = -reach; y < block + reach; y++) {
        for (int x = -reach; x < block + reach; x++) {
            vec3 here = texelFetch(mask, clamp(first + ivec2(x, y), ivec2(0), last), 0).rgb;
            most = max(most, here);
            least = min(least, here);
        }
    }
    vec3 edge = step(vec3(0.5), most) * step(least, vec3(0.5));
    fragment_color = vec4(max(edge.r, max(edge.g, edge.b)));
}
