//! Poses that lack one joint: the plainest reason why a mesh is off, alone or beside a mistake.

use super::diagnosis::ToldMistake;
use super::formula::{Formula, VertexOrder};
use super::found_otherwise::JOINT_NOT_TURNED;
use super::search::{Explanation, Search};
use super::skin::Skinner;
use super::ways::{Made, formula};
use crate::character::Pose;
use crate::math::Euler;
use crate::steps::Pace;

/// Fewest joints of a pose of which one may be left out beside a mistake. Of two, no more than half of the pose would be
/// there.
const FEWEST: usize = 3;
/// Joints of the largest poses in which each is left out beside each mistake.
const MOST: usize = 128;

/// A joint without whose rotation the exact formula gives the mesh.
pub(super) struct NotTurned {
    pub(super) joint: usize,
    /// What is left: the largest distance.
    pub(super) error: f64,
}

/// Joints each of which, left as it is in the bind pose, gives the mesh of `search`, with vertices in `order`. Where no other
/// joint is turned that is the whole pose, and none is told.
pub(super) async fn find(search: &Search<'_>, order: VertexOrder, pace: &Pace) -> Vec<NotTurned> {
    let mut found = Vec::new();
    for joint in turned(search.pose, search.model.skeleton().joints().len()) {
        let pose = without(search.pose, joint);
        if pose.is_bind() {
            continue;
        }
        let given = exact_in(search, &pose, order, pace).await;
        found.extend(given.map(|given| NotTurned {
            joint,
            error: given.error,
        }));
    }
    found
}

/// The pose of a search without each of its joints, where one of them is left out beside a mistake.
pub(super) struct Lacking<'a> {
    search: &'a Search<'a>,
    poses: Vec<(usize, Pose)>,
}

impl<'a> Lacking<'a> {
    /// `None` where the pose has too few or too many joints for that.
    pub(super) fn new(search: &'a Search<'a>) -> Option<Self> {
        let moves = search.model.moving_or_below();
        let is_in_pose = |joint: &usize| moves[*joint] && search.pose.is_changed(*joint);
        let in_pose = (0..moves.len()).filter(is_in_pose).count();
        let joints = turned(search.pose, moves.len()).filter(|&joint| moves[joint]);
        let poses = joints.map(|joint| (joint, without(search.pose, joint)));
        (FEWEST..=MOST).contains(&in_pose).then(|| Self {
            search,
            poses: poses.collect(),
        })
    }

    /// The joints that, not turned beside a mistake, give the mesh. Where it is right without one or two joints it is of
    /// another pose, and no mistake besides is named.
    pub(super) async fn beside(&self, other: Made, pace: &Pace) -> Vec<Explanation> {
        let by = formula(&[other]);
        if !self.search.may_be_of(&by) {
            return Vec::new();
        }
        let mut found = Vec::new();
        for (joint, pose) in &self.poses {
            let mut skinner = Skinner::new(self.search.model, pose, &by);
            let made = vec![other, Made::by_numbers(&JOINT_NOT_TURNED)];
            let given = self.search.explained_by(&mut skinner, made, pace).await;
            let Some(given) = given else { continue };
            if !self.is_right_in(pose, pace).await {
                found.push(Explanation {
                    how: Some(self.search.model.named(*joint)),
                    ..given
                });
            }
        }
        found
    }

    /// The joints that, not turned, give all vertices that are `such` ones.
    pub(super) async fn giving(
        &self,
        such: impl Fn(usize) -> bool,
        pace: &Pace,
    ) -> Vec<Explanation> {
        let search = self.search;
        let vertices: Vec<usize> = (0..search.theirs.len()).filter(|&it| such(it)).collect();
        let mut found = Vec::new();
        for (joint, pose) in &self.poses {
            let mut skinner = Skinner::new(search.model, pose, &Formula::default());
            let mut distances = vertices.iter().map(|&it| search.distance(&mut skinner, it));
            let error = distances.try_fold(0.0, |most: f64, distance| {
                (distance <= search.tolerance).then_some(most.max(distance))
            });
            found.extend(error.map(|error| Explanation {
                made: vec![Made::by_numbers(&JOINT_NOT_TURNED)],
                error,
                how: Some(search.model.named(*joint)),
            }));
            pace.after(vertices.len()).await;
        }
        found
    }

    /// The joint that, not turned, gives all vertices but the fewest and at most so many, with the mean distance that is left
    /// and how many these are.
    pub(super) async fn giving_all_but(
        &self,
        most: usize,
        pace: &Pace,
    ) -> Option<(ToldMistake, f64, usize)> {
        let search = self.search;
        let mut best: Option<(usize, f64, usize)> = None;
        for (joint, pose) in &self.poses {
            let mut skinner = Skinner::new(search.model, pose, &Formula::default());
            let all = 0..search.theirs.len();
            let off = all.filter(|&it| search.distance(&mut skinner, it) > search.tolerance);
            let off = off.take(most + 1).count();
            if off <= most && best.is_none_or(|(.., known)| off < known) {
                best = Some((*joint, search.nearness(&mut skinner).mean, off));
            }
            pace.after(search.theirs.len()).await;
        }
        best.map(|(joint, mean, off)| {
            let told = ToldMistake {
                how: search.model.named(joint).into(),
                ..ToldMistake::whole(&JOINT_NOT_TURNED)
            };
            (told, mean, off)
        })
    }

    /// Whether the mesh is right in `pose`, which lacks a joint, or without one more.
    async fn is_right_in(&self, pose: &Pose, pace: &Pace) -> bool {
        for (joint, _) in &self.poses {
            let pose = without(pose, *joint);
            let given = exact_in(self.search, &pose, VertexOrder::File, pace);
            if given.await.is_some() {
                return true;
            }
        }
        false
    }
}

/// The joints, of so many, that a pose turns.
fn turned(pose: &Pose, joints: usize) -> impl Iterator<Item = usize> + '_ {
    (0..joints).filter(|&joint| pose.rotation(joint) != Euler::default())
}

/// A pose in which one joint is not turned.
pub(super) fn without(pose: &Pose, joint: usize) -> Pose {
    let mut pose = pose.clone();
    pose.set_joint_transform(joint, Euler::default());
    pose
}

/// That the mesh of `search` is right in a pose, if it is.
async fn exact_in(
    search: &Search<'_>,
    pose: &Pose,
    order: VertexOrder,
    pace: &Pace,
) -> Option<Explanation> {
    let formula = Formula {
        vertex_order: order,
        ..Formula::default()
    };
    let mut skinner = Skinner::new(search.model, pose, &formula);
    search.explained_by(&mut skinner, Vec::new(), pace).await
}
