//! The report as a table for a gradebook.

use super::report::Report;
use super::section::Section;

impl Report {
    /// A row a submission as comma-separated values (RFC 4180): name, points, points that are possible,
    /// how many of these nobody has given yet, points of each section, and what is wrong. Points that a person has not
    /// given yet are empty.
    pub fn to_csv(&self) -> String {
        let mut csv = String::new();
        let sections = self.sections.iter().map(Section::name);
        let fixed = ["submission", "points", "possible", "not graded"]
            .map(str::to_owned)
            .into_iter();
        line(&mut csv, fixed.chain(sections).chain(["result".to_owned()]));
        for submission in &self.submissions {
            let first = [
                submission.name.clone(),
                submission.points.to_string(),
                submission.possible.to_string(),
                submission.not_graded.to_string(),
            ];
            let points = submission.sections.values();
            let points =
                points.map(|points| points.map_or(String::new(), |points| points.to_string()));
            let wrong = submission
                .summaries()
                .into_iter()
                .map(|(summary, tests)| format!("{summary} ({})", tests.join(", ")));
            let wrong: Vec<String> = wrong.collect();
            let result = if wrong.is_empty() {
                "right".to_owned()
            } else {
                wrong.join("; ")
            };
            line(&mut csv, first.into_iter().chain(points).chain([result]));
        }
        csv
    }
}

fn line(csv: &mut String, cells: impl Iterator<Item = String>) {
    let cells: Vec<String> = cells.map(|cell| quoted(&cell)).collect();
    *csv += &cells.join(",");
    *csv += "\r\n";
}

/// A cell, in quotes where it needs them. An apostrophe keeps spreadsheets from running a text as a
/// formula.
fn quoted(cell: &str) -> String {
    let is_formula = cell.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let is_number = cell.parse::<f64>().is_ok();
    let cell = if is_formula && !is_number {
        format!("'{cell}")
    } else {
        cell.to_owned()
    };
    if cell.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_with_commas_and_quotes_are_quoted() {
        assert_eq!(quoted("a b"), "a b");
        assert_eq!(quoted("a,\"b\""), "\"a,\"\"b\"\"\"");
    }
}
