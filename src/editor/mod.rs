//! Editing as data: an [`Edit`] describes a change of the document, and [`apply`] alone carries it
//! out; a [`Session`] is a document with the selection and the view of its user. Drags of the tools
//! turn the pointer's position into edits.

mod among;
mod apply;
mod constraint;
mod control_point_drag;
mod edit;
mod gizmo;
mod ground;
mod hiding;
mod history;
mod ik_grip;
mod ik_tool;
mod limbs;
mod messages;
mod move_tool;
mod movement;
mod rotate_tool;
mod selection;
mod session;
mod shape_group;
mod shape_scale;
mod shape_turn;
mod standing;
mod step_name;
mod swing;

pub use among::{
    bounds_of, is_deep, put_on_ground, set_among, set_beside_each_other, set_beside_others,
};
pub use apply::{Change, EditError, apply};
pub use constraint::Constraint;
pub use control_point_drag::{ControlPointDrag, control_point_at};
pub use edit::{Edit, View};
pub use gizmo::{
    GizmoAxes, GizmoHit, Handle, MoveGizmo, RingPoint, RotationGizmo, ScaleGizmo, Screen,
};
pub use ground::kept_on_ground;
pub use ik_grip::IkGrip;
pub use ik_tool::IkDrag;
pub use messages::{Message, Messages, Severity};
pub use move_tool::{MoveDrag, MoveTarget, root_of, selected_roots};
pub use movement::MoveAlong;
pub use rotate_tool::{BoneDrag, JointTurn, ROLL_STEP, RingDrag, Together, roll};
pub use selection::{
    BoxMode, duplicates, duplicates_in_place, for_all_in_view, for_all_selected, scene_of_selected,
    set_apart,
};
pub use session::Session;
pub use shape_group::{SCALES, ShapeGroup, kept_at_pivot};
pub use shape_scale::{ScaleBy, ShapeScale};
pub use shape_turn::ShapeTurn;

/// Tool of the view: what a left drag does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Moves the camera.
    #[default]
    Select,
    /// Turns the bone under the pointer ([`BoneDrag`]), or by a ring of its gizmo ([`RingDrag`]).
    Pose,
    /// Moves the shape under the pointer, or the root above the bone, if it shows or that root is selected
    /// ([`MoveDrag`]).
    Move,
    /// Turns the selected shapes by the rings of a gizmo ([`ShapeTurn`]).
    Rotate,
    /// Scales the selected shapes by the handles of a gizmo ([`ShapeScale`]).
    Scale,
    /// Moves the end of the bone under the pointer by inverse kinematics ([`IkDrag`]).
    Ik,
}

impl Tool {
    /// Whether it takes the bones under the pointer.
    pub fn takes_bones(self) -> bool {
        matches!(self, Self::Pose | Self::Move | Self::Ik)
    }
}
