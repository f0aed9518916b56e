//! Rays of the pointer through large meshes.

use crate::report::Report;
use cpu_time::ProcessTime;
use editor_core::geometry::{Mesh, Poles, SharedMesh, TriangleBoxes, sphere};
use editor_core::math::Ray;
use glam::Vec3;
use std::hint::black_box;

const ROUNDS: usize = 5;
/// Rays side by side, and one above the other; the outermost miss the mesh.
const RAYS: i16 = 20;

pub fn run(report: &mut Report) {
    let triangles = 2_000_000;
    report.ratio(
        "A ray through 2,000,000 triangles, against trying each",
        1.0 / 50.0,
        || {
            let pick = Pick::new(triangles);
            least(|| pick.by_boxes(), || pick.by_trying_each())
        },
    );
    report.ratio(
        "Boxes over 2,000,000 triangles that have moved, against a ray that tries each",
        4.0,
        || {
            let pick = Pick::new(triangles);
            least(
                || timed(1, || drop(black_box(pick.boxes_anew()))),
                || pick.by_trying_each(),
            )
        },
    );
    report.ratio(
        "The first ray through 2,000,000 triangles against that through 1,000,000",
        2.1,
        || {
            let first = |triangles| timed(1, || drop(black_box(Pick::new(triangles))));
            let made = |triangles| timed(1, || drop(black_box(mesh(triangles))));
            least(
                || first(triangles) - made(triangles),
                || first(triangles / 2) - made(triangles / 2),
            )
        },
    );
}

/// A mesh with all that rays through it need.
pub struct Pick {
    mesh: SharedMesh,
    boxes: TriangleBoxes,
}

impl Pick {
    /// A sphere of about so many triangles.
    pub fn new(triangles: u32) -> Self {
        let mesh = mesh(triangles);
        let boxes = mesh
            .triangle_order()
            .boxes(&mesh.positions, &mesh.triangles);
        Self { mesh, boxes }
    }

    fn boxes_anew(&self) -> TriangleBoxes {
        let order = self.mesh.triangle_order();
        order.boxes(&self.mesh.positions, &self.mesh.triangles)
    }

    /// Milliseconds a ray.
    pub fn by_boxes(&self) -> f64 {
        let (positions, triangles) = (&self.mesh.positions, &self.mesh.triangles);
        let order = self.mesh.triangle_order();
        let all = rays().len();
        timed(all, || {
            for ray in rays() {
                black_box(order.nearest(&self.boxes, &ray, positions, triangles));
            }
        })
    }

    /// Milliseconds a ray.
    fn by_trying_each(&self) -> f64 {
        let positions = &self.mesh.positions;
        let rays: Vec<Ray> = rays().step_by(40).collect();
        timed(rays.len(), || {
            for ray in &rays {
                let corners = self.mesh.triangles.iter();
                let corners = corners.map(|t| t.map(|corner| positions[corner as usize]));
                let hits = corners.filter_map(|corners| ray.triangle(corners));
                black_box(hits.min_by(|a, b| a.distance.total_cmp(&b.distance)));
            }
        })
    }
}

/// A sphere of about so many triangles.
pub fn mesh(triangles: u32) -> SharedMesh {
    let side = f64::from(triangles / 2).sqrt() as u32;
    let Mesh {
        positions,
        triangles,
        ..
    } = sphere(1.0, side, side, Poles::Y);
    SharedMesh::new(Mesh::new(positions, triangles))
}

fn rays() -> impl ExactSizeIterator<Item = Ray> {
    let all: Vec<Ray> = (0..RAYS)
        .flat_map(|y| (0..RAYS).map(move |x| [x, y]))
        .map(|place| {
            let [x, y] = place.map(|at| (2.0 * f32::from(at) / f32::from(RAYS - 1) - 1.0) * 0.3);
            Ray {
                origin: Vec3::new(0.3, 0.2, 5.0),
                direction: Vec3::new(x, y, -1.0),
            }
        })
        .collect();
    all.into_iter()
}

/// Milliseconds of the processor of each of so many parts of what is done.
fn timed(parts: usize, work: impl FnOnce()) -> f64 {
    let start = ProcessTime::now();
    work();
    start.elapsed().as_secs_f64() * 1e3 / parts as f64
}

fn least(one: impl Fn() -> f64, other: impl Fn() -> f64) -> (f64, f64) {
    let rounds = (0..ROUNDS).map(|_| (one(), other()));
    rounds.fold((f64::INFINITY, f64::INFINITY), |least, round| {
        (least.0.min(round.0), least.1.min(round.1))
    })
}
