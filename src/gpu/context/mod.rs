//! Sources of OpenGL contexts (a window, EGL without one, OSMesa on the processor), and which of
//! them is current on a thread.

#[cfg(target_arch = "wasm32")]
mod canvas;
#[cfg(not(target_arch = "wasm32"))]
mod egl;
#[cfg(not(target_arch = "wasm32"))]
mod headless;
#[cfg(not(target_arch = "wasm32"))]
mod osmesa;
#[cfg(not(target_arch = "wasm32"))]
mod turn;
#[cfg(not(target_arch = "wasm32"))]
mod window;

#[cfg(target_arch = "wasm32")]
pub use canvas::CanvasContext;
#[cfg(not(target_arch = "wasm32"))]
pub use headless::{Backend, HeadlessContext};
#[cfg(not(target_arch = "wasm32"))]
pub use window::WindowContext;

use std::cell::RefCell;
use std::rc::{Rc, Weak};

/// Kind of OpenGL of a context.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Api {
    /// OpenGL 3.3 core.
    Gl,
    /// OpenGL ES 3.0, which old and mobile drivers, and browsers, have instead.
    Gles,
}

/// The platform's side of a context: EGL, OSMesa, or glutin with a window.
pub(in crate::gpu) trait NativeContext {
    /// Makes the context current on this thread, or returns the platform's reason why not.
    fn make_current(&self) -> Result<(), String>;
    /// Leaves this thread without a current context.
    fn release(&self);
}

thread_local! {
    /// The context that is current on this thread. EGL and OSMesa do not know of each other, so
    /// the old one is released through its own library before another is made current.
    static CURRENT: RefCell<Weak<dyn NativeContext>> = RefCell::new(Weak::<NoContext>::new());
}

/// The type of [`CURRENT`] while no context is; never constructed.
struct NoContext;

impl NativeContext for NoContext {
    fn make_current(&self) -> Result<(), String> {
        Ok(())
    }
    fn release(&self) {}
}

/// `None` while the thread ends, too: whatever is dropped then makes its context current anew.
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

    /// Makes it current on this thread, unless it is; or returns the platform's reason why not,
    /// and then no context is current.
    pub(in crate::gpu) fn make_current(&self) -> Result<(), String> {
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
