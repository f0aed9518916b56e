//! Being asked to end, by Ctrl+C or the system, while commands run.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
#[cfg(unix)]
use {
    rustix::process::{Pid, Signal, kill_process_group},
    std::collections::BTreeSet,
    std::io,
    std::process::{Child, Command},
    std::sync::{Mutex, PoisonError},
};

/// Whether the program has been asked to end, and what ends with it.
#[derive(Debug, Default)]
pub(super) struct Interruption {
    is_asked: AtomicBool,
    /// Groups of processes that run.
    #[cfg(unix)]
    groups: Mutex<BTreeSet<u32>>,
}

impl Interruption {
    /// One that watches for signals. Asked a second time, the program ends at once with all groups: a file
    /// that is being written is left whole or as it was.
    pub fn watched() -> Arc<Self> {
        let watched = Arc::new(Self::default());
        #[cfg(unix)]
        Arc::clone(&watched).watch();
        watched
    }

    /// Whether it has been asked to end.
    pub fn is_asked(&self) -> bool {
        self.is_asked.load(Ordering::Relaxed)
    }
}

#[cfg(unix)]
impl Interruption {
    fn watch(self: Arc<Self>) {
        use signal_hook::consts::{SIGINT, SIGTERM};
        // Where signals cannot be watched, they end the program at once, and what is kept stays.
        let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGINT, SIGTERM]) else {
            return;
        };
        let thread = std::thread::Builder::new().name("signals".to_owned());
        // Without a thread to spare nothing is graded, either.
        let _ = thread.spawn(move || {
            for signal in signals.forever() {
                if self.is_asked.swap(true, Ordering::Relaxed) {
                    // Held to the end, so that nothing is started any more.
                    let groups = self.groups.lock().unwrap_or_else(PoisonError::into_inner);
                    groups.iter().copied().for_each(end);
                    signal_hook::low_level::exit(128 + signal);
                }
            }
        });
    }

    /// Starts a process that is a group of its own.
    ///
    /// # Errors
    /// If the system cannot start it.
    pub fn start(&self, command: &mut Command) -> io::Result<Child> {
        use std::os::unix::process::CommandExt;
        let mut groups = self.groups.lock().unwrap_or_else(PoisonError::into_inner);
        let child = command.process_group(0).spawn()?;
        groups.insert(child.id());
        Ok(child)
    }

    /// Ends a process and everything that it has started.
    pub fn end(&self, child: &Child) {
        let mut groups = self.groups.lock().unwrap_or_else(PoisonError::into_inner);
        groups.remove(&child.id());
        end(child.id());
    }
}

/// Ends all processes of a group.
#[cfg(unix)]
fn end(group: u32) {
    if let Some(group) = Pid::from_raw(group.cast_signed()) {
        // All of it may have ended already.
        let _ = kill_process_group(group, Signal::KILL);
    }
}
