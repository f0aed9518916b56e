//! Tests of what happens when a context, its memory or the window system fail.

use super::interface_painter::InterfacePainter;
use super::test_driver::TestDriver;
use super::{
    Attribute, Backend, Buffer, DrawState, Framebuffer, Gl, GpuError, HeadlessContext, Immediate,
    Mode, Primitive, Program, Usage, VertexArray,
};
use glam::Vec3;

const VERTEX: &str = "layout(location = 0) in vec3 position;\n\
     void main() { gl_Position = vec4(position, 1.0); gl_PointSize = 1.0; }";
const FRAGMENT: &str = "uniform float red;\nout vec4 color;\n\
     void main() { color = vec4(red, 0.0, 0.0, 1.0); }";

/// A triangle over the whole picture.
const CORNERS: [Vec3; 3] = [
    Vec3::new(-1.0, -1.0, 0.0),
    Vec3::new(3.0, -1.0, 0.0),
    Vec3::new(-1.0, 3.0, 0.0),
];

fn red_program(gl: &Gl) -> Program {
    Program::new(gl, "red", VERTEX, FRAGMENT).unwrap()
}

fn triangle(gl: &Gl) -> (Buffer<Vec3>, VertexArray) {
    let buffer = Buffer::vertices(gl, Usage::Static, &CORNERS).unwrap();
    let builder = VertexArray::builder(gl).attribute(&buffer, Attribute::f32(0, 3));
    let array = builder.build().unwrap();
    (buffer, array)
}

#[test]
fn a_driver_of_exactly_opengl_3_3_has_all_that_pictures_need() {
    // Functions that OpenGL 3.3 does not promise and OpenGL ES has.
    let newer = [
        c"glClearDepthf",
        c"glDepthRangef",
        c"glGetShaderPrecisionFormat",
        c"glInvalidateFramebuffer",
        c"glTexStorage2D",
        c"glTexStorage2DMultisample",
    ];
    let driver = TestDriver::without(&newer);
    let gl = driver.gl();
    for samples in [0, 4] {
        let picture = Framebuffer::new(gl, 4, 4, samples).unwrap();
        picture.clear([1.0; 4]);
        DrawState::opaque(4, 4).apply(gl);
        assert!(picture.read_rgba().unwrap().iter().all(|&c| c == 255));
    }
}

#[test]
fn no_call_comes_too_late_in_whatever_order_owners_are_dropped() {
    type Owner = Box<dyn std::any::Any>;
    let owners = |driver: TestDriver| -> Vec<Owner> {
        let gl = driver.gl().clone();
        vec![
            Box::new(InterfacePainter::new(&gl).unwrap()),
            Box::new(Immediate::new(&gl).unwrap()),
            Box::new(Framebuffer::new(&gl, 4, 4, 4).unwrap()),
            Box::new(triangle(&gl)),
            Box::new(driver),
        ]
    };
    for last in 0..5 {
        let mut owners = owners(TestDriver::new());
        TestDriver::calls();
        // The last one standing takes the context with it.
        let kept = owners.remove(last);
        drop(owners);
        drop(kept);
        assert!(TestDriver::calls() > 10);
        assert_eq!(TestDriver::stray_calls(), [""; 0], "{last} last");
    }
}

#[test]
fn nothing_is_called_while_the_context_cannot_be_made_current() {
    let driver = TestDriver::new();
    let gl = driver.gl();
    let (program, (buffer, array)) = (red_program(gl), triangle(gl));
    let (plain, sampled) = [0, 4]
        .map(|n| Framebuffer::new(gl, 4, 4, n).unwrap())
        .into();
    let mut immediate = Immediate::new(gl).unwrap();
    let mut painter = InterfacePainter::new(gl).unwrap();
    // Until another context was current, nothing has to be made current.
    let other = HeadlessContext::new(Backend::Auto).unwrap();
    TestDriver::refuse_current(true);
    TestDriver::calls();

    plain.clear([1.0; 4]);
    DrawState::opaque(4, 4).apply(gl);
    program.set_f32("red", 1.0);
    array.draw(&program, Primitive::Triangles, 0..3);
    immediate.begin(Mode::Points);
    immediate.vertex(Vec3::ZERO);
    immediate.end();
    sampled.resolve();
    gl.bind_window();
    painter.skip(egui::FullOutput::default());
    let is_lost = |error| matches!(error, GpuError::Lost { .. });
    assert!(is_lost(buffer.update(&[Vec3::ZERO]).unwrap_err()));
    assert!(is_lost(plain.read_rgba().unwrap_err()));
    assert!(is_lost(Framebuffer::new(gl, 4, 4, 0).unwrap_err()));
    assert!(is_lost(
        Program::new(gl, "red", VERTEX, FRAGMENT).unwrap_err()
    ));
    assert!(is_lost(Immediate::new(gl).unwrap_err()));
    assert!(InterfacePainter::new(gl).is_err());
    assert!(gl.with_glow(|_| ()).is_err_and(is_lost));
    let message = gl.check("the test").unwrap_err();
    assert_eq!(
        message.to_string(),
        "the graphics context was lost in the test (the display is gone): restart the program"
    );
    drop((
        program, buffer, array, plain, sampled, immediate, painter, driver,
    ));
    assert_eq!(TestDriver::calls(), 0);
    assert_eq!(TestDriver::stray_calls(), [""; 0]);
    other.gl().check("the other context").unwrap();
}

