use super::swing::{Swing, angle_about, snapped, unwound};
use super::{Edit, GizmoAxes, Session};
use crate::math::{DRay, Euler, Ray};
use crate::scene::ShapeId;
use glam::{DMat3, DMat4, DQuat, DVec3, Vec3};

/// Joint that is being turned by a gesture, with its rotation at the start, from which each step of
/// the gesture is computed.
///
/// All is in the character's space, in which gestures stay exact under a non-uniform scale.
#[derive(Clone, Debug)]
pub struct JointTurn {
    shape: ShapeId,
    joint: usize,
    start: Euler,
    /// Rotation from the parent's frame to the character's space.
    model_from_parent: DQuat,
    world_from_model: DMat4,
    model_from_world: DMat4,
    /// Position of the joint, which a turn does not change.
    center: DVec3,
    /// Other selected joints that turn by as much about the same axis, each about its own place.
    others: Vec<Self>,
}

/// Which of the selected joints turn together if one of them does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Together {
    /// Every one, as fingers curl; or the roots alone if all are selected, who mean the figure and not that it curls up.
    #[default]
    Every,
    /// Those that hang on no other one, so that a chain stays as it is bent: Blender's way.
    Topmost,
}

impl JointTurn {
    /// Begins to turn `joint` of the character `shape`, and with it others that are selected if it is one of them; the
    /// selected one that it hangs on in its place, if only those on top turn.
    /// `None` if there is no such joint, or the shape is scaled to zero.
    pub fn begin(
        session: &Session,
        shape: ShapeId,
        joint: usize,
        together: Together,
    ) -> Option<Self> {
        let skeleton = session.scene().character(shape)?.character.skeleton();
        let selected = session.selected_joints();
        if session.selected() != Some(shape) || !selected.contains(&joint) {
            return Self::of_one(session, shape, joint);
        }
        let means_all = selected.len() == skeleton.joints().len();
        let only_topmost = means_all || together == Together::Topmost;
        let topmost = |joint: usize| {
            let above = |&joint: &usize| skeleton.joints().get(joint)?.parent;
            let chain = std::iter::successors(Some(joint), above);
            chain.filter(|joint| selected.contains(joint)).last()
        };
        let turned = topmost(joint).filter(|_| only_topmost).unwrap_or(joint);
        let mut turn = Self::of_one(session, shape, turned)?;
        let others = selected.iter().copied().filter(|&other| other != turned);
        let others = others.filter(|&other| !only_topmost || topmost(other) == Some(other));
        let others = others.filter_map(|other| Self::of_one(session, shape, other));
        turn.others = others.collect();
        Some(turn)
    }

    fn of_one(session: &Session, shape: ShapeId, joint: usize) -> Option<Self> {
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
        sound.then(|| Self {
            shape,
            joint,
            start: character.pose().rotation(joint),
            model_from_parent,
            world_from_model,
            model_from_world,
            center,
            others: Vec::new(),
        })
    }

    /// Identifier of the character.
    pub fn shape(&self) -> ShapeId {
        self.shape
    }

    /// Index of the joint.
    pub fn joint(&self) -> usize {
        self.joint
    }

    /// Position of the joint, in the character's space.
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// Position of the joint in the world.
    pub fn world_center(&self) -> DVec3 {
        self.world_from_model.transform_point3(self.center)
    }

    /// Ray of the world in the character's space; its direction is not of unit length.
    pub fn model_ray(&self, ray: &Ray) -> DRay {
        DRay::from(ray).transformed(self.model_from_world)
    }

    /// Point of the world in the character's space.
    pub fn model_point(&self, world: Vec3) -> DVec3 {
        self.model_from_world.transform_point3(world.as_dvec3())
    }

    /// Edit that turns the joint from its start by `angle` radians about `axis`, a unit vector in
    /// the character's space, and others with it; their angles are the nearest to those that they have in `session`.
    pub fn turned(&self, session: &Session, axis: DVec3, angle: f64) -> Option<Edit> {
        let character = session.scene().character(self.shape)?;
        self.all_turned(|turn| turn.turned_near(axis, angle, character.pose().rotation(turn.joint)))
    }

    /// The same with the angles that are nearest to those at the start.
    pub fn turned_exactly(&self, axis: DVec3, angle: f64) -> Option<Edit> {
        self.all_turned(|turn| turn.turned_near(axis, angle, turn.start))
    }

    fn all_turned(&self, turned: impl Fn(&Self) -> Option<Edit>) -> Option<Edit> {
        let own = turned(self)?;
        if self.others.is_empty() {
            return Some(own);
        }
        let others = self.others.iter().filter_map(turned);
        Some(Edit::Together(std::iter::once(own).chain(others).collect()))
    }

