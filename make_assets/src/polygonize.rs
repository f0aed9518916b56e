//! A first mesh of a field's surface: marching tetrahedra, which leave no ambiguous case and so
//! always give a manifold. The triangles are poor; `remesh` makes good ones of them.
use super::mesh::Mesh;
use glam::{DVec3, IVec3};
use std::collections::HashMap;

/// The part of space to look at, from x = 0 to the positive side, and how finely.
pub struct Grid {
    pub low: DVec3,
    pub high: DVec3,
    pub step: f64,
}

/// Cells along each edge of the blocks that are skipped as a whole when far from the surface.
const BLOCK: i32 = 8;
/// The corners of a cell are numbered by their bits: x 1, y 2, z 4. Six tetrahedra share its
/// diagonal.
const TETRAHEDRA: [[usize; 4]; 6] = [
    [0, 1, 3, 7],
    [0, 3, 2, 7],
    [0, 2, 6, 7],
    [0, 6, 4, 7],
    [0, 4, 5, 7],
    [0, 5, 1, 7],
];

struct March<'a> {
    grid: &'a Grid,
    field: &'a dyn Fn(DVec3) -> f64,
    mesh: Mesh,
    /// At the grid's points, not a number where not asked for yet.
    values: Vec<f64>,
    points: IVec3,
    cuts: HashMap<(IVec3, IVec3), u32>,
}

/// The surface of `field` for x ≥ 0, open where it meets x = 0 (which is a plane of the grid).
pub fn polygonize(field: &dyn Fn(DVec3) -> f64, grid: &Grid) -> Mesh {
    let cells = ((grid.high - grid.low) / grid.step).ceil().as_ivec3();
    let blocks = (cells + IVec3::splat(BLOCK - 1)) / BLOCK;
    let points = blocks * BLOCK + IVec3::ONE;
    let radius = grid.step * f64::from(BLOCK) * 0.5 * 3f64.sqrt();
    let mut march = March {
        grid,
        field,
        mesh: Mesh::default(),
        values: vec![f64::NAN; (points.x * points.y * points.z) as usize],
        points,
        cuts: HashMap::new(),
    };
    for bz in 0..blocks.z {
        for by in 0..blocks.y {
            for bx in 0..blocks.x {
                let first = IVec3::new(bx, by, bz) * BLOCK;
                let middle =
                    march.position(first) + DVec3::splat(grid.step * f64::from(BLOCK) * 0.5);
                if field(middle).abs() < radius * 1.8 {
                    march.block(first);
                }
            }
        }
    }
    march.mesh
}

impl March<'_> {
    fn position(&self, at: IVec3) -> DVec3 {
        self.grid.low + at.as_dvec3() * self.grid.step
    }

    fn value(&mut self, at: IVec3) -> f64 {
        let index = ((at.z * self.points.y + at.y) * self.points.x + at.x) as usize;
        if self.values[index].is_nan() {
            self.values[index] = (self.field)(self.position(at));
        }
        self.values[index]
    }

    fn block(&mut self, first: IVec3) {
        for z in 0..BLOCK {
            for y in 0..BLOCK {
                for x in 0..BLOCK {
                    self.cell(first + IVec3::new(x, y, z));
                }
            }
        }
    }

    fn cell(&mut self, at: IVec3) {
        let corner =
            |i: usize| at + IVec3::new((i & 1) as i32, (i >> 1 & 1) as i32, (i >> 2) as i32);
        let mut values = [0.0; 8];
        for (i, value) in values.iter_mut().enumerate() {
            *value = self.value(corner(i));
        }
        let inside = values.iter().filter(|&&v| v < 0.0).count();
        if inside == 0 || inside == 8 {
            return;
        }
        for tetrahedron in TETRAHEDRA {
            self.tetrahedron(tetrahedron.map(corner), tetrahedron.map(|i| values[i]));
        }
    }

    fn tetrahedron(&mut self, at: [IVec3; 4], values: [f64; 4]) {
        let (inside, outside): (Vec<usize>, Vec<usize>) = (0..4).partition(|&i| values[i] < 0.0);
        let mut cut = |a: usize, b: usize| self.cut((at[a], values[a]), (at[b], values[b]));
        let polygon: Vec<u32> = match (inside.as_slice(), outside.as_slice()) {
            (&[a], out) => out.iter().map(|&b| cut(a, b)).collect(),
            (within, &[b]) => within.iter().map(|&a| cut(a, b)).collect(),
            (&[a, b], &[c, d]) => vec![cut(a, c), cut(a, d), cut(b, d), cut(b, c)],
            _ => return,
        };
        let p = |i: usize| self.mesh.positions[polygon[i] as usize];
        let mean =
            |of: &[usize]| of.iter().map(|&i| at[i].as_dvec3()).sum::<DVec3>() / of.len() as f64;
        let outward = mean(&outside) - mean(&inside);
        let faces_out = (p(1) - p(0)).cross(p(2) - p(0)).dot(outward) > 0.0;
        for i in 1..polygon.len() - 1 {
            let (b, c) = if faces_out { (i, i + 1) } else { (i + 1, i) };
            self.mesh
                .triangles
                .push([polygon[0], polygon[b], polygon[c]]);
        }
    }

    /// The vertex where the surface crosses the edge between two grid points.
    fn cut(&mut self, a: (IVec3, f64), b: (IVec3, f64)) -> u32 {
        let (a, b) = if a.0.to_array() < b.0.to_array() {
            (a, b)
        } else {
            (b, a)
        };
        if let Some(&vertex) = self.cuts.get(&(a.0, b.0)) {
            return vertex;
        }
        let t = (a.1 / (a.1 - b.1)).clamp(0.08, 0.92);
        let (from, to) = (self.position(a.0), self.position(b.0));
        let vertex = self.mesh.positions.len() as u32;
        self.mesh.positions.push(from.lerp(to, t));
        self.cuts.insert((a.0, b.0), vertex);
        vertex
    }
}
