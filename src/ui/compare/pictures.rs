use super::{CompareView, masks};
use crate::compare::Area;
use crate::geometry::Picture;
use crate::ui::theme::Palette;
use crate::ui::{CompareMode, CompareSettings, ScenePlaces, swipe_line};
use egui::{
    Align, Color32, Label, Layout, Pos2, Rect, Response, RichText, Stroke, StrokeKind, TextureId,
    Ui, Vec2, pos2, vec2,
};
use std::time::Duration;

/// How long one of two pictures is shown while they blink, in seconds.
const BLINK: f64 = 0.6;
/// Height of the line of text below a picture, in points: above it, the bar of tools would hide it.
const CAPTION: f32 = 20.0;
/// Between two pictures, and around them where there is room, in points.
const GAP: f32 = 8.0;
/// Names of the pictures.
const REFERENCE: &str = "A: reference";
const LIVE: &str = "B: live view";

/// Both pictures in the view instead of the scene alone. `view` is the widget that they lie in, `below_tools` the
/// height at its top that is the tools'.
pub(in crate::ui) fn show(
    ui: &mut Ui,
    (view, below_tools): (&Response, f32),
    compare: &CompareView,
    settings: &mut CompareSettings,
    outlined: Option<Area>,
) -> ScenePlaces {
    let area = view.rect;
    let size = compare.size();
    let pixels = vec2(size.0 as f32, size.1 as f32);
    let pixels_per_point = ui.ctx().pixels_per_point();
    let places_in = |area: Rect| match compare.settings.mode {
        CompareMode::SideBySide => places_of_two(area, pixels, pixels_per_point).to_vec(),
        _ => vec![place_of_one(area, pixels, pixels_per_point)],
    };
    let mut clear = area;
    clear.min.y += below_tools.min(area.height() / 2.0);
    // Every pixel as it is counts for more than a corner below the tools.
    let scale = |places: &[Rect]| places[0].width() * pixels_per_point / pixels.x.max(1.0);
    let (largest, clear) = (places_in(area), places_in(clear));
    let rects = if scale(&largest) >= 1.0 && scale(&clear) < 1.0 {
        largest
    } else {
        clear
    };
    let blinked = blinked(ui, compare.settings.mode);
    let places = ScenePlaces::compared(
        rects.clone(),
        rects[0].width() / pixels.x.max(1.0),
        live(ui, &rects, compare.settings),
        blinked || compare.settings.mode != CompareMode::Blink,
    );
    paint(ui, &places.rects, compare, blinked);
    masks::show_over(ui, &places, size, &mut settings.masks);
    if let Some(outlined) = outlined {
        outline(ui, &places, outlined);
    }
    if compare.settings.mode == CompareMode::Swipe {
        swipe_line::show(ui, places.rects[0], &mut settings.swipe);
    }
    let pixel = view.hover_pos().and_then(|position| {
        let place = places.rects[places.index_at(position)?];
        pixel_at(place, size, position)
    });
    let texts = captions(compare, blinked, pixel);
    for (place, text) in places.rects.iter().zip(texts) {
        caption(ui, *place, area, &text);
    }
    places
}

/// Whether it is the live view's turn to be shown.
fn blinked(ui: &Ui, mode: CompareMode) -> bool {
    if mode != CompareMode::Blink {
        return false;
    }
    let turns = ui.input(|input| input.time) / BLINK;
    let left = (1.0 - turns.fract()) * BLINK;
    ui.ctx()
        .request_repaint_after(Duration::from_secs_f64(left));
    turns as u64 % 2 == 1
}

