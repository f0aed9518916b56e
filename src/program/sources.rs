//! The files that shapes came from: found again, read again when another program has changed them,
//! and saved together with the scene.

use super::comparison::Comparison;
use super::document::Next;
use super::document_file::Writing;
use super::exports::{Together, needed_error};
use super::files::file_name;
use super::mesh_comparison::MeshComparison;
use super::running::Program;
use super::{Host, Purpose};
use crate::editor::{Edit, Severity};
use crate::io::{self, Diagnostic, Files, Package, Reimported, builtin};
use crate::scene::{Shape, ShapeId, ShapeKind, Source};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

impl Program {
    /// Has the host watch the files of the document, if they are others than before.
    pub(super) fn watch_files(&mut self, host: &mut dyn Host) {
        let compared = self.compared_file().map(Path::to_owned);
        let of = (
            self.session.document(),
            self.document.path().map(Path::to_owned),
            compared.clone(),
        );
        if self.session.is_in_gesture() || self.watched_of.as_ref() == Some(&of) {
            return;
        }
        self.watched_of = Some(of);
        let shapes = self.session.scene().shapes().iter();
        let files = shapes.filter_map(file_on_disk).flat_map(with_companions);
        let document = self.document.path().map(Path::to_owned);
        let files: BTreeSet<PathBuf> = files.chain(document).chain(compared).collect();
        if files != self.watched {
            host.watch(files.iter().cloned().collect());
            self.watched = files;
        }
    }

    /// Says that a file of the document was changed by another program, if it was. One that something is compared with
    /// is read anew.
    pub(super) fn notice_change(&mut self, path: &Path, host: &mut dyn Host) {
        let is_there = host.files().exists(path);
        if self.compared_file() == Some(path) {
            self.compare_anew(host);
        }
        let text = if self.document.path() == Some(path) {
            if is_there && self.document.is_on_disk(&*host.files()) {
                return self.document.find();
            }
            self.document.lose();
            "File ⏵ Revert opens it as it is now"
        } else if self.changed_shapes(path, &*host.files()).is_empty() {
            return;
        } else {
            "File ⏵ Reload Models reads it again; poses and places stay"
        };
        let name = file_name(path);
        let text = if is_there {
            format!("{name} was changed by another program. {text}")
        } else {
            format!(
                "{name} is gone: another program has moved or deleted it. Shapes stay as they are"
            )
        };
        self.tell(Severity::Warning, text);
    }

    /// The file that something is compared with, while it is.
    fn compared_file(&self) -> Option<&Path> {
        let picture = self.comparison.as_ref().map(Comparison::path);
        let mesh = self.mesh_comparison.as_ref();
        picture.or_else(|| mesh.map(MeshComparison::path))
    }

    /// Reads the file that something is compared with again; whether there is one.
    fn compare_anew(&mut self, host: &mut dyn Host) -> bool {
        let Some(path) = self.compared_file().map(Path::to_owned) else {
            return false;
        };
        match self.mesh_comparison.as_ref().map(MeshComparison::shown) {
            Some((shape, _)) => self.compare_with_mesh_anew(shape, &path, &*host.files()),
            None => self.compare_with(&path, &*host.files()),
        }
        true
    }

    /// Opens the document's file as it is now, after asking about changes that are not saved.
    pub(super) fn revert(&mut self, host: &mut dyn Host) {
        match self.document.path() {
            Some(path) => {
                let next = Next::Revert(path.to_owned(), host.files());
                // Whoever has changed nothing loses nothing of their own.
                if self.document.was_saved(self.session.document()) {
                    self.go_on(next, host);
                } else {
                    self.leave_for(next, host);
                }
            }
            None => self.tell(Severity::Info, "This document has not been saved yet"),
        }
    }

