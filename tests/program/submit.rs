//! `editor submit`: what is in the archive, and what is refused.

use super::{Ran, editor_in, files_in, folder};
use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::Path;

/// File of an archive: its content, and whether it may be executed.
type Unpacked = BTreeMap<String, (Vec<u8>, bool)>;

/// All files of a `.zip` or `.tar.gz`, by their paths.
pub fn unpacked(archive: &Path) -> Unpacked {
    let file = fs::File::open(archive).unwrap();
    let mut files = Unpacked::new();
    if archive.extension().is_some_and(|end| end == "zip") {
        let mut zip = zip::ZipArchive::new(file).unwrap();
        for index in 0..zip.len() {
            let mut entry = zip.by_index(index).unwrap();
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).unwrap();
            let runs = entry.unix_mode().unwrap() & 0o111 != 0;
            let before = files.insert(entry.name().unwrap().to_string(), (bytes, runs));
            assert!(before.is_none(), "{:?} is in it twice", entry.name());
        }
        return files;
    }
    let mut tar = tar::Archive::new(flate2::read::GzDecoder::new(file));
    for entry in tar.entries().unwrap() {
        let mut entry = entry.unwrap();
        let path = entry.path().unwrap().to_str().unwrap().to_owned();
        let runs = entry.header().mode().unwrap() & 0o111 != 0;
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).unwrap();
        let before = files.insert(path.clone(), (bytes, runs));
        assert!(before.is_none(), "{path} is in it twice");
    }
    files
}

/// Answers to all questions.
pub const ANSWERS: &str = "## Name\nAda Lovelace\n## Compiling\nType make.\n## Collaboration\n\
    With Charles.\n## References\nnone\n## Problems\nnone\n## Extra credit\nboxes as bones\n";

/// A scene with a character for each of `angles`, which turn its joint, side by side.
fn scene(angles: &[f32]) -> String {
    let shapes = angles.iter().enumerate().map(|(place, angle)| {
        format!(
            "{{\"source\": \"man.obj\", \"name\": \"Man {place}\", \"position\": [{place}, -1, 0],
            \"pose\": {{\"joints\": {{\"Tip\": [0, 0, {angle}]}}}}}}"
        )
    });
    let shapes: Vec<String> = shapes.collect();
    format!(
        "{{\"format\": \"editor-scene\", \"version\": 1, \"shapes\": [{}]}}",
        shapes.join(", ")
    )
}

