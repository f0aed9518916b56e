//! Which context is current on this thread, whatever library it came from.

use std::cell::RefCell;
use std::rc::{Rc, Weak};

use super::ContextError;

/// The window system's side of a context: EGL, OSMesa, or glutin with a window.
pub(in crate::gpu) trait NativeContext {
    /// Makes the context current on this thread.
    fn make_current(&self) -> Result<(), ContextError>;
    /// Leaves this thread without a current context.
    fn release(&self);
}

thread_local! {
    /// The context that is current on this thread. EGL and OSMesa do not know of each other, so
    /// the old one is released through its own library before another is made current.
    static CURRENT: RefCell<Weak<dyn NativeContext>> = RefCell::new(Weak::<NoContext>::new());
}

/// Stands in [`CURRENT`] before the first context exists; never constructed.
struct NoContext;

impl NativeContext for NoContext {
    fn make_current(&self) -> Result<(), ContextError> {
        Ok(())
    }
    fn release(&self) {}
}

/// None while the thread ends, too: whatever is dropped then finds no context current.
fn current() -> Option<Rc<dyn NativeContext>> {
    CURRENT
        .try_with(|current| current.borrow().upgrade())
        .ok()
        .flatten()
}

fn set_current(context: Weak<dyn NativeContext>) {
    // While the thread ends there is nothing to remember.
    let _ = CURRENT.try_with(|current| current.replace(context));
}

/// The native context, released when dropped: drivers keep a context that is still current.
pub(in crate::gpu) struct OwnedNative(Rc<dyn NativeContext>);

impl OwnedNative {
    pub(in crate::gpu) fn new(native: Rc<dyn NativeContext>) -> Self {
        Self(native)
    }

    /// Makes it current on this thread, unless it is.
    pub(in crate::gpu) fn make_current(&self) -> Result<(), ContextError> {
        if let Some(old) = current() {
            if Rc::ptr_eq(&old, &self.0) {
                return Ok(());
            }
            old.release();
        }
        set_current(Weak::<NoContext>::new());
        self.0.make_current()?;
        set_current(Rc::downgrade(&self.0) as Weak<dyn NativeContext>);
        Ok(())
    }
}

impl Drop for OwnedNative {
    fn drop(&mut self) {
        if current().is_some_and(|current| Rc::ptr_eq(&current, &self.0)) {
            self.0.release();
            set_current(Weak::<NoContext>::new());
        }
    }
}
