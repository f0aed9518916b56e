//! Pictures on materials.

use std::sync::Arc;

use editor_core::character::{Attachments, Character, Influence, Joint, SkeletalModel};
use editor_core::geometry::{
    Corner, Material, MaterialGroup, Mesh, MeshBuilder, Picture as Image, SharedMesh,
};
use editor_core::gpu::Gl;
use editor_core::render::{Marks, Renderer};
use editor_core::scene::NewShape;
use editor_core::scene::{
    CharacterShape, Look, Scene, ShapeColor, ShapeKind, Skinning, ViewSettings,
};
use glam::{Vec2, Vec3};

use crate::offscreen::support::{Picture, draw_scene, on_each_backend};

const SIZE: (u32, u32) = (160, 120);
const CORNERS: [[u8; 4]; 4] = [
    [255, 0, 0, 255],
    [0, 255, 0, 255],
    [0, 0, 255, 255],
    [255, 255, 255, 255],
];

/// Red and green above, blue and white below, each a square of 8 by 8 pixels.
fn four_colors() -> Image {
    let pixel = |i: usize| CORNERS[(i / 16 / 8) * 2 + (i % 16) / 8];
    Image {
        width: 16,
        height: 16,
        rgba: (0..16 * 16).flat_map(pixel).collect(),
    }
}

fn of_one_color(color: [u8; 4]) -> Image {
    Image {
        width: 3,
        height: 5,
        rgba: color.repeat(15),
    }
}

/// A cube of side 1 with the whole picture on each side, `repeats` times across.
fn cube(image: Image, repeats: f32) -> Mesh {
    let mut builder = MeshBuilder::new();
    let corner = |i: u32| Vec3::from([0, 1, 2].map(|axis| ((i >> axis) & 1) as f32 - 0.5));
    builder.extend_positions((0..8).map(corner));
    // Lower left, lower right, upper right, upper left, seen from outside.
    let sides: [[u32; 4]; 6] = [
        [4, 5, 7, 6],
        [1, 0, 2, 3],
        [5, 1, 3, 7],
        [0, 4, 6, 2],
        [6, 7, 3, 2],
        [0, 1, 5, 4],
    ];
    let across = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    for side in sides {
        let corner = |i: usize| Corner {
            position: side[i],
            normal: None,
            texture: Some(across[i] * repeats),
        };
        builder.push_triangle([0, 1, 2].map(corner));
        builder.push_triangle([0, 2, 3].map(corner));
    }
    builder.push_group(MaterialGroup {
        triangles: 0..12,
        material: Material {
            name: "picture".to_owned(),
            color: Vec3::new(0.0, 0.5, 0.0),
            texture: Some(Arc::new(image)),
        },
    });
    builder.build()
}

fn scene_of(mesh: Mesh) -> Scene {
    let mut scene = Scene::new();
    let kind = ShapeKind::Mesh(SharedMesh::new(mesh));
    scene.add(NewShape::new("Cube", kind));
    scene
}

fn draw(gl: &Gl, scene: &Scene, look: Look, radius: f32, skinning: Skinning) -> Picture {
    let mut view = ViewSettings {
        axis: false,
        grid: false,
        look,
        ..ViewSettings::default()
    };
    view.camera.radius = radius;
    let mut renderer = Renderer::new(gl).expect("a renderer");
    renderer.set_skinning(Some(skinning));
    let picture = draw_scene(&mut renderer, gl, SIZE, scene, &view, Marks::default());
    assert_eq!(renderer.take_notices(), Vec::<String>::new());
    picture
}

/// Which of red, green and blue are strong at four points round the middle, as in `CORNERS`.
fn strong(picture: &Picture, above: u8) -> [[bool; 3]; 4] {
    [(65, 45), (95, 45), (65, 75), (95, 75)].map(|(x, y)| {
        let pixel = picture.at(x, y);
        [0, 1, 2].map(|c| pixel[c] > above)
    })
}

const AS_IN_THE_FILE: [[bool; 3]; 4] = [
    [true, false, false],
    [false, true, false],
    [false, false, true],
    [true, true, true],
];

