//! The list of mouse gestures.

/// A mouse gesture, as Help ▸ Keys and Mouse lists it.
#[derive(Clone, Copy, Debug)]
pub struct Gesture {
    /// Buttons and movement, such as "Drag a ring".
    pub gesture: &'static str,
    /// Effect.
    pub does: &'static str,
}

/// A row of that list.
pub(in crate::ui) const fn gesture(gesture: &'static str, does: &'static str) -> Gesture {
    Gesture { gesture, does }
}

/// Gestures in the view, without those that move the camera (see [`crate::ui::Navigation`]), then in the
/// panels.
pub const GESTURES: &[Gesture] = &[
    gesture(
        "Click in the view",
        "Select a shape; Ctrl or Shift adds one",
    ),
    gesture(
        "Right click in the view",
        "Menu for what is under the pointer",
    ),
    gesture(
        "Drag a selected curve's point",
        "Move it; Esc or right click cancels",
    ),
    gesture("Wheel in the view", "Move the camera closer or away"),
    gesture("Pose: drag a bone", "Turn it, with Ctrl by 15°"),
    gesture("Pose: Left, Right", "Roll the bone under the pointer"),
    gesture(
        "Pose: click a bone",
        "Show rings that turn it; Shift adds one",
    ),
    gesture(
        "Move: drag a bone that shows",
        "Move its root, with Shift every root",
    ),
    gesture("Move: drag a shape", "Move it, with Ctrl by 0.1"),
    gesture("Drag a ring", "Turn about it, with Ctrl by 15°"),
    gesture(
        "Drag an arrow or a square",
        "Move along it, with Ctrl by 0.1",
    ),
    gesture("Scale: drag a handle", "Scale along it, with Ctrl by 0.1"),
    gesture("Scale: drag the ring", "Scale along all axes"),
    gesture("Shift in a drag of a shape", "Follow the pointer finely"),
    gesture(
        "X, Y, Z in a drag",
        "That axis alone; again: local, all. Scaling is local",
    ),
    gesture(
        "Shift and X, Y, Z in a drag",
        "The two other axes; again: local",
    ),
    gesture("A number in a drag", "Exactly so far; Enter keeps it"),
    gesture("Click a point, Delete", "Delete that point of the curve"),
    gesture("IK: drag a bone", "Move its end; a chain follows"),
    gesture("IK: drag the root", "Move it all; pinned joints stay"),
    gesture("IK: click a bone", "Select the joint at its nearer end"),
    gesture("Esc, right click in a drag", "Put everything back"),
    gesture("Click the axis ball", "Look from the side that was clicked"),
    gesture(
        "Drag a number",
        "Change it; Shift is finer, Ctrl is coarser",
    ),
    gesture(
        "Click a number",
        "Type a value or an expression such as 45/2",
    ),
    gesture("Right click a number", "Put it back to where it started"),
    gesture("Double click in the list", "Type a new name for the shape"),
    gesture("Drag in the list", "Move the shape to another place in it"),
    gesture("Up, Down in a list", "Choose the row above or below"),
    gesture("Left, Right in the joint list", "Fold or unfold a joint"),
    gesture("Ctrl and +, −, 0", "Larger, smaller, normal text"),
];
