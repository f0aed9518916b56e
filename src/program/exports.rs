//! Geometry, characters and curves written for other programs.

use super::document_file::Writing;
use super::questions::Asked;
use super::running::Program;
use super::{Host, Previous};
use crate::editor::{Severity, scene_of_selected};
use crate::io::{self, Diagnostic, Files};
use crate::scene::{Evaluator, Scene, ShapeId};
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};

/// Files that are written together.
pub(super) struct Together {
    /// The one that was chosen.
    pub path: PathBuf,
    /// All of them with their bytes.
    pub files: Vec<(PathBuf, Vec<u8>)>,
    /// Files beside the chosen one whose place others take.
    pub replaced: Vec<PathBuf>,
    /// The document's save that is done with them, if it is.
    pub saves: Option<Writing>,
    /// What they leave out of what they were made of, in words, if they do.
    pub left_out: Option<String>,
}

impl Together {
    /// The `files`, of which that at `path` was chosen.
    pub(super) fn new(path: &Path, files: Vec<(PathBuf, Vec<u8>)>) -> Self {
        Self {
            path: path.to_owned(),
            files,
            replaced: Vec::new(),
            saves: None,
            left_out: None,
        }
    }
}

/// Files that are being written together.
pub(super) struct Exporting {
    /// The one that was chosen.
    pub path: PathBuf,
    /// All of them, with the CRC-32 of their bytes.
    pub digests: HashMap<PathBuf, u32>,
    /// What they leave out, in words.
    pub left_out: Option<String>,
}

impl Program {
    /// `stem`, with a hyphen and the word `to_tell` where that is the name of a file that the document needs, which
    /// exports do not replace.
    pub(super) fn free_stem(&self, stem: String, to_tell: &str) -> String {
        let sources = self.session.scene().shapes().iter();
        let mut sources = sources.filter_map(|shape| shape.source.as_ref());
        let is_needed = sources.any(|source| {
            let own = Path::new(&source.file).file_stem();
            own.is_some_and(|own| own.eq_ignore_ascii_case(&stem))
        });
        if is_needed {
            format!("{stem}-{to_tell}")
        } else {
            stem
        }
    }

    pub(super) fn export_curve(&mut self, shape: ShapeId, path: &Path, host: &mut dyn Host) {
        // It may have been deleted while the dialog was open.
        let curves = self.session.scene().curve(shape);
        match curves.map(|shape| io::to_swp(shape.curves())) {
            Some(_) if self.sources(&*host.files()).have(path) => self.tell_needed(path, path),
            Some(text) => self.write(path, "swp", text, host),
            None => self.tell(
                Severity::Error,
                format!("Not saved: there is no curve with ID {shape} any more"),
            ),
        }
    }

    /// Writes the geometry of the scene as one `.obj` file, bare.
    pub(super) fn export_geometry(&mut self, path: &Path, host: &mut dyn Host) {
        let text = io::export_obj(self.session.scene(), self.session.evaluated());
        self.write_geometry(path, text, host);
    }

    /// Writes the geometry of the selected shapes as one `.obj` file, bare.
    pub(super) fn export_selected(&mut self, path: &Path, host: &mut dyn Host) {
        let selected = scene_of_selected(&self.session);
        // It may have been deleted while the dialog was open.
        if selected.shapes().is_empty() {
            return self.tell(Severity::Error, "Not saved: no shape is selected any more");
        }
        let evaluated = Evaluator::new().evaluate(&selected, 0.0);
        self.write_geometry(path, io::export_obj(&selected, &evaluated), host);
    }

    fn write_geometry(
        &mut self,
        path: &Path,
        text: Result<String, io::TooFarOut>,
        host: &mut dyn Host,
    ) {
        match text {
            Ok(_) if self.sources(&*host.files()).have(path) => self.tell_needed(path, path),
            Ok(text) => self.write(path, "obj", text, host),
            Err(error) => self.tell_written(path, Err(Diagnostic::new(path, error.to_string()))),
        }
    }

    /// Writes the geometry of the scene as an `.obj` file with its materials and pictures beside it.
    pub(super) fn export_materials(&mut self, path: &Path, host: &mut dyn Host) {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let (scene, evaluated) = (self.session.scene(), self.session.evaluated());
        let files = io::expect_extension(path, "obj").and_then(|()| {
            io::export_obj_with_materials(scene, evaluated, &stem)
                .map(|written| Together::new(path, written.into_files(path)))
                .map_err(|error| Diagnostic::new(path, error.to_string()))
        });
        self.write_exported(path, files, host);
    }

