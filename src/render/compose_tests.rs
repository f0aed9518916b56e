//! Pictures that are composed, and parts of them that are painted again.

use super::InterfacePainter;
use super::compose::{Composer, Placed, view_place};
use crate::gpu::{Backend, HeadlessContext};
use crate::gpu::{Framebuffer, Rect};
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
    (at, size, 0..4_u8, any::<[u8; 4]>(), clip).prop_map(|(at, size, kind, color, clip)| Painted {
        at,
        size,
        kind,
        color,
        clip,
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
