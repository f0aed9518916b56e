//! Scene files: version 1, which is written by hand, and version 2, which the program writes.

mod character_data;
mod curves;
mod data;
mod package;
mod paths;
mod reading;
mod reimport;
mod text;
mod version_1;
mod version_2;

pub use package::{Package, files_of_source, needed_files, package};
pub use paths::normal;
pub use reimport::{Reimported, reimport};
pub use text::{SceneError, scene_text};

use super::json::Json;
use super::{Diagnostic, Files, Imported};
use crate::scene::{NewShape, ViewSettings};
use crate::steps::{Pace, at_once};
use data::{Head, Version};
use reading::Reading;
use std::path::Path;

/// A scene read from its file.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// How it is looked at.
    pub view: ViewSettings,
    /// Its shapes, in the order of the file.
    pub shapes: Vec<NewShape>,
}

/// Treatment of a file that a scene names and that is missing, unreadable or lacks the shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Missing {
    /// The scene cannot be read.
    #[default]
    Refuse,
    /// The shape becomes a [`ShapeKind::Missing`](crate::scene::ShapeKind::Missing), with a warning;
    /// joints that a character does not have are left out, with a warning.
    StandIn,
}

/// Reads a `.scene` file, JSON of the form
/// `{"format": "editor-scene", "version": …, "view": {…}, "shapes": [{…}, …]}`.
///
/// In version 1 a shape has a `kind` (`cube`, `sphere`, `pyramid`, `teapot`, `icosahedron`,
/// `custom`) or a `source`: a file, relative to the scene's folder, or `builtin:NAME`, of which it
/// stands for all shapes. All else may be left out: `name`, `position`, `rotation` in degrees,
/// `scale`, `uniform_scaling`, `color` (a name of the panel's list, or `[r, g, b]` in 0..1),
/// `visible`, `locked`, and for characters `pose` (as in pose files, or the name of one) and
/// `display`, for curves `curves`.
///
/// Version 2 is what [`scene_text`] writes.
///
/// # Errors
/// At the first thing that is not so, in this file or, unless `missing` allows it, in one that it
/// names.
#[doc(alias = "FileManager")]
pub fn read_scene(
    files: &dyn Files,
    path: &Path,
    missing: Missing,
) -> Result<Imported<SceneFile>, Diagnostic> {
    at_once(|pace| async move { read_scene_by(files, path, missing, &pace).await })
}

/// As [`read_scene`], at a pace that is told of bytes.
///
/// # Errors
/// As [`read_scene`].
pub(super) async fn read_scene_by(
    files: &dyn Files,
    path: &Path,
    missing: Missing,
    pace: &Pace,
) -> Result<Imported<SceneFile>, Diagnostic> {
    let bytes = files.read(path)?;
    let json = Json::parse(path, &bytes)?;
    let head: Head = json.read()?;
    let mut reading = Reading {
        files,
        path,
        text: json.text(),
        missing,
        warnings: Vec::new(),
    };
    let value = match head.version {
        Version::One => version_1::read(&json, &mut reading, pace).await?,
        Version::Two => version_2::read(&json, &mut reading, pace).await?,
    };
    Ok(Imported {
        value,
        warnings: reading.warnings,
    })
}
