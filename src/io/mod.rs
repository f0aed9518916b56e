//! Files: importers, exporters, scene files. Bytes in, values out; nothing here opens a file, a
//! dialog or a window.

mod attach;
pub mod builtin;
pub mod dae;
mod diagnostic;
mod export;
mod file_importer;
mod files;
pub mod image;
mod import_character;
mod import_shape;
mod joint_names;
mod json;
mod material;
mod number;
mod obj;
mod pictures;
mod pose_entries;
mod pose_file;
mod scanner;
mod scene_data;
mod scene_file;
mod skel;
mod swp;
mod to_pose;
mod to_swp;
mod warnings;

pub use attach::read_attach;
pub use diagnostic::{Diagnostic, Imported, Position};
pub use export::export_obj;
pub use file_importer::{
    IMPORTABLE, Loaded, import_any, import_character, import_collada, import_curve, import_shape,
};
pub use files::{Files, expect_extension};
pub use import_character::{is_character, read_character};
pub use import_shape::read_shape_obj;
pub use obj::read_character_obj;
pub use pose_entries::Entries;
pub use pose_file::{PoseData, PoseFile};
pub use scene_file::{SceneFile, read_scene};
pub use skel::read_skel;
pub use swp::read_swp;
pub use to_swp::to_swp;
