//! The document's file: opening and saving it, and asking before unsaved work is lost.

use super::autosave::Kept;
use super::running::Program;
use super::{FileRequest, Host, Previous, Purpose, StorageKey, Suggested};
use crate::editor::Severity;
use crate::io::{self, Diagnostic, Files, Loaded, Missing};
use crate::revision::Revision;
use crate::ui::{Answer, Question};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Name of a document that has no file yet.
const UNTITLED: &str = "Untitled";

/// Number of files in File ▸ Open Recent.
const MOST_RECENT: usize = 10;

/// File of the document, and how much of the document is in it.
pub(super) struct DocumentFile {
    /// File that Save writes; `None` until there is one.
    path: Option<PathBuf>,
    /// Revision of the document that is in the file, or that was opened.
    saved: Revision,
    /// CRC-32 of the file's bytes as they were read or written last: other bytes are another
    /// program's.
    digest: Option<u32>,
    /// Write under way.
    writing: Option<Writing>,
    /// Continuation of the next save, for which a file is being chosen.
    then: Option<Next>,
    /// Name without an extension that files made from the document are offered, while it has no
    /// file: that of what was opened.
    stem: Option<String>,
    /// Revision of the document that is not wanted any more while another is chosen to be opened.
    discarded: Option<Revision>,
    /// What `saved` was before the file disappeared, in case it comes back.
    saved_in_lost_file: Option<Revision>,
}

struct Writing {
    path: PathBuf,
    document: Revision,
    digest: u32,
    then: Option<Next>,
}

/// Something that replaces the document or ends the program, and so waits until nothing is unsaved.
#[derive(Clone)]
pub(super) enum Next {
    New,
    /// Choose a file, and open it.
    Open,
    OpenFile(PathBuf, Arc<dyn Files>),
    OpenBuiltin(&'static str),
    /// Open the document's own file again, as it is now.
    Revert(PathBuf, Arc<dyn Files>),
    Quit,
}

/// Question that waits for its answer.
pub(super) enum Asked {
    /// There are unsaved changes.
    Unsaved(Next),
    /// The file was changed by another program since it was read or written here.
    Overwrite(PathBuf, Option<Next>),
    /// An earlier run did not end in order, and left unsaved work, this long ago if that is known.
    Restore(Kept, Option<Duration>),
}

impl DocumentFile {
    /// A document without a file, of which `saved` is no loss.
    pub fn untitled(saved: Revision) -> Self {
        Self {
            path: None,
            saved,
            digest: None,
            writing: None,
            then: None,
            stem: None,
            discarded: None,
            saved_in_lost_file: None,
        }
    }

    /// A document that is not in its file, of which an earlier run knew `digest`.
    pub fn restored(path: Option<PathBuf>, digest: Option<u32>) -> Self {
        Self {
            path,
            digest,
            ..Self::untitled(Revision::new())
        }
    }

    /// File that Save writes; `None` until there is one.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Whether the file is as it was read or written last; so is one that is gone.
    pub fn is_on_disk(&self, files: &dyn Files) -> bool {
        let found = self.path.as_deref().and_then(|path| digest_at(path, files));
        found.is_none() || found == self.digest
    }

    /// Takes note that the file has disappeared: nothing of the document is saved any more.
    pub fn lose(&mut self) {
        let saved = std::mem::replace(&mut self.saved, Revision::new());
        self.saved_in_lost_file.get_or_insert(saved);
    }

    /// Takes note that the file is there, as it was read or written last.
    pub fn find(&mut self) {
        if let Some(saved) = self.saved_in_lost_file.take() {
            self.saved = saved;
        }
    }

    /// Takes note that the document is being written to its file as `bytes`, beside other files.
    pub fn write_with_others(&mut self, document: Revision, bytes: &[u8]) {
        self.writing = self.path.clone().map(|path| Writing {
            path,
            document,
            digest: crc32fast::hash(bytes),
            then: None,
        });
    }

    /// Digest of the file's bytes as they were read or written last.
    pub fn digest(&self) -> Option<u32> {
        self.digest
    }
}

impl Asked {
    /// The question about a document called `name`.
    pub fn question(&self, name: &str) -> Question {
        match self {
            Self::Unsaved(next) => unsaved(next, name),
            Self::Overwrite(path, _) => Question {
                title: "Overwrite the file?".to_owned(),
                text: format!(
                    "Another program or window has changed {} since it was opened here. \
                     Overwriting replaces what it wrote.",
                    path.display()
                ),
                answers: vec![Answer::SaveAs, Answer::Overwrite, Answer::Cancel],
            },
            Self::Restore(kept, since) => Question {
                title: "Restore unsaved changes?".to_owned(),
                text: restore_text(kept.path(), *since),
                answers: vec![Answer::Restore, Answer::Later, Answer::Forget],
            },
        }
    }
}

impl Program {
    /// Whether there are changes that are not in the document's file.
    pub fn is_modified(&self) -> bool {
        self.session.document() != self.document.saved
    }

