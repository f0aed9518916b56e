//! Where widgets are on the screen: the same panels, laid out without a window, are asked.

use editor_core::editor::Session;
use editor_core::io::builtin::WithBuiltin;
use editor_core::io::{Diagnostic, Files, Loaded};
use editor_core::ui::{self, UiState, ViewInput};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use std::path::Path;

/// Size of the window at its start, in points and pixels alike.
const SIZE: (f32, f32) = (1280.0, 800.0);

struct NoDisk;

impl Files for NoDisk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        Err(Diagnostic::new(path, "there is no such file"))
    }

    fn exists(&self, _: &Path) -> bool {
        false
    }
}

/// The middle of the widget called `label`, in a window that shows `scene` as it starts.
pub fn middle_of(scene: &str, label: &str) -> (f32, f32) {
    let mut loaded = Loaded::default();
    loaded
        .add(&WithBuiltin(NoDisk), Path::new(scene))
        .expect("a built-in scene or character");
    let session = Session::with_scene(loaded.scene, loaded.view.unwrap_or_default());
    let mut state = UiState::new();
    let mut harness = Harness::builder()
        .with_size(egui::vec2(SIZE.0, SIZE.1))
        .build_ui(move |ui| {
            ui::show(ui, &session, &mut state, &ViewInput::default());
        });
    harness.run_steps(4);
    let middle = harness.get_by_label(label).rect().center();
    (middle.x, middle.y)
}
