//! The report as text: a row a submission.

use super::report::Report;

impl Report {
    /// Lines for a terminal: a heading, a row for each submission, and mistakes that several of them
    /// have.
    pub fn to_lines(&self) -> Vec<String> {
        let heading = ["submission".to_owned(), "points".to_owned()].into_iter();
        let heading = heading.chain(self.sections.iter().map(|section| section.section.clone()));
        let mut table: Vec<Vec<String>> = vec![heading.chain(["result".to_owned()]).collect()];
        for submission in &self.submissions {
            let mut row = vec![
                submission.name.clone(),
                format!("{}/{}", submission.points, submission.possible),
            ];
            for section in &self.sections {
                let points = submission.sections.get(&section.section).copied().flatten();
                let points = points.map_or("-".to_owned(), |points| points.to_string());
                row.push(format!("{points}/{}", section.possible));
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
        for group in self
            .mistakes
            .iter()
            .filter(|group| group.submissions.len() > 1)
        {
            let names: Vec<&str> = group.submissions.keys().map(|name| &**name).collect();
            lines.push(format!(
                "{} in {} submissions: {}",
                group.id,
                names.len(),
                names.join(", ")
            ));
        }
        lines
    }
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
