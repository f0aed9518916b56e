//! Marks of the editor, skeletons and curves, pixel by pixel.

use std::sync::Arc;

use editor_core::character::{Attachments, Character, Influence, Joint, SkeletalModel};
use editor_core::geometry::{Basis, Mesh, cube};
use editor_core::gpu::Gl;
use editor_core::render::{Marks, Renderer};
use editor_core::scene::NewShape;
use editor_core::scene::{
    BoneStyle, CharacterShape, CurveItemKind, CurveSet, CurveShape, CurveVisibility, Evaluator,
    JointStyle, Look, ModelDisplay, Scene, ShapeColor, ShapeId, ShapeKind, SurfaceVisibility,
    ViewSettings,
};
use glam::{Vec2, Vec3};

use crate::offscreen::support::{Picture, WHITE, draw_scene, on_each_backend};

/// Odd, so that the camera's target is in the middle of a pixel.
const SIZE: (u32, u32) = (161, 121);
const BACKGROUND: [u8; 4] = [26, 26, 26, 255];
const YELLOW: [u8; 4] = [255, 255, 0, 255];

fn view() -> ViewSettings {
    let mut view = ViewSettings {
        axis: false,
        ..ViewSettings::default()
    };
    view.camera.radius = 3.0;
    view
}

fn draw(gl: &Gl, scene: &Scene, marks: Marks) -> Picture {
    let mut renderer = Renderer::new(gl).expect("a renderer");
    draw_scene(&mut renderer, gl, SIZE, scene, &view(), marks)
}

fn is_selected_outline([r, g, b, _]: [u8; 4]) -> bool {
    r > 250 && (150..170).contains(&g) && b < 40
}

fn is_hovered_outline([r, g, b, _]: [u8; 4]) -> bool {
    (210..225).contains(&r) && (220..230).contains(&g) && b > 230
}

fn selected(id: ShapeId) -> Marks {
    Marks {
        selected: Some(id),
        ..Marks::default()
    }
}

/// Whether a pixel at most one away from a point of the world is of this kind.
fn has(picture: &Picture, world: Vec3, kind: impl Fn([u8; 4]) -> bool) -> bool {
    let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
    let at = view().camera.pixel(world, size).expect("in view");
    let (x, y) = (at.x as usize, at.y as usize);
    (x - 1..=x + 1).any(|x| (y - 1..=y + 1).any(|y| kind(picture.at(x, y))))
}

#[test]
fn the_outline_of_a_single_pixel_is_a_disc_of_twelve_pixels_round_it() {
    on_each_backend(|gl| {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        let placement = &mut scene.shape_mut(id).expect("the cube").placement;
        placement.transform.scale = Vec3::splat(0.01);
        let plain = draw(gl, &scene, Marks::default());
        assert_eq!(plain.count(|pixel| pixel != BACKGROUND), 1);
        let marked = draw(gl, &scene, selected(id));
        assert_eq!(marked.count(is_selected_outline), 12);
        assert!(is_selected_outline(marked.at(82, 60)) && is_selected_outline(marked.at(80, 58)));
        assert!(!is_selected_outline(marked.at(83, 60)) && !is_selected_outline(marked.at(82, 58)));
    });
}

#[test]
fn an_outline_is_two_pixels_wide_in_pictures_up_to_800_high_and_four_beyond() {
    on_each_backend(|gl| {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        for (height, width_of_line) in [(600, 2), (801, 4)] {
            let mut renderer = Renderer::new(gl).expect("a renderer");
            let mut view = view();
            view.camera.radius = 60.0;
            let size = (41, height);
            let picture = draw_scene(&mut renderer, gl, size, &scene, &view, selected(id));
            let row = height as usize / 2;
            let left = (0..20).filter(|&x| is_selected_outline(picture.at(x, row)));
            assert_eq!(left.count(), width_of_line, "{height}");
        }
    });
}

