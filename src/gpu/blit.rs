//! Copying from one framebuffer to another.

use super::Gl;
use glow::HasContext as _;

/// A rectangle of pixels, counted from the bottom left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rect {
    /// Left side.
    pub x: i32,
    /// Lower side.
    pub y: i32,
    /// In pixels.
    pub width: i32,
    /// In pixels.
    pub height: i32,
}

/// Switches the scissor test and sRGB conversion off, which copying and clearing obey.
///
/// # Safety
/// The context is current, and `is_gles` says truly whether it is one of OpenGL ES.
pub(super) unsafe fn prepare_whole(glow: &glow::Context, is_gles: bool) {
    // SAFETY: by this function's contract; OpenGL ES has no such conversion to switch.
    unsafe {
        glow.disable(glow::SCISSOR_TEST);
        glow.disable(glow::RASTERIZER_DISCARD);
        glow.disable(glow::DITHER);
        if !is_gles {
            glow.disable(glow::FRAMEBUFFER_SRGB);
        }
    }
}

/// Copies colors from a part of one framebuffer into a part of another, or of the window; scaled if sizes
/// differ, and averaged if there are samples.
pub(super) fn blit(
    gl: &Gl,
    from: glow::Framebuffer,
    source: Rect,
    to: Option<glow::Framebuffer>,
    target: Rect,
) {
    let Some(glow) = gl.current() else {
        return;
    };
    let same_size = (source.width, source.height) == (target.width, target.height);
    let filter = if same_size {
        glow::NEAREST
    } else {
        glow::LINEAR
    };
    // SAFETY: current context, which both are of; the driver leaves out parts outside of a picture.
    unsafe {
        prepare_whole(glow, gl.info().is_gles);
        glow.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(from));
        glow.bind_framebuffer(glow::DRAW_FRAMEBUFFER, to);
        glow.blit_framebuffer(
            source.x,
            source.y,
            source.x.saturating_add(source.width),
            source.y.saturating_add(source.height),
            target.x,
            target.y,
            target.x.saturating_add(target.width),
            target.y.saturating_add(target.height),
            glow::COLOR_BUFFER_BIT,
            filter,
        );
    }
}
