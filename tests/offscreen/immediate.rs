//! The compatibility layer: `begin … vertex … end`.

use editor_core::gpu::{Blend, DrawState, Framebuffer, Gl, Immediate, Mode, PointShape};
use glam::{Mat4, Vec3, Vec4};

use crate::offscreen::support::{BLACK, GREEN, Picture, RED, WHITE, black, on_each_backend};

/// From pixels, counted from the bottom left, to clip space.
fn clip_from_pixels(width: u32, height: u32) -> Mat4 {
    let scale = Vec3::new(2.0 / width as f32, 2.0 / height as f32, 1.0);
    Mat4::from_translation(Vec3::new(-1.0, -1.0, 0.0)) * Mat4::from_scale(scale)
}

/// A black picture and a layer that takes pixels.
fn on_pixels(gl: &Gl, width: u32, height: u32) -> (Framebuffer, Immediate) {
    let mut immediate = Immediate::new(gl).expect("the compatibility layer");
    immediate.load_matrix(clip_from_pixels(width, height));
    (black(gl, width, height, 0), immediate)
}

fn draw(immediate: &mut Immediate, mode: Mode, vertices: &[[f32; 2]]) {
    immediate.begin(mode);
    for [x, y] in vertices {
        immediate.vertex(Vec3::new(*x, *y, 0.0));
    }
    immediate.end();
}

#[test]
fn a_round_point_has_the_area_of_its_disc_and_free_corners() {
    on_each_backend(|gl| {
        for size in [5.0_f32, 8.0, 20.0] {
            let (framebuffer, mut immediate) = on_pixels(gl, 32, 32);
            immediate.point_size(size);
            immediate.point_shape(PointShape::Disc);
            let center = if size == 5.0 { 16.5 } else { 16.0 };
            draw(&mut immediate, Mode::Points, &[[center, center]]);
            let picture = Picture::of(&framebuffer);
            let area = picture.count(|pixel| pixel == WHITE) as f32;
            let disc = std::f32::consts::PI * size * size / 4.0;
            assert!(
                (area - disc).abs() < 0.1 * disc,
                "size {size}: {area} pixels, disc {disc}"
            );
            assert_eq!(picture.count(|pixel| pixel != WHITE && pixel != BLACK), 0);
            let (left, top) = (center - size / 2.0, 32.0 - center - size / 2.0);
            let corner = picture.at(left as usize, top as usize);
            assert_eq!(corner, BLACK, "size {size}: its corner");
        }
    });
}

#[test]
fn a_smooth_point_covers_as_much_light_as_its_disc() {
    on_each_backend(|gl| {
        for (size, center) in [(8.0_f32, 16.0), (8.0, 16.3), (5.0, 16.5), (13.0, 15.8)] {
            let (framebuffer, mut immediate) = on_pixels(gl, 32, 32);
            DrawState {
                blend: Blend::Alpha,
                ..DrawState::opaque(32, 32)
            }
            .apply(gl);
            immediate.point_size(size);
            immediate.point_shape(PointShape::SmoothDisc);
            draw(&mut immediate, Mode::Points, &[[center, center]]);
            let picture = Picture::of(&framebuffer);
            let light: f32 = picture
                .rgba
                .chunks_exact(4)
                .map(|p| f32::from(p[0]) / 255.0)
                .sum();
            let disc = std::f32::consts::PI * size * size / 4.0;
            assert!(
                (light - disc).abs() < 0.03 * disc,
                "size {size}: light {light}, disc {disc}"
            );
            assert!(
                picture.count(|[red, ..]| red > 0 && red < 255) > 4,
                "edges fade"
            );
            assert_eq!(
                picture.count(|[.., alpha]| alpha != 255),
                0,
                "the picture stays opaque"
            );
        }
    });
}

