//! Files that are gone, have changed, or lack what they had.

use super::support::{FOLDER, MAN, OLD_SCENE, SCENE, Table, VASE, assert_same, files, read};
use editor_core::character::Pose;
use editor_core::io::{Missing, import_any, reimport, scene_text};
use editor_core::math::Euler;
use editor_core::scene::{Scene, ShapeKind, ViewSettings};
use glam::Vec3;
use std::path::{Path, PathBuf};

const VERSION_2: &str = include_str!("version_2.scene");

fn with_scene(text: &str) -> Table {
    let mut files = files();
    files.0.insert(PathBuf::from(SCENE), text.into());
    files
}

fn lenient(files: &Table) -> (Scene, ViewSettings, Vec<String>) {
    read(files, SCENE, Missing::StandIn).unwrap()
}

fn text(scene: &Scene, view: &ViewSettings) -> String {
    scene_text(scene, view, Some(Path::new(FOLDER))).unwrap()
}

#[test]
fn a_missing_file_is_told_stood_in_for_and_saved_as_it_was() {
    let mut files = with_scene(VERSION_2);
    files.0.remove(Path::new(MAN));
    assert!(read(&files, SCENE, Missing::Refuse).is_err());
    let (scene, view, warnings) = lenient(&files);
    assert_eq!(
        warnings,
        ["/home/ada/scenes/a.scene:31:5: shape 2: /home/ada/rigs/man.obj: there is no such file"]
    );
    let man = &scene.shapes()[1];
    let ShapeKind::Missing(missing) = &man.kind else {
        panic!("{:?}", man.kind);
    };
    assert_eq!(
        missing.reason,
        "/home/ada/rigs/man.obj: there is no such file"
    );
    assert_eq!(man.kind.mesh().triangles.len(), 12);
    assert_eq!(text(&scene, &view), VERSION_2);
}

#[test]
fn a_file_that_is_found_elsewhere_gives_back_pose_kept_poses_pins_and_display() {
    let files = with_scene(VERSION_2);
    let (whole, ..) = read(&files, SCENE, Missing::Refuse).unwrap();
    let mut moved = files.clone();
    for extension in ["obj", "skel", "attach"] {
        let old = Path::new(MAN).with_extension(extension);
        let bytes = moved.0.remove(&old).unwrap();
        let new = Path::new("/elsewhere/figure").with_extension(extension);
        moved.0.insert(new, bytes);
    }
    let (mut scene, ..) = lenient(&moved);
    let id = scene.shapes()[1].id;
    assert!(reimport(&moved, &scene, id, None).is_err());
    let at = Path::new("/elsewhere/figure.obj");
    let found = reimport(&moved, &scene, id, Some(at)).unwrap().value;
    assert_eq!(found.source.file, "/elsewhere/figure.obj");
    let shape = scene.shape_mut(id).unwrap();
    shape.kind = found.kind;
    // All but the place is as before.
    shape.source = whole.shapes()[1].source.clone();
    assert_same(&scene, &whole, "");
}

#[test]
fn a_file_that_has_changed_is_told_once() {
    let mut files = with_scene(VERSION_2);
    let skel = Path::new("/home/ada/rigs/man.skel");
    files.0.get_mut(skel).unwrap().extend(b"# more\n");
    let (_, _, warnings) = read(&files, SCENE, Missing::Refuse).unwrap();
    let changed: Vec<&String> = warnings.iter().filter(|w| w.contains("changed")).collect();
    assert_eq!(
        changed,
        ["/home/ada/rigs/man.obj: this file has changed since the scene was saved"]
    );
}

