//! Files that are looked for with others, one after the other as they come.

use super::support::{BOX, MAN, SCENE, Table, files};
use editor_core::io::builtin::WithBuiltin;
use editor_core::io::missed_files;
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};

const VERSION_2: &str = include_str!("version_2.scene");

/// All that is looked for until nothing more is, when `opened` is fetched from `site` and opened.
fn fetched(site: &Table, opened: &str) -> BTreeSet<PathBuf> {
    let mut here: HashMap<PathBuf, Vec<u8>> = HashMap::new();
    let mut looked_for = BTreeSet::new();
    let mut missed = vec![PathBuf::from(opened)];
    while !missed.is_empty() {
        for path in missed {
            if let Some(bytes) = site.0.get(&path) {
                here.insert(path.clone(), bytes.clone());
            }
            assert!(looked_for.insert(path.clone()), "{path:?} twice");
        }
        missed = missed_files(&here, &[PathBuf::from(opened)]);
        missed.retain(|path| !looked_for.contains(path));
    }
    here.into_keys().collect()
}

fn paths(names: &[&str]) -> BTreeSet<PathBuf> {
    names.iter().map(PathBuf::from).collect()
}

#[test]
fn a_scene_brings_its_models_and_what_these_name() {
    let mut site = files();
    site.0.insert(PathBuf::from(SCENE), VERSION_2.into());
    let all = [
        SCENE,
        MAN,
        "/home/ada/rigs/man.skel",
        "/home/ada/rigs/man.attach",
        BOX,
        "/home/ada/scenes/box.mtl",
    ];
    assert_eq!(fetched(&site, SCENE), paths(&all));
}

#[test]
fn a_shape_brings_its_materials_and_their_pictures() {
    let mut site = files();
    let mtl = "newmtl m\nmap_Kd skins/wood.png\n";
    site.0.insert("/home/ada/scenes/box.mtl".into(), mtl.into());
    let picture = "/home/ada/scenes/skins/wood.png";
    site.0.insert(picture.into(), b"no picture".to_vec());
    let all = [BOX, "/home/ada/scenes/box.mtl", picture];
    assert_eq!(fetched(&site, BOX), paths(&all));
}

/// What is missed of the scene alone, with the man from elsewhere.
fn missed_with_man_from(place: &str) -> Vec<PathBuf> {
    let scene = VERSION_2.replace("../rigs/man.obj", place);
    let here = HashMap::from([(PathBuf::from(SCENE), scene.into())]);
    missed_files(&here, &[SCENE.into()])
}

#[test]
fn a_model_in_an_archive_comes_with_the_archive() {
    let missed = missed_with_man_from("all.zip/man.obj");
    let archive = Path::new("/home/ada/scenes/all.zip");
    assert!(missed.iter().any(|path| path == archive), "{missed:?}");
    assert!(missed.iter().all(|path| !path.ends_with("man.obj")));
}

#[test]
fn built_in_files_and_those_that_are_there_are_not_missed() {
    let missed = missed_with_man_from("builtin:robot");
    let is_builtin = |path: &PathBuf| path.to_string_lossy().contains("robot");
    assert!(!missed.is_empty() && !missed.iter().any(is_builtin));
    let WithBuiltin(here) = files();
    assert!(missed_files(&here, &[MAN.into()]).is_empty());
}

#[test]
fn the_geometry_of_a_shape_is_not_read_to_find_what_it_names() {
    let obj = "f 7 8 9\nv one two\n  mtllib first.mtl\nusemtl a\nf x\nmtllib second.mtl\n";
    let mut here = HashMap::from([(PathBuf::from("a.obj"), obj.as_bytes().to_vec())]);
    let missed = |here: &HashMap<PathBuf, Vec<u8>>| missed_files(here, &["a.obj".into()]);
    let materials = ["a.skel", "a.attach", "first.mtl", "second.mtl"];
    assert_eq!(BTreeSet::from_iter(missed(&here)), paths(&materials));
    here.insert("first.mtl".into(), b"newmtl a\nmap_Kd wood.png\n".to_vec());
    assert!(
        missed(&here).contains(&"wood.png".into()),
        "{:?}",
        missed(&here)
    );
}
