// A surface in model space.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 7) in vec2 texture_coordinates;
layout(location = 8) in float number;

uniform mat4 clip_from_world;
uniform mat4 world_from_model;
uniform mat3 world_from_model_normal;

out vec3 world_position;
out vec3 world_normal;
// The same, of the triangle's last corner alone.
flat out vec3 face_normal;
out vec3 tint;
flat out vec3 copy_color;
out vec2 on_picture;
out float shown_number;

void main() {
    vec4 world = world_from_model * vec4(position, 1.0);
    world_position = world.xyz;
    world_normal = world_from_model_normal * normal;
    face_normal = world_normal;
    tint = vec3(1.0);
    copy_color = vec3(1.0);
    on_picture = texture_coordinates;
    shown_number = number;
    gl_Position = clip_from_world * world;
}