#[test]
fn calls_that_were_left_out_are_reported_once_the_context_is_back() {
    let driver = TestDriver::new();
    let picture = Framebuffer::new(driver.gl(), 2, 2, 0).unwrap();
    picture.clear([1.0; 4]);
    let _other = HeadlessContext::new(Backend::Auto).unwrap();
    TestDriver::refuse_current(true);
    picture.clear([0.0; 4]);
    TestDriver::refuse_current(false);
    let message = driver.gl().check("clearing").unwrap_err().to_string();
    assert!(message.contains("the display is gone"), "{message}");
    assert_eq!(picture.read_rgba().unwrap(), [255; 16]);
}

#[test]
fn a_reset_driver_is_a_lost_context_from_then_on() {
    let driver = TestDriver::new();
    let gl = driver.gl();
    gl.check("before").unwrap();
    TestDriver::reset_driver();
    for _ in 0..2 {
        let error = gl.check("drawing").unwrap_err();
        assert!(matches!(&error, GpuError::Lost { what, .. } if what == "drawing"));
    }
    let (buffer, ..) = {
        let driver = TestDriver::new();
        triangle(driver.gl())
    };
    TestDriver::reset_driver();
    let error = buffer.update(&[Vec3::ZERO]).unwrap_err();
    assert!(matches!(error, GpuError::Lost { .. }), "{error}");
}

#[test]
fn a_buffer_that_finds_no_memory_is_empty_and_nothing_is_drawn_from_it() {
    let driver = TestDriver::new();
    let gl = driver.gl();
    let picture = Framebuffer::new(gl, 4, 4, 0).unwrap();
    picture.clear([0.0, 0.0, 0.0, 1.0]);
    DrawState::opaque(4, 4).apply(gl);
    let (program, (buffer, array)) = (red_program(gl), triangle(gl));
    program.set_f32("red", 1.0);
    assert_eq!(array.vertex_count(), 3);
    TestDriver::limit_buffers(64);
    let error = buffer.update(&[Vec3::ZERO; 6]).unwrap_err().to_string();
    assert!(
        error.contains("buffer") && error.contains("out of graphics memory"),
        "{error}"
    );
    assert_eq!((buffer.len(), array.vertex_count()), (0, 0));
    gl.check("the failure was returned already").unwrap();

    TestDriver::calls();
    array.draw(&program, Primitive::Triangles, 0..3);
    assert_eq!(TestDriver::calls(), 0);
    assert!(gl.check("a draw of three vertices of none").is_err());

    // Memory of the size that it had before must be reserved anew.
    TestDriver::limit_buffers(usize::MAX);
    buffer.update(&CORNERS).unwrap();
    assert_eq!(array.vertex_count(), 3);
    array.draw(&program, Primitive::Triangles, 0..3);
    assert_eq!(picture.read_rgba().unwrap()[..4], [255, 0, 0, 255]);
}

#[test]
fn errors_of_earlier_calls_are_not_the_buffer_s() {
    let driver = TestDriver::new();
    let gl = driver.gl();
    DrawState::opaque(4, 4).apply(gl);
    // SAFETY: the context is current; the driver reports the unknown constant.
    gl.with_glow(|glow| unsafe { glow::HasContext::enable(glow, 1) })
        .unwrap();
    let buffer = Buffer::vertices(gl, Usage::Static, &[0_u8; 9]).unwrap();
    assert_eq!(buffer.len(), 9);
    // The flag itself, beside what the driver may say about it.
    let GpuError::Faults { faults, .. } = gl.check("an unknown constant").unwrap_err() else {
        panic!("another kind of error");
    };
    assert!(
        faults.iter().any(|fault| fault == "GL_INVALID_ENUM"),
        "{faults:?}"
    );
}
