//! Points of what nothing explains, by how near its vertices are.

use super::graded::Graded;
use super::shares::share_left;
use crate::diagnose::UNSEEN;
use crate::io::{RIGHT_BUT_FOR_FEW, RIGHT_BUT_FOR_LITTLE, RubricData, TestData, TestKind};
use std::ops::Range;

/// How many times that far off a mesh is that is not near the exact one.
pub(super) const FAR_OFF: f64 = 10.0;
/// What vertices count for from which on they are nearly all right.
const NEARLY_ALL: Range<f64> = 0.9..0.99;

/// The share of its points that what is unexplained gives by how near its vertices are alone. A mesh with nearly all
/// vertices right, or with none far off, has the more the nearer it is to one that is right but for few, or but for little:
/// no vertex more or less makes much of a difference.
pub(super) fn by_vertices(test: &TestData, graded: &Graded, rubric: &RubricData) -> f64 {
    let unexplained = rubric.unexplained.0;
    let share = unexplained * graded.near;
    if test.kind != TestKind::Mesh {
        return share;
    }
    let [few, little] =
        [RIGHT_BUT_FOR_FEW, RIGHT_BUT_FOR_LITTLE].map(|id| share_left(id, graded, rubric));
    let by_few = by_nearly_all(unexplained * NEARLY_ALL.start, few, graded.near);
    let off = graded.error.unwrap_or(f64::INFINITY) / UNSEEN;
    let by_little = lerp(little, share, off.ln() / FAR_OFF.ln());
    let nearly_all = (graded.near > NEARLY_ALL.start).then_some(by_few);
    let near_all = (off < FAR_OFF).then_some(by_little);
    nearly_all.into_iter().chain(near_all).fold(share, f64::max)
}

/// The share of a mesh whose vertices count for so much: the nearer it is to one that is right but for few, the more of what
/// that leaves it has, and no vertex more or less makes much of a difference.
pub(super) fn by_nearly_all(otherwise: f64, few: f64, near: f64) -> f64 {
    let all = (near - NEARLY_ALL.start) / (NEARLY_ALL.end - NEARLY_ALL.start);
    lerp(otherwise, few, all)
}

/// What lies between `from` and `to`, at 0 and below and at 1 and above.
fn lerp(from: f64, to: f64, at: f64) -> f64 {
    from + (to - from) * at.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::graded::Outcome;
    use crate::grade::rubric::points;
    use crate::grade::rubric::tests::{TWO, test};
    use crate::grade::why::why;

    #[test]
    fn no_vertex_more_or_less_makes_much_of_a_difference_where_nearly_all_are_right() {
        let rubric = RubricData::default();
        let sections = &[("3.2", 10.0), ("3.4", 20.0), ("4.2", 30.0)];
        let total = |near: f64, error: f64| {
            let mut graded = Graded {
                agrees: near,
                near,
                error: Some(error),
                ..Graded::without(Outcome::Unexplained, "")
            };
            if near >= 0.99 {
                graded.nearly.push(RIGHT_BUT_FOR_FEW.to_owned());
            }
            if error <= 0.001 {
                graded.nearly.push(RIGHT_BUT_FOR_LITTLE.to_owned());
            }
            points(&test(sections), &graded, &rubric)
                .values()
                .sum::<f64>()
        };
        let by_count: Vec<f64> = (0..=1000)
            .map(|of| total(f64::from(of) / 1000.0, 0.5))
            .collect();
        let by_distance: Vec<f64> = (0..=1000)
            .map(|step| total(0.4, 1e-4 * 1e3_f64.powf(f64::from(step) / 1000.0)))
            .rev()
            .collect();
        for points in [by_count, by_distance] {
            assert!(points.is_sorted(), "nearer is never less");
            let steps = points.windows(2).map(|pair| pair[1] - pair[0]);
            assert!(steps.fold(0.0, f64::max) < 4.0);
        }
        assert_eq!(total(0.9, 0.5), 27.0);
        assert_eq!(total(0.0, 0.5), 0.0);
        let told = Graded {
            agrees: 0.95,
            near: 0.96,
            error: Some(0.5),
            ..Graded::without(Outcome::Unexplained, "")
        };
        let text = "what no known mistake explains leaves 75 %, so near is it to the exact result: 95 % of the vertices are right";
        assert_eq!(why(&test(TWO), &told, &rubric), [text]);
    }
}
