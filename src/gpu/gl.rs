//! [`Gl`]: the handle through which everything here speaks to OpenGL.

use std::cell::{Cell, RefCell};
use std::ffi::{CStr, c_void};
use std::fmt;
use std::rc::Rc;
use std::sync::{Arc, Mutex};

use glow::HasContext as _;

use super::current::{NativeContext, OwnedNative};
use super::{ContextError, GpuError, Info, driver};

/// Messages kept between two checks; more would only repeat what the first ones say.
pub(in crate::gpu) const MAX_MESSAGES: usize = 64;

struct Inner {
    glow: Arc<glow::Context>,
    info: Info,
    driver_messages: Arc<Mutex<Vec<String>>>,
    faults: RefCell<Vec<String>>,
    viewport: Cell<[i32; 4]>,
    most_buffer_bytes: Cell<i32>,
    /// The last field: `glow` says good-bye to the driver while the context is still there.
    native: OwnedNative,
}

impl Drop for Inner {
    fn drop(&mut self) {
        // Where this fails, the driver ignores what `glow` tells it.
        let _ = self.native.make_current();
    }
}

/// A handle to an OpenGL context: cheap to clone, tied to the thread that made it.
///
/// Each object made from it holds a clone, and the context lives until the last clone is dropped.
/// Several contexts may live on one thread: whatever is used makes its own context current first.
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
    pub(in crate::gpu) fn new(
        native: Rc<dyn NativeContext>,
        load: impl Fn(&CStr) -> *const c_void,
    ) -> Result<Self, ContextError> {
        let native = OwnedNative::new(native);
        native.make_current()?;
        driver::check_version(&load)?;
        // SAFETY: the context is current, and `load` returns the entry points of its driver.
        let mut glow = unsafe { glow::Context::from_loader_function_cstr(load) };
        let driver_messages = driver::collect_messages(&mut glow);
        let info = driver::read_info(&glow);
        let viewport = Cell::new([0; 4]);
        let most_buffer_bytes = Cell::new(i32::MAX);
        let faults = RefCell::default();
        let glow = Arc::new(glow);
        Ok(Self {
            inner: Rc::new(Inner {
                glow,
                info,
                driver_messages,
                faults,
                viewport,
                most_buffer_bytes,
                native,
            }),
        })
    }

    /// What the driver is and can do.
    #[must_use]
    pub fn info(&self) -> &Info {
        &self.inner.info
    }

    /// Makes this context current on the thread. Needed only before foreign code (a user interface
    /// painter) uses [`glow_context`](Self::glow_context); everything in `gpu` does it by itself.
    ///
    /// # Errors
    /// When the window system refuses, for example after the display was lost.
    pub fn make_current(&self) -> Result<(), ContextError> {
        self.inner.native.make_current()
    }

    /// The `glow` context, for the user interface's painter. It must not be used after the last
    /// [`Gl`] of this context is gone, nor without [`make_current`](Self::make_current).
    #[must_use]
    pub fn glow_context(&self) -> Arc<glow::Context> {
        Arc::clone(&self.inner.glow)
    }

    /// Draws into the window from now on, instead of a framebuffer.
    pub fn bind_window(&self) {
        // SAFETY: current context.
        unsafe { self.raw().bind_framebuffer(glow::FRAMEBUFFER, None) }
    }

    /// Everything that went wrong since the last check, each fault told once.
    ///
    /// # Errors
    /// [`GpuError::Faults`] with the driver's error codes and messages of errors or high severity,
    /// and the mistakes that this layer caught before they reached the driver; [`GpuError::Lost`]
    /// if the context is gone.
    pub fn check(&self, what: &str) -> Result<(), GpuError> {
        let mut faults = Vec::new();
        // A lost context may report errors for ever, hence the bound.
        for _ in 0..MAX_MESSAGES {
            // SAFETY: current context.
            match unsafe { self.raw().get_error() } {
                glow::NO_ERROR => break,
                glow::CONTEXT_LOST => {
                    let what = what.to_owned();
                    return Err(GpuError::Lost { what });
                }
                code => faults.push(error_name(code)),
            }
        }
        faults.append(&mut self.inner.faults.borrow_mut());
        if let Ok(mut messages) = self.inner.driver_messages.lock() {
            faults.append(&mut messages);
        }
        if faults.is_empty() {
            return Ok(());
        }
        let what = what.to_owned();
        Err(GpuError::Faults { what, faults })
    }

    /// The entry points, with the context made current. If that fails, the fault is kept for
    /// [`check`](Self::check); the drivers then ignore the calls.
    pub(in crate::gpu) fn raw(&self) -> &glow::Context {
        if let Err(error) = self.make_current() {
            self.report(error.to_string());
        }
        &self.inner.glow
    }

    /// Keeps a fault until the next check.
    pub(in crate::gpu) fn report(&self, fault: String) {
        let mut faults = self.inner.faults.borrow_mut();
        if faults.len() < MAX_MESSAGES && !faults.contains(&fault) {
            faults.push(fault);
        }
    }

    /// The most that a buffer holds: what OpenGL can count.
    pub(in crate::gpu) fn most_buffer_bytes(&self) -> i32 {
        self.inner.most_buffer_bytes.get()
    }

    /// Lets buffers hold `bytes` at most, as with a driver that is out of memory.
    #[cfg(test)]
    pub(crate) fn limit_buffers(&self, bytes: i32) {
        self.inner.most_buffer_bytes.set(bytes);
    }

    /// The viewport that was set last: x, y, width, height in pixels.
    pub(in crate::gpu) fn viewport(&self) -> [i32; 4] {
        self.inner.viewport.get()
    }

    pub(in crate::gpu) fn set_viewport(&self, viewport: [i32; 4]) {
        let [x, y, width, height] = viewport;
        self.inner.viewport.set(viewport);
        // SAFETY: current context.
        unsafe { self.raw().viewport(x, y, width.max(0), height.max(0)) }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{Api, Backend, DrawState, Framebuffer, HeadlessContext};

    /// A context that another handle owns.
    struct Borrowed(Gl);

    impl NativeContext for Borrowed {
        fn make_current(&self) -> Result<(), ContextError> {
            self.0.make_current()
        }
        fn release(&self) {}
    }

    /// Functions that OpenGL 3.3 does not promise and OpenGL ES has.
    const NEWER: [&CStr; 6] = [
        c"glClearDepthf",
        c"glDepthRangef",
        c"glGetShaderPrecisionFormat",
        c"glInvalidateFramebuffer",
        c"glTexStorage2D",
        c"glTexStorage2DMultisample",
    ];

    #[test]
    fn a_driver_of_exactly_opengl_3_3_has_all_that_pictures_need() {
        type Load = unsafe extern "system" fn(*const std::ffi::c_char) -> *const c_void;
        // SAFETY: the library's own initialization asks for nothing.
        let Ok(library) = (unsafe { libloading::Library::new("libEGL.so.1") }) else {
            return;
        };
        let context = HeadlessContext::with_api(Backend::Egl, Api::Gl).unwrap();
        // SAFETY: this is what the specification says `eglGetProcAddress` is.
        let load = unsafe { library.get::<Load>(b"eglGetProcAddress\0") }.unwrap();
        let native = Rc::new(Borrowed(context.gl().clone()));
        let gl = Gl::new(native, |name| {
            if NEWER.contains(&name) {
                return std::ptr::null();
            }
            // SAFETY: names end with zero; an unknown name gives null.
            unsafe { load(name.as_ptr()) }
        });
        let gl = gl.unwrap();
        for samples in [0, 4] {
            let picture = Framebuffer::new(&gl, 4, 4, samples).unwrap();
            picture.clear([1.0; 4]);
            DrawState::opaque(4, 4).apply(&gl);
            assert!(picture.read_rgba().unwrap().iter().all(|&c| c == 255));
        }
    }
}
