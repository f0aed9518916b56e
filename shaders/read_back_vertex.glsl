// Follows a vertex shader of surfaces, whose main is called surface_main here: one number of what it
// makes of each vertex goes to a pixel of its own.
uniform int pixels_a_row;
uniform int rows;
// 0 to 2: the position in the world; 3 to 5: the normal.
uniform int component;

flat out uint bits;

void main() {
    surface_main();
    bits = floatBitsToUint(component < 3 ? world_position[component] : world_normal[component - 3]);
    vec2 pixel = vec2(float(gl_VertexID % pixels_a_row), float(gl_VertexID / pixels_a_row));
    vec2 size = vec2(float(pixels_a_row), float(rows));
    gl_Position = vec4(2.0 * (pixel + 0.5) / size - 1.0, 0.0, 1.0);
    gl_PointSize = 1.0;
}
