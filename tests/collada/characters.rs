//! Skins, skeletons, weights.

use crate::collada::support::*;
use editor_core::character::{Character, Influence, Joint, Pose};
use editor_core::geometry::Normals;
use editor_core::math::Euler;
use glam::Vec3;

#[track_caller]
fn only_character(text: &str) -> Character {
    let mut scene = import_clean(text);
    assert_eq!((scene.characters.len(), scene.meshes.len()), (1, 0));
    scene.characters.remove(0).character
}

fn sids(character: &Character) -> Vec<&str> {
    let joints = character.skeleton().joints();
    joints
        .iter()
        .map(|joint| joint.sid.as_deref().unwrap_or("-"))
        .collect()
}

fn weights(character: &Character, position: usize) -> Vec<(u32, f32)> {
    let influences = character.attachments().of_vertex(position).iter();
    influences
        .map(|&Influence { joint, weight }| (joint, weight))
        .collect()
}

fn turned(character: &Character, joint: &str, degrees: Vec3) -> Vec<Vec3> {
    let mut pose = Pose::new();
    let joint = Pose::find_joint(character.skeleton(), joint).unwrap();
    pose.set_joint_transform(joint, Euler::from_degrees(degrees));
    character.skin_pose(&pose)
}

#[test]
fn joints_have_name_sid_parent_and_offset_in_the_files_order() {
    let character = only_character(&arm(&Skin::default()));
    let expected = [("a", None), ("b", Some(0))].map(|(sid, parent)| Joint {
        name: format!("Name {sid}"),
        sid: Some(sid.to_owned()),
        parent,
        offset: Vec3::Y,
        tip: None,
    });
    let found: Vec<Joint> = character.skeleton().joints().to_vec();
    assert_eq!(
        found[0],
        Joint {
            tip: Some(Vec3::Y),
            ..expected[0].clone()
        }
    );
    // A leaf has a share of its parent's length.
    assert_eq!(
        found[1],
        Joint {
            tip: Some(Vec3::Y * 0.4),
            ..expected[1].clone()
        }
    );
    let skeleton = character.skeleton();
    assert_eq!(Pose::find_joint(skeleton, "Name b"), Ok(1));
    assert_eq!(Pose::find_joint(skeleton, "b"), Ok(1));
    assert_eq!(Pose::find_joint(skeleton, "1"), Ok(1));
}

#[test]
fn vertices_at_rest_take_the_bind_shape_then_the_axes_and_not_their_node() {
    let bind_shape = "2 0 0 1 0 2 0 0 0 0 2 0 0 0 0 1";
    let text = arm(&Skin {
        bind_shape,
        ..Skin::default()
    })
    .replace(
        "<asset>",
        r#"<asset><unit meter="0.5"/><up_axis>Z_UP</up_axis>"#,
    )
    .replace(
        r#"<node name="Skin">"#,
        r#"<node name="Skin"><translate>9 9 9</translate>"#,
    );
    let character = only_character(&text);
    let expected = [
        Vec3::new(0.5, 0.0, 0.0),
        Vec3::new(1.5, 0.0, 0.0),
        Vec3::new(0.5, 3.0, -2.0),
    ];
    assert_near(&character.bind_mesh().positions, &expected);
    assert_near(
        &character.skeleton().bind_positions(),
        &[Vec3::Z * -0.5, -Vec3::Z],
    );
}

#[test]
fn joint_frames_are_parallel_to_the_axes_at_rest_whatever_the_file_turns() {
    let text = arm(&Skin {
        joints: "b",
        ..Skin::default()
    })
    .replace(
        "<translate>0 1 0</translate>",
        "<translate>0 1 0</translate><rotate>0 0 1 90</rotate>",
    );
    let character = only_character(&text);
    assert_near(
        &character.skeleton().bind_positions(),
        &[Vec3::Y, Vec3::new(-1.0, 1.0, 0.0)],
    );
    // About Y of the character, not of the file's joint.
    let posed = turned(&character, "b", Vec3::new(0.0, 180.0, 0.0));
    assert_near(
        &posed[..2],
        &[Vec3::new(-2.0, 0.0, 0.0), Vec3::new(-3.0, 0.0, 0.0)],
    );
    let tip = character.skeleton().joints()[0].tip.unwrap();
    assert_near(&[tip], &[-Vec3::X]);
}

