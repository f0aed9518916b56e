use egui::{RichText, Ui};

/// Help ▸ About.
pub(super) fn show(ui: &mut Ui, backend: &str) {
    ui.label(RichText::new(concat!("Editor ", env!("CARGO_PKG_VERSION"))).heading());
    ui.label(env!("CARGO_PKG_DESCRIPTION"));
    ui.add_space(8.0);
    ui.label(concat!("License: ", env!("CARGO_PKG_LICENSE")));
    if !backend.is_empty() {
        ui.label(format!("Draws with {backend}"));
    }
}
