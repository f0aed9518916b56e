//! What a driver without a browser before it is asked and heard: its version, and its messages.

use std::ffi::{CStr, c_char, c_void};
use std::sync::{Arc, Mutex};

use glow::HasContext as _;

use super::ContextError;
use super::gl::MAX_MESSAGES;

/// Checks that the version is one that the project needs. `glow` panics on a missing or odd version
/// string, so this comes first.
///
/// # Safety
/// A context is current, and what `load` returns for a name is its entry point of that name.
pub(in crate::gpu) unsafe fn check_version(
    load: &impl Fn(&CStr) -> *const c_void,
) -> Result<(), ContextError> {
    type GetString = unsafe extern "system" fn(u32) -> *const c_char;
    let missing = || ContextError::Native("the driver reports no OpenGL version".to_owned());
    let function = load(c"glGetString");
    if function.is_null() {
        return Err(missing());
    }
    // SAFETY: the entry point of this name has this type in the OpenGL specification, and the
    // context is current; the string that it returns is static and terminated by zero.
    let version = unsafe {
        let get_string = std::mem::transmute::<*const c_void, GetString>(function);
        let text = get_string(glow::VERSION);
        if text.is_null() {
            return Err(missing());
        }
        CStr::from_ptr(text).to_string_lossy().into_owned()
    };
    let is_gles = version.starts_with("OpenGL ES");
    let number = version
        .split_whitespace()
        .find(|word| word.starts_with(|c: char| c.is_ascii_digit()));
    let mut parts = number
        .unwrap_or_default()
        .split('.')
        .map_while(|part| part.parse::<u32>().ok());
    let found = (parts.next().unwrap_or(0), parts.next().unwrap_or(0));
    let needed = if is_gles { (3, 0) } else { (3, 3) };
    if found < needed {
        return Err(ContextError::TooOld { found: version });
    }
    Ok(())
}

/// Collects the driver's messages of errors and of high severity, where it has any.
///
/// # Safety
/// The context of `glow` is current, now and when `glow` is dropped.
pub(in crate::gpu) unsafe fn collect_messages(glow: &mut glow::Context) -> Arc<Mutex<Vec<String>>> {
    let messages = Arc::new(Mutex::new(Vec::new()));
    if glow.supports_debug() {
        let queue = Arc::clone(&messages);
        // SAFETY: the context is current. The callback owns what it uses; `glow` frees it after it
        // was unregistered, which the contract of this function makes possible.
        unsafe {
            glow.enable(glow::DEBUG_OUTPUT);
            // Otherwise the driver may call from a thread of its own.
            glow.enable(glow::DEBUG_OUTPUT_SYNCHRONOUS);
            glow.debug_message_callback(move |_source, kind, _id, severity, text| {
                let counts =
                    kind == glow::DEBUG_TYPE_ERROR || severity == glow::DEBUG_SEVERITY_HIGH;
                if counts
                    && let Ok(mut queue) = queue.lock()
                    && queue.len() < MAX_MESSAGES
                {
                    queue.push(text.trim_end().to_owned());
                }
            });
        }
    }
    messages
}
