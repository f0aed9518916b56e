// A line round what the mask covers: red what is selected, green what the pointer is over.
uniform sampler2D mask;
uniform vec3 selected_color;
uniform vec3 hovered_color;
uniform int reach;

out vec4 fragment_color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(mask, 0) - ivec2(1);
    vec2 here = texelFetch(mask, at, 0).rg;
    vec2 near = vec2(0.0);
    for (int y = -reach; y <= reach; y++) {
        for (int x = -reach; x <= reach; x++) {
            // A disc, not a square: the line is equally wide in all directions.
            if (x * x + y * y <= reach * reach) {
                ivec2 beside = clamp(at + ivec2(x, y), ivec2(0), last);
                near = max(near, texelFetch(mask, beside, 0).rg);
            }
        }
    }
    vec2 edge = near * (vec2(1.0) - here);
    if (max(edge.x, edge.y) < 0.5) {
        discard;
    }
    fragment_color = vec4(edge.x >= 0.5 ? selected_color : hovered_color, 1.0);
}
