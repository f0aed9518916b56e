//! Colors on a grown surface: its triangles are cut along the line where a function changes its
//! sign, so that borders are clean however coarse the mesh is.
use super::super::mesh::Mesh;
use super::model::{Weights, normalized};
use glam::DVec3;
use std::collections::HashMap;

/// Cuts this close to a vertex, as a share of the edge, go through the vertex instead.
const SNAP: f64 = 0.12;

/// A mesh with the weights of its vertices and the material of its triangles.
pub struct Painted {
    pub mesh: Mesh,
    pub weights: Vec<Weights>,
    pub materials: Vec<usize>,
}

impl Painted {
    pub fn new(mesh: Mesh, weights: Vec<Weights>) -> Self {
        let materials = vec![0; mesh.triangles.len()];
        Self {
            mesh,
            weights,
            materials,
        }
    }

    /// Gives `material` to everything where `outside` is negative, cutting what is crossed.
    pub fn paint(&mut self, material: usize, outside: &dyn Fn(DVec3) -> f64) {
        let mut values: Vec<f64> = self.mesh.positions.iter().map(|&p| outside(p)).collect();
        self.snap(&mut values);
        let mut cuts: HashMap<(u32, u32), u32> = HashMap::new();
        let triangles = std::mem::take(&mut self.mesh.triangles);
        let old = std::mem::take(&mut self.materials);
        for (triangle, old) in triangles.into_iter().zip(old) {
            for part in self.split(triangle, &mut values, &mut cuts) {
                let sum: f64 = part.iter().map(|&v| values[v as usize]).sum();
                self.mesh.triangles.push(part);
                self.materials.push(if sum < 0.0 { material } else { old });
            }
        }
    }

    /// Moves the border into vertices that it all but touches.
    fn snap(&self, values: &mut [f64]) {
        let whole = values.to_vec();
        for t in &self.mesh.triangles {
            for i in 0..3 {
                let (a, b) = (t[i] as usize, t[(i + 1) % 3] as usize);
                if whole[a] * whole[b] < 0.0 {
                    let share = whole[a] / (whole[a] - whole[b]);
                    if share < SNAP {
                        values[a] = 0.0;
                    } else if share > 1.0 - SNAP {
                        values[b] = 0.0;
                    }
                }
            }
        }
    }

    /// The triangle, or the two or three parts that the border leaves of it.
    fn split(
        &mut self,
        t: [u32; 3],
        values: &mut Vec<f64>,
        cuts: &mut HashMap<(u32, u32), u32>,
    ) -> Vec<[u32; 3]> {
        let crossed = |i: usize| values[t[i] as usize] * values[t[(i + 1) % 3] as usize] < 0.0;
        let edges: Vec<usize> = (0..3).filter(|&i| crossed(i)).collect();
        match edges[..] {
            [edge] => {
                let [a, b, c] = [0, 1, 2].map(|i| t[(edge + i) % 3]);
                let m = self.cut(a, b, values, cuts);
                vec![[a, m, c], [m, b, c]]
            }
            [first, second] => {
                // The corner that is alone on its side begins one crossed edge and ends another.
                let alone = if (first + 1) % 3 == second {
                    second
                } else {
                    first
                };
                let [a, b, c] = [0, 1, 2].map(|i| t[(alone + i) % 3]);
                let m = self.cut(a, b, values, cuts);
                let n = self.cut(c, a, values, cuts);
                vec![[a, m, n], [m, b, c], [m, c, n]]
            }
            _ => vec![t],
        }
    }

    /// The vertex where the border crosses an edge.
    fn cut(
        &mut self,
        a: u32,
        b: u32,
        values: &mut Vec<f64>,
        cuts: &mut HashMap<(u32, u32), u32>,
    ) -> u32 {
        let (a, b) = (a.min(b), a.max(b));
        if let Some(&known) = cuts.get(&(a, b)) {
            return known;
        }
        let (from, to) = (values[a as usize], values[b as usize]);
        let share = from / (from - to);
        let p = &self.mesh.positions;
        let place = p[a as usize].lerp(p[b as usize], share);
        let mut weights = Weights::new();
        for (v, part) in [(a, 1.0 - share), (b, share)] {
            for &(bone, weight) in &self.weights[v as usize] {
                match weights.iter_mut().find(|known| known.0 == bone) {
                    Some(known) => known.1 += weight * part,
                    None => weights.push((bone, weight * part)),
                }
            }
        }
        weights.sort_unstable_by_key(|weight| weight.0);
        self.mesh.positions.push(place);
        self.weights.push(normalized(weights));
        values.push(0.0);
        let new = self.mesh.positions.len() as u32 - 1;
        cuts.insert((a, b), new);
        new
    }
}
