use super::movement::{MoveAlong, Movement};
use super::{Edit, IkGrip, Session};
use crate::character::ik::{IkChain, IkGoal, hold_pins};
use crate::character::{Pose, SkeletalModel};
use crate::math::Ray;
use crate::scene::{IkSettings, ShapeId};
use glam::Vec3;

/// Drag of a part of a character by inverse kinematics: it follows the pointer in the plane
/// parallel to the picture, or along axes, and a chain of joints follows it. Pinned joints stay where they are.
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
    /// Movement of the target: in the plane parallel to the picture, unless it is held along axes.
    movement: Movement,
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
        let place = grip.place(session, shape)?.as_dvec3();
        let across = MoveAlong::Plane(session.view().camera.forward());
        Some(Self {
            shape,
            grip,
            chain,
            settings: settings.clone(),
            start: character.pose().clone(),
            movement: Movement::begin(place, across, ray)?,
            off: 0.0,
            pinned: pins_at(character.character.skeleton(), character.pose(), settings),
            lost: Vec::new(),
        })
    }

    /// The same drag along another line or plane, from where the grip was at the start.
    pub fn constrained(&self, along: MoveAlong) -> Self {
        Self {
            movement: self.movement.constrained(along),
            ..self.clone()
        }
    }

    /// Edit that poses the character for the cursor on `ray`, with `snap` in steps of 0.1. `None` if there is no such
    /// pose.
    pub fn update(&mut self, session: &Session, ray: &Ray, snap: bool) -> Option<Edit> {
        let before = self.movement.clone();
        self.movement.follow(ray, snap);
        self.edit(session, before)
    }

    /// Edit that poses the character with the target moved by exactly this length from where the grip was at the start,
    /// along the line or the first axis that it is held along. `None` if there is no such pose.
    pub fn moved_by(&mut self, session: &Session, length: f64) -> Option<Edit> {
        let before = self.movement.clone();
        self.movement.move_by(length);
        self.edit(session, before)
    }

    /// Edit for the movement so far; `None` if there is no such pose, and then the movement is as `before`.
    fn edit(&mut self, session: &Session, before: Movement) -> Option<Edit> {
        let edit = self.pose(session);
        if edit.is_none() {
            self.movement = before;
        }
        edit
    }

    fn pose(&mut self, session: &Session) -> Option<Edit> {
        let target = self.target();
        let character = session.scene().character(self.shape)?;
        let skeleton = character.character.skeleton();
        let world_from_model = session.evaluated().shape(self.shape)?.world_from_model;
        let in_model = world_from_model.inverse().transform_point3(target);
        if !in_model.is_finite() {
            return None;
        }
        let pose = self.solve(skeleton, character.pose(), in_model)?;
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
        self.movement.place().as_vec3()
    }

    /// Line or plane along which the target moves.
    pub fn along(&self) -> MoveAlong {
        self.movement.along()
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
