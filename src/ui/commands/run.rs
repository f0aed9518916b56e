//! What commands do.

use super::enabled::why_disabled;
use super::hiding::{hide_others, others, show_all, toggle};
use super::pose_commands::{
    copied_pose, fitted_to_joints, pasted_onto, pose_action, posed_character,
};
use super::put_back::put_back;
use super::sweep::{revolution, sweep};
use super::table::label;
use super::{Command, Entry, Primitive};
use crate::editor::{
    BoxMode, Edit, GizmoAxes, Session, Tool, View, duplicates, duplicates_in_place,
    for_all_selected, set_beside_others,
};
use crate::geometry::Curve;
use crate::scene::{
    Camera, CharacterShape, CurveSet, Evaluated, FitArea, Look, NewShape, Shape, ShapeId, ShapeKind,
};
use crate::ui::command_search::CommandSearch;
use crate::ui::shape_list::Renaming;
use crate::ui::state::UiState;
use crate::ui::windows::Dialog;
use crate::ui::{
    Action, Ask, CompareAction, CompareMeshAction, GestureStep, HistoryMove, Navigation,
    control_points, posing, view_overlay,
};
use std::ops::Range;
use std::sync::Arc;

/// Runs a command: changes of `state` at once, all else as the actions that it returns. `aspect` is
/// the width of the view over its height.
pub(in crate::ui) fn run(
    command: Command,
    session: &Session,
    state: &mut UiState,
    aspect: f32,
) -> Vec<Action> {
    let action = action(command, session, state, aspect);
    match command {
        Command::ResetViewAndPose => {
            let shapes = session.scene().shapes().iter();
            let back = shapes.flat_map(|shape| to_start(session, shape));
            let all = Action::Edit(Edit::Together(back.collect()));
            std::iter::once(all).chain(action).collect()
        }
        Command::MakeSweep => sweep(session).unwrap_or_default(),
        Command::ShowAll => {
            let poses = posing::posed(session, state.pose.tool).is_some();
            show_all(session, poses)
        }
        _ => action.into_iter().collect(),
    }
}

/// Puts a character where it was, and as it was posed, when the document was opened; one that came later,
/// where it started, at rest.
fn to_start(session: &Session, shape: &Shape) -> Vec<Edit> {
    let ShapeKind::Character(character) = &shape.kind else {
        return Vec::new();
    };
    let opened = session.start_scene();
    let placement = opened.shape(shape.id).map_or(shape.start, |s| s.placement);
    // A model that was read again may have other joints.
    let same = |opened: &&CharacterShape| Arc::ptr_eq(&opened.character, &character.character);
    let posed = opened.character(shape.id).filter(same);
    let pose = match posed.filter(|opened| !opened.is_at_rest()) {
        Some(opened) => Edit::SetPose(shape.id, opened.pose().clone()),
        None => Edit::ResetPose(shape.id),
    };
    vec![Edit::SetTransform(shape.id, placement.transform), pose]
}

/// Indices of the joints of a character.
fn joints_of(session: &Session, shape: ShapeId) -> Option<Range<usize>> {
    let character = session.scene().character(shape)?;
    Some(0..character.character.skeleton().joints().len())
}

