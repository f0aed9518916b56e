use crate::disk;
use crate::scene::Skinning;
use crate::ui::Navigation;
use egui::ThemePreference;
use std::path::PathBuf;

/// What is kept from one run to the next, in the user's configuration folder.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub(super) struct Preferences {
    /// Where the last file was opened or saved.
    pub last_folder: Option<PathBuf>,
    /// Colors of the panels.
    pub theme: ThemePreference,
    /// What deforms characters; whatever suits the driver if `None`.
    pub skinning: Option<Skinning>,
    /// How mouse and keys move the camera.
    pub navigation: Navigation,
    /// Whether the program has been started before.
    pub started_before: bool,
}

impl Default for Preferences {
    fn default() -> Self {
        Self {
            last_folder: None,
            theme: ThemePreference::System,
            skinning: None,
            navigation: Navigation::default(),
            started_before: false,
        }
    }
}

impl Preferences {
    /// What the last run kept; the defaults if there was none, or if it cannot be read.
    pub fn load() -> Self {
        path()
            .and_then(|path| std::fs::read(path).ok())
            .and_then(|bytes| serde_json::from_slice(&bytes).ok())
            .unwrap_or_default()
    }

    /// Keeps them for the next run. Failing to is no reason to trouble anyone: nothing that
    /// the user made is lost.
    pub fn save(&self) {
        let (Some(path), Ok(bytes)) = (path(), serde_json::to_vec_pretty(self)) else {
            return;
        };
        if let Some(folder) = path.parent()
            && std::fs::create_dir_all(folder).is_ok()
        {
            let _ = disk::write_whole(&path, &bytes);
        }
    }
}

fn path() -> Option<PathBuf> {
    let folders = directories::ProjectDirs::from("", "", "skeleton-editor")?;
    Some(folders.config_dir().join("preferences.json"))
}