#[test]
fn the_pointer_s_outline_is_bright_and_gives_way_to_the_selection_s() {
    on_each_backend(|gl| {
        let mut scene = Scene::new();
        let [one, other] =
            ["one", "other"].map(|name| scene.add(NewShape::new(name, ShapeKind::Cube)));
        let hovered = Marks {
            hovered: Some(other),
            ..Marks::default()
        };
        let picture = draw(gl, &scene, hovered.clone());
        let (bright, orange) = (
            picture.count(is_hovered_outline),
            picture.count(is_selected_outline),
        );
        assert!(bright > 100 && orange == 0, "{bright} {orange}");
        let both = Marks {
            selected: Some(one),
            ..hovered
        };
        // The two shapes cover the same pixels.
        let picture = draw(gl, &scene, both);
        assert_eq!(picture.count(is_hovered_outline), 0);
        assert_eq!(picture.count(is_selected_outline), bright);
    });
}

#[test]
fn outlines_fit_pictures_of_one_width_and_several_heights() {
    on_each_backend(|gl| {
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        let mut kept = Renderer::new(gl).expect("a renderer");
        for height in [30, 60, 45] {
            let mut fresh = Renderer::new(gl).expect("a renderer");
            let [a, b] = [&mut kept, &mut fresh].map(|renderer| {
                draw_scene(renderer, gl, (40, height), &scene, &view(), selected(id))
            });
            assert!(a == b, "{height}");
        }
    });
}

/// Two bones of a half, upwards from the origin, with a cube as its mesh.
fn stick() -> CharacterShape {
    let joint = |parent, y| Joint {
        parent,
        offset: Vec3::Y * y,
        ..Joint::default()
    };
    let joints = vec![joint(None, 0.0), joint(Some(0), 0.5), joint(Some(1), 0.5)];
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
    let mut shape = CharacterShape::new(Arc::new(character));
    shape.display.mode = ModelDisplay::Skeleton;
    shape
}

fn skeleton_scene(bones: BoneStyle, line_width: f32) -> (Scene, ShapeId) {
    let mut shape = stick();
    (shape.display.bones, shape.display.joints) = (bones, JointStyle::Points);
    (shape.display.point_size, shape.display.line_width) = (1.0, line_width);
    let mut scene = Scene::new();
    let id = scene.add(NewShape::new("Stick", ShapeKind::Character(shape)));
    (scene, id)
}

#[test]
fn bones_are_lines_of_their_width_or_boxes_of_their_size() {
    let across = |picture: &Picture| {
        let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
        let at = view().camera.pixel(Vec3::Y * 0.25, size).expect("in view");
        (0..SIZE.0 as usize)
            .filter(|&x| picture.at(x, at.y as usize) != BACKGROUND)
            .count()
    };
    on_each_backend(|gl| {
        for width in [1.0, 3.0, 6.0] {
            let (scene, _) = skeleton_scene(BoneStyle::Lines, width);
            let found = across(&draw(gl, &scene, Marks::default()));
            assert_eq!(found, width as usize);
        }
        // Twice the half width of 0.01, thirty times as large across: 0.6 wide, 0.3 nearer.
        let (mut scene, id) = skeleton_scene(BoneStyle::Boxes, 1.0);
        let placement = &mut scene.shape_mut(id).expect("the stick").placement;
        placement.transform.scale = Vec3::new(30.0, 1.0, 1.0);
        let found = across(&draw(gl, &scene, Marks::default())) as f32;
        let pixels_per_unit = 121.0 / (2.0 * (45.0_f32.to_radians() / 2.0).tan() * 2.99);
        let expected = 0.02 * 30.0 * pixels_per_unit;
        assert!((found - expected).abs() < 1.5, "{found} of {expected}");
    });
}

