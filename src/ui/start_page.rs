//! First steps in an empty document: recent files, built-in characters and scenes.

use super::posing::BAR_HEIGHT;
use super::theme::Palette;
use super::widgets::named;
use super::{Action, Ask, ViewInput};
use crate::scene::name_of_import;
use egui::{Button, Frame, Margin, Rect, RichText, Ui, UiBuilder, pos2, vec2};

/// Size of the page, in points.
const WIDTH: f32 = 400.0;
const HEIGHT: f32 = 190.0;
/// Recent documents that are offered, at most.
const RECENT: usize = 4;

/// Offers what to begin with, at the top of the view, if there is room.
pub(super) fn show(ui: &mut Ui, view: Rect, input: &ViewInput, actions: &mut Vec<Action>) {
    let top = view.top() + BAR_HEIGHT + 12.0;
    if view.width() < WIDTH + 24.0 || view.bottom() - top < HEIGHT + 12.0 {
        return;
    }
    let place = Rect::from_min_size(
        pos2(view.center().x - WIDTH / 2.0, top),
        vec2(WIDTH, HEIGHT),
    );
    let builder = UiBuilder::new().id_salt("start page").max_rect(place);
    let mut inner = ui.new_child(builder);
    let frame = Frame::popup(ui.style()).inner_margin(Margin::symmetric(16, 12));
    frame.show(&mut inner, |ui| {
        ui.set_width(WIDTH - 32.0);
        ui.heading("Start");
        ui.horizontal_wrapped(|ui| {
            offer(ui, "Open…", "Open a scene or a model", Ask::Open, actions);
            let tip = "Add a character from a .dae file, or from .obj, .skel and .attach files";
            offer(ui, "Import Character…", tip, Ask::ImportCharacter, actions);
            let color = Palette::of(ui.visuals()).weak;
            ui.label(RichText::new("or drop a file here").color(color));
        });
        if !input.recent.is_empty() {
            title(ui, "Recent");
            ui.horizontal_wrapped(|ui| {
                for path in input.recent.iter().take(RECENT) {
                    let name = path
                        .file_name()
                        .unwrap_or(path.as_os_str())
                        .to_string_lossy();
                    let tip = path.to_string_lossy();
                    offer(ui, &name, &tip, Ask::OpenRecent(path.clone()), actions);
                }
            });
        }
        title(ui, "Built-in characters");
        ui.horizontal_wrapped(|ui| {
            for &name in input.builtin_characters {
                let label = name_of_import(name);
                offer(
                    ui,
                    &label,
                    "Add it at the origin",
                    Ask::InsertBuiltin(name),
                    actions,
                );
            }
        });
        title(ui, "Built-in scenes");
        ui.horizontal_wrapped(|ui| {
            for (name, label) in [("showcase", "Showcase"), ("turned", "Turned")] {
                offer(
                    ui,
                    label,
                    "Open it as a new document",
                    Ask::OpenBuiltin(name),
                    actions,
                );
            }
        });
    });
}

fn title(ui: &mut Ui, text: &str) {
    ui.add_space(4.0);
    let color = Palette::of(ui.visuals()).weak;
    ui.label(RichText::new(text).small().color(color));
}

fn offer(ui: &mut Ui, label: &str, tip: &str, ask: Ask, actions: &mut Vec<Action>) {
    let button = ui.add(Button::new(label));
    if named(button, &format!("Begin: {label}"))
        .on_hover_text(tip)
        .clicked()
    {
        actions.push(Action::Ask(ask));
    }
}
