//! Meshes of another pose: whether there is one in which the exact formula gives the mesh.

mod fewest;
mod fit;
mod solve;

use super::diagnosis_words::vector;
use super::model::Model;
use super::skin::Skinner;
use super::{Formula, VertexOrder};
use crate::character::Pose;
use crate::math::Euler;
use crate::steps::Pace;
use fewest::{fewest, with_small_turns_put_back};
use fit::{Fit, Posed};
use glam::{DMat3, DVec3};
use serde::Serialize;
use std::fmt;

/// Angle between two rotations of a joint that are told apart, in degrees.
const TOLD_APART: f64 = 0.1;
/// Joints that are told in words; the others are counted.
const TOLD: usize = 5;

/// A pose in which the exact formula gives the mesh, other than the one that it was held against.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OtherPose {
    /// The pose. Joints that move no vertex are as in the one that was expected.
    #[serde(skip)]
    pub pose: Pose,
    /// The joints that differ, from the root on; never empty.
    pub joints: Vec<TurnedJoint>,
    /// How far the mesh is from the exact one in that pose, at most and by the size.
    pub error: f64,
}

/// A joint that is in another place of its range than expected.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TurnedJoint {
    /// Its name.
    pub joint: String,
    /// Its index.
    pub joint_index: usize,
    /// The angles that the mesh shows, in degrees about X, Y and Z; of all that give the same rotation
    /// those nearest to the expected ones.
    pub degrees: [f32; 3],
    /// The angles that were expected.
    pub expected: [f32; 3],
    /// The angle between the rotations of both, in degrees.
    pub turned_by: f64,
    /// Of a root, how far it is moved otherwise than expected, in model space; `None` if it is not.
    pub moved: Option<[f32; 3]>,
    /// Whether other angles give the same mesh: those of the joint and of others in the same place share a turn that
    /// no vertex tells how.
    pub is_ambiguous: bool,
}

impl fmt::Display for TurnedJoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [degrees, expected] = [self.degrees, self.expected].map(angles);
        write!(f, "{} {degrees}", self.joint)?;
        if degrees != expected {
            write!(f, " instead of {expected}")?;
        }
        if self.is_ambiguous {
            f.write_str(", or others that give the same")?;
        }
        match self.moved {
            Some(moved) => write!(f, ", moved by {}", vector(moved.map(f64::from))),
            None => Ok(()),
        }
    }
}

impl TurnedJoint {
    /// Whether its angles differ, and not only where it is.
    pub(super) fn is_turned(&self) -> bool {
        angles(self.degrees) != angles(self.expected)
    }
}

/// Angles in words: whole degrees where they are whole, and a zero without a sign.
fn angles(of: [f32; 3]) -> String {
    let [x, y, z] = of.map(|degrees| {
        let tenths = (degrees * 10.0).round() / 10.0;
        (tenths + 0.0).to_string()
    });
    format!("({x}°, {y}°, {z}°)")
}

impl OtherPose {
    /// The joints that are told in words, those first that are turned most, and how many others there are.
    pub fn told(&self) -> (Vec<&TurnedJoint>, usize) {
        let mut told: Vec<&TurnedJoint> = self.joints.iter().collect();
        // Stable: of those that are turned as much, or only moved, the one next to the root comes first.
        told.sort_by(|a, b| b.turned_by.total_cmp(&a.turned_by));
        told.truncate(TOLD);
        let more = self.joints.len() - told.len();
        (told, more)
    }
}

/// The pose in which the exact formula gives the vertices `theirs`, if there is one that differs from
/// `expected`.
pub(super) async fn find(
    model: &Model<'_>,
    expected: &Pose,
    order: VertexOrder,
    theirs: &[DVec3],
    (tolerance, size): (f64, f64),
    pace: &Pace,
) -> Option<OtherPose> {
    let fit = Fit::new(model, expected, order, theirs)?;
    let search = Search {
        model,
        expected,
        order,
        theirs,
        tolerance,
    };
    let all = fit.clone().improve(tolerance, pace).await;
    let found = search.found(&all)?;
    let agrees = |posed: &Posed| search.found(posed).is_some();
    let fewer = match fewest(&fit, tolerance, found.1.len(), agrees, pace).await {
        Some(fewer) => Some(fewer),
        None => {
            let mut turned: Vec<&TurnedJoint> = found.1.iter().collect();
            turned.sort_by(|a, b| a.turned_by.total_cmp(&b.turned_by));
            let turned = turned.iter().map(|joint| joint.joint_index).collect();
            with_small_turns_put_back(&fit, tolerance, (&all, turned), agrees, pace).await
        }
    };
    let fewer = fewer.and_then(|posed| search.found(&posed));
    let (pose, joints, error) = fewer
        .filter(|fewer| fewer.1.len() < found.1.len())
        .unwrap_or(found);
    Some(OtherPose {
        pose,
        joints,
        error: error / size,
    })
}

