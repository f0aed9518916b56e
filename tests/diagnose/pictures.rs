//! Pictures of mistakes: the student's mesh, drawn as a shape.

use crate::diagnose::figures::{Figure, obj, turned};
use crate::diagnose::student::{RIGHT, Student, with, without_last_joint};
use crate::program::{Ran, editor_in};
use crate::reference_data::course;
use glam::Vec3;
use serde_json::{Value, json};
use std::fmt::Write;
use std::fs;
use tempfile::TempDir;

/// A folder with `theirs.obj`, what a student with the mistakes `ids` makes of `figure`, and its pose.
fn folder(figure: &Figure, ids: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let mut text = String::new();
    for place in with(ids).skin(figure) {
        writeln!(text, "v {} {} {}", place.x, place.y, place.z).unwrap();
    }
    for [a, b, c] in &figure.triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    fs::write(folder.path().join("theirs.obj"), text).unwrap();
    let joints = figure.degrees.iter().enumerate();
    let joints: serde_json::Map<String, Value> = joints
        .map(|(joint, degrees)| (joint.to_string(), json!(degrees.to_array())))
        .collect();
    let pose = json!({ "joints": joints }).to_string();
    fs::write(folder.path().join("pose.json"), pose).unwrap();
    folder
}

/// A folder with `theirs.obj`, which has its vertices at `places`, and the pose of `figure`.
fn folder_with(figure: &Figure, places: &[Vec3]) -> TempDir {
    let folder = folder(figure, &[]);
    fs::write(
        folder.path().join("theirs.obj"),
        obj(places, figure, |number| number.to_string()),
    )
    .unwrap();
    folder
}

/// Runs `editor` with the words of `line`.
fn run(folder: &TempDir, line: &str) -> Ran {
    editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>())
}

/// What is found out about a picture of `theirs.obj` that is drawn with `options`.
fn diagnosed(folder: &TempDir, model: &str, picture: &str, camera: &str, options: &str) -> Value {
    let drawn = format!("render theirs.obj {camera}{options} -o {picture}");
    let ran = run(folder, &drawn);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let line = format!("diagnose {picture} --character {model} --pose pose.json {camera} --json");
    let ran = run(folder, &line);
    let found: Value = serde_json::from_str(&ran.out).unwrap_or_else(|_| panic!("{}", ran.err));
    let code = if found["verdict"] == "right" { 0 } else { 1 };
    assert_eq!(ran.code, Some(code));
    found
}

const FRONT: &str = "--camera 80,10,3";

#[test]
fn a_picture_of_what_is_right_is_right_in_every_format_and_beside_axes() {
    for (name, seed) in [("adult", 41), ("dog", 42)] {
        let folder = folder(&Figure::builtin(name, turned(seed)), &[]);
        let model = format!("builtin:{name}");
        for (picture, camera, options) in [
            ("a.png", FRONT, ""),
            ("a.png", "--view +x", " --samples 4"),
            ("a.jpg", FRONT, ""),
            ("a.gif", "--view -z", " --axis on"),
            ("a.png", FRONT, " --size 2400x1500"),
        ] {
            let found = diagnosed(&folder, &model, picture, camera, options);
            assert_eq!(
                found["verdict"], "right",
                "{picture} {camera}{options}: {found}"
            );
            assert_eq!(
                (&found["causes"], &found["same_as"]),
                (&json!([]), &json!([]))
            );
            assert!(found["sure"].as_f64().unwrap() > 0.5, "{found}");
        }
    }
}

#[test]
fn a_figure_with_nearly_the_color_of_the_background_is_found_where_the_picture_is_exact() {
    let folder = folder(&Figure::builtin("adult", turned(41)), &[]);
    let ran = run(&folder, &format!("render theirs.obj {FRONT} -o a.png"));
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let path = folder.path().join("a.png");
    let mut picture = image::open(&path).unwrap().to_rgba8();
    let background = picture.get_pixel(0, 0).0;
    for pixel in picture.pixels_mut().filter(|pixel| pixel.0 != background) {
        pixel.0 = background;
        pixel.0[1] += 2;
    }
    picture.save(&path).unwrap();
    let line = format!("diagnose a.png --character builtin:adult --pose pose.json {FRONT}");
    let ran = run(&folder, &line);
    assert!(ran.out.starts_with("right, as far as"), "{}", ran.out);
    // A part with the color itself is said to be missing.
    let size = picture.dimensions();
    for (x, _, pixel) in picture.enumerate_pixels_mut() {
        if x > size.0 / 2 {
            pixel.0 = background;
        }
    }
    picture.save(&path).unwrap();
    let told = run(&folder, &line).out;
    assert!(
        told.contains("may have the color of the background"),
        "{told}"
    );
}

