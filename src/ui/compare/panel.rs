use super::{CompareView, mask_list, report};
use crate::editor::View;
use crate::scene::{Look, Shading};
use crate::ui::number_field::NumberField;
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use crate::ui::{Action, Ask, CompareAction, CompareMode, CompareSettings};
use egui::{
    Align, Button, Frame, Label, Layout, Margin, Panel, RichText, ScrollArea, Slider, Ui, vec2,
};

/// At this height the course's 800×600 pixels fit above it in the window's first size.
const HEIGHT: f32 = 128.0;
const LOWEST: f32 = 64.0;
/// Narrower panels show their parts one below the other.
const ROOM_FOR_COLUMNS: f32 = 760.0;

/// The panel below the view while a picture is compared with it.
pub(in crate::ui) fn show(
    root: &mut Ui,
    look_is_course: bool,
    compare: &CompareView,
    changed: &mut CompareSettings,
    actions: &mut Vec<Action>,
) {
    let frame = Frame::side_top_panel(root.style()).inner_margin(Margin::symmetric(8, 4));
    let highest = (root.available_height() * 0.6).max(LOWEST);
    Panel::bottom("compare")
        .frame(frame)
        .resizable(true)
        .default_size(HEIGHT)
        .size_range(LOWEST..=highest)
        .show(root, |ui| {
            header(ui, compare, changed, actions);
            ui.add_space(2.0);
            ScrollArea::vertical()
                .id_salt("comparison")
                .auto_shrink(false)
                .show(ui, |ui| {
                    if ui.available_width() < ROOM_FOR_COLUMNS {
                        report::findings(ui, look_is_course, compare);
                        report::numbers(ui, compare.report);
                        ui.separator();
                        settings(ui, look_is_course, compare, changed, actions);
                    } else {
                        let gap = std::mem::replace(&mut ui.spacing_mut().item_spacing.x, 16.0);
                        ui.columns_const(|columns: &mut [Ui; 3]| {
                            for column in &mut *columns {
                                column.spacing_mut().item_spacing.x = gap;
                            }
                            let [numbers, findings, choices] = columns;
                            report::numbers(numbers, compare.report);
                            report::findings(findings, look_is_course, compare);
                            settings(choices, look_is_course, compare, changed, actions);
                        });
                    }
                });
        });
}

fn header(
    ui: &mut Ui,
    compare: &CompareView,
    changed: &mut CompareSettings,
    actions: &mut Vec<Action>,
) {
    ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
        let mut ask = |button: egui::Response, action| {
            if button.clicked() {
                actions.push(Action::Ask(Ask::Compare(action)));
            }
        };
        let close = named(ui.add(Button::new("×")), "Stop comparing");
        ask(
            close.on_hover_text("Back to the view alone (Esc)"),
            CompareAction::Close,
        );
        let save = ui.add(Button::new("Save…"));
        ask(
            save.on_hover_text("Save A, B and their differences side by side in one picture"),
            CompareAction::Save,
        );
        let other = named(ui.add(Button::new("Open…")), "Compare with another picture");
        ask(
            other.on_hover_text("Compare with another picture (F8)"),
            CompareAction::Choose,
        );
        ui.with_layout(
            Layout::left_to_right(Align::Min).with_main_wrap(true),
            |ui| {
                modes(ui, changed);
                let (width, height) = compare.size();
                let text = format!("{} · {width}×{height}", compare.name);
                let color = Palette::of(ui.visuals()).weak;
                ui.add(Label::new(RichText::new(text).color(color)).truncate())
                    .on_hover_text("A, the picture that the view is compared with");
            },
        );
    });
}

fn modes(ui: &mut Ui, changed: &mut CompareSettings) {
    for mode in CompareMode::ALL {
        let button = ui.selectable_label(changed.mode == mode, mode.label());
        if button.on_hover_text(explained(mode)).clicked() {
            changed.mode = mode;
        }
    }
    match changed.mode {
        CompareMode::Swipe => share(ui, "Swipe position", &mut changed.swipe),
        CompareMode::OnionSkin => share(ui, "Live view's opacity", &mut changed.onion),
        _ => {}
    }
}

fn share(ui: &mut Ui, name: &str, value: &mut f32) {
    let slider = Slider::new(value, 0.0..=1.0).show_value(false);
    named(ui.add(slider), name).on_hover_text(name);
}

fn explained(mode: CompareMode) -> &'static str {
    match mode {
        CompareMode::SideBySide => "The picture (A) beside the live view (B)",
        CompareMode::Swipe => "The picture left of a line that you drag, the live view right of it",
        CompareMode::Blink => "The picture and the live view in turn: what moves, differs",
        CompareMode::OnionSkin => "The live view over the picture, like thin paper",
        CompareMode::Difference => "Black where both are equal, lighter where they differ more",
    }
}

/// What counts as a difference, how the live view is drawn, and what is left out.
fn settings(
    ui: &mut Ui,
    look_is_course: bool,
    compare: &CompareView,
    changed: &mut CompareSettings,
    actions: &mut Vec<Action>,
) {
    ui.horizontal_wrapped(|ui| {
        ui.label("Threshold");
        let threshold = NumberField::new("Threshold", f32::from(changed.threshold), 1.0)
            .range(0.0..=255.0)
            .decimals(0..=0)
            .show(ui, vec2(48.0, 20.0));
        if let Some(threshold) = threshold {
            changed.threshold = threshold.round().clamp(0.0, 255.0) as u8;
        }
        ui.checkbox(&mut changed.smooth_edges, "Smooth edges")
            .on_hover_text("Draw the live view with antialiasing; the course's program has none");
    });
    ui.horizontal_wrapped(|ui| {
        let as_course = look_is_course && !changed.smooth_edges;
        let course = ui
            .add_enabled(!as_course, Button::new("Course look"))
            .on_hover_text("Draw the live view as the course's program does: its light and background, hard edges")
            .on_disabled_hover_text("The live view is drawn as the course's program does");
        if course.clicked() {
            changed.smooth_edges = false;
            actions.push(Action::View(View::SetLook(Look::Course)));
            actions.push(Action::View(View::SetShading(Shading::AsAuthored)));
        }
        mask_list::buttons(ui, compare.size(), &mut changed.masks);
    });
    mask_list::show(ui, compare.size(), &mut changed.masks);
}
