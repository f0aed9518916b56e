//! The Mannequin look: colors of normals, a checkered floor, bones over everything.

use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

use editor_core::character::{Attachments, Character, Influence, Joint, SkeletalModel};
use editor_core::geometry::cube;
use editor_core::gpu::Gl;
use editor_core::render::{Marks, Renderer};
use editor_core::scene::NewShape;
use editor_core::scene::{CharacterShape, Look, ModelDisplay, Scene, ShapeKind, ViewSettings};
use glam::Vec3;

use crate::offscreen::support::{Picture, draw_scene, on_each_backend};

const SIZE: (u32, u32) = (400, 300);
const BACKGROUND: [u8; 4] = [0, 95, 95, 255];
const BONE: [u8; 4] = [255, 0, 0, 255];
const HOVERED_BONE: [u8; 4] = [0, 255, 255, 255];

/// As the original starts: from (0, 0, −6).
fn first_view() -> ViewSettings {
    let mut view = ViewSettings {
        axis: false,
        look: Look::Mannequin,
        ..ViewSettings::default()
    };
    (view.camera.theta, view.camera.radius) = (-FRAC_PI_2, 6.0);
    view
}

fn draw(gl: &Gl, scene: &Scene, view: &ViewSettings, marks: Marks) -> Picture {
    let mut renderer = Renderer::new(gl).expect("a renderer");
    draw_scene(&mut renderer, gl, SIZE, scene, view, marks)
}

/// A cube with two upright bones inside, one after the other.
fn boxed_bones() -> Scene {
    let joint = |parent, y| Joint {
        parent,
        offset: Vec3::Y * y,
        ..Joint::default()
    };
    let joints = vec![joint(None, -0.4), joint(Some(0), 0.4), joint(Some(1), 0.4)];
    let mesh = cube();
    let mut attachments = Attachments::new();
    for _ in &mesh.positions {
        attachments.push_vertex([Influence {
            joint: 0,
            weight: 1.0,
        }]);
    }
    let skeleton = SkeletalModel::new(joints).expect("a skeleton");
    let character = Character::new(skeleton, attachments, mesh).expect("a character");
    let mut scene = Scene::new();
    let shape = CharacterShape::new(Arc::new(character));
    scene.add(NewShape::new("Box", ShapeKind::Character(shape)));
    scene
}

#[test]
fn the_floor_has_black_and_white_tiles_of_five_up_to_the_horizon() {
    on_each_backend(|gl| {
        let picture = draw(gl, &Scene::new(), &first_view(), Marks::default());
        assert_eq!(picture.at(200, 100), BACKGROUND);
        assert_eq!(picture.at(200, 148), BACKGROUND);
        // Seen from −Z, +X is to the left; a tile ends at x = 0, and one at z = 0 in row 271.
        let [nearest_left, nearest_right] = [(100, 290), (300, 290)].map(|(x, y)| picture.at(x, y));
        assert_eq!(nearest_left, [162, 162, 162, 255]);
        assert_eq!(nearest_right, [0, 0, 0, 255]);
        assert_eq!(picture.at(100, 240), [0, 0, 0, 255]);
        let [gray, ..] = picture.at(250, 240);
        assert!((155..170).contains(&gray), "{gray}");
        // Row 200 lies at z = 8.5, where x = 5 is in column 75.
        let [before, beyond] = [85, 65].map(|x| picture.at(x, 200)[0]);
        assert!(before > 100 && beyond == 0, "{before} {beyond}");
        // At the horizon tiles are smaller than pixels: even, not noise.
        let row = (50..350).map(|x| picture.at(x, 152)[0]);
        let (least, most) = (row.clone().min(), row.max());
        assert!(
            most.zip(least)
                .is_some_and(|(most, least)| most - least < 25)
        );
    });
}