/// Part of each of the pictures at `places` that is the live view.
fn live(ui: &Ui, places: &[Rect], settings: &CompareSettings) -> Vec<Rect> {
    let place = places[0];
    match settings.mode {
        CompareMode::SideBySide => [Rect::NOTHING]
            .into_iter()
            .chain(places[1..].iter().copied())
            .collect(),
        CompareMode::Swipe => {
            let x = swipe_line::x(ui, place, settings.swipe);
            vec![place.split_left_right_at_x(x).1]
        }
        CompareMode::Blink | CompareMode::OnionSkin => vec![place],
        CompareMode::Difference => vec![Rect::NOTHING],
    }
}

fn paint(ui: &Ui, places: &[Rect], compare: &CompareView, blinked: bool) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter();
    painter.rect_filled(ui.max_rect(), 0, palette.panel);
    let reference = compare.reference.texture;
    let live = compare.live.map(|live| live.texture);
    let image = |texture: Option<TextureId>, part: Rect, place: Rect, opacity: f32| {
        if let Some(texture) = texture.filter(|_| part.is_positive()) {
            let uv = Rect::from_min_max(
                ((part.min - place.min) / place.size()).to_pos2(),
                ((part.max - place.min) / place.size()).to_pos2(),
            );
            painter.image(texture, part, uv, Color32::WHITE.gamma_multiply(opacity));
        }
    };
    let place = places[0];
    painter.rect_filled(place, 0, Color32::BLACK);
    match compare.settings.mode {
        CompareMode::SideBySide => {
            image(Some(reference), place, place, 1.0);
            if let Some(&second) = places.get(1) {
                painter.rect_filled(second, 0, Color32::BLACK);
                image(live, second, second, 1.0);
            }
        }
        CompareMode::Swipe => {
            let (left, right) =
                place.split_left_right_at_x(swipe_line::x(ui, place, compare.settings.swipe));
            image(Some(reference), left, place, 1.0);
            image(live, right, place, 1.0);
        }
        CompareMode::Blink if blinked => image(live, place, place, 1.0),
        CompareMode::Blink => image(Some(reference), place, place, 1.0),
        CompareMode::OnionSkin => {
            image(Some(reference), place, place, 1.0);
            image(live, place, place, compare.settings.onion);
        }
        CompareMode::Difference => image(compare.difference, place, place, 1.0),
    }
    let line = Stroke::new(1.0, palette.line);
    for &place in places {
        painter.rect_stroke(place, 0, line, StrokeKind::Outside);
    }
}

/// A rectangle round the pixels `area` of each picture, a little out of it so that they stay seen.
fn outline(ui: &Ui, places: &ScenePlaces, area: Area) {
    let color = Palette::of(ui.visuals()).accent;
    for &place in &places.rects {
        let rect = masks::shown(area, place, places.points_per_pixel).expand(3.0);
        let painter = ui.painter();
        // Black beside the color shows on every picture.
        let dark = Stroke::new(4.0, Color32::from_black_alpha(160));
        painter.rect_stroke(rect, 2, dark, StrokeKind::Middle);
        painter.rect_stroke(rect, 2, Stroke::new(2.0, color), StrokeKind::Middle);
    }
}

/// What is written below a picture: which it is, and the pixel under the pointer.
fn caption(ui: &mut Ui, place: Rect, area: Rect, text: &str) {
    let line = Rect::from_min_max(
        place.left_bottom(),
        pos2(
            place.right().max(place.left() + 120.0),
            (place.bottom() + CAPTION).min(area.bottom()),
        ),
    );
    let color = Palette::of(ui.visuals()).text;
    let mut inside = ui.new_child(egui::UiBuilder::new().max_rect(line.intersect(area)));
    inside.set_clip_rect(line.intersect(area));
    inside.with_layout(Layout::left_to_right(Align::Center), |ui| {
        ui.add(Label::new(RichText::new(text).small().color(color)).truncate());
    });
}

