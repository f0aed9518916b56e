use super::{IkSettings, MissingJoints, MissingPose};
use crate::character::{Character, Pose};
use crate::revision::Revision;
use std::collections::HashSet;
use std::sync::Arc;

/// Character in the scene, with its pose, its kept poses and its display options.
#[derive(Clone, Debug)]
pub struct CharacterShape {
    /// Skeleton, weights and bind mesh, shared by copies of the scene.
    pub character: Arc<Character>,
    /// Current pose, changed by [`CharacterShape::set_pose`] alone.
    pose: Pose,
    /// Revision of everything that the deformed mesh follows from: character, pose and skinning method.
    revision: Revision,
    poses: Vec<KeptPose>,
    /// Settings of inverse kinematics, with its pins.
    pub ik: IkSettings,
    skinning_method: SkinningMethod,
    /// Display options.
    pub display: CharacterDisplay,
    /// What was saved about joints that it does not have.
    pub missing_joints: Arc<MissingJoints>,
}

/// Way in which a character's mesh follows its joints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SkinningMethod {
    /// The assignment's: the weighted sum of where each joint takes a vertex.
    #[default]
    LinearBlend,
    /// Dual quaternions: a rigid motion blended from those of the joints.
    DualQuaternion,
}

/// Display options of a character.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CharacterDisplay {
    /// Skeleton, mesh or both.
    pub mode: ModelDisplay,
    /// Display of joints.
    pub joints: JointStyle,
    /// Display of bones.
    pub bones: BoneStyle,
    /// Diameter of joints drawn as points, in pixels.
    pub point_size: f32,
    /// Width of bones drawn as lines, in pixels; 1 is a plain GL line.
    pub line_width: f32,
}

impl Default for CharacterDisplay {
    fn default() -> Self {
        Self {
            mode: ModelDisplay::Mesh,
            joints: JointStyle::Spheres,
            bones: BoneStyle::Boxes,
            point_size: 8.0,
            line_width: 1.0,
        }
    }
}

/// Parts of a character that are drawn: Model Display Mode in the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ModelDisplay {
    /// Joints and bones.
    Skeleton,
    /// The deformed mesh.
    Mesh,
    /// The mesh with the skeleton seen through it.
    Both,
}

/// Display of joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum JointStyle {
    /// Round points of a fixed size on screen.
    Points,
    /// Spheres of radius 0.02 in the character's space.
    Spheres,
}

/// Display of bones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BoneStyle {
    /// Lines of a fixed width on screen.
    Lines,
    /// Boxes of half-width 0.01 in the character's space.
    Boxes,
}

impl PartialEq for CharacterShape {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.character, &other.character)
            && self.pose == other.pose
            && self.poses == other.poses
            && self.ik == other.ik
            && self.skinning_method == other.skinning_method
            && self.display == other.display
            && self.missing_joints == other.missing_joints
    }
}

impl CharacterShape {
    /// `character` in its bind pose.
    pub fn new(character: Arc<Character>) -> Self {
        Self {
            character,
            pose: Pose::new(),
            revision: Revision::new(),
            poses: Vec::new(),
            ik: IkSettings::default(),
            skinning_method: SkinningMethod::default(),
            display: CharacterDisplay::default(),
            missing_joints: Arc::default(),
        }
    }

    /// Current pose.
    pub fn pose(&self) -> &Pose {
        &self.pose
    }

    /// Pose at a time of playback, in seconds. So far a character has one pose at all times.
    pub fn pose_at(&self, _time: f64) -> &Pose {
        &self.pose
    }

    /// Revision of the pose at a time of playback, in seconds, and of the weights: all that the
    /// deformed mesh follows from.
    pub fn revision_at(&self, _time: f64) -> Revision {
        self.revision
    }

    /// See [`super::Scene::memory`].
    pub(super) fn memory(&self, counted: &mut HashSet<usize>) -> usize {
        let shared = if counted.insert(Arc::as_ptr(&self.character).addr()) {
            self.character.weights_memory() + self.character.bind_mesh().memory(counted)
        } else {
            0
        };
        let kept = |kept: &KeptPose| size_of::<KeptPose>() + kept.name.len() + kept.pose.memory();
        let pins = self.ik.pins.len().div_ceil(5) * 12 * size_of::<usize>();
        let kept = self.poses.iter().map(kept).sum::<usize>();
        shared + self.pose.memory() + kept + pins
    }

