//! The folder and the generator agree.
use crate::{bytes, catalog};
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn every_file_is_what_the_generator_makes() {
    let files = catalog::files();
    assert_eq!(files.len(), catalog::PATHS.len());
    for file in files {
        let stored = bytes(file.path);
        let same = stored.iter().zip(&file.content).take_while(|(a, b)| a == b);
        let line = same.filter(|&(&byte, _)| byte == b'\n').count() + 1;
        assert!(
            stored == file.content,
            "{}: line {line} differs from what `cargo run --release --example make_assets` writes",
            file.path,
        );
    }
}

/// What Blender writes by `scripts/blender_rig.py`.
const MADE_BY_BLENDER: [&str; 1] = ["rigs/lizard.dae"];

#[test]
fn the_folders_hold_nothing_that_the_generator_does_not_make() {
    let made = catalog::PATHS.into_iter().chain(MADE_BY_BLENDER);
    let made: BTreeSet<&str> = made.collect();
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    for folder in ["characters", "shapes", "poses", "curves", "rigs"] {
        for entry in std::fs::read_dir(assets.join(folder))
            .into_iter()
            .flatten()
            .flatten()
        {
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            assert!(made.contains(path.as_str()), "{path} is of unknown origin");
        }
    }
}
