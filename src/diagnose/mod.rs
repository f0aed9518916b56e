//! Diagnosing: which mistake in skinning gives a mesh that another program posed, or a picture of it.
//! Mistakes are found by making them: each is a change of the formula, and the one whose mesh agrees is the
//! one that was made. Nothing here opens a file or a window.

mod angle_formula;
mod any_order;
mod beside;
mod choices;
mod clipping;
mod diagnosis;
mod diagnosis_words;
mod elsewhere;
mod faces;
mod factor_formula;
mod findings;
mod formula;
mod found_otherwise;
mod job;
mod joint_list;
mod joint_transforms;
mod joint_tree;
mod made_alone;
mod mannequin_words;
mod measure;
mod misread_rows;
mod mistake;
mod mistaken;
mod mistakes;
mod model;
mod nearest;
mod nearly_other_pose;
mod no_numbers;
mod not_reached;
mod not_turned;
mod of_angles;
mod of_collada;
mod of_product;
mod of_weighted_sum;
mod of_whole_program;
mod one_joint;
mod other_pose;
mod otherwise;
mod picture;
mod picture_search;
mod placed;
mod precision;
mod regions;
mod search;
mod silhouette;
mod skin;
mod small_weights;
mod tree_formula;
mod triangles;
mod turned_camera;
mod turned_picture;
mod vertex_count;
mod vertex_formula;
mod ways;
mod weight_formula;
mod whole_program;
mod wrong_offset;

pub use diagnosis::{Diagnosis, NearlyRight, OfTheWhole, Region, Shown, ToldMistake, Verdict};
pub use diagnosis_words::{in_words, of_size, part_of_size, within_everywhere};
pub use faces::{FaceDifference, hardly_any_triangles};
pub use formula::{
    About, AngleAtEnd, AngleUnits, AnglesOf, AtEnd, Chain, Columns, Divided, Factor, Factors,
    Formula, Halves, JointFormula, JointOrder, JointsBy, Kept, Offsets, OtherJoint, Parents,
    Rescaled, Rotations, Rounded, RoundedAngles, Rows, Shaped, Shifted, VertexOrder, WeightFormula,
};
pub use found_otherwise::{
    ANGLES_KEPT, BIND_OF_OTHER_POSE, JOINT_NOT_TURNED, POSE_LATE, SUM_NOT_RESET,
    VERTICES_NOT_REACHED, VERTICES_WITHOUT_WEIGHTS,
};
pub use job::MeshJob;
pub use mannequin_words::ToldFor;
pub use measure::{MeshMeasure, measure};
pub use mistake::{
    MESH_MIRRORED, MOVED_AS_A_WHOLE, Mistake, PICTURE_TURNED, POSE_NOT_APPLIED, Reading,
    TRIANGLES_DIFFER, TRIANGLES_TURNED, VERTEX_MISSING, VERTEX_TOO_MANY,
};
pub use mistaken::{MistakenMesh, skin_after, skin_by};
pub use mistakes::MISTAKES;
pub use nearest::Nearest;
pub use no_numbers::NoNumbers;
pub use of_weighted_sum::LAST_RESULT_SKINNED;
pub use other_pose::{OtherPose, TurnedJoint};
pub use picture::{PictureDiagnosis, PictureError, diagnose_picture, has_silhouette};
pub use precision::Coarse;
pub use vertex_formula::{Step, Term, VertexFormula};

use crate::character::{Character, Pose};
use crate::geometry::Mesh;
use crate::math::Aabb;
use crate::steps::{Pace, at_once};
use findings::Findings;
use glam::{DVec3, Vec3};
use model::Model;
use of_angles::TOLD_LAST;
use precision::Written;
use search::{Alone, Explanation, Search};
use std::rc::Rc;
use vertex_count::Miscount;

