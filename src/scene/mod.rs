//! The scene: shapes with their placement, what follows from them, and the camera.

mod bone_picking;
mod box_picking;
mod camera;
mod camera_fit;
mod camera_moves;
mod character_shape;
mod coarse;
mod color_presets;
mod color_scale;
mod curve_shape;
pub mod custom;
mod deformation;
mod evaluate;
mod evaluate_curves;
mod ground;
mod ik_settings;
mod import_curve;
mod joints_fit;
mod method_blend;
mod missing_joints;
mod picking;
mod shape;
mod shape_manager;
mod turntable;
mod vertex_numbers;
mod view_settings;

pub use bone_picking::{
    BoneHit, Seen, bones_in_world, pick_bone, seen_by, shape_seen_by, turned_there,
};
pub use box_picking::{pick_in_box, pick_joints_in_box};
pub use camera::Camera;
pub use camera_fit::FitArea;
pub use character_shape::{
    BoneStyle, CharacterDisplay, CharacterShape, JointStyle, KeptPose, ModelDisplay, SkinningMethod,
};
pub use coarse::Coarsener;
pub use color_presets::{COLOR_PRESETS, CUSTOM_PRESET, ColorPreset, ShapeColor};
pub use color_scale::{SCALE_GRAY, scale_color};
pub use curve_shape::{CurveDisplay, CurveShape, CurveVisibility, SurfaceVisibility};
pub use deformation::Deformation;
pub use evaluate::{Evaluated, EvaluatedGeometry, EvaluatedShape, Evaluator};
pub use evaluate_curves::{EvaluatedCurve, EvaluatedCurves, EvaluatedSurface};
pub use ik_settings::{IkPole, IkSettings};
pub use import_curve::{CurveItem, CurveItemKind, CurveSet, CurveSetError, MAX_SET_POINTS};
pub use missing_joints::{MissingJoints, MissingPose};
pub use picking::{pick_control_point, pick_shape};
pub use shape::{Importer, MissingShape, NewShape, Placement, Shape, ShapeId, ShapeKind, Source};
pub use shape_manager::{Scene, name_of_import};
pub use turntable::{TURNTABLE_FRAMES, fit_turntable, turntable_cameras, turntable_milliseconds};
pub use vertex_numbers::{CharacterNumber, VertexNumbers};
pub use view_settings::{Look, Shading, Skinning, ViewDirection, ViewSettings};
