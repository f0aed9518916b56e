use super::{Edit, Session};
use crate::math::{Euler, Ray};
use crate::scene::ShapeId;
use glam::{DMat3, DMat4, DQuat, DVec3, EulerRot, Vec3};

/// A joint that is being turned by hand: what it started from, so that each moment of the
/// gesture is worked out from the start and not from the moment before.
///
/// Space is the character's own: gestures under an uneven scale stay exact there.
#[derive(Clone, Debug)]
pub struct JointTurn {
    shape: ShapeId,
    joint: usize,
    start: DMat3,
    /// Rotation from the parent's frame to the character's space.
    model_from_parent: DQuat,
    world_from_model: DMat4,
    model_from_world: DMat4,
    /// The joint itself, which a turn leaves where it is.
    center: DVec3,
}

impl JointTurn {
    /// Starts to turn `joint` of the character `shape`. `None` if there is no such joint, or if
    /// the shape is scaled to nothing.
    pub fn begin(session: &Session, shape: ShapeId, joint: usize) -> Option<Self> {
        let character = session.scene().character(shape)?;
        let evaluated = session.evaluated().shape(shape)?;
        let frames = &evaluated.geometry.figure.as_ref()?.model_from_joint;
        let frame = frames.get(joint)?;
        let model_from_parent = match character.character.skeleton().joints()[joint].parent {
            Some(parent) => DQuat::from_mat4(&frames.get(parent)?.as_dmat4()).normalize(),
            None => DQuat::IDENTITY,
        };
        let world_from_model = evaluated.world_from_model.as_dmat4();
        let model_from_world = world_from_model.inverse();
        let center = frame.w_axis.truncate().as_dvec3();
        let sound =
            model_from_world.is_finite() && model_from_parent.is_finite() && center.is_finite();
        let [x, y, z] = character
            .pose()
            .rotation(joint)
            .radians
            .as_dvec3()
            .to_array();
        sound.then(|| Self {
            shape,
            joint,
            start: DMat3::from_euler(EulerRot::XYZ, x, y, z),
            model_from_parent,
            world_from_model,
            model_from_world,
            center,
        })
    }

    /// The character.
    pub fn shape(&self) -> ShapeId {
        self.shape
    }

    /// Index of the joint.
    pub fn joint(&self) -> usize {
        self.joint
    }

    /// The joint's place, in the character's space.
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// The joint's place in the world.
    pub fn world_center(&self) -> DVec3 {
        self.world_from_model.transform_point3(self.center)
    }

    /// Origin and direction of a ray of the world, in the character's space; the direction is
    /// not of unit length.
    pub fn model_ray(&self, ray: &Ray) -> (DVec3, DVec3) {
        (
            self.model_from_world
                .transform_point3(ray.origin.as_dvec3()),
            self.model_from_world
                .transform_vector3(ray.direction.as_dvec3()),
        )
    }

    /// A point of the world in the character's space.
    pub fn model_point(&self, world: Vec3) -> DVec3 {
        self.model_from_world.transform_point3(world.as_dvec3())
    }

    /// The joint turned from its start by `angle` radians about `axis`, a unit vector in the
    /// character's space; its angles are the nearest to those that it has in `session`.
    pub fn turned(&self, session: &Session, axis: DVec3, angle: f64) -> Option<Edit> {
        let in_parent = self.model_from_parent.inverse() * axis;
        let turn = DMat3::from_axis_angle(in_parent.try_normalize()?, angle);
        let shown = session
            .scene()
            .character(self.shape)?
            .pose()
            .rotation(self.joint);
        Some(Edit::SetJointTransform {
            shape: self.shape,
            joint: self.joint,
            rotation: Euler::nearest((turn * self.start).as_mat3(), shown),
        })
    }
}

/// Rounds an angle in radians to whole steps of 15° if `snap`.
pub(super) fn snapped(angle: f64, snap: bool) -> f64 {
    let step = 15.0_f64.to_radians();
    if snap {
        (angle / step).round() * step
    } else {
        angle
    }
}

/// `angle` by whole turns as near to `to` as can be, so that a gesture can go round more than
/// once.
pub(super) fn unwound(angle: f64, to: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle + ((to - angle) / turn).round() * turn
}
