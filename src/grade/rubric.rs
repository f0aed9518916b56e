//! Points by the rubric.

use super::by_vertices::by_vertices;
use super::graded::{Graded, Outcome};
use super::mistake_section::{number, own_section, section_of};
use super::shares::share_left;
use crate::diagnose::{Mistake, POSE_NOT_APPLIED};
use crate::io::{OTHER_POSE, RIGHT_BUT_FOR_JOINTS, RubricData, TestData};
use std::collections::BTreeMap;

/// How much of a test's pose another one has that shows all that the test asks for but some angles: more than this, which
/// any pose of the same joints has.
pub(super) const MOSTLY_POSED: f64 = 0.5;

/// The points of a test by section. A mistake costs its share of the points of its own section alone,
/// for all else is right once it is set aside; one whose section has no points in the test costs them in the nearest
/// one, and a pose that was not applied in each. Of explanations that give the same file the one counts that costs
/// least, unless the first is that the pose was not applied.
pub(super) fn points(
    test: &TestData,
    graded: &Graded,
    rubric: &RubricData,
) -> BTreeMap<String, f64> {
    match graded.outcome {
        Outcome::Right => of_all(test, 1.0),
        Outcome::Unexplained if counts_as_mistakes(test, graded, rubric) => {
            left_by(&graded.nearly, test, graded, rubric)
        }
        Outcome::Unexplained => of_all(test, by_vertices(test, graded, rubric)),
        Outcome::OtherPose => {
            let ids = [&[of_other_pose(graded).to_owned()], &*graded.nearly].concat();
            left_by(&ids, test, graded, rubric)
        }
        Outcome::Explained => counted(test, graded, rubric).map_or_else(
            || of_all(test, 0.0),
            |ids| left_by(ids, test, graded, rubric),
        ),
        Outcome::Blank | Outcome::Missing | Outcome::Unreadable | Outcome::Failed => {
            of_all(test, 0.0)
        }
    }
}

/// Mistakes that cost points in another section than their own, which has none in the test: each with its own and
/// that other one.
pub(super) fn counted_elsewhere(
    test: &TestData,
    graded: &Graded,
    rubric: &RubricData,
) -> Vec<(&'static Mistake, String)> {
    let ids = counted(test, graded, rubric).unwrap_or_default();
    let elsewhere = ids.iter().filter_map(|id| {
        let mistake = Mistake::find(id)?;
        let section = section_of(mistake.section, test)?;
        let is_own = number(section) == number(mistake.section) || id == POSE_NOT_APPLIED;
        (!is_own).then(|| (mistake, section.to_owned()))
    });
    elsewhere.collect()
}

/// Of the explanations of a file the mistakes that points are taken for.
pub(super) fn counted<'a>(
    test: &TestData,
    graded: &'a Graded,
    rubric: &RubricData,
) -> Option<&'a [String]> {
    let first = graded.causes.first()?;
    // Wrong triangles may come with it.
    if first.iter().any(|id| id == POSE_NOT_APPLIED) {
        return Some(first);
    }
    let left = |ids: &[String]| points_left(ids, test, graded, rubric);
    // Of equals the first, which is the one that is told.
    let best = graded.causes.iter().reduce(|best, other| {
        if left(other) > left(best) + 1e-9 {
            other
        } else {
            best
        }
    });
    best.map(Vec::as_slice)
}

/// Points that a test has in all with these mistakes in a file.
pub(super) fn points_left(
    ids: &[String],
    test: &TestData,
    graded: &Graded,
    rubric: &RubricData,
) -> f64 {
    total(&left_by(ids, test, graded, rubric))
}

fn total(points: &BTreeMap<String, f64>) -> f64 {
    points.values().sum()
}

/// A share of the points in each section.
fn of_all(test: &TestData, share: f64) -> BTreeMap<String, f64> {
    let points = test.points.iter();
    points
        .map(|(section, points)| (section.clone(), points.0 * share))
        .collect()
}

