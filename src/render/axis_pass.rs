use super::frame::PassContext;
use crate::gpu::{DrawState, Gl, Immediate, Mode};
use glam::Vec3;

/// How far the axes reach to either side.
const REACH: f32 = 50.0;

/// Draws the world's axes through the compatibility layer: X red, Y green, Z blue.
pub(super) fn draw_axis(gl: &Gl, immediate: &mut Immediate, context: &PassContext) {
    DrawState::opaque(context.width, context.height).apply(gl);
    immediate.load_matrix(context.clip_from_world);
    immediate.line_width(1.0);
    immediate.begin(Mode::Lines);
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        immediate.color(axis);
        immediate.vertex(axis * -REACH);
        immediate.vertex(axis * REACH);
    }
    immediate.end();
}
