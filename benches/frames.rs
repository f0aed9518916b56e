//! What a person feels: frames of the window while something is dragged.

use crate::report::Report;
use crate::window::Window;
use egui::{Key, Pos2};

const ROUNDS: usize = 7;

/// Name of the scene that is opened.
pub const SCENE: &str = "bench.scene";

pub fn run(report: &mut Report) {
    report.ratio("Selected against deselected, Studio", 1.1, || {
        let mut selected = Drag::of_camera(1, "studio", true);
        let mut deselected = Drag::of_camera(1, "studio", false);
        against(&mut selected, &mut deselected)
    });
    report.ratio("Selected against deselected, Course", 1.1, || {
        let mut selected = Drag::of_camera(1, "course", true);
        let mut deselected = Drag::of_camera(1, "course", false);
        against(&mut selected, &mut deselected)
    });
    report.ratio(
        "Studio with shadows against Course, dragging a bone",
        1.5,
        || {
            against(
                &mut Drag::of_bone(1, "studio"),
                &mut Drag::of_bone(1, "course"),
            )
        },
    );
    for count in [16, 100] {
        let what = format!("A bone among {count} characters against one alone, Studio");
        report.ratio(&what, 1.3, || {
            against(
                &mut Drag::of_bone(count, "studio"),
                &mut Drag::of_bone(1, "studio"),
            )
        });
    }
}

/// A drag that is under way.
struct Drag {
    window: Window,
    from: Pos2,
}

impl Drag {
    fn of_bone(count: usize, look: &str) -> Self {
        let mut window = Window::start(SCENE, &scene(count, look));
        window.key(Key::B);
        let from = window.end_of_bone("Left elbow");
        window.press(from);
        let before = window.state();
        let mut drag = Self { window, from };
        drag.round();
        drag.window.release(from);
        assert_eq!(
            drag.window.state(),
            (before.0 + 1, true),
            "a bone was dragged"
        );
        drag.window.press(from);
        drag
    }

    fn of_camera(count: usize, look: &str, selected: bool) -> Self {
        let mut window = Window::start(SCENE, &scene(count, look));
        let from = window.empty_place();
        if !selected {
            window.key(Key::Escape);
        }
        assert_eq!(window.state().1, selected);
        window.press(from);
        Self { window, from }
    }

    fn round(&mut self) -> f64 {
        self.window.drag(self.from)
    }
}

/// The least of interleaved rounds of both.
fn against(one: &mut Drag, other: &mut Drag) -> (f64, f64) {
    let mut least = (f64::INFINITY, f64::INFINITY);
    for _ in 0..ROUNDS {
        least.0 = least.0.min(one.round());
        least.1 = least.1.min(other.round());
    }
    least
}

/// An adult, selected, before rows of others, ten in each.
pub fn scene(count: usize, look: &str) -> String {
    let behind = (1..count).rev().map(|index| {
        let (row, column) = (index / 10 + 1, index % 10);
        (column as f64 - 4.5, -(row as f64))
    });
    let shapes: Vec<String> = behind
        .chain([(0.0, 0.0)])
        .map(|(x, z)| format!(r#"{{"source": "builtin:adult", "position": [{x}, 0, {z}]}}"#))
        .collect();
    format!(
        r#"{{"format": "editor-scene", "version": 1, "view": {{"look": "{look}", "grid": true}},
            "shapes": [{}]}}"#,
        shapes.join(", ")
    )
}
