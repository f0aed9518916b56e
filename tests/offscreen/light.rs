//! Light, shading, materials and backdrops by numbers: single pixels whose colors follow from the
//! formulas of the looks.

use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

use editor_core::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
use editor_core::geometry::{
    Material, MaterialGroup, Mesh, Normals, Picture as Image, SharedMesh, cube,
};
use editor_core::gpu::Gl;
use editor_core::render::{Backdrop, Marks, Renderer};
use editor_core::scene::NewShape;
use editor_core::scene::{
    BoneStyle, CharacterShape, JointStyle, Look, ModelDisplay, Scene, Shading, ShapeColor,
    ShapeKind, Skinning, ViewSettings,
};
use glam::{Quat, Vec2, Vec3};

use crate::offscreen::support::{Picture, draw_before, draw_scene, on_each_backend};

/// Odd, so that the camera's target is in the middle of a pixel.
const SIZE: (u32, u32) = (41, 31);
const MIDDLE: (usize, usize) = (20, 15);
/// Position of the course's light.
const COURSE_LIGHT: Vec3 = Vec3::new(10.0, 10.0, 30.0);

fn view(look: Look) -> ViewSettings {
    let mut view = ViewSettings {
        axis: false,
        grid: false,
        look,
        ..ViewSettings::default()
    };
    view.camera.radius = 3.0;
    view
}

fn draw(gl: &Gl, scene: &Scene, view: &ViewSettings) -> Picture {
    let mut renderer = Renderer::new(gl).expect("a renderer");
    draw_scene(&mut renderer, gl, SIZE, scene, view, Marks::default())
}

/// The pixel that shows a point of the world.
fn pixel(picture: &Picture, view: &ViewSettings, world: Vec3) -> [u8; 4] {
    let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
    let at = view.camera.pixel(world, size).expect("in front of the eye");
    picture.at(at.x as usize, at.y as usize)
}

fn assert_near(found: [u8; 4], expected: [f32; 3], tolerance: f32, what: &str) {
    let apart = |c: usize| (f32::from(found[c]) - expected[c]).abs();
    assert!(
        (0..3).all(|c| apart(c) <= tolerance),
        "{what}: {found:?}, expected {expected:?}"
    );
}

/// A square about the origin in the plane perpendicular to `normal`, with a normal at each corner
/// if `has_normals`.
fn square(normal: Vec3, has_normals: bool) -> Mesh {
    let turn = Quat::from_rotation_arc(Vec3::Z, normal.try_normalize().expect("a direction"));
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let positions = corners.map(|(x, y)| turn * Vec3::new(x, y, 0.0)).to_vec();
    let mut mesh = Mesh::new(positions, vec![[0, 1, 2], [0, 2, 3]]);
    if has_normals {
        mesh.normals = Normals::PerVertex(vec![turn * Vec3::Z; 4]);
    }
    mesh
}

fn one_joint(mesh: Mesh) -> Character {
    let mut attachments = Attachments::new();
    for _ in &mesh.positions {
        attachments.push_vertex([Influence {
            joint: 0,
            weight: 1.0,
        }]);
    }
    let skeleton = SkeletalModel::new(vec![Joint::default()]).expect("a skeleton");
    Character::new(skeleton, attachments, mesh).expect("a character")
}

fn scene_of(kind: ShapeKind, color: Vec3, scale: Vec3) -> Scene {
    let mut scene = Scene::new();
    let id = scene.add(NewShape::new("Shape", kind));
    let placement = &mut scene.shape_mut(id).expect("the shape").placement;
    placement.color = ShapeColor::Custom(color);
    placement.transform.scale = scale;
    scene
}

/// The course's Phong light: ambient 0.2, diffuse 0.8 and highlights of 0.4 to the power of 32,
/// which are seen from the world's origin.
fn course_color(surface: Vec3, position: Vec3, normal: Vec3) -> [f32; 3] {
    let normal = normal.try_normalize().expect("a normal");
    let light = (COURSE_LIGHT - position).try_normalize().expect("a light");
    let mirrored = 2.0 * normal.dot(light) * normal - light;
    let eye = (-position).try_normalize().unwrap_or(Vec3::ZERO);
    let shine = 0.4 * eye.dot(mirrored).max(0.0).powi(32);
    let color = surface * (0.2 + 0.8 * normal.dot(light).max(0.0)) + Vec3::splat(shine);
    (255.0 * color.min(Vec3::ONE)).to_array()
}

