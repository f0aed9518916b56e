//! What an editor shows of meshes besides themselves: numbers of their vertices, and other meshes with
//! them.

use crate::character::Character;
use crate::scene::{CharacterNumber, EvaluatedGeometry, ShapeId, VertexNumbers};
use glam::{Mat4, Vec3};
use std::sync::Arc;

/// A shape whose mesh is drawn in the colors of numbers, in place of its own.
#[derive(Clone, Debug)]
pub struct ShapeNumbers {
    /// The shape.
    pub shape: ShapeId,
    /// The numbers, one for each position of its mesh.
    pub numbers: Arc<VertexNumbers>,
}

impl ShapeNumbers {
    /// The numbers of characters, each with its shape, all on one scale.
    pub fn on_one_scale<'a>(
        of: impl IntoIterator<Item = (ShapeId, CharacterNumber, &'a Character)>,
    ) -> Vec<Self> {
        let of = of.into_iter();
        let (shapes, of): (Vec<_>, Vec<_>) = of
            .map(|(shape, number, character)| (shape, (number, character)))
            .unzip();
        let numbers = CharacterNumber::on_one_scale(of).into_iter().map(Arc::new);
        let pairs = shapes.into_iter().zip(numbers);
        pairs
            .map(|(shape, numbers)| Self { shape, numbers })
            .collect()
    }
}

impl PartialEq for ShapeNumbers {
    fn eq(&self, other: &Self) -> bool {
        self.shape == other.shape && Arc::ptr_eq(&self.numbers, &other.numbers)
    }
}

/// A mesh that is drawn beside those of the scene. It casts no shadow.
#[derive(Clone, Debug)]
pub struct Ghost {
    /// The mesh, which nothing deforms.
    pub geometry: Arc<EvaluatedGeometry>,
    /// Transform from its model space to the world.
    pub world_from_model: Mat4,
    /// How it is drawn.
    pub paint: GhostPaint,
}

impl PartialEq for Ghost {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.geometry, &other.geometry)
            && self.world_from_model == other.world_from_model
            && self.paint == other.paint
    }
}

/// How a [`Ghost`] is drawn.
#[derive(Clone, Debug)]
pub enum GhostPaint {
    /// Seen through, in one color. Where it lies on a mesh of the scene, that is seen.
    Translucent(Vec3),
    /// Opaque, in the colors of one number for each position.
    Numbers(Arc<VertexNumbers>),
}

impl PartialEq for GhostPaint {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Translucent(a), Self::Translucent(b)) => a == b,
            (Self::Numbers(a), Self::Numbers(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}
