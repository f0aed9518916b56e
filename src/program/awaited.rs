//! What waits for built-in files that are not inside the program: on a page these are fetched when
//! they are used.

use super::Host;
use super::autosave::Kept;
use super::document::{Next, ToOpen};
use super::reading::Use;
use super::running::Program;
use crate::editor::Severity;
use crate::io::{Diagnostic, Files, builtin};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Something that goes on once the host has brought what it reads.
#[derive(Clone)]
pub(super) enum Awaited {
    Next(Next),
    /// Add what a file holds.
    Import(PathBuf, Arc<dyn Files>),
    /// Add the shapes of this text from the clipboard.
    Paste(String),
    /// Open what an earlier run left.
    Restore(Box<Kept>),
    /// Draw a picture of the start page.
    StartPicture,
}

impl Awaited {
    /// Built-in files that it reads and that are not there.
    fn absent(&self, files: &dyn Files) -> Vec<PathBuf> {
        match self {
            Self::Next(Next::OpenFiles(ToOpen { paths, files, .. })) => {
                let absent = paths.iter().map(|path| builtin::absent(&**files, path));
                absent.flatten().collect()
            }
            Self::Next(Next::Revert(path, files)) | Self::Import(path, files) => {
                builtin::absent(&**files, path)
            }
            Self::Next(Next::OpenBuiltin(name)) => {
                builtin::absent(files, Path::new(&format!("{}{name}", builtin::PREFIX)))
            }
            Self::Next(Next::New | Next::Open | Next::Show(_) | Next::Quit)
            | Self::StartPicture => Vec::new(),
            Self::Paste(text) => builtin::absent_in(files, text),
            Self::Restore(kept) => builtin::absent_in(files, &kept.scene),
        }
    }

    /// Whether somebody looks at the progress: pictures of the start page come by themselves.
    fn is_shown(&self) -> bool {
        !matches!(self, Self::StartPicture)
    }
}

impl Program {
    /// Whether `work` has to wait for the host to bring files; it goes on by itself then.
    pub(super) fn has_to_wait(&mut self, work: &Awaited, host: &mut dyn Host) -> bool {
        let absent = work.absent(&*host.files());
        if absent.is_empty() {
            return false;
        }
        self.wait_for(absent, work.clone(), host);
        true
    }

    /// Has the host bring `absent`, after which `work` goes on.
    pub(super) fn wait_for(&mut self, absent: Vec<PathBuf>, work: Awaited, host: &mut dyn Host) {
        self.awaited.push(work);
        host.bring(absent);
    }

    /// Gives up what waits for files. They may come all the same.
    pub(super) fn stop_waiting(&mut self, host: &mut dyn Host) {
        let (given_up, left) = std::mem::take(&mut self.awaited)
            .into_iter()
            .partition(Awaited::is_shown);
        self.awaited = left;
        for work in given_up {
            self.give_up(&work, host);
        }
    }

    /// Has nothing be lost with work whose files do not come: an earlier run's is offered again.
    fn give_up(&mut self, work: &Awaited, host: &mut dyn Host) {
        match work {
            Awaited::Restore(_) => self.offer_restoring(host),
            Awaited::StartPicture => self.start_pictures.go_without(),
            Awaited::Next(_) | Awaited::Import(..) | Awaited::Paste(_) => {}
        }
    }

    /// Whether work of an earlier run waits for its files, or is being read.
    pub(super) fn is_restoring(&self) -> bool {
        let restores = |work: &Awaited| matches!(work, Awaited::Restore(_));
        let is_read = self.is_reading(|becomes| matches!(becomes, Use::Restore(_)));
        is_read || self.awaited.iter().any(restores)
    }

    /// Goes on with what waited for files that the host has brought. Says why others could not be had,
    /// and gives up what needs them.
    pub(super) fn take_brought(&mut self, brought: Result<(), Diagnostic>, host: &mut dyn Host) {
        let mut error = brought.err();
        let has_failed = error.is_some();
        for work in std::mem::take(&mut self.awaited) {
            let is_absent = match work {
                Awaited::StartPicture => has_failed,
                _ => !work.absent(&*host.files()).is_empty(),
            };
            if is_absent && has_failed {
                if let Some(error) = error.take_if(|_| work.is_shown()) {
                    self.tell(Severity::Error, error.to_string());
                }
                self.give_up(&work, host);
                continue;
            }
            match work {
                Awaited::Next(next) => self.leave_as_answered(next, host),
                Awaited::Import(path, files) => self.import_any(&path, &files, host),
                Awaited::Paste(text) => self.paste_shapes(&text, host),
                Awaited::Restore(kept) => self.restore(&kept, host),
                Awaited::StartPicture => self.start_pictures.go_on(),
            }
        }
    }

    /// Text and part done, from 0 to 1, of the files that somebody waits for.
    pub(super) fn awaited_progress(&self, host: &dyn Host) -> Option<(String, f32)> {
        let part = host.part_brought()?;
        let is_shown = self.awaited.iter().any(Awaited::is_shown);
        is_shown.then(|| ("Fetching files".to_owned(), part))
    }
}
