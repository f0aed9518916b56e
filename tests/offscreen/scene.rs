//! Scenes drawn by the renderer that the window and the command line share.

use std::sync::Arc;

use editor_core::character::{Attachments, Character, Influence, Joint, Pose, SkeletalModel};
use editor_core::geometry::{Basis, Mesh};
use editor_core::gpu::Gl;
use editor_core::math::Euler;
use editor_core::render::{Marks, Renderer};
use editor_core::scene::NewShape;
use editor_core::scene::{
    BoneStyle, CharacterShape, CurveItemKind, CurveSet, CurveShape, CurveVisibility, JointStyle,
    Look, ModelDisplay, Scene, Shading, ShapeId, ShapeKind, SurfaceVisibility, ViewSettings,
};
use glam::Vec3;

use crate::offscreen::support::{Picture, draw_scene, on_each_backend};

const SIZE: (u32, u32) = (160, 120);
const BACKGROUND: [u8; 4] = [26, 26, 26, 255];

/// A beam of two bones along +X, whose far half follows joint 1.
fn beam() -> CharacterShape {
    let joint = |name: &str, parent, offset| Joint {
        name: name.to_owned(),
        parent,
        offset,
        ..Joint::default()
    };
    let skeleton = SkeletalModel::new(vec![
        joint("near", None, Vec3::new(-1.0, 0.0, 0.0)),
        joint("middle", Some(0), Vec3::X),
        joint("far", Some(1), Vec3::X),
    ]);
    let positions: Vec<Vec3> = [-1.0, 0.0, 1.0]
        .into_iter()
        .flat_map(|x| [Vec3::new(x, -0.2, 0.0), Vec3::new(x, 0.2, 0.0)])
        .collect();
    let triangles = vec![[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]];
    let mut attachments = Attachments::new();
    for position in &positions {
        let joint = u32::from(position.x > 0.5);
        attachments.push_vertex([Influence { joint, weight: 1.0 }]);
    }
    let character = Character::new(
        skeleton.expect("a skeleton"),
        attachments,
        Mesh::new(positions, triangles),
    );
    CharacterShape::new(Arc::new(character.expect("a character")))
}

fn scene_of(kind: ShapeKind) -> (Scene, ShapeId) {
    let mut scene = Scene::new();
    let id = scene.add(NewShape::new("Shape", kind));
    (scene, id)
}

fn no_axis() -> ViewSettings {
    ViewSettings {
        axis: false,
        ..ViewSettings::default()
    }
}

fn draw(
    gl: &Gl,
    renderer: &mut Renderer,
    scene: &Scene,
    view: &ViewSettings,
    marks: Marks,
) -> Picture {
    draw_scene(renderer, gl, SIZE, scene, view, marks)
}

fn drawn(picture: &Picture) -> usize {
    picture.count(|pixel| pixel != BACKGROUND)
}

#[test]
fn an_empty_scene_is_the_course_s_gray_and_nothing_else() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let picture = draw(
            gl,
            &mut renderer,
            &Scene::new(),
            &no_axis(),
            Marks::default(),
        );
        assert_eq!(drawn(&picture), 0);
    });
}

#[test]
fn every_shape_of_the_insert_menu_shows_in_its_own_color() {
    let kinds = [
        (ShapeKind::Cube, [true, false, false]),
        (ShapeKind::Sphere, [false, true, false]),
        (ShapeKind::Pyramid, [true, true, false]),
        (ShapeKind::Teapot, [false, false, true]),
        (ShapeKind::Icosahedron, [false, true, true]),
        (ShapeKind::Custom, [true, true, false]),
    ];
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        for (kind, color) in &kinds {
            let (scene, _) = scene_of(kind.clone());
            let picture = draw(gl, &mut renderer, &scene, &no_axis(), Marks::default());
            let in_color = picture.count(|pixel| {
                (0..3).all(|c| {
                    if color[c] {
                        pixel[c] > 60
                    } else {
                        pixel[c] < 20
                    }
                })
            });
            assert!(in_color > 300, "{}: {in_color} pixels", kind.label());
        }
    });
}

#[test]
fn the_axes_are_red_green_and_blue() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let mut view = ViewSettings::default();
        view.camera.theta = 1.0;
        view.camera.phi = 0.4;
        let picture = draw(gl, &mut renderer, &Scene::new(), &view, Marks::default());
        for axis in 0..3 {
            let line = picture.count(|pixel| (0..3).all(|c| (pixel[c] > 200) == (c == axis)));
            assert!(line > 50, "axis {axis}: {line} pixels");
        }
    });
}