#[test]
fn a_square_point_fills_its_square() {
    on_each_backend(|gl| {
        let (framebuffer, mut immediate) = on_pixels(gl, 16, 16);
        immediate.point_size(6.0);
        immediate.color(Vec3::X);
        draw(&mut immediate, Mode::Points, &[[8.0, 8.0]]);
        let picture = Picture::of(&framebuffer);
        assert_eq!(picture.count(|pixel| pixel == RED), 36);
        assert_eq!(
            (picture.at(5, 5), picture.at(10, 10), picture.at(4, 5)),
            (RED, RED, BLACK)
        );
    });
}

#[test]
fn a_line_of_width_five_covers_five_pixels_across() {
    on_each_backend(|gl| {
        let (framebuffer, mut immediate) = on_pixels(gl, 32, 32);
        immediate.line_width(5.0);
        draw(&mut immediate, Mode::Lines, &[[4.0, 16.5], [28.0, 16.5]]);
        let picture = Picture::of(&framebuffer);
        assert_eq!(picture.count(|pixel| pixel == WHITE), 24 * 5);
        let rows: Vec<usize> = (0..32).filter(|&y| picture.at(16, y) == WHITE).collect();
        assert_eq!(rows, [13, 14, 15, 16, 17]);

        let (framebuffer, mut immediate) = on_pixels(gl, 32, 64);
        immediate.line_width(5.0);
        draw(&mut immediate, Mode::Lines, &[[16.5, 4.0], [16.5, 60.0]]);
        assert_eq!(
            Picture::of(&framebuffer).count(|pixel| pixel == WHITE),
            56 * 5
        );

        let (framebuffer, mut immediate) = on_pixels(gl, 64, 32);
        immediate.line_width(4.0);
        draw(&mut immediate, Mode::Lines, &[[10.0, 6.0], [34.0, 24.0]]);
        let area = Picture::of(&framebuffer).count(|pixel| pixel == WHITE);
        assert!(
            (116..=124).contains(&area),
            "a slanted line of length 30: {area} pixels"
        );
    });
}

#[test]
fn a_wide_line_ends_at_the_near_plane_and_keeps_its_width() {
    on_each_backend(|gl| {
        let (framebuffer, mut immediate) = on_pixels(gl, 64, 64);
        let clip_from_eye = glam::camera::rh::proj::opengl::perspective(1.0, 1.0, 0.1, 100.0);
        immediate.load_matrix(clip_from_eye);
        immediate.line_width(3.0);
        immediate.begin(Mode::Lines);
        // From ahead, slightly below the eye, to far behind it.
        immediate.vertex(Vec3::new(0.0, -0.5, -50.0));
        immediate.vertex(Vec3::new(0.0, -0.5, 50.0));
        immediate.end();
        let picture = Picture::of(&framebuffer);
        for y in 0..64 {
            let across = (0..64).filter(|&x| picture.at(x, y) == WHITE).count();
            let expected = if y >= 33 { 3..=4 } else { 0..=0 };
            assert!(expected.contains(&across), "row {y}: {across} pixels");
        }
    });
}

#[test]
fn a_line_of_width_one_is_opengls_own() {
    on_each_backend(|gl| {
        let (framebuffer, mut immediate) = on_pixels(gl, 32, 32);
        draw(&mut immediate, Mode::Lines, &[[2.5, 3.5], [29.5, 20.5]]);
        let picture = Picture::of(&framebuffer);
        // The diamond rule: one pixel a column, the last left out.
        assert_eq!(picture.count(|pixel| pixel == WHITE), 27);
        for x in 2..29 {
            assert_eq!(
                (0..32).filter(|&y| picture.at(x, y) == WHITE).count(),
                1,
                "column {x}"
            );
        }
        assert_eq!(picture.at(29, 31 - 20), BLACK);
    });
}

