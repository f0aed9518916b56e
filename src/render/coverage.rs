//! Triangles that are in no pixel.

use super::samples::Samples;
use super::sight::largest_terms;
use crate::math::Aabb;
use glam::{Mat4, Vec2, Vec3, Vec4Swizzles as _};

/// Share of the terms of a sum by which rounding may change it.
const ROUNDING: f32 = 2e-6;
/// Pixels by which a corner may be off at most, so that it is worth looking.
const MOST_OFF: f32 = 0.25;
/// Corners farther from the picture's, in pixels, are not looked at.
const FAR: f32 = 10_000.0;
/// Samples within the box of a triangle up to which each is looked at.
const FEW: f32 = 4.0;

/// Way of a mesh to the pixels of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Raster {
    pub clip_from_world: Mat4,
    pub world_from_model: Mat4,
    /// Width and height of the picture, in pixels.
    pub size: [u32; 2],
}

impl Raster {
    /// The triangles in which there may be a sample, by their numbers, in their order. The driver draws nothing of
    /// the others: in a crowd, most of them lie between the middles of pixels. `None` if nearly all may
    /// be seen: `bounds`, around the mesh in model space, reach behind the eye or take up more pixels
    /// than there are triangles.
    pub fn covering(
        &self,
        bounds: &Aabb,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        samples: &Samples,
    ) -> Option<Vec<u32>> {
        let size = Vec2::new(self.size[0] as f32, self.size[1] as f32);
        let off = samples.room + self.off(bounds, size, triangles.len() * samples.places.len())?;
        if off > MOST_OFF {
            return None;
        }
        let clip_from_model = self.clip_from_world * self.world_from_model;
        let on_picture: Vec<Vec2> = positions
            .iter()
            .map(|&position| {
                let clip = clip_from_model * position.extend(1.0);
                (clip.xy() / clip.w * 0.5 + 0.5) * size
            })
            .collect();
        let tests = SampleTests {
            size,
            off,
            places: &samples.places,
        };
        let numbered = triangles.iter().zip(0_u32..);
        let kept = numbered.filter_map(|(triangle, number)| {
            let corners = triangle.map(|corner| on_picture[corner as usize]);
            tests.may_cover(corners).then_some(number)
        });
        Some(kept.collect())
    }

    /// How far, in pixels, rounding may move a point within `bounds`; `None` if it is not worth looking
    /// at so many triangles.
    fn off(&self, bounds: &Aabb, size: Vec2, triangles: usize) -> Option<f32> {
        let (mut least, mut most) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
        let (mut nearest, mut largest) = (f32::INFINITY, 0.0_f32);
        for corner in bounds.corners() {
            let world = largest_terms(self.world_from_model, corner);
            largest = largest.max(largest_terms(self.clip_from_world, world.xyz()).max_element());
            let clip = self.clip_from_world * (self.world_from_model * corner.extend(1.0));
            nearest = nearest.min(clip.w);
            let at = (clip.xy() / clip.w * 0.5 + 0.5) * size;
            (least, most) = (least.min(at), most.max(at));
        }
        let pixels = most - least;
        let is_dense = (nearest > 0.0) && pixels.x * pixels.y < triangles as f32;
        is_dense.then(|| ROUNDING * largest / nearest * size.max_element())
    }
}

/// What it takes to be drawn.
struct SampleTests<'a> {
    size: Vec2,
    off: f32,
    places: &'a [Vec2],
}

impl SampleTests<'_> {
    /// Whether a sample may be within the triangle.
    fn may_cover(&self, corners: [Vec2; 3]) -> bool {
        let [a, b, c] = corners;
        let least = a.min(b).min(c) - self.off;
        let most = a.max(b).max(c) + self.off;
        let is_near = least.cmpgt(Vec2::splat(-FAR)).all() && most.cmplt(self.size + FAR).all();
        // Also where a number is none.
        if !is_near || !(a + b + c).is_finite() {
            return true;
        }
        self.places.iter().any(|&sample| {
            // The first and the last column and row whose sample is in the box.
            let first = (least - sample).ceil().max(Vec2::ZERO);
            let last = (most - sample).floor().min(self.size - 1.0);
            if first.x > last.x || first.y > last.y {
                return false;
            }
            let count = last - first + 1.0;
            count.x * count.y > FEW || self.any_within(corners, first + sample, count)
        })
    }

    /// Whether one of some samples may be within the triangle.
    fn any_within(&self, corners: [Vec2; 3], first: Vec2, count: Vec2) -> bool {
        let (columns, rows) = (count.x as u8, count.y as u8);
        (0..rows).any(|row| {
            (0..columns).any(|column| {
                let at = first + Vec2::new(f32::from(column), f32::from(row));
                self.is_within(corners, at)
            })
        })
    }

    /// Whether a point may be within the triangle: on the same side of all its edges, or so near to
    /// those where it is not that corners which are a little off may have it there.
    fn is_within(&self, corners: [Vec2; 3], at: Vec2) -> bool {
        let [a, b, c] = corners;
        let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| {
            let (along, aside) = (to - from, at - from);
            let sum = |v: Vec2| v.x.abs() + v.y.abs();
            let off = self.off * (2.0 * sum(aside) + sum(along) + 4.0 * self.off);
            (along.perp_dot(aside), off)
        });
        sides.iter().all(|&(side, off)| side >= -off)
            || sides.iter().all(|&(side, off)| side <= off)
    }
}
