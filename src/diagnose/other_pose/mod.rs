//! Meshes of another pose: whether there is one in which the exact formula gives the mesh.

mod fewest;
mod fit;
mod shared;
mod solve;

use super::diagnosis::ToldMistake;
use super::diagnosis_words::{of_size, vector};
use super::model::Model;
use super::not_turned::{self, NotTurned};
use super::skin::Skinner;
use super::{Formula, VertexOrder, as_good};
use crate::character::Pose;
use crate::math::Euler;
use crate::steps::Pace;
use fewest::{fewest, with_small_turns_put_back};
use fit::{Fit, Posed};
use glam::{DMat3, DVec3, Vec3};
use serde::Serialize;
use shared::{SharedTurn, plainest};
use std::fmt;
use std::ops::RangeInclusive;

/// Angle between two rotations of a joint that are told apart, in degrees.
const TOLD_APART: f64 = 0.1;
/// The same where none of a pose is, of angles that were rounded.
const TOLD_APART_OF_SMALL: f64 = 0.01;
/// Parts of a degree that a mesh tells, …
const DEGREES_TOLD: f64 = 1e3;
/// … and fewer, of which angles are multiples where that is as good.
const FEWER_TOLD: [f64; 3] = [1.0, 1e1, 1e2];
/// Digits after the point with which angles are told: more than the fewest only where it takes them to tell two apart.
const DIGITS: RangeInclusive<i32> = 1..=3;
/// Angle up to which a joint is as good as turned as expected, such as by angles that are cut to whole degrees, in
/// degrees.
const AS_EXPECTED: f64 = 5.0;
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
    /// How much of the expected pose it has, 0 to 1: of the joints that move vertices and that either pose turns or
    /// moves, those that are as expected, and half of those that are turned otherwise in both.
    pub as_expected: f64,
    /// How many joints that is told of.
    pub posed_joints: usize,
    /// How far the mesh is from the exact one in that pose, at most and by the size, or from the one of the mistake besides.
    pub error: f64,
    /// A mistake that moves vertices by less than anybody sees, with which the mesh is of that pose.
    pub besides: Option<ToldMistake>,
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
        let [degrees, expected] = self.angles();
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
    /// Whether it is where and as it is in the bind pose, of which it differs in the pose `expected`.
    fn is_at_rest(&self, expected: &Pose) -> bool {
        let before = expected.root_offset(self.joint_index);
        let moved = self.moved.map_or(Vec3::ZERO, Vec3::from);
        let rotation = Euler::from_degrees(Vec3::from(self.degrees)).to_dmat3();
        // What is moved back is so but for the error of the fit.
        degrees_between(rotation, DMat3::IDENTITY) <= TOLD_APART
            && (before + moved).length() <= 0.01 * before.length()
    }

    /// Whether its angles differ, and not only where it is.
    pub(super) fn is_turned(&self) -> bool {
        let [degrees, expected] = self.angles();
        degrees != expected
    }

    /// Both rotations in words, with as many digits as it takes to tell them apart.
    fn angles(&self) -> [String; 2] {
        let with = |digits| [self.degrees, self.expected].map(|of| angles(of, digits));
        let differ = |[degrees, expected]: &[String; 2]| degrees != expected;
        let mut more = DIGITS.map(with).filter(differ);
        more.next().unwrap_or_else(|| with(*DIGITS.start()))
    }
}

/// Angles in words, within half a turn either way and with so many digits after the point: whole degrees where they are
/// whole, and a zero without a sign.
fn angles(of: [f32; 3], digits: i32) -> String {
    let scale = 10_f64.powi(digits);
    let [x, y, z] = of.map(|degrees| {
        let within = f64::from(degrees) - (f64::from(degrees) / 360.0 - 0.5).ceil() * 360.0;
        let rounded = (within * scale).round() / scale;
        (rounded + 0.0).to_string()
    });
    format!("({x}°, {y}°, {z}°)")
}

impl OtherPose {
    /// In words, but for what the mesh is the exact one in that pose, if agreeing within `tolerance` by the size does not say
    /// it.
    pub fn but_for(&self, tolerance: f64) -> Option<String> {
        match &self.besides {
            Some(mistake) => Some(format!("but for {}", mistake.id)),
            None if self.error > tolerance => Some(format!("but for {}", of_size(self.error))),
            None => None,
        }
    }

