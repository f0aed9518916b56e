use super::Finding;
use super::evidence::{Evidence, FEWEST_PIXELS, OTHER_COLOR, Outline, UNEXPLAINED_ONE_IN, count};
use crate::compare::differences::difference;
use crate::compare::{Area, Pair};

/// Every movement up to this many pixels is tried; farther ones where the outlines suggest it.
const FARTHEST: i32 = 8;
/// A movement may spoil one of the pixels that agree without it for this many that it explains:
/// more would be things that stayed where they were.
const SPOILED_ONE_IN: u64 = 100;
/// Outlines of another size agree if they differ in no more than this share of their pixels.
const SCALED_SLACK: f64 = 0.02;
/// Shading differs if it does so in more than this share of the drawn pixels.
const LEAST_SHADING: f64 = 0.001;

/// A mirrored, if that is B.
pub(super) fn mirrored(evidence: &Evidence) -> Option<Finding> {
    let pair = evidence.pair();
    let direct = enough_to_move(evidence)?;
    let [right, bottom] = [pair.width() - 1, pair.height() - 1];
    [(true, false), (false, true), (true, true)]
        .into_iter()
        .filter_map(|(left_right, top_bottom)| {
            let place_in_a = |x: u32, y: u32| {
                let x = if left_right { right - x } else { x };
                let y = if top_bottom { bottom - y } else { y };
                Some((x, y))
            };
            let unexplained = unexplained_by(pair, whole(pair), direct, place_in_a)?;
            let finding = Finding::Mirrored {
                left_right,
                top_bottom,
            };
            Some((unexplained, finding))
        })
        .min_by_key(|(unexplained, _)| *unexplained)
        .map(|(_, finding)| finding)
}

/// A movement by whole pixels that makes A into B: the one that explains the most, the nearest
/// of equals.
pub(super) fn shifted(evidence: &Evidence) -> Option<Finding> {
    let pair = evidence.pair();
    let direct = enough_to_move(evidence)?;
    let [drawn_a, drawn_b] = match evidence.drawn_masks() {
        Some([a, b]) => [evidence.area_of(a)?, evidence.area_of(b)?],
        None => [whole(pair); 2],
    };
    let nearby =
        (-FARTHEST..=FARTHEST).flat_map(|dy| (-FARTHEST..=FARTHEST).map(move |dx| (dx, dy)));
    let suggested = suggested_moves(drawn_a, drawn_b);
    let inside = united(drawn_a, drawn_b);
    nearby
        .chain(suggested)
        .filter(|&by| by != (0, 0) && keeps_half_in_view(pair, drawn_a, by))
        .filter_map(|(dx, dy)| {
            let place_in_a =
                |x: u32, y: u32| Some((x.checked_add_signed(-dx)?, y.checked_add_signed(-dy)?));
            let unexplained = unexplained_by(pair, inside, direct, place_in_a)?;
            Some((unexplained, dx * dx + dy * dy, (dx, dy)))
        })
        .min()
        .map(|(_, _, (dx, dy))| Finding::Shifted { dx, dy })
}

/// A's outline in another size.
pub(super) fn scaled(evidence: &Evidence) -> Option<Finding> {
    let pair = evidence.pair();
    let [drawn_a, drawn_b] = evidence.drawn_masks()?;
    let [area_a, area_b] = [evidence.area_of(drawn_a)?, evidence.area_of(drawn_b)?];
    if touches_border(pair, area_a) || touches_border(pair, area_b) {
        return None;
    }
    let ratio = |b: u32, a: u32| f64::from(b) / f64::from(a);
    let factors = [
        ratio(area_b.width, area_a.width),
        ratio(area_b.height, area_a.height),
    ];
    // Steadier than the sides, which are off by up to a pixel each.
    let factor = (count(drawn_b) as f64 / count(drawn_a) as f64).sqrt();
    let rounding = 2.0 / f64::from(area_a.width.min(area_a.height));
    if (factors[0] - factors[1]).abs() > 0.01 + rounding || (factor - 1.0).abs() < 0.02 {
        return None;
    }
    let width = pair.width() as usize;
    let (mut differing, mut drawn) = (0_u32, 0_u32);
    for y in 0..area_b.height {
        for x in 0..area_b.width {
            let in_b = (area_b.y + y) as usize * width + (area_b.x + x) as usize;
            let scaled = |place: u32, factor: f64| ((f64::from(place) + 0.5) / factor) as u32;
            let from_x = area_a.x + scaled(x, factors[0]).min(area_a.width - 1);
            let from_y = area_a.y + scaled(y, factors[1]).min(area_a.height - 1);
            let in_a = from_y as usize * width + from_x as usize;
            drawn += u32::from(drawn_b[in_b]);
            differing += u32::from(drawn_b[in_b] != drawn_a[in_a]);
        }
    }
    (f64::from(differing) <= SCALED_SLACK * f64::from(drawn)).then_some(Finding::Scaled { factor })
}

