//! A comparison of a character with a mesh that another program posed.

use super::Host;
use super::files::file_name;
use super::job::{Job, JobHandle, MeshDiagnosed, Work};
use crate::diagnose::{
    DiagnoseError, Diagnosis, MeshJob, MeshMeasure, NoNumbers, ToldFor, may_be_of, measure, of_size,
};
use crate::editor::Session;
use crate::geometry::{Mesh, SharedMesh};
use crate::render::{Ghost, GhostPaint, Marks, ShapeNumbers};
use crate::revision::Revision;
use crate::scene::{
    Camera, EvaluatedGeometry, EvaluatedShape, ShapeId, SkinningMethod, VertexNumbers,
};
use crate::ui::{CompareMeshView, Legend, MeshesShown};
use glam::Vec3;
use std::path::{Path, PathBuf};
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
    pub opened: Revision,
    pub shape: ShapeId,
    /// File of theirs.
    path: PathBuf,
    pub name: String,
    /// Their vertices, in model space; not finite where they are no numbers.
    theirs: Arc<[Vec3]>,
    /// Which of them are no numbers in the file.
    no_numbers: Option<NoNumbers>,
    /// Their mesh with numbers in the place of these, to be diagnosed.
    mesh: SharedMesh,
    /// Their mesh to be drawn.
    geometry: Arc<EvaluatedGeometry>,
    pub shown: MeshesShown,
    /// Why the file cannot be compared as it is now.
    pub problem: Option<String>,
    /// The newest pose, and when it came.
    pose: Option<(Revision, Duration)>,
    measured: Option<Measured>,
    legend: Legend,
    /// The search for the mistake, while it is under way.
    running: Option<Search>,
    diagnosis: Option<(Revision, Result<Diagnosis, DiagnoseError>)>,
    /// The camera before it was moved for the comparison, and where it was moved to.
    pub(super) moved_camera: Option<(Camera, Camera)>,
}

/// A mesh as it was read.
pub(super) struct TheirMesh {
    /// With numbers in the place of what is none.
    pub mesh: Mesh,
    /// Which of its vertices are no numbers.
    pub no_numbers: Option<NoNumbers>,
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
    /// A comparison of the character `shape` with the mesh from the file `path`.
    pub fn new(opened: Revision, shape: ShapeId, path: PathBuf, theirs: TheirMesh) -> Self {
        let TheirMesh { mesh, no_numbers } = theirs;
        let mut positions = mesh.positions.clone();
        if let Some(no_numbers) = &no_numbers {
            no_numbers.put_back_among(&mut positions);
        }
        let mesh = SharedMesh::new(mesh);
        let drawn = match no_numbers {
            Some(_) => SharedMesh::new(drawable(&positions, &mesh.triangles)),
            None => mesh.clone(),
        };
        let (bounds, revision) = (drawn.bounds(), drawn.revision());
        Self {
            opened,
            shape,
            name: file_name(&path),
            path,
            theirs: positions.into(),
            no_numbers,
            mesh,
            geometry: Arc::new(EvaluatedGeometry::rigid(drawn, bounds, revision)),
            shown: MeshesShown::default(),
            problem: None,
            pose: None,
            measured: None,
            legend: Legend::default(),
            running: None,
            diagnosis: None,
            moved_camera: None,
        }
    }

    /// Keeps that the camera is moved for the comparison, `from` where it is.
    pub fn move_camera(&mut self, from: Camera, to: Camera) {
        let before = self.camera_after(from);
        self.moved_camera = Some((before, to));
    }

    /// Camera that the view goes back to when the comparison ends with `camera`: the one before it was moved for the
    /// comparison, unless it was moved otherwise since.
    pub fn camera_after(&self, camera: Camera) -> Camera {
        match self.moved_camera {
            Some((before, moved)) if moved == camera => before,
            _ => camera,
        }
    }

    /// Measures anew if the character has another pose. Whether there still is something to compare.
    pub fn update(&mut self, session: &Session, now: Duration) -> bool {
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
            path: &self.path,
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

    /// File that their mesh was read from.
    pub fn path(&self) -> &Path {
        &self.path
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
            theirs: self.mesh.clone(),
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

    /// Takes in the result of a search, told for a program. That of another pose, or another mesh, is ignored.
    pub fn take_result(&mut self, result: MeshDiagnosed, program: ToldFor) {
        let is_of = |search: &mut Search| search.own == result.of;
        if let Some(search) = self.running.take_if(is_of) {
            let told = |found: Diagnosis| match &self.no_numbers {
                Some(no_numbers) => no_numbers.put_back_into(&found).told_for(program),
                None => found.told_for(program),
            };
            self.diagnosis = Some((search.pose, result.outcome.map(told)));
        }
    }
}

/// A mesh without the triangles that have no place, with the vertices `places`.
fn drawable(places: &[Vec3], triangles: &[[u32; 3]]) -> Mesh {
    let has_place = |vertex: &u32| places[*vertex as usize].is_finite();
    let whole = triangles
        .iter()
        .filter(|corners| corners.iter().all(has_place));
    let anywhere = places.iter().find(|place| place.is_finite());
    let anywhere = anywhere.copied().unwrap_or_default();
    let placed = places
        .iter()
        .map(|place| if place.is_finite() { *place } else { anywhere });
    Mesh::new(placed.collect(), whole.copied().collect())
}

/// The largest distance of a vertex that has a place: where the scale of colors ends.
fn largest(measure: &MeshMeasure) -> f64 {
    let finite = measure.distances.iter().copied().filter(|d| d.is_finite());
    finite.fold(0.0, f64::max)
}

/// The distances as numbers of the vertices, to the largest one.
fn numbers(measure: &MeshMeasure) -> VertexNumbers {
    let most = largest(measure).max(measure.tolerance);
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
    let ends = ["0".to_owned(), by_size(largest(measure))];
    Legend {
        title: format!("Distance of {name} from the exact mesh"),
        ends: Some(ends).filter(|_| measure.off > 0),
        gray: Some(format!("agrees: up to {}", by_size(measure.tolerance))),
        note: Some(format!("In Both, {name} lies over it like orange glass")),
    }
}
