//! What is blank, missing, unreadable and wrong is told apart.

use crate::diagnose::figures::Figure;
use crate::diagnose::figures::obj;
use crate::diagnose::student::{RIGHT, with};
use crate::grade::support::{Class, result};
use crate::program::editor_in;
use glam::Vec3;
use serde_json::{Value, json};

fn class() -> (Class, String) {
    let class = Class::new(&["adult"]);
    let figure: &Figure = &class.tests[0].1;
    let right = obj(&RIGHT.skin(figure), figure, |number| number.to_string());
    (class, right)
}

/// The file with every face the other way round.
fn inside_out(text: &str) -> String {
    let lines = text.lines().map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["f", a, b, c] => format!("f {c} {b} {a}"),
            _ => line.to_owned(),
        }
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn what_lies_beside_the_folders_of_submissions_is_told_if_somebody_may_have_handed_it_in() {
    let (class, right) = class();
    for name in [
        "ann/adult-1.obj",
        "tom.obj",
        "Zoe.ZIP",
        "._tom.obj",
        "__MACOSX/adult-1.obj",
        ".hidden/adult-1.obj",
    ] {
        class.write(&format!("class/{name}"), &right);
    }
    let ran = class.run("class --tests tests.json -o report");
    let warnings: Vec<&str> = ran
        .err
        .lines()
        .filter(|line| line.starts_with("warning: "))
        .collect();
    let told = |name: &str| {
        let told = format!("{name}: left out, since it is in no folder of a submission");
        warnings.iter().filter(|line| line.ends_with(&told)).count()
    };
    assert_eq!(
        (told("tom.obj"), told("Zoe.ZIP"), warnings.len()),
        (1, 1, 2),
        "{}",
        ran.err
    );
    let report = class.graded();
    assert_eq!(
        report["submissions"].as_array().unwrap().len(),
        1,
        "{report}"
    );
}

#[cfg(unix)]
#[test]
fn links_to_other_folders_and_to_nowhere_are_told_to_be_left_out() {
    let (class, right) = class();
    class.write("class/ann/adult-1.obj", &right);
    for (from, to) in [("ann", "bob"), ("nowhere", "cem")] {
        let link = class.path().join("class").join(to);
        std::os::unix::fs::symlink(from, link).unwrap();
    }
    let ran = class.run("class --tests tests.json -o report");
    for name in ["bob", "cem"] {
        let told = format!("warning: class/{name}: left out, since it is a symbolic link\n");
        assert!(ran.err.contains(&told), "{}", ran.err);
    }
    let report = class.graded();
    assert_eq!(report["submissions"].as_array().unwrap().len(), 1);
}

