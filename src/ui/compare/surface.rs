//! Points of surfaces, by which it is known where other cameras show them. Hundreds of cameras are tried, for each of which all
//! triangles would have to be filled otherwise.

use super::cells::{Cells, Grid};
use crate::editor::Session;
use crate::scene::{Camera, EvaluatedShape};
use glam::{IVec3, Vec2, Vec3};
use std::collections::HashSet;

/// How far apart points are, in cells at the middle of the scene: the least at which they are not too many. Farther apart they
/// would leave holes.
const APART: [f32; 3] = [1.0, 1.5, 2.0];
/// Most points.
const POINTS: usize = 20_000;
/// Most points along a triangle.
const MOST_STEPS: usize = 500;

/// Points of all visible surfaces, near enough to one another to be in every cell that these cover, or beside it.
pub(super) struct Surface {
    grid: Grid,
    /// In the world.
    points: Vec<Vec3>,
}

impl Surface {
    /// `None` if nothing is before the camera, or so much that points would be far apart.
    pub fn new(session: &Session, grid: Grid) -> Option<Self> {
        let camera = &session.view().camera;
        let shapes = session.evaluated().shapes.iter();
        let shapes: Vec<&EvaluatedShape> = shapes.filter(|shape| shape.visible).collect();
        let bounds = session.evaluated().world_bounds();
        let middle = 0.5 * (bounds.min + bounds.max);
        let cell = grid.step as f32 * camera.world_per_pixel(middle, grid.size.y)?;
        APART.into_iter().find_map(|cells| {
            let mut points = Points::new(cells * cell);
            let are_all = shapes.iter().all(|shape| points.add(shape));
            let points = points.kept;
            are_all.then_some(Self { grid, points })
        })
    }

    /// The middle of the points, in the world; `None` without any.
    pub fn middle(&self) -> Option<Vec3> {
        let sum: Vec3 = self.points.iter().sum();
        (!self.points.is_empty()).then(|| sum / self.points.len() as f32)
    }

    /// The cells that the surfaces are in as a camera sees them.
    pub fn covered(&self, camera: &Camera) -> Cells {
        let Grid { size, apart, .. } = self.grid;
        let clip_from_world = camera.clip_from_world(size.x / size.y);
        let mut covered = Cells::none(self.grid);
        for point in &self.points {
            let clip = clip_from_world * point.extend(1.0);
            if clip.w <= 0.0 {
                continue;
            }
            let ndc = clip.truncate() / clip.w;
            // Pixels that are known stand for those around them.
            let pixel = Vec2::new(ndc.x + 1.0, 1.0 - ndc.y) * 0.5 * size + 0.5 * apart as f32;
            if pixel.cmpge(Vec2::ZERO).all() && pixel.cmplt(size).all() {
                covered.insert(self.grid.cell(pixel.as_uvec2().to_array()));
            }
        }
        covered
    }
}

/// Points of triangles in the world, one of those that are so near to one another.
struct Points {
    apart: f32,
    kept: Vec<Vec3>,
    known: HashSet<IVec3>,
}

impl Points {
    fn new(apart: f32) -> Self {
        Self {
            apart,
            kept: Vec::new(),
            known: HashSet::new(),
        }
    }

    /// Adds those of a shape; whether they are not too many.
    fn add(&mut self, shape: &EvaluatedShape) -> bool {
        let positions = shape.geometry.positions().iter();
        let positions: Vec<Vec3> = positions
            .map(|position| shape.world_from_model.transform_point3(*position))
            .collect();
        for corners in &shape.geometry.mesh.triangles {
            let [a, b, c] = corners.map(|corner| positions[corner as usize]);
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            let steps = (longest / self.apart).ceil();
            // What is nowhere is not seen.
            if !steps.is_finite() {
                continue;
            }
            let steps = steps.max(1.0) as usize;
            if steps > MOST_STEPS {
                return false;
            }
            for along_b in 0..=steps {
                for along_c in 0..=steps - along_b {
                    let [to_b, to_c] = [along_b, along_c].map(|along| along as f32 / steps as f32);
                    let point = a + to_b * (b - a) + to_c * (c - a);
                    if self.known.insert((point / self.apart).round().as_ivec3()) {
                        self.kept.push(point);
                    }
                }
            }
            if self.kept.len() > POINTS {
                return false;
            }
        }
        true
    }
}
