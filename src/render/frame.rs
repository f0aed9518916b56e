use crate::scene::{Evaluated, EvaluatedShape, Scene, Shape, ShapeId, ViewSettings};
use glam::Mat4;

/// Everything a picture depends on: the same frame gives the same picture.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// What there is.
    pub scene: &'a Scene,
    /// What follows from it; must have been evaluated from `scene`.
    pub evaluated: &'a Evaluated,
    /// How it is looked at.
    pub view: &'a ViewSettings,
    /// What an editor marks; nothing in a picture to hand in.
    pub marks: Marks,
}

impl<'a> Frame<'a> {
    /// The shapes that are drawn.
    pub(super) fn shapes(&self) -> impl Iterator<Item = (&'a Shape, &'a EvaluatedShape)> {
        let shapes = self.scene.shapes().iter().zip(&self.evaluated.shapes);
        shapes.filter(|(_, evaluated)| evaluated.visible)
    }
}

/// What the editor shows on top of the scene to its user.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// The selected shape.
    pub selected: Option<ShapeId>,
    /// The shape under the pointer.
    pub hovered: Option<ShapeId>,
    /// The selected joint of the selected shape.
    pub selected_joint: Option<usize>,
    /// The joint of the selected shape that the pointer is over.
    pub hovered_joint: Option<usize>,
    /// The control point of the selected shape that the pointer is over: the indices of its curve
    /// in the [`crate::scene::CurveSet`] and of the point in the curve.
    pub hovered_control_point: Option<(usize, usize)>,
}

/// What all passes of one picture share.
#[derive(Clone, Copy, Debug)]
pub(super) struct PassContext {
    pub width: u32,
    pub height: u32,
    pub clip_from_world: Mat4,
    /// How high the Studio look's ground lies, in the world.
    pub ground: f32,
}
