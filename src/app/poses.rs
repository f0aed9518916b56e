use super::exports::file_stem;
use super::file_dialogs::Purpose;
use super::workspace::Workspace;
use crate::character::Pose;
use crate::disk::files;
use crate::editor::{Edit, Severity, apply_edit};
use crate::io::{Files, PoseData, PoseFile};
use crate::scene::ShapeId;
use std::path::Path;

/// What messages call the clipboard where they name a file.
const CLIPBOARD: &str = "clipboard";

impl Workspace {
    /// Pose ▸ Copy Pose: as the text of a pose file, so that it can be pasted anywhere.
    pub(super) fn copy_pose(&mut self, shape: ShapeId) {
        if let Some(text) = self.pose_text(shape, None) {
            self.egui.set_clipboard_text(text);
        }
    }

    /// Pose ▸ Paste Pose.
    pub(super) fn paste_pose(&mut self, shape: ShapeId) {
        let text = self.egui.clipboard_text().unwrap_or_default();
        if text.trim().is_empty() {
            let text = "There is no pose on the clipboard: Copy Pose puts one there".to_owned();
            self.session.messages.tell(Severity::Warning, text);
            return;
        }
        self.take_pose(shape, Path::new(CLIPBOARD), text.as_bytes());
    }

    /// Pose ▸ Save Pose, and the same for a kept one: chooses a file.
    pub(super) fn choose_pose_to_save(&mut self, shape: ShapeId, kept: Option<usize>) {
        let folder = self.preferences.last_folder.as_deref();
        let poses = self.session.scene().character(shape).map(|c| c.poses());
        let name = kept.and_then(|kept| Some(file_stem(&poses?.get(kept)?.name)));
        let name = format!("{}.json", name.as_deref().unwrap_or("pose"));
        let purpose = Purpose::SavePose(shape, kept);
        self.dialogs.open_to_save(purpose, folder, &name);
    }

    /// Writes the pose of a character, or one kept with it.
    pub(super) fn save_pose(&mut self, shape: ShapeId, kept: Option<usize>, path: &Path) {
        // It may have been deleted while the dialog was open.
        let Some(text) = self.pose_text(shape, kept) else {
            let text = "Not saved: the character or its pose is no more";
            self.session.messages.tell(Severity::Error, text.to_owned());
            return;
        };
        self.write(path, "json", &text);
    }

    /// Pose ▸ Load Pose.
    pub(super) fn load_pose(&mut self, shape: ShapeId, path: &Path) {
        match files().read(path) {
            Ok(bytes) => self.take_pose(shape, path, &bytes),
            Err(error) => self.tell(Severity::Error, vec![error]),
        }
    }

    fn take_pose(&mut self, shape: ShapeId, path: &Path, bytes: &[u8]) {
        let Some(character) = self.session.scene().character(shape) else {
            return;
        };
        let skeleton = character.character.skeleton();
        let file = match PoseFile::read(path, bytes) {
            Ok(file) => file,
            Err(error) => return self.tell(Severity::Error, vec![error]),
        };
        match file.what_fits(skeleton) {
            Ok((pose, missing)) => {
                if !missing.is_empty() {
                    let text = without(path, &missing);
                    self.session.messages.tell(Severity::Warning, text);
                }
                apply_edit(&mut self.session, Edit::SetPose(shape, pose));
            }
            Err(error) => self.tell(Severity::Error, vec![error]),
        }
    }

    fn pose_text(&self, shape: ShapeId, kept: Option<usize>) -> Option<String> {
        let character = self.session.scene().character(shape)?;
        let pose: &Pose = match kept {
            Some(kept) => &character.poses().get(kept)?.pose,
            None => character.pose(),
        };
        Some(PoseData::new(character.character.skeleton(), pose).to_json())
    }
}

/// What is told of a pose that went only to some of its joints.
fn without(path: &Path, missing: &[&str]) -> String {
    const NAMED: usize = 3;
    let named: Vec<&str> = missing.iter().take(NAMED).copied().collect();
    let more = match missing.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let named = named.join(", ");
    format!(
        "{}: taken on without {named}{more}, which this character has not",
        path.display()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_that_a_character_has_not_are_named_and_many_are_counted() {
        let clipboard = Path::new(CLIPBOARD);
        assert_eq!(
            without(clipboard, &["Tail"]),
            "clipboard: taken on without Tail, which this character has not"
        );
        let many = ["A", "B", "C", "D", "E"];
        assert!(without(clipboard, &many).contains("A, B, C and 2 more,"));
    }
}