#[test]
fn names_are_sids_below_the_skeleton_though_another_armature_has_them_too() {
    let skins = Skin::default().xml()
        + &Skin {
            id: "d",
            ..Skin::default()
        }
        .xml();
    let libraries = geometries(&triangle("g")) + &controllers(&skins);
    let armature = |id: &str, at: &str, controller: &str| {
        let joints = joint("a", "0 0 0", "").replace("ID-a", id);
        format!(
            "<node name=\"Rig {id}\"><translate>{at}</translate>{joints}{}</node>",
            skinned(controller, &[id])
        )
    };
    let nodes = armature("one", "1 0 0", "c") + &armature("two", "2 0 0", "d");
    let scene = import_clean(&document("", &libraries, &nodes));
    let found: Vec<(&str, Vec3)> = scene
        .characters
        .iter()
        .map(|c| (c.name.as_str(), c.character.skeleton().joints()[0].offset))
        .collect();
    assert_eq!(found, [("Rig one", Vec3::X), ("Rig two", Vec3::X * 2.0)]);
    assert_eq!(scene.report.skins, 2);
}

#[test]
fn an_array_of_references_names_ids_of_nodes() {
    let skin = Skin {
        array: "IDREF_array",
        joints: "ID-b ID-a",
        ..Skin::default()
    };
    let character = only_character(&arm(&skin));
    assert_eq!(weights(&character, 0), [(1, 1.0)]);
}

#[test]
fn names_of_nodes_are_never_meant() {
    let skin = Skin {
        joints: "b Name",
        vcount: "2 1 0",
        weights: "1 3",
        v: "0 0 1 1 1 0",
        ..Skin::default()
    };
    let text = arm(&skin).replace("Name a", "Name");
    let imported = import(&text);
    assert_warns(
        &imported,
        "expected the joint “Name” below <skeleton>, found none",
    );
    let character = &imported.value.characters[0].character;
    assert_eq!(weights(character, 0), [(1, 1.0)]);
    assert_eq!(weights(character, 1), []);
}

#[test]
fn ids_where_sids_belong_are_understood_with_a_warning() {
    let imported = import(&arm(&Skin {
        joints: "ID-b",
        ..Skin::default()
    }));
    assert_warns(
        &imported,
        "expected all joints below <skeleton>, found 1 elsewhere",
    );
    assert_eq!(
        weights(&imported.value.characters[0].character, 0),
        [(1, 1.0)]
    );
}

#[test]
fn joints_that_the_controller_does_not_list_belong_to_the_rig_and_its_order_is_no_matter() {
    let skin = Skin {
        joints: "c b",
        vcount: "1 1 1",
        v: "0 0 1 0 0 0",
        ..Skin::default()
    };
    let libraries = geometries(&triangle("g")) + &controllers(&skin.xml());
    let inner = joint("b", "1 0 0", &joint("c", "1 0 0", "")) + &joint("d", "0 1 0", "");
    let nodes = joint("a", "0 0 0", &inner) + &skinned("c", &["ID-a"]);
    let character = only_character(&document("", &libraries, &nodes));
    assert_eq!(sids(&character), ["a", "b", "c", "d"]);
    assert_eq!(weights(&character, 0), [(2, 1.0)]);
    assert_eq!(weights(&character, 1), [(1, 1.0)]);
}

#[test]
fn the_parent_is_the_nearest_joint_and_nodes_between_count() {
    let libraries = geometries(&triangle("g")) + &controllers(&Skin::default().xml());
    let between = format!(
        "<node><scale>2 2 2</scale>{}</node>",
        joint("b", "0 1 0", "")
    );
    let nodes = joint("a", "0 1 0", &between) + &skinned("c", &["ID-a"]);
    let character = only_character(&document("", &libraries, &nodes));
    assert_eq!(character.skeleton().joints()[1].parent, Some(0));
    assert_eq!(character.skeleton().joints()[1].offset, Vec3::Y * 2.0);
}

#[test]
fn several_skins_on_one_skeleton_are_one_character_in_the_order_of_the_scene() {
    let skins = Skin::default().xml()
        + &Skin {
            id: "d",
            geometry: "h",
            joints: "b",
            ..Skin::default()
        }
        .xml();
    let second = geometry("h", "5 0 0 6 0 0 5 1 0 9 9 9", "", &triangles("h", "0 1 2"));
    let libraries = geometries(&(second + &triangle("g"))) + &controllers(&skins);
    let nodes = skinned("d", &["ID-a"])
        + &joint("a", "0 0 0", &joint("b", "0 1 0", ""))
        + &skinned("c", &["ID-b"]);
    let imported = import(&document("", &libraries, &nodes));
    // The second skin looks for its joint below a skeleton that starts too low.
    assert_warns(&imported, "found 1 elsewhere");
    let scene = &imported.value;
    assert_eq!(scene.characters.len(), 1);
    let character = &scene.characters[0].character;
    assert_eq!(character.bind_mesh().positions.len(), 7);
    assert_eq!(character.bind_mesh().positions[0], Vec3::X * 5.0);
    assert_eq!(character.bind_mesh().triangles, [[0, 1, 2], [4, 5, 6]]);
    assert_eq!(weights(character, 0), [(1, 1.0)]);
    assert_eq!(weights(character, 3), []);
    assert_eq!(weights(character, 4), [(0, 1.0)]);
}

