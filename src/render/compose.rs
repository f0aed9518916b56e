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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{Backend, HeadlessContext};

    #[test]
    fn the_view_s_rectangle_is_in_pixels_from_the_bottom_left_and_inside_of_the_picture() {
        let place = view_place((10.0, 20.0), (110.0, 70.0), 2.0, (400, 300));
        assert_eq!(place, rect(20, 160, 200, 100));
        let place = view_place((-5.0, 10.0), (350.0, 900.0), 1.0, (400, 300));
        assert_eq!(place, rect(0, 0, 350, 290));
        let folded = view_place((30.0, 30.0), (30.0, 30.0), 1.0, (400, 300));
        assert_eq!((folded.width, folded.height), (1, 1));
    }

    #[test]
    fn the_scene_is_put_in_its_place_and_the_rest_is_black() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = context.gl();
        let [scene, target] = [(2, 2), (8, 6)].map(|(w, h)| Framebuffer::new(gl, w, h, 0).unwrap());
        scene.clear([0.0, 1.0, 0.0, 1.0]);
        target.clear([1.0; 4]);
        let mut painter = InterfacePainter::new(gl).unwrap();
        let egui = egui::Context::default();
        let output = egui.run_ui(egui::RawInput::default(), |_| {});
        let place = rect(1, 0, 3, 2);
        compose(&scene, place, &mut painter, &egui, output, &target).unwrap();
        let pixels = target.read_rgba().unwrap();
        for (index, pixel) in pixels.chunks_exact(4).enumerate() {
            let (x, y) = (index % 8, index / 8);
            // Rows count from the top.
            let green = (1..4).contains(&x) && y >= 4;
            let expected = if green {
                [0, 255, 0, 255]
            } else {
                [0, 0, 0, 255]
            };
            assert_eq!(pixel, expected, "at {x}, {y}");
        }
    }

    fn rect(x: i32, y: i32, width: i32, height: i32) -> Rect {
        Rect {
            x,
            y,
            width,
            height,
        }
    }
}
