//! Joints are fitted into the view with their skin, in Blender's navigation, where nothing cuts the mesh open.

use crate::interface::Editor;
use crate::interface::blender::in_blender;
use editor_core::character::{Attachments, Pose};
use editor_core::disk::Disk;
use editor_core::editor::View;
use editor_core::io::dae::read_dae;
use editor_core::math::Aabb;
use editor_core::scene::{Camera, bones_in_world};
use egui::{Key, Rect, vec2};
use glam::Vec2;
use std::f32::consts::TAU;
use std::path::Path;
use std::sync::Arc;

impl Editor {
    /// Selects a joint of a character by its name and has it fitted into the view.
    fn fit_joint(&mut self, name: &str) -> usize {
        let joint = Pose::find_joint(self.character().character.skeleton(), name);
        let joint = joint.expect("the joint is there");
        self.view(View::SelectJoint(Some(joint)));
        self.choose(&["View", "Fit to View"]);
        joint
    }

    /// What the picture shows at points all over it: whether it is the outside of the mesh, and its depth. None is in the
    /// middle, where a ray may slip through between the two halves of what is symmetric.
    fn met(&self) -> Vec<(bool, f32)> {
        let shape = &self.session().evaluated().shapes[0];
        let (camera, rect) = (self.session().view().camera, self.harness.state().view);
        let size = Vec2::new(rect.width(), rect.height());
        let to_model = shape.world_from_model.inverse();
        let positions = shape.geometry.positions();
        let corners = shape.geometry.mesh.triangles.iter();
        let triangles: Vec<_> = corners
            .map(|corners| corners.map(|corner| positions[corner as usize]))
            .collect();
        let at = (0..100).map(|at| Vec2::new((at % 10) as f32, (at / 10) as f32) + 0.5);
        let rays = at.map(|at| camera.ray(at * size / 10.0, size));
        let first = rays.filter_map(|ray| {
            let in_model = ray.transformed(to_model);
            let all = triangles.iter();
            let hits = all.filter_map(|&of| Some((in_model.triangle(of)?.distance, of)));
            let (distance, [a, b, c]) = hits.min_by(|a, b| a.0.total_cmp(&b.0))?;
            let is_outside = (b - a).cross(c - a).dot(in_model.direction) < 0.0;
            Some((is_outside, camera.depth(ray.at(distance))))
        });
        first.collect()
    }
}

/// The humanoid with its joints at hand, in Blender's navigation.
fn with_humanoid() -> Editor {
    let mut editor = in_blender(Editor::sized(vec2(1280.0, 800.0)));
    let rig = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/rigs/humanoid.dae");
    let mut read = read_dae(&Disk, &rig).expect("the humanoid").value;
    editor.add_character(Arc::new(read.characters.remove(0).character));
    editor.key(Key::J);
    editor
}

#[test]
fn a_joint_is_fitted_with_all_of_its_skin_and_nothing_is_cut_open() {
    let mut editor = with_humanoid();
    for name in [
        "Left hand",
        "Left index 2",
        "Right thumb 3",
        "Left foot",
        "Left toes",
        "Head",
        "Left collarbone",
        "Chest",
        "Hips",
    ] {
        let joint = editor.fit_joint(name) as u32;
        let view = editor.harness.state().view;
        let shape = &editor.session().evaluated().shapes[0];
        let influences = editor.character().character.attachments().vertices();
        let skin = shape.geometry.positions().iter().zip(influences);
        let skin = skin.filter(|(_, by)| Attachments::strongest(by) == Some(joint));
        let seen: Vec<_> = skin
            .map(|(&at, _)| editor.place(shape.world_from_model.transform_point3(at)))
            .collect();
        assert!(
            seen.len() > 5 && seen.iter().all(|&at| view.contains(at)),
            "{name}"
        );
        let bounds = Rect::from_points(&seen);
        let share = (bounds.size() / view.size()).max_elem();
        assert!(share > 0.3, "{name} is {share} of the picture");
        let near = editor.session().view().camera.near;
        let met = editor.met();
        assert!(met.len() > 5, "{name}");
        for (is_outside, depth) in met {
            assert!(is_outside && depth > near, "{name}: {depth}, near {near}");
        }
    }
}

#[test]
fn a_hand_is_fitted_with_its_fingers_and_an_upper_arm_without_the_forearm() {
    let mut editor = with_humanoid();
    let ends = |editor: &mut Editor, fitted: &str, seen: &str| {
        editor.fit_joint(fitted);
        let skeleton = editor.character().character.skeleton();
        let joint = Pose::find_joint(skeleton, seen).expect("the joint is there");
        let (start, end) = editor.bone(joint);
        let view = editor.harness.state().view;
        [start, end].map(|at| view.contains(editor.place(at)))
    };
    for finger in ["thumb", "index", "middle", "ring", "little"] {
        let last = format!("Left {finger} 2");
        assert_eq!(ends(&mut editor, "Left hand", &last), [true; 2], "{finger}");
    }
    assert_eq!(ends(&mut editor, "Left arm", "Left hand"), [false; 2]);
}

#[test]
fn a_hand_behind_the_body_is_fitted_from_outside_of_the_body() {
    let mut editor = with_humanoid();
    for turn in 0..12 {
        let camera = Camera {
            theta: turn as f32 * TAU / 12.0,
            phi: 0.1,
            ..Camera::default()
        };
        for name in ["Left hand", "Left shin", "Left arm", "Neck"] {
            editor.view(View::SetCamera(camera));
            editor.fit_joint(name);
            let now = editor.session().view().camera;
            let met = editor.met();
            let is_whole = met
                .iter()
                .all(|&(outside, depth)| outside && depth > now.near);
            assert!(is_whole, "{name} from {turn}: {now:?}");
            assert!(now.radius < 3.0, "{name} from {turn}");
        }
    }
}

#[test]
fn where_the_skeleton_is_shown_alone_bones_are_fitted_as_they_are() {
    let mut editor = with_humanoid();
    editor.fit_joint("Left hand");
    let with_skin = editor.session().view().camera;
    editor.click("Skeletal Model");
    let joint = editor.fit_joint("Left hand");
    let camera = editor.session().view().camera;
    assert!(camera.radius < with_skin.radius, "{camera:?} {with_skin:?}");
    let (shape, session) = (editor.shape().id, editor.session());
    let evaluated = session.evaluated().shape(shape).expect("it is evaluated");
    let bones = bones_in_world(session.scene(), evaluated).filter(|bone| bone.0 == joint);
    let bounds = Aabb::from_points(bones.flat_map(|(_, start, end)| [start, end]));
    assert!(camera.target.abs_diff_eq(bounds.center(), 1e-5));
}
