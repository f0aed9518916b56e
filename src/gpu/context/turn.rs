//! One thread at a time with contexts without a window.

use std::cell::RefCell;
use std::rc::{Rc, Weak};
use std::sync::{Mutex, MutexGuard, PoisonError};

static TURN: Mutex<()> = Mutex::new(());

thread_local! {
    static OF_THIS_THREAD: RefCell<Weak<Turn>> = const { RefCell::new(Weak::new()) };
}

/// The right of a thread to have contexts of EGL and OSMesa, shared by all of them that it has.
///
/// Drivers promise that threads may draw at the same time. Those on the processor (llvmpipe of Mesa
/// 22.3, which all contexts of a process share) have crashed tests that do, though seldom; they have
/// threads of their own for the cores anyway.
pub(super) struct Turn {
    _guard: MutexGuard<'static, ()>,
}

impl Turn {
    /// Waits until no other thread has a context.
    pub(super) fn of_this_thread() -> Rc<Self> {
        OF_THIS_THREAD.with_borrow_mut(|own| {
            own.upgrade().unwrap_or_else(|| {
                // A thread that panicked has dropped its contexts.
                let guard = TURN.lock().unwrap_or_else(PoisonError::into_inner);
                let turn = Rc::new(Self { _guard: guard });
                *own = Rc::downgrade(&turn);
                turn
            })
        })
    }
}
