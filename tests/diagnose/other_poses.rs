//! Meshes that are right, but of another pose than the one that they are held against.

use crate::assignment::characters::character;
use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::student::{RIGHT, with};
use crate::reference_data::course;
use editor_core::character::Pose;
use editor_core::diagnose::{Diagnosis, Verdict, diagnose};
use editor_core::geometry::Mesh;
use editor_core::math::Euler;
use glam::Vec3;

/// What is found out about the right mesh of `figure` where `expected` is the pose that is asked for.
fn held_against(figure: &Figure, expected: &Pose) -> Diagnosis {
    figure.diagnose_in(expected, &RIGHT.skin(figure))
}

#[test]
fn a_right_mesh_of_another_pose_is_told_with_the_pose_that_gives_it() {
    for name in ["adult", "dog", "robot"] {
        for (theirs, ours) in [(1, 2), (3, 4)] {
            let figure = Figure::builtin(name, turned(theirs));
            let expected = Figure::builtin(name, turned(ours)).pose();
            let found = held_against(&figure, &expected);
            assert_eq!(found.verdict, Verdict::OtherPose, "{name}: {found}");
            let json = serde_json::to_value(&found).unwrap();
            assert_eq!(json["verdict"], "other-pose");
            let told = found.to_string();
            assert!(told.starts_with("another pose: "), "{name}: {told}");
            let other = found.other_pose.expect("a pose");
            assert!(
                found.nearest.is_none(),
                "{name}: nothing is left to be near to"
            );
            // In that pose it is right.
            let found = held_against(&figure, &other.pose);
            assert_eq!(found.verdict, Verdict::Right, "{name}: {found}");
        }
    }
}

#[test]
fn a_mesh_that_is_held_against_the_character_at_rest_shows_its_pose() {
    let figure = Figure::builtin("adult", turned(5));
    let by = Vec3::new(0.3, -0.2, 0.5);
    let theirs: Vec<Vec3> = RIGHT.skin(&figure).iter().map(|at| *at + by).collect();
    let found = figure.diagnose_in(&Pose::new(), &theirs);
    let other = found.other_pose.expect("a pose");
    assert!(other.joints.len() > 10, "{:?}", other.joints);
    let root = &other.joints[0];
    let moved = Vec3::from(root.moved.expect("the root is moved"));
    assert!(moved.abs_diff_eq(by, 1e-4), "{moved}");
}

#[test]
fn angles_of_another_pose_are_without_the_noise_of_the_fit_as_they_were_typed() {
    // Of a tenth of a degree, a hundredth, and so on.
    let typed = Figure::builtin("adult", |joint| turned(6)(joint) * Vec3::new(0.0, 0.1, 1.0));
    let expected = Figure::builtin("adult", turned(7)).pose();
    let found = typed.diagnose_in(&expected, &written(&RIGHT.skin(&typed), 4));
    let other = found.other_pose.expect("a pose");
    let joints: Vec<usize> = other.joints.iter().map(|joint| joint.joint_index).collect();
    assert!(joints.len() > 10, "{joints:?}");
    for joint in other.joints.iter().filter(|joint| !joint.is_ambiguous) {
        let index = joint.joint_index;
        let tenths = typed.degrees[index].map(|angle| (angle * 10.0).round() / 10.0);
        let off = (Vec3::from(joint.degrees) - tenths).abs().max_element();
        assert!(off < 1e-5, "{}: {off}", joint.joint);
        assert_eq!(other.pose.rotation(index).radians.x, 0.0, "{}", joint.joint);
    }
}

#[test]
fn of_one_joint_that_is_turned_otherwise_this_one_alone_is_told() {
    for name in ["adult", "dog", "robot"] {
        let figure = Figure::builtin(name, turned(24));
        let joints = figure.character.skeleton().joints();
        for (joint, described) in joints.iter().enumerate() {
            let mut expected = figure.pose();
            let before = expected.rotation(joint).degrees();
            let other = Euler::from_degrees(before + Vec3::new(25.0, -30.0, 10.0));
            expected.set_joint_transform(joint, other);
            let found = held_against(&figure, &expected);
            // Joints that move no vertex, such as ends of limbs, show no angle, and a mesh that is turned as a whole
            // is told to be.
            if found.verdict != Verdict::Right && found.findings.is_empty() {
                let case = format!("{name}, {}: {found}", described.name);
                let other = found.other_pose.expect(&case);
                let told: Vec<usize> = other.joints.iter().map(|it| it.joint_index).collect();
                assert_eq!(told, [joint], "{case}");
            }
        }
    }
}

