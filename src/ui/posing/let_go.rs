//! What a hand has let go of.

use crate::editor::{Session, Tool};
use crate::scene::ShapeId;
use egui::Pos2;

/// What was turned last is at hand, wherever that has left the pointer, until the pointer moves, or another tool or other
/// joints are chosen.
#[derive(Clone, Debug)]
pub(in crate::ui) struct LetGo {
    /// The place of the pointer.
    at: Pos2,
    /// The character and the joint.
    pub held: (ShapeId, usize),
    /// The tool that has turned it.
    tool: Tool,
    /// The joints that were selected then.
    joints: Vec<usize>,
}

impl LetGo {
    pub(super) fn new(at: Pos2, held: (ShapeId, usize), tool: Tool, session: &Session) -> Self {
        Self {
            at,
            held,
            tool,
            joints: session.selected_joints().to_vec(),
        }
    }

    pub(super) fn is_at_hand(&self, at: Option<Pos2>, tool: Tool, session: &Session) -> bool {
        at == Some(self.at) && tool == self.tool && session.selected_joints() == self.joints
    }
}
