//! The joint list of a character: folding, search, selection; its rows are in `joint_rows`.

use super::joint_columns::{Columns, MANY};
use super::joint_marks::Marks;
use super::joint_rows::RowEvent;
use super::joint_tree::{Row, reveal, row_with, rows_of};
use super::theme::Palette;
use super::widgets::{ListMove, moved, named};
use super::{Action, joint_rows};
use crate::character::SkeletalModel;
use crate::editor::{Edit, Session, View};
use crate::math::Euler;
use crate::scene::{CharacterShape, ShapeId};
use egui::{Align, Button, Key, Label, Layout, Rect, Response, RichText, TextEdit, Ui, vec2};
use std::collections::{BTreeSet, HashMap};

/// State of the joint list.
#[derive(Clone, Debug, Default)]
pub(super) struct JointListState {
    /// Whether the search field is shown.
    pub searching: bool,
    /// Whether the search field was just opened, and is to get the keyboard focus.
    pub search_opened: bool,
    /// Text in the search field.
    pub search: String,
    /// Folded joints of each character.
    pub folded: HashMap<ShapeId, BTreeSet<usize>>,
    /// The joint under the pointer in the list. One that is hovered in the view is not the list's
    /// to clear.
    pub hovered: Option<usize>,
    /// The joint whose row is to get the keyboard focus once it has been scrolled into view.
    pub focus: Option<usize>,
    /// The joint that was selected in the last frame, to notice one selected in the view.
    pub selected: Option<(ShapeId, usize)>,
}

/// The joint list: angles of all joints, and below each root its offset, as a tree that can be
/// folded and searched.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    id: ShapeId,
    state: &mut JointListState,
    actions: &mut Vec<Action>,
) {
    let Some(character) = session.scene().character(id) else {
        return;
    };
    title(ui, id, character, state, actions);
    if state.searching {
        search(ui, state);
    }

    let skeleton = character.character.skeleton();
    let selected = session.selected_joint().map(|joint| (id, joint));
    let newly_selected = selected != state.selected;
    if newly_selected && let Some((_, joint)) = selected {
        reveal(skeleton, state.folded.entry(id).or_default(), joint);
    }
    state.selected = selected;

    let folded = state.folded.entry(id).or_default();
    let searched = if state.searching { &state.search } else { "" };
    let mut rows = rows_of(skeleton, folded, searched);
    let listed = |joint| rows.iter().any(|row| row.joint == joint);
    if newly_selected && selected.is_some_and(|(_, joint)| !listed(joint)) {
        // Selected in the view, and hidden by the search.
        state.searching = false;
        state.search.clear();
        rows = rows_of(skeleton, folded, "");
    }
    if rows.is_empty() {
        ui.label(RichText::new("No joint has this in its name.").weak());
    }
    let columns = Columns::new(ui, skeleton, &rows);
    joint_rows::show_header(ui, &columns);

    let shown = show_rows(ui, session, character, &rows, &columns);
    // A joint that is only under the pointer is lit: rows that moved by themselves would be missed. All of them are
    // everywhere.
    let are_all = session.selected_joints().len() == skeleton.joints().len();
    let wanted = selected.filter(|_| newly_selected && !are_all);
    if let Some(row) = wanted.and_then(|(_, joint)| row_with(skeleton, &rows, joint)) {
        scroll_to(ui, shown.places[row]);
    }
    if let Some(name) = state.focus.and_then(|joint| shown.names.get(&joint)) {
        name.request_focus();
        state.focus = None;
    }
    if shown.hovered != state.hovered {
        state.hovered = shown.hovered;
        actions.push(Action::View(View::HoverJoint(shown.hovered)));
    }
    let turned = turned_by_number(&shown.events);
    let is_selected = |joint: usize| session.selected_joints().contains(&joint);
    if let Some(joint) = turned.filter(|&joint| !is_selected(joint)) {
        select(joint, actions);
        // Its row is in sight already, and stays where the hand is.
        state.selected = Some((id, joint));
    }
    let adds = ui.input(|input| input.modifiers.shift || input.modifiers.command);
    for (row, event) in shown.events {
        match event {
            RowEvent::Fold => toggle(state, id, row.joint),
            RowEvent::Select if adds => {
                actions.push(Action::View(View::ToggleJoint(row.joint)));
            }
            RowEvent::Select => select(row.joint, actions),
            RowEvent::Turn(axis, degrees) => {
                let angle = |joint: usize| character.pose().rotation(joint).radians[axis];
                let by = degrees.to_radians() - angle(row.joint);
                let turned = |joint| Edit::SetJointAngle {
                    shape: id,
                    joint,
                    axis,
                    // The one that was given is exact.
                    radians: match joint == row.joint {
                        true => degrees.to_radians(),
                        false => angle(joint) + by,
                    },
                };
                actions.push(for_selected_joints(session, row.joint, turned));
            }
            RowEvent::Reset => {
                let reset = |joint| Edit::SetJointTransform {
                    shape: id,
                    joint,
                    rotation: Euler::ZERO,
                };
                actions.push(for_selected_joints(session, row.joint, reset));
            }
            RowEvent::Offset(offset) => actions.push(Action::Edit(Edit::SetRootOffset {
                shape: id,
                root: row.joint,
                offset,
            })),
            RowEvent::Move(movement) => {
                let to = goal(skeleton, &rows, row, movement, state, id);
                if let Some((to, row)) = to.and_then(|to| Some((to, rows.get(to)?))) {
                    ui.scroll_to_rect(shown.places[to], None);
                    state.focus = Some(row.joint);
                    select(row.joint, actions);
                }
            }
        }
    }
}