#[test]
fn strips_loops_and_fans_join_their_vertices() {
    let square = [[4.5, 4.5], [27.5, 4.5], [27.5, 27.5], [4.5, 27.5]];
    on_each_backend(|gl| {
        for width in [1.0, 3.0] {
            for (mode, sides) in [
                (Mode::Lines, [true, false, true, false]),
                (Mode::LineStrip, [true, true, true, false]),
                (Mode::LineLoop, [true; 4]),
            ] {
                let (framebuffer, mut immediate) = on_pixels(gl, 32, 32);
                immediate.line_width(width);
                draw(&mut immediate, mode, &square);
                let picture = Picture::of(&framebuffer);
                // The middles of the sides, in the order drawn; rows count from the top.
                let middles = [(16, 27), (27, 16), (16, 4), (4, 16)];
                let seen = middles.map(|(x, y)| picture.at(x, y) == WHITE);
                assert_eq!(seen, sides, "{mode:?}, width {width}");
            }
        }
        let square = [[4.0, 4.0], [28.0, 4.0], [28.0, 28.0], [4.0, 28.0]];
        let zigzag = [square[0], square[1], square[3], square[2]];
        for (mode, vertices, area) in [
            (Mode::Quads, square, 24 * 24),
            (Mode::TriangleFan, square, 24 * 24),
            (Mode::TriangleStrip, zigzag, 24 * 24),
        ] {
            let (framebuffer, mut immediate) = on_pixels(gl, 32, 32);
            draw(&mut immediate, mode, &vertices);
            let white = Picture::of(&framebuffer).count(|pixel| pixel == WHITE);
            assert_eq!(white, area, "{mode:?}");
        }
        let (framebuffer, mut immediate) = on_pixels(gl, 32, 32);
        draw(&mut immediate, Mode::Triangles, &square);
        let white = Picture::of(&framebuffer).count(|pixel| pixel == WHITE);
        assert!(
            (24 * 23 / 2..=24 * 25 / 2).contains(&white),
            "the fourth vertex makes nothing"
        );
    });
}

#[test]
fn colors_belong_to_vertices_and_stay_until_changed() {
    on_each_backend(|gl| {
        let (framebuffer, mut immediate) = on_pixels(gl, 8, 1);
        immediate.begin(Mode::Points);
        immediate.color(Vec3::X);
        immediate.vertex(Vec3::new(0.5, 0.5, 0.0));
        immediate.vertex(Vec3::new(1.5, 0.5, 0.0));
        immediate.color_alpha(Vec4::new(0.0, 1.0, 0.0, 1.0));
        immediate.vertex(Vec3::new(2.5, 0.5, 0.0));
        immediate.end();
        draw(&mut immediate, Mode::Points, &[[3.5, 0.5]]);
        let picture = Picture::of(&framebuffer);
        let row = [0, 1, 2, 3, 4].map(|x| picture.at(x, 0));
        assert_eq!(row, [RED, RED, GREEN, GREEN, BLACK]);
    });
}

#[test]
fn a_list_draws_what_its_groups_would_and_again_wherever_the_matrix_says() {
    let groups = |immediate: &mut Immediate| {
        for (index, mode) in [
            Mode::Points,
            Mode::Lines,
            Mode::Lines,
            Mode::LineStrip,
            Mode::LineLoop,
            Mode::Quads,
            Mode::Quads,
            Mode::TriangleFan,
        ]
        .into_iter()
        .enumerate()
        {
            let (x, y) = (
                2.0 + 12.0 * (index % 4) as f32,
                3.0 + 15.0 * (index / 4) as f32,
            );
            immediate.point_size(3.0 + index as f32);
            immediate.color(Vec3::new(0.5, index as f32 * 0.1, 1.0));
            let corners = [[x, y], [x + 9.0, y + 1.0], [x + 8.0, y + 9.0], [x, y + 7.0]];
            draw(immediate, mode, &corners);
        }
    };
    on_each_backend(|gl| {
        let (framebuffer, mut immediate) = on_pixels(gl, 64, 32);
        groups(&mut immediate);
        let wanted = Picture::of(&framebuffer);
        let (framebuffer, mut immediate) = on_pixels(gl, 64, 32);
        immediate.begin_list();
        groups(&mut immediate);
        let list = immediate.end_list().expect("a list");
        assert_eq!(Picture::of(&framebuffer).count(|pixel| pixel != BLACK), 0);
        immediate.load_matrix(Mat4::from_translation(Vec3::X * 9.0));
        immediate.call_list(&list);
        assert_eq!(Picture::of(&framebuffer).count(|pixel| pixel != BLACK), 0);
        immediate.load_matrix(clip_from_pixels(64, 32));
        immediate.call_list(&list);
        assert!(Picture::of(&framebuffer) == wanted);
    });
}

