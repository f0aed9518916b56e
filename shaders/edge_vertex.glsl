// Squares over those blocks of the picture through which a line may pass.
layout(location = 0) in vec4 block_and_corner;

uniform sampler2D blocks;
// Side of a block, and width and height of the picture, in pixels.
uniform float block;
uniform vec2 picture;

void main() {
    vec2 pixel = min((block_and_corner.xy + block_and_corner.zw) * block, picture);
    bool drawn = texelFetch(blocks, ivec2(block_and_corner.xy), 0).r > 0.5;
    // All corners of the others are in one place outside the picture, where nothing is drawn.
    gl_Position = drawn ? vec4(2.0 * pixel / picture - vec2(1.0), 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
