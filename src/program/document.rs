//! Opening and saving the document, and asking before unsaved work is lost.

use super::awaited::Awaited;
use super::document_file::{DocumentFile, Writing, digest_at};
use super::document_name::{free_name, holds_document};
use super::preferences::MOST_RECENT;
use super::questions::Asked;
use super::reading::{Opened, Use};
use super::running::Program;
use super::{FileRequest, Host, Previous, Purpose, Suggested};
use crate::editor::{Edit, Severity};
use crate::io::{self, Diagnostic, Files, Missing, ReadJob, Wanted};
use crate::scene::{ShapeId, Source, ViewSettings};
use crate::ui::{Answer, MeshColors};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Something that replaces the document or ends the program, and so waits until nothing is unsaved.
#[derive(Clone)]
pub(super) enum Next {
    New,
    /// Choose a file, and open it.
    Open,
    /// Open the first of some files, and add the others to it.
    OpenFiles(ToOpen),
    OpenBuiltin(&'static str),
    /// Open the document's own file again, as it is now.
    Revert(PathBuf, Arc<dyn Files>),
    /// Show a document that was read.
    Show(Box<Opened>),
    Quit,
}

/// Files to open in the place of the document.
#[derive(Clone)]
pub(super) struct ToOpen {
    pub paths: Vec<PathBuf>,
    pub files: Arc<dyn Files>,
    /// Number of the first message about these files: those before it are about the document before.
    pub since: u64,
}

impl Program {
    /// Files to open, about which nothing has been told.
    pub(super) fn to_open(&self, paths: Vec<PathBuf>, files: Arc<dyn Files>) -> ToOpen {
        let since = self.session.messages.count();
        ToOpen {
            paths,
            files,
            since,
        }
    }

    /// Whether there are changes that are not in the document's file.
    pub fn is_modified(&self) -> bool {
        self.session.document() != self.document.saved
    }

    /// Does `next`, after asking about changes that are not saved.
    pub(super) fn leave_for(&mut self, next: Next, host: &mut dyn Host) {
        self.document.discarded = None;
        self.quitting = false;
        if self.is_modified() {
            self.asked = Some(Asked::Unsaved(next));
        } else {
            self.go_on(next, host);
        }
    }

    /// Quits, if that waits for pictures and none is left to wait for; asks about what was changed
    /// meanwhile.
    pub(super) fn quit_after_pictures(&mut self, host: &mut dyn Host) {
        if !self.quitting || self.has_pictures_under_way() {
            return;
        }
        self.leave_as_answered(Next::Quit, host);
    }

    /// As [`Program::leave_for`], but whoever has said already that the changes so far are not wanted
    /// is not asked again.
    pub(super) fn leave_as_answered(&mut self, next: Next, host: &mut dyn Host) {
        if self.document.discarded.take() == Some(self.session.document()) {
            self.go_on(next, host);
        } else {
            self.leave_for(next, host);
        }
    }

    pub(super) fn go_on(&mut self, next: Next, host: &mut dyn Host) {
        if self.has_to_wait(&Awaited::Next(next.clone()), host) {
            // What is done meanwhile is asked about then; what is not wanted now is not.
            self.document.discarded = Some(self.session.document());
            return;
        }
        match next {
            Next::New => {
                self.cancel_reading(host);
                self.end_comparison();
                // They are about another document.
                self.session.messages.dismiss_all();
                self.ui.colors = MeshColors::default();
                self.session.open(Vec::new(), self.view_without_scene());
                self.ui.suit_navigation(self.session.view().look);
                self.document = DocumentFile::untitled(self.session.document());
            }
            Next::Open => self.choose_file(Purpose::Open, "", host),
            Next::OpenFiles(to_open) => self.open(to_open, Missing::StandIn, host),
            // What is in memory must not become a box because a file is gone.
            Next::Revert(path, files) => {
                self.open(self.to_open(vec![path], files), Missing::Refuse, host);
            }
            Next::OpenBuiltin(name) => {
                let path = PathBuf::from(format!("builtin:{name}"));
                self.open(
                    self.to_open(vec![path], host.files()),
                    Missing::Refuse,
                    host,
                );
            }
            Next::Show(opened) => self.show_document(*opened, host),
            Next::Quit if self.has_pictures_under_way() => {
                // What is done meanwhile is asked about then; what is not wanted now is not.
                self.document.discarded = Some(self.session.document());
                self.quitting = true;
                let text = "The program ends when the picture that is under way is written";
                self.tell(Severity::Info, text);
            }
            Next::Quit => {
                self.drop_reading();
                // What is not saved by now is not wanted.
                self.document.saved = self.session.document();
                self.forget_autosave(host);
                self.keep_at_end(host);
                host.quit();
            }
        }
    }