#[test]
fn an_unevenly_scaled_surface_is_lit_by_the_direction_that_it_then_has() {
    let color = Vec3::new(0.9, 0.6, 0.3);
    on_each_backend(|gl| {
        for skinning in [Skinning::Cpu, Skinning::Gpu] {
            let mut renderer = Renderer::new(gl).expect("a renderer");
            renderer.set_skinning(Some(skinning));
            for (normal, scale) in [
                (Vec3::new(1.0, 0.0, 1.0), Vec3::new(4.0, 1.0, 1.0)),
                (Vec3::new(-1.0, 0.5, 1.0), Vec3::new(0.5, 3.0, 1.0)),
                (Vec3::new(0.5, -1.0, 1.0), Vec3::new(1.0, 1.0, 3.0)),
            ] {
                for (shading, has_normals) in [
                    (Shading::AsAuthored, true),
                    (Shading::AsAuthored, false),
                    (Shading::Smooth, false),
                    (Shading::Flat, true),
                ] {
                    let mesh = square(normal, has_normals);
                    // Where the plane lies then, from two of its edges.
                    let [a, b, c] = [0, 1, 2].map(|i| mesh.positions[i] * scale);
                    let direction = (b - a).cross(c - a);
                    let kind = ShapeKind::Character(CharacterShape::new(Arc::new(one_joint(mesh))));
                    let scene = scene_of(kind, color, scale);
                    let view = ViewSettings {
                        shading,
                        ..view(Look::Course)
                    };
                    let marks = Marks::default();
                    let picture = draw_scene(&mut renderer, gl, SIZE, &scene, &view, marks);
                    assert_near(
                        picture.at(MIDDLE.0, MIDDLE.1),
                        course_color(color, Vec3::ZERO, direction),
                        1.0,
                        &format!("{skinning:?} {shading:?} {has_normals} {normal} {scale}"),
                    );
                }
            }
        }
    });
}

#[test]
fn a_joint_s_sphere_has_its_size_and_is_lit_as_the_ellipsoid_that_uneven_scale_makes_of_it() {
    // A sphere of radius 0.02 in the character's space.
    let scale = Vec3::new(10.0, 30.0, 10.0);
    let half = scale * 0.02;
    let kind = |mesh| {
        let mut shape = CharacterShape::new(Arc::new(one_joint(mesh)));
        shape.display.mode = ModelDisplay::Skeleton;
        (shape.display.joints, shape.display.bones) = (JointStyle::Spheres, BoneStyle::Lines);
        ShapeKind::Character(shape)
    };
    on_each_backend(|gl| {
        let scene = scene_of(kind(square(Vec3::Z, true)), Vec3::X, scale);
        let view = view(Look::Course);
        let picture = draw(gl, &scene, &view);
        for y in [-0.3_f32, 0.0, 0.3] {
            let z = half.z * (1.0 - (y / half.y).powi(2)).sqrt();
            let at = Vec3::new(0.0, y, z);
            // The gradient of x²/a² + y²/b² + z²/c².
            let normal = at / (half * half);
            let expected = course_color(Vec3::ONE, at, normal);
            assert_near(pixel(&picture, &view, at), expected, 12.0, &format!("{y}"));
        }
        let white = picture.count(|pixel| pixel != [26, 26, 26, 255]) as f32;
        // An ellipse as large in pixels as it is from this far.
        let pixels_per_unit = 31.0 / (2.0 * (45.0_f32.to_radians() / 2.0).tan() * 3.0);
        let area = std::f32::consts::PI * half.x * half.y * pixels_per_unit.powi(2);
        assert!((white / area - 1.0).abs() < 0.15, "{white} of {area}");
    });
}

/// Stored values of a gray of a half, or black, in the Studio look, worked out from its lights: key
/// (−0.55, 0.8, 0.75), fill (0.9, 0.25, 0.6), rim (0.35, 0.7, −0.9), with (0.95, 0.91, 0.85),
/// (0.2, 0.24, 0.3), (0.42, 0.46, 0.52) and highlights of 0.1, 0.03, 0.12 to the power of 48; a sky
/// from (0.1, 0.095, 0.09) below to (0.26, 0.28, 0.31) above; gamma 2.2; seen along −Z.
const STUDIO: [([f32; 3], f32, [f32; 3]); 6] = [
    ([0.0, 0.0, 1.0], 0.5, [119.8, 120.1, 120.6]),
    ([-0.5, 0.2, 0.8], 0.5, [132.0, 130.7, 128.7]),
    ([0.9, -0.2, 0.3], 0.5, [77.9, 81.9, 87.7]),
    ([0.0, -0.6, 0.8], 0.5, [72.0, 72.9, 74.5]),
    ([0.2, 0.9, 0.4], 0.5, [141.1, 142.6, 144.8]),
    ([-0.125, 0.182, 0.949], 0.0, [49.4, 48.4, 47.0]),
];

