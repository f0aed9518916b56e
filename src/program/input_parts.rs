use egui::{Event, Key, RawInput};

/// Takes the events of one frame apart, so that each part has one press or release of a button at
/// most, alone but for the finger that it is of, which comes after it, or the press of one key with
/// its text. Only what is typed into a text field, which `is_typing` says has the keyboard at first,
/// stays together until a key that may end it.
///
/// egui and the program look at a frame as a whole: what is pressed is what lies where the pointer was
/// last, a drag ends where it was before the frame of the release, text typed after a click or Tab goes
/// to where the keyboard was before it, and a key does what it did before the one that came with it.
/// On slow frames so one thing is taken for another.
pub fn input_parts(mut input: RawInput, mut is_typing: bool) -> Vec<RawInput> {
    let mut groups: Vec<Vec<Event>> = vec![Vec::new()];
    for event in std::mem::take(&mut input.events) {
        let begins = groups
            .last()
            .is_some_and(|group| is_over(group, &event, is_typing));
        if begins {
            groups.push(Vec::new());
        }
        is_typing &= !may_end_typing(&event);
        if let Some(group) = groups.last_mut() {
            group.push(event);
        }
    }
    let parts = groups.into_iter().map(|events| RawInput {
        events,
        ..input.clone()
    });
    let mut parts: Vec<RawInput> = parts.collect();
    // Files are dropped once.
    for later in parts.iter_mut().skip(1) {
        later.dropped_files.clear();
    }
    parts
}

/// Whether `event` cannot belong to the events of `group`, before which a text field had the keyboard
/// if `is_typing`, and has it still.
fn is_over(group: &[Event], event: &Event, is_typing: bool) -> bool {
    let Some(first) = group.first() else {
        return false;
    };
    // A group with a button begins with it.
    if is_button(event) || is_button(first) {
        return !matches!(event, Event::Touch { .. });
    }
    let has_press = group.iter().any(is_press);
    let has_text = group.iter().any(is_text);
    if is_press(event) {
        let is_repeated = is_repeated(event, group);
        let goes_on = is_typing && !may_end_typing(event);
        return (has_press || has_text) && !is_repeated && !goes_on;
    }
    match event {
        Event::Text(_) | Event::Ime(_) => {
            !is_typing && (has_text || group.iter().any(may_end_typing))
        }
        Event::PointerMoved(_) | Event::ModifiersChanged(_) => has_press && !is_typing,
        _ => false,
    }
}

fn is_button(event: &Event) -> bool {
    matches!(event, Event::PointerButton { .. })
}

fn is_text(event: &Event) -> bool {
    matches!(event, Event::Text(_) | Event::Ime(_))
}

/// Whether a key is pressed. The keys of the clipboard are events of their own.
fn is_press(event: &Event) -> bool {
    matches!(
        event,
        Event::Key { pressed: true, .. } | Event::Cut | Event::Copy | Event::Paste(_)
    )
}

/// Whether `event` comes from a key that is held and is the only one of `group`.
fn is_repeated(event: &Event, group: &[Event]) -> bool {
    let Event::Key {
        key, repeat: true, ..
    } = event
    else {
        return false;
    };
    let mut presses = group.iter().filter(|event| is_press(event));
    presses.all(|event| matches!(event, Event::Key { key: other, .. } if other == key))
}

