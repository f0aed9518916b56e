use glam::DMat4;

/// What a program that reads the same file has in other frames than this one. A joint's frame at rest is parallel to the
/// character's axes here, while a Collada file turns it, and its skin places the mesh by a matrix of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct FileFrames {
    /// For each joint the directions of its frame at rest in the file, without its place: what its transform there has
    /// before that of this program.
    pub directions: Vec<DMat4>,
    /// For each joint its inverse bind matrix in the file (`INV_BIND_MATRIX`), from the mesh as the skin places it to the
    /// joint's frame, as it is where it agrees with the joint's node.
    pub inverse_bind: Vec<DMat4>,
    /// From the mesh as the skin places it, in the file's axes and units, to the mesh at rest here.
    pub placed: DMat4,
    /// The skin's own matrix, which places the mesh (`bind_shape_matrix`); `None` where that changes nothing, or several
    /// skins have different ones.
    pub bind_shape: Option<DMat4>,
}
