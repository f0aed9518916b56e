//! `editor export`.

use crate::program::check::POSES;
use crate::program::{editor_in, files_in, folder};
use crate::reference_data::{course, course_pose, posed};
use glam::Vec3;
use std::fs;
use std::path::Path;

fn vertices(obj: &Path) -> Vec<[f32; 3]> {
    let text = fs::read_to_string(obj).unwrap();
    let lines = text.lines().filter_map(|line| line.strip_prefix("v "));
    lines
        .map(|line| {
            let numbers: Vec<f32> = line.split(' ').map(|n| n.parse().unwrap()).collect();
            numbers.try_into().unwrap()
        })
        .collect()
}

#[test]
fn a_posed_character_is_written_in_the_order_of_its_file() {
    let folder = folder();
    let arguments = ["export", "man.obj", "--pose", "bend.json", "-o", "out.obj"];
    let ran = editor_in(folder.path(), &arguments);
    assert_eq!((ran.code, &*ran.out), (Some(0), ""));
    assert_eq!(
        ran.err,
        "warning: man.attach:2:1: 1 vertex with weights that do not sum up to 1\n"
    );
    let written = vertices(&folder.path().join("out.obj"));
    // The elbow at (0, 1, 0) turns by a quarter: (x, y) goes to (1 - y, 1 + x).
    let expected = [[1.0, 1.0, 0.0], [0.25, 0.5, 0.0], [-2.0, 1.0, 0.0]];
    for (written, expected) in written.iter().zip(expected) {
        let apart = (0..3).map(|axis| (written[axis] - expected[axis]).abs());
        assert!(apart.fold(0.0, f32::max) < 1e-6, "{written:?} {expected:?}");
    }
}

#[test]
fn one_pose_of_a_file_with_several_is_named_behind_the_file() {
    let folder = folder();
    let path = folder.path();
    fs::write(path.join("poses.json"), POSES).unwrap();
    let export = |pose: &str| {
        let ran = editor_in(path, &["export", "man.obj", "--pose", pose, "-o", "o.obj"]);
        assert_eq!(ran.code, Some(0), "{pose}: {}", ran.err);
        vertices(&path.join("o.obj"))
    };
    assert_eq!(export("poses.json#bend"), export("bend.json"));
    assert_ne!(export("poses.json#rest"), export("bend.json"));
    let arguments = ["export", "man.obj", "--pose", "poses.json", "-o", "p.obj"];
    let ran = editor_in(path, &arguments);
    let told = "error: poses.json: expected one pose, found 2 (rest, bend): one of them is poses.json#rest\n";
    assert!(
        ran.code == Some(1) && ran.err.ends_with(told),
        "{}",
        ran.err
    );
}

#[test]
fn a_scene_in_the_place_of_a_pose_is_told_to_be_one_and_how_its_pose_is_had() {
    let folder = folder();
    fs::write(
        folder.path().join("my.scene"),
        r#"{"format": "editor-scene", "version": 2, "shapes": []}"#,
    )
    .unwrap();
    let arguments = ["export", "man.obj", "--pose", "my.scene", "-o", "out.obj"];
    let ran = editor_in(folder.path(), &arguments);
    let told = "error: my.scene: expected a pose, found a scene: open it, and save the pose of its character by \
                Pose ⏵ Save Pose\n";
    assert_eq!(ran.code, Some(1));
    assert!(ran.err.ends_with(told), "{}", ran.err);
    assert!(!folder.path().join("out.obj").exists());
    // A joint may be called as what tells a scene.
    let skeleton = "0 0 0 -1 # Root\n0 1 0 0 # shapes\n";
    fs::write(folder.path().join("own.skel"), skeleton).unwrap();
    fs::copy(folder.path().join("man.obj"), folder.path().join("own.obj")).unwrap();
    fs::copy(
        folder.path().join("man.attach"),
        folder.path().join("own.attach"),
    )
    .unwrap();
    fs::write(
        folder.path().join("own.json"),
        r#"{"joints": {"shapes": [0, 0, 90]}}"#,
    )
    .unwrap();
    let arguments = ["export", "own.obj", "--pose", "own.json", "-o", "out.obj"];
    let ran = editor_in(folder.path(), &arguments);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
}