#[test]
fn the_studio_s_lights_come_from_their_sides_and_turn_with_the_camera() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        for (normal, gray, expected) in STUDIO {
            for quarter in 0..2 {
                let mut view = view(Look::Studio);
                view.camera.theta += quarter as f32 * FRAC_PI_2;
                let turn = Quat::from_rotation_y(quarter as f32 * -FRAC_PI_2);
                // Both sides are lit as the one that is seen.
                for side in [1.0, -1.0] {
                    let mesh = square(turn * Vec3::from(normal) * side, true);
                    let kind = ShapeKind::Mesh(SharedMesh::new(mesh));
                    let scene = scene_of(kind, Vec3::splat(gray), Vec3::ONE);
                    let marks = Marks::default();
                    let picture = draw_scene(&mut renderer, gl, SIZE, &scene, &view, marks);
                    let what = format!("{normal:?}, side {side}, quarter {quarter}");
                    assert_near(picture.at(MIDDLE.0, MIDDLE.1), expected, 1.0, &what);
                }
            }
        }
    });
}

/// A square with a white picture on it.
fn white_square(normal: Vec3) -> Mesh {
    let mut mesh = square(normal, true);
    mesh.texture_coordinates = vec![Vec2::ZERO; 4];
    mesh.groups = vec![MaterialGroup {
        triangles: 0..2,
        material: Material {
            name: "white".to_owned(),
            color: Vec3::X,
            texture: Some(Arc::new(Image {
                width: 1,
                height: 1,
                rgba: vec![255; 4],
            })),
        },
    }];
    mesh
}

#[test]
fn the_mannequin_s_light_stands_behind_and_pictures_keep_15_percent_without_it() {
    on_each_backend(|gl| {
        for (normal, expected) in [
            (Vec3::Z, 0.15),
            // Towards (−10, 10, −10) by 18 of √300 · √2.04.
            (
                Vec3::new(-1.0, 1.0, 0.2),
                0.15 + 18.0 / (300.0_f32 * 2.04).sqrt(),
            ),
        ] {
            let kind = ShapeKind::Mesh(SharedMesh::new(white_square(normal)));
            let scene = scene_of(kind, Vec3::ONE, Vec3::ONE);
            let picture = draw(gl, &scene, &view(Look::Mannequin));
            let expected = [255.0 * expected; 3];
            assert_near(
                picture.at(MIDDLE.0, MIDDLE.1),
                expected,
                1.0,
                &format!("{normal}"),
            );
        }
    });
}

#[test]
fn materials_and_pictures_are_tinted_and_triangles_of_no_material_have_the_shape_s_color() {
    let tint = Vec3::new(0.5, 1.0, 0.25);
    let material = Vec3::new(0.8, 0.4, 0.6);
    let mut mesh = square(Vec3::Z, true);
    mesh.groups = vec![MaterialGroup {
        // The lower right triangle.
        triangles: 0..1,
        material: Material {
            name: "first".to_owned(),
            color: material,
            texture: None,
        },
    }];
    on_each_backend(|gl| {
        let kind = |mesh: &Mesh| ShapeKind::Mesh(SharedMesh::new(mesh.clone()));
        let view = view(Look::Course);
        let picture = draw(gl, &scene_of(kind(&mesh), tint, Vec3::ONE), &view);
        for (at, surface) in [
            (Vec3::new(0.3, -0.3, 0.0), material * tint),
            (Vec3::new(-0.3, 0.3, 0.0), tint),
        ] {
            let expected = course_color(surface, at, Vec3::Z);
            assert_near(pixel(&picture, &view, at), expected, 2.0, &format!("{at}"));
        }
        let scene = scene_of(kind(&white_square(Vec3::Z)), tint, Vec3::ONE);
        let expected = course_color(tint, Vec3::ZERO, Vec3::Z);
        let found = draw(gl, &scene, &view).at(MIDDLE.0, MIDDLE.1);
        assert_near(found, expected, 1.0, "a white picture");
    });
}