#[test]
fn the_floor_hides_what_is_below_it_and_goes_with_the_ground_grid() {
    on_each_backend(|gl| {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        let placement = &mut scene.shape_mut(id).expect("the cube").placement;
        placement.transform.position = Vec3::new(0.0, -3.0, 2.0);
        let floor = draw(gl, &Scene::new(), &first_view(), Marks::default());
        assert!(draw(gl, &scene, &first_view(), Marks::default()) == floor);
        let without = ViewSettings {
            grid: false,
            ..first_view()
        };
        let picture = draw(gl, &scene, &without, Marks::default());
        assert_eq!(picture.at(100, 290), BACKGROUND);
        assert!(picture.count(|pixel| pixel != BACKGROUND) > 100);
    });
}

#[test]
fn surfaces_have_the_colors_of_their_normals() {
    on_each_backend(|gl| {
        let (mut scene, mut view) = (Scene::new(), first_view());
        scene.add(NewShape::new("Cube", ShapeKind::Cube));
        for (theta, color) in [
            (-FRAC_PI_2, [128, 128, 0, 255]),
            (FRAC_PI_2, [128, 128, 255, 255]),
            (0.0, [255, 128, 128, 255]),
        ] {
            view.camera.theta = theta;
            let found = draw(gl, &scene, &view, Marks::default()).at(200, 150);
            let apart = (0..4).map(|c| found[c].abs_diff(color[c])).max();
            assert!(apart <= Some(1), "{found:?} for {color:?}");
        }
    });
}

#[test]
fn bones_are_red_over_everything_and_cyan_under_the_pointer() {
    on_each_backend(|gl| {
        let mut scene = boxed_bones();
        let id = scene.shapes()[0].id;
        for mode in [
            ModelDisplay::Mesh,
            ModelDisplay::Both,
            ModelDisplay::Skeleton,
        ] {
            scene.character_mut(id).expect("the box").display.mode = mode;
            let picture = draw(gl, &scene, &first_view(), Marks::default());
            let bones = picture.count(|pixel| pixel == BONE);
            // Two pixels wide, with an edge of one on each side.
            assert!((80..120).contains(&bones), "{mode:?}: {bones}");
            let edge = picture.count(|[r, g, b, _]| r == 13 && g == 13 && b == 20);
            assert!(edge.abs_diff(bones) < 20, "{mode:?}: {edge} {bones}");
            let surface = picture.count(|[r, g, b, _]| r.abs_diff(g) < 2 && r > 120 && b == 0);
            assert_eq!(surface > 500, mode != ModelDisplay::Skeleton, "{mode:?}");
            let marks = Marks {
                selected: Some(id),
                hovered_joint: Some(1),
                ..Marks::default()
            };
            let marked = draw(gl, &scene, &first_view(), marks);
            let red = marked.count(|pixel| pixel == BONE);
            let cyan = marked.count(|pixel| pixel == HOVERED_BONE);
            assert!(
                red.abs_diff(cyan) <= 4 && red > 36,
                "{mode:?}: {red} {cyan}"
            );
        }
    });
}

#[test]
fn where_bones_are_hidden_those_of_shown_skeletons_and_the_one_under_the_pointer_are_seen() {
    on_each_backend(|gl| {
        let mut scene = boxed_bones();
        let id = scene.shapes()[0].id;
        let without = ViewSettings {
            bones: false,
            ..first_view()
        };
        let hovered = Marks {
            selected: Some(id),
            hovered_joint: Some(1),
            ..Marks::default()
        };
        for (mode, shown) in [
            (ModelDisplay::Mesh, false),
            (ModelDisplay::Both, true),
            (ModelDisplay::Skeleton, true),
        ] {
            scene.character_mut(id).expect("the box").display.mode = mode;
            let picture = draw(gl, &scene, &without, Marks::default());
            let bones = picture.count(|pixel| pixel == BONE);
            assert_eq!(bones > 0, shown, "{mode:?}: {bones}");
            let marked = draw(gl, &scene, &without, hovered.clone());
            let cyan = marked.count(|pixel| pixel == HOVERED_BONE);
            assert!(cyan > 36, "{mode:?}: {cyan}");
        }
    });
}
