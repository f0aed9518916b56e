//! Comparing meshes, vertex by vertex in the order of their files.

mod finding;
mod matching;
mod numbers;
mod place;
mod placement;
mod rounding;
mod signed_axis;
mod words;

pub use finding::MeshFinding;
pub use place::{MeshParts, MeshPlace};
pub(crate) use placement::nearest_rotation;
pub use signed_axis::SignedAxis;

use super::rules::Beside::{self, Everything, Only};
use super::rules::{Rule, found_by, with_messages, without_names};
use super::{Allowance, CompareError, Which};
use crate::geometry::Mesh;
use crate::math::Aabb;
use crate::steps::at_once;
use glam::DVec3;
use matching::{Matching, Triangles};
use placement::Points;
use serde::Serialize;

/// Vertices differ if they are farther apart than this share of the reference's size, unless
/// told otherwise.
pub const MESH_TOLERANCE: f64 = 1e-5;
/// Share of the reference's size to within which a mesh is nearly another one that was moved, turned or scaled, such as one
/// that was turned by weights that do not add up to one.
const NEARLY: f64 = 1e-3;
/// How many times as far apart as that the two are where they are farthest, at least: nearer ones are no more like that
/// than like each other.
const MUCH_NEARER: f64 = 30.0;
/// Number of the worst vertices that are listed.
const LISTED: usize = 10;

/// Options of a comparison of meshes, and what still passes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeshOptions<'a> {
    /// Vertices differ if they are farther apart than this, in model space; [`MESH_TOLERANCE`] of
    /// the size if not given.
    pub tolerance: Option<f64>,
    /// How many vertices may differ.
    pub allowed: Allowance,
    /// Parts that tell where vertices differ; sides of the mesh if not given.
    pub parts: Option<&'a MeshParts>,
}

/// Result of a comparison of two meshes. Lengths are in their model space; distances that are
/// not finite are JSON null.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshComparison {
    /// Whether no more vertices differ than are allowed, and the triangles are the same.
    pub passed: bool,
    /// Vertices of each mesh.
    pub vertices: u64,
    /// Triangles of A.
    pub triangles: u64,
    /// Above which distance vertices differ.
    pub tolerance: f64,
    /// How many vertices may differ.
    pub allowed_vertices: u64,
    /// Vertices farther apart than the tolerance.
    pub differing_vertices: u64,
    /// Lower and upper corner of the box around them in A, those left out that are not finite
    /// there; `None` if there are none.
    pub differing_bounds: Option<[[f64; 3]; 2]>,
    /// Size of A: the diagonal of the box around it, but for vertices that are not finite.
    pub size: f64,
    /// Largest distance of two vertices.
    pub max: f64,
    /// The same by the size of A.
    pub max_by_size: f64,
    /// Mean distance.
    pub mean: f64,
    /// Root of the mean squared distance.
    pub rms: f64,
    /// The vertices farthest apart, at most ten, those that do not differ left out.
    pub worst: Vec<WorstVertex>,
    /// Where vertices differ, the place with the farthest first; empty where something that is wrong with
    /// the whole mesh accounts for them.
    pub places: Vec<MeshPlace>,
    /// Whether both have the same triangles, wound alike, in whatever order.
    pub same_triangles: bool,
    /// What is wrong.
    #[serde(serialize_with = "with_messages")]
    pub findings: Vec<MeshFinding>,
    /// Where no cause accounts for what differs: what B is to within a thousandth of the size of A, if it is much farther
    /// apart.
    pub nearly: Option<MeshFinding>,
}

/// A vertex that differs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WorstVertex {
    /// Its index, from 0.
    pub index: u64,
    /// How far apart.
    pub distance: f64,
    /// Where it is in A.
    pub a: [f32; 3],
    /// Where it is in B.
    pub b: [f32; 3],
}