#[test]
fn the_bone_of_the_selected_joint_is_orange_and_that_under_the_pointer_cyan() {
    on_each_backend(|gl| {
        for style in [BoneStyle::Lines, BoneStyle::Boxes] {
            let (scene, id) = skeleton_scene(style, 3.0);
            let marks = Marks {
                selected_joint: Some(0),
                hovered_joint: Some(1),
                ..selected(id)
            };
            let picture = draw(gl, &scene, marks.clone());
            let is_orange = |[r, g, b, _]: [u8; 4]| r > g.saturating_add(30) && g > b;
            let is_cyan = |[r, g, b, _]: [u8; 4]| b > g && g > r.saturating_add(60);
            // In the middle of the bones, which the outline goes round.
            let colors = |picture: &Picture| {
                [0.25, 0.75].map(|y| {
                    let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
                    let at = view().camera.pixel(Vec3::Y * y, size).expect("in view");
                    picture.at(at.x as usize, at.y as usize)
                })
            };
            let [lower, upper] = colors(&picture);
            assert!(
                is_orange(lower) && is_cyan(upper),
                "{style:?} {lower:?} {upper:?}"
            );
            // Joints of other shapes than the selected one are not marked.
            let marks = Marks {
                selected: None,
                ..marks
            };
            let [lower, upper] = colors(&draw(gl, &scene, marks));
            assert!(
                lower[0] == lower[2] && upper[0] == upper[2],
                "{lower:?} {upper:?}"
            );
        }
    });
}

#[test]
fn a_selected_skeleton_and_a_selected_curve_are_outlined_where_they_are() {
    let curve = CurveShape::new(CurveSet::start_spline(Basis::Bezier));
    on_each_backend(|gl| {
        let (skeleton, stick) = skeleton_scene(BoneStyle::Boxes, 1.0);
        let mut curves = Scene::new();
        let wire = curves.add(NewShape::new("Wire", ShapeKind::Curve(curve.clone())));
        for (mut scene, id) in [(skeleton, stick), (curves, wire)] {
            for x in [0.0, 0.5] {
                let placement = &mut scene.shape_mut(id).expect("the shape").placement;
                placement.transform.position.x = x;
                let evaluated = Evaluator::new().evaluate(&scene, 0.0);
                let geometry = &evaluated.shapes[0].geometry;
                let middle = match &geometry.curves {
                    Some(curves) => {
                        let points = &curves.curves[0].points;
                        points[points.len() / 2].position
                    }
                    None => Vec3::Y * 0.75,
                } + Vec3::X * x;
                let picture = draw(gl, &scene, selected(id));
                let nearby = [-0.06, 0.06].map(|d| Vec3::new(d, d, 0.0) + middle);
                let is_outlined = |&at: &Vec3| has(&picture, at, is_selected_outline);
                assert!(nearby.iter().any(is_outlined), "{x}");
            }
        }
    });
}

#[test]
fn frames_of_a_selected_curve_are_not_covered_by_an_outline() {
    on_each_backend(|gl| {
        let outlined = |visibility| {
            let mut curve = CurveShape::new(CurveSet::start_spline(Basis::Bezier));
            curve.display.curve = visibility;
            let mut scene = Scene::new();
            let id = scene.add(NewShape::new("Wire", ShapeKind::Curve(curve)));
            let picture = draw(gl, &scene, selected(id));
            let pixels = picture.rgba.as_chunks::<4>().0.iter();
            pixels.filter(|&&pixel| is_selected_outline(pixel)).count()
        };
        assert!(outlined(CurveVisibility::On) > 50);
        assert_eq!(outlined(CurveVisibility::OnWithFrames), 0);
    });
}

