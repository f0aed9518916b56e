//! Diagnosing: which mistake in skinning gives a mesh that another program posed, or a picture of it.
//! Mistakes are found by making them: each is a change of the formula, and the one whose mesh agrees is the
//! one that was made. Nothing here opens a file or a window.

mod choices;
mod diagnosis;
mod diagnosis_words;
mod faces;
mod formula;
mod found_otherwise;
mod job;
mod made_alone;
mod measure;
mod mistaken;
mod mistakes;
mod model;
mod nearest;
mod no_numbers;
mod one_joint;
mod other_pose;
mod picture;
mod picture_search;
mod precision;
mod regions;
mod search;
mod silhouette;
mod skin;
mod triangles;
mod vertex_formula;
mod whole_program;

pub use diagnosis::{Diagnosis, NearlyRight, OfTheWhole, Region, Shown, ToldMistake, Verdict};
pub use diagnosis_words::{of_size, part_of_size};
pub use faces::FaceDifference;
pub use formula::{
    AngleUnits, AnglesOf, Chain, Columns, Divided, Factor, Factors, Formula, JointFormula,
    JointOrder, JointsBy, Kept, Offsets, OtherJoint, Rescaled, Rows, VertexOrder, WeightFormula,
};
pub use found_otherwise::{LAST_RESULT_SKINNED, SUM_NOT_RESET};
pub use job::MeshJob;
pub use measure::{MeshMeasure, measure};
pub use mistaken::{MistakenMesh, skin_by};
pub use mistakes::{MISTAKES, Mistake, POSE_NOT_APPLIED, Reading};
pub use nearest::Nearest;
pub use no_numbers::NoNumbers;
pub use other_pose::{OtherPose, TurnedJoint};
pub use picture::{PictureDiagnosis, PictureError, diagnose_picture, has_silhouette};
pub use precision::Coarse;
pub use vertex_formula::{Step, Term, VertexFormula};

use crate::character::{Character, Pose};
use crate::compare::{MeshFinding, MeshOptions, compare_meshes, permutation};
use crate::geometry::Mesh;
use crate::math::Aabb;
use crate::steps::{Pace, at_once};
use glam::{DVec3, Vec3};
use mistakes::IN_ANY_ORDER;
use model::Model;
use search::{Explanation, Made, Search};
use skin::Placed;
use std::rc::Rc;

/// Part of the largest error from which on much is off.
const MUCH: f64 = 0.25;

/// Error up to which meshes agree, by the size: more than rounding to four digits after the point
/// of a mesh of size 1, or computing in single precision, is off by.
const TOLERANCE: f64 = 1e-4;
/// The same for numbers that were written with fewer digits: what rounding to four digits in all is
/// off by. Fewer are too few to tell what is wrong.
const MOST_TOLERANCE: f64 = 1e-3;
/// What single precision is off by, by the largest coordinate.
const SINGLE_PRECISION: f64 = 1e-6;
/// Errors that are no more than this many times the least one are as good.
const AS_GOOD: f64 = 2.0;
/// Errors that are as good as none, by the size.
const AS_GOOD_AS_NONE: f64 = 5e-6;

/// The largest error that is as good as the `least`, of a mesh of this size.
fn as_good(least: f64, size: f64) -> f64 {
    (AS_GOOD * least).max(AS_GOOD_AS_NONE * size)
}

/// A mesh that agrees with the exact one is still one of a mistake if that is this many times nearer.
const MUCH_NEARER: f64 = 10.0;

/// Reason why a mesh cannot be one of a character.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DiagnoseError {
    /// It has another number of vertices, and none that an importer leaves.
    #[error("expected {expected} vertices, as the character has, found {found}")]
    Vertices {
        /// Vertices of the character.
        expected: usize,
        /// Vertices of the mesh.
        found: usize,
    },
}

/// Whether a mesh of `vertices` vertices may be one of `character`, or of what importers make of it.
pub fn may_be_of(character: &Character, vertices: usize) -> bool {
    order_of(&Model::new(character), vertices).is_some()
}

/// Finds out which mistake gives the vertices of `theirs`, in model space, instead of those of
/// `character` in `pose`, and whether it has the triangles of the character.
///
/// # Errors
/// If their number fits neither the character nor what importers make of it, or it has none.
pub fn diagnose(
    character: &Character,
    pose: &Pose,
    theirs: &Mesh,
) -> Result<Diagnosis, DiagnoseError> {
    at_once(|pace| diagnose_by(character, pose, theirs, pace))
}

/// [`diagnose`] at a pace.
async fn diagnose_by(
    character: &Character,
    pose: &Pose,
    theirs: &Mesh,
    pace: Rc<Pace>,
) -> Result<Diagnosis, DiagnoseError> {
    let model = Model::new(character);
    let mut found = diagnose_vertices(&model, pose, &theirs.positions, &pace).await?;
    found.judge(FaceDifference::find(&model, &found, theirs, &pace).await);
    Ok(found)
}

