//! Skins that were bound in another pose, or with another turn, than the scene shows them in: where
//! `Σ weight · joint's world · inverse bind · bind shape · position` has their positions.

use crate::collada::support::*;
use editor_core::character::{Character, Pose};
use editor_core::geometry::Normals;
use editor_core::io::Imported;
use editor_core::io::dae::DaeScene;
use editor_core::math::Euler;
use glam::Vec3;

/// Inverse bind matrices of the joints `a` at (0, 1, 0) and `b` at (0, 2, 0), not turned.
const STANDING: &str = "1 0 0 0  0 1 0 -1  0 0 1 0  0 0 0 1   1 0 0 0  0 1 0 -2  0 0 1 0  0 0 0 1";
/// The same for a mesh that lies on its back: −90° about X, (x, y, z) → (x, z, −y), make it stand.
const LYING: &str = "1 0 0 0  0 0 1 -1  0 -1 0 0  0 0 0 1   1 0 0 0  0 0 1 -2  0 -1 0 0  0 0 0 1";
/// −90° about X.
const UPRIGHT: &str = "1 0 0 0  0 0 1 0  0 -1 0 0  0 0 0 1";

/// Joint `a` at (0, 1, 0) and its child `b` at (0, 2, 0), bent by 90° about Z in the scene.
fn bent_arm() -> String {
    let bent = joint("b", "0 1 0", "<rotate>0 0 1 90</rotate>");
    joint("a", "0 1 0", &bent)
}

fn straight_arm() -> String {
    joint("a", "0 1 0", &joint("b", "0 1 0", ""))
}

/// A skin whose first position follows `a`, the second `b` and the third both alike.
fn two_joints<'a>(inverse_binds: &'a str) -> Skin<'a> {
    Skin {
        joints: "a b",
        inverse_binds,
        weights: "1 0.5",
        vcount: "1 1 2",
        v: "0 0  1 0  0 1 1 1",
        ..Skin::default()
    }
}

/// A document with joints and the mesh `g` with these positions, skinned as `skin` says.
fn skinned_document(joints: &str, positions: &str, skin: &Skin) -> String {
    let mesh = geometry("g", positions, "", &triangles("g", "0 1 2"));
    let libraries = geometries(&mesh) + &controllers(&skin.xml());
    document(
        "",
        &libraries,
        &(joints.to_owned() + &skinned("c", &["ID-a"])),
    )
}

#[track_caller]
fn only_character(scene: &DaeScene) -> &Character {
    assert_eq!((scene.characters.len(), scene.meshes.len()), (1, 0));
    &scene.characters[0].character
}

/// That the mesh at rest, with all angles 0, and the joints are here.
#[track_caller]
fn assert_rest(scene: &DaeScene, mesh: &[Vec3], joints: &[Vec3]) {
    let character = only_character(scene);
    assert_near(&character.bind_mesh().positions, mesh);
    assert_near(&character.skin_pose(&Pose::new()), mesh);
    assert_near(&character.skeleton().bind_positions(), joints);
}

fn shown(imported: &Imported<DaeScene>) -> Vec<String> {
    imported
        .warnings
        .iter()
        .map(|w| w.message.clone())
        .collect()
}

const JOINTS: [Vec3; 2] = [Vec3::Y, Vec3::new(0.0, 2.0, 0.0)];
/// (1, 1, 0), (0, 3, 0) and (0, 3, 1) with the second joint bent: the third has gone half of the
/// way to (−1, 2, 1).
const BENT: [Vec3; 3] = [
    Vec3::new(1.0, 1.0, 0.0),
    Vec3::new(-1.0, 2.0, 0.0),
    Vec3::new(-0.5, 2.5, 1.0),
];

#[test]
fn a_mesh_bound_straight_is_bent_as_its_skeleton_is_in_the_scene() {
    let text = skinned_document(&bent_arm(), "1 1 0  0 3 0  0 3 1", &two_joints(STANDING));
    let imported = import(&text);
    assert_rest(&imported.value, &BENT, &JOINTS);
    assert_eq!(
        shown(&imported),
        [
            "expected inverse bind matrices that agree with the scene's rest pose, found a difference of 2.000e0 at “Name b”: the mesh is shown in the scene's rest pose"
        ]
    );
    let worst = imported.value.report.worst_inverse_bind.unwrap();
    assert_eq!((worst.joint.as_str(), worst.difference), ("Name b", 2.0));
}

#[test]
fn angles_count_from_the_scenes_rest_pose_whose_mesh_they_bend() {
    let text = skinned_document(&bent_arm(), "1 1 0  0 3 0  0 3 1", &two_joints(STANDING));
    let scene = import(&text).value;
    let character = only_character(&scene);
    let mut pose = Pose::new();
    let b = Pose::find_joint(character.skeleton(), "b").unwrap();
    pose.set_joint_transform(b, Euler::from_degrees(Vec3::new(0.0, 0.0, -90.0)));
    // Straight again. The third is the mean of (−0.5, 2.5, 1) and that turned about (0, 2, 0).
    let expected = [
        Vec3::new(1.0, 1.0, 0.0),
        Vec3::new(0.0, 3.0, 0.0),
        Vec3::new(0.0, 2.5, 1.0),
    ];
    assert_near(&character.skin_pose(&pose), &expected);
}