/// The folder of a small project, with everything beside it that must stay at home, and a scene
/// `two.scene` of two posed characters beside the project.
fn project() -> tempfile::TempDir {
    let folder = folder();
    for (name, text) in [
        ("p/Cargo.toml", "[package]"),
        ("p/Cargo.lock", "version = 4"),
        ("p/Makefile", "all:"),
        ("p/README.md", "# mine"),
        ("p/.gitignore", "/target\n/editor\nnotes.txt\n"),
        ("p/src/main.rs", "fn main() {}"),
        ("p/src/target/mod.rs", "// of a target"),
        ("p/shaders/a.glsl", "void main() {}"),
        ("p/assets/a.zip", "data of the project"),
        ("p/notes.txt", "private"),
        ("p/src/._main.rs", "of macOS"),
        ("p/src/main.rs~", "of an editor"),
        ("p/.DS_Store", "of macOS"),
        ("p/.git/config", "of git"),
        ("p/target/debug/a.o", "built"),
        ("p/out/CACHEDIR.TAG", "built elsewhere"),
        ("p/out/a.o", "built"),
        ("p/editor", "an old program"),
        ("p/old.tar.gz", "handed in before"),
        ("program", "the program"),
        ("answers.md", ANSWERS),
        ("two.scene", &scene(&[30.0, -30.0])),
    ] {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

fn submit(folder: &tempfile::TempDir, line: &str) -> Ran {
    let line = format!("submit --project p --executable program {line}");
    editor_in(folder.path(), &line.split_whitespace().collect::<Vec<_>>())
}

#[test]
fn the_archive_holds_code_program_answers_picture_and_data_and_nothing_else() {
    let folder = project();
    for (name, root) in [("out.zip", "out"), ("a.b.tar.gz", "a.b")] {
        let line = format!("--scene two.scene --answers answers.md -o {name}");
        let ran = submit(&folder, &line);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        assert!(ran.out.lines().next().unwrap().ends_with(name));
        let files = unpacked(&folder.path().join(name));
        let expected = [
            ".gitignore",
            "Cargo.lock",
            "Cargo.toml",
            "Makefile",
            "README.md",
            "README.txt",
            "assets/a.zip",
            "data/two.zip",
            "editor",
            "picture.png",
            "shaders/a.glsl",
            "src/main.rs",
            "src/target/mod.rs",
        ];
        let expected = expected.map(|path| format!("{root}/{path}"));
        assert_eq!(files.keys().cloned().collect::<Vec<_>>(), expected);
        let file = |path: &str| files[&format!("{root}/{path}")].clone();
        assert_eq!(file("editor"), (b"the program".to_vec(), true));
        assert_eq!(file("src/main.rs"), (b"fn main() {}".to_vec(), false));
        let readme = String::from_utf8(file("README.txt").0).unwrap();
        for answer in [
            "Ada Lovelace",
            "Type make.",
            "With Charles.",
            "boxes as bones",
        ] {
            assert!(readme.contains(answer), "{readme}");
        }
        let picture = image::load_from_memory(&file("picture.png").0).unwrap();
        assert_eq!((picture.width(), picture.height()), (1280, 960));

        // The scene in it needs nothing that is not in it.
        let elsewhere = tempfile::tempdir().unwrap();
        fs::write(elsewhere.path().join("two.zip"), file("data/two.zip").0).unwrap();
        let line = "render two.zip --size 1280x960 --samples 4 -o again.png";
        let ran = editor_in(elsewhere.path(), &line.split(' ').collect::<Vec<_>>());
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        let again = image::open(elsewhere.path().join("again.png")).unwrap();
        assert!(again.to_rgba8() == picture.to_rgba8(), "another picture");
    }
}

#[test]
fn the_picture_is_wider_where_somebody_would_be_cut_off_at_its_sides() {
    let folder = project();
    let hand_in = |place: &str| {
        let wide = scene(&[30.0, 30.0]).replace("[1, -1, 0]", place);
        fs::write(folder.path().join("wide.scene"), wide).unwrap();
        let ran = submit(
            &folder,
            "--scene wide.scene --answers answers.md -o wide.zip",
        );
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        let files = unpacked(&folder.path().join("wide.zip"));
        let picture = image::load_from_memory(&files["wide/picture.png"].0).unwrap();
        assert_eq!(picture.height(), 960);
        (picture.width(), ran.err)
    };
    let (width, told) = hand_in("[3, -1, 0]");
    assert!((1281..2304).contains(&width), "{width}");
    let note = format!("note: the picture is {width}x960, so that nobody is cut off at its sides");
    assert!(told.contains(&note), "{told}");
    let (width, told) = hand_in("[5, -1, 0], \"scale\": [9, 1, 1]");
    assert_eq!(width, 2304);
    let warning = "warning: “Man 1” is cut off at a side of the picture";
    assert!(told.contains(warning) && !told.contains("note"), "{told}");
}

#[test]
fn of_another_project_the_program_that_is_built_there_is_handed_in() {
    let folder = project();
    let at = |path: &str| folder.path().join(path);
    fs::write(
        at("p/Cargo.toml"),
        "[package]\nedition = \"2024\"\nname = \"hw2\"\n\n[dependencies]\nname = \"1\"\n",
    )
    .unwrap();
    let line = "submit --project p --scene two.scene --answers answers.md -o o.zip";
    let line: Vec<&str> = line.split(' ').collect();
    let ran = editor_in(folder.path(), &line);
    let told =
        "p/target/release/hw2: expected the program of the project, found none: build it with";
    assert!(ran.code == Some(1) && ran.err.contains(told), "{}", ran.err);
    fs::create_dir_all(at("p/target/release")).unwrap();
    fs::write(at("p/target/release/hw2"), "my program").unwrap();
    let ran = editor_in(folder.path(), &line);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let files = unpacked(&at("o.zip"));
    assert_eq!(files["o/hw2"], (b"my program".to_vec(), true));
    assert!(!files.contains_key("o/editor"));
    let readme = String::from_utf8(files["o/README.txt"].0.clone()).unwrap();
    assert!(readme.contains("- hw2: the program"), "{readme}");
}

#[test]
fn our_own_project_is_in_the_archive_byte_for_byte() {
    let folder = project();
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    let line = "submit --executable program --scene two.scene --answers answers.md -o o.zip";
    let arguments: Vec<&str> = line.split(' ').collect();
    let place = ["--project", project.to_str().unwrap()];
    let ran = editor_in(folder.path(), &[&arguments[..], &place].concat());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let files = unpacked(&folder.path().join("o.zip"));
    let mut open: Vec<_> = [
        "src",
        "shaders",
        "assets",
        "tests",
        "scripts",
        "make_assets",
        "make_web",
        ".ci",
    ]
    .map(|name| project.join(name))
    .to_vec();
    let names = [
        "Cargo.toml",
        "Cargo.lock",
        "Makefile",
        "clippy.toml",
        "LICENSE",
    ];
    open.extend(names.map(|name| project.join(name)));
    let mut found = 0;
    while let Some(path) = open.pop() {
        if path.is_dir() {
            open.extend(
                fs::read_dir(path)
                    .unwrap()
                    .map(|entry| entry.unwrap().path()),
            );
            continue;
        }
        let inside = path.strip_prefix(project).unwrap().to_str().unwrap();
        let packed = files.get(&format!("o/{}", inside.replace('\\', "/")));
        let bytes = fs::read(&path).unwrap();
        assert!(
            packed.is_some_and(|(packed, _)| *packed == bytes),
            "{inside}"
        );
        found += 1;
    }
    assert!(found > 400, "{found}");
    assert!(files["o/scripts/packages.sh"].1, "scripts stay executable");
    let outside = |name: &&String| {
        name.contains("/._") || name.contains("/.git/") || name.contains("o/target/")
    };
    assert_eq!(files.keys().find(outside), None);
}

#[test]
fn fewer_than_two_posed_characters_in_the_picture_are_refused_with_the_reason() {
    let folder = project();
    let write = |text: &str| fs::write(folder.path().join("bad.scene"), text).unwrap();
    let before = files_in(folder.path()).len() + 1;
    let hidden = scene(&[30.0, 30.0]).replacen("\"source\"", "\"visible\": false, \"source\"", 1);
    let far = scene(&[30.0, 30.0]).replace("[1, -1, 0]", "[500, -1, 0]");
    for (text, found) in [
        (scene(&[]), "none, and no other character"),
        (scene(&[30.0]), "1, and no other character"),
        (scene(&[30.0, 0.0]), "1: “Man 1” is not posed"),
        (
            scene(&[0.0, 0.0]),
            "none: “Man 0” is not posed, “Man 1” is not posed",
        ),
        (hidden, "1: “Man 0” is hidden"),
        (far, "1: “Man 1” is outside the picture"),
    ] {
        write(&text);
        let ran = submit(&folder, "--scene bad.scene --answers answers.md -o out.zip");
        assert_eq!((ran.code, &*ran.out), (Some(1), ""), "{text}");
        let expected = format!(
            "error: bad.scene: expected two posed characters in the picture, found {found}\n"
        );
        assert!(ran.err.ends_with(&expected), "{} {expected}", ran.err);
        assert_eq!(files_in(folder.path()).len(), before);
    }
}

#[test]
fn a_picture_is_taken_as_it_is_unless_it_shows_nothing() {
    let folder = project();
    let ran = editor_in(folder.path(), &["render", "two.scene", "-o", "two.jpg"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let ran = submit(&folder, "--picture two.jpg --answers answers.md -o out.zip");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let note = "note: two.jpg is handed in as it is. Check that it shows two posed characters; ";
    assert!(ran.err.contains(note), "{}", ran.err);
    let files = unpacked(&folder.path().join("out.zip"));
    let picture = fs::read(folder.path().join("two.jpg")).unwrap();
    assert!(files["out/picture.jpg"].0 == picture);
    assert!(!files.keys().any(|name| name.contains("data")));

    image::RgbImage::new(8, 8)
        .save(folder.path().join("black.png"))
        .unwrap();
    fs::write(folder.path().join("text.png"), "no picture").unwrap();
    for (name, code, error) in [
        ("black.png", 1, "found a single color"),
        ("text.png", 1, "text.png: "),
        ("none.png", 1, "none.png: there is no such file"),
        ("man.obj", 2, "man.obj"),
    ] {
        let line = format!("--picture {name} --answers answers.md -o no.zip");
        let ran = submit(&folder, &line);
        assert_eq!((ran.code, &*ran.out), (Some(code), ""), "{name}");
        assert!(ran.err.contains(error), "{}", ran.err);
    }
    assert!(!folder.path().join("no.zip").exists());
}

#[test]
fn without_a_terminal_what_is_not_answered_is_one_clear_error() {
    let folder = project();
    let errors = |line: &str| {
        let ran = submit(&folder, line);
        assert_eq!((ran.code, &*ran.out), (Some(1), ""), "{line}");
        let errors: Vec<&str> = ran
            .err
            .lines()
            .filter(|line| line.starts_with("error"))
            .collect();
        errors.join("\n")
    };
    assert_eq!(
        errors("--scene two.scene --name Ada -o out.zip"),
        "error: there is no answer for: Compiling, Collaboration, References, Problems, Extra \
         credit; write the answers into a form (editor submit --form > answers.md) and name it \
         with --answers, or start the command on a terminal"
    );
    let some = ANSWERS.replace("none\n", "");
    fs::write(folder.path().join("some.md"), some).unwrap();
    assert_eq!(
        errors("--scene two.scene --answers some.md -o out.zip"),
        "error: some.md: expected an answer below each heading, found none below: \
         References: Which references (books, papers, websites, models by others) helped you? \
         Problems: Which problems does your code have, what causes them, and how would you fix them?"
    );
    fs::write(folder.path().join("twice.md"), "## Name\nA\n## Name\nB\n").unwrap();
    assert_eq!(
        errors("--scene two.scene --answers twice.md -o out.zip"),
        "error: twice.md:3:4: expected one answer to “Name”, found a second"
    );
    assert!(!folder.path().join("out.zip").exists());
}

#[test]
fn the_form_is_answered_or_the_readme_of_the_project_and_the_name_makes_that_of_the_archive() {
    let folder = project();
    let form = editor_in(folder.path(), &["submit", "--form"]);
    assert_eq!((form.code, &*form.err), (Some(0), ""));
    // Under each heading, a line of its own.
    let lines = form.out.lines().map(|line| match line.starts_with("## ") {
        true => format!("{line}\nanswered\n"),
        false => format!("{line}\n"),
    });
    let answered: String = lines.collect();
    assert_eq!(answered.matches("answered").count(), 6, "{answered}");
    fs::write(folder.path().join("p/README.txt"), answered).unwrap();
    let line = [
        "submit",
        "--project",
        "p",
        "--executable",
        "program",
        "--scene",
        "two.scene",
    ];
    let ran = editor_in(
        folder.path(),
        &[&line[..], &["--name", "Ada Lovelace"]].concat(),
    );
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let files = unpacked(&folder.path().join("submission-Ada-Lovelace.zip"));
    let readme = &files["submission-Ada-Lovelace/README.txt"].0;
    let readme = String::from_utf8(readme.clone()).unwrap();
    assert_eq!(readme.matches("answered").count(), 5, "{readme}");
    assert!(readme.contains("\n\nAda Lovelace\n"), "{readme}");
}

#[test]
fn wrong_usage_and_folders_that_are_no_project_leave_no_archive() {
    let folder = project();
    for (line, code, error) in [
        ("--answers answers.md -o out.zip", 2, "--scene"),
        (
            "--scene two.scene --picture a.png -o out.zip",
            2,
            "--picture",
        ),
        (
            "--scene two.scene --answers answers.md -o out.rar",
            2,
            ".tar.gz",
        ),
        (
            "--scene two.scene --answers answers.md -o none/out.zip",
            1,
            "there is no folder none",
        ),
        (
            "--scene two.scene --answers answers.md --executable none -o out.zip",
            2,
            "--executable",
        ),
    ] {
        let ran = submit(&folder, line);
        assert_eq!((ran.code, &*ran.out), (Some(code), ""), "{line}");
        assert!(ran.err.contains(error), "{}", ran.err);
    }
    let line = "submit --scene two.scene --answers answers.md -o out.zip";
    let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert_eq!(ran.code, Some(1));
    let error = "error: .: expected the folder of the project, found no Cargo.toml in it";
    assert!(ran.err.starts_with(error), "{}", ran.err);
    // That comes first: whatever the picture is, there is nothing to put it into.
    let picture = fs::read(folder.path().join("p/assets/a.zip")).unwrap();
    fs::write(folder.path().join("two.png"), picture).unwrap();
    let line = "submit --picture two.png --answers answers.md -o out.zip";
    let ran = editor_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert!(ran.err.starts_with(error), "{}", ran.err);
    assert_eq!(ran.err.lines().count(), 1);
    assert!(!folder.path().join("out.zip").exists());
    // What is read is not written over.
    fs::rename(
        folder.path().join("program"),
        folder.path().join("program.zip"),
    )
    .unwrap();
    let line = "submit --project p --executable program.zip --scene two.scene --answers answers.md \
        -o program.zip";
    let ran = editor_in(folder.path(), &line.split_whitespace().collect::<Vec<_>>());
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    let kept = fs::read(folder.path().join("program.zip")).unwrap();
    assert_eq!(kept, b"the program");
}

#[test]
fn a_source_that_is_newer_than_the_program_is_said() {
    let folder = project();
    let set = |name: &str, seconds: u64| {
        let file = fs::File::options()
            .append(true)
            .open(folder.path().join(name))
            .unwrap();
        let time = std::time::UNIX_EPOCH + std::time::Duration::from_secs(seconds);
        file.set_modified(time).unwrap();
    };
    for name in ["p/src/target/mod.rs", "p/shaders/a.glsl", "p/assets/a.zip"] {
        set(name, 1000);
    }
    set("p/src/main.rs", 2000);
    // It is not built into the program.
    set("p/README.md", 5000);
    let warned = |built: u64| {
        set("program", built);
        let ran = submit(&folder, "--scene two.scene --answers answers.md -o out.zip");
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        ran.err
            .contains("main.rs is newer than the program program")
    };
    assert!(warned(1500));
    assert!(!warned(3000));

    // Who unpacks it over an older one builds what is new in it.
    let line = "--scene two.scene --answers answers.md -o out.tar.gz";
    assert_eq!(submit(&folder, line).code, Some(0));
    let out = fs::File::open(folder.path().join("out.tar.gz")).unwrap();
    let mut tar = tar::Archive::new(flate2::read::GzDecoder::new(out));
    let times = tar.entries().unwrap().map(|entry| {
        let entry = entry.unwrap();
        let path = entry.path().unwrap().to_str().unwrap().to_owned();
        (path, entry.header().mtime().unwrap())
    });
    let times: BTreeMap<String, u64> = times.collect();
    assert_eq!(times["out/src/main.rs"], 2000);
    assert_eq!(times["out/assets/a.zip"], 1000);
}
