//! Files that are not where they belong, and those that may be meant.

use std::path::{Path, PathBuf};

/// Folders within each other in which a file is sought that is not where it belongs.
const DEEPEST: usize = 3;

/// That there is no file called `name` in `folder`, the submission's, and which one is there that may be meant: one with
/// other capitals or in a folder within, or else one whose name is like it, if it is none of the files `of_others`.
pub(super) fn missing(folder: &Path, name: &str, of_others: &[String]) -> String {
    let files = files_within(folder);
    let is_alike = |found: &&PathBuf| name_of(found) == name.to_lowercase();
    if let Some(found) = files.iter().find(is_alike) {
        let beside = found.strip_prefix(folder).unwrap_or(found);
        let why = if beside.components().count() == 1 {
            "the names differ in capitals"
        } else {
            "it belongs into the folder of the submission itself"
        };
        return format!(
            "there is no {name}, but {} is there: {why}",
            beside.display()
        );
    }
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let is_like = |found: &&PathBuf| {
        let found = name_of(found);
        let is_of_other = of_others.iter().any(|other| found == other.to_lowercase());
        found.contains(&stem.to_lowercase()) && !is_of_other
    };
    match files.iter().find(is_like) {
        Some(found) => {
            let beside = found.strip_prefix(folder).unwrap_or(found).display();
            format!("there is no {name}, but {beside} is there, whose name is like it")
        }
        None => format!("there is no {name}"),
    }
}

/// Files in `folder` and in folders within, those that lie less deep first, and otherwise by their names.
fn files_within(folder: &Path) -> Vec<PathBuf> {
    let (mut folders, mut files) = (vec![folder.to_owned()], Vec::new());
    for _ in 0..=DEEPEST {
        let entries = folders
            .iter()
            .filter_map(|folder| std::fs::read_dir(folder).ok());
        let entries = entries.flatten().flatten();
        // Links may lead to other submissions.
        let kinds = entries.filter_map(|entry| Some((entry.path(), entry.file_type().ok()?)));
        let (within, others): (Vec<_>, Vec<_>) = kinds.partition(|(_, kind)| kind.is_dir());
        let others = others.into_iter().filter(|(_, kind)| kind.is_file());
        let mut found: Vec<PathBuf> = others.map(|(path, _)| path).collect();
        found.sort();
        files.append(&mut found);
        folders = within.into_iter().map(|(path, _)| path).collect();
    }
    files
}

/// The name of a file in small letters.
fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::missing;

    #[test]
    fn of_a_missing_file_the_one_is_named_that_may_be_meant() {
        let said = |files: &[&str]| {
            let folder = tempfile::tempdir().unwrap();
            for file in files {
                let path = folder.path().join(file);
                std::fs::create_dir_all(path.parent().unwrap()).unwrap();
                std::fs::write(path, "").unwrap();
            }
            let others = ["walk-2.obj".to_owned()];
            let said = missing(folder.path(), "walk.obj", &others);
            let rest = said.strip_prefix("there is no walk.obj").unwrap();
            rest.trim_start_matches(", but ").to_owned()
        };
        for (files, expected) in [
            (&["run.obj", "walk-2.obj"][..], ""),
            (
                &["Walk.OBJ"],
                "Walk.OBJ is there: the names differ in capitals",
            ),
            (
                &["walk.png", "out/walk.obj"],
                "out/walk.obj is there: it belongs into the folder of the submission itself",
            ),
            (
                &["walk.obj.txt"],
                "walk.obj.txt is there, whose name is like it",
            ),
            (
                &["my Walk (1).obj"],
                "my Walk (1).obj is there, whose name is like it",
            ),
            (
                &["out/walk.png"],
                "out/walk.png is there, whose name is like it",
            ),
        ] {
            assert_eq!(said(files), expected, "{files:?}");
        }
    }
}
