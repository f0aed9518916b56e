//! Where widgets are on the screen: the same panels, laid out without a window, are asked.

use editor_core::editor::Session;
use editor_core::geometry::Picture;
use editor_core::io::Loaded;
use editor_core::io::builtin::WithBuiltin;
use editor_core::scene::{Look, bones_in_world};
use editor_core::ui::{
    self, CompareReport, CompareSettings, CompareView, ShownPicture, UiState, ViewInput,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use std::cell::Cell;
use std::collections::HashMap;
use std::path::Path;
use std::rc::Rc;

/// Size of the window at its start, in points and pixels alike.
const SIZE: (f32, f32) = (1280.0, 800.0);

/// The middle of the widget called `label`, in a window that shows `scene` as it starts.
pub fn middle_of(scene: &str, label: &str) -> (f32, f32) {
    middle_in(scene, label, None, None)
}

/// The same after `key` was pressed.
pub fn middle_after(key: egui::Key, scene: &str, label: &str) -> (f32, f32) {
    middle_in(scene, label, None, Some(key))
}

/// The same while the view is compared with a picture of 800×600.
pub fn middle_of_comparing(scene: &str, label: &str) -> (f32, f32) {
    let picture = Picture {
        width: 800,
        height: 600,
        rgba: vec![0; 4 * 800 * 600],
    };
    middle_in(scene, label, Some(picture), None)
}

fn middle_in(
    scene: &str,
    label: &str,
    compared: Option<Picture>,
    key: Option<egui::Key>,
) -> (f32, f32) {
    let mut loaded = Loaded::default();
    loaded
        .add(&WithBuiltin(HashMap::new()), Path::new(scene))
        .expect("a built-in scene or character");
    let session = Session::with_shapes(loaded.shapes, loaded.view.unwrap_or_default());
    let mut state = UiState::new();
    let (settings, report) = (CompareSettings::default(), CompareReport::default());
    let mut harness = Harness::builder()
        .with_size(egui::vec2(SIZE.0, SIZE.1))
        .build_ui(move |ui| {
            let compare = compared.as_ref().map(|picture| CompareView {
                name: "reference.png",
                look: Look::Course,
                is_cut: false,
                are_edges_chosen: false,
                is_reference_smooth: None,
                settings: &settings,
                reference: ShownPicture {
                    picture,
                    texture: egui::TextureId::default(),
                },
                live: None,
                difference: None,
                report: &report,
                judged_part: None,
            });
            let input = ViewInput {
                compare: compare.as_ref(),
                progress: None,
                ..ViewInput::default()
            };
            ui::show(ui, &session, &mut state, &input);
        });
    harness.run_steps(4);
    if let Some(key) = key {
        harness.key_press(key);
        harness.run_steps(4);
    }
    let middle = harness.get_by_label(label).rect().center();
    (middle.x, middle.y)
}

/// Where the end of a joint's bone is on the screen, in a window that shows `scene` as it starts.
pub fn end_of_bone(scene: &str, joint: &str) -> (f32, f32) {
    let mut loaded = Loaded::default();
    loaded
        .add(&WithBuiltin(HashMap::new()), Path::new(scene))
        .expect("a built-in scene or character");
    let session = Session::with_shapes(loaded.shapes, loaded.view.unwrap_or_default());
    let shape = &session.evaluated().shapes[0];
    let character = session.scene().character(shape.id).expect("a character");
    let joints = character.character.skeleton().joints();
    let index = joints.iter().position(|known| known.name == joint);
    let (.., end) = bones_in_world(session.scene(), shape)
        .find(|bone| Some(bone.0) == index)
        .expect("the joint has a bone");
    let camera = session.view().camera;
    let mut state = UiState::new();
    let view = Rc::new(Cell::new(egui::Rect::NOTHING));
    let found = view.clone();
    let mut harness = Harness::builder()
        .with_size(egui::vec2(SIZE.0, SIZE.1))
        .build_ui(move |ui| {
            let shown = ui::show(ui, &session, &mut state, &ViewInput::default());
            found.set(shown.view_rect);
        });
    harness.run_steps(4);
    let view = view.get();
    let size = glam::vec2(view.width(), view.height());
    let pixel = camera.pixel(end, size).expect("before the eye");
    (view.left() + pixel.x, view.top() + pixel.y)
}
