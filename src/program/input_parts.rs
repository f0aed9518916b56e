use egui::{Event, RawInput};

/// Takes the events of one frame apart, so that each part has one press or release of a button at
/// most, and alone but for the finger that it is of, which comes after it.
///
/// egui looks at a frame as a whole: what is pressed is what lies where the pointer was last, a
/// drag ends where it was before the frame of the release, and text typed after a click goes to
/// where the keyboard was before it. On slow frames so one thing is taken for another.
pub fn input_parts(mut input: RawInput) -> Vec<RawInput> {
    let is_button = |event: &Event| matches!(event, Event::PointerButton { .. });
    let mut groups: Vec<Vec<Event>> = vec![Vec::new()];
    for event in std::mem::take(&mut input.events) {
        let alone = is_button(&event);
        // A group with a button begins with it.
        let is_of_finger = matches!(event, Event::Touch { .. });
        let before = groups.last().and_then(|group| group.first());
        let begins = before.is_some_and(|first| alone || is_button(first) && !is_of_finger);
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
