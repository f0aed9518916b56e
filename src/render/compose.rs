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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{Backend, HeadlessContext};
    use proptest::prelude::*;

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
        let placed = Placed {
            scene: &scene,
            is_new: true,
            place: rect(1, 0, 3, 2),
        };
        let mut composer = Composer::default();
        let composed = composer.compose(placed, &mut painter, &egui, output, &target);
        assert!(composed.unwrap());
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

    /// One thing that panels paint.
    #[derive(Clone, Debug, PartialEq)]
    struct Painted {
        at: (f32, f32),
        size: (f32, f32),
        kind: u8,
        color: [u8; 4],
        /// Where it may be seen.
        clip: (f32, f32),
    }

    impl Painted {
        fn paint(&self, ui: &egui::Ui) {
            let [r, g, b, a] = self.color;
            let color = egui::Color32::from_rgba_unmultiplied(r, g, b, a);
            let (at, size) = (egui::Pos2::from(self.at), egui::Vec2::from(self.size));
            let place = egui::Rect::from_min_size(at, size);
            let whole = ui.ctx().content_rect();
            let clip = egui::Rect::from_min_max(egui::pos2(self.clip.0, self.clip.1), whole.max);
            let painter = ui.painter().with_clip_rect(clip);
            let stroke = egui::Stroke::new(size.x * 0.1, color);
            match self.kind {
                0 => drop(painter.rect_filled(place, 3.0, color)),
                1 => drop(painter.circle_stroke(at, size.y, stroke)),
                2 => drop(painter.line_segment([at, at + size], stroke)),
                _ => {
                    let font = egui::FontId::proportional(12.0);
                    painter.text(at, egui::Align2::LEFT_TOP, "12.5°", font, color);
                }
            }
        }
    }

    fn painted() -> impl Strategy<Value = Painted> {
        let at = (-10.0..110.0_f32, -10.0..80.0_f32);
        let size = (1.0..60.0_f32, 1.0..40.0_f32);
        let clip = (0.0..80.0_f32, 0.0..50.0_f32);
        (at, size, 0..4_u8, any::<[u8; 4]>(), clip).prop_map(|(at, size, kind, color, clip)| {
            Painted {
                at,
                size,
                kind,
                color,
                clip,
            }
        })
    }

    /// What changes from one frame to the next.
    #[derive(Clone, Debug)]
    enum Step {
        Nothing,
        Scene([f32; 3]),
        Insert(usize, Painted),
        Remove(usize),
        Replace(usize, Painted),
    }

    fn steps() -> impl Strategy<Value = Vec<Step>> {
        let step = prop_oneof![
            1 => Just(Step::Nothing),
            2 => prop::array::uniform3(0.0..1.0_f32).prop_map(Step::Scene),
            1 => (0..9_usize, painted()).prop_map(|(at, it)| Step::Insert(at, it)),
            1 => (0..9_usize).prop_map(Step::Remove),
            3 => (0..9_usize, painted()).prop_map(|(at, it)| Step::Replace(at, it)),
        ];
        let several = proptest::collection::vec(step, 0..3);
        let frames = proptest::collection::vec(several, 2..8);
        frames.prop_map(|frames| frames.concat())
    }

    /// What differs between pictures that are painted in parts, step by step, and such as are painted as a whole.
    fn difference(
        mut shapes: Vec<Painted>,
        steps: Vec<Step>,
        pixels_per_point: f32,
        (x, y): (i32, i32),
    ) -> Option<String> {
        let headless = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = headless.gl();
        let scene = Framebuffer::new(gl, 60, 40, 0).unwrap();
        scene.clear([0.2, 0.3, 0.4, 1.0]);
        let [parts, whole] = [(); 2].map(|()| Framebuffer::new(gl, 123, 97, 0).unwrap());
        let mut painter = InterfacePainter::new(gl).unwrap();
        let egui = egui::Context::default();
        egui.set_pixels_per_point(pixels_per_point);
        let mut composer = Composer::default();
        let place = rect(x, y, 60, 40);
        // The first frames load letters.
        for step in std::iter::repeat_n(Step::Nothing, 3).chain(steps) {
            let mut is_new = false;
            let at = |at: usize, shapes: &[Painted]| at.min(shapes.len() - 1);
            match step.clone() {
                Step::Nothing => {}
                Step::Scene([r, g, b]) => {
                    scene.clear([r, g, b, 1.0]);
                    is_new = true;
                }
                Step::Insert(index, it) => shapes.insert(at(index, &shapes), it),
                Step::Remove(index) if shapes.len() > 1 => {
                    shapes.remove(at(index, &shapes));
                }
                Step::Remove(_) => {}
                Step::Replace(index, it) => {
                    let index = at(index, &shapes);
                    shapes[index] = it;
                }
            }
            let size = egui::vec2(123.0, 97.0) / pixels_per_point;
            let input = egui::RawInput {
                screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
                ..egui::RawInput::default()
            };
            let output = egui.run_ui(input, |ui| {
                shapes.iter().for_each(|it| it.paint(ui));
            });
            let mut again = output.clone();
            again.textures_delta.clear();
            let scene = &scene;
            let placed = Placed {
                scene,
                is_new,
                place,
            };
            composer
                .compose(placed, &mut painter, &egui, output, &parts)
                .unwrap();
            let all = Composer::default().compose(placed, &mut painter, &egui, again, &whole);
            assert!(all.unwrap());
            let [found, expected] = [&parts, &whole].map(|it| it.read_rgba().unwrap());
            let pairs = found.iter().zip(&expected).enumerate();
            let off: Vec<_> = pairs.filter(|(_, (a, b))| a != b).collect();
            if !off.is_empty() {
                return Some(format!("after {step:?}: {off:?}"));
            }
        }
        None
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        #[test]
        fn a_picture_of_which_parts_are_painted_again_has_the_pixels_of_one_that_is_painted_as_a_whole(
            first in proptest::collection::vec(painted(), 1..9),
            steps in steps(),
            pixels_per_point in prop::sample::select(vec![1.0_f32, 1.25, 2.0]),
            // Also partly beyond the picture.
            place in (0..124_i32, 0..98_i32),
        ) {
            prop_assert_eq!(difference(first, steps, pixels_per_point, place), None);
        }
    }

    #[test]
    fn the_smooth_edge_of_a_shape_beside_what_is_painted_again_stays() {
        let below = Painted {
            at: (19.720_015, 31.069_738),
            size: (3.712_972_6, 16.696_182),
            kind: 0,
            color: [0, 0, 0, 14],
            clip: (0.0, 0.0),
        };
        let green = Step::Scene([0.0, 0.788_230_24, 0.0]);
        assert_eq!(difference(vec![below], vec![green], 1.0, (0, 66)), None);
    }

    #[test]
    fn nothing_is_painted_where_nothing_has_changed() {
        let context = HeadlessContext::new(Backend::Auto).unwrap();
        let gl = context.gl();
        let [scene, target] = [(2, 2), (8, 6)].map(|(w, h)| Framebuffer::new(gl, w, h, 0).unwrap());
        let mut painter = InterfacePainter::new(gl).unwrap();
        let (egui, mut composer) = (egui::Context::default(), Composer::default());
        let mut compose = |is_new| {
            let output = egui.run_ui(egui::RawInput::default(), |_| {});
            let placed = Placed {
                scene: &scene,
                is_new,
                place: rect(1, 0, 2, 2),
            };
            composer
                .compose(placed, &mut painter, &egui, output, &target)
                .unwrap()
        };
        assert!(compose(true));
        assert!(!compose(false));
        assert!(compose(true));
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