#[test]
fn a_selected_skeleton_is_outlined_along_the_bones_that_its_look_draws() {
    let joint = |parent: Option<usize>, offset: Vec3, tip: Vec3| Joint {
        parent,
        offset,
        tip: Some(tip),
        ..Joint::default()
    };
    // The file has the bone beside the way from joint to joint.
    let joints = vec![
        joint(None, Vec3::ZERO, Vec3::X),
        joint(Some(0), Vec3::Y, Vec3::X * 0.5),
    ];
    let skeleton = SkeletalModel::new(joints).expect("a chain");
    let mesh = Mesh::new(Vec::new(), Vec::new());
    let character = Character::new(skeleton, Attachments::new(), mesh).expect("no vertices");
    let mut shape = CharacterShape::new(Arc::new(character));
    shape.display.mode = ModelDisplay::Skeleton;
    shape.display.bones = BoneStyle::Boxes;
    let mut scene = Scene::new();
    let id = scene.add(NewShape::new("Rig", ShapeKind::Character(shape)));
    on_each_backend(|gl| {
        for (look, expected) in [
            (Look::Mannequin, [true, false]),
            (Look::Studio, [false, true]),
        ] {
            let mut view = ViewSettings { look, ..view() };
            view.grid = false;
            let mut renderer = Renderer::new(gl).expect("a renderer");
            let picture = draw_scene(&mut renderer, gl, SIZE, &scene, &view, selected(id));
            let middles = [(Vec3::X, Vec3::Y), (Vec3::Y, Vec3::X)].map(|(along, across)| {
                let sides = [-0.06, 0.06].map(|side| along * 0.5 + across * side);
                sides
                    .iter()
                    .any(|&at| has(&picture, at, is_selected_outline))
            });
            assert_eq!(middles, expected, "{look:?}");
        }
    });
}

#[test]
fn a_curve_has_the_color_that_was_chosen_for_it_but_not_in_the_course_s_program() {
    on_each_backend(|gl| {
        let colored = |look: Look, color: Option<Vec3>| {
            let mut shape = CurveShape::new(CurveSet::start_circle());
            shape.display.control_points = false;
            let mut scene = Scene::new();
            let id = scene.add(NewShape::new("Wire", ShapeKind::Curve(shape)));
            if let Some(color) = color {
                let placement = &mut scene.shape_mut(id).expect("the curve").placement;
                placement.color = ShapeColor::Custom(color);
            }
            let mut view = ViewSettings { look, ..view() };
            view.grid = false;
            let mut renderer = Renderer::new(gl).expect("a renderer");
            draw_scene(&mut renderer, gl, SIZE, &scene, &view, Marks::default())
        };
        let green = Vec3::new(0.0, 1.0, 0.0);
        let is_green = |pixel: &&[u8]| pixel[..3] == [0, 255, 0];
        let count = |picture: &Picture| picture.rgba.chunks_exact(4).filter(is_green).count();
        let studio = colored(Look::Studio, Some(green));
        assert!(count(&studio) > 100, "{}", count(&studio));
        assert_eq!(count(&colored(Look::Studio, None)), 0);
        let course = colored(Look::Course, None);
        assert_eq!(colored(Look::Course, Some(green)).rgba, course.rgba);
    });
}