#[test]
fn a_joint_that_was_not_turned_is_told_before_two_mistakes_that_come_to_the_same() {
    let figure = Figure::builtin("adult", |_| Vec3::ZERO);
    let joints = figure.character.skeleton().joints();
    let posed = |turned: &[(&str, [f32; 3])]| {
        let mut pose = Pose::new();
        for (name, degrees) in turned {
            let joint = joints.iter().position(|joint| joint.name == *name);
            let rotation = Euler::from_degrees(Vec3::from(*degrees));
            pose.set_joint_transform(joint.expect("the joint"), rotation);
        }
        pose
    };
    let (leg, elbow) = (
        ("Left leg", [30.0, 22.5, 0.0]),
        ("Left elbow", [4.9, -18.6, 143.9]),
    );
    let expected = posed(&[leg, elbow]);
    // Weights that are shifted by one joint, of joints in another order, give the same.
    let found = figure.diagnose_in(&expected, &figure.character.skin_pose(&posed(&[leg])));
    let other = found.other_pose.as_ref().expect("a pose");
    let told: Vec<&str> = other.joints.iter().map(|joint| &*joint.joint).collect();
    assert_eq!(told, ["Left elbow"], "{found}");

    // One mistake gives it, too: both are told.
    let found = figure.diagnose_in(&expected, &figure.character.skin_pose(&posed(&[elbow])));
    assert_eq!(found.causes, ["joints-not-reached"], "{found}");
    assert_eq!(found.not_turned, ["Left leg"]);
    let text = found.to_string();
    let or = "\n  or       it is right, but of a pose in which Left leg is not turned";
    assert!(text.ends_with(or), "{text}");

    // That the root is not turned is a mistake by itself.
    let root = ("Root", [0.0, 40.0, 0.0]);
    let expected = posed(&[root, leg, elbow]);
    let found = figure.diagnose_in(
        &expected,
        &figure.character.skin_pose(&posed(&[leg, elbow])),
    );
    assert!(found.causes.contains(&"root-angles-missing"), "{found}");
    assert_eq!(found.not_turned, [""; 0]);
}

#[test]
fn a_joint_that_is_turned_by_a_hair_is_told_alone_and_with_digits_that_show_it() {
    let mut figure = Figure::builtin("adult", |_| Vec3::ZERO);
    let joint = |name: &str| {
        let mut joints = figure.character.skeleton().joints().iter();
        joints.position(|joint| joint.name == name).unwrap()
    };
    let (neck, elbow) = (joint("Neck"), joint("Left elbow"));
    figure.degrees[neck] = Vec3::new(0.0, 40.0, 0.0);
    figure.degrees[elbow] = Vec3::new(-4.73, -9.13, 59.96);
    let mut expected = figure.pose();
    let other = Vec3::new(-4.73, -9.13, 60.02);
    expected.set_joint_transform(elbow, Euler::from_degrees(other));
    let found = held_against(&figure, &expected);
    let told = "\n  turned   Left elbow (-4.73°, -9.13°, 59.96°) instead of (-4.73°, -9.13°, 60.02°)\n  look at";
    assert!(found.to_string().contains(told), "{found}");
}

#[test]
fn a_joint_at_rest_is_told_without_what_three_digits_add_to_its_angles() {
    let Some(path) = course("characters/Model1.obj") else {
        return;
    };
    let elbow = 17;
    let walk = |of_elbow: Vec3| {
        move |joint: usize| match joint {
            0 => Vec3::new(5.0, 20.0, -8.0),
            1 => Vec3::new(12.0, -9.0, 10.0),
            3 => Vec3::new(0.0, 25.0, 10.0),
            5 => Vec3::new(-35.0, 8.0, 5.0),
            6 => Vec3::new(30.0, 5.0, 0.0),
            9 => Vec3::new(25.0, -6.0, 10.0),
            10 => Vec3::new(20.0, 0.0, 12.0),
            13 => Vec3::new(20.0, -15.0, 50.0),
            14 => Vec3::new(15.0, 30.0, 20.0),
            16 => Vec3::new(-30.0, 12.0, -40.0),
            17 => of_elbow,
            _ => Vec3::ZERO,
        }
    };
    let expected = Figure::new(&path, walk(Vec3::new(-20.0, 40.0, 35.0))).pose();
    let figure = Figure::new(&path, walk(Vec3::ZERO));
    let found = figure.diagnose_in(&expected, &written(&RIGHT.skin(&figure), 3));
    let other = found.other_pose.expect("another pose");
    let told: Vec<usize> = other.joints.iter().map(|it| it.joint_index).collect();
    assert_eq!(told, [elbow]);
    assert_eq!(other.joints[0].degrees, [0.0; 3]);
}

