use super::control_point_drag::{cannot_leave_plane, plane_normal, rounding, without_rounding};
use super::movement::{MoveAlong, Movement};
use super::shape_group::pivot_of;
use super::{Edit, Session};
use crate::character::Pose;
use crate::math::{Ray, Transform};
use crate::scene::ShapeId;
use glam::{DMat3, DVec3, Vec3};

/// Target of a move gesture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveTarget {
    /// A whole shape.
    Shape(ShapeId),
    /// The root joint above `joint`, or that joint if it is a root itself.
    Root {
        /// The character.
        shape: ShapeId,
        /// Index of a joint below the root.
        joint: usize,
    },
    /// All roots of a character by the same vector; the one above `joint` follows the cursor.
    AllRoots {
        /// The character.
        shape: ShapeId,
        /// Index of a joint below the leading root.
        joint: usize,
    },
    /// A control point of a curve.
    ControlPoint {
        /// The shape that has it.
        shape: ShapeId,
        /// Index of the curve in its set.
        curve: usize,
        /// Index of the point in the curve.
        point: usize,
    },
}

impl MoveTarget {
    /// Identifier of the shape that moves, or whose roots move.
    pub fn shape(self) -> ShapeId {
        match self {
            Self::Shape(shape)
            | Self::Root { shape, .. }
            | Self::AllRoots { shape, .. }
            | Self::ControlPoint { shape, .. } => shape,
        }
    }

    /// Index of the joint whose root follows the cursor.
    pub fn joint(self) -> Option<usize> {
        match self {
            Self::Shape(_) | Self::ControlPoint { .. } => None,
            Self::Root { joint, .. } | Self::AllRoots { joint, .. } => Some(joint),
        }
    }

    /// The same target with all roots of the character; what is no root stays what it is.
    pub fn all_roots(self) -> Self {
        match self {
            Self::Root { shape, joint } => Self::AllRoots { shape, joint },
            other => other,
        }
    }

    /// Line or plane in which it follows a cursor that is free: parallel to the picture, and for a control point as
    /// in a [`ControlPointDrag`](super::ControlPointDrag).
    pub fn free(self, session: &Session) -> MoveAlong {
        let normal = match self {
            Self::ControlPoint { shape, curve, .. } => plane_normal(session, shape, curve),
            _ => None,
        };
        MoveAlong::Plane(normal.unwrap_or_else(|| session.view().camera.forward()))
    }

    /// Position in the world of the shape's pivot, of the root that follows the cursor, or of the control point.
    pub fn place(self, session: &Session) -> Option<Vec3> {
        let evaluated = session.evaluated().shape(self.shape())?;
        let in_model = match self {
            Self::Shape(_) => pivot_of(evaluated),
            Self::Root { joint, .. } | Self::AllRoots { joint, .. } => {
                let root = root_of(session, self.shape(), joint)?;
                *evaluated.geometry.figure.as_ref()?.joints.get(root)?
            }
            Self::ControlPoint {
                shape,
                curve,
                point,
            } => control_point(session, shape, curve, point)?,
        };
        Some(evaluated.world_from_model.transform_point3(in_model))
    }
}

/// What moves where the selected joints of a character are meant: the root among them, or all roots if all are; `None` if
/// none is, since other joints only turn.
pub fn selected_roots(session: &Session, shape: ShapeId) -> Option<MoveTarget> {
    let active = session
        .selected_joint()
        .filter(|_| session.selected() == Some(shape))?;
    let selected = session.selected_joints();
    let roots = session
        .scene()
        .character(shape)?
        .character
        .skeleton()
        .roots();
    if roots.len() > 1 && roots.iter().all(|root| selected.contains(root)) {
        return Some(MoveTarget::AllRoots {
            shape,
            joint: active,
        });
    }
    let own = root_of(session, shape, active);
    let own = own.filter(|root| selected.contains(root));
    let mut others = roots.iter().copied().filter(|root| selected.contains(root));
    let joint = own.or_else(|| others.next())?;
    Some(MoveTarget::Root { shape, joint })
}

/// Index of the root above `joint`, or `joint` itself if it is a root.
pub fn root_of(session: &Session, shape: ShapeId, joint: usize) -> Option<usize> {
    let joints = session
        .scene()
        .character(shape)?
        .character
        .skeleton()
        .joints();
    let mut joint = joint;
    while let Some(parent) = joints.get(joint)?.parent {
        joint = parent;
    }
    Some(joint)
}

/// Position of a control point in model space.
fn control_point(session: &Session, shape: ShapeId, curve: usize, point: usize) -> Option<Vec3> {
    let curve = session.scene().curve(shape)?.curves().curve(curve)?;
    curve.control_points().get(point).copied()
}

/// Drag of a shape, of roots or of a control point, which move one to one: the point that was grabbed stays where the
/// cursor's ray meets the line or plane through the target.
#[derive(Clone, Debug)]
pub struct MoveDrag {
    target: MoveTarget,
    start: Start,
    movement: Movement,
}

#[derive(Clone, Debug)]
enum Start {
    Shape(Transform),
    Roots {
        pose: Pose,
        roots: Vec<usize>,
        /// Matrix of directions from the world to the character's space.
        model_from_world: DMat3,
    },
    Point {
        curve: usize,
        point: usize,
        /// Position in the shape's model space.
        position: Vec3,
        /// Matrix of directions from the world to that.
        model_from_world: DMat3,
        /// Rounding error of where it is moved, along each axis of that.
        rounding: Vec3,
        /// Whether it cannot leave z = 0.
        stays_flat: bool,
    },
}

