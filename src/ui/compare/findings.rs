//! What is wrong with a picture, in words, with the places that are outlined.

use super::CompareView;
use super::apart::{CameraTold, KeptPlaces, Place};
use super::hints::{self, hints};
use super::outlined::Outlined;
use super::page_figure::{self, FigureTold};
use super::panel::say;
use super::place::place;
use crate::compare::{Area, Finding, sentence};
use crate::editor::Session;
use crate::scene::Look;
use crate::ui::theme::Palette;
use egui::{Button, Ui};

/// What is said before places that have no cause.
const WHERE: &str = "The pictures differ here:";

/// What is said where nothing else is known.
const UNEXPLAINED: &str = "No single cause explains the differences.";
const OTHERS_UNEXPLAINED: &str = "No single cause explains the other differences.";

/// What is wrong, in words.
pub(super) fn findings(
    ui: &mut Ui,
    session: &Session,
    compare: &CompareView,
    outlined: &mut Outlined,
    kept: &mut KeptPlaces,
) {
    let palette = Palette::of(ui.visuals());
    let areas = compare.report.judgment.iter().flat_map(|j| &j.findings);
    let counts = compare.report.differences.as_ref();
    let all = counts.and_then(|counts| counts.differing_area);
    // What differs of the figure says more than all that does, where other lines and floors are drawn about it.
    let of_page = compare.report.page_figure.as_ref();
    let of_page = of_page.map(|figure| FigureTold::new(session, compare, figure, kept));
    let judgment = compare.report.judgment.as_ref();
    let off = judgment.and_then(|judgment| judgment.off.as_ref());
    let display = hints::other_display(session, off);
    // What a skeleton leaves of a mesh is neither moved nor missing.
    let is_sought = of_page.is_none() && display.is_none();
    let apart = judgment.filter(|_| is_sought).and_then(|judged| {
        let (off, figure) = (judged.off.as_ref()?, judged.figure?);
        Some(kept.apart(session, compare, off, figure))
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
            figure.and_then(FigureTold::hint)
        });
        let is_slanted = report
            .page_figure
            .as_ref()
            .is_some_and(|page| page.is_slanted);
        if is_slanted && look == Look::Mannequin && !report.measuring {
            return say(ui, page_figure::SLANTED, palette.strong);
        }
        let first = first.into_iter().chain(hints::other_edges(compare));
        for hint in first
            .chain(display.as_deref())
            .filter(|_| !report.measuring)
        {
            say(ui, hint, palette.strong);
        }
        match &report.judgment {
            Some(judgment) if !report.measuring => {
                let is_told = |camera| apart.iter().any(|place| place.camera == camera);
                let is_camera_right = is_told(CameraTold::Right);
                // Where another one is found, the place says so.
                let is_home = is_told(CameraTold::Home);
                let is_camera_known = is_camera_right || is_home || is_told(CameraTold::Other);
                let findings = judgment.findings.iter().cloned();
                let findings: Vec<Finding> = findings
                    .map(|finding| match is_camera_known {
                        true => finding.without_camera(),
                        false => finding,
                    })
                    .collect();
                // Of what is moved, Home tells more.
                let is_told_by_home =
                    |finding: &Finding| is_home && matches!(finding, Finding::Placed { .. });
                let are_told_apart = |finding: &Finding| {
                    (finding.is_without_cause() || is_told_by_home(finding)) && !apart.is_empty()
                };
                // Where it is comes before how many pixels it is.
                if findings.iter().any(are_told_apart) {
                    say(ui, WHERE, palette.strong);
                    links(ui, &apart, outlined);
                }
                for finding in &findings {
                    say(ui, &finding.sentence(), palette.strong);
                    let area = finding.area().filter(|_| !are_told_apart(finding));
                    if let Some((area, figure)) = area.zip(judgment.figure) {
                        let place = place(session, area, figure, compare.size());
                        link(ui, &place, area, outlined);
                    }
                }
                match places {
                    _ if !findings.iter().all(Finding::is_beside_others) => {}
                    Some(places) if places.is_empty() => {
                        say(ui, page_figure::AGREES, palette.strong);
                    }
                    Some(places) => {
                        say(ui, page_figure::DIFFERS, palette.text);
                        links(ui, places, outlined);
                    }
                    None => {
                        let text = match apart.is_empty() {
                            true if findings.is_empty() => UNEXPLAINED,
                            true => OTHERS_UNEXPLAINED,
                            false => WHERE,
                        };
                        say(ui, text, palette.text);
                        links(ui, &apart, outlined);
                        let all = all.filter(|_| apart.is_empty());
                        if let Some((area, figure)) = all.zip(judgment.figure) {
                            // What is in several places is of no single joint.
                            let place = sentence(&area.place_in(figure));
                            link(ui, &place, area, outlined);
                        }
                    }
                }
                let hint =
                    hints::camera(session, &findings).filter(|_| !is_camera_right && !is_home);
                if let Some(hint) = hint {
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

/// Places, each of which outlines its area.
fn links(ui: &mut Ui, places: &[Place], outlined: &mut Outlined) {
    for place in places {
        link(ui, &place.told, place.area, outlined);
        if let Some(instead) = &place.instead {
            say(ui, instead, ui.visuals().text_color());
        }
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
