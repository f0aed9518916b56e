// A unit shape, once for every joint or bone.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 world_from_unit_x;
layout(location = 3) in vec4 world_from_unit_y;
layout(location = 4) in vec4 world_from_unit_z;
layout(location = 5) in vec4 world_from_unit_w;
layout(location = 6) in vec3 instance_color;

uniform mat4 clip_from_world;

out vec3 world_position;
out vec3 world_normal;
// The same, of the triangle's last corner alone.
flat out vec3 face_normal;
out vec3 tint;
flat out vec3 copy_color;
out vec2 on_picture;

void main() {
    mat4 world_from_unit =
        mat4(world_from_unit_x, world_from_unit_y, world_from_unit_z, world_from_unit_w);
    vec4 world = world_from_unit * vec4(position, 1.0);
    world_position = world.xyz;
    world_normal = transpose(inverse(mat3(world_from_unit))) * normal;
    face_normal = world_normal;
    tint = instance_color;
    copy_color = vec3(1.0);
    on_picture = vec2(0.0);
    gl_Position = clip_from_world * world;
}
