use crate::gpu::Program;
use crate::scene::{Camera, Look};
use glam::Vec3;

/// Where the Course look's light stands, in the world.
const COURSE_LIGHT: Vec3 = Vec3::new(10.0, 10.0, 30.0);
/// Where the Mannequin look's light stands, in the world.
pub(super) const MANNEQUIN_LIGHT: Vec3 = Vec3::new(-10.0, 10.0, -10.0);

/// Tells a program that includes `surface_fragment.glsl` how to light. The Studio look's lights
/// hang on the camera's heading, so that a character is lit well from every side.
pub(super) fn set_lights(program: &Program, look: Look, camera: &Camera) {
    program.set_i32(
        "look",
        match look {
            Look::Course => 0,
            Look::Studio => 1,
            Look::Mannequin => 2,
        },
    );
    program.set_vec3("course_light", COURSE_LIGHT);
    program.set_vec3("mannequin_light", MANNEQUIN_LIGHT);
    program.set_vec3("eye", camera.eye());
    let right = camera.right();
    let back = right.cross(Vec3::Y);
    let direction =
        |x: f32, y: f32, z: f32| (right * x + Vec3::Y * y + back * z).normalize_or(Vec3::Y);
    program.set_vec3("key_direction", direction(-0.55, 0.8, 0.75));
    program.set_vec3("fill_direction", direction(0.9, 0.25, 0.6));
    program.set_vec3("rim_direction", direction(0.35, 0.7, -0.9));
}
