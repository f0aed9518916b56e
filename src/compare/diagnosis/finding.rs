use crate::compare::Area;
use crate::compare::rules::sentence;
use serde::Serialize;

/// A cause of differences between two pictures. B is compared with the reference A.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Finding {
    /// All pixels of one picture (or of each) have the same color: nothing was drawn.
    Blank {
        /// Which.
        picture: Which,
    },
    /// All pixels of one picture (or of each) have opacity 0, though their colors differ.
    Transparent {
        /// Which.
        picture: Which,
    },
    /// Rounding, and so few other pixels that they give no clue.
    NearlySame {
        /// Largest difference that may be rounding: 0 to 3 of 255.
        rounding: u8,
        /// Pixels that differ by more.
        others: u64,
        /// Of these, pixels that differ by more than 8 of 255.
        other_color: u64,
        /// Where the others are.
        area: Option<Area>,
        /// Whether the backgrounds differ as well, which is a finding of its own.
        other_background: bool,
    },
    /// B is A moved by whole pixels.
    Shifted {
        /// To the right.
        dx: i32,
        /// Downward.
        dy: i32,
    },
    /// B is A mirrored.
    Mirrored {
        /// Left and right are exchanged.
        left_right: bool,
        /// Top and bottom are exchanged.
        top_bottom: bool,
    },
    /// What is drawn in B has A's outline elsewhere in the picture, in another size or turned.
    Placed {
        /// By how many pixels its middle is farther to the right.
        dx: i32,
        /// By how many it is farther down.
        dy: i32,
        /// Size in B by size in A.
        factor: f64,
        /// By how much it is turned, clockwise as it is seen.
        degrees: f64,
        /// Share of what is drawn whose outlines differ even so; 0 if that is next to nothing.
        unexplained: f64,
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
    /// The axes are drawn in one picture alone.
    Axes {
        /// Which.
        only_in: Which,
        /// Whether nothing else differs.
        alone: bool,
    },
    /// Pixels differ in opacity.
    Opacity {
        /// Number of pixels.
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
    /// A highlight differs in B: the difference is white light that fades toward its rim.
    HighlightChanged {
        /// Change from A to B.
        in_b: HighlightChange,
        /// Where it differs.
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
        /// Whether that is so in every part of the figure.
        everywhere: bool,
    },
    /// What is drawn has a different color in B.
    Shading {
        /// Pixels that differ by more than 8 of 255, by all that are drawn: in both, unless the
        /// outlines agree.
        share: f64,
        /// Where these are.
        area: Area,
        /// Whether next to nothing is drawn in one picture alone. Otherwise that is a finding of its
        /// own.
        outlines_agree: bool,
        /// Whether something is drawn in each picture alone, so that another camera may be all that
        /// differs.
        outlines_cross: bool,
    },
}

/// Change of a highlight from A to B.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HighlightChange {
    /// Less bright, but present in B.
    Weaker,
    /// Brighter, and present in A.
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
    /// The picture compared with it.
    B,
    /// Each of them.
    Both,
}

impl Finding {
    /// Its text as a sentence, with a capital letter and a full stop.
    pub fn sentence(&self) -> String {
        sentence(&self.to_string())
    }

    /// Whether its words say that it is in every part of the figure.
    pub fn is_everywhere(&self) -> bool {
        matches!(
            self,
            Self::Outline {
                everywhere: true,
                ..
            }
        )
    }

    /// Whether it only says what differs, in whichever places, and not why.
    pub fn is_without_cause(&self) -> bool {
        match self {
            Self::Outline { everywhere, .. } => !everywhere,
            Self::Shading { .. } => true,
            _ => false,
        }
    }

    /// Whether something else differs as well, of which it says nothing.
    pub fn is_beside_others(&self) -> bool {
        matches!(
            self,
            Self::Background { alone: false, .. } | Self::Axes { alone: false, .. }
        )
    }

    /// The same without the camera as a possible cause, where it is known whether both pictures have one.
    #[must_use]
    pub fn without_camera(mut self) -> Self {
        match &mut self {
            Self::Outline { everywhere, .. } => *everywhere = false,
            Self::Shading { outlines_cross, .. } => *outlines_cross = false,
            _ => {}
        }
        self
    }

    /// Where it shows: the area round all of it, unless it is about the pictures as a whole.
    pub fn area(&self) -> Option<Area> {
        match *self {
            // What is as good as the same is nowhere in particular.
            Self::NearlySame { .. } => None,
            Self::Highlight { area, .. }
            | Self::HighlightChanged { area, .. }
            | Self::Edges { area, .. }
            | Self::Detail { area, .. }
            | Self::Shading { area, .. } => Some(area),
            Self::Outline { area_a, area_b, .. } => {
                let areas = || area_a.into_iter().chain(area_b);
                let corners = areas().flat_map(|area| {
                    let last = (area.x + area.width - 1, area.y + area.height - 1);
                    [(area.x, area.y), last]
                });
                Area::around(corners)
            }
            Self::Blank { .. }
            | Self::Transparent { .. }
            | Self::Shifted { .. }
            | Self::Mirrored { .. }
            | Self::Placed { .. }
            | Self::RedBlueExchanged
            | Self::Gray
            | Self::Background { .. }
            | Self::Axes { .. }
            | Self::Opacity { .. }
            | Self::Brightness { .. }
            | Self::Gamma { .. } => None,
        }
    }
}

impl Which {
    /// Those of which something is true: of A, and of B.
    pub(super) fn of(is_true: [bool; 2]) -> Option<Self> {
        match is_true {
            [true, true] => Some(Self::Both),
            [true, false] => Some(Self::A),
            [false, true] => Some(Self::B),
            [false, false] => None,
        }
    }
}