/// What the exact result of another pose counts as.
pub(super) fn of_other_pose(graded: &Graded) -> &'static str {
    if graded.posed > MOSTLY_POSED {
        RIGHT_BUT_FOR_JOINTS
    } else {
        OTHER_POSE
    }
}

/// Whether something unexplained that is nearly right has more points as what is wrong with it than by its vertices.
pub(super) fn counts_as_mistakes(test: &TestData, graded: &Graded, rubric: &RubricData) -> bool {
    let as_mistakes = left_by(&graded.nearly, test, graded, rubric);
    let by_vertices = of_all(test, by_vertices(test, graded, rubric));
    let is_without_pose = graded.nearly.iter().any(|id| id == POSE_NOT_APPLIED);
    // Of equals what is told of it.
    let is_better = total(&as_mistakes) > total(&by_vertices) - 1e-9;
    !graded.nearly.is_empty() && (is_better || is_without_pose)
}

/// What mistakes that are made together leave in each section.
fn left_by(
    ids: &[String],
    test: &TestData,
    graded: &Graded,
    rubric: &RubricData,
) -> BTreeMap<String, f64> {
    let mut left = of_all(test, 1.0);
    for id in ids {
        let is_of_all = id == POSE_NOT_APPLIED || id == OTHER_POSE;
        let share = share_left(id, graded, rubric);
        let own = section_of(own_section(id), test);
        for (section, points) in &mut left {
            if is_of_all || own == Some(section) {
                *points *= share;
            }
        }
    }
    left
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::grade::why::why;
    use crate::io::{NamedFile, Points, Position, Share, TestKind};

    fn named(path: &str) -> NamedFile {
        NamedFile {
            path: path.into(),
            at: Position { line: 1, column: 1 },
        }
    }

    pub(in crate::grade) fn test(sections: &[(&str, f64)]) -> TestData {
        let points = sections
            .iter()
            .map(|&(section, points)| (section.to_owned(), Points(points)));
        TestData {
            name: "walk".to_owned(),
            character: named("a.obj"),
            pose: named("b.json"),
            kind: TestKind::Mesh,
            points: points.collect(),
        }
    }

    pub(in crate::grade) fn explained(causes: &[&[&str]]) -> Graded {
        let owned = |ids: &&[&str]| ids.iter().map(|&id| id.to_owned()).collect();
        Graded {
            causes: causes.iter().map(owned).collect(),
            ..Graded::without(Outcome::Explained, "")
        }
    }

    pub(in crate::grade) fn given(
        sections: &[(&str, f64)],
        graded: &Graded,
        rubric: &RubricData,
    ) -> Vec<f64> {
        points(&test(sections), graded, rubric)
            .into_values()
            .collect()
    }

    pub(in crate::grade) const TWO: &[(&str, f64)] = &[("3.4", 6.0), ("4.2", 10.0)];

    #[test]
    fn a_mistake_costs_points_in_its_own_section_and_two_in_one_cost_twice() {
        let rubric = RubricData::default();
        for (causes, expected) in [
            (&["euler-zyx"][..], [3.0, 10.0]),
            (&["no-inverse-bind"], [6.0, 5.0]),
            (&["euler-zyx", "no-inverse-bind"], [3.0, 5.0]),
            (&["euler-zyx", "one-axis-ignored-x"], [1.5, 10.0]),
            // Sections 3.2 and 4.1 have no points in this test.
            (&["parent-missing"], [3.0, 10.0]),
            (&["vertices-renumbered"], [6.0, 5.0]),
        ] {
            assert_eq!(
                given(TWO, &explained(&[causes]), &rubric),
                expected,
                "{causes:?}"
            );
        }
    }

    #[test]
    fn a_mesh_that_is_hardly_posed_at_all_gets_no_points_for_vertices_that_do_not_move() {
        let nearly = Graded {
            nearly: ["pose-not-applied", "right-but-for-few"]
                .map(str::to_owned)
                .to_vec(),
            near: 0.9,
            ..Graded::without(Outcome::Unexplained, "")
        };
        assert_eq!(given(TWO, &nearly, &RubricData::default()), [0.0, 0.0]);
    }

    #[test]
    fn of_mistakes_that_give_the_same_the_one_counts_that_costs_least() {
        let causes = explained(&[&["no-inverse-bind"], &["euler-zyx"]]);
        assert_eq!(given(TWO, &causes, &RubricData::default()), [3.0, 10.0]);
    }

    #[test]
    fn a_mistake_whose_section_is_not_in_the_test_costs_points_once_in_the_nearest_one() {
        let rubric = RubricData::default();
        let renumbered = explained(&[&["vertices-renumbered"]]);
        for (sections, expected) in [
            (
                &[("3.4", 4.0), ("4.1", 4.0), ("4.2", 4.0)][..],
                [4.0, 2.0, 4.0],
            ),
            (&[("3.2", 4.0), ("4.2", 4.0), ("5.1", 4.0)], [4.0, 2.0, 4.0]),
            // As near to the section before as to the one after.
            (&[("4", 4.0), ("4.0", 4.0), ("4.2", 4.0)], [4.0, 4.0, 2.0]),
            (
                &[("3.2", 4.0), ("3.4", 4.0), ("pose", 9.0)],
                [4.0, 2.0, 9.0],
            ),
            (&[("2", 4.0), ("5.1", 4.0), ("5.2", 4.0)], [4.0, 2.0, 4.0]),
            (&[("a", 4.0), ("b", 8.0), ("c", 8.0)], [4.0, 4.0, 8.0]),
        ] {
            assert_eq!(
                given(sections, &renumbered, &rubric),
                expected,
                "{sections:?}"
            );
        }
        let elsewhere = counted_elsewhere(&test(TWO), &renumbered, &rubric);
        let [(mistake, section)] = &elsewhere[..] else {
            panic!("{elsewhere:?}");
        };
        assert_eq!((mistake.id, &**section), ("vertices-renumbered", "4.2"));
    }

    #[test]
    fn a_test_whose_pose_was_not_applied_shows_none_of_its_sections() {
        let mut rubric = RubricData::default();
        let at_rest = explained(&[&["pose-not-applied"], &["one-axis-ignored-z"]]);
        let other_pose = Graded::without(Outcome::OtherPose, "");
        assert_eq!(given(TWO, &at_rest, &rubric), [0.0, 0.0]);
        let cut_off = explained(&[
            &["pose-not-applied", "triangles-differ"],
            &["one-axis-ignored-z", "triangles-differ"],
        ]);
        assert_eq!(given(TWO, &cut_off, &rubric), [0.0, 0.0]);
        assert_eq!(given(TWO, &other_pose, &rubric), [0.0, 0.0]);
        let name = POSE_NOT_APPLIED.to_owned().try_into().unwrap();
        rubric.mistakes.insert(name, Share(0.25));
        assert_eq!(given(TWO, &at_rest, &rubric), [1.5, 2.5]);
        assert_eq!(given(TWO, &other_pose, &rubric), [1.5, 2.5]);
        let name = OTHER_POSE.to_owned().try_into().unwrap();
        rubric.mistakes.insert(name, Share(0.5));
        assert_eq!(given(TWO, &at_rest, &rubric), [1.5, 2.5]);
        assert_eq!(given(TWO, &other_pose, &rubric), [3.0, 5.0]);
    }

    #[test]
    fn a_slip_in_one_joint_of_the_pose_costs_as_much_as_a_mistake_in_its_angles() {
        let mut rubric = RubricData::default();
        let of_pose = |posed| Graded {
            posed,
            agrees: 0.8,
            ..Graded::without(Outcome::OtherPose, "")
        };
        let slip = of_pose(0.51);
        assert_eq!(given(TWO, &slip, &rubric), [3.0, 10.0]);
        let told = "right-but-for-joints leaves 50 % of 3.4";
        assert_eq!(why(&test(TWO), &slip, &rubric), [told]);
        assert_eq!(given(TWO, &of_pose(0.5), &rubric), [0.0, 0.0]);
        // The two have shares of their own.
        for (id, share) in [(OTHER_POSE, 0.25), (RIGHT_BUT_FOR_JOINTS, 0.75)] {
            let name = id.to_owned().try_into().unwrap();
            rubric.mistakes.insert(name, Share(share));
        }
        assert_eq!(given(TWO, &slip, &rubric), [4.5, 10.0]);
        assert_eq!(given(TWO, &of_pose(0.5), &rubric), [1.5, 2.5]);
    }

    #[test]
    fn a_mistake_may_cost_less_than_others() {
        let mut rubric = RubricData::default();
        let name = "euler-zyx".to_owned().try_into().unwrap();
        rubric.mistakes.insert(name, Share(0.75));
        assert_eq!(
            given(TWO, &explained(&[&["euler-zyx"]]), &rubric),
            [4.5, 10.0]
        );
    }

    #[test]
    fn what_is_nearly_right_costs_less_than_a_mistake_and_in_the_section_of_posed_meshes() {
        let mut rubric = RubricData::default();
        let nearly = |names: &[&str], near| Graded {
            nearly: names.iter().map(|&name| name.to_owned()).collect(),
            near,
            ..Graded::without(Outcome::Unexplained, "")
        };
        // One vertex too few is as little, and so are wrong triangles.
        for id in [
            "vertex-missing",
            "vertex-too-many",
            "triangles-differ",
            "triangles-turned",
        ] {
            assert_eq!(given(TWO, &explained(&[&[id]]), &rubric), [6.0, 9.0]);
        }
        let few = nearly(&["right-but-for-few"], 0.998);
        assert_eq!(given(TWO, &few, &rubric), [6.0, 9.0]);
        let told = why(&test(TWO), &few, &rubric);
        assert_eq!(told, ["right-but-for-few leaves 90 % of 4.2"]);
        // Whatever has the most points.
        let sections = [("3.4", 12.0), ("4.1", 4.0)];
        assert_eq!(given(&sections, &few, &rubric), [12.0, 3.6]);
        let told = why(&test(&sections), &few, &rubric);
        let text = "right-but-for-few leaves 90 % of 4.1, since the test has no points for 4.2";
        assert_eq!(told, [text]);
        let little = nearly(&["right-but-for-little"], 0.76);
        assert_eq!(given(TWO, &little, &rubric), [6.0, 9.0]);
        let moved = nearly(&["moved-as-a-whole"], 0.0);
        assert_eq!(given(TWO, &moved, &rubric), [6.0, 7.5]);
        let of_mistake = nearly(&["euler-zyx", "right-but-for-few"], 0.1);
        assert_eq!(given(TWO, &of_mistake, &rubric), [3.0, 9.0]);
        // A rubric may count them otherwise.
        for (id, share) in [("moved-as-a-whole", 0.8), ("right-but-for-few", 0.0)] {
            let name = id.to_owned().try_into().unwrap();
            rubric.mistakes.insert(name, Share(share));
        }
        assert_eq!(given(TWO, &moved, &rubric), [6.0, 8.0]);
        rubric.unexplained = Share(1.0);
        let [small, large] = given(TWO, &few, &rubric)[..] else {
            panic!("two sections");
        };
        assert!((small - 5.988).abs() < 1e-9 && (large - 9.98).abs() < 1e-9);
    }

    #[test]
    fn what_is_unexplained_counts_by_how_near_it_is_and_what_is_not_there_counts_nothing() {
        let rubric = RubricData::default();
        let unexplained = Graded {
            near: 0.8,
            ..Graded::without(Outcome::Unexplained, "")
        };
        assert_eq!(given(&[("4.2", 10.0)], &unexplained, &rubric), [4.0]);
        let far = Graded {
            near: 0.0,
            ..unexplained
        };
        assert_eq!(given(TWO, &far, &rubric), [0.0, 0.0]);
        for outcome in [
            Outcome::Blank,
            Outcome::Missing,
            Outcome::Unreadable,
            Outcome::Failed,
        ] {
            let none = Graded::without(outcome, "");
            assert_eq!(given(TWO, &none, &rubric), [0.0, 0.0]);
        }
    }
}
