//! From control points to points with frames, in f64 so that tangents stay right where control
//! points almost coincide.

use super::curve::{Basis, CurvePoint};
use crate::math::Frame;
use glam::{DVec3, Vec3};
use std::f64::consts::TAU;

/// A derivative shorter than this, measured against the size of its piece, has no direction.
const VANISHING: f64 = 1e-10;
/// Tangents closer than this (cosine, about 0.08°) run on smoothly.
const SMOOTH: f32 = 1.0 - 1e-6;

/// The four Bézier points of one cubic piece.
struct Piece([DVec3; 4]);

/// A point of a piece with the direction of the curve there, where it has one.
struct Sample {
    position: Vec3,
    tangent: Option<Vec3>,
}

/// Points and frames of a chain of cubic pieces, `steps` steps each.
pub fn spline(basis: Basis, control_points: &[Vec3], steps: u32) -> Vec<CurvePoint> {
    let mut samples: Vec<Sample> = Vec::new();
    for piece in pieces(basis, control_points) {
        for step in 0..=steps {
            let sample = piece.sample(f64::from(step) / f64::from(steps));
            let shared = step == 0 && samples.last().is_some_and(|last| last.runs_on(&sample));
            if !shared {
                samples.push(sample);
            }
        }
    }
    frames(&samples)
}

/// Points and frames of a circle about the origin: the last point is the first.
pub fn circle(radius: f32, steps: u32) -> Vec<CurvePoint> {
    (0..=steps)
        .map(|step| {
            let angle = TAU * f64::from(step % steps) / f64::from(steps);
            let (sin, cos) = (angle.sin() as f32, angle.cos() as f32);
            CurvePoint {
                position: Vec3::new(radius * cos, radius * sin, 0.0),
                frame: Frame {
                    tangent: Vec3::new(-sin, cos, 0.0),
                    normal: Vec3::new(-cos, -sin, 0.0),
                    binormal: Vec3::Z,
                },
            }
        })
        .collect()
}

/// The pieces, as Bézier points.
fn pieces(basis: Basis, control_points: &[Vec3]) -> Vec<Piece> {
    let stride = match basis {
        Basis::Bezier => 3,
        Basis::BSpline => 1,
    };
    control_points
        .windows(4)
        .step_by(stride)
        .map(|window| {
            let p = [0, 1, 2, 3].map(|i| window[i].as_dvec3());
            Piece(match basis {
                Basis::Bezier => p,
                Basis::BSpline => [
                    (p[0] + p[1] * 4.0 + p[2]) / 6.0,
                    (p[1] * 4.0 + p[2] * 2.0) / 6.0,
                    (p[1] * 2.0 + p[2] * 4.0) / 6.0,
                    (p[1] + p[2] * 4.0 + p[3]) / 6.0,
                ],
            })
        })
        .collect()
}

impl Piece {
    fn sample(&self, t: f64) -> Sample {
        let [a, b, c, d] = self.0;
        let s = 1.0 - t;
        let position =
            a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t);
        Sample {
            position: position.as_vec3(),
            tangent: self.tangent(t),
        }
    }

    /// The direction of the first derivative that does not vanish. At the end of a piece the
    /// second one points back to where the curve came from, so its sign changes there.
    fn tangent(&self, t: f64) -> Option<Vec3> {
        let [a, b, c, d] = self.0;
        let s = 1.0 - t;
        let (ab, bc, cd) = (b - a, c - b, d - c);
        let first = (ab * s + bc * t) * s + (bc * s + cd * t) * t;
        let second = (bc - ab) * s + (cd - bc) * t;
        let third = cd - bc * 2.0 + ab;
        let toward = if t < 1.0 { second } else { -second };
        let size = ab.length() + bc.length() + cd.length();
        [first, toward, third]
            .into_iter()
            .find(|derivative| derivative.length() > VANISHING * size)
            .and_then(DVec3::try_normalize)
            .map(|direction| direction.as_vec3())
    }
}

impl Sample {
    /// Whether `next`, the first point of the piece after this one's, adds nothing to it.
    fn runs_on(&self, next: &Self) -> bool {
        match (self.tangent, next.tangent) {
            (Some(before), Some(after)) => before.dot(after) > SMOOTH,
            // After a piece without extent the direction only becomes known here.
            (None, Some(_)) => false,
            (_, None) => true,
        }
    }
}

/// Carries a frame along `samples`. A point without a direction has the one before it, points
/// before the first direction have that one.
fn frames(samples: &[Sample]) -> Vec<CurvePoint> {
    let mut tangent = samples
        .iter()
        .find_map(|sample| sample.tangent)
        .unwrap_or(Vec3::X);
    let mut frame = Frame::first(tangent);
    samples
        .iter()
        .map(|sample| {
            tangent = sample.tangent.unwrap_or(tangent);
            frame = frame.carried_to(tangent);
            CurvePoint {
                position: sample.position,
                frame,
            }
        })
        .collect()
}
