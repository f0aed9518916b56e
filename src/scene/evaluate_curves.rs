use super::{CurveItemKind, CurveSet, CurveShape, EvaluatedGeometry};
use crate::geometry::{
    CurvePoint, Mesh, Normals, SharedMesh, close_frames, generalized_cylinder,
    surface_of_revolution, wireframe,
};
use crate::math::Aabb;
use glam::Vec3;
use std::ops::Range;

/// What follows from a set of curves, in model space. The triangles of all its surfaces are the
/// mesh of the [`EvaluatedGeometry`], so that whatever draws, picks or exports meshes has them.
#[derive(Clone, Debug)]
pub struct EvaluatedCurves {
    /// The curves, in the order of the file.
    pub curves: Vec<EvaluatedCurve>,
    /// The surfaces, in the order of the file.
    pub surfaces: Vec<EvaluatedSurface>,
    /// Every edge of every surface once, as indices of vertices of the geometry's mesh: the
    /// wireframe. Its normals are those of the mesh, one a vertex.
    pub edges: Vec<[u32; 2]>,
}

/// One evaluated curve.
#[derive(Clone, Debug)]
pub struct EvaluatedCurve {
    /// Its index in the [`CurveSet`].
    pub item: usize,
    /// Points with tangent, normal and binormal, from start to end; a polyline through the
    /// positions is the curve. Frames of a curve that a surface is swept along are the ones that
    /// the surface has.
    pub points: Vec<CurvePoint>,
    /// The control points; a polyline through them is the control polygon. None for a circle.
    pub control_points: Vec<Vec3>,
    /// The angle in radians by which the frames were closed, for a curve that a surface is swept
    /// along and that closes.
    pub closing_angle: Option<f32>,
}

/// Where one surface is in the geometry's mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EvaluatedSurface {
    /// Its index in the [`CurveSet`].
    pub item: usize,
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its triangles.
    pub triangles: Range<usize>,
}

impl EvaluatedCurve {
    /// The curve as a polyline.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = Vec3> {
        self.points.iter().map(|point| point.position)
    }
}

/// Curves, surfaces and bounds of `shape`.
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
    let sweeps = set.sweeps();
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

/// All surfaces as one mesh, and which part of it each one is.
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
