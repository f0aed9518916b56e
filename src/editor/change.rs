use crate::scene::{Scene, ShapeId};

/// What an edit or a gesture changed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Change {
    /// Whether another scene took the place of the one before: all ids are new, though their
    /// numbers may have been in use.
    pub opened: bool,
    /// Shapes that were not there before, in the order of the scene.
    pub added: Vec<ShapeId>,
    /// Shapes that are there no more, in the order of the scene before.
    pub removed: Vec<ShapeId>,
    /// Shapes that were there before and differ now, in the order of the scene.
    pub altered: Vec<ShapeId>,
}

impl Change {
    /// The change by which a scene is opened in the place of any other.
    pub(super) fn opened(scene: &Scene) -> Self {
        Self {
            opened: true,
            added: scene.shapes().iter().map(|shape| shape.id).collect(),
            ..Self::default()
        }
    }

    /// The change from one state of a scene to a later one.
    pub fn between(before: &Scene, after: &Scene) -> Self {
        let mut change = Self::default();
        for shape in after.shapes() {
            match before.shape(shape.id) {
                None => change.added.push(shape.id),
                Some(was) if was != shape => change.altered.push(shape.id),
                Some(_) => {}
            }
        }
        let gone = |id: &ShapeId| after.shape(*id).is_none();
        let shapes = before.shapes().iter();
        change.removed = shapes.map(|shape| shape.id).filter(gone).collect();
        change
    }

    /// Whether everything is as it was.
    pub fn is_nothing(&self) -> bool {
        *self == Self::default()
    }
}
