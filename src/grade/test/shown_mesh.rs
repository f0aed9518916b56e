//! A picture of a mesh that the submission has as well: what is wrong with that is wrong with the picture.

use super::Test;
use crate::character::{Attachments, Character, Pose};
use crate::diagnose::has_silhouette;
use crate::geometry::Mesh;
use crate::io::image;
use crate::io::{TestKind, in_utf8, read_posed_vertices};
use std::path::Path;

impl Test {
    /// The one of `tests` that is of the mesh that the picture of this test should show; `None` for a test of a mesh.
    pub fn mesh_test<'a>(&self, tests: &'a [Self]) -> Option<&'a Self> {
        let is_of_same = |test: &&Self| {
            test.data.kind == TestKind::Mesh
                && test.has_character_of(self)
                && test.pose == self.pose
        };
        let mut meshes = tests.iter().filter(is_of_same);
        meshes.next().filter(|_| self.data.kind != TestKind::Mesh)
    }

    /// Whether the picture `theirs` shows the posed mesh in the file `mesh`, seen as the test says.
    pub fn shows(&self, theirs: &[u8], mesh: &[u8]) -> bool {
        self.shown(theirs, mesh).unwrap_or(false)
    }

    /// The same; `None` where one of them cannot be read, or the mesh is another one.
    fn shown(&self, theirs: &[u8], mesh: &[u8]) -> Option<bool> {
        let TestKind::Picture { camera, size } = self.data.kind else {
            return None;
        };
        let picture = image::decode(Path::new(&self.file_name()), theirs).ok()?;
        let model = self.character.bind_mesh();
        let read = read_posed_vertices(Path::new("mesh.obj"), &in_utf8(mesh), model).ok()?;
        let places = read.value.positions;
        let mut unweighted = Attachments::new();
        places.iter().for_each(|_| unweighted.push_vertex([]));
        let mesh = Mesh::new(places, model.triangles.clone());
        // What has no weights stays where it is.
        let skeleton = self.character.skeleton().clone();
        let posed = Character::new(skeleton, unweighted, mesh).ok()?;
        let [width, height] = size.map(|side| side as f32);
        let seen = camera.clip_from_world(width / height);
        Some(has_silhouette(&posed, &Pose::new(), &picture, seen))
    }
}
