//! The folder `assets/` and the generator agree, bit for bit.

use std::collections::BTreeSet;
use std::path::PathBuf;

/// What Blender writes by `scripts/blender_rig.py`.
const MADE_BY_BLENDER: [&str; 1] = ["rigs/lizard.dae"];

#[test]
fn every_file_is_what_the_generator_makes() {
    let files = make_assets::files();
    assert_eq!(files.len(), make_assets::PATHS.len());
    for file in files {
        let stored = std::fs::read(assets().join(file.path)).unwrap_or_default();
        let same = stored.iter().zip(&file.content).take_while(|(a, b)| a == b);
        let line = same.filter(|&(&byte, _)| byte == b'\n').count() + 1;
        assert!(
            stored == file.content,
            "{}: line {line} differs from what `cargo run --release -p make_assets` writes",
            file.path,
        );
    }
}

#[test]
fn the_folders_hold_nothing_that_the_generator_does_not_make() {
    let made = make_assets::PATHS.into_iter().chain(MADE_BY_BLENDER);
    let made: BTreeSet<&str> = made.collect();
    for folder in ["characters", "shapes", "poses", "curves", "rigs"] {
        for entry in std::fs::read_dir(assets().join(folder)).unwrap() {
            let path = format!("{folder}/{}", entry.unwrap().file_name().display());
            assert!(made.contains(path.as_str()), "{path} is of unknown origin");
        }
    }
}

fn assets() -> PathBuf {
    PathBuf::from(make_assets::ASSETS)
}