#[test]
fn normals_go_with_their_positions() {
    let normals = source("n", 3, "0 1 0");
    let corners = r##"<triangles><input semantic="VERTEX" source="#g-v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/><p>0 0 1 0 2 0</p></triangles>"##;
    let mesh = geometry("g", "1 1 0  0 3 0  0 3 1", &normals, corners);
    let libraries = geometries(&mesh) + &controllers(&two_joints(STANDING).xml());
    let text = document("", &libraries, &(bent_arm() + &skinned("c", &["ID-a"])));
    let scene = import(&text).value;
    let Normals::PerVertex(found) = &only_character(&scene).bind_mesh().normals else {
        panic!("expected a normal for each vertex");
    };
    let half = 0.5_f32.sqrt();
    assert_near(found, &[Vec3::Y, -Vec3::X, Vec3::new(-half, half, 0.0)]);
}

#[test]
fn a_mesh_that_its_node_or_its_bind_shape_turns_stands_with_its_skeleton() {
    let lying = two_joints(LYING);
    let shaped = Skin {
        bind_shape: UPRIGHT,
        ..two_joints(STANDING)
    };
    for skin in [lying, shaped] {
        let text = skinned_document(&straight_arm(), "1 0 1  0 0.25 3  0 0 3", &skin);
        let turned = text.replace(
            r#"<node name="Skin">"#,
            r#"<node name="Skin"><rotate>1 0 0 -90</rotate>"#,
        );
        assert_ne!(text, turned);
        let expected = [
            Vec3::new(1.0, 1.0, 0.0),
            Vec3::new(0.0, 3.0, -0.25),
            Vec3::new(0.0, 3.0, 0.0),
        ];
        for text in [text, turned] {
            assert_rest(&import_clean(&text), &expected, &JOINTS);
        }
    }
}

#[test]
fn a_turned_mesh_is_bent_with_its_skeleton_too() {
    let text = skinned_document(&bent_arm(), "1 0 1  0 0 3  0 -1 3", &two_joints(LYING));
    let turned = text.replace(
        r#"<node name="Skin">"#,
        r#"<node name="Skin"><rotate>1 0 0 -90</rotate>"#,
    );
    for text in [text, turned] {
        let imported = import(&text);
        assert_rest(&imported.value, &BENT, &JOINTS);
        assert_eq!(imported.warnings.len(), 1);
    }
}

#[test]
fn each_skin_of_a_skeleton_has_its_own_bind_pose() {
    let second = Skin {
        id: "d",
        geometry: "h",
        ..two_joints(LYING)
    };
    let meshes = geometry("g", "1 1 0  0 3 0  0 3 1", "", &triangles("g", "0 1 2"))
        + &geometry("h", "1 0 1  0 0 3  0 -1 3", "", &triangles("h", "0 1 2"));
    let skins = two_joints(STANDING).xml() + &second.xml();
    let nodes = bent_arm() + &skinned("c", &["ID-a"]) + &skinned("d", &["ID-a"]);
    let text = document("", &(geometries(&meshes) + &controllers(&skins)), &nodes);
    let imported = import(&text);
    assert_rest(&imported.value, &[BENT, BENT].concat(), &JOINTS);
}

#[test]
fn positions_without_weights_go_with_the_first_joint() {
    let skin = Skin {
        vcount: "1 0 0",
        v: "1 0",
        ..two_joints(LYING)
    };
    let positions = "0 0 3  0 0 3  1 0 1";
    let expected = [3.0 * Vec3::Y, 3.0 * Vec3::Y, Vec3::new(1.0, 1.0, 0.0)];
    let straight = skinned_document(&straight_arm(), positions, &skin);
    assert_rest(&import_clean(&straight), &expected, &JOINTS);
    let bent = import(&skinned_document(&bent_arm(), positions, &skin)).value;
    let expected = [BENT[1], expected[1], expected[2]];
    assert_rest(&bent, &expected, &JOINTS);
}

#[test]
fn inverse_bind_matrices_without_an_inverse_are_left_out() {
    let (of_a, _) = STANDING.split_once("   ").unwrap();
    let binds = of_a.to_owned() + &" 0".repeat(16);
    let text = skinned_document(&straight_arm(), "1 1 0  0 3 0  0 3 1", &two_joints(&binds));
    let imported = import(&text);
    let expected = [
        Vec3::new(1.0, 1.0, 0.0),
        3.0 * Vec3::Y,
        Vec3::new(0.0, 3.0, 1.0),
    ];
    assert_rest(&imported.value, &expected, &JOINTS);
    assert_eq!(
        shown(&imported),
        ["expected inverse bind matrices that can be inverted, found 1 that cannot: left out"]
    );
}

#[test]
fn digits_that_a_file_has_rounded_away_move_nothing() {
    // Each joint is half a unit higher than it was bound.
    let rounded = STANDING.replace("-1  ", "-0.5  ").replace("-2", "-1.5");
    let large = "1000 1 0  0 3 0  0 3 1";
    let scene = import_clean(&skinned_document(
        &straight_arm(),
        large,
        &two_joints(&rounded),
    ));
    let expected = [
        Vec3::new(1000.0, 1.0, 0.0),
        3.0 * Vec3::Y,
        Vec3::new(0.0, 3.0, 1.0),
    ];
    assert_rest(&scene, &expected, &JOINTS);
    let small = "1 1 0  0 3 0  0 3 1";
    let scene = import_clean(&skinned_document(
        &straight_arm(),
        small,
        &two_joints(&rounded),
    ));
    let expected = [
        Vec3::new(1.0, 1.5, 0.0),
        3.5 * Vec3::Y,
        Vec3::new(0.0, 3.5, 1.0),
    ];
    assert_rest(&scene, &expected, &JOINTS);
}
