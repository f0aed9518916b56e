//! The triangles of a mesh that a picture needs.

use super::coverage::Raster;
use super::samples::Samples;
use crate::gpu::{Gl, GpuError, IndexBuffer, Usage, VertexArray};
use crate::revision::Revision;
use crate::scene::EvaluatedGeometry;
use std::ops::Range;

/// What triangles are drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// Its surface.
    Surface,
    /// Its shadow on the ground.
    Shadow,
    /// The mask of the line round it.
    Mask,
}

/// The triangles of a mesh that are drawn for each purpose.
#[derive(Debug, Default)]
pub(super) struct ShownTriangles([Shown; 3]);

/// Some triangles of a mesh.
#[derive(Debug, Default)]
pub(super) enum Shown {
    #[default]
    All,
    /// The mesh is out of sight.
    None,
    Some(Box<Kept>),
}

/// The triangles in which there may be a sample.
#[derive(Debug)]
pub(super) struct Kept {
    /// What they follow from.
    of: (Revision, Raster, usize),
    /// `None` for all, since nearly all may be seen.
    list: Option<List>,
}

#[derive(Debug)]
struct List {
    /// Their numbers in the mesh.
    triangles: Vec<u32>,
    indices: IndexBuffer,
    vertex_array: VertexArray,
}

impl ShownTriangles {
    /// Whether any triangle may have to be drawn.
    pub fn is_any(&self, purpose: Purpose) -> bool {
        !matches!(self.of(purpose), Shown::None)
    }

    pub fn of(&self, purpose: Purpose) -> &Shown {
        &self.0[purpose as usize]
    }

    /// Leaves out the mesh as a whole, or nothing of it.
    pub fn set_seen(&mut self, purpose: Purpose, seen: bool) {
        self.0[purpose as usize] = if seen { Shown::All } else { Shown::None };
    }

    /// Leaves out the triangles without a sample. `drawn` are all triangles as they are uploaded, in
    /// the order of those of `geometry`; `all` draws them.
    ///
    /// # Errors
    /// If the driver cannot take the others; then all are drawn.
    pub fn set_covering(
        &mut self,
        gl: &Gl,
        purpose: Purpose,
        geometry: &EvaluatedGeometry,
        (drawn, all): (&[[u32; 3]], &VertexArray),
        raster: Raster,
        samples: &Samples,
    ) -> Result<(), GpuError> {
        let shown = &mut self.0[purpose as usize];
        let of = (geometry.revision, raster, samples.places.len());
        let before = match std::mem::take(shown) {
            Shown::Some(kept) if kept.of == of => {
                *shown = Shown::Some(kept);
                return Ok(());
            }
            Shown::Some(kept) => kept.list,
            Shown::All | Shown::None => None,
        };
        let (positions, triangles) = (geometry.positions(), &geometry.mesh.triangles);
        let covering = raster.covering(&geometry.bounds(), positions, triangles, samples);
        let list = covering.map(|triangles| {
            let corners = triangles.iter().map(|&kept| drawn[kept as usize]);
            let corners: Vec<[u32; 3]> = corners.collect();
            let corners = corners.as_flattened();
            let (indices, vertex_array) = match before {
                Some(List {
                    indices,
                    vertex_array,
                    ..
                }) => {
                    indices.update(corners)?;
                    (indices, vertex_array)
                }
                None => {
                    let indices = IndexBuffer::new(gl, Usage::Stream, corners)?;
                    let vertex_array = all.extended().indices(&indices).build()?;
                    (indices, vertex_array)
                }
            };
            Ok(List {
                triangles,
                indices,
                vertex_array,
            })
        });
        let list = list.transpose()?;
        *shown = Shown::Some(Box::new(Kept { of, list }));
        Ok(())
    }
}

