// A square on the ground, about a point below the camera's target.
layout(location = 0) in vec2 corner;

uniform mat4 clip_from_world;
uniform vec2 center;
uniform float reach;
uniform float height;
// 0, or the distance of the near plane, before which alone the ground is drawn.
uniform float near;

out vec2 on_ground;

void main() {
    on_ground = center + corner * reach;
    gl_Position = clip_from_world * vec4(on_ground.x, height, on_ground.y, 1.0);
    if (near > 0.0) {
        // Not cut off there.
        gl_Position.z = 0.0;
    } else {
        // What lies exactly on the ground is before it.
        gl_Position.z += 4e-6 * gl_Position.w;
    }
}
