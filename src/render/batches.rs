//! Copies of a mesh that are drawn at once.

use super::cached_mesh::CachedMesh;
use super::mesh_cache::MeshCache;
use super::shown_triangles::Purpose;
use crate::scene::{EvaluatedShape, Shape};
use std::ops::Range;
use std::rc::Rc;

/// Copies that are drawn at once. `shaders/skinning.glsl` has room for so many.
const MOST: usize = 64;

/// Consecutive shapes with the same mesh, skinned by the graphics card: one draw for all of them. Of
/// other shapes each is a batch of its own.
#[derive(Debug)]
pub(super) struct Batch<'a> {
    /// The first of the shapes.
    pub shape: &'a Shape,
    /// Its evaluation.
    pub evaluated: &'a EvaluatedShape,
    /// Its mesh.
    pub mesh: &'a CachedMesh,
    /// Where each of the shapes starts in the palettes; none if the graphics card does not skin it.
    pub instances: Vec<i32>,
}

impl<'a> Batch<'a> {
    /// A batch of one shape; `None` if nothing of it is drawn.
    pub fn of(
        shape: &'a Shape,
        evaluated: &'a EvaluatedShape,
        meshes: &'a MeshCache,
        purpose: Purpose,
    ) -> Option<Self> {
        let mesh = meshes.get(shape.id)?;
        let instance = mesh.is_skinned().then(|| meshes.first_cell(shape.id));
        mesh.shown.is_any(purpose).then(|| Self {
            shape,
            evaluated,
            mesh,
            instances: instance.flatten().into_iter().collect(),
        })
    }

    /// Number of meshes that it draws.
    pub fn copies(&self) -> u32 {
        self.instances.len().max(1) as u32
    }

    /// All triangles of each mesh.
    pub fn triangles(&self) -> Range<u32> {
        0..self.evaluated.geometry.mesh.triangles.len() as u32
    }

    /// Whether the same draw can draw `other` too, after this. Meshes of several materials are drawn
    /// one by one: of two at the same place the first is seen, which part by part would be another.
    fn takes(&self, other: &Self, purpose: Purpose) -> bool {
        let has_one_color = |batch: &Self| {
            let mesh = &batch.evaluated.geometry.mesh;
            purpose != Purpose::Surface
                || (mesh.groups.is_empty() && batch.mesh.numbers().is_none())
        };
        let is_same = Rc::ptr_eq(&self.mesh.upload, &other.mesh.upload);
        let is_room = (1..MOST).contains(&self.instances.len()) && !other.instances.is_empty();
        is_same && is_room && has_one_color(self) && has_one_color(other)
    }
}

/// The batches of `shapes`, in their order.
pub(super) fn batches<'a>(
    shapes: impl Iterator<Item = (&'a Shape, &'a EvaluatedShape)>,
    meshes: &'a MeshCache,
    purpose: Purpose,
) -> Vec<Batch<'a>> {
    let mut batches: Vec<Batch> = Vec::new();
    for next in shapes.filter_map(|(shape, it)| Batch::of(shape, it, meshes, purpose)) {
        match batches.last_mut() {
            Some(last) if last.takes(&next, purpose) => last.instances.extend(next.instances),
            _ => batches.push(next),
        }
    }
    batches
}

/// The parts of `batches` that are within `triangles`, counted batch by batch and each as often as it is drawn, and
/// the number of all triangles.
pub(super) fn parts_within(
    batches: Vec<Batch<'_>>,
    triangles: Range<u64>,
) -> (Vec<(Batch<'_>, Range<u32>)>, u64) {
    let mut parts = Vec::new();
    let mut first = 0;
    for batch in batches {
        let copies = u64::from(batch.copies());
        let all = batch.triangles().end;
        // Copies are drawn together: each triangle of the mesh as often as there are copies.
        let before = |end: u64| {
            let before = end.saturating_sub(first).div_ceil(copies);
            before.min(u64::from(all)) as u32
        };
        let part = before(triangles.start)..before(triangles.end);
        first += u64::from(all) * copies;
        if !part.is_empty() {
            parts.push((batch, part));
        }
    }
    (parts, first)
}
