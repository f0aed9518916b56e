//! How comparisons with meshes begin, go on with a file that has changed, and end.

use super::files::file_name;
use super::mesh_comparison::MeshComparison;
use super::running::Program;
use super::{Host, Purpose};
use crate::diagnose::{may_be_of, measure};
use crate::editor::Severity;
use crate::geometry::Mesh;
use crate::io::{self, Files};
use crate::scene::{ShapeId, SkinningMethod};
use crate::ui::CompareMeshAction;
use glam::{Mat4, Vec3};
use std::path::Path;
use std::time::Duration;

/// How many times as far vertices are from another character on average, at least, for a mesh to be far nearer to one.
const FAR_NEARER: f64 = 4.0;

impl Program {
    /// Compares a character with the mesh at `path` from now on, or another one to which that is far nearer. One that
    /// cannot be a pose of it changes nothing, and is told.
    pub(super) fn compare_with_mesh(&mut self, shape: ShapeId, path: &Path, files: &dyn Files) {
        if let Err(why) = self.try_to_compare_with_mesh(shape, path, files) {
            return self.tell(Severity::Error, why);
        }
        let theirs = self.mesh_comparison.as_ref().map(MeshComparison::theirs);
        let nearer = theirs.and_then(|theirs| self.nearer_character(shape, &theirs));
        if let Some(nearer) = nearer
            && self.try_to_compare_with_mesh(nearer, path, files).is_ok()
        {
            let name = |id| {
                self.session
                    .scene()
                    .shape(id)
                    .map_or("", |shape| &shape.name)
            };
            let text = format!(
                "{} is compared with {}, to which it is far nearer than to {}",
                file_name(path),
                name(nearer),
                name(shape)
            );
            self.tell(Severity::Info, text);
        }
    }

    /// Another character that is seen and has as many vertices, to which a mesh is far nearer, if there is one.
    fn nearer_character(&self, shape: ShapeId, theirs: &[Vec3]) -> Option<ShapeId> {
        let mean = |id: ShapeId| {
            let character = self.session.scene().character(id)?;
            let shown = self
                .session
                .evaluated()
                .shape(id)
                .filter(|shown| shown.visible)?;
            let is_linear = character.skinning_method() == SkinningMethod::LinearBlend;
            let measured = measure(&character.character, shown.geometry.positions(), theirs);
            Some(measured.filter(|_| is_linear)?.mean)
        };
        let own = mean(shape)?;
        let shapes = self.session.scene().shapes().iter();
        let others = shapes.filter_map(|other| Some((other.id, mean(other.id)?)));
        let nearest = others.min_by(|(_, a), (_, b)| a.total_cmp(b))?;
        (nearest.1 * FAR_NEARER < own).then_some(nearest.0)
    }

    /// Compares the character of the comparison with the mesh at `path` as it is now. Where that is not possible, the
    /// panel says so in place of what was found out about the version before.
    pub(super) fn compare_with_mesh_anew(
        &mut self,
        shape: ShapeId,
        path: &Path,
        files: &dyn Files,
    ) {
        let compared = if files.exists(path) {
            self.try_to_compare_with_mesh(shape, path, files)
        } else {
            Err(format!("{} is gone.", file_name(path)))
        };
        match (compared, &mut self.mesh_comparison) {
            (Err(why), Some(comparison)) => comparison.problem = Some(why),
            (Err(why), None) => self.tell(Severity::Error, why),
            (Ok(()), _) => {
                let text = format!("{} is read and compared anew", file_name(path));
                self.tell(Severity::Info, text);
            }
        }
    }

