//! What a person points with, by which hints choose their words.

use egui::{Context, Event, Id, InputState};

/// What a person points with, as far as is known: what was used last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Pointing {
    /// A mouse or what passes for one, with a keyboard at hand.
    #[default]
    Mouse,
    /// Fingers, which have neither a second button nor keys.
    Fingers,
}

impl Pointing {
    /// What is pointed with. A screen of touch with a mouse has either at any time.
    pub(super) fn of(ctx: &Context) -> Self {
        ctx.data(|data| data.get_temp(id())).unwrap_or_default()
    }

    /// `with_mouse`, or `with_fingers` if these point.
    pub(super) fn words<'t>(self, with_mouse: &'t str, with_fingers: &'t str) -> &'t str {
        match self {
            Self::Mouse => with_mouse,
            Self::Fingers => with_fingers,
        }
    }
}

/// Takes note of what points in this frame. To be called before the panels. Where nothing has pointed yet, these are
/// fingers if the machine `has_fingers_first`.
pub(super) fn notice(ctx: &Context, has_fingers_first: bool) {
    let now = ctx.input(|input| {
        let mut events = input.events.iter();
        let is_touch = |event: &Event| matches!(event, Event::Touch { .. });
        // The first finger moves the pointer as well.
        if input.events.iter().any(is_touch) || InputState::any_touches(input) {
            return Some(Pointing::Fingers);
        }
        let is_moved = events.any(|event| matches!(event, Event::PointerMoved(_)));
        is_moved.then_some(Pointing::Mouse)
    });
    let is_known = ctx.data(|data| data.get_temp::<Pointing>(id()).is_some());
    let first = (has_fingers_first && !is_known).then_some(Pointing::Fingers);
    if let Some(now) = now.or(first) {
        ctx.data_mut(|data| data.insert_temp(id(), now));
    }
}

fn id() -> Id {
    Id::new("what points")
}
