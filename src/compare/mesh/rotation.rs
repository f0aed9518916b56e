use glam::{DQuat, DVec3};

/// More sweeps than any matrix of this size takes.
const MOST_SWEEPS: usize = 32;

/// The rotation that takes `a` nearest to `b`, as seen from their centers, and the one that takes
/// the mirror image of `a` through its center there. `None` where the points do not spread, or
/// are no numbers.
///
/// Horn, Closed-form solution of absolute orientation using unit quaternions, 1987: they are the
/// eigenvectors of the largest and of the smallest eigenvalue of a matrix of products.
pub(super) fn rotations(
    a: &[DVec3],
    b: &[DVec3],
    center_a: DVec3,
    center_b: DVec3,
) -> Option<[DQuat; 2]> {
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
                let found = rotations(&a, &b, DVec3::ZERO, DVec3::ZERO).unwrap()[which];
                let likeness = found.dot(turn).abs();
                assert!(likeness > 1.0 - 1e-12, "{i}: {found} for {turn}");
            }
        }
    }

    #[test]
    fn what_does_not_spread_or_is_no_number_has_no_turn() {
        let find = |a, b| rotations(&[a, -a], &[b, -b], DVec3::ZERO, DVec3::ZERO);
        assert_eq!(find(DVec3::X, DVec3::ZERO), None);
        assert_eq!(find(DVec3::NAN, DVec3::X), None);
        assert_eq!(find(DVec3::X, DVec3::INFINITY), None);
        assert!(find(DVec3::X, DVec3::Y).is_some());
    }
}
