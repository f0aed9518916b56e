//! A comparison of a character with a mesh that another program posed, as the panels show it.

use super::across::{looking_from, with_across};
use crate::diagnose::{DiagnoseError, Diagnosis, MeshMeasure};
use crate::editor::Session;
use crate::math::Aabb;
use crate::revision::Revision;
use crate::scene::{Camera, FitArea, ShapeId};
use glam::Vec3;
use std::path::Path;

/// What is asked of a comparison with a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CompareMeshAction {
    /// Choose the mesh to compare a character with; starts a comparison or goes on with another mesh.
    Choose(ShapeId),
    /// Show the meshes in this way.
    Show(MeshesShown),
    /// Look at a vertex from there.
    LookFrom(Camera),
    /// Back to the scene alone.
    Close,
}

/// How the two meshes are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshesShown {
    /// Ours in the colors of the distances, and theirs over it like glass.
    #[default]
    Both,
    /// Ours alone, in the colors of the distances.
    Ours,
    /// Theirs alone, in the colors of the distances.
    Theirs,
}

impl MeshesShown {
    /// All, in the order of the panel.
    pub const ALL: [Self; 3] = [Self::Both, Self::Ours, Self::Theirs];
}

/// A comparison of a character with a mesh. Ours is the exact one, theirs the file's.
#[derive(Clone, Copy, Debug)]
pub struct CompareMeshView<'a> {
    /// Name of their file.
    pub name: &'a str,
    /// Their file.
    pub path: &'a Path,
    /// The character.
    pub shape: ShapeId,
    /// Revision of their mesh.
    pub mesh: Revision,
    /// How the two are shown.
    pub shown: MeshesShown,
    /// Their vertices, in model space.
    pub theirs: &'a [Vec3],
    /// Why their file cannot be compared as it is now; what is shown is of the version before.
    pub problem: Option<&'a str>,
    /// How far they are from ours; `None` if they have another number of vertices.
    pub measure: Option<&'a MeshMeasure>,
    /// What is wrong with theirs, as far as it is known.
    pub diagnosis: Option<&'a Result<Diagnosis, DiagnoseError>>,
    /// Whether the diagnosis is about an earlier pose, or there is none yet.
    pub is_diagnosing: bool,
    /// Part of the newer diagnosis that is done, from 0 to 1, while it is sought.
    pub diagnosed_part: Option<f32>,
}

/// Half of the room around a vertex that the camera goes to, by the size of the mesh.
const ROOM: f32 = 0.08;
/// Least distance of the two places of a vertex, by the size of the mesh, that is seen as a line.
const A_LINE: f32 = 0.005;

impl CompareMeshView<'_> {
    /// Where a vertex is in ours and in theirs, in the world; `None` if one of them has none, or no
    /// place for it.
    pub(super) fn places(&self, session: &Session, vertex: usize) -> Option<[Vec3; 2]> {
        let ours = session.evaluated().shape(self.shape)?;
        let exact = *ours.geometry.positions().get(vertex)?;
        let theirs = *self.theirs.get(vertex)?;
        let places = [exact, theirs].map(|at| ours.world_from_model.transform_point3(at));
        places.iter().all(|at| at.is_finite()).then_some(places)
    }

    /// The camera before a vertex, from where the surface looks, with both places in the picture, and turned where one
    /// would hide the other.
    pub(super) fn camera(&self, session: &Session, vertex: usize, area: FitArea) -> Option<Camera> {
        let places = self.places(session, vertex)?;
        let ours = session.evaluated().shape(self.shape)?;
        let size = ours.world_bounds().size().length();
        let room = Vec3::splat(ROOM * size);
        let around = |at: Vec3| [at - room, at + room];
        let bounds = Aabb::from_points(places.into_iter().flat_map(around));
        let mut camera = session.view().camera;
        let positions = ours.geometry.positions();
        let own = ours.geometry.mesh.triangles.iter();
        let own = own.filter(|corners| corners.contains(&(vertex as u32)));
        let normals = own.map(|corners| {
            let [a, b, c] = corners.map(|corner| {
                let at = positions[corner as usize];
                ours.world_from_model.transform_point3(at)
            });
            (b - a).cross(c - a)
        });
        if let Some(normal) = normals.sum::<Vec3>().try_normalize() {
            camera = looking_from(camera, normal);
        }
        let [exact, theirs] = places;
        if exact.distance(theirs) >= A_LINE * size {
            camera = with_across(camera, theirs - exact);
        }
        camera.fit(&bounds, area);
        Some(camera)
    }
}
