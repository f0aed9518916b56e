use super::workspace::Workspace;
use crate::disk::files;
use crate::editor::{Edit, Session, Severity, apply_edit};
use crate::io::image::PictureFormat;
use crate::io::{self, Diagnostic, Imported, Loaded, NewShape};
use std::path::{Path, PathBuf};

impl Workspace {
    /// Starts with `paths` in one scene, compared with the last that is a picture. What cannot be
    /// opened is told; the others are there.
    pub(super) fn open_at_start(&mut self, paths: &[PathBuf]) {
        let mut loaded = Loaded::default();
        let mut failed = Vec::new();
        let (pictures, paths): (Vec<_>, Vec<_>) = paths.iter().partition(|path| is_picture(path));
        for path in paths {
            if let Err(error) = loaded.add(&files(), path) {
                failed.push(error);
            }
        }
        self.session = Session::with_scene(loaded.scene, loaded.view.unwrap_or_default());
        self.tell(Severity::Warning, loaded.warnings);
        self.tell(Severity::Error, failed);
        if let Some(picture) = pictures.last() {
            self.compare_with(picture);
        }
    }

    /// Puts the scene of `path` in the place of the one that is open; one that cannot be read
    /// leaves it untouched.
    pub(super) fn open(&mut self, path: &Path) {
        let mut loaded = Loaded::default();
        match loaded.add(&files(), path) {
            Ok(()) => {
                let view = loaded.view.unwrap_or(*self.session.view());
                self.session.open(loaded.scene, view);
                self.tell(Severity::Warning, loaded.warnings);
            }
            Err(error) => self.tell(Severity::Error, vec![error]),
        }
        self.request_redraw();
    }

    /// Uses a file that was dropped on the window: a picture to compare the view with, a pose for
    /// the selected character, all else as an import.
    pub(super) fn use_dropped(&mut self, path: &Path) {
        let posed = self.session.selected().filter(|_| is_pose(path));
        if is_picture(path) {
            self.compare_with(path);
        } else if let Some(shape) = posed {
            self.load_pose(shape, path);
        } else {
            self.import_any(path);
        }
    }

    /// Adds what the file at `path` holds, whatever it is.
    pub(super) fn import_any(&mut self, path: &Path) {
        self.insert(io::import_any(&files(), path));
    }

    /// Import ▸ Import Shape.
    pub(super) fn import_shape(&mut self, path: &Path) {
        self.insert(io::import_shape(&files(), path));
    }

    /// Import ▸ Import Curve.
    pub(super) fn import_curve(&mut self, path: &Path) {
        self.insert(io::import_curve(&files(), path));
    }

    /// Import ▸ Import Character.
    pub(super) fn import_character(&mut self, path: &Path) {
        self.insert(io::import_character(&files(), path));
    }

    fn insert(&mut self, imported: Result<Imported<Vec<NewShape>>, Diagnostic>) {
        match imported {
            Ok(imported) => {
                for NewShape { name, kind, source } in imported.value {
                    apply_edit(
                        &mut self.session,
                        Edit::Insert {
                            name,
                            kind,
                            source: Some(source),
                        },
                    );
                }
                self.tell(Severity::Warning, imported.warnings);
            }
            Err(error) => self.tell(Severity::Error, vec![error]),
        }
        self.request_redraw();
    }

    pub(super) fn tell(&mut self, severity: Severity, diagnostics: Vec<Diagnostic>) {
        for diagnostic in diagnostics {
            self.session.messages.tell(severity, diagnostic.to_string());
        }
    }
}

fn is_pose(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("json"))
}

fn is_picture(path: &Path) -> bool {
    PictureFormat::of(path).is_ok()
}
