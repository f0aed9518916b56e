//! What the program does with files: opening, importing, posing, comparing, exporting, saving.

use super::awaited::Awaited;
use super::clipboard::{Pasted, Sides};
use super::document_file::DocumentFile;
use super::reading::Use;
use super::running::Program;
use super::{Host, Previous};
use crate::character::Pose;
use crate::editor::{Edit, Severity, View, set_beside_each_other};
use crate::geometry::Picture;
use crate::io::image::{self, PictureFormat};
use crate::io::{self, Diagnostic, Files, Loaded, Missing, PoseData, PoseFile, ReadJob, Wanted};
use crate::scene::ShapeId;
use std::borrow::Borrow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a pose file rounds off at most, in radians and relative to a distance.
const ROUNDED_OFF: f32 = 1e-5;
/// What messages call the clipboard where they name a file.
pub(super) const CLIPBOARD: &str = "clipboard";

impl Program {
    /// Starts with `paths` in one scene, compared with the last that is a picture. What cannot be
    /// opened becomes a message; the others are there.
    pub(super) fn open_at_start(&mut self, paths: &[PathBuf], host: &mut dyn Host) {
        let files = host.files();
        let (pictures, paths): (Vec<PathBuf>, Vec<_>) =
            paths.iter().cloned().partition(|path| is_picture(path));
        let picture = pictures.into_iter().next_back();
        if paths.is_empty() {
            let nothing = Loaded::default();
            return self.begin_with(nothing, &[], &*files, Vec::new(), picture.as_deref());
        }
        let unpacked = paths.iter().flat_map(|path| io::unpacked(&*files, path));
        let paths: Vec<PathBuf> = unpacked.collect();
        // What is seen while large files are read.
        self.session.open(Vec::new(), self.view_without_scene());
        self.document = DocumentFile::untitled(self.session.document());
        let wanted = Wanted::Document(Missing::StandIn);
        let job = ReadJob {
            files,
            paths,
            wanted,
        };
        self.read(job, Use::Start(picture), host);
    }

    /// Shows what the program was started with: what was `loaded` from `paths`, each with the number of its shapes,
    /// compared with a picture if there is one. What could not be opened becomes a message. Whoever has begun
    /// something else meanwhile has the shapes added to that.
    pub(super) fn begin_with(
        &mut self,
        mut loaded: Loaded,
        paths: &[(PathBuf, usize)],
        files: &dyn Files,
        failed: Vec<Diagnostic>,
        picture: Option<&Path>,
    ) {
        if self.is_modified() {
            self.insert(loaded);
        } else {
            let mut shapes = std::mem::take(&mut loaded.shapes);
            // The picture shows them where their files have them.
            if picture.is_none() {
                let counts = paths.iter().map(|(_, count)| *count);
                let camera = loaded.view.unwrap_or_default().camera;
                shapes = set_beside_each_other(shapes, counts, &camera);
            }
            self.show_opened(shapes, loaded.view, picture.is_some());
            self.document = self.document_of(paths, files, !failed.is_empty());
            self.tell_all(Severity::Warning, loaded.warnings);
        }
        self.tell_all(Severity::Error, failed);
        if let Some(picture) = picture {
            self.compare_with(picture, files);
        }
        if self.is_viewer {
            self.session.look(View::Select(None));
        }
    }

    /// What is known of the file of the first document, which was read from `paths`, each with the number of its
    /// shapes: of several files it has the name of the first that is there.
    fn document_of(
        &mut self,
        paths: &[(PathBuf, usize)],
        files: &dyn Files,
        any_failed: bool,
    ) -> DocumentFile {
        let mut there = paths.iter().filter(|(_, count)| *count > 0 || !any_failed);
        let Some((first, _)) = there.next() else {
            return DocumentFile::untitled(self.session.document());
        };
        self.remember_recent(&io::character_file(files, first));
        let file = self.file_of(first, files);
        if paths.len() == 1 {
            return file;
        }
        // Saved over its first file, the others would be in that.
        DocumentFile {
            stem: file.stem,
            ..DocumentFile::untitled(self.session.document())
        }
    }

