//! Lines wider than a pixel, as two triangles each: core OpenGL does not promise to draw them.

use glam::{Vec2, Vec4};

/// Below this clip-space w a point is at the eye, or behind it.
const MIN_W: f32 = 1e-6;

/// A point in clip space with its color.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) clip: Vec4,
    pub(super) color: Vec4,
}

impl Point {
    fn lerp(self, other: Self, t: f32) -> Self {
        Self {
            clip: self.clip.lerp(other.clip, t),
            color: self.color.lerp(other.color, t),
        }
    }
}

/// Two triangles that cover the segment with `width` pixels across, or nothing where it is behind
/// the eye or seen end-on. `viewport` is the size of the picture in pixels.
///
/// The part before the near plane is cut off first: projecting it would turn the line around.
pub(super) fn quad(from: Point, to: Point, width: f32, viewport: Vec2) -> Option<[Point; 6]> {
    let (from, to) = cut(from, to, |clip| clip.z + clip.w)?;
    let (from, to) = cut(from, to, |clip| clip.w - MIN_W)?;
    let on_screen = |point: Point| point.clip.truncate().truncate() / point.clip.w * viewport * 0.5;
    let along = (on_screen(to) - on_screen(from)).try_normalize()?;
    let aside = along.perp() * width / viewport;
    let moved = |point: Point, by: Vec2| Point {
        clip: point.clip + (by * point.clip.w).extend(0.0).extend(0.0),
        ..point
    };
    let (a, b) = (moved(from, -aside), moved(to, -aside));
    let (c, d) = (moved(to, aside), moved(from, aside));
    Some([a, b, c, a, c, d])
}

/// The part of a segment where `inside` is not negative.
fn cut(from: Point, to: Point, inside: impl Fn(Vec4) -> f32) -> Option<(Point, Point)> {
    let (start, end) = (inside(from.clip), inside(to.clip));
    match (start >= 0.0, end >= 0.0) {
        (true, true) => Some((from, to)),
        (true, false) => Some((from, from.lerp(to, start / (start - end)))),
        (false, true) => Some((from.lerp(to, start / (start - end)), to)),
        (false, false) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEWPORT: Vec2 = Vec2::new(200.0, 100.0);

    fn point(x: f32, y: f32, z: f32, w: f32) -> Point {
        Point {
            clip: Vec4::new(x, y, z, w),
            color: Vec4::ONE,
        }
    }

    #[test]
    fn a_line_is_as_wide_as_asked_at_both_ends_whatever_their_distance() {
        let quad = quad(
            point(0.0, 0.0, 0.0, 1.0),
            point(2.0, 0.0, 3.0, 4.0),
            5.0,
            VIEWPORT,
        )
        .unwrap();
        let height = |p: Point| p.clip.y / p.clip.w * VIEWPORT.y * 0.5;
        let [a, b, c, _, _, d] = quad;
        assert!((height(d) - height(a) - 5.0).abs() < 1e-5);
        assert!((height(c) - height(b) - 5.0).abs() < 1e-5);
    }

    #[test]
    fn a_line_that_passes_the_eye_ends_at_the_near_plane() {
        let behind = Point {
            color: Vec4::ZERO,
            ..point(0.0, 0.0, -3.0, -1.0)
        };
        let quad = quad(point(1.0, 0.0, 0.0, 2.0), behind, 2.0, VIEWPORT).unwrap();
        // z + w goes from 2 to -4: a third of the way.
        let end = quad[1];
        assert!((end.clip.z + end.clip.w).abs() < 1e-6);
        assert!((end.clip.w - 1.0).abs() < 1e-6);
        assert!((end.color.x - 2.0 / 3.0).abs() < 1e-6);
    }

    #[test]
    fn nothing_is_left_of_a_line_behind_the_eye_or_without_a_direction() {
        let behind = point(0.0, 0.0, -3.0, -1.0);
        assert_eq!(
            quad(behind, point(1.0, 0.0, -3.0, 1.0), 2.0, VIEWPORT),
            None
        );
        let there = point(0.5, 0.5, 0.0, 1.0);
        assert_eq!(quad(there, there, 2.0, VIEWPORT), None);
    }
}
