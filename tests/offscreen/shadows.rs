//! Shadows on the Studio look's ground.

use editor_core::geometry::Basis;
use editor_core::gpu::Gl;
use editor_core::render::{Marks, Renderer};
use editor_core::scene::{CurveSet, CurveShape, Evaluator, NewShape};
use editor_core::scene::{Look, Scene, ShapeColor, ShapeKind, Skinning, ViewSettings};
use glam::{Vec2, Vec3};

use crate::offscreen::skinning::characters;
use crate::offscreen::support::{Picture, draw_scene, on_each_backend};

const SIZE: (u32, u32) = (240, 180);

/// From above and in front, so that shadows behind a shape are seen.
fn studio() -> ViewSettings {
    let mut view = ViewSettings {
        axis: false,
        look: Look::Studio,
        ..ViewSettings::default()
    };
    (view.camera.phi, view.camera.radius) = (0.7, 6.0);
    view
}

fn draw(gl: &Gl, scene: &Scene, view: &ViewSettings, skinning: Skinning) -> Picture {
    let mut renderer = Renderer::new(gl).expect("a renderer");
    renderer.set_skinning(Some(skinning));
    draw_scene(&mut renderer, gl, SIZE, scene, view, Marks::default())
}

fn cube_at(height: f32) -> Scene {
    let mut scene = Scene::new();
    let id = scene.add(NewShape::new("Cube", ShapeKind::Cube));
    let placement = &mut scene.shape_mut(id).expect("the cube").placement;
    placement.transform.position.y = height;
    scene
}

/// How many pixels are darker in `picture` than in `plain`.
fn darkened(picture: &Picture, plain: &Picture) -> usize {
    let sum = |pixel: &[u8]| pixel[..3].iter().map(|&c| i32::from(c)).sum::<i32>();
    let pixels = picture.rgba.chunks_exact(4).zip(plain.rgba.chunks_exact(4));
    pixels.filter(|(a, b)| sum(a) < sum(b) - 20).count()
}

#[test]
fn a_shape_above_the_ground_darkens_it_away_from_the_light_and_softly() {
    on_each_backend(|gl| {
        let empty = draw(gl, &Scene::new(), &studio(), Skinning::Cpu);
        let scene = cube_at(2.0);
        let picture = draw(gl, &scene, &studio(), Skinning::Cpu);
        // The light stands to the left and in front, one unit up for half a unit away.
        let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
        let shadow = Vec3::new(0.9, 0.0, -1.1);
        let middle = studio().camera.pixel(shadow, size).expect("in view");
        let (middle, y) = (middle.x as usize, middle.y as usize);
        let darker: Vec<u8> = (middle..SIZE.0 as usize)
            .map(|x| empty.at(x, y)[0].saturating_sub(picture.at(x, y)[0]))
            .collect();
        assert!(darker[0] > 30, "{darker:?}");
        assert_eq!(darker.last(), Some(&0));
        // To the right the ground does not go from dark to light in one step.
        let steps = darker.windows(2).map(|pair| pair[0].abs_diff(pair[1]));
        assert!(steps.max() < Some(darker[0] / 2), "{darker:?}");
    });
}

#[test]
fn a_thin_shadow_that_is_seen_flat_is_as_dark_in_pictures_of_every_size() {
    let mut view = studio();
    (view.camera.phi, view.camera.radius) = (0.1, 8.0);
    view.camera.target = Vec3::Y;
    let mut rod = cube_at(1.0);
    let id = rod.shapes()[0].id;
    let placement = &mut rod.shape_mut(id).expect("the cube").placement;
    placement.transform.scale = Vec3::new(3.0, 0.1, 0.1);
    // The middle of the rod is one unit above the ground.
    let shadow = Vec3::new(0.45, 0.0, -0.55);
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let sizes = [480, 500, 550, 600, 650, 720, 1000].map(|width| (width, width * 3 / 4));
        let darker = sizes.map(|size| {
            let mut drawn =
                |scene: &Scene| draw_scene(&mut renderer, gl, size, scene, &view, Marks::default());
            let (empty, picture) = (drawn(&Scene::new()), drawn(&rod));
            let all = Vec2::new(size.0 as f32, size.1 as f32);
            let at = view.camera.pixel(shadow, all).expect("in view");
            let (x, y) = (at.x as usize, at.y as usize);
            empty.at(x, y)[0].saturating_sub(picture.at(x, y)[0])
        });
        let (least, most) = (darker.iter().min(), darker.iter().max());
        assert!(least > Some(&20) && most < Some(&40), "{darker:?}");
    });
}

