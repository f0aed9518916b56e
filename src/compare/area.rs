use glam::Vec2;
use serde::Serialize;
use std::fmt;
use std::str::FromStr;

/// A rectangle of pixels, from the upper left corner of the picture. Written `X,Y,W,H`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Area {
    /// First column.
    pub x: u32,
    /// First row.
    pub y: u32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Area {
    /// The part inside a picture of this size; `None` if no pixel is left.
    pub fn clipped(self, width: u32, height: u32) -> Option<Self> {
        let clipped = Self {
            width: self.width.min(width.checked_sub(self.x)?),
            height: self.height.min(height.checked_sub(self.y)?),
            ..self
        };
        (clipped.width > 0 && clipped.height > 0).then_some(clipped)
    }

    /// The nearest area of at least a pixel inside a picture of this size, which has one.
    #[must_use]
    pub fn inside(self, (width, height): (u32, u32)) -> Self {
        let x = self.x.min(width.saturating_sub(1));
        let y = self.y.min(height.saturating_sub(1));
        Self {
            x,
            y,
            width: self.width.clamp(1, (width - x).max(1)),
            height: self.height.clamp(1, (height - y).max(1)),
        }
    }

    /// Half the width and height of a picture of this size, in its middle.
    pub fn in_the_middle(size: (u32, u32)) -> Self {
        Self {
            x: size.0 / 4,
            y: size.1 / 4,
            width: size.0 / 2,
            height: size.1 / 2,
        }
        .inside(size)
    }

    /// Its columns and rows in words, such as `x 3 to 9, y 4`.
    pub fn in_words(self) -> String {
        let along = |axis, first: u32, count: u32| match count {
            0 | 1 => format!("{axis} {first}"),
            _ => format!("{axis} {first} to {}", first + (count - 1)),
        };
        let (columns, rows) = (
            along("x", self.x, self.width),
            along("y", self.y, self.height),
        );
        format!("{columns}, {rows}")
    }

    /// Its upper left corner, and the lower right one, which is no pixel of it.
    pub fn corners(self) -> [Vec2; 2] {
        let least = Vec2::new(self.x as f32, self.y as f32);
        [
            least,
            least + Vec2::new(self.width as f32, self.height as f32),
        ]
    }

    /// The smallest area around all pixels `(x, y)`; `None` without any.
    pub fn around(pixels: impl IntoIterator<Item = (u32, u32)>) -> Option<Self> {
        let mut ends: Option<[u32; 4]> = None;
        for (x, y) in pixels {
            let [left, top, right, bottom] = ends.unwrap_or([x, y, x, y]);
            ends = Some([left.min(x), top.min(y), right.max(x), bottom.max(y)]);
        }
        ends.map(|[left, top, right, bottom]| Self {
            x: left,
            y: top,
            width: right - left + 1,
            height: bottom - top + 1,
        })
    }
}

impl FromStr for Area {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Result<Vec<u32>, _> =
            text.split(',').map(|part| part.trim().parse()).collect();
        match numbers.as_deref() {
            Ok(&[x, y, width, height]) if width > 0 && height > 0 => Ok(Self {
                x,
                y,
                width,
                height,
            }),
            _ => Err(format!(
                "expected X,Y,W,H in whole pixels with a size above zero, found “{text}”"
            )),
        }
    }
}

impl fmt::Display for Area {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{},{}", self.x, self.y, self.width, self.height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_area_is_written_and_read_as_four_numbers() {
        let area = Area {
            x: 1,
            y: 2,
            width: 30,
            height: 4,
        };
        assert_eq!("1, 2,30,4".parse(), Ok(area));
        assert_eq!(area.to_string().parse(), Ok(area));
        for wrong in ["", "1,2,3", "1,2,3,4,5", "-1,2,3,4", "1,2,0,4", "1,2,x,4"] {
            assert!(wrong.parse::<Area>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn in_words_an_area_is_its_first_and_last_columns_and_rows() {
        let words = |text: &str| text.parse::<Area>().unwrap().in_words();
        assert_eq!(words("227,53,507,631"), "x 227 to 733, y 53 to 683");
        assert_eq!(words("5,7,1,2"), "x 5, y 7 to 8");
    }

    #[test]
    fn an_area_is_clipped_to_the_picture() {
        let area: Area = "6,4,10,4294967295".parse().unwrap();
        assert_eq!(area.clipped(8, 6), "6,4,2,2".parse().ok());
        assert_eq!(area.clipped(6, 6), None);
        assert_eq!(area.clipped(5, 6), None);
    }

    #[test]
    fn an_area_is_brought_inside_of_the_picture_and_keeps_a_pixel() {
        let inside = |x, y, width, height| {
            let area = Area {
                x,
                y,
                width,
                height,
            };
            area.inside((80, 60)).to_string()
        };
        assert_eq!(inside(10, 5, 20, 7), "10,5,20,7");
        assert_eq!(inside(70, 50, 90, 90), "70,50,10,10");
        assert_eq!(inside(500, 600, 5, 0), "79,59,1,1");
    }

    #[test]
    fn the_area_around_pixels_holds_the_outermost() {
        assert_eq!(Area::around([]), None);
        assert_eq!(Area::around([(3, 1), (2, 5)]), "2,1,2,5".parse().ok());
    }
}
