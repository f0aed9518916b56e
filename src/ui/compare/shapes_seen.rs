//! Shapes in view, as they lie in its picture.

use crate::editor::Session;
use crate::scene::{Camera, EvaluatedShape, ShapeId, ShapeKind};
use glam::Vec2;

/// Pixels in the box around a shape of which it is found out whether the shape is there, …
const PROBED: usize = 64;
/// … and the share of them from which on the shape differs, and not only what was behind or before it.
const SHOWS: f64 = 0.3;

/// A visible shape, and the box around it in the picture.
pub(super) struct ShapeSeen<'a> {
    pub id: ShapeId,
    pub name: &'a str,
    pub is_character: bool,
    /// Whether it is a curve or its surface, which may be drawn as lines.
    pub is_curve: bool,
    evaluated: &'a EvaluatedShape,
    pub least: Vec2,
    pub most: Vec2,
}

impl ShapeSeen<'_> {
    /// 1 in the box, as far as a limb reaches, so that a pixel is a limb's where there is one.
    pub fn distance(&self, pixel: Vec2) -> f32 {
        1.0 + pixel.distance(pixel.clamp(self.least, self.most))
    }

    /// Whether many of such pixels in the box show the shape.
    pub fn shows_at(&self, pixels: &[Vec2], session: &Session, size: Vec2) -> bool {
        let inside = pixels.iter().filter(|pixel| self.distance(**pixel) <= 1.0);
        let step = inside.clone().count().div_ceil(PROBED).max(1);
        let probed: Vec<&Vec2> = inside.step_by(step).collect();
        let camera = &session.view().camera;
        let is_met = |pixel: &&&Vec2| self.evaluated.is_met_by(&camera.ray(***pixel, size));
        let met = probed.iter().filter(is_met).count();
        met as f64 > SHOWS * probed.len() as f64
    }
}

/// The shapes without bones, and these `characters`. None where a shape is alone: what differs is it, then.
pub(super) fn shapes_seen<'a>(
    session: &'a Session,
    size: Vec2,
    characters: &[ShapeId],
) -> Vec<ShapeSeen<'a>> {
    let (scene, evaluated) = (session.scene(), session.evaluated());
    let camera = &session.view().camera;
    let visible = || scene.shapes().iter().filter(|shape| shape.visible);
    if visible().count() < 2 {
        return Vec::new();
    }
    let seen = visible().filter_map(|shape| {
        let is_character = scene.character(shape.id).is_some();
        if is_character && !characters.contains(&shape.id) {
            return None;
        }
        let evaluated = evaluated.shape(shape.id)?;
        let [least, most] = box_of(evaluated, camera, size)?;
        Some(ShapeSeen {
            id: shape.id,
            name: &shape.name,
            is_character,
            is_curve: matches!(shape.kind, ShapeKind::Curve(_)),
            evaluated,
            least,
            most,
        })
    });
    seen.collect()
}

/// The upper left and the lower right corner of the box round a shape, in a picture of `size` pixels; `None` of one that reaches
/// behind the camera, which is everywhere.
pub(super) fn box_of(shape: &EvaluatedShape, camera: &Camera, size: Vec2) -> Option<[Vec2; 2]> {
    let corners = shape.world_box().corners().into_iter();
    let pixels = corners.map(|corner| camera.pixel(corner, size));
    let pixels = pixels.collect::<Option<Vec<Vec2>>>()?.into_iter();
    Some([pixels.clone().reduce(Vec2::min)?, pixels.reduce(Vec2::max)?])
}
