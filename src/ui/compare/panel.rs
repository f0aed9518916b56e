use super::apart::KeptPlaces;
use super::findings::findings;
use super::outlined::Outlined;
use super::{CompareReport, CompareView, masks};
use crate::compare::{Differences, Judgment};
use crate::editor::{Session, View};
use crate::scene::{Look, Shading};
use crate::ui::below_view::{Heights, below_the_view, columns, has_room_for_columns, scrolled};
use crate::ui::number_field::NumberField;
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use crate::ui::{Action, Ask, CompareAction, CompareMode, CompareSettings};
use egui::{Align, Button, Color32, Grid, Label, Layout, Response, RichText, Slider, Ui, vec2};

/// At the height alone the course's 800×600 pixels fit above it in the window's first size.
const HEIGHTS: Heights = Heights {
    lowest: 64.0,
    alone: 128.0,
    beside: 0.16,
};
/// Shown for what is not known yet.
const UNKNOWN: &str = "…";

/// The panel below the view while a picture is compared with it.
pub(in crate::ui) fn show(
    root: &mut Ui,
    session: &Session,
    compare: &CompareView,
    changed: &mut CompareSettings,
    outlined: &mut Outlined,
    kept: &mut KeptPlaces,
    actions: &mut Vec<Action>,
) {
    let look = session.view().look;
    below_the_view(root, ("compare", false), HEIGHTS, |ui| {
        header(ui, compare, changed, actions);
        // What is scrolled is so for one picture.
        ui.push_id(compare.reference.texture, |ui| {
            if has_room_for_columns(ui) {
                columns(ui, |number, ui| match number {
                    0 => findings(ui, session, compare, outlined, kept),
                    1 => numbers(ui, compare.report),
                    _ => settings(ui, look, compare, changed, actions),
                });
            } else {
                scrolled(ui, |ui| {
                    findings(ui, session, compare, outlined, kept);
                    numbers(ui, compare.report);
                    ui.separator();
                    settings(ui, look, compare, changed, actions);
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
    look: Look,
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
        // Edges that are those of the picture stay.
        let are_edges_right = compare.is_reference_smooth == Some(true);
        let as_course = look == Look::Course && (!changed.smooth_edges || are_edges_right);
        let course = ui
            .add_enabled(!as_course, Button::new("Course look"))
            .on_hover_text("Draw the live view as the course's program does: its light and background, and hard edges unless A has smooth ones")
            .on_disabled_hover_text("The live view is drawn as the course's program does");
        if course.clicked() {
            changed.smooth_edges &= are_edges_right;
            actions.push(Action::View(View::SetLook(Look::Course)));
            actions.push(Action::View(View::SetShading(Shading::AsAuthored)));
        }
        for (other, name, tip, is_it) in [
            (
                Look::Studio,
                "Studio look",
                "Draw the live view as pictures of files that are not the course's: its light and ground",
                "The live view is drawn in the Studio look",
            ),
            (
                Look::Mannequin,
                "Mannequin look",
                "Draw the live view as the Virtual Mannequin does: its light and background",
                "The live view is drawn as the Virtual Mannequin does",
            ),
        ] {
            let button = ui.add_enabled(look != other, Button::new(name));
            let button = button.on_hover_text(tip).on_disabled_hover_text(is_it);
            if button.clicked() {
                actions.push(Action::View(View::SetLook(other)));
            }
        }
        masks::buttons(ui, compare, look, &mut changed.masks);
    });
    masks::list(ui, compare.size(), &mut changed.masks);
}

/// What was measured: a name, a number, and what it means.
fn numbers(ui: &mut Ui, report: &CompareReport) {
    let palette = Palette::of(ui.visuals());
    let judged = report.judgment.as_ref();
    // What belongs to an older picture stands back until it is measured anew.
    let judged_color = if report.measuring {
        palette.weak
    } else {
        palette.text
    };
    Grid::new("numbers")
        .num_columns(2)
        .spacing([12.0, 1.0])
        .min_row_height(16.0)
        .show(ui, |ui| {
            for (name, value, hint) in counted(report.differences.as_ref()) {
                line(ui, name, &value, palette.text, hint);
            }
            let (name, value, hint) = perceived(judged);
            line(ui, name, &value, judged_color, hint);
        });
}

type Line = (&'static str, String, &'static str);

fn counted(counts: Option<&Differences>) -> [Line; 4] {
    let value = |text: fn(&Differences) -> String| counts.map_or(UNKNOWN.to_owned(), text);
    [
        (
            "Differing pixels",
            value(|c| of_which(c.differing_pixels, c.compared_pixels)),
            "Pixels of which a channel differs by more than the threshold",
        ),
        (
            "Of the drawn",
            value(|c| of_which(c.drawn_differing_pixels, c.drawn_pixels)),
            "The same among the pixels that are not background in one of the pictures",
        ),
        (
            "Difference",
            value(|c| format!("at most {}, mean {:.3} of 255", c.max, c.mean)),
            "Of a channel of a pixel",
        ),
        (
            "PSNR",
            value(|c| {
                if c.psnr.is_finite() {
                    format!("{:.2} dB", c.psnr)
                } else {
                    "infinite: no color differs".to_owned()
                }
            }),
            "Peak signal to noise ratio: larger is more alike",
        ),
    ]
}

fn perceived(judgment: Option<&Judgment>) -> Line {
    let value = match judgment {
        None => UNKNOWN.to_owned(),
        Some(Judgment { ssim, flip, .. }) => match ssim {
            Some(ssim) => format!("{ssim:.5}, {flip:.5}"),
            None => format!("none below 11×11 pixels, {flip:.5}"),
        },
    };
    (
        "SSIM, FLIP",
        value,
        "Structural similarity, 1 if equal; and the difference that a person sees when the pictures blink, 0 if equal",
    )
}

/// `37 of 12345 (0.300 %)`.
pub(super) fn of_which(part: u64, whole: u64) -> String {
    let percent = 100.0 * part as f64 / whole.max(1) as f64;
    format!("{part} of {whole} ({percent:.3} %)")
}

/// A line of a grid: what it is, its value, and what that means.
pub(super) fn line(ui: &mut Ui, name: &str, value: &str, color: Color32, hint: &str) {
    let weak = Palette::of(ui.visuals()).weak;
    ui.label(RichText::new(name).small().color(weak))
        .on_hover_text(hint);
    let value = RichText::new(value).small().color(color);
    ui.add(Label::new(value).selectable(true))
        .on_hover_text(hint);
    ui.end_row();
}

/// A paragraph that can be copied.
pub(super) fn say(ui: &mut Ui, text: &str, color: Color32) {
    label(ui, text, color);
}

/// The same as a widget.
pub(super) fn label(ui: &mut Ui, text: &str, color: Color32) -> Response {
    let text = RichText::new(text).color(color);
    ui.add(Label::new(text).wrap().selectable(true))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_told_with_their_whole_and_never_divide_by_zero() {
        assert_eq!(of_which(3, 1000), "3 of 1000 (0.300 %)");
        assert_eq!(of_which(0, 0), "0 of 0 (0.000 %)");
    }
}