#[test]
fn dual_quaternions_are_asked_for_on_the_command_line() {
    let folder = folder();
    let export = |method: &str| {
        let arguments = ["export", "man.obj", "--pose", "bend.json", "-o", "out.obj"];
        let arguments = [&arguments[..], &["--skinning-method", method]].concat();
        let ran = editor_in(folder.path(), &arguments);
        (ran.code, vertices(&folder.path().join("out.obj")))
    };
    // The second vertex has weights that sum up to less than one: linear blending shrinks it.
    let (linear, dual) = (export("lbs"), export("dqs"));
    assert_eq!((linear.0, dual.0), (Some(0), Some(0)));
    let off = |to: [f32; 3], from: [f32; 3]| Vec3::from(to).distance(Vec3::from(from));
    assert!(off(linear.1[1], [0.25, 0.5, 0.0]) < 1e-6);
    assert!(off(dual.1[1], linear.1[1]) > 0.1);
    assert_eq!(export("other").0, Some(2));
}

#[test]
fn a_scene_is_written_in_the_world_and_can_be_read_again() {
    let folder = folder();
    let ran = editor_in(folder.path(), &["export", "a.scene", "-o", "out.obj"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let text = fs::read_to_string(folder.path().join("out.obj")).unwrap();
    assert!(
        text.contains("o Man\n") && text.contains("o Box\nv 0 0 2\n"),
        "{text}"
    );
    assert!(text.ends_with("f 4 5 6\nf 4 6 7\n"), "{text}");
    let ran = editor_in(folder.path(), &["check", "out.obj"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
}

#[test]
fn a_closed_sweep_is_written_with_or_without_the_closing_of_its_frames() {
    let folder = folder();
    let export = |options: &[&str]| {
        let arguments = [&["export", "builtin:seam", "-o", "out.obj"], options].concat();
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!((ran.code, &*ran.err), (Some(0), ""), "{options:?}");
        vertices(&folder.path().join("out.obj"))
    };
    let (closed, open) = (export(&[]), export(&["--no-frame-closing"]));
    assert_eq!(closed.len(), open.len());
    assert_ne!(closed, open);
}

#[test]
fn what_is_read_is_never_written_over() {
    let folder = folder();
    let before = fs::read(folder.path().join("box.obj")).unwrap();
    let told = "box.obj: expected another file to write than the one that is read\n";
    let ran = editor_in(folder.path(), &["export", "box.obj", "-o", "./box.obj"]);
    assert_eq!((ran.code, ran.err), (Some(1), format!("error: ./{told}")));
    let arguments = ["compare", "box.obj", "man.obj", "-o", "box.obj"];
    let ran = editor_in(folder.path(), &arguments);
    assert_eq!((ran.code, ran.err), (Some(1), format!("error: {told}")));
    assert_eq!(fs::read(folder.path().join("box.obj")).unwrap(), before);
}

#[test]
fn a_failed_export_leaves_no_file() {
    let folder = folder();
    fs::write(
        folder.path().join("off.json"),
        "{\"joints\":\n{\"Tap\": [0, 0, 1]}}",
    )
    .unwrap();
    fs::create_dir(folder.path().join("dir.obj")).unwrap();
    let before = files_in(folder.path());
    for (arguments, error) in [
        (&["bad.obj", "-o", "out.obj"][..], "error: bad.obj:2:7: "),
        (
            &["man.obj", "-o", "none/out.obj"],
            "error: none/out.obj: there is no folder none\n",
        ),
        (
            &["man.obj", "-o", "dir.obj"],
            "error: dir.obj: expected a file to write, found a folder\n",
        ),
        (
            &["man.obj", "--pose", "off.json", "-o", "out.obj"],
            "error: off.json:2:2: expected the name or index of a joint, such as “Tip”, “Root”, found “Tap”\n",
        ),
        (
            &["box.obj", "--pose", "bend.json", "-o", "out.obj"],
            "error: bend.json: expected a character to pose",
        ),
        (
            &["builtin:none", "-o", "out.obj"],
            "error: builtin:none: expected one of ",
        ),
    ] {
        let ran = editor_in(folder.path(), &[&["export"], arguments].concat());
        assert_eq!((ran.code, &*ran.out), (Some(1), ""), "{arguments:?}");
        assert!(
            ran.err
                .lines()
                .any(|line| error.starts_with(line) || line.starts_with(error)),
            "{}",
            ran.err
        );
    }
    assert_eq!(files_in(folder.path()), before);
}

#[test]
fn what_could_not_be_read_again_is_not_written_and_the_shape_is_named() {
    let folder = folder();
    let scene = "{\"format\": \"editor-scene\", \"version\": 1, \"shapes\": [{\"kind\": \"cube\",
        \"name\": \"Huge\", \"position\": [3e38, 0, 0], \"scale\": [3e38, 1, 1]}]}";
    fs::write(folder.path().join("far.scene"), scene).unwrap();
    let before = files_in(folder.path());
    let ran = editor_in(folder.path(), &["export", "far.scene", "-o", "out.obj"]);
    let error = "error: out.obj: expected shapes whose coordinates are numbers, found the shape \
                 “Huge” with a vertex too far out: make it smaller or move it nearer\n";
    assert_eq!((ran.code, &*ran.out, &*ran.err), (Some(1), "", error));
    assert_eq!(files_in(folder.path()), before);
}

#[test]
fn exported_vertices_agree_with_the_course_editor() {
    let folder = folder();
    for name in ["walk", "twist"] {
        let (Some(character), Some(pose), Some(golden)) = (
            course("characters/Model1.obj"),
            course_pose(name),
            posed(&format!("model1_{name}"), "v "),
        ) else {
            return;
        };
        let joints: serde_json::Map<_, _> = pose
            .into_iter()
            .map(|(joint, degrees)| (joint, serde_json::json!(degrees)))
            .collect();
        let pose = serde_json::json!({ "joints": joints }).to_string();
        fs::write(folder.path().join("pose.json"), pose).unwrap();
        let character = character.to_str().unwrap();
        let arguments = ["export", character, "--pose", "pose.json", "-o", "out.obj"];
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!((ran.code, &*ran.err), (Some(0), ""));
        let written = vertices(&folder.path().join("out.obj"));
        assert_eq!(written.len(), golden.len());
        for (vertex, (written, golden)) in written.iter().zip(&golden).enumerate() {
            for axis in 0..3 {
                assert!(
                    (written[axis] - golden[axis]).abs() < 2e-5,
                    "{name} vertex {vertex}"
                );
            }
        }
    }
}

#[test]
fn the_four_largest_weights_count_where_the_command_says_so() {
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    // Five joints beside the root, all in one place, hold the one vertex that is off the ground.
    write("arm.obj", "v 1 0 0\nv 0 0 0\nv 0 0 1\nf 1 2 3\n");
    write(
        "arm.skel",
        &("0 0 0 -1\n".to_owned() + &"0 0 0 0\n".repeat(5)),
    );
    write(
        "arm.attach",
        "0.3 0.25 0.2 0.15 0.1\n1 0 0 0 0\n1 0 0 0 0\n",
    );
    // The fifth, and weakest, turns it by half a circle: to (-1, 0, 0).
    write("turn.json", r#"{"joints": {"5": [0, 0, 180]}}"#);
    let first = |influences: &str| {
        let arguments = [
            "export",
            "arm.obj",
            "--pose",
            "turn.json",
            "--influences",
            influences,
        ];
        let ran = editor_in(
            folder.path(),
            &[&arguments[..], &["-o", "out.obj"]].concat(),
        );
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        vertices(&folder.path().join("out.obj"))[0]
    };
    let near = |found: [f32; 3], x: f32| (found[0] - x).abs() < 1e-6 && found[1].abs() < 1e-6;
    // 0.9 of it stays, 0.1 goes over.
    assert!(near(first("all"), 0.8), "{:?}", first("all"));
    assert!(near(first("4"), 1.0), "{:?}", first("4"));
    for wrong in ["3", "0", "many"] {
        let arguments = ["export", "arm.obj", "--influences", wrong, "-o", "no.obj"];
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!(ran.code, Some(2), "{wrong}: {}", ran.err);
    }
    assert!(!folder.path().join("no.obj").exists());
}

#[cfg(unix)]
#[test]
fn a_file_is_replaced_and_never_written_over() {
    let folder = folder();
    let (out, held) = (
        folder.path().join("out.obj"),
        folder.path().join("held.obj"),
    );
    fs::write(&out, "the version before").unwrap();
    // Whoever holds the old file goes on reading the whole of it.
    fs::hard_link(&out, &held).unwrap();
    let ran = editor_in(folder.path(), &["export", "box.obj", "-o", "out.obj"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert_eq!(fs::read_to_string(&held).unwrap(), "the version before");
    assert_eq!(vertices(&out).len(), 4);
}

/// The largest distance between vertices of two `.obj` files.
fn apart(a: &Path, b: &Path) -> f32 {
    let (a, b) = (vertices(a), vertices(b));
    assert_eq!(a.len(), b.len());
    let far = a.iter().zip(&b).map(|(a, b)| {
        let squares = (0..3).map(|axis| (a[axis] - b[axis]).powi(2));
        squares.sum::<f32>().sqrt()
    });
    far.fold(0.0, f32::max)
}

#[test]
fn a_rig_of_three_trees_becomes_a_character_with_its_pose_that_stands_as_before() {
    let folder = folder();
    let run = |line: &str| {
        let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
        assert_eq!((ran.code, &*ran.out), (Some(0), ""), "{line}: {}", ran.err);
        ran.err
    };
    let before = files_in(folder.path()).len();
    run("export builtin:creature --pose builtin:creature-wave -o out.skel");
    let written = ["out.attach", "out.json", "out.obj", "out.skel"].map(|name| name.into());
    let found = files_in(folder.path());
    assert_eq!(found.len(), before + 4);
    assert!(written.iter().all(|name| found.contains(name)), "{found:?}");
    let skel = fs::read_to_string(folder.path().join("out.skel")).unwrap();
    assert!(skel.starts_with("0 0 0 -1 # Added root\n"), "{skel}");
    let told = run("export builtin:crate -o crate.skel");
    let left_out = "warning: The course's files have no ";
    assert!(told.starts_with(left_out), "{told}");
    assert_eq!(
        run("export out.obj -o again.skel"),
        "",
        "it has no more than these"
    );

    run("export builtin:creature --pose builtin:creature-wave -o was.obj");
    assert_eq!(run("export out.obj --pose out.json -o is.obj"), "");
    let path = |name: &str| folder.path().join(name);
    // The creature is about as high as 2.
    assert!(apart(&path("was.obj"), &path("is.obj")) < 1e-5);
    run("export builtin:creature -o rest.obj");
    // At rest, too, the vertices of the first are sums of weights, which are rounded.
    assert!(apart(&path("rest.obj"), &path("out.obj")) < 1e-5);
    assert!(apart(&path("rest.obj"), &path("was.obj")) > 0.1);
}

#[test]
fn what_is_no_single_character_is_refused_and_a_name_chooses_one() {
    let folder = folder();
    let before = files_in(folder.path());
    let two = "man.obj builtin:robot";
    for (line, code, error) in [
        (
            "box.obj -o out.skel",
            1,
            "box.obj: expected a character to write, found none",
        ),
        (
            "man.obj builtin:robot -o out.skel",
            1,
            "man.obj: expected one character, found “Man”, “Robot”: choose one with --shape NAME",
        ),
        (
            "man.obj builtin:robot --shape Woman -o out.skel",
            1,
            "man.obj: expected the name of a character, such as “Man”, “Robot”, found “Woman”",
        ),
        (
            "man.obj man.obj --shape Man -o out.skel",
            1,
            "man.obj: expected one character called “Man”, found several",
        ),
        (
            "man.obj -o man.skel",
            1,
            "man.skel: expected another file to write than the one that is read",
        ),
        (
            "a.scene -o man.obj",
            1,
            "man.obj: expected another file to write than the one that is read",
        ),
        (
            "a.scene --shape Man -o man.skel",
            1,
            "man.skel: expected another file to write than the one that is read",
        ),
        (
            "man.obj --pose bend.json -o bend.skel",
            1,
            "bend.json: expected another file to write than the one that is read",
        ),
        (
            "man.obj --materials -o out.skel",
            2,
            "out.skel: expected a name that ends in .obj with --materials, found one that ends in .skel",
        ),
        (
            "man.obj --shape Man -o out.obj",
            2,
            "out.obj: expected a name that ends in .skel with --shape, found one that ends in .obj",
        ),
        (
            "man.obj -o out.stl",
            2,
            "out.stl: expected a name that ends in .obj or .skel",
        ),
    ] {
        let arguments: Vec<_> = std::iter::once("export").chain(line.split(' ')).collect();
        let ran = editor_in(folder.path(), &arguments);
        assert_eq!(
            (ran.code, &*ran.out),
            (Some(code), ""),
            "{line}: {}",
            ran.err
        );
        let told = format!("error: {error}");
        assert!(
            ran.err.lines().any(|line| line == told),
            "{line}: {}",
            ran.err
        );
    }
    assert_eq!(files_in(folder.path()), before);
    let line = format!("export {two} --shape Robot -o out.skel");
    let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let ran = editor_in(folder.path(), &["check", "out.obj"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
}

#[test]
fn materials_lie_beside_the_geometry_and_without_the_option_nothing_changes() {
    let folder = folder();
    let export = |options: &[&str]| {
        let ran = editor_in(
            folder.path(),
            &[&["export", "builtin:crate"], options].concat(),
        );
        assert_eq!(
            (ran.code, &*ran.out, &*ran.err),
            (Some(0), "", ""),
            "{options:?}"
        );
    };
    let before = files_in(folder.path()).len();
    export(&["-o", "plain.obj"]);
    assert_eq!(files_in(folder.path()).len(), before + 1);
    export(&["--materials", "-o", "out.obj"]);
    let text = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let plain = text("plain.obj");
    assert!(!plain.contains("mtl") && plain.lines().all(|line| !line.starts_with("vt")));
    assert_eq!(
        vertices(&folder.path().join("plain.obj")),
        vertices(&folder.path().join("out.obj"))
    );
    assert!(text("out.obj").starts_with("mtllib out.mtl\no Crate\nv "));
    assert!(
        text("out.mtl").contains("map_Kd out-1.png\n"),
        "{}",
        text("out.mtl")
    );
    let written = image::open(folder.path().join("out-1.png"))
        .unwrap()
        .to_rgba8();
    let original = image::open("assets/rigs/crate.png").unwrap().to_rgba8();
    assert!(written == original);
    let ran = editor_in(folder.path(), &["check", "out.obj"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    let picture = |file: &str, name: &str| {
        let arguments = [
            "render",
            file,
            "--look",
            "studio",
            "--camera=60,20,6",
            "-o",
            name,
        ];
        assert_eq!(editor_in(folder.path(), &arguments).code, Some(0));
        image::open(folder.path().join(name)).unwrap().to_rgba8()
    };
    assert!(picture("builtin:crate", "a.png") == picture("out.obj", "b.png"));
}

#[test]
fn files_that_belong_together_are_written_all_or_none() {
    let folder = folder();
    fs::create_dir(folder.path().join("out.mtl")).unwrap();
    fs::create_dir(folder.path().join("man2.obj")).unwrap();
    let before = files_in(folder.path());
    for (line, error) in [
        (
            "export builtin:crate --materials -o out.obj",
            "error: out.mtl: ",
        ),
        ("export builtin:robot -o man2.skel", "error: man2.obj: "),
    ] {
        let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
        let told = format!("{error}expected a file to write, found a folder\n");
        assert_eq!((ran.code, ran.err), (Some(1), told), "{line}");
    }
    assert_eq!(files_in(folder.path()), before);
}
