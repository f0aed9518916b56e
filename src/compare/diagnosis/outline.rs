use super::Finding;
use super::evidence::{Evidence, FEWEST_PIXELS, Outline, UNEXPLAINED_ONE_IN, count, different};
use crate::compare::{Area, Pair};
use std::ops::Range;

/// Every movement up to this many pixels is tried; farther ones where the outlines suggest it.
const FARTHEST: i32 = 8;
/// A movement may spoil one of the pixels that agree without it for this many that it explains:
/// more would be things that stayed where they were.
const SPOILED_ONE_IN: u64 = 100;
/// Movements are tried on every row of so many first.
const ROW_STEP: u32 = 16;
/// Share of the figure below which a ninth of the area round it has no part of it worth the name.
const LEAST_PART: f64 = 0.02;
/// Share of each part of a figure of which the outline must differ to differ everywhere.
const EVERYWHERE: f64 = 0.04;
/// Shading differs if it does so in more than this share of the drawn pixels.
const LEAST_SHADING: f64 = 0.001;

/// A mirrored, if that is B.
pub(super) async fn mirrored(evidence: &Evidence<'_>) -> Option<Finding> {
    let direct = enough_to_move(evidence)?;
    let inside = whole(evidence.pair());
    let mut found = Vec::new();
    for (left_right, top_bottom) in [(true, false), (false, true), (true, true)] {
        let movement = Movement::Mirrored {
            left_right,
            top_bottom,
        };
        let unexplained = unexplained_by(evidence, inside, direct, movement).await;
        let finding = Finding::Mirrored {
            left_right,
            top_bottom,
        };
        found.extend(unexplained.map(|unexplained| (unexplained, finding)));
    }
    let least = found
        .into_iter()
        .min_by_key(|(unexplained, _)| *unexplained);
    least.map(|(_, finding)| finding)
}

/// A movement by whole pixels that makes A into B: the one that explains the most, the nearest
/// of equals.
pub(super) async fn shifted(evidence: &Evidence<'_>) -> Option<Finding> {
    let pair = evidence.pair();
    let direct = enough_to_move(evidence)?;
    let [drawn_a, drawn_b] = match evidence.drawn_masks().await {
        Some([a, b]) => [evidence.area_of(a)?, evidence.area_of(b)?],
        None => [whole(pair); 2],
    };
    let nearby =
        (-FARTHEST..=FARTHEST).flat_map(|dy| (-FARTHEST..=FARTHEST).map(move |dx| (dx, dy)));
    let suggested = suggested_moves(drawn_a, drawn_b);
    let inside = united(drawn_a, drawn_b);
    let movements = nearby
        .chain(suggested)
        .filter(|&by| by != (0, 0) && keeps_half_in_view(pair, drawn_a, by));
    let mut found = Vec::new();
    for (dx, dy) in movements {
        let movement = Movement::Shifted { dx, dy };
        let unexplained = unexplained_by(evidence, inside, direct, movement).await;
        found.extend(unexplained.map(|unexplained| (unexplained, dx * dx + dy * dy, (dx, dy))));
    }
    let best = found.into_iter().min();
    best.map(|(_, _, (dx, dy))| Finding::Shifted { dx, dy })
}

/// What is drawn in one picture alone.
pub(super) async fn outline(evidence: &Evidence<'_>) -> Option<Finding> {
    let Outline { only, areas } = evidence.outline().await?;
    Some(Finding::Outline {
        only_a: only[0],
        area_a: areas[0],
        only_b: only[1],
        area_b: areas[1],
        everywhere: differs_everywhere(evidence).await.unwrap_or(false),
    })
}

/// Whether the outlines differ in each ninth of the figure that has a part of it worth the name.
async fn differs_everywhere(evidence: &Evidence<'_>) -> Option<bool> {
    let [drawn_a, drawn_b] = evidence.drawn_masks().await?;
    let pair = evidence.pair();
    let figure = pair.paced_figure(evidence.pace).await?;
    let ninth = |index: usize| {
        let place = |at: usize, first: u32, length: u32| {
            let along = at.checked_sub(first as usize)?;
            Some(3 * along / length as usize).filter(|third| *third < 3)
        };
        let width = pair.width() as usize;
        let column = place(index % width, figure.x, figure.width)?;
        Some(3 * place(index / width, figure.y, figure.height)? + column)
    };
    let mut counts = [[0_u32; 2]; 9];
    evidence
        .pace
        .bands(drawn_a.len(), |band| {
            for index in band {
                let (a, b) = (drawn_a[index], drawn_b[index]);
                if let Some(ninth) = ninth(index).filter(|_| a || b) {
                    counts[ninth][0] += 1;
                    counts[ninth][1] += u32::from(a != b);
                }
            }
        })
        .await;
    let drawn: u32 = counts.iter().map(|[drawn, _]| drawn).sum();
    let mut parts = counts.iter();
    Some(parts.all(|&[part, differing]| {
        let is_little = f64::from(part) < LEAST_PART * f64::from(drawn);
        is_little || f64::from(differing) >= EVERYWHERE * f64::from(part)
    }))
}

