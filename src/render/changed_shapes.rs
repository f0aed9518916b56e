//! The shapes of the panels that changed from one frame to the next, and where they are.

use super::area::Area;
use egui::epaint::{ClippedShape, Primitive};

/// Changed shapes up to which it is worth finding out where they are.
const MOST: usize = 200;

/// Pixels by which rounding may move an edge.
const ROUNDING: f32 = 1.0;

/// The shapes of two frames that are not in both at one place in the order in which they are painted.
#[derive(Debug)]
pub(super) struct ChangedShapes<'a>(Vec<&'a ClippedShape>);

impl<'a> ChangedShapes<'a> {
    pub fn between(before: &'a [ClippedShape], now: &'a [ClippedShape]) -> Self {
        // What was inserted, such as a tooltip, moves all that comes after it.
        let pairs = before.iter().zip(now);
        let first = pairs.take_while(|(before, now)| before == now).count();
        let (before, now) = (&before[first..], &now[first..]);
        let pairs = before.iter().rev().zip(now.iter().rev());
        let last = pairs.take_while(|(before, now)| before == now).count();
        let (before, now) = (&before[..before.len() - last], &now[..now.len() - last]);
        if before.len() != now.len() {
            return Self(before.iter().chain(now).collect());
        }
        let pairs = before.iter().zip(now);
        let changed = pairs.filter(|(before, now)| before != now);
        Self(changed.flat_map(|(before, now)| [before, now]).collect())
    }

    /// The areas of a picture of `size` pixels outside of which it stays as it is: the `view`, if that has
    /// changed as a whole, and one with all shapes that are not in it. `None` if it is not worth leaving out
    /// anything.
    pub fn areas(
        &self,
        context: &egui::Context,
        pixels_per_point: f32,
        size: [u32; 2],
        view: Option<Area>,
    ) -> Option<Vec<Area>> {
        if self.0.len() > MOST {
            return None;
        }
        let shapes = self.0.iter();
        let places = shapes.map(|shape| pixels_of(context, shape, pixels_per_point, size));
        let is_beside = |area: &Area| view.is_none_or(|view| area.within(view) != *area);
        let beside = places.filter(is_beside).fold(Area::EMPTY, Area::union);
        let areas = view.into_iter().chain([beside]);
        let areas: Vec<Area> = areas.filter(|area| !area.is_empty()).collect();
        let changed: u64 = areas.iter().map(Area::pixels).sum();
        (changed < Area::whole(size).pixels()).then_some(areas)
    }
}

/// The pixels that a shape may cover. Its triangles tell: its bounds leave out corners of thick lines.
fn pixels_of(
    context: &egui::Context,
    shape: &ClippedShape,
    pixels_per_point: f32,
    size: [u32; 2],
) -> Area {
    let triangles = context.tessellate(vec![shape.clone()], pixels_per_point);
    let bounds = triangles.iter().map(|part| match &part.primitive {
        Primitive::Mesh(mesh) => mesh.calc_bounds(),
        Primitive::Callback(_) => egui::Rect::NOTHING,
    });
    let bounds = bounds.fold(egui::Rect::NOTHING, egui::Rect::union);
    let bounds = bounds.intersect(shape.clip_rect);
    if !bounds.is_positive() {
        return Area::EMPTY;
    }
    let bounds = (bounds * pixels_per_point).expand(ROUNDING);
    // Numbers beyond the range of integers become the nearest in it.
    let [right, bottom] = [bounds.max.x.ceil() as u32, bounds.max.y.ceil() as u32];
    let [left, top] = [bounds.min.x as u32, bounds.min.y as u32];
    let [width, height] = size;
    Area {
        first: [left, height.saturating_sub(bottom)],
        end: [right.min(width), height.saturating_sub(top)],
    }
}
