// Points are squares to OpenGL; this cuts the disc out of them.
in vec4 vertex_color;

// 0: no point, or a square one; 1: a disc with hard edges; 2: a disc whose edge fades out.
uniform int point_shape;
uniform float point_size;
uniform float sprite_size;

out vec4 fragment_color;

void main() {
    float coverage = 1.0;
    if (point_shape != 0) {
        float inside = 0.5 * point_size - sprite_size * length(gl_PointCoord - vec2(0.5));
        coverage = point_shape == 1 ? step(0.0, inside) : clamp(inside + 0.5, 0.0, 1.0);
        if (coverage <= 0.0) {
            discard;
        }
    }
    fragment_color = vec4(vertex_color.rgb, vertex_color.a * coverage);
}
