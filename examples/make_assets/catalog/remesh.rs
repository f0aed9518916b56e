//! Good triangles of a wanted size on a field's surface: split long edges, collapse short ones,
//! flip to even out the number of neighbors, slide the vertices apart and back onto the surface
//! (Botsch and Kobbelt, "A Remeshing Approach to Multiresolution Modeling", 2004).
//!
//! The mesh is a half, open along x = 0; its vertices with x = 0 stay there, and no edge joins two
//! of them but along the opening, so that the half and its reflection fit together.
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

/// Two triangles on both sides of an edge, and the two that the other diagonal would make.
struct Quad {
    at: [u32; 2],
    across: [u32; 2],
    old: [[u32; 3]; 2],
    new: [[u32; 3]; 2],
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

    fn split_long_edges(&mut self) {
        let mut t = 0;
        while t < self.triangles.len() {
            let [a, b, c] = self.triangles[t];
            if a != u32::MAX {
                let excess = |x: u32, y: u32| self.length(x, y) / self.wanted(x, y);
                let mut edges = [(a, b), (b, c), (c, a)].map(|(x, y)| (excess(x, y), x, y));
                edges.sort_by(|x, y| y.0.total_cmp(&x.0));
                if edges[0].0 > 4.0 / 3.0 {
                    self.split(edges[0].1, edges[0].2);
                    continue;
                }
            }
            t += 1;
        }
    }

    fn split(&mut self, a: u32, b: u32) {
        let middle = self.positions.len() as u32;
        let position = (self.at(a) + self.at(b)) * 0.5;
        self.positions.push(position);
        self.sizes.push((self.target.size)(position));
        self.around.push(Vec::new());
        for t in self.sides(a, b) {
            let other = self.opposite(t, a, b);
            let new = self.triangles.len() as u32;
            let copy = self.triangles[t as usize].map(|v| if v == a { middle } else { v });
            self.triangles.push(copy);
            self.replace(t, b, middle);
            self.around[b as usize].retain(|&x| x != t);
            self.around[b as usize].push(new);
            self.around[other as usize].push(new);
            self.around[middle as usize].extend([t, new]);
        }
    }

    fn collapse_short_edges(&mut self) {
        for a in 0..self.positions.len() as u32 {
            if self.around[a as usize].is_empty() {
                continue;
            }
            let mut near: Vec<(f64, u32)> = self
                .neighbors(a)
                .into_iter()
                .map(|b| (self.length(a, b) / self.wanted(a, b), b))
                .filter(|x| x.0 < 0.8)
                .collect();
            near.sort_by(|x, y| x.0.total_cmp(&y.0));
            for (_, b) in near {
                if self.collapse(a, b) {
                    break;
                }
            }
        }
    }

    /// Moves `b` and `a` together, keeping `b`; says whether that could be done without harm.
    fn collapse(&mut self, a: u32, b: u32) -> bool {
        let (a_seam, b_seam) = (self.on_seam(a), self.on_seam(b));
        let sides = self.sides(a, b);
        let on_opening = sides.len() == 1;
        if a_seam && !(b_seam && on_opening) {
            return false;
        }
        let (near_a, near_b) = (self.neighbors(a), self.neighbors(b));
        let shared = near_a.iter().filter(|n| near_b.contains(n)).count();
        if shared != sides.len() {
            return false;
        }
        if b_seam && !on_opening {
            let joined = |&n: &u32| n == b || !self.on_seam(n) || self.sides(b, n).len() == 1;
            if !near_a.iter().all(joined) {
                return false;
            }
        }
        let to = if b_seam && !a_seam {
            self.at(b)
        } else {
            (self.at(a) + self.at(b)) * 0.5
        };
        let size = (self.target.size)(to);
        let far = |&n: &u32| n != a && n != b && self.at(n).distance(to) > 1.4 * size;
        if near_a.iter().chain(&near_b).any(far) {
            return false;
        }
        if !self.stays_upright(a, b, to, &sides) || !self.stays_upright(b, a, to, &sides) {
            return false;
        }
        for &t in &sides {
            for v in self.triangles[t as usize] {
                self.around[v as usize].retain(|&x| x != t);
            }
            self.triangles[t as usize] = GONE;
        }
        for t in std::mem::take(&mut self.around[a as usize]) {
            self.replace(t, a, b);
            self.around[b as usize].push(t);
        }
        self.positions[b as usize] = to;
        self.sizes[b as usize] = size;
        true
    }

