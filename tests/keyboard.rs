//! Keys as a keyboard sends them, with their text.

use egui::{Event, Key, Modifiers};

/// Event of a key that goes down or up.
pub fn key(key: Key, pressed: bool, modifiers: Modifiers) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers,
    }
}

/// Press of a key, and its text if it has one.
pub fn press(pressed: Key, modifiers: Modifiers) -> Vec<Event> {
    let text = text(pressed).filter(|_| modifiers == Modifiers::NONE);
    let text = text.map(Event::Text);
    std::iter::once(key(pressed, true, modifiers))
        .chain(text)
        .collect()
}

fn text(key: Key) -> Option<String> {
    let text = match key {
        Key::Minus => "-",
        Key::Period => ".",
        Key::Slash => "/",
        key if key.name().len() == 1 => key.name(),
        _ => return None,
    };
    Some(text.to_lowercase())
}
