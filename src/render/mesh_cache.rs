//! The meshes and textures of a scene in the memory of the graphics card.

use super::batches::Batch;
use super::cached_mesh::CachedMesh;
use super::coverage::Raster;
use super::frame::Frame;
use super::mesh_upload::{MeshKey, MeshUploads};
use super::palettes::Palettes;
use super::samples::Samples;
use super::shown_triangles::Purpose;
use super::sight::{Sight, may_be_seen};
use super::upload_cache::UploadCache;
use crate::geometry::Picture;
use crate::gpu::{Filter, Gl, GpuError, Program, Sampling, Texture, Wrap};
use crate::scene::{Evaluated, EvaluatedShape, ShapeId, Skinning};
use std::collections::HashSet;
use std::rc::Rc;
use std::sync::Arc;

/// Triangles of a mesh from which on it is uploaded in parts: a browser takes some 60 ms for the normals of half a
/// million.
const MANY_TRIANGLES: usize = 50_000;

/// The meshes of a scene. Only those with a new revision are uploaded: a shape that does not change
/// costs nothing but its draw.
#[derive(Debug)]
pub(super) struct MeshCache {
    /// With each, whether it has room for numbers.
    meshes: UploadCache<(MeshKey, bool), CachedMesh>,
    uploads: MeshUploads,
    palettes: Palettes,
    textures: TextureCache,
    /// Rows of the largest table for skinning.
    most_rows: u32,
}

impl MeshCache {
    /// An empty cache, whose tables have at most `most_rows` rows.
    pub fn new(most_rows: u32) -> Self {
        Self {
            meshes: UploadCache::default(),
            uploads: MeshUploads::default(),
            palettes: Palettes::default(),
            textures: TextureCache::default(),
            most_rows,
        }
    }

    /// Uploads the shapes in `sight` that have changed and drops those that are gone. The processor does what
    /// a shader cannot do for a mesh, whatever `skinning` says: smooth normals of a mesh that has
    /// none are sums over the moved triangles round each vertex.
    ///
    /// # Errors
    /// When the graphics card cannot skin. Other meshes that the driver cannot take are left out,
    /// see [`MeshCache::left_out`].
    pub fn update(
        &mut self,
        gl: &Gl,
        frame: &Frame,
        sight: &Sight,
        skinning: Skinning,
    ) -> Result<(), GpuError> {
        let (evaluated, shading) = (frame.evaluated, frame.view.shading);
        self.meshes.forget_deleted(evaluated);
        let (uploads, textures) = (&mut self.uploads, &mut self.textures);
        let most_rows = self.most_rows;
        let in_sight = |shape: &&EvaluatedShape| shape.visible && sight.has(shape);
        for shape in evaluated.shapes.iter().filter(in_sight) {
            let geometry = &shape.geometry;
            let numbers = frame.marks.numbers_of(shape.id);
            let has_numbers = numbers.is_some();
            let key = MeshKey::new(geometry, shading, skinning);
            let is_skinned = key.is_skinned();
            let moved = |cached: &mut CachedMesh| {
                if cached.update_positions(geometry)? {
                    gl.check("moving a mesh")?;
                }
                cached.update_numbers(&geometry.mesh, numbers)
            };
            self.meshes
                .update(shape.id, (key.clone(), has_numbers), moved, || {
                    let upload = uploads.get(gl, &key, geometry, textures, most_rows)?;
                    let mut cached = CachedMesh::new(gl, &upload, geometry, has_numbers)?;
                    cached.update_numbers(&geometry.mesh, numbers)?;
                    gl.check("uploading a mesh")?;
                    Ok(cached)
                });
            if is_skinned && let Some(why) = self.meshes.take_refusal(shape.id) {
                return Err(why);
            }
        }
        self.uploads.forget_unused();
        self.textures.forget_unused();
        let present = evaluated.shapes.iter().map(|shape| shape.id).collect();
        let is_skinned = |id: ShapeId| self.meshes.get(id).is_some_and(CachedMesh::is_skinned);
        let shapes = frame.scene.shapes().iter().zip(&evaluated.shapes);
        let skinned = shapes
            .filter(|(_, evaluated)| is_skinned(evaluated.id) && in_sight(evaluated))
            .map(|(shape, evaluated)| (evaluated, shape.placement.color.rgb()));
        self.palettes.update(gl, &present, skinned, most_rows)
    }

