use super::{CurveItemKind, CurveSet, CurveShape, EvaluatedGeometry};
use crate::geometry::{
    CurvePoint, Mesh, Normals, SharedMesh, close_frames, generalized_cylinder,
    surface_of_revolution, wireframe,
};
use crate::math::Aabb;
use glam::Vec3;
use std::collections::HashSet;
use std::ops::Range;

/// Evaluated curves and surfaces, in model space. The triangles of all surfaces are the mesh of the
/// [`EvaluatedGeometry`], so that whatever draws, picks or exports meshes includes them.
#[derive(Clone, Debug)]
pub struct EvaluatedCurves {
    /// Curves, in the order of the file.
    pub curves: Vec<EvaluatedCurve>,
    /// Surfaces, in the order of the file.
    pub surfaces: Vec<EvaluatedSurface>,
    /// Wireframe: every edge of every surface once, as indices of vertices of the geometry's mesh.
    /// Its normals are those of the mesh, one per vertex.
    pub edges: Vec<[u32; 2]>,
}

/// Evaluated curve.
#[derive(Clone, Debug)]
pub struct EvaluatedCurve {
    /// Index in the [`CurveSet`].
    pub item: usize,
    /// Points with tangent, normal and binormal, from start to end; a polyline through the
    /// positions is the curve. Frames of a curve that a surface is swept along are the ones that
    /// the surface has.
    pub points: Vec<CurvePoint>,
    /// Control points; a polyline through them is the control polygon. Empty for a circle.
    pub control_points: Vec<Vec3>,
    /// Angle in radians by which the frames were closed, for a closed curve that a surface is swept
    /// along.
    pub closing_angle: Option<f32>,
}

/// Part of the geometry's mesh that is one surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EvaluatedSurface {
    /// Index in the [`CurveSet`].
    pub item: usize,
    /// Range of its vertices.
    pub vertices: Range<usize>,
    /// Range of its triangles.
    pub triangles: Range<usize>,
}

impl EvaluatedCurve {
    /// Positions of the points: the curve as a polyline.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = Vec3> {
        self.points.iter().map(|point| point.position)
    }
}

/// Evaluates the curves, surfaces and bounds of `shape`.
pub(super) fn evaluate_curves(shape: &CurveShape) -> EvaluatedGeometry {
    let set = shape.curves();
    let curves = curves(set, shape.frame_closing());
    let (mesh, surfaces) = surfaces(set, &curves);
    let on_curves = curves.iter().flat_map(EvaluatedCurve::positions);
    let bounds = Aabb::from_points(on_curves).union(mesh.bounds());
    EvaluatedGeometry {
        curves: Some(EvaluatedCurves {
            edges: wireframe(&mesh.triangles),
            curves,
            surfaces,
        }),
        ..EvaluatedGeometry::rigid(SharedMesh::new(mesh), bounds, shape.revision())
    }
}

fn curves(set: &CurveSet, frame_closing: bool) -> Vec<EvaluatedCurve> {
    let sweeps: HashSet<usize> = set.sweeps().collect();
    let evaluated = |(item, curve): (usize, &crate::geometry::Curve)| {
        let mut points = curve.evaluate();
        let closing_angle = if frame_closing && sweeps.contains(&item) {
            close_frames(&mut points)
        } else {
            None
        };
        EvaluatedCurve {
            item,
            points,
            control_points: curve.control_points().to_vec(),
            closing_angle,
        }
    };
    let items = set.items().iter().enumerate();
    items
        .filter_map(|(index, item)| Some((index, item.curve()?)))
        .map(evaluated)
        .collect()
}

/// All surfaces as one mesh, and the part of it that each one is.
fn surfaces(set: &CurveSet, curves: &[EvaluatedCurve]) -> (Mesh, Vec<EvaluatedSurface>) {
    let points = |item: usize| {
        curves
            .binary_search_by_key(&item, |curve| curve.item)
            .map_or(&[] as &[CurvePoint], |index| &curves[index].points)
    };
    let mut whole = Mesh::default();
    let mut normals = Vec::new();
    let mut surfaces = Vec::new();
    for (item, kind) in set.items().iter().map(|item| &item.kind).enumerate() {
        let mesh = match *kind {
            CurveItemKind::Curve(_) => continue,
            CurveItemKind::Revolution { steps, profile } => {
                surface_of_revolution(points(profile), steps)
            }
            CurveItemKind::Sweep { profile, sweep } => {
                generalized_cylinder(points(profile), points(sweep))
            }
        };
        let (first, start) = (whole.positions.len(), whole.triangles.len());
        whole.positions.extend(mesh.positions);
        let shifted = |corner: u32| corner + first as u32;
        let triangles = mesh.triangles.into_iter().map(|t| t.map(shifted));
        whole.triangles.extend(triangles);
        if let Normals::PerVertex(own) = mesh.normals {
            normals.extend(own);
        }
        surfaces.push(EvaluatedSurface {
            item,
            vertices: first..whole.positions.len(),
            triangles: start..whole.triangles.len(),
        });
    }
    (whole.with_normals(normals), surfaces)
}