#[test]
fn a_turned_joint_takes_its_part_of_the_mesh_along() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let (mut scene, id) = scene_of(ShapeKind::Character(beam()));
        let before = draw(gl, &mut renderer, &scene, &no_axis(), Marks::default());
        let mut pose = Pose::new();
        pose.set_joint_transform(1, Euler::from_degrees(Vec3::new(0.0, 0.0, 90.0)));
        scene
            .character_mut(id)
            .expect("the character")
            .set_pose(pose);
        let after = draw(gl, &mut renderer, &scene, &no_axis(), Marks::default());

        let (right, up) = ((100, 60), (80, 40));
        assert_ne!(before.at(right.0, right.1), BACKGROUND);
        assert_eq!(before.at(up.0, up.1), BACKGROUND);
        assert_eq!(after.at(right.0, right.1), BACKGROUND);
        assert_ne!(after.at(up.0, up.1), BACKGROUND);
    });
}

#[test]
fn a_skeleton_is_drawn_in_every_style_and_seen_through_its_mesh() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let (mut scene, id) = scene_of(ShapeKind::Character(beam()));
        let mut counts = Vec::new();
        // Near enough for boxes of a hundredth to cover pixels.
        let mut view = no_axis();
        view.camera.radius = 1.0;
        for mode in [ModelDisplay::Skeleton, ModelDisplay::Both] {
            for joints in [JointStyle::Points, JointStyle::Spheres] {
                for bones in [BoneStyle::Lines, BoneStyle::Boxes] {
                    let display = &mut scene.character_mut(id).expect("the character").display;
                    (display.mode, display.joints, display.bones) = (mode, joints, bones);
                    let picture = draw(gl, &mut renderer, &scene, &view, Marks::default());
                    // The mesh is green: red comes from the skeleton, through the mesh or not.
                    let white = picture.count(|[r, _, b, _]| r > 40 && r == b);
                    assert!(white > 20, "{mode:?} {joints:?} {bones:?}: {white} pixels");
                    counts.push(drawn(&picture));
                }
            }
        }
        assert!(
            counts[4..].iter().min() > counts[..4].iter().max(),
            "{counts:?}"
        );
    });
}

#[test]
fn joints_as_points_are_as_wide_as_told() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let (mut scene, id) = scene_of(ShapeKind::Character(beam()));
        let mut counts = Vec::new();
        for size in [4.0, 8.0, 16.0] {
            let display = &mut scene.character_mut(id).expect("the character").display;
            display.mode = ModelDisplay::Skeleton;
            (display.joints, display.point_size) = (JointStyle::Points, size);
            display.bones = BoneStyle::Lines;
            counts.push(drawn(&draw(
                gl,
                &mut renderer,
                &scene,
                &no_axis(),
                Marks::default(),
            )));
        }
        assert!(counts[0] < counts[1] && counts[1] < counts[2], "{counts:?}");
    });
}

#[test]
fn the_selected_shape_is_outlined_and_the_outline_is_no_part_of_the_picture_to_hand_in() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let (scene, id) = scene_of(ShapeKind::Cube);
        let plain = draw(gl, &mut renderer, &scene, &no_axis(), Marks::default());
        let marks = Marks {
            selected: Some(id),
            ..Marks::default()
        };
        let marked = draw(gl, &mut renderer, &scene, &no_axis(), marks);
        let orange = |picture: &Picture| {
            picture.count(|[r, g, b, _]| r > 250 && (140..180).contains(&g) && b < 60)
        };
        assert_eq!(orange(&plain), 0);
        assert!(orange(&marked) > 100, "{}", orange(&marked));
    });
}

#[test]
fn the_control_point_under_the_pointer_is_larger_than_the_others() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let curves = CurveSet::start_spline(Basis::Bezier);
        let (scene, id) = scene_of(ShapeKind::Curve(CurveShape::new(curves)));
        let mut yellow = |hovered_control_point| {
            let marks = Marks {
                selected: Some(id),
                hovered_control_point,
                ..Marks::default()
            };
            let picture = draw(gl, &mut renderer, &scene, &no_axis(), marks);
            picture.count(|[r, g, b, _]| r > 250 && g > 250 && b < 5)
        };
        let plain = yellow(None);
        let grown = yellow(Some((0, 1))) - plain;
        // A square of 11 pixels in the place of one of 5, and lines below both.
        assert!((80..=96).contains(&grown), "{grown}");
        assert_eq!(yellow(Some((0, 99))), plain);
    });
}

#[test]
fn looks_and_shadings_differ() {
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let (scene, _) = scene_of(ShapeKind::Sphere);
        let mut pictures = Vec::new();
        for look in [Look::Course, Look::Studio] {
            for shading in [Shading::Flat, Shading::Smooth] {
                let view = ViewSettings {
                    look,
                    shading,
                    ..no_axis()
                };
                pictures.push(draw(gl, &mut renderer, &scene, &view, Marks::default()).rgba);
            }
        }
        for a in 0..4 {
            for b in 0..a {
                assert_ne!(pictures[a], pictures[b], "{a} and {b}");
            }
        }
    });
}

