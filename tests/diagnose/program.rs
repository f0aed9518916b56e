//! `editor diagnose` as it is called.

use crate::program::{Ran, editor_in};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A man of two joints that is bent at the tip, and what programs make of him.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("man.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3\n"),
        ("man.skel", "0 0 0 -1 # Root\n0 1 0 0 # Tip\n"),
        ("man.attach", "1\n0.25\n1\n"),
        ("box.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"),
        ("bend.json", "{\"joints\": {\"Tip\": [0, 0, 90]}}"),
        ("elbow.json", "{\"joints\": {\"Elbow\": [0, 0, 90]}}"),
        ("right.obj", "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\nf 1 2 3\n"),
        ("wrong.obj", "v 0 1 0\nv 0 0.5 0\nv -3 1 0\nf 1 2 3\n"),
        ("odd.obj", "v 0 1 0\nv 0 0.5 4\nv -3 7 0\nf 1 2 3\n"),
        ("two.obj", "v 0 1 0\nv 0 0.5 4\nf 1 2 1\n"),
        ("points.txt", "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\n"),
        ("lost.obj", "v 0 1 0\nv 0 0.5 4\nf 1 2 3\n"),
        ("nan.obj", "v nan 1 nan\nv 0 inf 4\nv 0 0 nan\nf 1 2 3\n"),
        ("empty.obj", ""),
        ("half.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3\n"),
        ("half.skel", "0 0 0 -1\n"),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn diagnose(folder: &Path, theirs: &str, character: &str, pose: &str) -> Ran {
    let arguments = ["diagnose", theirs, "--character", character, "--pose", pose];
    editor_in(folder, &arguments)
}

fn json(folder: &Path, theirs: &str) -> (Option<i32>, Value) {
    let options = ["--character", "man.obj", "--pose", "bend.json", "--json"];
    let ran = editor_in(folder, &[&["diagnose", theirs][..], &options].concat());
    (ran.code, serde_json::from_str(&ran.out).unwrap())
}

const WARNING: &str = "warning: man.attach:2:1: 1 vertex with weights that do not sum up to 1\n";

#[test]
fn a_mesh_that_is_right_ends_with_0() {
    let folder = folder();
    for model in ["man.obj", "man.skel", "man.attach"] {
        let ran = diagnose(folder.path(), "right.obj", model, "bend.json");
        // The pose turns one joint about one axis, which shows few mistakes.
        let told = "\
right: this is the exact result, but for less than 0.001 % of the size
  unseen   parent-missing, bind-parent-missing, parent-order, euler-zyx, euler-xzy, euler-yxz, euler-yzx, euler-zxy, \
influences-cut-4, vertices-renumbered, joints-by-depth, \
one-axis-ignored-x, one-axis-ignored-y, sign-flipped-x, sign-flipped-y, \
root-rotated-before-translation, root-angles-missing, stack-not-popped, parents-misread, root-translation-missing, \
root-transform-missing, root-transform-repeated, sum-overwritten, angles-exchanged, influences-cut-fewer, sum-divided, \
small-weights-left-out, above-parents-missing, parents-rotations-missing, parent-rotation-order, offset-not-turned, turns-order, inverse-bind-shared, \
only-one-axis, angle-repeated: with these mistakes, made in the usual way, it would be the same here
";
        assert_eq!((ran.code, &*ran.out, &*ran.err), (Some(0), told, WARNING));
    }
}

#[test]
fn a_mistake_is_told_with_what_to_look_at_and_ends_with_1() {
    let ran = diagnose(folder().path(), "wrong.obj", "man.obj", "bend.json");
    let told = "\
no-inverse-bind: vertices are moved by T alone, without the inverse of B
  agrees   with what that gives, but for less than 0.001 % of the size; the exact result is 32.9 % of the size away
  section  4.2 SSD
  look at  updateMeshVertices: whether bindWorldToJointTransform is multiplied at all, and is filled
  shown by Tip, vertex 2 (from 0): theirs (-3.0000, 1.0000, 0.0000), exact (-2.0000, 1.0000, 0.0000)
  indistinguishable here: own-transform-missing
           own-transform-missing: what is kept for a joint is the transform of its parent, without its own (in B)
";
    assert_eq!((ran.code, &*ran.out, &*ran.err), (Some(1), told, WARNING));
}

