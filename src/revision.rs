//! Revisions: cheap identifiers of a state, by which caches know whether something changed.
//!
//! The lowest layer: every other one may use it.

use std::sync::atomic::{AtomicU64, Ordering};

/// Identifier of a state: equal revisions mean equal content. All come from one counter and none
/// is used twice, so that going back to an older state brings its revision back, and whatever was
/// cached for it is valid again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Revision(u64);

impl Revision {
    /// A revision that no other state has.
    #[allow(clippy::new_without_default, reason = "every call gives another value")]
    pub fn new() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}
