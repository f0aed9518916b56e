//! Gestures in the view: camera, selection, and the protocol of everything that is dragged.

use super::navigation::PointerMove;
use super::scene_places::{Picked, Place, ScenePlaces};
use super::{Action, GestureStep, UiState, control_points, posing};
use crate::editor::{Edit, Session, Tool, View, for_all_selected};
use crate::scene::{ShapeId, pick_shape};
use egui::{
    Event, InputState, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect, Response,
};
use glam::{Vec2, Vec3};

/// Scrolling of a touchpad, in points, that counts as one notch of a wheel.
const POINTS_PER_NOTCH: f32 = 50.0;

/// Handles the pointer over the scene: drags and the wheel move the camera according to the
/// [`super::Navigation`], and a click selects the shape under the pointer. Control points of the
/// selected curves take precedence, then gizmos and bones, and with the Move tool shapes: a left
/// drag takes what is under the pointer.
///
/// `view` is the widget that [`super::show`] returns; panels and windows over it keep the pointer
/// to themselves. `places` are the pictures of the scene in it. Returns the shape under the
/// pointer.
pub fn view_gestures(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) -> Option<ShapeId> {
    let mut pointer = PointerUse::Free;
    if state.pose.gesture.is_none() {
        pointer = control_points::pointer(view, places, session, &mut state.curves, actions);
    }
    if pointer == PointerUse::Free {
        let list = state.joints.hovered;
        pointer = posing::pointer(view, places, session, &mut state.pose, list, actions);
    }
    if pointer == PointerUse::Holding {
        return None;
    }
    put_back_on_esc(view, session, state, actions);
    let moved = pointer_move(view, places, session, &mut state.held_point);
    let camera = session.view().camera;
    let camera = state.navigation.moved(camera, view, &moved);
    if camera != session.view().camera {
        actions.push(Action::View(View::SetCamera(camera)));
    }
    if pointer == PointerUse::Over {
        return None;
    }
    if view.clicked() {
        let clicked = view.interact_pointer_pos();
        let picked = &mut state.pose.picked;
        let shape = clicked.and_then(|position| shape_at(picked, session, places, position));
        let adds = view.ctx.input(|i| i.modifiers.command || i.modifiers.shift);
        match shape {
            Some(shape) if adds => actions.push(Action::View(View::ToggleSelected(shape))),
            // A click that misses must not lose what was selected before.
            None if adds => {}
            _ => actions.push(Action::View(View::Select(shape))),
        }
        if state.pose.tool != Tool::Select {
            actions.push(Action::View(View::SelectJoint(None)));
        }
    }
    let position = view.hover_pos().filter(|_| !view.dragged())?;
    shape_at(&mut state.pose.picked, session, places, position)
}

/// What the pointer did in this frame. `held` is the point of a surface where the drag under way
/// began, if it was over one; all else is dragged as if it were as far away as the camera's target.
fn pointer_move(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    held: &mut Option<Vec3>,
) -> PointerMove {
    let in_pixels = |points: egui::Vec2| Vec2::new(points.x, points.y) / places.points_per_pixel;
    let delta = in_pixels(view.drag_delta());
    let mut all = delta;
    let pressed = view.ctx.input(|input| input.pointer.press_origin());
    if !view.dragged() {
        *held = None;
    } else if view.drag_started()
        && let Some((pressed, now)) = pressed.zip(view.interact_pointer_pos())
    {
        // egui recognizes a drag only after some pixels, which must not be lost.
        all = in_pixels(now - pressed);
        *held = places.at(pressed).and_then(|place| {
            let camera = &session.view().camera;
            let ray = camera.ray(place.pixel(pressed), place.size());
            pick_shape(session.evaluated(), &ray).map(|(_, distance)| ray.at(distance))
        });
    }
    let height = places.rects.first().map_or(1.0, Rect::height) / places.points_per_pixel;
    PointerMove {
        delta,
        all,
        held: held.unwrap_or(session.view().camera.target),
        height: height.max(1.0),
        notches: if view.hovered() {
            notches(&view.ctx)
        } else {
            0.0
        },
    }
}

/// Remembers the camera before a drag, and restores it on Esc, which ends the drag in egui.
fn put_back_on_esc(
    view: &Response,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    if view.dragged() {
        state
            .camera_before_drag
            .get_or_insert(session.view().camera);
    } else if let Some(before) = state.camera_before_drag.take() {
        let escape = view
            .ctx
            .input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        if escape {
            actions.push(Action::View(View::SetCamera(before)));
        }
    }
}

fn shape_at(
    picked: &mut Picked,
    session: &Session,
    places: &ScenePlaces,
    position: Pos2,
) -> Option<ShapeId> {
    let place = places.at(position)?;
    picked.shape_at(session, place.pixel(position), place.size())
}