#[test]
fn angles_that_a_mesh_shows_are_without_what_single_precision_adds_to_them() {
    let mut figure = Figure::builtin("adult", turned(87));
    let mut joints = figure.character.skeleton().joints().iter();
    let hip = joints.position(|joint| joint.name == "Right hip").unwrap();
    for theirs in [Vec3::ZERO, Vec3::new(20.0, 30.0, -10.0)] {
        figure.degrees[hip] = Vec3::new(35.0, -15.0, 45.0);
        let expected = figure.pose();
        figure.degrees[hip] = theirs;
        let found = figure.diagnose_in(&expected, &written(&RIGHT.skin(&figure), 6));
        let other = found.other_pose.expect("another pose");
        assert_eq!(other.pose.rotation(hip), Euler::from_degrees(theirs));
        assert_eq!(other.pose.is_changed(hip), theirs != Vec3::ZERO);
    }
}

#[test]
fn angles_beyond_half_a_turn_are_told_as_the_panel_shows_them() {
    let mut figure = Figure::builtin("adult", |_| Vec3::ZERO);
    let mut joints = figure.character.skeleton().joints().iter();
    let neck = joints.position(|joint| joint.name == "Neck").unwrap();
    figure.degrees[neck] = Vec3::new(0.0, 400.0, 0.0);
    let expected = figure.pose();
    figure.degrees[neck] = Vec3::new(0.0, -20.0, 180.0);
    let found = held_against(&figure, &expected);
    let told = "Neck (0°, -20°, 180°) instead of (0°, 40°, 0°)";
    assert!(found.to_string().contains(told), "{found}");
}

#[test]
fn of_many_joints_that_are_turned_otherwise_no_other_is_told_and_the_largest_turn_comes_first() {
    let ours = Figure::builtin("adult", |_| Vec3::ZERO);
    let path = course("characters/Model1.obj");
    let theirs = path.map(|path| Figure::new(&path, |_| Vec3::ZERO));
    for figure in theirs.into_iter().chain([ours]) {
        the_joints_that_differ_are_told(&figure);
    }
}

fn the_joints_that_differ_are_told(figure: &Figure) {
    let joints = figure.character.skeleton().joints();
    let index = |name: &str| {
        let mut names = joints.iter().map(|joint| &*joint.name);
        names.position(|known| known == name).expect(name)
    };
    // A walk is expected, and a neck and an elbow were turned.
    let mut expected = Pose::new();
    for (joint, x) in [
        ("Right leg", -35.0),
        ("Right knee", 30.0),
        ("Left leg", 25.0),
        ("Left knee", 35.0),
        ("Right shoulder", 25.0),
        ("Right elbow", -40.0),
        ("Left shoulder", -25.0),
        ("Left elbow", -20.0),
    ] {
        expected.set_joint_transform(index(joint), Euler::from_degrees(Vec3::X * x));
    }
    let mut differing: Vec<usize> = (0..joints.len())
        .filter(|&joint| expected.rotation(joint) != Euler::default())
        .collect();
    let mut theirs = Pose::new();
    theirs.set_joint_transform(index("Neck"), Euler::from_degrees(Vec3::Y * 20.0));
    theirs.set_joint_transform(index("Left elbow"), Euler::from_degrees(Vec3::Z * 50.0));
    differing.push(index("Neck"));
    differing.sort_unstable();
    let found = figure.diagnose_in(&expected, &figure.character.skin_pose(&theirs));
    let other = found.other_pose.as_ref().expect("a pose");
    let mut told: Vec<usize> = other.joints.iter().map(|joint| joint.joint_index).collect();
    told.sort_unstable();
    assert_eq!(told, differing, "{found}");
    let text = found.to_string();
    assert!(text.contains("turned   Left elbow (0°, 0°, 50°)"), "{text}");
}