#[test]
fn calls_in_a_wrong_order_draw_nothing_and_are_told() {
    on_each_backend(|gl| {
        let (framebuffer, mut immediate) = on_pixels(gl, 4, 4);
        immediate.vertex(Vec3::ONE);
        assert!(gl.check("a vertex outside").is_err());
        immediate.end();
        assert!(gl.check("an end without a begin").is_err());
        immediate.begin(Mode::Points);
        immediate.vertex(Vec3::ONE);
        immediate.begin(Mode::Points);
        immediate.end();
        assert!(gl.check("two begins").is_err());
        immediate.begin_list();
        draw(&mut immediate, Mode::Points, &[[1.0, 1.0]]);
        immediate.begin(Mode::Quads);
        let list = immediate.end_list().expect("a list");
        immediate.end();
        assert!(gl.check("an end behind the list").is_err());
        assert_eq!(Picture::of(&framebuffer).count(|pixel| pixel != BLACK), 0);
        immediate.call_list(&list);
        assert_eq!(Picture::of(&framebuffer).count(|pixel| pixel != BLACK), 1);
        let framebuffer = black(gl, 4, 4, 0);
        assert_eq!(Picture::of(&framebuffer).count(|pixel| pixel != BLACK), 0);
    });
}

#[test]
fn an_empty_group_is_no_fault() {
    on_each_backend(|gl| {
        let (_framebuffer, mut immediate) = on_pixels(gl, 4, 4);
        for mode in [Mode::Points, Mode::LineLoop, Mode::Quads, Mode::Triangles] {
            for width in [1.0, 4.0] {
                immediate.line_width(width);
                draw(&mut immediate, mode, &[]);
                draw(&mut immediate, mode, &[[1.0, 1.0]]);
            }
        }
    });
}

#[test]
fn a_lit_vertex_is_as_bright_as_its_normal_faces_the_light() {
    on_each_backend(|gl| {
        for (normal, brightness) in [(Vec3::Z, 255), (Vec3::X, 51), (Vec3::NEG_Z, 51)] {
            let (framebuffer, mut immediate) = on_pixels(gl, 8, 8);
            immediate.light(Some(Vec3::Z * 3.0));
            immediate.normal(normal);
            draw(
                &mut immediate,
                Mode::Quads,
                &[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]],
            );
            let [red, ..] = Picture::of(&framebuffer).at(4, 4);
            assert_eq!(red, brightness, "{normal}");
        }
    });
}

#[test]
fn the_edge_of_a_smooth_point_fades_equally_on_all_sides() {
    on_each_backend(|gl| {
        let mut immediate = Immediate::new(gl).expect("the compatibility layer");
        let framebuffer = black(gl, 9, 9, 0);
        DrawState {
            blend: Blend::Alpha,
            ..DrawState::opaque(9, 9)
        }
        .apply(gl);
        immediate.point_size(4.0);
        immediate.point_shape(PointShape::SmoothDisc);
        immediate.begin(Mode::Points);
        immediate.vertex(Vec3::ZERO);
        immediate.end();
        let picture = Picture::of(&framebuffer);
        // Two pixels from the middle the edge of the disc goes through the pixel's center.
        for (x, y) in [(2, 4), (6, 4), (4, 2), (4, 6)] {
            let [covered, ..] = picture.at(x, y);
            assert!((120..=136).contains(&covered), "{covered} at {x}, {y}");
        }
    });
}