#[test]
fn a_skin_on_several_roots_makes_a_forest_with_those_roots_that_no_skin_names() {
    let skin = Skin {
        joints: "a b",
        ..Skin::default()
    };
    let libraries = geometries(&triangle("g")) + &controllers(&skin.xml());
    let roots = joint("a", "1 0 0", "") + &joint("b", "2 0 0", "") + &joint("spare", "3 0 0", "");
    let nodes = format!(
        "<node name=\"Creature\">{roots}</node>{}",
        skinned("c", &["ID-a", "ID-b"])
    );
    let scene = import_clean(&document("", &libraries, &nodes));
    assert_eq!(scene.characters.len(), 1);
    assert_eq!(scene.characters[0].name, "Creature");
    let skeleton = scene.characters[0].character.skeleton();
    assert_eq!(skeleton.roots(), [0, 1, 2]);
    assert_eq!(skeleton.joints()[2].offset, Vec3::X * 3.0);
}

#[test]
fn skeletons_without_a_skin_can_be_posed_too() {
    let scene = import_clean(&document(
        "",
        "",
        &joint("a", "0 0 0", &joint("b", "0 1 0", "")),
    ));
    let character = &scene.characters[0].character;
    assert_eq!(sids(character), ["a", "b"]);
    assert!(character.bind_mesh().positions.is_empty());
}

#[test]
fn meshes_below_a_joint_move_with_it_after_all_skins() {
    let libraries =
        geometries(&(triangle("g") + &triangle("h"))) + &controllers(&Skin::default().xml());
    let hand = format!("<node><translate>0 0 5</translate>{}</node>", instance("h"));
    let nodes = joint("a", "0 1 0", &joint("b", "0 1 0", &hand)) + &skinned("c", &["ID-a"]);
    let character = only_character(&document("", &libraries, &nodes));
    assert_eq!(weights(&character, 0), [(0, 1.0)]);
    assert_eq!(weights(&character, 3), [(1, 1.0)]);
    let posed = turned(&character, "b", Vec3::new(90.0, 0.0, 0.0));
    assert_near(&posed[3..4], &[Vec3::new(0.0, -3.0, 0.0)]);
}

#[test]
fn weights_are_divided_by_their_sum_and_a_vertex_without_any_stays() {
    let skin = Skin {
        joints: "a b",
        weights: "1 3 0",
        vcount: "2 0 1",
        v: "0 0 1 1  0 2",
        ..Skin::default()
    };
    let scene = import_clean(&arm(&skin));
    let character = &scene.characters[0].character;
    assert_eq!(weights(character, 0), [(0, 0.25), (1, 0.75)]);
    assert_eq!(weights(character, 1), []);
    assert_eq!(weights(character, 2), []);
    assert_eq!(scene.report.weight_sums, Some((4.0, 4.0)));
    assert_eq!(scene.report.unweighted, 2);
    let posed = turned(character, "a", Vec3::new(0.0, 90.0, 0.0));
    assert_eq!(posed[1], Vec3::X);
}

#[test]
fn a_mesh_that_no_weight_moves_is_told() {
    let skin = Skin {
        joints: "a b",
        weights: "0 0 0",
        vcount: "1 1 1",
        v: "0 0 0 1 1 2",
        ..Skin::default()
    };
    let warnings = import(&arm(&skin)).warnings;
    let [only] = &warnings[..] else {
        panic!("{warnings:?}");
    };
    let told =
        "expected weights that are not 0, found none at 3 of 3 positions: these stay at rest";
    assert_eq!(only.message, told);
}

