//! The rigs in Collada files: they read without a word, and are well bound.
use crate::asset;
use editor_core::character::{Character, Pose};
use editor_core::disk::Disk;
use editor_core::io::dae::{DaeScene, read_dae};
use editor_core::math::Euler;
use glam::{Mat4, Vec3};
use std::path::Path;

/// All of them; the lizard is Blender's work, the others are the generator's.
const NAMES: [&str; 5] = ["chain", "column", "crate", "lizard", "tentacle"];

fn read(name: &str) -> DaeScene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/rigs");
    let imported = read_dae(&Disk, &folder.join(name).with_extension("dae")).unwrap();
    assert_eq!(imported.warnings, [], "{name}");
    imported.value
}

/// The one character of a rig's file.
fn character(name: &str) -> Character {
    let mut scene = read(name);
    assert_eq!(
        (scene.characters.len(), scene.meshes.len()),
        (1, 0),
        "{name}"
    );
    scene.characters.remove(0).character
}

fn joint(character: &Character, name: &str) -> usize {
    Pose::find_joint(character.skeleton(), name).unwrap()
}

/// How many joints move each vertex.
fn influences(character: &Character) -> Vec<usize> {
    let all = character.attachments();
    let vertices = 0..character.bind_mesh().positions.len();
    vertices.map(|vertex| all.of_vertex(vertex).len()).collect()
}

#[test]
fn every_rig_is_one_character_whose_faces_all_have_a_material() {
    for name in NAMES {
        let character = character(name);
        assert!(
            character
                .bind_mesh()
                .groups
                .iter()
                .all(|group| !group.triangles.is_empty())
        );
        let grouped: usize = character
            .bind_mesh()
            .groups
            .iter()
            .map(|g| g.triangles.len())
            .sum();
        assert_eq!(
            grouped,
            character.bind_mesh().triangles.len(),
            "{name}: a material each"
        );
    }
}

#[test]
fn weights_sum_to_one_in_the_file_and_leave_no_vertex_out() {
    for name in NAMES {
        let report = read(name).report;
        let (least, most) = report.weight_sums.unwrap();
        assert!(
            (least - 1.0).abs() < 1e-6 && (most - 1.0).abs() < 1e-6,
            "{name}"
        );
        assert_eq!(report.unweighted, 0, "{name}");
    }
}

#[test]
fn bind_matrices_agree_with_the_scene_and_cancel_out_at_rest() {
    for name in NAMES {
        let worst = read(name).report.worst_inverse_bind.unwrap();
        assert!(worst.difference < 2e-4, "{name}: {worst:?}");
        let character = character(name);
        let skeleton = character.skeleton();
        let current = skeleton.update_current_joint_to_world_transforms(&Pose::new());
        let palette = skeleton.palette(&current);
        for (index, matrix) in palette.iter().enumerate() {
            assert!(matrix.abs_diff_eq(Mat4::IDENTITY, 1e-6), "{name}: {index}");
        }
        let rest = character.skin_pose(&Pose::new());
        for (now, then) in rest.iter().zip(&character.bind_mesh().positions) {
            assert!(now.abs_diff_eq(*then, 1e-5), "{name}");
        }
    }
}

#[test]
fn every_joint_moves_something_and_its_bone_has_an_end() {
    for name in NAMES {
        let character = character(name);
        let rest = &character.bind_mesh().positions;
        for (index, joint) in character.skeleton().joints().iter().enumerate() {
            let tip = joint.tip.unwrap_or_default();
            assert!(tip.length() > 0.005, "{name}: {}", joint.name);
            let mut pose = Pose::new();
            pose.set_joint_transform(index, Euler::from_degrees(Vec3::new(10.0, 20.0, 30.0)));
            let moved = character
                .skin_pose(&pose)
                .iter()
                .zip(rest)
                .any(|(a, b)| a.distance(*b) > 1e-3);
            assert!(moved, "{name}: {}", joint.name);
        }
    }
}

#[test]
fn the_column_has_two_bones_and_the_chain_six() {
    assert_eq!(character("column").skeleton().joints().len(), 2);
    let chain = character("chain");
    assert_eq!(chain.skeleton().joints().len(), 6);
    assert!(influences(&chain).iter().all(|&count| count <= 2));
}

#[test]
fn the_tentacle_follows_five_joints_and_more_at_once() {
    let all = influences(&character("tentacle"));
    let many = all.iter().filter(|&&count| count >= 5).count();
    assert!(many * 2 > all.len(), "{many} of {}", all.len());
    assert!(all.iter().max() >= Some(&6));
}

#[test]
fn the_crate_has_a_picture_on_every_face_and_opens() {
    let character = character("crate");
    let mesh = character.bind_mesh();
    let [group] = &mesh.groups[..] else {
        panic!("{:?}", mesh.groups);
    };
    let picture = group.material.texture.as_ref().unwrap();
    assert!(picture.width >= 256 && picture.height >= 256);
    assert_eq!(mesh.texture_coordinates.len(), mesh.vertex_count());
    for at in &mesh.texture_coordinates {
        assert!(at.min_element() >= 0.0 && at.max_element() <= 1.0, "{at}");
    }
    let lid = joint(&character, "Lid");
    let mut pose = Pose::new();
    pose.set_joint_transform(lid, Euler::from_degrees(Vec3::new(-90.0, 0.0, 0.0)));
    let top = |positions: &[Vec3]| positions.iter().fold(f32::MIN, |top, p| top.max(p.y));
    assert!(top(&character.skin_pose(&pose)) > top(&mesh.positions) + 1.0);
}

#[test]
fn blenders_file_is_the_exporters_own_and_has_two_skins_on_one_skeleton() {
    let text = asset("rigs/lizard.dae");
    assert!(
        text.contains("<authoring_tool>Blender 4"),
        "made by Blender"
    );
    assert!(text.contains("<up_axis>Z_UP</up_axis>"));
    let scene = read("lizard");
    assert_eq!(scene.report.skins, 2);
    let lizard = &scene.characters[0].character;
    let skeleton = lizard.skeleton();
    let sids = skeleton.joints().iter().map(|joint| joint.sid.as_deref());
    assert!(sids.into_iter().any(|sid| sid == Some("Left_front_foot")));
    // Turned upright: it stands on its toes and looks along +Z, its left on +X.
    let at = skeleton.bind_positions();
    let at = |name: &str| at[joint(lizard, name)];
    assert!(at("Head").z > at("Hips").z + 0.5 && at("Tail 6").z < at("Hips").z - 0.5);
    assert!(at("Left front foot").x > 0.1 && at("Right front foot").x < -0.1);
    let low = lizard
        .bind_mesh()
        .positions
        .iter()
        .fold(f32::MAX, |low, p| low.min(p.y));
    assert!((-0.01..0.02).contains(&low), "stands at {low}");
    assert!(influences(lizard).iter().max() >= Some(&4));
}
