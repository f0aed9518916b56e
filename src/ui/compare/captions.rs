use super::CompareView;
use crate::geometry::Picture;
use crate::ui::CompareMode;
use egui::{Align, Label, Layout, Pos2, Rect, RichText, Ui, pos2};

/// What is written above a picture, at its left or right: which it is, and the pixel under the
/// pointer.
pub(super) fn show(ui: &mut Ui, place: Rect, area: Rect, align: Align, text: &str) {
    let top = (place.top() - super::fitting::CAPTION).max(area.top());
    let line = Rect::from_min_max(
        pos2(place.left(), top),
        pos2(place.right().max(place.left() + 120.0), place.top()),
    );
    let color = crate::ui::theme::Palette::of(ui.visuals()).text;
    let mut inside = ui.new_child(egui::UiBuilder::new().max_rect(line.intersect(area)));
    inside.set_clip_rect(line.intersect(area));
    let layout = match align {
        Align::Max => Layout::right_to_left(Align::Center),
        _ => Layout::left_to_right(Align::Center),
    };
    inside.with_layout(layout, |ui| {
        ui.add(Label::new(RichText::new(text).small().color(color)).truncate());
    });
}

/// The captions of the pictures in the view, `blinked` if it is B's turn to blink.
pub(super) fn texts(
    compare: &CompareView,
    blinked: bool,
    pixel: Option<(u32, u32)>,
) -> Vec<String> {
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

const REFERENCE: &str = "A: reference";
const LIVE: &str = "B: live view";

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
pub(super) fn pixel_at(place: Rect, size: (u32, u32), position: Pos2) -> Option<(u32, u32)> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use egui::vec2;

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
}
