//! Uploads of shapes that are kept while the shape stays the same.

use super::frame::Frame;
use crate::gpu::GpuError;
use crate::scene::{Evaluated, Shape, ShapeId};
use std::collections::{HashMap, HashSet};

/// One upload a shape. `K` is what determines its content. An upload that the driver refused is not
/// tried again until its key changes.
#[derive(Debug)]
pub(super) struct UploadCache<K, T> {
    uploads: HashMap<ShapeId, (K, Result<T, GpuError>)>,
}

impl<K, T> Default for UploadCache<K, T> {
    fn default() -> Self {
        let uploads = HashMap::new();
        Self { uploads }
    }
}

impl<K: PartialEq, T> UploadCache<K, T> {
    /// Drops the uploads of shapes that are no longer in the scene.
    pub fn forget_deleted(&mut self, evaluated: &Evaluated) {
        let present: HashSet<ShapeId> = evaluated.shapes.iter().map(|shape| shape.id).collect();
        self.uploads.retain(|id, _| present.contains(id));
    }

    /// Calls `refresh` on the upload of a shape if it has this key; otherwise drops it and calls
    /// `upload`. A failure of either is kept as a refusal.
    pub fn update(
        &mut self,
        id: ShapeId,
        key: K,
        refresh: impl FnOnce(&mut T) -> Result<(), GpuError>,
        upload: impl FnOnce() -> Result<T, GpuError>,
    ) {
        let kept = self.uploads.remove(&id).filter(|(known, _)| *known == key);
        let upload = match kept {
            Some((_, Ok(mut kept))) => refresh(&mut kept).map(|()| kept),
            Some((_, refused)) => refused,
            None => upload(),
        };
        self.uploads.insert(id, (key, upload));
    }

    /// Whether there is an upload of a shape with this key, or it was refused.
    pub fn has(&self, id: ShapeId, key: &K) -> bool {
        self.uploads.get(&id).is_some_and(|(known, _)| known == key)
    }

    /// The upload of a shape, unless it was refused.
    pub fn get(&self, id: ShapeId) -> Option<&T> {
        self.uploads.get(&id)?.1.as_ref().ok()
    }

    /// The same, to be changed.
    pub fn get_mut(&mut self, id: ShapeId) -> Option<&mut T> {
        self.uploads.get_mut(&id)?.1.as_mut().ok()
    }

    /// Whether the upload of a shape was refused.
    pub fn is_refused(&self, id: ShapeId) -> bool {
        (self.uploads.get(&id)).is_some_and(|(_, upload)| upload.is_err())
    }

    /// Why the upload of a shape was refused, if it was. It is forgotten, and so tried again.
    pub fn take_refusal(&mut self, id: ShapeId) -> Option<GpuError> {
        self.uploads.get(&id)?.1.as_ref().err()?;
        self.uploads.remove(&id)?.1.err()
    }

    /// The visible shapes whose uploads were refused, with the reasons.
    pub fn refused<'a>(
        &'a self,
        frame: &Frame<'a>,
    ) -> impl Iterator<Item = (&'a Shape, &'a GpuError)> {
        frame.shapes().filter_map(|(shape, _)| {
            let why = self.uploads.get(&shape.id)?.1.as_ref().err()?;
            Some((shape, why))
        })
    }
}
