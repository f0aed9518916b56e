//! Version 2 of scene files, which the program writes: each entry is one shape.

use super::character_data::CharacterData;
use super::curves::{self, CurvesData};
use super::data::{ColorData, KindData, SceneData, vector};
use super::reading::{Entry, Reading, share_of};
use super::{Missing, SceneFile, paths};
use crate::io::angle::{self, ExactDegrees};
use crate::io::file_importer::import_with;
use crate::io::joint_names::Misfit;
use crate::io::json::Json;
use crate::io::pose_data::Angles;
use crate::io::{Diagnostic, scanner};
use crate::math::Transform;
use crate::scene::{CurveShape, Importer, NewShape, Placement, ShapeColor, ShapeKind, Source};
use crate::steps::Pace;
use glam::Vec3;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use serde_spanned::Spanned;
use std::collections::{HashMap, HashSet, hash_map};
use std::path::{Path, PathBuf};

/// One shape.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ShapeData {
    name: String,
    kind: Option<KindData>,
    source: Option<SourceData>,
    #[serde(default)]
    placement: PlacementData,
    start: Option<PlacementData>,
    visible: Option<bool>,
    locked: Option<bool>,
    character: Option<Spanned<CharacterData>>,
    curves: Option<Spanned<CurvesData>>,
}

/// Where a shape comes from.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct SourceData {
    #[serde(deserialize_with = "file_name")]
    file: String,
    importer: Importer,
    #[serde(default)]
    part: u32,
    fingerprint: Option<Fingerprint>,
}

fn file_name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    match String::deserialize(deserializer)? {
        name if name.is_empty() => Err(D::Error::custom(
            "expected the name of a file, found an empty one",
        )),
        name => Ok(name),
    }
}

/// A CRC-32 in eight hexadecimal digits.
#[derive(Clone, Copy, Debug)]
struct Fingerprint(u32);

impl<'de> Deserialize<'de> for Fingerprint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let is_hex = text.len() == 8 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        let number = u32::from_str_radix(&text, 16).ok().filter(|_| is_hex);
        number.map(Self).ok_or_else(|| {
            let found = scanner::quoted(&text);
            D::Error::custom(format!("expected eight hexadecimal digits, found {found}"))
        })
    }
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct PlacementData {
    #[serde(deserialize_with = "vector")]
    position: Vec3,
    #[serde(deserialize_with = "angles")]
    rotation: [ExactDegrees; 3],
    #[serde(deserialize_with = "vector")]
    scale: Vec3,
    uniform_scaling: bool,
    color: Option<ColorData>,
}

fn angles<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[ExactDegrees; 3], D::Error> {
    Angles::deserialize(deserializer).map(|Angles(angles)| angles)
}

impl Default for PlacementData {
    fn default() -> Self {
        Self {
            position: Vec3::ZERO,
            rotation: [angle::Angle::from_radians(0.0); 3],
            scale: Vec3::ONE,
            uniform_scaling: true,
            color: None,
        }
    }
}

impl PlacementData {
    /// The placement, in the color of `kind` if it names none.
    fn placement(&self, kind: &ShapeKind) -> Placement {
        let color = self.color.map(|color| color.0);
        Placement {
            transform: Transform {
                position: self.position,
                rotation: angle::euler(self.rotation),
                scale: self.scale,
            },
            uniform_scaling: self.uniform_scaling,
            color: color.unwrap_or(ShapeColor::Preset(kind.start_color())),
        }
    }
}

/// Reads a scene of version 2.
///
/// # Errors
/// At the first thing that is not so, in this file or in one that it names.
pub(super) async fn read(
    json: &Json<'_>,
    reading: &mut Reading<'_>,
    pace: &Pace,
) -> Result<SceneFile, Diagnostic> {
    let data: SceneData<ShapeData, ExactDegrees> = json.read()?;
    let mut reader = Reader {
        reading,
        imported: HashMap::new(),
        changed: HashSet::new(),
    };
    let mut shapes = Vec::new();
    let view = data.view.settings();
    let count = data.shapes.len();
    for (index, shape) in data.shapes.into_iter().enumerate() {
        let entry = Entry {
            number: index + 1,
            at: shape.span().start,
        };
        let shape = reader.shape(entry, shape.into_inner(), pace);
        shapes.push(pace.within(share_of(index, count), shape).await?);
    }
    Ok(SceneFile { view, shapes })
}

