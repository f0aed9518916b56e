//! Drags with the tools: what is held, and how it follows the pointer or what is typed.

use super::typed::Typed;
use crate::editor::{
    BoneDrag, Constraint, Edit, GizmoAxes, Handle, IkDrag, JointTurn, MoveAlong, MoveDrag,
    MoveTarget, RingDrag, Session, ShapeScale, ShapeTurn,
};
use crate::math::Ray;
use crate::scene::ShapeId;
use crate::ui::grab::{Follow, Grab};
use crate::ui::scene_places::Place;
use glam::{Vec2, Vec3};

/// A drag of a bone, a gizmo's handle, a root or a shape.
pub(super) type PoseGesture = Grab<Held>;

/// A drag with one of the tools, the gizmo's handle that it uses, if any, and what was typed.
#[derive(Clone, Debug)]
pub(in crate::ui) struct Held {
    /// As it began, without an axis or a plane that was typed.
    begun: Drag,
    pub(super) drag: Drag,
    handle: Option<Handle>,
    /// The pointer at the start.
    pointer: Ray,
    /// Axes of the gizmos.
    pub(super) axes: GizmoAxes,
    pub(super) typed: Typed,
    /// Whether a key began it.
    by_key: bool,
    /// Whether anything was asked for yet: a pointer that rests where it took hold changes nothing, not even by
    /// rounding.
    has_begun: bool,
}

/// A drag of the object that a tool moves.
#[derive(Clone, Debug)]
pub(super) enum Drag {
    Bone(BoneDrag),
    Ring(RingDrag),
    Move(MoveDrag),
    Turn(ShapeTurn),
    Scale(ShapeScale),
    Ik(IkDrag),
    /// A joint that the IK tool cannot move: the drag must not move the camera instead.
    Stuck(ShapeId, usize),
}

impl Held {
    /// A drag that began with the pointer on `pointer`, while gizmos had these axes.
    pub(super) fn new(drag: Drag, handle: Option<Handle>, pointer: Ray, axes: GizmoAxes) -> Self {
        Self {
            begun: drag.clone(),
            drag,
            handle,
            pointer,
            axes,
            typed: Typed::default(),
            by_key: false,
            has_begun: false,
        }
    }

