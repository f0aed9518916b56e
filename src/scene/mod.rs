//! What the user arranges: shapes with their placement, and how they are looked at.

mod camera;
mod color_presets;
mod curve_picking;
mod curve_shape;
pub mod custom;
mod deformation;
mod evaluate;
mod evaluate_curves;
mod import_curve;
mod kept_pose;
mod pick_bone;
mod picking;
mod shape;
mod shape_manager;
mod view_direction;
mod view_settings;

pub use camera::Camera;
pub use color_presets::{COLOR_PRESETS, CUSTOM_PRESET, ColorPreset, ShapeColor};
pub use curve_picking::pick_control_point;
pub use curve_shape::{CurveDisplay, CurveShape, CurveVisibility, SurfaceVisibility};
pub use deformation::Deformation;
pub use evaluate::{Evaluated, EvaluatedGeometry, EvaluatedShape, Evaluator};
pub use evaluate_curves::{EvaluatedCurve, EvaluatedCurves, EvaluatedSurface};
pub use import_curve::{CurveItem, CurveItemKind, CurveSet, CurveSetError, MAX_SET_POINTS};
pub use kept_pose::KeptPose;
pub use pick_bone::{BoneHit, bones_in_world, pick_bone};
pub use picking::pick_shape;
pub use shape::{
    BoneStyle, CharacterDisplay, CharacterShape, JointStyle, ModelDisplay, NewShape, Placement,
    Shape, ShapeId, ShapeKind, Source,
};
pub use shape_manager::{Scene, name_of_import};
pub use view_direction::ViewDirection;
pub use view_settings::{Look, Shading, Skinning, ViewSettings};
