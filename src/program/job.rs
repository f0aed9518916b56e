use crate::compare::{CompareError, Judgment, Measured, PictureJob};
use crate::geometry::Picture;
use crate::io::image::{self, PictureFormat};
use crate::revision::Revision;
use std::path::PathBuf;

/// Work that a host does beside the program. It is plain data, so that a host may hand it to a
/// thread, to a worker with a memory of its own, or do it on the spot.
#[derive(Clone, Debug)]
pub struct Job(pub(super) Work);

/// The kinds of work.
#[derive(Clone, Debug)]
pub(super) enum Work {
    /// Compares two pictures.
    Compare(CompareWork),
    /// Makes a picture the content of the file at `path`.
    Encode {
        path: PathBuf,
        picture: Picture,
        format: PictureFormat,
    },
}

/// Measuring of two pictures.
#[derive(Clone, Debug)]
pub(super) struct CompareWork {
    /// State of the two pictures.
    pub of: Revision,
    pub step: Step,
    /// A is the reference, B the live view.
    pub pictures: PictureJob,
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
pub struct JobResult(pub(super) Finished);

/// Results of the kinds of work.
#[derive(Debug)]
pub(super) enum Finished {
    Compared(Compared),
    Encoded {
        path: PathBuf,
        bytes: Result<Vec<u8>, String>,
    },
}

/// Result of measuring two pictures.
#[derive(Debug)]
pub(super) struct Compared {
    pub of: Revision,
    pub outcome: Result<Outcome, CompareError>,
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
        JobResult(match self.0 {
            Work::Compare(work) => Finished::Compared(work.run()),
            Work::Encode {
                path,
                picture,
                format,
            } => Finished::Encoded {
                path,
                bytes: image::encode(&picture, format),
            },
        })
    }
}

impl CompareWork {
    fn run(self) -> Compared {
        Compared {
            of: self.of,
            outcome: match self.step {
                Step::Measure => self.pictures.measure().map(Outcome::Measured),
                Step::Judge => self.pictures.judge().map(Outcome::Judged),
            },
        }
    }
}