#[test]
fn any_number_of_influences_is_kept_and_four_are_the_largest_of_equals_the_first_listed() {
    let names = ["a", "b", "e", "f", "h", "i"];
    let chain = names
        .iter()
        .rev()
        .fold(String::new(), |inside, sid| joint(sid, "0 1 0", &inside));
    let skin = Skin {
        // The list runs against the tree.
        joints: "i h f e b a",
        weights: "1 2 3",
        vcount: "6 0 0",
        v: "5 0 4 0 3 0 2 1 1 0 0 2",
        ..Skin::default()
    };
    let libraries = geometries(&triangle("g")) + &controllers(&skin.xml());
    let character = only_character(&document(
        "",
        &libraries,
        &(chain + &skinned("c", &["ID-a"])),
    ));
    assert_eq!(character.attachments().most_influences(), 6);
    let four = character.limited(4);
    let mut kept = weights(&four, 0);
    kept.sort_by_key(|&(joint, _)| joint);
    // i has 3, f has 2, of those with 1 come h and e first in the list.
    assert_eq!(
        kept.iter().map(|&(joint, _)| joint).collect::<Vec<_>>(),
        [2, 3, 4, 5]
    );
    let found: Vec<f32> = kept.iter().map(|&(_, weight)| weight * 7.0).collect();
    for (found, expected) in found.iter().zip([1.0, 2.0, 1.0, 3.0]) {
        assert!((found - expected).abs() < 1e-6, "{kept:?}");
    }
}

#[test]
fn a_joint_named_twice_for_a_vertex_counts_once() {
    let skin = Skin {
        joints: "a b",
        weights: "0.25 0.5",
        vcount: "3 0 0",
        v: "0 0 1 1 0 0",
        ..Skin::default()
    };
    assert_eq!(
        weights(&only_character(&arm(&skin)), 0),
        [(0, 0.5), (1, 0.5)]
    );
}

#[test]
fn weights_that_sum_to_nothing_leave_their_vertex_at_rest_with_a_warning() {
    let skin = Skin {
        joints: "a b",
        weights: "1 -1",
        vcount: "2 1 1",
        v: "0 0 1 1 0 1 0 0",
        ..Skin::default()
    };
    let imported = import(&arm(&skin));
    assert_warns(
        &imported,
        "expected weights with a positive sum, found others at 2 positions",
    );
    assert_eq!(weights(&imported.value.characters[0].character, 0), []);
}

#[test]
fn normals_follow_the_joints() {
    let normals = source("n", 3, "0 0 1 1 0 0");
    let rest = r##"<triangles><input semantic="VERTEX" source="#g-v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/><p>0 0 1 0 2 0 0 1 2 1 1 1</p></triangles>"##;
    let geometry = geometry("g", "0 0 0 1 0 0 0 1 0", &normals, rest);
    let libraries = geometries(&geometry) + &controllers(&Skin::default().xml());
    let text = document(
        "",
        &libraries,
        &(joint("a", "0 1 0", "") + &skinned("c", &["ID-a"])),
    );
    let character = only_character(&text);
    assert!(matches!(&character.bind_mesh().normals, Normals::PerVertex(n) if n.len() == 6));
    let mut pose = Pose::new();
    pose.set_joint_transform(0, Euler::from_degrees(Vec3::new(0.0, 90.0, 0.0)));
    let current = character
        .skeleton()
        .update_current_joint_to_world_transforms(&pose);
    let skinned = character.skin(&current).normals.unwrap();
    assert_near(
        &skinned,
        &[Vec3::X, Vec3::X, Vec3::X, -Vec3::Z, -Vec3::Z, -Vec3::Z],
    );
}

#[test]
fn a_leafs_bone_ends_where_blender_says() {
    let tip = r#"<extra><technique profile="blender"><tip_x sid="tip_x">0</tip_x><tip_y>3</tip_y><tip_z>-4</tip_z></technique></extra>"#;
    let libraries = geometries(&triangle("g")) + &controllers(&Skin::default().xml());
    let nodes =
        joint("a", "0 0 0", &format!("<rotate>1 0 0 90</rotate>{tip}")) + &skinned("c", &["ID-a"]);
    let text = document(r#"<unit meter="0.1"/>"#, &libraries, &nodes);
    let character = only_character(&text);
    assert_near(
        &[character.skeleton().joints()[0].tip.unwrap()],
        &[Vec3::Z * 0.5],
    );
}

#[test]
fn a_skin_without_any_joint_is_a_static_mesh_with_a_warning() {
    let text = arm(&Skin {
        joints: "x",
        ..Skin::default()
    })
    .replace("<skeleton>#ID-a</skeleton>", "");
    let imported = import(&text);
    assert_warns(&imported, "expected a skeleton, found no joint");
    assert_eq!(imported.value.meshes.len(), 1);
}

#[test]
fn a_morph_shows_its_base_mesh() {
    let morph = r##"<controller id="c"><morph source="#g"/></controller>"##;
    let libraries = geometries(&triangle("g")) + &controllers(morph);
    let scene = import_clean(&document("", &libraries, &skinned("c", &[])));
    assert_eq!(scene.meshes.len(), 1);
    assert_eq!(scene.report.ignored["morph"], 1);
}
