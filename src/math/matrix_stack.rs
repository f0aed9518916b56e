use glam::Mat4;

/// Stack of transforms in which every entry already holds the product of all below it (assignment,
/// "Matrix stack"). It replaces the graphics library's own stack, which core GL no longer has.
///
/// ```
/// use editor_core::math::MatrixStack;
/// use glam::{Mat4, Vec3};
///
/// let mut stack = MatrixStack::new();
/// stack.push(Mat4::from_translation(Vec3::X));
/// stack.push(Mat4::from_translation(Vec3::Y));
/// assert_eq!(stack.top().w_axis.truncate(), Vec3::new(1.0, 1.0, 0.0));
/// ```
#[derive(Clone, Debug, Default)]
pub struct MatrixStack {
    world_from_local: Vec<Mat4>,
}

impl MatrixStack {
    /// An empty stack, whose top is the identity.
    pub fn new() -> Self {
        Self::default()
    }

    /// Multiplies the current top by `parent_from_child` and makes the product the new top.
    pub fn push(&mut self, parent_from_child: Mat4) {
        self.world_from_local.push(self.top() * parent_from_child);
    }

    /// Removes the top. Does nothing on an empty stack.
    pub fn pop(&mut self) {
        self.world_from_local.pop();
    }

    /// The product of everything pushed, oldest first; the identity if the stack is empty.
    pub fn top(&self) -> Mat4 {
        self.world_from_local
            .last()
            .copied()
            .unwrap_or(Mat4::IDENTITY)
    }

    /// Removes every entry.
    pub fn clear(&mut self) {
        self.world_from_local.clear();
    }
}
