//! The same picture, whoever skins.

use super::characters::{self, ids};
use crate::offscreen::support::{Picture, on_each_backend};
use editor_core::character::Pose;
use editor_core::gpu::{Framebuffer, Gl};
use editor_core::render::{Backdrop, Frame, Marks, Renderer, ShapeNumbers};
use editor_core::scene::NewShape;
use editor_core::scene::{
    CharacterNumber, Evaluated, Evaluator, FitArea, ModelDisplay, SCALE_GRAY, Scene, Shading,
    ShapeKind, Skinning, SkinningMethod, ViewSettings, scale_color,
};
use glam::Vec3;
use std::sync::Arc;

const SIZE: (u32, u32) = (400, 300);

fn renderer(gl: &Gl, skinning: Skinning) -> Renderer {
    let mut renderer = Renderer::new(gl).expect("a renderer");
    renderer.set_skinning(Some(skinning));
    assert_eq!(renderer.skinning(), skinning);
    renderer
}

fn fitted(scene: &Scene, shading: Shading) -> ViewSettings {
    let mut view = ViewSettings {
        shading,
        axis: false,
        ..ViewSettings::default()
    };
    view.camera.theta = 1.2;
    view.camera.phi = 0.2;
    let bounds = Evaluator::new().evaluate(scene, 0.0).world_bounds();
    view.camera
        .fit(&bounds, FitArea::whole(SIZE.0 as f32 / SIZE.1 as f32));
    view
}

fn draw(
    gl: &Gl,
    renderer: &mut Renderer,
    scene: &Scene,
    view: &ViewSettings,
    marks: Marks,
) -> (Picture, Evaluated) {
    let evaluated = Evaluator::new().evaluate(scene, 0.0);
    let frame = Frame {
        scene,
        evaluated: &evaluated,
        view,
        backdrop: Backdrop::default(),
        marks,
    };
    let target = Framebuffer::new(gl, SIZE.0, SIZE.1, 0).expect("a picture");
    renderer.draw(&frame, &target).expect("a drawn frame");
    assert_eq!(renderer.take_notices(), Vec::<String>::new());
    (Picture::of(&target), evaluated)
}

fn same(what: &str, one: &Picture, other: &Picture) {
    let pixels = one.rgba.chunks_exact(4).zip(other.rgba.chunks_exact(4));
    let apart = |(a, b): (&[u8], &[u8])| (0..3).map(|c| a[c].abs_diff(b[c])).max() > Some(2);
    let different = pixels.filter(|&pair| apart(pair)).count();
    let drawn = one.count(|pixel| pixel != [26, 26, 26, 255]);
    assert!(drawn > 1000, "{what}: only {drawn} pixels");
    eprintln!("{what}: {different} of {drawn} pixels differ");
    // Rounding decides now and then which triangle has a pixel on an edge.
    assert!(
        different * 500 <= drawn,
        "{what}: {different} of {drawn} pixels differ"
    );
}

#[test]
fn the_picture_is_the_same_whoever_skins() {
    let scenes = characters::all();
    on_each_backend(|gl| {
        let [mut cpu, mut gpu] = [Skinning::Cpu, Skinning::Gpu].map(|s| renderer(gl, s));
        for (name, scene) in &scenes {
            for shading in [Shading::AsAuthored, Shading::Flat, Shading::Smooth] {
                let view = fitted(scene, shading);
                let (here, _) = draw(gl, &mut cpu, scene, &view, Marks::default());
                let (there, _) = draw(gl, &mut gpu, scene, &view, Marks::default());
                same(&format!("{name}, {shading:?}"), &here, &there);
            }
        }
    });
}

#[test]
fn outlines_and_meshes_seen_through_are_the_same_too() {
    let mut scene = characters::scene_of(characters::column(true));
    characters::bend(&mut scene);
    let id = ids(&scene)[0];
    scene.character_mut(id).expect("the column").display.mode = ModelDisplay::Both;
    let marks = Marks {
        selected: Some(id),
        ..Marks::default()
    };
    on_each_backend(|gl| {
        let [mut cpu, mut gpu] = [Skinning::Cpu, Skinning::Gpu].map(|s| renderer(gl, s));
        let view = fitted(&scene, Shading::AsAuthored);
        let (here, _) = draw(gl, &mut cpu, &scene, &view, marks.clone());
        let (there, _) = draw(gl, &mut gpu, &scene, &view, marks.clone());
        same("outlined", &here, &there);
    });
}

#[test]
fn dual_quaternions_give_the_same_picture_where_the_graphics_card_is_to_skin() {
    let mut scene = characters::scene_of(characters::column(true));
    characters::bend(&mut scene);
    let id = ids(&scene)[0];
    on_each_backend(|gl| {
        let [mut cpu, mut gpu] = [Skinning::Cpu, Skinning::Gpu].map(|s| renderer(gl, s));
        let view = fitted(&scene, Shading::AsAuthored);
        let (linear, _) = draw(gl, &mut gpu, &scene, &view, Marks::default());
        let mut scene = scene.clone();
        let character = scene.character_mut(id).expect("the column");
        character.set_skinning_method(SkinningMethod::DualQuaternion);
        let (here, _) = draw(gl, &mut cpu, &scene, &view, Marks::default());
        let (there, _) = draw(gl, &mut gpu, &scene, &view, Marks::default());
        same("dual quaternions", &here, &there);
        assert!(there.rgba != linear.rgba, "as by linear blending");
    });
}