/// The diagnosis of vertices, whose faces are not known yet.
async fn diagnose_vertices(
    model: &Model<'_>,
    pose: &Pose,
    theirs: &[Vec3],
    pace: &Pace,
) -> Result<Diagnosis, DiagnoseError> {
    let order = order_of(model, theirs.len()).ok_or(DiagnoseError::Vertices {
        expected: model.positions.len(),
        found: theirs.len(),
    })?;
    let exact = search::exact(model, pose, order);
    pace.after(exact.len()).await;
    let size = size_of(exact.iter().map(|placed| placed.at.as_vec3()));
    let points: Vec<DVec3> = theirs.iter().map(|point| point.as_dvec3()).collect();
    let distances: Vec<f64> = exact
        .iter()
        .zip(&points)
        .map(|(placed, &point)| placed.distance(point))
        .collect();
    let half_step = precision::half_step(theirs);
    let tolerance = tolerance(theirs, half_step, size);
    let mut findings = Findings {
        model,
        order,
        theirs: &points,
        exact: &exact,
        distances: &distances,
        size,
        tolerance,
    };
    let error = findings.error();
    if order == VertexOrder::File && error <= tolerance {
        let closer = error / MUCH_NEARER;
        let is_closer = |it: &Explanation| closer > SINGLE_PRECISION * size && it.error <= closer;
        let search = Search::new(model, pose, &points, tolerance, &distances);
        let (_, same) = search.singles(pace).await;
        let (explanations, same): (Vec<_>, Vec<_>) = same.into_iter().partition(is_closer);
        if explanations.is_empty() {
            let mut found = findings.diagnosis(Verdict::Right);
            for id in same.iter().flat_map(Explanation::ids) {
                if !found.unseen.contains(&id) {
                    found.unseen.push(id);
                }
            }
            return Ok(found);
        }
        findings.tolerance = closer;
        return Ok(findings.explained(&explanations));
    }
    let search = Search::new(model, pose, &points, tolerance, &distances);
    let (alone, mut explanations) = search.singles(pace).await;
    if explanations.is_empty() {
        explanations.extend(findings.in_another_order());
    }
    if explanations.is_empty() {
        // Numbers that are worked out from a mesh bring many near it. Those that are right bring it much nearer.
        let rounding = precision::of_vertices(half_step).max(AS_GOOD_AS_NONE * size);
        let fits = search.within(rounding.max(error / MUCH_NEARER));
        explanations = made_alone::find(&search, &fits, order, &exact, size, pace).await;
    }
    if explanations.is_empty() {
        explanations = search.pairs(&alone, pace).await;
    }
    if explanations.is_empty() {
        let mut found = findings.diagnosis(Verdict::Unexplained);
        found.coarse = Coarse::find(&exact, theirs, half_step, size);
        if found.coarse.is_some_and(|coarse| coarse.may_be_right) {
            return Ok(found);
        }
        pace.after(exact.len()).await;
        found.regions = findings.regions();
        found.findings = findings.of_the_whole(theirs);
        if found.findings.is_empty() {
            let limits = (tolerance, size);
            found.other_pose = other_pose::find(model, pose, order, &points, limits, pace).await;
            if found.other_pose.is_some() {
                found.verdict = Verdict::OtherPose;
            }
        }
        // What is explained whole has nothing that is only near it.
        if found.other_pose.is_none() && found.findings.is_empty() {
            found.nearest = nearest::find(&search, model, pose, order, &alone);
        }
        return Ok(found);
    }
    let without_w: Vec<_> = (explanations.iter())
        .filter_map(Explanation::without_w)
        .collect();
    explanations.extend(without_w);
    if pose.is_bind() {
        // Whatever leaves out weights gives the file's own mesh at rest. The simplest is that it is that.
        explanations.sort_by_key(|explanation| explanation.ids() != [POSE_NOT_APPLIED]);
    }
    Ok(findings.explained(&explanations))
}

/// The order in which a program may have written so many vertices: that of the file if it may be.
fn order_of(model: &Model, vertices: usize) -> Option<VertexOrder> {
    let orders = [
        VertexOrder::File,
        VertexOrder::FirstUse,
        VertexOrder::Corners,
    ];
    let mut fitting = orders
        .into_iter()
        .filter(|&order| model.count(order) == vertices);
    fitting.next().filter(|_| vertices > 0)
}

/// Diagonal of the box around points, by which distances are told; 1 for points in one place.
fn size_of(points: impl Iterator<Item = Vec3>) -> f64 {
    match Aabb::from_points(points).size().as_dvec3().length() {
        size if size > 0.0 => size,
        _ => 1.0,
    }
}

/// How far vertices may be apart and agree, with numbers that rounding moves by `half_step` at most.
fn tolerance(theirs: &[Vec3], half_step: f64, size: f64) -> f64 {
    let rounding = precision::of_vertices(half_step);
    let by_size = rounding.clamp(TOLERANCE * size, MOST_TOLERANCE * size);
    let largest = theirs.iter().map(|point| point.abs().max_element());
    let largest = largest
        .filter(|largest| largest.is_finite())
        .fold(0.0, f32::max);
    by_size.max(SINGLE_PRECISION * f64::from(largest))
}

