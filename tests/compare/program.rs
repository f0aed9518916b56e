//! `editor compare` as it is called.

use crate::compare::painter::{HEIGHT, SCENE, Scene, WIDTH};
use crate::program::editor_in;
use editor_core::geometry::Picture;
use editor_core::io::image::{PictureFormat, decode, encode};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// Exit code, standard output, standard error.
fn compare(folder: &TempDir, arguments: &[&str]) -> (i32, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_editor"))
        .arg("compare")
        .args(arguments)
        .current_dir(folder.path())
        .output()
        .unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        output.status.code().unwrap(),
        text(output.stdout),
        text(output.stderr),
    )
}

fn save(folder: &TempDir, name: &str, picture: &Picture) {
    let bytes = encode(picture, PictureFormat::of(Path::new(name)).unwrap()).unwrap();
    fs::write(folder.path().join(name), bytes).unwrap();
}

/// A folder with the pictures `a.png` and `b.png`, in which a slab of 360 pixels is missing.
fn pictures() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    save(&folder, "a.png", &SCENE.paint());
    let b = Scene {
        slab: false,
        ..SCENE
    };
    save(&folder, "b.png", &b.paint());
    folder
}

/// A folder with the meshes `a.obj` and `b.obj`, which is `a.obj` moved.
fn meshes() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name, text| fs::write(folder.path().join(name), text).unwrap();
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    write("b.obj", "v 0 0 3\nv 1 0 3\nv 0 2 3\nf 1 2 3\n");
    folder
}

#[test]
fn a_jpeg_of_a_picture_is_not_explained_by_things_that_are_drawn() {
    let folder = pictures();
    save(&folder, "a.jpg", &SCENE.paint());
    let (code, out, _) = compare(&folder, &["a.png", "a.jpg"]);
    assert_eq!(code, 1);
    assert!(
        !out.contains("drawn only") && !out.contains("shading"),
        "{out}"
    );
}

#[test]
fn equal_pictures_end_with_0_and_different_ones_with_1() {
    let folder = pictures();
    let (code, out, err) = compare(&folder, &["a.png", "a.png"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        out.contains("infinite") && out.ends_with("passed: at most 0 may differ\n"),
        "{out}"
    );
    let (code, out, err) = compare(&folder, &["a.png", "b.png"]);
    assert_eq!((code, err.as_str()), (1, ""));
    assert!(out.contains("360 of 19200"), "{out}");
    assert!(
        out.contains("found: 360 pixels are drawn only in A, within x 20 to 49, y 92 to 103"),
        "{out}"
    );
}

#[test]
fn differences_of_pictures_without_a_cause_are_told_to_have_none() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = 1_u32;
    let mut noise = || {
        let bytes = (0..64 * 64).flat_map(|_| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let [_, r, g, b] = random.to_be_bytes();
            [r, g, b, 255]
        });
        Picture {
            width: 64,
            height: 64,
            rgba: bytes.collect(),
        }
    };
    save(&folder, "a.png", &noise());
    save(&folder, "b.png", &noise());
    let (code, out, _) = compare(&folder, &["a.png", "b.png"]);
    let told = "\nno single cause explains the differences\nfailed";
    assert!(code == 1 && out.contains(told), "{out}");
    let (_, out, _) = compare(&folder, &["a.png", "a.png"]);
    assert!(!out.contains("cause"), "{out}");
}

#[test]
fn axes_of_one_picture_alone_are_not_told_as_if_nothing_else_differed() {
    let folder = tempfile::tempdir().unwrap();
    let adult = "render builtin:adult --look studio";
    for (options, picture) in [
        ("--axis off", "rest.png"),
        ("--axis on", "axes.png"),
        ("--axis on --pose builtin:adult-wave", "posed.png"),
    ] {
        let line = format!("{adult} {options} -o {picture}");
        let arguments: Vec<&str> = line.split(' ').collect();
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
    }
    let told = "\nno single cause explains the other differences\nfailed";
    for (other, is_more) in [("axes.png", false), ("posed.png", true)] {
        let (_, out, _) = compare(&folder, &["rest.png", other]);
        assert!(out.contains("found: B shows the axes, A does not"), "{out}");
        assert_eq!(out.contains(told), is_more, "{out}");
    }
}

