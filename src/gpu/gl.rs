//! [`Gl`]: the handle to a context. It is the only way to the driver's entry points.

use std::cell::{Cell, RefCell};
#[cfg(not(target_arch = "wasm32"))]
use std::ffi::{CStr, c_void};
use std::fmt;
use std::mem::ManuallyDrop;
use std::rc::Rc;
use std::sync::{Arc, Mutex};

use glow::HasContext as _;

use super::context::{NativeContext, OwnedNative};
#[cfg(not(target_arch = "wasm32"))]
use super::native_driver;
use super::{ContextError, GpuError, Info, driver};

/// Messages kept between two checks; more would only repeat what the first ones say.
pub(in crate::gpu) const MAX_MESSAGES: usize = 64;

/// Whether errors are asked for only by `Gl::keep_errors`, as on a page.
const ASKS_WHEN_IDLE: bool = cfg!(target_arch = "wasm32");

/// A context: the driver's entry points, and below them the platform's side.
struct Inner {
    /// Shared with the interface's painter, which holds a [`Gl`] and so never is the last owner.
    glow: ManuallyDrop<Arc<glow::Context>>,
    info: Info,
    driver_messages: Arc<Mutex<Vec<String>>>,
    faults: RefCell<Vec<String>>,
    viewport: Cell<[i32; 4]>,
    /// Whether the driver has said that the context is lost. It may say so only once.
    is_lost: Cell<bool>,
    native: OwnedNative,
}

impl Drop for Inner {
    fn drop(&mut self) {
        // `glow` unregisters its callback when it is dropped, which is a call to the driver. Where
        // the context cannot be made current, the entry points are leaked instead.
        if self.native.make_current().is_ok() {
            // SAFETY: the context is current and alive, since `native` is dropped after this body;
            // the field is dropped here and nowhere else, and not used afterwards.
            unsafe { ManuallyDrop::drop(&mut self.glow) }
        }
    }
}

/// A handle to an OpenGL context: cheap to clone, tied to the thread that made it.
///
/// Each object made from it holds a clone, and the context lives until the last clone is dropped,
/// in whatever order that happens. Several contexts may live on one thread: each call makes the
/// context of its object current first. Where that fails, nothing is called, and
/// [`check`](Self::check) returns the failure.
#[derive(Clone)]
pub struct Gl {
    inner: Rc<Inner>,
}

impl fmt::Debug for Gl {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Gl").field(&self.inner.info.version).finish()
    }
}

impl Gl {
    /// Makes `native` current and loads the entry points through `load` (null for unknown names).
    ///
    /// # Safety
    /// While `native` lives and is current, what `load` returns for a name is the entry point of
    /// that name as the OpenGL specification has it, or null.
    #[cfg(not(target_arch = "wasm32"))]
    pub(in crate::gpu) unsafe fn new(
        native: Rc<dyn NativeContext>,
        load: impl Fn(&CStr) -> *const c_void,
    ) -> Result<Self, ContextError> {
        let native = OwnedNative::new(native);
        native.make_current().map_err(ContextError::Native)?;
        // SAFETY: the context is current, and `load` is as this function's contract has it.
        unsafe { native_driver::check_version(&load) }?;
        // SAFETY: as above; the version is one that `glow` can parse.
        let mut glow = unsafe { glow::Context::from_loader_function_cstr(load) };
        // SAFETY: the context is current, and `glow` is dropped while it is: see `Inner`.
        let driver_messages = unsafe { native_driver::collect_messages(&mut glow) };
        Ok(Self::of(native, Arc::new(glow), driver_messages))
    }

    /// Shares the context of a canvas with whoever else draws there.
    #[cfg(target_arch = "wasm32")]
    pub(in crate::gpu) fn of_canvas(
        native: Rc<dyn NativeContext>,
        glow: Arc<glow::Context>,
    ) -> Result<Self, ContextError> {
        let native = OwnedNative::new(native);
        native.make_current().map_err(ContextError::Native)?;
        Ok(Self::of(native, glow, Arc::default()))
    }

