/// What a left drag in the view does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Moves the camera.
    #[default]
    Select,
    /// Turns the bone under the pointer.
    Pose,
    /// Moves the root of the bone, or else the shape, under the pointer.
    Move,
    /// Brings the end of the bone under the pointer somewhere, and a chain of joints follows.
    Ik,
}
