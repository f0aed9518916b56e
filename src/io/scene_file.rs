use super::file_importer::import_any;
use super::json::Json;
use super::pose_file::Misfit;
use super::scene_data::{Head, PoseReference, SceneData, ShapeData};
use super::{Diagnostic, Files, Imported, PoseFile, Position, builtin};
use crate::character::{Pose, SkeletalModel};
use crate::scene::{NewShape, ShapeKind, Source, ViewSettings};
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
    let json = Json::parse(path, &bytes)?;
    json.read::<Head>()?;
    let data: SceneData = json.read()?;
    let mut reader = SceneReader {
        files,
        path,
        text: json.text(),
        imported: HashMap::new(),
        warnings: Vec::new(),
    };
    let mut shapes = Vec::new();
    for (index, shape) in data.shapes.iter().enumerate() {
        let entry = Entry {
            number: index + 1,
            at: shape.span().start,
            data: shape.get_ref(),
        };
        shapes.extend(reader.shape(&entry)?);
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

/// A shape of the list.
struct Entry<'a> {
    /// Counted from 1, as messages have it.
    number: usize,
    /// The byte of the text where it starts.
    at: usize,
    data: &'a ShapeData,
}

impl SceneReader<'_> {
    fn shape(&mut self, entry: &Entry) -> Result<Vec<NewShape>, Diagnostic> {
        let data = entry.data;
        let new = self.new_shapes(entry)?;
        let skeletons: Vec<&SkeletalModel> = new.iter().filter_map(skeleton).collect();
        let has_character = !skeletons.is_empty();
        if !has_character && (data.pose.is_some() || data.display.is_some()) {
            let message = "expected a character, for it has a pose or display, found a shape";
            return Err(self.wrong(entry, message));
        }
        let has_curves = |(kind, ..): &Named| matches!(kind, ShapeKind::Curve(_));
        if data.curves.is_some() && !new.iter().any(has_curves) {
            let message = "expected curves, for it says how they are drawn, found a shape";
            return Err(self.wrong(entry, message));
        }
        let poses = match &data.pose {
            Some(pose) => self.poses(entry, pose, &skeletons)?,
            None => Vec::new(),
        };
        let mut poses = poses.into_iter();
        let shapes = new.into_iter().map(|(mut kind, name, source)| {
            let placement = data.placement(&kind);
            match &mut kind {
                ShapeKind::Character(character) => {
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
                ShapeKind::Curve(curve) => {
                    if let Some(display) = data.curves {
                        display.apply_to(curve);
                    }
                }
                _ => {}
            }
            NewShape {
                name: data.name.clone().unwrap_or(name),
                kind,
                source,
                // Reset brings a shape back to its place in the scene, not to the origin.
                placement,
                visible: data.visible.unwrap_or(true),
                locked: data.locked.unwrap_or(false),
            }
        });
        Ok(shapes.collect())
    }

    /// The shapes that an entry stands for, with their names: of its kind, or those of its file.
    fn new_shapes(&mut self, entry: &Entry) -> Result<Vec<Named>, Diagnostic> {
        match (&entry.data.kind, &entry.data.source) {
            (Some(kind), None) => {
                let kind = kind.kind();
                let name = kind.label().to_owned();
                Ok(vec![(kind, name, None)])
            }
            (None, Some(source)) if source.is_empty() => {
                Err(self.wrong(entry, "expected the name of a file, found an empty one"))
            }
            (None, Some(source)) => {
                let imported = self.import(source);
                let imported = imported.map_err(|error| self.named_by(entry, error))?;
                let named = |new: NewShape| (new.kind, new.name, new.source);
                Ok(imported.into_iter().map(named).collect())
            }
            (Some(_), Some(_)) => Err(self.wrong(entry, "expected a kind or a source, found both")),
            (None, None) => Err(self.wrong(entry, "expected a kind or a source, found neither")),
        }
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
        entry: &Entry,
        pose: &PoseReference,
        skeletons: &[&SkeletalModel],
    ) -> Result<Vec<Option<Pose>>, Diagnostic> {
        match pose {
            PoseReference::Inline(data) => data
                .poses_of(skeletons)
                .map_err(|Misfit { at, message }| self.wrong_at(at, entry, &message)),
            PoseReference::File(name) => {
                let path = builtin::resolve(&self.beside(name));
                let read = path.and_then(|path| Ok((self.files.read(&path)?, path)));
                let (bytes, path) = read.map_err(|error| self.named_by(entry, error))?;
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

    fn wrong(&self, entry: &Entry, message: &str) -> Diagnostic {
        self.wrong_at(entry.at, entry, message)
    }

    fn wrong_at(&self, at: usize, entry: &Entry, message: &str) -> Diagnostic {
        Diagnostic {
            position: Some(Position::in_text(self.text, at)),
            ..Diagnostic::new(self.path, format!("shape {}: {message}", entry.number))
        }
    }

    /// `error` at its place in a file; one about a file as a whole where the scene names the file.
    fn named_by(&self, entry: &Entry, error: Diagnostic) -> Diagnostic {
        if error.position.is_some() {
            return error;
        }
        self.wrong(entry, &error.to_string())
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

    #[test]
    fn points_and_lines_have_sizes_that_can_be_drawn() {
        let text = r#"{"format": "editor-scene", "version": 1, "shapes": [{"source": "builtin:chain",
            "display": {"point_size": 1e9, "line_width": -3}}]}"#;
        let files = HashMap::from([(PathBuf::from("a.scene"), text.as_bytes().to_vec())]);
        let read = read_scene(&WithBuiltin(files), Path::new("a.scene")).unwrap();
        let ShapeKind::Character(character) = &read.value.shapes[0].kind else {
            panic!("{:?}", read.value.shapes);
        };
        let display = character.display;
        assert_eq!((display.point_size, display.line_width), (64.0, 1.0));
    }
}