fn action(command: Command, session: &Session, state: &mut UiState, aspect: f32) -> Option<Action> {
    if why_disabled(command, session, state).is_some() {
        return None;
    }
    state.box_select.armed = command == Command::BoxSelect;
    let view = session.view();
    match command {
        Command::New => return Some(Action::Ask(Ask::New)),
        Command::Open => return Some(Action::Ask(Ask::Open)),
        Command::Save => return Some(Action::Ask(Ask::Save)),
        Command::SaveWithFiles => return Some(Action::Ask(Ask::SaveWithFiles)),
        Command::CopyLink => return Some(Action::Ask(Ask::CopyLink)),
        Command::Revert => return Some(Action::Ask(Ask::Revert)),
        Command::Reload => return Some(Action::Ask(Ask::Reload)),
        Command::SaveAs => return Some(Action::Ask(Ask::SaveAs)),
        Command::Screenshot => state.windows.open(Dialog::Screenshot),
        Command::FindCommand => state.search = Some(CommandSearch::default()),
        Command::Keys => state.windows.open(Dialog::Keys),
        Command::Messages => state.windows.open(Dialog::Messages),
        Command::About => state.windows.open(Dialog::About),
        Command::History => state.windows.open(Dialog::History),
        Command::Preferences => state.windows.open(Dialog::Preferences),
        Command::Undo => return Some(Action::History(HistoryMove::Undo)),
        Command::Redo => return Some(Action::History(HistoryMove::Redo)),
        Command::TogglePanel => state.fold_panel(!state.is_panel_folded()),
        Command::SetTheme(theme) => state.theme = theme,
        Command::SetNavigation(navigation) => state.set_navigation(navigation),
        Command::OpenScene(name) => return Some(Action::Ask(Ask::OpenBuiltin(name))),
        Command::ResetViewAndPose => {
            return Some(Action::View(View::SetCamera(*session.start_camera())));
        }
        Command::SetSkinning(skinning) => state.skinning = skinning,
        Command::SetColors(colors) => state.colors = colors,
        Command::ToggleBindGhost => state.bind_ghost = !state.bind_ghost,
        Command::SetTool(tool) => state.pose.tool = tool,
        Command::Begin(tool) => state.pose.asked = Some((tool, GestureStep::Begin)),
        Command::ToggleLocalAxes => state.pose.axes = state.pose.axes.other(),
        Command::ResetJoint
        | Command::ResetAngles
        | Command::ResetOffset
        | Command::ResetPose
        | Command::MirrorPose
        | Command::MirrorJoints
        | Command::PastePose
        | Command::PastePoseMirrored
        | Command::KeepPose
        | Command::SavePose
        | Command::LoadPose => {
            return pasted_onto(command, session, state).or_else(|| pose_action(command, session));
        }
        Command::CopyPose => {
            let (shape, _) = selected_character(session)?;
            return Some(Action::Ask(copied_pose(shape, session, state)));
        }
        Command::PinJoint => {
            state.pose.tool = Tool::Ik;
            if let Some((shape, joints)) = posing::joints_to_pin(session) {
                return posing::toggle_pins(session, shape, &joints).map(Action::Edit);
            }
        }
        Command::UnpinAll => return Some(Action::Edit(posing::unpin_all(session))),
        Command::Quit => return Some(Action::Ask(Ask::Quit)),
        Command::Insert(primitive) => return Some(insert(command, primitive, session)),
        Command::MakeSurfaceOfRevolution => return revolution(session).ok(),
        Command::ExportCurve => return export_curves(session),
        Command::ExportGeometry => return Some(Action::Ask(Ask::ExportGeometry)),
        Command::ExportSelected => return Some(Action::Ask(Ask::ExportSelected)),
        Command::ExportMaterials => return Some(Action::Ask(Ask::ExportMaterials)),
        Command::ExportCharacter => {
            let (character, _) = selected_character(session)?;
            return Some(Action::Ask(Ask::ExportCharacter(character)));
        }
        Command::ImportShape => return Some(Action::Ask(Ask::ImportShape)),
        Command::ImportCurve => return Some(Action::Ask(Ask::ImportCurve)),
        Command::ImportCharacter => return Some(Action::Ask(Ask::ImportCharacter)),
        Command::Explain => state.explain.set_open(!state.explain.is_open()),
        Command::Compare if state.compares[0] => {
            return Some(Action::Ask(Ask::Compare(CompareAction::Close)));
        }
        Command::Compare => return Some(Action::Ask(Ask::Compare(CompareAction::Choose))),
        Command::CompareMesh if state.compares[1] => {
            return Some(Action::Ask(Ask::CompareMesh(CompareMeshAction::Close)));
        }
        Command::CompareMesh => {
            let choose = CompareMeshAction::Choose(character_to_compare(session)?);
            return Some(Action::Ask(Ask::CompareMesh(choose)));
        }
        Command::Delete => {
            let point = control_points::delete_clicked(session, &state.curves);
            return match point.and_then(Result::ok) {
                Some(edit) => Some(Action::Edit(edit)),
                None => to_selected(session, Edit::Delete),
            };
        }
        Command::Reset => return to_selected(session, Edit::Reset),
        Command::ResetPosition | Command::ResetRotation | Command::ResetScale => {
            return Some(put_back(command, session));
        }
        Command::Duplicate => {
            let copies = if state.navigation == Navigation::Blender {
                // They follow the pointer from there.
                state.pose.asked = Some((Tool::Move, GestureStep::BeginOnLastStep));
                duplicates_in_place(session)
            } else {
                duplicates(session)
            };
            return Some(Action::Edit(Edit::Insert(copies)));
        }
        Command::BoxSelect | Command::MakeSweep | Command::ShowAll => {}
        Command::SelectAll => {
            return Some(Action::View(
                match posing::posed(session, state.pose.tool) {
                    Some(shape) => View::SelectJoints(joints_of(session, shape)?.collect()),
                    None => View::SelectAll,
                },
            ));
        }
        Command::SelectNone => {
            let is_posed = posing::posed(session, state.pose.tool).is_some();
            let has_joint = session.selected_joint().is_some();
            return Some(Action::View(match is_posed && has_joint {
                true => View::SelectJoint(None),
                false => View::Select(None),
            }));
        }
        Command::InvertSelection if let Some(shape) = posing::posed(session, state.pose.tool) => {
            let is_other = |joint: &usize| !session.selected_joints().contains(joint);
            let others: Vec<usize> = joints_of(session, shape)?.filter(is_other).collect();
            return Some(Action::View(match others.is_empty() {
                true => View::SelectJoint(None),
                false => View::SelectJoints(others),
            }));
        }
        Command::InvertSelection => {
            let others = others(session).map(|shape| shape.id).collect();
            return Some(Action::View(View::SelectInBox(others, BoxMode::Replace)));
        }
        Command::InsertMenu => state.opens_insert_menu = true,
        Command::Cut => return Some(Action::Ask(Ask::CutShapes)),
        Command::Copy => {
            let posed = posed_character(session, state);
            let pose = posed.map(|shape| copied_pose(shape, session, state));
            return Some(Action::Ask(pose.unwrap_or(Ask::CopyShapes)));
        }
        Command::Paste => {
            let onto = pasted_onto(command, session, state);
            return onto.or(Some(Action::Ask(Ask::Paste)));
        }
        Command::Rename => {
            let shape = session.selected().and_then(|id| session.scene().shape(id));
            state.renaming = shape.map(Renaming::of);
        }
        Command::ToggleVisible | Command::ToggleLocked => return toggle(command, session),
        Command::HideOthers => return Some(hide_others(session)),
        // Only the course's editor turns away from what is looked at.
        Command::ViewFrom(direction) => {
            return Some(Action::View(match state.navigation {
                Navigation::Course => View::From(direction),
                _ => View::SetCamera(session.view().camera.looking_from(direction)),
            }));
        }
        Command::ResetCamera => {
            let second = second_home(session);
            return Some(Action::View(
                second.map_or(View::ResetCamera, View::SetCamera),
            ));
        }
        Command::Fit | Command::FitAll => {
            let area = view_overlay::fit_area(state, aspect);
            let all = command == Command::FitAll || session.selected().is_none();
            let of_joints = fitted_to_joints(session, state, area).filter(|_| !all);
            if let Some(camera) = of_joints {
                return Some(Action::View(View::SetCamera(camera)));
            }
            return Some(Action::View(match state.explain.evaluated(session) {
                // A mistake that is made on purpose may take a mesh elsewhere.
                Some(shown) => View::SetCamera(fitted(session, &shown, all, area)),
                None if command == Command::FitAll => View::FitAll(area),
                None => View::Fit(area),
            }));
        }
        Command::ToggleAxis => return Some(Action::View(View::SetAxis(!view.axis))),
        Command::ToggleGrid => return Some(Action::View(View::SetGrid(!view.grid))),
        Command::ToggleBones => return Some(Action::View(View::SetBones(!view.bones))),
        Command::SetLook(look) => return Some(Action::View(View::ChooseLook(look))),
        Command::SetShading(shading) => return Some(Action::View(View::SetShading(shading))),
    }
    None
}

