//! What is found out about a mesh, held against the exact one.

use super::diagnosis::{Diagnosis, OfTheWhole, Region, Shown, Verdict, all_causes};
use super::faces::FaceDifference;
use super::formula::{Formula, VertexOrder};
use super::mannequin_words::ToldFor;
use super::model::Model;
use super::not_turned::NotTurned;
use super::of_angles::ROOT_ANGLES_MISSING;
use super::other_pose::OtherPose;
use super::placed::Limits;
use super::regions::regions;
use super::search::Explanation;
use super::skin::{Placed, Skinner};
use super::ways::{Made, formula};
use super::{AS_GOOD_AS_NONE, POSE_NOT_APPLIED, UNSEEN, as_good};
use crate::character::Pose;
use crate::compare::{MeshFinding, MeshOptions, compare_meshes};
use crate::geometry::Mesh;
use glam::{DVec3, Vec3};
use std::collections::BTreeSet;

/// Part of the largest error from which on much is off.
const MUCH: f64 = 0.25;
/// Part of the largest weight that a joint has from which on a vertex is its own.
const OWN: f32 = 0.9;

/// A mesh beside the exact one.
pub(super) struct Findings<'a> {
    pub(super) model: &'a Model<'a>,
    pub(super) order: VertexOrder,
    pub(super) theirs: &'a [DVec3],
    pub(super) exact: &'a [Placed],
    pub(super) distances: &'a [f64],
    pub(super) size: f64,
    pub(super) tolerance: f64,
}

/// Share of those that are right where `off` of so many are not; 1 of none.
pub(super) fn share_right(off: usize, of: usize) -> f64 {
    1.0 - off as f64 / of.max(1) as f64
}