    /// Name of the document: that of its file, if it has one.
    pub(super) fn document_name(&self) -> String {
        let name = self.document.path.as_deref().and_then(Path::file_name);
        name.map_or_else(
            || UNTITLED.to_owned(),
            |name| name.to_string_lossy().into_owned(),
        )
    }

    /// Name of the document without its extension, for files that are made from it.
    pub(super) fn document_stem(&self) -> String {
        let stem = self.document.path.as_deref().and_then(Path::file_stem);
        let stem = stem.map(|stem| stem.to_string_lossy().into_owned());
        let stem = stem.or_else(|| self.document.stem.clone());
        stem.unwrap_or_else(|| "scene".to_owned())
    }

    /// Title of the window: the document, with a mark if it is modified, and the program. A
    /// document that is neither named nor modified is not mentioned.
    pub(super) fn title(&self) -> String {
        let mark = if self.is_modified() { "*" } else { "" };
        let is_nothing_to_tell = self.document.path.is_none() && mark.is_empty();
        // A picture of the panels has no title at all.
        if is_nothing_to_tell || self.program_title.is_empty() {
            return self.program_title.clone();
        }
        format!("{mark}{} — {}", self.document_name(), self.program_title)
    }

    /// Does `next`, after asking about changes that are not saved.
    pub(super) fn leave_for(&mut self, next: Next, host: &mut dyn Host) {
        self.document.discarded = None;
        if self.is_modified() {
            self.asked = Some(Asked::Unsaved(next));
        } else {
            self.go_on(next, host);
        }
    }

    /// Opens the file that was chosen for it. Whoever has said before the choice that changes are not
    /// wanted is not asked again.
    pub(super) fn open_chosen(
        &mut self,
        path: PathBuf,
        files: Arc<dyn Files>,
        host: &mut dyn Host,
    ) {
        let next = Next::OpenFile(path, files);
        if self.document.discarded.take() == Some(self.session.document()) {
            self.go_on(next, host);
        } else {
            self.leave_for(next, host);
        }
    }

    fn go_on(&mut self, next: Next, host: &mut dyn Host) {
        match next {
            Next::New => {
                self.session.open(Vec::new(), self.view_without_scene());
                self.document = DocumentFile::untitled(self.session.document());
            }
            Next::Open => self.choose_file(Purpose::Open, "", host),
            Next::OpenFile(path, files) => self.open(&path, &*files, Missing::StandIn),
            // What is in memory must not become a box because a file is gone.
            Next::Revert(path, files) => self.open(&path, &*files, Missing::Refuse),
            Next::OpenBuiltin(name) => {
                let path = PathBuf::from(format!("builtin:{name}"));
                self.open(&path, &*host.files(), Missing::Refuse);
            }
            Next::Quit => {
                // What is not saved by now is not wanted.
                self.document.saved = self.session.document();
                self.forget_autosave(host);
                self.keep_at_end(host);
                // A picture that was asked for is written first.
                self.quitting = true;
                self.quit_after_pictures(host);
            }
        }
    }