/// What is drawn in one picture alone.
pub(super) fn outline(evidence: &Evidence) -> Option<Finding> {
    let Outline { only, areas } = evidence.outline()?;
    Some(Finding::Outline {
        only_a: only[0],
        area_a: areas[0],
        only_b: only[1],
        area_b: areas[1],
    })
}

/// Different colors of what is drawn. Where the outlines differ, more pixels than theirs must
/// have another color among those drawn in both.
pub(super) fn shading(evidence: &Evidence) -> Option<Finding> {
    let [drawn_a, drawn_b] = evidence.drawn_masks()?;
    let outline = evidence.outline();
    let outlines_agree = outline.is_none();
    let drawn: Vec<bool> = drawn_a
        .iter()
        .zip(drawn_b)
        .map(|(&in_a, &in_b)| in_a && in_b || outlines_agree && (in_a || in_b))
        .collect();
    let differs: Vec<bool> = evidence
        .other_colors()
        .iter()
        .zip(&drawn)
        .map(|(&differs, &drawn)| differs && drawn)
        .collect();
    let differing = count(&differs);
    let share = differing as f64 / count(&drawn) as f64;
    if differing <= outline.map_or(0, Outline::pixels) || share <= LEAST_SHADING {
        return None;
    }
    let area = evidence.area_of(&differs)?;
    Some(Finding::Shading {
        share,
        area,
        outlines_agree,
    })
}

/// Number of pixels of different color, if they are enough to tell a movement.
fn enough_to_move(evidence: &Evidence) -> Option<u64> {
    let direct = evidence.pixels_of_other_color();
    (direct >= FEWEST_PIXELS).then_some(direct)
}

/// Whether at least half of the area stays within the picture when moved.
fn keeps_half_in_view(pair: &Pair, area: Area, (dx, dy): (i32, i32)) -> bool {
    let left = |start: u32, length: u32, by: i32, size: u32| {
        let first = (i64::from(start) + i64::from(by)).max(0);
        let end = (i64::from(start) + i64::from(length) + i64::from(by)).min(size.into());
        2 * (end - first) >= i64::from(length)
    };
    left(area.x, area.width, dx, pair.width()) && left(area.y, area.height, dy, pair.height())
}

/// Number of pixels of B within `inside` that have a different color than A at `place_in_a`;
/// `None` if they are too many for this to explain `direct` pixels of different color. Pixels
/// without a place in A, or with an ignored one, are left out.
fn unexplained_by(
    pair: &Pair,
    inside: Area,
    direct: u64,
    place_in_a: impl Fn(u32, u32) -> Option<(u32, u32)>,
) -> Option<u64> {
    let (width, height) = (pair.width(), pair.height());
    let index = |x: u32, y: u32| y as usize * width as usize + x as usize;
    let (mut unexplained, mut spoiled) = (0, 0);
    for y in inside.y..inside.y + inside.height {
        for x in inside.x..inside.x + inside.width {
            let Some((from_x, from_y)) = place_in_a(x, y) else {
                continue;
            };
            if from_x >= width || from_y >= height {
                continue;
            }
            let (from, to) = (index(from_x, from_y), index(x, y));
            let counts = pair.kept()[from] && pair.kept()[to];
            if counts && difference(pair.a()[from], pair.b()[to]) > OTHER_COLOR {
                unexplained += 1;
                spoiled += u64::from(difference(pair.a()[to], pair.b()[to]) <= OTHER_COLOR);
                if unexplained > direct / UNEXPLAINED_ONE_IN || spoiled > direct / SPOILED_ONE_IN {
                    return None;
                }
            }
        }
    }
    Some(unexplained)
}

fn touches_border(pair: &Pair, area: Area) -> bool {
    area.x == 0
        || area.y == 0
        || area.x + area.width == pair.width()
        || area.y + area.height == pair.height()
}

fn whole(pair: &Pair) -> Area {
    Area {
        x: 0,
        y: 0,
        width: pair.width(),
        height: pair.height(),
    }
}

/// Movements that bring corners of the areas together.
fn suggested_moves(a: Area, b: Area) -> impl Iterator<Item = (i32, i32)> {
    let by = |a: u32, b: u32| b as i32 - a as i32;
    let across = [by(a.x, b.x), by(a.x + a.width, b.x + b.width)];
    let down = [by(a.y, b.y), by(a.y + a.height, b.y + b.height)];
    across
        .into_iter()
        .flat_map(move |dx| down.map(|dy| (dx, dy)))
}

/// The smallest area around both.
fn united(a: Area, b: Area) -> Area {
    let corners = [a, b].map(|area| {
        [
            (area.x, area.y),
            (area.x + area.width - 1, area.y + area.height - 1),
        ]
    });
    Area::around(corners.into_iter().flatten()).unwrap_or(a)
}
