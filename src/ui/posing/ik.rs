//! The IK tool: pins, and the chain that follows a grip.

use super::held::{Drag, PoseGesture};
use crate::editor::{Edit, IkDrag, IkGrip, Screen, Session};
use crate::math::Ray;
use crate::scene::{BoneHit, IkSettings, ShapeId, ShapeKind};
use crate::ui::scene_places::Place;
use egui::Pos2;
use glam::Vec3;

/// The pinned joints of a character; none if it has none, or is none.
pub(super) fn pins(session: &Session, shape: ShapeId) -> impl Iterator<Item = usize> {
    let character = session.scene().character(shape);
    character
        .into_iter()
        .flat_map(|c| c.ik.pins.iter().copied())
}

/// The characters with pins.
pub(super) fn pinned(session: &Session) -> impl Iterator<Item = (ShapeId, &IkSettings)> {
    let shapes = session.scene().shapes().iter();
    let with_settings = shapes.filter_map(|shape| match &shape.kind {
        ShapeKind::Character(character) => Some((shape.id, &character.ik)),
        _ => None,
    });
    with_settings.filter(|(_, ik)| !ik.pins.is_empty())
}

pub(in crate::ui) fn has_pins(session: &Session) -> bool {
    with_pins(session).next().is_some()
}

/// Pins joints, or unpins them if all are pinned.
pub(in crate::ui) fn toggle_pins(
    session: &Session,
    shape: ShapeId,
    joints: &[usize],
) -> Option<Edit> {
    let mut ik = session.scene().character(shape)?.ik.clone();
    if are_pinned(session, shape, joints) {
        ik.pins.retain(|pin| !joints.contains(pin));
    } else {
        ik.pins.extend(joints);
    }
    Some(Edit::SetIk(shape, ik))
}

/// Whether all of these joints of a character are pinned.
pub(super) fn are_pinned(session: &Session, shape: ShapeId, joints: &[usize]) -> bool {
    let character = session.scene().character(shape);
    character.is_some_and(|character| {
        let pins = &character.ik.pins;
        joints.iter().all(|joint| pins.contains(joint))
    })
}

/// Unpins all joints of all characters.
pub(in crate::ui) fn unpin_all(session: &Session) -> Edit {
    Edit::Together(with_pins(session).map(Edit::UnpinAll).collect())
}

/// The characters with pins of joints that they have, or were saved to have.
fn with_pins(session: &Session) -> impl Iterator<Item = ShapeId> {
    let shapes = session.scene().shapes().iter();
    shapes.filter_map(|shape| match &shape.kind {
        ShapeKind::Character(character) if character.has_pins() => Some(shape.id),
        _ => None,
    })
}

/// Begins a drag of the grip on a bone with the pointer on `ray`.
pub(super) fn take(session: &Session, hit: &BoneHit, screen: &Screen, ray: &Ray) -> Option<Drag> {
    let grip = IkGrip::of(session, hit, screen)?;
    Some(lead(session, hit.shape, grip, ray))
}

/// Begins a drag of a grip with the pointer on `ray`.
pub(super) fn lead(session: &Session, shape: ShapeId, grip: IkGrip, ray: &Ray) -> Drag {
    let drag = IkDrag::begin(session, shape, grip, ray);
    drag.map_or(Drag::Stuck(shape, grip.joint()), Drag::Ik)
}

/// The joints that are pinned or unpinned: the hovered one, or else all that are selected, also where the hovered one is
/// among them.
pub(in crate::ui) fn joints_to_pin(session: &Session) -> Option<(ShapeId, Vec<usize>)> {
    let selected = session.selected_joints();
    let active = session.selected().filter(|_| !selected.is_empty());
    match session.hovered_bone() {
        Some((shape, joint)) if active != Some(shape) || !selected.contains(&joint) => {
            Some((shape, vec![joint]))
        }
        _ => Some((active?, selected.to_vec())),
    }
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
    hovered: Option<(ShapeId, IkGrip)>,
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
            let (shape, grip) = hovered?;
            (shape, grip, None)
        }
    };
    let joints = match held {
        Some(drag) => drag.chain().map(|chain| chain.joints().to_vec()),
        None => {
            let chain = grip.chain(session, shape);
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
