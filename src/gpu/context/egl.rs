//! A context without a window through EGL: every device in turn, then Mesa without a device.
//!
//! EGL is called directly rather than through `glutin`, which has no surfaceless platform: one path
//! serves both. A display is shared by everybody who asks for the same device and is therefore
//! never terminated.

use std::ffi::{CStr, c_char, c_void};
use std::ptr;
use std::rc::Rc;

use libloading::Library;

use super::turn::Turn;
use super::{Api, NativeContext};
use crate::gpu::{ContextError, Gl};

const LIBRARIES: [&str; 2] = ["libEGL.so.1", "libEGL.so"];

const PLATFORM_DEVICE: u32 = 0x313F;
const PLATFORM_SURFACELESS: u32 = 0x31DD;
const OPENGL_API: u32 = 0x30A2;
const OPENGL_ES_API: u32 = 0x30A0;
const NONE: i32 = 0x3038;
const SURFACE_TYPE: i32 = 0x3033;
const RENDERABLE_TYPE: i32 = 0x3040;
const OPENGL_BIT: i32 = 0x0008;
const OPENGL_ES3_BIT: i32 = 0x0040;
const MAJOR_VERSION: i32 = 0x3098;
const MINOR_VERSION: i32 = 0x30FB;
const PROFILE_MASK: i32 = 0x30FD;
const CORE_PROFILE: i32 = 0x0001;
const MAX_DEVICES: usize = 64;

type Handle = *mut c_void;
type QueryDevices = unsafe extern "system" fn(i32, *mut Handle, *mut i32) -> u32;
type GetPlatformDisplay = unsafe extern "system" fn(u32, Handle, *const i32) -> Handle;

#[derive(Clone, Copy)]
struct Functions {
    get_proc_address: unsafe extern "system" fn(*const c_char) -> *const c_void,
    get_error: unsafe extern "system" fn() -> i32,
    initialize: unsafe extern "system" fn(Handle, *mut i32, *mut i32) -> u32,
    bind_api: unsafe extern "system" fn(u32) -> u32,
    choose_config: unsafe extern "system" fn(Handle, *const i32, *mut Handle, i32, *mut i32) -> u32,
    create_context: unsafe extern "system" fn(Handle, Handle, Handle, *const i32) -> Handle,
    destroy_context: unsafe extern "system" fn(Handle, Handle) -> u32,
    make_current: unsafe extern "system" fn(Handle, Handle, Handle, Handle) -> u32,
    query_devices: Option<QueryDevices>,
    get_platform_display: GetPlatformDisplay,
}

struct EglContext {
    functions: Functions,
    api: u32,
    display: Handle,
    raw: Handle,
    /// Ends after the context.
    _turn: Rc<Turn>,
}

/// A new context, current on this thread.
pub(super) fn create(api: Api) -> Result<Gl, ContextError> {
    let turn = Turn::of_this_thread();
    let functions = load()?;
    let mut tried = Vec::new();
    let devices = functions.devices();
    let devices = devices.iter().map(|&device| (PLATFORM_DEVICE, device));
    for (index, (platform, device)) in devices
        .chain([(PLATFORM_SURFACELESS, ptr::null_mut())])
        .enumerate()
    {
        match functions.context_on(platform, device, api, &turn) {
            Ok(gl) => return Ok(gl),
            Err(cause) if platform == PLATFORM_SURFACELESS => {
                tried.push(format!("surfaceless: {cause}"))
            }
            Err(cause) => tried.push(format!("device {index}: {cause}")),
        }
    }
    Err(ContextError::NoDevice { tried })
}

impl Functions {
    fn devices(&self) -> Vec<Handle> {
        let mut devices = vec![ptr::null_mut(); MAX_DEVICES];
        let mut count = 0;
        let Some(query) = self.query_devices else {
            return Vec::new();
        };
        // SAFETY: there is room for MAX_DEVICES handles.
        let done = unsafe { query(MAX_DEVICES as i32, devices.as_mut_ptr(), &raw mut count) };
        let count = if done == 0 {
            0
        } else {
            usize::try_from(count).unwrap_or(0)
        };
        devices.truncate(count);
        devices
    }