impl MoveDrag {
    /// Begins a drag of `target` with the cursor on `ray`. `None` if it does not exist, is scaled
    /// to zero, or the ray is parallel to the line or plane.
    pub fn begin(
        session: &Session,
        target: MoveTarget,
        along: MoveAlong,
        ray: &Ray,
    ) -> Option<Self> {
        Self::about(
            session,
            target,
            along,
            ray,
            &[target.place(session)?.as_dvec3()],
        )
    }

    /// The same for a target that nobody has pointed at: one that is beside or behind the eye follows as if
    /// it were at a distance of 1 before it.
    pub fn begin_anywhere(
        session: &Session,
        target: MoveTarget,
        along: MoveAlong,
        ray: &Ray,
    ) -> Option<Self> {
        let before_eye = ray.origin + ray.direction.normalize_or_zero();
        let anchors = [target.place(session)?, before_eye].map(|place| place.as_dvec3());
        Self::about(session, target, along, ray, &anchors)
    }

    /// A drag along the line or plane through the first of `anchors` that the ray meets.
    fn about(
        session: &Session,
        target: MoveTarget,
        along: MoveAlong,
        ray: &Ray,
        anchors: &[DVec3],
    ) -> Option<Self> {
        let shape = target.shape();
        let start = match target {
            MoveTarget::Shape(_) => Start::Shape(session.scene().shape(shape)?.placement.transform),
            MoveTarget::Root { joint, .. } => {
                Start::roots(session, shape, vec![root_of(session, shape, joint)?])?
            }
            MoveTarget::AllRoots { .. } => {
                let character = &session.scene().character(shape)?.character;
                Start::roots(session, shape, character.skeleton().roots().to_vec())?
            }
            MoveTarget::ControlPoint { curve, point, .. } => {
                Start::point(session, shape, curve, point)?
            }
        };
        let begin = |&anchor: &DVec3| Movement::begin(anchor, along, ray);
        Some(Self {
            target,
            start,
            movement: anchors.iter().find_map(begin)?,
        })
    }

    /// The same drag from its start, along another line or plane.
    pub fn constrained(&self, along: MoveAlong) -> Self {
        Self {
            movement: self.movement.constrained(along),
            ..self.clone()
        }
    }

    /// Edit that moves the target for the cursor on `ray`; with `snap` in steps.
    pub fn update(&mut self, ray: &Ray, snap: bool) -> Edit {
        self.movement.follow(ray, snap);
        self.edit()
    }

    /// Edit that moves the target by exactly this length, wherever the cursor is.
    pub fn moved_by(&mut self, length: f64) -> Edit {
        self.movement.move_by(length);
        self.edit()
    }

    fn edit(&self) -> Edit {
        match &self.start {
            Start::Shape(transform) => {
                let mut transform = *transform;
                transform.position += self.movement.moved().as_vec3();
                Edit::SetTransform(self.target.shape(), transform)
            }
            Start::Roots {
                pose,
                roots,
                model_from_world,
            } => {
                let offset = (*model_from_world * self.movement.moved()).as_vec3();
                let mut pose = pose.clone();
                for &root in roots {
                    pose.set_root_offset(root, pose.root_offset(root) + offset);
                }
                Edit::SetPose(self.target.shape(), pose)
            }
            &Start::Point {
                curve,
                point,
                position: start,
                model_from_world,
                rounding,
                stays_flat,
            } => {
                let position = start + (model_from_world * self.movement.moved()).as_vec3();
                let mut position = without_rounding(position, start, rounding);
                if stays_flat {
                    position.z = start.z;
                }
                Edit::SetControlPoint {
                    shape: self.target.shape(),
                    curve,
                    point,
                    position,
                }
            }
        }
    }

    /// Line or plane along which the target moves.
    pub fn along(&self) -> MoveAlong {
        self.movement.along()
    }

    /// Target that is moved.
    pub fn target(&self) -> MoveTarget {
        self.target
    }

    /// Vector by which the target has moved, in the world.
    pub fn moved(&self) -> Vec3 {
        self.movement.moved().as_vec3()
    }
}

impl Start {
    fn roots(session: &Session, shape: ShapeId, roots: Vec<usize>) -> Option<Self> {
        Some(Self::Roots {
            pose: session.scene().character(shape)?.pose().clone(),
            roots,
            model_from_world: model_from_world(session, shape)?,
        })
    }

    fn point(session: &Session, shape: ShapeId, curve: usize, point: usize) -> Option<Self> {
        let position = control_point(session, shape, curve, point)?;
        let world_from_model = session.evaluated().shape(shape)?.world_from_model;
        let world = world_from_model.transform_point3(position);
        let distance = session.view().camera.eye().distance(world);
        Some(Self::Point {
            curve,
            point,
            position,
            model_from_world: model_from_world(session, shape)?,
            rounding: rounding(world_from_model, distance),
            stays_flat: cannot_leave_plane(session.scene().curve(shape)?.curves(), curve),
        })
    }
}

/// Matrix of directions from the world to a shape's model space; `None` if it is scaled to zero.
fn model_from_world(session: &Session, shape: ShapeId) -> Option<DMat3> {
    let world_from_model = session.evaluated().shape(shape)?.world_from_model;
    let model_from_world = DMat3::from_mat4(world_from_model.as_dmat4()).inverse();
    model_from_world.is_finite().then_some(model_from_world)
}
