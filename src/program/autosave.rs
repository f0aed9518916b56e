//! Unsaved work that outlives the program: kept while it runs, offered at the next start.

use super::awaited::Awaited;
use super::document_file::DocumentFile;
use super::questions::Asked;
use super::reading::Use;
use super::running::Program;
use super::{Host, StorageKey};
use crate::editor::Severity;
use crate::io::{self, Diagnostic, Files, Loaded, Missing, ReadJob, SceneError, Wanted};
use crate::revision::Revision;
use crate::scene::{Scene, ViewSettings};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Least time between two autosaves.
const EVERY: Duration = Duration::from_secs(10);
/// The same in the middle of a gesture, which must not halt for it too often.
const IN_A_GESTURE: Duration = Duration::from_secs(30);

/// Name under which a document without a file is read again.
const WITHOUT_FILE: &str = "restored.scene";

/// State of the autosave.
#[derive(Default)]
pub(super) struct Autosave {
    /// When the gesture under way was noticed, or unsaved work was stored in it last.
    gesture_since: Option<Duration>,
    /// Document that is stored, and when that was.
    stored: Option<(Revision, Duration)>,
    /// Whether the user knows that nothing can be stored.
    failure_told: bool,
}

/// Unsaved work, as it is at a moment. Cheap to make.
#[derive(Clone, Debug)]
pub struct Unsaved {
    scene: Scene,
    view: ViewSettings,
    path: Option<PathBuf>,
    stem: Option<String>,
    digest: Option<u32>,
}

impl Unsaved {
    /// Bytes to store under [`StorageKey::Autosave`].
    ///
    /// # Errors
    /// If the document cannot be written as a file.
    pub fn to_bytes(&self) -> Result<Vec<u8>, SceneError> {
        let folder = self.path.as_deref().and_then(Path::parent);
        let kept = Kept {
            path: self.path.clone(),
            stem: self.stem.clone(),
            digest: self.digest,
            scene: io::scene_text(&self.scene, &self.view, folder)?,
        };
        // Fails for paths alone that are no Unicode; without its path the work is worth as much.
        Ok(serde_json::to_vec(&kept)
            .or_else(|_| serde_json::to_vec(&Kept { path: None, ..kept }))
            .unwrap_or_default())
    }
}

/// Unsaved work that an earlier run left.
#[derive(Clone, serde::Serialize, serde::Deserialize)]
pub(super) struct Kept {
    /// File of the document.
    path: Option<PathBuf>,
    /// Name of a document without a file, after what was opened. Earlier versions kept none.
    #[serde(default)]
    stem: Option<String>,
    /// Digest of that file's bytes as they were known to the earlier run.
    digest: Option<u32>,
    /// Text of a scene file.
    pub(super) scene: String,
}

impl Kept {
    /// Name of the document, if it has a file.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// What the document is called: its file, or what was opened.
    pub fn name(&self) -> Option<String> {
        let path = self.path.as_deref();
        let path = path.map(|path| path.display().to_string());
        path.or_else(|| self.stem.clone())
    }

    /// Names of the shapes; none if the scene cannot be read.
    pub fn shape_names(&self) -> Vec<String> {
        let scene: serde_json::Value = serde_json::from_str(&self.scene).unwrap_or_default();
        let shapes = scene["shapes"].as_array().into_iter().flatten();
        let names = shapes.filter_map(|shape| shape["name"].as_str());
        names.map(str::to_owned).collect()
    }
}

/// Files with one more.
pub(super) struct WithText {
    pub path: PathBuf,
    pub text: String,
    pub rest: Arc<dyn Files>,
}

impl Files for WithText {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        if path == self.path {
            Ok(self.text.as_bytes().to_vec())
        } else {
            self.rest.read(path)
        }
    }

    fn exists(&self, path: &Path) -> bool {
        path == self.path || self.rest.exists(path)
    }
}

impl Program {
    /// Work that is not in the document's file; `None` if there is none.
    pub fn unsaved(&self) -> Option<Unsaved> {
        self.is_modified().then(|| Unsaved {
            scene: self.session.scene().clone(),
            view: self.document_view(),
            path: self.document.path().map(Path::to_owned),
            stem: self.document.stem.clone(),
            digest: self.document.digest(),
        })
    }

    /// Has the next frame, which may be the last, take over what is being typed.
    pub fn prepare_to_end(&mut self) {
        self.ui.give_up_typing();
    }

    /// Ends the program at once, because the system asks for it: unsaved work is stored.
    pub fn end(&mut self, host: &mut dyn Host) {
        self.session.commit_gesture();
        self.keep(host);
        host.quit();
    }

    /// Stores unsaved work and preferences at once, since the program may end without being told.
    pub fn keep(&mut self, host: &mut dyn Host) {
        // What an earlier run left is for the user to answer first.
        if !self.has_work_to_answer() {
            self.store_unsaved(host);
        }
        self.keep_at_end(host);
    }

