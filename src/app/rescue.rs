//! Unsaved work when the program ends against its will: by a signal, or by a fault of its own.

use super::slot;
use super::window_host::Wake;
use crate::program::Unsaved;
use std::io::Write;
use std::path::PathBuf;
use std::sync::{Mutex, Once};
use winit::event_loop::EventLoopProxy;

/// Unsaved work as of the last frame, and the places of which the panic hook writes it to the first
/// that it can.
static LATEST: Mutex<Option<(Unsaved, Vec<PathBuf>)>> = Mutex::new(None);

/// Remembers unsaved work for the panic hook; none if `latest` is `None`.
pub(super) fn remember(latest: Option<(Unsaved, Vec<PathBuf>)>) {
    if let Ok(mut place) = LATEST.lock() {
        *place = latest;
    }
}

/// Has a panic write unsaved work and say where.
pub(super) fn write_on_panic() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let report = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            report(panic);
            // Whoever does not listen need not be told.
            let _ = writeln!(std::io::stderr(), "{}", write_latest());
        }));
    });
}

/// Writes what there is; what to tell the user.
fn write_latest() -> String {
    // Whoever holds the lock, or left it poisoned, is the one that panics.
    let latest = LATEST.try_lock().ok().and_then(|latest| latest.clone());
    let Some((unsaved, paths)) = latest else {
        return "The editor ended because of a fault of its own. Nothing was unsaved.".to_owned();
    };
    let write = |bytes: Vec<u8>| match slot::write_to_first(&paths, &bytes) {
        Ok(place) => Ok(place.to_owned()),
        Err(failure) => failure.kept_in.ok_or_else(|| failure.error.to_string()),
    };
    match unsaved
        .to_bytes()
        .map_err(|e| e.to_string())
        .and_then(write)
    {
        Ok(path) => format!(
            "The editor ended because of a fault of its own. Unsaved work is in {} and will be \
             offered at the next start.",
            path.display()
        ),
        Err(error) => format!(
            "The editor ended because of a fault of its own, and unsaved work could not be \
             kept: {error}"
        ),
    }
}

/// Wakes the event loop when the system asks the program to end. Where signals cannot be watched,
/// the last autosave is what is left.
#[cfg(unix)]
pub(super) fn watch_signals(proxy: EventLoopProxy<Wake>) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGTERM, SIGINT, SIGHUP]) else {
        return;
    };
    let thread = std::thread::Builder::new().name("signals".to_owned());
    // Without a thread to spare, signals end the program as they always did.
    let _ = thread.spawn(move || {
        for _ in signals.forever() {
            // A window that is gone needs no waking.
            let _ = proxy.send_event(Wake::Terminate);
        }
    });
}

/// Does nothing: there are no such signals.
#[cfg(not(unix))]
pub(super) fn watch_signals(_: EventLoopProxy<Wake>) {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::{Edit, Session};
    use crate::program::{GraphicsInfo, Program};
    use crate::scene::{NewShape, ShapeKind};

    #[test]
    fn a_panic_writes_unsaved_work_and_says_where() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let path = folder.join("autosave-0.json");
        let mut program = Program::showing(
            Session::new(),
            GraphicsInfo {
                description: String::new(),
                max_texture_side: 4096,
            },
        );
        assert!(program.unsaved().is_none());
        let cube = NewShape::new("My cube", ShapeKind::Cube);
        let edit = Edit::Insert(vec![cube]);
        program.session_mut().edit(edit).unwrap();
        remember(
            program
                .unsaved()
                .map(|unsaved| (unsaved, vec![path.clone()])),
        );
        let told = write_latest();
        assert!(told.contains(&path.display().to_string()), "{told}");
        let written = std::fs::read_to_string(&path).unwrap();
        assert!(written.contains("My cube"), "{written}");

        remember(
            program
                .unsaved()
                .map(|unsaved| (unsaved, vec![folder.join("no/where")])),
        );
        assert!(write_latest().contains("could not be kept"));
        remember(None);
        assert!(write_latest().contains("Nothing was unsaved"));
    }
}
