//! What a class has, as data.

use super::graded::{Graded, Outcome};
use super::mistake_section::number;
use super::name::Name;
use super::section::{Section, cents, in_cents, notes, points_by_section, sections};
use super::{rubric, settled, why};
use crate::diagnose::Mistake;
use crate::io::{RubricData, TestData, TestKind, TestsFile};
use serde::Serialize;
use std::collections::BTreeMap;

/// Everything about a class; as JSON it is `grade.json`. Points have two digits after the point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// What it is called.
    pub title: String,
    /// Sections with points, by number or name.
    pub sections: Vec<Section>,
    /// Tests in the order of their file.
    pub tests: Vec<Row>,
    /// Submissions in the order of their names.
    pub submissions: Vec<Submission>,
    /// Mistakes that were made, the one that most submissions have first.
    pub mistakes: Vec<MistakeGroup>,
}

/// A test as the report has it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Its name.
    pub name: String,
    /// `mesh` or `picture`.
    pub kind: &'static str,
    /// Points by section, as the file of tests has them.
    pub points: BTreeMap<String, f64>,
    /// The exact result as a PNG in Base64.
    #[serde(skip)]
    pub picture: Option<String>,
}

/// A submission with its points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Submission {
    /// Name of its folder.
    pub name: String,
    /// Path of the page about it alone from the folder of the report.
    pub page: String,
    /// Points in all, without those that a person has not given yet.
    pub points: f64,
    /// Points that are possible in all, without extra ones.
    pub possible: f64,
    /// How many of these nobody has graded yet.
    pub not_graded: f64,
    /// Points by section; `None` where a person has not given them yet.
    pub sections: BTreeMap<String, Option<f64>>,
    /// Points of each section in words, and why they are others than those of its tests together, if they are.
    pub notes: Vec<String>,
    /// Results in the order of the tests.
    pub tests: Vec<GradedTest>,
}

/// A test of a submission.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GradedTest {
    /// Name of the test.
    pub test: String,
    /// What the file is.
    pub outcome: Outcome,
    /// What is known of it beyond its outcome, in a few words.
    pub hint: Option<String>,
    /// Mistakes that together give the file; the first are those of `text`, the others give the same.
    pub causes: Vec<Vec<String>>,
    /// How far the file is from the exact one, by the size.
    pub error: Option<f64>,
    /// Share that agrees, 0 to 1.
    pub agrees: f64,
    /// What its vertices count for by how near they are, or the share of the silhouette that agrees, 0 to 1.
    pub near: f64,
    /// Points by section, before sections are scaled to what they are worth.
    pub points: BTreeMap<String, f64>,
    /// The diagnosis in words.
    pub text: String,
    /// In which other sections mistakes cost points whose own section has none in the test, in sentences.
    pub elsewhere: Vec<String>,
    /// Why it has not all of its points, in sentences.
    pub why: Vec<String>,
    /// A PNG of what is off, in Base64.
    #[serde(skip)]
    pub picture: Option<String>,
}

/// A mistake, and who made it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MistakeGroup {
    /// Its name.
    pub id: String,
    /// What programs do that make it.
    pub meaning: &'static str,
    /// Section of the assignment.
    pub section: &'static str,
    /// What to look at in the code.
    pub look_at: &'static str,
    /// Submissions that make it, each with the tests that show it.
    pub submissions: BTreeMap<Name, Vec<String>>,
}

