//! Pictures in tiles, and without a background.

use editor_core::disk::files;
use editor_core::geometry::Picture;
use editor_core::gpu::Backend;
use editor_core::io::Loaded;
use editor_core::render::{Background, Frame, LargePicture, Offscreen};
use editor_core::scene::{Camera, Evaluator, Look, ModelDisplay, Scene, ShapeKind, ViewSettings};
use std::path::Path;

/// A built-in scene or model, with the view that it brings.
fn builtin(name: &str) -> (Scene, ViewSettings) {
    let mut loaded = Loaded::default();
    loaded
        .add(&files(), Path::new(&format!("builtin:{name}")))
        .unwrap();
    (
        Scene::from_iter(loaded.shapes),
        loaded.view.unwrap_or_default(),
    )
}

fn picture(
    offscreen: &mut Offscreen,
    (scene, view): &(Scene, ViewSettings),
    asked: &LargePicture,
) -> Picture {
    let evaluated = Evaluator::new().evaluate(scene, 0.0);
    let frame = Frame::plain(scene, &evaluated, view);
    offscreen.large_picture(&frame, asked, |_, _| {}).unwrap()
}

const ASKED: LargePicture = LargePicture {
    size: (800, 600),
    samples: 0,
    background: Background::Look,
    tile: None,
};

/// How many pixels differ by more than `most` in a channel.
fn apart(a: &Picture, b: &Picture, most: u8) -> usize {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let pixels = a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4));
    let differs = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > most);
    pixels.filter(differs).count()
}

fn in_look(name: &str, look: Look) -> (Scene, ViewSettings) {
    let (scene, view) = builtin(name);
    let axis = false;
    (scene, ViewSettings { look, axis, ..view })
}

/// Number of pixels of a picture.
const ALL: usize = 800 * 600;

#[test]
fn tiles_make_the_same_picture_up_to_what_rounding_moves_over_the_middle_of_a_pixel() {
    for backend in [Backend::Egl, Backend::Osmesa] {
        let mut offscreen = Offscreen::new(backend).unwrap();
        for name in ["showcase", "adult", "mannequin-5", "knot"] {
            for samples in [0, 4] {
                for look in [Look::Course, Look::Mannequin] {
                    let scene = in_look(name, look);
                    let asked = LargePicture { samples, ..ASKED };
                    let whole = picture(&mut offscreen, &scene, &asked);
                    let tile = Some(256);
                    let tiled = picture(&mut offscreen, &scene, &LargePicture { tile, ..asked });
                    let what = format!("{backend:?} {name} {look:?} {samples}");
                    let (any, seen) = (apart(&whole, &tiled, 0), apart(&whole, &tiled, 1));
                    assert!(any * 1000 <= ALL, "{what}: {any} differ");
                    assert!(seen * 10_000 <= ALL, "{what}: {seen} differ by more than 1");
                }
            }
        }
    }
}

#[test]
fn soft_shadows_have_no_seams_where_tiles_meet() {
    let mut offscreen = Offscreen::new(Backend::Auto).unwrap();
    for name in ["showcase", "adult", "knot"] {
        let scene = in_look(name, Look::Studio);
        let mut of = |tile| picture(&mut offscreen, &scene, &LargePicture { tile, ..ASKED });
        // Of these three no two have all seams in the same places.
        let (large, small, smallest) = (of(Some(640)), of(Some(384)), of(Some(128)));
        for other in [&small, &smallest] {
            let seen = apart(&large, other, 1);
            assert!(seen * 10_000 <= ALL, "{name}: {seen} differ by more than 1");
        }
        // In one piece the smaller versions that shadows are read from are cut otherwise.
        let whole = of(None);
        let seen = apart(&large, &whole, 8);
        assert!(seen * 1000 <= ALL, "{name}: {seen} differ by more than 8");
    }
}

