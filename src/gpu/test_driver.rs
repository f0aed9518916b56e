//! A driver for tests: EGL's own, with functions in between that fail on demand and notice calls
//! without a current context.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::ffi::{CStr, c_char, c_void};
use std::rc::Rc;

use super::context::NativeContext;
use super::{Api, Backend, Gl, HeadlessContext};

/// A context whose driver and window system fail on demand. One at a time on each thread.
pub(crate) struct TestDriver {
    gl: Gl,
}

impl TestDriver {
    /// Works as any other at first.
    pub(crate) fn new() -> Self {
        Self::without(&[])
    }

    /// Without the functions `missing`, as with an older driver.
    pub(crate) fn without(missing: &[&CStr]) -> Self {
        type Load = unsafe extern "system" fn(*const c_char) -> *const c_void;
        let real = HeadlessContext::with_api(Backend::Egl, Api::Gl).unwrap();
        // SAFETY: the library's own initialization has no preconditions; it is loaded already.
        let library = unsafe { libloading::Library::new("libEGL.so.1") }.unwrap();
        // SAFETY: this is the type of `eglGetProcAddress` in the specification.
        let load = unsafe { *library.get::<Load>(b"eglGetProcAddress\0").unwrap() };
        STATE.with(State::reset);
        let native = Rc::new(Native(real.gl().clone()));
        let entry_point = |name: &CStr| {
            if missing.contains(&name) {
                return std::ptr::null();
            }
            // SAFETY: names end with zero; an unknown name gives null.
            let found = unsafe { load(name.as_ptr()) };
            STATE.with(|state| state.watch(name, found))
        };
        // SAFETY: the functions are those of the real context's driver, or have the types of those
        // and pass calls on to them.
        let gl = unsafe { Gl::new(native, entry_point) }.unwrap();
        Self { gl }
    }

    pub(crate) fn gl(&self) -> &Gl {
        &self.gl
    }

    /// Lets the context be made current no more, as after the display was lost, or again.
    pub(crate) fn refuse_current(refuse: bool) {
        STATE.with(|state| state.refuses.set(refuse));
    }

    /// Has no memory for buffers of more than `bytes`.
    pub(crate) fn limit_buffers(bytes: usize) {
        STATE.with(|state| state.most_bytes.set(bytes));
    }

    /// Reports, once, that the driver was reset.
    pub(crate) fn reset_driver() {
        STATE.with(|state| state.is_reset.set(true));
    }

    /// The watched functions that were called while the context was not current, or gone.
    pub(crate) fn stray_calls() -> Vec<&'static str> {
        STATE.with(|state| state.stray.take())
    }

    /// Bytes written to buffers and textures since the last time.
    pub(crate) fn uploaded() -> usize {
        STATE.with(|state| state.uploaded.take())
    }

    /// Number of shader programs that were linked since the last time.
    pub(crate) fn linked() -> usize {
        STATE.with(|state| state.linked.take())
    }

    /// Number of calls of watched functions since the last time.
    pub(crate) fn calls() -> usize {
        STATE.with(|state| state.calls.take())
    }
}

/// The window system's side.
struct Native(Gl);

impl NativeContext for Native {
    fn make_current(&self) -> Result<(), String> {
        STATE.with(|state| {
            let made = match state.refuses.get() {
                true => Err("the display is gone".to_owned()),
                false => self.0.make_current().map_err(|error| error.to_string()),
            };
            state.is_current.set(made.is_ok());
            made
        })
    }

    fn release(&self) {
        let _ = STATE.try_with(|state| state.is_current.set(false));
    }
}

impl Drop for Native {
    fn drop(&mut self) {
        let _ = STATE.try_with(|state| state.is_current.set(false));
    }
}

struct State {
    real: RefCell<HashMap<&'static str, *const c_void>>,
    is_current: Cell<bool>,
    refuses: Cell<bool>,
    is_reset: Cell<bool>,
    most_bytes: Cell<usize>,
    calls: Cell<usize>,
    uploaded: Cell<usize>,
    linked: Cell<usize>,
    stray: RefCell<Vec<&'static str>>,
}

