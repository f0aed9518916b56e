//! The `gpu` layer: framebuffers, programs, buffers, vertex arrays and the draw state.

use editor_core::gpu::{
    Attribute, Blend, Buffer, DepthTest, DrawState, Framebuffer, Gl, GpuError, IndexBuffer,
    Primitive, Program, Rect, Usage, VertexArray,
};
use glam::{Vec3, Vec4};
use glow::HasContext as _;

use crate::offscreen::support::{
    BLACK, GREEN, Picture, RED, WHITE, black, flat_program, on_each_backend, set_color,
};

/// The lower left half of the picture, at depth `z` in -1..1.
pub fn lower_left_half(gl: &Gl, z: f32) -> VertexArray {
    let corners = [
        Vec3::new(-1.0, -1.0, z),
        Vec3::new(1.0, -1.0, z),
        Vec3::new(-1.0, 1.0, z),
    ];
    let buffer = Buffer::vertices(gl, Usage::Static, &corners).expect("a buffer");
    let builder = VertexArray::builder(gl).attribute(&buffer, Attribute::f32(0, 3));
    builder.build().expect("a vertex array")
}

pub fn fill(program: &Program, shape: &VertexArray, color: Vec4) {
    set_color(program, color);
    shape.draw(program, Primitive::Triangles, 0..3);
}

pub const OPAQUE_RED: Vec4 = Vec4::new(1.0, 0.0, 0.0, 1.0);
const OPAQUE_GREEN: Vec4 = Vec4::new(0.0, 1.0, 0.0, 1.0);

#[test]
fn a_triangle_covers_its_pixels_and_no_others() {
    on_each_backend(|gl| {
        let framebuffer = black(gl, 8, 8, 0);
        fill(&flat_program(gl), &lower_left_half(gl, 0.0), OPAQUE_RED);
        let picture = Picture::of(&framebuffer);
        for y in 0..8 {
            for x in 0..8 {
                // The diagonal x = y goes through pixel centers, which belong to either side.
                if x != y {
                    let expected = if x < y { RED } else { BLACK };
                    assert_eq!(picture.at(x, y), expected, "at {x}, {y}");
                }
            }
        }
    });
}

#[test]
fn samples_give_colors_between_along_an_edge() {
    on_each_backend(|gl| {
        let framebuffer = black(gl, 8, 8, 4);
        fill(&flat_program(gl), &lower_left_half(gl, 0.0), OPAQUE_RED);
        let picture = Picture::of(&framebuffer);
        assert_eq!(picture.at(1, 6), RED);
        assert_eq!(picture.at(6, 1), BLACK);
        let between = picture.count(|[red, ..]| red > 0 && red < 255);
        assert_eq!(between, 8, "the pixels on the diagonal");
    });
}

#[test]
fn the_nearer_triangle_wins_unless_the_test_is_off() {
    on_each_backend(|gl| {
        let program = flat_program(gl);
        let (near, far) = (lower_left_half(gl, -0.5), lower_left_half(gl, 0.5));
        for (depth_test, expected) in [
            (DepthTest::Less, RED),
            (DepthTest::LessEqual, RED),
            (DepthTest::Off, GREEN),
            (DepthTest::Always, GREEN),
        ] {
            let framebuffer = black(gl, 4, 4, 0);
            DrawState {
                depth_test,
                ..DrawState::opaque(4, 4)
            }
            .apply(gl);
            fill(&program, &near, OPAQUE_RED);
            fill(&program, &far, OPAQUE_GREEN);
            assert_eq!(
                Picture::of(&framebuffer).at(0, 3),
                expected,
                "{depth_test:?}"
            );
        }
    });
}