/// The camera that the program of the look starts with, to which Home leads from where the document began.
pub(in crate::ui) fn second_home(session: &Session) -> Option<Camera> {
    let view = session.view();
    let is_at_start = view.camera == *session.start_camera();
    first_camera(view.look).filter(|_| is_at_start)
}

/// The cameras to which Home leads when it is pressed, and when it is pressed twice.
pub(in crate::ui) fn homes(session: &Session) -> [Camera; 2] {
    let start = *session.start_camera();
    let first = first_camera(session.view().look);
    [
        second_home(session).unwrap_or(start),
        first.unwrap_or(start),
    ]
}

/// The camera that the program of a look starts with.
fn first_camera(look: Look) -> Option<Camera> {
    match look {
        Look::Course => Some(Camera::default()),
        Look::Mannequin => Some(Camera::of_mannequin()),
        Look::Studio => None,
    }
}

/// Inserts a new shape, with the name that the menu has for it.
fn insert(command: Command, primitive: Primitive, session: &Session) -> Action {
    let mut shape = NewShape::new(label(command), primitive.kind());
    set_beside_others(session, &mut shape);
    Action::Edit(Edit::Insert(vec![shape]))
}

/// Does something to every selected shape.
fn to_selected(session: &Session, edit: impl Fn(ShapeId) -> Edit) -> Option<Action> {
    let edit = edit(session.selected()?);
    Some(Action::Edit(for_all_selected(session, edit)))
}

