//! Editing as data: an [`Edit`] says how the document changes, and [`apply`] alone carries it out;
//! a [`Session`] is a document with the selection and the view of its user.

mod apply;
mod apply_curve;
mod change;
mod command;
mod control_point_drag;
mod gizmo;
mod ik_grip;
mod ik_settings;
mod ik_tool;
mod joint_turn;
mod messages;
mod move_gizmo;
mod move_tool;
mod pose_tool;
mod ring_drag;
mod rotation_gizmo;
mod session;
mod tool;

pub use apply::{EditError, apply};
pub use change::Change;
pub use command::{Edit, View};
pub use control_point_drag::{ControlPointDrag, control_point_at};
pub use gizmo::{GizmoAxes, GizmoHit, Handle, Screen};
pub use ik_grip::IkGrip;
pub use ik_settings::{IkPole, IkSettings};
pub use ik_tool::IkDrag;
pub use joint_turn::JointTurn;
pub use messages::{Message, Messages, Severity};
pub use move_gizmo::MoveGizmo;
pub use move_tool::{MoveAlong, MoveDrag, MoveTarget, root_of};
pub use pose_tool::{BoneDrag, ROLL_STEP, roll};
pub use ring_drag::RingDrag;
pub use rotation_gizmo::{RingPoint, RotationGizmo};
pub use session::Session;
pub use tool::Tool;
