use super::{Place, is_pickable};
use crate::editor::{BoneDrag, Handle, IkDrag, MoveDrag, MoveTarget, RingDrag, Session};
use crate::scene::ShapeId;
use crate::ui::pointer_use::released_at;
use crate::ui::{Action, GestureStep, ScenePlaces};
use egui::{Key, Modifiers, PointerButton, Pos2, Response};

/// A bone, a gizmo's handle, a root or a shape that was grabbed with the left button.
#[derive(Clone, Debug)]
pub(in crate::ui) struct PoseGesture {
    held: Held,
    handle: Option<Handle>,
    /// Of the picture of the scene in which it was grabbed.
    index: usize,
    /// Once it is cancelled it only waits for the buttons to be released, so that what is left of
    /// the drag does not become another gesture.
    cancelled: bool,
}

/// What follows the pointer.
#[derive(Clone, Debug)]
pub(super) enum Held {
    Bone(BoneDrag),
    Ring(RingDrag),
    Moved(MoveDrag),
    Ik(IkDrag),
    /// A joint that the IK tool cannot bring anywhere: it must not be the camera that follows.
    Stuck(ShapeId, usize),
}

impl PoseGesture {
    /// By `handle`, if a gizmo was taken; in the picture with this index.
    pub(super) fn new(held: Held, handle: Option<Handle>, index: usize) -> Self {
        Self {
            held,
            handle,
            index,
            cancelled: false,
        }
    }

    /// The handle that is held.
    pub(super) fn handle(&self) -> Option<Handle> {
        self.handle.filter(|_| !self.cancelled)
    }

    pub(super) fn shape(&self) -> ShapeId {
        match &self.held {
            Held::Bone(drag) => drag.turn().shape(),
            Held::Ring(drag) => drag.turn().shape(),
            Held::Moved(drag) => drag.target().shape(),
            Held::Ik(drag) => drag.shape(),
            Held::Stuck(shape, _) => *shape,
        }
    }

    /// The joint that is turned, brought somewhere or moved.
    pub(super) fn joint(&self) -> Option<usize> {
        match &self.held {
            Held::Bone(drag) => Some(drag.turn().joint()),
            Held::Ring(drag) => Some(drag.turn().joint()),
            Held::Moved(drag) => drag.target().joint(),
            Held::Ik(drag) => Some(drag.grip().joint()),
            Held::Stuck(_, joint) => Some(*joint),
        }
    }

    /// The joint that stands for it in words; none if all of the shape moves.
    pub(super) fn named(&self) -> Option<usize> {
        match &self.held {
            Held::Moved(drag) if matches!(drag.target(), MoveTarget::AllRoots { .. }) => None,
            _ => self.joint(),
        }
    }

    /// Whether it goes in steps while Ctrl is held.
    pub(super) fn snaps(&self) -> bool {
        !matches!(self.held, Held::Ik(_) | Held::Stuck(..))
    }

    /// What the IK tool brings somewhere; `None` for everything else, and once it is cancelled.
    pub(super) fn ik(&self) -> Option<&IkDrag> {
        match &self.held {
            Held::Ik(drag) if !self.cancelled => Some(drag),
            _ => None,
        }
    }

    /// How far it has turned or moved, in words; `None` once it is cancelled.
    pub(super) fn readout(&self) -> Option<String> {
        if self.cancelled {
            return None;
        }
        let turned = |angle: f64| format!("{:+.1}°", angle.to_degrees() + 0.0);
        Some(match &self.held {
            Held::Bone(drag) => turned(drag.angle()),
            Held::Ring(drag) => turned(drag.angle()),
            Held::Moved(drag) => {
                let by = drag.moved();
                format!("x {:+.2}  y {:+.2}  z {:+.2}", by.x, by.y, by.z)
            }
            Held::Ik(drag) if drag.off() > IkDrag::OUT_OF_REACH => {
                format!("out of reach by {:.2}", drag.off())
            }
            Held::Ik(drag) if drag.lost_pins().len() == 1 => "a pin is out of reach".to_owned(),
            Held::Ik(drag) if !drag.lost_pins().is_empty() => {
                format!("{} pins are out of reach", drag.lost_pins().len())
            }
            Held::Ik(drag) => match drag.chain().map(|chain| chain.joints().len()) {
                Some(1) => "1 joint follows".to_owned(),
                Some(count) => format!("{count} joints follow"),
                None => "all of it follows".to_owned(),
            },
            Held::Stuck(..) => "a pin holds it".to_owned(),
        })
    }

    /// Follows the pointer; whether the gesture goes on in the next frame.
    pub(super) fn go_on(
        &mut self,
        view: &Response,
        places: &ScenePlaces,
        session: &Session,
        actions: &mut Vec<Action>,
    ) -> bool {
        let hand = Hand::read(view);
        if self.cancelled {
            return hand.any_down;
        }
        if !is_pickable(session, self.shape()) {
            actions.push(Action::Gesture(GestureStep::Commit));
            self.cancelled = true;
            return hand.any_down;
        }
        if hand.cancel {
            actions.push(Action::Gesture(GestureStep::Cancel));
            self.cancelled = true;
            return hand.any_down;
        }
        let place = Place::of(places, self.index);
        if let Some((place, position)) = place.zip(hand.position) {
            let ray = place.screen(session).ray(place.pixel(position));
            let edit = match &mut self.held {
                Held::Bone(drag) => drag.update(session, &ray, hand.snap),
                Held::Ring(drag) => drag.update(session, &ray, hand.snap),
                Held::Moved(drag) => Some(drag.update(&ray, hand.snap)),
                Held::Ik(drag) => drag.update(session, &ray),
                Held::Stuck(..) => None,
            };
            actions.extend(edit.map(Action::Edit));
        }
        if !hand.left_down {
            actions.push(Action::Gesture(GestureStep::Commit));
        }
        hand.left_down
    }
}

/// What the hand does in one frame of a gesture.
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
            // Taken, so that Esc does nothing else in this frame.
            let escape = input.consume_key(Modifiers::NONE, Key::Escape);
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
