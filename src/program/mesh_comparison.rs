//! A comparison of a character with a mesh that another program posed.

use super::Host;
use super::files::file_name;
use super::job::{Job, JobHandle, MeshDiagnosed, Work};
use super::running::Program;
use crate::diagnose::{
    DiagnoseError, Diagnosis, MeshJob, MeshMeasure, may_be_of, measure, of_size,
};
use crate::editor::{Session, Severity};
use crate::geometry::{Mesh, SharedMesh};
use crate::io::{self, Files};
use crate::render::{Ghost, GhostPaint, Marks, ShapeNumbers};
use crate::revision::Revision;
use crate::scene::{EvaluatedGeometry, EvaluatedShape, ShapeId, SkinningMethod, VertexNumbers};
use crate::ui::{CompareMeshAction, CompareMeshView, Legend, MeshesShown};
use glam::{Mat4, Vec3};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// How long the pose must stand still before the mistake is sought.
const STILL: Duration = Duration::from_millis(150);
/// Time between two looks at how far the search has come.
const LOOK: Duration = Duration::from_millis(100);
/// Color of their mesh.
const THEIRS: Vec3 = Vec3::new(1.0, 0.55, 0.35);

/// A comparison under way. Ours is the exact mesh, theirs the file's.
pub(super) struct MeshComparison {
    /// [`Session::opened`] of the scene that the character is in.
    opened: Revision,
    shape: ShapeId,
    name: String,
    theirs: Arc<[Vec3]>,
    /// Their mesh to be drawn.
    geometry: Arc<EvaluatedGeometry>,
    shown: MeshesShown,
    /// Why the file cannot be compared as it is now.
    problem: Option<String>,
    /// The newest pose, and when it came.
    pose: Option<(Revision, Duration)>,
    measured: Option<Measured>,
    legend: Legend,
    /// The search for the mistake, while it is under way.
    running: Option<Search>,
    diagnosis: Option<(Revision, Result<Diagnosis, DiagnoseError>)>,
}

/// A search for the mistake.
struct Search {
    /// The pose that it is about.
    pose: Revision,
    /// Its own, by which its result is known.
    own: Revision,
    handle: JobHandle,
}

/// How far theirs is from ours.
struct Measured {
    measure: MeshMeasure,
    numbers: Arc<VertexNumbers>,
}

impl MeshComparison {
    fn new(opened: Revision, shape: ShapeId, name: String, theirs: Mesh) -> Self {
        let positions: Arc<[Vec3]> = theirs.positions.as_slice().into();
        let mesh = SharedMesh::new(theirs);
        let (bounds, revision) = (mesh.bounds(), mesh.revision());
        Self {
            opened,
            shape,
            name,
            theirs: positions,
            geometry: Arc::new(EvaluatedGeometry::rigid(mesh, bounds, revision)),
            shown: MeshesShown::default(),
            problem: None,
            pose: None,
            measured: None,
            legend: Legend::default(),
            running: None,
            diagnosis: None,
        }
    }

    /// Measures anew if the character has another pose. Whether there still is something to compare.
    fn update(&mut self, session: &Session, now: Duration) -> bool {
        let character = session.scene().character(self.shape);
        let evaluated = session.evaluated().shape(self.shape);
        let (Some(character), Some(evaluated)) = (character, evaluated) else {
            return false;
        };
        let geometry = &evaluated.geometry;
        let is_linear = character.skinning_method() == SkinningMethod::LinearBlend;
        if session.opened() != self.opened
            || !is_linear
            || !may_be_of(&character.character, self.theirs.len())
        {
            return false;
        }
        if self.pose.is_some_and(|(of, _)| of == geometry.revision) {
            return true;
        }
        self.pose = Some((geometry.revision, now));
        // What is sought for another pose is given up.
        self.running = None;
        let measure = measure(&character.character, geometry.positions(), &self.theirs);
        self.measured = measure.map(|measure| Measured {
            numbers: Arc::new(numbers(&measure)),
            measure,
        });
        let measure = self.measured.as_ref().map(|measured| &measured.measure);
        self.legend = words(&self.name, measure);
        true
    }

