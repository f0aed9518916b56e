use super::CliError;
use super::output::tell;
use crate::disk::files;
use crate::io::{Files, Loaded, PoseFile, builtin};
use std::path::{Path, PathBuf};

/// Loads `paths` into one scene, and poses its characters by the file `pose` if there is one.
/// Warnings go to standard error.
///
/// # Errors
/// At the first file that cannot be loaded.
pub fn load(paths: &[PathBuf], pose: Option<&Path>) -> Result<Loaded, CliError> {
    let files = files();
    let mut loaded = Loaded::default();
    for path in paths {
        loaded.add(&files, path)?;
    }
    for warning in &loaded.warnings {
        tell(format_args!("warning: {warning}"));
    }
    if let Some(path) = pose {
        let path = builtin::resolve(path)?;
        PoseFile::read(&path, &files.read(&path)?)?.apply_to(&mut loaded.scene)?;
    }
    Ok(loaded)
}
