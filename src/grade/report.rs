//! What a class has, as data.

use super::graded::{Graded, Outcome};
use super::name::Name;
use super::rubric;
use crate::diagnose::{MISTAKES, Mistake};
use crate::io::{RubricData, TestData, TestKind, TestsFile};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

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

/// A section of the assignment.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Section {
    /// Its number or name.
    pub section: String,
    /// What it is called beside its number; may be empty.
    pub title: String,
    /// Points that are possible.
    pub possible: f64,
    /// Whether they come on top of what is possible in all.
    pub extra: bool,
    /// Whether no test has points for it, so that a person gives them.
    pub by_hand: bool,
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
    /// Points in all, without those that a person has not given yet.
    pub points: f64,
    /// Points that are possible in all, without extra ones.
    pub possible: f64,
    /// How many of these nobody has graded yet.
    pub not_graded: f64,
    /// Points by section; `None` where a person has not given them yet.
    pub sections: BTreeMap<String, Option<f64>>,
    /// Of sections that have other points than their tests together, why, in sentences.
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
    /// `pictures` of tests are PNG in Base64 by name.
    pub fn new(
        file: &TestsFile,
        pictures: &BTreeMap<String, String>,
        mut graded: Vec<(String, Vec<Graded>)>,
    ) -> Self {
        graded.sort_by_cached_key(|(name, _)| Name::from(&**name));
        let sections = sections(file);
        let possible = sections.iter().filter(|section| !section.extra);
        let possible = in_cents(possible.map(|section| section.possible).sum());
        let submissions = graded.into_iter().map(|(name, graded)| {
            let tests: Vec<GradedTest> = file
                .tests
                .iter()
                .zip(graded)
                .map(|(test, graded)| GradedTest {
                    test: test.name.clone(),
                    points: cents(rubric::points(test, &graded, &file.rubric)),
                    elsewhere: elsewhere(test, &graded, &file.rubric),
                    why: rubric::why(test, &graded, &file.rubric),
                    outcome: graded.outcome,
                    hint: graded.hint,
                    causes: graded.causes,
                    error: graded.error,
                    agrees: graded.agrees,
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

impl Section {
    /// Number and title, or one of them where they say the same.
    pub fn name(&self) -> String {
        let Self { section, title, .. } = self;
        if title.is_empty() || title.eq_ignore_ascii_case(section) {
            section.clone()
        } else {
            format!("{section} {title}")
        }
    }
}

impl GradedTest {
    /// The mistakes of the text by name, or else the word for what the file is, and what more is known of it.
    pub fn summary(&self) -> String {
        let Some(mistakes) = self.causes.first() else {
            let word = self.outcome.word();
            let hint = self.hint.as_ref();
            return hint.map_or(word.to_owned(), |hint| format!("{word}: {hint}"));
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

/// A number of points with two digits after the point.
fn in_cents(points: f64) -> f64 {
    // Halves that are not exact in binary are rounded up, as by hand.
    (points * 100.0 + 1e-6).round() / 100.0
}

fn cents(points: BTreeMap<String, f64>) -> BTreeMap<String, f64> {
    points
        .into_iter()
        .map(|(section, points)| (section, in_cents(points)))
        .collect()
}

/// In which sections mistakes cost points whose own section has none in the test.
fn elsewhere(test: &TestData, graded: &Graded, rubric: &RubricData) -> Vec<String> {
    let counted = rubric::counted_elsewhere(test, graded, rubric).into_iter();
    let told = counted.map(|(mistake, section)| {
        let own = rubric::number(mistake.section);
        format!(
            "{} counts against {section}, since the test has no points for {own}",
            mistake.id
        )
    });
    told.collect()
}

fn sections(file: &TestsFile) -> Vec<Section> {
    let of_rubric = file.rubric.sections.keys();
    let of_tests_too = of_rubric.chain(file.tests.iter().flat_map(|test| test.points.keys()));
    let names: BTreeSet<&String> = of_tests_too.collect();
    let sections = names.into_iter().map(|name| {
        let data = file.rubric.sections.get(name).cloned().unwrap_or_default();
        let of_course = || {
            let mut sections = MISTAKES.iter().map(|mistake| mistake.section);
            let section = sections.find(|section| rubric::number(section) == name);
            section
                .and_then(|section| section.split_once(' '))
                .map_or("", |(_, title)| title)
        };
        Section {
            section: name.clone(),
            title: match &*data.title {
                "" => of_course().to_owned(),
                title => title.to_owned(),
            },
            possible: in_cents(file.worth(name).unwrap_or(0.0)),
            extra: data.extra,
            by_hand: file.points_of_tests(name).is_none(),
        }
    });
    sections.collect()
}

/// The points of a submission: those that a person gives, or else those of the tests, scaled to what
/// the section is worth.
fn points_by_section(
    file: &TestsFile,
    sections: &[Section],
    name: &str,
    tests: &[GradedTest],
) -> BTreeMap<String, Option<f64>> {
    let given = file.rubric.given.get(name);
    let points = sections.iter().map(|section| {
        let key = &section.section;
        let by_tests = || {
            let possible = file.points_of_tests(key)?;
            let reached: f64 = tests.iter().filter_map(|test| test.points.get(key)).sum();
            let share = if possible > 0.0 {
                reached / possible
            } else {
                0.0
            };
            Some(in_cents(share * section.possible))
        };
        let by_hand = given
            .and_then(|given| given.get(key))
            .map(|points| in_cents(points.get_ref().0));
        (key.clone(), by_hand.or_else(by_tests))
    });
    points.collect()
}

/// Of sections that have other points than their tests together, why.
fn notes(
    file: &TestsFile,
    sections: &[Section],
    name: &str,
    tests: &[GradedTest],
    points: &BTreeMap<String, Option<f64>>,
) -> Vec<String> {
    let given = file.rubric.given.get(name);
    let told = sections.iter().filter_map(|section| {
        let key = &section.section;
        let points = (*points.get(key)?)?;
        if given.is_some_and(|given| given.contains_key(key)) {
            return Some(format!("{key}: {points} given by hand"));
        }
        let possible = in_cents(file.points_of_tests(key)?);
        let reached: f64 = tests.iter().filter_map(|test| test.points.get(key)).sum();
        let worth = section.possible;
        (possible != worth).then(|| {
            let reached = in_cents(reached);
            format!("{key}: {reached} of {possible} in the tests count as {points} of {worth}")
        })
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
        Report::new(&file(), &BTreeMap::new(), graded)
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

    #[test]
    fn halves_of_cents_are_rounded_up() {
        assert_eq!(
            [in_cents(1.005), in_cents(2.675), in_cents(1.0 / 3.0)],
            [1.01, 2.68, 0.33]
        );
    }
}
