//! What is wrong with a picture, in words. A finding is reported only where the pictures bear it
//! out pixel by pixel; where nothing explains the difference, nothing is said.

mod color;
mod detail;
mod evidence;
mod highlight;
mod motion;
mod nearly;
mod outline;
mod white_light;
mod words;

use super::{Area, Pair};
use serde::Serialize;

/// One thing that the comparison found. B is held against the reference A.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Finding {
    /// Every pixel of one picture (or of each) has one color: nothing was drawn.
    Blank {
        /// Which.
        picture: Which,
    },
    /// Every pixel of one picture (or of each) has opacity 0, though they have different colors.
    Transparent {
        /// Which.
        picture: Which,
    },
    /// Nothing but rounding, and so few other pixels that they tell nothing.
    NearlySame {
        /// Largest difference that may be rounding: 0 to 3 of 255.
        rounding: u8,
        /// Pixels that differ by more.
        others: u64,
        /// Of these, pixels that differ by more than 8 of 255.
        other_color: u64,
        /// Where the others are.
        area: Option<Area>,
        /// Whether the backgrounds differ beside, which is told by itself.
        other_background: bool,
    },
    /// B is A moved by whole pixels.
    Shifted {
        /// To the right.
        dx: i32,
        /// Downward.
        dy: i32,
    },
    /// B is A with the sides exchanged.
    Mirrored {
        /// Left and right are exchanged.
        left_right: bool,
        /// Top and bottom are exchanged.
        top_bottom: bool,
    },
    /// What is drawn in B has A's outline in another size.
    Scaled {
        /// Size in B by size in A.
        factor: f64,
    },
    /// B has red and blue exchanged.
    RedBlueExchanged,
    /// B is A in shades of gray.
    Gray,
    /// The backgrounds differ.
    Background {
        /// Red, green, blue in A.
        a: [u8; 3],
        /// Red, green, blue in B.
        b: [u8; 3],
        /// Whether nothing else differs by more than 8 of 255.
        alone: bool,
    },
    /// Pixels differ in opacity.
    Opacity {
        /// How many.
        pixels: u64,
    },
    /// What is drawn in B has the colors of A times these factors.
    Brightness {
        /// For red, green and blue.
        factors: [f64; 3],
    },
    /// One picture is encoded as sRGB once more often than the other.
    Gamma {
        /// The one that was encoded more often, and is lighter.
        lighter: Which,
    },
    /// A highlight is missing: the difference is white light that fades toward its rim.
    Highlight {
        /// The picture without it.
        missing_in: Which,
        /// Where it is in the other.
        area: Area,
    },
    /// A highlight is another one in B: the difference is white light that fades toward its rim.
    HighlightChanged {
        /// How B's is, held against A's.
        in_b: HighlightChange,
        /// Where it is another one.
        area: Area,
    },
    /// The differences lie along edges, where each color is between those around it in the other
    /// picture.
    Edges {
        /// So many of the pixels that differ by more than 8 of 255.
        share: f64,
        /// Where all of these are.
        area: Area,
    },
    /// Fine detail differs: over 16×16 pixels the colors of A and B have the same means, and those
    /// of B are near to those around in A.
    Detail {
        /// Largest difference of a channel, of 255.
        max: u8,
        /// Where pixels differ by more than 8.
        area: Area,
    },
    /// Things are drawn in one picture where the other shows the background.
    Outline {
        /// Pixels drawn only in A.
        only_a: u64,
        /// Where these are.
        area_a: Option<Area>,
        /// Pixels drawn only in B.
        only_b: u64,
        /// Where these are.
        area_b: Option<Area>,
    },
    /// What is drawn has another color in B.
    Shading {
        /// Pixels that differ by more than 8 of 255, by all that are drawn: in both, unless the
        /// outlines agree.
        share: f64,
        /// Where these are.
        area: Area,
        /// Whether next to nothing is drawn in one picture alone. Otherwise that is told by
        /// itself.
        outlines_agree: bool,
    },
}

/// How a highlight of B is, held against A's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HighlightChange {
    /// Less bright; A's is in B too.
    Weaker,
    /// Brighter; B's is in A too.
    Stronger,
    /// As bright, but smaller.
    Narrower,
    /// As bright, but larger.
    Wider,
    /// Weaker, narrower or missing: the colors do not tell which.
    Less,
    /// Stronger, wider or missing in A: the colors do not tell which.
    More,
}

/// One of the two pictures, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Which {
    /// The reference.
    A,
    /// The one held against it.
    B,
    /// Each of them.
    Both,
}

impl Pair<'_> {
    /// What the differences come from, as far as the pictures prove it. Empty if nothing does,
    /// or if they are equal.
    pub fn findings(&self) -> Vec<Finding> {
        if let Some(picture) = Which::of(self.hides_colors()) {
            return vec![Finding::Transparent { picture }];
        }
        // Another background must not hide what else is wrong.
        let over_same = self.over_background_of_a();
        let pair = over_same.as_ref().unwrap_or(self);
        let blank = self.blank();
        if self.a() == self.b() || blank.is_some() {
            let background = self.background_beside(pair);
            return blank.into_iter().chain(background).collect();
        }
        let mut findings: Vec<Finding> = pair.motion().into_iter().collect();
        findings.extend(self.opacity());
        if findings.is_empty() {
            let exchanged = self.red_blue_exchanged();
            let exchanged = exchanged.or_else(|| pair.red_blue_exchanged());
            findings.extend(exchanged.or_else(|| self.gray()));
        }
        findings.extend(self.background_beside(pair));
        let explained =
            |finding: &Finding| !matches!(finding, Finding::Background { alone: false, .. });
        if findings.iter().any(explained) {
            return findings;
        }
        let color = || {
            self.gamma()
                .or_else(|| self.brightness())
                .or_else(|| pair.highlight())
        };
        let surface = pair
            .nearly_same(over_same.is_some())
            .or_else(|| {
                if pair.outline_dominates() {
                    None
                } else {
                    color()
                }
            })
            .or_else(|| pair.edges())
            .or_else(|| pair.detail())
            .or_else(|| pair.scaled())
            .or_else(|| pair.outline());
        let beside = match surface {
            None => pair.shading(None),
            Some(Finding::Outline { only_a, only_b, .. }) => pair.shading(Some(only_a + only_b)),
            Some(_) => None,
        };
        findings.extend(surface.into_iter().chain(beside));
        findings
    }

    fn blank(&self) -> Option<Finding> {
        let picture = Which::of([self.a(), self.b()].map(|pixels| self.is_even(pixels)))?;
        Some(Finding::Blank { picture })
    }

    fn opacity(&self) -> Option<Finding> {
        let pixels = self.a().iter().zip(self.b());
        let pixels = pixels.filter(|(a, b)| a[3] != b[3]).count() as u64;
        (pixels > 0).then_some(Finding::Opacity { pixels })
    }
}

impl Which {
    /// Those of which something is true: of A, and of B.
    fn of(is_true: [bool; 2]) -> Option<Self> {
        match is_true {
            [true, true] => Some(Self::Both),
            [true, false] => Some(Self::A),
            [false, true] => Some(Self::B),
            [false, false] => None,
        }
    }
}
