use egui::{Event, InputState, PointerButton, Pos2};

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

/// Where the left button went up in this frame: the pointer may have gone on since.
pub(super) fn released_at(input: &InputState) -> Option<Pos2> {
    input.events.iter().find_map(|event| match event {
        Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed: false,
            ..
        } => Some(*pos),
        _ => None,
    })
}