/// What a pose that was found is held against.
struct Search<'a> {
    model: &'a Model<'a>,
    expected: &'a Pose,
    order: VertexOrder,
    theirs: &'a [DVec3],
    tolerance: f64,
}

impl Search<'_> {
    /// The pose that `posed` is, with the joints that differ from the expected one and the largest distance of the
    /// exact mesh in it, if that agrees and any joint differs.
    fn found(&self, posed: &Posed) -> Option<(Pose, Vec<TurnedJoint>, f64)> {
        let Posed { rotations, offsets } = posed;
        let Self {
            model, expected, ..
        } = *self;
        // Joints that differ in a hair are as expected, if the mesh agrees with that.
        let (mut whole, mut plain) = (expected.clone(), expected.clone());
        let mut joints = Vec::new();
        let ambiguous = ambiguous(model, self.tolerance);
        for &joint in &model.by_depth {
            let before = expected.rotation(joint);
            let after = Euler::nearest(rotations[joint].as_mat3(), before);
            let moved = offsets[joint] - expected.root_offset(joint).as_dvec3();
            let turned_by = degrees_between(before.to_dmat3(), rotations[joint]);
            let is_turned = turned_by > TOLD_APART;
            let is_moved = moved.length() > self.tolerance;
            whole.set_joint_transform(joint, after);
            whole.set_root_offset(joint, offsets[joint].as_vec3());
            if is_turned {
                plain.set_joint_transform(joint, after);
            }
            if is_moved {
                plain.set_root_offset(joint, offsets[joint].as_vec3());
            }
            if is_turned || is_moved {
                joints.push(TurnedJoint {
                    joint: model.skeleton().joints()[joint].name.clone(),
                    joint_index: joint,
                    degrees: plain.rotation(joint).degrees().to_array(),
                    expected: before.degrees().to_array(),
                    turned_by: if is_turned { turned_by } else { 0.0 },
                    moved: is_moved.then(|| moved.as_vec3().to_array()),
                    is_ambiguous: ambiguous[joint],
                });
            }
        }
        if joints.is_empty() {
            return None;
        }
        let poses = [plain, whole].into_iter();
        let mut errors =
            poses.map(|pose| (largest_error(model, &pose, self.order, self.theirs), pose));
        let (error, pose) = errors.find(|(error, _)| *error <= self.tolerance)?;
        Some((pose, joints, error))
    }
}

/// For each joint whether other angles of it and of joints in the same place give the same mesh: where a joint moves no
/// vertex but by those that hang on it at its own place, its turn can as well be theirs.
fn ambiguous(model: &Model, tolerance: f64) -> Vec<bool> {
    let joints = model.skeleton().joints();
    let mut moves = vec![false; joints.len()];
    for vertex in 0..model.positions.len() {
        let influences = model.influences(vertex).iter();
        for influence in influences.filter(|influence| influence.weight != 0.0) {
            moves[influence.joint as usize] = true;
        }
    }
    let own = moves.clone();
    for &joint in model.by_depth.iter().rev() {
        if let Some(parent) = joints[joint].parent {
            moves[parent] |= moves[joint];
        }
    }
    let mut found = vec![false; joints.len()];
    for (parent, &is_moving) in own.iter().enumerate() {
        let children = model.skeleton().children(parent).iter().copied();
        let children: Vec<usize> = children.filter(|&child| moves[child]).collect();
        let is_here = |&child: &usize| joints[child].offset.as_dvec3().length() <= tolerance;
        if !is_moving && !children.is_empty() && children.iter().all(is_here) {
            for joint in children.into_iter().chain([parent]) {
                found[joint] = true;
            }
        }
    }
    found
}

/// The angle between two rotations, in degrees.
fn degrees_between(a: DMat3, b: DMat3) -> f64 {
    let turn = a.transpose() * b;
    let trace = turn.x_axis.x + turn.y_axis.y + turn.z_axis.z;
    ((trace - 1.0) / 2.0).clamp(-1.0, 1.0).acos().to_degrees()
}

/// The largest distance of `theirs` from the exact mesh in `pose`.
fn largest_error(model: &Model, pose: &Pose, order: VertexOrder, theirs: &[DVec3]) -> f64 {
    let exact = Formula {
        vertex_order: order,
        ..Formula::default()
    };
    let mut skinner = Skinner::new(model, pose, &exact);
    let distances = theirs.iter().enumerate();
    distances
        .map(|(index, &theirs)| skinner.place(index).distance(theirs))
        .fold(0.0, f64::max)
}
