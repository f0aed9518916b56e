//! `editor check`.

use crate::program::{editor_in, folder};
use crate::reference_data::course;
use editor_core::io::to_zip;
use serde_json::{Value, json};
use std::path::Path;

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn check_says_what_is_in_a_character_and_what_is_odd() {
    let ran = editor_in(folder().path(), &["check", "man.obj"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    // The vertex with a quarter of a weight shrinks towards the origin, as the formula has it.
    let expected = "\
man.obj
  character        Man
    vertices       3
    triangles      1
    joints         2 (1 root)
    influences     at most 1 a vertex
    weight sums    0.2500 to 1.0000
    bounds         (0.0000, 0.0000, 0.0000) to (0.2500, 3.0000, 0.0000)
  warning          man.attach:2:1: 1 vertex with weights that do not sum up to 1
";
    assert_eq!(ran.out, expected);
}

#[test]
fn check_prints_one_json_object_for_any_number_of_files() {
    let ran = editor_in(
        folder().path(),
        &["check", "--json", "a.scene", "bad.obj", "bend.json"],
    );
    assert_eq!(ran.code, Some(1));
    assert_eq!(
        ran.err,
        "error: bad.obj:2:7: expected a vertex from 1 to 1, found 2\n"
    );
    let report = json(&ran.out);
    let files = report["files"].as_array().unwrap();
    assert_eq!(files.len(), 3);
    assert_eq!(files[0]["shapes"][0]["skeleton"]["joints"], 2);
    assert_eq!(files[0]["shapes"][1]["triangles"], 2);
    assert_eq!(
        files[0]["shapes"][1]["bounds"],
        json!([[0.0, 0.0, 2.0], [1.0, 1.0, 2.0]])
    );
    assert_eq!(
        files[1]["error"],
        json!({"file": "bad.obj", "line": 2, "column": 7, "message": "expected a vertex from 1 to 1, found 2"})
    );
    assert_eq!(files[2]["posed_joints"], 1);
}

/// Poses as the course has them in one file.
pub const POSES: &str =
    r#"{"poses": {"rest": {}, "bend": {"1": {"name": "Tip", "xyz_deg": [0, 0, 90]}}}}"#;

#[test]
fn the_poses_of_a_file_with_several_are_told_and_each_joint_is_looked_for() {
    let folder = folder();
    let path = folder.path();
    std::fs::write(path.join("poses.json"), POSES).unwrap();
    let ran = editor_in(path, &["check", "poses.json"]);
    let expected =
        "poses.json\n  pose             rest, of 0 joints\n  pose             bend, of 1 joint\n";
    assert_eq!((ran.code, &*ran.out), (Some(0), expected), "{}", ran.err);
    let ran = editor_in(path, &["check", "--json", "poses.json"]);
    let poses = json!([{"name": "rest", "joints": 0}, {"name": "bend", "joints": 1}]);
    assert_eq!(json(&ran.out)["files"][0]["poses"], poses);
    std::fs::write(path.join("poses.json"), POSES.replace("\"1\"", "\"7\"")).unwrap();
    let ran = editor_in(path, &["check", "poses.json", "man.obj"]);
    assert_eq!(ran.code, Some(1), "{}", ran.out);
    assert!(ran.err.contains("poses.json:1:"), "{}", ran.err);
}

#[test]
fn a_pose_that_only_moves_a_root_is_of_one_joint_and_materials_are_named_once() {
    let folder = folder();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write(
        "moved.json",
        "{\"joints\": {}, \"roots\": {\"Root\": [1, 0, 0]}}",
    );
    write("red.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    write(
        "flag.obj",
        "mtllib red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n\
         usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 3 2 1\n",
    );
    let arguments = ["check", "--json", "moved.json", "flag.obj"];
    let report = json(&editor_in(folder.path(), &arguments).out);
    assert_eq!(report["files"][0]["posed_joints"], 1);
    let materials = &report["files"][1]["shapes"][0]["materials"];
    assert_eq!(materials, &json!(["red", "blue"]));
}

#[test]
fn places_are_told_in_parts_to_programs_and_a_file_as_a_whole_has_none() {
    let ran = editor_in(folder().path(), &["check", "--json", "man.obj", "none.obj"]);
    let report = json(&ran.out);
    let warning = &report["files"][0]["warnings"][0];
    assert_eq!(
        (&warning["file"], &warning["line"]),
        (&json!("man.attach"), &json!(2))
    );
    let error = json!({"file": "none.obj", "line": null, "column": null, "message": "there is no such file"});
    assert_eq!(report["files"][1]["error"], error);
}

#[test]
fn curves_of_one_name_are_odd() {
    let folder = folder();
    std::fs::write(
        folder.path().join("two.swp"),
        "circ a 8 1\ncirc a 8 2\nsrev b 5 a\n",
    )
    .unwrap();
    let ran = editor_in(folder.path(), &["check", "two.swp"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    let told = "two.swp:2:6: expected another name for each curve, found “a” again: surfaces after it are made of this one";
    assert!(ran.out.contains(told), "{}", ran.out);
}

#[test]
fn check_tells_every_broken_file_and_still_reports_the_others() {
    let ran = editor_in(
        folder().path(),
        &["check", "bad.obj", "box.obj", "none.obj", "."],
    );
    assert_eq!(ran.code, Some(1));
    let told = "\
error: bad.obj:2:7: expected a vertex from 1 to 1, found 2
error: none.obj: there is no such file
error: .: expected a file, found a folder
";
    assert_eq!(ran.err, told);
    assert!(ran.out.starts_with("box.obj\n"), "{}", ran.out);
}

#[test]
fn commands_read_scenes_in_archives_and_refuse_those_that_miss_a_file() {
    let folder = folder();
    let entries = ["a.scene", "man.obj", "man.skel", "man.attach", "box.obj"].map(|name| {
        let bytes = std::fs::read(folder.path().join(name)).unwrap();
        (Path::new("inner").join(name), bytes)
    });
    let other = tempfile::tempdir().unwrap();
    std::fs::write(other.path().join("a.zip"), to_zip(&entries).unwrap()).unwrap();
    let ran = editor_in(other.path(), &["check", "a.zip"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    assert!(ran.out.contains("character        Man"), "{}", ran.out);
    let ran = editor_in(other.path(), &["export", "a.zip", "-o", "out.obj"]);
    let weights =
        "warning: a.zip/inner/man.attach:2:1: 1 vertex with weights that do not sum up to 1\n";
    assert_eq!((ran.code, &*ran.err), (Some(0), weights));
    let written = std::fs::read_to_string(other.path().join("out.obj")).unwrap();
    assert!(written.starts_with("o Man\nv 0 0 0\n"), "{written}");

    let scene = r#"{"format": "editor-scene", "version": 2, "shapes": [
        {"name": "Ada", "source": {"file": "a.zip/inner/man.obj", "importer": "character",
         "fingerprint": "00000000"}},
        {"name": "Box", "source": {"file": "crate.obj", "importer": "shape"}}]}"#;
    std::fs::write(other.path().join("b.scene"), scene).unwrap();
    for command in [
        &["check", "b.scene"][..],
        &["export", "b.scene", "-o", "b.obj"],
    ] {
        let ran = editor_in(other.path(), command);
        assert_eq!(ran.code, Some(1));
        let told = "error: b.scene:4:9: shape 2: crate.obj: there is no such file\n";
        assert_eq!(ran.err, told);
    }
    std::fs::copy(
        folder.path().join("box.obj"),
        other.path().join("crate.obj"),
    )
    .unwrap();
    let ran = editor_in(other.path(), &["check", "b.scene"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    let told = "a.zip/inner/man.obj: this file has changed since the scene was saved";
    assert!(ran.out.contains(told), "{}", ran.out);
}

#[test]
fn names_cannot_write_lines_of_their_own_on_a_terminal() {
    let folder = folder();
    let scene = r#"{"format": "editor-scene", "version": 1,
        "shapes": [{"kind": "cube", "name": "\u001b[31mred\n\nerror: \u202eno"}]}"#;
    std::fs::write(folder.path().join("a\nb.scene"), scene).unwrap();
    let ran = editor_in(folder.path(), &["check", "a\nb.scene"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    assert!(ran.out.starts_with("a\\nb.scene\n  cube "), "{:?}", ran.out);
    let name = " \\u{1b}[31mred\\n\\nerror: \\u{202e}no\n";
    assert!(ran.out.contains(name), "{:?}", ran.out);
    let ran = editor_in(folder.path(), &["check", "--json", "a\nb.scene"]);
    let report = json(&ran.out);
    assert_eq!(report["files"][0]["path"], "a\nb.scene");

    let mtl = "newmtl m\nmap_Kd \u{1b}[31mx.png\n";
    std::fs::write(folder.path().join("a.mtl"), mtl).unwrap();
    let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    std::fs::write(folder.path().join("a.obj"), obj).unwrap();
    let told = "a.obj: expected a picture, found no file “\\u{1b}[31mx.png”\n";
    let ran = editor_in(folder.path(), &["check", "a.obj"]);
    assert!(ran.out.contains(told), "{:?}", ran.out);
    let ran = editor_in(folder.path(), &["export", "a.obj", "-o", "b.obj"]);
    assert_eq!(ran.err, format!("warning: {told}"));

    let ran = editor_in(folder.path(), &["check", "no\nsuch\u{1b}[31m.obj"]);
    assert_eq!(
        ran.err,
        "error: no\\nsuch\\u{1b}[31m.obj: there is no such file\n"
    );
    let ran = editor_in(folder.path(), &["no\u{1b}c"]);
    assert!(!ran.err.contains('\u{1b}'), "{:?}", ran.err);
    assert_eq!(ran.err.lines().count(), 3, "{:?}", ran.err);
}

#[test]
fn one_joint_is_no_joints() {
    let ran = editor_in(folder().path(), &["check", "bend.json"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    assert_eq!(ran.out, "bend.json\n  pose             of 1 joint\n");
}

#[test]
fn a_joint_of_a_pose_that_no_character_beside_it_has_is_an_error() {
    let folder = folder();
    let elbow = "{\"joints\": {\"Elbow\": [0, 0, 50], \"Tip\": [0, 0, 9]}}";
    std::fs::write(folder.path().join("elbow.json"), elbow).unwrap();
    let checked = |files: &[&str]| editor_in(folder.path(), &[&["check"], files].concat());
    let told = "error: elbow.json:1:13: expected the name or index of a joint";
    for files in [&["man.obj", "elbow.json"][..], &["elbow.json", "a.scene"]] {
        let ran = checked(files);
        assert_eq!(ran.code, Some(1), "{}", ran.out);
        assert!(ran.err.starts_with(told), "{}", ran.err);
        assert!(!ran.out.contains("elbow.json"), "{}", ran.out);
    }
    // A file that is wrong may be the character that has the joint.
    let ran = checked(&["man.obj", "elbow.json", "bad.obj"]);
    assert!(
        ran.code == Some(1) && !ran.err.contains("elbow.json"),
        "{}",
        ran.err
    );
    // One character has all of its joints, and without one none can be missing.
    for files in [
        &["bend.json", "man.obj", "builtin:adult"][..],
        &["elbow.json", "builtin:vase"],
        &["elbow.json"],
    ] {
        assert_eq!(checked(files).code, Some(0), "{files:?}");
    }
}

#[test]
fn a_word_that_is_no_value_is_told_whole() {
    let folder = folder();
    for (value, told) in [
        ("NaN", "1:21: expected a value, found “NaN”"),
        (
            "-Infinity",
            "1:21: expected a number such as -1.5 or 2e3, found “-Infinity”",
        ),
        ("True", "1:21: expected a value, found “True”"),
    ] {
        let pose = format!("{{\"joints\": {{\"Tip\": [{value}, 0, 0]}}}}");
        std::fs::write(folder.path().join("nan.json"), pose).unwrap();
        let ran = editor_in(folder.path(), &["check", "nan.json"]);
        assert!(ran.err.contains(told), "{}", ran.err);
    }
}

#[test]
fn bounds_that_round_to_nothing_have_no_sign() {
    let folder = folder();
    let obj = "v -0.00004 -0.0001 -0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(folder.path().join("a.obj"), obj).unwrap();
    let ran = editor_in(folder.path(), &["check", "a.obj"]);
    let told = "bounds         (0.0000, -0.0001, 0.0000) to (1.0000, 1.0000, 0.0000)\n";
    assert!(ran.out.contains(told), "{}", ran.out);
}

#[test]
fn colors_are_told_by_their_channels() {
    let folder = folder();
    for (line, told) in [
        (
            "Kd nan 0 0",
            "a.mtl:2:4: expected a number for red, found “nan”",
        ),
        (
            "Kd 0 x 0",
            "a.mtl:2:6: expected a number for green, found “x”",
        ),
        (
            "Kd 0 0",
            "a.mtl:2:7: expected a number for blue, found the end of the line",
        ),
    ] {
        std::fs::write(folder.path().join("a.mtl"), format!("newmtl m\n{line}\n")).unwrap();
        let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
        std::fs::write(folder.path().join("a.obj"), obj).unwrap();
        let ran = editor_in(folder.path(), &["check", "a.obj"]);
        assert!(ran.out.contains(told), "{}", ran.out);
    }
}

#[test]
fn check_knows_the_course_characters() {
    for name in ["characters/Model1.obj", "characters/Model2.obj"] {
        let Some(path) = course(name) else { return };
        let ran = editor_in(
            folder().path(),
            &["check", "--json", path.to_str().unwrap()],
        );
        assert_eq!((ran.code, &*ran.err), (Some(0), ""));
        let report = json(&ran.out);
        let shape = &report["files"][0]["shapes"][0];
        assert_eq!(shape["vertices"], 13_336);
        assert_eq!(shape["triangles"], 26_668);
        assert_eq!(shape["skeleton"]["joints"], 18);
        assert_eq!(shape["skeleton"]["roots"], 1);
        assert_eq!(shape["skeleton"]["most_influences"], 13);
        assert_eq!(report["files"][0]["warnings"], json!([]));
    }
}

/// The warnings that are told about a file in `folder`, without its name.
fn warnings(folder: &Path, file: &str) -> Vec<String> {
    let ran = editor_in(folder, &["check", "--json", file]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{file}");
    let report = json(&ran.out);
    let warnings = report["files"][0]["warnings"].as_array().unwrap();
    let message = |warning: &Value| warning["message"].as_str().unwrap().to_owned();
    warnings.iter().map(message).collect()
}

#[test]
fn a_mesh_in_other_units_than_its_skeleton_is_odd() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let skeleton = |unit: f32| format!("0 0 0 -1\n0 {unit} 0 0\n");
    write("man.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("man.attach", "1\n1\n1\n");
    let units = ": one of them may be in other units, such as centimeters and meters";
    for (unit, expected) in [
        (1.0, None),
        (0.1, None),
        (10.0, None),
        (
            0.01,
            Some("Man: the mesh is some 140 times as large as the skeleton"),
        ),
        (
            100.0,
            Some("Man: the skeleton is some 71 times as large as the mesh"),
        ),
        // All joints in one place say nothing of units.
        (0.0, None),
    ] {
        write("man.skel", &skeleton(unit));
        let expected: Vec<String> = expected
            .iter()
            .map(|what| format!("{what}{units}"))
            .collect();
        assert_eq!(warnings(folder.path(), "man.obj"), expected, "{unit}");
    }
}

#[test]
fn faces_that_are_turned_inside_out_are_odd() {
    let folder = tempfile::tempdir().unwrap();
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    for (name, faces, expected) in [
        ("right", "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", None),
        ("open", "f 1 2 3\nf 1 4 2\nf 1 3 4\n", None),
        (
            "all",
            "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n",
            Some(
                "All: all of the closed mesh is turned inside out: the corners of its faces go clockwise, seen from outside",
            ),
        ),
        (
            "one",
            "f 1 3 2\nf 1 4 2\nf 1 4 3\nf 2 3 4\n",
            Some("One: 1 of 4 triangles is turned inside out, against its neighbors"),
        ),
    ] {
        let file = format!("{name}.obj");
        std::fs::write(folder.path().join(&file), corners.to_owned() + faces).unwrap();
        assert_eq!(
            warnings(folder.path(), &file),
            Vec::from_iter(expected),
            "{name}"
        );
    }
}

#[test]
fn nothing_is_odd_about_the_size_and_the_faces_of_what_is_built_in_or_the_course_s() {
    let builtin = editor_core::io::builtin::catalogue().into_iter();
    let mut files: Vec<String> = builtin.map(|it| format!("builtin:{}", it.name)).collect();
    let course = ["Model1", "Model2"].map(|name| course(&format!("characters/{name}.obj")));
    let course = course.into_iter().flatten();
    files.extend(course.map(|path| path.display().to_string()));
    for file in files {
        let odd = warnings(Path::new("."), &file);
        let is_of_mesh = |what: &&String| what.contains("inside out") || what.contains("units");
        assert_eq!(odd.iter().find(is_of_mesh), None, "{file}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_name_that_fits_but_for_capitals_is_told_where_the_file_is_not_found() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let write = |name: &str, text: &str| std::fs::write(path(name), text).unwrap();
    write(
        "man.obj",
        "mtllib Paint/red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    write("Man.SKEL", "0 0 0 -1\n0 1 0 0\n");
    std::fs::create_dir(path("paint")).unwrap();
    write("paint/Red.mtl", "newmtl red\n");
    let told = |found: &str, asked: &str| {
        format!(
            "{found} is not called {asked}, as is looked for: Windows and macOS take the one for the other, Linux does not"
        )
    };
    let odd = warnings(folder.path(), "man.obj");
    for told in [
        told("Man.SKEL", "man.skel"),
        told("paint/Red.mtl", "Paint/red.mtl"),
    ] {
        assert!(odd.contains(&told), "{odd:?}");
    }
    write("man.attach", "1\n1\n1\n");
    let ran = editor_in(folder.path(), &["check", "man.obj"]);
    assert_eq!(ran.code, Some(1));
    let told = format!("found only the weights; {}", told("Man.SKEL", "man.skel"));
    assert!(ran.err.contains(&told), "{}", ran.err);
    // With the right names all is well, and what nothing asks for may be called as it likes.
    std::fs::rename(path("Man.SKEL"), path("man.skel")).unwrap();
    std::fs::rename(path("paint"), path("Paint")).unwrap();
    std::fs::rename(path("Paint/Red.mtl"), path("Paint/red.mtl")).unwrap();
    write("BOX.obj", "v 0 0 0\n");
    assert_eq!(warnings(folder.path(), "man.obj"), [""; 0]);
}

#[test]
fn a_model_that_was_cut_off_is_said_to_be() {
    let folder = folder();
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3";
    std::fs::write(folder.path().join("part.obj"), text).unwrap();
    let ran = editor_in(folder.path(), &["check", "part.obj"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    let warning = "part.obj:5:6: expected the rest of a face, found the end of the file: it seems to \
                   be cut off\n";
    assert!(ran.out.ends_with(warning), "{}", ran.out);
}

#[test]
fn tests_for_grade_are_not_taken_for_a_wrong_pose() {
    let folder = folder();
    let example = editor_in(folder.path(), &["grade", "--example"]).out;
    std::fs::write(folder.path().join("tests.json"), example).unwrap();
    let ran = editor_in(folder.path(), &["check", "tests.json"]);
    let told = "error: tests.json: expected a pose, found tests for editor grade\n";
    assert_eq!((ran.code, &*ran.err), (Some(1), told));
}
