//! Movements, scales, exchanged axes and turns that take every vertex of one mesh to that of
//! another, within a tolerance. Where B is larger, so is the tolerance: the rounding of A grew too.

use super::MeshFinding;
use super::numbers::is_told;
use super::signed_axis::SignedAxis;
use glam::{DQuat, DVec3};
use std::f64::consts::PI;

/// Factors nearer to one than this are rounding.
const LEAST_SCALE: f64 = 1e-6;
/// Turns by less are told as none.
const LEAST_DEGREES: f64 = 5e-5;
/// Every order of the axes, the turned before the mirrored: where a flat mesh admits both, it
/// was turned.
const ORDERS: [[usize; 3]; 6] = [
    [0, 1, 2],
    [0, 2, 1],
    [2, 1, 0],
    [1, 0, 2],
    [1, 2, 0],
    [2, 0, 1],
];
/// More sweeps than any matrix of this size takes.
const MOST_SWEEPS: usize = 32;

/// Vertices of two meshes, and how far apart they still agree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Points<'a> {
    pub(super) a: &'a [DVec3],
    pub(super) b: &'a [DVec3],
    pub(super) tolerance: f64,
    /// How far apart they are at most.
    pub(super) apart: f64,
}

/// A center of A and the point of B that it is taken to.
type Centers = (DVec3, DVec3);

const ORIGINS: Centers = (DVec3::ZERO, DVec3::ZERO);

impl Points<'_> {
    fn means(&self) -> Centers {
        let mean = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len().max(1) as f64;
        (mean(self.a), mean(self.b))
    }

    /// Size of B by the size of A, as their points spread about the centers; one where it is but
    /// for rounding. `None` if that is no size.
    fn size_ratio(&self, (center_a, center_b): Centers) -> Option<f64> {
        let spread = |points: &[DVec3], center: DVec3| -> f64 {
            let squares = points.iter().map(|point| point.distance_squared(center));
            squares.sum()
        };
        let factor = (spread(self.b, center_b) / spread(self.a, center_a)).sqrt();
        if (factor - 1.0).abs() <= LEAST_SCALE {
            return Some(1.0);
        }
        (factor.is_finite() && factor > 0.0).then_some(factor)
    }

    /// Whether `b_from_a`, which scales by `factor`, takes every vertex of A to that of B. Where they agree as they
    /// are, a cause has to leave less than half of the difference, which else is rounding.
    fn agree(&self, factor: f64, b_from_a: impl Fn(DVec3) -> DVec3) -> bool {
        let tolerance = match self.apart <= self.tolerance {
            true => self.apart / 2.0,
            false => self.tolerance * factor.max(1.0),
        };
        let mut pairs = self.a.iter().zip(self.b);
        pairs.all(|(a, b)| b_from_a(*a).distance(*b) <= tolerance)
    }
}

/// The simplest of movements, scales and exchanged axes.
pub(super) fn simplest(points: &Points) -> Option<MeshFinding> {
    offset(points)
        .or_else(|| scale(points))
        .or_else(|| scale_and_move(points))
        .or_else(|| axes(points))
        .or_else(|| scaled_axes(points))
        .or_else(|| scaled_and_moved_axes(points))
}

/// A movement.
fn offset(points: &Points) -> Option<MeshFinding> {
    let (mean_a, mean_b) = points.means();
    let by = mean_b - mean_a;
    let by = by.to_array();
    let agrees = is_told(by) && points.agree(1.0, |point| point + DVec3::from_array(by));
    agrees.then_some(MeshFinding::Offset { by })
}

/// A scale about the origin.
fn scale(points: &Points) -> Option<MeshFinding> {
    scale_about(points, ORIGINS)
}

/// A scale and a movement.
fn scale_and_move(points: &Points) -> Option<MeshFinding> {
    scale_about(points, points.means())
}

/// Axes exchanged or reversed, in the same size about the origin.
fn axes(points: &Points) -> Option<MeshFinding> {
    axes_about(points, ORIGINS, 1.0)
}

/// Axes exchanged or reversed, and a scale about the origin.
fn scaled_axes(points: &Points) -> Option<MeshFinding> {
    axes_about(points, ORIGINS, points.size_ratio(ORIGINS)?)
}

/// Axes exchanged or reversed, a scale and a movement.
fn scaled_and_moved_axes(points: &Points) -> Option<MeshFinding> {
    let means = points.means();
    axes_about(points, means, points.size_ratio(means)?)
}