impl Findings<'_> {
    /// The largest distance.
    pub(super) fn error(&self) -> f64 {
        self.distances.iter().copied().fold(0.0, f64::max)
    }

    /// A diagnosis without causes.
    pub(super) fn diagnosis(&self, verdict: Verdict) -> Diagnosis {
        let error = self.error() / self.size;
        let all = 0..self.distances.len();
        let moved: Vec<usize> = all.clone().filter(|&index| self.is_moved(index)).collect();
        let moved_off = moved.iter().filter(|&&index| self.is_off(index)).count();
        let off = all.filter(|&index| self.is_off(index)).count();
        Diagnosis {
            verdict,
            causes: Vec::new(),
            error,
            error_from_exact: error,
            tolerance: self.tolerance / self.size,
            mistakes: Vec::new(),
            same_as: Vec::new(),
            others: Vec::new(),
            not_turned: Vec::new(),
            no_numbers: 0,
            not_reached: None,
            reached: 1.0,
            is_as_in_file: false,
            slight: Vec::new(),
            unseen: Vec::new(),
            first: self.first().filter(|_| verdict != Verdict::Right),
            faces: FaceDifference::default(),
            off,
            agrees: share_right(off, self.distances.len()),
            moved_agree: share_right(moved_off, moved.len()),
            regions: Vec::new(),
            other_pose: None,
            nearest: None,
            findings: Vec::new(),
            coarse: None,
            told_for: ToldFor::default(),
        }
    }

    /// The diagnosis of the exact mesh of another pose.
    pub(super) fn of_other_pose(&self, other: OtherPose) -> Diagnosis {
        Diagnosis {
            regions: self.regions(),
            other_pose: Some(other),
            ..self.diagnosis(Verdict::OtherPose)
        }
    }

    /// The diagnosis of a mesh all vertices of which are in one place; `None` of any other, and where they should be.
    pub(super) fn in_one_place(&self) -> Option<Diagnosis> {
        let found = MeshFinding::one_place(self.theirs.iter().copied())?;
        let first = self.exact.first()?.at;
        let are_apart = |placed: &Placed| placed.distance(first) > self.tolerance;
        self.exact.iter().any(are_apart).then(|| Diagnosis {
            regions: self.regions(),
            findings: vec![OfTheWhole(found)],
            ..self.diagnosis(Verdict::Unexplained)
        })
    }

    /// The diagnosis of the file's own mesh at rest, which nobody can tell from the skinned one.
    pub(super) fn as_the_file_has_it(&self) -> Diagnosis {
        Diagnosis {
            is_as_in_file: true,
            ..self.diagnosis(Verdict::Unexplained)
        }
    }

    /// The joints without whose rotation the mesh is given as well as by the best of the explanations. That the root has
    /// none is a mistake by itself.
    pub(super) fn names_of(
        &self,
        joints: &[NotTurned],
        explanations: &[Explanation],
    ) -> Vec<String> {
        let errors = explanations.iter().map(|it| it.error);
        let enough = as_good(errors.fold(f64::INFINITY, f64::min), self.size);
        let names_root = (explanations.iter()).any(|it| it.ids() == [ROOT_ANGLES_MISSING.id]);
        let is_told = |joint: &&NotTurned| {
            let is_root = self.model.skeleton().roots().contains(&joint.joint);
            joint.error <= enough && !(is_root && names_root)
        };
        let told = joints.iter().filter(is_told);
        told.filter_map(|joint| self.name(joint.joint)).collect()
    }

    /// The diagnosis from explanations, of which there is at least one, in the order in which they
    /// are named.
    pub(super) fn explained(&self, explanations: &[Explanation]) -> Diagnosis {
        let mut found = self.diagnosis(Verdict::Explained);
        let errors = explanations.iter().map(|explanation| explanation.error);
        let least = errors.fold(f64::INFINITY, f64::min);
        let enough = as_good(least, self.size);
        let mut good = explanations
            .iter()
            .filter(|explanation| explanation.error <= enough);
        if let Some(first) = good.next() {
            found.error = first.error / self.size;
            found.mistakes = first.told();
        }
        let together = found.together();
        for other in good {
            let ids = other.ids();
            let is_same = |known: &[&str]| ids.iter().all(|id| known.contains(id));
            if !is_same(&together) && !found.same_as.iter().any(|known| is_same(known)) {
                found.same_as.push(ids);
                for told in other.told() {
                    let mut known = found.mistakes.iter().chain(&found.others);
                    if known.all(|known| known.id != told.id) {
                        found.others.push(told);
                    }
                }
            }
        }
        found.causes = all_causes(&found.mistakes, &found.same_as);
        found
    }

    /// The diagnosis from explanations, of which there is at least one, in the order in which the search has them: the simplest
    /// are named first.
    pub(super) fn simplest(&self, mut explanations: Vec<Explanation>, pose: &Pose) -> Diagnosis {
        // Stable: otherwise the order of the tables decides.
        explanations.sort_by_key(Explanation::rare);
        let without_w: Vec<_> = (explanations.iter())
            .filter_map(Explanation::without_w)
            .collect();
        explanations.extend(without_w);
        // Whatever leaves out weights gives the file's own mesh at rest, where that is asked for, and more does where a pose
        // turns or moves little. The simplest is that it is that.
        let at_rest = explanations
            .iter()
            .position(|it| it.ids() == [POSE_NOT_APPLIED]);
        let is_as_good =
            |it: &Explanation| it.error <= explanations[0].error + AS_GOOD_AS_NONE * self.size;
        if let Some(at_rest) = at_rest
            && (pose.is_bind() || is_as_good(&explanations[at_rest]))
        {
            explanations[..=at_rest].rotate_right(1);
        }
        Diagnosis {
            slight: self.slight(&explanations, pose, UNSEEN * self.size),
            ..self.explained(&explanations)
        }
    }

    /// Mistakes of the explanations that by themselves move no vertex by more than `limit`, in whichever way of those they
    /// are made.
    fn slight(&self, explanations: &[Explanation], pose: &Pose, limit: f64) -> Vec<&'static str> {
        let mut slight = BTreeSet::new();
        let mut others = BTreeSet::new();
        for made in explanations.iter().flat_map(|it| &it.made) {
            let known = match self.moves_within(*made, pose, limit) {
                true => &mut slight,
                false => &mut others,
            };
            known.insert(made.mistake.id);
        }
        slight.difference(&others).copied().collect()
    }

    /// Whether a mistake by itself leaves every vertex within `limit` of the exact one. What it makes of them is known from its
    /// formula alone, which neither numbers from the mesh nor an order of vertices are in.
    fn moves_within(&self, made: Made, pose: &Pose, limit: f64) -> bool {
        let mut formula = formula(&[made]);
        if formula == Formula::default() || formula.vertex_order != VertexOrder::File {
            return false;
        }
        formula.vertex_order = self.order;
        let mut skinner = Skinner::new(self.model, pose, &formula);
        let mut all = self.exact.iter().enumerate();
        all.all(|(index, exact)| skinner.place(index).distance(exact.at) <= limit)
    }

    /// Whether the vertex at `index` is not where it is in the bind pose.
    fn is_moved(&self, index: usize) -> bool {
        self.exact[index].distance(self.at_rest(index)) > self.tolerance
    }

    /// Where the vertex at `index` is in the bind pose.
    pub(super) fn at_rest(&self, index: usize) -> DVec3 {
        self.model.positions[self.model.source(self.order, index).position]
    }

    pub(super) fn is_off(&self, index: usize) -> bool {
        self.distances[index] > self.tolerance
    }

    /// The joint that moves the vertex at `index` most, after all joints if none does.
    fn joint_of(&self, index: usize) -> usize {
        let source = self.model.source(self.order, index);
        let none = self.model.skeleton().joints().len();
        self.model.strongest(source.position).unwrap_or(none)
    }

    /// The largest weight of the vertex at `index`; 0 without any.
    fn weight_of(&self, index: usize) -> f32 {
        let source = self.model.source(self.order, index);
        let weights = self.model.influences(source.weights).iter();
        weights.map(|one| one.weight).fold(0.0, f32::max)
    }

    fn name(&self, joint: usize) -> Option<String> {
        let joints = self.model.skeleton().joints();
        joints.get(joint).map(|joint| joint.name.clone())
    }

    /// The vertex farthest off of the first joint, from the root on, where much is off, among those that are its own: what
    /// joints below move a little, or nearly as much, shows little of the mistake.
    fn first(&self) -> Option<Shown> {
        let mut strongest = vec![0.0_f32; self.model.skeleton().joints().len() + 1];
        for index in 0..self.theirs.len() {
            let strongest = &mut strongest[self.joint_of(index)];
            *strongest = strongest.max(self.weight_of(index));
        }
        let is_own = |index: usize| self.weight_of(index) >= OWN * strongest[self.joint_of(index)];
        self.first_of(is_own).or_else(|| self.first_of(|_| true))
    }

    /// The same among vertices that are `such` ones; `None` if much is off at none of them.
    fn first_of(&self, is_such: impl Fn(usize) -> bool) -> Option<Shown> {
        let mut worst: Vec<Option<usize>> = vec![None; self.model.skeleton().joints().len() + 1];
        let mut most = 0.0_f64;
        for index in (0..self.theirs.len()).filter(|&index| self.is_off(index)) {
            most = most.max(self.distances[index]);
            let worst = &mut worst[self.joint_of(index)];
            let is_worse = |known: usize| self.distances[index] > self.distances[known];
            if is_such(index) && worst.is_none_or(is_worse) {
                *worst = Some(index);
            }
        }
        let none = worst.len() - 1;
        let off = |vertex: usize| self.distances[vertex];
        let enough = MUCH * most;
        let mut joints = self.model.by_depth.iter().copied().chain([none]);
        let (joint, vertex) = joints.find_map(|joint| {
            let vertex = worst[joint].filter(|&vertex| off(vertex) >= enough);
            Some((joint, vertex?))
        })?;
        let name = self.name(joint);
        Some(Shown {
            joint_index: name.is_some().then_some(joint),
            joint: name,
            vertex,
            error: self.distances[vertex] / self.size,
            theirs: self.theirs[vertex].to_array(),
            exact: self.exact[vertex].at.to_array(),
        })
    }

    /// What each joint moves and is off.
    pub(super) fn regions(&self) -> Vec<Region> {
        let joints = self.model.skeleton().joints();
        let (distances, limits) = (self.distances, (self.tolerance, self.size));
        regions(joints, distances, limits, |index| self.joint_of(index))
    }

    /// Movements, scales and turns that give the whole mesh within `limits`.
    pub(super) fn of_the_whole(&self, limits: Limits) -> Vec<OfTheWhole> {
        let exact = self.exact.iter().map(|placed| placed.at.as_vec3());
        let theirs = self.theirs.iter().map(|place| place.as_vec3());
        let [exact, theirs] = [exact.collect(), theirs.collect()]
            .map(|points: Vec<Vec3>| Mesh::new(points, Vec::new()));
        let options = MeshOptions {
            tolerance: Some(self.tolerance),
            ..MeshOptions::default()
        };
        let Ok(compared) = compare_meshes(&exact, &theirs, &options) else {
            return Vec::new();
        };
        let exact = |vertex: usize| self.exact[vertex].at;
        // What order and digits are is found out otherwise, and of a smaller mesh more has to agree.
        let of_all = |finding: &&MeshFinding| match finding {
            MeshFinding::Permuted { .. } | MeshFinding::Rounded { .. } => false,
            MeshFinding::Offset { .. } | MeshFinding::Scaled { .. } | MeshFinding::Axes { .. } => {
                limits.error(finding, exact, self.theirs).is_some()
            }
            _ => true,
        };
        let findings = compared.findings.iter().filter(of_all);
        findings.cloned().map(OfTheWhole).collect()
    }

    /// Whether the whole mesh is the exact one with other axes, within `limits`.
    pub(super) fn has_other_axes(&self, limits: Limits) -> bool {
        let found = self.of_the_whole(limits);
        let is_of_axes = |found: &OfTheWhole| matches!(found.0, MeshFinding::Axes { .. });
        found.iter().any(is_of_axes)
    }
}