thread_local! {
    static STATE: State = State {
        real: RefCell::default(),
        is_current: Cell::new(false),
        refuses: Cell::new(false),
        is_reset: Cell::new(false),
        most_bytes: Cell::new(usize::MAX),
        calls: Cell::new(0),
        uploaded: Cell::new(0),
        linked: Cell::new(0),
        stray: RefCell::default(),
    };
}

impl State {
    fn reset(&self) {
        self.real.take();
        self.is_current.set(false);
        self.refuses.set(false);
        self.is_reset.set(false);
        self.most_bytes.set(usize::MAX);
        self.calls.set(0);
        self.uploaded.set(0);
        self.linked.set(0);
        self.stray.take();
    }

    /// As `call`, for one that writes so many bytes.
    fn upload(&self, name: &'static str, bytes: usize) -> Option<*const c_void> {
        self.uploaded.set(self.uploaded.get() + bytes);
        self.call(name)
    }

    /// The real function to pass a call on to, if the context is current.
    fn call(&self, name: &'static str) -> Option<*const c_void> {
        self.calls.set(self.calls.get() + 1);
        if self.is_current.get() {
            return self.real.borrow().get(name).copied();
        }
        self.stray.borrow_mut().push(name);
        None
    }
}

/// Functions that note their call and pass it on while the context is current; and the one that
/// finds them by name.
macro_rules! watched {
    ($($name:ident($($argument:ident: $kind:ty),*);)*) => {
        $(
            #[allow(non_snake_case, reason = "OpenGL's names")]
            extern "system" fn $name($($argument: $kind),*) {
                let real = STATE.try_with(|state| state.call(stringify!($name)));
                if let Ok(Some(real)) = real {
                    // SAFETY: the driver's function of this name, which has this type in the
                    // OpenGL specification; the context is current.
                    unsafe {
                        let real = std::mem::transmute::<
                            *const c_void,
                            unsafe extern "system" fn($($kind),*),
                        >(real);
                        real($($argument),*);
                    }
                }
            }
        )*

        impl State {
            /// The function to be called in place of `found`.
            fn watch(&self, name: &CStr, found: *const c_void) -> *const c_void {
                if found.is_null() {
                    return found;
                }
                let (name, watched) = match name.to_bytes() {
                    $(
                        name if name == stringify!($name).as_bytes() => {
                            (stringify!($name), $name as *const c_void)
                        }
                    )*
                    b"glBufferSubData" => ("glBufferSubData", buffer_sub_data as *const c_void),
                    b"glTexImage2D" => ("glTexImage2D", tex_image as *const c_void),
                    b"glTexSubImage2D" => ("glTexSubImage2D", tex_sub_image as *const c_void),
                    b"glBufferData" => ("glBufferData", buffer_data as *const c_void),
                    b"glLinkProgram" => ("glLinkProgram", link_program as *const c_void),
                    b"glGetError" => ("glGetError", get_error as *const c_void),
                    _ => return found,
                };
                self.real.borrow_mut().insert(name, found);
                watched
            }
        }
    };
}

watched! {
    glActiveTexture(unit: u32);
    glBindBuffer(target: u32, buffer: u32);
    glBindFramebuffer(target: u32, framebuffer: u32);
    glBindTexture(target: u32, texture: u32);
    glBindVertexArray(array: u32);
    glClear(mask: u32);
    glDebugMessageCallback(callback: *const c_void, user: *const c_void);
    glDeleteBuffers(count: i32, names: *const u32);
    glDeleteFramebuffers(count: i32, names: *const u32);
    glDeleteProgram(program: u32);
    glDeleteTextures(count: i32, names: *const u32);
    glDeleteVertexArrays(count: i32, names: *const u32);
    glDisable(capability: u32);
    glDrawArraysInstanced(mode: u32, first: i32, count: i32, instances: i32);
    glEnable(capability: u32);
    glUseProgram(program: u32);
    glViewport(x: i32, y: i32, width: i32, height: i32);
}