#[test]
fn angles_that_two_joints_in_one_place_share_are_said_not_to_be_the_only_ones() {
    let mut obj = String::new();
    for at in 0..40 {
        let [x, y, z] = [7, 11, 13].map(|step| (at * step % 41) as f32 / 41.0);
        obj += &format!("v {x} {} {z}\n", 2.0 * y);
    }
    let attach: String = (0..40)
        .map(|at| if at % 2 == 0 { "1 0\n" } else { "0.2 0.8\n" })
        .collect();
    let body = character(
        "0 0 0 -1 # Root\n0 0 0 0 # Base\n0 1 0 1 # Tip\n",
        &attach,
        &(obj + "f 1 2 3\n"),
    );
    let pose = |base: Vec3, tip: Vec3| {
        let mut pose = Pose::new();
        pose.set_joint_transform(1, Euler::from_degrees(base));
        pose.set_joint_transform(2, Euler::from_degrees(tip));
        pose
    };
    let theirs = body.skin_pose(&pose(
        Vec3::new(20.0, 30.0, 10.0),
        Vec3::new(0.0, 0.0, 50.0),
    ));
    let theirs = Mesh::new(theirs, body.bind_mesh().triangles.clone());
    let expected = pose(Vec3::new(20.0, 0.0, 0.0), Vec3::new(40.0, 0.0, 0.0));
    let found = diagnose(&body, &expected, &theirs).unwrap();
    let other = found.other_pose.as_ref().unwrap();
    for joint in &other.joints {
        assert_eq!(joint.is_ambiguous, joint.joint != "Tip", "{found}");
    }
    assert!(other.joints.len() > 1, "{found}");
    assert!(
        found
            .to_string()
            .contains("°), or others that give the same\n"),
        "{found}"
    );
}

#[test]
fn a_torso_that_is_not_turned_is_told_as_joints_at_rest_though_others_could_share_their_turns() {
    // The chest and the neck are where the root is, as in the course's characters.
    let mut obj = String::new();
    for at in 0..60 {
        let [x, y, z] = [7, 11, 13].map(|step| (at * step % 61) as f32 / 61.0);
        obj += &format!("v {x} {} {z}\n", 2.0 * y);
    }
    let attach: String = (0..60)
        .map(|at| ["1 0 0\n", "0 1 0\n", "0.2 0 0.8\n"][at % 3])
        .collect();
    let body = character(
        "0 0 0 -1 # Root\n0 0 0 0 # Chest\n0 0 0 0 # Neck\n0 1 0 1 # Arm\n",
        &attach,
        &(obj + "f 1 2 3\n"),
    );
    let turned = |joint: usize, degrees: Vec3, pose: &mut Pose| {
        pose.set_joint_transform(joint, Euler::from_degrees(degrees));
    };
    let mut theirs = Pose::new();
    turned(2, Vec3::new(20.0, -30.0, 5.0), &mut theirs);
    turned(3, Vec3::new(0.0, 0.0, 70.0), &mut theirs);
    let mut expected = theirs.clone();
    turned(0, Vec3::new(0.0, 30.0, 0.0), &mut expected);
    turned(1, Vec3::new(10.0, 15.0, 5.0), &mut expected);
    let mesh = Mesh::new(body.skin_pose(&theirs), body.bind_mesh().triangles.clone());
    let found = diagnose(&body, &expected, &mesh).unwrap();
    let other = found.other_pose.as_ref().expect("a pose");
    let mut told: Vec<&str> = other.joints.iter().map(|joint| &*joint.joint).collect();
    told.sort_unstable();
    assert_eq!(told, ["Chest", "Root"], "{found}");
    for joint in &other.joints {
        let degrees = Vec3::from(joint.degrees);
        assert!(degrees.abs_diff_eq(Vec3::ZERO, 0.01), "{joint}");
    }
    // Of four joints that are asked for, two are as asked.
    assert_eq!((other.as_expected, other.posed_joints), (0.5, 4));
}

#[test]
fn a_root_that_few_vertices_go_with_is_told_and_not_its_children() {
    // Its weights do not sum to one, so that the mesh is not turned as a whole.
    let Some(path) = course("characters/Model1.obj") else {
        return;
    };
    let degrees = turned(26);
    let figure = Figure::new(&path, |joint| match joint {
        0 => Vec3::Y * 10.0,
        joint => degrees(joint),
    });
    let mut expected = figure.pose();
    expected.set_joint_transform(0, Euler::from_degrees(Vec3::new(0.0, 50.0, 0.0)));
    let found = held_against(&figure, &expected);
    let other = found.other_pose.expect("a pose");
    let told: Vec<String> = other.joints.iter().map(ToString::to_string).collect();
    // The chest and the hips are where the root is, and could share the turn.
    let root = "Root (0°, 10°, 0°) instead of (0°, 50°, 0°), or others that give the same";
    assert_eq!(told, [root]);
}

