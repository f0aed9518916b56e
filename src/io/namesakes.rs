//! Files of the same name that came one after the other to where all files lie beside each other, as on a page,
//! which is not told from where they are.

use super::file_access;
use std::path::{Component, Path, PathBuf};

/// The folder in which files that came together lie beside each other, so that none of them takes the place of
/// another one: the common folder, which has no name, or else the first of `2`, `3` and so on that will do.
/// `is_free` says of a path and a content whether no other content is there.
pub fn folder_for(files: &[(PathBuf, Vec<u8>)], is_free: impl Fn(&Path, &[u8]) -> bool) -> PathBuf {
    let will_do = |folder: &PathBuf| {
        let mut files = files.iter();
        files.all(|(path, bytes)| is_free(&folder.join(path), bytes))
    };
    let numbered = (2_u32..).map(|number| PathBuf::from(number.to_string()));
    let mut folders = std::iter::once(PathBuf::new()).chain(numbered);
    folders.find(will_do).unwrap_or_default()
}

/// The path of a file without the folder of [`folder_for`] in which it is, if any, and that folder. A scene that names
/// a file in such a folder may come again with its files beside it.
pub fn in_common_folder(path: &Path) -> Option<(&Path, &Path)> {
    let mut parts = path.components();
    let Some(Component::Normal(first)) = parts.next() else {
        return None;
    };
    let number: u32 = first.to_str()?.parse().ok()?;
    let rest = parts.as_path();
    (number >= 2 && !rest.as_os_str().is_empty()).then_some((rest, Path::new(first)))
}

/// `path`, or else `NAME-2`, `NAME-3` and so on with its extension: the first that takes no other file's place, and
/// that is not read with files that are there as if it was one of theirs, as an `.obj` is with a `.skel` of its name.
pub fn free_name(path: PathBuf, is_there: impl Fn(&Path) -> bool) -> PathBuf {
    const TOGETHER: [&str; 4] = ["obj", "skel", "attach", "mtl"];
    let is_taken = |path: &PathBuf| {
        let extension = file_access::extension(path);
        let is_one = TOGETHER.contains(&&*extension);
        let others = TOGETHER.iter().filter(|_| is_one);
        let mut others = others.map(|other| path.with_extension(other));
        is_there(path) || others.any(|path| is_there(&path))
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    let others = (2..).map(|number| PathBuf::from(format!("{stem}-{number}.{extension}")));
    let mut names = std::iter::once(path.clone()).chain(others);
    names.find(|path| !is_taken(path)).unwrap_or(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// Puts files among `there`, as a page does; returns the folder.
    fn come(there: &mut HashMap<PathBuf, Vec<u8>>, files: &[(&str, &str)]) -> PathBuf {
        let files: Vec<(PathBuf, Vec<u8>)> = files
            .iter()
            .map(|(path, content)| (PathBuf::from(path), content.as_bytes().to_vec()))
            .collect();
        let folder = folder_for(&files, |path, bytes| {
            there.get(path).is_none_or(|other| other == bytes)
        });
        let placed = files
            .into_iter()
            .map(|(path, bytes)| (folder.join(path), bytes));
        there.extend(placed);
        folder
    }

    #[test]
    fn files_that_come_together_stay_together_and_take_no_other_s_place() {
        let mut there = HashMap::new();
        let cube = [("cube.dae", "a cube"), ("wood.jpg", "brown")];
        assert_eq!(come(&mut there, &cube), PathBuf::new());
        assert_eq!(come(&mut there, &cube), PathBuf::new(), "the same again");
        let other = [("crate.dae", "a crate"), ("wood.jpg", "red")];
        assert_eq!(come(&mut there, &other), PathBuf::from("2"));
        assert_eq!(
            come(&mut there, &other),
            PathBuf::from("2"),
            "the same again"
        );
        let third = [("wood.jpg", "black")];
        assert_eq!(come(&mut there, &third), PathBuf::from("3"));
        let content = |path: &str| there[Path::new(path)].clone();
        assert_eq!(content("wood.jpg"), b"brown");
        assert_eq!(content("2/crate.dae"), b"a crate");
        assert_eq!(content("2/wood.jpg"), b"red");
    }

    #[test]
    fn a_path_in_such_a_folder_has_one_outside_of_it() {
        let found = |path: &'static str| in_common_folder(Path::new(path));
        let both = |path, folder| Some((Path::new(path), Path::new(folder)));
        assert_eq!(found("2/wood.jpg"), both("wood.jpg", "2"));
        assert_eq!(
            found("12/textures/wood.jpg"),
            both("textures/wood.jpg", "12")
        );
        for path in [
            "wood.jpg",
            "textures/wood.jpg",
            "1/wood.jpg",
            "2",
            "",
            "../2/wood.jpg",
        ] {
            assert_eq!(found(path), None, "{path}");
        }
    }

    #[test]
    fn an_export_takes_no_other_file_s_place_and_has_a_name_of_its_own_only_then() {
        for (name, there, free) in [
            ("robot.obj", &["robot.dae", "robot.png"][..], "robot.obj"),
            ("robot.obj", &["robot.obj"], "robot-2.obj"),
            ("robot.obj", &["robot.obj", "robot-2.obj"], "robot-3.obj"),
            // It would become a character's.
            ("robot.obj", &["robot.skel"], "robot-2.obj"),
            ("vase.swp", &["vase.obj"], "vase.swp"),
            ("vase.swp", &["vase.swp"], "vase-2.swp"),
        ] {
            let is_there = |path: &Path| there.iter().any(|there| Path::new(there) == path);
            let found = free_name(name.into(), is_there);
            assert_eq!(found, Path::new(free), "{name} beside {there:?}");
        }
    }
}