    /// Reads the files of all shapes again, and replaces what has changed, as one step. Poses,
    /// places and all else stay.
    pub(super) fn reload(&mut self, host: &mut dyn Host) {
        let shapes = self.session.scene().shapes().iter();
        let ids: Vec<ShapeId> = shapes
            .filter(|shape| file_on_disk(shape).is_some())
            .map(|shape| shape.id)
            .collect();
        let since = self.session.messages.count();
        let (count, failed) = self.replace(&ids, &|_| None, &*host.files());
        if count > 0 && failed == 0 {
            // What was wrong with the files before; what still is has been told again.
            self.session.messages.dismiss_numbers(&(0..since));
        }
        let compares = self.compare_anew(host);
        match count {
            0 if failed > 0 || compares => {}
            0 => self.tell(Severity::Info, "No model has changed since it was read"),
            1 => self.tell(Severity::Info, "1 shape was read again"),
            count => self.tell(Severity::Info, format!("{count} shapes were read again")),
        }
    }

    /// Reads the models again that name the picture at `path` and were read when it was not there. Returns whether
    /// there are any.
    pub(super) fn complete_models(&mut self, path: &Path, files: &dyn Files) -> bool {
        let picture = io::normal(path);
        let shapes = self.session.scene().shapes().iter();
        let beside = shapes.filter(|shape| {
            let file = file_on_disk(shape);
            let folder = file.as_deref().and_then(Path::parent);
            folder.is_some_and(|folder| picture.starts_with(io::normal(folder)))
        });
        let beside: Vec<&Shape> = beside.collect();
        let needs = |shape: &&Shape| {
            let source = shape.source.as_ref();
            source.is_some_and(|source| io::files_of_source(files, source).contains(&picture))
        };
        let ids: Vec<ShapeId> = beside
            .into_iter()
            .filter(needs)
            .map(|shape| shape.id)
            .collect();
        let since = self.session.messages.count();
        let (count, _) = self.replace(&ids, &|_| None, files);
        if count > 0 {
            self.session.messages.dismiss_numbers(&(0..since));
            let text = format!("{} is on the model that names it", file_name(path));
            self.tell(Severity::Info, text);
        }
        count > 0
    }

    /// The first shape that is missing because a model of the name that `path` has was not there.
    pub(super) fn missing_shape_from(&self, path: &Path) -> Option<ShapeId> {
        let name = path.file_name()?;
        let mut shapes = self.session.scene().shapes().iter();
        let missing = shapes.find(|shape| {
            let source = shape.source.as_ref();
            let file = source.map(|source| Path::new(&source.file));
            matches!(shape.kind, ShapeKind::Missing(_))
                && file.and_then(Path::file_name) == Some(name)
        });
        missing.map(|shape| shape.id)
    }

    /// Puts the model at `path` in the place of the shape that is missing without it, if one still is.
    pub(super) fn complete_scene(&mut self, path: &Path, files: &dyn Files) {
        let Some(shape) = self.missing_shape_from(path) else {
            return;
        };
        if self.use_found(shape, path, files) {
            let text = format!("{} is where it was missing", file_name(path));
            self.tell(Severity::Info, text);
        }
    }

    /// Lets the file of a shape be chosen, where it is now.
    pub(super) fn find_source(&mut self, shape: ShapeId, host: &mut dyn Host) {
        self.choose_file(Purpose::FindSource(shape), "", host);
    }

    /// Reads the file of a shape from `path` from now on; and those of other shapes that are
    /// missing, too, where they lie beside it. Returns whether any could be.
    pub(super) fn use_found(&mut self, shape: ShapeId, path: &Path, files: &dyn Files) -> bool {
        let folder = path.parent().unwrap_or(Path::new(""));
        let is_now = |other: &Shape| {
            if other.id == shape {
                return Some(path.to_owned());
            }
            let name = Path::new(&other.source.as_ref()?.file).file_name()?;
            let beside = folder.join(name);
            let is_missing = matches!(other.kind, ShapeKind::Missing(_));
            (is_missing && files.exists(&beside)).then_some(beside)
        };
        let shapes = self.session.scene().shapes().iter();
        let found = shapes.filter(|shape| is_now(shape).is_some());
        let found: Vec<ShapeId> = found.map(|shape| shape.id).collect();
        self.replace(&found, &is_now, files).0 > 0
    }