impl Report {
    /// The report on submissions, each with its name and the results of all tests in their order. Exact
    /// `pictures` of tests are PNG in Base64 by name, and `page_paths` has the path of the page about each submission
    /// alone for their names, in their order.
    pub fn new(
        file: &TestsFile,
        pictures: &BTreeMap<String, String>,
        mut graded: Vec<(String, Vec<Graded>)>,
        page_paths: impl FnOnce(&[&str]) -> Vec<String>,
    ) -> Self {
        graded.sort_by_cached_key(|(name, _)| Name::from(&**name));
        let names: Vec<&str> = graded.iter().map(|(name, _)| &**name).collect();
        let pages = page_paths(&names);
        let sections = sections(file);
        let possible = sections.iter().filter(|section| !section.extra);
        let possible = in_cents(possible.map(|section| section.possible).sum());
        let submissions = graded
            .into_iter()
            .zip(pages)
            .map(|((name, mut graded), page)| {
                settled::settle(file, &mut graded);
                let tests: Vec<GradedTest> = file
                    .tests
                    .iter()
                    .zip(graded)
                    .map(|(test, graded)| GradedTest {
                        test: test.name.clone(),
                        points: cents(rubric::points(test, &graded, &file.rubric)),
                        elsewhere: elsewhere(test, &graded, &file.rubric),
                        why: why::why(test, &graded, &file.rubric),
                        outcome: graded.outcome,
                        hint: graded.hint,
                        causes: graded.causes,
                        error: graded.error,
                        agrees: graded.agrees,
                        near: graded.near,
                        text: graded.text,
                        picture: graded.picture,
                    })
                    .collect();
                let by_section = points_by_section(file, &sections, &name, &tests);
                let is_open =
                    |section: &&Section| !section.extra && by_section[&section.section].is_none();
                let not_graded = sections.iter().filter(is_open);
                Submission {
                    points: in_cents(by_section.values().flatten().sum()),
                    not_graded: in_cents(not_graded.map(|section| section.possible).sum()),
                    possible,
                    notes: notes(file, &sections, &name, &tests, &by_section),
                    sections: by_section,
                    tests,
                    name,
                    page,
                }
            });
        let submissions: Vec<Submission> = submissions.collect();
        let tests = file.tests.iter().map(|test| Row {
            name: test.name.clone(),
            kind: match test.kind {
                TestKind::Mesh => "mesh",
                TestKind::Picture { .. } => "picture",
            },
            points: test
                .points
                .iter()
                .map(|(section, points)| (section.clone(), points.0))
                .collect(),
            picture: pictures.get(&test.name).cloned(),
        });
        Self {
            title: match &*file.title {
                "" => "Grades".to_owned(),
                title => title.to_owned(),
            },
            tests: tests.collect(),
            mistakes: mistakes(&submissions),
            submissions,
            sections,
        }
    }
}

/// What is said of a file that is not explained, but nearly.
pub(super) const NEARLY: &str = "nearly ";

impl GradedTest {
    /// Whether nothing is known of what is wrong with it.
    pub(super) fn is_unknown(&self) -> bool {
        self.outcome == Outcome::Unexplained && self.summary().starts_with(self.outcome.word())
    }

    /// The mistakes of the text by name, or else the word for what the file is, and what more is known of it.
    pub fn summary(&self) -> String {
        let Some(mistakes) = self.causes.first() else {
            let word = self.outcome.word();
            let hint = self.hint.as_ref();
            return match hint {
                None => word.to_owned(),
                Some(hint) if self.outcome != Outcome::Unexplained => format!("{word}: {hint}"),
                Some(hint) if hint.starts_with(NEARLY) || hint.starts_with(word) => hint.clone(),
                Some(hint) => format!("{NEARLY}right: {hint}"),
            };
        };
        // The same two are told alike, whichever of them accounts for more.
        let mut mistakes = mistakes.clone();
        mistakes.sort();
        mistakes.join(" + ")
    }
}

impl Submission {
    /// Points that are possible in what is graded.
    pub fn graded(&self) -> f64 {
        in_cents(self.possible - self.not_graded)
    }

    /// What is wrong, each with the tests that show it; empty if all is right.
    pub fn summaries(&self) -> Vec<(String, Vec<&str>)> {
        let mut all: Vec<(String, Vec<&str>)> = Vec::new();
        for test in self
            .tests
            .iter()
            .filter(|test| test.outcome != Outcome::Right)
        {
            let summary = test.summary();
            match all.iter_mut().find(|(known, _)| *known == summary) {
                Some((_, tests)) => tests.push(&test.test),
                None => all.push((summary, vec![&test.test])),
            }
        }
        all
    }
}

/// In which sections mistakes cost points whose own section has none in the test.
fn elsewhere(test: &TestData, graded: &Graded, rubric: &RubricData) -> Vec<String> {
    let counted = rubric::counted_elsewhere(test, graded, rubric).into_iter();
    let told = counted.map(|(mistake, section)| {
        let own = number(mistake.section);
        format!(
            "{} counts against {section}, since the test has no points for {own}",
            mistake.id
        )
    });
    told.collect()
}

