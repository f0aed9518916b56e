//! The gizmo of the chosen tool for the selection.

use super::held::{Drag, Held};
use super::{PoseState, ik, selected_root};
use crate::editor::{
    BoneDrag, GizmoHit, Handle, IkGrip, MoveDrag, MoveGizmo, MoveTarget, RingDrag, RotationGizmo,
    ScaleBy, ScaleGizmo, Session, ShapeGroup, ShapeScale, ShapeTurn, Tool, selected_roots,
};
use crate::math::Ray;
use crate::scene::ShapeId;
use crate::ui::grab::is_pickable;
use crate::ui::scene_places::Place;
use glam::Vec2;

/// A gizmo in the view.
#[derive(Clone, Debug)]
pub(super) enum Gizmo {
    Turn {
        rings: RotationGizmo,
        shape: ShapeId,
        joint: usize,
    },
    TurnShapes(RotationGizmo),
    Move {
        arrows: MoveGizmo,
        target: MoveTarget,
    },
    Scale(ScaleGizmo),
}

/// The tool's gizmo for the selection: rings for a joint with the Pose tool, arrows for a root
/// that is selected, or else for the shape, with the Move tool, rings and handles for the shapes with the Rotate and
/// the Scale tool. `None` while something else is dragged, and for a shape that is hidden or locked.
pub(super) fn shown_gizmo(session: &Session, state: &PoseState, place: Place) -> Option<Gizmo> {
    if state.gesture.is_some() && state.held_handle().is_none() {
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
            let target = move_target(session, shape);
            let arrows = MoveGizmo::new(session, target, state.axes, place.size())?;
            Some(Gizmo::Move { arrows, target })
        }
        Tool::Rotate => {
            RotationGizmo::of_shapes(session, state.axes, place.size()).map(Gizmo::TurnShapes)
        }
        Tool::Scale => ScaleGizmo::new(session, place.size()).map(Gizmo::Scale),
    }
}

/// What the Move tool moves of the active shape: the selected joint, if that is a root, or else the shape.
fn move_target(session: &Session, shape: ShapeId) -> MoveTarget {
    match selected_root(session, shape) {
        Some(joint) => MoveTarget::Root { shape, joint },
        None => MoveTarget::Shape(shape),
    }
}

impl Gizmo {
    /// The handle under a pixel of the picture.
    fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        match self {
            Self::Turn { rings, .. } | Self::TurnShapes(rings) => rings.hit(pixel),
            Self::Move { arrows, .. } => arrows.hit(pixel),
            Self::Scale(handles) => handles.hit(pixel),
        }
    }

    /// The same unless a bone is there, too, that the handle looks like, or that the circle in the middle of a figure's
    /// arrows lies over, as over its root: who points at that means the bone.
    pub(super) fn hit_beside_bones(
        &self,
        pixel: Vec2,
        is_bone: impl FnOnce() -> bool,
    ) -> Option<GizmoHit> {
        let hit = self.hit(pixel)?;
        let yields = match self {
            Self::Turn { rings, .. } => rings.looks_like_bone(hit.handle, pixel),
            Self::Move { target, .. } => {
                matches!(target, MoveTarget::Shape(_)) && hit.handle == Handle::Center
            }
            _ => false,
        };
        (!yields || !is_bone()).then_some(hit)
    }

    /// Begins a drag of a handle with the pointer at a pixel of `place`; with `all`, the gizmo of a
    /// root moves all roots.
    pub(super) fn take(
        &self,
        session: &Session,
        state: &PoseState,
        place: Place,
        (hit, pixel): (GizmoHit, Vec2),
        all: bool,
    ) -> Option<Held> {
        let ray = place.screen(session).ray(pixel);
        let drag = match (self, hit.handle) {
            (&Self::Turn { shape, joint, .. }, Handle::FreeRing) => {
                let eye = session.view().camera.eye();
                Drag::Bone(BoneDrag::begin(
                    session,
                    shape,
                    joint,
                    (eye, hit.point),
                    state.together,
                )?)
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
                let grabbed = hit.point;
                Drag::Ring(RingDrag::begin(
                    session,
                    *shape,
                    *joint,
                    axis,
                    (grabbed, &ray),
                    state.together,
                )?)
            }
            (Self::TurnShapes(rings), handle) => {
                let group = ShapeGroup::of_selected(session)?;
                Drag::Turn(turn_shapes(session, rings, group, (handle, hit), &ray)?)
            }
            (Self::Move { arrows, target }, handle) => {
                let target = if all { target.all_roots() } else { *target };
                let along = arrows.along(handle)?;
                Drag::Move(MoveDrag::begin(session, target, along, &ray)?)
            }
            (Self::Scale(_), handle) => Drag::Scale(scale_shapes(session, place, handle, &ray)?),
            _ => return None,
        };
        Some(Held::new(drag, Some(hit.handle), ray, state.axes))
    }
}

