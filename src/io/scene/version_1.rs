//! Version 1 of scene files, for scenes written by hand: an entry stands for all shapes of its file.

use super::SceneFile;
use super::character_data::CharacterData;
use super::data::{ColorData, CurveDisplayData, KindData, SceneData, set_display, vector};
use super::reading::{Entry, Reading, share_of};
use crate::character::{Pose, SkeletalModel};
use crate::io::angle::Degrees;
use crate::io::file_importer::import_any_by;
use crate::io::joint_names::Misfit;
use crate::io::json::Json;
use crate::io::json_values;
use crate::io::{Diagnostic, PoseData, PoseFile, builtin, is_character};
use crate::math::{Euler, Transform};
use crate::scene::{
    CharacterDisplay, Importer, NewShape, Placement, ShapeColor, ShapeKind, Source,
};
use crate::steps::Pace;
use glam::Vec3;
use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use std::collections::HashMap;
use std::fmt;
use std::path::{Path, PathBuf};

/// Reads a scene of version 1.
///
/// # Errors
/// At the first thing that is not so, in this file or in one that it names.
pub(super) async fn read(
    json: &Json<'_>,
    reading: &mut Reading<'_>,
    pace: &Pace,
) -> Result<SceneFile, Diagnostic> {
    let data: SceneData<ShapeData, Degrees> = json.read()?;
    let mut reader = Reader {
        reading,
        imported: HashMap::new(),
    };
    let mut shapes = Vec::new();
    for (index, shape) in data.shapes.iter().enumerate() {
        let entry = Entry {
            number: index + 1,
            at: shape.span().start,
        };
        let share = share_of(index, data.shapes.len());
        let shape = reader.shape(entry, shape.get_ref(), pace);
        shapes.extend(pace.within(share, shape).await?);
    }
    Ok(SceneFile {
        view: data.view.settings(),
        shapes,
    })
}

/// One shape: of a kind, or from a file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ShapeData {
    kind: Option<KindData>,
    source: Option<String>,
    name: Option<String>,
    #[serde(default, deserialize_with = "vector")]
    position: Vec3,
    #[serde(default, deserialize_with = "vector")]
    rotation: Vec3,
    #[serde(default = "one", deserialize_with = "scale")]
    scale: Vec3,
    uniform_scaling: Option<bool>,
    color: Option<ColorData>,
    visible: Option<bool>,
    locked: Option<bool>,
    pose: Option<PoseReference>,
    display: Option<CharacterDisplay>,
    curves: Option<CurveDisplayData>,
}

fn one() -> Vec3 {
    Vec3::ONE
}

fn scale<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    json_values::vec3(deserializer, |scale| match scale {
        0.0 => Err("expected a scale other than 0, found 0".to_owned()),
        _ => Ok(()),
    })
}

impl ShapeData {
    /// Where the shape stands, in the color of a preset if it names none.
    fn placement(&self, preset: usize) -> Placement {
        let uniform = self.scale == Vec3::splat(self.scale.x);
        let color = self.color.map(|color| color.0);
        Placement {
            transform: Transform {
                position: self.position,
                rotation: Euler::from_degrees(self.rotation),
                scale: self.scale,
            },
            uniform_scaling: self.uniform_scaling.unwrap_or(uniform),
            color: color.unwrap_or(ShapeColor::Preset(preset)),
        }
    }

    /// The shape in its place.
    fn placed(&self, (kind, name, source): Named) -> NewShape {
        let preset = match (&kind, &source) {
            (ShapeKind::Missing(_), Some(source)) => source.importer.start_color(),
            _ => kind.start_color(),
        };
        let placement = self.placement(preset);
        NewShape {
            name: self.name.clone().unwrap_or(name),
            kind,
            source,
            // Reset brings a shape back to its place in the scene, not to the origin.
            placement,
            start: placement,
            visible: self.visible.unwrap_or(true),
            locked: self.locked.unwrap_or(false),
        }
    }
}

/// A pose written out, or the file that holds it.
#[derive(Clone, Debug, PartialEq)]
enum PoseReference {
    File(String),
    Inline(PoseData),
}

