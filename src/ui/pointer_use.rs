/// What one kind of thing in the view has to do with the pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PointerUse {
    /// Nothing.
    Free,
    /// One is under it, and takes its clicks and left drags.
    Over,
    /// One follows it, and nothing else does.
    Holding,
}
