//! Why results have the points that they have, in sentences for who made them.

use super::by_vertices::{FAR_OFF, by_vertices};
use super::graded::{Graded, Outcome};
use super::mistake_section::{number, own_section, section_of};
use super::rubric::{counted, counts_as_mistakes, of_other_pose};
use super::shares::{Unseen, share_and_reason, share_left};
use crate::diagnose::{POSE_NOT_APPLIED, UNSEEN, of_size};
use crate::io::{OTHER_POSE, RubricData, TestData, TestKind};

/// Why a test has not all of its points, in sentences.
pub(super) fn why(test: &TestData, graded: &Graded, rubric: &RubricData) -> Vec<String> {
    let of_mistakes = |ids: &[String]| {
        let all = ids.iter();
        all.map(|id| why_mistake(id, test, graded, rubric))
            .collect()
    };
    match graded.outcome {
        Outcome::Right => Vec::new(),
        Outcome::Explained => {
            let counted = counted(test, graded, rubric).unwrap_or_default();
            let told = graded.causes.first();
            let is_told = told.is_some_and(|told| counted.iter().all(|id| told.contains(id)));
            let instead = (!is_told).then(|| {
                format!(
                    "of what gives the same, {} costs least",
                    counted.join(" + ")
                )
            });
            instead.into_iter().chain(of_mistakes(counted)).collect()
        }
        Outcome::Unexplained if counts_as_mistakes(test, graded, rubric) => {
            of_mistakes(&graded.nearly)
        }
        Outcome::Unexplained => {
            vec![why_by_vertices(test, graded, rubric)]
        }
        Outcome::OtherPose => match of_other_pose(graded) {
            OTHER_POSE => {
                let share = percent(share_left(OTHER_POSE, graded, rubric));
                vec![format!(
                    "a result that is not the one of the test's own character in its pose leaves {share} of every section"
                )]
            }
            nearly => {
                let joints = [why_mistake(nearly, test, graded, rubric)];
                joints
                    .into_iter()
                    .chain(of_mistakes(&graded.nearly))
                    .collect()
            }
        },
        Outcome::Blank | Outcome::Missing | Outcome::Unreadable | Outcome::Failed => {
            vec!["there is nothing to give points for".to_owned()]
        }
    }
}

/// What is left of what counts by how near it is.
fn why_by_vertices(test: &TestData, graded: &Graded, rubric: &RubricData) -> String {
    let what = match test.kind {
        TestKind::Mesh => "vertices",
        TestKind::Picture { .. } => "silhouette",
    };
    let unexplained = rubric.unexplained.0;
    let [share, right, near] = [unexplained, graded.agrees, graded.near].map(percent);
    let left = by_vertices(test, graded, rubric);
    if left > unexplained * graded.near {
        let left = percent(left);
        let near = match graded.error {
            Some(error) if error < FAR_OFF * UNSEEN => {
                format!("no vertex is farther off than {}", of_size(error))
            }
            _ => format!("{right} of the {what} are right"),
        };
        return format!(
            "what no known mistake explains leaves {left}, so near is it to the exact result: {near}"
        );
    }
    let leaves = format!("what no known mistake explains leaves {share}, times");
    match right == near {
        true => format!("{leaves} the {right} of the {what} that are right"),
        false => format!(
            "{leaves} {near}: {right} of the {what} are right, and others count by how near they are"
        ),
    }
}

/// What a mistake, or a file that is nearly right, leaves of which section.
fn why_mistake(id: &str, test: &TestData, graded: &Graded, rubric: &RubricData) -> String {
    let (share, unseen) = share_and_reason(id, graded, rubric);
    let share = percent(share);
    if id == POSE_NOT_APPLIED {
        return format!("{id} leaves {share} of every section");
    }
    let own = own_section(id);
    let section = section_of(own, test).unwrap_or_default();
    let own = number(own);
    let unseen = match unseen {
        Some(Unseen::Mesh) => ", so little is the mesh off",
        Some(Unseen::Alone) => ", so little would it move by itself",
        None => "",
    };
    let told = format!("{id} leaves {share} of {section}{unseen}");
    match own == number(section) {
        true => told,
        false => format!("{told}, since the test has no points for {own}"),
    }
}

/// A share in words. What is not all is never told as all.
pub(super) fn percent(share: f64) -> String {
    let percent = (share * 1000.0 + 1e-6).floor() / 10.0;
    format!("{percent} %")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::rubric::counted_elsewhere;
    use crate::grade::rubric::tests::{TWO, explained, test};
    use crate::io::Share;

    #[test]
    fn points_that_are_lost_are_explained_by_what_is_left() {
        let mut rubric = RubricData::default();
        let told = |graded: &Graded, rubric: &RubricData| why(&test(TWO), graded, rubric);
        let two = explained(&[&["no-inverse-bind", "parent-missing"]]);
        assert_eq!(
            told(&two, &rubric),
            [
                "no-inverse-bind leaves 50 % of 4.2",
                "parent-missing leaves 50 % of 3.4, since the test has no points for 3.2"
            ]
        );
        let cheaper = explained(&[&["no-inverse-bind", "parent-missing"], &["weights-doubled"]]);
        assert_eq!(
            told(&cheaper, &rubric),
            [
                "of what gives the same, weights-doubled costs least",
                "weights-doubled leaves 50 % of 4.2"
            ]
        );
        let bind = explained(&[&["pose-not-applied"]]);
        assert_eq!(
            told(&bind, &rubric),
            ["pose-not-applied leaves 0 % of every section"]
        );
        rubric.unexplained = Share(0.25);
        let unexplained = Graded {
            agrees: 0.8,
            near: 0.8,
            ..Graded::without(Outcome::Unexplained, "")
        };
        let text = "what no known mistake explains leaves 25 %, times the 80 % of the vertices that are right";
        assert_eq!(told(&unexplained, &rubric), [text]);
        let near = Graded {
            near: 0.9,
            ..unexplained
        };
        let text = "what no known mistake explains leaves 25 %, times 90 %: 80 % of the vertices are right, and others \
                    count by how near they are";
        assert_eq!(told(&near, &rubric), [text]);
        assert!(told(&Graded::without(Outcome::Right, ""), &rubric).is_empty());
        // Sections may have their names beside their numbers.
        let named = test(&[("3.4 Sliders", 6.0), ("4.2 SSD", 10.0)]);
        let inverse = explained(&[&["no-inverse-bind"]]);
        let told = why(&named, &inverse, &rubric);
        assert_eq!(told, ["no-inverse-bind leaves 50 % of 4.2 SSD"]);
        assert!(counted_elsewhere(&named, &inverse, &rubric).is_empty());
    }
}