fn turn_shapes(
    session: &Session,
    rings: &RotationGizmo,
    group: ShapeGroup,
    (handle, hit): (Handle, GizmoHit),
    ray: &Ray,
) -> Option<ShapeTurn> {
    match handle {
        Handle::Ring(axis) => ShapeTurn::begin(group, rings.axis(axis)?, hit.point, ray),
        _ => ShapeTurn::about_view(group, session.view().camera.forward(), ray),
    }
}

/// Scaling of the selected shapes by a handle: along its axis, by the distance from the pivot, or
/// from the middle twice for each such distance as a handle is long.
fn scale_shapes(session: &Session, place: Place, handle: Handle, ray: &Ray) -> Option<ShapeScale> {
    let group = ShapeGroup::of_selected(session)?;
    let by = match handle {
        Handle::Arrow(axis) => ScaleBy::Axis(axis),
        Handle::Center => {
            let per_pixel = place.screen(session).world_per_pixel(group.pivot())?;
            ScaleBy::Doubling(RotationGizmo::RADIUS * per_pixel)
        }
        _ => ScaleBy::Distance,
    };
    let camera = &session.view().camera;
    let across = (camera.right(), camera.up());
    Some(ShapeScale::begin(group, by, across, ray))
}

/// Begins what a tool does to the selection with the pointer anywhere, which then moves it without
/// a button: the control point that was clicked last, of a curve of the active shape, is moved; the
/// selected joint is turned, led by inverse kinematics or its root moved where the tool for bones is
/// chosen; else the shapes are moved, turned or scaled.
pub(super) fn begin_by_key(
    session: &Session,
    state: &PoseState,
    (does, point): (Tool, Option<(ShapeId, usize, usize)>),
    place: Place,
    pixel: Vec2,
) -> Option<Held> {
    let ray = place.screen(session).ray(pixel);
    let camera = &session.view().camera;
    let shape = session.selected().filter(|&id| is_pickable(session, id))?;
    let joint = session
        .selected_joint()
        .filter(|_| state.tool.takes_bones());
    let drag = match (does, joint) {
        (Tool::Move, Some(joint)) if state.tool == Tool::Ik && point.is_none() => {
            let screen = place.screen(session);
            // The end that was clicked last, or else the joint.
            let clicked = state.taken.filter(|hit| hit.shape == shape);
            let clicked = clicked.and_then(|hit| IkGrip::of(session, &hit, &screen));
            let grip = clicked.filter(|grip| grip.joint() == joint);
            ik::lead(session, shape, grip.unwrap_or(IkGrip::Joint(joint)), &ray)
        }
        (Tool::Move, _) => {
            let target = match (joint, point) {
                (_, Some((shape, curve, point))) => MoveTarget::ControlPoint {
                    shape,
                    curve,
                    point,
                },
                (Some(_), None) => {
                    selected_roots(session, shape).unwrap_or(MoveTarget::Shape(shape))
                }
                (None, None) => MoveTarget::Shape(shape),
            };
            let along = target.free(session);
            Drag::Move(MoveDrag::begin_anywhere(session, target, along, &ray)?)
        }
        (Tool::Rotate, Some(joint)) => {
            let eye = camera.eye();
            let point = ray.at(1.0);
            Drag::Bone(BoneDrag::begin(
                session,
                shape,
                joint,
                (eye, point),
                state.together,
            )?)
        }
        (Tool::Rotate, None) => {
            let group = ShapeGroup::of_selected(session)?;
            Drag::Turn(ShapeTurn::about_view(group, camera.forward(), &ray)?)
        }
        (Tool::Scale, _) => {
            let group = ShapeGroup::of_selected(session)?;
            let across = (camera.right(), camera.up());
            Drag::Scale(ShapeScale::begin(group, ScaleBy::Distance, across, &ray))
        }
        (Tool::Select | Tool::Pose | Tool::Ik, _) => return None,
    };
    Some(Held::by_key(drag, ray, state.axes))
}