#[test]
fn of_two_joints_that_are_turned_otherwise_these_two_are_told_with_their_angles() {
    let figure = Figure::builtin("adult", turned(21));
    let mut expected = figure.pose();
    let joints = figure.character.skeleton().joints();
    let index = |name: &str| joints.iter().position(|joint| joint.name == name).unwrap();
    let (elbow, knee) = (index("Right elbow"), index("Left knee"));
    expected.set_joint_transform(elbow, Euler::from_degrees(Vec3::new(5.0, -10.0, 20.0)));
    expected.set_joint_transform(knee, Euler::ZERO);
    let other = held_against(&figure, &expected).other_pose.expect("a pose");
    let mut told: Vec<usize> = other.joints.iter().map(|joint| joint.joint_index).collect();
    told.sort_unstable();
    let mut both = [elbow, knee];
    both.sort_unstable();
    assert_eq!(told, both);
    for joint in &other.joints {
        let (found, real) = (Vec3::from(joint.degrees), figure.degrees[joint.joint_index]);
        let [found, real] = [found, real].map(|angles| Euler::from_degrees(angles).to_mat3());
        assert!(found.abs_diff_eq(real, 1e-3), "{joint}");
        assert_eq!(joint.moved, None);
    }
    let elbow = other.joints.iter().find(|joint| joint.joint_index == elbow);
    assert!(
        elbow
            .unwrap()
            .to_string()
            .ends_with(" instead of (5°, -10°, 20°)")
    );
}

#[test]
fn joints_that_are_at_rest_in_both_poses_are_left_at_rest() {
    let posed = |waist: Vec3, elbow: Vec3| {
        move |joint: usize| match joint {
            1 => waist,
            17 => elbow,
            _ => Vec3::ZERO,
        }
    };
    let theirs = posed(Vec3::new(-2.0, 9.0, 20.0), Vec3::new(-15.0, 40.0, -2.0));
    let ours = posed(Vec3::new(-2.0, -9.0, 20.0), Vec3::new(-15.0, -13.0, -2.0));
    let figure = Figure::builtin("adult", theirs);
    let found = held_against(&figure, &Figure::builtin("adult", ours).pose());
    let other = found.other_pose.expect("a pose");
    let told: Vec<usize> = other.joints.iter().map(|joint| joint.joint_index).collect();
    assert_eq!(told, [1, 17]);
    for joint in (0..figure.degrees.len()).filter(|joint| ![1, 17].contains(joint)) {
        assert!(!other.pose.is_changed(joint), "{joint}");
    }
}

#[test]
fn numbers_of_four_digits_are_enough_to_see_another_pose() {
    let figure = Figure::builtin("adult", turned(6));
    let theirs = written(&RIGHT.skin(&figure), 4);
    let expected = Figure::builtin("adult", turned(7)).pose();
    let found = figure.diagnose_in(&expected, &theirs);
    assert!(found.other_pose.is_some(), "{found}");
}

#[test]
fn a_mesh_that_no_pose_gives_is_not_said_to_be_of_another_one() {
    let figure = Figure::builtin("adult", turned(8));
    let expected = Figure::builtin("adult", turned(9)).pose();
    let right = RIGHT.skin(&figure);
    let bent = right
        .iter()
        .map(|at| *at + Vec3::Y * 0.01 * (at.x * 40.0).sin());
    let not_finite = right
        .iter()
        .map(|at| if *at == right[7] { Vec3::NAN } else { *at });
    let wide = Vec3::new(1.2, 1.0, 1.0);
    for (what, theirs) in [
        ("bent", bent.collect()),
        ("not finite", not_finite.collect()),
        (
            "with a mistake besides",
            with(&["weights-shifted"]).skin(&figure),
        ),
        ("larger", right.iter().map(|at| *at * 1.1).collect()),
        (
            "wider",
            right.iter().map(|at| *at * wide).collect::<Vec<_>>(),
        ),
    ] {
        let found = figure.diagnose_in(&expected, &theirs);
        assert_eq!(found.verdict, Verdict::Unexplained, "{what}");
        assert_eq!(found.other_pose, None, "{what}");
        let text = found.to_string();
        let is_told = text.starts_with("unexplained: ") && text.contains("in this pose");
        assert!(is_told, "{what}: {text}");
    }
}
