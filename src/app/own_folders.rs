//! Folders that are the user's alone, where the program keeps what outlives it.

use crate::program::globals;
use directories::{BaseDirs, ProjectDirs};
use std::path::{Path, PathBuf};

/// The user's folder of configuration, made if need be; `None` if the system has no place for one.
pub(super) fn configuration() -> Option<PathBuf> {
    let folders = ProjectDirs::from("", "", globals::SETTINGS_FOLDER)?;
    let folder = folders.config_dir().to_owned();
    // Whoever writes to it is told why it could not be made.
    let _ = std::fs::create_dir_all(&folder);
    Some(folder)
}

/// Folders that are rarely on the same disk, for work that does not fit in `configuration`: that of the
/// user's session, and one among the temporary files. The system may clear them when it shuts down.
pub(super) fn spare(configuration: Option<&Path>) -> Vec<PathBuf> {
    let name = spare_name(configuration);
    let session = BaseDirs::new().and_then(|folders| folders.runtime_dir().map(Path::to_owned));
    let mut parents: Vec<PathBuf> = session.into_iter().chain([std::env::temp_dir()]).collect();
    // A folder that came twice would be locked against itself.
    parents.dedup();
    let folders = parents.into_iter();
    let folders = folders.filter_map(|parent| private(parent.join(&name)));
    folders.collect()
}

/// Name of a spare folder, another for each folder of configuration: a program that keeps its work elsewhere
/// would lock what another one left, which would not be offered until that has ended.
fn spare_name(configuration: Option<&Path>) -> String {
    let of = configuration.map_or(0, |folder| {
        crc32fast::hash(folder.as_os_str().as_encoded_bytes())
    });
    format!("{}-{of:08x}", folder_name())
}

/// Name of the folder, another for each user, who may share the one for temporary files.
#[cfg(unix)]
fn folder_name() -> String {
    format!(
        "{}-{}",
        globals::SETTINGS_FOLDER,
        rustix::process::getuid().as_raw()
    )
}

/// Name of the folder: elsewhere each user has temporary files of their own.
#[cfg(not(unix))]
fn folder_name() -> String {
    globals::SETTINGS_FOLDER.to_owned()
}

/// The folder, made if need be. `None` if it is not this user's alone: somebody else may have made
/// it, or a link in its place, to read or replace what is kept.
#[cfg(unix)]
fn private(folder: PathBuf) -> Option<PathBuf> {
    use std::os::unix::fs::{DirBuilderExt, MetadataExt};
    // That it exists already is no failure; what it is follows.
    let _ = std::fs::DirBuilder::new().mode(0o700).create(&folder);
    let found = std::fs::symlink_metadata(&folder).ok()?;
    let is_own = found.uid() == rustix::process::getuid().as_raw();
    (found.is_dir() && is_own && found.mode() & 0o077 == 0).then_some(folder)
}

/// The folder, made if need be.
#[cfg(not(unix))]
fn private(folder: PathBuf) -> Option<PathBuf> {
    std::fs::create_dir_all(&folder).ok()?;
    Some(folder)
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::{self, Permissions};
    use std::os::unix::fs::{PermissionsExt, symlink};

    #[test]
    fn programs_with_other_folders_of_configuration_have_other_spare_folders() {
        let [one, other] = ["/home/ada/.config", "/home/bob/.config"].map(Path::new);
        assert_eq!(spare_name(Some(one)), spare_name(Some(one)));
        assert_ne!(spare_name(Some(one)), spare_name(Some(other)));
        assert_ne!(spare_name(Some(one)), spare_name(None));
    }

    #[test]
    fn a_folder_that_others_can_reach_is_not_used() {
        let parent = tempfile::tempdir().unwrap();
        let new = parent.path().join("new");
        assert_eq!(private(new.clone()), Some(new.clone()));
        assert_eq!(private(new.clone()), Some(new.clone()), "once more");
        let link = parent.path().join("link");
        symlink(&new, &link).unwrap();
        assert_eq!(private(link), None);
        fs::set_permissions(&new, Permissions::from_mode(0o755)).unwrap();
        assert_eq!(private(new), None);
        assert_eq!(private(parent.path().join("no/where")), None);
    }
}
