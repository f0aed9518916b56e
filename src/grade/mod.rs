//! Grading: what the files of a class are worth. A [`Test`] tells what a file is, by its bytes alone; a
//! [`Report`] gives the points by the rubric, finds mistakes that several submissions share, and
//! writes all of it as JSON, as a table for a gradebook, as text and as a page. Nothing here opens a
//! file or runs a program, and everything is the same on each run.

mod by_vertices;
mod canvas;
mod csv;
mod found;
mod graded;
mod kept;
mod late;
mod mistake_section;
mod name;
mod nearness;
mod page;
mod report;
mod rubric;
mod section;
mod settled;
mod shares;
mod style;
mod terminal;
mod test;
mod thumbnail;
mod why;

pub use graded::{Graded, Outcome};
pub use mistake_section::{is_numbered, without_mistakes};
pub use name::Name;
pub use report::{GradedTest, MistakeGroup, Report, Row, Submission};
pub use section::Section;
pub use test::Test;
