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
    vec2 most = vec2(0.0);
    vec2 least = vec2(1.0);
    for (int y = -reach; y < block + reach; y++) {
        for (int x = -reach; x < block + reach; x++) {
            vec2 here = texelFetch(mask, clamp(first + ivec2(x, y), ivec2(0), last), 0).rg;
            most = max(most, here);
            least = min(least, here);
        }
    }
    vec2 edge = step(vec2(0.5), most) * step(least, vec2(0.5));
    fragment_color = vec4(max(edge.x, edge.y));
}
