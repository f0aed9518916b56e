//! What a picture is made from: the scene as it is seen, and the marks of an editor over it.

use super::backdrop::{Backdrop, Colors};
use super::number_marks::{Ghost, ShapeNumbers};
use super::tile::Tile;
use crate::scene::{Evaluated, EvaluatedShape, Scene, Shape, ShapeId, VertexNumbers, ViewSettings};
use glam::Mat4;
use std::sync::Arc;

/// Everything that a picture depends on: the same frame gives the same picture.
#[derive(Clone, Debug)]
pub struct Frame<'a> {
    /// The shapes.
    pub scene: &'a Scene,
    /// The evaluation of `scene`.
    pub evaluated: &'a Evaluated,
    /// Camera, look and shading.
    pub view: &'a ViewSettings,
    /// Brightness of what is behind the shapes, where the look leaves a choice.
    pub backdrop: Backdrop,
    /// Marks of an editor; none in a picture of the scene alone.
    pub marks: Marks,
}

impl<'a> Frame<'a> {
    /// A picture of the scene alone, without the marks of an editor, before the default backdrop.
    pub fn plain(scene: &'a Scene, evaluated: &'a Evaluated, view: &'a ViewSettings) -> Self {
        Self {
            scene,
            evaluated,
            view,
            backdrop: Backdrop::default(),
            marks: Marks::default(),
        }
    }

    /// The visible shapes, but for one that another mesh takes the place of.
    pub(crate) fn shapes(&self) -> impl Iterator<Item = (&'a Shape, &'a EvaluatedShape)> {
        let shapes = self.scene.shapes().iter().zip(&self.evaluated.shapes);
        shapes
            .filter(|(shape, evaluated)| evaluated.visible && self.marks.replaced != Some(shape.id))
    }
}

/// Marks that an editor draws over the scene for its user.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// The selected shape; of several the active one.
    pub selected: Option<ShapeId>,
    /// All other selected shapes.
    pub also_selected: Vec<ShapeId>,
    /// The shape under the pointer.
    pub hovered: Option<ShapeId>,
    /// The selected joint of the selected shape.
    pub selected_joint: Option<usize>,
    /// The joint of the selected shape that the pointer is over.
    pub hovered_joint: Option<usize>,
    /// The control point of the selected shape that the pointer is over: the indices of its curve
    /// in the [`crate::scene::CurveSet`] and of the point in the curve.
    pub hovered_control_point: Option<(usize, usize)>,
    /// Shapes whose meshes are drawn in the colors of numbers.
    pub numbers: Vec<ShapeNumbers>,
    /// Meshes that are drawn beside those of the scene.
    pub ghosts: Vec<Ghost>,
    /// A shape that is not drawn, since a ghost takes its place.
    pub replaced: Option<ShapeId>,
}

impl Marks {
    /// The numbers that a shape is colored by, if it is.
    pub(super) fn numbers_of(&self, shape: ShapeId) -> Option<&Arc<VertexNumbers>> {
        let mut all = self.numbers.iter();
        let own = all.find(|numbers| numbers.shape == shape);
        own.map(|own| &own.numbers)
    }

    /// Whether meshes are drawn otherwise than the scene has them.
    pub(super) fn change_meshes(&self) -> bool {
        !(self.numbers.is_empty() && self.ghosts.is_empty())
    }
}

/// Values that all passes of one picture share.
#[derive(Clone, Copy, Debug)]
pub(super) struct PassContext {
    /// Width of the tile, in pixels.
    pub width: u32,
    /// Height of the tile, in pixels.
    pub height: u32,
    /// The part of the picture that is drawn.
    pub tile: Tile,
    pub background: Background,
    /// From the world to the tile's clip space.
    pub clip_from_world: Mat4,
    /// Height of the Studio look's ground in the world, and the highest at which the Mannequin look's floor is.
    pub ground: f32,
    /// Colors of the background and of marks before it.
    pub colors: &'static Colors,
}

/// What is drawn behind the shapes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Background {
    /// The background of the look, and its ground or floor.
    #[default]
    Look,
    /// Nothing: the picture is transparent there. Of the Studio look's ground only the shadows are
    /// drawn. Colors are multiplied by alpha.
    Transparent,
}

/// Whether the look has a ground with lines, which is seen.
pub(super) fn has_ground(frame: &Frame) -> bool {
    frame.view.has_ground()
}