#[test]
fn a_mesh_is_right_wrong_blank_missing_or_unreadable() {
    let (class, right) = class();
    let figure = &class.tests[0].1;
    let number: fn(f32) -> String = |number| number.to_string();
    let origin = obj(&vec![Vec3::ZERO; figure.positions.len()], figure, number);
    let wrong = obj(&with(&["parent-order"]).skin(figure), figure, number);
    let mut bent = RIGHT.skin(figure);
    for place in bent.iter_mut().take(500) {
        *place += Vec3::new(1.0, 2.0, 3.0);
    }
    let bent = obj(&bent, figure, number);
    let nan = right.replacen("v ", "v nan ", 1);
    let comma = format!("v 0,58 0,08 1\n{right}");
    let faces = &right[right.find("f ").unwrap()..];
    let no_number = "v nan -inf 1\n".repeat(figure.positions.len()) + faces;
    let latin = [b"# J\xFCrgen\n".as_slice(), right.as_bytes()].concat();
    let cut = &right[..right.len() / 3];
    let mut lines: Vec<&str> = right.lines().collect();
    let (vertices, triangles) = (figure.positions.len(), figure.triangles.len());
    let no_faces = lines[..vertices].join("\n");
    // Of its last face two corners are left.
    let last = lines[vertices + 1000].rsplit_once(' ').unwrap().0;
    let cut_in_a_face = format!("{}\n{last}", lines[..vertices + 1000].join("\n"));
    let cut_text = format!(
        "but      {} of the model's {triangles} triangles are missing: the file may be cut off",
        triangles - 1000
    );
    let mut one_other = lines.clone();
    one_other[vertices + 100] = "f 1 2 3";
    let one_other = one_other.join("\n");
    lines[vertices..].reverse();
    let other_order = lines.join("\n");
    for (name, content) in [
        ("ada", &*right),
        ("bob", &wrong),
        ("cem", &bent),
        ("dan", ""),
        ("eve", "\n \n"),
        ("fay", "# nothing yet\n"),
        ("flo", "0.5, 1, -2e-3\nV 1 2 3\n1 2\n"),
        ("gus", &origin),
        ("hal", cut),
        ("ida", &nan),
        ("jan", &no_number),
        ("joe", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("liv", "\n<!DOCTYPE html>\n<html>404</html>\n"),
        ("lou", &comma),
        ("max", &cut_in_a_face),
        ("ned", &no_faces),
        ("ole", &other_order),
    ] {
        class.write(&format!("class/{name}/adult-1.obj"), content);
    }
    // The faces name normals that nobody has written.
    let with_normals = right.lines().map(|line| match line.strip_prefix("f ") {
        Some(corners) => {
            let corners = corners
                .split(' ')
                .map(|corner| format!(" {corner}//{corner}"));
            format!("f{}\n", corners.collect::<String>())
        }
        None => format!("{line}\n"),
    });
    class.write("class/nic/adult-1.obj", with_normals.collect::<String>());
    // Corners count from 0, which the file cannot name.
    let from_0 = right.lines().map(|line| match line.strip_prefix("f ") {
        Some(corners) => {
            let corners = corners
                .split(' ')
                .map(|corner| corner.parse::<u32>().unwrap() - 1);
            let corners = corners.map(|corner| format!(" {corner}"));
            format!("f{}\n", corners.collect::<String>())
        }
        None => format!("{line}\n"),
    });
    class.write("class/nil/adult-1.obj", from_0.collect::<String>());
    class.write("class/kai/adult-1.obj", latin);
    class.write("class/kim/Adult.obj", &right);
    class.write("class/pia/Adult-1.OBJ", &right);
    std::fs::create_dir_all(class.path().join("class/lee/adult-1.obj")).unwrap();
    let rubbish: Vec<u8> = (0..5000_u32).map(|at| (at * at % 251) as u8).collect();
    class.write("class/raj/adult-1.obj", rubbish);
    class.write("class/viv/adult-1.obj", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR");
    class.write("class/sam/hw2/out/adult-1.obj", &right);
    class.write("class/tim/adult-1.obj", inside_out(&right));
    class.write("class/una/adult-1.obj", &one_other);
    class.write(
        "class/zoe/adult-1.obj",
        right.splitn(3, '\n').last().unwrap(),
    );
    let zyx = obj(&with(&["euler-zyx"]).skin(figure), figure, number);
    let cut = zyx.lines().take(vertices + 1000);
    class.write("class/eli/adult-1.obj", cut.collect::<Vec<_>>().join("\n"));
    let report = class.graded();
    for (name, outcome, text) in [
        ("ada", "right", "right: this is the exact result"),
        ("bob", "explained", "parent-order: "),
        ("cem", "unexplained", "unexplained: "),
        ("dan", "blank", "the file is empty"),
        ("eve", "blank", "the file is empty"),
        ("fay", "blank", "the file has no vertices"),
        (
            "flo",
            "blank",
            "the file has no vertices: 2 lines with three numbers begin without the v of v x y z",
        ),
        ("gus", "blank", "all vertices are at the origin"),
        ("hal", "unreadable", "adult-1.obj"),
        (
            "ida",
            "unexplained",
            "nearly right: all but 1 of its vertices are right",
        ),
        (
            "jan",
            "blank",
            "adult-1.obj:1: 13301 vertices are no numbers (nan or infinite)",
        ),
        ("joe", "unreadable", "adult-1.obj: expected "),
        (
            "liv",
            "unreadable",
            "adult-1.obj: expected lines of words and numbers, found a web page (HTML)",
        ),
        (
            "lou",
            "unreadable",
            "adult-1.obj:1:3: expected a number for x with a decimal point, found “0,58”",
        ),
        ("nic", "right", "right: this is the exact result"),
        (
            "nil",
            "explained",
            "right but for its triangles: its vertices are the exact result",
        ),
        ("kai", "right", "right: this is the exact result"),
        ("raj", "unreadable", "adult-1.obj"),
        (
            "viv",
            "unreadable",
            "adult-1.obj: expected text, found a PNG picture",
        ),
        ("kim", "missing", "there is no adult-1.obj"),
        (
            "pia",
            "missing",
            "there is no adult-1.obj, but Adult-1.OBJ is there: the names differ in capitals",
        ),
        (
            "sam",
            "missing",
            "there is no adult-1.obj, but hw2/out/adult-1.obj is there: it belongs into the folder of the submission itself",
        ),
        ("tim", "explained", "right but for its triangles: "),
        (
            "lee",
            "unreadable",
            "adult-1.obj: expected a file, found a folder",
        ),
        ("max", "explained", "right but for its triangles: "),
        ("una", "explained", "right but for its triangles: "),
        ("eli", "explained", "euler-zyx: "),
        ("ned", "right", "right: this is the exact result"),
        (
            "zoe",
            "unreadable",
            "adult-1.obj:39559:9: expected a vertex from 1 to 13299, found 13300: the file lacks 2 of 13301 vertices",
        ),
        ("ole", "right", "right: this is the exact result"),
    ] {
        let found = result(&report, name, "adult-1");
        assert_eq!(found["outcome"], outcome, "{name}: {found}");
        assert!(
            found["text"].as_str().unwrap().starts_with(text),
            "{name}: {found}"
        );
    }
    let points = |name: &str| {
        result(&report, name, "adult-1")["points"]["4.2"]
            .as_f64()
            .unwrap()
    };
    assert_eq!(
        (points("ada"), points("gus"), points("kim"), points("tim")),
        (10.0, 0.0, 0.0, 9.0)
    );
    assert_eq!(
        result(&report, "tim", "adult-1")["causes"],
        json!([["triangles-turned"]])
    );
    let told = |name: &str, told: &str| {
        let found = result(&report, name, "adult-1");
        assert!(found["text"].as_str().unwrap().contains(told), "{found}");
        found["causes"].clone()
    };
    // What the file has, and not what stands for it.
    told("ida", "theirs (NaN, ");
    told("ida", "away     an infinite distance");
    assert_eq!(told("max", &cut_text), json!([["triangles-differ"]]));
    assert_eq!(
        told("una", "triangles is missing, and 1 other is there"),
        json!([["triangles-differ"]])
    );
    assert_eq!(
        told("eli", &cut_text),
        json!([["euler-zyx", "triangles-differ"]])
    );
    // Posing does nothing to faces, which may even be left out.
    assert_eq!(
        ["max", "una", "nil", "ned"].map(points),
        [9.0, 9.0, 9.0, 10.0]
    );
    // Nearly all agrees: from 45 % of the points where nine tenths do to what is right but for few.
    let near = result(&report, "cem", "adult-1")["near"].as_f64().unwrap();
    assert!((0.9..0.99).contains(&near), "{near}");
    let expected = 4.5 + (near - 0.9) / 0.09 * 4.5;
    assert!((points("cem") - expected).abs() < 0.01, "{}", points("cem"));
}

#[test]
fn pictures_are_graded_by_their_silhouette_whatever_their_scale() {
    let (class, right) = class();
    let mut tests = class.tests_file();
    tests["tests"][0]["kind"] = "picture".into();
    tests["tests"][0]["camera"] = json!([80, 10, 3]);
    tests["tests"][0]["size"] = json!([400, 300]);
    class.set_tests(&tests);
    let figure = &class.tests[0].1;
    class.write("right.obj", right);
    let wrong = with(&["parent-order"]).skin(figure);
    class.write(
        "wrong.obj",
        obj(&wrong, figure, |number| number.to_string()),
    );
    for (name, line) in [
        ("ada", "right.obj --camera 80,10,3 --size 400x300"),
        ("bob", "wrong.obj --camera 80,10,3 --size 400x300"),
        (
            "cem",
            "right.obj --camera 80,10,3,100,100,100 --size 400x300",
        ),
        ("dan", "right.obj --camera 80,10,3 --size 200x150"),
        ("gus", "right.obj --camera 80,10,3 --size 300x300"),
        ("hal", "right.obj --camera 80,10,3 --size 80x60"),
    ] {
        class.write(&format!("class/{name}/about.txt"), "");
        let output = format!("class/{name}/adult-1.png");
        let words = ["render", "-o", &output].into_iter().chain(line.split(' '));
        let ran = editor_in(class.path(), &words.collect::<Vec<_>>());
        assert_eq!(ran.code, Some(0), "{}", ran.err);
    }
    let png = class.read("class/ada/adult-1.png");
    class.write("class/eve/adult-1.png", &png[..png.len() / 2]);
    class.write("class/fay/adult-1.png", "");
    let mut speck = image::load_from_memory(&png).unwrap().to_rgba8();
    for (x, y) in (0..25).map(|at| (20 + at % 5, 20 + at / 5)) {
        speck.put_pixel(x, y, image::Rgba([255, 255, 255, 255]));
    }
    class.write("class/ian/about.txt", "");
    speck
        .save(class.path().join("class/ian/adult-1.png"))
        .unwrap();
    let report = class.graded();
    for (name, outcome, text) in [
        ("ada", "right", "right, as far as the silhouette tells"),
        ("bob", "explained", "parent-order: "),
        (
            "cem",
            "blank",
            "there is nothing in the picture but its background",
        ),
        ("dan", "right", "right, as far as the silhouette tells"),
        (
            "gus",
            "unreadable",
            "adult-1.png: expected 400×300 pixels, or a picture of the same shape at least a quarter",
        ),
        ("hal", "unreadable", "adult-1.png: expected 400×300 pixels"),
        ("eve", "unreadable", "adult-1.png: "),
        ("fay", "blank", "the file is empty"),
        ("ian", "unexplained", "nearly right: "),
    ] {
        let found = result(&report, name, "adult-1");
        assert_eq!(found["outcome"], outcome, "{name}: {found}");
        assert!(
            found["text"].as_str().unwrap().starts_with(text),
            "{name}: {found}"
        );
    }
    let ian = result(&report, "ian", "adult-1");
    let points = &ian["points"]["4.2"];
    assert_eq!(points, 9.0, "{ian}");
    let hint = ian["hint"].as_str().unwrap();
    assert!(hint.starts_with("all but 0."), "{hint}");
}

#[test]
fn a_test_may_have_one_pose_of_a_file_with_several() {
    let (class, right) = class();
    class.write("class/ada/adult-1.obj", right);
    let mut tests = class.tests_file();
    let named = tests["tests"][0]["pose"].as_str().unwrap().to_owned();
    let pose: Value = serde_json::from_slice(&class.read(&named)).unwrap();
    let joints = pose["joints"].as_object().unwrap().iter();
    let turned = joints.map(|(joint, degrees)| (joint.clone(), json!({"xyz_deg": degrees})));
    let turned: serde_json::Map<String, Value> = turned.collect();
    let several = json!({"poses": {"rest": {}, "mine": turned}});
    class.write("poses.json", several.to_string());
    tests["tests"][0]["pose"] = "poses.json#mine".into();
    class.set_tests(&tests);
    assert_eq!(
        result(&class.graded(), "ada", "adult-1")["outcome"],
        "right"
    );
    // Other programs get it in a file of its own.
    class.write("class/ada/made.obj", class.read("class/ada/adult-1.obj"));
    class.write(
        "class/ada/make.sh",
        "grep -q joints \"$1\" && ! grep -q poses \"$1\" && cp made.obj \"$2\"",
    );
    tests["command"] = json!({"run": ["sh", "make.sh", "{pose}", "{output}"]});
    for extension in ["obj", "skel", "attach"] {
        let root = env!("CARGO_MANIFEST_DIR");
        let from = format!("{root}/assets/characters/adult.{extension}");
        class.write(&format!("a.{extension}"), std::fs::read(from).unwrap());
    }
    tests["tests"][0]["character"] = "a.obj".into();
    class.set_tests(&tests);
    let report = class.graded();
    let found = result(&report, "ada", "adult-1");
    assert_eq!(found["outcome"], "right", "{found}");
}

#[test]
fn what_is_wrong_with_the_tests_or_the_folder_is_one_clear_error_and_leaves_no_report() {
    let (class, right) = class();
    class.write("class/ada/adult-1.obj", right);
    class.write("empty/readme.txt", "");
    let tests = class.tests_file();
    let with = |change: fn(&mut Value)| {
        let mut tests = tests.clone();
        change(&mut tests);
        tests.to_string()
    };
    class.write(
        "character.json",
        with(|tests| tests["tests"][0]["character"] = "builtin:nobody".into()),
    );
    class.write(
        "shape.json",
        with(|tests| tests["tests"][0]["character"] = "builtin:gear".into()),
    );
    class.write(
        "pose.json",
        with(|tests| tests["tests"][0]["pose"] = "none.json".into()),
    );
    class.write(
        "other.json",
        with(|tests| tests["tests"][0]["pose"] = "builtin:dog-trot".into()),
    );
    class.write(
        "gone.json",
        with(|tests| tests["tests"][0]["pose"] = "no-pose.json".into()),
    );
    class.write(
        "no-model.json",
        with(|tests| tests["tests"][0]["character"] = "no-model.obj".into()),
    );
    class.write(
        "given.json",
        r#"{"tests": [{"name": "a", "character": "b", "pose": "c", "points": {"4.2": 12, "3.4": 2}}],
            "rubric": {"sections": {"4.2": {"points": 15}, "artifact": {"points": 20}},
                "given": {"Ada": {"artifact": 20, "4.2": 15, "3.4": 5}}}}"#,
    );
    class.write("none.json", "{\"tests\": []}");
    class.write(
        "command.json",
        with(|tests| tests["command"] = json!({"run": ["./a", "{character}", "{output}"]})),
    );
    class.write("cut.json", "{\"tests\": [");
    for (line, told) in [
        (
            "class --tests nowhere.json",
            "nowhere.json: there is no such file",
        ),
        (
            "nowhere --tests tests.json",
            "nowhere: there is no such folder",
        ),
        (
            "tests.json --tests tests.json",
            "tests.json: expected a folder, found a file",
        ),
        (
            "empty --tests tests.json",
            "empty: expected a folder for each submission, found none",
        ),
        ("class --tests character.json", "nobody"),
        ("class --tests shape.json", "builtin:shapes/gear.obj"),
        ("class --tests pose.json", "none.json"),
        (
            "class --tests other.json",
            "expected the name or index of a joint",
        ),
        (
            "class --tests gone.json",
            "gone.json:1:100: expected the file of a pose, found none at no-pose.json",
        ),
        (
            "class --tests no-model.json",
            "no-model.json:1:24: expected the file of a character, found none at no-model.obj",
        ),
        (
            "class --tests given.json",
            "given.json:3:69: expected at most the 2 points of section 3.4, found 5",
        ),
        (
            "class --tests cut.json",
            "cut.json:1:12: expected the rest of",
        ),
        (
            "class --tests none.json",
            "none.json: expected a test, found none",
        ),
        (
            "class --tests command.json",
            "expected a file for {character} of the command, found builtin:adult",
        ),
        (
            "--merge nowhere",
            "nowhere: expected the finished report of `editor grade`, found none",
        ),
    ] {
        let ran = class.run(&format!("{line} -o report"));
        assert_eq!((ran.code, &*ran.out), (Some(1), ""), "{line}: {}", ran.err);
        assert!(
            ran.err.starts_with("error: ") && ran.err.contains(told),
            "{line}: {}",
            ran.err
        );
        assert_eq!(ran.err.lines().count(), 1, "{line}: {}", ran.err);
        assert!(!class.path().join("report").exists(), "{line}");
    }
    for (output, told) in [
        (
            "-",
            "-: expected a folder for the report, found - for standard output",
        ),
        (
            "tests.json",
            "tests.json: a part of its path is a file, not a folder",
        ),
    ] {
        let ran = class.run(&format!("class --tests tests.json -o {output}"));
        // What the tests do not show may be noted before.
        let told = format!("error: {told}\n");
        assert!(ran.err.ends_with(&told), "{output}: {}", ran.err);
        assert_eq!(ran.code, Some(1), "{output}");
    }
    for line in [
        "class",
        "--tests tests.json",
        "class --tests tests.json --part 3/2",
        "class --merge a",
    ] {
        assert_eq!(class.run(line).code, Some(2), "{line}");
    }
    let ran = class.run("class --tests tests.json --jobs 0");
    let told = "expected a whole number from 1 on, found 0";
    assert!(ran.code == Some(2) && ran.err.contains(told), "{}", ran.err);
}
