//! The joint list of a character: folding, search, selection; its rows are in `joint_rows`.

use super::joint_columns::{Columns, MANY};
use super::joint_rows::{Look, RowEvent};
use super::theme::Palette;
use super::widgets::{ListMove, moved, named};
use super::{Action, joint_rows};
use crate::character::{Pose, SkeletalModel};
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
    /// The joint that was under the pointer in the view in the last frame.
    pub hovered_in_view: Option<usize>,
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
    let hovered_in_view = session.hovered_joint().filter(|_| state.hovered.is_none());
    let newly_hovered = hovered_in_view.filter(|_| hovered_in_view != state.hovered_in_view);
    state.hovered_in_view = hovered_in_view;

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
    let wanted = match selected {
        Some((_, joint)) if newly_selected => Some(joint),
        _ => newly_hovered.filter(|_| shown.is_in_sight(ui)),
    };
    if let Some(row) = wanted.and_then(|joint| row_with(skeleton, &rows, joint)) {
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

impl Rows {
    /// Whether any row can be seen, or could without scrolling far: the user works with the list.
    fn is_in_sight(&self, ui: &Ui) -> bool {
        self.places.iter().any(|&place| ui.is_rect_visible(place))
    }
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
            let event = shown.offset.map(RowEvent::Offset);
            all.events.extend(event.map(|event| (*row, event)));
        }
    }
    all
}

/// Joints of a character that are marked in the list.
struct Marks<'a> {
    skeleton: &'a SkeletalModel,
    pose: &'a Pose,
    selected: Option<usize>,
    hovered: Option<usize>,
    /// Row that the selected joint is folded away in, with that joint; the same of the hovered one.
    folded_away: [Option<(usize, usize)>; 2],
    /// Joints above one that is not at rest.
    above_changed: BTreeSet<usize>,
}

impl<'a> Marks<'a> {
    fn new(session: &Session, character: &'a CharacterShape, rows: &[Row]) -> Self {
        let (skeleton, pose) = (character.character.skeleton(), character.pose());
        let (selected, hovered) = (session.selected_joint(), session.hovered_joint());
        let folded_away = [selected, hovered].map(|joint| {
            let joint = joint?;
            let row = rows.get(row_with(skeleton, rows, joint)?)?;
            (row.joint != joint).then_some((row.joint, joint))
        });
        let mut above_changed = BTreeSet::new();
        for joint in (0..skeleton.joints().len()).filter(|&joint| pose.is_changed(joint)) {
            let mut above = parent_of(skeleton, joint);
            while let Some(joint) = above.filter(|&joint| above_changed.insert(joint)) {
                above = parent_of(skeleton, joint);
            }
        }
        Self {
            skeleton,
            pose,
            selected,
            hovered,
            folded_away,
            above_changed,
        }
    }

    fn look(&self, row: &Row) -> Look<'a> {
        let is_folded = row.folded == Some(true);
        let inside = self.folded_away.iter().flatten();
        let inside = inside.clone().find(|&&(at, _)| at == row.joint);
        let joint = inside.and_then(|&(_, joint)| self.skeleton.joints().get(joint));
        Look {
            selected: self.selected == Some(row.joint),
            hovered: self.hovered == Some(row.joint),
            changed: self.pose.is_changed(row.joint)
                || is_folded && self.above_changed.contains(&row.joint),
            inside: joint.map(|joint| joint.name.as_str()),
        }
    }
}

fn parent_of(skeleton: &SkeletalModel, joint: usize) -> Option<usize> {
    skeleton.joints().get(joint).and_then(|joint| joint.parent)
}

/// Index of the row of `joint`, or of the nearest above it that is listed.
fn row_with(skeleton: &SkeletalModel, rows: &[Row], joint: usize) -> Option<usize> {
    let row_of = |joint: usize| rows.iter().position(|row| row.joint == joint);
    let mut at = Some(joint);
    while let Some(joint) = at {
        if let Some(row) = row_of(joint) {
            return Some(row);
        }
        at = parent_of(skeleton, joint);
    }
    None
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

/// One row of the joint list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Row {
    /// Index of the joint.
    pub joint: usize,
    /// Number of ancestors shown above it.
    pub depth: usize,
    /// Whether it is folded; `None` if it has no children to fold.
    pub folded: Option<bool>,
}

