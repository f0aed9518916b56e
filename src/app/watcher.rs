use super::window_host::Wake;
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, Weak};
use std::time::{Duration, SystemTime};
use winit::event_loop::EventLoopProxy;

/// Time between two looks at the files.
const EVERY: Duration = Duration::from_secs(1);

/// Size and time of the last change of a file; `None` while there is none.
type Stamp = Option<(u64, Option<SystemTime>)>;

/// Files that are watched for changes by other programs.
///
/// They are looked at once a second, rather than reported by the system: that works for every
/// drive, and editors that replace a file instead of writing to it need no special care.
pub(super) struct Watcher {
    stamps: Arc<Mutex<HashMap<PathBuf, Stamp>>>,
    proxy: EventLoopProxy<Wake>,
    running: bool,
}

impl Watcher {
    pub fn new(proxy: EventLoopProxy<Wake>) -> Self {
        Self {
            stamps: Arc::default(),
            proxy,
            running: false,
        }
    }

    /// Watches `files`, and no others, as they are now.
    pub fn watch(&mut self, files: Vec<PathBuf>) {
        let Ok(mut stamps) = self.stamps.lock() else {
            return;
        };
        let now = |path: &PathBuf| stamps.get(path).copied().unwrap_or_else(|| stamp(path));
        let stamped = files.iter().map(now).collect::<Vec<_>>();
        *stamps = files.into_iter().zip(stamped).collect();
        drop(stamps);
        if !self.running {
            let (stamps, proxy) = (Arc::downgrade(&self.stamps), self.proxy.clone());
            let thread = std::thread::Builder::new().name("watcher".to_owned());
            // Without a thread to spare, changes are noticed when a file is saved or reloaded.
            self.running = thread.spawn(move || look(&stamps, &proxy)).is_ok();
        }
    }
}

/// Looks at the files until nobody wants to know any more.
fn look(stamps: &Weak<Mutex<HashMap<PathBuf, Stamp>>>, proxy: &EventLoopProxy<Wake>) {
    loop {
        std::thread::sleep(EVERY);
        let Some(stamps) = stamps.upgrade() else {
            return;
        };
        let Ok(mut stamps) = stamps.lock() else {
            return;
        };
        for (path, known) in stamps.iter_mut() {
            let now = stamp(path);
            if now != *known {
                *known = now;
                // A window that is gone needs no waking.
                let _ = proxy.send_event(Wake::FileChanged(path.clone()));
            }
        }
    }
}

fn stamp(path: &PathBuf) -> Stamp {
    let metadata = std::fs::metadata(path).ok()?;
    Some((metadata.len(), metadata.modified().ok()))
}
