use super::running::Program;
use super::{FileKind, Host, Purpose, StorageKey};
use crate::io;
use crate::scene::{Look, Skinning};
use crate::ui::Navigation;
use egui::ThemePreference;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Number of documents in File ▸ Open Recent, at most.
pub(super) const MOST_RECENT: usize = 10;

/// Number of folders that dialogs offer as recent, at most.
const RECENT_FOLDERS: usize = 6;

/// Choices that are kept from one run to the next.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub(super) struct Preferences {
    /// Folder in which a file was chosen last.
    pub last_folder: Option<PathBuf>,
    /// The same for each kind of files.
    pub folders: BTreeMap<FileKind, PathBuf>,
    /// Colors of the panels.
    pub theme: ThemePreference,
    /// What deforms characters; whatever suits the driver if `None`.
    pub skinning: Option<Skinning>,
    /// How mouse and keys move the camera, if it was chosen.
    pub navigation: Option<Navigation>,
    /// Whether the shape panel is folded away.
    pub panel_folded: bool,
    /// Whether a page reads aloud what is used.
    pub reads_aloud: bool,
    /// Width of the shape panel, in points.
    pub panel_width: Option<f32>,
    /// Look of documents that have none of their own: the one that was chosen last, or whatever suits
    /// them if `None`.
    pub look: Option<Look>,
    /// Width and height of the window when the program ended last, in points; of a maximized one those before it was.
    pub window_size: Option<(f32, f32)>,
    /// Whether it was maximized then.
    pub window_maximized: bool,
    /// Documents that were opened or saved last, the newest first.
    pub recent: Vec<PathBuf>,
    /// Whether the program has been started before.
    pub started_before: bool,
}

impl Default for Preferences {
    fn default() -> Self {
        Self {
            last_folder: None,
            folders: BTreeMap::new(),
            theme: ThemePreference::System,
            skinning: None,
            navigation: None,
            panel_folded: false,
            reads_aloud: false,
            panel_width: None,
            look: None,
            window_size: None,
            window_maximized: false,
            recent: Vec::new(),
            started_before: false,
        }
    }
}

/// The window when the program ended last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LastWindow {
    /// Width and height in points, if they are known; of a maximized one those before it was.
    pub size: Option<(f32, f32)>,
    /// Whether it was maximized.
    pub is_maximized: bool,
}

/// The window when the program ended last, from what is stored under [`StorageKey::Preferences`]: a host needs it before
/// there is a program.
pub fn last_window(preferences: &[u8]) -> LastWindow {
    let Ok(preferences) = serde_json::from_slice::<Preferences>(preferences) else {
        return LastWindow::default();
    };
    let is_usable = |side: f32| (100.0..=20_000.0).contains(&side);
    let size = preferences.window_size;
    LastWindow {
        size: size.filter(|size| is_usable(size.0) && is_usable(size.1)),
        is_maximized: preferences.window_maximized,
    }
}

impl Preferences {
    /// The preferences that were stored last; `None` if there are none, or if they cannot be read.
    pub fn load(host: &dyn Host) -> Option<Self> {
        let stored = host.load(StorageKey::Preferences);
        stored.and_then(|bytes| serde_json::from_slice(&bytes).ok())
    }

    /// What has changed in these since they were `before`, in what another window has stored meanwhile.
    fn merged(self, before: &Self, theirs: Self) -> Self {
        let chosen = self.folders.into_iter();
        let chosen = chosen.filter(|(kind, folder)| before.folders.get(kind) != Some(folder));
        let mut folders = theirs.folders;
        folders.extend(chosen);
        Self {
            last_folder: changed(self.last_folder, &before.last_folder, theirs.last_folder),
            folders,
            theme: changed(self.theme, &before.theme, theirs.theme),
            skinning: changed(self.skinning, &before.skinning, theirs.skinning),
            navigation: changed(self.navigation, &before.navigation, theirs.navigation),
            panel_folded: changed(self.panel_folded, &before.panel_folded, theirs.panel_folded),
            reads_aloud: changed(self.reads_aloud, &before.reads_aloud, theirs.reads_aloud),
            panel_width: changed(self.panel_width, &before.panel_width, theirs.panel_width),
            look: changed(self.look, &before.look, theirs.look),
            window_size: changed(self.window_size, &before.window_size, theirs.window_size),
            window_maximized: changed(
                self.window_maximized,
                &before.window_maximized,
                theirs.window_maximized,
            ),
            recent: merged_recent(self.recent, &before.recent, theirs.recent),
            started_before: self.started_before || theirs.started_before,
        }
    }

    /// These, with what is remembered about files and the window's size in `other`.
    fn with_files_of(self, other: &Self) -> Self {
        Self {
            last_folder: other.last_folder.clone(),
            folders: other.folders.clone(),
            window_size: other.window_size,
            window_maximized: other.window_maximized,
            recent: other.recent.clone(),
            ..self
        }
    }

    /// Remembers that a file of a kind was chosen.
    pub fn remember_folder(&mut self, kind: FileKind, file: &Path) {
        let folder = file.parent().map(Path::to_owned);
        if kind != FileKind::References {
            self.last_folder.clone_from(&folder);
        }
        self.folders.extend(folder.map(|folder| (kind, folder)));
    }