/// A turn about any axis, with a scale and a movement; of the mirror image only where that of the
/// mesh itself does not do.
pub(super) fn turn(points: &Points) -> Option<MeshFinding> {
    let means = points.means();
    let factor = points.size_ratio(means)?;
    let [turned, of_mirrored] = rotations(points.a, points.b, means)?;
    [(turned, 1.0), (of_mirrored, -1.0)]
        .into_iter()
        .find_map(|(rotation, sign)| {
            let linear = |point: DVec3| rotation * point * (sign * factor);
            let offset = means.1 - linear(means.0);
            let offset = if points.agree(factor, linear) {
                DVec3::ZERO
            } else if points.agree(factor, |point| linear(point) + offset) {
                offset
            } else {
                return None;
            };
            let (mirrored, rotation) = if sign > 0.0 {
                (None, rotation)
            } else {
                let (axis, rotation) = mirrored_along_one_axis(rotation);
                (Some(axis), rotation)
            };
            // The same rotation, by at most half a turn.
            let rotation = if rotation.w < 0.0 {
                -rotation
            } else {
                rotation
            };
            let (axis, angle) = rotation.to_axis_angle();
            Some(MeshFinding::Turned {
                mirrored,
                degrees: angle.to_degrees(),
                axis: axis.to_array(),
                factor,
                offset: offset.to_array(),
            })
        })
        // Of a flat mesh the mirror image does as well as a turn too small to be told.
        .filter(|found| {
            !matches!(found, MeshFinding::Turned { mirrored: None, degrees, .. } if *degrees < LEAST_DEGREES)
        })
}

/// All vertices of B in one place.
pub(super) fn one_place(points: &Points) -> Option<MeshFinding> {
    MeshFinding::one_place(points.b.iter().copied())
}

/// The scale of least squares that takes the first of `centers` to the second.
fn scale_about(points: &Points, (center_a, center_b): Centers) -> Option<MeshFinding> {
    let (mut product, mut square) = (0.0, 0.0);
    for (a, b) in points.a.iter().zip(points.b) {
        let (a, b) = (*a - center_a, *b - center_b);
        product += a.dot(b);
        square += a.dot(a);
    }
    let factor = product / square;
    let usable = factor.is_finite() && factor > 0.0 && (factor - 1.0).abs() > LEAST_SCALE;
    let agrees = usable && points.agree(factor, |point| (point - center_a) * factor + center_b);
    agrees.then(|| MeshFinding::Scaled {
        factor,
        offset: (center_b - center_a * factor).to_array(),
    })
}

/// Axes exchanged or reversed, with a scale that takes the first of `centers` to the second.
fn axes_about(points: &Points, (center_a, center_b): Centers, factor: f64) -> Option<MeshFinding> {
    let all = ORDERS.iter().flat_map(|&order| {
        let axis = move |signs: usize, along: usize| SignedAxis {
            axis: order[along],
            is_reversed: signs >> along & 1 == 1,
        };
        (0..8).map(move |signs| [0, 1, 2].map(|along| axis(signs, along)))
    });
    let [turned, mirrored]: [Vec<_>; 2] = [false, true].map(|mirrored| {
        all.clone()
            .filter(|&axes| is_mirrored(axes) == mirrored)
            .collect()
    });
    let placed = |axes: [SignedAxis; 3], point: DVec3| {
        DVec3::from_array(axes.map(|axis| axis.of(point))) * factor
    };
    let found = turned
        .into_iter()
        .chain(mirrored)
        .find(|&axes| points.agree(factor, |point| placed(axes, point - center_a) + center_b))
        // The axes as they are, about the means: a movement too short to be told.
        .filter(|axes| axes.map(SignedAxis::name) != ["x", "y", "z"]);
    found.map(|from_a| MeshFinding::Axes {
        from_a,
        mirrored: is_mirrored(from_a),
        factor,
        offset: (center_b - placed(from_a, center_a)).to_array(),
    })
}

/// An odd number of exchanges and reversals mirrors.
fn is_mirrored(axes: [SignedAxis; 3]) -> bool {
    let kept = (0..3).filter(|&axis| axes[axis].axis == axis).count();
    let reversed = axes.iter().filter(|axis| axis.is_reversed).count();
    let exchanged = kept == 1;
    exchanged != (reversed % 2 == 1)
}

/// Mirroring through a point and turning by `rotation` as mirroring along one axis and turning as
/// little as that allows.
fn mirrored_along_one_axis(rotation: DQuat) -> (&'static str, DQuat) {
    let along = |axis: DVec3| rotation * DQuat::from_axis_angle(axis, PI);
    let [x, y, z] = DVec3::AXES.map(along);
    let less = |one: (&'static str, DQuat), other: (&'static str, DQuat)| {
        if other.1.w.abs() > one.1.w.abs() {
            other
        } else {
            one
        }
    };
    less(less(("x", x), ("y", y)), ("z", z))
}

/// The rotation that takes `a` nearest to `b`, as seen from their centers; `None` where the points do not
/// spread, or are no numbers.
pub(crate) fn nearest_rotation(a: &[DVec3], b: &[DVec3]) -> Option<DQuat> {
    let points = Points {
        a,
        b,
        tolerance: 0.0,
        apart: 0.0,
    };
    rotations(a, b, points.means()).map(|[turned, _]| turned)
}