/// Error up to which meshes agree, by the size: more than rounding to four digits after the point
/// of a mesh of size 1, or computing in single precision, is off by.
const TOLERANCE: f64 = 1e-4;
/// The same for numbers that were written with fewer digits: what rounding to four digits in all is
/// off by. Fewer are too few to tell what is wrong.
const MOST_TOLERANCE: f64 = 1e-3;
/// Largest distance of a vertex, by the size, up to which nobody sees that a mesh is not the exact one.
pub const UNSEEN: f64 = 1e-3;
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
    let model = Model::new(character);
    let mut miscounts = Miscount::places(character, vertices);
    order_of(&model, vertices).is_some() || miscounts.next().is_some()
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
    let vertices = &theirs.positions;
    let found = diagnose_vertices(&model, pose, vertices, &pace).await;
    let error = match found {
        Ok(mut found) => {
            found.judge(FaceDifference::find(&model, &found, theirs, &pace).await);
            return Ok(found);
        }
        Err(error) => error,
    };
    for miscount in Miscount::places(character, vertices.len()) {
        let lacking = miscount.lacking(character);
        let lacking = lacking.as_ref().map(Model::new);
        let model = lacking.as_ref().unwrap_or(&model);
        let mut others = diagnose_vertices(model, pose, miscount.without(vertices), &pace).await?;
        if !miscount.renumbers() {
            others.judge(FaceDifference::find(model, &others, theirs, &pace).await);
        }
        if let Some(found) = miscount.added_to(others) {
            return Ok(found);
        }
    }
    Err(error)
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
    let written = Written::of(theirs, exact.iter().map(|placed| placed.at.as_vec3()));
    let (half_step, tolerance) = (written.half_step, written.tolerance(size));
    let mut findings = Findings {
        model,
        order,
        theirs: &points,
        exact: &exact,
        distances: &distances,
        size,
        tolerance,
    };
    if let Some(found) = findings.in_one_place() {
        return Ok(found);
    }
    let error = findings.error();
    let limits = (tolerance, written.largest);
    let search = Search::new(model, pose, &points, limits, &distances);
    if order == VertexOrder::File && error <= tolerance {
        let closer = error / MUCH_NEARER;
        let is_closer = |it: &Explanation| closer > SINGLE_PRECISION * size && it.error <= closer;
        let (_, same) = search.singles(pace).await;
        let (explanations, same): (Vec<_>, Vec<_>) = same.into_iter().partition(is_closer);
        if explanations.is_empty() {
            let mut found = findings.diagnosis(Verdict::Right);
            let of_whole = made_alone::as_well(&search, order, pace).await;
            let made = same.iter().chain(&of_whole).flat_map(|it| &it.made);
            let usual = made.filter(|made| search.is_usual(**made));
            found.unseen = usual.map(|made| made.mistake.id).collect();
            return Ok(found);
        }
        findings.tolerance = closer;
        return Ok(findings.explained(&explanations));
    }
    // Numbers that are worked out from a mesh bring many near it. Those that are right bring it much nearer.
    let of_numbers = precision::of_vertices(half_step);
    let rounding = of_numbers.max(AS_GOOD_AS_NONE * size);
    let fits = search.within(rounding.max(error / MUCH_NEARER));
    let (alone, mut explanations) = sought(&search, &fits, &findings, rounding, pace).await;
    // At rest no pose is to be applied: the file's own mesh, unseen from the one that is skinned, is no mistake.
    if pose.is_bind()
        && error <= UNSEEN * size
        && explanations.iter().any(|it| it.ids() == [POSE_NOT_APPLIED])
    {
        return Ok(findings.as_the_file_has_it());
    }
    // That the right mesh has other axes, or is of a pose that lacks a joint, is simpler than two mistakes that come to the
    // same.
    let are_two = explanations.iter().any(|it| it.made.len() > 1);
    if are_two && findings.has_other_axes(written.limits(size)) {
        explanations.clear();
    }
    let not_turned = match explanations.is_empty() {
        true => Vec::new(),
        false => not_turned::find(&search, order, pace).await,
    };
    if are_two && !not_turned.is_empty() {
        let limits = (tolerance, size);
        if let Some(other) = other_pose::find(model, pose, order, &points, limits, pace).await {
            return Ok(findings.of_other_pose(other));
        }
    }
    let mut coarse = None;
    if explanations.is_empty() {
        coarse = Coarse::find(&exact, theirs, &written, size);
        let limit = precision::coarse_limit(half_step, size);
        let may_be_right = coarse.is_some_and(|coarse| coarse.may_be_right);
        if coarse.is_some() && !may_be_right && precision::tells_mistakes(half_step, size) {
            let rounded = search.of_coordinates_within(limit, None);
            (_, explanations) = sought(&rounded, &rounded, &findings, limit, pace).await;
            // As where digits tell more, this is simpler than two mistakes.
            if explanations.iter().all(|it| it.made.len() > 1) {
                let lacking = not_turned::find(&rounded, order, pace).await;
                let least = lacking.iter().min_by(|a, b| a.error.total_cmp(&b.error));
                if let Some(lacking) = least {
                    let other = OtherPose::without(model, pose, lacking, size);
                    return Ok(Diagnosis {
                        coarse,
                        ..findings.of_other_pose(other)
                    });
                }
            }
        }
        if explanations.is_empty() && !may_be_right {
            let cut_off = sought_cut_off(&search, &findings, &written, pace).await;
            if let Some((cut_off, found)) = cut_off {
                (coarse, explanations) = (Some(cut_off), found);
            }
        }
    }
    if explanations.is_empty() {
        let found = otherwise::find(&search, &findings, (alone, coarse), &written, pace).await;
        return Ok(Diagnosis {
            coarse: found.coarse.or(coarse),
            ..found
        });
    }
    Ok(Diagnosis {
        coarse,
        not_turned: findings.names_of(&not_turned, &explanations),
        ..findings.simplest(explanations, pose)
    })
}