#[test]
fn only_the_nearest_surface_of_a_mesh_covers_its_skeleton_and_the_background_by_55_percent() {
    on_each_backend(|gl| {
        let view = view(Look::Course);
        let mut shape = CharacterShape::new(Arc::new(one_joint(cube())));
        let mut found = [ModelDisplay::Mesh, ModelDisplay::Both].map(|mode| {
            shape.display.mode = mode;
            let kind = ShapeKind::Character(shape.clone());
            let picture = draw(gl, &scene_of(kind, Vec3::X, Vec3::ONE), &view);
            // Beside the joint in the middle.
            pixel(&picture, &view, Vec3::new(0.3, 0.3, 0.5)).map(f32::from)
        });
        let [solid, through] = &mut found;
        let expected = solid.map(|c| 0.55 * c + 0.45 * 26.0);
        let through = through.map(|c| c as u8);
        assert_near(
            through,
            [expected[0], expected[1], expected[2]],
            1.0,
            "seen through",
        );
    });
}

#[test]
fn the_studio_s_background_is_bright_above_and_dark_below() {
    on_each_backend(|gl| {
        let picture = draw(gl, &Scene::new(), &view(Look::Studio));
        for x in [0, 20, 40] {
            let (top, bottom) = (picture.at(x, 0), picture.at(x, 30));
            // 0.30, 0.33, 0.37 and 0.12, 0.13, 0.15 of 255.
            assert_near(top, [76.5, 84.15, 94.35], 1.0, "top");
            assert_near(bottom, [30.6, 33.15, 38.25], 1.0, "bottom");
            let middle = picture.at(x, 15);
            assert_near(middle, [53.5, 58.6, 66.3], 1.0, "middle");
        }
    });
}

#[test]
fn x_is_red_y_is_green_and_z_is_blue_to_both_sides() {
    on_each_backend(|gl| {
        let mut view = view(Look::Course);
        view.axis = true;
        (view.camera.theta, view.camera.phi) = (1.0, 0.5);
        let picture = draw(gl, &Scene::new(), &view);
        for (axis, color) in [
            (Vec3::X, [255, 0, 0, 255]),
            (Vec3::Y, [0, 255, 0, 255]),
            (Vec3::Z, [0, 0, 255, 255]),
        ] {
            for along in [-0.7, 0.7] {
                // A line of one pixel: one of the pixels round the point has it.
                let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
                let at = view.camera.pixel(axis * along, size).expect("in view");
                let (x, y) = (at.x as usize, at.y as usize);
                let around = (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| (x, y)));
                let has_it = around.into_iter().any(|(x, y)| picture.at(x, y) == color);
                assert!(has_it, "{axis} {along}");
            }
        }
    });
}

/// The Studio look's ground, from above or below, without anything on it.
fn ground(gl: &Gl, phi: f32, target: Vec3, grid: bool) -> (Picture, ViewSettings) {
    let mut view = ViewSettings {
        grid,
        ..view(Look::Studio)
    };
    (view.camera.phi, view.camera.radius, view.camera.target) = (phi, 20.0, target);
    (draw(gl, &Scene::new(), &view), view)
}

#[test]
fn the_ground_is_lit_round_the_target_and_only_seen_from_above() {
    on_each_backend(|gl| {
        let between_lines = Vec3::new(0.5, 0.0, 0.5);
        for (phi, is_lit) in [(1.2, true), (-1.2, false)] {
            let (with, view) = ground(gl, phi, Vec3::ZERO, true);
            let (without, _) = ground(gl, phi, Vec3::ZERO, false);
            let [lit, plain] = [with, without].map(|p| pixel(&p, &view, between_lines)[0]);
            assert_eq!(lit.abs_diff(plain) > 20, is_lit, "{phi}: {lit} {plain}");
        }
        // The grid repeats after ten units, and the light goes with the target.
        let here = ground(gl, 0.9, Vec3::ZERO, true).0;
        for target in [Vec3::X * 10.0, Vec3::Z * -20.0] {
            let there = ground(gl, 0.9, target, true).0;
            let pairs = here.rgba.iter().zip(&there.rgba);
            let apart = pairs.filter(|(a, b)| a.abs_diff(**b) > 3).count();
            assert!(apart < 20, "{target}: {apart}");
        }
    });
}