impl<'de> Deserialize<'de> for PoseReference {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct FileOrPose;
        impl<'de> Visitor<'de> for FileOrPose {
            type Value = PoseReference;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a pose or the name of its file")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<PoseReference, E> {
                Ok(PoseReference::File(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<PoseReference, A::Error> {
                PoseData::deserialize(MapAccessDeserializer::new(map)).map(PoseReference::Inline)
            }
        }
        deserializer.deserialize_any(FileOrPose)
    }
}

struct Reader<'r, 'a> {
    reading: &'r mut Reading<'a>,
    /// A file that several shapes name is read once, and its mesh shared.
    imported: HashMap<PathBuf, Vec<NewShape>>,
}

impl Reader<'_, '_> {
    async fn shape(
        &mut self,
        entry: Entry,
        data: &ShapeData,
        pace: &Pace,
    ) -> Result<Vec<NewShape>, Diagnostic> {
        let new = self.new_shapes(entry, data, pace).await?;
        if let [(ShapeKind::Missing(_), ..)] = new.as_slice() {
            return Ok(new.into_iter().map(|named| data.placed(named)).collect());
        }
        let skeletons: Vec<&SkeletalModel> = new.iter().filter_map(skeleton).collect();
        let has_character = !skeletons.is_empty();
        if !has_character && (data.pose.is_some() || data.display.is_some()) {
            let message = "expected a character, for it has a pose or display, found a shape";
            return Err(self.reading.wrong(entry, message));
        }
        let has_curves = |(kind, ..): &Named| matches!(kind, ShapeKind::Curve(_));
        if data.curves.is_some() && !new.iter().any(has_curves) {
            let message = "expected curves, for it says how they are drawn, found a shape";
            return Err(self.reading.wrong(entry, message));
        }
        let poses = match &data.pose {
            Some(pose) => self.poses(entry, pose, &skeletons)?,
            None => Vec::new(),
        };
        let mut poses = poses.into_iter();
        let shapes = new.into_iter().map(|(mut kind, name, source)| {
            match &mut kind {
                ShapeKind::Character(character) => {
                    if let Some(display) = data.display {
                        set_display(character, display);
                    }
                    if let Some(pose) = poses.next().flatten() {
                        character.set_pose(pose);
                    }
                }
                ShapeKind::Curve(curve) => {
                    if let Some(display) = data.curves {
                        display.apply_to(curve);
                    }
                }
                _ => {}
            }
            data.placed((kind, name, source))
        });
        Ok(shapes.collect())
    }

    /// The shapes that an entry stands for, with their names: of its kind, or those of its file.
    async fn new_shapes(
        &mut self,
        entry: Entry,
        data: &ShapeData,
        pace: &Pace,
    ) -> Result<Vec<Named>, Diagnostic> {
        match (&data.kind, &data.source) {
            (Some(kind), None) => {
                let kind = kind.kind();
                let name = kind.label().to_owned();
                Ok(vec![(kind, name, None)])
            }
            (None, Some(source)) if source.is_empty() => Err(self
                .reading
                .wrong(entry, "expected the name of a file, found an empty one")),
            (None, Some(source)) => match self.import(source, pace).await {
                Ok(imported) => {
                    let named = |new: NewShape| (new.kind, new.name, new.source);
                    Ok(imported.into_iter().map(named).collect())
                }
                Err(error) => Ok(vec![self.missing(entry, data, source, error)?]),
            },
            (Some(_), Some(_)) => Err(self
                .reading
                .wrong(entry, "expected a kind or a source, found both")),
            (None, None) => Err(self
                .reading
                .wrong(entry, "expected a kind or a source, found neither")),
        }
    }

    async fn import(&mut self, source: &str, pace: &Pace) -> Result<Vec<NewShape>, Diagnostic> {
        let path = self.beside(source);
        if let Some(known) = self.imported.get(&path) {
            return Ok(known.clone());
        }
        let read = import_any_by(self.reading.files, &path, pace).await?;
        self.reading.warnings.extend(read.warnings);
        self.imported.insert(path, read.value.clone());
        Ok(read.value)
    }

