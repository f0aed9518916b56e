//! Several fingers on the view, which move it and zoom, and do nothing else.

use super::commands::{Gesture, gesture};
use super::scene_places::ScenePlaces;
use super::{Action, UiState, control_points, posing};
use crate::editor::{Session, View};
use egui::{InputState, Pos2, Response};
use glam::{Vec2, Vec3};

/// Distance in points that a finger that rests may move.
const STILL: f32 = 6.0;

/// What fingers do, for Help ▸ Keys and Mouse, but for one that is drawn over the view (see
/// [`Navigation::drag_of_a_finger`](super::Navigation::drag_of_a_finger)).
pub(super) const GESTURES: &[Gesture] = &[
    gesture("Two fingers", "Move the scene and zoom"),
    gesture("A second finger in a drag", "Put everything back"),
    gesture("Tap in the view", "Select a shape"),
    gesture("Pose: drag a bone", "Turn it"),
    gesture("Pose: tap a bone", "Show rings that turn it"),
    gesture("Drag a number", "Change it"),
    gesture("Tap a number", "Type a value or an expression such as 45/2"),
    gesture("Long press", "The right button: a menu, a number at rest"),
];

/// The view, which is dragged from now on if a finger has rested on it for long: it takes hold of what lies under it,
/// which lights up. egui would take the rest for a right click at once, and ignore the movement of the finger after it;
/// here it is one if the finger is lifted where it `rested`.
pub(super) fn drag_after_rest(view: Response, rested: &mut Option<Pos2>) -> Response {
    if !view.long_touched() {
        return view;
    }
    *rested = view.interact_pointer_pos();
    view.ctx.set_dragged_id(view.id);
    view.ctx.read_response(view.id).unwrap_or(view)
}

/// Where a finger was lifted that had rested there, and has not moved since.
pub(super) fn lifted_after_rest(view: &Response, rested: &mut Option<Pos2>) -> Option<Pos2> {
    let at = (*rested)?;
    let (is_down, now) = view
        .ctx
        .input(|input| (input.any_touches(), input.pointer.latest_pos()));
    let has_moved = now.is_some_and(|now| now.distance(at) > STILL);
    if has_moved || view.ctx.multi_touch().is_some() {
        *rested = None;
        return None;
    }
    if is_down { None } else { rested.take() }
}

/// What several fingers have been for since they came together. One that is left of them does nothing
/// until it is lifted: nobody lifts all of them at the same moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum SeveralFingers {
    /// There are none.
    #[default]
    None,
    /// They move the view, as if they held this point of the world.
    OnView(Vec3),
    /// The first of them holds something else, such as a number, which goes on.
    Elsewhere,
}

impl SeveralFingers {
    /// Whether they move the view.
    pub(super) fn move_view(self) -> bool {
        matches!(self, Self::OnView(_))
    }

    /// What fingers are for in this frame.
    fn notice(&mut self, view: &Response, places: &ScenePlaces, session: &Session) -> Self {
        if *self == Self::None
            && let Some(touch) = view.ctx.multi_touch()
        {
            // What egui takes for the start is where an earlier finger was, if two came at once.
            let pressed = view.ctx.input(|input| input.pointer.press_origin());
            let first = pressed.unwrap_or(touch.start_pos);
            // A window over the view keeps the fingers on it to itself.
            let is_on_view = view.interact_rect.contains(first)
                && view.ctx.layer_id_at(first) == Some(view.layer_id);
            *self = if is_on_view {
                let held = places.point_at(session, touch.center_pos);
                Self::OnView(held.unwrap_or(session.view().camera.target))
            } else {
                Self::Elsewhere
            };
        }
        let now = *self;
        if !view.ctx.input(InputState::any_touches) {
            // The last one that is lifted is no click either.
            *self = Self::None;
        }
        now
    }
}

/// Moves the view with several fingers, after putting back what the first of them has begun; whether
/// there are any, so that nothing else is to be done with them.
pub(super) fn pointer(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) -> bool {
    let SeveralFingers::OnView(held) = state.fingers.notice(view, places, session) else {
        return false;
    };
    control_points::put_back(session, &mut state.curves, actions);
    posing::put_back(session, &mut state.pose, actions);
    state.box_select.put_back();
    let before = state.camera_before_drag.take();
    let mut camera = before.unwrap_or(session.view().camera);
    if let Some(touch) = view.ctx.multi_touch()
        && touch.zoom_delta > 0.0
    {
        let moved = touch.translation_delta / places.points_per_pixel;
        camera.pan_with_pointer(Vec2::new(moved.x, moved.y), places.height(), held);
        camera.dolly_about(-touch.zoom_delta.ln(), held);
    }
    if camera != session.view().camera {
        actions.push(Action::View(View::SetCamera(camera)));
    }
    true
}