/// The captions of the pictures in the view, `blinked` if it is B's turn to blink.
fn captions(compare: &CompareView, blinked: bool, pixel: Option<(u32, u32)>) -> Vec<String> {
    let reference = color_at(compare.reference.picture, pixel);
    let live = compare.live.and_then(|live| color_at(live.picture, pixel));
    let alone = |name: &str, color: Option<String>| match (pixel, color) {
        (Some((x, y)), Some(color)) => format!("{name} · pixel {x}, {y}: {color}"),
        _ => name.to_owned(),
    };
    let both = |name: &str| match (pixel, &reference, &live) {
        (Some((x, y)), Some(a), Some(b)) => format!("{name} · pixel {x}, {y}: A {a}, B {b}"),
        _ => name.to_owned(),
    };
    match compare.settings.mode {
        CompareMode::SideBySide => vec![alone(REFERENCE, reference), alone(LIVE, live)],
        CompareMode::Swipe => vec![both(
            "A left of the line: reference, B right of it: live view",
        )],
        CompareMode::Blink => vec![both(if blinked { LIVE } else { REFERENCE })],
        CompareMode::OnionSkin => vec![both("B: live view, over A: reference")],
        CompareMode::Difference => vec![both("Differences, lighter where larger")],
    }
}

/// Red, green, blue, and opacity unless it is full.
fn color_at(picture: &Picture, pixel: Option<(u32, u32)>) -> Option<String> {
    let (x, y) = pixel?;
    let start = 4 * (y as usize * picture.width as usize + x as usize);
    match picture.rgba.get(start..start + 4)? {
        [r, g, b, 255] => Some(format!("{r} {g} {b}")),
        [r, g, b, alpha] => Some(format!("{r} {g} {b}, opacity {alpha}")),
        _ => None,
    }
}

/// The pixel of a picture of `size` that lies under `position` when it is shown in `place`.
fn pixel_at(place: Rect, size: (u32, u32), position: Pos2) -> Option<(u32, u32)> {
    let along = (position - place.min) / place.size();
    let inside = (0.0..1.0).contains(&along.x) && (0.0..1.0).contains(&along.y);
    inside.then(|| {
        let x = (along.x * size.0 as f32) as u32;
        let y = (along.y * size.1 as f32) as u32;
        (
            x.min(size.0.saturating_sub(1)),
            y.min(size.1.saturating_sub(1)),
        )
    })
}

/// A picture of `size` pixels in the middle of `area` (points), as large as fits. Where it can
/// be shown pixel by pixel or larger it is, in whole pixels of the screen.
fn fitted(area: Rect, size: Vec2, pixels_per_point: f32) -> Rect {
    let size = size.max(Vec2::splat(1.0));
    let room = area.size() * pixels_per_point;
    let scale = (room.x / size.x).min(room.y / size.y);
    let scale = if scale >= 1.0 {
        scale.floor()
    } else {
        scale.max(1.0 / size.max_elem())
    };
    let shown = size * (scale / pixels_per_point);
    let free = (area.size() - shown).max(Vec2::ZERO) * 0.5;
    let whole = |points: f32| (points * pixels_per_point).round() / pixels_per_point;
    let corner = area.min + free;
    Rect::from_min_size(pos2(whole(corner.x), whole(corner.y)), shown)
}

fn above_caption(area: Rect) -> Rect {
    let bottom = (area.bottom() - CAPTION).max(area.top());
    Rect::from_min_max(area.min, pos2(area.right(), bottom))
}

/// Where one picture with a caption below it is shown.
fn place_of_one(area: Rect, size: Vec2, pixels_per_point: f32) -> Rect {
    fitted(above_caption(area), size, pixels_per_point)
}

/// Where two pictures of the same size are shown, each with a caption below it: side by side, or
/// one above the other where they can be clearly larger so.
fn places_of_two(area: Rect, size: Vec2, pixels_per_point: f32) -> [Rect; 2] {
    let area = area.shrink(GAP.min(area.size().min_elem().max(0.0) * 0.1));
    let beside =
        halves(area, vec2(1.0, 0.0)).map(|half| place_of_one(half, size, pixels_per_point));
    let above = halves(area, vec2(0.0, 1.0)).map(|half| place_of_one(half, size, pixels_per_point));
    if above[0].width() > 1.25 * beside[0].width() {
        above
    } else {
        beside
    }
}