/// The rotation that takes `a` nearest to `b`, as seen from their centers, and the one that takes
/// the mirror image of `a` through its center there. `None` where the points do not spread, or
/// are no numbers.
///
/// Horn, Closed-form solution of absolute orientation using unit quaternions, 1987: they are the
/// eigenvectors of the largest and of the smallest eigenvalue of a matrix of products.
fn rotations(a: &[DVec3], b: &[DVec3], (center_a, center_b): Centers) -> Option<[DQuat; 2]> {
    let mut products = [[0.0; 3]; 3];
    let mut largest = 0.0_f64;
    for (a, b) in a.iter().zip(b) {
        let (a, b) = (*a - center_a, *b - center_b);
        for (row, a) in products.iter_mut().zip(a.to_array()) {
            for (sum, b) in row.iter_mut().zip(b.to_array()) {
                *sum += a * b;
                largest = largest.max(sum.abs());
            }
        }
    }
    if !largest.is_finite() || largest == 0.0 {
        return None;
    }
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] =
        products.map(|row| row.map(|sum| sum / largest));
    let (values, vectors) = eigen([
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, yy - xx - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, zz - xx - yy],
    ]);
    let index = |better: fn(f64, f64) -> bool| {
        (1..4).fold(0, |best, i| {
            if better(values[i], values[best]) {
                i
            } else {
                best
            }
        })
    };
    let rotation = |i: usize| {
        let [w, x, y, z] = vectors.map(|row| row[i]);
        DQuat::from_xyzw(x, y, z, w).normalize()
    };
    let found = [index(|a, b| a > b), index(|a, b| a < b)].map(rotation);
    found.iter().all(|q| q.is_finite()).then_some(found)
}

/// Eigenvalues and, as columns, eigenvectors of a symmetric matrix, by Jacobi's rotations.
fn eigen(mut matrix: [[f64; 4]; 4]) -> ([f64; 4], [[f64; 4]; 4]) {
    let mut vectors = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    for _ in 0..MOST_SWEEPS {
        let mut changed = false;
        for p in 0..3 {
            for q in p + 1..4 {
                let off = matrix[p][q];
                let size = matrix[p][p].abs() + matrix[q][q].abs();
                if off == 0.0 || off.abs() < f64::EPSILON * 1e-3 * size {
                    continue;
                }
                changed = true;
                let theta = (matrix[q][q] - matrix[p][p]) / (2.0 * off);
                let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let cosine = 1.0 / tangent.hypot(1.0);
                let sine = tangent * cosine;
                for row in matrix.iter_mut().chain(&mut vectors) {
                    let (left, right) = (row[p], row[q]);
                    row[p] = cosine * left - sine * right;
                    row[q] = sine * left + cosine * right;
                }
                let (upper, lower) = (matrix[p], matrix[q]);
                matrix[p] = std::array::from_fn(|k| cosine * upper[k] - sine * lower[k]);
                matrix[q] = std::array::from_fn(|k| sine * upper[k] + cosine * lower[k]);
                (matrix[p][q], matrix[q][p]) = (0.0, 0.0);
            }
        }
        if !changed {
            break;
        }
    }
    (std::array::from_fn(|i| matrix[i][i]), vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_turn_and_any_turned_mirror_image_is_found_again() {
        let mut random = 1_u32;
        let mut number = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(random) / f64::from(u32::MAX) - 0.5
        };
        let mut vector = || DVec3::new(number(), number(), number());
        let a: Vec<DVec3> = (0..20)
            .map(|_| vector() * DVec3::new(1.0, 0.2, 0.05))
            .collect();
        for i in 0..300 {
            let axis = vector().normalize_or(DVec3::X);
            // Among them none, and half a turn.
            let turn =
                DQuat::from_axis_angle(axis, f64::from(i % 31) / 30.0 * std::f64::consts::PI);
            for (which, sign) in [(0, 1.0), (1, -1.0)] {
                let b: Vec<DVec3> = a.iter().map(|p| turn * *p * sign * 1e20).collect();
                let found = rotations(&a, &b, ORIGINS).unwrap()[which];
                let likeness = found.dot(turn).abs();
                assert!(likeness > 1.0 - 1e-12, "{i}: {found} for {turn}");
            }
        }
    }

    #[test]
    fn what_does_not_spread_or_is_no_number_has_no_turn() {
        let find = |a, b| rotations(&[a, -a], &[b, -b], ORIGINS);
        assert_eq!(find(DVec3::X, DVec3::ZERO), None);
        assert_eq!(find(DVec3::NAN, DVec3::X), None);
        assert_eq!(find(DVec3::X, DVec3::INFINITY), None);
        assert!(find(DVec3::X, DVec3::Y).is_some());
    }
}
