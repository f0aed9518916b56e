use glam::DMat4;

/// What a program that reads the same file has in other frames than this one. A joint's frame at rest is parallel to the
/// character's axes here, while a Collada file turns it, and its skin places the mesh by a matrix of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct FileFrames {
    /// For each joint what its transform in the file has before that of this program: it leads from the mesh as the skin
    /// places it to the directions of the joint's frame, without its place.
    pub turned: Vec<DMat4>,
    /// What takes the mesh at rest to where it is without the skin's own matrix (`bind_shape_matrix`); `None` where that
    /// changes nothing, or several skins have different ones.
    pub unshaped: Option<DMat4>,
}
