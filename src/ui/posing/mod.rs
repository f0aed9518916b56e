//! The tools Pose, IK, Move, Rotate and Scale: gestures with bones, gizmos and shapes in the view.

mod amount;
mod held;
mod ik;
mod let_go;
mod paint;
mod paint_gizmo;
mod pointer;
mod readout;
mod rolling;
mod shown_gizmo;
mod tool_bar;
mod tool_icons;
mod typed;

pub(super) use ik::{has_pins, joints_to_pin, toggle_pins, unpin_all};
use pointer::bone_at;
pub(super) use pointer::{pointer, put_back};
pub(super) use rolling::roll_by_keys;
pub(super) use tool_bar::BAR_HEIGHT;
pub(super) use typed::Typed;

use super::scene_places::{Picked, Place, ScenePlaces};
use crate::editor::{GizmoAxes, Handle, IkGrip, Session, Together, Tool, View, root_of};
use crate::revision::Revision;
use crate::scene::{BoneHit, Look, ModelDisplay, ShapeId, bones_in_world};
use crate::ui::commands::{self, Command};
use crate::ui::grab::is_pickable;
use crate::ui::pointing::Pointing;
use crate::ui::{Action, GestureStep};
use egui::{Context, Key, Painter, Pos2, Response, Ui};
use glam::Vec2;
use held::{Held, PoseGesture};
use let_go::LetGo;
use std::borrow::Cow;

/// State of the tools.
#[derive(Clone, Debug, Default)]
pub(super) struct PoseState {
    pub tool: Tool,
    /// Axes of gizmos.
    pub axes: GizmoAxes,
    /// Which of the selected joints turn together, as the navigation has it.
    pub together: Together,
    /// The character and its grip under the pointer in the view, with the IK tool, while nothing is
    /// dragged.
    pub hovered_grip: Option<(ShapeId, IkGrip)>,
    /// What a drag or a roll by keys has turned, while it is still at hand.
    pub let_go: Option<LetGo>,
    /// The bone that keys rolled last.
    pub rolled: Option<Rolled>,
    /// What a command asked to be done to the selection with the pointer from now on, and how that gesture begins.
    pub asked: Option<(Tool, GestureStep)>,
    /// The drag under way.
    pub gesture: Option<PoseGesture>,
    /// The bone under the pointer in the view in the last frame.
    pub hovered: Option<BoneHit>,
    /// Cache of the shape under the pointer.
    pub picked: Picked,
    /// Whether the view itself was under the pointer in the last frame.
    pub over_view: bool,
    /// Where the pointer was when Left or Right was pressed last, if that was beside all bones, where it turns the camera if
    /// the navigation has that, or has not moved since it was.
    pub turns_camera_at: Option<Pos2>,
    /// Whether the pointer is a finger.
    pub by_finger: bool,
    /// The bone that was dragged or clicked last: of its joint's bones, keys roll this one.
    pub taken: Option<BoneHit>,
    /// A joint that was selected by turning its bone. Its gizmo is hidden until the joint is
    /// clicked: it would be in the way of the next turn.
    pub without_gizmo: Option<(ShapeId, usize)>,
    /// Lower edge of the tool bar in the last frame, in points below the view's upper one: where it is narrow, its buttons
    /// are in several rows.
    pub bar_bottom: f32,
    /// The handle of a gizmo under the pointer in the last frame, while nothing is dragged.
    pub hot: Option<Handle>,
}

/// A bone that keys have rolled: the taps of a key are one step, as long as nothing else is done.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rolled {
    /// The character, and the index of the bone.
    bone: (ShapeId, usize),
    /// The document with that, once the key is up.
    document: Option<Revision>,
}

impl PoseState {
    /// Keeps the settings, and drops everything about shapes.
    pub(super) fn forget_shapes(&mut self) {
        *self = Self {
            tool: self.tool,
            axes: self.axes,
            ..Self::default()
        };
    }

    /// Whether the view marks a chain instead of the hovered bone.
    fn shows_chain(&self) -> bool {
        self.tool == Tool::Ik && (self.gesture.is_some() || self.hovered_grip.is_some())
    }

    /// The handle of a gizmo that is being dragged.
    fn held_handle(&self) -> Option<Handle> {
        self.gesture.as_ref()?.active().and_then(Held::handle)
    }
}

