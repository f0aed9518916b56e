//! Contexts for tests, and ways to look at pictures.

use editor_core::gpu::{Api, Backend, DrawState, Framebuffer, Gl, HeadlessContext, Program};
use editor_core::render::{Backdrop, Frame, Marks, Renderer};
use editor_core::scene::{Evaluator, Scene, ViewSettings};
use glam::Vec4;

/// Runs `body` on EGL, on EGL's OpenGL ES, and on OSMesa. A missing backend fails the test, and so
/// does any OpenGL error that `body` leaves.
pub fn on_each_backend(body: impl Fn(&Gl)) {
    for (backend, api) in [
        (Backend::Egl, Api::Gl),
        (Backend::Egl, Api::Gles),
        (Backend::Osmesa, Api::Gl),
    ] {
        let context = match HeadlessContext::with_api(backend, api) {
            Ok(context) => context,
            Err(error) => panic!("{backend:?} {api:?}: {error}"),
        };
        eprintln!("{backend:?} {api:?}: {}", context.gl().info().version);
        body(context.gl());
        if let Err(error) = context.gl().check("the test") {
            panic!("{backend:?} {api:?}: {error}");
        }
    }
}

/// A picture, the top row first.
#[derive(PartialEq)]
pub struct Picture {
    pub width: usize,
    pub rgba: Vec<u8>,
}

impl Picture {
    pub fn of(framebuffer: &Framebuffer) -> Self {
        let rgba = framebuffer.read_rgba().expect("a readable picture");
        Self {
            width: framebuffer.width() as usize,
            rgba,
        }
    }

    /// Column from the left, row from the top.
    pub fn at(&self, x: usize, y: usize) -> [u8; 4] {
        let start = (y * self.width + x) * 4;
        self.rgba[start..start + 4].try_into().expect("four bytes")
    }

    pub fn count(&self, wanted: impl Fn([u8; 4]) -> bool) -> usize {
        let pixels = self.rgba.chunks_exact(4);
        pixels
            .filter(|pixel| wanted([pixel[0], pixel[1], pixel[2], pixel[3]]))
            .count()
    }
}

pub const BLACK: [u8; 4] = [0, 0, 0, 255];
pub const RED: [u8; 4] = [255, 0, 0, 255];
pub const GREEN: [u8; 4] = [0, 255, 0, 255];
pub const WHITE: [u8; 4] = [255; 4];

/// A black picture, bound, with the opaque state applied.
pub fn black(gl: &Gl, width: u32, height: u32, samples: u32) -> Framebuffer {
    let framebuffer = Framebuffer::new(gl, width, height, samples).expect("a framebuffer");
    framebuffer.clear([0.0, 0.0, 0.0, 1.0]);
    DrawState::opaque(width, height).apply(gl);
    framebuffer
}

/// Positions in clip space as they are, one color for all.
pub fn flat_program(gl: &Gl) -> Program {
    let vertex = "layout(location = 0) in vec3 position;\n\
         void main() { gl_Position = vec4(position, 1.0); gl_PointSize = 1.0; }";
    let fragment = "uniform vec3 color;\nuniform float alpha;\nout vec4 fragment_color;\n\
         void main() { fragment_color = vec4(color, alpha); }";
    Program::new(gl, "flat", vertex, fragment).expect("the flat shader")
}

/// A scene as `renderer` draws it, in pixels.
pub fn draw_scene(
    renderer: &mut Renderer,
    gl: &Gl,
    size: (u32, u32),
    scene: &Scene,
    view: &ViewSettings,
    marks: Marks,
) -> Picture {
    draw_frame(
        renderer,
        gl,
        size,
        (scene, view, Backdrop::default()),
        marks,
    )
}

/// The same without marks, before a backdrop.
pub fn draw_before(
    renderer: &mut Renderer,
    gl: &Gl,
    size: (u32, u32),
    shown: (&Scene, &ViewSettings, Backdrop),
) -> Picture {
    draw_frame(renderer, gl, size, shown, Marks::default())
}

fn draw_frame(
    renderer: &mut Renderer,
    gl: &Gl,
    (width, height): (u32, u32),
    (scene, view, backdrop): (&Scene, &ViewSettings, Backdrop),
    marks: Marks,
) -> Picture {
    let evaluated = Evaluator::new().evaluate(scene, 0.0);
    let frame = Frame {
        scene,
        evaluated: &evaluated,
        view,
        backdrop,
        marks,
    };
    let target = Framebuffer::new(gl, width, height, 0).expect("a picture");
    renderer.draw(&frame, &target).expect("a drawn frame");
    Picture::of(&target)
}

/// The color of [`flat_program`].
pub fn set_color(program: &Program, color: Vec4) {
    program.set_vec3("color", color.truncate());
    program.set_f32("alpha", color.w);
}