    /// Kept poses, in the order in which they were first kept.
    pub fn poses(&self) -> &[KeptPose] {
        &self.poses
    }

    /// Replaces all kept poses. Of several with one name the first is kept.
    pub fn set_poses(&mut self, poses: Vec<KeptPose>) {
        let mut names = HashSet::new();
        let first = |kept: &KeptPose| names.insert(kept.name.clone());
        self.poses = poses.into_iter().collect();
        self.poses.retain(first);
    }

    /// Keeps the current pose under `name`, replacing the one of that name if there is one, with what was
    /// saved of joints that the character does not have.
    pub fn keep_pose(&mut self, name: String) {
        let pose = self.pose.clone();
        if *self.missing_joints != MissingJoints::default() {
            Arc::make_mut(&mut self.missing_joints).keep_pose(&name);
        }
        match self.poses.iter_mut().find(|kept| kept.name == name) {
            Some(kept) => kept.pose = pose,
            None => self.poses.push(KeptPose { name, pose }),
        }
    }

    /// Removes the kept pose at `index`, if there is one.
    pub fn forget_pose(&mut self, index: usize) {
        if index < self.poses.len() {
            let KeptPose { name, .. } = self.poses.remove(index);
            if self.missing_joints.of_kept(&name).is_some() {
                Arc::make_mut(&mut self.missing_joints).forget_pose(&name);
            }
        }
    }

    /// First name of `Pose 1`, `Pose 2`, … that no kept pose has.
    pub fn free_pose_name(&self) -> String {
        let taken = |name: &String| self.poses.iter().any(|kept| kept.name == *name);
        let mut names = (1..).map(|number| format!("Pose {number}"));
        names.find(|name| !taken(name)).unwrap_or_default()
    }

    /// Replaces the pose. An equal one does not change the revision.
    pub fn set_pose(&mut self, pose: Pose) {
        if pose != self.pose {
            self.pose = pose;
            self.revision = Revision::new();
        }
    }

    /// Whether every joint is at rest, those that were saved with a pose and that the character does not
    /// have included.
    pub fn is_at_rest(&self) -> bool {
        self.pose.is_bind() && self.missing_joints.pose == MissingPose::default()
    }

    /// Resets every joint to rest, and forgets what was saved of the pose of joints that the character
    /// does not have.
    pub fn reset_pose(&mut self) {
        if self.missing_joints.pose != MissingPose::default() {
            Arc::make_mut(&mut self.missing_joints).pose = MissingPose::default();
        }
        self.set_pose(Pose::new());
    }

    /// Whether a joint is pinned, or was and is not there any more.
    pub fn has_pins(&self) -> bool {
        !(self.ik.pins.is_empty() && self.missing_joints.pins.is_empty())
    }

    /// Unpins all joints, and forgets the pins of those that the character does not have.
    pub fn unpin_all(&mut self) {
        self.ik.pins.clear();
        if !self.missing_joints.pins.is_empty() {
            Arc::make_mut(&mut self.missing_joints).pins.clear();
        }
    }

    /// Way in which the mesh follows the joints.
    pub fn skinning_method(&self) -> SkinningMethod {
        self.skinning_method
    }

    /// Sets the way in which the mesh follows the joints. An equal one does not change the revision.
    pub fn set_skinning_method(&mut self, method: SkinningMethod) {
        if method != self.skinning_method {
            self.skinning_method = method;
            self.revision = Revision::new();
        }
    }

    /// Leaves every vertex at most `most` influences (see [`Character::limited`]).
    pub fn limit_influences(&mut self, most: usize) {
        self.character = Arc::new(self.character.limited(most));
        self.revision = Revision::new();
    }
}

/// Pose that is kept with a character under a name.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptPose {
    /// Name in the list, unique among the character's kept poses.
    pub name: String,
    /// Rotations and translations of the joints.
    pub pose: Pose,
}