#[test]
fn half_transparent_red_over_black_is_half_red_and_still_opaque() {
    on_each_backend(|gl| {
        for (blend, color) in [
            (Blend::Alpha, Vec4::new(1.0, 0.0, 0.0, 0.5)),
            (Blend::Premultiplied, Vec4::new(0.5, 0.0, 0.0, 0.5)),
        ] {
            let framebuffer = black(gl, 4, 4, 0);
            DrawState {
                blend,
                ..DrawState::opaque(4, 4)
            }
            .apply(gl);
            fill(&flat_program(gl), &lower_left_half(gl, 0.0), color);
            assert_eq!(
                Picture::of(&framebuffer).at(0, 3),
                [128, 0, 0, 255],
                "{blend:?}"
            );
        }
    });
}

#[test]
fn a_picture_without_pixels_or_beyond_the_limit_is_an_error() {
    on_each_backend(|gl| {
        let max = gl.info().max_framebuffer_size;
        for (width, height) in [(0, 10), (10, 0), (max + 1, 10), (10, u32::MAX)] {
            let error = Framebuffer::new(gl, width, height, 0).expect_err("an error");
            assert_eq!(
                error,
                GpuError::Size {
                    what: "picture",
                    width,
                    height,
                    max
                }
            );
        }
        let too_many = gl.info().max_samples + 1;
        let error = Framebuffer::new(gl, 10, 10, too_many).expect_err("an error");
        assert!(
            error
                .to_string()
                .contains(&format!("at most {}", gl.info().max_samples))
        );
    });
}

#[test]
fn a_picture_is_copied_into_a_part_of_another() {
    on_each_backend(|gl| {
        for samples in [0, 4] {
            let source = Framebuffer::new(gl, 2, 2, samples).expect("a framebuffer");
            source.clear([0.0, 1.0, 0.0, 1.0]);
            let target = black(gl, 6, 6, 0);
            let whole = Rect {
                x: 0,
                y: 0,
                width: 2,
                height: 2,
            };
            let part = Rect {
                x: 1,
                y: 0,
                width: 4,
                height: 3,
            };
            source.blit_into(&target, whole, part).expect("a copy");
            let picture = Picture::of(&target);
            assert_eq!(picture.count(|pixel| pixel == GREEN), 12);
            assert_eq!(
                (picture.at(1, 5), picture.at(1, 2), picture.at(0, 5)),
                (GREEN, BLACK, BLACK)
            );
            assert!(target.blit_into(&black(gl, 6, 6, 4), part, part).is_err());
        }
    });
}