    /// Stores unsaved work after a gesture, at most every ten seconds, in the middle of a long one
    /// now and then, and removes it once it is saved. Returns how long no frame is needed for its sake.
    pub(super) fn autosave(&mut self, host: &mut dyn Host) -> Duration {
        if !self.session.is_in_gesture() {
            self.autosave.gesture_since = None;
        }
        if !self.is_modified() {
            self.forget_autosave(host);
            return Duration::MAX;
        }
        let document = self.session.document();
        // What an earlier run left must not be overwritten before the question about it is answered.
        if self.has_work_to_answer() {
            return Duration::MAX;
        }
        let now = host.now();
        let stored = self.autosave.stored;
        if stored.is_some_and(|(stored, _)| stored == document) {
            return Duration::MAX;
        }
        let after_stored = stored.map(|(_, at)| at + EVERY);
        let due = if self.session.is_in_gesture() {
            let since = *self.autosave.gesture_since.get_or_insert(now);
            after_stored.max(Some(since + IN_A_GESTURE))
        } else {
            after_stored
        };
        match due {
            Some(due) if now < due => due - now,
            _ => {
                // A gesture that goes on waits as long again.
                self.autosave.gesture_since = None;
                self.store_unsaved(host);
                Duration::MAX
            }
        }
    }

    /// Whether the place of this run's unsaved work has that of an earlier one, which nobody has decided
    /// about or which is on its way.
    fn has_work_to_answer(&self) -> bool {
        matches!(self.asked, Some(Asked::Restore(..))) || self.is_restoring()
    }

    /// Removes what was stored by this run, if anything.
    pub(super) fn forget_autosave(&mut self, host: &mut dyn Host) {
        if self.autosave.stored.take().is_some() {
            host.remove_unsaved_work();
        }
    }

    fn store_unsaved(&mut self, host: &mut dyn Host) {
        let Some(unsaved) = self.unsaved() else {
            return;
        };
        self.autosave.stored = Some((self.session.document(), host.now()));
        match unsaved.to_bytes() {
            Ok(bytes) => host.store(StorageKey::Autosave, bytes),
            Err(error) => self.tell_store_failure(&error.to_string(), None, host.now()),
        }
    }

    /// Says once that unsaved work cannot be stored where it should be; it is tried again later.
    pub(super) fn tell_store_failure(
        &mut self,
        error: &str,
        kept_in: Option<&Path>,
        now: Duration,
    ) {
        self.autosave.stored = Some((Revision::new(), now));
        if !std::mem::replace(&mut self.autosave.failure_told, true) {
            let text = match kept_in {
                Some(place) => format!(
                    "Unsaved work is kept for the case of a crash in {} only, which may be cleared \
                     when the computer shuts down: {error}",
                    place.display()
                ),
                None => format!("Unsaved work cannot be kept for the case of a crash: {error}"),
            };
            self.tell(Severity::Warning, text);
        }
    }

    /// Offers what an earlier run left that did not end in order.
    pub(super) fn offer_restoring(&mut self, host: &mut dyn Host) {
        let Some(bytes) = host.load(StorageKey::Autosave) else {
            return;
        };
        match serde_json::from_slice(&bytes) {
            Ok(kept) => {
                let since = host.unsaved_work_since();
                self.asked = Some(Asked::Restore(kept, since));
            }
            Err(error) => {
                self.give_up_restoring(&error.to_string(), host);
                self.offer_next(host);
            }
        }
    }

    /// Offers what another earlier run left, if there is one.
    pub(super) fn offer_next(&mut self, host: &mut dyn Host) {
        host.pass_unsaved_work();
        self.offer_restoring(host);
    }

    /// Says why what an earlier run left cannot be restored, and puts it out of the way of what this
    /// one stores.
    pub(super) fn give_up_restoring(&mut self, error: &str, host: &mut dyn Host) {
        let place = host.put_unsaved_work_aside();
        let place = place.map_or_else(String::new, |path| {
            format!(". They are in {}", path.display())
        });
        let text = format!("The unsaved changes cannot be restored: {error}{place}");
        self.tell(Severity::Error, text);
    }

    /// Restores what an earlier run left. It is unsaved as before.
    pub(super) fn restore(&mut self, kept: &Kept, host: &mut dyn Host) {
        if self.has_to_wait(&Awaited::Restore(Box::new(kept.clone())), host) {
            return;
        }
        self.cancel_reading(host);
        // What was kept of an archive is the text of its scene.
        let path = kept.path().unwrap_or(Path::new(WITHOUT_FILE));
        let path = path.with_extension("scene");
        let files = WithText {
            path: path.clone(),
            text: kept.scene.clone(),
            rest: host.files(),
        };
        let job = ReadJob {
            files: Arc::new(files),
            paths: vec![path],
            wanted: Wanted::Document(Missing::StandIn),
        };
        self.read(job, Use::Restore(Box::new(kept.clone())), host);
    }

    /// Shows what an earlier run left, once it has been read.
    pub(super) fn show_restored(&mut self, kept: &Kept, loaded: Loaded, host: &dyn Host) {
        let view = loaded.view.unwrap_or_default();
        self.session.open(loaded.shapes, view);
        self.ui.suit_navigation(view.look);
        self.document = DocumentFile {
            stem: kept.stem.clone(),
            ..DocumentFile::restored(kept.path.clone(), kept.digest)
        };
        self.autosave.stored = Some((self.session.document(), host.now()));
        self.tell_all(Severity::Warning, loaded.warnings);
    }
}
