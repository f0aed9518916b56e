//! The fixed-function state of a draw, always set as a whole.

use glow::HasContext as _;

use super::Gl;

/// Comparison of a fragment's depth with the depth that is there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DepthTest {
    /// All of them; depth is neither read nor written.
    Off,
    /// The nearer ones.
    #[default]
    Less,
    /// The nearer ones and those equally far.
    LessEqual,
    /// All of them, and depth may be written.
    Always,
}

/// Combination of a fragment's color with the color that is there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Blend {
    /// The fragment's color replaces the one that is there.
    #[default]
    None,
    /// Covers it by its alpha; the picture's own alpha stays right too.
    Alpha,
    /// As `Alpha`, with colors that are already multiplied by their alpha.
    Premultiplied,
}

/// The state of a draw, apart from shader and data.
///
/// [`apply`](Self::apply) sets the whole of it every time, since a user interface painter leaves
/// its own state behind. Rectangles are x, y, width, height in pixels, from the bottom left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawState {
    /// Rectangle that clip space is mapped to.
    pub viewport: [i32; 4],
    /// Rectangle outside of which nothing is drawn, if there is one.
    pub scissor: Option<[i32; 4]>,
    /// Comparison that decides which fragments pass.
    pub depth_test: DepthTest,
    /// Whether fragments that pass write their depth.
    pub depth_write: bool,
    /// Combination of colors.
    pub blend: Blend,
    /// Whether red, green, blue and alpha are written.
    pub color_mask: [bool; 4],
}

impl DrawState {
    /// An opaque draw with depth over the whole of a picture of this size.
    #[must_use]
    pub fn opaque(width: u32, height: u32) -> Self {
        let side = |pixels| i32::try_from(pixels).unwrap_or(i32::MAX);
        Self {
            viewport: [0, 0, side(width), side(height)],
            scissor: None,
            depth_test: DepthTest::Less,
            depth_write: true,
            blend: Blend::None,
            color_mask: [true; 4],
        }
    }

    /// Makes this the state of the following draws, whatever was set before.
    pub fn apply(&self, gl: &Gl) {
        gl.set_viewport(self.viewport);
        let Some(glow) = gl.current() else {
            return;
        };
        let [red, green, blue, alpha] = self.color_mask;
        // SAFETY: current context; all values are constants of OpenGL 3.3 and OpenGL ES 3.0.
        unsafe {
            reset_unused(glow, gl.info().is_gles);
            if let Some([x, y, width, height]) = self.scissor {
                glow.enable(glow::SCISSOR_TEST);
                glow.scissor(x, y, width, height);
            }
            set_enabled(glow, glow::DEPTH_TEST, self.depth_test != DepthTest::Off);
            glow.depth_func(match self.depth_test {
                DepthTest::Less => glow::LESS,
                DepthTest::LessEqual => glow::LEQUAL,
                DepthTest::Off | DepthTest::Always => glow::ALWAYS,
            });
            glow.depth_mask(self.depth_write);
            glow.color_mask(red, green, blue, alpha);
            self.blend.apply(glow);
        }
    }
}

impl Blend {
    /// # Safety
    /// The context is current.
    unsafe fn apply(self, glow: &glow::Context) {
        let source = if self == Self::Alpha {
            glow::SRC_ALPHA
        } else {
            glow::ONE
        };
        let rest = if self == Self::None {
            glow::ZERO
        } else {
            glow::ONE_MINUS_SRC_ALPHA
        };
        // SAFETY: by this function's contract; all values are constants of OpenGL 3.3 and ES 3.0.
        unsafe {
            set_enabled(glow, glow::BLEND, self != Self::None);
            glow.blend_equation(glow::FUNC_ADD);
            glow.blend_func_separate(source, rest, glow::ONE, rest);
        }
    }
}

/// Resets the state that no draw of this layer needs, but that other code may have set.
///
/// # Safety
/// The context is current, and `is_gles` says truly whether it is one of OpenGL ES.
unsafe fn reset_unused(glow: &glow::Context, is_gles: bool) {
    let off = [
        glow::CULL_FACE,
        glow::DITHER,
        glow::POLYGON_OFFSET_FILL,
        glow::SCISSOR_TEST,
        glow::STENCIL_TEST,
        glow::SAMPLE_ALPHA_TO_COVERAGE,
        glow::SAMPLE_COVERAGE,
        glow::RASTERIZER_DISCARD,
    ];
    // OpenGL ES has none of these; there, points have the shader's size and multisampling is on.
    let off_natively = [
        glow::FRAMEBUFFER_SRGB,
        glow::COLOR_LOGIC_OP,
        glow::PRIMITIVE_RESTART,
        glow::DEPTH_CLAMP,
        glow::LINE_SMOOTH,
        glow::POLYGON_SMOOTH,
        glow::POLYGON_OFFSET_LINE,
        glow::POLYGON_OFFSET_POINT,
    ];
    // SAFETY: by this function's contract; all values are constants of OpenGL 3.3, or of ES 3.0
    // where the context is one.
    unsafe {
        off.iter().for_each(|&capability| glow.disable(capability));
        glow.front_face(glow::CCW);
        // Of `f64` where that is, as in OpenGL 3.3, and of `f32` in OpenGL ES.
        glow.depth_range(0.0, 1.0);
        glow.line_width(1.0);
        glow.active_texture(glow::TEXTURE0);
        if !is_gles {
            off_natively
                .iter()
                .for_each(|&capability| glow.disable(capability));
            glow.enable(glow::MULTISAMPLE);
            glow.enable(glow::PROGRAM_POINT_SIZE);
            glow.polygon_mode(glow::FRONT_AND_BACK, glow::FILL);
        }
    }
}

/// # Safety
/// The context is current and has `capability`.
unsafe fn set_enabled(glow: &glow::Context, capability: u32, enabled: bool) {
    // SAFETY: by this function's contract.
    unsafe {
        if enabled {
            glow.enable(capability)
        } else {
            glow.disable(capability)
        }
    }
}
