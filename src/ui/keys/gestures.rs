/// A gesture of the mouse, for the window about the keys.
#[derive(Clone, Copy, Debug)]
pub struct Gesture {
    /// What the hand does.
    pub gesture: &'static str,
    /// What happens.
    pub does: &'static str,
}

pub(in crate::ui) const fn gesture(gesture: &'static str, does: &'static str) -> Gesture {
    Gesture { gesture, does }
}

/// Gestures in the view other than those that move the camera ([`crate::ui::Navigation`]'s), then in
/// the panels.
pub const GESTURES: &[Gesture] = &[
    gesture("Click in the view", "Select the shape under the pointer"),
    gesture(
        "Drag a control point",
        "Move it; Esc or right click cancels",
    ),
    gesture("Wheel in the view", "Move the camera closer or away"),
    gesture("Pose: drag a bone", "Turn it, with Ctrl by 15°"),
    gesture("Pose: Left, Right", "Roll the bone under the pointer"),
    gesture("Pose: click a bone", "Show rings that turn it"),
    gesture("Move: drag a bone", "Move its root, with Shift every root"),
    gesture("Move: drag a shape", "Move it, with Ctrl by 0.1"),
    gesture("Drag a ring", "Turn the joint about it, with Ctrl by 15°"),
    gesture(
        "Drag an arrow or a square",
        "Move along it, with Ctrl by 0.1",
    ),
    gesture(
        "IK: drag a bone",
        "Bring its end somewhere; a chain follows",
    ),
    gesture("IK: drag the root", "Move it all; pinned joints stay"),
    gesture("IK: click a bone", "Select the joint at its nearer end"),
    gesture("Esc, right click in a drag", "Put everything back"),
    gesture("Click the axis ball", "Look from the side that was clicked"),
    gesture(
        "Drag a number",
        "Change it; Shift is finer, Ctrl is coarser",
    ),
    gesture("Click a number", "Type a value or a sum such as 45/2"),
    gesture("Right click a number", "Put it back to where it started"),
    gesture("Up, Down in a list", "Choose the row above or below"),
    gesture("Left, Right in the joint list", "Fold or unfold a joint"),
    gesture("Ctrl and +, −, 0", "Larger, smaller, normal text"),
];
