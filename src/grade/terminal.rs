//! The report as text: a row a submission.

use super::graded::Outcome;
use super::name::Name;
use super::report::Report;
use std::collections::{BTreeMap, BTreeSet};

/// Names of submissions that a reason has; the others are counted.
const NAMES: usize = 8;
/// Letters of a reason.
const LETTERS: usize = 160;

/// What is told of points that wait.
const WAITING: &str = "wait: points that are still to be given by hand, by \"given\" in the rubric, in sections with -";

impl Report {
    /// Lines for a terminal: a heading, a row for each submission, what points that wait are, mistakes that several of
    /// them have, which of them cost points in another section than their own, why files could not be graded, and who has
    /// files that a person has to look at.
    pub fn to_lines(&self) -> Vec<String> {
        let heading = ["submission".to_owned(), "points".to_owned()].into_iter();
        let heading = heading.chain(self.sections.iter().map(|section| section.section.clone()));
        let mut table: Vec<Vec<String>> = vec![heading.chain(["result".to_owned()]).collect()];
        for submission in &self.submissions {
            let mut row = vec![
                submission.name.clone(),
                match (submission.graded(), submission.not_graded) {
                    (graded, 0.0) => format!("{}/{graded}", submission.points),
                    (graded, open) => format!("{}/{graded} ({open} wait)", submission.points),
                },
            ];
            for section in &self.sections {
                let points = submission.sections.get(&section.section).copied().flatten();
                row.push(match points {
                    Some(points) => format!("{points}/{}", section.possible),
                    None if section.extra => "none".to_owned(),
                    None => format!("-/{}", section.possible),
                });
            }
            let wrong = submission.summaries().into_iter().map(|(summary, tests)| {
                // What is the same in all tests needs no list of them.
                if tests.len() == submission.tests.len() {
                    summary
                } else {
                    format!("{summary} ({})", tests.join(", "))
                }
            });
            let wrong: Vec<String> = wrong.collect();
            row.push(if wrong.is_empty() {
                "right".to_owned()
            } else {
                wrong.join("; ")
            });
            table.push(row);
        }
        let mut lines = aligned(&table);
        if self.submissions.iter().any(|one| one.not_graded > 0.0) {
            lines.push(WAITING.to_owned());
        }
        for group in self
            .mistakes
            .iter()
            .filter(|group| group.submissions.len() > 1)
        {
            let names: Vec<&str> = group.submissions.keys().map(Name::as_str).collect();
            lines.push(format!(
                "{} in {} submissions: {}",
                group.id,
                names.len(),
                names.join(", ")
            ));
        }
        lines.extend(self.elsewhere());
        lines.extend(self.reasons());
        lines.extend(self.to_look_at());
        lines
    }

    /// In which other sections mistakes cost points, each once with the tests that it is about.
    fn elsewhere(&self) -> Vec<String> {
        let mut by_sentence: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for test in self.submissions.iter().flat_map(|one| &one.tests) {
            for sentence in &test.elsewhere {
                by_sentence.entry(sentence).or_default().insert(&test.test);
            }
        }
        let lines = by_sentence.into_iter().map(|(sentence, tests)| {
            let tests: Vec<&str> = tests.into_iter().collect();
            format!("{sentence} ({})", tests.join(", "))
        });
        lines.collect()
    }

    /// Why files could not be graded, each reason once, with the submissions that it is about.
    fn reasons(&self) -> impl Iterator<Item = String> {
        let mut by_reason: BTreeMap<(&str, String), BTreeSet<Name>> = BTreeMap::new();
        for submission in &self.submissions {
            for test in &submission.tests {
                if is_ungraded(test.outcome) {
                    let text = match test.outcome {
                        // What a file says may be a page; a blank one is told in words of ours.
                        Outcome::Blank => test.text.clone(),
                        _ => in_one_line(&test.text),
                    };
                    let reason = (test.outcome.word(), text);
                    by_reason
                        .entry(reason)
                        .or_default()
                        .insert(Name::from(&*submission.name));
                }
            }
        }
        let all = self.submissions.len();
        by_reason.into_iter().map(move |((word, reason), names)| {
            let told: Vec<&str> = names.iter().map(Name::as_str).collect();
            let who = match names.len() {
                count if count == all && all > 1 => format!("all {all} submissions"),
                _ => some_of(&told, ", "),
            };
            format!("{word}: {reason} ({who})")
        })
    }

    /// Who has files of which nothing is known, with their tests unless it is all of them.
    fn to_look_at(&self) -> Option<String> {
        let who = self.submissions.iter().filter_map(|submission| {
            let unknown = submission.tests.iter().filter(|test| test.is_unknown());
            let unknown: Vec<&str> = unknown.map(|test| &*test.test).collect();
            let name = &submission.name;
            match unknown.len() {
                0 => None,
                count if count == submission.tests.len() => Some(name.clone()),
                _ => Some(format!("{name}: {}", unknown.join(", "))),
            }
        });
        let who: Vec<String> = who.collect();
        let who: Vec<&str> = who.iter().map(String::as_str).collect();
        let word = Outcome::Unexplained.word();
        (!who.is_empty())
            .then(|| format!("{word}: to be looked at by hand ({})", some_of(&who, "; ")))
    }
}

/// The first of `names`, and how many more there are.
fn some_of(names: &[&str], separator: &str) -> String {
    let told = names[..names.len().min(NAMES)].join(separator);
    match names.len().saturating_sub(NAMES) {
        0 => told,
        more => format!("{told} and {more} more"),
    }
}

/// Whether there was nothing to diagnose.
fn is_ungraded(outcome: Outcome) -> bool {
    match outcome {
        Outcome::Right | Outcome::Explained | Outcome::OtherPose | Outcome::Unexplained => false,
        Outcome::Blank | Outcome::Missing | Outcome::Unreadable | Outcome::Failed => true,
    }
}

/// A text whose lines are joined. Of a long one the beginning, which says what happened, and the end, where the
/// message of a program is.
fn in_one_line(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let letters: Vec<char> = line.chars().collect();
    if letters.len() <= LETTERS {
        return line;
    }
    let part = |letters: &[char]| letters.iter().collect::<String>();
    let (first, last) = (LETTERS / 3, LETTERS - LETTERS / 3);
    let (first, last) = (
        part(&letters[..first]),
        part(&letters[letters.len() - last..]),
    );
    // Whole words, unless one is as long as all of that.
    let first = first.rsplit_once(' ').map_or(&*first, |(words, _)| words);
    let last = last.split_once(' ').map_or(&*last, |(_, words)| words);
    format!("{first} … {last}")
}

/// Rows with their cells, all but the last, below one another.
fn aligned(table: &[Vec<String>]) -> Vec<String> {
    let columns = table.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = table.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let rows = table.iter().map(|row| {
        let cells = row
            .iter()
            .zip(&widths)
            .enumerate()
            .map(|(column, (cell, &width))| {
                if column + 1 == row.len() {
                    cell.clone()
                } else {
                    format!("{cell:width$}")
                }
            });
        cells.collect::<Vec<_>>().join("  ")
    });
    rows.collect()
}
