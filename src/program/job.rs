use crate::compare::{CompareError, Judgment, Measured, PictureJob};
use crate::revision::Revision;

/// Work that a host does beside the program. It is plain data, so that a host may hand it to a
/// thread, to a worker with a memory of its own, or do it on the spot.
#[derive(Clone, Debug)]
pub struct Job {
    /// State of the two pictures.
    pub(super) of: Revision,
    pub(super) step: Step,
    /// A is the reference, B the live view.
    pub(super) pictures: PictureJob,
}

/// A part of the measuring of two pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// Differences pixel by pixel, which are quick to find.
    Measure,
    /// How alike the pictures look, and why they differ.
    Judge,
}

/// Result of a job.
#[derive(Debug)]
pub struct JobResult {
    pub(super) of: Revision,
    pub(super) outcome: Result<Outcome, CompareError>,
}

/// Findings about two pictures.
#[derive(Debug)]
pub(super) enum Outcome {
    Measured(Measured),
    Judged(Judgment),
}

impl Job {
    /// Does the work.
    pub fn run(self) -> JobResult {
        JobResult {
            of: self.of,
            outcome: match self.step {
                Step::Measure => self.pictures.measure().map(Outcome::Measured),
                Step::Judge => self.pictures.judge().map(Outcome::Judged),
            },
        }
    }
}
