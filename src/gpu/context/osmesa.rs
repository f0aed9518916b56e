//! Mesa on the processor through `libOSMesa`, loaded when asked for: newer versions of Mesa have none.

use std::cell::RefCell;
use std::ffi::{CStr, c_char, c_int, c_void};
use std::ptr;
use std::rc::Rc;

use libloading::Library;

use super::turn::Turn;
use super::{Api, NativeContext};
use crate::gpu::{ContextError, Gl};

const LIBRARIES: [&str; 3] = ["libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"];

const RGBA: c_int = 0x1908;
const UNSIGNED_BYTE: u32 = 0x1401;
const FORMAT: c_int = 0x22;
const DEPTH_BITS: c_int = 0x30;
const PROFILE: c_int = 0x33;
const CORE_PROFILE: c_int = 0x34;
const MAJOR_VERSION: c_int = 0x36;
const MINOR_VERSION: c_int = 0x37;

/// The side of the buffer that OSMesa wants; pictures are drawn into framebuffers of their own.
const SIDE: c_int = 4;

type RawContext = *mut c_void;
type CreateContext = unsafe extern "C" fn(*const c_int, RawContext) -> RawContext;
type DestroyContext = unsafe extern "C" fn(RawContext);
type MakeCurrent = unsafe extern "C" fn(RawContext, *mut c_void, u32, c_int, c_int) -> u8;
type GetProcAddress = unsafe extern "C" fn(*const c_char) -> *const c_void;

#[derive(Clone, Copy)]
struct Functions {
    create_context: CreateContext,
    destroy_context: DestroyContext,
    make_current: MakeCurrent,
    get_proc_address: GetProcAddress,
}

/// A context and the pixels it must have as its window.
struct OsmesaContext {
    functions: Functions,
    raw: RawContext,
    pixels: RefCell<Vec<u32>>,
    /// Ends after the context.
    _turn: Rc<Turn>,
}

/// A new context, current on this thread.
pub(super) fn create(api: Api) -> Result<Gl, ContextError> {
    let failed = |cause: &str| ContextError::Osmesa {
        cause: cause.to_owned(),
    };
    if api == Api::Gles {
        return Err(failed("it has no OpenGL ES"));
    }
    let turn = Turn::of_this_thread();
    let functions = load()?;
    let attributes = [
        FORMAT,
        RGBA,
        DEPTH_BITS,
        24,
        PROFILE,
        CORE_PROFILE,
        MAJOR_VERSION,
        3,
        MINOR_VERSION,
        3,
        0,
    ];
    // SAFETY: the list ends with zero, and no context is shared with.
    let raw = unsafe { (functions.create_context)(attributes.as_ptr(), ptr::null_mut()) };
    if raw.is_null() {
        return Err(failed("it has no OpenGL 3.3 core"));
    }
    let pixels = RefCell::new(vec![0; (SIDE * SIDE).unsigned_abs() as usize]);
    let context = Rc::new(OsmesaContext {
        functions,
        raw,
        pixels,
        _turn: turn,
    });
    // SAFETY: names end with zero; an unknown name gives null. The entry points stay valid, since
    // the library is never unloaded.
    unsafe {
        Gl::new(context, |name: &CStr| {
            (functions.get_proc_address)(name.as_ptr())
        })
    }
}

impl NativeContext for OsmesaContext {
    fn make_current(&self) -> Result<(), String> {
        let pixels = self.pixels.borrow_mut().as_mut_ptr().cast();
        // SAFETY: the context is alive until `self` is dropped, and so are its SIDE x SIDE pixels of
        // four bytes, which nothing else reads or writes.
        let done =
            unsafe { (self.functions.make_current)(self.raw, pixels, UNSIGNED_BYTE, SIDE, SIDE) };
        if done == 0 {
            return Err("OSMesaMakeCurrent failed".to_owned());
        }
        Ok(())
    }

    fn release(&self) {
        // SAFETY: a null context means none. The result is of no use: the next context reports.
        unsafe {
            (self.functions.make_current)(ptr::null_mut(), ptr::null_mut(), UNSIGNED_BYTE, 0, 0)
        };
    }
}

impl Drop for OsmesaContext {
    fn drop(&mut self) {
        // SAFETY: created by this library, destroyed once, and no longer current: `OwnedNative`
        // releases it first.
        unsafe { (self.functions.destroy_context)(self.raw) }
    }
}

fn load() -> Result<Functions, ContextError> {
    let mut cause = String::new();
    for name in LIBRARIES {
        // SAFETY: loading Mesa runs its initialisers, which have no preconditions.
        match unsafe { Library::new(name) } {
            Ok(library) => return functions_of(library),
            Err(error) if cause.is_empty() => cause = error.to_string(),
            Err(_) => {}
        }
    }
    Err(ContextError::Library {
        library: "libOSMesa",
        cause,
    })
}

fn functions_of(library: Library) -> Result<Functions, ContextError> {
    // Entry points may be held by anybody who holds a `glow` context: never unloaded.
    let library: &'static Library = Box::leak(Box::new(library));
    let missing = |error: libloading::Error| ContextError::Osmesa {
        cause: error.to_string(),
    };
    // SAFETY: the types are those of `GL/osmesa.h`.
    unsafe {
        Ok(Functions {
            create_context: *library
                .get(b"OSMesaCreateContextAttribs\0")
                .map_err(missing)?,
            destroy_context: *library.get(b"OSMesaDestroyContext\0").map_err(missing)?,
            make_current: *library.get(b"OSMesaMakeCurrent\0").map_err(missing)?,
            get_proc_address: *library.get(b"OSMesaGetProcAddress\0").map_err(missing)?,
        })
    }
}
