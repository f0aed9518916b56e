//! Textures: pictures, and tables of numbers.

use editor_core::gpu::{
    Attribute, Buffer, Filter, FloatTexture, Gl, GpuError, Primitive, Program, Sampling, Texture,
    Usage, VertexArray, Wrap,
};
use glam::Vec2;

use crate::offscreen::support::{BLACK, GREEN, Picture, RED, WHITE, black, on_each_backend};

/// A picture of 4 x 1 pixels, whose pixel x is what `expression` says at u = (x + 0.5) / 4.
fn four_pixels(gl: &Gl, expression: &str) -> Picture {
    let vertex = "layout(location = 0) in vec2 position;\nout vec2 uv;\n\
         void main() { uv = position * 0.5 + 0.5; gl_Position = vec4(position, 0.0, 1.0); }";
    let fragment = format!(
        "in vec2 uv;\nuniform sampler2D image;\nout vec4 color;\n\
         void main() {{ color = {expression}; }}"
    );
    let program = Program::new(gl, "textured", vertex, &fragment).expect("a program");
    program.set_sampler("image", 2);
    let corners = [
        Vec2::new(-1.0, -1.0),
        Vec2::new(3.0, -1.0),
        Vec2::new(-1.0, 3.0),
    ];
    let buffer = Buffer::vertices(gl, Usage::Static, &corners).expect("a buffer");
    let builder = VertexArray::builder(gl).attribute(&buffer, Attribute::f32(0, 2));
    let framebuffer = black(gl, 4, 1, 0);
    builder
        .build()
        .expect("a vertex array")
        .draw(&program, Primitive::Triangles, 0..3);
    Picture::of(&framebuffer)
}

fn row(picture: &Picture) -> [[u8; 4]; 4] {
    [0, 1, 2, 3].map(|x| picture.at(x, 0))
}

#[test]
fn a_texture_shows_its_pixels_and_repeats_if_asked() {
    on_each_backend(|gl| {
        let pixels = [RED, GREEN].concat();
        for (wrap, beyond) in [(Wrap::Clamp, GREEN), (Wrap::Repeat, RED)] {
            let sampling = Sampling {
                filter: Filter::Nearest,
                wrap,
                mipmaps: false,
            };
            let texture = Texture::new(gl, 2, 1, &pixels, sampling).expect("a texture");
            texture.bind(2);
            let picture = four_pixels(gl, "texture(image, vec2(uv.x * 2.0, 0.5))");
            assert_eq!(row(&picture)[..3], [RED, GREEN, beyond], "{wrap:?}");
            let upright = Texture::new(gl, 1, 2, &pixels, sampling).expect("a texture");
            upright.bind(2);
            let picture = four_pixels(gl, "texture(image, vec2(0.5, uv.x * 2.0))");
            assert_eq!(row(&picture)[..3], [RED, GREEN, beyond], "{wrap:?} upwards");
        }
    });
}

#[test]
fn a_linear_texture_mixes_neighbors_and_mipmaps_mix_everything() {
    on_each_backend(|gl| {
        let pixels = [BLACK, WHITE, BLACK, WHITE].concat();
        let sampling = Sampling {
            mipmaps: true,
            ..Sampling::default()
        };
        let texture = Texture::new(gl, 4, 1, &pixels, sampling).expect("a texture");
        texture.bind(2);
        let [gray, ..] = four_pixels(gl, "textureLod(image, vec2(0.25, 0.5), 0.0)").at(0, 0);
        assert!(
            (126..=129).contains(&gray),
            "between black and white: {gray}"
        );
        let [gray, ..] = four_pixels(gl, "textureLod(image, vec2(0.1, 0.5), 2.0)").at(0, 0);
        assert!((126..=129).contains(&gray), "the smallest version: {gray}");
    });
}

#[test]
fn a_table_gives_back_the_numbers_exactly_and_takes_a_new_size() {
    on_each_backend(|gl| {
        let odd = 16_777_215.0;
        let texture = FloatTexture::new(gl, 1, 2, &[[0.0; 4], [odd, -1e30, 1e-30, 0.1]]);
        let texture = texture.expect("a table");
        texture.bind(2);
        let expression = "vec4(texelFetch(image, ivec2(0, 1), 0) \
             == vec4(16777215.0, -1e30, 1e-30, 0.1))";
        assert_eq!(four_pixels(gl, expression).at(0, 0), WHITE);
        let cells = [0.0, 1.0, 0.0, 1.0].map(|green| [1.0 - green, green, 0.0, 1.0]);
        texture.update(4, 1, &cells).expect("an update");
        texture.bind(2);
        let picture = four_pixels(gl, "texelFetch(image, ivec2(int(uv.x * 4.0), 0), 0)");
        assert_eq!(row(&picture), [RED, GREEN, RED, GREEN]);
    });
}

#[test]
fn a_picture_can_be_read_by_a_shader_with_its_samples_averaged() {
    on_each_backend(|gl| {
        for samples in [0, 4] {
            let source = black(gl, 2, 2, samples);
            source.clear([0.0, 1.0, 0.0, 1.0]);
            source.bind_texture(2);
            let picture = four_pixels(gl, "texelFetch(image, ivec2(1, 1), 0)");
            assert_eq!(row(&picture), [GREEN; 4], "{samples} samples");
        }
    });
}

#[test]
fn a_texture_of_a_wrong_size_is_an_error() {
    on_each_backend(|gl| {
        let max = gl.info().max_texture_size;
        let size = |width, height| GpuError::Size {
            what: "texture",
            width,
            height,
            max,
        };
        let sampling = Sampling::default();
        assert_eq!(
            Texture::new(gl, 0, 1, &[], sampling).expect_err("an error"),
            size(0, 1)
        );
        let error = FloatTexture::new(gl, max + 1, 1, &[]).expect_err("an error");
        assert_eq!(error, size(max + 1, 1));
        assert!(Texture::new(gl, 2, 2, &[0; 15], sampling).is_err());
        assert!(FloatTexture::new(gl, 2, 2, &[[0.0; 4]; 5]).is_err());
    });
}
