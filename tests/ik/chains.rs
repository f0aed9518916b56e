//! Skeletons and poses to try, and what is measured of them.

use editor_core::character::ik::IkChain;
use editor_core::character::{Joint, Pose, SkeletalModel};
use editor_core::math::Euler;
use glam::{Mat4, Vec3};
use proptest::prelude::*;
use std::collections::BTreeSet;

/// A row of joints, each the child of the one before, and the point that is brought to a target.
#[derive(Clone, Debug)]
pub struct Row {
    pub skeleton: SkeletalModel,
    pub pose: Pose,
    pub tip: Vec3,
}

impl Row {
    /// A row with these bones; the first joint is at `base`.
    pub fn new(base: Vec3, bones: &[Vec3], angles: &[Vec3]) -> Self {
        let mut offset = base;
        let mut joints = Vec::new();
        for (index, &bone) in bones.iter().enumerate() {
            joints.push(Joint {
                parent: index.checked_sub(1),
                offset,
                ..Joint::default()
            });
            offset = bone;
        }
        let mut pose = Pose::new();
        for (joint, &degrees) in angles.iter().enumerate() {
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        Self {
            skeleton: SkeletalModel::new(joints).expect("a row is a tree"),
            pose,
            tip: offset,
        }
    }

    /// The chain of all joints.
    pub fn chain(&self) -> Option<IkChain> {
        self.chain_of(usize::MAX)
    }

    pub fn chain_of(&self, length: usize) -> Option<IkChain> {
        let last = self.skeleton.joints().len() - 1;
        let (skeleton, pose) = (&self.skeleton, &self.pose);
        IkChain::to_point(skeleton, pose, last, self.tip, length, &BTreeSet::new())
    }

    /// Where a joint is, and beyond the last one the tip.
    pub fn point(&self, pose: &Pose, index: usize) -> Vec3 {
        let frames = frames(&self.skeleton, pose);
        match frames.get(index) {
            Some(frame) => frame.w_axis.truncate(),
            None => frames[frames.len() - 1].transform_point3(self.tip),
        }
    }

    /// Where the tip is.
    pub fn end(&self, pose: &Pose) -> Vec3 {
        self.point(pose, self.skeleton.joints().len())
    }

    /// Lengths of the bones from joint `first` on.
    pub fn lengths(&self, first: usize) -> Vec<f32> {
        let offsets = self.skeleton.joints()[first + 1..].iter();
        let bones = offsets.map(|joint| joint.offset.length());
        bones.chain([self.tip.length()]).collect()
    }
}

/// How near to its first joint, and how far from it, a chain with these links reaches.
pub fn reach(lengths: &[f32]) -> (f32, f32) {
    let total: f32 = lengths.iter().sum();
    let longest = lengths.iter().copied().fold(0.0, f32::max);
    ((2.0 * longest - total).max(0.0), total)
}

/// As the rest of the program computes them.
pub fn frames(skeleton: &SkeletalModel, pose: &Pose) -> Vec<Mat4> {
    skeleton.update_current_joint_to_world_transforms(pose)
}

pub fn vector(size: f32) -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-size..size).prop_map(Vec3::from)
}

/// Bones of common and of awkward kinds: none at all, tiny, along an axis.
fn bone() -> impl Strategy<Value = Vec3> {
    prop_oneof![
        6 => vector(2.0),
        1 => Just(Vec3::ZERO),
        1 => vector(1e-3),
        2 => prop::sample::select(vec![Vec3::Y, Vec3::NEG_Y, Vec3::X, Vec3::Z * 2.0]),
    ]
}

/// Degrees, many of them right angles or none.
fn angles() -> impl Strategy<Value = Vec3> {
    prop_oneof![
        3 => vector(400.0),
        2 => Just(Vec3::ZERO),
        1 => prop::sample::select(vec![
            Vec3::new(0.0, 90.0, 0.0),
            Vec3::new(180.0, 0.0, 0.0),
            Vec3::new(30.0, -90.0, 20.0),
        ]),
    ]
}

/// Rows of `count` joints; not all bones are without a length.
pub fn row(count: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Row> {
    let parts = prop::collection::vec((bone(), angles()), count);
    (vector(3.0), parts)
        .prop_map(|(base, parts)| {
            let (bones, angles): (Vec<Vec3>, Vec<Vec3>) = parts.into_iter().unzip();
            Row::new(base, &bones, &angles)
        })
        .prop_filter("a chain with a length", |row| {
            row.lengths(0).iter().sum::<f32>() > 0.05
        })
}

/// A direction, often along the chain as it is or an axis.
pub fn direction() -> impl Strategy<Value = Option<Vec3>> {
    prop_oneof![
        3 => vector(1.0).prop_map(|v| v.try_normalize()),
        1 => prop::sample::select(vec![Some(Vec3::Y), Some(Vec3::NEG_Y), Some(Vec3::Z)]),
        1 => Just(None),
    ]
}