/// Notches of the wheel since the last frame. egui's smoothing would spread a notch over several
/// frames, but the course's editor zooms by whole notches.
fn notches(context: &egui::Context) -> f32 {
    context.input(|input| {
        let wheel = input.events.iter().map(|event| match event {
            Event::MouseWheel {
                unit: MouseWheelUnit::Point,
                delta,
                ..
            } => delta.y / POINTS_PER_NOTCH,
            Event::MouseWheel { delta, .. } => delta.y,
            _ => 0.0,
        });
        wheel.sum()
    })
}

/// How a kind of thing in the view uses the pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PointerUse {
    /// Not at all.
    Free,
    /// One is under it, and takes its clicks and left drags.
    Over,
    /// One is being dragged; nothing else uses the pointer.
    Holding,
}

/// Something that follows the pointer while it is dragged.
pub(super) trait Follow {
    /// The shape that it changes.
    fn shape(&self) -> ShapeId;

    /// Edit that brings it to the pointer at `pixel` of a picture, if that changes anything; in
    /// steps if `snap`.
    fn follow(&mut self, session: &Session, place: Place, pixel: Vec2, snap: bool) -> Option<Edit>;
}

/// A drag of something in the view, from the press of the left button to its release.
#[derive(Clone, Debug)]
pub(super) struct Grab<H> {
    held: H,
    /// Index of the picture of the scene in which it was grabbed.
    index: usize,
    /// A drag that ended early waits for the buttons to be released, so that the rest of it does
    /// not become another gesture.
    ended: bool,
}

impl<H> Grab<H> {
    /// Begins a gesture if a left drag began in this frame and `take` grabs something, at the pixel
    /// of a picture where the button went down: egui recognizes a drag only once the pointer has
    /// moved. Actions of `take` come before the gesture.
    pub(super) fn begin(
        view: &Response,
        places: &ScenePlaces,
        actions: &mut Vec<Action>,
        take: impl FnOnce(Place, Vec2, &mut Vec<Action>) -> Option<H>,
    ) -> Option<Self> {
        if !view.drag_started_by(PointerButton::Primary) {
            return None;
        }
        let pressed = view.ctx.input(|input| input.pointer.press_origin())?;
        let index = places.index_at(pressed)?;
        let place = places.get(index)?;
        let held = take(place, place.pixel(pressed), actions)?;
        actions.push(Action::Gesture(GestureStep::Begin));
        Some(Self {
            held,
            index,
            ended: false,
        })
    }

    /// The thing that was grabbed.
    pub(super) fn held(&self) -> &H {
        &self.held
    }

    /// The thing that was grabbed, unless the drag ended early.
    pub(super) fn active(&self) -> Option<&H> {
        Some(&self.held).filter(|_| !self.ended)
    }
}

impl<H: Follow> Grab<H> {
    /// Follows the pointer, and commits or cancels the gesture; whether to go on in the next frame.
    pub(super) fn follow(
        &mut self,
        view: &Response,
        places: &ScenePlaces,
        session: &Session,
        actions: &mut Vec<Action>,
    ) -> bool {
        let hand = Hand::read(view);
        if self.ended {
            return hand.any_down;
        }
        let early = if !is_pickable(session, self.held.shape()) {
            Some(GestureStep::Commit)
        } else {
            hand.cancel.then_some(GestureStep::Cancel)
        };
        if let Some(step) = early {
            actions.push(Action::Gesture(step));
            self.ended = true;
            return hand.any_down;
        }
        if let Some((place, position)) = places.get(self.index).zip(hand.position) {
            let pixel = place.pixel(position);
            let edit = self.held.follow(session, place, pixel, hand.snap);
            actions.extend(edit.map(|edit| Action::Edit(for_all_selected(session, edit))));
        }
        if !hand.left_down {
            actions.push(Action::Gesture(GestureStep::Commit));
        }
        hand.left_down
    }
}

/// Whether gestures in the view may change a shape: it is neither hidden nor locked.
pub(super) fn is_pickable(session: &Session, shape: ShapeId) -> bool {
    let evaluated = session.evaluated().shape(shape);
    evaluated.is_some_and(|shape| shape.pickable)
}

/// Input to a drag in one frame.
struct Hand {
    position: Option<Pos2>,
    cancel: bool,
    left_down: bool,
    any_down: bool,
    snap: bool,
}

impl Hand {
    fn read(view: &Response) -> Self {
        let position = view.interact_pointer_pos();
        view.ctx.input_mut(|input| {
            // Consumed, so that these keys do nothing else in this frame.
            let escape = input.consume_key(Modifiers::NONE, Key::Escape)
                || input.consume_key(Modifiers::COMMAND, Key::Z);
            let pointer = &input.pointer;
            Self {
                position: released_at(input).or(position),
                cancel: escape || pointer.button_pressed(PointerButton::Secondary),
                left_down: pointer.primary_down(),
                any_down: pointer.any_down(),
                snap: input.modifiers.command,
            }
        })
    }
}

/// Where the left button was released in this frame: the pointer may have moved since.
fn released_at(input: &InputState) -> Option<Pos2> {
    input.events.iter().find_map(|event| match event {
        Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed: false,
            ..
        } => Some(*pos),
        _ => None,
    })
}
