//! Scenes together with their files, in folders and archives.

use super::support::{MAN, SCENE, Table, files, read};
use editor_core::io::builtin::WithBuiltin;
use editor_core::io::{Files, Loaded, Missing, WithArchives, package, scene_text, to_zip};
use editor_core::scene::{NewShape, Scene, ShapeKind, ViewSettings};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

const VERSION_2: &str = include_str!("version_2.scene");

fn archives(entries: &[(&str, Vec<u8>)]) -> WithArchives<HashMap<PathBuf, Vec<u8>>> {
    let entry = |(path, bytes): &(&str, Vec<u8>)| (PathBuf::from(path), bytes.clone());
    WithArchives::new(entries.iter().map(entry).collect())
}

fn zip(entries: &[(&str, &str)]) -> Vec<u8> {
    let entry = |(path, text): &(&str, &str)| (PathBuf::from(path), text.as_bytes().to_vec());
    to_zip(&entries.iter().map(entry).collect::<Vec<_>>()).unwrap()
}

/// A scene with a character, a textured `.dae`, a shape with its material, curves, and a built-in
/// character.
fn everything() -> (Table, Scene, ViewSettings) {
    let mut files = files();
    for name in ["crate.dae", "crate.png"] {
        let bytes = files
            .read(Path::new(&format!("builtin:rigs/{name}")))
            .unwrap();
        files
            .0
            .insert(PathBuf::from("/media/rigs").join(name), bytes);
    }
    let more = r#"  "shapes": [
    {"name": "Crate", "source": {"file": "../../../media/rigs/crate.dae", "importer": "character"}},
    {"name": "Adult", "source": {"file": "builtin:adult", "importer": "character"}},"#;
    let text = VERSION_2.replacen("  \"shapes\": [", more, 1);
    files.0.insert(PathBuf::from(SCENE), text.into_bytes());
    let (scene, view, _) = read(&files, SCENE, Missing::Refuse).unwrap();
    (files, scene, view)
}

#[test]
fn a_scene_saved_with_its_files_opens_from_the_archive_alone() {
    let (files, scene, view) = everything();
    let entries = package(&files, &scene, &view, "My scene").unwrap().files;
    let names: Vec<&str> = entries
        .iter()
        .map(|(path, _)| path.to_str().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "My scene.scene",
            "My scene files/ada/vase.swp",
            "My scene files/rigs/man.attach",
            "My scene files/rigs/man.obj",
            "My scene files/rigs/man.skel",
            "My scene files/scenes/box.mtl",
            "My scene files/scenes/box.obj",
            "My scene files/rigs 2/crate.dae",
            "My scene files/rigs 2/crate.png",
        ]
    );
    let zip = to_zip(&entries).unwrap();
    let alone = WithBuiltin(archives(&[("/mnt/a.ZIP", zip)]));
    let (read, read_view, warnings) = read(&alone, "/mnt/a.ZIP", Missing::Refuse).unwrap();
    assert!(
        warnings
            .iter()
            .all(|w| w.contains("expected a name of its own")),
        "{warnings:?}"
    );
    assert_eq!(read_view, view);
    // Equal but for where the files are.
    let mut moved = read.clone();
    for (shape, original) in read.shapes().iter().zip(scene.shapes()) {
        let [now, before] = [shape, original].map(|shape| shape.source.clone());
        assert_eq!(now.is_some(), before.is_some());
        if let (Some(now), Some(before)) = (now, before) {
            let is_kept = now.file == before.file && now.file.starts_with("builtin:");
            assert!(
                is_kept || now.file.starts_with("/mnt/a.ZIP/My scene files/"),
                "{}",
                now.file
            );
        }
        moved.shape_mut(shape.id).unwrap().source = original.source.clone();
    }
    super::support::assert_same(&moved, &scene, "");
    let ShapeKind::Character(crates) = &read.shapes()[0].kind else {
        panic!("{:?}", read.shapes()[0].kind);
    };
    let texture = &crates.character.bind_mesh().groups[0].material.texture;
    assert!(texture.is_some());
    // What is opened from an archive can be saved beside it.
    let text = scene_text(&read, &read_view, Some(Path::new("/mnt"))).unwrap();
    assert!(
        text.contains("\"file\": \"a.ZIP/My scene files/rigs/man.obj\""),
        "{text}"
    );
}

#[test]
fn equal_scenes_make_equal_archives() {
    let (files, scene, view) = everything();
    let zip = || to_zip(&package(&files, &scene, &view, "a").unwrap().files).unwrap();
    assert_eq!(zip(), zip());
}

#[test]
fn a_scene_whose_file_is_gone_is_not_packed() {
    let (mut files, scene, view) = everything();
    files.0.remove(Path::new(MAN));
    let error = package(&files, &scene, &view, "a").unwrap_err();
    assert_eq!(
        error.to_string(),
        "/home/ada/rigs/man.obj: there is no such file"
    );
}

#[test]
fn a_file_in_an_archive_is_read_and_what_is_not_there_is_told() {
    let files = archives(&[("d/a.zip", zip(&[("x/y.obj", "v 1 2 3\n")]))]);
    assert_eq!(
        files.read(Path::new("d/a.zip/x/y.obj")).unwrap(),
        b"v 1 2 3\n"
    );
    assert!(files.exists(Path::new("d/a.zip/x/y.obj")));
    assert!(files.exists(Path::new("d/a.zip")));
    assert!(!files.exists(Path::new("d/a.zip/x")) && !files.exists(Path::new("d/b.zip/x")));
    let error = files.read(Path::new("d/a.zip/x/z.obj")).unwrap_err();
    assert_eq!(error.to_string(), "d/a.zip/x/z.obj: there is no such file");
}