#[test]
fn every_tenth_line_of_the_ground_is_stronger() {
    on_each_backend(|gl| {
        let mut view = view(Look::Studio);
        (view.grid, view.camera.phi, view.camera.radius) = (true, 1.4, 5.0);
        view.camera.target = Vec3::new(9.5, 0.0, 0.5);
        let picture = draw(gl, &Scene::new(), &view);
        let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
        let column = |x: f32| {
            let at = view.camera.pixel(Vec3::new(x, 0.0, 0.5), size);
            at.expect("in view").x as usize
        };
        // How much brighter the pixels round a line are than those between lines.
        let between = u32::from(picture.at(column(9.5), MIDDLE.1)[0]);
        let excess = |x: f32| {
            let pixels = column(x) - 2..=column(x) + 2;
            let sum: u32 = pixels.map(|x| u32::from(picture.at(x, MIDDLE.1)[0])).sum();
            sum.saturating_sub(5 * between)
        };
        // 0.6 to 0.35, and lines so close together are fainter by a quarter.
        let (tenth, ninth) = (excess(10.0) as f32, excess(9.0) as f32);
        assert!((1.8..3.0).contains(&(tenth / ninth)), "{tenth} {ninth}");
    });
}

#[test]
fn the_ground_fades_towards_the_far_plane() {
    on_each_backend(|gl| {
        let [with, without] = [true, false].map(|grid| {
            let mut view = ViewSettings {
                grid,
                ..view(Look::Studio)
            };
            (view.camera.phi, view.camera.radius) = (1.5, 10.0);
            (view.camera.far, view.camera.fovy) = (12.0, 2.2);
            (draw(gl, &Scene::new(), &view), view)
        });
        // The line at a distance of 10 of 12: 0.14 are left of it.
        let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
        let line = Vec3::new(10.0, 0.0, 0.0);
        let at = with.1.camera.pixel(line, size).expect("in view");
        let (x, y) = (at.x as usize, at.y as usize);
        let excess = (x - 1..=x + 1).map(|x| with.0.at(x, y)[0].abs_diff(without.0.at(x, y)[0]));
        let excess = excess.max().expect("three pixels");
        assert!((2..=22).contains(&excess), "{excess}");
    });
}

#[test]
fn the_ground_hides_what_is_below_it_from_above_and_not_from_below() {
    on_each_backend(|gl| {
        // The first says where the ground is; the second hangs below it once it is posed.
        let mut scene = scene_of(ShapeKind::Cube, Vec3::ONE, Vec3::ONE);
        let mut hanging = CharacterShape::new(Arc::new(one_joint(cube())));
        let mut pose = Pose::new();
        pose.set_root_offset(0, Vec3::Y * -3.0);
        hanging.set_pose(pose);
        let kind = ShapeKind::Character(hanging);
        let id = scene.add(NewShape::new("Hanging", kind));
        for (phi, is_hidden) in [(0.5, true), (1.2, true), (-0.5, false)] {
            let mut view = ViewSettings {
                grid: true,
                ..view(Look::Studio)
            };
            (view.camera.phi, view.camera.radius) = (phi, 9.0);
            let mut drawn = |visible| {
                scene.shape_mut(id).expect("the shape").visible = visible;
                draw(gl, &scene, &view)
            };
            let (with, without) = (drawn(true), drawn(false));
            let pairs = with.rgba.chunks_exact(4).zip(without.rgba.chunks_exact(4));
            let apart = pairs.filter(|(a, b)| (0..3).any(|c| a[c].abs_diff(b[c]) > 2));
            let apart = apart.count();
            assert_eq!(apart == 0, is_hidden, "{phi}: {apart} pixels");
        }
    });
}

#[test]
fn the_ground_ends_in_the_background_without_an_edge() {
    on_each_backend(|gl| {
        for backdrop in [Backdrop::Dark, Backdrop::Light] {
            let [with, without] = [true, false].map(|grid| {
                let mut view = ViewSettings {
                    grid,
                    ..view(Look::Studio)
                };
                // The horizon is near the top.
                (view.camera.phi, view.camera.radius) = (0.3, 5.0);
                let frame = (&Scene::new(), &view, backdrop);
                let mut renderer = Renderer::new(gl).expect("a renderer");
                draw_before(&mut renderer, gl, (160, 120), frame)
            });
            for x in [3, 60, 150] {
                let apart = |y: usize| {
                    let (a, b) = (with.at(x, y), without.at(x, y));
                    (0..3).map(|c| a[c].abs_diff(b[c])).max()
                };
                // At the end of the ground, which rises slowly from there on.
                let horizon = (0..120).find(|&y| apart(y) > Some(0));
                let horizon = horizon.expect("there is a ground");
                assert!((8..30).contains(&horizon), "{horizon}");
                assert!(apart(horizon) <= Some(8), "{:?}", apart(horizon));
            }
        }
    });
}

