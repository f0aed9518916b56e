//! Segments in a picture.

use glam::Vec2;

/// Distance of a place in a picture from the segment between two others, which may be one.
pub fn distance_from_segment(at: Vec2, [start, end]: [Vec2; 2]) -> f32 {
    let along = end - start;
    let share = (at - start).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
    at.distance(start + along * share.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_is_as_far_as_its_nearest_point_which_may_be_an_end_of_it() {
        let segment = [Vec2::new(1.0, 2.0), Vec2::new(5.0, 2.0)];
        for (at, expected) in [((3.0, 5.0), 3.0), ((8.0, 6.0), 5.0), ((1.0, 2.0), 0.0)] {
            assert_eq!(distance_from_segment(at.into(), segment), expected);
        }
        let point = [Vec2::ONE; 2];
        assert_eq!(distance_from_segment(Vec2::new(4.0, 5.0), point), 5.0);
    }
}