impl Kept {
    /// The vertex array that draws them, and those of the triangles `range` of the mesh, as triangles
    /// there; `None` if all are drawn.
    pub fn within(&self, range: &Range<u32>) -> Option<(&VertexArray, Range<u32>)> {
        let list = self.list.as_ref()?;
        let before = |end: u32| list.triangles.partition_point(|&kept| kept < end) as u32;
        Some((&list.vertex_array, before(range.start)..before(range.end)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Mesh, Poles, SharedMesh, sphere};
    use crate::gpu::{Backend, DrawState, Framebuffer, HeadlessContext};
    use crate::math::Euler;
    use crate::render::frame::PassContext;
    use crate::render::ground_pass::ShadowPass;
    use crate::render::mesh_cache::MeshCache;
    use crate::render::sight::Sight;
    use crate::render::surface_pass::SurfacePass;
    use crate::render::tile::Tile;
    use crate::render::{Backdrop, Background, Frame};
    use crate::scene::{
        Camera, Evaluated, Evaluator, Look, NewShape, Scene, ShapeKind, Skinning, ViewSettings,
    };
    use glam::{Vec2, Vec3};
    use proptest::prelude::*;

    const SIZE: (u32, u32) = (151, 113);

    /// Balls of a thousand triangles, stretched and turned, and cameras from everywhere.
    fn scenes() -> impl Strategy<Value = (Scene, Camera)> {
        let place = prop::array::uniform3(-6.0..6.0f32);
        let scale = prop::array::uniform3(0.02..0.8f32);
        let shapes = proptest::collection::vec((place, scale, 0.0..90.0f32), 1..12);
        let camera = (1.0..60.0f32, -180.0..180.0f32, -30.0..89.0f32);
        (shapes, camera).prop_map(|(shapes, (radius, theta, phi))| {
            let ball = sphere(1.0, 24, 24, Poles::Y);
            let ball = SharedMesh::new(Mesh::new(ball.positions, ball.triangles));
            let mut scene = Scene::new();
            for (place, scale, turn) in shapes {
                let id = scene.add(NewShape::new("A", ShapeKind::Mesh(ball.clone())));
                let transform = &mut scene.shape_mut(id).unwrap().placement.transform;
                transform.position = Vec3::from(place);
                transform.scale = Vec3::from(scale);
                transform.rotation = Euler::from_degrees(Vec3::splat(turn));
            }
            let camera = Camera {
                radius,
                theta: theta.to_radians(),
                phi: phi.to_radians(),
                ..Camera::default()
            };
            (scene, camera)
        })
    }

    /// Number of triangles that are drawn.
    fn drawn(meshes: &MeshCache, evaluated: &Evaluated, purpose: Purpose) -> u32 {
        let shapes = evaluated.shapes.iter();
        let counts = shapes.map(|shape| {
            let mesh = meshes.get(shape.id);
            let all = shape.geometry.mesh.triangles.len() as u32;
            match mesh.map(|mesh| mesh.shown.of(purpose)) {
                Some(Shown::All) => all,
                Some(Shown::None) | None => 0,
                Some(Shown::Some(kept)) => kept.within(&(0..all)).map_or(all, |(_, it)| it.end),
            }
        });
        counts.sum()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(150))]

        #[test]
        fn what_is_left_out_of_a_picture_is_not_seen((scene, camera) in scenes()) {
            let headless = HeadlessContext::new(Backend::Auto).unwrap();
            let gl = headless.gl();
            let evaluated = Evaluator::new().evaluate(&scene, 0.0);
            let view = ViewSettings { camera, look: Look::Studio, grid: true, ..ViewSettings::default() };
            let frame = Frame::plain(&scene, &evaluated, &view);
            let tile = Tile::whole(SIZE);
            let context = PassContext {
                width: SIZE.0,
                height: SIZE.1,
                tile,
                background: Background::Look,
                clip_from_world: camera.clip_from_world(tile.aspect()),
                ground: -1.0,
                colors: Backdrop::default().colors(Look::Studio),
            };
            let sight = Sight::new(&context, &frame);
            let everywhere = Sight {
                clip_from_world: glam::Mat4::ZERO,
                clip_from_shadowed: None,
            };
            let (surfaces, mut shadows) = (SurfacePass::new(gl), ShadowPass::new(gl));
            let mut pictures = |meshes: &MeshCache| {
                let target = Framebuffer::new(gl, SIZE.0, SIZE.1, 0).unwrap();
                DrawState::opaque(SIZE.0, SIZE.1).apply(gl);
                target.clear([0.3, 0.4, 0.5, 1.0]);
                surfaces.draw_opaque(gl, &context, &frame, meshes, 0..u64::MAX);
                let shadows = shadows.draw(gl, &context, &frame, meshes, None).unwrap();
                [&target, shadows].map(|picture| picture.read_rgba().unwrap())
            };
            let [mut all, mut some] = [(); 2].map(|()| MeshCache::new(gl.info().max_texture_size));
            all.update(gl, &frame, &everywhere, Skinning::Cpu).unwrap();
            some.update(gl, &frame, &sight, Skinning::Cpu).unwrap();
            let middle = Samples::middle(gl.info());
            let samples = (Some(&middle), Some(&middle));
            some.choose_triangles(gl, &frame, &sight, [SIZE.0, SIZE.1], samples).unwrap();
            let counts = [Purpose::Surface, Purpose::Shadow].map(|purpose| {
                [&all, &some].map(|meshes| drawn(meshes, &evaluated, purpose))
            });
            prop_assert!(pictures(&all) == pictures(&some), "{counts:?}");
        }
    }

    #[test]
    fn of_a_crowd_far_away_most_triangles_are_left_out() {
        let triangles = sphere(1.0, 200, 100, Poles::Y);
        let bounds = triangles.bounds();
        let size = [800, 600];
        let raster = |radius| Raster {
            clip_from_world: Camera {
                radius,
                ..Camera::default()
            }
            .clip_from_world(800.0 / 600.0),
            world_from_model: glam::Mat4::IDENTITY,
            size,
        };
        let (positions, triangles) = (&triangles.positions, &triangles.triangles);
        let middle = Samples {
            places: vec![Vec2::splat(0.5)],
            room: 1.0 / 256.0,
        };
        let kept = |radius| {
            let kept = raster(radius).covering(&bounds, positions, triangles, &middle);
            kept.map(|kept| kept.len())
        };
        assert_eq!(kept(3.0), None, "it fills the picture");
        // A disc of radius r pixels, once in front and once behind, has 2π r² middles.
        let pixels = 600.0 / 2.0 / 22.5_f64.to_radians().tan() / 80.0;
        let seen = 2.0 * std::f64::consts::PI * pixels * pixels;
        let kept = kept(80.0).unwrap() as f64;
        assert!((seen * 0.7..seen * 1.5).contains(&kept), "{kept} of {seen}");
    }
}
