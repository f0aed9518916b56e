//! Smooth weights: each vertex is first given to one joint, then the borders are softened by heat
//! that flows along the surface (one implicit step), so that nothing bleeds through the air from
//! an arm to the chest or from leg to leg.
use super::mesh::Mirrored;
use super::rig::Joint;
use glam::DVec3;

/// Weights smaller than this are spread over the others.
const SMALLEST: f64 = 0.012;
const SWEEPS: usize = 120;

/// Weights of every vertex for every joint but the root.
///
/// `owner` names the joint of a place, `reach` how far a border there is softened (the length over
/// which a weight falls to a third).
pub fn weights(
    body: &Mirrored,
    joints: &[Joint],
    owner: &dyn Fn(DVec3) -> usize,
    reach: &dyn Fn(DVec3) -> f64,
) -> Vec<Vec<f64>> {
    let flow = Flow::new(body, reach);
    let count = joints.len() - 1;
    let owners: Vec<usize> = body.mesh.positions.iter().map(|&p| owner(p)).collect();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    for (joint, Joint { twin, .. }) in joints.iter().enumerate().skip(1) {
        let column = match columns.get(twin.wrapping_sub(1)) {
            Some(reflected) => body.twin.iter().map(|&v| reflected[v as usize]).collect(),
            None => {
                let mine = |&o: &usize| if o == joint { 1.0 } else { 0.0 };
                flow.spread(&owners.iter().map(mine).collect::<Vec<f64>>())
            }
        };
        columns.push(column);
    }
    let mut rows = Vec::new();
    for (v, &twin) in body.twin.iter().enumerate() {
        let mut row: Vec<f64> = (0..count)
            .map(|c| {
                let other = joints[c + 1].twin - 1;
                let even = 0.5 * (columns[c][v] + columns[other][twin as usize]);
                (even - SMALLEST).max(0.0)
            })
            .collect();
        let sum: f64 = row.iter().sum();
        row.iter_mut().for_each(|w| *w /= sum);
        rows.push(row);
    }
    rows
}

/// Who exchanges how much heat with whom.
struct Flow {
    area: Vec<f64>,
    neighbors: Vec<Vec<(u32, f64)>>,
}

impl Flow {
    fn new(body: &Mirrored, reach: &dyn Fn(DVec3) -> f64) -> Self {
        let mesh = &body.mesh;
        let mut flow = Self {
            area: vec![0.0; mesh.positions.len()],
            neighbors: vec![Vec::new(); mesh.positions.len()],
        };
        for &t in &mesh.triangles {
            let p = mesh.corners(t);
            let area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).length();
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                flow.area[t[i] as usize] += area / 3.0;
                // The cotangent at corner i weighs the edge across from it.
                let (u, v) = (p[j] - p[i], p[k] - p[i]);
                let cotangent = (u.dot(v) / u.cross(v).length()).max(0.02);
                let width = reach((p[j] + p[k]) * 0.5);
                let rate = 0.5 * cotangent * width * width;
                flow.neighbors[t[j] as usize].push((t[k], rate));
                flow.neighbors[t[k] as usize].push((t[j], rate));
            }
        }
        flow
    }

    /// Solves (area + flow) x = area · start by Gauss-Seidel sweeps forth and back.
    fn spread(&self, start: &[f64]) -> Vec<f64> {
        let mut x = start.to_vec();
        let update = |x: &mut Vec<f64>, v: usize| {
            let (mut sum, mut rate) = (self.area[v] * start[v], self.area[v]);
            for &(n, r) in &self.neighbors[v] {
                sum += r * x[n as usize];
                rate += r;
            }
            x[v] = sum / rate;
        };
        for _ in 0..SWEEPS / 2 {
            (0..start.len()).for_each(|v| update(&mut x, v));
            (0..start.len()).rev().for_each(|v| update(&mut x, v));
        }
        x
    }
}
