//! The machine that the program runs on: system, display server, folder of the settings.

use crate::program::globals;
use serde::Serialize;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// Operating system and its version, such as `Debian GNU/Linux 13 (trixie), linux x86_64`.
pub(super) fn system() -> String {
    let kind = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    let release = fs::read_to_string("/etc/os-release").unwrap_or_default();
    let name = release
        .lines()
        .find_map(|line| line.strip_prefix("PRETTY_NAME="))
        .map(|name| name.trim_matches(['"', '\'']));
    name.map_or(kind.clone(), |name| format!("{name}, {kind}"))
}

/// Server that shows windows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Server {
    X11,
    Wayland,
    /// Windows and macOS always have one.
    Native,
    None,
}

/// Display that a window would be opened on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(super) struct Display {
    pub server: Server,
    /// Name that the environment gives it, such as `DISPLAY=:0`.
    pub name: Option<String>,
}

impl Display {
    /// The display of this process's environment.
    pub fn of_environment() -> Self {
        if cfg!(any(windows, target_vendor = "apple")) {
            let (server, name) = (Server::Native, None);
            return Self { server, name };
        }
        Self::among(|variable| {
            let value = std::env::var_os(variable)?;
            Some(value.to_string_lossy().into_owned())
        })
    }

    /// The display that `variable` names. Wayland comes first, as it does for the window.
    fn among(variable: impl Fn(&str) -> Option<String>) -> Self {
        let named = [
            ("WAYLAND_DISPLAY", Server::Wayland),
            ("WAYLAND_SOCKET", Server::Wayland),
            ("DISPLAY", Server::X11),
        ];
        let set = named.into_iter().find_map(|(name, server)| {
            let value = variable(name).filter(|value| !value.is_empty())?;
            Some((server, Some(format!("{name}={value}"))))
        });
        let (server, name) = set.unwrap_or((Server::None, None));
        Self { server, name }
    }

    /// Server and name in one line.
    pub fn in_words(&self) -> String {
        let server = match self.server {
            Server::X11 => "X11",
            Server::Wayland => "Wayland",
            Server::Native => "of the system",
            Server::None => "none",
        };
        match &self.name {
            Some(name) => format!("{server} ({name})"),
            None => server.to_owned(),
        }
    }
}

/// Folder in which preferences and unsaved work are kept.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(super) struct Settings {
    /// `None` where the system names no home folder.
    pub folder: Option<PathBuf>,
    pub writable: bool,
}

impl Settings {
    /// The folder of this user. One that does not exist yet is writable if it can be made.
    pub fn of_user() -> Self {
        let folders = directories::ProjectDirs::from("", "", globals::SETTINGS_FOLDER);
        let folder = folders.map(|folders| folders.config_dir().to_owned());
        let existing = folder.as_deref().and_then(|folder| {
            // The first one that is there; a folder in place of a file is found out by writing.
            folder.ancestors().find(|folder| folder.exists())
        });
        let writable = existing.is_some_and(is_writable);
        Self { folder, writable }
    }
}

/// Whether a file can be made in `folder`.
fn is_writable(folder: &Path) -> bool {
    let path = folder.join(format!(".editor-doctor-{}", std::process::id()));
    let made = File::create_new(&path).is_ok();
    if made {
        // An empty file that cannot be removed does no harm.
        let _ = fs::remove_file(path);
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wayland_comes_before_x11_and_an_empty_name_is_no_display() {
        let display = |set: &[(&str, &str)]| {
            let value = |name: &str| set.iter().find(|(set, _)| *set == name);
            Display::among(|name| value(name).map(|(_, value)| (*value).to_owned())).in_words()
        };
        assert_eq!(display(&[]), "none");
        assert_eq!(display(&[("DISPLAY", "")]), "none");
        assert_eq!(display(&[("DISPLAY", ":1")]), "X11 (DISPLAY=:1)");
        let both = [("DISPLAY", ":1"), ("WAYLAND_DISPLAY", "wayland-0")];
        assert_eq!(display(&both), "Wayland (WAYLAND_DISPLAY=wayland-0)");
    }
}