#[test]
fn an_archive_with_nothing_to_open_or_two_scenes_is_refused() {
    let scene = r#"{"format": "editor-scene", "version": 2}"#;
    let neither = "a.zip: expected a .scene or a model (.obj, .swp, .dae) in it, found neither";
    let two = "a.zip: expected one .scene in it, found 2";
    for (entries, message) in [
        (vec![("a.png", ""), ("__MACOSX/._a.scene", "")], neither),
        (vec![("a.scene", scene), ("b.scene", scene)], two),
    ] {
        let files = archives(&[("a.zip", zip(&entries))]);
        let error = read(&files, "a.zip", Missing::Refuse).unwrap_err();
        assert_eq!(error, message);
    }
    let entries = [("d/a.scene", scene), ("__MACOSX/d/._a.scene", "x")];
    let files = archives(&[("a.zip", zip(&entries))]);
    assert!(read(&files, "a.zip", Missing::Refuse).is_ok());
}

#[test]
fn an_archive_without_a_scene_opens_as_all_models_in_it() {
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let entries = [
        ("rigs/man.skel", "0 0 0 -1\n0 1 0 0\n"),
        ("rigs/man.obj", triangle),
        ("rigs/man.attach", "1\n1\n1\n"),
        ("flag.obj", triangle),
        ("__MACOSX/._flag.obj", "x"),
        ("readme.txt", "x"),
    ];
    let files = archives(&[("d/a.zip", zip(&entries))]);
    let mut loaded = Loaded::default();
    loaded.add(&files, Path::new("d/a.zip")).unwrap();
    let source = |shape: &NewShape| shape.source.as_ref().unwrap().file.clone();
    let found: Vec<(&str, String)> = loaded
        .shapes
        .iter()
        .map(|shape| (&*shape.name, source(shape)))
        .collect();
    let flag = ("Flag", "d/a.zip/flag.obj".to_owned());
    let man = ("Man", "d/a.zip/rigs/man.obj".to_owned());
    assert_eq!(found, [flag, man]);
    let [ShapeKind::Mesh(_), ShapeKind::Character(_)] =
        [&loaded.shapes[0].kind, &loaded.shapes[1].kind]
    else {
        panic!("a shape and a character");
    };
    assert!(loaded.view.is_none());
}

#[test]
fn names_that_lead_out_of_the_archive_are_refused() {
    for name in [
        "../a.scene",
        "b/../../a.scene",
        "/a.scene",
        "c:/a.scene",
        "..\\a.scene",
    ] {
        // The writer cleans names: the bytes are changed afterwards, in both places.
        let plain = "x".repeat(name.len());
        let bytes = zip(&[(&plain, "{}")]);
        let [plain, name_bytes] = [plain.as_bytes(), name.as_bytes()];
        let mut changed = bytes.clone();
        for at in 0..bytes.len() - plain.len() {
            if &bytes[at..at + plain.len()] == plain {
                changed[at..at + plain.len()].copy_from_slice(name_bytes);
            }
        }
        let files = archives(&[("a.zip", changed)]);
        let error = files
            .read(Path::new("a.zip/a.scene"))
            .unwrap_err()
            .to_string();
        let expected = "a.zip: expected names of files inside the archive, found ";
        assert!(error.starts_with(expected), "{name}: {error}");
    }
}

/// An archive of one file `a.obj` that is said to be of `size` bytes, unpacked.
fn zip_that_claims(size: u32, text: &str) -> Vec<u8> {
    let mut bytes = zip(&[("a.obj", text)]);
    // The sizes are in the list of files, 24 bytes after the mark of an entry.
    let mark = b"PK\x01\x02";
    let at = bytes.windows(4).position(|four| four == mark).unwrap() + 24;
    bytes[at..at + 4].copy_from_slice(&size.to_le_bytes());
    bytes
}

#[test]
fn an_archive_that_unpacks_to_more_than_fits_is_refused_before_it_is_unpacked() {
    let files = archives(&[("a.zip", zip_that_claims(1200 << 20, "v"))]);
    let error = files.read(Path::new("a.zip/a.obj")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.zip: expected files of at most 1024 MiB in it, unpacked, found 1200"
    );
}

#[test]
fn a_file_of_another_size_than_the_archive_says_is_refused() {
    let text = "v 0 0 0\n".repeat(100_000);
    for claimed in [0, 10, 799_999, 800_001] {
        let files = archives(&[("a.zip", zip_that_claims(claimed, &text))]);
        let error = files.read(Path::new("a.zip/a.obj")).unwrap_err();
        assert_eq!(
            error.to_string(),
            "a.zip/a.obj: expected a whole file in the archive, found a damaged one"
        );
    }
    let files = archives(&[("a.zip", zip_that_claims(800_000, &text))]);
    assert_eq!(
        files.read(Path::new("a.zip/a.obj")).unwrap(),
        text.as_bytes()
    );
}

#[test]
fn a_damaged_archive_gives_an_error_and_no_panic() {
    let whole = zip(&[("a.scene", "{}"), ("b.obj", "v 0 0 0\n")]);
    for length in 0..whole.len() {
        let files = archives(&[("a.zip", whole[..length].to_vec())]);
        let error = files
            .read(Path::new("a.zip/a.scene"))
            .unwrap_err()
            .to_string();
        assert!(error.contains("expected"), "{error}");
    }
    for at in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x55;
        let files = archives(&[("a.zip", bytes)]);
        let _ = files.read(Path::new("a.zip/a.scene"));
        let _ = files.exists(Path::new("a.zip/b.obj"));
    }
}