#[test]
fn threshold_allowance_and_ignored_areas_decide() {
    let folder = pictures();
    let code = |options: &[&str]| compare(&folder, &[&["a.png", "b.png"], options].concat()).0;
    assert_eq!(code(&["--max-pixels", "360"]), 0);
    assert_eq!(code(&["--max-pixels", "359"]), 1);
    assert_eq!(code(&["--max-pixels", "50%"]), 0);
    assert_eq!(code(&["--threshold", "153"]), 0);
    assert_eq!(code(&["--ignore", "20,92,15,12"]), 1);
    assert_eq!(
        code(&["--ignore", "20,92,15,12", "--ignore", "35,92,15,12"]),
        0
    );
}

#[test]
fn json_is_one_object_with_findings_as_sentences() {
    let folder = pictures();
    let (code, out, _) = compare(&folder, &["a.png", "b.png", "--json"]);
    let json: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(code, 1);
    assert_eq!(
        (&json["a"], &json["passed"]),
        (&"a.png".into(), &false.into())
    );
    assert_eq!(json["differing_pixels"], 360);
    assert_eq!(json["findings"][0]["kind"], "outline");
    assert!(
        json["findings"][0]["message"]
            .as_str()
            .unwrap()
            .contains("only in A")
    );
    let (_, out, _) = compare(&folder, &["a.png", "a.png", "--json"]);
    let json: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&json["psnr"], &json["ssim"]), (&Value::Null, &1.0.into()));
}

#[test]
fn the_result_shows_both_pictures_and_the_differences() {
    let folder = pictures();
    assert_eq!(compare(&folder, &["a.png", "b.png", "-o", "d.png"]).0, 1);
    let path = folder.path().join("d.png");
    let picture = decode(&path, &fs::read(&path).unwrap()).unwrap();
    assert_eq!((picture.width, picture.height), (3 * WIDTH + 16, HEIGHT));
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let at = |x: u32, y: u32| pixels[(y * picture.width + x) as usize];
    let [a, b, heat] = [0, 1, 2].map(|part| at(part * (WIDTH + 8) + 30, 100));
    assert_eq!((a, b), ([51, 77, 179, 255], [26, 26, 26, 255]));
    assert!(heat[0] > 200, "{heat:?}");
    assert_eq!(at(2 * (WIDTH + 8) + 70, 55), [0, 0, 0, 255]);
}

#[test]
fn what_cannot_be_compared_ends_with_1_and_says_why() {
    let folder = pictures();
    let small = Picture {
        width: HEIGHT,
        height: WIDTH,
        ..SCENE.paint()
    };
    save(&folder, "small.png", &small);
    let (code, out, err) = compare(&folder, &["a.png", "small.png", "-o", "d.png"]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("A is 160×120, B is 120×160"), "{err}");
    assert!(!folder.path().join("d.png").exists());
    let (code, out, _) = compare(&folder, &["a.png", "none.png", "--json"]);
    let json: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(code, 1);
    let missing = json!({"file": "none.png", "line": null, "column": null, "message": "there is no such file"});
    assert_eq!(json["error"], missing);
    let (_, out, _) = compare(&folder, &["a.png", "small.png", "--json"]);
    let json: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(json["error"]["file"], Value::Null);
    assert!(json["error"]["message"].as_str().unwrap().contains("A is"));
    let (code, _, err) = compare(&folder, &["a.png", "b.png", "-o", "none/d.png"]);
    assert_eq!(code, 1);
    assert!(err.contains("there is no folder none"), "{err}");
}