/// Shows bones and gizmos over the pictures of the scene in the view, and the tool bar.
pub(super) fn show(
    ui: &mut Ui,
    places: &ScenePlaces,
    view: &Response,
    session: &Session,
    state: &mut PoseState,
    actions: &mut Vec<Action>,
) {
    let whole = ui.max_rect();
    let mut hot = None;
    let gesture = state.gesture.as_ref();
    for place in places.iter() {
        let clip = place.seen.intersect(ui.clip_rect());
        let painter = ui.painter().with_clip_rect(clip);
        paint::selected_bones(&painter, place, session, state.tool);
        if !state.shows_chain() {
            paint::hovered_bones(&painter, place, session);
        }
        hot = hot.or(show_gizmo(&painter, place, view, session, state));
        let typed = gesture.and_then(|gesture| Some(gesture.active()?.typed_axes(session)));
        for axis in typed.into_iter().flatten() {
            paint_gizmo::axis(&painter, place, session, axis);
        }
        if state.tool == Tool::Ik {
            paint::ik(&painter, place, session, state.hovered_grip, gesture);
        }
    }
    if let Some(gesture) = gesture {
        let pointer = ui.ctx().input(|input| input.pointer.latest_pos());
        let under = pointer.and_then(|at| places.at(at));
        let place = under.or_else(|| places.get(0));
        readout::show(ui, whole, place, session, gesture);
    }
    state.hot = hot.filter(|_| gesture.is_none());
    tool_bar::show(ui, whole, session, state, actions);
}

/// Shows the bones of the joint under the pointer, and nothing else of the tools.
pub(super) fn show_hovered(ui: &Ui, places: &ScenePlaces, session: &Session) {
    for place in places.iter() {
        let clip = place.seen.intersect(ui.clip_rect());
        paint::hovered_bones(&ui.painter().with_clip_rect(clip), place, session);
    }
}

/// Shows the gizmo of the tool, if it has one; the handle that is held or under the pointer.
fn show_gizmo(
    painter: &Painter,
    place: Place,
    view: &Response,
    session: &Session,
    state: &PoseState,
) -> Option<Handle> {
    let gizmo = shown_gizmo::shown_gizmo(session, state, place)?;
    let held = state.held_handle();
    let under = view
        .hover_pos()
        .filter(|&at| state.gesture.is_none() && place.live.contains(at));
    let handle_at = |at: Pos2| {
        let pixel = place.pixel(at);
        let is_bone = || bone_at(session, (state.tool, state.by_finger), place, pixel).is_some();
        Some(gizmo.hit_beside_bones(pixel, is_bone)?.handle)
    };
    let hot = held.or_else(|| handle_at(under?));
    paint_gizmo::gizmo(painter, place, &gizmo, hot, held.is_some());
    hot
}

/// Takes the numbers and axes that are typed for the drag under way. To be called before the panels.
///
/// Returns whether R was pressed once more while something is turned, which in Blender turns it freely.
pub(super) fn take_keys(ctx: &Context, state: &mut PoseState) -> bool {
    let Some(gesture) = &mut state.gesture else {
        return false;
    };
    let is_turned = gesture.is_by_key() && gesture.held().turns();
    gesture.held_mut().take_keys(ctx);
    is_turned && ctx.input(|input| input.key_pressed(Key::R))
}

/// Shows the gizmo of a joint that is selected by a click, in the view or in the list.
pub(super) fn notice_selection(state: &mut PoseState, actions: &[Action]) {
    let selects = |action: &Action| matches!(action, Action::View(View::SelectJoint(Some(_))));
    if actions.iter().any(selects) {
        state.without_gizmo = None;
    }
}

