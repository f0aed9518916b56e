use super::{Edit, IkGrip, IkSettings, Session};
use crate::character::ik::{IkChain, IkGoal, hold_pins};
use crate::character::{Pose, SkeletalModel};
use crate::math::Ray;
use crate::scene::ShapeId;
use glam::{DVec3, Vec3};

/// A hand, a foot or whatever else of a character held by the pointer: it follows in the plane
/// parallel to the picture, and a chain of joints follows it. Pinned joints stay.
///
/// Each moment goes on from the one before, so that a hand can be led all round its shoulder and
/// the elbow never flips; where everything is pinned to is taken from the start.
#[derive(Clone, Debug)]
pub struct IkDrag {
    shape: ShapeId,
    grip: IkGrip,
    /// `None` if a root is moved.
    chain: Option<IkChain>,
    settings: IkSettings,
    start: Pose,
    /// Where the grip was, in the world.
    anchor: DVec3,
    /// Across the plane that it moves in.
    normal: DVec3,
    /// Where the cursor took hold, in that plane.
    from: DVec3,
    target: Vec3,
    off: f32,
    /// Where each pin was, in the character's space.
    pinned: Vec<(usize, Vec3)>,
    lost: Vec<(usize, Vec3)>,
}

impl IkDrag {
    /// What the grip or a pin is off its place by before it counts as out of reach, in the
    /// character's space.
    pub const OUT_OF_REACH: f32 = 5e-3;

    /// Takes `grip` of the character `shape` with the cursor on `ray`. `None` if there is no such
    /// thing, the shape is scaled to nothing, or nothing can turn: a pin is above.
    pub fn begin(
        session: &Session,
        shape: ShapeId,
        grip: IkGrip,
        settings: &IkSettings,
        ray: &Ray,
    ) -> Option<Self> {
        let character = session.scene().character(shape)?;
        let joints = character.character.skeleton().joints();
        let is_root = joints.get(grip.joint())?.parent.is_none();
        let chain = match grip {
            IkGrip::Joint(_) if is_root => None,
            _ => Some(grip.chain(session, shape, settings)?),
        };
        let target = grip.place(session, shape)?;
        let mut drag = Self {
            shape,
            grip,
            chain,
            settings: settings.clone(),
            start: character.pose().clone(),
            anchor: target.as_dvec3(),
            normal: session.view().camera.forward().as_dvec3(),
            from: DVec3::ZERO,
            target,
            off: 0.0,
            pinned: pins_at(character.character.skeleton(), character.pose(), settings),
            lost: Vec::new(),
        };
        drag.from = drag.meeting(ray)?;
        Some(drag)
    }

    /// The character posed for the cursor on `ray`.
    pub fn update(&mut self, session: &Session, ray: &Ray) -> Option<Edit> {
        let target = (self.anchor + self.meeting(ray)? - self.from).as_vec3();
        let character = session.scene().character(self.shape)?;
        let skeleton = character.character.skeleton();
        let world_from_model = session.evaluated().shape(self.shape)?.world_from_model;
        let in_model = world_from_model.inverse().transform_point3(target);
        if !in_model.is_finite() {
            return None;
        }
        let pose = self.solve(skeleton, character.pose(), in_model)?;
        self.target = target;
        Some(Edit::SetPose(self.shape, pose))
    }

    /// The character.
    pub fn shape(&self) -> ShapeId {
        self.shape
    }

    /// What is held.
    pub fn grip(&self) -> IkGrip {
        self.grip
    }

    /// The chain that follows; none if a root is moved.
    pub fn chain(&self) -> Option<&IkChain> {
        self.chain.as_ref()
    }

    /// Where the grip is wanted, in the world.
    pub fn target(&self) -> Vec3 {
        self.target
    }

    /// How far the grip is from there, in the character's space.
    pub fn off(&self) -> f32 {
        self.off
    }

    /// The pinned joints that could not be held, and where they were, in the character's space.
    pub fn lost_pins(&self) -> &[(usize, Vec3)] {
        &self.lost
    }

    fn solve(&mut self, skeleton: &SkeletalModel, pose: &Pose, target: Vec3) -> Option<Pose> {
        let (moved, busy) = match &self.chain {
            Some(chain) => {
                let goal = IkGoal {
                    target,
                    pole: self.settings.pole.direction(skeleton.facing()),
                    keep_orientation: self.settings.keep_orientation,
                };
                let solution = chain.solve(skeleton, pose, &goal)?;
                self.off = solution.off;
                let mut busy = chain.joints().to_vec();
                busy.extend(chain.end());
                (solution.pose, busy)
            }
            None => {
                let root = self.grip.joint();
                let rest = skeleton.joints().get(root)?.offset;
                let mut pose = pose.clone();
                pose.set_root_offset(root, target - rest);
                (pose, vec![root])
            }
        };
        let pins = &self.settings.pins;
        let held = hold_pins(skeleton, &self.start, &moved, pins, &busy);
        let now = pins_at(skeleton, &held, &self.settings);
        let held_back = self.pinned.iter().zip(now);
        let lost = held_back.filter(|(was, now)| {
            let off = was.1.distance(now.1);
            // A pin that is dragged itself goes where it is brought.
            off > Self::OUT_OF_REACH && !busy.contains(&was.0)
        });
        self.lost = lost.map(|(was, _)| *was).collect();
        Some(held)
    }

    /// Where the ray meets the plane.
    fn meeting(&self, ray: &Ray) -> Option<DVec3> {
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let distance = (self.anchor - origin).dot(self.normal) / direction.dot(self.normal);
        (distance > 0.0 && distance.is_finite()).then(|| origin + direction * distance)
    }
}

/// Where the pinned joints are under `pose`, in the character's space.
fn pins_at(skeleton: &SkeletalModel, pose: &Pose, settings: &IkSettings) -> Vec<(usize, Vec3)> {
    if settings.pins.is_empty() {
        return Vec::new();
    }
    let frames = skeleton.update_current_joint_to_world_transforms(pose);
    let place = |&pin: &usize| Some((pin, frames.get(pin)?.w_axis.truncate()));
    settings.pins.iter().filter_map(place).collect()
}
