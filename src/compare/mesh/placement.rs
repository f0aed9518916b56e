use super::MeshFinding;
use super::rotation::rotations;
use glam::{DQuat, DVec3};
use std::f64::consts::PI;

/// Factors nearer to one than this are rounding.
const LEAST_SCALE: f64 = 1e-6;
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
const AXIS_NAMES: [[&str; 2]; 3] = [["x", "-x"], ["y", "-y"], ["z", "-z"]];

/// What takes every vertex of `a` to that of `b` within `tolerance`: a movement, a scale about
/// the origin, a scale and a movement, other axes, or any turn, these two with a scale and a
/// movement or without. Or else that `b` lies all in one place. Where `b` is larger, so is the tolerance: the rounding of `a` grew too.
pub(super) fn find(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Option<MeshFinding> {
    let (mean_a, mean_b) = (mean(a), mean(b));
    let origin = DVec3::ZERO;
    let scaled_axes = |center_a, center_b| {
        let factor = size_by_size(a, b, center_a, center_b)?;
        axes(a, b, (center_a, center_b), factor, tolerance)
    };
    offset(a, b, tolerance)
        .or_else(|| scale(a, b, origin, origin, tolerance))
        .or_else(|| scale(a, b, mean_a, mean_b, tolerance))
        .or_else(|| axes(a, b, (origin, origin), 1.0, tolerance))
        .or_else(|| scaled_axes(origin, origin))
        .or_else(|| scaled_axes(mean_a, mean_b))
        .or_else(|| turned(a, b, tolerance))
        .or_else(|| one_place(b))
}

fn offset(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Option<MeshFinding> {
    let by = mean(b) - mean(a);
    agree(a, b, tolerance, |point| point + by).then(|| MeshFinding::Offset { by: by.to_array() })
}

/// A scale that takes `center_a` to `center_b`.
fn scale(
    a: &[DVec3],
    b: &[DVec3],
    center_a: DVec3,
    center_b: DVec3,
    tolerance: f64,
) -> Option<MeshFinding> {
    let (mut product, mut square) = (0.0, 0.0);
    for (a, b) in a.iter().zip(b) {
        let (a, b) = (*a - center_a, *b - center_b);
        product += a.dot(b);
        square += a.dot(a);
    }
    let factor = product / square;
    let usable = factor.is_finite() && factor > 0.0 && (factor - 1.0).abs() > LEAST_SCALE;
    let agrees = usable
        && agree(a, b, tolerance * factor.max(1.0), |point| {
            (point - center_a) * factor + center_b
        });
    agrees.then(|| MeshFinding::Scaled {
        factor,
        offset: (center_b - center_a * factor).to_array(),
    })
}

/// Other axes, with a scale that takes the first of `centers` to the second.
fn axes(
    a: &[DVec3],
    b: &[DVec3],
    (center_a, center_b): (DVec3, DVec3),
    factor: f64,
    tolerance: f64,
) -> Option<MeshFinding> {
    let all = ORDERS
        .iter()
        .flat_map(|&order| (0..8).map(move |signs| (order, signs)));
    let [turned, mirrored]: [Vec<_>; 2] = [false, true].map(|mirrored| {
        all.clone()
            .filter(|&axes| is_mirrored(axes) == mirrored)
            .collect()
    });
    let placed = |(order, signs): ([usize; 3], usize), point: DVec3| {
        let sign = |axis: usize| if signs >> axis & 1 == 1 { -1.0 } else { 1.0 };
        DVec3::from_array(std::array::from_fn(|axis| sign(axis) * point[order[axis]])) * factor
    };
    let room = tolerance * factor.max(1.0);
    let found = turned.into_iter().chain(mirrored).find(|&axes| {
        agree(a, b, room, |point| {
            placed(axes, point - center_a) + center_b
        })
    });
    found.map(|(order, signs)| MeshFinding::Axes {
        from_a: std::array::from_fn(|axis| AXIS_NAMES[order[axis]][signs >> axis & 1]),
        mirrored: is_mirrored((order, signs)),
        factor,
        offset: (center_b - placed((order, signs), center_a)).to_array(),
    })
}

/// An odd number of exchanges and reversals mirrors.
fn is_mirrored((order, signs): ([usize; 3], usize)) -> bool {
    let kept = (0..3).filter(|&axis| order[axis] == axis).count();
    let exchanged = kept == 1;
    exchanged != (signs.count_ones() % 2 == 1)
}

/// A turn about any axis, with a scale and a movement; of the mirror image only where that of the
/// mesh itself does not do.
fn turned(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Option<MeshFinding> {
    let (center_a, center_b) = (mean(a), mean(b));
    let factor = size_by_size(a, b, center_a, center_b)?;
    let [turned, of_mirrored] = rotations(a, b, center_a, center_b)?;
    let room = tolerance * factor.max(1.0);
    [(turned, 1.0), (of_mirrored, -1.0)]
        .into_iter()
        .find_map(|(rotation, sign)| {
            let linear = |point: DVec3| rotation * point * (sign * factor);
            let offset = center_b - linear(center_a);
            let offset = if agree(a, b, room, linear) {
                DVec3::ZERO
            } else if agree(a, b, room, |point| linear(point) + offset) {
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
            let (axis, angle) = positive(rotation).to_axis_angle();
            Some(MeshFinding::Turned {
                mirrored,
                degrees: angle.to_degrees(),
                axis: axis.to_array(),
                factor,
                offset: offset.to_array(),
            })
        })
}

fn one_place(b: &[DVec3]) -> Option<MeshFinding> {
    let first = b.first().filter(|point| point.is_finite())?;
    let at = first.to_array();
    b.iter()
        .all(|point| point == first)
        .then_some(MeshFinding::OnePlace { at })
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

/// The same rotation, by at most half a turn.
fn positive(rotation: DQuat) -> DQuat {
    if rotation.w < 0.0 {
        -rotation
    } else {
        rotation
    }
}

/// How large `b` is by the size of `a`, as their points spread about the centers; one where it is
/// but for rounding. `None` if that is no size.
fn size_by_size(a: &[DVec3], b: &[DVec3], center_a: DVec3, center_b: DVec3) -> Option<f64> {
    let spread = |points: &[DVec3], center: DVec3| -> f64 {
        let squares = points.iter().map(|point| point.distance_squared(center));
        squares.sum()
    };
    let factor = (spread(b, center_b) / spread(a, center_a)).sqrt();
    if (factor - 1.0).abs() <= LEAST_SCALE {
        return Some(1.0);
    }
    (factor.is_finite() && factor > 0.0).then_some(factor)
}

fn agree(a: &[DVec3], b: &[DVec3], tolerance: f64, b_from_a: impl Fn(DVec3) -> DVec3) -> bool {
    a.iter()
        .zip(b)
        .all(|(a, b)| b_from_a(*a).distance(*b) <= tolerance)
}

fn mean(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len().max(1) as f64
}
