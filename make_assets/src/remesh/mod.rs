//! Good triangles of a wanted size on a field's surface: split long edges, collapse short ones,
//! flip to even out the number of neighbors, slide the vertices apart and back onto the surface
//! (Botsch and Kobbelt, "A Remeshing Approach to Multiresolution Modeling", 2004).
//!
//! The mesh is a half, open along x = 0; its vertices with x = 0 stay there, and no edge joins two
//! of them but along the opening, so that the half and its reflection fit together.
mod flips;
mod lengths;

use super::mesh::Mesh;
use glam::DVec3;

const GONE: [u32; 3] = [u32::MAX; 3];

/// What to remesh to.
pub struct Target<'a> {
    pub field: &'a dyn Fn(DVec3) -> f64,
    /// The wanted edge length at a place.
    pub size: &'a dyn Fn(DVec3) -> f64,
    pub rounds: usize,
}

struct Remesher<'a> {
    target: &'a Target<'a>,
    positions: Vec<DVec3>,
    sizes: Vec<f64>,
    triangles: Vec<[u32; 3]>,
    around: Vec<Vec<u32>>,
}

/// Remeshes a half to the target.
pub fn remesh(mesh: &Mesh, target: &Target) -> Mesh {
    let mut around = vec![Vec::new(); mesh.positions.len()];
    for (t, triangle) in mesh.triangles.iter().enumerate() {
        for &v in triangle {
            around[v as usize].push(t as u32);
        }
    }
    let mut work = Remesher {
        target,
        positions: mesh.positions.clone(),
        sizes: mesh.positions.iter().map(|&p| (target.size)(p)).collect(),
        triangles: mesh.triangles.clone(),
        around,
    };
    for _ in 0..target.rounds {
        work.split_long_edges();
        work.collapse_short_edges();
        work.flip_edges();
        work.relax();
    }
    for _ in 0..3 {
        work.relax();
        work.align_edges();
    }
    work.compact()
}

/// The unit outward normal of a field, and its slope.
pub fn gradient(field: &dyn Fn(DVec3) -> f64, p: DVec3) -> DVec3 {
    const E: f64 = 2e-4;
    let corners = [
        DVec3::new(1.0, 1.0, 1.0),
        DVec3::new(1.0, -1.0, -1.0),
        DVec3::new(-1.0, 1.0, -1.0),
        DVec3::new(-1.0, -1.0, 1.0),
    ];
    corners.iter().map(|&c| c * field(p + c * E)).sum::<DVec3>() / (4.0 * E)
}

impl Remesher<'_> {
    fn at(&self, v: u32) -> DVec3 {
        self.positions[v as usize]
    }

    fn on_seam(&self, v: u32) -> bool {
        self.at(v).x == 0.0
    }

    fn wanted(&self, a: u32, b: u32) -> f64 {
        0.5 * (self.sizes[a as usize] + self.sizes[b as usize])
    }

    fn length(&self, a: u32, b: u32) -> f64 {
        self.at(a).distance(self.at(b))
    }

    fn normal(&self, t: [u32; 3]) -> DVec3 {
        let [a, b, c] = t.map(|v| self.at(v));
        (b - a).cross(c - a)
    }

    /// The triangles on both sides of an edge (one at the opening).
    fn sides(&self, a: u32, b: u32) -> Vec<u32> {
        let has_b = |&&t: &&u32| self.triangles[t as usize].contains(&b);
        self.around[a as usize]
            .iter()
            .filter(has_b)
            .copied()
            .collect()
    }

    fn neighbors(&self, v: u32) -> Vec<u32> {
        let mut all: Vec<u32> = self.around[v as usize]
            .iter()
            .flat_map(|&t| self.triangles[t as usize])
            .filter(|&n| n != v)
            .collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn opposite(&self, t: u32, a: u32, b: u32) -> u32 {
        let [x, y, z] = self.triangles[t as usize];
        if x != a && x != b {
            x
        } else if y != a && y != b {
            y
        } else {
            z
        }
    }

    fn replace(&mut self, t: u32, old: u32, new: u32) {
        for v in &mut self.triangles[t as usize] {
            if *v == old {
                *v = new;
            }
        }
    }

    /// 1 for an equilateral triangle, 0 for a degenerate one.
    fn quality(&self, t: [u32; 3]) -> f64 {
        let [a, b, c] = t.map(|v| self.at(v));
        let edges = (b - a).length_squared() + (c - b).length_squared() + (a - c).length_squared();
        2.0 * 3f64.sqrt() * self.normal(t).length() / edges.max(1e-30)
    }

    fn relax(&mut self) {
        for v in 0..self.positions.len() as u32 {
            if self.around[v as usize].is_empty() {
                continue;
            }
            let p = self.at(v);
            let size = self.sizes[v as usize];
            let seam = self.on_seam(v);
            let mut near = self.neighbors(v);
            if seam {
                near.retain(|&n| self.on_seam(n));
            }
            let middle = near.iter().map(|&n| self.at(n)).sum::<DVec3>() / near.len() as f64;
            let normal = gradient(self.target.field, p).normalize_or_zero();
            let slide = middle - p;
            let mut q = p + (slide - normal * normal.dot(slide)) * 0.7;
            for _ in 0..2 {
                let slope = gradient(self.target.field, q);
                let step = slope * (self.target.field)(q) / slope.length_squared().max(0.05);
                q -= step.clamp_length_max(0.5 * size);
            }
            q.x = if seam { 0.0 } else { q.x.max(0.2 * size) };
            self.positions[v as usize] = q;
            self.sizes[v as usize] = (self.target.size)(q);
        }
    }

    fn compact(self) -> Mesh {
        let mut number = vec![u32::MAX; self.positions.len()];
        let mut mesh = Mesh::default();
        for triangle in self.triangles.iter().filter(|t| **t != GONE) {
            let triangle = triangle.map(|v| {
                if number[v as usize] == u32::MAX {
                    number[v as usize] = mesh.positions.len() as u32;
                    mesh.positions.push(self.positions[v as usize]);
                }
                number[v as usize]
            });
            mesh.triangles.push(triangle);
        }
        mesh
    }
}
