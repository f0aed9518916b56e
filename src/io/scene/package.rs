//! A scene together with the files that its shapes came from, to be opened on another machine.

use super::{paths, text::scene_text_with};
use crate::io::file_access::with_slashes;
use crate::io::file_importer::import_with;
use crate::io::recorder::Recorder;
use crate::io::{Diagnostic, Files, builtin};
use crate::scene::{Importer, Scene, ShapeKind, Source, ViewSettings};
use std::collections::{BTreeMap, HashSet};
use std::path::{Component, Path, PathBuf};

/// The scene as `NAME.scene`, and below `NAME files/` all files that its shapes came from, those of
/// one folder as they lie there relative to each other. Paths are relative, and the scene comes
/// first. Where a file of curves is not there, only the note of where they came from is left out,
/// since the curves are in the scene.
///
/// # Errors
/// If another file is missing or cannot be read, or the scene cannot be written (see
/// [`scene_text`](super::scene_text)).
pub fn package(
    files: &dyn Files,
    scene: &Scene,
    view: &ViewSettings,
    name: &str,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Diagnostic> {
    let folders = folders(files, scene)?;
    let root = PathBuf::from(format!("{name} files"));
    let mut places = places(&folders, &root);
    let named = |source: &Source| {
        if source.file.starts_with(builtin::PREFIX) {
            return Some(source.file.clone());
        }
        let place = places.get(&paths::normal(Path::new(&source.file)))?;
        Some(with_slashes(place))
    };
    let scene_name = PathBuf::from(format!("{name}.scene"));
    let text = scene_text_with(scene, view, &named);
    let text = text.map_err(|error| Diagnostic::new(&scene_name, error.to_string()))?;
    let mut entries = vec![(scene_name, text.into_bytes())];
    for (file, path) in folders.values().flatten() {
        if let Some(place) = places.remove(file) {
            entries.push((place, files.read(path)?));
        }
    }
    Ok(entries)
}

/// The files that the scene needs, by the folders of those that its shapes name: the path without
/// `..`, and the one by which it was read.
type Folders = BTreeMap<PathBuf, BTreeMap<PathBuf, PathBuf>>;

fn folders(files: &dyn Files, scene: &Scene) -> Result<Folders, Diagnostic> {
    let mut folders = Folders::new();
    let mut seen: HashSet<(&str, Importer)> = HashSet::new();
    for shape in scene.shapes() {
        let Some(source) = &shape.source else {
            continue;
        };
        let is_builtin = source.file.starts_with(builtin::PREFIX);
        if is_builtin || !seen.insert((&source.file, source.importer)) {
            continue;
        }
        let recorder = Recorder::new(files);
        let path = Path::new(&source.file);
        let imported = import_with(&recorder, path, source.importer);
        if let Err(error) = imported {
            if matches!(shape.kind, ShapeKind::Curve(_)) {
                continue;
            }
            return Err(error);
        }
        let folder = paths::normal(path.parent().unwrap_or(Path::new("")));
        let read = recorder.into_paths().into_iter();
        let read = read.map(|path| (paths::normal(&path), path));
        folders.entry(folder).or_default().extend(read);
    }
    Ok(folders)
}

/// Where each file comes to lie: its folder below `root`, by the name of the folder and a number
/// where another has that name.
fn places(folders: &Folders, root: &Path) -> BTreeMap<PathBuf, PathBuf> {
    let mut places = BTreeMap::new();
    // Some systems take names for the same that differ in upper and lower case.
    let mut taken: HashSet<String> = HashSet::new();
    for (folder, files) in folders {
        let base = common_folder(folder, files);
        let name = base.file_name().map(|name| name.to_string_lossy());
        let name = name.unwrap_or("files".into());
        let numbered = (2..).map(|number| format!("{name} {number}"));
        let mut names = std::iter::once(name.to_string()).chain(numbered);
        let free = names.find(|name| taken.insert(name.to_lowercase()));
        let folder = root.join(free.unwrap_or_default());
        for file in files.keys() {
            let inner = file.strip_prefix(&base).unwrap_or(file).components();
            let inner = inner.filter(|part| matches!(part, Component::Normal(_)));
            let place = folder.join(inner.collect::<PathBuf>());
            places.entry(file.clone()).or_insert(place);
        }
    }
    places
}

/// The innermost folder that contains `folder` and all `files`.
fn common_folder(folder: &Path, files: &BTreeMap<PathBuf, PathBuf>) -> PathBuf {
    let contains_all = |base: &&Path| files.keys().all(|file| file.starts_with(base));
    let found = folder.ancestors().find(contains_all);
    found.unwrap_or(Path::new("")).to_owned()
}