extern "system" fn buffer_data(target: u32, size: isize, data: *const c_void, usage: u32) {
    type BufferData = unsafe extern "system" fn(u32, isize, *const c_void, u32);
    let state = STATE.try_with(|state| (state.call("glBufferData"), state.most_bytes.get()));
    let Ok((Some(real), most)) = state else {
        return;
    };
    // What no driver can hold, without data to read.
    let (size, data) = if size.unsigned_abs() > most {
        (isize::MAX / 2, std::ptr::null())
    } else {
        (size, data)
    };
    // SAFETY: the driver's function of this name; the context is current, and the data is that of
    // the caller, or none.
    unsafe { std::mem::transmute::<*const c_void, BufferData>(real)(target, size, data, usage) }
}

extern "system" fn buffer_sub_data(target: u32, offset: isize, size: isize, data: *const c_void) {
    type BufferSubData = unsafe extern "system" fn(u32, isize, isize, *const c_void);
    let real = STATE.try_with(|state| state.upload("glBufferSubData", size.unsigned_abs()));
    if let Ok(Some(real)) = real {
        // SAFETY: the driver's function of this name; the context is current, and the data is that of
        // the caller.
        unsafe {
            std::mem::transmute::<*const c_void, BufferSubData>(real)(target, offset, size, data)
        }
    }
}

/// Bytes of a picture; of tables four numbers a cell.
fn picture_bytes(width: i32, height: i32, component: u32, data: *const c_void) -> usize {
    let cells = width.unsigned_abs() as usize * height.unsigned_abs() as usize;
    let bytes = if component == glow::FLOAT { 16 } else { 4 };
    if data.is_null() { 0 } else { cells * bytes }
}

#[allow(clippy::too_many_arguments, reason = "OpenGL's")]
extern "system" fn tex_image(
    target: u32,
    level: i32,
    format: i32,
    width: i32,
    height: i32,
    border: i32,
    components: u32,
    component: u32,
    data: *const c_void,
) {
    type TexImage =
        unsafe extern "system" fn(u32, i32, i32, i32, i32, i32, u32, u32, *const c_void);
    let bytes = picture_bytes(width, height, component, data);
    let real = STATE.try_with(|state| state.upload("glTexImage2D", bytes));
    if let Ok(Some(real)) = real {
        // SAFETY: as in `buffer_sub_data`.
        unsafe {
            std::mem::transmute::<*const c_void, TexImage>(real)(
                target, level, format, width, height, border, components, component, data,
            )
        }
    }
}

#[allow(clippy::too_many_arguments, reason = "OpenGL's")]
extern "system" fn tex_sub_image(
    target: u32,
    level: i32,
    x: i32,
    y: i32,
    width: i32,
    height: i32,
    components: u32,
    component: u32,
    data: *const c_void,
) {
    type TexSubImage =
        unsafe extern "system" fn(u32, i32, i32, i32, i32, i32, u32, u32, *const c_void);
    let bytes = picture_bytes(width, height, component, data);
    let real = STATE.try_with(|state| state.upload("glTexSubImage2D", bytes));
    if let Ok(Some(real)) = real {
        // SAFETY: as in `buffer_sub_data`.
        unsafe {
            std::mem::transmute::<*const c_void, TexSubImage>(real)(
                target, level, x, y, width, height, components, component, data,
            )
        }
    }
}

extern "system" fn link_program(program: u32) {
    type LinkProgram = unsafe extern "system" fn(u32);
    let real = STATE.try_with(|state| {
        state.linked.set(state.linked.get() + 1);
        state.call("glLinkProgram")
    });
    if let Ok(Some(real)) = real {
        // SAFETY: the driver's function of this name; the context is current.
        unsafe { std::mem::transmute::<*const c_void, LinkProgram>(real)(program) }
    }
}

extern "system" fn get_error() -> u32 {
    type GetError = unsafe extern "system" fn() -> u32;
    let state = STATE.try_with(|state| (state.call("glGetError"), state.is_reset.take()));
    match state {
        Ok((Some(_), true)) => glow::CONTEXT_LOST,
        // SAFETY: the driver's function of this name; the context is current.
        Ok((Some(real), false)) => unsafe {
            std::mem::transmute::<*const c_void, GetError>(real)()
        },
        _ => glow::NO_ERROR,
    }
}