#[test]
fn a_copy_of_another_size_mixes_neighbors() {
    on_each_backend(|gl| {
        let source = black(gl, 2, 1, 0);
        DrawState {
            viewport: [1, 0, 1, 1],
            ..DrawState::opaque(2, 1)
        }
        .apply(gl);
        let whole = [(-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
        let corners = Buffer::vertices(gl, Usage::Static, &whole).expect("a buffer");
        let builder = VertexArray::builder(gl).attribute(&corners, Attribute::f32(0, 3));
        let array = builder.build().expect("a vertex array");
        fill(&flat_program(gl), &array, Vec4::ONE);
        let target = black(gl, 8, 1, 0);
        let rect = |width| Rect {
            x: 0,
            y: 0,
            width,
            height: 1,
        };
        source.blit_into(&target, rect(2), rect(8)).expect("a copy");
        let picture = Picture::of(&target);
        let row: Vec<u8> = (0..8).map(|x| picture.at(x, 0)[0]).collect();
        assert_eq!((row[0], row[7]), (0, 255));
        assert!(row.is_sorted() && (40..120).contains(&row[3]), "{row:?}");
    });
}

#[test]
fn a_scissor_left_behind_cuts_neither_clearing_nor_copying_nor_reading() {
    on_each_backend(|gl| {
        for samples in [0, 4] {
            let source = Framebuffer::new(gl, 6, 6, samples).expect("a framebuffer");
            let target = black(gl, 6, 6, 0);
            let cut = || {
                DrawState {
                    color_mask: [false; 4],
                    ..DrawState::opaque(6, 6)
                }
                .apply(gl);
                // SAFETY: the context is current in here.
                gl.with_glow(|glow| unsafe {
                    glow.enable(glow::SCISSOR_TEST);
                    glow.scissor(1, 1, 2, 2);
                })
                .expect("a context");
            };
            let whole = Rect {
                x: 0,
                y: 0,
                width: 6,
                height: 6,
            };
            cut();
            source.clear([0.0, 1.0, 0.0, 1.0]);
            cut();
            assert_eq!(Picture::of(&source).count(|pixel| pixel == GREEN), 36);
            cut();
            source.blit_into(&target, whole, whole).expect("a copy");
            assert_eq!(Picture::of(&target).count(|pixel| pixel == GREEN), 36);
        }
    });
}

#[test]
fn a_shader_error_names_the_program_the_stage_and_the_line_of_the_body() {
    on_each_backend(|gl| {
        let vertex = "void main() { gl_Position = vec4(0.0); }";
        let fragment = "out vec4 color;\nvoid main() {\n    color = vec4(missing);\n}";
        match Program::new(gl, "broken", vertex, fragment) {
            Err(GpuError::Compile {
                label,
                stage,
                line,
                log,
            }) => {
                assert_eq!(
                    (label.as_str(), stage, line),
                    ("broken", "fragment", Some(3))
                );
                assert!(log.contains("missing"), "{log}");
            }
            other => panic!("expected a compile error, got {other:?}"),
        }
        // The compiler's complaint is also a message of the driver's; it is told above already.
        let _ = gl.check("a shader that must not compile");
    });
}

#[test]
fn a_name_that_no_shader_declares_is_told_once_and_an_unused_one_is_not() {
    on_each_backend(|gl| {
        let vertex = "uniform vec3 unused;\nvoid main() { gl_Position = vec4(0.0); }";
        let fragment = "uniform float red;\nout vec4 color;\nvoid main() { color = vec4(red); }";
        let program = Program::new(gl, "names", vertex, fragment).expect("a program");
        program.set_vec3("unused", Vec3::ONE);
        program.set_f32("red", 1.0);
        gl.check("known names").expect("no fault");
        program.set_f32("rde", 1.0);
        program.set_f32("rde", 1.0);
        program.set_vec3("red", Vec3::ONE);
        let faults = gl.check("unknown names").expect_err("faults").to_string();
        assert!(faults.contains("rde is declared nowhere"), "{faults}");
        assert!(faults.contains("red has another type"), "{faults}");
        assert_eq!(faults.matches("rde").count(), 1, "{faults}");
        gl.check("afterwards").expect("each fault is told once");
    });
}

#[test]
fn a_draw_beyond_the_end_of_a_buffer_draws_nothing_and_is_told() {
    on_each_backend(|gl| {
        let framebuffer = black(gl, 4, 4, 0);
        let (program, shape) = (flat_program(gl), lower_left_half(gl, 0.0));
        set_color(&program, OPAQUE_RED);
        shape.draw(&program, Primitive::Triangles, 0..6);
        assert!(gl.check("a draw of six vertices of three").is_err());

        let corners = [Vec3::ZERO; 3];
        let buffer = Buffer::vertices(gl, Usage::Static, &corners).expect("a buffer");
        let indices = IndexBuffer::new(gl, Usage::Static, &[0, 1, 3]).expect("indices");
        let builder = VertexArray::builder(gl).attribute(&buffer, Attribute::f32(0, 3));
        let array = builder.indices(&indices).build().expect("a vertex array");
        array.draw_indexed(&program, Primitive::Triangles, 0..3);
        assert!(gl.check("index 3 of three vertices").is_err());
        assert_eq!(Picture::of(&framebuffer).count(|pixel| pixel != BLACK), 0);
    });
}

#[test]
fn an_attribute_that_does_not_fit_its_element_is_an_error() {
    on_each_backend(|gl| {
        let buffer = Buffer::vertices(gl, Usage::Static, &[Vec3::ZERO]).expect("a buffer");
        for attribute in [
            Attribute::f32(0, 4),
            Attribute::f32(0, 3).offset(4),
            Attribute::f32(0, 0),
            Attribute::u32(0, 5),
            Attribute::f32(1000, 3),
            Attribute::f32(0, 3).offset(usize::MAX),
        ] {
            let builder = VertexArray::builder(gl).attribute(&buffer, attribute);
            assert!(builder.build().is_err(), "{attribute:?}");
        }
    });
}

#[test]
fn instances_read_their_own_attributes_integers_included() {
    on_each_backend(|gl| {
        let vertex = "layout(location = 0) in vec2 corner;\n\
             layout(location = 1) in uint column;\n\
             layout(location = 2) in uvec4 color;\n\
             out vec4 instance_color;\n\
             void main() {\n\
                 instance_color = vec4(color) / 255.0;\n\
                 float x = (corner.x + float(column)) * 0.5 - 1.0;\n\
                 gl_Position = vec4(x, corner.y * 2.0 - 1.0, 0.0, 1.0);\n\
             }";
        let fragment = "in vec4 instance_color;\nout vec4 fragment_color;\n\
             void main() { fragment_color = instance_color; }";
        let program = Program::new(gl, "columns", vertex, fragment).expect("a program");
        let corners = [[0.0_f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let corners = Buffer::vertices(gl, Usage::Static, &corners).expect("corners");
        let instances = [(3_u32, RED), (0, GREEN)]
            .map(|(column, [r, g, b, a])| [column, r.into(), g.into(), b.into(), a.into()]);
        let instances = Buffer::vertices(gl, Usage::Stream, &instances).expect("instances");
        let indices = IndexBuffer::new(gl, Usage::Static, &[0, 1, 2, 0, 2, 3]).expect("indices");
        let array = VertexArray::builder(gl)
            .attribute(&corners, Attribute::f32(0, 2))
            .attribute(&instances, Attribute::u32(1, 1).divisor(1))
            .attribute(&instances, Attribute::u32(2, 4).offset(4).divisor(1))
            .indices(&indices)
            .build()
            .expect("a vertex array");
        // The vertex array keeps what it reads.
        drop((corners, indices));
        let framebuffer = black(gl, 4, 1, 0);
        array.draw_indexed_instanced(&program, Primitive::Triangles, 0..6, 2);
        let picture = Picture::of(&framebuffer);
        let columns = [0, 1, 2, 3].map(|x| picture.at(x, 0));
        assert_eq!(columns, [GREEN, BLACK, BLACK, RED]);
        array.draw_indexed_instanced(&program, Primitive::Triangles, 0..6, 3);
        assert!(gl.check("three instances of two").is_err());
    });
}

#[test]
fn a_buffer_takes_more_and_fewer_elements_than_before() {
    on_each_backend(|gl| {
        let program = flat_program(gl);
        set_color(&program, Vec4::ONE);
        let buffer = Buffer::<Vec3>::vertices(gl, Usage::Stream, &[]).expect("an empty buffer");
        let builder = VertexArray::builder(gl).attribute(&buffer, Attribute::f32(0, 3));
        let array = builder.build().expect("a vertex array");
        for count in [0, 3, 8, 2] {
            let pixel = |x: u32| Vec3::new((x as f32 + 0.5) / 4.0 - 1.0, 0.0, 0.0);
            let points: Vec<Vec3> = (0..count).map(pixel).collect();
            buffer.update(&points).expect("an update");
            assert_eq!(array.vertex_count(), count);
            let framebuffer = black(gl, 8, 1, 0);
            array.draw(&program, Primitive::Points, 0..array.vertex_count());
            let white = Picture::of(&framebuffer).count(|pixel| pixel == WHITE);
            assert_eq!(white, count as usize);
        }
    });
}
