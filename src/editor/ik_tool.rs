use super::{Edit, IkGrip, Session};
use crate::character::ik::{IkChain, IkGoal, hold_pins};
use crate::character::{Pose, SkeletalModel};
use crate::math::{DRay, Ray};
use crate::scene::{IkSettings, ShapeId};
use glam::{DVec3, Vec3};

/// Drag of a part of a character by inverse kinematics: it follows the pointer in the plane
/// parallel to the picture, and a chain of joints follows it. Pinned joints stay where they are.
///
/// Each step starts from the previous one, so that a hand can be led all around its shoulder and
/// the elbow never flips; the positions of pins are those at the start.
#[derive(Clone, Debug)]
pub struct IkDrag {
    shape: ShapeId,
    grip: IkGrip,
    /// Chain that turns; `None` if a root is moved.
    chain: Option<IkChain>,
    settings: IkSettings,
    start: Pose,
    /// Position of the grip at the start, in the world.
    anchor: DVec3,
    /// Normal of the plane in which the grip moves, in the world.
    normal: DVec3,
    /// Point that was grabbed in that plane, in the world.
    from: DVec3,
    target: Vec3,
    off: f32,
    /// Joint and position of each pin at the start, in the character's space.
    pinned: Vec<(usize, Vec3)>,
    lost: Vec<(usize, Vec3)>,
}

impl IkDrag {
    /// Distance, in the character's space, of the grip from its target or of a pin from its place
    /// above which it counts as out of reach.
    pub const OUT_OF_REACH: f32 = 5e-3;

    /// Begins a drag of `grip` of the character `shape` with the cursor on `ray`. `None` if it does
    /// not exist, the shape is scaled to zero, or no joint can turn, as below a pin.
    pub fn begin(session: &Session, shape: ShapeId, grip: IkGrip, ray: &Ray) -> Option<Self> {
        let character = session.scene().character(shape)?;
        let settings = &character.ik;
        let joints = character.character.skeleton().joints();
        let is_root = joints.get(grip.joint())?.parent.is_none();
        let chain = match grip {
            IkGrip::Joint(_) if is_root => None,
            _ => Some(grip.chain(session, shape)?),
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

    /// Edit that poses the character for the cursor on `ray`. `None` if there is no such pose.
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

    /// Identifier of the character.
    pub fn shape(&self) -> ShapeId {
        self.shape
    }

    /// Part that is dragged.
    pub fn grip(&self) -> IkGrip {
        self.grip
    }

    /// Chain that turns; `None` if a root is moved.
    pub fn chain(&self) -> Option<&IkChain> {
        self.chain.as_ref()
    }

    /// Target of the grip, in the world.
    pub fn target(&self) -> Vec3 {
        self.target
    }

    /// Distance of the grip from the target, in the character's space.
    pub fn off(&self) -> f32 {
        self.off
    }

    /// Pinned joints that could not be held, with their positions at the start, in the character's
    /// space.
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
            // A pin that is itself dragged is not lost.
            off > Self::OUT_OF_REACH && !busy.contains(&was.0)
        });
        self.lost = lost.map(|(was, _)| *was).collect();
        Some(held)
    }

    /// Point where the ray meets the plane, in the world.
    fn meeting(&self, ray: &Ray) -> Option<DVec3> {
        DRay::from(ray).meet_plane(self.anchor, self.normal)
    }
}

/// Positions of the pinned joints under `pose`, in the character's space.
fn pins_at(skeleton: &SkeletalModel, pose: &Pose, settings: &IkSettings) -> Vec<(usize, Vec3)> {
    if settings.pins.is_empty() {
        return Vec::new();
    }
    let frames = skeleton.update_current_joint_to_world_transforms(pose);
    let place = |&pin: &usize| Some((pin, frames.get(pin)?.w_axis.truncate()));
    settings.pins.iter().filter_map(place).collect()
}
