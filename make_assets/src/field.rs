//! Distance fields: a function of a point, negative inside the body, about the distance to its
//! surface near the surface. Lengths are in the unit of the body that is modeled.
use glam::{DVec2, DVec3};

/// Distance to an axis-aligned ellipsoid, exact to first order at its surface.
pub fn ellipsoid(p: DVec3, center: DVec3, radii: DVec3) -> f64 {
    let q = (p - center) / radii;
    let k0 = q.length();
    let k1 = (q / radii).length();
    if k1 < 1e-9 {
        return -radii.min_element();
    }
    k0 * (k0 - 1.0) / k1
}

/// Distance to a sphere.
pub fn sphere(p: DVec3, center: DVec3, radius: f64) -> f64 {
    (p - center).length() - radius
}

/// Distance to the hull of two spheres: a cone with round ends.
pub fn round_cone(p: DVec3, a: (DVec3, f64), b: (DVec3, f64)) -> f64 {
    let (axis, from_a, slope) = (b.0 - a.0, p - a.0, a.1 - b.1);
    let length_squared = axis.length_squared();
    let rest = length_squared - slope * slope;
    if rest <= 0.0 {
        return sphere(p, a.0, a.1).min(sphere(p, b.0, b.1));
    }
    let along = from_a.dot(axis) / length_squared;
    let across = (from_a - axis * along).length();
    let length = length_squared.sqrt();
    // The foot of the perpendicular on the cone's side lies a little up or down the axis.
    let foot = along * length + across * slope / rest.sqrt();
    let t = (foot / length).clamp(0.0, 1.0);
    (p - a.0 - axis * t).length() - (a.1 - slope * t)
}

/// Distance to a chain of round cones through the given spheres.
pub fn chain(p: DVec3, spheres: &[(DVec3, f64)]) -> f64 {
    spheres
        .windows(2)
        .map(|pair| round_cone(p, pair[0], pair[1]))
        .fold(f64::INFINITY, f64::min)
}

/// Union of two bodies whose seam is filled over a width of about `k`.
pub fn blend(a: f64, b: f64, k: f64) -> f64 {
    let h = (k - (a - b).abs()).max(0.0) / k;
    a.min(b) - h * h * h * k / 6.0
}

/// Intersection of two bodies whose edge is rounded over a width of about `k`.
pub fn clip(a: f64, b: f64, k: f64) -> f64 {
    -blend(-a, -b, k)
}

/// What is left of `a` when `b` is carved out of it, with an edge rounded over about `k`.
pub fn carve(a: f64, b: f64, k: f64) -> f64 {
    clip(a, -b, k)
}

/// 0 below `from`, 1 above `to`, smooth in between.
pub fn smooth_step(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A cross-section of a loft: where along the axis, the center, and how far it reaches from there.
#[derive(Clone, Copy)]
pub struct Section {
    pub at: f64,
    pub center: DVec2,
    /// To either side, along the first cross axis.
    pub side: f64,
    /// Along the positive second cross axis.
    pub front: f64,
    /// Along the negative second cross axis.
    pub back: f64,
}

/// A body given by cross-sections along an axis, as a ship is by its frames.
pub struct Loft {
    sections: Vec<Section>,
    /// 2 for ellipses, more for boxier sections.
    exponent: f64,
    /// How far the rounded ends reach past the first and last section.
    caps: (f64, f64),
}

impl Loft {
    /// `rows` are (along, center across, center forward, side, front, back), in rising order.
    pub fn new(rows: &[[f64; 6]], exponent: f64, caps: (f64, f64)) -> Self {
        let sections = rows
            .iter()
            .map(|r| Section {
                at: r[0],
                center: DVec2::new(r[1], r[2]),
                side: r[3],
                front: r[4],
                back: r[5],
            })
            .collect();
        Self {
            sections,
            exponent,
            caps,
        }
    }

    /// The section at a place along the axis, by a cubic without overshoot.
    pub fn section(&self, at: f64) -> Section {
        let s = &self.sections;
        let last = s.len() - 1;
        let at = at.clamp(s[0].at, s[last].at);
        let i = s.partition_point(|x| x.at <= at).clamp(1, last) - 1;
        let t = (at - s[i].at) / (s[i + 1].at - s[i].at);
        let value = |f: &dyn Fn(&Section) -> f64| {
            let slope = |j: usize| {
                if j == 0 || j == last {
                    return 0.0;
                }
                let before = (f(&s[j]) - f(&s[j - 1])) / (s[j].at - s[j - 1].at);
                let after = (f(&s[j + 1]) - f(&s[j])) / (s[j + 1].at - s[j].at);
                if before * after <= 0.0 {
                    0.0
                } else {
                    2.0 * before * after / (before + after)
                }
            };
            let width = s[i + 1].at - s[i].at;
            let (a, b) = (f(&s[i]), f(&s[i + 1]));
            let (da, db) = (slope(i) * width, slope(i + 1) * width);
            let (t2, t3) = (t * t, t * t * t);
            (2.0 * t3 - 3.0 * t2 + 1.0) * a
                + (t3 - 2.0 * t2 + t) * da
                + (3.0 * t2 - 2.0 * t3) * b
                + (t3 - t2) * db
        };
        Section {
            at,
            center: DVec2::new(value(&|x| x.center.x), value(&|x| x.center.y)),
            side: value(&|x| x.side),
            front: value(&|x| x.front),
            back: value(&|x| x.back),
        }
    }

    /// Distance, about, from a point given by its place along the axis and across it.
    pub fn distance(&self, along: f64, across: DVec2) -> f64 {
        let section = self.section(along);
        let last = self.sections.len() - 1;
        let past = if along < self.sections[0].at {
            (along - self.sections[0].at) / self.caps.0
        } else {
            (along - self.sections[last].at).max(0.0) / self.caps.1
        };
        let cap = if along < section.at {
            self.caps.0
        } else {
            self.caps.1
        };
        let q = across - section.center;
        let depth = if q.y > 0.0 {
            section.front
        } else {
            section.back
        };
        let n = DVec3::new((q.x / section.side).abs(), (q.y / depth).abs(), past.abs());
        let k0 = if self.exponent == 2.0 {
            n.length()
        } else {
            let flat =
                (n.x.powf(self.exponent) + n.y.powf(self.exponent)).powf(1.0 / self.exponent);
            (flat * flat + n.z * n.z).sqrt()
        };
        let k1 = DVec3::new(n.x / section.side, n.y / depth, n.z / cap).length();
        if k1 < 1e-6 {
            return -section.side.min(depth);
        }
        n.length().max(1e-9) * (k0 - 1.0) / k1
    }
}