    /// Adds what the file at `path` holds, whatever it is.
    pub(super) fn import_any(&mut self, path: &Path, files: &Arc<dyn Files>, host: &mut dyn Host) {
        let work = Awaited::Import(path.to_owned(), Arc::clone(files));
        if !self.has_to_wait(&work, host) {
            self.import(path.to_owned(), Arc::clone(files), Wanted::Any, host);
        }
    }

    pub(super) fn import(
        &mut self,
        path: PathBuf,
        files: Arc<dyn Files>,
        wanted: Wanted,
        host: &mut dyn Host,
    ) {
        let paths = vec![path];
        let job = ReadJob {
            files,
            paths,
            wanted,
        };
        self.read(job, Use::Import, host);
    }

    /// Adds the shapes that were `loaded` to the document.
    pub(super) fn insert(&mut self, loaded: Loaded) {
        let mut shapes = loaded.shapes;
        let first = self.view_of_import(&mut shapes);
        match self.session.edit(Edit::Insert(shapes)) {
            Ok(change) => self.show_added(&change.added, first),
            Err(refused) => self.tell(Severity::Error, refused.to_string()),
        }
        self.tell_all(Severity::Warning, loaded.warnings);
    }

    /// Compares the view with the picture at `path` from now on, with what was chosen before.
    pub(super) fn compare_with(&mut self, path: &Path, files: &dyn Files) {
        match self.reference_picture(path, files) {
            Ok(picture) => self.begin_comparison(path.to_owned(), picture),
            Err(error) => self.tell(Severity::Error, error.to_string()),
        }
    }

    /// A picture to compare with.
    fn reference_picture(&self, path: &Path, files: &dyn Files) -> Result<Picture, Diagnostic> {
        let picture = image::decode(path, &files.read(path)?)?;
        let (width, height) = (picture.width, picture.height);
        let most = self.graphics.max_texture_side;
        if width.max(height) as usize > most {
            return Err(Diagnostic::new(
                path,
                format!(
                    "expected a picture of at most {most} pixels a side, found {width}×{height}"
                ),
            ));
        }
        Ok(picture)
    }

    pub(super) fn save_pose(
        &mut self,
        shape: ShapeId,
        kept: Option<usize>,
        path: &Path,
        host: &mut dyn Host,
    ) {
        // It may have been deleted while the dialog was open.
        match self.pose_text(shape, kept) {
            Some(text) => self.write(path, "json", text, host),
            None => self.tell(
                Severity::Error,
                "Not saved: the character or its pose does not exist any more",
            ),
        }
    }

    /// Name, without an extension, for a file with the pose of a character or a kept one.
    pub(super) fn name_of_pose(&self, shape: ShapeId, kept: Option<usize>) -> String {
        let scene = self.session.scene();
        let poses = scene.character(shape).map(|c| c.poses());
        let name = kept.and_then(|kept| Some(&poses?.get(kept)?.name));
        let name = name.or(scene.shape(shape).map(|shape| &shape.name));
        file_stem(name.map_or("pose", String::as_str))
    }

    /// Text of a pose file with the pose of a character, or one kept with it.
    pub(super) fn pose_text(&self, shape: ShapeId, kept: Option<usize>) -> Option<String> {
        let character = self.session.scene().character(shape)?;
        let pose: &Pose = match kept {
            Some(kept) => &character.poses().get(kept)?.pose,
            None => character.pose(),
        };
        Some(PoseData::new(character.character.skeleton(), pose).to_json())
    }

