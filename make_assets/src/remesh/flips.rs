//! Edges turned to run the other way between the same two triangles.
use super::{GONE, Remesher};

/// Two triangles on both sides of an edge, and the two that the other diagonal would make.
struct Quad {
    at: [u32; 2],
    across: [u32; 2],
    old: [[u32; 3]; 2],
    new: [[u32; 3]; 2],
}

impl Remesher<'_> {
    pub(super) fn flip_edges(&mut self) {
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
    pub(super) fn align_edges(&mut self) {
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
}