#[test]
fn a_reload_keeps_the_pose_by_the_names_of_joints_and_tells_which_are_gone() {
    let mut files = files();
    let skel = "0 0 0 -1 # Root\n0 1 0 0 # Arm\n0 1 0 1 # Hand\n0 1 0 2 # Finger\n0 1 0 3 # Nail\n";
    let path = PathBuf::from("/home/ada/rigs/man.skel");
    files.0.insert(path.clone(), skel.into());
    let imported = import_any(&files, Path::new(MAN)).unwrap().value;
    let mut scene = Scene::from_iter(imported);
    let id = scene.shapes()[0].id;
    let shape = scene.character_mut(id).unwrap();
    let turn = |degrees: f32| Euler::from_degrees(Vec3::X * degrees);
    let mut pose = Pose::new();
    pose.set_joint_transform(1, turn(10.0));
    pose.set_joint_transform(2, turn(20.0));
    pose.set_joint_transform(3, turn(30.0));
    shape.set_pose(pose);
    shape.keep_pose("Bent".to_owned());
    shape.ik.pins = [2, 3].into();

    // A joint comes first, and another has a new name.
    let skel = skel
        .replace("0 1 0 0 # Arm", "0 0 1 0 # Tail\n0 1 0 0 # Arm")
        .replace("0 1 0 1 # Hand", "0 1 0 2 # Paw")
        .replace("0 1 0 2 # Finger", "0 1 0 3 # Finger")
        .replace("0 1 0 3 # Nail\n", "");
    files.0.insert(path, skel.into());
    let again = reimport(&files, &scene, id, None).unwrap();
    let warnings: Vec<String> = again.warnings.iter().map(ToString::to_string).collect();
    // In the pose, in the kept pose, and as a pin.
    let gone = "/home/ada/rigs/man.obj: expected the name or index of a joint, such as “Arm”, “Paw”, “Tail”, found “Hand”";
    assert_eq!(warnings, [gone; 3]);
    scene.shape_mut(id).unwrap().kind = again.value.kind;
    let shape = scene.character(id).unwrap();
    for pose in [shape.pose(), &shape.poses()[0].pose] {
        let turned: Vec<_> = (0..5).map(|joint| pose.rotation(joint)).collect();
        let rest = Euler::ZERO;
        assert_eq!(turned, [rest, rest, turn(10.0), rest, turn(30.0)]);
    }
    assert!(shape.ik.pins.iter().eq([4].iter()), "{:?}", shape.ik);
}

#[test]
fn a_joint_that_is_gone_is_an_error_to_commands_and_a_warning_in_the_window() {
    let mut files = with_scene(VERSION_2);
    let skel = "0 0 0 -1 # Root\n0 1 0 0 # B\n0 1 0 1 # C\n0 1 0 2 # 2\n0 1 0 3 # #2\n";
    files
        .0
        .insert("/home/ada/rigs/man.skel".into(), skel.into());
    let error = read(&files, SCENE, Missing::Refuse).unwrap_err();
    assert!(
        error.starts_with("/home/ada/scenes/a.scene:49:13: shape 2: expected"),
        "{error}"
    );
    let (scene, _, warnings) = lenient(&files);
    let warning = error + "; what is saved of it is kept until Reset Pose and Unpin All Joints";
    assert!(warnings.contains(&warning), "{warnings:?}");
    let shape = scene.character(scene.shapes()[1].id).unwrap();
    let turned = shape.pose().rotation(2);
    assert_eq!(turned, Euler::from_degrees(Vec3::new(90.0, 0.0, 0.0)));
}

#[test]
fn a_missing_file_of_version_1_is_kept_too() {
    let version_1 = include_str!("version_1.scene");
    let mut files = files();
    files.0.insert(OLD_SCENE.into(), version_1.into());
    let (whole, ..) = read(&files, OLD_SCENE, Missing::Refuse).unwrap();
    let [man, vase] = [MAN, VASE].map(|path| files.0.remove(Path::new(path)).unwrap());
    let (scene, view, warnings) = read(&files, OLD_SCENE, Missing::StandIn).unwrap();
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    // Saved, which makes it version 2, and opened when the files are back.
    files.0.insert(SCENE.into(), text(&scene, &view).into());
    let (still, ..) = lenient(&files);
    assert_same(&still, &scene, "");
    files.0.insert(MAN.into(), man);
    files.0.insert(VASE.into(), vase);
    let (read, ..) = read(&files, SCENE, Missing::Refuse).unwrap();
    assert_same(&read, &whole, "");
}

#[test]
fn curves_are_in_the_scene_and_miss_no_file() {
    let mut files = with_scene(VERSION_2);
    files.0.remove(Path::new(VASE));
    let (scene, view, _) = read(&files, SCENE, Missing::Refuse).unwrap();
    assert_eq!(text(&scene, &view), VERSION_2);
}
