//! Pixels of which the nearest ones are looked for.

use glam::Vec2;

/// Pixels by where they are.
pub(super) struct PixelMap {
    is_in: Vec<bool>,
    size: [usize; 2],
}

impl PixelMap {
    pub fn new(pixels: &[Vec2], size: Vec2) -> Self {
        let size = [size.x as usize, size.y as usize];
        let mut is_in = vec![false; size[0] * size[1]];
        for pixel in pixels {
            is_in[pixel.y as usize * size[0] + pixel.x as usize] = true;
        }
        Self { is_in, size }
    }

    /// Distance of the nearest pixel, if there is one within `most`.
    pub fn nearest(&self, at: Vec2, most: f32) -> Option<f32> {
        let along = |at: f32, size: usize| {
            let end = (at + most).floor().max(-1.0) + 1.0;
            (at - most).ceil().max(0.0) as usize..size.min(end as usize)
        };
        let rows = along(at.y, self.size[1]);
        let pixels = rows.flat_map(|y| along(at.x, self.size[0]).map(move |x| (x, y)));
        let known = pixels.filter(|(x, y)| self.is_in[y * self.size[0] + x]);
        let distances = known.map(|(x, y)| Vec2::new(x as f32, y as f32).distance(at));
        distances
            .filter(|distance| *distance <= most)
            .reduce(f32::min)
    }
}

/// What differs in a live view, and what does not, by where it is.
pub(super) struct PixelMaps {
    /// What the live view shows, where that is off and where it is right.
    pub ours: [PixelMap; 2],
    /// What only the other picture shows; `None` where nothing of that is known.
    theirs: Option<PixelMap>,
}

impl PixelMaps {
    /// Of the pixels that are off and of those that are right in a live view of `size` pixels, and of those of the other picture.
    pub fn new(ours: [&[Vec2]; 2], theirs: &[Vec2], size: Vec2) -> Self {
        Self {
            ours: ours.map(|pixels| PixelMap::new(pixels, size)),
            theirs: (!theirs.is_empty()).then(|| PixelMap::new(theirs, size)),
        }
    }

    /// Whether the other picture is known to show nothing within a distance.
    pub fn is_far_from_theirs(&self, at: Vec2, distance: f32) -> bool {
        let [_, right] = &self.ours;
        let theirs = self.theirs.as_ref();
        let is_far = |shown: &PixelMap| shown.nearest(at, distance).is_none();
        theirs.is_some_and(is_far) && is_far(right)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_pixel_is_found_at_the_edges_of_a_picture_and_none_outside() {
        let map = PixelMap::new(&[Vec2::ZERO, Vec2::new(9.0, 4.0)], Vec2::new(10.0, 5.0));
        let nearest = |x: f32, y: f32| map.nearest(Vec2::new(x, y), 3.0);
        assert_eq!(nearest(0.0, 2.0), Some(2.0));
        assert_eq!(nearest(-3.0, 0.0), Some(3.0));
        assert_eq!(nearest(9.0, 6.5), Some(2.5));
        for (x, y) in [(-9.0, -9.0), (-3.0, -3.0), (50.0, 2.0), (5.0, 2.0)] {
            assert_eq!(nearest(x, y), None, "{x}, {y}");
        }
    }
}
