use super::cached_mesh::CachedMesh;
use super::palettes::Palettes;
use super::texture_cache::TextureCache;
use crate::character::Skinning;
use crate::gpu::{Gl, GpuError, Program};
use crate::scene::{Evaluated, Shading, ShapeId};
use std::collections::{HashMap, HashSet};

/// The meshes of a scene in the memory of the graphics card. Only what has a new revision is
/// uploaded: a shape that nobody touches costs nothing but its draw.
#[derive(Debug)]
pub(super) struct MeshCache {
    meshes: HashMap<ShapeId, CachedMesh>,
    palettes: Palettes,
    textures: TextureCache,
    /// Rows of the largest table for skinning.
    most_rows: u32,
}

impl MeshCache {
    /// An empty one, whose tables have at most `most_rows` rows.
    pub fn new(most_rows: u32) -> Self {
        Self {
            meshes: HashMap::new(),
            palettes: Palettes::default(),
            textures: TextureCache::default(),
            most_rows,
        }
    }

    /// Brings all shapes up to date and forgets those that are gone. What a shader cannot do for a
    /// mesh is done on the processor, whatever `skinning` says: smooth normals of a mesh that has
    /// none are sums over the moved triangles round each vertex.
    pub fn update(
        &mut self,
        gl: &Gl,
        evaluated: &Evaluated,
        shading: Shading,
        skinning: Skinning,
    ) -> Result<(), GpuError> {
        let there: HashSet<ShapeId> = evaluated.shapes.iter().map(|shape| shape.id).collect();
        self.meshes.retain(|id, _| there.contains(id));
        for shape in &evaluated.shapes {
            let geometry = &shape.geometry;
            match self.meshes.get_mut(&shape.id) {
                Some(cached) if cached.fits(geometry, shading, skinning) => {
                    cached.update_positions(geometry)?;
                }
                _ => {
                    let most_rows = self.most_rows;
                    let mut cached = CachedMesh::new(gl, geometry, shading, skinning, most_rows)?;
                    cached.add_textures(gl, &geometry.mesh, &mut self.textures);
                    self.meshes.insert(shape.id, cached);
                }
            }
        }
        self.textures.forget_unused();
        let meshes = &self.meshes;
        let is_skinned = |id: &ShapeId| meshes.get(id).is_some_and(|mesh| mesh.skin.is_some());
        let skinned = evaluated.shapes.iter().filter(|s| is_skinned(&s.id));
        self.palettes.update(gl, skinned, self.most_rows)
    }

    pub fn get(&self, id: ShapeId) -> Option<&CachedMesh> {
        self.meshes.get(&id)
    }

    /// How high the ground lies: as low as the lowest visible mesh stands, and never above the origin. At
    /// rest, so that the ground stays where it is while a character is posed.
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
