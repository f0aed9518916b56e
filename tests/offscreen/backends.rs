//! The same drawing gives the same picture, byte for byte, wherever it is drawn on the processor.

use editor_core::gpu::{
    Api, Backend, Blend, DrawState, Framebuffer, Gl, HeadlessContext, Immediate, Mode, PointShape,
};
use glam::{Mat4, Vec3, Vec4};

use crate::offscreen::support::Picture;

/// Lines thin and wide, points of every shape, and blended triangles, seen at an angle.
fn medley(gl: &Gl, samples: u32) -> Picture {
    let framebuffer = Framebuffer::new(gl, 160, 120, samples).expect("a framebuffer");
    framebuffer.clear([0.2, 0.4, 0.6, 1.0]);
    DrawState {
        blend: Blend::Alpha,
        ..DrawState::opaque(160, 120)
    }
    .apply(gl);
    let mut immediate = Immediate::new(gl).expect("the compatibility layer");
    let clip_from_eye = glam::camera::rh::proj::opengl::perspective(0.9, 4.0 / 3.0, 0.1, 100.0);
    let turn = Mat4::from_rotation_y(0.5) * Mat4::from_rotation_x(0.4);
    let eye_from_world = Mat4::from_translation(Vec3::new(0.0, 0.0, -4.0)) * turn;
    immediate.load_matrix(clip_from_eye * eye_from_world);
    let modes = [
        Mode::TriangleFan,
        Mode::LineStrip,
        Mode::LineLoop,
        Mode::Points,
        Mode::Points,
    ];
    for (index, mode) in modes.into_iter().enumerate() {
        let layer = index as f32 * 0.3 - 0.6;
        immediate.line_width(if index == 2 { 3.5 } else { 1.0 });
        immediate.point_size(5.0 + index as f32);
        immediate.point_shape(if index == 3 {
            PointShape::Disc
        } else {
            PointShape::SmoothDisc
        });
        immediate.begin(mode);
        for step in 0..24 {
            let (sin, cos) = (step as f32 * 0.27).sin_cos();
            immediate.color_alpha(Vec4::new(sin.abs(), cos.abs(), 0.5, 0.7));
            immediate.vertex(Vec3::new(cos * (1.0 + layer), sin, layer));
        }
        immediate.end();
    }
    Picture::of(&framebuffer)
}

#[test]
fn egl_and_osmesa_draw_the_same_bytes() {
    let context = |backend| HeadlessContext::with_api(backend, Api::Gl).expect("a context");
    let (egl, osmesa) = (context(Backend::Egl), context(Backend::Osmesa));
    assert!(osmesa.gl().info().is_software);
    if !egl.gl().info().is_software {
        eprintln!("left out: EGL draws on {}", egl.gl().info().renderer);
        return;
    }
    for samples in [4, 0] {
        let first = medley(egl.gl(), samples);
        let background = first.count(|pixel| pixel == [51, 102, 153, 255]);
        assert!(
            (1000..18_000).contains(&background),
            "{background} pixels are background"
        );
        assert!(
            first == medley(osmesa.gl(), samples),
            "{samples} samples: OSMesa differs"
        );
        assert!(
            first == medley(egl.gl(), samples),
            "{samples} samples: a repetition differs"
        );
    }
}

#[test]
fn the_driver_is_described() {
    for backend in [Backend::Auto, Backend::Egl, Backend::Osmesa] {
        let context = HeadlessContext::new(backend).expect("a context");
        let info = context.gl().info();
        assert!(!info.version.is_empty() && !info.renderer.is_empty() && !info.glsl.is_empty());
        assert!(info.max_texture_size >= 1024 && info.max_framebuffer_size >= 1024);
        assert!(info.max_samples >= 4);
        assert!(
            info.max_point_size >= 8.0,
            "points of {} pixels",
            info.max_point_size
        );
        assert!(!info.is_gles);
        assert_ne!(context.backend(), Backend::Auto);
    }
}
