use glam::Vec3;

/// Joint of a skeleton, at rest.
///
/// A joint's frame at rest is parallel to the character's axes, so its rest transform relative to
/// the parent is the translation by `offset` alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Joint {
    /// Name in panels and pose files.
    pub name: String,
    /// Short identifier in a Collada file, which pose files may use too.
    pub sid: Option<String>,
    /// Index of the parent; `None` for a root.
    pub parent: Option<usize>,
    /// Position at rest relative to the parent; for a root, in the character's model space.
    pub offset: Vec3,
    /// End of its bone at rest, relative to the joint, if the file says so: bones of a Collada file
    /// have a length of their own, those of a course character end at the children.
    pub tip: Option<Vec3>,
}

/// Names of the joints of the course's characters, which have 18, in the order of its files.
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
    /// Name of joint `index` of `count` joints in a file without names.
    pub fn default_name(index: usize, count: usize) -> String {
        match COURSE_JOINT_NAMES.get(index) {
            Some(name) if count == COURSE_JOINT_NAMES.len() => (*name).to_owned(),
            _ => format!("Joint {index}"),
        }
    }
}
