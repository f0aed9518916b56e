//! The rigs in Collada files: they read without a word, and are well bound.
use crate::assets::asset;
use editor_core::character::{Character, Pose};
use editor_core::disk::Disk;
use editor_core::io::dae::{DaeScene, read_dae};
use editor_core::math::Euler;
use glam::{Mat4, Vec3};
use std::path::Path;

/// All of them; the lizard is Blender's work, the others are the generator's.
const NAMES: [&str; 8] = [
    "chain", "column", "crate", "creature", "face", "humanoid", "lizard", "tentacle",
];

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

#[test]
fn the_creature_has_three_roots_each_of_which_moves_its_own_part_alone() {
    let creature = character("creature");
    let skeleton = creature.skeleton();
    let names: Vec<&str> = skeleton
        .roots()
        .iter()
        .map(|&root| &*skeleton.joints()[root].name)
        .collect();
    assert_eq!(names, ["Body", "Left hand", "Right hand"]);
    let rest = &creature.bind_mesh().positions;
    let mut moved_by = vec![0; rest.len()];
    for &root in skeleton.roots() {
        let mut pose = Pose::new();
        pose.set_root_offset(root, Vec3::new(0.1, 0.2, 0.3));
        for (count, (now, then)) in moved_by
            .iter_mut()
            .zip(creature.skin_pose(&pose).iter().zip(rest))
        {
            let distance = (*now - *then).length();
            let whole = Vec3::new(0.1, 0.2, 0.3).length();
            assert!(distance < 1e-5 || (distance - whole).abs() < 1e-5);
            *count += usize::from(distance > 1e-5);
        }
    }
    assert!(moved_by.iter().all(|&count| count == 1));
    let report = read("creature").report;
    assert!(
        (report.space.meters - 0.01).abs() < 1e-9,
        "its file is in centimeters"
    );
}

#[test]
fn the_humanoid_has_fingers_of_three_bones_that_bend_alone() {
    let humanoid = character("humanoid");
    let skeleton = humanoid.skeleton();
    let rest = &humanoid.bind_mesh().positions;
    let places = skeleton.bind_positions();
    for side in ["Left", "Right"] {
        for finger in ["thumb", "index", "middle", "ring", "little"] {
            let bones = [1, 2, 3].map(|part| joint(&humanoid, &format!("{side} {finger} {part}")));
            assert_eq!(skeleton.joints()[bones[1]].parent, Some(bones[0]));
            assert_eq!(skeleton.joints()[bones[2]].parent, Some(bones[1]));
            let mut pose = Pose::new();
            pose.set_joint_transform(bones[0], Euler::from_degrees(Vec3::new(40.0, 0.0, 0.0)));
            let posed = humanoid.skin_pose(&pose);
            let moved: Vec<usize> = (0..rest.len())
                .filter(|&v| posed[v].distance(rest[v]) > 0.004)
                .collect();
            assert!(moved.len() > 60, "{side} {finger}: {}", moved.len());
            let far = moved
                .iter()
                .filter(|&&v| rest[v].distance(places[bones[0]]) > 0.14)
                .count();
            assert_eq!(far, 0, "{side} {finger} moves what is far from it");
            // A vertex that the last bone all but owns is no other finger's.
            let tip = joint(&humanoid, &format!("{side} {finger} 3")) as u32;
            let owned = humanoid.attachments().vertices();
            let own = owned
                .filter(|v| v.iter().any(|i| i.joint == tip && i.weight > 0.8))
                .count();
            assert!(own >= 5, "{side} {finger}: {own}");
        }
    }
}

#[test]
fn the_face_opens_its_mouth_by_the_jaw_and_looks_about_by_its_eyes() {
    let face = character("face");
    let rest = &face.bind_mesh().positions;
    let moved = |name: &str, degrees: Vec3| {
        let mut pose = Pose::new();
        pose.set_joint_transform(joint(&face, name), Euler::from_degrees(degrees));
        let posed = face.skin_pose(&pose);
        (0..rest.len())
            .filter(|&v| posed[v].distance(rest[v]) > 0.01)
            .map(|v| rest[v])
            .collect::<Vec<_>>()
    };
    let jaw = moved("Jaw", Vec3::new(20.0, 0.0, 0.0));
    let eyes = face.skeleton().bind_positions()[joint(&face, "Left eye")];
    assert!(jaw.len() > 1000, "{}", jaw.len());
    assert!(
        jaw.iter().all(|p| p.y < eyes.y - 0.05),
        "the upper face stays"
    );
    let ball = moved("Left eye", Vec3::new(0.0, 30.0, 0.0));
    assert!(ball.len() > 100);
    assert!(
        ball.iter()
            .all(|p| (p.distance(eyes) - 0.0755).abs() < 0.002),
        "a ball"
    );
    let names: Vec<&str> = face
        .bind_mesh()
        .groups
        .iter()
        .map(|group| &*group.material.name)
        .collect();
    for name in [
        "Skin",
        "Hair",
        "Lips",
        "Teeth",
        "Tongue",
        "Eye white",
        "Iris",
        "Pupil",
    ] {
        assert!(names.contains(&name), "{names:?}");
    }
}

#[test]
fn joints_of_the_left_mirror_those_of_the_right() {
    for name in ["creature", "face", "humanoid", "lizard"] {
        let character = character(name);
        let joints = character.skeleton().joints();
        let places = character.skeleton().bind_positions();
        let lefts = joints
            .iter()
            .filter(|joint| joint.name.starts_with("Left "));
        assert!(lefts.clone().count() >= 5, "{name}");
        for left in lefts {
            let right = left.name.replacen("Left", "Right", 1);
            let [l, r] = [&left.name, &right].map(|name| places[joint(&character, name)]);
            assert!(
                l.x > 0.0 && l.distance(Vec3::new(-r.x, r.y, r.z)) < 1e-4,
                "{name}: {right}"
            );
        }
    }
}