#[test]
fn limbs_of_a_figure_that_is_small_in_its_picture_are_seen() {
    // As coarsely as a picture that it fills is looked at, another order of rotations fits as well.
    let figure = Figure::builtin("adult", turned(45));
    let folder = folder(&figure, &["euler-zyx"]);
    let found = diagnosed(&folder, "builtin:adult", "a.png", "--camera 80,10,14", "");
    assert_eq!(found["causes"], json!(["euler-zyx"]), "{found}");
    assert_eq!(found["same_as"], json!([]), "{found}");
}

#[test]
fn a_limb_of_a_small_figure_that_is_not_turned_is_missed_in_its_place() {
    let far = "--camera 80,10,14";
    let degrees = |joint: usize| turned(45)(joint) / 2.0;
    let figure = Figure::builtin("adult", degrees);
    let mut joints = figure.character.skeleton().joints().iter();
    let shoulder = joints.position(|joint| joint.name == "Right shoulder");
    let mut unturned = Figure::builtin("adult", degrees);
    unturned.degrees[shoulder.expect("a joint")] = Vec3::ZERO;
    let folder = folder_with(&figure, &RIGHT.skin(&unturned));
    let found = diagnosed(&folder, "builtin:adult", "a.png", far, " --axis on");
    assert_eq!(found["verdict"], "unexplained", "{found}");
    assert!(found["off_within"].is_array(), "{found}");
    let told = run(
        &folder,
        &format!("diagnose a.png --character builtin:adult --pose pose.json {far}"),
    )
    .out;
    assert!(
        !told.contains("the color of the background"),
        "it is elsewhere: {told}"
    );
    // What is right is right however small it is.
    let folder = folder_with(&figure, &RIGHT.skin(&figure));
    for (picture, options) in [("a.png", " --samples 4"), ("a.jpg", " --axis on")] {
        let found = diagnosed(&folder, "builtin:adult", picture, far, options);
        assert_eq!(found["verdict"], "right", "{picture}{options}: {found}");
    }
}

#[test]
fn a_picture_that_is_written_upside_down_or_mirrored_is_said_to_be() {
    for (mistakes, causes) in [
        (&[][..], &["picture-turned"][..]),
        (&["no-inverse-bind"], &["no-inverse-bind", "picture-turned"]),
    ] {
        let folder = folder(&Figure::builtin("adult", turned(41)), mistakes);
        let ran = run(&folder, &format!("render theirs.obj {FRONT} -o a.png"));
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        let path = folder.path().join("a.png");
        let picture = image::open(&path).unwrap().to_rgba8();
        for (turned, how) in [
            (image::imageops::flip_vertical(&picture), "upside down"),
            (
                image::imageops::flip_horizontal(&picture),
                "left and right exchanged",
            ),
            (image::imageops::rotate180(&picture), "by half a turn"),
        ] {
            turned.save(&path).unwrap();
            let line = "diagnose a.png --character builtin:adult --pose pose.json --json";
            let found: Value =
                serde_json::from_str(&run(&folder, &format!("{line} {FRONT}")).out).unwrap();
            assert_eq!(found["verdict"], "explained", "{found}");
            assert_eq!(found["causes"], json!(causes), "{found}");
            assert_eq!(found["mistakes"][causes.len() - 1]["how"], how, "{found}");
        }
    }
}

#[test]
fn a_joint_that_is_left_out_is_seen_though_the_tip_of_its_spike_is_thinner_than_a_pixel() {
    let figure = Figure::builtin("adult", turned(47));
    let student = Student {
        weights: without_last_joint,
        ..RIGHT
    };
    let folder = folder_with(&figure, &student.skin(&figure));
    for camera in ["--camera 0,10,3", FRONT] {
        let found = diagnosed(&folder, "builtin:adult", "a.png", camera, "");
        assert_eq!(found["causes"][0], "joint-left-out", "{camera}: {found}");
    }
}

#[test]
fn a_floor_is_told_from_a_mistake() {
    let folder = folder(&Figure::builtin("adult", turned(41)), &[]);
    let line = format!("render theirs.obj {FRONT} --look mannequin -o a.png");
    let ran = run(&folder, &line);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let line = format!("diagnose a.png --character builtin:adult --pose pose.json {FRONT}");
    let told = run(&folder, &line).out;
    let floor =
        "of the picture's edge differ from the background: a floor, for one, is taken for a part";
    assert!(
        told.starts_with("unexplained: ") && told.contains(floor),
        "{told}"
    );
}

