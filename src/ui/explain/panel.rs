//! The panel below the view.

use super::digits::Digits;
use super::table::Compared;
use super::vertex::Told;
use super::{ExplainState, Topic, letters, mistakes, stack, table, words};
use crate::editor::Session;
use crate::scene::SkinningMethod;
use crate::ui::below_view::{Heights, below_the_view, has_room_for_columns};
use crate::ui::number_field::NumberField;
use crate::ui::pointing::Pointing;
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use crate::ui::{Action, Ask, CompareMeshAction, CompareMeshView};
use egui::{Align, Button, Id, Label, Layout, RichText, ScrollArea, Ui, UiBuilder, vec2};

const HEIGHTS: Heights = Heights {
    lowest: 96.0,
    alone: 280.0,
    beside: 0.29,
};
/// Width of the list of mistakes beside the formula, in points: a row of the formula needs more.
const MISTAKES: f32 = 280.0;
/// Size of the formula's letters, in points, and of those of its parts.
const LETTERS: f32 = 15.0;
const SMALLER: f32 = 12.5;

const FOLLOWS: &str =
    "Drag a joint's numbers at the right, or its bone with the Pose tool, and watch these change.";

const FOLLOWS_SELECTED: &str =
    "Select the character, drag a joint's numbers at the right, and watch these change.";

/// Shows the panel below the view while it is open.
pub(in crate::ui) fn show(
    root: &mut Ui,
    session: &Session,
    compare: Option<&CompareMeshView>,
    state: &mut ExplainState,
    actions: &mut Vec<Action>,
) {
    if !state.is_open {
        return;
    }
    let before = state.made;
    below_the_view(root, ("explain", state.compares), HEIGHTS, |ui| {
        header(ui, session, state);
        ui.separator();
        state.update(session);
        match state.topic {
            Topic::Formula => formula(ui, session, compare, state),
            Topic::Stack => steps(ui, session, state),
        }
    });
    if compare.is_some() && state.made != before {
        let close = Ask::CompareMesh(CompareMeshAction::Close);
        actions.push(Action::Ask(close));
    }
}

fn header(ui: &mut Ui, session: &Session, state: &mut ExplainState) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        let close = named(ui.add(Button::new("×")), "Close Explain");
        if close
            .on_hover_text("Close it, and end a mistake (Esc)")
            .clicked()
        {
            state.set_open(false);
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            for (topic, label, tip) in [
                (
                    Topic::Formula,
                    "Formula",
                    "The formula at work on a vertex, and mistakes in it",
                ),
                (
                    Topic::Stack,
                    "Matrix Stack",
                    "The way over the joints, push by push",
                ),
            ] {
                let button = ui.selectable_label(state.topic == topic, label);
                if button.on_hover_text(tip).clicked() {
                    state.topic = topic;
                }
            }
            let name = state.character.and_then(|id| session.scene().shape(id));
            if let Some(shape) = name {
                let color = Palette::of(ui.visuals()).weak;
                let whose = RichText::new(format!("of {}", shape.name));
                ui.add(Label::new(whose.small().color(color)).truncate());
            }
        });
    });
}

const NOBODY: &str = "There is no character to explain. Insert one.";

fn formula(
    ui: &mut Ui,
    session: &Session,
    compare: Option<&CompareMeshView>,
    state: &mut ExplainState,
) {
    if state.explained(session).is_none() {
        ui.label(NOBODY);
        return;
    }
    let character = state.character.and_then(|id| session.scene().shape(id));
    if !has_room_for_columns(ui) {
        ScrollArea::vertical()
            .id_salt(("formula", state.picks))
            .auto_shrink(false)
            .show(ui, |ui| {
                numbers(ui, session, compare, state);
                ui.separator();
                mistakes::show(ui, compare, character, &mut state.made);
            });
        return;
    }
    let room = ui.available_rect_before_wrap();
    let (left, right) = room.split_left_right_at_x(room.right() - MISTAKES);
    let right = right.with_min_x(right.left() + 16.0);
    let area = |id: Id| ScrollArea::vertical().id_salt(id).auto_shrink(false);
    ui.scope_builder(UiBuilder::new().max_rect(left), |ui| {
        ui.shrink_clip_rect(left);
        area(Id::new(("formula", state.picks))).show(ui, |ui| numbers(ui, session, compare, state));
    });
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| {
        area(Id::new("mistakes")).show(ui, |ui| {
            mistakes::show(ui, compare, character, &mut state.made)
        });
    });
}

