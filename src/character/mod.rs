//! Rigged characters: skeletons, poses, weights, and skinning by skeletal subspace deformation.
//!
//! Everything here is in the character's model space, which the shape's transform then places in
//! the world. Joint indices are the order of the file.

mod attachments;
mod bones;
mod coarse_character;
mod dual_quaternions;
mod facing;
mod file_frames;
pub mod ik;
mod import_character;
mod joint;
mod mirror;
mod pose;
mod skeletal_model;
mod skeleton_walk;
pub mod skinning;
mod skinning_blocks;

pub use attachments::{Attachments, AttachmentsError, Influence};
pub use bones::{Bone, JointBone, StickFigure};
pub use facing::Facing;
pub use file_frames::FileFrames;
pub use import_character::{Character, CharacterError};
pub use joint::{COURSE_JOINT_NAMES, Joint};
pub use mirror::Mirror;
pub use pose::{Pose, PoseError};
pub use skeletal_model::{SkeletalModel, SkeletonError};
pub use skeleton_walk::{SkeletonWalk, WalkStep};
pub use skinning_blocks::{Skinned, SkinningBlocks};
