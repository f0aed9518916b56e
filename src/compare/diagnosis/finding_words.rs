//! Findings in words.

use super::evidence::OTHER_COLOR;
use super::finding::{Finding, HighlightChange, Which};
use crate::compare::Area;
use std::fmt;

impl fmt::Display for Which {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::A => "A",
            Self::B => "B",
            Self::Both => "both",
        })
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Blank {
                picture: Which::Both,
            } => f.write_str("both pictures are blank: in each, all pixels have the same color"),
            Self::Blank { picture } => write!(
                f,
                "{picture} is blank: all pixels have the same color, so nothing was drawn in view"
            ),
            Self::Transparent {
                picture: Which::Both,
            } => f.write_str(
                "both pictures are transparent: their pixels have colors, but opacity 0, so nothing shows",
            ),
            Self::Transparent { picture } => write!(
                f,
                "{picture} is transparent, not blank: its pixels have colors, but opacity 0 (saved with the alpha of the frame buffer?)"
            ),
            Self::NearlySame {
                rounding,
                others,
                other_color,
                area,
                other_background,
            } => {
                if *other_background {
                    f.write_str("apart from the background, ")?;
                }
                fmt_nearly_same(f, *rounding, [*others, *other_color], *area)
            }
            Self::Shifted { dx, dy } => {
                write!(f, "B is A moved {}", moved(*dx, *dy))
            }
            Self::Mirrored {
                left_right,
                top_bottom,
            } => f.write_str(match (left_right, top_bottom) {
                (true, true) => "B is A turned by 180 degrees",
                (true, false) => "B is A mirrored: left and right are exchanged",
                _ => "B is A upside down: top and bottom are exchanged (rows in reverse order?)",
            }),
            Self::Placed {
                dx,
                dy,
                factor,
                degrees,
                unexplained,
            } => fmt_placed(f, (*dx, *dy), *factor, *degrees, *unexplained),
            Self::RedBlueExchanged => f.write_str("B has red and blue exchanged (BGR instead of RGB?)"),
            Self::Gray => f.write_str("B has no colors: it is A in shades of gray"),
            Self::Background { a, b, alone } => {
                let [a, b] = [a, b].map(|[r, g, b]| format!("({r}, {g}, {b})"));
                let rest = if *alone {
                    "; nothing else differs by more than 8"
                } else {
                    ""
                };
                write!(f, "the background differs: {a} in A, {b} in B{rest}")
            }
            Self::Axes { only_in, alone } => fmt_axes(f, *only_in, *alone),
            Self::Opacity { pixels } => write!(f, "{pixels} pixels differ in opacity"),
            Self::Brightness { factors } => fmt_brightness(f, *factors),
            Self::Gamma { lighter } => write!(
                f,
                "{lighter} was encoded as sRGB one more time than the other picture: it is lighter, with washed-out shadows"
            ),
            Self::Highlight {
                missing_in: Which::A,
                area,
            } => write!(
                f,
                "B has a highlight that A does not have, around {area}: the specular term of the light",
                area = area.in_words()
            ),
            Self::Highlight { missing_in, area } => write!(
                f,
                "a highlight is missing in {missing_in}, around {area}: the specular term of the light",
                area = area.in_words()
            ),
            Self::HighlightChanged { in_b, area } => {
                let [seen, from] = in_b.words();
                write!(f, "{seen}, around {}: {from}", area.in_words())
            }
            Self::Edges { share, area } => write!(
                f,
                "{:.1} % of the differences lie along edges, all within {area}: antialiasing, or a movement of less than about a pixel",
                100.0 * share,
                area = area.in_words()
            ),
            Self::Detail { max, area } => write!(
                f,
                "only fine detail differs, by at most {max}, within {area}: averaged over 16×16 pixels the colors agree, as after compression (JPEG), blurring, scaling or smoothing of edges",
                area = area.in_words()
            ),
            Self::Outline {
                only_a,
                area_a,
                only_b,
                area_b,
                everywhere,
            } => {
                fmt_outline(f, [(*only_a, *area_a), (*only_b, *area_b)])?;
                if *everywhere {
                    f.write_str(
                        ", in every part of the figure: another camera, or the whole figure moved or posed otherwise",
                    )?;
                }
                Ok(())
            }
            Self::Shading {
                share,
                area,
                outlines_agree,
                outlines_cross,
            } => {
                let (before, both) = if *outlines_agree {
                    ("the outlines agree, but ", "")
                } else {
                    ("", " in both")
                };
                let camera = if *outlines_cross {
                    "another camera, "
                } else {
                    ""
                };
                write!(
                    f,
                    "{before}{:.1} % of what is drawn{both} has a different color, within {area}: {camera}shape, depth or shading (normals, light, material)",
                    100.0 * share,
                    area = area.in_words()
                )
            }
        }
    }
}

impl HighlightChange {
    /// What is seen, and what it comes from.
    fn words(self) -> [&'static str; 2] {
        let strength = "strength or exponent of the specular term";
        let exponent = "the exponent of the specular term";
        match self {
            Self::Weaker => ["the highlight is weaker in B", strength],
            Self::Stronger => ["the highlight is stronger in B", strength],
            Self::Narrower => ["the highlight is narrower in B", exponent],
            Self::Wider => ["the highlight is wider in B", exponent],
            Self::Less => [
                "the highlight is weaker or narrower in B, or missing",
                strength,
            ],
            Self::More => [
                "the highlight is stronger or wider in B than in A, or A has none",
                strength,
            ],
        }
    }
}

