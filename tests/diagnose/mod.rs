//! Diagnosing: which mistake in skinning gives a mesh. The meshes come from a program of its own
//! (`student.rs`), which shares no formula with the library.

mod beside;
mod choices;
mod collada;
mod correct;
mod documents;
mod explained;
mod faces;
pub mod figures;
mod mistaken;
mod one_joint;
mod other_poses;
mod pairs;
mod picture_pairs;
mod pictures;
mod placed;
mod program;
mod same;
mod steps;
pub mod student;
mod unexplained;
mod whole_program;

use editor_core::diagnose::{Diagnosis, Verdict};

/// Mistakes that together give a mesh, by name: which accounts for more is another matter.
fn sorted(found: &Diagnosis) -> Vec<&'static str> {
    let mut together = found.together();
    together.sort_unstable();
    together
}

/// The causes that are named for a mesh, each with those that are made beside it.
fn named(found: &Diagnosis) -> Vec<Vec<&'static str>> {
    let first = (found.verdict == Verdict::Explained).then(|| found.together());
    first.into_iter().chain(found.same_as.clone()).collect()
}
