//! Bones, gizmos and shapes under the hand: the tools Pose, Move and IK.

mod bone_paint;
mod gesture;
mod gizmo_paint;
mod gizmos;
mod ik;
mod ik_bar;
mod ik_paint;
mod pointer;
mod roll;
mod sentence;
mod tool_bar;

pub(super) use gesture::PoseGesture;
pub(super) use ik::{IkState, joint_to_pin};
pub(super) use pointer::{Picked, pointer};
pub(super) use roll::roll_by_keys;
pub(super) use sentence::sentence;
pub(super) use tool_bar::BAR_HEIGHT;

use super::ScenePlaces;
use super::state::UiState;
use crate::editor::{GizmoAxes, Screen, Session, Tool, View};
use crate::scene::{BoneHit, ShapeId};
use crate::ui::Action;
use egui::{Painter, Pos2, Rect, Response, Ui, pos2};
use glam::Vec2;

/// What the tools remember.
#[derive(Clone, Debug, Default)]
pub(super) struct PoseState {
    pub tool: Tool,
    pub axes: GizmoAxes,
    pub ik: IkState,
    /// What is in the user's hand.
    pub gesture: Option<PoseGesture>,
    /// The bone under the pointer in the view in the last frame.
    pub hovered: Option<BoneHit>,
    /// The shape that was found under the pointer last.
    pub picked: Picked,
    /// Whether the view itself was under the pointer in the last frame.
    pub over_view: bool,
    /// The bone that was taken last: the one of its joint that keys roll.
    pub taken: Option<BoneHit>,
    /// A joint that was selected by turning its bone: its gizmo would be in the way of the next
    /// turn until it is asked for by a click.
    pub without_gizmo: Option<(ShapeId, usize)>,
}

impl PoseState {
    /// Keeps what is chosen, and nothing of any shape.
    pub(super) fn forget_shapes(&mut self) {
        *self = Self {
            tool: self.tool,
            axes: self.axes,
            ik: self.ik.without_pins(),
            ..Self::default()
        };
    }

    /// Whether a chain is marked in the view, and not the bone under the pointer.
    fn shows_chain(&self) -> bool {
        self.tool == Tool::Ik && (self.gesture.is_some() || self.ik.hovered.is_some())
    }
}

/// Shows bones and gizmos over the pictures of the scene in the view, and the bar of tools.
pub(super) fn show(
    ui: &mut Ui,
    places: &ScenePlaces,
    view: &Response,
    session: &Session,
    state: &mut UiState,
) {
    let whole = ui.max_rect();
    for &rect in &places.rects {
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        let place = Place { rect };
        bone_paint::show(&painter, place, session, state.pose.tool);
        if !state.pose.shows_chain() {
            bone_paint::hovered(&painter, place, session);
        }
        show_gizmo(&painter, place, view, session, &state.pose);
        if state.pose.tool == Tool::Ik {
            let gesture = state.pose.gesture.as_ref();
            ik_paint::show(&painter, place, session, &state.pose.ik, gesture);
        }
    }
    if let Some(gesture) = &state.pose.gesture {
        gizmo_paint::readout(ui, whole, session, gesture);
    }
    ik::forget_gone(session, state);
    tool_bar::show(ui, whole, session, state);
}

fn show_gizmo(
    painter: &Painter,
    place: Place,
    view: &Response,
    session: &Session,
    state: &PoseState,
) {
    let Some(gizmo) = gizmos::shown(session, state, place) else {
        return;
    };
    let held = state.gesture.as_ref().and_then(PoseGesture::handle);
    let under = view
        .hover_pos()
        .filter(|&at| state.gesture.is_none() && place.rect.contains(at));
    let hot = held.or_else(|| Some(gizmo.hit(place.pixel(under?))?.handle));
    gizmo_paint::show(painter, place, &gizmo, hot, held.is_some());
}

/// Whether hands and keys in the view may change a shape: it is neither hidden nor locked.
fn is_pickable(session: &Session, shape: ShapeId) -> bool {
    let evaluated = session.evaluated().shape(shape);
    evaluated.is_some_and(|shape| shape.pickable)
}

/// A joint that is selected by a click, here or in the list, shows its gizmo.
pub(super) fn notice_selection(state: &mut PoseState, actions: &[Action]) {
    let selects = |action: &Action| matches!(action, Action::View(View::SelectJoint(Some(_))));
    if actions.iter().any(selects) {
        state.without_gizmo = None;
    }
}

/// Where the scene is shown, in points of the window.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    rect: Rect,
}

impl Place {
    /// The picture under a point of the window.
    pub fn at(places: &ScenePlaces, position: Pos2) -> Option<Self> {
        Self::of(places, places.index_at(position)?)
    }

    /// The picture with this index.
    pub fn of(places: &ScenePlaces, index: usize) -> Option<Self> {
        Some(Self {
            rect: *places.rects.get(index)?,
        })
    }

    /// A point of the window as one of the picture.
    pub fn pixel(self, position: Pos2) -> Vec2 {
        let from_corner = position - self.rect.min;
        Vec2::new(from_corner.x, from_corner.y)
    }

    /// A point of the picture as one of the window.
    pub fn position(self, pixel: Vec2) -> Pos2 {
        pos2(self.rect.min.x + pixel.x, self.rect.min.y + pixel.y)
    }

    pub fn size(self) -> Vec2 {
        Vec2::new(self.rect.width().max(1.0), self.rect.height().max(1.0))
    }

    /// The picture under the session's camera.
    pub fn screen(self, session: &Session) -> Screen {
        Screen {
            camera: session.view().camera,
            size: self.size(),
        }
    }
}
