//! Scenes of version 2 that are wrong, and scenes that cannot be written.

use super::support::{SCENE, files, read};
use editor_core::character::Pose;
use editor_core::geometry::{SharedMesh, cube};
use editor_core::io::{Missing, scene_text};
use editor_core::math::Euler;
use editor_core::scene::{CharacterShape, NewShape, Scene, ShapeKind, ViewSettings};
use glam::Vec3;
use std::path::PathBuf;

const VERSION_2: &str = include_str!("version_2.scene");

/// Message for `good` replaced by `bad` in the scene.
fn fault(good: &str, bad: &str) -> String {
    let text = VERSION_2.replacen(good, bad, 1);
    assert_ne!(text, VERSION_2, "{good}");
    let mut files = files();
    files.0.insert(PathBuf::from(SCENE), text.into_bytes());
    read(&files, SCENE, Missing::Refuse).expect_err(bad)
}

#[test]
fn each_fault_is_told_where_it_is() {
    let mut wrong = Vec::new();
    for (good, bad, message) in [
        (
            "\"name\": \"Floor\"",
            "\"title\": \"Floor\"",
            "21:7: expected one of `name`, `kind`, `source`, `placement`, `start`, `visible`, `locked`, `character`, `curves`, found “title”",
        ),
        (
            "\"cube\"",
            "\"curve\"",
            "22:15: expected one of `cube`, `sphere`, `pyramid`, `teapot`, `icosahedron`, `custom`, found “curve”",
        ),
        (
            "      \"kind\": \"cube\",\n",
            "",
            "20:5: shape 1: expected a kind, a source or curves, found none of them",
        ),
        (
            "\"8c665056\"",
            "\"8c66505\"",
            "36:24: expected eight hexadecimal digits, found “8c66505”",
        ),
        (
            "\"character\",\n",
            "\"rig\",\n",
            "35:21: expected one of `shape`, `character`, `curve`, found “rig”",
        ),
        (
            "\"../rigs/man.obj\"",
            "\"\"",
            "34:17: expected the name of a file, found an empty one",
        ),
        (
            "\"length\": 3",
            "\"length\": 0",
            "65:21: expected a length from 1 to 999, found 0",
        ),
        (
            "\"length\": 3",
            "\"length\": -3",
            "65:21: expected a whole number from 0, found -3",
        ),
        (
            "-400]",
            "-1e300]",
            "49:29: expected an angle below 3.4e38 radians, found a larger one",
        ),
        (
            "-400]",
            "-400, 1]",
            "49:18: expected three numbers [x, y, z], found 4",
        ),
        (
            "\"A\": [0",
            "\"B\": [0",
            "49:13: shape 2: expected the name or index of a joint, such as “2”, “A”, “#2”, found “B”",
        ),
        (
            "\"Wave\"",
            "\"At rest\"",
            "58:11: expected each name once, found “At rest” again",
        ),
        (
            "\"steps\": 20",
            "\"steps\": 4000000",
            "111:11: shape 4: expected 1 to 10000 steps, found 4000000",
        ),
        (
            "\"flat\": true",
            "\"radius\": 2",
            "111:11: shape 4: expected no `radius` in it, found one",
        ),
        (
            "            \"radius\": 0.05\n",
            "            \"flat\": false\n",
            "134:11: shape 4: expected no `flat` in it, found one",
        ),
        (
            "[0.9, 1, 0]",
            "[0.9, 1, 2]",
            "111:11: shape 4: expected z = 0 in a flat curve, found 2",
        ),
        (
            "[0.9, 1, 0]",
            "[0.9, 1]",
            "120:15: expected three numbers [x, y, z], found 2",
        ),
        (
            "\"sweep\": 1",
            "\"sweep\": 4",
            "146:11: shape 4: expected the index of a curve, found 4",
        ),
        (
            "\"profile\": 2",
            "\"profile\": 1",
            "146:11: shape 4: expected a profile in the plane z = 0, found “way”, which leaves it",
        ),
        (
            "\"sweep\": 1",
            "\"sweep\": 9000000000",
            "150:22: expected a whole number from 0, found 9000000000",
        ),
        (
            "\"phi\": -8.25",
            "\"phi\": \"up\"",
            "9:14: expected a number, found “up”",
        ),
        (
            "\"near\": 0.1",
            "\"near\": 100",
            "5:15: expected near < far, found 100 and 100",
        ),
    ] {
        let error = fault(good, bad);
        if error != format!("{SCENE}:{message}") {
            wrong.push((bad, error, message));
        }
    }
    assert_eq!(wrong, []);
}

#[test]
fn what_a_scene_names_and_is_not_there_is_told_with_the_place_that_names_it() {
    for (good, bad, message) in [
        (
            "\"../rigs/man.obj\"",
            "\"../rigs/woman.obj\"",
            "/home/ada/scenes/a.scene:31:5: shape 2: /home/ada/rigs/woman.obj: there is no such file",
        ),
        (
            "\"box.obj\"",
            "\"crate.obj\"",
            "/home/ada/scenes/a.scene:82:5: shape 3: /home/ada/scenes/crate.obj: there is no such file",
        ),
        (
            "\"box.obj\",",
            "\"box.obj\", \"part\": 2,",
            "/home/ada/scenes/a.scene:82:5: shape 3: /home/ada/scenes/box.obj: expected a shape 3 in it, found 1 shape",
        ),
    ] {
        assert_eq!(fault(good, bad), message);
    }
}

#[test]
fn a_scene_that_could_not_be_read_again_is_not_written() {
    let view = ViewSettings::default();
    let written = |shape: NewShape| {
        let scene = Scene::from_iter([NewShape::new("A", ShapeKind::Cube), shape]);
        scene_text(&scene, &view, None).unwrap_err().to_string()
    };
    let mut sphere = NewShape::new("Ball", ShapeKind::Sphere);
    sphere.placement.transform.position.y = f32::INFINITY;
    assert_eq!(
        written(sphere.clone()),
        "shape 2, “Ball”: expected finite numbers, found others in placement.position"
    );
    sphere.placement = sphere.start;
    sphere.start.transform.rotation = Euler::from_radians(Vec3::NAN);
    assert_eq!(
        written(sphere),
        "shape 2, “Ball”: expected finite numbers, found others in start.rotation"
    );
    let mesh = ShapeKind::Mesh(SharedMesh::new(cube()));
    assert_eq!(
        written(NewShape::new("Made", mesh)),
        "shape 2, “Made”: expected the file that it came from, found none"
    );
    let mut view = view;
    view.camera.near = view.camera.far;
    let error = scene_text(&Scene::new(), &view, None).unwrap_err();
    assert_eq!(
        error.to_string(),
        "expected a camera of finite numbers that sees something, found another"
    );
}

#[test]
fn a_pose_that_is_not_finite_is_named_by_its_joint() {
    let (mut scene, view, _) = {
        let mut files = files();
        files.0.insert(PathBuf::from(SCENE), VERSION_2.into());
        read(&files, SCENE, Missing::Refuse).unwrap()
    };
    let man = scene.shapes()[1].id;
    let shape: &mut CharacterShape = scene.character_mut(man).unwrap();
    let mut pose = Pose::new();
    pose.set_joint_transform(1, Euler::from_radians(Vec3::X * f32::NAN));
    shape.set_pose(pose);
    let error = scene_text(&scene, &view, None).unwrap_err().to_string();
    assert_eq!(
        error,
        "shape 2, “Man”: expected finite numbers, found others in character.pose.joints.A"
    );
}
