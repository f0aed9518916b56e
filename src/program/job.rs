use crate::compare::{CompareError, Pair};
use crate::geometry::Picture;
use crate::math::Area;
use crate::revision::Revision;
use crate::ui::{CompareCounts, CompareJudgment};
use std::sync::Arc;

/// Work that a host does beside the program. It is plain data, so that a host may hand it to a
/// thread, to a worker with a memory of its own, or do it on the spot.
#[derive(Clone, Debug)]
pub struct Job {
    /// Which state of the two pictures this is about.
    pub(super) of: Revision,
    pub(super) step: Step,
    /// A.
    pub(super) reference: Arc<Picture>,
    /// B.
    pub(super) live: Arc<Picture>,
    /// A pixel differs if a channel does by more than this, of 255.
    pub(super) threshold: u8,
    /// Areas that are left out.
    pub(super) ignore: Vec<Area>,
}

/// A part of the measuring of two pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// Differences pixel by pixel, which are quick to find.
    Count,
    /// How alike the pictures look, and why they differ.
    Judge,
}

/// What came of a job.
#[derive(Debug)]
pub struct JobResult {
    pub(super) of: Revision,
    pub(super) finding: Result<Finding, CompareError>,
}

/// What was found out about two pictures.
#[derive(Debug)]
pub(super) enum Finding {
    Counted {
        counts: CompareCounts,
        heat_map: Picture,
    },
    Judged(CompareJudgment),
}

impl Job {
    /// Does the work.
    pub fn run(self) -> JobResult {
        let pair = Pair::new(&self.reference, &self.live, &self.ignore);
        let finding = pair.map(|pair| match self.step {
            Step::Count => Finding::Counted {
                counts: counts(&pair, self.threshold),
                heat_map: pair.heat_map(),
            },
            Step::Judge => Finding::Judged(judgment(&pair)),
        });
        JobResult {
            of: self.of,
            finding,
        }
    }
}

fn counts(pair: &Pair, threshold: u8) -> CompareCounts {
    let differences = pair.differences(threshold);
    CompareCounts {
        compared: differences.compared_pixels,
        differing: differences.differing_pixels,
        drawn: differences.drawn_pixels,
        drawn_differing: differences.drawn_pixels_above(threshold),
        max: differences.max,
        mean: differences.mean,
        psnr: differences.psnr,
    }
}

fn judgment(pair: &Pair) -> CompareJudgment {
    let findings = pair.findings().into_iter();
    let findings = findings.map(|f| sentence(&f.to_string()));
    CompareJudgment {
        ssim: pair.ssim(),
        flip: pair.flip().mean,
        findings: findings.collect(),
    }
}

/// With a capital letter and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase);
    let first: String = first.into_iter().flatten().collect();
    format!("{first}{}.", letters.as_str())
}
