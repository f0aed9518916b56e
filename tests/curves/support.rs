use editor_core::geometry::CurveFrame;
use editor_core::geometry::{Basis, Curve, CurvePoint, Mesh};
use editor_core::io::read_swp;
use editor_core::scene::NewShape;
use editor_core::scene::{CurveSet, CurveShape, EvaluatedGeometry, Evaluator, Scene, ShapeKind};
use glam::Vec3;
use std::collections::{HashMap, HashSet};
use std::path::Path;
use std::sync::Arc;

pub fn flat(points: &[[f32; 2]]) -> Vec<Vec3> {
    points.iter().map(|&[x, y]| Vec3::new(x, y, 0.0)).collect()
}

pub fn spatial(points: &[[f32; 3]]) -> Vec<Vec3> {
    points.iter().copied().map(Vec3::from).collect()
}

pub fn spline(basis: Basis, steps: u32, points: Vec<Vec3>) -> Curve {
    Curve::spline(basis, false, steps, points).unwrap()
}

pub fn read(text: &str) -> Result<CurveSet, String> {
    read_swp(Path::new("a.swp"), text.as_bytes())
        .map(|imported| imported.value)
        .map_err(|error| error.to_string())
}

pub fn evaluate(set: CurveSet, frame_closing: bool) -> Arc<EvaluatedGeometry> {
    let mut shape = CurveShape::new(set);
    shape.set_frame_closing(frame_closing);
    let mut scene = Scene::new();
    scene.add(NewShape::new("Curve", ShapeKind::Curve(shape)));
    Evaluator::new().evaluate(&scene, 0.0).shapes[0]
        .geometry
        .clone()
}

/// Half a circle about the origin from (0, −r) over (r, 0) to (0, r), exact points and normals:
/// the profile of a sphere.
pub fn half_circle(radius: f32, steps: u32) -> Vec<CurvePoint> {
    (0..=steps)
        .map(|step| {
            let angle = std::f64::consts::PI * (f64::from(step) / f64::from(steps) - 0.5);
            let out = Vec3::new(angle.cos() as f32, angle.sin() as f32, 0.0);
            CurvePoint {
                position: out * radius,
                frame: CurveFrame {
                    tangent: Vec3::new(-out.y, out.x, 0.0),
                    normal: -out,
                    binormal: Vec3::Z,
                },
            }
        })
        .collect()
}

/// The volume inside closed triangles, by the tetrahedra from the origin.
pub fn volume(positions: &[Vec3], triangles: &[[u32; 3]]) -> f64 {
    triangles
        .iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|i| positions[i as usize].as_dvec3());
            a.dot(b.cross(c)) / 6.0
        })
        .sum()
}

/// A mesh whose vertices at one place, within `1e-4` of its size, are one vertex.
pub struct Merged {
    pub vertices: usize,
    pub triangles: Vec<[usize; 3]>,
}

impl Merged {
    pub fn new(mesh: &Mesh) -> Self {
        let cell = 1e-4 * mesh.bounds().size().length();
        let mut places: HashMap<[i64; 3], usize> = HashMap::new();
        let mut representative: Vec<Vec3> = Vec::new();
        let merged: Vec<usize> = mesh
            .positions
            .iter()
            .map(|&position| {
                let place = (position / cell).round().to_array().map(|c| c as i64);
                for dx in -1..=1 {
                    for dy in -1..=1 {
                        for dz in -1..=1 {
                            let beside = [place[0] + dx, place[1] + dy, place[2] + dz];
                            if let Some(&known) = places.get(&beside)
                                && representative[known].distance(position) < cell
                            {
                                return known;
                            }
                        }
                    }
                }
                representative.push(position);
                places.insert(place, representative.len() - 1);
                representative.len() - 1
            })
            .collect();
        let triangles = mesh
            .triangles
            .iter()
            .map(|corners| corners.map(|i| merged[i as usize]))
            .filter(|[a, b, c]| a != b && b != c && c != a)
            .collect::<Vec<_>>();
        let used: HashSet<usize> = triangles.iter().flatten().copied().collect();
        Self {
            vertices: used.len(),
            triangles,
        }
    }

    /// How often each directed edge is used.
    pub fn directed_edges(&self) -> HashMap<(usize, usize), usize> {
        let mut edges = HashMap::new();
        for &[a, b, c] in &self.triangles {
            for edge in [(a, b), (b, c), (c, a)] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        edges
    }

    /// Neighbors walk a shared edge in opposite directions: no direction is used twice.
    pub fn winds_consistently(&self) -> bool {
        self.directed_edges().values().all(|&uses| uses == 1)
    }

    /// Every edge has a triangle on either side.
    pub fn is_watertight(&self) -> bool {
        let edges = self.directed_edges();
        edges
            .keys()
            .all(|&(a, b)| edges.get(&(b, a)) == edges.get(&(a, b)))
    }

    /// Vertices − edges + faces: 2 for a sphere, 0 for a torus.
    pub fn euler_characteristic(&self) -> i64 {
        let edges: HashSet<(usize, usize)> = self
            .directed_edges()
            .keys()
            .map(|&(a, b)| (a.min(b), a.max(b)))
            .collect();
        self.vertices as i64 - edges.len() as i64 + self.triangles.len() as i64
    }
}
