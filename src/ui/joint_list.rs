use super::joint_columns::{Columns, MANY};
use super::joint_row::{self, RowEvent};
use super::joint_tree::{self, Row};
use super::root_row;
use super::state::JointListState;
use super::theme::Palette;
use super::widgets::{ListMove, moved, named};
use crate::character::{Pose, SkeletalModel};
use crate::editor::{Edit, Session, View};
use crate::math::Euler;
use crate::scene::{CharacterShape, ShapeId};
use crate::ui::Action;
use egui::{Align, Button, Key, Label, Layout, Rect, Response, RichText, TextEdit, Ui, vec2};
use std::collections::HashMap;

/// The angles of all joints, and below each root how far it has moved, as a tree that folds and can
/// be searched.
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
        joint_tree::reveal(skeleton, state.folded.entry(id).or_default(), joint);
    }
    state.selected = selected;

    let folded = state.folded.entry(id).or_default();
    let searched = if state.searching { &state.search } else { "" };
    let mut rows = joint_tree::rows(skeleton, folded, searched);
    let listed = |joint| rows.iter().any(|row| row.joint == joint);
    if newly_selected && selected.is_some_and(|(_, joint)| !listed(joint)) {
        // Selected in the view, and not what was searched for.
        state.searching = false;
        state.search.clear();
        rows = joint_tree::rows(skeleton, folded, "");
    }
    if rows.is_empty() {
        ui.label(RichText::new("No joint has this in its name.").weak());
    }
    let columns = Columns::new(ui, skeleton, &rows);
    joint_row::header(ui, &columns);

    let shown = show_rows(ui, session, character, &rows, &columns, newly_selected);
    if let Some(name) = state.focus.and_then(|joint| shown.names.get(&joint)) {
        name.request_focus();
        state.focus = None;
    }
    if shown.hovered != state.hovered {
        state.hovered = shown.hovered;
        actions.push(Action::View(View::HoverJoint(shown.hovered)));
    }
    for (row, event) in shown.events {
        match event {
            RowEvent::Fold => toggle(state, id, row.joint),
            RowEvent::Select => select(row.joint, actions),
            RowEvent::Turn(axis, degrees) => actions.push(Action::Edit(Edit::SetJointAngle {
                shape: id,
                joint: row.joint,
                axis,
                radians: degrees.to_radians(),
            })),
            RowEvent::Reset => actions.push(Action::Edit(Edit::SetJointTransform {
                shape: id,
                joint: row.joint,
                rotation: Euler::ZERO,
            })),
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

/// What came of showing all rows.
#[derive(Default)]
struct Rows {
    hovered: Option<usize>,
    events: Vec<(Row, RowEvent)>,
    /// Where each row is, as many as there are rows.
    places: Vec<Rect>,
    /// The names shown to egui, by joint: only those may be given the keyboard.
    names: HashMap<usize, Response>,
}

fn show_rows(
    ui: &mut Ui,
    session: &Session,
    character: &CharacterShape,
    rows: &[Row],
    columns: &Columns,
    scroll_to_selected: bool,
) -> Rows {
    let skeleton = character.character.skeleton();
    let mut all = Rows::default();
    for row in rows {
        let place = columns.place(ui);
        all.places.push(place);
        let selected = session.selected_joint() == Some(row.joint);
        let is_root = skeleton.joints()[row.joint].parent.is_none();
        let below = is_root.then(|| columns.place(ui));
        let both = place.union(below.unwrap_or(place));
        if selected && scroll_to_selected {
            scroll_to(ui, both);
        }
        if rows.len() > MANY && !ui.is_rect_visible(both) {
            continue;
        }
        let look = joint_row::Look {
            selected,
            hovered: session.hovered_joint() == Some(row.joint),
        };
        let shown = joint_row::show(ui, skeleton, character.pose(), row, place, look, columns);
        if shown.hovered {
            all.hovered = Some(row.joint);
        }
        all.names.insert(row.joint, shown.name);
        all.events.extend(shown.event.map(|event| (*row, event)));
        if let Some(below) = below {
            let shown = root_row::show(ui, skeleton, character.pose(), row, below, columns);
            if shown.hovered {
                all.hovered = Some(row.joint);
            }
            let event = shown.offset.map(RowEvent::Offset);
            all.events.extend(event.map(|event| (*row, event)));
        }
    }
    all
}

/// Scrolls to a row so that it is clear of where the panel fades out; what is clicked in the list
/// itself stays under the pointer.
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

/// The row that a key leads to from `at`. As in other trees, ← folds or goes to the parent and
/// → unfolds or goes to the first child.
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

/// The list's title with the buttons that search it and reset it.
fn title(
    ui: &mut Ui,
    id: ShapeId,
    character: &CharacterShape,
    state: &mut JointListState,
    actions: &mut Vec<Action>,
) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        let changed = !character.pose().is_bind();
        let reset = ui
            .add_enabled(changed, Button::new("Reset all"))
            .on_hover_text("Put every joint of this character back to rest")
            .on_disabled_hover_text("Every joint is at rest");
        if reset.clicked() {
            actions.push(Action::Edit(Edit::SetPose(id, Pose::new())));
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
