//! Unsaved work when the program stops by a fault of its own.

use super::browser;
use crate::program::Unsaved;
use std::cell::RefCell;

thread_local! {
    /// Unsaved work as of the last frame, and the entry in the browser's storage for it.
    static LATEST: RefCell<Option<(Unsaved, String)>> = const { RefCell::new(None) };
}

/// Remembers unsaved work for the panic hook; none if `latest` is `None`.
pub(super) fn remember(latest: Option<(Unsaved, String)>) {
    LATEST.with(|place| place.replace(latest));
}

/// Stores what there is, as an autosave does, which would be up to ten seconds old.
pub(super) fn store_latest() {
    // Whoever holds it is the one that panics.
    let latest = LATEST.with(|place| place.try_borrow_mut().ok()?.take());
    if let Some((unsaved, entry)) = latest
        && let Ok(bytes) = unsaved.to_bytes()
    {
        browser::store(&entry, &String::from_utf8_lossy(&bytes));
    }
}
