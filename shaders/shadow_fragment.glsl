// What lies in the shadow of a surface that was flattened onto the ground on its way here. Only
// what is above the ground keeps light from it.
in vec3 world_position;

uniform float ground;

out vec4 fragment_color;

void main() {
    if (world_position.y <= ground) {
        discard;
    }
    fragment_color = vec4(1.0);
}
