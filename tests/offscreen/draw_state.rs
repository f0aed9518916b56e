//! The draw state is set as a whole, whatever foreign code left behind.

use editor_core::gpu::{Blend, DepthTest, DrawState, Gl, Immediate, Mode};
use glam::Vec3;
use glow::HasContext as _;

use crate::offscreen::support::{Picture, black, on_each_backend};

const CAPABILITIES: [u32; 10] = [
    glow::BLEND,
    glow::CULL_FACE,
    glow::DEPTH_TEST,
    glow::DITHER,
    glow::POLYGON_OFFSET_FILL,
    glow::RASTERIZER_DISCARD,
    glow::SAMPLE_ALPHA_TO_COVERAGE,
    glow::SAMPLE_COVERAGE,
    glow::SCISSOR_TEST,
    glow::STENCIL_TEST,
];

/// Those that OpenGL ES does not have.
const NATIVE_CAPABILITIES: [u32; 10] = [
    glow::COLOR_LOGIC_OP,
    glow::DEPTH_CLAMP,
    glow::FRAMEBUFFER_SRGB,
    glow::LINE_SMOOTH,
    glow::MULTISAMPLE,
    glow::POLYGON_OFFSET_LINE,
    glow::POLYGON_OFFSET_POINT,
    glow::POLYGON_SMOOTH,
    glow::PRIMITIVE_RESTART,
    glow::PROGRAM_POINT_SIZE,
];

const NUMBERS: [u32; 11] = [
    glow::ACTIVE_TEXTURE,
    glow::BLEND_DST_ALPHA,
    glow::BLEND_DST_RGB,
    glow::BLEND_EQUATION_ALPHA,
    glow::BLEND_EQUATION_RGB,
    glow::BLEND_SRC_ALPHA,
    glow::BLEND_SRC_RGB,
    glow::DEPTH_FUNC,
    glow::DEPTH_WRITEMASK,
    glow::FRONT_FACE,
    glow::COLOR_WRITEMASK,
];

const FRACTIONS: [u32; 2] = [glow::DEPTH_RANGE, glow::LINE_WIDTH];

fn capabilities(gl: &Gl) -> Vec<u32> {
    let mut capabilities = CAPABILITIES.to_vec();
    if !gl.info().is_gles {
        capabilities.extend(NATIVE_CAPABILITIES);
    }
    capabilities
}

/// The driver's own account of its state, one line a value.
fn state(gl: &Gl) -> Vec<String> {
    let mut lines = Vec::new();
    // SAFETY: the context is current in here; no value has more than four numbers.
    let asked = gl.with_glow(|glow| unsafe {
        for capability in capabilities(gl) {
            lines.push(format!(
                "0x{capability:04x}: {}",
                glow.is_enabled(capability)
            ));
        }
        let polygon_mode = (!gl.info().is_gles).then_some(glow::POLYGON_MODE);
        for number in NUMBERS
            .into_iter()
            .chain([glow::VIEWPORT])
            .chain(polygon_mode)
        {
            let mut values = [0; 4];
            glow.get_parameter_i32_slice(number, &mut values);
            lines.push(format!("0x{number:04x}: {values:?}"));
        }
        for fraction in FRACTIONS {
            let mut values = [0.0; 4];
            glow.get_parameter_f32_slice(fraction, &mut values);
            lines.push(format!("0x{fraction:04x}: {values:?}"));
        }
    });
    asked.expect("a context");
    lines
}

/// Changes everything.
fn mess(gl: &Gl) {
    // SAFETY: the context is current in here.
    let messed = gl.with_glow(|glow| unsafe {
        for capability in capabilities(gl) {
            if glow.is_enabled(capability) {
                glow.disable(capability);
            } else {
                glow.enable(capability);
            }
        }
        glow.active_texture(glow::TEXTURE3);
        glow.blend_equation(glow::FUNC_REVERSE_SUBTRACT);
        glow.blend_func(glow::DST_COLOR, glow::SRC_COLOR);
        glow.color_mask(false, true, false, true);
        glow.cull_face(glow::FRONT_AND_BACK);
        glow.depth_func(glow::NEVER);
        glow.depth_mask(!glow.get_parameter_bool(glow::DEPTH_WRITEMASK));
        glow.depth_range_f32(0.5, 0.6);
        glow.front_face(glow::CW);
        glow.polygon_offset(7.0, 8.0);
        glow.scissor(1, 1, 1, 1);
        glow.use_program(None);
        glow.viewport(3, 3, 2, 2);
        if !gl.info().is_gles {
            glow.polygon_mode(glow::FRONT_AND_BACK, glow::LINE);
        }
    });
    messed.expect("a context");
}

const EVERYTHING_SET: DrawState = DrawState {
    viewport: [1, 2, 10, 11],
    scissor: Some([2, 3, 5, 7]),
    depth_test: DepthTest::LessEqual,
    depth_write: false,
    blend: Blend::Alpha,
    color_mask: [true, true, true, false],
};

#[test]
fn the_whole_state_is_set_whatever_was_left_behind() {
    on_each_backend(|gl| {
        for wanted in [DrawState::opaque(16, 16), EVERYTHING_SET] {
            wanted.apply(gl);
            let clean = state(gl);
            mess(gl);
            let messy = state(gl);
            let kept: Vec<_> = clean.iter().filter(|line| messy.contains(line)).collect();
            // The width of lines is not messed up: core OpenGL allows no other than 1.
            assert_eq!(kept.len(), 1, "a mess changes everything: {kept:?}");
            wanted.apply(gl);
            assert_eq!(state(gl), clean);
        }
    });
}

#[test]
fn a_picture_does_not_depend_on_what_was_left_behind() {
    on_each_backend(|gl| {
        let mut immediate = Immediate::new(gl).expect("the compatibility layer");
        let mut draw = || {
            let framebuffer = black(gl, 16, 16, 0);
            EVERYTHING_SET.apply(gl);
            immediate.begin(Mode::Triangles);
            for corner in [Vec3::NEG_ONE, Vec3::new(1.0, -1.0, 0.0), Vec3::ONE] {
                immediate.vertex(corner);
            }
            immediate.end();
            Picture::of(&framebuffer)
        };
        let clean = draw();
        let white = clean.count(|pixel| pixel == [255; 4]);
        assert!(
            (10..20).contains(&white),
            "{white} pixels, of the scissor rectangle's 35"
        );
        mess(gl);
        assert!(draw() == clean);
    });
}
