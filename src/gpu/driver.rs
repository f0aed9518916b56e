//! The driver behind a context: its version, limits and messages.

use std::ffi::{CStr, c_char, c_void};
use std::sync::{Arc, Mutex};

use glow::HasContext as _;

use super::ContextError;
use super::gl::MAX_MESSAGES;

/// Properties and limits of the driver.
#[derive(Debug, Clone, PartialEq)]
pub struct Info {
    /// `GL_VERSION`.
    pub version: String,
    /// `GL_RENDERER`.
    pub renderer: String,
    /// `GL_VENDOR`.
    pub vendor: String,
    /// `GL_SHADING_LANGUAGE_VERSION`.
    pub glsl: String,
    /// Whether the picture is computed on the processor (llvmpipe, softpipe, swrast).
    pub is_software: bool,
    /// Whether this is OpenGL ES rather than OpenGL.
    pub is_gles: bool,
    /// Most samples a pixel of a [`Framebuffer`](super::Framebuffer).
    pub max_samples: u32,
    /// Longest side of a texture, in pixels.
    pub max_texture_size: u32,
    /// Most textures that a vertex shader can read.
    pub max_vertex_textures: u32,
    /// Number of attributes that a vertex can have.
    pub max_vertex_attributes: u32,
    /// Longest side of a framebuffer, in pixels.
    pub max_framebuffer_size: u32,
    /// Largest point, in pixels.
    pub max_point_size: f32,
    /// Widest line that the driver itself draws, in pixels.
    pub max_line_width: f32,
}

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

/// Asks for the properties and limits.
///
/// # Safety
/// The context of `glow` is current.
pub(in crate::gpu) unsafe fn read_info(glow: &glow::Context) -> Info {
    let largest = |parameter| {
        let mut range = [0.0_f32; 2];
        // SAFETY: the context is current; both ranges that are asked for have two numbers.
        unsafe { glow.get_parameter_f32_slice(parameter, &mut range) };
        range[1].max(1.0)
    };
    // SAFETY: the context is current.
    let text = |parameter| unsafe { glow.get_parameter_string(parameter) };
    // SAFETY: the context is current.
    let number = |parameter| {
        unsafe { glow.get_parameter_i32(parameter) }
            .max(0)
            .unsigned_abs()
    };
    let mut viewport = [0; 2];
    // SAFETY: the context is current; this parameter is two numbers.
    unsafe { glow.get_parameter_i32_slice(glow::MAX_VIEWPORT_DIMS, &mut viewport) };
    let largest_viewport = viewport[0].min(viewport[1]).max(0).unsigned_abs();
    let is_gles = glow.version().is_embedded;
    // The core profile and ES each know only one of these names.
    let point_sizes = if is_gles {
        glow::ALIASED_POINT_SIZE_RANGE
    } else {
        glow::POINT_SIZE_RANGE
    };
    let renderer = text(glow::RENDERER);
    let lower = renderer.to_lowercase();
    let is_software = ["llvmpipe", "softpipe", "swrast", "software", "swr "]
        .iter()
        .any(|name| lower.contains(name));
    Info {
        version: text(glow::VERSION),
        vendor: text(glow::VENDOR),
        glsl: text(glow::SHADING_LANGUAGE_VERSION),
        is_software,
        renderer,
        is_gles,
        max_samples: number(glow::MAX_SAMPLES),
        max_texture_size: number(glow::MAX_TEXTURE_SIZE),
        max_vertex_textures: number(glow::MAX_VERTEX_TEXTURE_IMAGE_UNITS),
        max_vertex_attributes: number(glow::MAX_VERTEX_ATTRIBS),
        max_framebuffer_size: number(glow::MAX_RENDERBUFFER_SIZE)
            .min(number(glow::MAX_TEXTURE_SIZE))
            .min(largest_viewport),
        max_point_size: largest(point_sizes),
        max_line_width: largest(glow::ALIASED_LINE_WIDTH_RANGE),
    }
}
