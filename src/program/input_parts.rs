use egui::{Event, Key, RawInput};

/// Takes the events of one frame apart, so that each part has one press or release of a button at
/// most, and alone but for the finger that it is of, which comes after it; and what is typed after a
/// shortcut or Enter, or before a shortcut, is in another part than that.
///
/// egui looks at a frame as a whole: what is pressed is what lies where the pointer was last, a
/// drag ends where it was before the frame of the release, and text typed after a click goes to
/// where the keyboard was before it. On slow frames so one thing is taken for another.
pub fn input_parts(mut input: RawInput) -> Vec<RawInput> {
    let is_button = |event: &Event| matches!(event, Event::PointerButton { .. });
    let pressed = |event: &Event| match event {
        Event::Key {
            pressed: true,
            key,
            modifiers,
            ..
        } => Some((*key, modifiers.command)),
        _ => None,
    };
    let is_shortcut = |event: &Event| pressed(event).is_some_and(|(_, command)| command);
    let is_enter = |event: &Event| pressed(event).is_some_and(|(key, _)| key == Key::Enter);
    let types = |event: &Event| {
        matches!(event, Event::Text(_) | Event::Paste(_) | Event::Ime(_))
            || pressed(event).is_some_and(|(_, command)| !command)
    };
    let mut groups: Vec<Vec<Event>> = vec![Vec::new()];
    for event in std::mem::take(&mut input.events) {
        let is_of_finger = matches!(event, Event::Touch { .. });
        let begins = groups.last().is_some_and(|group| {
            let Some(first) = group.first() else {
                return false;
            };
            let ends = |event: &Event| is_shortcut(event) || is_enter(event);
            let is_typed_after = (types(&event) || is_shortcut(&event)) && group.iter().any(ends);
            let is_shortcut_after = is_shortcut(&event) && group.iter().any(types);
            // A group with a button begins with it.
            let is_button_over = is_button(first) && !is_of_finger;
            is_button(&event) || is_button_over || is_typed_after || is_shortcut_after
        });
        if begins {
            groups.push(Vec::new());
        }
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
        let parts = input_parts(input);
        let counts: Vec<usize> = parts.iter().map(|part| part.events.len()).collect();
        assert_eq!(counts, [2, 1, 1, 1, 1]);
        assert!(parts.iter().all(|part| part.time == Some(3.0)));
        let joined: Vec<Event> = parts.into_iter().flat_map(|part| part.events).collect();
        assert_eq!(joined, events);
    }

    #[test]
    fn what_is_typed_is_taken_in_before_the_shortcut_after_it() {
        let key = |key, modifiers| Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        };
        let events = vec![
            Event::Text("4".into()),
            Event::Text("3".into()),
            key(Key::Enter, Modifiers::NONE),
            key(Key::Z, Modifiers::COMMAND),
            key(Key::S, Modifiers::COMMAND),
            Event::Text("5".into()),
        ];
        let parts = input_parts(RawInput {
            events,
            ..RawInput::default()
        });
        let counts: Vec<usize> = parts.iter().map(|part| part.events.len()).collect();
        assert_eq!(counts, [3, 1, 1, 1]);
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
        let parts = input_parts(RawInput {
            events: vec![button(true), finger, Event::PointerMoved(pos2(3.0, 2.0))],
            ..RawInput::default()
        });
        let counts: Vec<usize> = parts.iter().map(|part| part.events.len()).collect();
        assert_eq!(counts, [2, 1]);
    }

    #[test]
    fn files_are_dropped_once() {
        let input = RawInput {
            events: vec![button(true), button(false)],
            dropped_files: vec![std::sync::Arc::new(Nothing)],
            ..RawInput::default()
        };
        let parts = input_parts(input);
        let files: Vec<usize> = parts.iter().map(|part| part.dropped_files.len()).collect();
        assert_eq!(files, [1, 0]);
    }

    #[test]
    fn a_frame_without_events_is_one_part() {
        assert_eq!(input_parts(RawInput::default()).len(), 1);
    }
}
