//! Skeletons of which one line is read wrong: a joint that hangs on a wrong parent, or has a wrong offset.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::student::{RIGHT, with};
use editor_core::diagnose::Verdict;
use glam::{EulerRot, Quat, Vec3};
use proptest::prelude::*;

/// The vertices that a right program writes that has another skeleton, which `change` makes.
fn with_skeleton(name: &str, seed: u32, change: impl Fn(&mut Figure)) -> Vec<Vec3> {
    let mut wrong = Figure::builtin(name, turned(seed));
    change(&mut wrong);
    RIGHT.skin(&wrong)
}

#[test]
fn where_one_joint_is_turned_a_wrong_parent_is_named_beside_a_rule_by_which_all_are_wrong() {
    let (elbow, collarbone) = (17, 15);
    let pose = |joint: usize| match joint {
        17 => Vec3::new(0.0, 0.0, 0.9),
        _ => Vec3::ZERO,
    };
    let figure = Figure::builtin("adult", pose);
    let mut wrong = Figure::builtin("adult", pose);
    wrong.parents[elbow] = Some(collarbone);
    let found = figure.diagnose(&RIGHT.skin(&wrong));
    assert_eq!(found.causes, ["parents-misread", "one-wrong-parent"]);
    let told = &found.others[0].how;
    assert!(
        told.contains("Left elbow (17) on Left collarbone (15)"),
        "{told}"
    );
}

/// Whether `joint` is `above` or hangs on it.
fn hangs_on(figure: &Figure, joint: usize, above: usize) -> bool {
    let line = std::iter::successors(Some(joint), |&joint| figure.parents[joint]);
    line.into_iter().any(|joint| joint == above)
}

/// Whether the vertices are those of a right program, as far as six digits show it.
fn is_right(figure: &Figure, theirs: &[Vec3]) -> bool {
    let exact = RIGHT.skin(figure);
    let pairs = exact.iter().zip(theirs);
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f32::max) < 1e-4
}

#[test]
fn a_joint_that_hangs_on_a_wrong_parent_is_named_with_both_parents() {
    let figure = Figure::builtin("adult", turned(51));
    let joints = figure.character.skeleton().joints();
    let index = |name: &str| joints.iter().position(|joint| joint.name == name).unwrap();
    let (elbow, chest) = (index("Left elbow"), index("Chest"));
    let shoulder = figure.parents[elbow].unwrap();
    let theirs = with_skeleton("adult", 51, |wrong| wrong.parents[elbow] = Some(chest));
    let found = figure.diagnose(&written(&theirs, 6));
    assert_eq!(found.causes, ["one-wrong-parent"], "{found}");
    let expected = format!(
        "one-wrong-parent: one joint hangs on another parent than the file says (Left elbow ({elbow}) on Chest \
         ({chest}) instead of {} ({shoulder}))\n",
        joints[shoulder].name
    );
    assert!(found.to_string().starts_with(&expected), "{found}");
    assert_eq!(found.mistakes[0].section, "3.2 Skeleton");
}

#[test]
fn of_parents_that_give_the_same_those_next_to_the_right_one_are_told_and_how_many_others_there_are()
 {
    let (elbow, shoulder, collarbone) = (17, 16, 15);
    // The joints above the limbs are not turned, so that what hangs on any of them is where it hangs on the collarbone.
    let pose = |joint: usize| match joint {
        5..=11 | 13 | 14 | 16 => turned(51)(joint),
        _ => Vec3::ZERO,
    };
    let figure = Figure::builtin("adult", pose);
    let mut wrong = Figure::builtin("adult", pose);
    assert_eq!(figure.parents[elbow], Some(shoulder));
    wrong.parents[elbow] = Some(collarbone);
    let found = figure.diagnose(&RIGHT.skin(&wrong));
    let told = found.mistakes.iter().chain(&found.others);
    let mut told = told.filter(|mistake| mistake.id == "one-wrong-parent");
    let how = told
        .next()
        .unwrap_or_else(|| panic!("{found}"))
        .how
        .to_string();
    let first = "Left elbow (17) on Left collarbone (15) instead of Left shoulder (16), or ";
    assert!(how.starts_with(first), "{how}");
    assert!(
        how.ends_with(" others that give the same in this pose"),
        "{how}"
    );
}

#[test]
fn a_joint_with_a_wrong_offset_is_named_with_both_offsets() {
    let figure = Figure::builtin("adult", turned(52));
    let joints = figure.character.skeleton().joints();
    let knee = joints
        .iter()
        .position(|joint| joint.name == "Left knee")
        .unwrap();
    let real = figure.offsets[knee];
    let wrong = Vec3::new(real.x, -real.y, real.z);
    let theirs = with_skeleton("adult", 52, |figure| figure.offsets[knee] = wrong);
    let told = |of: Vec3| {
        let [x, y, z] = of
            .to_array()
            .map(|value| (f64::from(value) * 1e4).round() / 1e4);
        format!("({x}, {y}, {z})")
    };
    let expected = format!(
        "Left knee ({knee}) {} instead of {}",
        told(wrong),
        told(real)
    );
    for digits in 3..8 {
        let found = figure.diagnose(&written(&theirs, digits));
        assert_eq!(found.causes, ["one-wrong-offset"], "{digits}: {found}");
        assert_eq!(found.mistakes[0].how, expected, "{digits}");
    }
}

