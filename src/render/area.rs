use glam::{Mat4, Vec2, Vec3};

/// Rectangle of pixels of a picture, counted from the bottom left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Area {
    /// First column and row.
    pub first: [u32; 2],
    /// Column and row after the last.
    pub end: [u32; 2],
}

impl Area {
    /// No pixels at all.
    pub const EMPTY: Self = Self {
        first: [u32::MAX; 2],
        end: [0; 2],
    };

    /// All pixels of a picture of this size.
    pub fn whole(size: [u32; 2]) -> Self {
        Self {
            first: [0; 2],
            end: size,
        }
    }

    pub fn is_empty(&self) -> bool {
        self.first[0] >= self.end[0] || self.first[1] >= self.end[1]
    }

    /// Number of its pixels.
    pub fn pixels(&self) -> u64 {
        let [_, _, width, height] = self.rectangle().map(i32::unsigned_abs);
        u64::from(width) * u64::from(height)
    }

    /// The smallest area with both.
    pub fn union(self, other: Self) -> Self {
        let axes = [0, 1];
        Self {
            first: axes.map(|axis| self.first[axis].min(other.first[axis])),
            end: axes.map(|axis| self.end[axis].max(other.end[axis])),
        }
    }

    /// Where everything between `points` lies in a picture of `size` pixels, with a pixel more on each
    /// side for what rounding may do. All of the picture if a point is behind the eye, which has no
    /// such place.
    pub fn around(points: &[Vec3], clip_from_world: Mat4, size: [u32; 2]) -> Self {
        let mut least = Vec2::INFINITY;
        let mut most = Vec2::NEG_INFINITY;
        for point in points {
            let clip = clip_from_world * point.extend(1.0);
            let at = clip.truncate().truncate() / clip.w;
            if clip.w <= 0.0 || !at.is_finite() {
                return Self::whole(size);
            }
            (least, most) = (least.min(at), most.max(at));
        }
        if points.is_empty() {
            return Self::EMPTY;
        }
        let [width, height] = size;
        let pixel = |at: Vec2| (at * 0.5 + 0.5) * Vec2::new(width as f32, height as f32);
        // Numbers beyond the range of integers become the nearest in it.
        let (least, most) = (pixel(least) - 1.0, pixel(most) + 2.0);
        Self {
            first: [least.x as u32, least.y as u32],
            end: [(most.x as u32).min(width), (most.y as u32).min(height)],
        }
    }

    /// The pixels that are in both.
    pub fn within(self, other: Self) -> Self {
        let axes = [0, 1];
        Self {
            first: axes.map(|axis| self.first[axis].max(other.first[axis])),
            end: axes.map(|axis| self.end[axis].min(other.end[axis])),
        }
    }

    /// Left side, lower side, width and height, as OpenGL takes them.
    pub fn rectangle(&self) -> [i32; 4] {
        let [x, y] = self.first.map(u32::cast_signed);
        let [right, top] = self.end.map(u32::cast_signed);
        [x, y, (right - x).max(0), (top - y).max(0)]
    }

    /// The pixels of `whole` outside of this area of it, in up to four rectangles.
    pub fn outside(&self, whole: Self) -> impl Iterator<Item = Self> {
        let ([left, bottom], [right, top]) = (self.first, self.end);
        let ([first, low], [end, high]) = (whole.first, whole.end);
        let area = |first, end| Self { first, end };
        let parts = if self.is_empty() {
            [whole, Self::EMPTY, Self::EMPTY, Self::EMPTY]
        } else {
            [
                area([first, low], [end, bottom]),
                area([first, top], [end, high]),
                area([first, bottom], [left, top]),
                area([right, bottom], [end, top]),
            ]
        };
        parts.into_iter().filter(|part| !part.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::camera::rh::proj::opengl;

    #[test]
    fn an_area_and_what_is_outside_of_it_are_all_pixels_once() {
        let whole = Area::whole([9, 7]);
        for area in [
            Area {
                first: [2, 3],
                end: [5, 6],
            },
            Area {
                first: [0, 0],
                end: [9, 3],
            },
            Area::EMPTY,
            whole,
        ] {
            let mut times = [[0; 9]; 7];
            for part in area
                .outside(whole)
                .chain([area])
                .filter(|part| !part.is_empty())
            {
                for row in part.first[1]..part.end[1] {
                    for column in part.first[0]..part.end[0] {
                        times[row as usize][column as usize] += 1;
                    }
                }
            }
            assert_eq!(times, [[1; 9]; 7], "{area:?}");
        }
    }

    #[test]
    fn points_lie_in_their_area_and_those_behind_the_eye_may_be_anywhere() {
        let size = [100, 50];
        let clip_from_world = opengl::perspective(1.0, 2.0, 0.1, 100.0);
        let points = [Vec3::new(0.0, 0.0, -5.0), Vec3::new(1.0, 0.5, -5.0)];
        let area = Area::around(&points, clip_from_world, size);
        // The middle of the picture, and 0.2 / tan(0.5) / 2 of half its width to the right.
        assert_eq!(area.first, [49, 24]);
        assert_eq!(area.end, [61, 31]);
        let behind = [Vec3::new(0.0, 0.0, 5.0)];
        assert_eq!(
            Area::around(&behind, clip_from_world, size),
            Area::whole(size)
        );
        assert!(Area::around(&[], clip_from_world, size).is_empty());
    }
}
