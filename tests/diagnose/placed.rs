//! A mistake in a mesh that is moved, scaled or has other axes as a whole.

use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::named;
use crate::diagnose::student::{RIGHT, with};
use crate::reference_data::reference;
use editor_core::character::Pose;
use editor_core::diagnose::{Verdict, diagnose};
use editor_core::disk::Disk;
use editor_core::geometry::Mesh;
use editor_core::io::dae::read_dae;
use editor_core::math::Euler;
use glam::Vec3;

type Place = fn(Vec3) -> Vec3;

const PLACES: [(Place, &str); 5] = [
    (|v| Vec3::new(v.x, -v.z, v.y), "the axes x, -z, y"),
    (|v| v * 100.0, "100 times as large"),
    (|v| v * 0.01, "0.01 times as large"),
    (|v| v - Vec3::new(3.0, 0.0, 4.0), "moved by 5"),
    (
        |v| Vec3::new(-v.z, v.y, v.x) * 2.0,
        "the axes -z, y, x, 2 times as large",
    ),
];

#[test]
fn a_mistake_is_named_in_a_mesh_that_is_elsewhere_of_another_size_or_on_other_axes() {
    let figure = Figure::builtin("adult", turned(71)).with_weights_of(2);
    for id in [
        "euler-zyx",
        "weights-shifted",
        "weights-normalized",
        "no-inverse-bind",
        "pose-not-applied",
    ] {
        let skinned = with(&[id]).skin(&figure);
        for (place, how) in PLACES {
            let theirs: Vec<Vec3> = skinned.iter().copied().map(place).collect();
            let found = figure.diagnose(&written(&theirs, 6));
            assert_eq!(found.verdict, Verdict::Explained, "{id} {how}: {found}");
            assert!(
                named(&found).contains(&vec![id, "moved-as-a-whole"]),
                "{id} {how}: {found}"
            );
            assert_eq!(found.mistakes[1].how, how, "{found}");
            assert!(found.error < 1e-4, "{found}");
        }
    }
}

#[test]
fn a_mesh_that_is_right_but_for_its_place_has_no_mistake() {
    let figure = Figure::builtin("adult", turned(71));
    let exact = RIGHT.skin(&figure);
    for (place, how) in PLACES {
        let theirs: Vec<Vec3> = exact.iter().copied().map(place).collect();
        let found = figure.diagnose(&written(&theirs, 6));
        assert_eq!(found.verdict, Verdict::Unexplained, "{how}: {found}");
        assert!(found.causes.is_empty(), "{how}: {found}");
        assert!(
            found.to_string().starts_with("nearly right: "),
            "{how}: {found}"
        );
    }
}

#[test]
fn a_mesh_that_is_placed_otherwise_and_has_two_mistakes_has_none_of_them_named() {
    let figure = Figure::builtin("adult", turned(72));
    let skinned = with(&["euler-zyx", "weights-shifted"]).skin(&figure);
    let theirs: Vec<Vec3> = skinned.into_iter().map(|v| v * 100.0).collect();
    let found = figure.diagnose(&written(&theirs, 6));
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
}

#[test]
fn the_right_mesh_with_another_axis_up_is_that_though_two_mistakes_would_give_it_too() {
    let Some(path) = reference("mannequin/long_cubes.dae") else {
        return;
    };
    let scene = read_dae(&Disk, &path).expect("the reference data").value;
    let character = &scene.characters[0].character;
    let skeleton = character.skeleton();
    let mut pose = Pose::new();
    for (name, degrees) in [
        ("Bone", Vec3::X * 15.0),
        ("Bone.003", Vec3::Y * 60.0),
        ("Bone.005", Vec3::X * -45.0),
    ] {
        let mut joints = skeleton.joints().iter();
        let joint = joints.position(|joint| joint.name == name).unwrap();
        pose.set_joint_transform(joint, Euler::from_degrees(degrees));
    }
    let exact = character.skin_pose(&pose);
    for up in [
        |v: Vec3| Vec3::new(v.x, -v.z, v.y),
        |v: Vec3| Vec3::new(v.x, v.z, -v.y),
    ] {
        let theirs: Vec<Vec3> = exact.iter().copied().map(up).collect();
        let theirs = Mesh::new(written(&theirs, 6), Vec::new());
        let found = diagnose(character, &pose, &theirs).unwrap();
        assert!(found.to_string().starts_with("nearly right: "), "{found}");
        assert!(found.causes.is_empty(), "{found}");
    }
}