    /// Folders that were used last, each once, those of `files` before all others.
    pub fn recent_folders<'a>(&self, files: impl Iterator<Item = &'a PathBuf>) -> Vec<PathBuf> {
        let newest = files.filter_map(|file| file.parent());
        let documents = self.recent.iter().filter_map(|path| path.parent());
        let chosen = self.folders.values().map(PathBuf::as_path);
        let all = self.last_folder.as_deref().into_iter();
        let mut folders: Vec<PathBuf> = Vec::new();
        for folder in newest.chain(all).chain(documents).chain(chosen) {
            let folder = io::normal(folder);
            if !folders.contains(&folder) && !folder.as_os_str().is_empty() {
                folders.push(folder);
            }
        }
        folders.truncate(RECENT_FOLDERS);
        folders
    }

    /// Stores them for the next run.
    pub fn store(&self, host: &mut dyn Host) {
        if let Ok(bytes) = serde_json::to_vec_pretty(self) {
            host.store(StorageKey::Preferences, bytes);
        }
    }
}

/// What a choice is `now`, if that is another than `before`, or else what it is elsewhere.
fn changed<T: PartialEq>(now: T, before: &T, theirs: T) -> T {
    if now == *before { theirs } else { now }
}

/// Recent documents: the one that came to the front since they were `before`, then those of another window
/// without what was taken off meanwhile.
fn merged_recent(now: Vec<PathBuf>, before: &[PathBuf], theirs: Vec<PathBuf>) -> Vec<PathBuf> {
    let newest = now.first().filter(|&newest| before.first() != Some(newest));
    let is_kept =
        |path: &&PathBuf| Some(*path) != newest && (now.contains(path) || !before.contains(path));
    let others = theirs.iter().filter(is_kept);
    let all = newest.into_iter().chain(others).cloned();
    all.take(MOST_RECENT).collect()
}

impl Program {
    /// Remembers the folder of a file that was chosen; of one that is to be written, once it is: a folder that
    /// is gone, or that nothing can be written to, is no place to begin the next dialog in.
    pub(super) fn remember_chosen(&mut self, purpose: Purpose, file: &Path) {
        let kind = purpose.kind();
        if purpose.written().is_empty() {
            self.preferences.remember_folder(kind, file);
        } else {
            self.to_write.insert(kind, file.to_owned());
        }
    }

    /// Takes note whether the file at `path` could be written.
    pub(super) fn remember_written(&mut self, path: &Path, is_written: bool) {
        let chosen = self.to_write.iter().find(|(_, chosen)| *chosen == path);
        let Some(kind) = chosen.map(|(kind, _)| *kind) else {
            return;
        };
        self.to_write.remove(&kind);
        if is_written {
            self.preferences.remember_folder(kind, path);
        }
    }

    /// Folder of the last file of a kind, that of a picture that is still being drawn included.
    pub(super) fn folder_of_last(&self, kind: FileKind) -> Option<PathBuf> {
        let chosen = self.to_write.get(&kind).and_then(|file| file.parent());
        let chosen = chosen.map(Path::to_owned);
        chosen.or_else(|| self.preferences.folders.get(&kind).cloned())
    }

    /// Stores what is kept of the program at its end.
    pub(super) fn keep_at_end(&mut self, host: &mut dyn Host) {
        self.preferences.window_size = self.window_size.or(self.preferences.window_size);
        self.preferences.window_maximized = host.is_maximized();
        self.keep_preferences(host);
    }

    /// Stores the preferences if something that is kept in them has changed. Another window may have done so
    /// meanwhile: what changed there stays, and its recent files and folders are known here from then on.
    pub(super) fn keep_preferences(&mut self, host: &mut dyn Host) {
        let mut now = self.preferences.clone();
        now.theme = self.ui.theme;
        now.panel_folded = self.ui.panel_folded;
        now.reads_aloud = self.ui.reads_aloud;
        now.panel_width = self.ui.panel_width;
        now.navigation = self.ui.chosen_navigation;
        now.look = self.ui.look_of_new;
        // One that was asked for on the command line, and left so, is for that time only.
        if self.ui.skinning != self.skinning_at_start {
            now.skinning = self.ui.skinning;
        }
        if now == self.stored {
            return;
        }
        let theirs = Preferences::load(host).unwrap_or_else(|| self.stored.clone());
        let merged = now.clone().merged(&self.stored, theirs);
        merged.store(host);
        // What others chose is theirs alone, until the next start.
        self.preferences = self.preferences.clone().with_files_of(&merged);
        self.stored = now.with_files_of(&merged);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_compared_with_leads_no_other_file_into_its_folder() {
        let mut preferences = Preferences::default();
        preferences.remember_folder(FileKind::Scenes, Path::new("mine/two.scene"));
        preferences.remember_folder(FileKind::References, Path::new("theirs/walk.png"));
        assert_eq!(preferences.last_folder, Some("mine".into()));
        assert_eq!(
            preferences.folders[&FileKind::References],
            Path::new("theirs")
        );
    }
}