/// Whether the keyboard may belong to something else after an event.
fn may_end_typing(event: &Event) -> bool {
    match event {
        Event::Key {
            pressed: true,
            key,
            modifiers,
            ..
        } => modifiers.command || matches!(key, Key::Enter | Key::Tab | Key::Escape),
        _ => is_button(event) || is_press(event),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Modifiers, PointerButton, pos2};

    fn button(pressed: bool) -> Event {
        Event::PointerButton {
            pos: pos2(1.0, 2.0),
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    #[test]
    fn a_press_and_what_comes_after_it_are_looked_at_one_after_the_other() {
        let moved = |x| Event::PointerMoved(pos2(x, 0.0));
        let events = vec![
            moved(1.0),
            moved(2.0),
            button(true),
            moved(3.0),
            button(false),
            Event::Text("7".into()),
        ];
        let input = RawInput {
            events: events.clone(),
            time: Some(3.0),
            ..RawInput::default()
        };
        assert_eq!(counts(events.clone(), true), [2, 1, 1, 1, 1]);
        let parts = input_parts(input, true);
        assert!(parts.iter().all(|part| part.time == Some(3.0)));
        let joined: Vec<Event> = parts.into_iter().flat_map(|part| part.events).collect();
        assert_eq!(joined, events);
    }

    fn key(key: Key, modifiers: Modifiers) -> Event {
        Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        }
    }

    fn text(text: &str) -> Event {
        Event::Text(text.into())
    }

    fn counts(events: Vec<Event>, is_typing: bool) -> Vec<usize> {
        let input = RawInput {
            events,
            ..RawInput::default()
        };
        let parts = input_parts(input, is_typing);
        parts.iter().map(|part| part.events.len()).collect()
    }

    #[test]
    fn what_is_typed_is_taken_in_before_the_shortcut_after_it() {
        let events = vec![
            text("4"),
            text("3"),
            key(Key::Enter, Modifiers::NONE),
            key(Key::Z, Modifiers::COMMAND),
            key(Key::S, Modifiers::COMMAND),
            text("5"),
        ];
        assert_eq!(counts(events, true), [2, 1, 1, 1, 1]);
    }

    #[test]
    fn keys_are_pressed_one_after_the_other_with_their_text_unless_they_are_typed_into_a_field() {
        let events = vec![
            key(Key::G, Modifiers::NONE),
            text("g"),
            key(Key::X, Modifiers::NONE),
            text("x"),
            Event::PointerMoved(pos2(3.0, 2.0)),
        ];
        assert_eq!(counts(events.clone(), false), [2, 2, 1]);
        assert_eq!(counts(events, true), [5]);
        let tab = key(Key::Tab, Modifiers::NONE);
        let events = vec![text("1"), tab.clone(), text("2"), tab, Event::Cut];
        assert_eq!(counts(events, true), [1, 1, 1, 1, 1]);
    }

    #[test]
    fn a_key_that_is_held_is_one_press_many_times() {
        let held = Event::Key {
            key: Key::ArrowLeft,
            physical_key: None,
            pressed: true,
            repeat: true,
            modifiers: Modifiers::NONE,
        };
        let events = vec![
            held.clone(),
            held.clone(),
            key(Key::A, Modifiers::NONE),
            held,
        ];
        assert_eq!(counts(events, false), [2, 1, 1]);
    }

    #[derive(Debug)]
    struct Nothing;

    impl egui::DroppedFile for Nothing {
        fn path(&self) -> &std::path::Path {
            std::path::Path::new("nothing.obj")
        }

        fn bytes(&self) -> Result<Vec<u8>, String> {
            Ok(Vec::new())
        }
    }

    #[test]
    fn a_press_by_a_finger_stays_with_its_finger() {
        let finger = Event::Touch {
            device_id: egui::TouchDeviceId(0),
            id: egui::TouchId(1),
            phase: egui::TouchPhase::Start,
            pos: pos2(1.0, 2.0),
            force: None,
        };
        let moved = Event::PointerMoved(pos2(3.0, 2.0));
        assert_eq!(counts(vec![button(true), finger, moved], false), [2, 1]);
    }

    #[test]
    fn files_are_dropped_once() {
        let input = RawInput {
            events: vec![button(true), button(false)],
            dropped_files: vec![std::sync::Arc::new(Nothing)],
            ..RawInput::default()
        };
        let parts = input_parts(input, false);
        let files: Vec<usize> = parts.iter().map(|part| part.dropped_files.len()).collect();
        assert_eq!(files, [1, 0]);
    }

    #[test]
    fn a_frame_without_events_is_one_part() {
        assert_eq!(input_parts(RawInput::default(), false).len(), 1);
    }
}