/// A mesh beside the exact one.
struct Findings<'a> {
    model: &'a Model<'a>,
    order: VertexOrder,
    theirs: &'a [DVec3],
    exact: &'a [Placed],
    distances: &'a [f64],
    size: f64,
    tolerance: f64,
}

impl Findings<'_> {
    /// The largest distance.
    fn error(&self) -> f64 {
        self.distances.iter().copied().fold(0.0, f64::max)
    }

    /// A diagnosis without causes.
    fn diagnosis(&self, verdict: Verdict) -> Diagnosis {
        let error = self.error() / self.size;
        let all = 0..self.distances.len();
        let off = all.filter(|&index| self.is_off(index)).count();
        Diagnosis {
            verdict,
            causes: Vec::new(),
            error,
            error_from_exact: error,
            tolerance: self.tolerance / self.size,
            mistakes: Vec::new(),
            same_as: Vec::new(),
            unseen: Vec::new(),
            first: self.first().filter(|_| verdict != Verdict::Right),
            faces: FaceDifference::default(),
            off,
            agrees: 1.0 - off as f64 / self.distances.len().max(1) as f64,
            regions: Vec::new(),
            other_pose: None,
            nearest: None,
            findings: Vec::new(),
            coarse: None,
        }
    }

    /// The diagnosis from explanations, of which there is at least one, in the order in which they
    /// are named.
    fn explained(&self, explanations: &[Explanation]) -> Diagnosis {
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
            }
        }
        found.causes = diagnosis::all_causes(&found.mistakes, &found.same_as);
        found
    }

    /// Whether the vertices are the exact ones in an order that no importer is known to leave.
    fn in_another_order(&self) -> Option<Explanation> {
        if self.order != VertexOrder::File {
            return None;
        }
        let exact: Vec<DVec3> = self.exact.iter().map(|placed| placed.at).collect();
        let from_exact = permutation(&exact, self.theirs, self.tolerance)?;
        let pairs = from_exact.iter().zip(self.theirs);
        let distances = pairs.map(|(&index, theirs)| exact[index as usize].distance(*theirs));
        let made = Made {
            mistake: Mistake::find("vertices-renumbered")?,
            reading: &IN_ANY_ORDER,
        };
        Some(Explanation {
            made: vec![made],
            error: distances.fold(0.0, f64::max),
            how: None,
        })
    }

    fn is_off(&self, index: usize) -> bool {
        self.distances[index] > self.tolerance
    }

    /// The joint that moves the vertex at `index` most, after all joints if none does.
    fn joint_of(&self, index: usize) -> usize {
        let source = self.model.source(self.order, index);
        let none = self.model.skeleton().joints().len();
        self.model.strongest(source.position).unwrap_or(none)
    }

    fn name(&self, joint: usize) -> Option<String> {
        let joints = self.model.skeleton().joints();
        joints.get(joint).map(|joint| joint.name.clone())
    }

    /// The vertex farthest off of the first joint, from the root on, where much is off: what joints below move a little
    /// shows little of the mistake.
    fn first(&self) -> Option<Shown> {
        let mut worst: Vec<Option<usize>> = vec![None; self.model.skeleton().joints().len() + 1];
        for index in 0..self.theirs.len() {
            let worst = &mut worst[self.joint_of(index)];
            let is_worse = |known: usize| self.distances[index] > self.distances[known];
            if self.is_off(index) && worst.is_none_or(is_worse) {
                *worst = Some(index);
            }
        }
        let none = worst.len() - 1;
        let off = |vertex: usize| self.distances[vertex];
        let most = worst.iter().flatten().map(|&vertex| off(vertex));
        let enough = MUCH * most.fold(0.0, f64::max);
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
    fn regions(&self) -> Vec<Region> {
        let joints = self.model.skeleton().joints();
        let (distances, limits) = (self.distances, (self.tolerance, self.size));
        regions::regions(joints, distances, limits, |index| self.joint_of(index))
    }

    /// Movements, scales and turns that give the whole mesh.
    fn of_the_whole(&self, theirs: &[Vec3]) -> Vec<OfTheWhole> {
        let exact = self
            .exact
            .iter()
            .map(|placed| placed.at.as_vec3())
            .collect();
        let [exact, theirs] = [exact, theirs.to_vec()].map(|points| Mesh::new(points, Vec::new()));
        let options = MeshOptions {
            tolerance: Some(self.tolerance),
            ..MeshOptions::default()
        };
        let Ok(compared) = compare_meshes(&exact, &theirs, &options) else {
            return Vec::new();
        };
        // What order and digits are is found out otherwise.
        let of_all = |finding: &&MeshFinding| {
            !matches!(
                finding,
                MeshFinding::Permuted { .. } | MeshFinding::Rounded { .. }
            )
        };
        let findings = compared.findings.iter().filter(of_all);
        findings.cloned().map(OfTheWhole).collect()
    }
}
