//! Writing scene files, version 2.

use super::character_data::CharacterData;
use super::data::{FORMAT, KindData, is_fovy};
use super::{curves, paths};
use crate::io::angle::exact_degrees;
use crate::io::json_text::{Members, Text, vector};
use crate::math::Euler;
use crate::scene::{
    COLOR_PRESETS, Camera, Placement, Scene, Shape, ShapeColor, ShapeKind, Source, ViewSettings,
};
use std::path::Path;

/// Reason why a scene cannot be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SceneError {
    /// A number of a shape is infinite or not a number.
    #[error("shape {number}, “{name}”: expected finite numbers, found others in {member}")]
    NotFinite {
        /// Number of the shape, counted from 1.
        number: usize,
        /// Name of the shape.
        name: String,
        /// Member of the file that would hold the number.
        member: String,
    },
    /// A mesh or a character that was not imported from a file.
    #[error("shape {number}, “{name}”: expected the file that it came from, found none")]
    NoSource {
        /// Number of the shape, counted from 1.
        number: usize,
        /// Name of the shape.
        name: String,
    },
    /// A camera that nothing can be seen with, or whose numbers are not finite.
    #[error("expected a camera of finite numbers that sees something, found another")]
    Camera,
}

/// Text of a `.scene` file, version 2, with everything in `scene` and `view` but the data of files
/// that shapes came from. Files are named by their way from `folder`, the folder of the scene; all
/// by their whole path if there is none. For that `folder` must be absolute, as the sources are.
///
/// [`read_scene`](super::read_scene) reads the same scene back, and the text of that is the same.
///
/// # Errors
/// If a number is not finite, or a mesh or character did not come from a file.
pub fn scene_text(
    scene: &Scene,
    view: &ViewSettings,
    folder: Option<&Path>,
) -> Result<String, SceneError> {
    let named = |source: &Source| Some(paths::name(&source.file, folder));
    scene_text_with(scene, view, &named)
}

/// As [`scene_text`], with files named by `named`; a source that it has no name for is left out.
pub(super) fn scene_text_with(
    scene: &Scene,
    view: &ViewSettings,
    named: &dyn Fn(&Source) -> Option<String>,
) -> Result<String, SceneError> {
    let mut shapes = Vec::new();
    for (index, shape) in scene.shapes().iter().enumerate() {
        let (number, name) = (index + 1, shape.name.clone());
        let source = shape.source.as_ref();
        let file = source.and_then(named);
        let needs_file =
            KindData::name(&shape.kind).is_none() && !matches!(shape.kind, ShapeKind::Curve(_));
        if needs_file && file.is_none() {
            return Err(SceneError::NoSource { number, name });
        }
        let members = shape_members(shape, source.zip(file));
        if let Some(member) = members.not_finite() {
            return Err(SceneError::NotFinite {
                number,
                name,
                member,
            });
        }
        shapes.push(Text::Object(members));
    }
    let mut file = Members::default();
    file.push("format", FORMAT);
    file.push("version", 2_u32);
    file.push("view", view_members(view)?);
    file.push("shapes", shapes);
    Ok(Text::Object(file).to_file())
}

fn view_members(view: &ViewSettings) -> Result<Members, SceneError> {
    let Camera {
        target,
        radius,
        theta,
        phi,
        fovy,
        near,
        far,
    } = view.camera;
    let mut camera = Members::default();
    camera.push("target", target);
    camera.push("radius", radius);
    camera.push("theta", angle(theta));
    camera.push("phi", angle(phi));
    camera.push("fovy", angle(fovy));
    camera.push("near", near);
    camera.push("far", far);
    let sees = radius > 0.0 && near > 0.0 && near < far && is_fovy(fovy);
    if !sees || camera.not_finite().is_some() {
        return Err(SceneError::Camera);
    }
    let mut members = Members::default();
    members.push("camera", camera);
    members.push("look", word(view.look));
    members.push("shading", word(view.shading));
    members.push("axis", view.axis);
    members.push("grid", view.grid);
    members.push_unless("bones", view.bones, true);
    Ok(members)
}

fn shape_members(shape: &Shape, source: Option<(&Source, String)>) -> Members {
    let mut members = Members::default();
    members.push("name", shape.name.as_str());
    if let Some(kind) = KindData::name(&shape.kind) {
        members.push("kind", kind);
    } else if let Some((source, file)) = source {
        members.push("source", source_members(source, &file));
    }
    members.push("placement", placement_members(&shape.placement));
    if shape.start != shape.placement {
        members.push("start", placement_members(&shape.start));
    }
    members.push_unless("visible", shape.visible, true);
    members.push_unless("locked", shape.locked, false);
    match &shape.kind {
        ShapeKind::Character(character) => {
            members.push_some("character", CharacterData::of(character).members());
        }
        ShapeKind::Curve(curve) => members.push("curves", curves::members(curve)),
        ShapeKind::Missing(missing) => {
            if let Some((name, value)) = &missing.kept {
                members.push(name, Text::Plain(value.clone()));
            }
        }
        _ => {}
    }
    members
}

fn source_members(source: &Source, file: &str) -> Members {
    let mut members = Members::default();
    members.push("file", file);
    members.push("importer", word(source.importer));
    members.push_unless("part", source.part, 0);
    if let Some(fingerprint) = source.fingerprint {
        members.push("fingerprint", format!("{fingerprint:08x}").as_str());
    }
    members
}

fn placement_members(placement: &Placement) -> Members {
    let Placement {
        transform,
        uniform_scaling,
        color,
    } = placement;
    let standard = Placement::at_origin(0).transform;
    let mut members = Members::default();
    members.push_unless("position", transform.position, standard.position);
    if transform.rotation != standard.rotation {
        members.push("rotation", degrees(transform.rotation));
    }
    members.push_unless("scale", transform.scale, standard.scale);
    members.push_unless("uniform_scaling", *uniform_scaling, true);
    let color = match color {
        ShapeColor::Preset(_) => Text::from(COLOR_PRESETS[color.preset_index()].name),
        ShapeColor::Custom(rgb) => Text::from(*rgb),
    };
    members.push("color", color);
    members
}

/// A name that serde has for a value.
pub(super) fn word(value: impl serde::Serialize) -> Text {
    // Only a type that cannot be written as JSON makes this fail.
    Text::Plain(serde_json::to_string(&value).unwrap_or_default())
}

/// An angle in degrees.
fn angle(radians: f32) -> Text {
    if radians.is_finite() {
        Text::Plain(exact_degrees(radians))
    } else {
        Text::NotFinite
    }
}

/// Three angles in degrees.
pub(super) fn degrees(rotation: Euler) -> Text {
    if rotation.radians.is_finite() {
        Text::Plain(vector(rotation.radians.to_array().map(exact_degrees)))
    } else {
        Text::NotFinite
    }
}

/// The text of a member of a shape that holds `members`.
pub(super) fn member(members: Members) -> String {
    // The file, its list of shapes, and the shape are around it.
    Text::Object(members).at_depth(3)
}