#[test]
fn wrong_usage_ends_with_2() {
    let folder = pictures();
    let code = |arguments: &[&str]| compare(&folder, arguments).0;
    assert_eq!(code(&["a.png"]), 2);
    for options in [
        ["--threshold", "256"],
        ["--threshold", "-1"],
        ["--threshold", "1.5"],
        ["--max-pixels", "-1"],
        ["--max-pixels", "many"],
        ["--ignore", "1,2,3"],
        ["--ignore", "-1,2,3,4"],
        ["-o", "d.txt"],
    ] {
        let arguments = [&["a.png", "b.png"], &options[..]].concat();
        assert_eq!(code(&arguments), 2, "{options:?}");
    }
    let folder = meshes();
    let code = |arguments: &[&str]| compare(&folder, arguments).0;
    fs::write(folder.path().join("b.png"), "no mesh").unwrap();
    assert_eq!(code(&["a.obj", "b.png"]), 2);
    assert_eq!(code(&["a.obj", "b.obj", "-o", "d.png"]), 2);
    assert_eq!(code(&["a.obj", "b.obj", "--threshold", "-1"]), 2);
}

#[test]
fn what_is_odd_in_a_mesh_is_told_beside_the_result() {
    let folder = meshes();
    let odd = fs::read_to_string(folder.path().join("a.obj")).unwrap() + "f 1 2\n";
    fs::write(folder.path().join("odd.obj"), odd).unwrap();
    let (code, _, err) = compare(&folder, &["a.obj", "odd.obj"]);
    assert_eq!(code, 0, "{err}");
    assert!(err.starts_with("warning: odd.obj:"), "{err}");
}

#[test]
fn json_is_one_object_for_wrong_usage_too() {
    let folder = pictures();
    for name in ["a.obj", "b.obj"] {
        fs::copy(meshes().path().join(name), folder.path().join(name)).unwrap();
    }
    fs::write(folder.path().join("c.bin"), [0, 159]).unwrap();
    for (expected, line, told) in [
        (
            2,
            "a.obj c.bin",
            "found the mesh a.obj and what is no mesh, c.bin",
        ),
        (
            2,
            "a.png b.obj",
            "found the mesh b.obj and the picture a.png",
        ),
        (1, "a.obj gone.png", "there is no such file"),
        (1, "gone.obj a.png", "there is no such file"),
        (2, "a.png b.png --threshold 256", "found 256"),
        (2, "a.png b.png -o d.txt", "d.txt"),
        (2, "a.obj b.obj -o d.png", "--output is for pictures"),
        (1, "a.png b.png -o a.png", "expected another file"),
        (1, "a.png b.png -o b.png", "expected another file"),
    ] {
        let arguments: Vec<&str> = line.split(' ').chain(["--json"]).collect();
        let (code, out, err) = compare(&folder, &arguments);
        assert_eq!(code, expected, "{line}");
        let json: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(
            (&json["a"], &json["passed"]),
            (&arguments[0].into(), &false.into())
        );
        let message = json["error"].to_string();
        assert!(message.contains(told) && err.contains(told), "{out}\n{err}");
    }
}

#[test]
fn meshes_are_compared_by_vertex() {
    let folder = meshes();
    assert_eq!(compare(&folder, &["a.obj", "a.obj"]).0, 0);
    assert_eq!(
        compare(&folder, &["a.obj", "b.obj", "--threshold", "3"]).0,
        0
    );
    let (code, out, _) = compare(&folder, &["a.obj", "b.obj"]);
    assert_eq!(code, 1);
    assert!(
        out.contains("found: B is A moved by (0.000000, 0.000000, 3.000000)"),
        "{out}"
    );
    let distance = "\nlargest distance    3\n  by size           1.34 of 2.24\n";
    assert!(out.contains(distance), "{out}");
    let vertices: Vec<&str> = out
        .lines()
        .filter(|line| line.starts_with("  vertex"))
        .collect();
    assert!(
        vertices[0].starts_with("  vertex 0 (from 0): 3 apart"),
        "{out}"
    );
    assert!(vertices[1].starts_with("  vertex 1: 3 apart"), "{out}");
    let (_, out, _) = compare(&folder, &["a.obj", "b.obj", "--json"]);
    let json: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(
        (&json["max"], &json["findings"][0]["kind"]),
        (&3.0.into(), &"offset".into())
    );
}

