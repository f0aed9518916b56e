//! What a picture of the scene follows from.

use super::scene_picture::Asked;
use crate::render::{Backdrop, Marks};
use crate::revision::Revision;
use crate::scene::{Evaluated, ViewSettings};

/// State that a picture of the scene follows from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SceneKey {
    document: Revision,
    /// Geometry of each shape, which is not the document's while the view shows another one.
    geometry: Vec<Revision>,
    /// The same at the right of a line, and the column of the line, while the view is split.
    right: Option<(Vec<Revision>, i32)>,
    view: ViewSettings,
    backdrop: Backdrop,
    marks: Marks,
}

impl SceneKey {
    /// That of a picture of `asked`, at the `right` of a column with another evaluation of the scene.
    pub fn of(asked: &Asked, right: Option<(&Evaluated, i32)>) -> Self {
        let frame = asked.frame;
        Self {
            document: asked.document,
            geometry: revisions(frame.evaluated),
            right: right.map(|(evaluated, column)| (revisions(evaluated), column)),
            view: *frame.view,
            backdrop: frame.backdrop,
            marks: frame.marks.clone(),
        }
    }

    /// The same without the marks that are lines round shapes and nothing else.
    pub fn without_outlines(&self) -> Self {
        let mut key = self.clone();
        key.marks.hovered = None;
        key.marks.also_selected.clear();
        key
    }
}

/// Revisions of the geometry of each shape.
fn revisions(evaluated: &Evaluated) -> Vec<Revision> {
    let shapes = evaluated.shapes.iter();
    shapes.map(|shape| shape.geometry.revision).collect()
}
