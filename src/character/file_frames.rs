use glam::{DMat3, DMat4};

/// What a program that reads the same file has in other frames than this one. A joint's frame at rest is parallel to the
/// character's axes here, while a Collada file turns it, and its skin places the mesh by a matrix of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct FileFrames {
    /// For each joint what leads from its frame at rest in the file to model space.
    pub model_from_joint: Vec<DMat4>,
    /// From the mesh as the skin places it, in the file's axes and units, to the mesh at rest here.
    pub placed: DMat4,
    /// The skin's own matrix, which places the mesh (`bind_shape_matrix`); `None` where that changes nothing, or several
    /// skins have different ones.
    pub bind_shape: Option<DMat4>,
    /// The joints in the skin's own list, in which numbers of weights count; empty where several skins have different lists,
    /// or one names what is no joint.
    pub skin_joints: Vec<usize>,
}

impl FileFrames {
    /// Directions of the frame of `joint` at rest, without its place: what its transform in the file has before that of this
    /// program.
    pub fn directions(&self, joint: usize) -> Option<DMat4> {
        let model_from_joint = self.model_from_joint.get(joint)?;
        Some(DMat4::from_mat3(DMat3::from_mat4(*model_from_joint)))
    }

    /// Whether the skin's own list has the joints otherwise than all joints one after the other, from whichever on.
    pub fn has_other_numbers(&self) -> bool {
        let mut pairs = self.skin_joints.windows(2);
        pairs.any(|pair| pair[1] != pair[0] + 1)
    }

    /// The inverse bind matrix of `joint` (`INV_BIND_MATRIX`), from the mesh as the skin places it to the joint's frame, as it
    /// is where it agrees with the joint's node.
    pub fn inverse_bind(&self, joint: usize) -> Option<DMat4> {
        Some(self.model_from_joint.get(joint)?.inverse() * self.placed)
    }
}
