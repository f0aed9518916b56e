use super::gesture::{Held, PoseGesture};
use super::{Place, PoseState, is_pickable};
use crate::editor::{
    BoneDrag, GizmoHit, Handle, MoveDrag, MoveGizmo, MoveTarget, RingDrag, RotationGizmo, Session,
    Tool, root_of,
};
use crate::math::Ray;
use crate::scene::ShapeId;
use glam::Vec2;

/// The gizmo that is shown.
#[derive(Clone, Debug)]
pub(super) enum Gizmo {
    Turn {
        rings: RotationGizmo,
        shape: ShapeId,
        joint: usize,
    },
    Move {
        arrows: MoveGizmo,
        target: MoveTarget,
    },
}

/// The tool's gizmo for what is selected: rings for a joint with the Pose tool, arrows for the
/// root above it or else for the shape with the Move tool. None while something else is held, and
/// none for a shape that is hidden or locked.
pub(super) fn shown(session: &Session, state: &PoseState, place: Place) -> Option<Gizmo> {
    let holding = state.gesture.as_ref();
    if holding.is_some_and(|gesture| gesture.handle().is_none()) {
        return None;
    }
    let shape = session.selected().filter(|&id| is_pickable(session, id))?;
    let joint = session.selected_joint();
    match state.tool {
        Tool::Select | Tool::Ik => None,
        Tool::Pose => {
            let joint = joint.filter(|&joint| state.without_gizmo != Some((shape, joint)))?;
            let rings = RotationGizmo::new(session, shape, joint, state.axes, place.size())?;
            Some(Gizmo::Turn {
                rings,
                shape,
                joint,
            })
        }
        Tool::Move => {
            let target = match joint {
                Some(joint) => MoveTarget::Root {
                    shape,
                    joint: root_of(session, shape, joint)?,
                },
                None => MoveTarget::Shape(shape),
            };
            let arrows = MoveGizmo::new(session, target, state.axes, place.size())?;
            Some(Gizmo::Move { arrows, target })
        }
    }
}

impl Gizmo {
    /// The handle under a point of the picture.
    pub fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        match self {
            Self::Turn { rings, .. } => rings.hit(pixel),
            Self::Move { arrows, .. } => arrows.hit(pixel),
        }
    }

    /// Takes a handle with the cursor on `ray`; with `all`, that of a root moves all of
    /// them. The cursor is in the picture with this index.
    pub fn take(
        &self,
        session: &Session,
        hit: GizmoHit,
        ray: &Ray,
        all: bool,
        index: usize,
    ) -> Option<PoseGesture> {
        let held = match (self, hit.handle) {
            (&Self::Turn { shape, joint, .. }, Handle::FreeRing) => {
                let eye = session.view().camera.eye();
                Held::Bone(BoneDrag::begin(session, shape, joint, eye, hit.point)?)
            }
            (
                Self::Turn {
                    rings,
                    shape,
                    joint,
                },
                Handle::Ring(axis),
            ) => {
                let axis = rings.axis(axis)?;
                Held::Ring(RingDrag::begin(
                    session, *shape, *joint, axis, hit.point, ray,
                )?)
            }
            (Self::Move { arrows, target }, handle) => {
                let target = if all { target.all_roots() } else { *target };
                Held::Moved(MoveDrag::begin(
                    session,
                    target,
                    arrows.along(handle)?,
                    ray,
                )?)
            }
            _ => return None,
        };
        Some(PoseGesture::new(held, Some(hit.handle), index))
    }
}