/// Text of the status line about what is dragged or the bone under the pointer: its name, and what
/// gestures do with it.
pub(super) fn status(
    session: &Session,
    state: &PoseState,
    pointing: Pointing,
    ctx: &Context,
) -> Option<(Option<String>, Cow<'static, str>)> {
    if let Some(gesture) = &state.gesture {
        let held = gesture.held();
        let over = held_name(session, held);
        let next = if gesture.is_by_key() {
            "Type X, Y, Z, a number · click keeps it · Esc cancels"
        } else if pointing == Pointing::Fingers {
            "A second finger cancels"
        } else if held.snaps() {
            "Type X, Y, Z, a number · Ctrl snaps · Esc cancels"
        } else {
            "Esc or right click cancels"
        };
        return Some((over, next.into()));
    }
    if let Some(handle) = state.hot {
        let does = over_handle(state.tool, handle);
        let next = match pointing {
            Pointing::Mouse => format!("{does} · Ctrl snaps").into(),
            Pointing::Fingers => does.into(),
        };
        let moves = session.selected().filter(|_| state.tool == Tool::Move);
        let over = moves.and_then(|id| joint_name(session, id, selected_root(session, id)));
        return Some((over, next));
    }
    // Fingers take hold of bones and are never only above them.
    let hit = state.hovered?;
    if let Some((shape, grip)) = state.hovered_grip {
        let over = joint_name(session, shape, Some(grip.joint()));
        return Some((over, ik_status(session, shape, grip).into()));
    }
    let (joint, next) = match state.tool {
        Tool::Select => {
            let tool = commands::with_key(ctx, Command::SetTool(Tool::Pose), "the Pose tool");
            let next = format!("Click to select the joint · {tool} turns it by hand");
            return Some((joint_name(session, hit.shape, Some(hit.joint)), next.into()));
        }
        Tool::Pose if points_at_eye(session, hit) => (
            Some(hit.joint),
            "It points at you: Left, Right roll · click for rings, or look from the side",
        ),
        Tool::Pose => (
            Some(hit.joint),
            "Drag to turn it · Left, Right roll · Ctrl snaps · click for rings",
        ),
        Tool::Move => (
            root_of(session, hit.shape, hit.joint),
            "Drag to move it and what hangs on it · Shift: all roots · Ctrl snaps",
        ),
        Tool::Ik => (Some(hit.joint), "Drag to bring it somewhere"),
        Tool::Rotate | Tool::Scale => return None,
    };
    Some((joint_name(session, hit.shape, joint), next.into()))
}

/// What a tool does with bones, where the pointer is over none; `None` where there are none to point at.
pub(super) fn beside_bones(session: &Session, tool: Tool) -> Option<&'static str> {
    let mut shapes = session.scene().shapes().iter();
    let has_bones =
        shapes.any(|shape| shape.visible && session.scene().character(shape.id).is_some());
    match tool {
        Tool::Pose if has_bones => Some("Drag a bone to turn it"),
        Tool::Ik if has_bones => Some("Drag a bone to bring it somewhere"),
        _ => None,
    }
}

/// Cosine of the angle between a bone and the line of sight above which a turn about that line hardly moves it.
const AT_EYE: f32 = 0.9;
/// Length of a bone in the picture, relative to the height of that, from which on a hand turns it well all the same.
const LONG: f32 = 0.06;

/// Whether the bone under the pointer runs along the line of sight, about which a drag turns it, and is so short in the
/// picture that this hardly shows.
fn points_at_eye(session: &Session, hit: BoneHit) -> bool {
    let evaluated = session.evaluated().shape(hit.shape);
    let bone =
        evaluated.and_then(|evaluated| bones_in_world(session.scene(), evaluated).nth(hit.bone));
    let camera = session.view().camera;
    bone.is_some_and(|(_, start, end)| {
        let along = (end - start).normalize_or_zero();
        let sight = (start - camera.eye()).normalize_or_zero();
        let [from, to] = [start, end].map(|at| camera.pixel(at, Vec2::ONE));
        let is_short = from
            .zip(to)
            .is_some_and(|(from, to)| from.distance(to) < LONG);
        is_short && along.dot(sight).abs() > AT_EYE
    })
}

