//! Files that are read beside the program, so that it goes on meanwhile: what is imported, and
//! documents that are opened. One request is carried out after the other, each as a whole.

use super::Host;
use super::autosave::Kept;
use super::document::{Next, ToOpen};
use super::files::file_name;
use super::job::{Job, JobHandle, Work};
use super::running::Program;
use crate::editor::Severity;
use crate::io::{Files, Loaded, ReadFiles, ReadJob};
use crate::revision::Revision;
use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

/// Time for which a frame waits for files, so that small ones are there in the frame that asked.
const PATIENCE: Duration = Duration::from_millis(20);
/// The same before the first frame, when nobody sees that the program waits.
const PATIENCE_AT_START: Duration = Duration::from_secs(1);
/// Time after which progress is shown: what takes less would only flicker.
const SHOWN_AFTER: Duration = Duration::from_millis(100);
/// Time between two looks at the progress.
const LOOK: Duration = Duration::from_millis(100);

/// What becomes of files that were read.
pub(super) enum Use {
    /// They are added to the document.
    Import,
    /// So are they, beside the shapes that they are copies of.
    Paste,
    /// They take the place of the document, and `others` are added to it. Messages before `since` are about the
    /// document before.
    Open { others: Vec<PathBuf>, since: u64 },
    /// They are the first document, compared with a picture if there is one.
    Start(Option<PathBuf>),
    /// They are what an earlier run left.
    Restore(Box<Kept>),
}

/// A document that was read, to be shown.
#[derive(Clone)]
pub(super) struct Opened {
    pub path: PathBuf,
    /// Files that are added to it.
    pub others: Vec<PathBuf>,
    /// Number of the first message about it.
    pub since: u64,
    pub files: Arc<dyn Files>,
    pub loaded: Loaded,
}

/// Requests to read files, in the order in which they came.
#[derive(Default)]
pub(super) struct Readings {
    running: Option<Running>,
    waiting: VecDeque<Request>,
}

struct Request {
    job: ReadJob,
    becomes: Use,
}

/// The request that is being carried out.
struct Running {
    request: Request,
    of: Revision,
    job: JobHandle,
    since: Duration,
    /// Result, once it is there.
    read: Option<ReadFiles>,
}

impl Request {
    /// Names of its files, of many the first.
    fn name(&self) -> String {
        let first = self.job.paths.first().map(|path| file_name(path));
        let first = first.unwrap_or_default();
        match self.job.paths.len().saturating_sub(1) {
            0 => first,
            more => format!("{first} and {more} more"),
        }
    }
}

impl Readings {
    fn requests(&self) -> impl Iterator<Item = &Request> {
        let running = self.running.iter().map(|running| &running.request);
        running.chain(&self.waiting)
    }
}

impl Program {
    /// Has the files of `job` read, after all others that are, and uses them then.
    pub(super) fn read(&mut self, job: ReadJob, becomes: Use, host: &mut dyn Host) {
        self.readings.waiting.push_back(Request { job, becomes });
        self.read_next(host);
    }

    fn read_next(&mut self, host: &mut dyn Host) {
        if self.readings.running.is_some() {
            return;
        }
        let Some(request) = self.readings.waiting.pop_front() else {
            return;
        };
        let of = Revision::new();
        let patience = match request.becomes {
            Use::Start(_) => PATIENCE_AT_START,
            _ => PATIENCE,
        };
        let job = Job::new(Work::Read {
            of,
            job: request.job.clone(),
            patience,
        });
        self.readings.running = Some(Running {
            request,
            of,
            job: job.handle(),
            since: host.now(),
            read: None,
        });
        host.start_job(job);
    }

    /// Takes in what was read for the request `of`, unless that was given up.
    pub(super) fn take_read(&mut self, of: Revision, read: ReadFiles) {
        let running = self.readings.running.as_mut();
        if let Some(running) = running.filter(|running| running.of == of) {
            running.read = Some(read);
        }
    }