#[test]
fn of_offsets_that_give_the_same_the_one_that_changes_the_fewest_numbers_is_named() {
    // Of the joint, about one axis, so that along this axis nothing shows.
    let elbow = 14;
    let axis = Vec3::new(0.48, 0.6, 0.64);
    let turn = Quat::from_axis_angle(axis, 1.0).to_euler(EulerRot::XYZ);
    let degrees = Vec3::new(turn.0, turn.1, turn.2).map(f32::to_degrees);
    let pose = |joint: usize| match joint == elbow {
        true => degrees,
        false => turned(52)(joint),
    };
    let figure = Figure::builtin("adult", pose);
    for by in [Vec3::X * 0.05, Vec3::Y * 0.04, Vec3::Z * -0.03] {
        let mut wrong = Figure::builtin("adult", pose);
        wrong.offsets[elbow] += by;
        let told = (wrong.offsets[elbow].to_array()).map(|at| (f64::from(at) * 1e4).round() / 1e4);
        let expected = format!("({}, {}, {}) instead of", told[0], told[1], told[2]);
        for digits in [3, 4, 8] {
            let found = figure.diagnose(&written(&RIGHT.skin(&wrong), digits));
            assert_eq!(found.causes, ["one-wrong-offset"], "{found}");
            let how = &found.mistakes[0].how;
            assert!(how.contains(&expected), "{by}: {how} {expected}");
            assert!(
                how.ends_with(", or another that gives the same in this pose"),
                "{how}"
            );
        }
    }
}

#[test]
fn a_part_that_is_bent_or_a_single_vertex_that_is_off_is_no_mistake_of_one_line() {
    let figure = Figure::builtin("adult", turned(53));
    let elbow = 14;
    let mut bent = with_skeleton("adult", 53, |wrong| wrong.offsets[elbow].y += 0.1);
    assert_eq!(figure.diagnose(&bent).causes, ["one-wrong-offset"]);
    let in_part = |vertex: &usize| figure.rows[*vertex][elbow - 1] > 0.6;
    let part: Vec<usize> = (0..bent.len()).filter(in_part).collect();
    bent[part[part.len() / 2]].x += 0.002;
    let found = figure.diagnose(&bent);
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
    let mut single = RIGHT.skin(&figure);
    single[part[0]].x += 0.01;
    let found = figure.diagnose(&single);
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
}

#[test]
fn a_mistake_of_the_whole_program_is_named_before_one_of_one_joint() {
    // Only the knee turns, so that its offset alone matters.
    let knee = |joint: usize| {
        if joint == 6 {
            Vec3::X * 50.0
        } else {
            Vec3::ZERO
        }
    };
    let figure = Figure::builtin("adult", knee);
    let found = figure.diagnose(&with(&["rotation-before-translation"]).skin(&figure));
    assert!(
        found.causes.contains(&"rotation-before-translation"),
        "{found}"
    );
    assert!(!found.causes.contains(&"one-wrong-offset"), "{found}");
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 48,
        failure_persistence: None,
        rng_seed: prop::test_runner::RngSeed::Fixed(29),
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_joint_on_any_other_parent_is_found_or_makes_no_difference(
        name in prop::sample::select(vec!["adult", "dog", "robot"]),
        seed in 60..64_u32,
        joint in 0..1000_usize,
        parent in 0..1000_usize,
        digits in 5..8_usize,
    ) {
        let figure = Figure::builtin(name, turned(seed));
        let (joint, parent) = (joint % figure.parents.len(), parent % figure.parents.len());
        prop_assume!(!hangs_on(&figure, parent, joint) && figure.parents[joint] != Some(parent));
        let theirs = with_skeleton(name, seed, |wrong| wrong.parents[joint] = Some(parent));
        let found = figure.diagnose(&written(&theirs, digits));
        let case = format!("{joint} on {parent} of {name} {seed}: {found}");
        if is_right(&figure, &theirs) {
            prop_assert_eq!(found.verdict, Verdict::Right, "{}", case);
        } else {
            prop_assert_eq!(&found.causes[0], &"one-wrong-parent", "{}", case);
            let names = figure.character.skeleton().joints();
            let told = format!("{} ({joint}) on {} ({parent}) ", names[joint].name, names[parent].name);
            prop_assert!(found.mistakes[0].how.contains(&told), "{}", case);
        }
    }

    #[test]
    fn any_joint_with_any_other_offset_is_found_or_makes_no_difference(
        name in prop::sample::select(vec!["adult", "dog", "robot"]),
        seed in 60..64_u32,
        joint in 0..1000_usize,
        off in prop::array::uniform3(-0.2..0.2_f32),
        digits in 3..8_usize,
    ) {
        let figure = Figure::builtin(name, turned(seed));
        let joint = joint % figure.parents.len();
        let theirs = with_skeleton(name, seed, |wrong| wrong.offsets[joint] += Vec3::from(off));
        let found = figure.diagnose(&written(&theirs, digits));
        let case = format!("{joint} of {name} {seed} by {off:?}: {found}");
        if is_right(&figure, &theirs) {
            prop_assert_eq!(found.verdict, Verdict::Right, "{}", case);
        } else {
            prop_assert_eq!(&found.causes[..], &["one-wrong-offset"], "{}", case);
            let named = format!("{} ({joint}) ", figure.character.skeleton().joints()[joint].name);
            prop_assert!(found.mistakes[0].how.starts_with(&named), "{}", case);
        }
    }
}