/// Effect of a drag of a handle, for the status line. Ctrl snaps all of them.
fn over_handle(tool: Tool, handle: Handle) -> &'static str {
    match (tool, handle) {
        (Tool::Scale, Handle::Arrow(0)) => "Drag to scale along X",
        (Tool::Scale, Handle::Arrow(1)) => "Drag to scale along Y",
        (Tool::Scale, Handle::Arrow(_)) => "Drag to scale along Z",
        (Tool::Scale, _) => "Drag to scale all axes alike",
        (_, Handle::Ring(0)) => "Drag to turn about X",
        (_, Handle::Ring(1)) => "Drag to turn about Y",
        (_, Handle::Ring(_)) => "Drag to turn about Z",
        (Tool::Pose, Handle::FreeRing) => "Drag to turn as the pointer goes",
        (_, Handle::FreeRing) => "Drag to turn about the direction of view",
        (_, Handle::Arrow(0)) => "Drag to move along X",
        (_, Handle::Arrow(1)) => "Drag to move along Y",
        (_, Handle::Arrow(_)) => "Drag to move along Z",
        (_, Handle::Plane(0)) => "Drag to move along Y and Z",
        (_, Handle::Plane(1)) => "Drag to move along X and Z",
        (_, Handle::Plane(_)) => "Drag to move along X and Y",
        (_, Handle::Center) => "Drag to move across the view",
    }
}

/// Effect of a drag of a grip with the IK tool, for the status line.
fn ik_status(session: &Session, shape: ShapeId, grip: IkGrip) -> &'static str {
    let is_root = root_of(session, shape, grip.joint()) == Some(grip.joint());
    let is_held = grip.chain(session, shape).is_none();
    let moves_root = is_root && matches!(grip, IkGrip::Joint(_));
    if ik::pins(session, shape).any(|pin| pin == grip.joint()) {
        "Pinned: stays while others are dragged · P unpins"
    } else if moves_root {
        "Drag to move it all; pins stay · P pins"
    } else if is_held {
        "A pin above holds it"
    } else {
        "Drag to bring it somewhere, the chain follows · P pins"
    }
}

/// Whether the skeleton of a character is displayed.
fn shows_skeleton(session: &Session, shape: ShapeId) -> bool {
    let character = session.scene().character(shape);
    character.is_some_and(|character| character.display.mode != ModelDisplay::Mesh)
}

/// Whether the tool takes the bones of a character: the Move tool those that are seen, of a character whose root is
/// selected, or that has no mesh, since it moves others as a whole.
fn takes_bones_of(session: &Session, tool: Tool, shape: ShapeId) -> bool {
    let view = session.view();
    let has_no_mesh = || {
        let character = session.scene().character(shape);
        character.is_some_and(|it| it.character.bind_mesh().triangles.is_empty())
    };
    match tool {
        Tool::Move => {
            view.look == Look::Mannequin && view.bones
                || shows_skeleton(session, shape)
                || selected_root(session, shape).is_some()
                || has_no_mesh()
        }
        tool => tool.takes_bones(),
    }
}

/// The joint of a character that is selected, if it is a root.
fn selected_root(session: &Session, shape: ShapeId) -> Option<usize> {
    let joint = session.selected_joint();
    let joint = joint.filter(|_| session.selected() == Some(shape))?;
    (root_of(session, shape, joint) == Some(joint)).then_some(joint)
}

/// The character whose joints are selected together, with a tool that turns them.
pub(super) fn posed(session: &Session, tool: Tool) -> Option<ShapeId> {
    let id = session
        .selected()
        .filter(|_| matches!(tool, Tool::Pose | Tool::Ik))?;
    let is_free = session.scene().character(id).is_some() && is_pickable(session, id);
    is_free.then_some(id)
}

/// Name of what is dragged: of a control point, a joint or a shape, or how many shapes.
fn held_name(session: &Session, held: &Held) -> Option<String> {
    if let Some(point) = held.point() {
        return Some(format!("Point {}", point + 1));
    }
    let joints = session.selected_joints();
    // Inverse kinematics leads one alone.
    if joints.len() > 1
        && held.ik().is_none()
        && held.joint().is_some_and(|joint| joints.contains(&joint))
    {
        return Some(format!("{} joints", joints.len()));
    }
    let free = session.selected_shapes();
    let shapes = free.filter(|shape| is_pickable(session, shape.id)).count();
    if held.joint().is_none() && shapes > 1 {
        return Some(format!("{shapes} shapes"));
    }
    joint_name(session, held.shape(), held.named())
}

/// Name of a joint, or else of its shape.
fn joint_name(session: &Session, shape: ShapeId, joint: Option<usize>) -> Option<String> {
    let joint = joint.and_then(|joint| {
        let character = session.scene().character(shape)?;
        Some(&character.character.skeleton().joints().get(joint)?.name)
    });
    joint
        .or_else(|| Some(&session.scene().shape(shape)?.name))
        .cloned()
}