#[test]
fn the_light_backdrop_is_light_and_lines_and_bones_stand_out_from_both() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let mut character = CharacterShape::new(Arc::new(one_joint(square(Vec3::Z, true))));
        character.display.mode = ModelDisplay::Skeleton;
        let scene = scene_of(ShapeKind::Character(character), Vec3::ONE, Vec3::splat(8.0));
        for (backdrop, brightness) in [
            (Backdrop::Dark, 40.0..110.0),
            (Backdrop::Light, 200.0..250.0),
        ] {
            let mut view = ViewSettings {
                grid: true,
                ..view(Look::Studio)
            };
            view.camera.phi = 0.5;
            let frame = (&scene, &view, backdrop);
            let picture = draw_before(&mut renderer, gl, SIZE, frame);
            let mut sorted: Vec<u8> = picture.rgba.chunks_exact(4).map(|pixel| pixel[1]).collect();
            sorted.sort_unstable();
            let median = f32::from(sorted[sorted.len() / 2]);
            assert!(brightness.contains(&median), "{backdrop:?}: {median}");
            // The joint's sphere lies over the ground.
            let joint = f32::from(picture.at(MIDDLE.0, MIDDLE.1)[1]);
            assert!(
                (joint - median).abs() > 60.0,
                "{backdrop:?}: {joint} {median}"
            );
            // The lines of the grid are among the brightest, or the darkest.
            let line = match backdrop {
                Backdrop::Dark => f32::from(sorted[sorted.len() * 97 / 100]),
                Backdrop::Light => f32::from(sorted[sorted.len() * 3 / 100]),
            };
            assert!(
                (line - median).abs() > 20.0,
                "{backdrop:?}: {line} {median}"
            );
        }
    });
}

#[test]
fn a_surface_of_one_pure_color_keeps_its_shading_in_the_studio() {
    on_each_backend(|gl| {
        for color in [
            Vec3::X,
            Vec3::Y,
            Vec3::Z,
            Vec3::new(1.0, 1.0, 0.0),
            Vec3::ONE,
        ] {
            let scene = scene_of(ShapeKind::Sphere, color, Vec3::ONE);
            let mut view = view(Look::Studio);
            view.camera.radius = 1.5;
            let mut renderer = Renderer::new(gl).expect("a renderer");
            let size = (160, 160);
            let marks = Marks::default();
            let picture = draw_scene(&mut renderer, gl, size, &scene, &view, marks);
            // From the side of the key light to the other, as far as the sphere reaches.
            let mut found: Vec<[u8; 4]> = Vec::new();
            for step in -9..=9 {
                let at = (80 + step * 5, 80 + step * 3);
                found.push(picture.at(at.0 as usize, at.1 as usize));
            }
            let sum = |pixel: &[u8; 4]| (0..3).map(|c| u32::from(pixel[c])).sum::<u32>();
            let most = found.iter().map(sum).max().expect("pixels");
            let least = found.iter().map(sum).min().expect("pixels");
            assert!(most - least > 100, "{color}: {least} to {most}");
            // No two places along the way look the same, as where light is cut off.
            let flat = found.windows(2).filter(|pair| pair[0] == pair[1]).count();
            assert!(flat <= 2, "{color}: {found:?}");
            // The color is still the shape's.
            let middle = found[found.len() / 2];
            let strongest = (0..3).map(|c| middle[c]).max();
            for channel in 0..3 {
                let is_strong = color[channel] > 0.5;
                let value = middle[channel];
                assert_eq!(
                    Some(value) > strongest.map(|s| s / 2),
                    is_strong,
                    "{middle:?}"
                );
            }
        }
    });
}

#[test]
fn looks_without_a_ground_do_not_draw_the_studio_s() {
    on_each_backend(|gl| {
        let scene = scene_of(ShapeKind::Cube, Vec3::ONE, Vec3::ONE);
        let [with, without] = [true, false].map(|grid| {
            let view = ViewSettings {
                grid,
                ..view(Look::Course)
            };
            draw(gl, &scene, &view)
        });
        assert!(with == without);
    });
}