    /// Writes a character as a `.skel` file with `.attach`, `.obj` and its pose beside it.
    pub(super) fn export_character(&mut self, id: ShapeId, path: &Path, host: &mut dyn Host) {
        let scene = self.session.scene();
        // It may have been deleted while the dialog was open.
        let Some((shape, character)) = scene.shape(id).zip(scene.character(id)) else {
            let text = "Not saved: the character does not exist any more";
            return self.tell(Severity::Error, text);
        };
        let files = io::expect_extension(path, "skel").and_then(|()| {
            io::export_character(shape, character)
                .map(|written| written.into_files(path))
                .map_err(|error| Diagnostic::new(path, error.to_string()))
        });
        let left_out = io::left_out_of_course(character);
        let files = files.map(|files| Together {
            left_out,
            ..Together::new(path, files)
        });
        self.write_exported(path, files, host);
    }

    /// Writes files of which only the one at `path` was chosen. None of them takes the place of a
    /// file that the document needs.
    fn write_exported(
        &mut self,
        path: &Path,
        together: Result<Together, Diagnostic>,
        host: &mut dyn Host,
    ) {
        match together {
            Ok(together) => {
                let there = host.files();
                let sources = self.sources(&*there);
                let mut files = together.files.iter();
                match files.find(|(file, _)| sources.have(file)) {
                    Some((file, _)) => self.tell_needed(path, file),
                    None => self.write_together(together, host),
                }
            }
            Err(error) => self.tell_written(path, Err(error)),
        }
    }

    /// Writes files of which only the one at `path` was chosen; asks before others of which this program
    /// did not write the last version are replaced.
    pub(super) fn write_together(&mut self, mut together: Together, host: &mut dyn Host) {
        let there = host.files();
        let Together { path, files, .. } = &together;
        let others = files.iter().filter(|(file, _)| file != path);
        let is_foreign = |file: &Path, bytes: &[u8]| {
            let own = self.exported.get(file);
            let is_foreign = |old: Vec<u8>| old != bytes && own != Some(&crc32fast::hash(&old));
            there.read(file).is_ok_and(is_foreign)
        };
        let replaced = others.filter(|(file, bytes)| is_foreign(file, bytes));
        let mut replaced: Vec<PathBuf> = replaced.map(|(file, _)| file.clone()).collect();
        replaced.sort();
        together.replaced = replaced;
        if together.replaced.is_empty() {
            self.write_now(together, host);
        } else {
            self.asked = Some(Asked::Replace(together));
        }
    }

    pub(super) fn write_now(&mut self, together: Together, host: &mut dyn Host) {
        let Together {
            path,
            files,
            saves,
            left_out,
            replaced: _,
        } = together;
        let previous = match &saves {
            Some(_) => self.previous_version(&path),
            None => Previous::KeepForeign,
        };
        if saves.is_some() {
            self.document.writing = saves;
        }
        let digests = files
            .iter()
            .map(|(file, bytes)| (file.clone(), crc32fast::hash(bytes)));
        self.exporting = Some(Exporting {
            path: path.clone(),
            digests: digests.collect(),
            left_out,
        });
        host.write_files(&path, files, previous);
    }

    /// The first of the files but the chosen one that is a file of the document and has other bytes.
    pub(super) fn replaced_source(&self, together: &Together, read: &dyn Files) -> Option<PathBuf> {
        let sources = self.sources(read);
        let files = together.files.iter();
        let mut others = files.filter(|(file, _)| *file != together.path);
        let replaced = others.find(|(file, bytes)| {
            let is_other = |old: Vec<u8>| old != *bytes;
            sources.have(file) && read.read(file).is_ok_and(is_other)
        });
        replaced.map(|(file, _)| file.clone())
    }

    /// Says that nothing is written to `path`, because `file` would be replaced.
    pub(super) fn tell_needed(&mut self, path: &Path, file: &Path) {
        self.tell_written(path, Err(needed_error(path, file)));
    }

    /// The files that shapes of the document, and those that undoing brings back, come from.
    fn sources<'a>(&self, there: &'a dyn Files) -> Sources<'a> {
        let shapes = self.session.remembered_scenes().flat_map(Scene::shapes);
        let files: BTreeSet<&str> = shapes
            .filter_map(|shape| Some(shape.source.as_ref()?.file.as_str()))
            .collect();
        let files = files.into_iter().map(Path::new);
        Sources {
            there,
            stems: files.map(|file| stem(there, file)).collect(),
        }
    }
}

/// Files that shapes come from, and those that are read with them: those of a character differ in
/// their extensions alone.
struct Sources<'a> {
    there: &'a dyn Files,
    stems: BTreeSet<PathBuf>,
}

impl Sources<'_> {
    /// Whether `file` is one of them.
    fn have(&self, file: &Path) -> bool {
        self.stems.contains(&stem(self.there, file))
    }
}

fn stem(there: &dyn Files, file: &Path) -> PathBuf {
    there.real(file).with_extension("")
}

/// Error of writing to `path`, because the document needs `file`, which would be replaced.
pub(super) fn needed_error(path: &Path, file: &Path) -> Diagnostic {
    let message = format!(
        "expected a name whose files are not those of the document, which needs {}",
        file.display()
    );
    Diagnostic::new(path, message)
}
