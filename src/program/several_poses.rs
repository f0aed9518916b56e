//! Files with several poses: all of them are kept with a character.

use super::files::{file_name, listed, without};
use super::running::Program;
use crate::character::Pose;
use crate::editor::{Edit, Severity};
use crate::io::PoseFile;
use crate::scene::ShapeId;
use std::path::Path;

impl Program {
    /// Keeps the poses of a file, as far as they fit, in the list of a character, which takes on the first of them.
    pub(super) fn keep_poses(&mut self, shape: ShapeId, path: &Path, poses: &[(String, PoseFile)]) {
        let Some(character) = self.session.scene().character(shape) else {
            return self.tell_no_character(path);
        };
        let skeleton = character.character.skeleton();
        let mut kept: Vec<(&str, Pose)> = Vec::new();
        let (mut missing, mut failed) = (Vec::new(), Vec::new());
        for (name, file) in poses {
            match file.what_fits(skeleton) {
                Ok((pose, lacking)) => {
                    kept.push((name, pose));
                    missing.extend(lacking);
                }
                Err(error) => failed.push(error),
            }
        }
        self.tell_all(Severity::Error, failed);
        if !missing.is_empty() {
            missing.sort_unstable();
            missing.dedup();
            self.tell(Severity::Warning, without(path, &missing));
        }
        let Some((first, first_pose)) = kept.first().cloned() else {
            return;
        };
        let names: Vec<&str> = kept.iter().map(|(name, _)| *name).collect();
        let file = file_name(path);
        let text = match &names[..] {
            [only] => format!("The pose {only} of {file} is in the list Poses of the panel"),
            _ => format!(
                "{file} has {} poses ({}): they are in the list Poses of the panel, and the character has {first} now",
                names.len(),
                listed(&names)
            ),
        };
        let keep = kept.into_iter().flat_map(|(name, pose)| {
            let name = name.to_owned();
            [Edit::SetPose(shape, pose), Edit::KeepPose { shape, name }]
        });
        let edits = keep.chain([Edit::SetPose(shape, first_pose)]);
        self.edit(Edit::Together(edits.collect()));
        self.tell(Severity::Info, text);
    }
}