#[test]
fn a_vertex_that_is_no_number_differs_and_all_others_are_compared() {
    let folder = meshes();
    let text = "v 0 0 0\nv -nan(ind) 0 0\nv 0 2 0\nf 1 2 3\n";
    fs::write(folder.path().join("nan.obj"), text).unwrap();
    for (pair, which) in [(["a.obj", "nan.obj"], "B"), (["nan.obj", "a.obj"], "A")] {
        let (code, out, err) = compare(&folder, &pair);
        assert_eq!(code, 1, "{out}{err}");
        let warning = "warning: nan.obj:2: 1 vertex is no number (nan or infinite), which counts";
        assert!(err.starts_with(warning), "{err}");
        assert!(out.starts_with("differing vertices  1 of 3 by"), "{out}");
        let found = format!("found: 1 vertex of {which} has coordinates that are not finite");
        assert!(out.contains(&found), "{out}");
        let arguments = [&pair[..], &["--max-pixels", "1"]].concat();
        assert_eq!(compare(&folder, &arguments).0, 0);
    }
    let (_, out, _) = compare(&folder, &["a.obj", "nan.obj", "--json"]);
    let json: Value = serde_json::from_str(&out).unwrap();
    let numbers = [
        &json["differing_vertices"],
        &json["max"],
        &json["worst"][0]["index"],
    ];
    assert_eq!(numbers, [&1.into(), &Value::Null, &1.into()]);
    // Of a mesh without any numbers nothing is compared.
    fs::write(folder.path().join("none.obj"), "v nan 0 0\nf 1 1 1\n").unwrap();
    let (code, _, err) = compare(&folder, &["a.obj", "none.obj"]);
    assert_eq!(code, 1);
    assert!(err.contains("none.obj:1:3: expected a number"), "{err}");
}

#[test]
fn the_vertices_of_either_mesh_are_enough() {
    let folder = meshes();
    fs::write(
        folder.path().join("alone.txt"),
        "v 0 0 0\nv 1 0 0\nv 0 2 0\n",
    )
    .unwrap();
    for pair in [["a.obj", "alone.txt"], ["alone.txt", "a.obj"]] {
        let (code, out, err) = compare(&folder, &pair);
        assert_eq!(code, 0, "{out}{err}");
        assert!(err.contains("warning: alone.txt"), "{err}");
    }
    let (code, _, err) = compare(&folder, &["alone.txt", "alone.txt"]);
    assert_eq!(code, 1);
    assert!(err.contains("expected faces"), "{err}");
}