/// Compares `b` with the reference `a`, vertex by vertex.
///
/// # Errors
/// If the numbers of vertices differ, or there are none.
pub fn compare_meshes(
    a: &Mesh,
    b: &Mesh,
    options: &MeshOptions<'_>,
) -> Result<MeshComparison, CompareError> {
    let finite = a.positions.iter().copied().filter(|p| p.is_finite());
    let size = Aabb::from_points(finite).size().as_dvec3().length();
    // Room for rounding even where the tolerance leaves none: for naming a cause.
    let rounding = (MESH_TOLERANCE * size).max(options.tolerance.unwrap_or(0.0));
    let [points_a, points_b] =
        [a, b].map(|mesh| -> Vec<DVec3> { mesh.positions.iter().map(|p| p.as_dvec3()).collect() });
    let count = points_a.len();
    if count != points_b.len() {
        return Err(CompareError::Vertices {
            a: count as u64,
            b: points_b.len() as u64,
            alike: matching::alike(&points_a, &points_b, rounding),
        });
    }
    if count == 0 {
        return Err(CompareError::NoVertices);
    }
    let tolerance = options.tolerance.unwrap_or(MESH_TOLERANCE * size);
    let distances = distances(&points_a, &points_b);
    let differing = distances
        .iter()
        .filter(|d| is_apart(**d, tolerance))
        .count() as u64;
    let allowed_vertices = options.allowed.of(count as u64);
    let matching = if differing > 0 {
        Matching::find(&points_a, &points_b, rounding)
    } else {
        Matching::InOrder
    };
    let triangles = matching::compare_triangles(&a.triangles, &b.triangles, &matching);
    let max = distances.iter().copied().fold(0.0, f64::max);
    let evidence = Evidence {
        points: Points {
            a: &points_a,
            b: &points_b,
            tolerance: rounding,
            apart: max,
        },
        differing,
        moved_in_order: matching.moved(),
        triangles,
    };
    let findings = find(&evidence);
    let is_explained = is_explained(&findings, differing);
    let (places, nearly) = if is_explained {
        (Vec::new(), None)
    } else {
        let places = place::places(&points_a, &distances, tolerance, options.parts);
        (places, nearly(evidence, NEARLY * size))
    };
    Ok(MeshComparison {
        passed: differing <= allowed_vertices && triangles.are_same(),
        vertices: count as u64,
        triangles: a.triangles.len() as u64,
        tolerance,
        allowed_vertices,
        differing_vertices: differing,
        differing_bounds: differing_bounds(&points_a, &distances, tolerance),
        size,
        max,
        max_by_size: if max > 0.0 { max / size } else { 0.0 },
        mean: distances.iter().sum::<f64>() / count as f64,
        rms: (distances.iter().map(|d| d * d).sum::<f64>() / count as f64).sqrt(),
        worst: worst(a, b, &distances, tolerance),
        places,
        same_triangles: triangles.are_same(),
        findings,
        nearly,
    })
}

/// What is wrong by the rules.
fn find(evidence: &Evidence) -> Vec<MeshFinding> {
    let found = at_once(|_| found_by(&Evidence::RULES, async |_, applies| applies(evidence)));
    without_names(found)
}

/// What moved, turned or scaled A to where B is to within `tolerance`, if they are much farther apart.
fn nearly(evidence: Evidence, tolerance: f64) -> Option<MeshFinding> {
    if evidence.points.apart.is_nan() || evidence.points.apart < MUCH_NEARER * tolerance {
        return None;
    }
    let points = Points {
        tolerance,
        ..evidence.points
    };
    let found = find(&Evidence { points, ..evidence });
    found.into_iter().find(MeshFinding::is_placement)
}