#[test]
fn colors_of_numbers_are_the_same_whoever_skins_and_are_those_of_the_scale() {
    let scenes = characters::all();
    on_each_backend(|gl| {
        let [mut cpu, mut gpu] = [Skinning::Cpu, Skinning::Gpu].map(|s| renderer(gl, s));
        for (name, scene) in &scenes {
            let view = fitted(scene, Shading::AsAuthored);
            let numbered = |shape| {
                let character = &scene.character(shape)?.character;
                let number = (CharacterNumber::Weight(1), &**character);
                let numbers = CharacterNumber::on_one_scale([number]).pop()?;
                Some(ShapeNumbers {
                    shape,
                    numbers: Arc::new(numbers),
                })
            };
            let marks = Marks {
                numbers: ids(scene).into_iter().filter_map(numbered).collect(),
                ..Marks::default()
            };
            let (here, _) = draw(gl, &mut cpu, scene, &view, marks.clone());
            let (there, _) = draw(gl, &mut gpu, scene, &view, marks);
            same(name, &here, &there);
            // Every pixel of a mesh has a hue of the scale, or its gray.
            let is_of_scale = |pixel: [u8; 4]| {
                let seen = Vec3::new(pixel[0].into(), pixel[1].into(), pixel[2].into()) / 255.0;
                let scale = (0..=100).map(|part| scale_color(part as f32 / 100.0));
                scale.chain([SCALE_GRAY]).any(|color| {
                    let lit = color * (seen.length() / color.length());
                    (seen - lit).length() < 0.03
                })
            };
            let background = [26, 26, 26, 255];
            let others = here.count(|pixel| pixel != background && !is_of_scale(pixel));
            let drawn = here.count(|pixel| pixel != background);
            assert!(others * 50 <= drawn, "{name}: {others} of {drawn}");
        }
    });
}

#[test]
fn new_poses_are_drawn_without_the_processor_touching_a_vertex() {
    on_each_backend(|gl| {
        let mut gpu = renderer(gl, Skinning::Gpu);
        let mut scene = characters::scene_of(characters::column(false));
        let view = fitted(&scene, Shading::AsAuthored);
        let (rest, _) = draw(gl, &mut gpu, &scene, &view, Marks::default());
        characters::bend(&mut scene);
        let (bent, evaluated) = draw(gl, &mut gpu, &scene, &view, Marks::default());
        assert!(rest != bent);
        let deformation = evaluated.shapes[0].geometry.deformation.as_ref();
        assert!(!deformation.expect("a character").is_worked_out());
        let id = ids(&scene)[0];
        scene
            .character_mut(id)
            .expect("the column")
            .set_pose(Pose::new());
        let (back, _) = draw(gl, &mut gpu, &scene, &view, Marks::default());
        assert!(rest == back);
    });
}

#[test]
fn several_characters_keep_their_own_joints_when_one_of_them_goes() {
    on_each_backend(|gl| {
        let [mut cpu, mut gpu] = [Skinning::Cpu, Skinning::Gpu].map(|s| renderer(gl, s));
        let mut scene = characters::scene_of(characters::column(false));
        let shape = scene.shapes()[0].kind.clone();
        for x in [-1.0, 1.0] {
            let id = scene.add(NewShape::new("Column", shape.clone()));
            let placed = scene.shape_mut(id).expect("a column");
            placed.placement.transform.position.x = x;
        }
        characters::bend(&mut scene);
        let first = ids(&scene)[0];
        scene
            .character_mut(first)
            .expect("a column")
            .set_pose(Pose::new());
        let view = fitted(&scene, Shading::AsAuthored);
        for what in ["three", "two"] {
            let (here, _) = draw(gl, &mut cpu, &scene, &view, Marks::default());
            let (there, _) = draw(gl, &mut gpu, &scene, &view, Marks::default());
            same(what, &here, &there);
            scene.delete(first);
        }
    });
}

#[test]
fn other_weights_on_the_same_mesh_are_noticed() {
    on_each_backend(|gl| {
        let [mut cpu, mut gpu] = [Skinning::Cpu, Skinning::Gpu].map(|s| renderer(gl, s));
        let mut scene = characters::scene_of(characters::column(true));
        characters::bend(&mut scene);
        let view = fitted(&scene, Shading::AsAuthored);
        let (all, _) = draw(gl, &mut gpu, &scene, &view, Marks::default());
        let id = ids(&scene)[0];
        if let Some(ShapeKind::Character(column)) = scene.shape_mut(id).map(|s| &mut s.kind) {
            let limited = Arc::new(column.character.limited(1));
            column.character = limited;
        }
        let (one_cpu, _) = draw(gl, &mut cpu, &scene, &view, Marks::default());
        let (one_gpu, _) = draw(gl, &mut gpu, &scene, &view, Marks::default());
        assert!(all != one_gpu);
        same("one influence", &one_cpu, &one_gpu);
    });
}
