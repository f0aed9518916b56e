use super::frame::{Frame, PassContext};
use crate::gpu::{DepthTest, DrawState, Gl, Immediate, Mode};
use crate::scene::bones_in_world;
use glam::Vec3;

const BONE: Vec3 = Vec3::X;
const HOVERED: Vec3 = Vec3::new(0.0, 1.0, 1.0);

/// Draws the bones of all characters as the Mannequin look has them: red lines over everything,
/// cyan where the pointer is.
pub(super) fn draw_bone_lines(
    gl: &Gl,
    context: &PassContext,
    frame: &Frame,
    immediate: &mut Immediate,
) {
    let state = DrawState {
        depth_test: DepthTest::Off,
        depth_write: false,
        ..DrawState::opaque(context.width, context.height)
    };
    state.apply(gl);
    immediate.load_matrix(context.clip_from_world);
    immediate.line_width(1.0);
    immediate.begin(Mode::Lines);
    for (_, shape) in frame.shapes() {
        let is_selected = frame.marks.selected == Some(shape.id);
        let hovered = frame.marks.hovered_joint.filter(|_| is_selected);
        for (joint, start, end) in bones_in_world(frame.scene, shape) {
            immediate.color(if hovered == Some(joint) {
                HOVERED
            } else {
                BONE
            });
            immediate.vertex(start);
            immediate.vertex(end);
        }
    }
    immediate.end();
}