    /// As the panels show it.
    pub fn view(&self) -> CompareMeshView<'_> {
        let newest = self.pose.map(|(of, _)| of);
        let diagnosis = self.diagnosis.as_ref();
        let diagnosis = diagnosis.filter(|(of, _)| Some(*of) == newest);
        CompareMeshView {
            name: &self.name,
            shape: self.shape,
            mesh: self.geometry.revision,
            shown: self.shown,
            theirs: &self.theirs,
            problem: self.problem.as_deref(),
            measure: self.measured.as_ref().map(|measured| &measured.measure),
            diagnosis: diagnosis.map(|(_, diagnosis)| diagnosis),
            is_diagnosing: diagnosis.is_none(),
            diagnosed_part: self.running.as_ref().map(|search| search.handle.part()),
        }
    }

    /// Words about the colors.
    pub fn legend(&self) -> &Legend {
        &self.legend
    }

    /// The character, and which of the two meshes are shown.
    pub fn shown(&self) -> (ShapeId, MeshesShown) {
        (self.shape, self.shown)
    }

    /// Their mesh in the place of the character; `None` while that is not there, and if it has no finite size.
    pub fn their_shape(&self, session: &Session) -> Option<EvaluatedShape> {
        let ours = session.evaluated().shape(self.shape)?;
        let theirs = EvaluatedShape {
            geometry: Arc::clone(&self.geometry),
            ..ours.clone()
        };
        let size = theirs.world_bounds().size();
        size.is_finite().then_some(theirs)
    }

    /// Both meshes, as they are shown.
    pub fn marks(&self, session: &Session) -> Marks {
        let mut marks = Marks::default();
        let Some(ours) = session.evaluated().shape(self.shape) else {
            return marks;
        };
        let ghost = |paint| Ghost {
            geometry: Arc::clone(&self.geometry),
            world_from_model: ours.world_from_model,
            paint,
        };
        let numbers = self.measured.as_ref().map(|measured| &measured.numbers);
        if self.shown != MeshesShown::Ours {
            let paint = match (self.shown, numbers) {
                (MeshesShown::Theirs, Some(numbers)) => GhostPaint::Numbers(Arc::clone(numbers)),
                _ => GhostPaint::Translucent(THEIRS),
            };
            marks.ghosts.push(ghost(paint));
        }
        if self.shown == MeshesShown::Theirs {
            marks.replaced = Some(self.shape);
        }
        marks.numbers.extend(numbers.map(|numbers| ShapeNumbers {
            shape: self.shape,
            numbers: Arc::clone(numbers),
        }));
        marks
    }

    /// Starts to look for the mistake once the pose stands still. Returns how long nothing needs to be
    /// done unless something changes.
    pub fn advance(&mut self, session: &Session, host: &mut dyn Host) -> Option<Duration> {
        let (newest, since) = self.pose?;
        if self.diagnosis.as_ref().is_some_and(|(of, _)| *of == newest) {
            return None;
        }
        if self.running.is_some() {
            return Some(LOOK);
        }
        let still_for = host.now().saturating_sub(since);
        if still_for < STILL {
            return Some(STILL - still_for);
        }
        let character = session.scene().character(self.shape)?;
        let mesh = MeshJob {
            character: Arc::clone(&character.character),
            pose: character.pose().clone(),
            theirs: self.geometry.mesh.clone(),
        };
        let own = Revision::new();
        let job = Job::new(Work::Diagnose { of: own, mesh });
        self.running = Some(Search {
            pose: newest,
            own,
            handle: job.handle(),
        });
        host.start_job(job);
        Some(LOOK)
    }

    /// Takes in the result of a search. That of another pose, or another mesh, is ignored.
    pub fn take_result(&mut self, result: MeshDiagnosed) {
        let is_of = |search: &mut Search| search.own == result.of;
        if let Some(search) = self.running.take_if(is_of) {
            self.diagnosis = Some((search.pose, result.outcome));
        }
    }
}

/// The distances as numbers of the vertices, to the largest one.
fn numbers(measure: &MeshMeasure) -> VertexNumbers {
    let finite = measure.distances.iter().copied().filter(|d| d.is_finite());
    let most = finite.fold(measure.tolerance, f64::max);
    let values = measure
        .distances
        .iter()
        .map(|distance| distance.min(most) as f32);
    VertexNumbers {
        values: values.collect(),
        low: 0.0,
        high: most as f32,
        gray_up_to: Some(measure.tolerance as f32),
    }
}

fn words(name: &str, measure: Option<&MeshMeasure>) -> Legend {
    let Some(measure) = measure else {
        return Legend {
            title: format!("{name}, over ours"),
            note: Some("There are no distances: its vertices are numbered differently".to_owned()),
            ..Legend::default()
        };
    };
    let by_size = |distance: f64| of_size(distance / measure.size);
    let ends = ["0".to_owned(), by_size(measure.worst)];
    Legend {
        title: format!("Distance of {name} from the exact mesh"),
        ends: Some(ends).filter(|_| measure.off > 0),
        gray: Some(format!("agrees: up to {}", by_size(measure.tolerance))),
        note: None,
    }
}

impl Program {
    /// Compares a character with the mesh at `path` from now on. One that cannot be a pose of it
    /// changes nothing, and is told.
    pub(super) fn compare_with_mesh(&mut self, shape: ShapeId, path: &Path, files: &dyn Files) {
        if let Err(why) = self.try_to_compare_with_mesh(shape, path, files) {
            self.tell(Severity::Error, why);
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
        let read = files
            .read(path)
            .and_then(|bytes| io::read_character_obj(path, &bytes));
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
        let mut comparison = MeshComparison::new(self.session.opened(), shape, name, theirs);
        comparison.shown = shown.unwrap_or_default();
        self.mesh_comparison = Some(comparison);
        self.compared_path = Some(path.to_owned());
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
                self.choose_file(super::Purpose::CompareMesh(shape), "", host);
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
