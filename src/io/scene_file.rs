use super::file_importer::import_any;
use super::scene_data::{Head, PoseReference, SceneData, ShapeData};
use super::{Diagnostic, Files, Imported, PoseFile, Position, builtin, json, scanner};
use crate::character::{Pose, SkeletalModel};
use crate::scene::{NewShape, ShapeKind, ViewSettings};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// A scene read from its file.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// How it is looked at.
    pub view: ViewSettings,
    /// Its shapes, in the order of the file.
    pub shapes: Vec<NewShape>,
}

/// Reads a `.scene` file, JSON of the form
/// `{"format": "editor-scene", "version": 1, "view": {…}, "shapes": [{…}, …]}`.
///
/// A shape has a `kind` (`cube`, `sphere`, `pyramid`, `teapot`, `icosahedron`, `custom`) or a
/// `source`: a file, relative to the scene's folder, or `builtin:NAME`. All else may be left out:
/// `name`, `position`, `rotation` in degrees, `scale`, `uniform_scaling`, `color` (a name of the
/// panel's list, or `[r, g, b]` in 0..1), `visible`, `locked`, and for characters `pose` (as in pose files, or the
/// name of one) and `display`, for curves `curves`.
///
/// # Errors
/// At the first thing that is not so, in this file or in one that it names.
#[doc(alias = "FileManager")]
pub fn read_scene(files: &dyn Files, path: &Path) -> Result<Imported<SceneFile>, Diagnostic> {
    let bytes = files.read(path)?;
    json::read::<Head>(path, &bytes)?;
    let data: SceneData = json::read(path, &bytes)?;
    let mut reader = SceneReader {
        files,
        path,
        text: scanner::utf8(path, &bytes)?,
        imported: HashMap::new(),
        warnings: Vec::new(),
    };
    let mut shapes = Vec::new();
    for (index, shape) in data.shapes.iter().enumerate() {
        shapes.extend(reader.shape(index, shape)?);
    }
    Ok(Imported {
        value: SceneFile {
            view: data.view.settings(),
            shapes,
        },
        warnings: reader.warnings,
    })
}

struct SceneReader<'a> {
    files: &'a dyn Files,
    path: &'a Path,
    text: &'a str,
    /// A file that several shapes name is read once, and its mesh shared.
    imported: HashMap<PathBuf, Vec<NewShape>>,
    warnings: Vec<Diagnostic>,
}

impl SceneReader<'_> {
    fn shape(&mut self, index: usize, data: &ShapeData) -> Result<Vec<NewShape>, Diagnostic> {
        let new = match (&data.kind, &data.source) {
            (Some(kind), None) => vec![(kind.kind(), kind.kind().label().to_owned(), None)],
            (None, Some(source)) if source.is_empty() => {
                return Err(self.wrong(index, "expected the name of a file, found an empty one"));
            }
            (None, Some(source)) => self
                .import(source)
                .map_err(|error| self.named_by(index, error))?
                .into_iter()
                .map(|new| (new.kind, new.name, new.source))
                .collect(),
            (Some(_), Some(_)) => {
                return Err(self.wrong(index, "expected a kind or a source, found both"));
            }
            (None, None) => {
                return Err(self.wrong(index, "expected a kind or a source, found neither"));
            }
        };
        let skeletons: Vec<&SkeletalModel> = new
            .iter()
            .filter_map(|(kind, ..)| match kind {
                ShapeKind::Character(shape) => Some(shape.character.skeleton()),
                _ => None,
            })
            .collect();
        let has_character = !skeletons.is_empty();
        let poses = match &data.pose {
            Some(pose) if has_character => self.poses(index, pose, &skeletons)?,
            _ => Vec::new(),
        };
        let mut poses = poses.into_iter();
        let mut shapes = Vec::new();
        let mut has_curves = false;
        for (mut kind, name, source) in new {
            let placement = data.placement(&kind);
            if let ShapeKind::Character(character) = &mut kind {
                if let Some(display) = data.display {
                    character.display = display;
                    // Beyond this no driver draws, and no one wants it.
                    character.display.point_size = display.point_size.clamp(1.0, 64.0);
                    character.display.line_width = display.line_width.clamp(1.0, 64.0);
                }
                if let Some(pose) = poses.next().flatten() {
                    character.set_pose(pose);
                }
            }
            if let ShapeKind::Curve(curve) = &mut kind {
                has_curves = true;
                if let Some(display) = data.curves {
                    display.apply_to(curve);
                }
            }
            shapes.push(NewShape {
                name: data.name.clone().unwrap_or(name),
                kind,
                source,
                // Reset brings a shape back to its place in the scene, not to the origin.
                placement,
                visible: data.visible.unwrap_or(true),
                locked: data.locked.unwrap_or(false),
            });
        }
        if !has_character && (data.pose.is_some() || data.display.is_some()) {
            let message = "expected a character, for it has a pose or display, found a shape";
            return Err(self.wrong(index, message));
        }
        if !has_curves && data.curves.is_some() {
            let message = "expected curves, for it says how they are drawn, found a shape";
            return Err(self.wrong(index, message));
        }
        Ok(shapes)
    }

    fn import(&mut self, source: &str) -> Result<Vec<NewShape>, Diagnostic> {
        let path = self.beside(source);
        if let Some(known) = self.imported.get(&path) {
            return Ok(known.clone());
        }
        let read = import_any(self.files, &path)?;
        self.warnings.extend(read.warnings);
        self.imported.insert(path, read.value.clone());
        Ok(read.value)
    }

    /// The pose of each of a shape's characters; `None` for one that has no joint of it.
    fn poses(
        &self,
        index: usize,
        pose: &PoseReference,
        skeletons: &[&SkeletalModel],
    ) -> Result<Vec<Option<Pose>>, Diagnostic> {
        match pose {
            PoseReference::Inline(data) => data
                .poses_of(skeletons)
                .map_err(|(_, _, message)| self.wrong(index, &message)),
            PoseReference::File(name) => {
                let path = builtin::resolve(&self.beside(name));
                let read = path.and_then(|path| Ok((self.files.read(&path)?, path)));
                let (bytes, path) = read.map_err(|error| self.named_by(index, error))?;
                PoseFile::read(&path, &bytes)?.poses_of(skeletons)
            }
        }
    }

    /// The file that this scene calls `name`.
    fn beside(&self, name: &str) -> PathBuf {
        if name.starts_with(builtin::PREFIX) {
            PathBuf::from(name)
        } else {
            self.path.parent().unwrap_or(Path::new("")).join(name)
        }
    }

    fn wrong(&self, index: usize, message: &str) -> Diagnostic {
        Diagnostic {
            position: self.place(index),
            ..Diagnostic::new(self.path, format!("shape {}: {message}", index + 1))
        }
    }

    /// `error` about a file as a whole, with who named that file.
    fn named_by(&self, index: usize, error: Diagnostic) -> Diagnostic {
        if error.position.is_some() {
            return error;
        }
        let scene = self.path.display();
        let place = self.place(index).map_or(String::new(), |place| {
            format!(":{}:{}", place.line, place.column)
        });
        let shape = index + 1;
        let message = format!("{} (shape {shape} of {scene}{place})", error.message);
        Diagnostic { message, ..error }
    }

    fn place(&self, index: usize) -> Option<Position> {
        json::position_of_item(self.text, "shapes", index)
    }
}