#[test]
fn a_picture_beyond_the_limits_of_the_driver_is_drawn_and_one_within_them_is_not_cut() {
    let mut offscreen = Offscreen::new(Backend::Auto).unwrap();
    let (scene, view) = in_look("robot", Look::Course);
    let evaluated = Evaluator::new().evaluate(&scene, 0.0);
    let frame = Frame::plain(&scene, &evaluated, &view);
    let most = offscreen.gl().info().max_framebuffer_size;
    let size = (most + 100, 40);
    assert!(offscreen.picture(&frame, size, 0).is_err());
    let mut heard = Vec::new();
    let asked = LargePicture { size, ..ASKED };
    let drawn = offscreen.large_picture(&frame, &asked, |done, all| heard.push((done, all)));
    let drawn = drawn.unwrap();
    assert_eq!((drawn.width, drawn.height), size);
    let tiles = (most as usize + 100).div_ceil(2048);
    let expected: Vec<_> = (0..=tiles).map(|done| (done, tiles)).collect();
    assert_eq!(heard, expected);
    // The robot stands in the middle, the edges are background.
    let pixel = |x: u32| &drawn.rgba[4 * (20 * size.0 + x) as usize..][..4];
    assert_eq!(
        (pixel(0), pixel(size.0 - 1)),
        (&[26, 26, 26, 255][..], &[26, 26, 26, 255][..])
    );
    let seen = (0..size.0).filter(|&x| pixel(x) != [26, 26, 26, 255]);
    let middle: Vec<u32> = seen.collect();
    let (first, last) = (middle[0], middle[middle.len() - 1]);
    assert!(
        first > size.0 / 2 - 40 && last < size.0 / 2 + 40,
        "{first} {last}"
    );

    let small = offscreen.picture(&frame, (300, 200), 4).unwrap();
    let asked = LargePicture {
        size: (300, 200),
        samples: 4,
        ..ASKED
    };
    let asked = offscreen.large_picture(&frame, &asked, |_, _| panic!("one piece"));
    assert!(asked.unwrap() == small);
}

/// A transparent picture over a background of one gray.
fn over_gray(picture: &Picture, gray: u8) -> Picture {
    let pixels = picture.rgba.chunks_exact(4);
    let blend = |color: u8, alpha: u8| {
        let (color, alpha) = (f32::from(color), f32::from(alpha) / 255.0);
        (color * alpha + f32::from(gray) * (1.0 - alpha)).round() as u8
    };
    let rgba = pixels.flat_map(|p| [blend(p[0], p[3]), blend(p[1], p[3]), blend(p[2], p[3]), 255]);
    Picture {
        rgba: rgba.collect(),
        ..picture.clone()
    }
}

#[test]
fn over_the_background_that_was_left_out_a_transparent_picture_looks_as_before() {
    let mut offscreen = Offscreen::new(Backend::Auto).unwrap();
    for name in ["adult", "knot"] {
        for mode in [
            ModelDisplay::Mesh,
            ModelDisplay::Both,
            ModelDisplay::Skeleton,
        ] {
            for (samples, tile) in [(0, None), (4, None), (4, Some(256))] {
                let (mut scene, view) = in_look(name, Look::Course);
                let id = scene.shapes()[0].id;
                if let ShapeKind::Character(character) = &mut scene.shape_mut(id).unwrap().kind {
                    character.display.mode = mode;
                }
                let drawn = (scene, view);
                let asked = LargePicture {
                    samples,
                    tile,
                    ..ASKED
                };
                let opaque = picture(&mut offscreen, &drawn, &asked);
                let background = Background::Transparent;
                let asked = LargePicture {
                    background,
                    ..asked
                };
                let transparent = picture(&mut offscreen, &drawn, &asked);
                let what = format!("{name} {mode:?} {samples} {tile:?}");
                assert_eq!(transparent.rgba[..4], [0, 0, 0, 0], "{what}");
                let seen = apart(&over_gray(&transparent, 26), &opaque, 2);
                assert_eq!(seen, 0, "{what}");
                let solid = transparent.rgba.chunks_exact(4).filter(|p| p[3] == 255);
                assert!(solid.count() > 1000, "{what}");
            }
        }
    }
}

#[test]
fn of_the_studio_ground_only_shadows_stay_and_of_the_mannequin_floor_nothing() {
    let mut offscreen = Offscreen::new(Backend::Auto).unwrap();
    let transparent = LargePicture {
        background: Background::Transparent,
        ..ASKED
    };
    let (scene, view) = builtin("adult");
    let camera = Camera {
        phi: 0.5,
        ..view.camera
    };
    let mut of = |look| {
        let view = ViewSettings {
            look,
            camera,
            grid: true,
            axis: false,
            ..view
        };
        picture(&mut offscreen, &(scene.clone(), view), &transparent)
    };
    let studio = of(Look::Studio);
    let half = studio
        .rgba
        .chunks_exact(4)
        .filter(|p| (1..255).contains(&p[3]));
    let half: Vec<&[u8]> = half.collect();
    assert!(half.len() > 1000, "{}", half.len());
    assert!(
        half.iter().all(|p| p[..3] == [0, 0, 0]),
        "shadows are black"
    );
    let mannequin = of(Look::Mannequin);
    let solid = mannequin.rgba.chunks_exact(4).filter(|p| p[3] == 255);
    let share = solid.count() as f32 / ALL as f32;
    assert!((0.01..0.5).contains(&share), "{share}: the character alone");
    assert!(
        mannequin
            .rgba
            .chunks_exact(4)
            .all(|p| p[3] == 0 || p[3] == 255)
    );
}