/// Single mistakes, and those that alone or by two give the mesh of `search`. Where numbers are worked out from the mesh, it
/// has to agree with it as in `fits`, or within `rounding`.
async fn sought(
    search: &Search<'_>,
    fits: &Search<'_>,
    findings: &Findings<'_>,
    rounding: f64,
    pace: &Pace,
) -> (Vec<Alone>, Vec<Explanation>) {
    let Findings {
        order, exact, size, ..
    } = *findings;
    let (alone, mut explanations) = search.singles(pace).await;
    if explanations.is_empty() && order == VertexOrder::File {
        let exact: Vec<DVec3> = exact.iter().map(|placed| placed.at).collect();
        let meshes = (&*exact, findings.theirs);
        explanations.extend(any_order::of(meshes, findings.tolerance, None));
    }
    if explanations.is_empty() {
        let found = made_alone::find(search, fits, order, exact, size, pace).await;
        explanations.extend(found.into_iter().map(|it| it.of_order(order)));
    } else if order == VertexOrder::File {
        let as_well = made_alone::as_well(search, order, pace).await;
        let is_simple = |it: &Explanation| TOLD_LAST.iter().all(|last| it.ids() != [last.id]);
        explanations.extend(as_well.into_iter().filter(is_simple));
    }
    if explanations.is_empty() {
        explanations = search.pairs(&alone, rounding, pace).await;
    }
    if explanations.is_empty() && order == VertexOrder::File {
        explanations = beside::find(search, size, rounding, pace).await;
    }
    (alone, explanations)
}

/// How the numbers of the mesh are cut off, if it is the exact one then or the one of the mistakes that come with it.
async fn sought_cut_off(
    search: &Search<'_>,
    findings: &Findings<'_>,
    written: &Written,
    pace: &Pace,
) -> Option<(Coarse, Vec<Explanation>)> {
    let Findings {
        exact,
        theirs,
        size,
        ..
    } = *findings;
    let half_step = written.half_step;
    let limit = precision::coarse_limit(half_step, size);
    for cut_off in written.cut_off(theirs.len(), size)? {
        let search = search.of_coordinates_within(limit, Some(cut_off));
        let mut pairs = exact.iter().zip(theirs);
        if pairs.all(|(exact, theirs)| !search.is_off(*exact, *theirs)) {
            return Some((Coarse::of_cut_off(cut_off, size, true), Vec::new()));
        }
        if !precision::tells_mistakes(half_step, size) {
            continue;
        }
        let (_, explanations) = sought(&search, &search, findings, limit, pace).await;
        if !explanations.is_empty() {
            return Some((Coarse::of_cut_off(cut_off, size, false), explanations));
        }
    }
    None
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