    /// Opens the scene or the model at `path` in the place of the document; one that cannot be read
    /// leaves it untouched.
    fn open(&mut self, path: &Path, files: &dyn Files, missing: Missing) {
        let mut loaded = Loaded {
            missing,
            ..Loaded::default()
        };
        match loaded.add(files, path) {
            Ok(()) => {
                let compared = self.comparison.is_some();
                self.show_opened(loaded.shapes, loaded.view, compared);
                self.document = self.file_of(path, files);
                self.remember_recent(path);
                self.tell_all(Severity::Warning, loaded.warnings);
            }
            Err(error) => {
                self.preferences.recent.retain(|recent| recent != path);
                self.tell(Severity::Error, error.to_string());
            }
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
        if !is_scene(path) || io::builtin::is_builtin(path) {
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
        match io::expect_extension(&path, "scene") {
            Ok(()) => self.write_document(path, then, host),
            Err(error) => self.tell_written(&path, Err(error)),
        }
    }

    fn write_document(&mut self, path: PathBuf, then: Option<Next>, host: &mut dyn Host) {
        let (scene, view) = (self.session.scene(), self.session.view());
        let bytes = match io::scene_text(scene, view, path.parent()) {
            Ok(text) => text.into_bytes(),
            Err(error) => {
                let error = Diagnostic::new(&path, error.to_string());
                return self.tell_written(&path, Err(error));
            }
        };
        let document = self.session.document();
        // A version in which only the view differs is not worth the one that is kept.
        let is_same = self.document.path() == Some(&path) && self.document.saved == document;
        let previous = if is_same {
            Previous::Replace
        } else {
            Previous::KeepBeside
        };
        self.document.writing = Some(Writing {
            path: path.clone(),
            document,
            digest: crc32fast::hash(&bytes),
            then,
        });
        host.write_file(&path, bytes, previous);
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
        self.tell_written(path, result);
        let is_document = |writing: &mut Writing| writing.path == path;
        let Some(writing) = self.document.writing.take_if(is_document) else {
            return;
        };
        if is_saved {
            self.document.path = Some(writing.path);
            self.document.saved = writing.document;
            self.document.saved_in_lost_file = None;
            self.document.digest = Some(writing.digest);
            self.remember_recent(path);
            if let Some(next) = writing.then {
                self.leave_for(next, host);
            }
        }
    }

    /// Goes on as the user answered the question that was asked.
    pub(super) fn take_answer(&mut self, answer: Answer, host: &mut dyn Host) {
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
            (Some(Asked::Restore(kept, _)), Answer::Restore) => self.restore(&kept, host),
            (Some(Asked::Restore(..)), Answer::Forget) => {
                if let Some(path) = host.put_aside(StorageKey::Autosave) {
                    let text = format!("What was discarded is in {}", path.display());
                    self.tell(Severity::Info, text);
                }
            }
            (Some(Asked::Restore(..)), Answer::Later) => host.leave_unsaved_work(),
            _ => {}
        }
    }

    /// Lets a file be chosen in the folder of the last one of its kind; one that is to be written is
    /// called `name` until the user does otherwise.
    pub(super) fn choose_file(&self, purpose: Purpose, name: &str, host: &mut dyn Host) {
        let suggested = Suggested {
            folder: self.preferences.folder_for(purpose.kind()),
            recent: self.preferences.recent_folders(),
            name: name.to_owned(),
        };
        let opened = self.session.opened();
        host.choose_file(FileRequest { purpose, opened }, suggested);
    }

    /// Puts a file first in File ▸ Open Recent.
    pub(super) fn remember_recent(&mut self, path: &Path) {
        if io::builtin::is_builtin(path) {
            return;
        }
        let recent = &mut self.preferences.recent;
        recent.retain(|known| known != path);
        recent.insert(0, path.to_owned());
        recent.truncate(MOST_RECENT);
    }
}

/// The question before `next` about unsaved changes of the document called `name`.
fn unsaved(next: &Next, name: &str) -> Question {
    let loses = match next {
        Next::New => "begin another document",
        Next::Open | Next::OpenFile(..) | Next::OpenBuiltin(_) => "open another document",
        Next::Quit => "quit",
        // Saving would overwrite what is to come back.
        Next::Revert(..) => {
            return Question {
                title: "Go back to the file?".to_owned(),
                text: format!("What has changed since “{name}” was saved is lost then."),
                answers: vec![Answer::Cancel, Answer::Revert],
            };
        }
    };
    Question {
        title: "Save changes?".to_owned(),
        text: format!(
            "“{name}” has changes that are not saved. They are lost if you {loses} without saving."
        ),
        answers: vec![Answer::Save, Answer::Discard, Answer::Cancel],
    }
}

/// Text of the question about what an earlier run left of the document at `path`, `since` then.
fn restore_text(path: Option<&Path>, since: Option<Duration>) -> String {
    let ended = match path {
        Some(path) => format!(
            "The editor ended before changes to {} were saved.",
            path.display()
        ),
        None => "The editor ended before a new document was saved.".to_owned(),
    };
    match since {
        Some(since) => format!("{ended} The changes were kept {}.", ago(since)),
        None => ended,
    }
}

/// A time in the past, in words.
fn ago(since: Duration) -> String {
    let minutes = since.as_secs() / 60;
    let (count, unit) = match minutes {
        0 => return "less than a minute ago".to_owned(),
        1..60 => (minutes, "minute"),
        60..1440 => (minutes / 60, "hour"),
        _ => (minutes / 1440, "day"),
    };
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {unit}{plural} ago")
}

/// Whether the name of a file is that of a scene.
pub(super) fn is_scene(path: &Path) -> bool {
    io::expect_extension(path, "scene").is_ok()
}

/// Digest of a file; `None` if it cannot be read.
fn digest_at(path: &Path, files: &dyn Files) -> Option<u32> {
    files.read(path).ok().map(|bytes| crc32fast::hash(&bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_since_work_was_kept_is_told_in_the_largest_unit_that_fits() {
        for (seconds, words) in [
            (0, "less than a minute ago"),
            (59, "less than a minute ago"),
            (60, "1 minute ago"),
            (185, "3 minutes ago"),
            (3600, "1 hour ago"),
            (86_399, "23 hours ago"),
            (200_000, "2 days ago"),
        ] {
            assert_eq!(ago(Duration::from_secs(seconds)), words);
        }
        let told = restore_text(Some(Path::new("a.scene")), Some(Duration::from_secs(185)));
        assert!(told.ends_with("a.scene were saved. The changes were kept 3 minutes ago."));
        assert!(!restore_text(None, None).contains("kept"));
    }
}
