// A surface in the colors of the numbers at its vertices. The number is what is interpolated, and each
// pixel looks its color up. Light comes from the eye and is nearly even in every look, so that a color
// can be found again in the legend.
in vec3 world_position;
in vec3 world_normal;
flat in vec3 face_normal;
in float shown_number;

uniform float alpha;
uniform int flat_normals;
uniform vec3 eye;
// Numbers at the ends of the scale.
uniform float low;
uniform float high;
// Numbers up to this one have a color of their own.
uniform float gray_up_to;
uniform vec3 gray;
// The scale, the dark end at u = 0.
uniform sampler2D scale;

out vec4 fragment_color;

vec3 unit(vec3 v) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : vec3(0.0);
}

vec3 color_of(float number) {
    if (number <= gray_up_to) {
        return gray;
    }
    float range = high - low;
    float part = range > 0.0 ? clamp((number - low) / range, 0.0, 1.0) : 0.0;
    // From the middle of the first cell to that of the last.
    float cells = float(textureSize(scale, 0).x);
    return texture(scale, vec2((part * (cells - 1.0) + 0.5) / cells, 0.5)).rgb;
}

void main() {
    vec3 n = unit(flat_normals == 1 ? face_normal : world_normal);
    float facing = abs(dot(n, unit(eye - world_position)));
    fragment_color = vec4(color_of(shown_number) * (0.7 + 0.3 * facing), alpha);
}