    fn turned_near(&self, axis: DVec3, angle: f64, shown: Euler) -> Option<Edit> {
        let in_parent = self.model_from_parent.inverse() * axis;
        let turn = DMat3::from_axis_angle(in_parent.try_normalize()?, angle);
        Some(Edit::SetJointTransform {
            shape: self.shape,
            joint: self.joint,
            rotation: Euler::nearest((turn * self.start.to_dmat3()).as_mat3(), shown),
        })
    }

    /// Axis of a gizmo as it was at the start: 0 for x, 1 for y, 2 for z; in the character's space,
    /// of unit length.
    pub fn axis(&self, axes: GizmoAxes, axis: usize) -> Option<DVec3> {
        match axes {
            GizmoAxes::Local => Some(self.model_from_parent * self.start.to_dmat3().col(axis)),
            GizmoAxes::World => {
                let stretch = DMat3::from_mat4(self.world_from_model);
                stretch.transpose().col(axis).try_normalize()
            }
        }
    }

    /// 1 if a turn about `axis`, in the character's space, makes the angle in the panel larger that
    /// it changes most at the start, or else -1.
    pub fn panel_sign(&self, axis: DVec3) -> f64 {
        let in_parent = self.model_from_parent.inverse() * axis;
        f64::from(self.start.sign_of_turn(in_parent.as_vec3()))
    }
}

/// Angle by which the Left and Right keys roll a bone, in radians.
pub const ROLL_STEP: f32 = 0.1;

/// Angle between cursor and joint, in radians seen from the eye (about a pixel), below which the
/// cursor has no direction.
const ON_THE_JOINT: f64 = 1e-3;

/// Drag of a bone, which turns so that the grabbed point stays under the cursor, or in line with it
/// as seen from the joint.
///
/// The axis is the line from the eye to the joint, in the character's space, and the angle is the
/// dihedral angle from the plane through the grabbed point to the plane through the cursor's ray.
/// That is exact under perspective and under a non-uniform scale, which both map planes to planes.
/// It follows from the start of the gesture and the cursor alone, not from the path in between.
#[derive(Clone, Debug)]
pub struct BoneDrag {
    turn: JointTurn,
    /// Vector from the eye to the joint, in the world.
    to_joint: DVec3,
    /// Axis: the same direction in the character's space, of unit length.
    axis: DVec3,
    /// Direction from the axis to the grabbed point, of unit length; if the joint itself was
    /// grabbed, unknown until the cursor has left it.
    from: Option<DVec3>,
    /// Angle between cursor and joint, in radians seen from the eye, below which the cursor has no direction.
    on_joint: f64,
    /// Angle of the cursor, in radians.
    wanted: f64,
    /// Angle of the joint, in radians: in steps if it snaps.
    angle: f64,
}

impl BoneDrag {
    /// Begins a drag of the bone of `joint`, seen from the `eye`, at the point `grabbed`, both in the
    /// world. `None` if there is no such joint, the shape is scaled to zero, or the eye is at the
    /// joint.
    pub fn begin(
        session: &Session,
        shape: ShapeId,
        joint: usize,
        (eye, grabbed): (Vec3, Vec3),
        together: Together,
    ) -> Option<Self> {
        let turn = JointTurn::begin(session, shape, joint, together)?;
        let axis = (turn.center() - turn.model_point(eye)).try_normalize()?;
        let to_joint = turn.world_center() - eye.as_dvec3();
        let mut drag = Self {
            turn,
            to_joint,
            axis,
            from: None,
            on_joint: ON_THE_JOINT,
            wanted: 0.0,
            angle: 0.0,
        };
        drag.from = drag.side(&Ray {
            origin: eye,
            direction: grabbed - eye,
        });
        Some(drag)
    }

    /// The same of a bone that is grabbed next to its joint, from where every pixel is another direction: its `tip`, in the
    /// world, points to the cursor once that is farther from the joint than `on_joint`, in radians seen from the `eye`.
    #[must_use]
    pub fn pointing(mut self, eye: Vec3, tip: Vec3, on_joint: f64) -> Self {
        self.from = self.side(&Ray {
            origin: eye,
            direction: tip - eye,
        });
        self.on_joint = on_joint;
        self
    }

    /// Edit that turns the joint for the cursor on `ray`, which starts at the eye; with `snap` in
    /// steps of 15° from the start.
    pub fn update(&mut self, session: &Session, ray: &Ray, snap: bool) -> Option<Edit> {
        if let Some(to) = self.side(ray) {
            let from = *self.from.get_or_insert(to);
            self.wanted = unwound(angle_about(self.axis, from, to), self.wanted);
        }
        self.angle = snapped(self.wanted, snap);
        self.turn.turned(session, self.axis, self.angle)
    }

    /// Edit that turns the joint by exactly this angle in radians about the axis away from the eye,
    /// wherever the cursor is.
    pub fn turned_by(&mut self, angle: f64) -> Option<Edit> {
        self.angle = angle;
        self.turn.turned_exactly(self.axis, self.angle)
    }