#[test]
fn a_picture_of_the_bind_pose_is_one_whose_pose_was_not_applied() {
    for (name, seed) in [("adult", 48), ("robot", 49)] {
        let degrees = turned(seed);
        let figure = Figure::builtin(name, |joint| 0.2 * degrees(joint));
        let folder = folder(&figure, &["pose-not-applied"]);
        let found = diagnosed(&folder, &format!("builtin:{name}"), "a.png", FRONT, "");
        assert_eq!(found["mistakes"][0]["id"], "pose-not-applied", "{found}");
        // Angles that are converted twice are hardly any.
        let same = found["same_as"].as_array().unwrap();
        assert!(same.contains(&json!(["radians-as-degrees"])), "{found}");
    }
}

#[test]
fn mistakes_that_move_the_silhouette_are_told_by_it() {
    let all = [
        "weights-shifted",
        "no-inverse-bind",
        "bind-not-inverted",
        "factors-swapped",
        "parent-missing",
        "parent-order",
        "euler-zyx",
        "degrees-as-radians",
        "rotation-transposed",
        "rotation-before-translation",
        "translation-missing",
        "pose-not-applied",
        "one-axis-ignored-x",
        "sign-flipped-y",
    ];
    for (name, seed, ids) in [("adult", 43, &all[..]), ("dog", 44, &all[..5])] {
        let figure = Figure::builtin(name, turned(seed));
        for id in ids {
            let folder = folder(&figure, &[id]);
            let found = diagnosed(&folder, &format!("builtin:{name}"), "a.png", FRONT, "");
            let mut causes = found["causes"].as_array().unwrap().iter();
            let is_named = causes.any(|cause| cause == id);
            assert!(is_named, "{id} on {name}: {found}");
        }
    }
}

#[test]
fn a_picture_that_no_mistake_gives_is_unexplained() {
    let folder = folder(&Figure::builtin("adult", turned(46)), &[]);
    let found = diagnosed(&folder, "builtin:robot", "a.png", FRONT, "");
    assert_eq!(
        (&found["verdict"], &found["causes"]),
        (&"unexplained".into(), &json!([]))
    );
    assert_eq!(found["sure"], 0.0);
    let ran = run(
        &folder,
        "diagnose a.png --character builtin:robot --pose pose.json --camera 80,10,3",
    );
    let told = "of the silhouette is off, and none of the mistakes that are sought in pictures gives this one, nor do two of those that are tried together; where so much is off, the picture may be seen through another camera, or have more around the view\n  shown by the pixels within ";
    assert!(ran.code == Some(1) && ran.out.contains(told), "{}", ran.out);
}

#[test]
fn a_right_picture_through_another_camera_is_told_with_where_the_figure_is() {
    let folder = folder(&Figure::builtin("adult", turned(46)), &[]);
    let ran = run(&folder, &format!("render theirs.obj {FRONT} -o a.png"));
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    // As where the window's edges are elsewhere.
    let path = folder.path().join("a.png");
    let picture = image::open(&path).unwrap().to_rgba8();
    let (width, height) = picture.dimensions();
    let moved = image::RgbaImage::from_fn(width, height, |x, y| {
        *picture.get_pixel((x + width - 15) % width, (y + height - 6) % height)
    });
    moved.save(folder.path().join("moved.png")).unwrap();
    let diagnosed = |picture: &str, model: &str, camera: &str, how: &str| {
        let line = format!("diagnose {picture} --character {model} --pose pose.json {camera}{how}");
        run(&folder, &line).out
    };
    let placed = |picture: &str, model: &str, camera: &str| {
        let out = diagnosed(picture, model, camera, " --json");
        let found: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(found["verdict"], "unexplained", "{camera}: {found}");
        found["placed"].as_str().map(str::to_owned)
    };
    let by = "moved 15 pixels right and 6 pixels down";
    assert_eq!(
        placed("moved.png", "builtin:adult", FRONT).as_deref(),
        Some(by)
    );
    let told = diagnosed("moved.png", "builtin:adult", FRONT, "");
    assert!(told.contains(&format!(
        "; it is the exact one {by}: the picture is seen through"
    )));
    // From nearer.
    let nearer = placed("a.png", "builtin:adult", "--camera 80,10,4.3").expect("it is told");
    assert!(nearer.contains("times as large"), "{nearer}");
    assert_eq!(placed("a.png", "builtin:dog", FRONT), None);
}

#[test]
fn specks_of_a_figure_tell_no_mistake_though_one_that_draws_nothing_there_would_agree() {
    let mut figure = Figure::builtin("adult", turned(46));
    let kept = figure.triangles.iter().step_by(12).copied();
    figure.triangles = kept.collect();
    let folder = folder(&figure, &[]);
    let found = diagnosed(&folder, "builtin:adult", "a.png", FRONT, "");
    assert_eq!(
        (&found["verdict"], &found["causes"]),
        (&"unexplained".into(), &json!([]))
    );
    let ran = run(
        &folder,
        "diagnose a.png --character builtin:adult --pose pose.json --camera 80,10,3",
    );
    let told = "what is drawn are hardly more than lines and specks, which tell no mistake";
    assert!(ran.out.contains(told), "{}", ran.out);
}

