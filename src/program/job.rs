use super::page_figure::compare_figures;
use crate::compare::{CompareError, Judgment, Measured, PictureJob};
use crate::diagnose::{DiagnoseError, Diagnosis, MeshJob};
use crate::geometry::Picture;
use crate::io::image::{self, PictureFormat};
use crate::io::{ReadFiles, ReadJob};
use crate::revision::Revision;
use crate::steps::Steps;
use crate::ui::PageFigure;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::Duration;

/// Work that a host does beside the program: on a thread, or step by step between its frames.
#[derive(Clone, Debug)]
pub struct Job {
    work: Work,
    told: Arc<Told>,
}

/// A job under way, which the thread that began it goes on with.
pub struct RunningJob {
    steps: Steps<'static, JobResult>,
    told: Arc<Told>,
}

/// The program's end of a job. The job is given up when this is dropped.
#[derive(Debug)]
pub(super) struct JobHandle(Arc<Told>);

/// What the program and a job tell each other.
#[derive(Debug, Default)]
struct Told {
    /// The part that is done, from 0 to 1: the bits of an `f32`.
    part: AtomicU32,
    is_given_up: AtomicBool,
}

/// The kinds of work.
#[derive(Clone, Debug)]
pub(super) enum Work {
    /// Compares two pictures.
    Compare(CompareWork),
    /// Finds out which mistake gives a mesh.
    Diagnose {
        /// Pose that the mesh is held against.
        of: Revision,
        mesh: MeshJob,
    },
    /// Reads files.
    Read {
        /// Request that this answers.
        of: Revision,
        job: ReadJob,
        /// Time for which the program would rather wait.
        patience: Duration,
    },
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
    pub half: Half,
    /// Whether A is a screenshot of the Virtual Mannequin's page.
    pub is_page: bool,
    /// Whether B has smooth edges if A has, as far as that is known.
    pub are_edges_alike: bool,
    /// A is the reference, B the live view.
    pub pictures: PictureJob,
}

/// A half of the measuring of two pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Half {
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
    Diagnosed(Box<MeshDiagnosed>),
    Read {
        of: Revision,
        read: ReadFiles,
    },
    Encoded {
        path: PathBuf,
        bytes: Result<Vec<u8>, String>,
    },
    /// Nobody wants the result any more.
    GivenUp,
}

/// Result of measuring two pictures.
#[derive(Debug)]
pub(super) struct Compared {
    pub of: Revision,
    pub outcome: Result<Outcome, CompareError>,
}

/// Result of looking for the mistake that gives a mesh.
#[derive(Debug)]
pub(super) struct MeshDiagnosed {
    pub of: Revision,
    pub outcome: Result<Diagnosis, DiagnoseError>,
}

/// Findings about two pictures.
#[derive(Debug)]
pub(super) enum Outcome {
    Measured(Measured),
    Judged {
        judgment: Judgment,
        /// See [`CompareReport`](crate::ui::CompareReport).
        page_figure: Option<Box<PageFigure>>,
    },
}

impl Job {
    pub(super) fn new(work: Work) -> Self {
        Self {
            work,
            told: Arc::default(),
        }
    }

    /// The program's end of it.
    pub(super) fn handle(&self) -> JobHandle {
        JobHandle(Arc::clone(&self.told))
    }

    /// Time for which a host may keep everything else waiting for it: what is done by then is there in
    /// the frame that asked for it.
    pub fn patience(&self) -> Duration {
        match self.work {
            Work::Read { patience, .. } => patience,
            Work::Compare(_) | Work::Diagnose { .. } | Work::Encode { .. } => Duration::ZERO,
        }
    }

    /// Begins the work, of which nothing is done yet.
    pub fn begin(self) -> RunningJob {
        RunningJob {
            steps: self.work.begin(),
            told: self.told,
        }
    }

    /// Does the work, unless it is given up meanwhile.
    pub fn run(self) -> JobResult {
        let mut job = self.begin();
        loop {
            if let Some(result) = job.step() {
                return result;
            }
        }
    }
}

impl RunningJob {
    /// Does the next step, which takes some milliseconds at most where the work can be interrupted, and
    /// returns the result if it was the last one.
    pub fn step(&mut self) -> Option<JobResult> {
        if self.told.is_given_up.load(Ordering::Relaxed) {
            return Some(JobResult(Finished::GivenUp));
        }
        let result = self.steps.step();
        let part = self.steps.part().to_bits();
        self.told.part.store(part, Ordering::Relaxed);
        result
    }
}

impl JobHandle {
    /// Estimate of the part that is done, from 0 to 1.
    pub fn part(&self) -> f32 {
        f32::from_bits(self.0.part.load(Ordering::Relaxed))
    }
}

impl Drop for JobHandle {
    fn drop(&mut self) {
        self.0.is_given_up.store(true, Ordering::Relaxed);
    }
}

impl Work {
    fn begin(self) -> Steps<'static, JobResult> {
        match self {
            Self::Compare(work) => work.begin(),
            Self::Diagnose { of, mesh } => mesh.diagnose().map(move |outcome| {
                JobResult(Finished::Diagnosed(Box::new(MeshDiagnosed { of, outcome })))
            }),
            Self::Read { of, job, .. } => job
                .read()
                .map(move |read| JobResult(Finished::Read { of, read })),
            Self::Encode {
                path,
                picture,
                format,
            } => Steps::whole(move || {
                JobResult(Finished::Encoded {
                    path,
                    bytes: image::encode(&picture, format),
                })
            }),
        }
    }
}

impl CompareWork {
    fn begin(self) -> Steps<'static, JobResult> {
        let of = self.of;
        let compared = move |outcome| JobResult(Finished::Compared(Compared { of, outcome }));
        match self.half {
            Half::Measure => {
                let measured = self.pictures.measure();
                measured.map(move |measured| compared(measured.map(Outcome::Measured)))
            }
            Half::Judge => {
                let [a, b] = [&self.pictures.a, &self.pictures.b].map(Arc::clone);
                let (is_page, are_edges_alike) = (self.is_page, self.are_edges_alike);
                let judged = self.pictures.judge();
                judged.map(move |judgment| {
                    compared(judgment.map(|judgment| {
                        Outcome::Judged {
                            judgment,
                            page_figure: is_page
                                .then(|| compare_figures(&a, &b, are_edges_alike))
                                .flatten()
                                .map(Box::new),
                        }
                    }))
                })
            }
        }
    }
}
