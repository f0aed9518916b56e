//! The IK tool: its settings, pins, and the chain that follows a grip.

use super::held::{Drag, PoseGesture};
use crate::editor::{IkDrag, IkGrip, IkSettings, Screen, Session};
use crate::math::Ray;
use crate::scene::{BoneHit, ShapeId};
use crate::ui::scene_places::Place;
use egui::Pos2;
use glam::Vec3;
use std::collections::{BTreeSet, HashMap};

/// State of the IK tool.
#[derive(Clone, Debug, Default)]
pub(in crate::ui) struct IkState {
    /// Settings chosen in the tool bar, without pins.
    pub chosen: IkSettings,
    /// The character and its grip under the pointer in the view, while nothing is dragged.
    pub hovered: Option<(ShapeId, IkGrip)>,
    /// Pinned joints of each character that has any.
    pins: HashMap<ShapeId, BTreeSet<usize>>,
}

impl IkState {
    /// Settings with the pins of one character.
    pub fn settings(&self, shape: ShapeId) -> IkSettings {
        IkSettings {
            pins: self.pins(shape).cloned().unwrap_or_default(),
            ..self.chosen.clone()
        }
    }

    /// The pinned joints of a character, if it has any.
    pub fn pins(&self, shape: ShapeId) -> Option<&BTreeSet<usize>> {
        self.pins.get(&shape)
    }

    /// All characters with pins.
    pub fn pinned(&self) -> impl Iterator<Item = (ShapeId, &BTreeSet<usize>)> {
        self.pins.iter().map(|(&shape, pins)| (shape, pins))
    }

    pub fn is_pinned(&self, shape: ShapeId, joint: usize) -> bool {
        self.pins(shape).is_some_and(|pins| pins.contains(&joint))
    }

    /// Pins a joint, or unpins it.
    pub fn toggle_pin(&mut self, shape: ShapeId, joint: usize) {
        let pins = self.pins.entry(shape).or_default();
        if !pins.remove(&joint) {
            pins.insert(joint);
        }
        if pins.is_empty() {
            self.pins.remove(&shape);
        }
    }

    /// The settings alone, without pins.
    pub fn without_pins(&self) -> Self {
        Self {
            chosen: self.chosen.clone(),
            ..Self::default()
        }
    }

    pub fn unpin_all(&mut self) {
        self.pins.clear();
    }

    pub fn has_pins(&self) -> bool {
        !self.pins.is_empty()
    }

    /// Begins a drag of the grip on a bone with the pointer on `ray`.
    pub(super) fn take(
        &self,
        session: &Session,
        hit: &BoneHit,
        screen: &Screen,
        ray: &Ray,
    ) -> Option<Drag> {
        let grip = IkGrip::of(session, hit, screen)?;
        let settings = self.settings(hit.shape);
        let drag = IkDrag::begin(session, hit.shape, grip, &settings, ray);
        let stuck = Drag::Stuck(hit.shape, grip.joint());
        Some(drag.map_or(stuck, Drag::Ik))
    }
}

/// The joint that is pinned or unpinned: the hovered one, or else the selected one.
pub(in crate::ui) fn joint_to_pin(session: &Session) -> Option<(ShapeId, usize)> {
    let selected = session.selected().zip(session.selected_joint());
    session.hovered_bone().or(selected)
}

/// Drops pins of characters that were deleted.
pub(super) fn forget_gone(session: &Session, state: &mut IkState) {
    let exists = |shape: &ShapeId| session.scene().character(*shape).is_some();
    state.pins.retain(|shape, _| exists(shape));
}

/// The grip that is dragged or hovered, and the joints of the chain that follows it, root first; in
/// points of the window.
pub(super) struct Followed {
    pub chain: Vec<Pos2>,
    pub grip: Pos2,
    /// Target of the grip, if it is dragged and does not reach it.
    pub missed: Option<Pos2>,
}

/// Distance in points from which on a grip is shown to miss its target.
const MISSED: f32 = 2.0;

fn dragged(gesture: &PoseGesture) -> Option<&IkDrag> {
    gesture.active()?.ik()
}

/// Pins that cannot be reached during a drag: where they are, and where they should be.
pub(super) fn lost_pins(
    session: &Session,
    gesture: Option<&PoseGesture>,
    place: Place,
) -> Vec<(Pos2, Pos2)> {
    let Some(drag) = gesture.and_then(dragged) else {
        return Vec::new();
    };
    let Some(shape) = session.evaluated().shape(drag.shape()) else {
        return Vec::new();
    };
    let screen = place.screen(session);
    let position = |world| Some(place.position(screen.pixel(world)?));
    let ends = |&(pin, wanted): &(usize, Vec3)| {
        let now = IkGrip::Joint(pin).place(session, drag.shape())?;
        let wanted = shape.world_from_model.transform_point3(wanted);
        Some((position(now)?, position(wanted)?))
    };
    drag.lost_pins().iter().filter_map(ends).collect()
}

/// The grip and the chain to mark in the view; `None` if no grip is dragged or hovered.
pub(super) fn followed(
    session: &Session,
    state: &IkState,
    gesture: Option<&PoseGesture>,
    place: Place,
) -> Option<Followed> {
    let screen = place.screen(session);
    let position = |world| Some(place.position(screen.pixel(world)?));
    let (shape, grip, held) = match gesture.map(dragged) {
        Some(drag) => {
            let drag = drag?;
            (drag.shape(), drag.grip(), Some(drag))
        }
        None => {
            let (shape, grip) = state.hovered?;
            (shape, grip, None)
        }
    };
    let joints = match held {
        Some(drag) => drag.chain().map(|chain| chain.joints().to_vec()),
        None => {
            let chain = grip.chain(session, shape, &state.settings(shape));
            chain.map(|chain| chain.joints().to_vec())
        }
    };
    let at_joint = |&joint: &usize| position(IkGrip::Joint(joint).place(session, shape)?);
    let grip = position(grip.place(session, shape)?)?;
    let target = held.and_then(|drag| position(drag.target()));
    Some(Followed {
        chain: joints.iter().flatten().filter_map(at_joint).collect(),
        grip,
        missed: target.filter(|target| target.distance(grip) > MISSED),
    })
}
