//! How comparisons with meshes begin, go on with a file that has changed, and end.

use super::files::file_name;
use super::mesh_comparison::{MeshComparison, TheirMesh};
use super::running::Program;
use super::{Host, Purpose};
use crate::diagnose::{NoNumbers, may_be_of, measure};
use crate::editor::{Severity, View};
use crate::geometry::Mesh;
use crate::io::{self, Files};
use crate::scene::{Camera, ShapeId, SkinningMethod};
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
        let theirs = match self.read_mesh_of(shape, path, files) {
            Ok(theirs) => theirs,
            Err(why) => return self.tell(Severity::Error, why),
        };
        let nearer = match self.is_placed_like(shape, &theirs.mesh) {
            Some(_) => None,
            None => self.nearer_character(shape, &theirs.mesh.positions),
        };
        self.begin_mesh_comparison(nearer.unwrap_or(shape), path, theirs);
        if let Some(nearer) = nearer {
            let text = format!(
                "{} is compared with {}, to which it is far nearer than to {}",
                file_name(path),
                self.name_of(nearer),
                self.name_of(shape)
            );
            self.tell(Severity::Info, text);
        }
    }

    /// Compares the character of the comparison with the mesh at `path` as it is now. Where that is not possible, the
    /// panel says so in place of what was found out about the version before.
    pub(super) fn compare_with_mesh_anew(
        &mut self,
        shape: ShapeId,
        path: &Path,
        files: &dyn Files,
    ) {
        let read = if files.exists(path) {
            self.read_mesh_of(shape, path, files)
        } else {
            Err(format!("{} is gone.", file_name(path)))
        };
        match (read, &mut self.mesh_comparison) {
            (Err(why), Some(comparison)) => comparison.problem = Some(why),
            (Err(why), None) => self.tell(Severity::Error, why),
            (Ok(theirs), _) => {
                self.begin_mesh_comparison(shape, path, theirs);
                let text = format!("{} is read and compared anew", file_name(path));
                self.tell(Severity::Info, text);
            }
        }
    }

    /// Reads the mesh at `path`, which may be one of the character `shape`, in any pose.
    ///
    /// # Errors
    /// With the reason in words, if it cannot be read or cannot be a pose of the character.
    fn read_mesh_of(
        &mut self,
        shape: ShapeId,
        path: &Path,
        files: &dyn Files,
    ) -> Result<TheirMesh, String> {
        let name = file_name(path);
        let Some(character) = self.session.scene().character(shape) else {
            return Err(format!(
                "{name} is not compared: the character does not exist any more"
            ));
        };
        let expected = character.character.bind_mesh().positions.len();
        let bytes = files.read(path).map_err(|error| error.to_string())?;
        let no_numbers = NoNumbers::among_numbers(&io::in_utf8(&bytes));
        let readable = no_numbers.as_ref().map_or(&bytes, |found| &found.without);
        let read =
            io::read_posed_obj(path, readable, expected).map_err(|error| error.to_string())?;
        let found = read.value.positions.len();
        let ours = self.name_of(shape);
        if character.skinning_method() != SkinningMethod::LinearBlend {
            return Err(format!(
                "{name} is not compared with {ours}, which is skinned with dual quaternions: \
                 choose Linear Blend in its panel"
            ));
        }
        if !may_be_of(&character.character, found) {
            return Err(format!(
                "{} is not compared with {ours}, which has {expected} vertices: this mesh has {found}",
                path.display()
            ));
        }
        self.tell_all(Severity::Warning, read.warnings);
        if let Some(no_numbers) = &no_numbers {
            self.tell(Severity::Warning, no_numbers.told(&name));
        }
        Ok(TheirMesh {
            mesh: read.value,
            no_numbers,
        })
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

    /// Compares the character `shape` with `theirs` from `path` from now on.
    fn begin_mesh_comparison(&mut self, shape: ShapeId, path: &Path, mut theirs: TheirMesh) {
        if let Some(character) = self.session.scene().character(shape) {
            let model = character.character.bind_mesh();
            let warning = io::take_faces_of(model, path, &mut theirs.mesh);
            self.tell_all(Severity::Warning, Vec::from_iter(warning));
        }
        if let Some(model_from_world) = self.is_placed_like(shape, &theirs.mesh) {
            for position in &mut theirs.mesh.positions {
                *position = model_from_world.transform_point3(*position);
            }
            let text = format!(
                "{} has the position, rotation and scale of {}: it is compared without them",
                file_name(path),
                self.name_of(shape)
            );
            self.tell(Severity::Info, text);
        }
        self.end_comparison();
        let before = self.mesh_comparison.take();
        if before.is_none() {
            self.closer_due = Some(shape);
        }
        let opened = self.session.opened();
        let mut comparison = MeshComparison::new(opened, shape, path.to_owned(), theirs);
        if let Some(before) = before {
            comparison.shown = before.shown;
            comparison.moved_camera = before.moved_camera;
        }
        self.mesh_comparison = Some(comparison);
    }

    fn name_of(&self, shape: ShapeId) -> &str {
        let shape = self.session.scene().shape(shape);
        shape.map_or("", |shape| &shape.name)
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
            CompareMeshAction::LookFrom(camera) => self.look_for_comparison(camera),
            CompareMeshAction::Close => self.end_mesh_comparison(),
        }
    }

    /// Moves the camera for the comparison with a mesh.
    pub(super) fn look_for_comparison(&mut self, camera: Camera) {
        if let Some(comparison) = &mut self.mesh_comparison {
            comparison.move_camera(self.session.view().camera, camera);
        }
        self.session.look(View::SetCamera(camera));
    }

    /// Ends the comparison with a mesh, and goes back to where the view was before it, unless it was moved by hand since.
    pub(super) fn end_mesh_comparison(&mut self) {
        if let Some(comparison) = self.mesh_comparison.take() {
            let camera = comparison.camera_after(self.session.view().camera);
            self.session.look(View::SetCamera(camera));
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