#[test]
fn a_mesh_without_a_cause_is_told_to_have_none_and_where_it_is_off() {
    let ran = diagnose(folder().path(), "odd.obj", "man.obj", "bend.json");
    let told = "\
unexplained: 200.0 % of the size away from the exact result in this pose, and no known mistake gives this mesh, nor do two of those that are tried together
  shown by Tip, vertex 2 (from 0): theirs (-3.0000, 7.0000, 0.0000), exact (-2.0000, 1.0000, 0.0000)
  off      Tip: 100 % of its vertices, by up to 200.0 % of the size
";
    assert_eq!((ran.code, &*ran.out, &*ran.err), (Some(1), told, WARNING));
}

#[test]
fn a_file_that_is_cut_off_ends_with_1_and_is_told_to_lack_triangles() {
    let folder = folder();
    for (name, text) in [
        ("man.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3\nf 3 2 1\n"),
        (
            "right.obj",
            "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\nf 1 2 3\nf 3 2 1\n",
        ),
        ("cut.obj", "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\nf 1 2 3\nf 3 2"),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let ran = diagnose(folder.path(), "cut.obj", "man.obj", "bend.json");
    let told = "\
right but for its triangles: its vertices are the exact result, but for less than 0.001 % of the size
  but      1 of the model's 2 triangles is missing: the file may be cut off
";
    assert_eq!(ran.code, Some(1));
    assert!(ran.out.starts_with(told), "{}", ran.out);
    let (code, cut) = json(folder.path(), "cut.obj");
    assert_eq!((code, &cut["verdict"]), (Some(1), &"triangles".into()));
    let counts = ["triangles", "triangles_missing", "triangles_other"].map(|key| &cut[key]);
    assert_eq!(counts, [2, 1, 0]);
    let (code, right) = json(folder.path(), "right.obj");
    assert_eq!((code, &right["triangles_missing"]), (Some(0), &0.into()));
}

#[test]
fn a_misspelled_character_is_told_from_a_wrong_mesh_though_both_end_with_1() {
    let folder = folder();
    let ran = diagnose(folder.path(), "right.obj", "men.obj", "bend.json");
    assert_eq!((ran.code, &*ran.out), (Some(1), ""));
    assert!(ran.err.starts_with("error: men.obj: "), "{}", ran.err);
    let words = [
        "diagnose",
        "right.obj",
        "--json",
        "--character",
        "men.obj",
        "--pose",
        "bend.json",
    ];
    let ran = editor_in(folder.path(), &words);
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!((ran.code, &found["verdict"]), (Some(1), &Value::Null));
    assert_eq!(found["failure"]["file"], "men.obj");
}

#[test]
fn json_is_one_object_with_verdict_causes_and_error() {
    let folder = folder();
    let (code, right) = json(folder.path(), "right.obj");
    assert_eq!((code, &right["verdict"]), (Some(0), &"right".into()));
    assert_eq!(
        (&right["causes"], &right["first"]),
        (&json!([]), &Value::Null)
    );
    let (code, wrong) = json(folder.path(), "wrong.obj");
    assert_eq!((code, &wrong["verdict"]), (Some(1), &"explained".into()));
    let both = json!(["no-inverse-bind", "own-transform-missing"]);
    assert_eq!(wrong["causes"], both);
    assert!(wrong["error"].as_f64().unwrap() < 1e-6, "{wrong}");
    assert!(
        (wrong["error_from_exact"].as_f64().unwrap() - 0.3288).abs() < 1e-4,
        "{wrong}"
    );
    assert_eq!(wrong["mistakes"][0]["section"], "4.2 SSD");
    assert_eq!(
        (&wrong["first"]["joint"], &wrong["first"]["vertex"]),
        (&"Tip".into(), &2.into())
    );
    assert_eq!(wrong["first"]["theirs"], json!([-3.0, 1.0, 0.0]));
    let (code, odd) = json(folder.path(), "odd.obj");
    assert_eq!((code, &odd["verdict"]), (Some(1), &"unexplained".into()));
    assert_eq!(
        (&odd["causes"], &odd["regions"][0]["off"]),
        (&json!([]), &3.into())
    );
    let (code, nan) = json(folder.path(), "nan.obj");
    assert_eq!((code, &nan["verdict"]), (Some(1), &Value::Null));
    let message = "expected a number for x, found “nan”";
    let failure = json!({"file": "nan.obj", "line": 1, "column": 3, "message": message});
    assert_eq!(nan["failure"], failure);
}

#[test]
fn faces_that_name_vertices_that_are_not_there_are_wrong_and_the_vertices_are_looked_at() {
    let folder = folder();
    for (name, text) in [
        ("man.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3\nf 3 2 1\n"),
        (
            "from0.obj",
            "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\nf 0 1 2\nf 3 2 1\n",
        ),
        (
            "beyond.obj",
            "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\nf 2 3 4\nf 3 2 1\n",
        ),
        (
            "none.obj",
            "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\nf 2 3 4\nf 4 3 2\n",
        ),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    for (file, told) in [
        (
            "from0.obj",
            "warning: from0.obj:4:3: expected a vertex counted from 1, found 0: 1 face is left out\n",
        ),
        (
            "beyond.obj",
            "warning: beyond.obj:4:7: expected a vertex from 1 to 3, found 4: 1 face is left out\n",
        ),
    ] {
        let ran = diagnose(folder.path(), file, "man.obj", "bend.json");
        let is_right = ran.out.starts_with("right but for its triangles: ");
        assert!(ran.code == Some(1) && is_right, "{}{}", ran.out, ran.err);
        assert!(ran.err.contains(told), "{}", ran.err);
    }
    // Without any that is left, nothing tells the file from one with vertices alone.
    let ran = diagnose(folder.path(), "none.obj", "man.obj", "bend.json");
    let told = "none.obj:4:7: expected a vertex from 1 to 3, found 4\n";
    assert!(ran.code == Some(1) && ran.err.contains(told), "{}", ran.err);
}

#[test]
fn single_vertices_that_are_no_numbers_are_wrong_and_the_others_are_looked_at() {
    let folder = folder();
    let text = "v 1 1 0\nv 0.25 -nan(ind) 0\nv -2 1 0\nf 1 2 3\n";
    fs::write(folder.path().join("right.obj"), text).unwrap();
    let ran = diagnose(folder.path(), "right.obj", "man.obj", "bend.json");
    let warning =
        "warning: right.obj:2: 1 vertex is no number (nan or infinite), which counts as wrong";
    assert!(ran.err.contains(warning), "{}", ran.err);
    let told = "(from 0): theirs (0.2500, NaN, 0.0000), exact (0.2500, 0.5000, 0.0000)";
    assert!(ran.code == Some(1) && ran.out.contains(told), "{}", ran.out);
    let (code, found) = json(folder.path(), "right.obj");
    assert_eq!((code, &found["verdict"]), (Some(1), &"unexplained".into()));
    assert_eq!((&found["error"], &found["off"]), (&Value::Null, &1.into()));
    assert_eq!(found["first"]["error"], Value::Null, "{found}");
    assert_eq!(found["no_numbers"], 1);
    let told = "unexplained: 1 vertex is no number (nan or infinite), and all others are right";
    assert!(ran.out.starts_with(told), "{}", ran.out);
    // As PowerShell writes what a program prints.
    let units = format!("\u{feff}{text}")
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect::<Vec<u8>>();
    fs::write(folder.path().join("right.obj"), units).unwrap();
    let wide = diagnose(folder.path(), "right.obj", "man.obj", "bend.json");
    assert_eq!((wide.out, wide.err), (ran.out, ran.err));
}

#[test]
fn vertices_alone_are_enough_if_they_are_all() {
    let folder = folder();
    let ran = diagnose(folder.path(), "points.txt", "man.obj", "bend.json");
    assert!(ran.out.starts_with("right: "), "{}{}", ran.out, ran.err);
    let warning =
        "warning: points.txt: found no faces (lines `f a b c`): taken to be those of the model\n";
    assert!(ran.err.contains(warning), "{}", ran.err);
    let ran = editor_in(folder.path(), &["compare", "right.obj", "points.txt"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), warning), "{}", ran.out);
    fs::write(folder.path().join("points.txt"), "v 1 1 0\nv 0.25 0.5 0\n").unwrap();
    let ran = diagnose(folder.path(), "points.txt", "man.obj", "bend.json");
    let told = "vertex-missing: there is one vertex fewer than the model has (the last)\n";
    assert!(
        ran.code == Some(1) && ran.out.starts_with(told),
        "{}",
        ran.out
    );
    let one_more = "v 1 1 0\nv 0.25 0.5 0\nv -2 1 0\nv -2 1 0\n";
    fs::write(folder.path().join("points.txt"), one_more).unwrap();
    let ran = diagnose(folder.path(), "points.txt", "man.obj", "bend.json");
    let told = "vertex-too-many: there is one vertex more than the model has (after the last)\n";
    assert!(
        ran.code == Some(1) && ran.out.starts_with(told),
        "{}{}",
        ran.out,
        ran.err
    );
    fs::write(folder.path().join("points.txt"), "v 1 1 0\n").unwrap();
    let ran = diagnose(folder.path(), "points.txt", "man.obj", "bend.json");
    let told = "points.txt:1:8: expected 3 vertices, or faces, found 1 vertex alone: the file may be cut off";
    assert!(ran.code == Some(1) && ran.err.contains(told), "{}", ran.err);
}

#[test]
fn a_file_that_is_wrong_or_does_not_fit_is_one_clear_error() {
    let folder = folder();
    for (line, told) in [
        (
            "none.obj man.obj bend.json",
            "none.obj: there is no such file",
        ),
        (
            "right.obj none.obj bend.json",
            "none.obj: there is no such file",
        ),
        (
            "right.obj none.skel bend.json",
            "none.skel: there is no such file",
        ),
        (
            "right.obj man.obj none.json",
            "none.json: there is no such file",
        ),
        (
            "nan.obj man.obj bend.json",
            "nan.obj:1:3: expected a number for x, found “nan”",
        ),
        ("empty.obj man.obj bend.json", "empty.obj"),
        (
            "two.obj man.obj bend.json",
            "two.obj: expected 3 vertices, as the character has, found 2",
        ),
        (
            "lost.obj man.obj bend.json",
            "lost.obj:3:7: expected a vertex from 1 to 2, found 3: the file lacks 1 of 3 vertices",
        ),
        (
            "right.obj box.obj bend.json",
            "box.obj: expected box.skel and box.attach beside it, found neither: without them it is a \
             shape",
        ),
        (
            "right.obj half.obj bend.json",
            "half.obj: expected half.attach beside half.skel, found only the skeleton",
        ),
        ("right.obj builtin:vase bend.json", "expected a character"),
        ("right.obj builtin:plant bend.json", "expected "),
        ("right.obj builtin:nobody bend.json", "nobody"),
        (
            "right.obj man.obj elbow.json",
            "elbow.json:1:13: expected the name or index of a joint",
        ),
        ("right.obj man.obj man.obj", "man.obj:1:1"),
    ] {
        let [theirs, character, pose] = line.split(' ').collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let ran = diagnose(folder.path(), theirs, character, pose);
        assert_eq!((ran.code, &*ran.out), (Some(1), ""), "{line}");
        let error = ran.err.strip_prefix(WARNING).unwrap_or(&ran.err);
        assert!(
            error.starts_with("error: ") && error.contains(told),
            "{line}: {error}"
        );
        assert_eq!(error.lines().count(), 1, "{error}");
    }
}

#[test]
fn without_a_character_or_a_pose_it_is_wrong_usage() {
    let folder = folder();
    for arguments in [
        &["diagnose"][..],
        &["diagnose", "right.obj"],
        &["diagnose", "right.obj", "--character", "man.obj"],
        &["diagnose", "right.obj", "--pose", "bend.json"],
    ] {
        let ran = editor_in(folder.path(), arguments);
        assert_eq!((ran.code, &*ran.out), (Some(2), ""), "{arguments:?}");
    }
}

#[test]
fn what_export_writes_is_right_and_with_four_influences_is_told_to_have_four() {
    let folder = tempfile::tempdir().unwrap();
    let export = |options: &[&str]| {
        let ran = editor_in(
            folder.path(),
            &[&["export", "-o", "a.obj"], options].concat(),
        );
        assert_eq!(ran.code, Some(0), "{}", ran.err);
    };
    let diagnosed = |model, pose| diagnose(folder.path(), "a.obj", model, pose).out;
    for (model, pose) in [
        ("builtin:adult", "builtin:adult-walk"),
        ("builtin:dog", "builtin:dog-trot"),
        ("builtin:humanoid", "builtin:humanoid-point"),
    ] {
        export(&[model, "--pose", pose]);
        let told = diagnosed(model, pose);
        assert!(told.starts_with("right: "), "{model}: {told}");
        let rest = told.lines().skip(1);
        assert!(
            rest.clone().all(|line| line.starts_with("  unseen ")),
            "{model}: {told}"
        );
    }
    let posed = ["builtin:adult", "--pose", "builtin:adult-walk"];
    export(&[&posed[..], &["--influences", "4"]].concat());
    let told = diagnosed("builtin:adult", "builtin:adult-walk");
    assert!(
        told.starts_with("influences-cut-4-renormalized: "),
        "{told}"
    );
}

#[test]
fn what_is_wrong_with_a_program_that_reads_collada_files_is_told_without_the_courses_names() {
    let folder = tempfile::tempdir().unwrap();
    let rig = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/rigs/column.dae");
    fs::copy(rig, folder.path().join("column.dae")).unwrap();
    let poses = r#"{"joints": {"Lower": [10, 20, 30], "Upper": [40, -30, 20]}}"#;
    fs::write(folder.path().join("bend.json"), poses).unwrap();
    let at_rest = editor_in(folder.path(), &["export", "column.dae", "-o", "rest.obj"]);
    assert_eq!(at_rest.code, Some(0), "{}", at_rest.err);
    let ran = diagnose(folder.path(), "rest.obj", "column.dae", "bend.json");
    assert!(ran.out.starts_with("pose-not-applied: "), "{}", ran.out);
    let told = "\n  section  Turning bones\n  look at  whether the rotations of the bones reach the matrices";
    assert!(ran.out.contains(told), "{}", ran.out);
    // One that nothing explains is told so, too.
    let nearly: String = fs::read_to_string(folder.path().join("rest.obj")).unwrap();
    let mut lines: Vec<&str> = nearly.lines().collect();
    let first = lines
        .iter()
        .position(|line| line.starts_with("v "))
        .unwrap();
    lines[first] = "v 9 9 9";
    fs::write(folder.path().join("nearly.obj"), lines.join("\n")).unwrap();
    let ran = diagnose(folder.path(), "nearly.obj", "column.dae", "bend.json");
    assert!(ran.out.contains("nearest  pose-not-applied"), "{}", ran.out);
    assert!(!ran.out.contains("setJointTransform"), "{}", ran.out);
}
