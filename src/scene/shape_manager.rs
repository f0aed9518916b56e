use super::{CharacterShape, CurveShape, NewShape, Shape, ShapeId, ShapeKind};
use std::collections::HashSet;

/// Scene: the list of shapes, in the order in which they are drawn, listed and written.
#[derive(Clone, Debug)]
#[doc(alias = "ShapeManager")]
pub struct Scene {
    shapes: Vec<Shape>,
    next_id: u32,
}

/// Scenes with equal shapes are equal, whichever identifiers were in use before.
impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.shapes == other.shapes
    }
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            shapes: Vec::new(),
            next_id: 1,
        }
    }
}

impl Scene {
    /// An empty scene.
    pub fn new() -> Self {
        Self::default()
    }

    /// Shapes, in the order of the list.
    pub fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// Shape of this identifier.
    pub fn shape(&self, id: ShapeId) -> Option<&Shape> {
        self.shapes.iter().find(|shape| shape.id == id)
    }

    /// Shape of this identifier, to be changed.
    pub fn shape_mut(&mut self, id: ShapeId) -> Option<&mut Shape> {
        self.shapes.iter_mut().find(|shape| shape.id == id)
    }

    /// Shape of this identifier, if it is a character.
    pub fn character(&self, id: ShapeId) -> Option<&CharacterShape> {
        match &self.shape(id)?.kind {
            ShapeKind::Character(character) => Some(character),
            _ => None,
        }
    }

    /// Shape of this identifier, if it is a character, to be changed.
    pub fn character_mut(&mut self, id: ShapeId) -> Option<&mut CharacterShape> {
        match &mut self.shape_mut(id)?.kind {
            ShapeKind::Character(character) => Some(character),
            _ => None,
        }
    }

    /// Shape of this identifier, if it is made of curves.
    pub fn curve(&self, id: ShapeId) -> Option<&CurveShape> {
        match &self.shape(id)?.kind {
            ShapeKind::Curve(curve) => Some(curve),
            _ => None,
        }
    }

    /// Shape of this identifier, if it is made of curves, to be changed.
    pub fn curve_mut(&mut self, id: ShapeId) -> Option<&mut CurveShape> {
        match &mut self.shape_mut(id)?.kind {
            ShapeKind::Curve(curve) => Some(curve),
            _ => None,
        }
    }

    /// Appends a shape and returns its new identifier.
    pub fn add(&mut self, new: NewShape) -> ShapeId {
        let id = ShapeId(self.next_id);
        self.next_id += 1;
        self.shapes.push(Shape {
            id,
            name: new.name,
            kind: new.kind,
            source: new.source,
            start: new.start,
            placement: new.placement,
            visible: new.visible,
            locked: new.locked,
        });
        id
    }

    /// Removes a shape and returns it. Its identifier is not used again.
    pub fn delete(&mut self, id: ShapeId) -> Option<Shape> {
        let index = self.shapes.iter().position(|shape| shape.id == id)?;
        Some(self.shapes.remove(index))
    }

    /// Moves a shape in the list to `index`, or to its end if that is beyond it.
    pub fn move_in_list(&mut self, id: ShapeId, index: usize) {
        if let Some(from) = self.shapes.iter().position(|shape| shape.id == id) {
            let shape = self.shapes.remove(from);
            self.shapes.insert(index.min(self.shapes.len()), shape);
        }
    }

    /// Returns to an earlier or later state of this scene. Identifiers that were in use since are
    /// not used again.
    pub fn go_to(&mut self, state: &Self) {
        self.shapes.clone_from(&state.shapes);
        self.next_id = self.next_id.max(state.next_id);
    }

    /// Whether it is as an earlier state of it, and no shape was added in between: one that was and is gone
    /// again may still be wanted.
    pub fn is_back_at(&self, earlier: &Self) -> bool {
        self.next_id == earlier.next_id && self.shapes == earlier.shapes
    }

    /// Estimated memory in bytes. Data that states of a scene share counts once: `counted` holds
    /// the addresses of what has been counted already.
    pub fn memory(&self, counted: &mut HashSet<usize>) -> usize {
        self.shapes.iter().map(|shape| shape.memory(counted)).sum()
    }

    /// Restores the placement and color that the shape started with, and the bind pose of a
    /// character.
    pub fn reset(&mut self, id: ShapeId) {
        if let Some(shape) = self.shape_mut(id) {
            shape.placement = shape.start;
            if let ShapeKind::Character(character) = &mut shape.kind {
                character.reset_pose();
            }
        }
    }
}

impl Extend<NewShape> for Scene {
    fn extend<I: IntoIterator<Item = NewShape>>(&mut self, shapes: I) {
        for shape in shapes {
            self.add(shape);
        }
    }
}

impl FromIterator<NewShape> for Scene {
    fn from_iter<I: IntoIterator<Item = NewShape>>(shapes: I) -> Self {
        let mut scene = Self::new();
        scene.extend(shapes);
        scene
    }
}

/// Name of an imported shape: the stem of its file, first letter in upper, the rest in lower case.
pub fn name_of_import(stem: &str) -> String {
    let mut letters = stem.chars();
    match letters.next() {
        Some(first) => first
            .to_uppercase()
            .chain(letters.flat_map(char::to_lowercase))
            .collect(),
        None => "Shape".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_count_from_1_and_are_not_used_again() {
        let mut scene = Scene::new();
        let first = scene.add(NewShape::new("Cube", ShapeKind::Cube));
        assert_eq!(first, ShapeId(1));
        scene.delete(first);
        assert_eq!(
            scene.add(NewShape::new("Cube", ShapeKind::Cube)),
            ShapeId(2)
        );
    }

    #[test]
    fn imports_are_named_by_the_stem_first_letter_upper_rest_lower() {
        assert_eq!(name_of_import("myTeaPot"), "Myteapot");
        assert_eq!(name_of_import("MODEL1"), "Model1");
        assert_eq!(name_of_import(""), "Shape");
    }
}
