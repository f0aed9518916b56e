use glam::Vec3;

/// One joint of a skeleton, at rest.
///
/// A joint's frame at rest is parallel to the character's axes, so its rest transform relative
/// to the parent is the translation by `offset` alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Joint {
    /// Shown in panels and used by pose files.
    pub name: String,
    /// The short name that a Collada file gives it besides, by which pose files may call it too.
    pub sid: Option<String>,
    /// Index of the parent; `None` for a root.
    pub parent: Option<usize>,
    /// Position at rest relative to the parent; for a root, in the character's model space.
    pub offset: Vec3,
    /// Where its bone ends at rest, relative to the joint, if the file says so: the bones of a
    /// Collada file have a length of their own, those of a course character end at its children.
    pub tip: Option<Vec3>,
}

/// What the course calls the joints of a skeleton of 18, in the order of its files.
pub const COURSE_JOINT_NAMES: [&str; 18] = [
    "Root",
    "Chest",
    "Waist",
    "Neck",
    "Right hip",
    "Right leg",
    "Right knee",
    "Right foot",
    "Left hip",
    "Left leg",
    "Left knee",
    "Left foot",
    "Right collarbone",
    "Right shoulder",
    "Right elbow",
    "Left collarbone",
    "Left shoulder",
    "Left elbow",
];

impl Joint {
    /// The name of joint `index` in a file that names none, of `count` joints.
    pub fn default_name(index: usize, count: usize) -> String {
        match COURSE_JOINT_NAMES.get(index) {
            Some(name) if count == COURSE_JOINT_NAMES.len() => (*name).to_owned(),
            _ => format!("Joint {index}"),
        }
    }
}