struct Reader<'r, 'a> {
    reading: &'r mut Reading<'a>,
    /// The shapes of each file that was read, or why it could not be: a file is read once with each
    /// importer.
    imported: HashMap<(PathBuf, Importer), Result<Vec<NewShape>, Diagnostic>>,
    /// Files of which it was said that they have changed.
    changed: HashSet<PathBuf>,
}

impl Reader<'_, '_> {
    async fn shape(
        &mut self,
        entry: Entry,
        mut data: ShapeData,
        pace: &Pace,
    ) -> Result<NewShape, Diagnostic> {
        let curves = data.curves.take();
        let (mut kind, source) = match (data.kind, &data.source, curves) {
            (Some(kind), None, None) => (kind.kind(), None),
            (None, source, Some(curves)) => {
                self.curves(entry, source.as_ref(), curves, pace).await?
            }
            (None, Some(source), None) => {
                let character = data.character.as_ref();
                self.imported(entry, source, character, pace).await?
            }
            (Some(_), ..) => {
                let message = "expected a kind alone, found a source or curves too";
                return Err(self.reading.wrong(entry, message));
            }
            (None, None, None) => {
                let message = "expected a kind, a source or curves, found none of them";
                return Err(self.reading.wrong(entry, message));
            }
        };
        if let Some(character) = &data.character {
            self.apply(entry, character, &mut kind)?;
        }
        let placement = data.placement.placement(&kind);
        let start = data.start.map(|start| start.placement(&kind));
        Ok(NewShape {
            name: data.name,
            kind,
            source,
            placement,
            start: start.unwrap_or(placement),
            visible: data.visible.unwrap_or(true),
            locked: data.locked.unwrap_or(false),
        })
    }

    /// The curves that are in the scene, or else those of their file.
    async fn curves(
        &mut self,
        entry: Entry,
        source: Option<&SourceData>,
        curves: Spanned<CurvesData>,
        pace: &Pace,
    ) -> Result<(ShapeKind, Option<Source>), Diagnostic> {
        let text = self.reading.text[curves.span()].to_owned();
        let at = curves.span().start;
        let CurvesData { display, items } = curves.into_inner();
        let (mut kind, source) = match (items, source) {
            (Some(items), source) => {
                let set = curves::set(items);
                let set =
                    set.map_err(|(at, message)| self.reading.wrong_at(at, entry, &message))?;
                let source = source.map(|source| self.source(source));
                (ShapeKind::Curve(CurveShape::new(set)), source)
            }
            (None, Some(source)) => {
                let kept = Some(("curves", text));
                self.import(entry, source, kept, pace).await?
            }
            (None, None) => {
                let message = "expected `items` or a source, found neither";
                return Err(self.reading.wrong_at(at, entry, message));
            }
        };
        match &mut kind {
            ShapeKind::Curve(curve) => display.apply_to(curve),
            ShapeKind::Missing(_) => {}
            _ => {
                let message = "expected a file of curves, found one of shapes";
                return Err(self.reading.wrong_at(at, entry, message));
            }
        }
        Ok((kind, source))
    }

    async fn imported(
        &mut self,
        entry: Entry,
        source: &SourceData,
        character: Option<&Spanned<CharacterData>>,
        pace: &Pace,
    ) -> Result<(ShapeKind, Option<Source>), Diagnostic> {
        let text = character.map(|data| self.reading.text[data.span()].to_owned());
        let kept = text.map(|text| ("character", text));
        self.import(entry, source, kept, pace).await
    }