/// What moves, scales or exchanges the axes of all of `a` so that each is where `b` has it, within `tolerance`, which grows
/// with a scale; `None` for other numbers of points.
pub(crate) fn placement(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Option<MeshFinding> {
    let apart = distances(a, b).into_iter().fold(0.0, f64::max);
    let points = Points {
        a,
        b,
        tolerance,
        apart,
    };
    (a.len() == b.len() && apart.is_finite()).then(|| placement::simplest(&points))?
}

/// For each of `b` the index of the one of `a` that it is, within `tolerance`, if they are the same
/// points in another order. `None` for other numbers of points.
pub fn permutation(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Option<Vec<u32>> {
    match (a.len() == b.len()).then(|| Matching::find(a, b, tolerance))? {
        Matching::Permuted { from_a, .. } => Some(from_a),
        Matching::InOrder => None,
    }
}

/// What the rules need to know of two meshes.
struct Evidence<'a> {
    points: Points<'a>,
    /// Number of vertices that differ.
    differing: u64,
    /// Number of vertices that have another index.
    moved_in_order: u64,
    triangles: Triangles,
}

/// What gives the finding of a rule.
type Applies<E> = fn(&E) -> Option<MeshFinding>;

impl Evidence<'_> {
    /// Every cause: first what keeps vertices from being compared, then the simplest movement
    /// that explains all of them, then their order, then the triangles.
    const RULES: [Rule<Applies<Self>>; 9] = [
        rule("not_finite_in_a", Everything, |e| {
            not_finite(Which::A, e.points.a)
        }),
        rule("not_finite_in_b", Everything, |e| {
            not_finite(Which::B, e.points.b)
        }),
        rule("placement", NOT_FINITE, |e| {
            e.placed(placement::simplest)
                .or_else(|| e.placed(placement::turn))
        }),
        rule("rounded", NOT_FINITE, |e| e.placed(rounding::rounded)),
        rule("one_place", NOT_FINITE, |e| e.placed(placement::one_place)),
        rule("permuted", Everything, |e| {
            let vertices = e.moved_in_order;
            (vertices > 0).then_some(MeshFinding::Permuted { vertices })
        }),
        rule("winding", Everything, |e| {
            let Triangles {
                reversed,
                only_b,
                in_b,
                ..
            } = e.triangles;
            // Of other faces a few have the same corners by chance.
            let is_told = reversed > 0 && 2 * only_b <= in_b;
            is_told.then_some(MeshFinding::Winding { reversed, of: in_b })
        }),
        rule("triangles", Everything, |e| {
            let Triangles { only_a, only_b, .. } = e.triangles;
            (only_a + only_b > 0).then_some(MeshFinding::Triangles { only_a, only_b })
        }),
        rule("triangle_order", Everything, |e| {
            let reordered = e.triangles.are_same() && !e.triangles.in_order;
            reordered.then_some(MeshFinding::TriangleOrder)
        }),
    ];

    /// A placement of B, if vertices differ at all.
    fn placed(&self, find: fn(&Points) -> Option<MeshFinding>) -> Option<MeshFinding> {
        if self.differing > 0 {
            find(&self.points)
        } else {
            None
        }
    }
}

/// Vertices without a place leave it open where the others are.
const NOT_FINITE: Beside = Only(&["not_finite_in_a", "not_finite_in_b"]);

const fn rule<'a>(
    name: &'static str,
    beside: Beside,
    applies: Applies<Evidence<'a>>,
) -> Rule<Applies<Evidence<'a>>> {
    Rule {
        name,
        beside,
        applies,
    }
}

fn not_finite(mesh: Which, points: &[DVec3]) -> Option<MeshFinding> {
    let vertices = points.iter().filter(|point| !point.is_finite()).count() as u64;
    (vertices > 0).then_some(MeshFinding::NotFinite { mesh, vertices })
}

/// Distance of each vertex of `a` from that of `b`; infinite where either is not finite.
fn distances(a: &[DVec3], b: &[DVec3]) -> Vec<f64> {
    let finite = |distance: f64| {
        if distance.is_finite() {
            distance
        } else {
            f64::INFINITY
        }
    };
    a.iter()
        .zip(b)
        .map(|(a, b)| finite(a.distance(*b)))
        .collect()
}

fn is_apart(distance: f64, tolerance: f64) -> bool {
    distance > tolerance
}

/// Whether a cause accounts for all of the `differing` vertices.
fn is_explained(findings: &[MeshFinding], differing: u64) -> bool {
    findings.iter().any(|found| found.explains(differing))
}

fn differing_bounds(a: &[DVec3], distances: &[f64], tolerance: f64) -> Option<[[f64; 3]; 2]> {
    let points = a.iter().zip(distances);
    let differing =
        points.filter(|(point, distance)| is_apart(**distance, tolerance) && point.is_finite());
    let corners = differing.map(|(point, _)| (*point, *point));
    let (low, high) = corners.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    Some([low.to_array(), high.to_array()])
}

fn worst(a: &Mesh, b: &Mesh, distances: &[f64], tolerance: f64) -> Vec<WorstVertex> {
    let mut order: Vec<usize> = (0..distances.len())
        .filter(|&index| is_apart(distances[index], tolerance))
        .collect();
    order.sort_by(|&i, &j| distances[j].total_cmp(&distances[i]));
    let listed = order.into_iter().take(LISTED);
    listed
        .map(|index| WorstVertex {
            index: index as u64,
            distance: distances[index],
            a: a.positions[index].to_array(),
            b: b.positions[index].to_array(),
        })
        .collect()
}

impl MeshComparison {
    /// Whether vertices differ and no cause accounts for all of them.
    pub fn is_unexplained(&self) -> bool {
        let differing = self.differing_vertices;
        differing > 0 && !is_explained(&self.findings, differing)
    }
}