#[test]
fn a_cube_shows_its_picture_upright_in_every_look() {
    on_each_backend(|gl| {
        let scene = scene_of(cube(four_colors(), 1.0));
        // The Mannequin look's light stands behind, so that 15 % are left.
        for (look, above) in [
            (Look::Course, 100),
            (Look::Studio, 100),
            (Look::Mannequin, 30),
        ] {
            let picture = draw(gl, &scene, look, 2.5, Skinning::Cpu);
            assert_eq!(strong(&picture, above), AS_IN_THE_FILE, "{look:?}");
        }
    });
}

#[test]
fn a_character_shows_its_picture_whoever_skins() {
    let joint = Joint {
        offset: Vec3::X,
        ..Joint::default()
    };
    let mut attachments = Attachments::new();
    for _ in 0..8 {
        attachments.push_vertex([Influence {
            joint: 0,
            weight: 1.0,
        }]);
    }
    let skeleton = SkeletalModel::new(vec![joint]).expect("a skeleton");
    let mesh = cube(four_colors(), 1.0);
    let character = Character::new(skeleton, attachments, mesh).expect("a character");
    let mut scene = Scene::new();
    let shape = CharacterShape::new(Arc::new(character));
    scene.add(NewShape::new("Cube", ShapeKind::Character(shape)));
    on_each_backend(|gl| {
        for skinning in [Skinning::Cpu, Skinning::Gpu] {
            let picture = draw(gl, &scene, Look::Course, 2.5, skinning);
            assert_eq!(strong(&picture, 100), AS_IN_THE_FILE, "{skinning:?}");
        }
    });
}

#[test]
fn a_picture_of_one_color_looks_as_a_material_of_that_color_and_is_tinted_by_the_shape() {
    on_each_backend(|gl| {
        for look in [Look::Course, Look::Studio] {
            let mut pictured = scene_of(cube(of_one_color([200, 100, 50, 255]), 1.0));
            let mut plain = cube(of_one_color([0; 4]), 1.0);
            plain.groups[0].material.texture = None;
            plain.groups[0].material.color = Vec3::new(200.0, 100.0, 50.0) / 255.0;
            let mut plain = scene_of(plain);
            for tint in [Vec3::ONE, Vec3::new(0.5, 1.0, 1.0)] {
                for scene in [&mut pictured, &mut plain] {
                    let id = scene.shapes()[0].id;
                    let shape = scene.shape_mut(id).expect("the cube");
                    shape.placement.color = ShapeColor::Custom(tint);
                }
                let [a, b] = [&pictured, &plain].map(|s| draw(gl, s, look, 2.5, Skinning::Cpu));
                let apart = a
                    .rgba
                    .iter()
                    .zip(&b.rgba)
                    .map(|(a, b)| a.abs_diff(*b))
                    .max();
                assert!(apart <= Some(1), "{look:?} {tint}: {apart:?}");
            }
        }
    });
}

#[test]
fn from_far_away_a_picture_that_repeats_is_even_and_not_noise() {
    on_each_backend(|gl| {
        let stripes = (0..16 * 16).flat_map(|i| [[0, 0, 0, 255], [255; 4]][i % 2]);
        let image = Image {
            width: 16,
            height: 16,
            rgba: stripes.collect(),
        };
        let scene = scene_of(cube(image, 20.0));
        let picture = draw(gl, &scene, Look::Course, 6.0, Skinning::Cpu);
        let middle = (74..86).map(|x| picture.at(x, 60)[0]);
        let (least, most) = (middle.clone().min(), middle.max());
        assert!(
            least > Some(60) && most < Some(160),
            "{least:?} to {most:?}"
        );
        assert!(
            most.zip(least)
                .is_some_and(|(most, least)| most - least < 12)
        );
    });
}

#[test]
fn a_picture_that_the_mesh_has_no_coordinates_for_is_left_out() {
    on_each_backend(|gl| {
        let mut mesh = cube(of_one_color([255, 0, 0, 255]), 1.0);
        mesh.texture_coordinates.clear();
        let picture = draw(gl, &scene_of(mesh), Look::Course, 2.5, Skinning::Cpu);
        let [red, green, ..] = picture.at(80, 60);
        assert!(green > 60 && red < 40, "{red} {green}");
    });
}