#[test]
fn the_shadow_goes_with_the_ground_and_other_looks_have_none() {
    on_each_backend(|gl| {
        // Seen from straight above, the shape hides none of its shadow.
        let mut view = studio();
        view.camera.phi = 1.5;
        let scene = cube_at(2.0);
        let count = |view: &ViewSettings| {
            let [shown, hidden] = [Vec3::ONE, Vec3::splat(1e-3)].map(|scale| {
                let mut scene = scene.clone();
                let id = scene.shapes()[0].id;
                let placement = &mut scene.shape_mut(id).expect("the cube").placement;
                placement.transform.scale = scale;
                placement.color = ShapeColor::Custom(Vec3::ONE);
                draw(gl, &scene, view, Skinning::Cpu)
            });
            darkened(&shown, &hidden)
        };
        assert!(count(&view) > 200, "{}", count(&view));
        let without = ViewSettings {
            grid: false,
            ..view
        };
        let course = ViewSettings {
            look: Look::Course,
            ..view
        };
        assert_eq!((count(&without), count(&course)), (0, 0));
    });
}

#[test]
fn shadows_and_outlines_of_what_the_graphics_card_skins_come_whatever_was_drawn_before() {
    on_each_backend(|gl| {
        let scene = characters::scene_of(characters::column(false));
        let course = ViewSettings::default();
        let id = scene.shapes()[0].id;
        let marks = Marks {
            selected: Some(id),
            ..Marks::default()
        };
        let renderer = || {
            let mut renderer = Renderer::new(gl).expect("a renderer");
            renderer.set_skinning(Some(Skinning::Gpu));
            renderer
        };
        let mut used = renderer();
        // In this look there are no shadows, and nothing is selected.
        draw_scene(&mut used, gl, SIZE, &scene, &course, Marks::default());
        let [again, anew] = [&mut used, &mut renderer()]
            .map(|renderer| draw_scene(renderer, gl, SIZE, &scene, &studio(), marks.clone()));
        assert!(again.rgba == anew.rgba);
    });
}

#[test]
fn the_ground_reaches_to_the_lower_edge_of_a_picture_from_just_above_it() {
    on_each_backend(|gl| {
        let mut view = studio();
        (view.camera.phi, view.camera.target.y) = (0.0, 0.03);
        let picture = draw(gl, &Scene::new(), &view, Skinning::Cpu);
        let (x, height) = (SIZE.0 as usize / 3, SIZE.1 as usize);
        for y in 3 * height / 4..height - 1 {
            let [above, below] = [y, y + 1].map(|y| picture.at(x, y));
            let apart = (0..3).map(|at| above[at].abs_diff(below[at])).max();
            assert!(apart <= Some(3), "{y}: {above:?} {below:?}");
        }
    });
}

#[test]
fn the_ground_lies_under_the_lowest_shape() {
    on_each_backend(|gl| {
        // A cube at the origin reaches down to −0.5, and throws the shadow that one standing half
        // a unit higher throws on the ground at the origin.
        let at_origin = cube_at(0.0);
        let higher = cube_at(0.5);
        let mut lowered = studio();
        lowered.camera.target.y = -0.5;
        let one = draw(gl, &at_origin, &lowered, Skinning::Cpu);
        let other = draw(gl, &higher, &studio(), Skinning::Cpu);
        let apart = one
            .rgba
            .iter()
            .zip(&other.rgba)
            .filter(|(a, b)| a.abs_diff(**b) > 2);
        assert!(apart.count() < 40);
    });
}