/// Rows in tree order, without the descendants of folded joints; while `search` is not empty, all
/// joints whose name contains it, in file order.
fn rows_of(skeleton: &SkeletalModel, folded: &BTreeSet<usize>, search: &str) -> Vec<Row> {
    let search = search.trim().to_lowercase();
    if !search.is_empty() {
        return found(skeleton, &search);
    }
    let mut rows = Vec::with_capacity(skeleton.joints().len());
    let start = skeleton.roots().iter().rev();
    let mut open: Vec<(usize, usize)> = start.map(|&root| (root, 0)).collect();
    while let Some((joint, depth)) = open.pop() {
        let children = skeleton.children(joint);
        let is_folded = folded.contains(&joint);
        rows.push(Row {
            joint,
            depth,
            folded: (!children.is_empty()).then_some(is_folded),
        });
        if !is_folded {
            open.extend(children.iter().rev().map(|&child| (child, depth + 1)));
        }
    }
    rows
}

fn found(skeleton: &SkeletalModel, search: &str) -> Vec<Row> {
    let matches = |name: &str| name.to_lowercase().contains(search);
    skeleton
        .joints()
        .iter()
        .enumerate()
        .filter(|(_, joint)| matches(&joint.name))
        .map(|(joint, _)| Row {
            joint,
            depth: 0,
            folded: None,
        })
        .collect()
}

/// Unfolds all ancestors of `joint`, so that its row is shown.
fn reveal(skeleton: &SkeletalModel, folded: &mut BTreeSet<usize>, joint: usize) {
    let mut above = parent_of(skeleton, joint);
    while let Some(joint) = above {
        folded.remove(&joint);
        above = parent_of(skeleton, joint);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;
    use glam::Vec3;

    /// 0 → {1 → 3, 2}, and a second root 4.
    fn skeleton() -> SkeletalModel {
        let parents = [None, Some(0), Some(0), Some(1), None];
        let names = ["Root", "Left hip", "Right hip", "Left knee", "Prop"];
        let joints = parents.iter().zip(names).map(|(&parent, name)| Joint {
            name: name.to_owned(),
            parent,
            offset: Vec3::Y,
            ..Joint::default()
        });
        SkeletalModel::new(joints.collect()).expect("a tree")
    }

    fn joints(rows: &[Row]) -> Vec<usize> {
        rows.iter().map(|row| row.joint).collect()
    }

    #[test]
    fn children_stand_below_their_parent_one_step_further_in() {
        let rows = rows_of(&skeleton(), &BTreeSet::new(), "");
        assert_eq!(joints(&rows), [0, 1, 3, 2, 4]);
        let depths: Vec<usize> = rows.iter().map(|row| row.depth).collect();
        assert_eq!(depths, [0, 1, 2, 1, 0]);
        assert_eq!(rows[1].folded, Some(false));
        assert_eq!(rows[2].folded, None);
    }

    #[test]
    fn a_folded_joint_hides_what_is_below_it_until_that_is_revealed() {
        let mut folded = BTreeSet::from([0, 1]);
        assert_eq!(joints(&rows_of(&skeleton(), &folded, "")), [0, 4]);
        reveal(&skeleton(), &mut folded, 3);
        assert_eq!(joints(&rows_of(&skeleton(), &folded, "")), [0, 1, 3, 2, 4]);
    }

    #[test]
    fn a_search_finds_folded_joints_too_whatever_the_case() {
        let folded = BTreeSet::from([0]);
        assert_eq!(joints(&rows_of(&skeleton(), &folded, " LEFT ")), [1, 3]);
        assert!(rows_of(&skeleton(), &folded, "tail").is_empty());
    }
}