    /// # Errors
    /// With the reason in words, if the mesh cannot be read or cannot be a pose of the character.
    fn try_to_compare_with_mesh(
        &mut self,
        shape: ShapeId,
        path: &Path,
        files: &dyn Files,
    ) -> Result<(), String> {
        let ours = self.session.scene().character(shape);
        let read = files.read(path).and_then(|bytes| match ours {
            Some(ours) => io::read_posed_vertices(path, &bytes, ours.character.bind_mesh()),
            None => io::read_character_obj(path, &bytes),
        });
        let mut theirs = match read {
            Ok(read) => {
                self.tell_all(Severity::Warning, read.warnings);
                read.value
            }
            Err(error) => return Err(error.to_string()),
        };
        let scene = self.session.scene();
        let name = file_name(path);
        let found = theirs.positions.len();
        let Some(character) = scene.character(shape) else {
            return Err(format!(
                "{name} is not compared: the character does not exist any more"
            ));
        };
        let ours = scene
            .shape(shape)
            .map_or("the character", |shape| &shape.name);
        if character.skinning_method() != SkinningMethod::LinearBlend {
            return Err(format!(
                "{name} is not compared with {ours}, which is skinned with dual quaternions: \
                 choose Linear Blend in its panel"
            ));
        }
        if !may_be_of(&character.character, found) {
            let expected = character.character.bind_mesh().positions.len();
            return Err(format!(
                "{} is not compared with {ours}, which has {expected} vertices: this mesh has {found}",
                path.display()
            ));
        }
        let is_placed = self.is_placed_like(shape, &theirs);
        if let Some(model_from_world) = is_placed {
            for position in &mut theirs.positions {
                *position = model_from_world.transform_point3(*position);
            }
            let text = format!(
                "{name} has the position, rotation and scale of {ours}: it is compared without them"
            );
            self.tell(Severity::Info, text);
        }
        self.end_comparison();
        let shown = self.mesh_comparison.take().map(|before| before.shown);
        if shown.is_none() {
            self.closer_due = Some(shape);
        }
        let opened = self.session.opened();
        let mut comparison = MeshComparison::new(opened, shape, path.to_owned(), theirs);
        comparison.shown = shown.unwrap_or_default();
        self.mesh_comparison = Some(comparison);
        Ok(())
    }

    /// The transform that takes `theirs` to the space of the model, if it is in the world with the placement of the
    /// character `shape`, as this program exports geometry: less of it is off then.
    fn is_placed_like(&self, shape: ShapeId, theirs: &Mesh) -> Option<Mat4> {
        let character = &self.session.scene().character(shape)?.character;
        let shown = self.session.evaluated().shape(shape)?;
        let model_from_world = shown.world_from_model.inverse();
        if shown.world_from_model == Mat4::IDENTITY || !model_from_world.is_finite() {
            return None;
        }
        let exact = shown.geometry.positions();
        let off = |theirs: &[Vec3]| Some(measure(character, exact, theirs)?.off);
        let in_model = |place: &Vec3| model_from_world.transform_point3(*place);
        let placed: Vec<Vec3> = theirs.positions.iter().map(in_model).collect();
        let is_less = 2 * off(&placed)? < off(&theirs.positions)?;
        is_less.then_some(model_from_world)
    }

    pub(super) fn compare_mesh(&mut self, action: CompareMeshAction, host: &mut dyn Host) {
        match action {
            CompareMeshAction::Choose(shape) => {
                self.choose_file(Purpose::CompareMesh(shape), "", host);
            }
            CompareMeshAction::Show(shown) => {
                if let Some(comparison) = &mut self.mesh_comparison {
                    comparison.shown = shown;
                }
            }
            CompareMeshAction::Close => self.mesh_comparison = None,
        }
    }

    /// Keeps the comparison with a mesh up to date; it ends when its character is gone or is skinned in
    /// another way.
    pub(super) fn update_mesh_comparison(&mut self, now: Duration) {
        let session = &self.session;
        let ended = self
            .mesh_comparison
            .take_if(|comparison| !comparison.update(session, now));
        let Some(ended) = ended else {
            return;
        };
        let character = session.scene().character(ended.shape);
        let is_there = session.opened() == ended.opened;
        if let Some(character) = character.filter(|_| is_there)
            && character.skinning_method() != SkinningMethod::LinearBlend
        {
            let text = format!(
                "The comparison with {} is closed: it is about linear blending. Choose that again, and \
                 View ⏵ Compare with Mesh…",
                ended.name
            );
            self.tell(Severity::Info, text);
        }
    }

    /// The character that a dropped mesh is for: that of the comparison under way, unless the mesh is a
    /// character itself.
    pub(super) fn compared_by_dropping(&self, path: &Path, files: &dyn Files) -> Option<ShapeId> {
        let is_obj = path.extension()?.eq_ignore_ascii_case("obj");
        let has = |other: &str| files.exists(&path.with_extension(other));
        let comparison = self.mesh_comparison.as_ref()?;
        (is_obj && !has("skel") && !has("attach")).then_some(comparison.shape)
    }
}
