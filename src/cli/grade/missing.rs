//! Files that are not where they belong, and those that may be meant.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Folders within each other in which a file is sought that is not where it belongs.
const DEEPEST: usize = 3;

/// That there is no file called `name` in `folder`, the submission's, and which one is there that may be meant: one with
/// other capitals or in a folder within, or else one whose name is like it, if it is none of the files `of_others`.
pub(super) fn missing(folder: &Path, name: &str, of_others: &[String]) -> String {
    let files = files_within(folder);
    let is_alike = |found: &&PathBuf| name_of(found) == name.to_lowercase();
    if let Some(found) = files.iter().find(is_alike) {
        let why = if found.parent() == Some(folder) {
            "the names differ in capitals"
        } else {
            "it belongs into the folder of the submission itself"
        };
        let found = within(folder, found);
        return format!("there is no {name}, but {found} is there: {why}");
    }
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let is_like = |found: &&PathBuf| {
        let found = name_of(found);
        let is_of_other = of_others.iter().any(|other| found == other.to_lowercase());
        joined(&found).contains(&joined(&stem.to_lowercase())) && !is_of_other
    };
    if let Some(found) = files.iter().find(is_like) {
        let found = within(folder, found);
        return format!("there is no {name}, but {found} is there, whose name is like it");
    }
    match files.iter().find(|found| is_archive(found)) {
        Some(found) => {
            let found = within(folder, found);
            format!("there is no {name}, but {found} is there: it has to be unpacked")
        }
        None => format!("there is no {name}"),
    }
}

/// A file in `folder` as it is named from there.
fn within(folder: &Path, file: &Path) -> impl std::fmt::Display {
    file.strip_prefix(folder).unwrap_or(file).display()
}

/// Whether a file is called like an archive.
fn is_archive(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    let known = ["zip", "gz", "tgz", "xz", "bz2", "tar", "7z", "rar"];
    known.iter().any(|known| extension == *known)
}

/// Files with the time at which each was written last.
pub(super) type Times = BTreeMap<PathBuf, Option<SystemTime>>;

/// When the files in `folder` were written.
pub(super) fn times(folder: &Path) -> Times {
    let files = files_within(folder).into_iter();
    let with_time = files.map(|file| {
        let written = file.metadata().and_then(|metadata| metadata.modified());
        (file, written.ok())
    });
    with_time.collect()
}

/// That a command, which began with `before` in the `folder` of a submission, has not written the file called `name` in
/// the folder `output`; and which one of its kind it has written in one of the two.
pub(super) fn unwritten(name: &str, folder: &Path, before: &Times, output: &Path) -> String {
    let is_of_kind = |file: &Path| file.extension() == Path::new(name).extension();
    let now = times(folder).into_iter();
    let here = now.filter(|(file, written)| before.get(file) != Some(written));
    let here = here.map(|(file, _)| file).find(|file| is_of_kind(file));
    let nothing = "the command ended without writing its file";
    if let Some(file) = here {
        let found = within(folder, &file);
        return format!(
            "{nothing}: it wrote {found} in the submission's folder instead of what {{output}} names"
        );
    }
    let mut there = files_within(output).into_iter();
    match there.find(|file| is_of_kind(file)) {
        Some(file) => {
            let found = within(output, &file);
            format!("{nothing}: it wrote {found} in the folder of {{output}}, not {name}")
        }
        None => nothing.to_owned(),
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

/// A name without what joins its words.
fn joined(name: &str) -> String {
    name.replace(['-', '_', ' '], "")
}

/// The name of a file in small letters.
fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::{missing, times, unwritten};

    #[test]
    fn a_command_that_writes_under_another_name_is_told_which() {
        let (folder, output) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let write = |file: &std::path::Path| std::fs::write(file, "").unwrap();
        write(&folder.path().join("old.obj"));
        let before = times(folder.path());
        let said = || unwritten("walk.obj", folder.path(), &before, output.path());
        let plain = "the command ended without writing its file";
        write(&folder.path().join("log.txt"));
        assert_eq!(said(), plain);
        write(&output.path().join("Walk.obj.obj"));
        assert_eq!(
            said(),
            format!("{plain}: it wrote Walk.obj.obj in the folder of {{output}}, not walk.obj")
        );
        write(&folder.path().join("out.obj"));
        let expected = "it wrote out.obj in the submission's folder instead of what {output} names";
        assert_eq!(said(), format!("{plain}: {expected}"));
    }

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
                &["w-a_lk.obj"],
                "w-a_lk.obj is there, whose name is like it",
            ),
            (
                &["src/hw2.tar.gz", "main.cpp"],
                "src/hw2.tar.gz is there: it has to be unpacked",
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
