// The four bytes of a number as a color.
flat in uint bits;

out vec4 fragment_color;

void main() {
    uvec4 bytes = uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u;
    fragment_color = vec4(bytes) / 255.0;
}