    /// The same for one that a key begins, which no button holds.
    pub(super) fn by_key(drag: Drag, pointer: Ray, axes: GizmoAxes) -> Self {
        Self {
            by_key: true,
            ..Self::new(drag, None, pointer, axes)
        }
    }

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
            Drag::Turn(drag) => drag.group().active(),
            Drag::Scale(drag) => drag.group().active(),
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
            Drag::Turn(_) | Drag::Scale(_) => None,
            Drag::Ik(drag) => Some(drag.grip().joint()),
            Drag::Stuck(_, joint) => Some(*joint),
        }
    }

    /// Index of the control point that is moved, if one is.
    pub(super) fn point(&self) -> Option<usize> {
        match &self.drag {
            Drag::Move(drag) => match drag.target() {
                MoveTarget::ControlPoint { point, .. } => Some(point),
                _ => None,
            },
            _ => None,
        }
    }

    /// The joint that it is named after; `None` if all of the shape moves.
    pub(super) fn named(&self) -> Option<usize> {
        match &self.drag {
            Drag::Move(drag) if matches!(drag.target(), MoveTarget::AllRoots { .. }) => None,
            _ => self.joint(),
        }
    }

    /// Whether it snaps to steps while Ctrl is held, and takes numbers and axes that are typed.
    pub(super) fn snaps(&self) -> bool {
        !matches!(self.drag, Drag::Stuck(..))
    }

    /// The drag of the IK tool; `None` for everything else.
    pub(super) fn ik(&self) -> Option<&IkDrag> {
        match &self.drag {
            Drag::Ik(drag) => Some(drag),
            _ => None,
        }
    }

    /// Whether it is turned.
    pub(super) fn turns(&self) -> bool {
        matches!(self.drag, Drag::Bone(_) | Drag::Ring(_) | Drag::Turn(_))
    }

    /// Takes what is typed for it in this frame.
    pub(super) fn take_keys(&mut self, ctx: &egui::Context) {
        if self.snaps() {
            self.typed.take_keys(ctx);
        }
    }

    /// The axes that were typed: 0 for x, 1 for y, 2 for z, each with its direction in the world and
    /// the point that it goes through. Both axes of a plane, but the one that things turn about.
    pub(super) fn typed_axes(&self, session: &Session) -> Vec<(usize, Vec3, Vec3)> {
        let Some((constraint, axes)) = self.typed.constraint(self.axes) else {
            return Vec::new();
        };
        let line = |axis: usize| match &self.drag {
            Drag::Ring(drag) if axis == constraint.named() => {
                let turn = drag.turn();
                let shape = session.evaluated().shape(turn.shape())?;
                let own = turn.axis(axes, axis)?.as_vec3();
                let direction = shape.world_from_model.transform_vector3(own);
                let center = turn.world_center().as_vec3();
                Some((axis, direction.try_normalize()?, center))
            }
            Drag::Turn(drag) if axis == constraint.named() => {
                Some((axis, drag.group().axis(axes, axis), drag.group().pivot()))
            }
            Drag::Scale(drag) if constraint.axes().any(|free| free == axis) => {
                let own = drag.group().axis(GizmoAxes::Local, axis);
                Some((axis, own, drag.group().pivot()))
            }
            Drag::Move(drag) if constraint.axes().any(|free| free == axis) => {
                let direction = move_axis(session, drag.target().shape(), axes, axis)?;
                Some((axis, direction, drag.target().place(session)?))
            }
            Drag::Ik(drag) if constraint.axes().any(|free| free == axis) => {
                let direction = move_axis(session, drag.shape(), axes, axis)?;
                Some((axis, direction, drag.target()))
            }
            _ => None,
        };
        (0..3).filter_map(line).collect()
    }

    /// Sign that an angle has where it is shown and typed: about an axis that was typed that of the
    /// turn about it, else that of the number in the panel. By a key it is positive clockwise in the picture, as in
    /// Blender, and so about the axis away from the eye.
    pub(super) fn sign(&self) -> f64 {
        match &self.drag {
            _ if self.by_key || self.typed.constraint(self.axes).is_some() => 1.0,
            Drag::Bone(drag) => drag.panel_sign(),
            Drag::Ring(drag) => drag.panel_sign(),
            Drag::Turn(drag) => drag.panel_sign(),
            Drag::Move(_) | Drag::Scale(_) | Drag::Ik(_) | Drag::Stuck(..) => 1.0,
        }
    }

    /// Brings the kind of the drag up to the axis or the plane that was typed.
    fn constrain(&mut self, session: &Session) {
        let typed = self.typed.constraint(self.axes);
        let constrained = typed.and_then(|typed| self.begun.along(session, typed, &self.pointer));
        let drag = constrained.unwrap_or_else(|| self.begun.clone());
        if !self.drag.is_constrained_like(&drag) {
            self.drag = drag;
        }
    }
}

/// Direction in the world of an axis along which a shape or what is in it moves.
fn move_axis(session: &Session, shape: ShapeId, axes: GizmoAxes, axis: usize) -> Option<Vec3> {
    let shape = session.scene().shape(shape)?;
    let own = shape.placement.transform.rotation.to_mat3();
    Some(match axes {
        GizmoAxes::World => Vec3::AXES[axis],
        GizmoAxes::Local => own.col(axis),
    })
}

/// Line or plane along which a shape or what is in it moves.
fn move_along(
    session: &Session,
    shape: ShapeId,
    constraint: Constraint,
    axes: GizmoAxes,
) -> Option<MoveAlong> {
    let mut free = constraint.axes();
    let mut next = || move_axis(session, shape, axes, free.next()?);
    let first = next()?;
    let plane = next().map(|second| MoveAlong::Axes(first, second));
    Some(plane.unwrap_or(MoveAlong::Line(first)))
}

