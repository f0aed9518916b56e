use crate::math::Euler;
use glam::Vec3;

/// What was saved about joints that a character does not have, as when its file has changed. It is
/// kept, so that nothing is lost until they are there again.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MissingJoints {
    /// Of the current pose.
    pub pose: MissingPose,
    /// Of kept poses, by their names.
    pub poses: Vec<(String, MissingPose)>,
    /// Joints that are pinned, by name.
    pub pins: Vec<String>,
}

/// Part of a pose that is about joints that the character does not have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MissingPose {
    /// Angles by the joint's name.
    pub joints: Vec<(String, Euler)>,
    /// How far roots have moved, by name, in the character's model space.
    pub roots: Vec<(String, Vec3)>,
}

impl MissingJoints {
    /// Keeps what is said of the current pose under `name`, in place of what is kept there.
    pub(super) fn keep_pose(&mut self, name: &str) {
        self.forget_pose(name);
        if self.pose != MissingPose::default() {
            self.poses.push((name.to_owned(), self.pose.clone()));
        }
    }

    /// Forgets what the kept pose called `name` says.
    pub(super) fn forget_pose(&mut self, name: &str) {
        self.poses.retain(|(kept, _)| kept != name);
    }

    /// What the kept pose called `name` says, if it says anything.
    pub fn of_kept(&self, name: &str) -> Option<&MissingPose> {
        let mut poses = self.poses.iter();
        poses.find(|(kept, _)| kept == name).map(|(_, pose)| pose)
    }
}