    fn context_on(
        self,
        platform: u32,
        device: Handle,
        api: Api,
        turn: &Rc<Turn>,
    ) -> Result<Gl, String> {
        let (api_name, bit) = match api {
            Api::Gl => (OPENGL_API, OPENGL_BIT),
            Api::Gles => (OPENGL_ES_API, OPENGL_ES3_BIT),
        };
        // No surface is wanted; EGL would ask for one that can be a window by default.
        let config_attributes = [SURFACE_TYPE, 0, RENDERABLE_TYPE, bit, NONE];
        let context_attributes: &[i32] = match api {
            Api::Gl => &[
                MAJOR_VERSION,
                3,
                MINOR_VERSION,
                3,
                PROFILE_MASK,
                CORE_PROFILE,
                NONE,
            ],
            Api::Gles => &[MAJOR_VERSION, 3, MINOR_VERSION, 0, NONE],
        };
        // SAFETY: lists end with NONE, outputs have room for one value, and handles are those that
        // EGL just returned; each step is taken only after the one before it succeeded. The entry
        // points that `eglGetProcAddress` returns stay valid, since the library is never unloaded.
        unsafe {
            let display = (self.get_platform_display)(platform, device, ptr::null());
            self.expect(!display.is_null(), "no display")?;
            let done = (self.initialize)(display, ptr::null_mut(), ptr::null_mut());
            self.expect(done != 0, "the display does not start")?;
            self.expect(
                (self.bind_api)(api_name) != 0,
                "this kind of OpenGL is missing",
            )?;
            let (mut config, mut count) = (ptr::null_mut(), 0);
            let attributes = config_attributes.as_ptr();
            let done =
                (self.choose_config)(display, attributes, &raw mut config, 1, &raw mut count);
            self.expect(done != 0 && count > 0, "no configuration")?;
            let attributes = context_attributes.as_ptr();
            let raw = (self.create_context)(display, config, ptr::null_mut(), attributes);
            self.expect(!raw.is_null(), "no context of the version needed")?;
            let context = Rc::new(EglContext {
                functions: self,
                api: api_name,
                display,
                raw,
                _turn: Rc::clone(turn),
            });
            let load = |name: &CStr| (self.get_proc_address)(name.as_ptr());
            Gl::new(context, load).map_err(|error| error.to_string())
        }
    }

    /// EGL's error code beside `what` failed, unless it did not.
    fn expect(&self, succeeded: bool, what: &str) -> Result<(), String> {
        if succeeded {
            return Ok(());
        }
        // SAFETY: the function has no preconditions.
        let code = unsafe { (self.get_error)() };
        Err(format!("{what}, EGL error 0x{code:04x}"))
    }
}

impl NativeContext for EglContext {
    fn make_current(&self) -> Result<(), String> {
        // SAFETY: display and context are alive until `self` is dropped; drawing goes to
        // framebuffers, so no surface is needed.
        let done = unsafe {
            (self.functions.make_current)(self.display, ptr::null_mut(), ptr::null_mut(), self.raw)
        };
        self.functions.expect(done != 0, "eglMakeCurrent failed")
    }

    fn release(&self) {
        let none = ptr::null_mut();
        // SAFETY: no context and no surfaces are passed. EGL releases the context of the API that
        // is bound. The results are of no use: the next context to be made current reports.
        unsafe {
            (self.functions.bind_api)(self.api);
            (self.functions.make_current)(self.display, none, none, none);
        }
    }
}

impl Drop for EglContext {
    fn drop(&mut self) {
        // SAFETY: created on this display, destroyed once, and no longer current: `OwnedNative`
        // releases it first.
        unsafe { (self.functions.destroy_context)(self.display, self.raw) };
    }
}

fn load() -> Result<Functions, ContextError> {
    let mut cause = String::new();
    for name in LIBRARIES {
        // SAFETY: loading EGL runs its initialisers, which have no preconditions.
        match unsafe { Library::new(name) } {
            Ok(library) => {
                return functions_of(library).map_err(|cause| ContextError::Library {
                    library: "libEGL",
                    cause,
                });
            }
            Err(error) if cause.is_empty() => cause = error.to_string(),
            Err(_) => {}
        }
    }
    Err(ContextError::Library {
        library: "libEGL",
        cause,
    })
}

fn functions_of(library: Library) -> Result<Functions, String> {
    // Entry points may be held by anybody who holds a `glow` context: never unloaded.
    let library: &'static Library = Box::leak(Box::new(library));
    let missing = |error: libloading::Error| error.to_string();
    // SAFETY: the types are those of `EGL/egl.h` and `EGL/eglext.h`; an optional function that is
    // null is None.
    unsafe {
        let get_proc_address: unsafe extern "system" fn(*const c_char) -> *const c_void =
            *library.get(b"eglGetProcAddress\0").map_err(missing)?;
        let extension = |name: &CStr| get_proc_address(name.as_ptr());
        let query_devices = extension(c"eglQueryDevicesEXT");
        let get_platform_display = extension(c"eglGetPlatformDisplayEXT");
        if get_platform_display.is_null() {
            return Err("it is too old: eglGetPlatformDisplayEXT is missing".to_owned());
        }
        Ok(Functions {
            get_proc_address,
            get_error: *library.get(b"eglGetError\0").map_err(missing)?,
            initialize: *library.get(b"eglInitialize\0").map_err(missing)?,
            bind_api: *library.get(b"eglBindAPI\0").map_err(missing)?,
            choose_config: *library.get(b"eglChooseConfig\0").map_err(missing)?,
            create_context: *library.get(b"eglCreateContext\0").map_err(missing)?,
            destroy_context: *library.get(b"eglDestroyContext\0").map_err(missing)?,
            make_current: *library.get(b"eglMakeCurrent\0").map_err(missing)?,
            query_devices: std::mem::transmute::<*const c_void, Option<QueryDevices>>(
                query_devices,
            ),
            get_platform_display: std::mem::transmute::<*const c_void, GetPlatformDisplay>(
                get_platform_display,
            ),
        })
    }
}