/// Different colors of what is drawn. Where the outlines differ, more pixels than theirs must
/// have another color among those drawn in both.
pub(super) async fn shading(evidence: &Evidence<'_>) -> Option<Finding> {
    let [drawn_a, drawn_b] = evidence.drawn_masks().await?;
    let outline = evidence.outline().await;
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
    evidence.pace.after(differs.len()).await;
    let share = differing as f64 / count(&drawn) as f64;
    if differing <= outline.map_or(0, Outline::pixels) || share <= LEAST_SHADING {
        return None;
    }
    let area = evidence.area_of(&differs)?;
    Some(Finding::Shading {
        share,
        area,
        outlines_agree,
        outlines_cross: outline.is_some_and(|outline| outline.only.iter().all(|&only| only > 0)),
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

/// What makes A into B.
#[derive(Clone, Copy)]
enum Movement {
    /// By so many pixels to the right and down.
    Shifted {
        dx: i32,
        dy: i32,
    },
    Mirrored {
        left_right: bool,
        top_bottom: bool,
    },
}

impl Movement {
    /// The places in A from which the pixels of B's row `y` come, for the part of the columns
    /// `first..end` that have one: its first column in B, and its range in A, from the right to
    /// the left where A is mirrored.
    fn row_in_a(
        self,
        (width, height): (u32, u32),
        y: u32,
        (first, end): (u32, u32),
    ) -> Option<(u32, Range<usize>)> {
        let (first, from_x, length, from_y) = match self {
            Self::Shifted { dx, dy } => {
                let first = i64::from(first).max(dx.into());
                let end = i64::from(end).min(i64::from(width) + i64::from(dx));
                let length = u32::try_from(end - first).ok()?;
                let from_x = u32::try_from(first - i64::from(dx)).ok()?;
                let from_y = y.checked_add_signed(-dy).filter(|&y| y < height)?;
                (u32::try_from(first).ok()?, from_x, length, from_y)
            }
            Self::Mirrored {
                left_right,
                top_bottom,
            } => {
                let from_x = if left_right { width - end } else { first };
                let from_y = if top_bottom { height - 1 - y } else { y };
                (first, from_x, end - first, from_y)
            }
        };
        let start = from_y as usize * width as usize + from_x as usize;
        Some((first, start..start + length as usize))
    }
}

/// Number of pixels of B within `inside` that have a different color than A where `movement` has
/// them from; `None` if they are too many for this to explain `direct` pixels of different color.
/// Pixels without a place in A, or with an ignored one, are left out.
async fn unexplained_by(
    evidence: &Evidence<'_>,
    inside: Area,
    direct: u64,
    movement: Movement,
) -> Option<u64> {
    let pair = evidence.pair();
    let size = (pair.width(), pair.height());
    let turns_round = matches!(
        movement,
        Movement::Mirrored {
            left_right: true,
            ..
        }
    );
    let (mut row_of_a, mut kept_of_a) = (Vec::new(), Vec::new());
    let (mut unexplained, mut spoiled) = (0, 0);
    // Too many are found early in rows from everywhere, which the order does not change.
    let rows = (0..ROW_STEP).flat_map(|first| (first..inside.height).step_by(ROW_STEP as usize));
    for y in rows.map(|row| inside.y + row) {
        let columns = (inside.x, inside.x + inside.width);
        let Some((first, from)) = movement.row_in_a(size, y, columns) else {
            continue;
        };
        let start = y as usize * size.0 as usize + first as usize;
        let to = start..start + from.len();
        let (mut a, mut kept) = (&pair.a()[from.clone()], &pair.kept()[from]);
        if turns_round {
            row_of_a.clear();
            row_of_a.extend(a.iter().rev());
            kept_of_a.clear();
            kept_of_a.extend(kept.iter().rev());
            (a, kept) = (&row_of_a, &kept_of_a);
        }
        let differs = different(a, &pair.b()[to.clone()]);
        let kept = kept.iter().zip(&pair.kept()[to.clone()]);
        let pixels = differs.iter().zip(kept).zip(&evidence.other_colors()[to]);
        let (mut in_row, mut spoiled_in_row) = (0_u32, 0_u32);
        for ((&differs, (&one, &other)), &differed) in pixels {
            let counts = differs & one & other;
            in_row += u32::from(counts);
            spoiled_in_row += u32::from(counts & !differed);
        }
        unexplained += u64::from(in_row);
        spoiled += u64::from(spoiled_in_row);
        if unexplained > direct / UNEXPLAINED_ONE_IN || spoiled > direct / SPOILED_ONE_IN {
            return None;
        }
        evidence.pace.after(differs.len()).await;
    }
    Some(unexplained)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::diagnosis::evidence::OTHER_COLOR;
    use crate::compare::differences::difference;
    use crate::compare::test_pictures::noise;
    use crate::steps::{Pace, at_once};

    /// The same pixel by pixel, without an early end.
    fn pixel_by_pixel(
        evidence: &Evidence,
        inside: Area,
        direct: u64,
        place_in_a: impl Fn(i32, i32) -> (i32, i32),
    ) -> Option<u64> {
        let pair = evidence.pair();
        let (width, height) = (pair.width() as i32, pair.height() as i32);
        let (mut unexplained, mut spoiled) = (0, 0);
        for y in inside.y as i32..(inside.y + inside.height) as i32 {
            for x in inside.x as i32..(inside.x + inside.width) as i32 {
                let (from_x, from_y) = place_in_a(x, y);
                if !(0..width).contains(&from_x) || !(0..height).contains(&from_y) {
                    continue;
                }
                let (from, to) = ((from_y * width + from_x) as usize, (y * width + x) as usize);
                let (a, b) = (pair.a(), pair.b());
                if pair.kept()[from] && pair.kept()[to] && difference(a[from], b[to]) > OTHER_COLOR
                {
                    unexplained += 1;
                    spoiled += u64::from(difference(a[to], b[to]) <= OTHER_COLOR);
                }
            }
        }
        let few = unexplained <= direct / UNEXPLAINED_ONE_IN;
        (few && spoiled <= direct / SPOILED_ONE_IN).then_some(unexplained)
    }

    #[test]
    fn row_by_row_a_movement_leaves_as_much_unexplained_as_pixel_by_pixel() {
        let [a, b] = [1, 2].map(|seed| noise(37, 41, 0..=20, seed));
        let ignore = ["3,5,9,4", "30,30,99,99"].map(|area| area.parse().unwrap());
        let pair = Pair::new(&a, &b, &ignore).unwrap();
        let pace = Pace::new(usize::MAX);
        let evidence = at_once(|_| Evidence::new(&pair, &pace));
        let (right, bottom) = (36, 40);
        let part: Area = "4,2,30,33".parse().unwrap();
        let mut found = [0, 0];
        for direct in [100, 1_000, 5_000, 20_000, 200_000] {
            let mut same = |inside, movement, expected: Option<u64>| {
                let unexplained = at_once(|_| unexplained_by(&evidence, inside, direct, movement));
                assert_eq!(unexplained, expected);
                found[usize::from(expected.is_some())] += 1;
            };
            for (dx, dy) in [
                (1, 0),
                (-3, 2),
                (8, -8),
                (36, 40),
                (-37, 0),
                (0, 60),
                (-60, 1),
            ] {
                let place = |x, y| (x - dx, y - dy);
                for inside in [whole(&pair), part] {
                    let expected = pixel_by_pixel(&evidence, inside, direct, place);
                    same(inside, Movement::Shifted { dx, dy }, expected);
                }
            }
            for (left_right, top_bottom) in [(true, false), (false, true), (true, true)] {
                let place = |x, y| {
                    let x = if left_right { right - x } else { x };
                    (x, if top_bottom { bottom - y } else { y })
                };
                let movement = Movement::Mirrored {
                    left_right,
                    top_bottom,
                };
                for inside in [whole(&pair), part] {
                    let expected = pixel_by_pixel(&evidence, inside, direct, place);
                    same(inside, movement, expected);
                }
            }
        }
        assert!(found[0] > 20 && found[1] > 20, "both answers: {found:?}");
    }
}
