//! The list of mistakes, each of which can be made by a click.

use super::shown::{Made, capitalized};
use crate::character::Character;
use crate::diagnose::{MISTAKES, Mistake, ToldFor, ToldMistake};
use crate::scene::{Shape, ShapeKind};
use crate::ui::CompareMeshView;
use crate::ui::theme::Palette;
use crate::ui::widgets::{named, section};
use egui::{Button, Label, RichText, Ui};
use std::collections::BTreeSet;

/// Shows the list by the sections of the assignment, the section of the formula first, below what was found
/// in the mesh that is compared with `character`. A click makes a mistake, another ends it.
pub(super) fn show(
    ui: &mut Ui,
    compare: Option<&CompareMeshView>,
    character: Option<&Shape>,
    made: &mut Option<Made>,
) {
    let program = ToldFor::of_file(character.and_then(Shape::source_file));
    let skinned = character.and_then(|shape| match &shape.kind {
        ShapeKind::Character(shape) => Some(&*shape.character),
        _ => None,
    });
    let character = character.map(|shape| shape.id);
    section(ui, "Make this mistake");
    let weak = Palette::of(ui.visuals()).weak;
    let hint = match compare {
        Some(_) => "Making one ends the comparison, in which the character is shown as it is.",
        None => "The view shows what comes of it. Nothing in the document changes.",
    };
    ui.add(Label::new(RichText::new(hint).small().color(weak)).wrap());
    if let Some(compare) = compare.filter(|compare| Some(compare.shape) == character) {
        found(ui, compare, program, made);
    }
    let mut sections: Vec<&str> = MISTAKES.iter().map(|mistake| mistake.section).collect();
    let mut known = BTreeSet::new();
    sections.retain(|section| known.insert(*section));
    for section in sections {
        ui.add_space(4.0);
        let mistakes = MISTAKES.iter().filter(|mistake| mistake.section == section);
        for (index, mistake) in mistakes.enumerate() {
            let told = mistake.told_for(program);
            if index == 0 {
                ui.label(RichText::new(told.section).small().color(weak));
            }
            row(ui, (mistake, &told), skinned, made);
        }
    }
}

/// What was found in the compared mesh, each mistake in the way in which it was made there.
fn found(ui: &mut Ui, compare: &CompareMeshView, program: ToldFor, made: &mut Option<Made>) {
    let Some(Ok(diagnosis)) = compare.diagnosis else {
        return;
    };
    let mut all = diagnosis.mistakes.iter().filter_map(Made::told).peekable();
    if all.peek().is_none() {
        return;
    }
    ui.add_space(4.0);
    let weak = Palette::of(ui.visuals()).weak;
    let title = format!("Found in {}:", compare.name);
    ui.add(Label::new(RichText::new(title).small().color(weak)).truncate());
    for own in all {
        let button = Button::selectable(false, own.sentence(program))
            .wrap()
            .min_size(egui::vec2(ui.available_width(), 0.0));
        let tip = "End the comparison, and make it in this way";
        if ui.add(button).on_hover_text(tip).clicked() {
            *made = Some(own);
        }
    }
}

/// A mistake with its ways that there are for the character `skinned`.
fn row(
    ui: &mut Ui,
    (mistake, told): (&'static Mistake, &ToldMistake),
    skinned: Option<&Character>,
    made: &mut Option<Made>,
) {
    let is_made = made.is_some_and(|made| std::ptr::eq(made.mistake, mistake));
    let sentence = capitalized(told.meaning);
    let button = Button::selectable(is_made, &sentence)
        .wrap()
        .min_size(egui::vec2(ui.available_width(), 0.0));
    let button = named(ui.add(button), &sentence);
    let clicked = button
        .on_hover_text(format!("{}: {}", mistake.id, told.look_at))
        .clicked();
    if clicked {
        let first = mistake.readings.first();
        *made = first
            .filter(|_| !is_made)
            .map(|reading| Made { mistake, reading });
    }
    if !is_made {
        return;
    }
    ui.indent(mistake.id, |ui| {
        // What is special about the usual way may need no words.
        let several = mistake.readings.iter().filter(|it| !it.how.is_empty());
        for reading in several {
            let own = Made { mistake, reading };
            if skinned.is_some_and(|skinned| !own.formula().is_of(skinned)) {
                continue;
            }
            let button = Button::selectable(*made == Some(own), RichText::new(reading.how).small());
            if ui.add(button.wrap()).clicked() {
                *made = Some(own);
            }
        }
        let weak = Palette::of(ui.visuals()).weak;
        let look_at = format!("In the code: {}.", told.look_at);
        ui.add(Label::new(RichText::new(look_at).small().color(weak)).wrap());
    });
}