#[test]
fn a_mesh_that_is_bent_at_an_elbow_is_told_by_that_joint() {
    let folder = tempfile::tempdir().unwrap();
    let bent = r#"{"joints": {"Left elbow": [0, 0, 25]}}"#;
    fs::write(folder.path().join("bent.json"), bent).unwrap();
    let export = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_editor"));
        let command = command.args(["export", "builtin:adult"]).args(arguments);
        assert!(
            command
                .current_dir(folder.path())
                .status()
                .unwrap()
                .success()
        );
    };
    export(&["-o", "a.obj"]);
    export(&["--pose", "bent.json", "-o", "b.obj"]);
    let told = "\n  near Left elbow: 10 % of the vertices";
    for arguments in [
        &["a.obj", "b.obj", "--character", "builtin:adult"][..],
        &["builtin:adult", "b.obj"],
    ] {
        let (code, out, _) = compare(&folder, arguments);
        assert!(code == 1 && out.contains(told), "{out}");
        // A comparison knows no pose; the command that does is told as it is to be typed.
        let (_, command) = out.rsplit_once("\n  editor ").expect("a command");
        let expected = "diagnose b.obj --character builtin:adult --pose POSE.json\n";
        assert_eq!(command, expected);
        let command = command.replace("POSE.json", "bent.json");
        let diagnosed = editor_in(
            folder.path(),
            &command.split_whitespace().collect::<Vec<_>>(),
        );
        assert!(diagnosed.out.starts_with("right: "), "{}", diagnosed.out);
    }
    let (_, out, _) = compare(&folder, &["a.obj", "b.obj"]);
    assert!(out.contains("\n  toward +X of the mesh: 11 %"), "{out}");
    let told = "diagnose b.obj --character MODEL.obj --pose POSE.json";
    assert!(out.contains(told), "of no character that is known: {out}");
    let (_, out, _) = compare(&folder, &["builtin:adult", "a.obj"]);
    assert!(!out.contains("diagnose"), "nothing is off: {out}");
    let other = ["a.obj", "b.obj", "--character", "builtin:robot"];
    let (code, _, err) = compare(&folder, &other);
    assert!(code == 1 && err.contains("found none"), "{err}");
    let pictures = pictures();
    let wrong = ["a.png", "b.png", "--character", "builtin:adult"];
    assert_eq!(compare(&pictures, &wrong).0, 2);
}

#[test]
fn a_character_that_has_as_many_vertices_but_is_not_that_of_the_meshes_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: String| fs::write(folder.path().join(name), text).unwrap();
    // A strip of triangles, and one that takes the same vertices in another order.
    let character = |name: &str, step: usize| {
        let vertices: String = (0..60).map(|at| format!("v {at} {} 0\n", at % 2)).collect();
        let corner = |at: usize| 1 + at * step % 60;
        let face = |at: usize| {
            let [a, b, c] = [at, at + 1, at + 2].map(corner);
            format!("f {a} {b} {c}\n")
        };
        let faces: String = (0..58).map(face).collect();
        write(&format!("{name}.obj"), vertices + &faces);
        write(&format!("{name}.skel"), "0 0 0 -1\n1 0 0 0\n".to_owned());
        write(&format!("{name}.attach"), "1\n".repeat(60));
    };
    character("mine", 1);
    character("other", 7);
    let mesh = fs::read_to_string(folder.path().join("mine.obj")).unwrap();
    write("a.obj", mesh.clone());
    write("b.obj", mesh.replace("v 3 1 0", "v 3 2 0"));
    let by = |model| compare(&folder, &["a.obj", "b.obj", "--character", model]);
    let (code, out, _) = by("mine.obj");
    assert!(code == 1 && out.contains("near Joint 1"), "{out}");
    let (code, out, err) = by("other.obj");
    let expected = "error: other.obj: expected the model of a.obj, found another one, or its vertices in another order: only 0 \
                    of the triangles are the same\n";
    assert_eq!((code, &*out, &*err), (1, "", expected));
}

#[test]
fn where_a_has_vertices_alone_what_is_wrong_in_b_is_told() {
    let folder = meshes();
    let write = |name, text| fs::write(folder.path().join(name), text).unwrap();
    write("points.txt", "v 0 0 0\nv 1 0 0\nv 0 2 0\n");
    write("zero.obj", "v 0 0 3\nv 1 0 3\nv 0 2 3\nf 0 1 2\n");
    let (code, _, told) = compare(&folder, &["points.txt", "zero.obj"]);
    assert_eq!(code, 1);
    assert!(
        told.contains("zero.obj:4:3: expected a vertex counted from 1, found “0”"),
        "{told}"
    );
    // One of the two has to have faces.
    let (code, _, told) = compare(&folder, &["points.txt", "points.txt"]);
    assert!(code == 1 && told.contains("expected faces"), "{told}");
}
