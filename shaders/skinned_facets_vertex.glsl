// A character's surface in its bind pose, moved by its joints, with one normal a triangle: that of
// the moved corners, as the assignment asks. The last corner of a triangle carries it, and knows
// where the other two are. Follows skinning.glsl.
layout(location = 0) in vec3 position;
layout(location = 2) in uvec2 run;
layout(location = 3) in vec3 first_position;
layout(location = 4) in uvec2 first_run;
layout(location = 5) in vec3 second_position;
layout(location = 6) in uvec2 second_run;
layout(location = 7) in vec2 texture_coordinates;
layout(location = 8) in float number;

uniform mat4 clip_from_world;

out vec3 world_position;
out vec3 world_normal;
flat out vec3 face_normal;
out vec3 tint;
// Color of all of this copy: interpolated, it would be off by a rounding.
flat out vec3 copy_color;
out vec2 on_picture;
out float shown_number;

void main() {
    vec3 at = moved(model_from_bind(run), position);
    vec3 first = moved(model_from_bind(first_run), first_position);
    vec3 second = moved(model_from_bind(second_run), second_position);
    vec4 world = world_from_model() * vec4(at, 1.0);
    world_position = world.xyz;
    world_normal = world_from_model_normal() * unit_or(cross(second - first, at - first), vec3(0.0));
    face_normal = world_normal;
    tint = vec3(1.0);
    copy_color = own_color();
    on_picture = texture_coordinates;
    shown_number = number;
    gl_Position = clip_from_world * world;
}
