//! Crowds: what copies of a character cost, and that they look as each on its own.

use super::batches::batches;
use super::shown_triangles::Purpose;
use super::{Frame, GradualPicture, Renderer};
use crate::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
use crate::geometry::{Mesh, Picture, Poles, sphere};
use crate::gpu::test_driver::TestDriver;
use crate::gpu::{Backend, Framebuffer, Gl, HeadlessContext};
use crate::math::Euler;
use crate::render::read_picture;
use crate::scene::{
    CharacterShape, Evaluated, Evaluator, Look, NewShape, Scene, ShapeColor, ShapeId, ShapeKind,
    Skinning, ViewSettings,
};
use glam::Vec3;
use std::sync::Arc;

/// A ball whose upper half turns about its middle.
fn nodding() -> Arc<Character> {
    let ball = sphere(0.5, 16, 16, Poles::Y);
    let child = Joint {
        parent: Some(0),
        ..Joint::default()
    };
    let skeleton = SkeletalModel::new(vec![Joint::default(), child]).unwrap();
    let mut attachments = Attachments::new();
    for position in &ball.positions {
        let upper = (position.y + 0.5).clamp(0.0, 1.0);
        let weights = [(0, 1.0 - upper), (1, upper)];
        attachments.push_vertex(weights.map(|(joint, weight)| Influence { joint, weight }));
    }
    let mesh = Mesh::new(ball.positions, ball.triangles);
    Arc::new(Character::new(skeleton, attachments, mesh).unwrap())
}

fn pose(number: usize) -> Pose {
    let mut pose = Pose::new();
    let angle = 40.0 * (number as f32 + 0.5).sin();
    pose.set_joint_transform(1, Euler::from_degrees(Vec3::new(angle, 0.0, -angle)));
    pose
}

/// Rows of ten copies with poses, places and colors of their own.
fn crowd(count: usize) -> Scene {
    let character = nodding();
    let mut scene = Scene::new();
    for number in 0..count {
        let mut shape = CharacterShape::new(Arc::clone(&character));
        shape.set_pose(pose(number));
        let id = scene.add(NewShape::new("Ball", ShapeKind::Character(shape)));
        let placement = &mut scene.shape_mut(id).unwrap().placement;
        let (row, column) = (number / 10, number % 10);
        placement.transform.position = Vec3::new(column as f32 - 4.5, row as f32 - 1.0, -3.0);
        placement.transform.scale = Vec3::new(0.9, 1.1, 0.8);
        let part = number as f32 / count as f32;
        placement.color = ShapeColor::Custom(Vec3::new(part, 1.0 - part, 0.5));
    }
    scene
}

fn drawn(renderer: &mut Renderer, gl: &Gl, scene: &Scene, view: &ViewSettings) -> Picture {
    drawn_of(
        renderer,
        gl,
        (scene, &Evaluator::new().evaluate(scene, 0.0)),
        view,
    )
}

fn drawn_of(
    renderer: &mut Renderer,
    gl: &Gl,
    (scene, evaluated): (&Scene, &Evaluated),
    view: &ViewSettings,
) -> Picture {
    let frame = Frame::plain(scene, evaluated, view);
    let target = Framebuffer::new(gl, 200, 150, 0).unwrap();
    renderer.draw(&frame, &target).unwrap();
    read_picture(&target).unwrap()
}

fn view(look: Look) -> ViewSettings {
    ViewSettings {
        look,
        grid: true,
        axis: false,
        ..ViewSettings::default()
    }
}

fn skinning_by(gl: &Gl, skinning: Skinning) -> Renderer {
    let mut renderer = Renderer::new(gl).unwrap();
    renderer.set_skinning(Some(skinning));
    renderer
}

