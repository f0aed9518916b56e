//! A scene together with the files that its shapes came from, to be opened on another machine.

use super::{paths, text::scene_text_with};
use crate::io::file_access::with_slashes;
use crate::io::file_importer::import_with;
use crate::io::recorder::Recorder;
use crate::io::{Diagnostic, Files};
use crate::scene::{Importer, Scene, ShapeKind, Source, ViewSettings};
use crate::steps::at_once;
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::{Component, Path, PathBuf};

/// A scene with the files that it needs.
#[derive(Clone, Debug)]
pub struct Package {
    /// Relative paths and their bytes, that of the scene first.
    pub files: Vec<(PathBuf, Vec<u8>)>,
    /// Where the files that shapes came from lie in it, by their paths without `..`.
    places: BTreeMap<PathBuf, PathBuf>,
}

impl Package {
    /// Path in the package of the file that a shape came from; `None` if it is not in it, as built-in
    /// files never are.
    pub fn place(&self, source: &Source) -> Option<&Path> {
        let file = paths::normal(Path::new(&source.file));
        self.places.get(&file).map(PathBuf::as_path)
    }
}

/// Paths, without `..`, of all files that shapes of `scenes` came from. Files that cannot be read any
/// more are left out.
pub fn needed_files<'a>(
    files: &dyn Files,
    scenes: impl Iterator<Item = &'a Scene>,
) -> BTreeSet<PathBuf> {
    let mut seen = HashSet::new();
    let mut needed = BTreeSet::new();
    let sources = scenes
        .flat_map(|scene| scene.shapes())
        .filter_map(|shape| shape.source.as_ref());
    for source in sources {
        if !source.is_builtin() && seen.insert((&source.file, source.importer)) {
            needed.extend(files_of_source(files, source));
        }
    }
    needed
}

/// All files that a shape from `source` needs, by their shortest paths.
pub fn files_of_source(files: &dyn Files, source: &Source) -> BTreeSet<PathBuf> {
    // What was read before an error is needed as well.
    let (read, _) = files_of(files, source);
    read.iter().map(|path| paths::normal(path)).collect()
}

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
) -> Result<Package, Diagnostic> {
    let folders = folders(files, scene)?;
    let root = PathBuf::from(format!("{name} files"));
    let places = places(&folders, &root);
    let named = |source: &Source| {
        if source.is_builtin() {
            return Some(source.file.clone());
        }
        let place = places.get(&paths::normal(Path::new(&source.file)))?;
        Some(with_slashes(place))
    };
    let scene_name = PathBuf::from(format!("{name}.scene"));
    let text = scene_text_with(scene, view, &named);
    let text = text.map_err(|error| Diagnostic::new(&scene_name, error.to_string()))?;
    let mut entries = vec![(scene_name, text.into_bytes())];
    let mut written = HashSet::new();
    for (file, path) in folders.values().flatten() {
        if let Some(place) = places.get(file).filter(|_| written.insert(file)) {
            entries.push((place.clone(), files.read(path)?));
        }
    }
    Ok(Package {
        files: entries,
        places,
    })
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
        if source.is_builtin() || !seen.insert((&source.file, source.importer)) {
            continue;
        }
        let (read, imported) = files_of(files, source);
        if let Err(error) = imported {
            if matches!(shape.kind, ShapeKind::Curve(_)) {
                continue;
            }
            return Err(error);
        }
        let folder = Path::new(&source.file).parent();
        let folder = paths::normal(folder.unwrap_or(Path::new("")));
        let read = read.into_iter();
        let read = read.map(|path| (paths::normal(&path), path));
        folders.entry(folder).or_default().extend(read);
    }
    Ok(folders)
}

/// The files that are read to import `source`, in the order in which they are first read, and whether
/// all of them could be.
fn files_of(files: &dyn Files, source: &Source) -> (Vec<PathBuf>, Result<(), Diagnostic>) {
    let recorder = Recorder::new(files);
    let path = Path::new(&source.file);
    let imported = at_once(|pace| {
        let recorder = &recorder;
        async move { import_with(recorder, path, source.importer, &pace).await }
    });
    (recorder.into_paths(), imported.map(drop))
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
