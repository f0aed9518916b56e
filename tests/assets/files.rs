//! The folder and the generator agree.
use crate::{asset, catalog};
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn every_file_is_what_the_generator_makes() {
    let files = catalog::files();
    assert_eq!(files.len(), catalog::PATHS.len());
    for file in files {
        let stored = asset(file.path);
        let differs = stored
            .lines()
            .zip(file.text.lines())
            .position(|(a, b)| a != b);
        assert!(
            stored == file.text,
            "{}: line {} differs from what `cargo run --release --example make_assets` writes",
            file.path,
            differs.map_or(stored.lines().count().min(file.text.lines().count()), |i| i) + 1
        );
    }
}

#[test]
fn the_folders_hold_nothing_that_the_generator_does_not_make() {
    let made: BTreeSet<&str> = catalog::PATHS.iter().copied().collect();
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    for folder in ["characters", "shapes", "poses", "curves"] {
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