    /// Angle by which the joint has turned about the axis away from the eye, in radians.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// 1 if the angle has the sign of the angle in the panel that changes most, or else -1.
    pub fn panel_sign(&self) -> f64 {
        self.turn.panel_sign(self.axis)
    }

    /// Joint that is turned.
    pub fn turn(&self) -> &JointTurn {
        &self.turn
    }

    /// Direction from the axis to the ray, of unit length; `None` if the ray is at the joint.
    fn side(&self, ray: &Ray) -> Option<DVec3> {
        let across = ray.direction.as_dvec3().cross(self.to_joint).length();
        let along = f64::from(ray.direction.length()) * self.to_joint.length();
        if across <= self.on_joint * along {
            return None;
        }
        let direction = self.turn.model_ray(ray).direction;
        direction.reject_from_normalized(self.axis).try_normalize()
    }
}

/// Edit that rolls a bone: turns its joint by `angle` radians about the axis of the bone, an index
/// into [`crate::character::Character::bones`]. `None` if there is no such bone.
pub fn roll(session: &Session, shape: ShapeId, bone: usize, angle: f32) -> Option<Edit> {
    let bone = session
        .scene()
        .character(shape)?
        .character
        .bones()
        .get(bone)?;
    let turn = JointTurn::begin(session, shape, bone.joint, Together::Every)?;
    let figure = session.evaluated().shape(shape)?.geometry.figure.as_ref()?;
    let frame = figure.model_from_joint.get(bone.joint)?;
    let axis = frame
        .transform_vector3(bone.tip)
        .as_dvec3()
        .try_normalize()?;
    turn.turned(session, axis, f64::from(angle))
}

/// Drag of a ring of the rotation gizmo: the joint turns about the ring's axis.
#[derive(Clone, Debug)]
pub struct RingDrag {
    turn: JointTurn,
    /// In the character's space.
    swing: Swing,
    /// Angle of the cursor, in radians.
    wanted: f64,
    /// Angle of the joint, in radians: in steps if it snaps.
    angle: f64,
}

impl RingDrag {
    /// Begins a drag of the ring about `axis` (in the character's space) around `joint` at
    /// `grabbed` in the world, with the cursor on `ray`. `None` if there is no such joint, or no
    /// angle follows from the cursor.
    pub fn begin(
        session: &Session,
        shape: ShapeId,
        joint: usize,
        axis: Vec3,
        (grabbed, ray): (Vec3, &Ray),
        together: Together,
    ) -> Option<Self> {
        let turn = JointTurn::begin(session, shape, joint, together)?;
        let (grabbed, ray) = (turn.model_point(grabbed), turn.model_ray(ray));
        let swing = Swing::begin(turn.center(), axis.as_dvec3(), grabbed, &ray)?;
        Some(Self::with(turn, swing))
    }

    /// Begins a turn about `axis`, in the character's space, of a joint as it was when another drag
    /// of it began, with the cursor anywhere on `ray`, which comes from the eye. `None` if no angle
    /// follows from the cursor.
    pub fn in_front(turn: JointTurn, axis: DVec3, ray: &Ray) -> Option<Self> {
        let ray = turn.model_ray(ray);
        let swing = Swing::begin_in_front(turn.center(), axis, &ray)?;
        Some(Self::with(turn, swing))
    }

    fn with(turn: JointTurn, swing: Swing) -> Self {
        Self {
            turn,
            swing,
            wanted: 0.0,
            angle: 0.0,
        }
    }

    /// Edit that turns the joint for the cursor on `ray`; with `snap` in steps of 15° from the
    /// start.
    pub fn update(&mut self, session: &Session, ray: &Ray, snap: bool) -> Option<Edit> {
        let ray = self.turn.model_ray(ray);
        if let Some(angle) = self.swing.angle(&ray, self.wanted) {
            self.wanted = angle;
        }
        self.angle = snapped(self.wanted, snap);
        self.turn.turned(session, self.swing.axis(), self.angle)
    }

    /// Edit that turns the joint by exactly this angle in radians about the ring's axis, wherever
    /// the cursor is.
    pub fn turned_by(&mut self, angle: f64) -> Option<Edit> {
        self.angle = angle;
        self.turn.turned_exactly(self.swing.axis(), self.angle)
    }

    /// The ring's axis in the character's space, of unit length.
    pub fn axis(&self) -> DVec3 {
        self.swing.axis()
    }

    /// Angle by which the joint has turned about the ring's axis, in radians.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// 1 if the angle has the sign of the angle in the panel that changes most, or else -1.
    pub fn panel_sign(&self) -> f64 {
        self.turn.panel_sign(self.swing.axis())
    }

    /// Joint that is turned.
    pub fn turn(&self) -> &JointTurn {
        &self.turn
    }
}