/// The parts of `area` that are left of each other (`along` = +x) or above (`along` = +y).
fn halves(area: Rect, along: Vec2) -> [Rect; 2] {
    let gap = along * GAP;
    let size = (area.size() - (area.size() + gap) * along * 0.5).max(Vec2::ZERO);
    let second = area.min + along * (size + gap);
    [area.min, second].map(|corner| Rect::from_min_size(corner, size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pixel_under_the_pointer_is_found_at_every_scale() {
        for scale in [0.5, 1.0, 3.0] {
            let place = Rect::from_min_size(pos2(20.0, 40.0), vec2(8.0, 6.0) * scale);
            let at = |x: f32, y: f32| pixel_at(place, (8, 6), place.min + vec2(x, y) * scale);
            assert_eq!(at(0.0, 0.0), Some((0, 0)));
            assert_eq!(at(2.5, 5.9), Some((2, 5)));
            assert_eq!(at(8.1, 3.0), None);
            assert_eq!(at(-0.1, 3.0), None);
        }
    }

    fn area(width: f32, height: f32) -> Rect {
        Rect::from_min_size(pos2(10.0, 30.0), vec2(width, height))
    }

    const COURSE: Vec2 = vec2(800.0, 600.0);

    #[test]
    fn a_picture_that_fits_is_shown_pixel_by_pixel_in_the_middle() {
        let rect = fitted(area(1000.0, 650.0), COURSE, 1.0);
        assert_eq!(rect.size(), COURSE);
        assert_eq!(rect.min, pos2(110.0, 55.0));
        assert_eq!(
            fitted(area(1700.0, 1200.0), COURSE, 1.0).size(),
            COURSE * 2.0
        );
    }

    #[test]
    fn on_a_fine_screen_a_pixel_of_the_picture_is_a_whole_number_of_its_pixels() {
        let rect = fitted(area(1000.0, 650.0), COURSE, 1.5);
        // A corner is kept, not a size: rounded to what a number of points can hold.
        let close = |a: Vec2, b: Vec2| (a - b).abs().max_elem() < 1e-3;
        assert!(close(rect.size() * 1.5, COURSE), "{rect}");
        let corner = rect.min.to_vec2() * 1.5;
        assert!(close(corner, corner.round()), "{rect}");
    }

    #[test]
    fn a_picture_that_does_not_fit_keeps_its_shape_inside_of_the_area() {
        for (width, height) in [(500.0, 700.0), (900.0, 200.0), (60.0, 20.0)] {
            let area = area(width, height);
            let rect = fitted(area, COURSE, 1.0);
            assert!(
                area.expand(1.0).contains_rect(rect),
                "{rect} is not in {area}"
            );
            assert!((rect.aspect_ratio() - 4.0 / 3.0).abs() < 1e-4, "{rect}");
        }
        assert!(fitted(area(0.0, 0.0), COURSE, 1.0).is_positive());
        assert!(fitted(area(10.0, 10.0), Vec2::ZERO, 1.0).is_positive());
    }

    #[test]
    fn two_pictures_stand_side_by_side_or_above_each_other_and_never_overlap() {
        let [a, b] = places_of_two(area(1000.0, 600.0), COURSE, 1.0);
        assert_eq!(a.size(), b.size());
        assert!(a.right() + GAP <= b.left() + 1.0 && a.top() == b.top());
        assert!(a.bottom() + CAPTION <= area(1000.0, 600.0).bottom());
        let [a, b] = places_of_two(area(400.0, 900.0), COURSE, 1.0);
        assert_eq!(a.size(), b.size());
        assert!(a.bottom() + CAPTION <= b.top() && a.left() == b.left());
    }
}
