//! Saving the document.

use super::document::Next;
use super::document_file::Writing;
use super::exports::Exporting;
use super::files::file_name;
use super::questions::Asked;
use super::running::Program;
use super::{Host, Previous, Purpose};
use crate::editor::{Edit, Severity};
use crate::io::{self, Diagnostic, Files};
use crate::scene::{ShapeId, Source, ViewSettings};
use std::path::{Path, PathBuf};

impl Program {
    /// Saves the document to its file, or lets one be chosen if it has none, and then does `then`.
    pub(super) fn save(&mut self, then: Option<Next>, host: &mut dyn Host) {
        let Some(path) = self.document.path.clone() else {
            return self.save_as(then, host);
        };
        if self.document.is_on_disk(&*host.files()) {
            self.write_document(path, then, host);
        } else {
            self.asked = Some(Asked::Overwrite(path, then));
        }
    }

    /// Lets a file be chosen for the document, saves it there, and then does `then`.
    pub(super) fn save_as(&mut self, then: Option<Next>, host: &mut dyn Host) {
        self.document.then = then;
        let name = format!("{}.scene", self.document_stem());
        self.choose_file(Purpose::SaveScene, &name, host);
    }

    /// Saves the document to the file that was chosen for it.
    pub(super) fn save_to(&mut self, path: PathBuf, host: &mut dyn Host) {
        let then = self.document.then.take();
        let expected = match io::is_archive(&path) {
            true => Ok(()),
            false => io::expect_extension(&path, "scene"),
        };
        match expected {
            Ok(()) if self.is_foreign(&path, &*host.files()) => {
                self.asked = Some(Asked::Overwrite(path, then));
            }
            Ok(()) => self.write_document(path, then, host),
            Err(error) => self.tell_written(&path, Err(error)),
        }
    }

    /// Whether `path` leads to the document's file, and another program has changed that.
    pub(super) fn is_foreign(&self, path: &Path, files: &dyn Files) -> bool {
        self.is_own(path, files) && !self.document.is_on_disk(files)
    }

    /// Whether `path` leads to the document's file.
    pub(super) fn is_own(&self, path: &Path, files: &dyn Files) -> bool {
        let own = self.document.path();
        own.is_some_and(|own| files.real(own) == files.real(path))
    }

    /// The view as it is kept with the document: the look and the camera of a comparison are for that time only.
    pub(super) fn document_view(&self) -> ViewSettings {
        let view = *self.session.view();
        match &self.comparison {
            Some(comparison) => ViewSettings {
                look: comparison.look_after(view.look),
                camera: comparison.camera_after(view.camera),
                ..view
            },
            None => view,
        }
    }

    /// Writes the document to `path`, and then does `then`.
    pub(super) fn write_document(
        &mut self,
        path: PathBuf,
        then: Option<Next>,
        host: &mut dyn Host,
    ) {
        if io::is_archive(&path) {
            return self.write_archive(&path, then, host);
        }
        let view = self.document_view();
        let bytes = match io::scene_text(self.session.scene(), &view, path.parent()) {
            Ok(text) => text.into_bytes(),
            Err(error) => {
                let error = Diagnostic::new(&path, error.to_string());
                return self.tell_written(&path, Err(error));
            }
        };
        let document = self.session.document();
        let previous = self.previous_version(&path);
        self.document.writing = Some(Writing {
            path: path.clone(),
            document,
            digest: crc32fast::hash(&bytes),
            sources: Vec::new(),
            then,
        });
        host.write_file(&path, bytes, previous);
    }

    /// What becomes of the version that a save of the document to `path` replaces. One in which only the view
    /// differs is not worth the one before it.
    pub(super) fn previous_version(&self, path: &Path) -> Previous {
        if self.document.path() == Some(path) && !self.is_modified() {
            Previous::KeepForeign
        } else {
            Previous::KeepBeside
        }
    }

    /// Takes note that the file at `path` was written, or could not be; goes on with what waited
    /// for it if it is the document's.
    pub(super) fn written(
        &mut self,
        path: &Path,
        result: Result<(), Diagnostic>,
        host: &mut dyn Host,
    ) {
        let is_saved = result.is_ok();
        self.remember_written(path, is_saved);
        self.tell_written(path, result);
        if let Some(exported) = self.exporting.take_if(|exporting| exporting.path == path)
            && is_saved
        {
            let Exporting {
                digests, left_out, ..
            } = exported;
            if let Some(text) = left_out {
                self.tell(Severity::Warning, text);
            }
            let pose = path.with_extension("json");
            if pose != path && digests.contains_key(&pose) {
                // A character is opened at rest, as its files have it.
                let obj = path.with_extension("obj");
                let text = format!(
                    "Its pose is in {}, for the character as {} has it: with that open, Pose ⏵ Load Pose… gives it",
                    file_name(&pose),
                    file_name(&obj)
                );
                self.tell(Severity::Info, text);
            }
            self.exported.extend(digests);
        }
        let is_document = |writing: &mut Writing| writing.path == path;
        let Some(writing) = self.document.writing.take_if(is_document) else {
            return;
        };
        if is_saved {
            self.document.saved = writing.document;
            self.document.saved_in_lost_file = None;
            self.document.path = Some(writing.path);
            self.document.digest = Some(writing.digest);
            self.relink(writing.sources);
            self.tell_missing_models(&*host.files());
            self.remember_recent(path);
            if let Some(next) = writing.then {
                self.leave_for(next, host);
            }
        }
    }

    /// Has shapes come from other files with the same contents from now on, as they do in the document's
    /// file already.
    fn relink(&mut self, sources: Vec<(ShapeId, Source)>) {
        let is_saved = !self.is_modified();
        let edits = sources.into_iter().filter_map(|(id, source)| {
            let kind = self.session.scene().shape(id)?.kind.clone();
            Some(Edit::Replace(id, kind, source))
        });
        let edits: Vec<Edit> = edits.collect();
        if !edits.is_empty() && self.edit(Edit::Together(edits)) && is_saved {
            self.document.saved = self.session.document();
        }
    }
}
