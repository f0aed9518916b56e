use crate::character::Pose;

/// A pose that is kept with a character under a name.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptPose {
    /// What the list calls it; no other of the character's is called so.
    pub name: String,
    /// The pose.
    pub pose: Pose,
}

/// Keeps `pose` under `name`, in place of the one of that name if there is one.
pub(super) fn keep(poses: &mut Vec<KeptPose>, name: String, pose: Pose) {
    match poses.iter_mut().find(|kept| kept.name == name) {
        Some(kept) => kept.pose = pose,
        None => poses.push(KeptPose { name, pose }),
    }
}

/// `Pose 1` and so on: the first that is free.
pub(super) fn free_name(poses: &[KeptPose]) -> String {
    let taken = |name: &String| poses.iter().any(|kept| kept.name == *name);
    let mut names = (1..).map(|number| format!("Pose {number}"));
    names.find(|name| !taken(name)).unwrap_or_default()
}
