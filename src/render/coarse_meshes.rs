//! Meshes with fewer triangles, of which sketches are drawn.

use super::frame::Frame;
use super::mesh_cache::MeshCache;
use crate::scene::{Coarsener, Evaluated};

/// Triangles of a sketch, about. Software OpenGL takes some 20 ms for as many.
const MOST: usize = 60_000;

/// The meshes of a scene, as far as they have many triangles with fewer. They are uploaded beside the whole ones, which
/// the next full picture needs again.
#[derive(Debug)]
pub(super) struct CoarseMeshes {
    coarsener: Coarsener,
    pub meshes: MeshCache,
}

impl CoarseMeshes {
    /// None yet; tables of later ones have at most `most_rows` rows.
    pub fn new(most_rows: u32) -> Self {
        Self {
            coarsener: Coarsener::default(),
            meshes: MeshCache::new(most_rows),
        }
    }

    /// Forgets what belongs to shapes that are not in a scene any more.
    pub fn forget_deleted(&mut self, evaluated: &Evaluated) {
        self.coarsener.forget_deleted(evaluated);
        self.meshes.forget_deleted(evaluated);
    }

    /// The scene of `frame` with fewer triangles; `None` if it has few or shows numbers, which belong to the vertices
    /// of whole meshes.
    pub fn of(&mut self, frame: &Frame) -> Option<Evaluated> {
        match frame.marks.change_meshes() {
            true => None,
            false => self.coarsener.coarse(frame.evaluated, MOST),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::geometry::{Poles, SharedMesh, sphere};
    use crate::gpu::Framebuffer;
    use crate::gpu::test_driver::TestDriver;
    use crate::render::{Frame, Passes, Renderer};
    use crate::scene::{Evaluator, NewShape, Scene, ShapeKind, ViewSettings};

    #[test]
    fn a_coarse_picture_looks_like_the_whole_one_of_which_nothing_is_uploaded_for_it() {
        let driver = TestDriver::new();
        let gl = driver.gl();
        let mut scene = Scene::new();
        let ball = SharedMesh::new(sphere(1.0, 500, 500, Poles::Y));
        scene.add(NewShape::new("Ball", ShapeKind::Mesh(ball)));
        let evaluated = Evaluator::new().evaluate(&scene, 0.0);
        let view = ViewSettings::default();
        let frame = Frame::plain(&scene, &evaluated, &view);
        let targets = [(); 2].map(|()| Framebuffer::new(gl, 200, 150, 0).unwrap());
        let mut renderer = Renderer::new(gl).unwrap();
        TestDriver::limit_buffers(2_000_000);
        renderer
            .draw_coarse(&frame, &targets[0], Passes::All)
            .unwrap();
        let refused = renderer.draw(&frame, &targets[1]);
        assert!(refused.is_err(), "of half a million triangles");
        TestDriver::limit_buffers(usize::MAX);
        Renderer::new(gl)
            .unwrap()
            .draw(&frame, &targets[1])
            .unwrap();
        let [coarse, whole] = targets.map(|target| target.read_rgba().unwrap());
        assert_ne!(coarse, whole);
        let off: f64 = coarse
            .iter()
            .zip(&whole)
            .map(|(a, b)| f64::from(a.abs_diff(*b)))
            .sum();
        let mean = off / coarse.len() as f64;
        // Half a level of one channel in a hundred would be seen; it is 0.002.
        assert!(mean < 0.005, "{mean}");
    }
}
