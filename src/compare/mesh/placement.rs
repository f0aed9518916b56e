use super::MeshFinding;
use glam::DVec3;

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
/// the origin, a scale and a movement, or other axes.
pub(super) fn find(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Option<MeshFinding> {
    offset(a, b, tolerance)
        .or_else(|| scale(a, b, DVec3::ZERO, DVec3::ZERO, tolerance))
        .or_else(|| scale(a, b, mean(a), mean(b), tolerance))
        .or_else(|| axes(a, b, tolerance))
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
        && agree(a, b, tolerance, |point| {
            (point - center_a) * factor + center_b
        });
    agrees.then(|| MeshFinding::Scaled {
        factor,
        offset: (center_b - center_a * factor).to_array(),
    })
}

fn axes(a: &[DVec3], b: &[DVec3], tolerance: f64) -> Option<MeshFinding> {
    let all = ORDERS
        .iter()
        .flat_map(|&order| (0..8).map(move |signs| (order, signs)));
    let [turned, mirrored]: [Vec<_>; 2] = [false, true].map(|mirrored| {
        all.clone()
            .filter(|&axes| is_mirrored(axes) == mirrored)
            .collect()
    });
    let found = turned.into_iter().chain(mirrored).find(|&(order, signs)| {
        agree(a, b, tolerance, |point| {
            let sign = |axis: usize| if signs >> axis & 1 == 1 { -1.0 } else { 1.0 };
            DVec3::from_array(std::array::from_fn(|axis| sign(axis) * point[order[axis]]))
        })
    });
    found.map(|(order, signs)| MeshFinding::Axes {
        from_a: std::array::from_fn(|axis| AXIS_NAMES[order[axis]][signs >> axis & 1]),
        mirrored: is_mirrored((order, signs)),
    })
}

/// An odd number of exchanges and reversals mirrors.
fn is_mirrored((order, signs): ([usize; 3], usize)) -> bool {
    let kept = (0..3).filter(|&axis| order[axis] == axis).count();
    let exchanged = kept == 1;
    exchanged != (signs.count_ones() % 2 == 1)
}

fn agree(a: &[DVec3], b: &[DVec3], tolerance: f64, b_from_a: impl Fn(DVec3) -> DVec3) -> bool {
    a.iter()
        .zip(b)
        .all(|(a, b)| b_from_a(*a).distance(*b) <= tolerance)
}

fn mean(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len().max(1) as f64
}
