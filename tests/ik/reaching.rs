//! What can be reached is reached, what cannot is pointed at, however things lie.

use crate::ik::chains::{Row, direction, frames, reach, row, vector};
use editor_core::character::ik::IkGoal;
use glam::Vec3;
use proptest::prelude::*;

/// Of the chain's length.
const EXACT: f32 = 1e-5;

fn goal(target: Vec3, pole: Option<Vec3>) -> IkGoal {
    IkGoal {
        pole,
        ..IkGoal::to(target)
    }
}

fn check(row: &Row, length: usize, goal: &IkGoal) -> Result<(), TestCaseError> {
    let Some(chain) = row.chain_of(length) else {
        return Ok(());
    };
    let first = chain.joints()[0];
    let base = row.point(&row.pose, first);
    let lengths = row.lengths(first);
    let (least, total) = reach(&lengths);
    let solution = chain.solve(&row.skeleton, &row.pose, goal);
    let solution = solution.expect("a finite goal has an answer");

    let end = row.end(&solution.pose);
    prop_assert!(end.is_finite());
    let (wanted, got) = (goal.target - base, end - base);
    let distance = wanted.length();
    let off = (got.length() - distance.clamp(least, total)).abs();
    prop_assert!(off < EXACT * total + 1e-6, "{off} of {total}");
    if (least..=total).contains(&distance) {
        let off = end.distance(goal.target);
        prop_assert!(off < EXACT * total + 2e-6, "{off} from the target");
    } else if distance > 1e-3 * total {
        let across = got.reject_from(wanted).length();
        prop_assert!(across < EXACT * total + 2e-6, "{across} beside the line");
        prop_assert!(got.dot(wanted) >= -1e-5, "turned away");
    }
    let off = end.distance(goal.target);
    prop_assert!((solution.off - off).abs() < EXACT * (total + distance) + 1e-5);

    let (before, after) = (
        frames(&row.skeleton, &row.pose),
        frames(&row.skeleton, &solution.pose),
    );
    for joint in 0..=first {
        let moved = (before[joint].w_axis - after[joint].w_axis).length();
        prop_assert!(moved < 1e-6, "joint {joint} moved by {moved}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1500) })]

    #[test]
    fn a_target_is_reached_or_pointed_at(
        row in row(1..=6),
        length in 1_usize..=6,
        target in vector(12.0),
        pole in direction(),
    ) {
        check(&row, length, &goal(target, pole))?;
    }

    #[test]
    fn what_another_pose_reaches_this_one_reaches(
        row in row(1..=5),
        angles in prop::collection::vec(vector(180.0), 5),
        pole in direction(),
    ) {
        let other = Row::new(Vec3::ZERO, &[Vec3::Y; 5], &angles);
        let target = row.end(&other.pose);
        // The first joint may not stand where it stood.
        check(&row, usize::MAX, &goal(target, pole))?;
    }

    #[test]
    fn nothing_is_lost_where_target_first_joint_and_pole_line_up(
        row in row(1..=5),
        along in prop::sample::select(vec![-3.0_f32, -1.0, -0.5, -1e-4, 0.0, 1e-4, 0.5, 1.0, 3.0]),
        reversed in any::<bool>(),
    ) {
        let base = row.point(&row.pose, 0);
        let line = row.end(&row.pose) - base;
        let pole = if reversed { -line } else { line };
        check(&row, usize::MAX, &goal(base + along * line, Some(pole)))?;
        check(&row, usize::MAX, &goal(base + along * line, None))?;
        check(&row, usize::MAX, &goal(base + along * line, Some(Vec3::ZERO)))?;
    }

    #[test]
    fn a_straight_chain_bends_and_straightens(
        lengths in prop::collection::vec(0.1_f32..2.0, 2..=6),
        part in 0.0_f32..=1.2,
        turn in vector(180.0),
        target in vector(1.0),
    ) {
        let bones: Vec<Vec3> = lengths.iter().map(|&length| Vec3::Y * length).collect();
        let row = Row::new(Vec3::ZERO, &bones, &[turn]);
        let (_, total) = reach(&lengths);
        check(&row, usize::MAX, &goal(row.end(&row.pose) * part, None))?;
        check(&row, usize::MAX, &goal(target.normalize_or(Vec3::X) * total * part, None))?;
    }
}

#[test]
fn a_goal_that_is_not_finite_has_no_answer() {
    let row = Row::new(Vec3::ZERO, &[Vec3::Y, Vec3::Y], &[]);
    let chain = row.chain().unwrap();
    for target in [Vec3::NAN, Vec3::INFINITY, Vec3::new(0.0, f32::NAN, 1.0)] {
        let solution = chain.solve(&row.skeleton, &row.pose, &IkGoal::to(target));
        assert!(solution.is_none(), "{target}");
    }
    let pole = Some(Vec3::NAN);
    let solution = chain.solve(&row.skeleton, &row.pose, &goal(Vec3::X, pole));
    assert!(solution.unwrap().off < 1e-5, "a pole that is none is none");
}

#[test]
fn a_chain_without_a_length_is_none() {
    let row = Row::new(Vec3::ONE, &[Vec3::ZERO, Vec3::ZERO], &[]);
    assert!(row.chain().is_none());
    let row = Row::new(Vec3::ONE, &[Vec3::X, Vec3::INFINITY], &[]);
    assert!(row.chain().is_none());
}

#[test]
fn a_target_far_beyond_every_number_of_the_skeleton_is_pointed_at() {
    let row = Row::new(Vec3::ZERO, &[Vec3::Y, Vec3::Y, Vec3::Y], &[]);
    let target = Vec3::new(-1e30, 0.0, 0.0);
    let chain = row.chain().unwrap();
    let solution = chain.solve(&row.skeleton, &row.pose, &IkGoal::to(target));
    let end = row.end(&solution.unwrap().pose);
    assert!(end.abs_diff_eq(Vec3::NEG_X * 3.0, 1e-5), "{end}");
}
