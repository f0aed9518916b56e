//! The picture of the scene and the panels over it, in one.

use super::InterfacePainter;
use crate::gpu::{Framebuffer, GpuError, Rect};

/// Puts a picture of the scene into `target` at `place` (pixels from the bottom left) and paints
/// the panels over it, as in the window and in pictures with panels. A picture of another size is
/// scaled.
///
/// # Errors
/// When `target` has samples.
pub fn compose(
    scene: &Framebuffer,
    place: Rect,
    painter: &mut InterfacePainter,
    context: &egui::Context,
    output: egui::FullOutput,
    target: &Framebuffer,
) -> Result<(), GpuError> {
    target.clear([0.0, 0.0, 0.0, 1.0]);
    let whole = Rect {
        x: 0,
        y: 0,
        width: scene.width() as i32,
        height: scene.height() as i32,
    };
    let placed = scene.blit_into(target, whole, place);
    painter.paint(context, output, target);
    placed
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
