//! Drags with the Pose, Move and IK tools, and the gizmos that they can use.

use super::PoseState;
use crate::editor::{
    BoneDrag, Edit, GizmoHit, Handle, IkDrag, MoveDrag, MoveGizmo, MoveTarget, RingDrag,
    RotationGizmo, Session, Tool, root_of,
};
use crate::math::Ray;
use crate::scene::ShapeId;
use crate::ui::scene_places::Place;
use crate::ui::view_gestures::{Follow, Grab, is_pickable};
use glam::Vec2;

/// A drag of a bone, a gizmo's handle, a root or a shape.
pub(super) type PoseGesture = Grab<Held>;

/// A drag with one of the tools, and the gizmo's handle that it uses, if any.
#[derive(Clone, Debug)]
pub(in crate::ui) struct Held {
    drag: Drag,
    handle: Option<Handle>,
}

/// A drag of the object that a tool moves.
#[derive(Clone, Debug)]
pub(super) enum Drag {
    Bone(BoneDrag),
    Ring(RingDrag),
    Move(MoveDrag),
    Ik(IkDrag),
    /// A joint that the IK tool cannot move: the drag must not move the camera instead.
    Stuck(ShapeId, usize),
}

impl From<Drag> for Held {
    fn from(drag: Drag) -> Self {
        Self { drag, handle: None }
    }
}

impl Held {
    /// The gizmo's handle that it uses.
    pub(super) fn handle(&self) -> Option<Handle> {
        self.handle
    }

    /// The shape that changes.
    pub(super) fn shape(&self) -> ShapeId {
        match &self.drag {
            Drag::Bone(drag) => drag.turn().shape(),
            Drag::Ring(drag) => drag.turn().shape(),
            Drag::Move(drag) => drag.target().shape(),
            Drag::Ik(drag) => drag.shape(),
            Drag::Stuck(shape, _) => *shape,
        }
    }

    /// The joint that is turned or moved; `None` for a whole shape.
    pub(super) fn joint(&self) -> Option<usize> {
        match &self.drag {
            Drag::Bone(drag) => Some(drag.turn().joint()),
            Drag::Ring(drag) => Some(drag.turn().joint()),
            Drag::Move(drag) => drag.target().joint(),
            Drag::Ik(drag) => Some(drag.grip().joint()),
            Drag::Stuck(_, joint) => Some(*joint),
        }
    }

    /// The joint that it is named after; `None` if all of the shape moves.
    pub(super) fn named(&self) -> Option<usize> {
        match &self.drag {
            Drag::Move(drag) if matches!(drag.target(), MoveTarget::AllRoots { .. }) => None,
            _ => self.joint(),
        }
    }

    /// Whether it snaps to steps while Ctrl is held.
    pub(super) fn snaps(&self) -> bool {
        !matches!(self.drag, Drag::Ik(_) | Drag::Stuck(..))
    }

    /// The drag of the IK tool; `None` for everything else.
    pub(super) fn ik(&self) -> Option<&IkDrag> {
        match &self.drag {
            Drag::Ik(drag) => Some(drag),
            _ => None,
        }
    }

    /// By how much it has turned or moved, as text.
    pub(super) fn readout(&self) -> String {
        let turned = |angle: f64| format!("{:+.1}°", angle.to_degrees() + 0.0);
        match &self.drag {
            Drag::Bone(drag) => turned(drag.angle()),
            Drag::Ring(drag) => turned(drag.angle()),
            Drag::Move(drag) => {
                let by = drag.moved();
                format!("x {:+.2}  y {:+.2}  z {:+.2}", by.x, by.y, by.z)
            }
            Drag::Ik(drag) if drag.off() > IkDrag::OUT_OF_REACH => {
                format!("out of reach by {:.2}", drag.off())
            }
            Drag::Ik(drag) if drag.lost_pins().len() == 1 => "a pin is out of reach".to_owned(),
            Drag::Ik(drag) if !drag.lost_pins().is_empty() => {
                format!("{} pins are out of reach", drag.lost_pins().len())
            }
            Drag::Ik(drag) => match drag.chain().map(|chain| chain.joints().len()) {
                Some(1) => "1 joint follows".to_owned(),
                Some(count) => format!("{count} joints follow"),
                None => "all of it follows".to_owned(),
            },
            Drag::Stuck(..) => "a pin holds it".to_owned(),
        }
    }
}

impl Follow for Held {
    fn shape(&self) -> ShapeId {
        self.shape()
    }

    fn follow(&mut self, session: &Session, place: Place, pixel: Vec2, snap: bool) -> Option<Edit> {
        let ray = place.screen(session).ray(pixel);
        match &mut self.drag {
            Drag::Bone(drag) => drag.update(session, &ray, snap),
            Drag::Ring(drag) => drag.update(session, &ray, snap),
            Drag::Move(drag) => Some(drag.update(&ray, snap)),
            Drag::Ik(drag) => drag.update(session, &ray),
            Drag::Stuck(..) => None,
        }
    }
}

/// A gizmo in the view.
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

/// The tool's gizmo for the selection: rings for a joint with the Pose tool, arrows for its root,
/// or else for the shape, with the Move tool. `None` while something else is dragged, and for a
/// shape that is hidden or locked.
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
    /// The handle under a pixel of the picture.
    pub(super) fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        match self {
            Self::Turn { rings, .. } => rings.hit(pixel),
            Self::Move { arrows, .. } => arrows.hit(pixel),
        }
    }

    /// Begins a drag of a handle with the pointer on `ray`; with `all`, the gizmo of a root moves
    /// all roots.
    pub(super) fn take(
        &self,
        session: &Session,
        hit: GizmoHit,
        ray: &Ray,
        all: bool,
    ) -> Option<Held> {
        let drag = match (self, hit.handle) {
            (&Self::Turn { shape, joint, .. }, Handle::FreeRing) => {
                let eye = session.view().camera.eye();
                Drag::Bone(BoneDrag::begin(session, shape, joint, eye, hit.point)?)
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
                Drag::Ring(RingDrag::begin(
                    session, *shape, *joint, axis, hit.point, ray,
                )?)
            }
            (Self::Move { arrows, target }, handle) => {
                let target = if all { target.all_roots() } else { *target };
                Drag::Move(MoveDrag::begin(
                    session,
                    target,
                    arrows.along(handle)?,
                    ray,
                )?)
            }
            _ => return None,
        };
        Some(Held {
            drag,
            handle: Some(hit.handle),
        })
    }
}
