//! Shadows on the Studio look's ground.

use editor_core::character::Skinning;
use editor_core::gpu::{Framebuffer, Gl};
use editor_core::render::{Frame, Marks, Renderer};
use editor_core::scene::{Evaluator, Look, Scene, ShapeId, ShapeKind, ViewSettings};
use glam::Vec3;

use crate::skinning::characters;
use crate::support::{Picture, on_each_backend};

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
    let evaluated = Evaluator::new().evaluate(scene);
    let frame = Frame {
        scene,
        evaluated: &evaluated,
        view,
        marks: Marks::default(),
    };
    let target = Framebuffer::new(gl, SIZE.0, SIZE.1, 0).expect("a picture");
    let mut renderer = Renderer::new(gl).expect("a renderer");
    renderer.set_skinning(Some(skinning));
    renderer.draw(&frame, &target).expect("a drawn frame");
    Picture::of(&target)
}

fn cube_at(height: f32) -> (Scene, ShapeId) {
    let mut scene = Scene::new();
    let id = scene.add("Cube".to_owned(), ShapeKind::Cube, None);
    let placement = &mut scene.shape_mut(id).expect("the cube").placement;
    placement.transform.position.y = height;
    (scene, id)
}

/// The pixels that are darker in `picture` than in `plain`, and the mean of their places.
fn darkened(picture: &Picture, plain: &Picture) -> (usize, f32, f32) {
    let mut places = Vec::new();
    for y in 0..SIZE.1 as usize {
        for x in 0..SIZE.0 as usize {
            let [a, b] = [picture, plain]
                .map(|p| p.at(x, y)[..3].iter().map(|&c| i32::from(c)).sum::<i32>());
            if a < b - 20 {
                places.push((x as f32, y as f32));
            }
        }
    }
    let count = places.len().max(1) as f32;
    let sum = places
        .iter()
        .fold((0.0, 0.0), |s, p| (s.0 + p.0, s.1 + p.1));
    (places.len(), sum.0 / count, sum.1 / count)
}

#[test]
fn a_shape_above_the_ground_darkens_it_away_from_the_light_and_softly() {
    on_each_backend(|gl| {
        let empty = draw(gl, &Scene::new(), &studio(), Skinning::Cpu);
        let (scene, _) = cube_at(2.0);
        let picture = draw(gl, &scene, &studio(), Skinning::Cpu);
        let (count, x, y) = darkened(&picture, &empty);
        assert!(count > 300, "{count} pixels");
        // The light stands to the left.
        assert!(x > 120.0, "{x}");
        // Not one step from light to dark along a row, but many.
        let steps = (1..SIZE.0 as usize).map(|x| {
            let darker =
                |x: usize| empty.at(x, y as usize)[0].abs_diff(picture.at(x, y as usize)[0]);
            darker(x).abs_diff(darker(x - 1))
        });
        assert!(steps.max() < Some(12), "a hard edge");
    });
}

#[test]
fn the_shadow_goes_with_the_ground_and_other_looks_have_none() {
    on_each_backend(|gl| {
        let (scene, _) = cube_at(2.0);
        for view in [
            ViewSettings {
                grid: false,
                ..studio()
            },
            ViewSettings {
                look: Look::Course,
                ..studio()
            },
        ] {
            let picture = draw(gl, &scene, &view, Skinning::Cpu);
            let empty = draw(gl, &Scene::new(), &view, Skinning::Cpu);
            assert_eq!(darkened(&picture, &empty).0, 0, "{:?}", view.look);
        }
    });
}

#[test]
fn the_ground_lies_under_the_lowest_shape() {
    on_each_backend(|gl| {
        // A cube at the origin reaches down to −0.5, and throws the shadow that one standing half
        // a unit higher throws on the ground at the origin.
        let (at_origin, _) = cube_at(0.0);
        let (higher, _) = cube_at(0.5);
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
        let mut bare = scene.clone();
        let id = bare.shapes()[0].id;
        let placement = &mut bare.shape_mut(id).expect("the column").placement;
        placement.transform.scale = Vec3::splat(1e-3);
        assert!(cpu != draw(gl, &bare, &studio(), Skinning::Cpu));
    });
}