impl Drag {
    /// The same drag, as it begins along an axis or in a plane alone, or about the axis that this is
    /// named after; `None` if it has no such axis.
    fn along(
        &self,
        session: &Session,
        (constraint, axes): (Constraint, GizmoAxes),
        pointer: &Ray,
    ) -> Option<Self> {
        let axis = constraint.named();
        let ring = |turn: &JointTurn| {
            let about = turn.axis(axes, axis)?;
            RingDrag::in_front(turn.clone(), about, pointer).map(Drag::Ring)
        };
        match self {
            Self::Bone(drag) => ring(drag.turn()),
            Self::Ring(drag) => ring(drag.turn()),
            Self::Move(drag) => {
                let along = move_along(session, drag.target().shape(), constraint, axes)?;
                Some(Drag::Move(drag.constrained(along)))
            }
            Self::Turn(drag) => {
                let group = drag.group().clone();
                let about = group.axis(axes, axis);
                ShapeTurn::in_front(group, about, pointer).map(Drag::Turn)
            }
            Self::Scale(drag) => Some(Drag::Scale(drag.along(Some(constraint)))),
            Self::Ik(drag) => {
                let along = move_along(session, drag.shape(), constraint, axes)?;
                Some(Drag::Ik(drag.constrained(along)))
            }
            Self::Stuck(..) => None,
        }
    }

    /// Whether both go along or about the same axes, so that one goes on with what it knows.
    fn is_constrained_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Ring(one), Self::Ring(other)) => one.axis() == other.axis(),
            (Self::Move(one), Self::Move(other)) => one.along() == other.along(),
            (Self::Ik(one), Self::Ik(other)) => one.along() == other.along(),
            (Self::Turn(one), Self::Turn(other)) => one.axis() == other.axis(),
            (Self::Scale(one), Self::Scale(other)) => one.constraint() == other.constraint(),
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}

impl Follow for Held {
    fn shape(&self) -> ShapeId {
        self.shape()
    }

    fn follow(&mut self, session: &Session, place: Place, pixel: Vec2, snap: bool) -> Option<Edit> {
        self.constrain(session);
        let ray = place.screen(session).ray(pixel);
        let typed = self.typed.amount();
        self.has_begun |= typed.is_some() || ray != self.pointer;
        let radians = typed.map(|degrees| degrees.to_radians() * self.sign());
        let edit = match &mut self.drag {
            Drag::Bone(drag) => match radians {
                Some(angle) => drag.turned_by(angle),
                None => drag.update(session, &ray, snap),
            },
            Drag::Ring(drag) => match radians {
                Some(angle) => drag.turned_by(angle),
                None => drag.update(session, &ray, snap),
            },
            Drag::Move(drag) => Some(match typed {
                Some(length) => drag.moved_by(length),
                None => drag.update(&ray, snap),
            }),
            Drag::Turn(drag) => Some(match radians {
                Some(angle) => drag.turned_by(angle),
                None => drag.update(session, &ray, snap),
            }),
            Drag::Scale(drag) => Some(match typed {
                Some(factor) => drag.scaled_by(factor),
                None => drag.update(&ray, snap),
            }),
            Drag::Ik(drag) => match typed {
                Some(length) => drag.moved_by(session, length),
                None => drag.update(session, &ray, snap),
            },
            Drag::Stuck(..) => None,
        };
        edit.filter(|_| self.has_begun)
    }

    fn is_confirmed(&self) -> bool {
        self.typed.is_confirmed()
    }

    fn is_finer_with_shift(&self) -> bool {
        match &self.drag {
            Drag::Turn(_) | Drag::Scale(_) => true,
            Drag::Move(drag) => matches!(
                drag.target(),
                MoveTarget::Shape(_) | MoveTarget::ControlPoint { .. }
            ),
            Drag::Bone(_) | Drag::Ring(_) | Drag::Ik(_) | Drag::Stuck(..) => false,
        }
    }
}