    /// Writes the document and the files that it needs: an archive, or a scene with a folder beside
    /// it.
    pub(super) fn save_with_files(&mut self, path: &Path, host: &mut dyn Host) {
        if !io::is_archive(path)
            && let Err(error) = io::expect_extension(path, "scene")
        {
            return self.tell_written(path, Err(error));
        }
        if self.is_foreign(path, &*host.files()) {
            let message = "another program or window has changed it since it was opened here: choose \
                           another name";
            return self.tell_written(path, Err(Diagnostic::new(path, message)));
        }
        if io::is_archive(path) {
            return self.write_archive(path, None, host);
        }
        match self.package(path, host) {
            Ok(package) => {
                let together = self.scene_with_folder(path, package, host);
                match self.replaced_source(&together, &*host.files()) {
                    Some(needed) => self.tell_needed(path, &needed),
                    None => self.write_together(together, host),
                }
            }
            Err(error) => self.tell_written(path, Err(error)),
        }
    }

    /// Writes the document with the files that it needs as the archive at `path`, which becomes its file if
    /// it has none, and then does `then`.
    pub(super) fn write_archive(&mut self, path: &Path, then: Option<Next>, host: &mut dyn Host) {
        let packed = self.package(path, host);
        match packed.and_then(|package| self.archive(path, package, host)) {
            Ok(bytes) => {
                let is_own = self.document.path().is_none() || self.is_own(path, &*host.files());
                let saves = is_own.then(|| Writing {
                    path: path.to_owned(),
                    document: self.session.document(),
                    digest: crc32fast::hash(&bytes),
                    sources: Vec::new(),
                    then,
                });
                let together = Together {
                    saves,
                    ..Together::new(path, vec![(path.to_owned(), bytes)])
                };
                self.write_together(together, host);
            }
            Err(error) => self.tell_written(path, Err(error)),
        }
    }

    /// The document with the files that it needs, for being written to `path`.
    fn package(&self, path: &Path, host: &dyn Host) -> Result<Package, Diagnostic> {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let view = self.document_view();
        io::package(&*host.files(), self.session.scene(), &view, &stem)
    }

    /// Bytes of the archive at `path` with `package`. Files that the archive there has and that shapes come
    /// from, or those that undoing brings back, stay in it.
    fn archive(
        &self,
        path: &Path,
        package: Package,
        host: &dyn Host,
    ) -> Result<Vec<u8>, Diagnostic> {
        let there = host.files();
        let mut entries = package.files;
        let needed = io::needed_files(&*there, self.session.remembered_scenes());
        let archive = io::normal(path);
        for file in needed {
            let Ok(name) = file.strip_prefix(&archive) else {
                continue;
            };
            let bytes = there.read(&file)?;
            match entries.iter().find(|(entry, _)| entry == name) {
                None => entries.push((name.to_owned(), bytes)),
                Some((_, new)) if *new == bytes => {}
                Some(_) => return Err(needed_error(path, &file)),
            }
        }
        io::to_zip(&entries)
    }

    /// The scene at `path` with the files of `package` beside it, and what that saves of the document:
    /// all of it, if it has no file or this one.
    fn scene_with_folder(&self, path: &Path, package: Package, host: &dyn Host) -> Together {
        let folder = path.parent().unwrap_or(Path::new(""));
        let is_own = self.document.path().is_none() || self.is_own(path, &*host.files());
        let text = package.files.first().filter(|_| is_own);
        let saves = text.map(|(_, text)| {
            let shapes = self.session.scene().shapes().iter();
            let sources = shapes.filter_map(|shape| {
                let source = shape.source.clone()?;
                let file = folder.join(package.place(&source)?);
                let file = file.to_string_lossy().into_owned();
                Some((shape.id, Source { file, ..source }))
            });
            Writing {
                path: path.to_owned(),
                document: self.session.document(),
                digest: crc32fast::hash(text),
                sources: sources.collect(),
                then: None,
            }
        });
        // The scene comes last: it must not be there without its files.
        let files = package.files.into_iter().rev();
        let files = files.map(|(name, bytes)| (folder.join(name), bytes));
        Together {
            saves,
            ..Together::new(path, files.collect())
        }
    }