    pub(super) fn load_pose(&mut self, shape: ShapeId, path: &Path, files: &dyn Files) {
        match files.read(path) {
            Ok(bytes) => match PoseFile::read_several(path, &bytes) {
                Ok(Some(poses)) => self.keep_poses(shape, path, &poses),
                Ok(None) => {
                    self.take_pose(shape, path, &bytes, &Pasted::whole(Sides::AsTheyAre));
                }
                Err(error) => self.tell(Severity::Error, error.to_string()),
            },
            Err(error) => self.tell(Severity::Error, error.to_string()),
        }
    }

    pub(super) fn tell_no_character(&mut self, path: &Path) {
        let text = format!("{}: there is no character any more to pose", path.display());
        self.tell(Severity::Error, text);
    }

    /// The character that the pose of a file is meant for: `shape`, or else the first one that has joints of it, which is
    /// selected then.
    fn meant_by(&mut self, shape: ShapeId, file: &PoseFile, path: &Path) -> ShapeId {
        let fits = |id: ShapeId| {
            let character = self.session.scene().character(id);
            character.is_some_and(|character| file.fits(character.character.skeleton()))
        };
        if fits(shape) {
            return shape;
        }
        let shapes = self.session.scene().shapes().iter();
        let Some(other) = shapes.map(|shape| shape.id).find(|id| fits(*id)) else {
            return shape;
        };
        let name = self.session.scene().shape(other).map(|shape| &shape.name);
        let name = name.map_or("another character", String::as_str);
        let text = format!("{}: taken by {name}, which has its joints", path.display());
        self.tell(Severity::Info, text);
        self.session.look(View::Select(Some(other)));
        other
    }

    pub(super) fn take_pose(&mut self, shape: ShapeId, path: &Path, bytes: &[u8], pasted: &Pasted) {
        if self.session.scene().character(shape).is_none() {
            return self.tell_no_character(path);
        }
        let file = match PoseFile::read(path, bytes) {
            Ok(file) => file,
            Err(error) => return self.tell(Severity::Error, error.to_string()),
        };
        let shape = match path == Path::new(CLIPBOARD) {
            true => shape,
            false => self.meant_by(shape, &file, path),
        };
        let Some(character) = self.session.scene().character(shape) else {
            return;
        };
        let skeleton = character.character.skeleton();
        if let Some(joint) = file.first_joint()
            && path == Path::new(CLIPBOARD)
            && !file.fits(skeleton)
        {
            let shape = self.session.scene().shape(shape);
            let name = shape.map_or("the character", |shape| &shape.name);
            let text = format!(
                "The pose on the clipboard is another character's: {name} has none of the joints that it turns, such as {joint}"
            );
            return self.tell(Severity::Warning, text);
        }
        match file.what_fits(skeleton) {
            Ok((pose, missing)) => {
                let (pose, onto) = pasted.onto(skeleton, character.pose(), pose);
                let goes_somewhere = onto.as_ref().is_none_or(|joints| !joints.is_empty());
                let is_pasted = path == Path::new(CLIPBOARD) && goes_somewhere;
                let count = skeleton.joints().len();
                if is_pasted && missing.is_empty() && is_alike(&pose, character.pose(), count) {
                    let shape = self.session.scene().shape(shape);
                    let name = shape.map_or("The character", |shape| &shape.name);
                    let told = format!("{name} has this pose already");
                    return self.tell(Severity::Info, told);
                }
                let told = match &onto {
                    Some(joints) => Some(pasted.told(skeleton, joints, &missing)),
                    None if missing.is_empty() => None,
                    None => Some((Severity::Warning, without(path, &missing))),
                };
                if let Some((severity, told)) = told {
                    self.tell(severity, told);
                }
                if onto.is_some_and(|joints| joints.is_empty()) {
                    return;
                }
                self.edit(Edit::SetPose(shape, pose));
            }
            Err(error) => self.tell(Severity::Error, error.to_string()),
        }
    }

