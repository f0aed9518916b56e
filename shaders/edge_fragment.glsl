// A line round what the mask covers: red the active shape, blue those selected with it, green what the
// pointer is over.
uniform sampler2D mask;
uniform vec3 selected_color;
uniform vec3 hovered_color;
uniform vec3 other_color;
uniform int reach;

out vec4 fragment_color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(mask, 0) - ivec2(1);
    vec3 here = texelFetch(mask, at, 0).rgb;
    vec3 near = vec3(0.0);
    for (int y = -reach; y <= reach; y++) {
        for (int x = -reach; x <= reach; x++) {
            // A disc, not a square: the line is equally wide in all directions.
            if (x * x + y * y <= reach * reach) {
                ivec2 beside = clamp(at + ivec2(x, y), ivec2(0), last);
                near = max(near, texelFetch(mask, beside, 0).rgb);
            }
        }
    }
    vec3 edge = near * (vec3(1.0) - here);
    if (max(edge.r, max(edge.g, edge.b)) < 0.5) {
        discard;
    }
    vec3 color = edge.b >= 0.5 ? other_color : hovered_color;
    fragment_color = vec4(edge.r >= 0.5 ? selected_color : color, 1.0);
}