    /// Opens the first scene or model of `paths` in the place of the document, once it has been read, and
    /// adds the others to it. One that cannot be read leaves its place to the next, and the last one the
    /// document untouched. What is read for the document before is not wanted any more.
    fn open(&mut self, to_open: ToOpen, missing: Missing, host: &mut dyn Host) {
        let ToOpen {
            paths,
            files,
            since,
        } = to_open;
        self.cancel_reading(host);
        // What is done meanwhile is asked about then; what is not wanted now is not.
        self.document.discarded = Some(self.session.document());
        let unpacked = paths.iter().flat_map(|path| io::unpacked(&*files, path));
        let mut paths: Vec<PathBuf> = unpacked.collect();
        let others = paths.split_off(paths.len().min(1));
        let job = ReadJob {
            files,
            paths,
            wanted: Wanted::Document(missing),
        };
        self.read(job, Use::Open { others, since }, host);
    }

    /// Shows a document that was read, and adds what was chosen together with it.
    fn show_document(&mut self, opened: Opened, host: &mut dyn Host) {
        let Opened {
            path,
            others,
            since,
            files,
            loaded,
        } = opened;
        let compared = self.comparison.is_some();
        // Models of a scene may have come together with it.
        let sources = loaded.shapes.iter().flat_map(|shape| &shape.source);
        let named: HashSet<PathBuf> = sources
            .map(|source| files.real(Path::new(&source.file)))
            .collect();
        let is_new = |path: &PathBuf| !named.contains(&files.real(path));
        let others: Vec<PathBuf> = others.into_iter().filter(is_new).collect();
        self.session.messages.dismiss_before(since);
        self.show_opened(loaded.shapes, loaded.view, compared);
        self.document = self.file_of(&path, &*files);
        self.remember_recent(&io::character_file(&*files, &path));
        self.tell_all(Severity::Warning, loaded.warnings);
        for path in others {
            let job = ReadJob {
                files: Arc::clone(&files),
                paths: vec![path],
                wanted: Wanted::Document(Missing::StandIn),
            };
            self.read(job, Use::Import, host);
        }
    }

    /// Says why the file at `path` is not opened, and opens `others` instead.
    pub(super) fn go_on_without(
        &mut self,
        path: &Path,
        error: &Diagnostic,
        others: ToOpen,
        host: &mut dyn Host,
    ) {
        self.preferences.recent.retain(|recent| recent != path);
        self.tell(Severity::Error, error.to_string());
        if others.paths.is_empty() {
            self.document.discarded = None;
        } else {
            self.leave_as_answered(Next::OpenFiles(others), host);
        }
    }

    /// What is known of the file at `path`, from which the document has just been opened. Only
    /// scenes on a disk can be saved to where they came from.
    pub(super) fn file_of(&self, path: &Path, files: &dyn Files) -> DocumentFile {
        let name = path.to_string_lossy();
        let name = name.strip_prefix(io::builtin::PREFIX).unwrap_or(&name);
        let stem = Path::new(name).file_stem();
        let untitled = DocumentFile {
            stem: stem.map(|stem| stem.to_string_lossy().into_owned()),
            ..DocumentFile::untitled(self.session.document())
        };
        if !holds_document(path) || io::builtin::is_builtin(path) {
            return untitled;
        }
        DocumentFile {
            path: Some(path.to_owned()),
            digest: digest_at(path, files),
            ..untitled
        }
    }

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

