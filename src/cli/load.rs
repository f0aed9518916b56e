use super::CliError;
use super::output::tell;
use crate::disk::files;
use crate::editor::{Edit, Session};
use crate::io::{Files, Loaded, PoseFile, builtin};
use crate::scene::ShapeId;
use std::path::{Path, PathBuf};

/// A session with the scenes and shapes of `paths` in one scene, seen through the view of the last
/// scene file, and with its characters posed by the file `pose` if there is one. Warnings go to
/// standard error.
///
/// # Errors
/// At the first file that cannot be loaded.
pub fn load(paths: &[PathBuf], pose: Option<&Path>) -> Result<Session, CliError> {
    let files = files();
    let mut loaded = Loaded::default();
    for path in paths {
        loaded.add(&files, path)?;
    }
    for warning in &loaded.warnings {
        tell(format_args!("warning: {warning}"));
    }
    let mut session = Session::with_shapes(loaded.shapes, loaded.view.unwrap_or_default());
    if let Some(path) = pose {
        let path = builtin::resolve(path)?;
        let pose = PoseFile::read(&path, &files.read(&path)?)?;
        let poses = pose.poses_for(session.scene())?.into_iter();
        let edits = poses.map(|(id, pose)| Edit::SetPose(id, pose)).collect();
        edit(&mut session, edits)?;
    }
    Ok(session)
}

/// Carries out edits that the options of a command ask for.
///
/// # Errors
/// If one of them is refused; then nothing has changed.
pub fn edit(session: &mut Session, edits: Vec<Edit>) -> Result<(), CliError> {
    let edited = session.edit(Edit::Together(edits));
    edited.map_err(|refused| CliError::Other(refused.to_string()))?;
    Ok(())
}

/// The ids of all shapes.
pub fn ids(session: &Session) -> impl Iterator<Item = ShapeId> {
    session.scene().shapes().iter().map(|shape| shape.id)
}
