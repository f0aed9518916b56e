//! What becomes of files that the user has dropped on the window, or chosen.

use super::comparison::Comparison;
use super::document::Next;
use super::document_name::holds_document;
use super::files::{file_name, is_picture, listed};
use super::running::Program;
use super::{Host, Purpose};
use crate::editor::Severity;
use crate::io::image::PictureFormat;
use crate::io::{self, Files, Wanted};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Program {
    /// Uses files that were dropped on the window together. A scene or an archive among them is opened; other
    /// ones, and models that it does not name, are added to it, as when they are chosen together.
    pub(super) fn use_all_dropped(
        &mut self,
        mut dropped: Vec<(PathBuf, Arc<dyn Files>)>,
        host: &mut dyn Host,
    ) {
        if dropped.is_empty() {
            return;
        }
        if self.asked.is_some() {
            let text = "Nothing was dropped: the question comes first";
            self.tell(Severity::Warning, text);
            return;
        }
        let unpack = |(path, files): (PathBuf, Arc<dyn Files>)| {
            let unpacked = io::unpacked(&*files, &path).into_iter();
            unpacked.map(move |path| (path, Arc::clone(&files)))
        };
        dropped = dropped.into_iter().flat_map(unpack).collect();
        // All files of a character that are dropped together are one.
        let mut known = HashSet::new();
        for (path, files) in &mut dropped {
            *path = io::character_file(&**files, path).into_owned();
        }
        dropped.retain(|(path, _)| known.insert(path.clone()));
        let scene = dropped.iter().position(|(path, _)| holds_document(path));
        let Some(scene) = scene.filter(|_| dropped.len() > 1) else {
            // One that is found may bring others that are dropped with it.
            let is_missing = |(path, _): &(PathBuf, _)| self.missing_shape_from(path).is_some();
            let (found, others): (Vec<_>, Vec<_>) = dropped.into_iter().partition(is_missing);
            for (path, files) in found {
                self.complete_scene(&path, &*files);
            }
            for (path, files) in others {
                self.use_dropped(&path, files, host);
            }
            return;
        };
        let (scene, files) = dropped.remove(scene);
        let others = dropped.into_iter().map(|(path, _)| path);
        let (opened, rest): (Vec<PathBuf>, Vec<PathBuf>) =
            others.partition(|path| is_model(path) || holds_document(path));
        // Pictures and the like are read with models that name them.
        let unused = rest.iter().filter(|path| is_pose(path));
        let unused: Vec<String> = unused.map(|path| file_name(path)).collect();
        let to_open = self.to_open([vec![scene], opened].concat(), files);
        if !unused.is_empty() {
            let text = format!("Not used: {}", listed(&unused));
            self.tell(Severity::Warning, text);
        }
        self.leave_for(Next::OpenFiles(to_open), host);
    }

    /// Uses a file that was dropped on the window, of which no shape is missing: a scene or an archive to open, a
    /// picture that a model lacked or else one to compare the view with, a pose for the selected character, another
    /// mesh for the comparison with one, all else as an import.
    fn use_dropped(&mut self, path: &Path, files: Arc<dyn Files>, host: &mut dyn Host) {
        let scene = self.session.scene();
        let selected = self.session.selected();
        let posed = selected.filter(|&id| is_pose(path) && scene.character(id).is_some());
        if holds_document(path) {
            let to_open = self.to_open(vec![path.to_owned()], files);
            self.leave_for(Next::OpenFiles(to_open), host);
        } else if is_picture(path) {
            if !self.complete_models(path, &*files) {
                self.compare_with(path, &*files);
            }
        } else if let Some(shape) = posed {
            self.load_pose(shape, path, &*files);
        } else if let Some(shape) = self.compared_by_dropping(path, &*files) {
            self.compare_with_mesh(shape, path, &*files);
        } else {
            self.import_any(path, &files, host);
        }
    }

    /// Uses the file that was chosen in a dialog, with `others` that were chosen together with it. What was wrong with the
    /// one that was chosen for the same before is not told any longer.
    pub(super) fn use_chosen(
        &mut self,
        purpose: Purpose,
        (path, others): (PathBuf, Vec<PathBuf>),
        files: Arc<dyn Files>,
        host: &mut dyn Host,
    ) {
        let kind = std::mem::discriminant(&purpose);
        let refused = self.refused.take().filter(|(of, _)| *of == kind);
        if let Some((_, numbers)) = refused {
            // Another file is in its place.
            self.session.messages.dismiss_numbers(&numbers);
        }
        let since = self.session.messages.count();
        self.use_for(purpose, (path, others), files, host);
        let told = since..self.session.messages.count();
        let mut fresh = self.session.messages.fresh().iter();
        if fresh.any(|it| it.severity == Severity::Error && told.contains(&it.number)) {
            self.refused = Some((kind, told));
        }
    }

    fn use_for(
        &mut self,
        purpose: Purpose,
        (path, others): (PathBuf, Vec<PathBuf>),
        files: Arc<dyn Files>,
        host: &mut dyn Host,
    ) {
        let reader = &*files;
        let mut all = once_each(reader, [vec![path.clone()], others].concat());
        // Pictures on their own are for models that lack them; among models they are read with these.
        if takes_several(purpose) && all.iter().all(|path| is_picture(path)) {
            all.retain(|path| !self.complete_models(path, reader));
            if all.is_empty() {
                return;
            }
        }
        // What belongs to other missing shapes is found beside the one that is looked for.
        if !takes_several(purpose) && !matches!(purpose, Purpose::FindSource(_)) {
            self.tell_unused(&all);
        }
        match purpose {
            Purpose::Open => {
                let to_open = self.to_open(all, files);
                self.leave_as_answered(Next::OpenFiles(to_open), host);
            }
            Purpose::ImportShape => self.import_all(all, &files, Wanted::Shape, host),
            Purpose::ImportCurve => self.import_all(all, &files, Wanted::Curve, host),
            Purpose::ImportCharacter => self.import_all(all, &files, Wanted::Character, host),
            Purpose::SaveScene => self.save_to(path, host),
            Purpose::SaveWithFiles => self.save_with_files(&path, host),
            Purpose::FindSource(shape) => {
                self.use_found(shape, &path, reader);
            }
            Purpose::LoadPose(shape) => self.load_pose(shape, &path, reader),
            Purpose::Compare => self.compare_with(&path, reader),
            Purpose::CompareMesh(shape) => self.compare_with_mesh(shape, &path, reader),
            Purpose::ExportCurve(id) => self.export_curve(id, &path, host),
            Purpose::ExportGeometry => self.export_geometry(&path, host),
            Purpose::ExportSelected => self.export_selected(&path, host),
            Purpose::ExportMaterials => self.export_materials(&path, host),
            Purpose::ExportCharacter(shape) => self.export_character(shape, &path, host),
            Purpose::SavePose(shape, kept) => self.save_pose(shape, kept, &path, host),
            Purpose::SaveScreenshot(shot) => {
                // Large pictures take their time: what cannot be written is said before.
                match PictureFormat::of(&path) {
                    Ok(_) => self.pending_pictures.push((path, shot)),
                    Err(error) => self.tell_written(&path, Err(error)),
                }
            }
            Purpose::SaveComparison => {
                let picture = self.comparison.as_ref().and_then(Comparison::picture);
                match picture {
                    Some(Ok(picture)) => self.save_picture(&path, &picture, host),
                    Some(Err(error)) => self.tell(Severity::Error, format!("Not saved: {error}")),
                    None => {}
                }
            }
        }
    }

    fn import_all(
        &mut self,
        paths: Vec<PathBuf>,
        files: &Arc<dyn Files>,
        wanted: Wanted,
        host: &mut dyn Host,
    ) {
        let unpacked = paths.iter().flat_map(|path| io::unpacked(&**files, path));
        for path in unpacked {
            self.import(path, Arc::clone(files), wanted, host);
        }
    }

    /// Says which of `paths` are not used, because only the first is.
    fn tell_unused(&mut self, paths: &[PathBuf]) {
        let names: Vec<String> = paths.iter().map(|path| file_name(path)).collect();
        if let [used, unused @ ..] = &names[..]
            && !unused.is_empty()
        {
            let text = format!("Only {used} is used, not {}", listed(unused));
            self.tell(Severity::Warning, text);
        }
    }
}

/// Whether each of several files that are chosen together can be used.
fn takes_several(purpose: Purpose) -> bool {
    matches!(
        purpose,
        Purpose::Open | Purpose::ImportShape | Purpose::ImportCurve | Purpose::ImportCharacter
    )
}

/// `paths` without those that stand for the same character as one before.
fn once_each(files: &dyn Files, mut paths: Vec<PathBuf>) -> Vec<PathBuf> {
    let mut known = HashSet::new();
    paths.retain(|path| known.insert(io::character_file(files, path).into_owned()));
    paths
}

fn is_model(path: &Path) -> bool {
    io::IMPORTABLE.contains(&&*io::extension(path))
}

fn is_pose(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("json"))
}
