use super::joint_turn::{JointTurn, snapped, unwound};
use super::{Edit, Session};
use crate::math::Ray;
use crate::scene::ShapeId;
use glam::{DVec3, Vec3};

/// What Left and Right roll a bone by, in radians.
pub const ROLL_STEP: f32 = 0.1;

/// A cursor that is nearer to the joint than this, in radians seen from the eye (about a pixel),
/// says nothing about a direction.
const ON_THE_JOINT: f64 = 1e-3;

/// A bone held by the pointer: it turns so that the grabbed point stays under the cursor, or in
/// line with it as seen from the joint.
///
/// The turn is about the line from the eye to the joint, in the character's own space, by the
/// dihedral angle from the plane through the grabbed point to the plane through the cursor's ray.
/// That is exact under perspective and under uneven scale, for planes map to planes. It follows
/// from the start of the gesture and the cursor alone, not from the way between.
#[derive(Clone, Debug)]
pub struct BoneDrag {
    turn: JointTurn,
    /// From the eye to the joint, in the world.
    to_joint: DVec3,
    /// The same in the character's space, of unit length.
    axis: DVec3,
    /// From the axis to the grabbed point, of unit length; unknown until the cursor has left the
    /// joint if it grabbed the joint itself.
    from: Option<DVec3>,
    /// As the cursor has it, in radians.
    wanted: f64,
    /// The same in steps if it snaps.
    angle: f64,
}

impl BoneDrag {
    /// Takes the bone of `joint` at the point `grabbed`, in the world, as `eye` sees it. `None`
    /// if there is no such joint, the shape is scaled to nothing, or the eye is at the joint.
    pub fn begin(
        session: &Session,
        shape: ShapeId,
        joint: usize,
        eye: Vec3,
        grabbed: Vec3,
    ) -> Option<Self> {
        let turn = JointTurn::begin(session, shape, joint)?;
        let axis = (turn.center() - turn.model_point(eye)).try_normalize()?;
        let to_joint = turn.world_center() - eye.as_dvec3();
        let mut drag = Self {
            turn,
            to_joint,
            axis,
            from: None,
            wanted: 0.0,
            angle: 0.0,
        };
        drag.from = drag.side(&Ray {
            origin: eye,
            direction: grabbed - eye,
        });
        Some(drag)
    }

    /// The joint turned for the cursor on `ray`, which starts at the eye; with `snap` in steps of
    /// 15° from the start.
    pub fn update(&mut self, session: &Session, ray: &Ray, snap: bool) -> Option<Edit> {
        if let Some(to) = self.side(ray) {
            let from = *self.from.get_or_insert(to);
            let angle = self.axis.dot(from.cross(to)).atan2(from.dot(to));
            self.wanted = unwound(angle, self.wanted);
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

    /// From the axis towards the ray, of unit length; `None` where the ray is at the joint.
    fn side(&self, ray: &Ray) -> Option<DVec3> {
        let across = ray.direction.as_dvec3().cross(self.to_joint).length();
        let along = f64::from(ray.direction.length()) * self.to_joint.length();
        if across <= ON_THE_JOINT * along {
            return None;
        }
        let (_, direction) = self.turn.model_ray(ray);
        direction.reject_from_normalized(self.axis).try_normalize()
    }
}

/// The joint turned by `angle` radians about the axis of its bone `bone`, an index into
/// [`crate::character::Character::bones`]. `None` if there is no such bone.
pub fn roll(session: &Session, shape: ShapeId, bone: usize, angle: f32) -> Option<Edit> {
    let bone = session
        .scene()
        .character(shape)?
        .character
        .bones()
        .get(bone)?;
    let turn = JointTurn::begin(session, shape, bone.joint)?;
    let figure = session.evaluated().shape(shape)?.geometry.figure.as_ref()?;
    let frame = figure.model_from_joint.get(bone.joint)?;
    let axis = frame
        .transform_vector3(bone.tip)
        .as_dvec3()
        .try_normalize()?;
    turn.turned(session, axis, f64::from(angle))
}
