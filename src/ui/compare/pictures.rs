use super::{CompareView, captions, fitting, mask_overlay};
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use crate::ui::{CompareMode, CompareSettings, ScenePlaces};
use egui::{
    Align, Color32, CursorIcon, Rect, Response, Sense, Stroke, StrokeKind, TextureId, Ui, pos2,
    vec2,
};
use std::time::Duration;

/// How long one of two pictures is shown while they blink, in seconds.
const BLINK: f64 = 0.6;
/// How far from the line between two pictures it can be taken hold of, in points.
const GRIP: f32 = 6.0;

/// Both pictures in the view instead of the scene alone. `view` is the widget that they lie in.
pub(in crate::ui) fn show(
    ui: &mut Ui,
    view: &Response,
    compare: &CompareView,
    settings: &mut CompareSettings,
) -> ScenePlaces {
    let area = view.rect;
    let size = compare.size();
    let pixels = vec2(size.0 as f32, size.1 as f32);
    let pixels_per_point = ui.ctx().pixels_per_point();
    let rects = match compare.settings.mode {
        CompareMode::SideBySide => fitting::two(area, pixels, pixels_per_point).to_vec(),
        _ => vec![fitting::one(area, pixels, pixels_per_point)],
    };
    let places = ScenePlaces {
        points_per_pixel: rects[0].width() / pixels.x.max(1.0),
        rects,
    };
    let blinked = blinked(ui, compare.settings.mode);
    paint(ui, &places.rects, compare, blinked);
    mask_overlay::show(ui, &places, size, &mut settings.masks);
    if compare.settings.mode == CompareMode::Swipe {
        swipe_line(ui, places.rects[0], settings);
    }
    let pixel = view.hover_pos().and_then(|position| {
        let place = places.rects[places.index_at(position)?];
        captions::pixel_at(place, size, position)
    });
    let texts = captions::texts(compare, blinked, pixel);
    // One picture alone reaches up to the bar of tools at the left.
    let align = match places.rects.len() {
        1 => Align::Max,
        _ => Align::Min,
    };
    for (place, text) in places.rects.iter().zip(texts) {
        captions::show(ui, *place, area, align, &text);
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
            let (left, right) = place.split_left_right_at_x(swipe_x(place, compare.settings, ui));
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

/// Where the line stands, on a whole pixel of the screen so that both parts stay sharp.
fn swipe_x(place: Rect, settings: &CompareSettings, ui: &Ui) -> f32 {
    let pixels_per_point = ui.ctx().pixels_per_point();
    let x = place.left() + place.width() * settings.swipe.clamp(0.0, 1.0);
    (x * pixels_per_point).round() / pixels_per_point
}

fn swipe_line(ui: &mut Ui, place: Rect, settings: &mut CompareSettings) {
    let x = swipe_x(place, settings, ui);
    let strip = Rect::from_x_y_ranges(x - GRIP..=x + GRIP, place.y_range());
    let line = ui
        .interact(strip, ui.id().with("swipe line"), Sense::drag())
        .on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
    let line = named(line, "Line between the pictures");
    let palette = Palette::of(ui.visuals());
    let held = line.hovered() || line.dragged();
    let color = if held { palette.accent } else { Color32::WHITE };
    let painter = ui.painter();
    // White with black beside it shows on every picture.
    painter.vline(
        x,
        place.y_range(),
        Stroke::new(3.0, Color32::from_black_alpha(160)),
    );
    painter.vline(x, place.y_range(), Stroke::new(1.0, color));
    painter.circle(
        pos2(x, place.center().y),
        5.0,
        color,
        Stroke::new(1.0, Color32::BLACK),
    );
    if line.dragged()
        && let Some(pointer) = line.interact_pointer_pos()
    {
        settings.swipe = ((pointer.x - place.left()) / place.width()).clamp(0.0, 1.0);
    }
}
