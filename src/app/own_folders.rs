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

/// A folder that is rarely on the same disk, for work that does not fit there: that of the user's
/// session, or one among the temporary files. The system may clear it when it shuts down.
pub(super) fn spare() -> Option<PathBuf> {
    let session = BaseDirs::new().and_then(|folders| folders.runtime_dir().map(Path::to_owned));
    let parent = session.unwrap_or_else(std::env::temp_dir);
    private(parent.join(folder_name()))
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
