use super::curve_commands;
use super::keys::{self, Command, Menu, Primitive};
use super::pose_commands;
use super::posing;
use super::state::{Dialog, UiState};
use crate::character::Pose;
use crate::editor::{Edit, GizmoAxes, Session, Tool, View};
use crate::scene::NewShape;
use crate::scene::{Look, ShapeKind};
use crate::ui::{Action, Ask, CompareAction};

/// Carries out what a menu item or key starts: windows of the panels at once, all else as
/// actions. `aspect` is width over height of the view.
pub(super) fn run(
    command: Command,
    session: &Session,
    state: &mut UiState,
    aspect: f32,
) -> Vec<Action> {
    let action = action(command, session, state, aspect);
    if command == Command::ResetViewAndPose {
        let shapes = session.scene().shapes().iter();
        let characters = shapes.filter(|shape| matches!(shape.kind, ShapeKind::Character(_)));
        let to_rest = characters.map(|shape| Edit::SetPose(shape.id, Pose::default()));
        let all = Action::Edit(Edit::Together(to_rest.collect()));
        return std::iter::once(all).chain(action).collect();
    }
    action.into_iter().collect()
}

fn action(command: Command, session: &Session, state: &mut UiState, aspect: f32) -> Option<Action> {
    if why_disabled(command, session, state).is_some() {
        return None;
    }
    let view = session.view();
    match command {
        Command::Screenshot => state.open(Dialog::Screenshot),
        Command::Keys => state.open(Dialog::Keys),
        Command::Messages => state.open(Dialog::Messages),
        Command::About => state.open(Dialog::About),
        Command::SetTheme(theme) => state.theme = theme,
        Command::SetNavigation(navigation) => state.set_navigation(navigation),
        Command::OpenScene(name) => return Some(Action::Ask(Ask::OpenBuiltin(name))),
        Command::ResetViewAndPose => {
            return Some(Action::View(View::SetCamera(*session.start_camera())));
        }
        Command::SetSkinning(skinning) => state.skinning = skinning,
        Command::SetTool(tool) => state.pose.tool = tool,
        Command::ToggleLocalAxes => state.pose.axes = state.pose.axes.other(),
        Command::ResetJoint
        | Command::ResetPose
        | Command::MirrorPose
        | Command::CopyPose
        | Command::PastePose
        | Command::KeepPose
        | Command::SavePose
        | Command::LoadPose => return pose_commands::run(command, session),
        Command::PinJoint => {
            state.pose.tool = Tool::Ik;
            if let Some((shape, joint)) = posing::joint_to_pin(session) {
                state.pose.ik.toggle_pin(shape, joint);
            }
        }
        Command::UnpinAll => state.pose.ik.unpin_all(),
        Command::Quit => return Some(Action::Ask(Ask::Quit)),
        Command::Insert(primitive) => return Some(insert(command, primitive)),
        Command::MakeSurfaceOfRevolution => return curve_commands::revolution(session),
        Command::MakeSweep => return curve_commands::sweep(session),
        Command::ExportCurve => return curve_commands::export(session),
        Command::ExportGeometry => return Some(Action::Ask(Ask::ExportGeometry)),
        Command::ImportShape => return Some(Action::Ask(Ask::ImportShape)),
        Command::ImportCurve => return Some(Action::Ask(Ask::ImportCurve)),
        Command::ImportCharacter => return Some(Action::Ask(Ask::ImportCharacter)),
        Command::Compare => return Some(Action::Ask(Ask::Compare(CompareAction::Choose))),
        Command::Delete => return session.selected().map(|id| Action::Edit(Edit::Delete(id))),
        Command::Reset => return session.selected().map(|id| Action::Edit(Edit::Reset(id))),
        Command::ToggleVisible | Command::ToggleLocked => return toggle(command, session),
        Command::ViewFrom(direction) => return Some(Action::View(View::From(direction))),
        Command::ResetCamera => return Some(Action::View(View::ResetCamera)),
        Command::Fit => return Some(Action::View(View::Fit { aspect })),
        Command::ToggleAxis => return Some(Action::View(View::SetAxis(!view.axis))),
        Command::ToggleGrid => return Some(Action::View(View::SetGrid(!view.grid))),
        Command::SetLook(look) => return Some(Action::View(View::SetLook(look))),
        Command::SetShading(shading) => return Some(Action::View(View::SetShading(shading))),
    }
    None
}

/// A new shape, called as in the menu.
fn insert(command: Command, primitive: Primitive) -> Action {
    Action::Edit(Edit::Insert(vec![NewShape::new(
        keys::label(command),
        primitive.kind(),
    )]))
}

/// What hides, shows, locks or unlocks the selected shape.
fn toggle(command: Command, session: &Session) -> Option<Action> {
    let shape = session.scene().shape(session.selected()?)?;
    Some(Action::Edit(match command {
        Command::ToggleVisible => Edit::SetVisible(shape.id, !shape.visible),
        _ => Edit::SetLocked(shape.id, !shape.locked),
    }))
}

/// Whether a command that switches something has it switched on; `None` for all others.
pub(super) fn is_on(command: Command, session: &Session, state: &UiState) -> Option<bool> {
    let view = session.view();
    match command {
        Command::ToggleAxis => Some(view.axis),
        Command::ToggleGrid => Some(view.grid && view.look != Look::Course),
        Command::SetLook(look) => Some(view.look == look),
        Command::SetShading(shading) => Some(view.shading == shading),
        Command::SetTheme(theme) => Some(state.theme == theme),
        Command::SetNavigation(navigation) => Some(state.navigation == navigation),
        Command::SetSkinning(skinning) => Some(state.skinning == skinning),
        Command::SetTool(tool) => Some(state.pose.tool == tool),
        Command::ToggleLocalAxes => Some(state.pose.axes == GizmoAxes::Local),
        _ => None,
    }
}

/// Why a command cannot be used now, in words for its tooltip.
pub(super) fn why_disabled(
    command: Command,
    session: &Session,
    state: &UiState,
) -> Option<&'static str> {
    match command {
        Command::UnpinAll if !state.pose.ik.has_pins() => Some("Nothing is pinned"),
        Command::ToggleGrid if session.view().look == Look::Course => {
            Some("The Course look has no ground (View ⏵ Look ⏵ Studio)")
        }
        Command::PinJoint if posing::joint_to_pin(session).is_none() => {
            Some("No joint is selected or under the pointer")
        }
        Command::Delete | Command::Reset | Command::ToggleVisible | Command::ToggleLocked
            if session.selected().is_none() =>
        {
            Some("No shape is selected")
        }
        Command::ExportGeometry if session.scene().shapes().is_empty() => {
            Some("There is nothing to export")
        }
        Command::ExportCurve | Command::MakeSurfaceOfRevolution | Command::MakeSweep => {
            curve_commands::why_disabled(command, session)
        }
        _ if keys::is_in(Menu::Pose, command) => pose_commands::why_disabled(command, session),
        Command::Fit if !session.scene().shapes().iter().any(|shape| shape.visible) => {
            Some("There is nothing to fit")
        }
        _ => None,
    }
}
