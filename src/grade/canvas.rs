//! Triangles as pixels, without OpenGL: small pictures in a report must be the same byte for byte on
//! every machine that grades a part of a class, also where nothing draws.

use crate::geometry::Picture;
use glam::Vec3;

/// The most pixels of triangles that are looked at in one picture, about a second: a file may have
/// millions of triangles that each cover all of it.
const MOST_WORK: usize = 200_000_000;

/// A color of red, green and blue.
pub(super) type Color = [u8; 3];

/// A picture that is drawn, with the depth of each pixel.
#[derive(Clone, Debug)]
pub(super) struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<Color>,
    depths: Vec<f32>,
    /// How many pixels of triangles may still be looked at.
    left: usize,
}

impl Canvas {
    pub(super) fn new([width, height]: [u32; 2], background: Color) -> Self {
        let (width, height) = (width as usize, height as usize);
        Self {
            width,
            height,
            pixels: vec![background; width * height],
            depths: vec![f32::NEG_INFINITY; width * height],
            left: MOST_WORK,
        }
    }

    /// Lets what is drawn from now on cover what is there.
    pub(super) fn forget_depths(&mut self) {
        self.depths.fill(f32::NEG_INFINITY);
    }

    /// Draws a triangle in pixels from the upper left with Z toward the viewer. `color` gets the weights
    /// of the three corners. Draws nothing once the picture has spent its share of work.
    pub(super) fn triangle(&mut self, corners: [Vec3; 3], color: impl Fn(Vec3) -> Color) {
        let [a, b, c] = corners.map(Vec3::truncate);
        let area = (b - a).perp_dot(c - a);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        if area == 0.0 {
            return;
        }
        // Conversions stop at 0 and at the largest number, and make 0 of what is no number.
        let end = |most: f32, side: usize| (most.ceil() as usize).min(side);
        let rows = low.y.max(0.0) as usize..end(high.y, self.height);
        let columns = low.x.max(0.0) as usize..end(high.x, self.width);
        let Some(left) = self.left.checked_sub(rows.len() * columns.len()) else {
            self.left = 0;
            return;
        };
        self.left = left;
        for y in rows {
            for x in columns.clone() {
                let pixel = glam::Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let weights = Vec3::new(
                    (c - b).perp_dot(pixel - b),
                    (a - c).perp_dot(pixel - c),
                    (b - a).perp_dot(pixel - a),
                ) / area;
                if weights.min_element() < 0.0 {
                    continue;
                }
                let depth = weights.dot(Vec3::new(corners[0].z, corners[1].z, corners[2].z));
                let at = y * self.width + x;
                if depth > self.depths[at] {
                    self.depths[at] = depth;
                    self.pixels[at] = color(weights);
                }
            }
        }
    }

    /// The picture, opaque.
    pub(super) fn into_picture(self) -> Picture {
        let rgba = self.pixels.iter().flat_map(|&[r, g, b]| [r, g, b, 255]);
        Picture {
            width: self.width as u32,
            height: self.height as u32,
            rgba: rgba.collect(),
        }
    }

    /// Each pixel anew from its place and its color.
    pub(super) fn map(&mut self, color: impl Fn(usize, usize, Color) -> Color) {
        for (at, pixel) in self.pixels.iter_mut().enumerate() {
            *pixel = color(at % self.width, at / self.width, *pixel);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearer_triangles_cover_farther_ones_whatever_the_order_and_the_side() {
        let square = |z: f32| {
            let at = |x: f32, y: f32| Vec3::new(x, y, z);
            [
                [at(0.0, 0.0), at(4.0, 0.0), at(0.0, 4.0)],
                [at(4.0, 4.0), at(4.0, 0.0), at(0.0, 4.0)],
            ]
        };
        let draw = |order: [(f32, Color); 2]| {
            let mut canvas = Canvas::new([4, 4], [9, 9, 9]);
            for (z, color) in order {
                for triangle in square(z) {
                    canvas.triangle(triangle, |_| color);
                }
            }
            canvas.into_picture()
        };
        let (near, far) = ((2.0, [1, 2, 3]), (1.0, [4, 5, 6]));
        let picture = draw([near, far]);
        assert_eq!(picture, draw([far, near]));
        assert_eq!(picture.rgba, [1, 2, 3, 255].repeat(16));
    }

    #[test]
    fn triangles_beyond_the_most_work_are_not_drawn() {
        let mut canvas = Canvas::new([4, 4], [9, 9, 9]);
        canvas.left = 40;
        let whole =
            |z: f32| [(-9.0, -9.0), (20.0, -9.0), (-9.0, 20.0)].map(|(x, y)| Vec3::new(x, y, z));
        for z in 1..=4_u8 {
            canvas.triangle(whole(f32::from(z)), |_| [z; 3]);
        }
        assert_eq!(canvas.into_picture().rgba, [2, 2, 2, 255].repeat(16));
    }

    #[test]
    fn triangles_that_lie_outside_or_nowhere_draw_nothing() {
        let mut canvas = Canvas::new([4, 4], [9, 9, 9]);
        for corner in [-1e30, 1e30, f32::INFINITY, f32::NAN] {
            let corners = [
                Vec3::splat(corner),
                Vec3::new(corner, 1.0, 0.0),
                Vec3::new(1.0, corner, 0.0),
            ];
            canvas.triangle(corners, |_| [0; 3]);
        }
        assert_eq!(canvas.into_picture().rgba, [9, 9, 9, 255].repeat(16));
    }
}