    /// Uses what was read, and goes on with the next request; whether there was something. While the
    /// user drags something or is asked a question, the document stays as it is.
    pub(super) fn use_read(&mut self, host: &mut dyn Host) -> bool {
        if self.session.is_in_gesture() || self.asked.is_some() {
            return false;
        }
        let is_ready = |running: &mut Running| running.read.is_some();
        let Some(Running { request, read, .. }) = self.readings.running.take_if(is_ready) else {
            return false;
        };
        self.use_files(request, read.unwrap_or_default(), host);
        self.read_next(host);
        true
    }

    fn use_files(&mut self, request: Request, read: ReadFiles, host: &mut dyn Host) {
        let ReadFiles {
            loaded,
            counts,
            failed,
        } = read;
        let Request { job, becomes } = request;
        let ReadJob { files, paths, .. } = job;
        match (becomes, &paths[..], failed.first()) {
            (Use::Start(picture), ..) => {
                let paths: Vec<(PathBuf, usize)> = paths.into_iter().zip(counts).collect();
                self.begin_with(loaded, &paths, &*files, failed, picture.as_deref());
            }
            (Use::Restore(_), _, Some(error)) => self.give_up_restoring(&error.to_string(), host),
            (Use::Restore(kept), _, None) => self.show_restored(&kept, loaded, host),
            (Use::Open { others, since }, [path, ..], Some(error)) => {
                let others = ToOpen {
                    paths: others,
                    files,
                    since,
                };
                self.go_on_without(path, error, others, host);
            }
            (Use::Open { others, since }, [path, ..], None) => {
                let path = path.clone();
                let opened = Opened {
                    path,
                    others,
                    since,
                    files,
                    loaded,
                };
                self.leave_as_answered(Next::Show(Box::new(opened)), host);
            }
            (_, _, Some(_)) => self.tell_all(Severity::Error, failed),
            (Use::Paste, ..) => self.insert_pasted(loaded),
            (Use::Import | Use::Open { .. }, ..) => self.insert(loaded),
        }
    }

    /// Gives up what is being read and what is to be read after it, and says so.
    pub(super) fn cancel_reading(&mut self, host: &mut dyn Host) {
        let Readings { running, waiting } = std::mem::take(&mut self.readings);
        let running = running.map(|running| running.request);
        for request in running.into_iter().chain(waiting) {
            let becomes = match request.becomes {
                Use::Import | Use::Paste => "imported",
                Use::Open { .. } | Use::Start(_) => "opened",
                // Nothing of it is lost.
                Use::Restore(_) => {
                    self.offer_restoring(host);
                    continue;
                }
            };
            let text = format!("Cancelled: {} is not {becomes}", request.name());
            self.tell(Severity::Info, text);
        }
    }

    /// Gives up all reading, at the end of the program.
    pub(super) fn drop_reading(&mut self) {
        self.readings = Readings::default();
    }

    /// Whether the first document is still being read.
    pub fn is_starting(&self) -> bool {
        self.is_reading(|becomes| matches!(becomes, Use::Start(_)))
    }

    /// Whether files are read for something such as this.
    pub(super) fn is_reading(&self, is_such: impl Fn(&Use) -> bool) -> bool {
        let mut requests = self.readings.requests();
        requests.any(|request| is_such(&request.becomes))
    }

    /// Text and part done, from 0 to 1, of reading that takes its time.
    pub(super) fn reading_progress(&self, now: Duration) -> Option<(String, f32)> {
        let running = self.readings.running.as_ref();
        let running = running.filter(|running| now >= running.since + SHOWN_AFTER)?;
        let doing = match running.request.becomes {
            Use::Import | Use::Paste => "Importing",
            Use::Open { .. } | Use::Start(_) | Use::Restore(_) => "Opening",
        };
        let name = running.request.name();
        let text = match self.readings.waiting.len() {
            0 => format!("{doing} {name}"),
            more => format!("{doing} {name}, then {more} more"),
        };
        Some((text, running.job.part()))
    }

    /// Time after which the progress is to be looked at again.
    pub(super) fn reading_wait(&self, now: Duration) -> Duration {
        match &self.readings.running {
            Some(running) if running.read.is_none() => {
                let shown_at = running.since + SHOWN_AFTER;
                shown_at.checked_sub(now).unwrap_or(LOOK)
            }
            _ => Duration::MAX,
        }
    }
}
