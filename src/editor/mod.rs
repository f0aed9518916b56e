//! What a person does to a scene, as data: panels and tools return [`Action`]s, and
//! [`apply_edit`] and [`apply_view`] are the only places that change anything.

mod apply;
mod apply_curve;
mod command;
mod comparison;
mod control_point_drag;
mod messages;
mod session;

pub use apply::{apply_edit, apply_view};
pub use command::{Action, Ask, Edit, Screenshot, View};
pub use comparison::{CompareAction, CompareMode, CompareSettings, Mask};
pub use control_point_drag::{ControlPointDrag, control_point_at};
pub use messages::{Message, Messages, Severity};
pub use session::Session;
