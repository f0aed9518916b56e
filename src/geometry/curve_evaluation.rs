//! Evaluation of curves: points with frames, and frames of closed curves.
//!
//! Pieces are evaluated in `f64`, so that tangents stay right where control points almost coincide.

use super::curve::Basis;
use crate::math::Aabb;
use glam::{DVec3, Mat3, Vec3};
use std::f64::consts::TAU;

/// Evaluated point of a curve: V, T, N and B of the assignment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Position, in model space.
    #[doc(alias = "V")]
    pub position: Vec3,
    /// Tangent, normal and binormal there.
    #[doc(alias = "T")]
    #[doc(alias = "N")]
    #[doc(alias = "B")]
    pub frame: CurveFrame,
}

/// Orthonormal, right-handed frame at a point of a curve: `binormal = tangent × normal`. In the
/// curve's model space.
///
/// Frames are carried along a curve so that they turn about the tangent as little as possible,
/// where the Frenet frame would flip at every inflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveFrame {
    /// Direction of the curve.
    pub tangent: Vec3,
    /// Normal; in a flat curve it points to the left of the tangent.
    pub normal: Vec3,
    /// Binormal; +Z in a flat curve.
    pub binormal: Vec3,
}

/// Length of the cross product of two unit vectors below which they count as parallel.
const PARALLEL: f32 = 1e-4;

impl CurveFrame {
    /// First frame of a curve that starts along the unit vector `tangent`: from the binormal +Z, or
    /// +Y where the tangent is parallel to +Z.
    pub fn first(tangent: Vec3) -> Self {
        let seed = if tangent.cross(Vec3::Z).length() > PARALLEL {
            Vec3::Z
        } else {
            Vec3::Y
        };
        let normal = seed.cross(tangent).normalize_or(Vec3::X);
        Self::from_tangent_and_normal(tangent, normal)
    }

    /// Next frame, where the curve runs along the unit vector `tangent`: `N = normalize(B × T)`, `B
    /// = normalize(T × N)` with the previous `B`. Where the new tangent is parallel to that
    /// binormal, the previous normal is made perpendicular to the tangent instead.
    pub fn carried_to(self, tangent: Vec3) -> Self {
        let across = self.binormal.cross(tangent);
        let normal = if across.length() > PARALLEL {
            across.normalize_or(self.normal)
        } else {
            let upright = self.normal - tangent * self.normal.dot(tangent);
            upright.normalize_or(self.normal)
        };
        Self::from_tangent_and_normal(tangent, normal)
    }

    /// This frame rotated by `angle` radians about its tangent, counter-clockwise seen from the
    /// tangent's tip.
    pub fn turned(self, angle: f32) -> Self {
        let (sin, cos) = angle.sin_cos();
        let normal = self.normal * cos + self.binormal * sin;
        Self::from_tangent_and_normal(self.tangent, normal.normalize_or(self.normal))
    }

    /// Angle in radians, −π..π, by which [`CurveFrame::turned`] takes this frame's normal to
    /// `other`'s, as seen along this frame's tangent.
    pub fn angle_to(self, other: Self) -> f32 {
        let (x, y) = (
            other.normal.dot(self.normal),
            other.normal.dot(self.binormal),
        );
        y.atan2(x)
    }

    /// Whether all three vectors are finite, of unit length and at right angles within `tolerance`,
    /// and right-handed.
    pub fn is_orthonormal(self, tolerance: f32) -> bool {
        let axes = Mat3::from_cols(self.tangent, self.normal, self.binormal);
        (axes.transpose() * axes).abs_diff_eq(Mat3::IDENTITY, tolerance) && axes.determinant() > 0.0
    }

    fn from_tangent_and_normal(tangent: Vec3, normal: Vec3) -> Self {
        Self {
            tangent,
            normal,
            binormal: tangent.cross(normal).normalize_or(Vec3::Z),
        }
    }
}

/// Length of a derivative, relative to the size of its piece, below which it has no direction.
const VANISHING: f64 = 1e-10;
/// Cosine of the angle between tangents (about 0.08°) above which the curve is smooth there.
const SMOOTH: f32 = 1.0 - 1e-6;

/// Four Bézier points of one cubic piece.
struct Piece([DVec3; 4]);

/// Point of a piece with the direction of the curve there, where it has one.
struct Sample {
    position: Vec3,
    tangent: Option<Vec3>,
}

