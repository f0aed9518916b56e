use super::joint_turn::{JointTurn, snapped, unwound};
use super::{Edit, Session};
use crate::math::Ray;
use crate::scene::ShapeId;
use glam::{DVec3, Vec3};

/// A ring seen from this flat an angle (its sine) is pulled along like a thread: where its plane
/// meets the cursor's ray says little.
const EDGE_ON: f64 = 0.2;

/// A ring of the rotation gizmo held by the pointer: the joint turns about the ring's axis.
#[derive(Clone, Debug)]
pub struct RingDrag {
    turn: JointTurn,
    /// In the character's space, of unit length.
    axis: DVec3,
    how: How,
    /// As the cursor has it, in radians.
    wanted: f64,
    /// The same in steps if it snaps.
    angle: f64,
}

/// How an angle follows from the cursor. Vectors are in the character's space.
#[derive(Clone, Copy, Debug)]
enum How {
    /// By the point of the ring's plane that is under the cursor, from this one on.
    Plane {
        /// From the joint, of unit length.
        from: DVec3,
    },
    /// By the way along the ring's tangent at the grabbed point.
    Tangent {
        grabbed: DVec3,
        tangent: DVec3,
        radius: f64,
        start: f64,
    },
}

impl RingDrag {
    /// Takes the ring about `axis` (in the character's space) round `joint` at `grabbed` in the
    /// world, with the cursor on `ray`. `None` if there is no such joint or nothing to turn by.
    pub fn begin(
        session: &Session,
        shape: ShapeId,
        joint: usize,
        axis: Vec3,
        grabbed: Vec3,
        ray: &Ray,
    ) -> Option<Self> {
        let turn = JointTurn::begin(session, shape, joint)?;
        let axis = axis.as_dvec3().try_normalize()?;
        let (_, direction) = turn.model_ray(ray);
        let flat = direction.try_normalize()?.dot(axis).abs();
        let on_plane = in_plane(&turn, axis, ray);
        let how = match on_plane.filter(|_| flat > EDGE_ON) {
            Some(from) => How::Plane { from },
            None => {
                let grabbed = turn.model_point(grabbed);
                let arm = (grabbed - turn.center()).reject_from_normalized(axis);
                let tangent = axis.cross(arm).try_normalize()?;
                How::Tangent {
                    grabbed,
                    tangent,
                    radius: arm.length(),
                    start: along_line(turn.model_ray(ray), grabbed, tangent)?,
                }
            }
        };
        Some(Self {
            turn,
            axis,
            how,
            wanted: 0.0,
            angle: 0.0,
        })
    }

    /// The joint turned for the cursor on `ray`; with `snap` in steps of 15° from the start.
    pub fn update(&mut self, session: &Session, ray: &Ray, snap: bool) -> Option<Edit> {
        if let Some(angle) = self.angle_at(ray) {
            self.wanted = angle;
        }
        self.angle = snapped(self.wanted, snap);
        self.turn.turned(session, self.axis, self.angle)
    }

    /// How far it has turned, in radians.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// What is turned.
    pub fn turn(&self) -> &JointTurn {
        &self.turn
    }

    fn angle_at(&self, ray: &Ray) -> Option<f64> {
        match self.how {
            How::Plane { from } => {
                let to = in_plane(&self.turn, self.axis, ray)?;
                let angle = self.axis.dot(from.cross(to)).atan2(from.dot(to));
                Some(unwound(angle, self.wanted))
            }
            How::Tangent {
                grabbed,
                tangent,
                radius,
                start,
            } => {
                let at = along_line(self.turn.model_ray(ray), grabbed, tangent)?;
                Some((at - start) / radius)
            }
        }
    }
}

/// From the joint towards the point of the plane across `axis` that the ray meets, of unit
/// length; `None` where it meets none or the joint itself.
fn in_plane(turn: &JointTurn, axis: DVec3, ray: &Ray) -> Option<DVec3> {
    let (origin, direction) = turn.model_ray(ray);
    let distance = (turn.center() - origin).dot(axis) / direction.dot(axis);
    if !(distance > 0.0 && distance.is_finite()) {
        return None;
    }
    let arm = origin + direction * distance - turn.center();
    arm.reject_from_normalized(axis).try_normalize()
}

/// How far along the line through `point` in the unit direction `along` it comes nearest to a
/// ray given by origin and direction; `None` if they are parallel.
pub(super) fn along_line(
    (origin, direction): (DVec3, DVec3),
    point: DVec3,
    along: DVec3,
) -> Option<f64> {
    let direction = direction.try_normalize()?;
    let between = direction.dot(along);
    let across = 1.0 - between * between;
    let offset = origin - point;
    let at = (offset.dot(along) - offset.dot(direction) * between) / across;
    (across > 1e-9 && at.is_finite()).then_some(at)
}