fn fmt_axes(f: &mut fmt::Formatter<'_>, only_in: Which, alone: bool) -> fmt::Result {
    f.write_str(match only_in {
        Which::A => "A shows the axes, B does not",
        Which::B => "B shows the axes, A does not",
        Which::Both => "both show the axes",
    })?;
    if alone {
        f.write_str(": apart from them nothing differs")?;
    }
    f.write_str(" (View ⏵ Toggle Axis, T, or --axis)")
}

impl Finding {
    /// How A is placed in B in words, where it is elsewhere, in another size or turned, with what of it differs even so; `None` of
    /// another finding.
    pub(in crate::compare) fn placement(&self) -> Option<String> {
        match *self {
            Self::Shifted { dx, dy } => Some(format!("moved {}", moved(dx, dy))),
            Self::Placed {
                dx,
                dy,
                factor,
                degrees,
                unexplained,
            } => {
                let placed = placed((dx, dy), factor, degrees);
                Some(match unexplained {
                    0.0 => placed,
                    share => format!("{placed}, but for {:.0} % of it", 100.0 * share),
                })
            }
            _ => None,
        }
    }
}

fn moved(dx: i32, dy: i32) -> String {
    let part = |by: i32, forward: &str, backward: &str| {
        let direction = if by > 0 { forward } else { backward };
        (by != 0).then(|| {
            let unit = if by.abs() == 1 { "pixel" } else { "pixels" };
            format!("{} {unit} {direction}", by.abs())
        })
    };
    let parts = [part(dx, "right", "left"), part(dy, "down", "up")];
    parts
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join(" and ")
}

/// A movement, a scale and a turn in words, as far as there are any.
fn placed((dx, dy): (i32, i32), factor: f64, degrees: f64) -> String {
    let way = if degrees > 0.0 {
        "clockwise"
    } else {
        "counterclockwise"
    };
    let parts = [
        ((dx, dy) != (0, 0)).then(|| format!("moved {}", moved(dx, dy))),
        (factor != 1.0).then(|| format!("{factor:.3} times as large")),
        (degrees != 0.0).then(|| format!("turned {:.1} degrees {way}", degrees.abs())),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    parts.join(", ")
}

/// A figure elsewhere, of which a share is unexplained even so.
fn fmt_placed(
    f: &mut fmt::Formatter<'_>,
    by: (i32, i32),
    factor: f64,
    degrees: f64,
    unexplained: f64,
) -> fmt::Result {
    let placed = placed(by, factor, degrees);
    write!(f, "the whole figure is {placed} in B")?;
    if unexplained == 0.0 {
        f.write_str(": another camera, or another place or size of the shape")
    } else {
        write!(
            f,
            ", and {:.0} % of it differs even so: a camera in another direction, or another pose",
            100.0 * unexplained
        )
    }
}

fn fmt_brightness(f: &mut fmt::Formatter<'_>, factors: [f64; 3]) -> fmt::Result {
    let [r, g, b] = factors;
    let even = factors.iter().all(|factor| (factor - g).abs() < 0.02 * g);
    if even {
        write!(f, "what is drawn in B is {g:.3} times as bright as in A")
    } else {
        write!(
            f,
            "what is drawn in B has {r:.3}, {g:.3} and {b:.3} times the red, green and blue of A: a different color of light or material"
        )
    }
}

fn fmt_outline(f: &mut fmt::Formatter<'_>, parts: [(u64, Option<Area>); 2]) -> fmt::Result {
    let parts = parts.iter().zip([Which::A, Which::B]);
    let parts = parts.filter_map(|((pixels, area), which)| {
        let are = if *pixels == 1 {
            "pixel is"
        } else {
            "pixels are"
        };
        area.map(|area| {
            let area = area.in_words();
            format!("{pixels} {are} drawn only in {which}, within {area}")
        })
    });
    f.write_str(&parts.collect::<Vec<_>>().join("; "))
}

/// `others` pixels differ by more than `rounding`, and so many of them by more than 8.
fn fmt_nearly_same(
    f: &mut fmt::Formatter<'_>,
    rounding: u8,
    [others, other_color]: [u64; 2],
    area: Option<Area>,
) -> fmt::Result {
    let pixels = |count: u64| match count {
        1 => "1 pixel".to_owned(),
        _ => format!("{count} pixels"),
    };
    let differ = if others == 1 { "differs" } else { "differ" };
    if rounding > 0 {
        write!(
            f,
            "the pictures are the same except for rounding (at most {rounding} of 255)"
        )?;
    }
    let Some(area) = area else {
        return Ok(());
    };
    match (rounding, other_color) {
        (0, _) => write!(f, "the pictures are the same except for {}", pixels(others))?,
        (_, 0) => write!(
            f,
            " and {} that {differ} by more, up to {OTHER_COLOR}",
            pixels(others)
        )?,
        _ if other_color == others => {
            write!(
                f,
                " and {} that {differ} by more than {OTHER_COLOR}",
                pixels(others)
            )?;
        }
        _ => write!(
            f,
            " and {} that {differ} by more, {other_color} of them by more than {OTHER_COLOR}",
            pixels(others)
        )?,
    }
    write!(f, ", within {}", area.in_words())
}
