use super::joint_row::{self, Columns, RowEvent};
use super::joint_tree::{self, Row};
use super::state::JointListState;
use super::theme::Palette;
use super::widgets::{ListMove, moved, named};
use crate::character::{Pose, SkeletalModel};
use crate::editor::{Action, Edit, Session, View};
use crate::math::Euler;
use crate::scene::{CharacterShape, ShapeId};
use egui::{Align, Button, Label, Layout, RichText, TextEdit, Ui, vec2};

/// The angles of all joints, as a tree that folds and can be searched.
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

    let searched = if state.searching { &state.search } else { "" };
    let folded = state.folded.entry(id).or_default();
    let rows = joint_tree::rows(skeleton, folded, searched);
    if rows.is_empty() {
        ui.label(RichText::new("No joint has this in its name.").weak());
    }
    let columns = Columns::new(ui, skeleton, &rows);
    joint_row::header(ui, &columns);

    let mut hovered = None;
    let mut events = Vec::new();
    let mut names = Vec::with_capacity(rows.len());
    for row in &rows {
        let is_selected = session.selected_joint() == Some(row.joint);
        let look = joint_row::Look {
            selected: is_selected,
            hovered: session.hovered_joint() == Some(row.joint),
        };
        let shown = joint_row::show(ui, skeleton, character.pose(), row, look, &columns);
        if is_selected && newly_selected {
            shown.name.scroll_to_me(None);
        }
        if shown.hovered {
            hovered = Some(row.joint);
        }
        events.extend(shown.event.map(|event| (*row, event)));
        names.push(shown.name);
    }
    if hovered != state.hovered {
        state.hovered = hovered;
        actions.push(Action::View(View::HoverJoint(hovered)));
    }
    for (row, event) in events {
        match event {
            RowEvent::Fold => toggle(state, id, row.joint),
            RowEvent::Select => select(Some(row.joint), actions),
            RowEvent::Turn(degrees) => actions.push(Action::Edit(Edit::SetJointTransform {
                shape: id,
                joint: row.joint,
                rotation: Euler::from_degrees(degrees),
            })),
            RowEvent::Reset => actions.push(Action::Edit(Edit::ResetJoint(id, row.joint))),
            RowEvent::Move(movement) => {
                if let Some(to) = goal(skeleton, &rows, row, movement, state, id) {
                    if let Some(name) = names.get(to) {
                        name.request_focus();
                        name.scroll_to_me(None);
                    }
                    select(rows.get(to).map(|row| row.joint), actions);
                }
            }
        }
    }
}

fn select(joint: Option<usize>, actions: &mut Vec<Action>) {
    actions.push(Action::View(View::SelectJoint(joint)));
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
}
