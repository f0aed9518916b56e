use glam::Vec3;

/// The unit normal of a triangle whose corners wind counter-clockwise; zero for one without
/// area, so that it takes no light and breaks nothing.
pub fn face_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

/// One unit normal a triangle, from the *current* positions: what the assignment asks to be made
/// anew each time the vertices change.
pub fn face_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    triangles
        .iter()
        .map(|corners| face_normal(corners.map(|i| positions[i as usize])))
        .collect()
}

/// One unit normal a vertex: the mean of the faces around it, weighted by their area. A vertex
/// without faces gets zero.
pub fn smooth_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for corners in triangles {
        let [a, b, c] = corners.map(|i| positions[i as usize]);
        let twice_the_area = (b - a).cross(c - a);
        for &corner in corners {
            sums[corner as usize] += twice_the_area;
        }
    }
    sums.into_iter().map(Vec3::normalize_or_zero).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_without_area_has_a_zero_normal_and_no_nan() {
        assert_eq!(face_normal([Vec3::ONE; 3]), Vec3::ZERO);
        assert_eq!(
            face_normal([Vec3::ZERO, Vec3::X, Vec3::X * 2.0]),
            Vec3::ZERO
        );
    }

    #[test]
    fn normals_follow_the_right_hand() {
        assert_eq!(face_normal([Vec3::ZERO, Vec3::X, Vec3::Y]), Vec3::Z);
    }
}