#[test]
fn a_file_that_is_neither_a_mesh_nor_a_picture_is_told_to_be_that() {
    let folder = folder(&Figure::builtin("adult", turned(46)), &[]);
    std::fs::write(folder.path().join("a.csv"), "words").unwrap();
    std::fs::write(folder.path().join("a.dat"), "# adult\nv 0 1 2\n").unwrap();
    for (file, found) in [
        ("a.csv", "a file of another kind"),
        ("a.dat", "a mesh whose name does not end in .obj"),
    ] {
        let expected = format!(
            "{file}: expected a mesh (.obj) or a PNG, JPEG or GIF picture, found {found}\n"
        );
        for line in [
            format!("diagnose {file} --character builtin:adult --pose pose.json"),
            format!("compare {file} {file}"),
        ] {
            let ran = run(&folder, &line);
            let told = ran.err.ends_with(&expected);
            assert!(ran.code == Some(1) && told, "{line}: {}", ran.err);
        }
    }
}

#[test]
fn a_picture_of_nothing_and_one_of_another_camera_s_options_are_errors() {
    let folder = folder(&Figure::builtin("adult", turned(47)), &[]);
    let away = "--camera 80,10,3,100,100,100";
    assert_eq!(
        run(&folder, &format!("render theirs.obj {away} -o a.png")).code,
        Some(0)
    );
    let line = "diagnose a.png --character builtin:adult --pose pose.json";
    let ran = run(&folder, line);
    let told =
        "error: a.png: expected a picture of the character, found nothing but the background\n";
    assert_eq!((ran.code, &*ran.out, &*ran.err), (Some(1), "", told));
    let line = "diagnose theirs.obj --character builtin:adult --pose pose.json --view +x";
    let ran = run(&folder, line);
    assert_eq!((ran.code, &*ran.out), (Some(2), ""));
    fs::write(folder.path().join("broken.png"), "no picture").unwrap();
    let line = "diagnose broken.png --character builtin:adult --pose pose.json";
    let ran = run(&folder, line);
    assert_eq!(
        (ran.code, ran.err.lines().count()),
        (Some(1), 1),
        "{}",
        ran.err
    );
}

#[test]
fn a_mistake_of_the_whole_program_is_named_in_a_picture_too() {
    let figure = Figure::builtin("adult", turned(87));
    let wrong_inverse = Student {
        product: |t, b| t.inverse() * b,
        ..RIGHT
    };
    let repeated = Student {
        keep_rotation: |r| r * r,
        ..RIGHT
    };
    let begun = RIGHT.skin(&figure).into_iter().zip(&figure.positions);
    let begun: Vec<Vec3> = begun.map(|(sum, rest)| sum + *rest).collect();
    for (places, id) in [
        (repeated.skin(&figure), "rotation-repeated"),
        (wrong_inverse.skin(&figure), "wrong-inverse"),
        (begun, "sum-begun-at-rest"),
    ] {
        let folder = folder_with(&figure, &places);
        let found = diagnosed(&folder, "builtin:adult", "a.png", "--camera 80,10,6", "");
        assert_eq!(found["verdict"], "explained", "{id}: {found}");
        let causes = found["causes"].as_array().unwrap();
        assert!(causes.contains(&json!(id)), "{id}: {found}");
    }
}

#[test]
fn a_slight_mistake_is_not_to_blame_for_what_a_camera_shows_as_well() {
    let Some(model) = course("characters/Model1.obj") else {
        return;
    };
    let poses = course("poses.json").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let (model, pose) = (model.display(), format!("{}#twist", poses.display()));
    let camera = |theta: f32| format!("--camera {theta},10,1.7,0.5,0.5,0.5");
    let drawn = format!("render {model} --pose {pose} {} -o a.png", camera(70.0));
    assert_eq!(run(&folder, &drawn).code, Some(0));
    let diagnosed = |theta: f32, json: &str| {
        let camera = camera(theta);
        let line = format!("diagnose a.png --character {model} --pose {pose} {camera}{json}");
        run(&folder, &line).out
    };
    let found: Value = serde_json::from_str(&diagnosed(72.0, " --json")).unwrap();
    assert_eq!(found["verdict"], "unexplained", "{found}");
    assert_eq!(found["causes"], json!([]), "{found}");
    let told = diagnosed(72.0, "");
    let expected = "nearly right: 0.1 % of the silhouette is off, as through a camera that is turned by a few degrees; \
                    angles-rounded gives the same\n  shown by";
    assert!(told.contains(expected), "{told}");
    assert!(diagnosed(70.0, "").contains("right, as far as"));
}