/// The formula in letters, and below it in numbers.
fn numbers(
    ui: &mut Ui,
    session: &Session,
    compare: Option<&CompareMeshView>,
    state: &mut ExplainState,
) {
    state.hovered = None;
    let (Some(explained), Some(told)) = (state.explained(session), state.told.take()) else {
        return;
    };
    in_letters(ui, &told);
    let of_file = letters::of_file(&told.formula);
    if !of_file.is_empty() {
        weak(ui, &of_file);
    }
    if explained.shape.skinning_method() != SkinningMethod::LinearBlend {
        let hint = "The character is skinned with dual quaternions; this is linear blending.";
        let color = Palette::of(ui.visuals()).warning;
        ui.add(Label::new(RichText::new(hint).small().color(color)).wrap());
    }
    ui.add_space(2.0);
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        ui.label("Vertex");
        let index = told.vertex.vertex as f32;
        let last = told.count.saturating_sub(1);
        let field = NumberField::new("Vertex", index, 1.0)
            .decimals(0..=0)
            .range(0.0..=last as f64);
        chosen = field.show(ui, vec2(72.0, ui.spacing().interact_size.y));
        let [rest, posed] =
            [told.vertex.rest, told.vertex.sum].map(|point| table::point(point, told.digits));
        ui.label(format!("at rest v = {rest}, posed v' = {posed}"));
        if let Some(note) = told.digits.note() {
            ui.label(note);
        }
        if compare.is_none() {
            // Beside a comparison the lines are few.
            let next = Pointing::of(ui.ctx()).words(
                "Click another on the mesh, or a row for its matrices.",
                "Tap another on the mesh, or a row for its matrices.",
            );
            weak(ui, next);
        }
    });
    let compared = compare.filter(|compare| compare.shape == explained.id);
    let compared = compared.and_then(|compare| compared_vertex(compare, told.vertex.vertex));
    let hovered = table::show(ui, &explained, &told, compared, &mut state.unfolded);
    if !state.was_posed {
        ui.add_space(4.0);
        let is_selected = session.selected() == Some(explained.id);
        weak(
            ui,
            if is_selected {
                FOLLOWS
            } else {
                FOLLOWS_SELECTED
            },
        );
    }
    let character = explained.id;
    state.hovered = hovered;
    state.told = Some(told);
    if let Some(vertex) = chosen {
        state.choose(character, vertex as usize);
    }
}

/// The formula in letters.
fn in_letters(ui: &mut Ui, told: &Told) {
    let [vertex, current, bind] = words::lines(&told.formula);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 24.0;
        let color = Palette::of(ui.visuals()).text;
        for (line, size) in [(vertex, LETTERS), (current, SMALLER), (bind, SMALLER)] {
            let label = ui.add(Label::new(line.laid_out(ui, size, color)).wrap());
            named(label, &line.spoken());
        }
    });
}

/// A hint that stands back.
fn weak(ui: &mut Ui, hint: &str) {
    let color = Palette::of(ui.visuals()).weak;
    ui.add(Label::new(RichText::new(hint).small().color(color)).wrap());
}

/// The vertex in the compared mesh, if its vertices are numbered as the character's are.
fn compared_vertex<'a>(compare: &CompareMeshView<'a>, vertex: usize) -> Option<Compared<'a>> {
    compare.measure?;
    Some(Compared {
        name: compare.name,
        at: compare.theirs.get(vertex)?.as_dvec3(),
    })
}

fn steps(ui: &mut Ui, session: &Session, state: &mut ExplainState) {
    let told = state.told.as_ref();
    let digits = told.map_or(Digits::of_size(0.0), |told| told.digits);
    let Some(explained) = state.explained(session) else {
        ui.label(NOBODY);
        return;
    };
    if let Some(note) = digits.note() {
        ui.label(note);
    }
    if state.made.is_some() {
        weak(
            ui,
            "These are the right matrices; what the mistake changes is in the formula.",
        );
    }
    stack::show(ui, &explained, &mut state.stepper, digits);
}
