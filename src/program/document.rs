//! Opening and leaving the document, and asking before unsaved work is lost.

use super::awaited::Awaited;
use super::document_file::{DocumentFile, digest_at};
use super::document_name::{free_name, holds_document};
use super::preferences::MOST_RECENT;
use super::questions::Asked;
use super::reading::{Opened, Use};
use super::running::Program;
use super::{FileRequest, Host, Purpose, Suggested};
use crate::editor::Severity;
use crate::io::{self, Diagnostic, Files, Missing, ReadJob, Wanted};
use crate::scene::Look;
use crate::ui::{Answer, MeshColors, scene_label};
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
        // What is not compared as the course draws it is about the document that was open.
        let compared = self.comparison.as_ref();
        if compared.is_some_and(|it| it.looks.0 != Look::Course) {
            self.end_comparison();
        }
        let compared = self.comparison.is_some();
        // Models of a scene may have come together with it.
        let sources = loaded.shapes.iter().flat_map(|shape| &shape.source);
        let named: HashSet<PathBuf> = sources
            .map(|source| files.real(Path::new(&source.file)))
            .collect();
        let is_new = |path: &PathBuf| !named.contains(&files.real(path));
        let others: Vec<PathBuf> = others.into_iter().filter(is_new).collect();
        self.session.messages.dismiss_numbers(&(0..since));
        let scene = io::builtin::builtin_name(&path).and_then(scene_label);
        let shows_shapes = !self.session.scene().shapes().is_empty();
        let replaced = shows_shapes.then(|| self.document_name());
        if self.document.path() != Some(&path) {
            self.ui.colors = MeshColors::default();
        }
        self.show_opened(loaded.shapes, loaded.view, compared);
        self.document = self.file_of(&path, &*files);
        self.remember_recent(&io::character_file(&*files, &path));
        // A key that was pressed by mistake may have opened it.
        if let (Some(scene), Some(replaced)) = (scene, replaced) {
            self.tell(
                Severity::Info,
                format!("Opened {scene} in the place of {replaced}"),
            );
        }
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
    /// which is saved, or if the file is the first of its kind that is written; one that is to be written is called `name`
    /// until the user does otherwise.
    pub(super) fn choose_file(&self, purpose: Purpose, name: &str, host: &mut dyn Host) {
        let is_scene = matches!(purpose, Purpose::SaveScene | Purpose::SaveWithFiles);
        let of_document = self.document.path.as_deref().and_then(Path::parent);
        let of_document = of_document.filter(|_| !purpose.written().is_empty());
        let of_document = of_document.map(Path::to_owned);
        let of_kind = || self.folder_of_last(purpose.kind());
        let own = if is_scene {
            of_document.or_else(of_kind)
        } else {
            of_kind().or(of_document)
        };
        let folder = own.or_else(|| self.preferences.last_folder.clone());
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
        // A folder named as `a/../b` is `b`.
        let normal = io::normal(path);
        recent.retain(|known| io::normal(known) != normal);
        recent.insert(0, path.to_owned());
        recent.truncate(MOST_RECENT);
    }
}