    /// Whether the triangles round `v` keep their side and a fair shape when it moves.
    fn stays_upright(&self, v: u32, other: u32, to: DVec3, gone: &[u32]) -> bool {
        self.around[v as usize]
            .iter()
            .filter(|t| !gone.contains(t))
            .all(|&t| {
                let triangle = self.triangles[t as usize];
                let before = self.normal(triangle);
                let [p, q, r] =
                    triangle.map(|x| if x == v || x == other { to } else { self.at(x) });
                let after = (q - p).cross(r - p);
                let longest = (q - p)
                    .length_squared()
                    .max((r - q).length_squared())
                    .max((p - r).length_squared());
                before.dot(after) > 0.5 * before.length() * after.length()
                    && after.length() > 0.15 * longest
            })
    }

    fn flip_edges(&mut self) {
        for t in 0..self.triangles.len() {
            for side in 0..3 {
                let triangle = self.triangles[t];
                if triangle == GONE {
                    break;
                }
                self.flip(triangle[side], triangle[(side + 1) % 3]);
            }
        }
    }

    /// Replaces the edge ab by the one across it, if that evens out the valences.
    fn flip(&mut self, a: u32, b: u32) {
        let Some(quad) = self.quad(a, b) else { return };
        let [c, d] = quad.across;
        let excess = |v: u32| {
            let count = self.around[v as usize].len() as i32;
            if self.on_seam(v) {
                2 * count - 6
            } else {
                count - 6
            }
        };
        let step = |v: u32| if self.on_seam(v) { 2 } else { 1 };
        let cost = |v: u32, by: i32| (excess(v) + by * step(v)).pow(2);
        let before = cost(a, 0) + cost(b, 0) + cost(c, 0) + cost(d, 0);
        let after = cost(a, -1) + cost(b, -1) + cost(c, 1) + cost(d, 1);
        let worst = |[x, y]: [[u32; 3]; 2]| self.quality(x).min(self.quality(y));
        let (old, new) = (worst(quad.old), worst(quad.new));
        let rescue = old < 0.3 && new > 1.3 * old;
        let evens = after < before && new > 0.6 * old.min(0.6);
        let [flat_old, flat_new] = [quad.old, quad.new].map(|pair| self.flatness(pair));
        if (rescue || evens) && flat_new > flat_old - 0.15 {
            self.turn(a, b, &quad);
        }
    }

    /// Turns edges that cut across a crease of the field to run along it.
    fn align_edges(&mut self) {
        for t in 0..self.triangles.len() {
            for side in 0..3 {
                let triangle = self.triangles[t];
                if triangle == GONE {
                    break;
                }
                let (a, b) = (triangle[side], triangle[(side + 1) % 3]);
                let Some(quad) = self.quad(a, b) else {
                    continue;
                };
                let off =
                    |x: u32, y: u32| (self.target.field)((self.at(x) + self.at(y)) * 0.5).abs();
                let (old, new) = (off(a, b), off(quad.across[0], quad.across[1]));
                let fair = self.quality(quad.new[0]).min(self.quality(quad.new[1])) > 0.4;
                if fair && old > 0.03 * self.wanted(a, b) && new < 0.6 * old {
                    self.turn(a, b, &quad);
                }
            }
        }
    }

    /// What an edge's two triangles would become if it ran the other way; none where it must not.
    fn quad(&self, a: u32, b: u32) -> Option<Quad> {
        let [s, t] = self.sides(a, b)[..] else {
            return None;
        };
        let (c, d) = (self.opposite(s, a, b), self.opposite(t, a, b));
        if c == d || (self.on_seam(c) && self.on_seam(d)) || !self.sides(c, d).is_empty() {
            return None;
        }
        let swap = |t: [u32; 3], old: u32, new: u32| t.map(|v| if v == old { new } else { v });
        let old = [self.triangles[s as usize], self.triangles[t as usize]];
        let new = [swap(old[0], b, d), swap(old[1], a, c)];
        let unit = |x: [u32; 3]| self.normal(x).normalize_or_zero();
        let mean = unit(old[0]) + unit(old[1]);
        let upright = new.iter().all(|&x| unit(x).dot(mean) > 0.6);
        upright.then_some(Quad {
            at: [s, t],
            across: [c, d],
            old,
            new,
        })
    }

    fn turn(&mut self, a: u32, b: u32, quad: &Quad) {
        let ([s, t], [c, d]) = (quad.at, quad.across);
        self.triangles[s as usize] = quad.new[0];
        self.triangles[t as usize] = quad.new[1];
        self.around[a as usize].retain(|&x| x != t);
        self.around[b as usize].retain(|&x| x != s);
        self.around[c as usize].push(t);
        self.around[d as usize].push(s);
    }

    /// 1 for two triangles in a plane, less the more they are folded.
    fn flatness(&self, [x, y]: [[u32; 3]; 2]) -> f64 {
        let unit = |t: [u32; 3]| self.normal(t).normalize_or_zero();
        unit(x).dot(unit(y))
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