    /// Writes a picture in the format of its name.
    pub(super) fn save_picture(&mut self, path: &Path, picture: &Picture, host: &mut dyn Host) {
        match encode(path, picture) {
            Ok(bytes) => host.write_file(path, bytes, Previous::KeepForeign),
            Err(error) => self.tell_written(path, Err(error)),
        }
    }

    /// Writes `text`. A name without the extension that it needs to be read again is refused
    /// rather than changed: the file dialog has asked whether to replace a file of the name that
    /// was typed.
    pub(super) fn write(
        &mut self,
        path: &Path,
        extension: &str,
        text: String,
        host: &mut dyn Host,
    ) {
        match io::expect_extension(path, extension) {
            Ok(()) => host.write_file(path, text.into_bytes(), Previous::KeepForeign),
            Err(error) => self.tell_written(path, Err(error)),
        }
    }

    /// Says how writing a file went.
    pub(super) fn tell_written(&mut self, path: &Path, written: Result<(), Diagnostic>) {
        match written {
            Ok(()) => self.tell(Severity::Info, format!("Saved {}", path.display())),
            Err(error) => self.tell(Severity::Error, format!("Not saved: {error}")),
        }
    }

    pub(super) fn tell_all(&mut self, severity: Severity, diagnostics: Vec<Diagnostic>) {
        for diagnostic in diagnostics {
            self.tell(severity, diagnostic.to_string());
        }
    }
}

fn encode(path: &Path, picture: &Picture) -> Result<Vec<u8>, Diagnostic> {
    let format = PictureFormat::of(path)?;
    image::encode(picture, format).map_err(|message| Diagnostic::new(path, message))
}

pub(super) fn is_picture(path: &Path) -> bool {
    PictureFormat::of(path).is_ok()
}

/// Name of the file at `path`, without its folder.
pub(super) fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

/// Name, without an extension, of a file for a shape or a pose called `name`.
pub(super) fn file_stem(name: &str) -> String {
    let stem: String = name
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || c == '_' {
                c
            } else {
                '-'
            }
        })
        .collect();
    match stem.trim_matches('-') {
        "" => "shape".to_owned(),
        stem => stem.to_owned(),
    }
}

/// Whether poses of a skeleton with so many joints are the same but for what a file rounds off.
fn is_alike(one: &Pose, other: &Pose, joints: usize) -> bool {
    (0..joints).all(|joint| {
        let [a, b] = [one, other].map(|pose| (pose.rotation(joint), pose.root_offset(joint)));
        (a.0.radians).abs_diff_eq(b.0.radians, ROUNDED_OFF)
            && a.1
                .abs_diff_eq(b.1, ROUNDED_OFF * a.1.abs().max_element().max(1.0))
    })
}

/// Message about a pose that some joints of `missing` names were left out of.
pub(super) fn without(path: &Path, missing: &[&str]) -> String {
    let missing = listed(missing);
    format!(
        "{}: applied without {missing}, which this character does not have",
        path.display()
    )
}

/// The first of `names`, and how many more there are.
pub(super) fn listed<T: Borrow<str>>(names: &[T]) -> String {
    const NAMED: usize = 3;
    let named = names[..names.len().min(NAMED)].join(", ");
    match names.len().saturating_sub(NAMED) {
        0 => named,
        more => format!("{named} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_called_like_its_shape_without_what_file_systems_refuse() {
        assert_eq!(file_stem("Bézier Curve"), "Bézier-Curve");
        assert_eq!(file_stem("../A:b"), "A-b");
        assert_eq!(file_stem("walk_2"), "walk_2");
        assert_eq!(file_stem("///"), "shape");
    }

    #[test]
    fn joints_that_a_character_does_not_have_are_named_and_many_are_counted() {
        let clipboard = Path::new(CLIPBOARD);
        assert_eq!(
            without(clipboard, &["Tail"]),
            "clipboard: applied without Tail, which this character does not have"
        );
        let many = ["A", "B", "C", "D", "E"];
        assert!(without(clipboard, &many).contains("A, B, C and 2 more,"));
    }
}