    /// The view as it is kept with the document: the look of a comparison is for that time only.
    pub(super) fn document_view(&self) -> ViewSettings {
        let view = *self.session.view();
        let look = self.comparison.as_ref().map(|c| c.look_after(view.look));
        ViewSettings {
            look: look.unwrap_or(view.look),
            ..view
        }
    }

    fn write_document(&mut self, path: PathBuf, then: Option<Next>, host: &mut dyn Host) {
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
        if let Some((_, digests)) = self.exporting.take_if(|(exported, _)| exported == path)
            && is_saved
        {
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

    /// Goes on as the user answered the question that was asked.
    pub(super) fn take_answer(&mut self, answer: Answer, host: &mut dyn Host) {
        self.quitting = false;
        match (self.asked.take(), answer) {
            (Some(Asked::Unsaved(next)), Answer::Save) => self.save(Some(next), host),
            (Some(Asked::Unsaved(next)), Answer::Discard | Answer::Revert) => {
                if matches!(next, Next::Open) {
                    self.document.discarded = Some(self.session.document());
                }
                self.go_on(next, host)
            }
            (Some(Asked::Overwrite(path, then)), Answer::Overwrite) => {
                self.write_document(path, then, host);
            }
            (Some(Asked::Overwrite(_, then)), Answer::SaveAs) => self.save_as(then, host),
            (Some(Asked::Replace(together)), Answer::Overwrite) => {
                self.write_now(together, host);
            }
            (Some(Asked::Restore(kept, _)), Answer::Restore) => self.restore(&kept, host),
            (Some(Asked::Restore(..)), Answer::Forget) => {
                if let Some(path) = host.put_unsaved_work_aside() {
                    let text = format!("What was discarded is in {}", path.display());
                    self.tell(Severity::Info, text);
                }
                self.offer_next(host);
            }
            (Some(Asked::Restore(..)), Answer::Later) => self.offer_next(host),
            _ => {}
        }
    }

    /// Lets a file be chosen in the folder of the last one of its kind, or of the document if it is that
    /// which is saved; one that is to be written is called `name` until the user does otherwise.
    pub(super) fn choose_file(&self, purpose: Purpose, name: &str, host: &mut dyn Host) {
        let is_scene = matches!(purpose, Purpose::SaveScene | Purpose::SaveWithFiles);
        let own = self.document.path.as_deref().filter(|_| is_scene);
        let own = own.and_then(Path::parent).map(Path::to_owned);
        let folder = own.or_else(|| self.folder_for(purpose.kind()));
        // Two quick Enters must not replace another scene.
        let name = if is_scene {
            free_name(name, folder.as_deref(), &*host.files())
        } else {
            name.to_owned()
        };
        let suggested = Suggested {
            folder,
            recent: self.preferences.recent_folders(self.to_write.values()),
            name,
        };
        let opened = self.session.opened();
        host.choose_file(FileRequest { purpose, opened }, suggested);
    }

    /// Puts a file first in File ▸ Open Recent.
    pub(super) fn remember_recent(&mut self, path: &Path) {
        // A model that was opened from an archive is found with all others there.
        let mut folders = path.ancestors().skip(1);
        let path = folders
            .find(|folder| io::is_archive(folder))
            .unwrap_or(path);
        if io::builtin::is_builtin(path) {
            return;
        }
        let recent = &mut self.preferences.recent;
        recent.retain(|known| known != path);
        recent.insert(0, path.to_owned());
        recent.truncate(MOST_RECENT);
    }
}
