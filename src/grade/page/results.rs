//! The results of submissions: a table, and what was found in each test.

use super::{Escaped, Page};
use crate::grade::graded::Outcome;
use crate::grade::report::{GradedTest, Report, Submission};
use crate::grade::why::percent;

/// Letters of labels in a diagnosis, such as `look at`, with the spaces around them.
const LABEL: usize = 11;

impl Page {
    pub(super) fn submissions(&mut self, report: &Report) {
        self.add(format_args!(
            "<h2>Submissions</h2>\n<div class=\"wide\"><table class=\"class\">\n<thead><tr><th>Submission</th>\
             <th class=\"number\">Points</th>"
        ));
        for section in &report.sections {
            self.add(format_args!(
                "<th class=\"number\">{} <span class=\"dim\">of {}</span></th>",
                Escaped(&section.section),
                section.possible
            ));
        }
        self.add(format_args!(
            "<th class=\"result\">Result</th></tr></thead>\n<tbody>\n"
        ));
        for (number, submission) in report.submissions.iter().enumerate() {
            self.add(format_args!(
                "<tr><td class=\"name\"><a href=\"#s{number}\">{}</a></td><td class=\"number\">{} <span class=\"dim\">of {}</span></td>",
                Escaped(&submission.name),
                submission.points,
                submission.graded()
            ));
            for (points, section) in submission.sections.values().zip(&report.sections) {
                match points {
                    Some(points) => self.add(format_args!("<td class=\"number\">{points}</td>")),
                    None if section.extra => self.add(format_args!("<td></td>")),
                    None => self.add(format_args!("<td class=\"number dim\">not yet</td>")),
                }
            }
            self.add(format_args!("<td>"));
            self.chips(submission);
            self.add(format_args!("</td></tr>\n"));
        }
        self.add(format_args!("</tbody></table></div>\n<h2>Results</h2>\n"));
        for (number, submission) in report.submissions.iter().enumerate() {
            self.submission(report, number, submission, false);
        }
    }

    /// What was found in a submission, folded away unless it `is_open`.
    pub(super) fn submission(
        &mut self,
        report: &Report,
        number: usize,
        submission: &Submission,
        is_open: bool,
    ) {
        let name = Escaped(&submission.name);
        let open = match submission.not_graded {
            0.0 => String::new(),
            open => format!("<span class=\"dim\">, {open} more not graded yet</span>"),
        };
        self.add(format_args!(
            "<details{}><summary><h3>{name}</h3><span class=\"number\">{} of {}{open}</span><span>",
            if is_open { " open=\"open\"" } else { "" },
            submission.points,
            submission.graded()
        ));
        self.chips(submission);
        // A link to what is inside of it opens it, without a script.
        self.add(format_args!(
            "</span></summary>\n<div id=\"s{number}\" class=\"results\">\n"
        ));
        for note in &submission.notes {
            self.add(format_args!(
                "<p class=\"note dim\">{}</p>\n",
                Escaped(note)
            ));
        }
        for (test, row) in submission.tests.iter().zip(&report.tests) {
            self.add(format_args!("<div class=\"test\">"));
            if test.picture.is_some() {
                self.add(format_args!("<figure>"));
                let shown = format!(
                    "what {} gives for {}, and where it is off",
                    submission.name, test.test
                );
                self.picture(test.picture.as_deref(), &shown);
                self.add(format_args!("</figure>"));
            }
            self.add(format_args!("<div><h4>{} ", Escaped(&test.test)));
            self.chip(test);
            self.add(format_args!("</h4>"));
            let points = row.points.iter().map(|(section, possible)| {
                let points = test.points.get(section).copied().unwrap_or(0.0);
                format!("{section}: {points} of {possible}")
            });
            let points = points.collect::<Vec<_>>().join(", ");
            let whole = if row.kind == "mesh" {
                "vertices"
            } else {
                "silhouette"
            };
            let agrees = match test.outcome {
                // A mesh that is known to be right as a whole has no vertex that is where it was expected.
                Outcome::Unexplained if test.hint.is_some() && test.agrees < 0.01 => String::new(),
                Outcome::Explained | Outcome::OtherPose | Outcome::Unexplained => {
                    format!(" · {} of the {whole} right", percent(test.agrees))
                }
                _ => String::new(),
            };
            self.add(format_args!(
                "<p class=\"dim\">{}{agrees}</p>",
                Escaped(&points)
            ));
            for sentence in &test.why {
                self.add(format_args!("<p class=\"why\">{}</p>", Escaped(sentence)));
            }
            self.lines(&test.text);
            self.add(format_args!("</div></div>\n"));
        }
        self.add(format_args!("</div>\n</details>\n"));
    }

    /// A text in lines. One of a diagnosis that has a label goes on below its words where it is too long.
    fn lines(&mut self, text: &str) {
        self.add(format_args!("<pre>"));
        for line in text.lines() {
            let is_labeled =
                line.starts_with("  ") && line.as_bytes().get(LABEL - 1) == Some(&b' ');
            let class = if is_labeled { " class=\"told\"" } else { "" };
            self.add(format_args!("<span{class}>{}</span>", Escaped(line)));
        }
        self.add(format_args!("</pre>"));
    }

    /// What is wrong with a submission, each thing once.
    fn chips(&mut self, submission: &Submission) {
        let wrong = submission.summaries();
        if wrong.is_empty() {
            self.add(format_args!("<span class=\"chip right\">right</span>"));
        }
        for (summary, tests) in wrong {
            let of = submission.tests.len();
            let first = submission
                .tests
                .iter()
                .find(|test| test.summary() == summary);
            let class = first.map_or("", class);
            let count = if tests.len() == of {
                String::new()
            } else {
                format!(" ({})", tests.join(", "))
            };
            self.add(format_args!(
                "<span class=\"chip {class}\">{}{}</span>",
                Escaped(&summary),
                Escaped(&count)
            ));
        }
    }

    fn chip(&mut self, test: &GradedTest) {
        let (class, summary) = (class(test), test.summary());
        self.add(format_args!(
            "<span class=\"chip {class}\">{}</span>",
            Escaped(&summary)
        ));
    }
}

/// The kind of a result, for its color.
fn class(test: &GradedTest) -> &'static str {
    match test.outcome {
        Outcome::Right => "right",
        Outcome::Explained | Outcome::OtherPose | Outcome::Unexplained => "wrong",
        Outcome::Blank | Outcome::Missing | Outcome::Unreadable | Outcome::Failed => "none",
    }
}