#[test]
fn the_ground_lies_under_a_curve_that_has_no_surface() {
    on_each_backend(|gl| {
        let mut scene = Scene::new();
        let curve = CurveShape::new(CurveSet::start_spline(Basis::Bezier));
        let id = scene.add(NewShape::new("Curve", ShapeKind::Curve(curve)));
        let bounds = Evaluator::new().evaluate(&scene, 0.0).shapes[0].world_bounds();
        assert!(bounds.min.y < -0.5, "{bounds:?}");
        let is_line = |pixel: [u8; 4]| pixel[..3].iter().all(|&channel| channel > 220);
        let lines = |scene: &Scene| {
            let view = studio();
            draw(gl, scene, &view, Skinning::Cpu).count(is_line)
        };
        let at_origin = lines(&scene);
        let placement = &mut scene.shape_mut(id).expect("the curve").placement;
        placement.transform.position.y = 2.0;
        let above = lines(&scene);
        assert!(
            above > 60 && at_origin * 10 > above * 9,
            "{at_origin}, {above}"
        );
    });
}

#[test]
fn a_shape_that_is_moved_below_the_ground_leaves_it_where_it_is_and_is_hidden() {
    on_each_backend(|gl| {
        let mut scene = cube_at(0.0);
        let alone = draw(gl, &scene, &studio(), Skinning::Cpu);
        let other = scene.add(NewShape::new("Sphere", ShapeKind::Sphere));
        let mut place = |x: f32, y: f32| {
            let placement = &mut scene.shape_mut(other).expect("the sphere").placement;
            placement.transform.position = Vec3::new(x, y, 0.0);
            draw(gl, &scene, &studio(), Skinning::Cpu)
        };
        assert!(place(-1.5, 0.0) != alone);
        for height in [-1.5, -3.0, -6.0] {
            assert!(place(0.3, height) == alone, "{height}");
        }
    });
}

#[test]
fn shadows_are_the_same_whoever_skins() {
    let mut scene = characters::scene_of(characters::column(false));
    characters::bend(&mut scene);
    on_each_backend(|gl| {
        let [cpu, gpu] = [Skinning::Cpu, Skinning::Gpu].map(|s| draw(gl, &scene, &studio(), s));
        let apart = cpu
            .rgba
            .iter()
            .zip(&gpu.rgba)
            .filter(|(a, b)| a.abs_diff(**b) > 2);
        assert!(apart.count() < 20);
        // Beside the column, which is all that the Course look shows, only its shadow is dark.
        let course = ViewSettings {
            look: Look::Course,
            ..studio()
        };
        let mut column = draw(gl, &scene, &course, Skinning::Gpu);
        let background = column.at(0, 0);
        let empty = draw(gl, &Scene::new(), &studio(), Skinning::Gpu);
        let (pixels, ground) = (gpu.rgba.chunks_exact(4), empty.rgba.chunks_exact(4));
        for ((seen, pixel), ground) in column.rgba.chunks_exact_mut(4).zip(pixels).zip(ground) {
            let is_column = *seen != background;
            seen.copy_from_slice(if is_column { ground } else { pixel });
        }
        let shadow = darkened(&column, &empty);
        assert!(shadow > 50, "{shadow} pixels are in the shadow");
    });
}

#[test]
fn a_far_plane_nearer_than_the_ground_reaches_is_where_the_ground_ends() {
    on_each_backend(|gl| {
        let mut view = studio();
        view.camera.near = 0.1;
        view.camera.far = 10.0;
        let with_ground = draw(gl, &cube_at(0.5), &view, Skinning::Cpu);
        view.grid = false;
        let without = draw(gl, &cube_at(0.5), &view, Skinning::Cpu);
        assert!(with_ground.rgba != without.rgba, "no ground");
    });
}