    /// Says which models are not where the document, just saved, names them, and which archives it needs for
    /// its models.
    pub(super) fn tell_missing_models(&mut self, files: &dyn Files) {
        let shapes = self.session.scene().shapes().iter();
        let shapes = shapes.filter(|shape| !matches!(shape.kind, ShapeKind::Missing(_)));
        let models: BTreeSet<PathBuf> = shapes.filter_map(file_on_disk).collect();
        let archive = |file: &PathBuf| {
            let mut folders = file.ancestors().skip(1);
            folders
                .find(|folder| io::is_archive(folder))
                .map(Path::to_owned)
        };
        let mut archives: BTreeSet<PathBuf> = models.iter().filter_map(archive).collect();
        archives.retain(|archive| !self.is_own(archive, files));
        for archive in archives {
            let text = format!(
                "{} needs {}, where its models are: File ⏵ Save with Files… keeps everything together",
                self.document_name(),
                archive.display()
            );
            self.tell(Severity::Warning, text);
        }
        for file in models.into_iter().filter(|file| !files.exists(file)) {
            let text = format!(
                "{} is not there: what comes from it will be missing when the document is opened again",
                file.display()
            );
            self.tell(Severity::Warning, text);
        }
    }

    /// Imports the parts of files that shapes came from again, from where `at` says or else where
    /// they were, and replaces the shapes of which that is something new, in one step. Returns how many these are, and
    /// how many files could not be read.
    fn replace(
        &mut self,
        shapes: &[ShapeId],
        at: &dyn Fn(&Shape) -> Option<PathBuf>,
        files: &dyn Files,
    ) -> (usize, usize) {
        let mut edits = Vec::new();
        let mut failed = BTreeSet::new();
        for &id in shapes {
            let shape = self.session.scene().shape(id);
            let path = shape.and_then(at);
            match io::reimport(files, self.session.scene(), id, path.as_deref()) {
                Ok(read) => {
                    let Reimported { kind, source } = read.value;
                    if shape.is_some_and(|shape| is_new(shape, source.fingerprint)) {
                        edits.push(Edit::Replace(id, kind, source));
                        self.tell_all(Severity::Warning, read.warnings);
                    }
                }
                Err(error) => drop(failed.insert(error.to_string())),
            }
        }
        let count = edits.len();
        if count > 0 {
            self.edit(Edit::Together(edits));
        }
        for error in &failed {
            let text = format!("{error}. What came from it stays as it was");
            self.tell(Severity::Error, text);
        }
        (count, failed.len())
    }

    /// Shapes that come from `path` or a file that belongs to it, and would be others by now.
    fn changed_shapes(&self, path: &Path, files: &dyn Files) -> Vec<ShapeId> {
        let scene = self.session.scene();
        let from_it = scene.shapes().iter().filter(|shape| {
            let file = file_on_disk(shape);
            file.is_some_and(|file| with_companions(file).any(|file| file == path))
        });
        from_it
            .filter(|shape| match io::reimport(files, scene, shape.id, None) {
                Ok(read) => is_new(shape, read.value.source.fingerprint),
                // What cannot be read any more is something new, too.
                Err(_) => !matches!(shape.kind, ShapeKind::Missing(_)),
            })
            .map(|shape| shape.id)
            .collect()
    }
}

/// Whether a file with this fingerprint is another than the one that `shape` was read from.
fn is_new(shape: &Shape, fingerprint: Option<u32>) -> bool {
    let known = shape.source.as_ref().and_then(|source| source.fingerprint);
    matches!(shape.kind, ShapeKind::Missing(_)) || known != fingerprint
}

/// File that a shape came from, if that is not built in.
fn file_on_disk(shape: &Shape) -> Option<PathBuf> {
    let path = PathBuf::from(&shape.source.as_ref()?.file);
    (!builtin::is_builtin(&path)).then_some(path)
}

/// A file, and those that belong to it by their names.
fn with_companions(file: PathBuf) -> impl Iterator<Item = PathBuf> {
    let is_obj = io::expect_extension(&file, "obj").is_ok();
    let companions = ["skel", "attach", "mtl"].map(|extension| file.with_extension(extension));
    let companions = companions.into_iter().filter(move |_| is_obj);
    std::iter::once(file.clone()).chain(companions)
}
