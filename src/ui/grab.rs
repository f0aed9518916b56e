//! The protocol of everything that is dragged in the view.

use super::scene_places::{Place, ScenePlaces};
use super::widgets::forget_buttons;
use super::{Action, GestureStep};
use crate::editor::{Edit, Session, for_all_in_view};
use crate::scene::ShapeId;
use egui::{Event, InputState, Key, Modifiers, PointerButton, Pos2, Response};
use glam::Vec2;

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

    /// Whether it was ended by the keyboard, and its changes are to be kept.
    fn is_confirmed(&self) -> bool {
        false
    }

    /// Whether it follows by a tenth of the way while Shift is held.
    fn is_finer_with_shift(&self) -> bool {
        false
    }
}

/// Part of its way by which the pointer moves a thing with Shift.
const FINE: f32 = 0.1;

/// A drag of something in the view, from the press of the left button to its release; or from a key
/// to a click or Enter.
#[derive(Clone, Debug)]
pub(super) struct Grab<H> {
    held: H,
    /// Index of the picture of the scene in which it was grabbed.
    index: usize,
    /// Whether it follows the pointer without a button.
    by_key: bool,
    /// The pointer in the last frame, as a pixel.
    last: Option<Vec2>,
    /// From the pointer to where the thing follows it, in pixels: what Shift has held back.
    held_back: Vec2,
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
        let index = places.live_index_at(pressed)?;
        let place = places.get(index)?;
        let held = take(place, place.pixel(pressed), actions)?;
        actions.push(Action::Gesture(GestureStep::Begin));
        Some(Self {
            held,
            index,
            by_key: false,
            last: None,
            held_back: Vec2::ZERO,
            ended: false,
        })
    }

    /// Begins a gesture that a key asked for and that goes on without a button, in the picture
    /// under the pointer or else the first one, if `take` grabs something with the pointer there. It begins with
    /// `step`.
    pub(super) fn begin_by_key(
        view: &Response,
        places: &ScenePlaces,
        (step, actions): (GestureStep, &mut Vec<Action>),
        take: impl FnOnce(Place, Vec2) -> Option<H>,
    ) -> Option<Self> {
        let pointer = view.ctx.input(|input| input.pointer.latest_pos());
        let index = pointer.and_then(|at| places.index_at(at)).unwrap_or(0);
        let place = places.get(index)?;
        let pixel = place.pixel(pointer.unwrap_or(place.rect.center()));
        let held = take(place, pixel)?;
        actions.push(Action::Gesture(step));
        Some(Self {
            held,
            index,
            by_key: true,
            last: Some(pixel),
            held_back: Vec2::ZERO,
            ended: false,
        })
    }

    /// The thing that was grabbed, to take keys.
    pub(super) fn held_mut(&mut self) -> &mut H {
        &mut self.held
    }

    /// The thing that was grabbed.
    pub(super) fn held(&self) -> &H {
        &self.held
    }

    /// Ends the gesture, whatever is held, and puts back what it has changed.
    pub(super) fn put_back(self, actions: &mut Vec<Action>) {
        if !self.ended {
            actions.push(Action::Gesture(GestureStep::Cancel));
        }
    }

    /// Whether a key began it, so that no button is held.
    pub(super) fn is_by_key(&self) -> bool {
        self.by_key
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
        let hand = Hand::read(view, self.by_key);
        if self.ended {
            return hand.any_down;
        }
        // Behind a question the pointer is on its way to the answer.
        let is_covered = view.ctx.memory(|memory| memory.top_modal_layer().is_some());
        let early = if is_covered || !is_pickable(session, self.held.shape()) {
            Some(GestureStep::Commit)
        } else {
            hand.cancel.then_some(GestureStep::Cancel)
        };
        if let Some(step) = early {
            if hand.right_pressed {
                forget_buttons(&view.ctx);
            }
            return self.end(step, &hand, actions);
        }
        let place = places.get(self.index);
        let pointed = place.zip(hand.position).map(|(place, at)| place.pixel(at));
        if let Some((place, pixel)) = place.zip(pointed.or(self.last)) {
            let way = pixel - self.last.unwrap_or(pixel);
            if hand.fine && self.held.is_finer_with_shift() {
                self.held_back -= way * (1.0 - FINE);
            }
            self.last = Some(pixel);
            let followed = pixel + self.held_back;
            let edit = self.held.follow(session, place, followed, hand.snap);
            actions.extend(edit.map(|edit| Action::Edit(for_all_in_view(session, edit))));
        }
        let released = !self.by_key && !hand.left_down;
        let clicked = self.by_key && hand.left_pressed;
        if clicked {
            forget_buttons(&view.ctx);
        }
        if released || clicked || self.held.is_confirmed() {
            return self.end(GestureStep::Commit, &hand, actions);
        }
        true
    }

    /// Ends the gesture; whether buttons are still held, which must not begin another one.
    fn end(&mut self, step: GestureStep, hand: &Hand, actions: &mut Vec<Action>) -> bool {
        actions.push(Action::Gesture(step));
        self.ended = true;
        hand.any_down
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
    left_pressed: bool,
    right_pressed: bool,
    any_down: bool,
    snap: bool,
    fine: bool,
}

impl Hand {
    /// `without_button`: the pointer counts wherever it is.
    fn read(view: &Response, without_button: bool) -> Self {
        let position = view.interact_pointer_pos();
        view.ctx.input_mut(|input| {
            // Consumed, so that these keys do nothing else in this frame.
            let escape = input.consume_key(Modifiers::NONE, Key::Escape)
                || input.consume_key(Modifiers::COMMAND, Key::Z);
            let pointer = &input.pointer;
            let anywhere = pointer.latest_pos().filter(|_| without_button);
            let right_pressed = pointer.button_pressed(PointerButton::Secondary);
            Self {
                position: released_at(input).or(anywhere).or(position),
                cancel: escape || right_pressed,
                left_down: pointer.primary_down(),
                left_pressed: pointer.primary_pressed(),
                right_pressed,
                any_down: pointer.any_down(),
                snap: input.modifiers.command,
                fine: input.modifiers.shift,
            }
        })
    }
}

/// Where the left button was released in this frame: the pointer may have moved since.
pub(super) fn released_at(input: &InputState) -> Option<Pos2> {
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
