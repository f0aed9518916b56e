use crate::compare::{CompareError, Differences, Judgment, Measured as Counted, PictureJob};
use crate::geometry::Picture;
use crate::ui::CompareReport;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

/// How long the view must stand still before what takes longer is measured.
const STILL: Duration = Duration::from_millis(150);

/// Two pictures to measure.
pub(super) struct Job {
    /// Larger than that of every job before.
    pub number: u64,
    /// A is the reference, B the live view.
    pub pictures: PictureJob,
}

/// What has been found out about a job.
pub(super) struct Measured {
    number: u64,
    /// The picture of the differences, if it is new.
    pub heat_map: Option<Picture>,
    what: What,
}

enum What {
    Counts(Differences),
    Judgment(Judgment),
    Problem(CompareError),
}

impl Measured {
    /// Adds it to `report`; `newest` is the number of the newest job.
    pub fn into_report(self, report: &mut CompareReport, newest: u64) {
        let is_newest = self.number == newest;
        match self.what {
            What::Counts(counts) => {
                report.differences = Some(counts);
                report.problem = None;
            }
            What::Judgment(judgment) => {
                report.judgment = Some(judgment);
                report.measuring = !is_newest;
            }
            What::Problem(problem) => {
                report.problem = Some(problem);
                report.differences = None;
                report.judgment = None;
                report.measuring = !is_newest;
            }
        }
    }
}

/// Measures in a thread of its own, always the newest job; jobs that it could not begin in time
/// are left out. Ends when it is dropped.
pub(super) struct Measurer {
    jobs: Sender<Job>,
    results: Receiver<Measured>,
}

impl Measurer {
    /// `wake` is called whenever there is a result.
    ///
    /// # Errors
    /// If the system has no thread to spare.
    pub fn new(wake: impl Fn() + Send + 'static) -> std::io::Result<Self> {
        let (jobs, waiting) = channel();
        let (finished, results) = channel();
        let tell = move |measured| {
            let told = finished.send(measured).is_ok();
            wake();
            told
        };
        std::thread::Builder::new()
            .name("comparing".to_owned())
            .spawn(move || work(&waiting, &tell))?;
        Ok(Self { jobs, results })
    }

    /// Measures `job` instead of all before.
    pub fn start(&self, job: Job) {
        // Without its thread there are no results; nothing else could be done about it.
        let _ = self.jobs.send(job);
    }

    /// The next result, if there is one.
    pub fn result(&self) -> Option<Measured> {
        self.results.try_recv().ok()
    }
}

/// Until nobody waits for results any more.
fn work(waiting: &Receiver<Job>, tell: &impl Fn(Measured) -> bool) {
    let mut next = waiting.recv().ok();
    while let Some(job) = next.take() {
        let job = waiting.try_iter().last().unwrap_or(job);
        let number = job.number;
        let told = |what, heat_map| {
            tell(Measured {
                number,
                heat_map,
                what,
            })
        };
        match job.pictures.measure() {
            Ok(Counted {
                differences,
                heat_map,
            }) => {
                if !told(What::Counts(differences), Some(heat_map)) {
                    return;
                }
            }
            Err(error) => {
                if !told(What::Problem(error), None) {
                    return;
                }
                next = waiting.recv().ok();
                continue;
            }
        }
        next = match waiting.recv_timeout(STILL) {
            Ok(newer) => Some(newer),
            Err(RecvTimeoutError::Disconnected) => return,
            Err(RecvTimeoutError::Timeout) => {
                let what = job.pictures.judge();
                if !told(what.map_or_else(What::Problem, What::Judgment), None) {
                    return;
                }
                waiting.recv().ok()
            }
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::Area;
    use std::sync::Arc;

    /// A gray square in a dark picture, `right` pixels further right.
    fn square(right: usize) -> Arc<Picture> {
        let (width, height) = (64, 48);
        let gray = |i: usize| {
            let (x, y) = (i % width, i / width);
            let inside = (20 + right..40 + right).contains(&x) && (10..30).contains(&y);
            if inside { (80 + x * y % 100) as u8 } else { 26 }
        };
        Arc::new(Picture {
            width: width as u32,
            height: height as u32,
            rgba: (0..width * height)
                .flat_map(|i| [gray(i), gray(i), gray(i), 255])
                .collect(),
        })
    }

    fn job(number: u64, live: Arc<Picture>, ignore: Vec<Area>) -> Job {
        Job {
            number,
            pictures: PictureJob {
                a: square(0),
                b: live,
                threshold: 0,
                ignore,
            },
        }
    }

    /// The report once the newest job is finished.
    fn report_of(jobs: Vec<Job>) -> CompareReport {
        let measurer = Measurer::new(|| {}).expect("a thread");
        let newest = jobs.last().map_or(0, |job| job.number);
        for job in jobs {
            measurer.start(job);
        }
        let mut report = CompareReport {
            measuring: true,
            ..CompareReport::default()
        };
        while report.measuring {
            let measured = measurer.results.recv().expect("a result");
            measured.into_report(&mut report, newest);
        }
        report
    }

    #[test]
    fn equal_pictures_have_no_differing_pixel_and_nothing_to_say() {
        let report = report_of(vec![job(1, square(0), Vec::new())]);
        let counts = report.differences.unwrap();
        assert_eq!((counts.differing_pixels, counts.max), (0, 0));
        assert_eq!(counts.psnr, f64::INFINITY);
        let judgment = report.judgment.unwrap();
        assert!(judgment.findings.is_empty(), "{:?}", judgment.findings);
        assert_eq!((judgment.ssim, judgment.flip), (Some(1.0), 0.0));
    }

    #[test]
    fn of_several_jobs_the_newest_is_the_one_reported() {
        let jobs = (1..=9).map(|n| job(n, square(n as usize % 9), Vec::new()));
        let report = report_of(jobs.collect());
        assert_eq!(report.differences.unwrap().differing_pixels, 0);
    }

    #[test]
    fn masking_everything_is_a_problem_that_is_told() {
        let all = "0,0,64,48".parse().unwrap();
        let report = report_of(vec![job(1, square(3), vec![all])]);
        assert!(report.problem.is_some() && report.differences.is_none());
    }
}