    /// A handle to `native`, which is current and whose entry points are `glow`.
    fn of(
        native: OwnedNative,
        glow: Arc<glow::Context>,
        driver_messages: Arc<Mutex<Vec<String>>>,
    ) -> Self {
        // SAFETY: the context is current.
        let info = unsafe { driver::read_info(&glow) };
        Self {
            inner: Rc::new(Inner {
                glow: ManuallyDrop::new(glow),
                info,
                driver_messages,
                faults: RefCell::default(),
                viewport: Cell::new([0; 4]),
                is_lost: Cell::new(false),
                native,
            }),
        }
    }

    /// Properties and limits of the driver.
    #[must_use]
    pub fn info(&self) -> &Info {
        &self.inner.info
    }

    /// Makes this context current on the thread. Everything in `gpu` does so by itself.
    ///
    /// # Errors
    /// When the window system refuses, for example after the display was lost.
    pub fn make_current(&self) -> Result<(), ContextError> {
        let made = self.inner.native.make_current();
        made.map_err(ContextError::Native)
    }

    /// Runs `calls` with the driver's entry points while the context is current. State that it
    /// leaves behind is no problem: every draw sets all that it depends on.
    ///
    /// # Errors
    /// [`GpuError::Lost`] if the context cannot be made current; `calls` is not run then.
    pub fn with_glow<R>(&self, calls: impl FnOnce(&glow::Context) -> R) -> Result<R, GpuError> {
        self.current_for("calling the driver").map(calls)
    }

    /// Draws into the window from now on, instead of a framebuffer.
    pub fn bind_window(&self) {
        if let Some(glow) = self.current() {
            // SAFETY: current context.
            unsafe { glow.bind_framebuffer(glow::FRAMEBUFFER, None) }
        }
    }

    /// Everything that went wrong since the last check, each fault once. `what` is what was done
    /// in between, for the message. A browser tells errors once everything is drawn: there, those are
    /// returned that `Gl::keep_errors` has found.
    ///
    /// # Errors
    /// [`GpuError::Faults`] with the driver's error codes and messages of errors or high severity,
    /// and the mistakes that this layer caught before they reached the driver; [`GpuError::Lost`]
    /// if the context is gone.
    pub fn check(&self, what: &str) -> Result<(), GpuError> {
        let glow = self.current_for(what)?;
        let mut faults = Vec::new();
        if !ASKS_WHEN_IDLE {
            faults.extend(self.take_error_flags(glow).map(error_name));
        }
        if self.inner.is_lost.get() {
            return Err(lost(what, "the driver was reset"));
        }
        faults.append(&mut self.inner.faults.borrow_mut());
        faults.append(&mut self.take_driver_messages());
        if faults.is_empty() {
            return Ok(());
        }
        let what = what.to_owned();
        Err(GpuError::Faults { what, faults })
    }

    /// Asks for the driver's errors, for the next check. It waits until everything is drawn, and is for
    /// moments when that is so.
    #[cfg(target_arch = "wasm32")]
    pub fn keep_errors(&self) {
        if let Some(glow) = self.current() {
            let errors = self.take_error_flags(glow).map(error_name);
            errors.for_each(|error| self.report(error));
        }
    }

    /// Waits until the driver has done all that it was told.
    pub fn finish(&self) {
        if let Some(glow) = self.current() {
            // SAFETY: current context.
            unsafe { glow.finish() };
        }
    }

    /// Whether the driver had the memory for everything since errors were last asked for. Other
    /// errors are kept for [`check`](Self::check), as all are in a browser, which itself sees to it
    /// that nothing is read that is not there.
    pub(in crate::gpu) fn check_memory(&self, what: &'static str) -> Result<(), GpuError> {
        let glow = self.current_for("reserving memory")?;
        if ASKS_WHEN_IDLE {
            return Ok(());
        }
        let (exhausted, others): (Vec<u32>, Vec<u32>) = self
            .take_error_flags(glow)
            .partition(|&code| code == glow::OUT_OF_MEMORY);
        others
            .into_iter()
            .for_each(|code| self.report(error_name(code)));
        if self.inner.is_lost.get() {
            return Err(lost("reserving memory", "the driver was reset"));
        }
        if exhausted.is_empty() {
            return Ok(());
        }
        // The driver's own words for it would otherwise be reported a second time.
        let mut why = vec!["out of graphics memory".to_owned()];
        why.append(&mut self.take_driver_messages());
        let why = why.join("; ");
        Err(GpuError::Create { what, why })
    }

