use super::hints::{self, hints};
use super::outlined::Outlined;
use super::page_figure::{self, FigureTold};
use super::place::{Place, apart, place};
use super::{CompareReport, CompareView, masks};
use crate::compare::{Area, Differences, Finding, Judgment};
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
    actions: &mut Vec<Action>,
) {
    let look = session.view().look;
    below_the_view(root, ("compare", false), HEIGHTS, |ui| {
        header(ui, compare, changed, actions);
        // What is scrolled is so for one picture.
        ui.push_id(compare.reference.texture, |ui| {
            if has_room_for_columns(ui) {
                columns(ui, |number, ui| match number {
                    0 => findings(ui, session, compare, outlined),
                    1 => numbers(ui, compare.report),
                    _ => settings(ui, look, compare, changed, actions),
                });
            } else {
                scrolled(ui, |ui| {
                    findings(ui, session, compare, outlined);
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
        let as_course = look == Look::Course && !changed.smooth_edges;
        let course = ui
            .add_enabled(!as_course, Button::new("Course look"))
            .on_hover_text("Draw the live view as the course's program does: its light and background, hard edges")
            .on_disabled_hover_text("The live view is drawn as the course's program does");
        if course.clicked() {
            changed.smooth_edges = false;
            actions.push(Action::View(View::SetLook(Look::Course)));
            actions.push(Action::View(View::SetShading(Shading::AsAuthored)));
        }
        let mannequin = ui
            .add_enabled(look != Look::Mannequin, Button::new("Mannequin look"))
            .on_hover_text("Draw the live view as the Virtual Mannequin does: its light and background")
            .on_disabled_hover_text("The live view is drawn as the Virtual Mannequin does");
        if mannequin.clicked() {
            actions.push(Action::View(View::SetLook(Look::Mannequin)));
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

/// What is wrong, in words.
fn findings(ui: &mut Ui, session: &Session, compare: &CompareView, outlined: &mut Outlined) {
    let palette = Palette::of(ui.visuals());
    let areas = compare.report.judgment.iter().flat_map(|j| &j.findings);
    let counts = compare.report.differences.as_ref();
    let all = counts.and_then(|counts| counts.differing_area);
    // What differs of the figure says more than all that does, where other lines and floors are drawn about it.
    let of_page = compare.report.page_figure.as_ref();
    let of_page = of_page.map(|figure| FigureTold::new(session, compare, figure));
    let judgment = compare.report.judgment.as_ref();
    let apart = judgment.filter(|_| of_page.is_none()).and_then(|judged| {
        let (off, figure) = (judged.off.as_ref()?, judged.figure?);
        Some(apart(session, off, figure, compare.size()))
    });
    let apart = apart.unwrap_or_default();
    let places = of_page.as_ref().map(|figure| &figure.places);
    let is_still_told = |area: &Area| {
        let mut places = places.into_iter().flatten().chain(&apart);
        all == Some(*area)
            || places.any(|place| place.area == *area)
            || areas.clone().any(|f| f.area() == Some(*area))
    };
    *outlined = Outlined {
        hovered: None,
        clicked: outlined.clicked.filter(is_still_told),
    };
    ui.vertical(|ui| {
        let report = compare.report;
        if let Some(problem) = &report.problem {
            return say(ui, &problem.to_string(), palette.error);
        }
        let Some(counts) = &report.differences else {
            return say(ui, "Measuring…", palette.weak);
        };
        if counts.max == 0 {
            return say(ui, "A and B are equal, pixel by pixel.", palette.strong);
        }
        let shapes = session.scene().shapes();
        if !shapes.iter().any(|shape| shape.visible) {
            let text = match shapes.is_empty() {
                true => "B is empty: Insert ⏵ Import adds what is to be compared.",
                false => "B is empty: all shapes are hidden.",
            };
            return say(ui, text, palette.strong);
        }
        if counts.differing_pixels == 0 {
            say(
                ui,
                "No pixel differs by more than the threshold.",
                palette.strong,
            );
        }
        let look = session.view().look;
        let of_page = of_page.as_ref().filter(|_| look == Look::Mannequin);
        let [first, last] = [true, false].map(|is_first| {
            let figure = of_page.filter(|figure| figure.is_elsewhere == is_first);
            figure.map(FigureTold::hint)
        });
        let is_slanted = report
            .page_figure
            .as_ref()
            .is_some_and(|page| page.is_slanted);
        if is_slanted && look == Look::Mannequin && !report.measuring {
            return say(ui, page_figure::SLANTED, palette.strong);
        }
        if let Some(hint) = first.filter(|_| !report.measuring) {
            say(ui, hint, palette.strong);
        }
        match &report.judgment {
            Some(judgment) if !report.measuring => {
                let are_told_apart =
                    |finding: &Finding| finding.is_without_cause() && !apart.is_empty();
                for finding in &judgment.findings {
                    say(ui, &finding.sentence(), palette.strong);
                    let area = finding.area().filter(|_| !are_told_apart(finding));
                    if let Some((area, figure)) = area.zip(judgment.figure) {
                        let place = place(session, area, figure, compare.size());
                        link(ui, &place, area, outlined);
                    }
                }
                if judgment.findings.iter().any(are_told_apart) {
                    links(ui, &apart, outlined);
                }
                match places {
                    _ if !judgment.findings.is_empty() => {}
                    Some(places) if places.is_empty() => {
                        say(ui, page_figure::AGREES, palette.strong);
                    }
                    Some(places) => {
                        say(ui, page_figure::DIFFERS, palette.text);
                        links(ui, places, outlined);
                    }
                    None => {
                        let text = "No single cause explains the differences.";
                        say(ui, text, palette.text);
                        links(ui, &apart, outlined);
                        let all = all.filter(|_| apart.is_empty());
                        if let Some((area, figure)) = all.zip(judgment.figure) {
                            let place = place(session, area, figure, compare.size());
                            link(ui, &place, area, outlined);
                        }
                    }
                }
                if let Some(hint) = hints::camera(session, &judgment.findings) {
                    say(ui, hint, palette.text);
                }
            }
            _ => {
                let mut text = "Looking for the cause…".to_owned();
                if let Some(part) = compare.judged_part {
                    text += &format!(" {:.0} %", 100.0 * part);
                }
                say(ui, &text, palette.weak);
            }
        }
        for hint in hints(compare, look, counts).chain(last) {
            say(ui, hint, palette.text);
        }
    });
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

/// Places, each of which outlines its area.
fn links(ui: &mut Ui, places: &[Place], outlined: &mut Outlined) {
    for place in places {
        link(ui, &place.told, place.area, outlined);
    }
}

/// The place of a finding, which outlines its `area` in the pictures: while the pointer is over it,
/// and after a click until the next.
fn link(ui: &mut Ui, place: &str, area: Area, outlined: &mut Outlined) {
    let is_clicked = outlined.clicked == Some(area);
    let link = ui.add(Button::selectable(is_clicked, place).wrap());
    let link = link.on_hover_text("Outline it in the pictures; a click keeps the outline");
    if link.hovered() {
        outlined.hovered = Some(area);
    }
    if link.clicked() {
        outlined.clicked = (!is_clicked).then_some(area);
    }
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