#[test]
fn what_the_renderer_kept_from_other_frames_does_not_show() {
    on_each_backend(|gl| {
        let mut used = Renderer::new(gl).expect("a renderer");
        let (mut scene, id) = scene_of(ShapeKind::Character(beam()));
        let first = draw(gl, &mut used, &scene, &no_axis(), Marks::default());
        scene.character_mut(id).expect("the character").display.mode = ModelDisplay::Both;
        draw(
            gl,
            &mut used,
            &scene,
            &ViewSettings::default(),
            Marks::default(),
        );
        let (other, _) = scene_of(ShapeKind::Teapot);
        let used_picture = draw(gl, &mut used, &other, &no_axis(), Marks::default());
        let mut fresh = Renderer::new(gl).expect("a renderer");
        let fresh_picture = draw(gl, &mut fresh, &other, &no_axis(), Marks::default());
        assert!(used_picture == fresh_picture);
        assert!(first != fresh_picture);
    });
}

#[test]
fn lines_of_curves_follow_every_change() {
    let change = |shape: &mut CurveShape, step: usize| match step {
        0 => {}
        1 => shape.display.curve = CurveVisibility::OnWithFrames,
        2 => shape.display.surface = SurfaceVisibility::WireframeWithNormals,
        3 => shape.display.control_points = false,
        4 => {
            let moved = shape.curves().with_control_point(0, 1, Vec3::Y);
            shape.set_curves(moved.expect("a moved point"));
        }
        _ => shape.display.curve = CurveVisibility::Off,
    };
    on_each_backend(|gl| {
        let mut used = Renderer::new(gl).expect("a renderer");
        let mut curves = CurveSet::start_spline(Basis::Bezier);
        let surface = CurveItemKind::Revolution {
            steps: 12,
            profile: 0,
        };
        curves.push("surface", surface).expect("a surface");
        let (mut scene, id) = scene_of(ShapeKind::Curve(CurveShape::new(curves)));
        let mut before: Option<Picture> = None;
        for step in 0..6 {
            change(scene.curve_mut(id).expect("the curve"), step);
            for _ in 0..2 {
                let kept = draw(gl, &mut used, &scene, &no_axis(), Marks::default());
                let mut fresh = Renderer::new(gl).expect("a renderer");
                let fresh = draw(gl, &mut fresh, &scene, &no_axis(), Marks::default());
                assert!(kept == fresh, "step {step}");
                before = Some(fresh);
            }
            let shape = scene.shape_mut(id).expect("the curve");
            shape.placement.transform.position.x += 0.01;
            let moved = draw(gl, &mut used, &scene, &no_axis(), Marks::default());
            assert!(before.as_ref() != Some(&moved), "step {step}: it stays");
        }
    });
}

#[test]
fn what_is_hidden_leaves_no_trace_in_any_look() {
    let mut scene = Scene::new();
    let mut beam = beam();
    scene.add(NewShape::new("Cube", ShapeKind::Cube));
    for mode in [
        ModelDisplay::Mesh,
        ModelDisplay::Skeleton,
        ModelDisplay::Both,
    ] {
        beam.display.mode = mode;
        let kind = ShapeKind::Character(beam.clone());
        scene.add(NewShape::new("Beam", kind));
    }
    let curve = CurveShape::new(CurveSet::start_spline(Basis::Bezier));
    scene.add(NewShape::new("Curve", ShapeKind::Curve(curve)));
    let ids: Vec<ShapeId> = scene.shapes().iter().map(|shape| shape.id).collect();
    for &id in &ids {
        let shape = scene.shape_mut(id).expect("it was added");
        // The ground of the Studio look would lie below it.
        shape.placement.transform.position.y = -0.5;
        shape.visible = false;
    }
    on_each_backend(|gl| {
        let mut renderer = Renderer::new(gl).expect("a renderer");
        for look in [Look::Course, Look::Studio, Look::Mannequin] {
            let view = ViewSettings { look, ..no_axis() };
            let empty = draw(gl, &mut renderer, &Scene::new(), &view, Marks::default());
            for &id in &ids {
                let marks = Marks {
                    selected: Some(id),
                    hovered: Some(id),
                    selected_joint: Some(0),
                    hovered_joint: Some(1),
                    hovered_control_point: Some((0, 1)),
                    also_selected: ids.clone(),
                    ..Marks::default()
                };
                let picture = draw(gl, &mut renderer, &scene, &view, marks);
                assert!(picture == empty, "{look:?} {id}");
            }
        }
    });
}
