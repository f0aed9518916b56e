//! The picture of the scene and the panels over it, in one.

use super::InterfacePainter;
use super::area::Area;
use super::changed_shapes::ChangedShapes;
use crate::gpu::{Framebuffer, GpuError, Rect};
use egui::epaint::ClippedShape;

/// Puts pictures of the scene and the panels over them into one, as in the window and in pictures with
/// panels, and paints again only the parts in which something has changed: most frames of a window have
/// a new picture of the scene or a few new numbers, and all the rest as in the one before.
#[derive(Debug, Default)]
pub struct Composer {
    /// What is in the picture; `None` if nothing is known of it.
    shown: Option<Shown>,
}

/// What a picture shows beside the scene.
#[derive(Debug)]
struct Shown {
    /// The scene's.
    place: Rect,
    pixels_per_point: f32,
    shapes: Vec<ClippedShape>,
}

/// Picture of a scene, and its place in the whole in pixels from the bottom left; it is scaled to fit.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// The picture.
    pub scene: &'a Framebuffer,
    /// Whether it was drawn anew since it was composed last.
    pub is_new: bool,
    /// Its place.
    pub place: Rect,
}

impl Composer {
    /// Has all be painted with the next picture, as if this were another target.
    pub fn forget(&mut self) {
        self.shown = None;
    }

    /// Puts a picture of the scene into `target` and paints the panels over it. Returns whether anything
    /// had to be painted. `target` is the same as the last time, or [`Composer::forget`] was called.
    ///
    /// # Errors
    /// When `target` has samples.
    pub fn compose(
        &mut self,
        placed: Placed,
        painter: &mut InterfacePainter,
        context: &egui::Context,
        output: egui::FullOutput,
        target: &Framebuffer,
    ) -> Result<bool, GpuError> {
        let Placed { scene, place, .. } = placed;
        let now = Shown {
            place,
            pixels_per_point: output.pixels_per_point,
            shapes: output.shapes.clone(),
        };
        let is_to_scale = (scene.width(), scene.height())
            == (place.width.unsigned_abs(), place.height.unsigned_abs());
        // Letters may have gone elsewhere in a texture.
        let may_stay = is_to_scale && output.textures_delta.is_empty();
        let before = self.shown.take().filter(|before| {
            let is_there = before.place == place;
            may_stay && is_there && before.pixels_per_point == now.pixels_per_point
        });
        let areas = before.and_then(|before| {
            let size = [target.width(), target.height()];
            // A view that is folded away has a pixel that may be beyond the picture.
            let view = area_of(place).within(Area::whole(size));
            let view = placed.is_new.then_some(view);
            let changed = ChangedShapes::between(&before.shapes, &now.shapes);
            changed.areas(context, now.pixels_per_point, size, view)
        });
        let mut composed = Ok(());
        if let Some(areas) = &areas {
            for &area in areas {
                composed = composed.and(paint_area(placed, painter, context, &now, area, target));
            }
        } else {
            target.clear(BEHIND);
            composed = scene.blit_into(target, scene.rect(), place);
            painter.paint(context, output, target);
        }
        self.shown = Some(now);
        composed.map(|()| areas.is_none_or(|areas| !areas.is_empty()))
    }
}

/// Color where neither scene nor panels are.
const BEHIND: [f32; 4] = [0.0, 0.0, 0.0, 1.0];

/// Pixels, at least, by which smooth edges reach beyond shapes: egui's are one wide.
const SMOOTH_EDGE: f32 = 2.0;

/// Composes a part of a picture anew.
fn paint_area(
    Placed { scene, place, .. }: Placed,
    painter: &mut InterfacePainter,
    context: &egui::Context,
    now: &Shown,
    area: Area,
    target: &Framebuffer,
) -> Result<(), GpuError> {
    let seen = area.within(area_of(place));
    if seen != area {
        target.clear_area(rect_of(area), BEHIND);
    }
    let mut composed = Ok(());
    if !seen.is_empty() {
        let seen = rect_of(seen);
        let source = Rect {
            x: seen.x - place.x,
            y: seen.y - place.y,
            ..seen
        };
        composed = scene.blit_into(target, source, seen);
    }
    let ([left, bottom], [right, top]) = (area.first, area.end);
    let point =
        |x: u32, y: u32| egui::pos2(x as f32, (target.height() - y) as f32) / now.pixels_per_point;
    let clip = egui::Rect::from_min_max(point(left, top), point(right, bottom));
    // egui leaves out shapes beyond where they are clipped, though their smooth edges reach into it.
    let near = clip.expand(SMOOTH_EDGE / now.pixels_per_point);
    let shapes = now.shapes.iter().filter_map(|shape| {
        let clip_rect = shape.clip_rect.intersect(near);
        clip_rect.is_positive().then(|| ClippedShape {
            clip_rect,
            shape: shape.shape.clone(),
        })
    });
    let shapes = (shapes.collect(), clip);
    painter.paint_again(context, shapes, now.pixels_per_point, target);
    composed
}

/// The pixels of a rectangle whose corner is none left of or below a picture.
fn area_of(rect: Rect) -> Area {
    let [x, y, right, top] = [rect.x, rect.y, rect.x + rect.width, rect.y + rect.height];
    let first = [x, y].map(i32::unsigned_abs);
    let end = [right, top].map(i32::unsigned_abs);
    Area { first, end }
}

fn rect_of(area: Area) -> Rect {
    let [x, y, width, height] = area.rectangle();
    Rect {
        x,
        y,
        width,
        height,
    }
}

/// Rectangle of the view in a picture, in whole pixels, from its corners in the interface, in points
/// from the top left.
pub fn view_place(
    (min_x, min_y): (f32, f32),
    (max_x, max_y): (f32, f32),
    pixels_per_point: f32,
    (width, height): (u32, u32),
) -> Rect {
    let pixel = |points: f32, limit: u32| {
        ((points * pixels_per_point).round() as i64).clamp(0, i64::from(limit)) as i32
    };
    let (left, right) = (pixel(min_x, width), pixel(max_x, width));
    let (top, bottom) = (pixel(min_y, height), pixel(max_y, height));
    Rect {
        x: left,
        y: height as i32 - bottom,
        width: (right - left).max(1),
        height: (bottom - top).max(1),
    }
}