/// Mistakes by those who made them.
fn mistakes(submissions: &[Submission]) -> Vec<MistakeGroup> {
    let mut groups: BTreeMap<&str, BTreeMap<Name, Vec<String>>> = BTreeMap::new();
    for submission in submissions {
        for test in &submission.tests {
            for id in test.causes.first().into_iter().flatten() {
                let by = groups.entry(id).or_default();
                let tests = by.entry(Name::from(&*submission.name)).or_default();
                tests.push(test.test.clone());
            }
        }
    }
    let groups = groups.into_iter().filter_map(|(id, submissions)| {
        let mistake = Mistake::find(id)?;
        Some(MistakeGroup {
            id: id.to_owned(),
            meaning: mistake.meaning,
            section: mistake.section,
            look_at: mistake.look_at,
            submissions,
        })
    });
    let mut groups: Vec<MistakeGroup> = groups.collect();
    // Stable: of equals the first by name comes first.
    groups.sort_by_key(|group| std::cmp::Reverse(group.submissions.len()));
    groups
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn file() -> TestsFile {
        let text = br#"{"tests": [
            {"name": "a", "character": "b", "pose": "c", "points": {"3.4": 1, "4.2": 3}},
            {"name": "d", "character": "b", "pose": "c", "points": {"4.2": 1}}],
            "rubric": {"sections": {"4.2": {"points": 30}, "artifact": {"points": 5},
                "extra credit": {"points": 2, "extra": true}},
                "given": {"ada": {"artifact": 4.5, "extra credit": 2}}}}"#;
        TestsFile::read(Path::new("t.json"), text).unwrap()
    }

    fn report() -> Report {
        let right = || Graded::without(Outcome::Right, "");
        let wrong = |id: &str| Graded {
            causes: vec![vec![id.to_owned()]],
            ..Graded::without(Outcome::Explained, "")
        };
        let graded = vec![
            (
                "bob".to_owned(),
                vec![wrong("euler-zyx"), wrong("no-inverse-bind")],
            ),
            ("ada".to_owned(), vec![right(), right()]),
            (
                "eve".to_owned(),
                vec![wrong("euler-zyx"), Graded::without(Outcome::Missing, "")],
            ),
        ];
        let page_paths = |names: &[&str]| {
            names
                .iter()
                .map(|name| format!("pages/{name}.html"))
                .collect()
        };
        Report::new(&file(), &BTreeMap::new(), graded, page_paths)
    }

    #[test]
    fn sections_are_scaled_to_what_they_are_worth_and_a_person_gives_what_no_test_can() {
        let report = report();
        let names = report
            .submissions
            .iter()
            .map(|submission| &*submission.name);
        assert_eq!(names.collect::<Vec<_>>(), ["ada", "bob", "eve"]);
        let [ada, bob, eve] = &report.submissions[..] else {
            panic!("{report:?}");
        };
        assert_eq!((ada.points, ada.possible), (37.5, 36.0));
        // 4.2: 3 of 3 and 0.5 of 1, of which 30 points are made; 3.4: 0.5 of 1.
        assert_eq!(
            (bob.sections["4.2"], bob.sections["3.4"]),
            (Some(26.25), Some(0.5))
        );
        assert_eq!((bob.sections["artifact"], bob.points), (None, 26.75));
        // What nobody has graded yet is not lost; extra points never are.
        assert_eq!((ada.not_graded, bob.not_graded), (0.0, 5.0));
        assert_eq!((ada.graded(), bob.graded()), (36.0, 31.0));
        assert_eq!(eve.points, 23.0);
    }

    #[test]
    fn the_same_mistake_of_several_is_one_group_and_the_most_usual_comes_first() {
        let report = report();
        let groups = report.mistakes.iter().map(|group| {
            let who: Vec<&str> = group.submissions.keys().map(Name::as_str).collect();
            (&*group.id, who)
        });
        let expected = [
            ("euler-zyx", vec!["bob", "eve"]),
            ("no-inverse-bind", vec!["bob"]),
        ];
        assert_eq!(groups.collect::<Vec<_>>(), expected);
    }
}