    /// The pose `expected` without the rotation of one joint, of a mesh of this size.
    pub(super) fn without(
        model: &Model<'_>,
        expected: &Pose,
        lacking: &NotTurned,
        size: f64,
    ) -> Self {
        let joint = lacking.joint;
        let before = expected.rotation(joint);
        let joints = vec![TurnedJoint {
            joint: model.skeleton().joints()[joint].name.clone(),
            joint_index: joint,
            degrees: [0.0; 3],
            expected: before.shortest_degrees().to_array(),
            turned_by: degrees_between(before.to_dmat3(), DMat3::IDENTITY),
            moved: None,
            is_ambiguous: false,
        }];
        let (as_expected, posed_joints) = share_of_expected(model, expected, &joints);
        Self {
            pose: not_turned::without(expected, joint),
            as_expected,
            posed_joints,
            joints,
            error: lacking.error / size,
            besides: None,
        }
    }

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
        shared: SharedTurn::all(model, tolerance),
    };
    let all = fit.clone().improve(tolerance, pace).await;
    let found = search.found(&all)?;
    let agrees = |posed: &Posed| search.found(posed).is_some();
    let joints_of = |posed: &Posed| {
        search
            .found(posed)
            .map_or(usize::MAX, |found| found.1.len())
    };
    let fewer = match fewest(&fit, tolerance, found.1.len(), agrees, pace).await {
        Some(fewer) => Some(fewer),
        None => {
            let mut turned: Vec<&TurnedJoint> = found.1.iter().collect();
            turned.sort_by(|a, b| a.turned_by.total_cmp(&b.turned_by));
            let turned = turned.iter().map(|joint| joint.joint_index).collect();
            with_small_turns_put_back(&fit, tolerance, (&all, turned), agrees, pace).await
        }
    };
    let chosen = fewer.filter(|posed| joints_of(posed) < found.1.len());
    let chosen = chosen.unwrap_or(all);
    let plain = plainest(&search.shared, &chosen, &fit.expected());
    let found = [plain, chosen]
        .iter()
        .find_map(|posed| search.found(posed))?;
    let (pose, joints, error) = search.in_fewer_parts(found, size);
    let (as_expected, posed_joints) = share_of_expected(model, expected, &joints);
    Some(OtherPose {
        pose,
        as_expected,
        posed_joints,
        joints,
        error: error / size,
        besides: None,
    })
}

/// What a pose that was found is held against.
struct Search<'a> {
    model: &'a Model<'a>,
    expected: &'a Pose,
    order: VertexOrder,
    theirs: &'a [DVec3],
    tolerance: f64,
    shared: Vec<SharedTurn>,
}

