use glam::{Mat4, Vec2, Vec4};

/// Part of a picture that is drawn by itself, because all of it would exceed the driver's limits or
/// memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Tile {
    /// Width and height of the whole picture, in pixels.
    pub whole: (u32, u32),
    /// First column, from the left of the whole picture; negative in a margin.
    pub left: i64,
    /// First row, from the bottom of the whole picture; negative in a margin.
    pub bottom: i64,
    /// Width and height of the tile, in pixels.
    pub size: (u32, u32),
}

/// What is drawn round a tile and cut off again, in pixels, so that nothing is seen of its edges:
/// soft shadows look this far aside, and points and lines are narrower. Tiles begin at multiples of
/// it, and have multiples of it as sides: smaller versions of the picture, which soft shadows are
/// read from, then have the same pixels in all tiles.
pub(super) const MARGIN: u32 = 128;

impl Tile {
    /// A picture in one piece.
    pub fn whole(size: (u32, u32)) -> Self {
        Self {
            whole: size,
            left: 0,
            bottom: 0,
            size,
        }
    }

    /// Tiles of a picture of `whole` pixels, from the bottom up. They have at most `most` pixels a
    /// side, but [`MARGIN`] at least; the last ones reach beyond the picture.
    pub fn all(whole: (u32, u32), most: u32) -> Vec<Self> {
        let most = (most / MARGIN).max(1) * MARGIN;
        let side = |length: u32| most.min(length.next_multiple_of(MARGIN));
        let size = (side(whole.0), side(whole.1));
        let starts = |length: u32, side: u32| (0..i64::from(length)).step_by(side as usize);
        let row = |bottom| {
            starts(whole.0, size.0).map(move |left| Self {
                whole,
                left,
                bottom,
                size,
            })
        };
        starts(whole.1, size.1).flat_map(row).collect()
    }

    /// The tile with its margin.
    pub fn with_margin(self) -> Self {
        let (width, height) = self.size;
        Self {
            left: self.left - i64::from(MARGIN),
            bottom: self.bottom - i64::from(MARGIN),
            size: (width + 2 * MARGIN, height + 2 * MARGIN),
            ..self
        }
    }

    /// Width over height of the whole picture.
    pub fn aspect(&self) -> f32 {
        self.whole.0 as f32 / self.whole.1 as f32
    }

    /// Half sides and center of the tile in a picture that reaches from −1 to 1 on both axes.
    pub fn in_picture(&self) -> (Vec2, Vec2) {
        let side = |start: i64, length: u32, whole: u32| {
            let (length, whole) = (f64::from(length), f64::from(whole));
            let half = length / whole;
            (
                half as f32,
                (2.0 * start as f64 / whole + half - 1.0) as f32,
            )
        };
        let (half_width, x) = side(self.left, self.size.0, self.whole.0);
        let (half_height, y) = side(self.bottom, self.size.1, self.whole.1);
        (Vec2::new(half_width, half_height), Vec2::new(x, y))
    }

    /// Matrix from the clip space of the whole picture to that of the tile.
    pub fn clip_from_whole(&self) -> Mat4 {
        let (half, center) = self.in_picture();
        let scale = half.recip();
        let shift = -center * scale;
        Mat4::from_cols(
            Vec4::X * scale.x,
            Vec4::Y * scale.y,
            Vec4::Z,
            Vec4::new(shift.x, shift.y, 0.0, 1.0),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn tiles_cover_every_pixel_once_and_begin_at_multiples_of_the_margin() {
        let whole = (700, 301);
        let mut seen = vec![0; 700 * 301];
        for tile in Tile::all(whole, 300) {
            assert_eq!(tile.size, (256, 256));
            assert_eq!((tile.left % 128, tile.bottom % 128), (0, 0));
            for row in tile.bottom..(tile.bottom + 256).min(301) {
                for column in tile.left..(tile.left + 256).min(700) {
                    seen[(row * 700 + column) as usize] += 1;
                }
            }
        }
        assert!(seen.iter().all(|&count| count == 1));
    }

    #[test]
    fn the_corners_of_a_tile_are_those_of_its_clip_space() {
        let tile = Tile {
            whole: (800, 600),
            left: -100,
            bottom: 450,
            size: (400, 200),
        };
        let clip = tile.clip_from_whole();
        for ((column, row), (x, y)) in [
            ((-100.0, 450.0), (-1.0, -1.0)),
            ((300.0, 650.0), (1.0, 1.0)),
            ((100.0, 550.0), (0.0, 0.0)),
        ] {
            let whole = Vec3::new(2.0 * column / 800.0 - 1.0, 2.0 * row / 600.0 - 1.0, 0.5);
            let found = clip.project_point3(whole);
            assert!(found.abs_diff_eq(Vec3::new(x, y, 0.5), 1e-5), "{found}");
        }
        assert_eq!(Tile::whole((800, 600)).clip_from_whole(), Mat4::IDENTITY);
    }
}