/// What is done to `joint`, and to the other selected ones if it is among them.
fn for_selected_joints(session: &Session, joint: usize, edit: impl Fn(usize) -> Edit) -> Action {
    let selected = session.selected_joints();
    if !selected.contains(&joint) {
        return Action::Edit(edit(joint));
    }
    Action::Edit(Edit::Together(selected.iter().copied().map(edit).collect()))
}

/// Rows as they were shown, with what was done in them.
#[derive(Default)]
struct Rows {
    hovered: Option<usize>,
    events: Vec<(Row, RowEvent)>,
    /// Rectangle of each row, with that of its offset, as many as there are rows.
    places: Vec<Rect>,
    /// Widgets of the names that were shown, by joint: only these may get the keyboard focus.
    names: HashMap<usize, Response>,
}

fn show_rows(
    ui: &mut Ui,
    session: &Session,
    character: &CharacterShape,
    rows: &[Row],
    columns: &Columns,
) -> Rows {
    let skeleton = character.character.skeleton();
    let marks = Marks::new(session, character, rows);
    let mut all = Rows::default();
    for row in rows {
        let place = columns.place(ui);
        let is_root = skeleton.joints()[row.joint].parent.is_none();
        let below = is_root.then(|| columns.place(ui));
        let both = place.union(below.unwrap_or(place));
        all.places.push(both);
        if rows.len() > MANY && !ui.is_rect_visible(both) {
            continue;
        }
        let look = marks.look(row);
        let shown =
            joint_rows::show_joint(ui, skeleton, character.pose(), row, place, look, columns);
        if shown.hovered {
            all.hovered = Some(row.joint);
        }
        all.names.insert(row.joint, shown.name);
        all.events.extend(shown.event.map(|event| (*row, event)));
        if let Some(below) = below {
            let shown =
                joint_rows::show_offset(ui, skeleton, character.pose(), row, below, columns);
            if shown.hovered {
                all.hovered = Some(row.joint);
            }
            all.events.extend(shown.event.map(|event| (*row, event)));
        }
    }
    all
}

/// The joint of which a number was changed: what shows the selected joint is about it from then on.
fn turned_by_number(events: &[(Row, RowEvent)]) -> Option<usize> {
    let is_number = |event: &RowEvent| matches!(event, RowEvent::Turn(..) | RowEvent::Offset(_));
    let turned = events.iter().find(|(_, event)| is_number(event));
    turned.map(|(row, _)| row.joint)
}

/// Scrolls a row into view, clear of the edge where the panel fades out. A row that is clicked in
/// the list stays under the pointer.
fn scroll_to(ui: &Ui, row: Rect) {
    let fade = if ui.rect_contains_pointer(row) {
        0.0
    } else {
        ui.spacing().scroll.fade.size
    };
    ui.scroll_to_rect(row.expand2(vec2(0.0, fade)), None);
}

fn select(joint: usize, actions: &mut Vec<Action>) {
    actions.push(Action::View(View::SelectJoint(Some(joint))));
}

fn toggle(state: &mut JointListState, id: ShapeId, joint: usize) {
    let folded = state.folded.entry(id).or_default();
    if !folded.remove(&joint) {
        folded.insert(joint);
    }
}

/// Index of the row that a key leads to from `at`. As in other trees, ← folds or goes to the parent
/// and → unfolds or goes to the first child.
fn goal(
    skeleton: &SkeletalModel,
    rows: &[Row],
    at: Row,
    movement: ListMove,
    state: &mut JointListState,
    id: ShapeId,
) -> Option<usize> {
    let place = |joint: usize| rows.iter().position(|row| row.joint == joint);
    match (movement, at.folded) {
        (ListMove::Left, Some(false)) | (ListMove::Right, Some(true)) => {
            toggle(state, id, at.joint);
            None
        }
        (ListMove::Left, _) => skeleton.joints()[at.joint].parent.and_then(place),
        (ListMove::Right, _) => skeleton.children(at.joint).first().copied().and_then(place),
        _ => moved(movement, place(at.joint)?, rows.len()),
    }
}

/// Title of the list, with buttons to search it and to reset it.
fn title(
    ui: &mut Ui,
    id: ShapeId,
    character: &CharacterShape,
    state: &mut JointListState,
    actions: &mut Vec<Action>,
) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        let changed = !character.is_at_rest();
        let reset = ui
            .add_enabled(changed, Button::new("Reset all"))
            .on_hover_text("Put every joint of this character back to rest")
            .on_disabled_hover_text("Every joint is at rest");
        if reset.clicked() {
            actions.push(Action::Edit(Edit::ResetPose(id)));
        }
        let find = Button::selectable(state.searching, "🔍").frame_when_inactive(true);
        let find = named(ui.add(find), "Find joints");
        if find
            .on_hover_text("Show only joints with a word in their name")
            .clicked()
        {
            state.searching = !state.searching;
            state.search.clear();
            state.search_opened = state.searching;
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let color = Palette::of(ui.visuals()).strong;
            let text = RichText::new("Joint Rotations (x, y, z)").color(color);
            ui.add(Label::new(text).truncate());
        });
    });
}

fn search(ui: &mut Ui, state: &mut JointListState) {
    let color = Palette::of(ui.visuals()).weak;
    let edit = TextEdit::singleline(&mut state.search)
        .hint_text(RichText::new("Part of a name").color(color))
        .margin(vec2(6.0, 2.0))
        .desired_width(f32::INFINITY);
    let edit = named(ui.add(edit), "Search joints");
    if std::mem::take(&mut state.search_opened) {
        edit.request_focus();
    }
    if edit.lost_focus() && ui.input(|input| input.key_pressed(Key::Escape)) {
        state.searching = false;
        state.search.clear();
    }
}