    /// Drops the meshes of shapes that are not in a scene any more.
    pub fn forget_deleted(&mut self, evaluated: &Evaluated) {
        self.meshes.forget_deleted(evaluated);
        self.uploads.forget_unused();
        self.textures.forget_unused();
    }

    /// Uploads the next part of what [`MeshCache::update`] will need of meshes with many triangles; whether there is
    /// no more of it. What the driver does not take is left to that.
    pub fn upload_part(
        &mut self,
        gl: &Gl,
        frame: &Frame,
        sight: &Sight,
        skinning: Skinning,
    ) -> bool {
        let in_sight = |shape: &&EvaluatedShape| shape.visible && sight.has(shape);
        for shape in frame.evaluated.shapes.iter().filter(in_sight) {
            let geometry = &shape.geometry;
            if geometry.mesh.triangles.len() < MANY_TRIANGLES {
                continue;
            }
            let key = MeshKey::new(geometry, frame.view.shading, skinning);
            let has_numbers = frame.marks.numbers_of(shape.id).is_some();
            if self.meshes.has(shape.id, &(key.clone(), has_numbers)) {
                continue;
            }
            let (textures, most_rows) = (&mut self.textures, self.most_rows);
            let more = self.uploads.go_on(gl, &key, geometry, textures, most_rows);
            if more.is_ok_and(|is_whole| !is_whole) {
                return false;
            }
        }
        true
    }

    /// The visible shapes whose meshes the driver could not take, in words for the user.
    pub fn left_out(&self, frame: &Frame) -> Vec<String> {
        let refused = self.meshes.refused(frame);
        refused
            .map(|(shape, why)| format!("“{}” ({why})", shape.name))
            .collect()
    }

    pub fn get(&self, id: ShapeId) -> Option<&CachedMesh> {
        self.meshes.get(id)
    }

    /// Chooses the triangles of each mesh that a picture of `size` pixels needs: none of those that are
    /// out of `sight`, and only those in which there may be one of the samples, if they are given: those
    /// of surfaces, and those of shadows and masks.
    ///
    /// # Errors
    /// If the driver cannot take a list of them.
    pub fn choose_triangles(
        &mut self,
        gl: &Gl,
        frame: &Frame,
        sight: &Sight,
        size: [u32; 2],
        (of_surfaces, of_others): (Option<&Samples>, Option<&Samples>),
    ) -> Result<(), GpuError> {
        let marks = &frame.marks;
        let marked = marks.also_selected.iter().copied();
        let marked: HashSet<ShapeId> = marked.chain(marks.selected).chain(marks.hovered).collect();
        let visible = frame.evaluated.shapes.iter().filter(|shape| shape.visible);
        for shape in visible {
            let Some(cached) = self.meshes.get_mut(shape.id) else {
                continue;
            };
            let around = shape.world_box();
            let surface = sight.clip_from_world;
            let mask = marked.contains(&shape.id).then_some(surface);
            let purposes = [
                (Purpose::Surface, Some(surface), of_surfaces),
                (Purpose::Shadow, sight.clip_from_shadowed, of_others),
                (Purpose::Mask, mask, of_others),
            ];
            for (purpose, clip_from_world, samples) in purposes {
                let seen = clip_from_world.filter(|&clip| may_be_seen(clip, &around));
                match (seen, samples) {
                    (Some(clip_from_world), Some(samples)) => {
                        let raster = Raster {
                            clip_from_world,
                            world_from_model: shape.world_from_model,
                            size,
                        };
                        cached.leave_out_uncovered(
                            gl,
                            purpose,
                            &shape.geometry,
                            raster,
                            samples,
                        )?;
                    }
                    _ => cached.shown.set_seen(purpose, seen.is_some()),
                }
            }
        }
        Ok(())
    }