/// Points and frames of a chain of cubic pieces, `steps` steps each.
pub(super) fn spline(basis: Basis, control_points: &[Vec3], steps: u32) -> Vec<CurvePoint> {
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
pub(super) fn circle(radius: f32, steps: u32) -> Vec<CurvePoint> {
    (0..=steps)
        .map(|step| {
            let angle = TAU * f64::from(step % steps) / f64::from(steps);
            let (sin, cos) = (angle.sin() as f32, angle.cos() as f32);
            CurvePoint {
                position: Vec3::new(radius * cos, radius * sin, 0.0),
                frame: CurveFrame {
                    tangent: Vec3::new(-sin, cos, 0.0),
                    normal: Vec3::new(-cos, -sin, 0.0),
                    binormal: Vec3::Z,
                },
            }
        })
        .collect()
}

/// Pieces of a curve, as Bézier points.
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

    /// Direction of the first derivative that does not vanish. At the end of a piece the second one
    /// points back to where the curve came from, so its sign changes there.
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

/// Carries a frame along `samples`. A point without a direction takes the one before it; points
/// before the first direction take that one.
fn frames(samples: &[Sample]) -> Vec<CurvePoint> {
    let mut tangent = samples
        .iter()
        .find_map(|sample| sample.tangent)
        .unwrap_or(Vec3::X);
    let mut frame = CurveFrame::first(tangent);
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

/// Distance between the ends, relative to the size of the curve, up to which it is closed.
const MEETING: f32 = 1e-5;
/// Cosine of the angle between the tangents at the ends (about 2.5°) above which a closed curve has
/// no corner there.
const RUNNING_ON: f32 = 0.999;

/// Whether the curve ends where it starts.
pub fn is_closed(points: &[CurvePoint]) -> bool {
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return false;
    };
    let size = Aabb::from_points(points.iter().map(|point| point.position))
        .size()
        .length();
    points.len() > 2 && first.position.distance(last.position) <= MEETING * size
}

/// Closes the frames of a curve that ends where it starts, in the direction that it starts in: the
/// angle between the last frame and the first is distributed along the curve in proportion to arc
/// length, so that a surface swept along it closes without a step. The last point becomes the
/// first. Other curves do not change.
///
/// Returns the angle in radians, −π..π, by which the last frame had to turn; `None` if nothing
/// changed.
pub fn close_frames(points: &mut [CurvePoint]) -> Option<f32> {
    let (&first, &last) = (points.first()?, points.last()?);
    let runs_on = first.frame.tangent.dot(last.frame.tangent) > RUNNING_ON;
    if !runs_on || !is_closed(points) {
        return None;
    }
    let angle = last.frame.angle_to(first.frame);
    let length: f32 = points
        .windows(2)
        .map(|pair| pair[0].position.distance(pair[1].position))
        .sum();
    let mut walked = 0.0;
    let mut before = first.position;
    for point in points.iter_mut() {
        walked += point.position.distance(before);
        before = point.position;
        point.frame = point.frame.turned(angle * walked / length);
    }
    if let Some(last) = points.last_mut() {
        *last = first;
    }
    Some(angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_frame_of_a_flat_curve_has_its_binormal_on_z() {
        let frame = CurveFrame::first(Vec3::Y);
        assert_eq!(frame.normal, -Vec3::X);
        assert_eq!(frame.binormal, Vec3::Z);
    }

    #[test]
    fn a_frame_exists_for_every_direction_even_along_z() {
        for tangent in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::Z] {
            assert!(CurveFrame::first(tangent).is_orthonormal(1e-6));
        }
    }

    #[test]
    fn carrying_onto_the_old_binormal_keeps_the_normal() {
        let frame = CurveFrame::first(Vec3::X);
        let carried = frame.carried_to(frame.binormal);
        assert!(carried.is_orthonormal(1e-6));
        assert_eq!(carried.normal, frame.normal);
    }

    #[test]
    fn turning_by_the_angle_between_two_frames_brings_one_to_the_other() {
        let frame = CurveFrame::first(Vec3::new(0.6, 0.0, 0.8));
        let other = frame.turned(-1.2);
        assert!((frame.angle_to(other) + 1.2).abs() < 1e-6);
        assert!(other.is_orthonormal(1e-6));
    }
}