/// Tooltip of a row of the table, about what it does at the moment.
pub(in crate::ui) fn full_tooltip(
    entry: &Entry,
    session: &Session,
    state: &UiState,
) -> &'static str {
    match entry.command {
        Command::Delete if deletes_point(session, state) => {
            "Delete the control point that was clicked last"
        }
        Command::Compare if state.compares[0] => "Show the view alone again",
        Command::CompareMesh if state.compares[1] => "Show the character alone again",
        _ => entry.tooltip,
    }
}

/// Whether Delete is about a control point rather than its shape.
pub(super) fn deletes_point(session: &Session, state: &UiState) -> bool {
    control_points::delete_clicked(session, &state.curves).is_some()
}

/// Label of a command in a menu, with what Copy copies, whether Delete deletes a point or a comparison ends, and
/// the step that Undo or Redo is about.
pub(in crate::ui) fn full_label(command: Command, session: &Session, state: &UiState) -> String {
    match command {
        Command::Delete if deletes_point(session, state) => return "Delete Point".to_owned(),
        Command::Compare if state.compares[0] => return "End Comparison with Picture".to_owned(),
        Command::CompareMesh if state.compares[1] => return "End Comparison with Mesh".to_owned(),
        _ => {}
    }
    if command == Command::Copy {
        let several = session.selected_shapes().count() > 1;
        return match posed_character(session, state) {
            Some(_) => "Copy Pose".to_owned(),
            None if several => "Copy Shapes".to_owned(),
            None => "Copy Shape".to_owned(),
        };
    }
    let done = session.done_steps();
    let step = match command {
        Command::Undo => done.checked_sub(1),
        Command::Redo => Some(done),
        _ => None,
    };
    let step = step.and_then(|step| session.steps().nth(step));
    match step {
        Some(step) => format!("{} {step}", label(command)),
        None => label(command).to_owned(),
    }
}

/// State of a command that switches something on or off; `None` for all others.
pub(in crate::ui) fn is_on(command: Command, session: &Session, state: &UiState) -> Option<bool> {
    let view = session.view();
    match command {
        Command::ToggleAxis => Some(view.axis),
        Command::ToggleGrid => Some(view.grid && view.look != Look::Course),
        Command::ToggleBones => Some(view.bones && view.look == Look::Mannequin),
        Command::TogglePanel => Some(!state.is_panel_folded()),
        Command::Explain => Some(state.explain.is_open()),
        Command::SetLook(look) => Some(view.look == look),
        Command::SetShading(shading) => Some(view.shading == shading),
        Command::SetTheme(theme) => Some(state.theme == theme),
        Command::SetNavigation(navigation) => Some(state.navigation == navigation),
        Command::SetSkinning(skinning) => Some(state.skinning == skinning),
        Command::SetColors(colors) => Some(state.colors == colors),
        Command::ToggleBindGhost => Some(state.bind_ghost),
        Command::SetTool(tool) => Some(state.pose.tool == tool),
        Command::ToggleLocalAxes => Some(state.pose.axes == GizmoAxes::Local),
        _ => None,
    }
}

/// Exports the curves of the selected shape.
fn export_curves(session: &Session) -> Option<Action> {
    let (shape, _) = selected_curves(session)?;
    Some(Action::Ask(Ask::ExportCurve(shape)))
}

pub(super) fn selected_curves(session: &Session) -> Option<(ShapeId, &CurveSet)> {
    let id = session.selected()?;
    Some((id, session.scene().curve(id)?.curves()))
}

/// The camera that has what is `shown` in its `area`: all that is visible, or what of it is selected.
fn fitted(session: &Session, shown: &Evaluated, all: bool, area: FitArea) -> Camera {
    let mut camera = session.view().camera;
    let shapes = shown.shapes.iter().filter(|shape| shape.visible);
    camera.fit_shapes(
        shapes.filter(|shape| all || session.is_selected(shape.id)),
        area,
    );
    camera
}

/// Curves of `set` with their indices among its items.
pub(in crate::ui) fn curves(set: &CurveSet) -> impl Iterator<Item = (usize, &Curve)> {
    let items = set.items().iter().enumerate();
    items.filter_map(|(index, item)| Some((index, item.curve()?)))
}

/// The character that a mesh is compared with: the selected one, or the only one.
pub(super) fn character_to_compare(session: &Session) -> Option<ShapeId> {
    if let Some((selected, _)) = selected_character(session) {
        return Some(selected);
    }
    let shapes = session.scene().shapes().iter();
    let mut characters = shapes.filter(|shape| matches!(shape.kind, ShapeKind::Character(_)));
    let only = characters.next()?;
    characters.next().is_none().then_some(only.id)
}

/// The selected shape, if it is a character.
pub(in crate::ui) fn selected_character(session: &Session) -> Option<(ShapeId, &CharacterShape)> {
    let id = session.selected()?;
    Some((id, session.scene().character(id)?))
}