#[test]
fn copies_drawn_at_once_look_as_those_drawn_one_by_one() {
    let headless = HeadlessContext::new(Backend::Auto).unwrap();
    let gl = headless.gl();
    let copies = crowd(70);
    // The same shapes, each with a mesh of its own, which no other can be drawn with.
    let mut others = Scene::new();
    for shape in copies.shapes() {
        let character = copies.character(shape.id).unwrap();
        let mut other = CharacterShape::new(nodding());
        other.set_pose(character.pose().clone());
        let id = others.add(NewShape::new("Ball", ShapeKind::Character(other)));
        others.shape_mut(id).unwrap().placement = shape.placement;
    }
    for look in [Look::Course, Look::Studio] {
        for skinning in [Skinning::Cpu, Skinning::Gpu] {
            let mut renderer = skinning_by(gl, skinning);
            let mut view = view(look);
            view.camera.radius = 20.0;
            let at_once = drawn(&mut renderer, gl, &copies, &view);
            let draws = |renderer: &Renderer, scene: &Scene| {
                let evaluated = Evaluator::new().evaluate(scene, 0.0);
                let shapes = scene.shapes().iter().zip(&evaluated.shapes);
                batches(shapes, &renderer.meshes, Purpose::Surface).len()
            };
            let expected = match skinning {
                Skinning::Gpu => 2,
                Skinning::Cpu => 70,
            };
            assert_eq!(draws(&renderer, &copies), expected);
            // 70 times 480 triangles, the copies of each at once.
            let mut gradual = GradualPicture::new(gl, (200, 150), 0).unwrap();
            gradual.most.triangles = 9_000;
            let evaluated = Evaluator::new().evaluate(&copies, 0.0);
            let frame = Frame::plain(&copies, &evaluated, &view);
            let mut steps = 0;
            while !gradual.is_complete() {
                gradual.draw_next(&mut renderer, &frame).unwrap();
                steps += 1;
            }
            // In the Studio look one for the shadows and one for the ground as well.
            assert_eq!(steps, if look == Look::Studio { 7 } else { 5 });
            let in_steps = read_picture(gradual.picture()).unwrap();
            assert!(at_once == in_steps, "{look:?} {skinning:?}");
            let mut renderer = skinning_by(gl, skinning);
            let one_by_one = drawn(&mut renderer, gl, &others, &view);
            assert_eq!(draws(&renderer, &others), 70);
            assert!(at_once == one_by_one, "{look:?} {skinning:?}");
        }
    }
}

#[test]
fn of_a_crowd_only_what_moves_is_uploaded() {
    let driver = TestDriver::new();
    let gl = driver.gl();
    for skinning in [Skinning::Cpu, Skinning::Gpu] {
        let mut renderer = skinning_by(gl, skinning);
        let mut scene = crowd(40);
        let view = view(Look::Course);
        let mut evaluator = Evaluator::new();
        let mut uploaded = |scene: &Scene| {
            let evaluated = evaluator.evaluate(scene, 0.0);
            TestDriver::uploaded();
            drawn_of(&mut renderer, gl, (scene, &evaluated), &view);
            TestDriver::uploaded()
        };
        let first = uploaded(&scene);
        let nothing = uploaded(&scene);
        // What is left are the quads of the background.
        assert!(nothing < 1000, "{skinning:?}: {nothing} of {first} bytes");
        let one = ShapeId(20);
        scene.character_mut(one).unwrap().set_pose(pose(77));
        let moved = uploaded(&scene) - nothing;
        match skinning {
            // All positions and normals of one ball, and the list of its triangles.
            Skinning::Cpu => assert!((5_000..30_000).contains(&moved), "{moved} of {first}"),
            // The row of the table that its cells are in; two, where they go on in the next.
            Skinning::Gpu => assert!([16_384, 32_768].contains(&moved), "{moved} of {first}"),
        }
        // The same place again, with all others still there.
        scene.delete(one);
        assert_eq!(uploaded(&scene), nothing, "{skinning:?}");
    }
}

#[test]
fn copies_share_what_does_not_change_with_a_pose() {
    let driver = TestDriver::new();
    let gl = driver.gl();
    let uploaded = |count, skinning| {
        let (mut renderer, scene) = (skinning_by(gl, skinning), crowd(count));
        TestDriver::uploaded();
        drawn(&mut renderer, gl, &scene, &view(Look::Course));
        TestDriver::uploaded()
    };
    let [alone, two, forty] = [1, 2, 40].map(|count| uploaded(count, Skinning::Gpu));
    // One mesh, and one more row of the table at most.
    assert!(forty - alone <= 3 * 16_384, "{alone}, {forty}");
    assert!(two - alone <= 16_384, "{alone}, {two}");
}

#[test]
fn copies_out_of_sight_are_neither_skinned_nor_uploaded() {
    let driver = TestDriver::new();
    let gl = driver.gl();
    for look in [Look::Course, Look::Studio] {
        let mut renderer = skinning_by(gl, Skinning::Cpu);
        let mut away = view(look);
        away.camera.target = Vec3::new(500.0, 0.0, 0.0);
        let scene = crowd(40);
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        drawn_of(
            &mut renderer,
            gl,
            (&Scene::new(), &Evaluated::default()),
            &away,
        );
        TestDriver::uploaded();
        drawn_of(
            &mut renderer,
            gl,
            (&Scene::new(), &Evaluated::default()),
            &away,
        );
        let nothing = TestDriver::uploaded();
        drawn_of(&mut renderer, gl, (&scene, &evaluated), &away);
        assert_eq!(TestDriver::uploaded(), nothing, "{look:?}");
        let mut shapes = evaluated.shapes.iter();
        let skinned = |deformation: &crate::scene::Deformation| deformation.is_worked_out();
        assert!(!shapes.any(|shape| shape.geometry.deformation.as_ref().is_some_and(skinned)));
        drawn_of(&mut renderer, gl, (&scene, &evaluated), &view(look));
        assert!(TestDriver::uploaded() > 100_000, "{look:?}");
    }
}
