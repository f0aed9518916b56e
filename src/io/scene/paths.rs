//! Paths of the files that a scene names, relative to the folder of the scene.

use crate::io::builtin;
use std::path::{Component, Path, PathBuf};

/// The name of `file` in a scene that lies in `folder`: the way from there, with forward slashes,
/// where there is one; `file` as it is otherwise, and if it is built in.
pub(super) fn name(file: &str, folder: Option<&Path>) -> String {
    let is_builtin = file.starts_with(builtin::PREFIX);
    // Else a folder whose name is no Unicode would share no beginning with its files, whose names are kept
    // as Unicode.
    let folder = folder.filter(|_| !is_builtin).map(Path::to_string_lossy);
    folder
        .and_then(|folder| way(Path::new(&*folder), Path::new(file)))
        .unwrap_or_else(|| file.to_owned())
}

/// The file that a scene in `folder` calls `name`. `..` is taken back from the words of the path and
/// not from the folders that links lead to, as [`name`] adds it.
pub(super) fn file(name: &str, folder: &Path) -> PathBuf {
    if name.starts_with(builtin::PREFIX) {
        PathBuf::from(name)
    } else {
        normal(&folder.join(name))
    }
}

/// `path` without `.`, and without `..` after a folder.
pub fn normal(path: &Path) -> PathBuf {
    let mut parts: Vec<Component> = Vec::new();
    for part in path.components() {
        match (part, parts.last()) {
            (Component::CurDir, _) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => drop(parts.pop()),
            (Component::ParentDir, Some(Component::RootDir)) => {}
            _ => parts.push(part),
        }
    }
    parts.iter().collect()
}

/// The way from `folder` to `file`, with forward slashes; `None` if there is none by the words of the
/// paths alone, as between drives, or from a folder that is relative to an absolute file.
fn way(folder: &Path, file: &Path) -> Option<String> {
    let (folder, file) = (normal(folder), normal(file));
    let (mut from, mut to) = (folder.components().peekable(), file.components().peekable());
    let mut shares_any = false;
    while let (Some(one), Some(other)) = (from.peek(), to.peek()) {
        if one != other {
            break;
        }
        shares_any = true;
        from.next();
        to.next();
    }
    let is_absolute = folder.is_absolute() || file.is_absolute();
    if is_absolute && !shares_any {
        return None;
    }
    let up = from.map(|part| matches!(part, Component::Normal(_)).then_some(".."));
    let down = to.map(|part| match part {
        Component::Normal(name) => name.to_str(),
        Component::ParentDir => Some(".."),
        _ => None,
    });
    let parts: Option<Vec<&str>> = up.chain(down).collect();
    Some(parts?.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn way_and_back(folder: &str, file: &str) -> String {
        let way = name(file, Some(Path::new(folder)));
        let back = super::file(&way, Path::new(folder));
        assert_eq!(back, Path::new(file), "{folder} {way}");
        way
    }

    #[test]
    fn a_file_is_named_by_the_way_from_the_scene_to_it() {
        for (folder, file, way) in [
            ("/home/ada", "/home/ada/man.obj", "man.obj"),
            (
                "/home/ada/scenes",
                "/home/ada/rigs/man.obj",
                "../rigs/man.obj",
            ),
            ("/home/ada", "/usr/man.obj", "../../usr/man.obj"),
            ("/", "/man.obj", "man.obj"),
            ("", "man.obj", "man.obj"),
            ("", "../man.obj", "../man.obj"),
            ("a/b", "c.obj", "../../c.obj"),
            ("../a", "../b/c.obj", "../b/c.obj"),
            ("a", "builtin:adult", "builtin:adult"),
            ("a", "/man.obj", "/man.obj"),
        ] {
            assert_eq!(way_and_back(folder, file), way, "{folder} {file}");
        }
        assert_eq!(name("/a/b.obj", None), "/a/b.obj");
    }

    #[test]
    fn dots_are_taken_out_of_a_path() {
        for (path, normal) in [
            ("/a/../../b/./c", "/b/c"),
            ("a/../../b", "../b"),
            ("./a", "a"),
        ] {
            assert_eq!(super::normal(Path::new(path)), Path::new(normal), "{path}");
        }
    }
}