impl Search<'_> {
    /// The pose that `posed` is, with the joints that differ from the expected one and the largest distance of the
    /// exact mesh in it, if that agrees and any joint differs.
    fn found(&self, posed: &Posed) -> Option<(Pose, Vec<TurnedJoint>, f64)> {
        let told_apart = [TOLD_APART, TOLD_APART_OF_SMALL];
        let mut found = told_apart
            .map(|degrees| self.turned_by_more_than(degrees, posed))
            .into_iter();
        let (poses, joints) = found.find(|(_, joints)| !joints.is_empty())?;
        let mut errors = poses.into_iter().map(|pose| {
            (
                largest_error(self.model, &pose, self.order, self.theirs),
                pose,
            )
        });
        let (error, pose) = errors.find(|(error, _)| *error <= self.tolerance)?;
        Some((pose, joints, error))
    }

    /// What was found, by angles that are multiples of a larger part of a degree where that is as good: those of a pose that
    /// somebody typed are, and what the fit adds to 0 or to 20 is noise.
    fn in_fewer_parts(
        &self,
        (pose, joints, error): (Pose, Vec<TurnedJoint>, f64),
        size: f64,
    ) -> (Pose, Vec<TurnedJoint>, f64) {
        let enough = as_good(error, size).min(self.tolerance);
        let with = |parts: f64| {
            let (mut pose, mut joints) = (pose.clone(), joints.clone());
            for joint in joints.iter_mut().filter(|joint| joint.turned_by > 0.0) {
                let index = joint.joint_index;
                let rotation = without_noise(pose.rotation(index), parts);
                pose.set_joint_transform(index, rotation);
                joint.degrees = rotation.shortest_degrees().to_array();
            }
            let error = largest_error(self.model, &pose, self.order, self.theirs);
            (error <= enough).then_some((pose, joints, error))
        };
        FEWER_TOLD
            .into_iter()
            .find_map(with)
            .unwrap_or((pose, joints, error))
    }

    /// The joints that are turned by more than so many `degrees` otherwise than expected, or moved, with the pose in which
    /// these alone are, and the one that `posed` is.
    fn turned_by_more_than(&self, degrees: f64, posed: &Posed) -> ([Pose; 2], Vec<TurnedJoint>) {
        let Self {
            model, expected, ..
        } = *self;
        let Posed { rotations, offsets } = posed;
        // Joints that differ in a hair are as expected, if the mesh agrees with that.
        let (mut whole, mut plain) = (expected.clone(), expected.clone());
        let mut joints = Vec::new();
        let is_shared = |joint| {
            self.shared
                .iter()
                .flat_map(SharedTurn::joints)
                .any(|it| it == joint)
        };
        for &joint in &model.by_depth {
            let before = expected.rotation(joint);
            let after = Euler::nearest(rotations[joint].as_mat3(), before);
            let moved = offsets[joint] - expected.root_offset(joint).as_dvec3();
            let turned_by = degrees_between(before.to_dmat3(), rotations[joint]);
            let is_turned = turned_by > degrees;
            let is_moved = moved.length() > self.tolerance;
            whole.set_joint_transform(joint, after);
            whole.set_root_offset(joint, offsets[joint].as_vec3());
            if is_turned {
                plain.set_joint_transform(joint, without_noise(after, DEGREES_TOLD));
            }
            if is_moved {
                plain.set_root_offset(joint, offsets[joint].as_vec3());
            }
            if is_turned || is_moved {
                joints.push(TurnedJoint {
                    joint: model.skeleton().joints()[joint].name.clone(),
                    joint_index: joint,
                    degrees: plain.rotation(joint).shortest_degrees().to_array(),
                    expected: before.shortest_degrees().to_array(),
                    turned_by: if is_turned { turned_by } else { 0.0 },
                    moved: is_moved.then(|| moved.as_vec3().to_array()),
                    is_ambiguous: is_shared(joint),
                });
            }
        }
        ([plain, whole], joints)
    }
}

/// How much of the pose `expected` is in another one, from which the joints of `turned` alone differ: each joint that
/// moves vertices and is turned or moved in either counts whole where it is as expected, half where it is turned
/// otherwise, and not at all where it is at rest in one of both. With it the number of these joints.
fn share_of_expected(model: &Model, expected: &Pose, turned: &[TurnedJoint]) -> (f64, usize) {
    let moves = model.moving_or_below();
    let (mut all, mut counted) = (0, 0.0);
    for joint in (0..moves.len()).filter(|&joint| moves[joint]) {
        let is_expected = expected.is_changed(joint);
        let differs = turned.iter().find(|turned| turned.joint_index == joint);
        let is_there = differs.map_or(is_expected, |turned| !turned.is_at_rest(expected));
        if !is_expected && !is_there {
            continue;
        }
        all += 1;
        counted += match differs {
            Some(turned)
                if turned.turned_by > AS_EXPECTED + TOLD_APART_OF_SMALL
                    || turned.moved.is_some() =>
            {
                0.5 * f64::from(is_expected && is_there)
            }
            _ => 1.0,
        };
    }
    let share = if all == 0 { 1.0 } else { counted / all as f64 };
    (share, all)
}

/// Angles in so many parts of a degree.
fn without_noise(rotation: Euler, parts: f64) -> Euler {
    let degrees = rotation.degrees().to_array().map(f64::from);
    let rounded = degrees.map(|angle| (angle * parts).round() / parts + 0.0);
    Euler::from_degrees(Vec3::from(rounded.map(|angle| angle as f32)))
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