    /// Height of the ground in the world: that below the visible meshes and curves, but not above the origin. It stays where
    /// it is while a character is posed or a shape is moved below it.
    pub fn ground_height(&self, evaluated: &Evaluated) -> f32 {
        let shapes = evaluated.shapes.iter();
        let shown = shapes.filter(|shape| shape.visible && !self.meshes.is_refused(shape.id));
        let grounds = shown.map(|shape| shape.ground);
        grounds.filter(|y| y.is_finite()).fold(0.0, f32::min)
    }

    /// Pictures that could not be shown since the last call, in words for the user.
    pub fn take_notices(&mut self) -> Vec<String> {
        self.textures.take_notices()
    }

    /// Where the shape `id`, which the graphics card skins, starts in the palettes.
    pub fn first_cell(&self, id: ShapeId) -> Option<i32> {
        self.palettes.first_cell(id)
    }

    /// Sets what `program`, one for the kind of mesh of a batch, needs to know of its shapes.
    pub fn place(&self, program: &Program, batch: &Batch) {
        if batch.mesh.is_skinned() {
            (batch.mesh).bind_skin(program, &batch.instances, &self.palettes);
        } else {
            program.set_mat4("world_from_model", batch.evaluated.world_from_model);
        }
    }
}

/// Textures of materials, each picture once, however many materials and meshes show it.
///
/// Texels are the values stored in the file, as all colors here are: the Course look
/// lights stored values, as its original does, and the Studio look makes them linear itself. So a
/// picture of one color looks as a material of that color, and mipmaps average what other viewers
/// average.
#[derive(Debug, Default)]
pub(super) struct TextureCache {
    /// `None` for a picture that the driver refused, which is reported once.
    held: Vec<(Arc<Picture>, Option<Rc<Texture>>)>,
    notices: Vec<String>,
}

impl TextureCache {
    /// The texture of `picture`; `None` if the driver refuses it.
    pub fn texture(&mut self, gl: &Gl, picture: &Arc<Picture>) -> Option<Rc<Texture>> {
        let known = self
            .held
            .iter()
            .find(|(held, _)| Arc::ptr_eq(held, picture));
        if let Some((_, texture)) = known {
            return texture.clone();
        }
        let texture = match upload(gl, picture) {
            Ok(texture) => Some(Rc::new(texture)),
            Err(error) => {
                let Picture { width, height, .. } = **picture;
                self.notices.push(format!(
                    "A picture of {width}x{height} pixels is not shown on its material: {error}"
                ));
                None
            }
        };
        self.held.push((picture.clone(), texture.clone()));
        texture
    }

    /// Drops the textures that no mesh shows any more.
    pub fn forget_unused(&mut self) {
        self.held.retain(|(picture, texture)| match texture {
            Some(texture) => Rc::strong_count(texture) > 1,
            None => Arc::strong_count(picture) > 1,
        });
    }

    /// Pictures refused since the last call, in words for the user.
    pub fn take_notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }
}

fn upload(gl: &Gl, picture: &Picture) -> Result<Texture, GpuError> {
    // Texture coordinates count from the lower left, pictures from the top.
    let row = (picture.width as usize * 4).max(1);
    let rows = picture.rgba.chunks(row).rev();
    let upwards: Vec<u8> = rows.flatten().copied().collect();
    let sampling = Sampling {
        filter: Filter::Linear,
        wrap: Wrap::Repeat,
        mipmaps: true,
    };
    Texture::new(gl, picture.width, picture.height, &upwards, sampling)
}