#[test]
fn a_curve_s_frames_are_red_green_and_blue_of_a_fifth_and_surface_normals_teal_of_a_tenth() {
    on_each_backend(|gl| {
        let mut set = CurveSet::start_spline(Basis::Bezier);
        let surface = CurveItemKind::Revolution {
            steps: 8,
            profile: 0,
        };
        set.push("surface", surface).expect("a surface");
        let mut shape = CurveShape::new(set);
        shape.display.curve = CurveVisibility::OnWithFrames;
        shape.display.surface = SurfaceVisibility::Off;
        shape.display.control_points = false;
        let mut scene = Scene::new();
        let id = scene.add(NewShape::new("Wire", ShapeKind::Curve(shape)));
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let geometry = &evaluated.shapes[0].geometry;
        let points = &geometry.curves.as_ref().expect("a curve").curves[0].points;
        // The frame at the end, beyond which nothing follows.
        let last = points.last().expect("a point");
        let mut view = view();
        (view.camera.theta, view.camera.phi, view.camera.radius) = (0.9, 0.5, 1.0);
        view.camera.target = last.position;
        let size = Vec2::new(SIZE.0 as f32, SIZE.1 as f32);
        let near = |picture: &Picture, world: Vec3, color: [u8; 3]| {
            let at = view.camera.pixel(world, size).expect("in view");
            let (x, y) = (at.x as usize, at.y as usize);
            (x - 1..=x + 1).any(|x| (y - 1..=y + 1).any(|y| picture.at(x, y)[..3] == color))
        };
        let mut renderer = Renderer::new(gl).expect("a renderer");
        let picture = draw_scene(&mut renderer, gl, SIZE, &scene, &view, Marks::default());
        for (axis, color) in [
            (last.frame.binormal, [0, 255, 0]),
            (last.frame.tangent, [0, 0, 255]),
            (last.frame.normal, [255, 0, 0]),
        ] {
            assert!(
                near(&picture, last.position + axis * 0.18, color),
                "{color:?}"
            );
        }

        // The curve goes no further than its last tangent.
        let beyond = last.position + last.frame.tangent * 0.24;
        assert!(!near(&picture, beyond, [0, 0, 255]));

        let shape = scene.curve_mut(id).expect("the curve");
        shape.display.curve = CurveVisibility::Off;
        shape.display.surface = SurfaceVisibility::WireframeWithNormals;
        let picture = draw_scene(&mut renderer, gl, SIZE, &scene, &view, Marks::default());
        let editor_core::geometry::Normals::PerVertex(normals) = &geometry.mesh.normals else {
            panic!("a surface has normals");
        };
        let positions = &geometry.mesh.positions;
        let vertices = positions.iter().zip(normals);
        let at = |p: Vec3| {
            let pixel = view.camera.pixel(p, size);
            pixel.filter(|at| at.cmpgt(Vec2::splat(2.0)).all() && at.cmplt(size - 3.0).all())
        };
        let seen: Vec<_> = vertices
            .filter(|(p, n)| at(**p + **n * 0.16).is_some() && at(**p).is_some())
            .collect();
        assert!(seen.len() > 3, "{} vertices in view", seen.len());
        let teal = [0, 128, 128];
        let at_end = seen
            .iter()
            .filter(|(p, n)| near(&picture, **p + **n * 0.09, teal))
            .count();
        let beyond = seen
            .iter()
            .filter(|(p, n)| near(&picture, **p + **n * 0.15, teal))
            .count();
        assert!(
            at_end > 2 * beyond && at_end * 2 > seen.len(),
            "{at_end} {beyond} of {}",
            seen.len()
        );
    });
}

#[test]
fn control_points_are_squares_of_five_and_only_the_selected_curve_s_grows_under_the_pointer() {
    on_each_backend(|gl| {
        let mut scene = Scene::new();
        let ids = [0.0, 0.6].map(|y| {
            let mut shape = CurveShape::new(CurveSet::start_spline(Basis::Bezier));
            shape.display.curve = CurveVisibility::Off;
            let id = scene.add(NewShape::new("Wire", ShapeKind::Curve(shape)));
            scene
                .shape_mut(id)
                .expect("the curve")
                .placement
                .transform
                .position
                .y = y;
            id
        });
        let yellow = |marks| draw(gl, &scene, marks).count(|pixel| pixel == YELLOW);
        let plain = yellow(Marks::default());
        let hovered = |selected| Marks {
            selected,
            hovered_control_point: Some((0, 1)),
            ..Marks::default()
        };
        assert_eq!(yellow(hovered(None)), plain);
        // A square of 11 in the place of one of 5, less what the polygons cover.
        let grown = yellow(hovered(Some(ids[0]))) - yellow(selected(ids[0]));
        assert!((80..=96).contains(&grown), "{grown}");
        assert_eq!(
            draw(gl, &scene, Marks::default()).count(|pixel| pixel == WHITE),
            0
        );
    });
}