    /// The shape that `source` means, or a stand-in that keeps `kept`.
    async fn import(
        &mut self,
        entry: Entry,
        source: &SourceData,
        kept: Option<(&str, String)>,
        pace: &Pace,
    ) -> Result<(ShapeKind, Option<Source>), Diagnostic> {
        let path = self.path(source);
        let recorded = self.source(source);
        match self.part(&path, source, pace).await {
            Ok(shape) => {
                let was = recorded.fingerprint;
                let now = shape.source.as_ref().and_then(|source| source.fingerprint);
                if was.is_some() && was != now && self.changed.insert(path.clone()) {
                    let message = "this file has changed since the scene was saved";
                    self.reading.warnings.push(Diagnostic::new(&path, message));
                }
                Ok((shape.kind, shape.source))
            }
            Err(error) => Ok((self.reading.stand_in(entry, error, kept)?, Some(recorded))),
        }
    }

    /// The shape of the file at `path` that `source` means.
    async fn part(
        &mut self,
        path: &Path,
        source: &SourceData,
        pace: &Pace,
    ) -> Result<NewShape, Diagnostic> {
        let key = (path.to_owned(), source.importer);
        let known = match self.imported.entry(key) {
            hash_map::Entry::Occupied(known) => known.into_mut(),
            hash_map::Entry::Vacant(new) => {
                let read = import_with(self.reading.files, path, source.importer, pace).await;
                new.insert(read.map(|read| {
                    self.reading.warnings.extend(read.warnings);
                    read.value
                }))
            }
        };
        let shapes = known.as_ref().map_err(Clone::clone)?;
        part_of(shapes, source.part as usize, path).cloned()
    }

    fn path(&self, source: &SourceData) -> PathBuf {
        let folder = self.reading.path.parent().unwrap_or(Path::new(""));
        paths::file(&source.file, folder)
    }

    /// The source as it is in the scene.
    fn source(&self, data: &SourceData) -> Source {
        let path = self.path(data);
        let file = self.reading.files.absolute(&path);
        Source {
            file: file.to_string_lossy().into_owned(),
            importer: data.importer,
            part: data.part as usize,
            fingerprint: data.fingerprint.map(|fingerprint| fingerprint.0),
        }
    }

    /// Sets pose and display of a character.
    fn apply(
        &mut self,
        entry: Entry,
        data: &Spanned<CharacterData>,
        kind: &mut ShapeKind,
    ) -> Result<(), Diagnostic> {
        let ShapeKind::Character(character) = kind else {
            if matches!(kind, ShapeKind::Missing(_)) {
                return Ok(());
            }
            let message = "expected a character, for it has a pose or display, found a shape";
            return Err(self.reading.wrong_at(data.span().start, entry, message));
        };
        let misfits = data.get_ref().apply_to(character);
        let Some(Misfit { at, message }) = misfits.first() else {
            return Ok(());
        };
        let mut fault = self.reading.wrong_at(*at, entry, message);
        match self.reading.missing {
            Missing::Refuse => Err(fault),
            Missing::StandIn => {
                fault.message +=
                    "; what is saved of it is kept until Reset Pose and Unpin All Joints";
                self.reading.warnings.push(fault);
                Ok(())
            }
        }
    }
}

/// The part of a file that a source means.
///
/// # Errors
/// If the file does not have it.
pub(super) fn part_of<'s>(
    shapes: &'s [NewShape],
    part: usize,
    path: &Path,
) -> Result<&'s NewShape, Diagnostic> {
    let is_it = |shape: &&NewShape| {
        let source = shape.source.as_ref();
        source.is_some_and(|source| source.part == part)
    };
    shapes.iter().find(is_it).ok_or_else(|| {
        let count = shapes.len();
        let shapes = if count == 1 { "shape" } else { "shapes" };
        let message = format!(
            "expected a shape {} in it, found {count} {shapes}",
            part + 1
        );
        Diagnostic::new(path, message)
    })
}
