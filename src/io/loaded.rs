//! What is opened as one scene, from one or more files.

use super::archive::main_files;
use super::file_importer::{IMPORTABLE, cannot_open, character_file, import_any_by, to_open};
use super::scene::{Missing, read_scene_by};
use super::{Diagnostic, Files, Imported, file_access};
use crate::scene::{NewShape, ViewSettings};
use crate::steps::{Pace, at_once};
use std::path::Path;

/// The scenes and shapes of one or more files, to be opened as one scene.
#[derive(Clone, Debug, Default)]
pub struct Loaded {
    /// All their shapes, in the order of the files.
    pub shapes: Vec<NewShape>,
    /// The view of the last scene file; none if there is none.
    pub view: Option<ViewSettings>,
    /// Warnings about them.
    pub warnings: Vec<Diagnostic>,
    /// Treatment of files that scenes name and that cannot be read.
    pub missing: Missing,
}

impl Loaded {
    /// Adds the content of the file at `path`: the shapes of a scene with its view, those of the one
    /// scene in an archive or else all models there, or an import.
    ///
    /// # Errors
    /// If it cannot be read or is not well formed; then nothing is added.
    pub fn add(&mut self, files: &dyn Files, path: &Path) -> Result<(), Diagnostic> {
        at_once(|pace| async move { self.add_by(files, path, &pace).await })
    }

    /// As [`Loaded::add`], at a pace that is told of bytes.
    ///
    /// # Errors
    /// As [`Loaded::add`].
    pub(super) async fn add_by(
        &mut self,
        files: &dyn Files,
        path: &Path,
        pace: &Pace,
    ) -> Result<(), Diagnostic> {
        let path = &*character_file(files, path);
        let file = to_open(path)?;
        match file_access::extension(&file).as_str() {
            "scene" => self.add_scene(files, &file, pace).await?,
            "zip" => {
                let mut packed = Self {
                    missing: self.missing,
                    ..Self::default()
                };
                for path in main_files(files, &file)? {
                    if file_access::is_scene(&path) {
                        packed.add_scene(files, &path, pace).await?;
                    } else {
                        packed.add_imported(import_any_by(files, &path, pace).await?);
                    }
                }
                self.add_loaded(packed);
            }
            extension if !IMPORTABLE.contains(&extension) => {
                let openable = [&["scene", "zip"], &IMPORTABLE[..]].concat();
                return Err(cannot_open(
                    files,
                    path,
                    extension,
                    "a file that can be opened",
                    &openable,
                ));
            }
            _ => self.add_imported(import_any_by(files, path, pace).await?),
        }
        Ok(())
    }

    async fn add_scene(
        &mut self,
        files: &dyn Files,
        path: &Path,
        pace: &Pace,
    ) -> Result<(), Diagnostic> {
        let read = read_scene_by(files, path, self.missing, pace).await?;
        self.warnings.extend(read.warnings);
        self.view = Some(read.value.view);
        self.shapes.extend(read.value.shapes);
        Ok(())
    }

    /// Adds what was loaded from another file.
    fn add_loaded(&mut self, other: Self) {
        self.warnings.extend(other.warnings);
        self.view = other.view.or(self.view);
        self.shapes.extend(other.shapes);
    }

    /// Adds imported shapes.
    pub fn add_imported(&mut self, imported: Imported<Vec<NewShape>>) {
        self.warnings.extend(imported.warnings);
        self.shapes.extend(imported.value);
    }
}
