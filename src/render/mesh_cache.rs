use super::cached_mesh::CachedMesh;
use super::frame::Frame;
use super::palettes::Palettes;
use super::texture_cache::TextureCache;
use crate::gpu::{Gl, GpuError, Program};
use crate::revision::Revision;
use crate::scene::{Evaluated, EvaluatedShape, Shading, Shape, ShapeId, Skinning};
use std::collections::{HashMap, HashSet};

/// The meshes of a scene in the memory of the graphics card. Only what has a new revision is
/// uploaded: a shape that nobody touches costs nothing but its draw.
#[derive(Debug)]
pub(super) struct MeshCache {
    meshes: HashMap<ShapeId, CachedMesh>,
    /// Meshes that the driver could not take.
    refused: HashMap<ShapeId, Refused>,
    palettes: Palettes,
    textures: TextureCache,
    /// Rows of the largest table for skinning.
    most_rows: u32,
}

/// A mesh that is left out, and not tried again as long as it is the same.
#[derive(Debug)]
struct Refused {
    mesh: Revision,
    asked: (Shading, Skinning),
    why: GpuError,
}

impl MeshCache {
    /// An empty one, whose tables have at most `most_rows` rows.
    pub fn new(most_rows: u32) -> Self {
        Self {
            meshes: HashMap::new(),
            refused: HashMap::new(),
            palettes: Palettes::default(),
            textures: TextureCache::default(),
            most_rows,
        }
    }

    /// Brings all shapes up to date and forgets those that are gone. What a shader cannot do for a
    /// mesh is done on the processor, whatever `skinning` says: smooth normals of a mesh that has
    /// none are sums over the moved triangles round each vertex.
    ///
    /// # Errors
    /// When the driver cannot skin. A mesh that it cannot take otherwise is left out, see
    /// [`MeshCache::left_out`].
    pub fn update(
        &mut self,
        gl: &Gl,
        evaluated: &Evaluated,
        shading: Shading,
        skinning: Skinning,
    ) -> Result<(), GpuError> {
        let there: HashSet<ShapeId> = evaluated.shapes.iter().map(|shape| shape.id).collect();
        self.meshes.retain(|id, _| there.contains(id));
        self.refused.retain(|id, _| there.contains(id));
        for shape in &evaluated.shapes {
            let asked = (shading, skinning);
            let mesh = shape.geometry.mesh.revision();
            let is_same = |refused: &Refused| (refused.mesh, refused.asked) == (mesh, asked);
            if self.refused.get(&shape.id).is_some_and(is_same) {
                continue;
            }
            self.refused.remove(&shape.id);
            if let Err(why) = self.update_shape(gl, shape, shading, skinning) {
                self.meshes.remove(&shape.id);
                if skinning == Skinning::Gpu && shape.geometry.deformation.is_some() {
                    return Err(why);
                }
                self.refused.insert(shape.id, Refused { mesh, asked, why });
            }
        }
        self.textures.forget_unused();
        let meshes = &self.meshes;
        let is_skinned = |id: &ShapeId| meshes.get(id).is_some_and(|mesh| mesh.skin.is_some());
        let skinned = evaluated.shapes.iter().filter(|s| is_skinned(&s.id));
        self.palettes.update(gl, skinned, self.most_rows)
    }

    fn update_shape(
        &mut self,
        gl: &Gl,
        shape: &EvaluatedShape,
        shading: Shading,
        skinning: Skinning,
    ) -> Result<(), GpuError> {
        let geometry = &shape.geometry;
        let known = self.meshes.get_mut(&shape.id);
        if let Some(cached) = known.filter(|cached| cached.fits(geometry, shading, skinning)) {
            if cached.update_positions(geometry)? {
                gl.check("moving a mesh")?;
            }
            return Ok(());
        }
        let mut cached = CachedMesh::new(gl, geometry, shading, skinning, self.most_rows)?;
        gl.check("uploading a mesh")?;
        cached.add_textures(gl, &geometry.mesh, &mut self.textures);
        self.meshes.insert(shape.id, cached);
        Ok(())
    }

    /// The visible shapes whose meshes the driver could not take, in words for the user.
    pub fn left_out(&self, frame: &Frame) -> Vec<String> {
        let told = |(shape, _): (&Shape, &EvaluatedShape)| {
            let refused = self.refused.get(&shape.id)?;
            Some(format!("“{}” ({})", shape.name, refused.why))
        };
        frame.shapes().filter_map(told).collect()
    }

    pub fn get(&self, id: ShapeId) -> Option<&CachedMesh> {
        self.meshes.get(&id)
    }

    /// How high the ground lies: as low as the lowest visible mesh stands, and never above the
    /// origin. At rest, so that the ground stays where it is while a character is posed.
    pub fn ground_height(&self, evaluated: &Evaluated) -> f32 {
        let visible = evaluated.shapes.iter().filter(|shape| shape.visible);
        let lowest = visible.filter_map(|shape| {
            let bounds = self.get(shape.id)?.rest_bounds;
            let world = bounds.transformed(shape.world_from_model);
            (!bounds.is_empty()).then_some(world.min.y)
        });
        lowest.filter(|y| y.is_finite()).fold(0.0, f32::min)
    }

    /// What could not be shown since the last call, in words for the user.
    pub fn take_notices(&mut self) -> Vec<String> {
        self.textures.take_notices()
    }

    /// Lets `program`, which is one for its kind of mesh, find the joints of `id`.
    pub fn bind_skin(&self, program: &Program, id: ShapeId) {
        if let Some(cached) = self.get(id) {
            cached.bind_skin(program, id, &self.palettes);
        }
    }
}