    /// A stand-in for the shapes of a file that could not be read, the first of them if there were
    /// several.
    ///
    /// # Errors
    /// The error itself if stand-ins are not wanted; or about the file of the pose.
    fn missing(
        &mut self,
        entry: Entry,
        data: &ShapeData,
        source: &str,
        error: Diagnostic,
    ) -> Result<Named, Diagnostic> {
        let path = self.beside(source);
        let is_posed = data.pose.is_some() || data.display.is_some();
        let importer = match path.extension().and_then(|extension| extension.to_str()) {
            Some(swp) if swp.eq_ignore_ascii_case("swp") => Importer::Curve,
            Some(dae) if dae.eq_ignore_ascii_case("dae") => Importer::Character,
            _ if is_posed || is_character(self.reading.files, &path) => Importer::Character,
            _ => Importer::Shape,
        };
        let kept = if let (Importer::Curve, Some(display)) = (importer, &data.curves) {
            Some(("curves", super::curves::display_only(display)))
        } else if is_posed {
            let pose = match &data.pose {
                Some(PoseReference::Inline(data)) => data.clone(),
                Some(PoseReference::File(name)) => self.pose_file(entry, name)?.data().clone(),
                None => PoseData::default(),
            };
            let data = CharacterData::new(pose, data.display.unwrap_or_default());
            Some(("character", data.members()))
        } else {
            None
        };
        let kept = kept.map(|(name, members)| (name, super::text::member(members)));
        let kind = self.reading.stand_in(entry, error, kept)?;
        let file = self
            .reading
            .files
            .absolute(&path)
            .to_string_lossy()
            .into_owned();
        let source = Source {
            file,
            importer,
            part: 0,
            fingerprint: None,
        };
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        Ok((kind, crate::scene::name_of_import(&name), Some(source)))
    }

    /// The pose of each of a shape's characters; `None` for one that has no joint of it.
    fn poses(
        &self,
        entry: Entry,
        pose: &PoseReference,
        skeletons: &[&SkeletalModel],
    ) -> Result<Vec<Option<Pose>>, Diagnostic> {
        match pose {
            PoseReference::Inline(data) => data
                .poses_of(skeletons)
                .map_err(|Misfit { at, message }| self.reading.wrong_at(at, entry, &message)),
            PoseReference::File(name) => self.pose_file(entry, name)?.poses_of(skeletons),
        }
    }

    fn pose_file(&self, entry: Entry, name: &str) -> Result<PoseFile, Diagnostic> {
        let path = builtin::resolve(&self.beside(name));
        let read = path.and_then(|path| Ok((self.reading.files.read(&path)?, path)));
        let (bytes, path) = read.map_err(|error| self.reading.named_by(entry, error))?;
        PoseFile::read(&path, &bytes)
    }

    /// The file that this scene calls `name`.
    fn beside(&self, name: &str) -> PathBuf {
        if name.starts_with(builtin::PREFIX) {
            PathBuf::from(name)
        } else {
            let folder = self.reading.path.parent().unwrap_or(Path::new(""));
            folder.join(name)
        }
    }
}

/// A shape with its name and where it came from.
type Named = (ShapeKind, String, Option<Source>);

fn skeleton((kind, ..): &Named) -> Option<&SkeletalModel> {
    match kind {
        ShapeKind::Character(shape) => Some(shape.character.skeleton()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::builtin::WithBuiltin;
    use crate::io::{Missing, read_scene};

    #[test]
    fn points_and_lines_have_sizes_that_can_be_drawn() {
        let text = r#"{"format": "editor-scene", "version": 1, "shapes": [{"source": "builtin:chain",
            "display": {"point_size": 1e9, "line_width": -3}}]}"#;
        let files = HashMap::from([(PathBuf::from("a.scene"), text.as_bytes().to_vec())]);
        let read = read_scene(&WithBuiltin(files), Path::new("a.scene"), Missing::Refuse).unwrap();
        let ShapeKind::Character(character) = &read.value.shapes[0].kind else {
            panic!("{:?}", read.value.shapes);
        };
        let display = character.display;
        assert_eq!((display.point_size, display.line_width), (64.0, 1.0));
    }
}
