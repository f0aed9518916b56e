//! Edges brought to length: long ones split, short ones collapsed.
use super::{GONE, Remesher};
use glam::DVec3;

impl Remesher<'_> {
    pub(super) fn split_long_edges(&mut self) {
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

    pub(super) fn collapse_short_edges(&mut self) {
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
}
