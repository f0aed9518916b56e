//! The driver behind a context: its names and limits.

use glow::HasContext as _;

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
    /// Corners of triangles are moved to the nearest of two to the power of so many places along a pixel.
    pub subpixel_bits: u32,
    /// Largest point, in pixels.
    pub max_point_size: f32,
    /// Widest line that the driver itself draws, in pixels.
    pub max_line_width: f32,
}

/// Extension of browsers that tells the driver's name, which is masked otherwise.
const RENDERER_INFO: &str = "WEBGL_debug_renderer_info";
/// Name of the renderer, by that extension.
const UNMASKED_RENDERER: u32 = 0x9246;

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
    // Browsers have the name of the driver under another number, if they tell it.
    let is_masked = glow.supported_extensions().contains(RENDERER_INFO);
    let renderer = text(if is_masked {
        UNMASKED_RENDERER
    } else {
        glow::RENDERER
    });
    let lower = renderer.to_lowercase();
    let is_software = [
        "llvmpipe",
        "softpipe",
        "swrast",
        "software",
        "swr ",
        "swiftshader",
    ]
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
        subpixel_bits: number(glow::SUBPIXEL_BITS),
        max_point_size: largest(point_sizes),
        max_line_width: largest(glow::ALIASED_LINE_WIDTH_RANGE),
    }
}