    /// The entry points, with the context current on this thread. `None` if it cannot be made
    /// current: nothing may be called then, and [`check`](Self::check) returns the failure.
    pub(in crate::gpu) fn current(&self) -> Option<&glow::Context> {
        match self.make_current() {
            Ok(()) => Some(&self.inner.glow),
            Err(error) => {
                self.report(error.to_string());
                None
            }
        }
    }

    /// As [`current`](Self::current), for callers that return the failure themselves.
    pub(in crate::gpu) fn current_for(&self, what: &str) -> Result<&glow::Context, GpuError> {
        match self.inner.native.make_current() {
            Ok(()) => Ok(&self.inner.glow),
            Err(why) => Err(lost(what, &why)),
        }
    }

    /// The entry points for a painter that keeps them.
    ///
    /// # Safety
    /// The caller holds a [`Gl`] of this context until the last copy is dropped, and makes the
    /// context current, successfully, before each use.
    pub(in crate::gpu) unsafe fn shared_glow(&self) -> Arc<glow::Context> {
        Arc::clone(&self.inner.glow)
    }

    /// Whether both are handles to one context. Names of objects mean nothing in another one.
    pub(in crate::gpu) fn is_same(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.inner, &other.inner)
    }

    /// Keeps a fault until the next check.
    pub(in crate::gpu) fn report(&self, fault: String) {
        let mut faults = self.inner.faults.borrow_mut();
        if faults.len() < MAX_MESSAGES && !faults.contains(&fault) {
            faults.push(fault);
        }
    }

    /// The viewport that was set last: x, y, width, height in pixels.
    pub(in crate::gpu) fn viewport(&self) -> [i32; 4] {
        self.inner.viewport.get()
    }

    pub(in crate::gpu) fn set_viewport(&self, viewport: [i32; 4]) {
        let [x, y, width, height] = viewport;
        if let Some(glow) = self.current() {
            self.inner.viewport.set(viewport);
            // SAFETY: current context; sizes are not negative.
            unsafe { glow.viewport(x, y, width.max(0), height.max(0)) }
        }
    }

    /// Resets the driver's error flags and returns their codes, without that of a lost context,
    /// which is remembered.
    fn take_error_flags(&self, glow: &glow::Context) -> impl Iterator<Item = u32> {
        let mut codes = Vec::new();
        // A lost context may report errors for ever, hence the bound.
        for _ in 0..MAX_MESSAGES {
            // SAFETY: current context: `glow` was just handed out by `current_for`.
            match unsafe { glow.get_error() } {
                glow::NO_ERROR => break,
                glow::CONTEXT_LOST => {
                    self.inner.is_lost.set(true);
                    break;
                }
                code => codes.push(code),
            }
        }
        codes.into_iter()
    }

    fn take_driver_messages(&self) -> Vec<String> {
        let messages = self.inner.driver_messages.lock();
        messages.map_or_else(
            |_| Vec::new(),
            |mut messages| std::mem::take(&mut *messages),
        )
    }
}

fn lost(what: &str, why: &str) -> GpuError {
    GpuError::Lost {
        what: what.to_owned(),
        why: why.to_owned(),
    }
}

fn error_name(code: u32) -> String {
    match code {
        glow::INVALID_ENUM => "GL_INVALID_ENUM".to_owned(),
        glow::INVALID_VALUE => "GL_INVALID_VALUE".to_owned(),
        glow::INVALID_OPERATION => "GL_INVALID_OPERATION".to_owned(),
        glow::INVALID_FRAMEBUFFER_OPERATION => "GL_INVALID_FRAMEBUFFER_OPERATION".to_owned(),
        glow::OUT_OF_MEMORY => "GL_OUT_OF_MEMORY (out of graphics memory)".to_owned(),
        other => format!("GL error 0x{other:04x}"),
    }
}
