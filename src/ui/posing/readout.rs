//! The readout of a gesture: what it holds, and by how much that has turned or moved.

use super::held::{Held, PoseGesture};
use super::held_name;
use crate::editor::Session;
use crate::scene::bones_in_world;
use crate::ui::scene_places::Place;
use crate::ui::theme::Palette;
use egui::text::{LayoutJob, TextWrapping};
use egui::{FontId, Id, LayerId, Order, Pos2, Rect, Ui, Vec2, vec2};

/// Least distance of the readout from the edges of the view, in points.
const AWAY_FROM_EDGE: f32 = 4.0;
/// Distance of the readout from the pointer, in points.
const AWAY_FROM_POINTER: Vec2 = vec2(18.0, 14.0);
/// Distance from a bone within which the limb round it is, in points.
const LIMB: f32 = 16.0;

/// Paints the readout beside the pointer, on the side where it covers the limbs least.
pub(super) fn show(
    ui: &Ui,
    view: Rect,
    place: Option<Place>,
    session: &Session,
    gesture: &PoseGesture,
) {
    let pointer = ui.ctx().input(|input| input.pointer.latest_pos());
    let text = gesture.active().map(Held::readout);
    let (Some(text), Some(pointer)) = (text, pointer) else {
        return;
    };
    let palette = Palette::of(ui.visuals());
    // Above what lies over the view, such as the axis ball.
    let layer = LayerId::new(Order::Tooltip, Id::new("readout"));
    let painter = ui.ctx().layer_painter(layer);
    let (font, color) = (FontId::proportional(13.0), palette.strong);
    let value = painter.layout_no_wrap(text, font.clone(), color);
    let (margin, gap) = (vec2(6.0, 3.0), 8.0);
    // Names come from files and may be of any length: the value must stay readable.
    let room = view.width() - value.size().x - gap - 2.0 * (margin.x + AWAY_FROM_EDGE);
    let held = gesture.held();
    let name = held_name(session, held).unwrap_or_default();
    let mut line = LayoutJob::simple_singleline(name, font, color);
    line.wrap = TextWrapping::truncate_at_width(room.max(0.0));
    let name = painter.layout_job(line);

    let content = vec2(name.size().x + gap + value.size().x, value.size().y);
    let bones = place.map_or_else(Vec::new, |place| bones(session, place, gesture));
    let rect = clear_of(&bones, pointer, content + 2.0 * margin, view);
    painter.rect_filled(rect, 4.0, palette.panel);
    let after_name = rect.min + margin + vec2(name.size().x + gap, 0.0);
    painter.galley(rect.min + margin, name, color);
    painter.galley(after_name, value, color);
}

/// Ends of the bones of the held character in the view, in points.
fn bones(session: &Session, place: Place, gesture: &PoseGesture) -> Vec<[Pos2; 2]> {
    let screen = place.screen(session);
    let position = |world| Some(place.position(screen.pixel(world)?));
    let evaluated = session.evaluated().shape(gesture.held().shape());
    evaluated.map_or_else(Vec::new, |evaluated| {
        bones_in_world(session.scene(), evaluated)
            .filter_map(|(_, start, end)| Some([position(start)?, position(end)?]))
            .collect()
    })
}

/// Rectangle of `size` within `view`, in one of the places around `pointer`: the one with the least
/// of `bones` in it.
fn clear_of(bones: &[[Pos2; 2]], pointer: Pos2, size: Vec2, view: Rect) -> Rect {
    let first = view.min + Vec2::splat(AWAY_FROM_EDGE);
    let last = (view.max - size - Vec2::splat(AWAY_FROM_EDGE)).max(first);
    // The nearest come first: of equally good ones, the first is taken.
    let sides = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    let places = [1.0_f32, 1.8, 3.0, 4.5]
        .into_iter()
        .flat_map(|away| sides.map(|(x, y)| (vec2(x, y), away)))
        .map(|(side, away)| {
            let center = pointer + side * (AWAY_FROM_POINTER * away + size / 2.0);
            let corner = (center - size / 2.0).clamp(first, last);
            Rect::from_min_size(corner, size)
        });
    let covered = |rect: &Rect| -> f32 {
        let limbs = rect.expand(LIMB);
        // What is under the pointer must be seen even where there are no bones.
        let pointer = if rect.contains(pointer) { 1e6 } else { 0.0 };
        pointer
            + bones
                .iter()
                .map(|bone| length_in(limbs, *bone))
                .sum::<f32>()
    };
    let best = places.min_by(|a, b| covered(a).total_cmp(&covered(b)));
    best.unwrap_or_else(|| Rect::from_min_size(first, size))
}

/// Length of the part of a line that is in `rect`: the line is clipped at one side after another.
fn length_in(rect: Rect, [start, end]: [Pos2; 2]) -> f32 {
    let along = end - start;
    let (mut from, mut to) = (0.0_f32, 1.0_f32);
    for (at, step, least, greatest) in [
        (start.x, along.x, rect.left(), rect.right()),
        (start.y, along.y, rect.top(), rect.bottom()),
    ] {
        if step == 0.0 {
            if at < least || at > greatest {
                return 0.0;
            }
            continue;
        }
        let (a, b) = ((least - at) / step, (greatest - at) / step);
        from = from.max(a.min(b));
        to = to.min(a.max(b));
    }
    (to - from).max(0.0) * along.length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    const VIEW: Rect = Rect {
        min: Pos2::ZERO,
        max: pos2(400.0, 300.0),
    };
    const SIZE: Vec2 = vec2(90.0, 20.0);

    #[test]
    fn the_readout_is_below_the_pointer_to_the_right_where_nothing_is_in_the_way() {
        let rect = clear_of(&[], pos2(200.0, 150.0), SIZE, VIEW);
        assert_eq!(rect.min, pos2(218.0, 164.0));
    }

    #[test]
    fn the_readout_does_not_cover_the_limb_that_is_dragged() {
        let pointer = pos2(200.0, 150.0);
        for end in [
            pos2(300.0, 220.0),
            pos2(300.0, 100.0),
            pos2(100.0, 220.0),
            pos2(100.0, 80.0),
            pos2(200.0, 290.0),
            pos2(390.0, 150.0),
        ] {
            let bone = [pointer, end];
            let rect = clear_of(&[bone], pointer, SIZE, VIEW);
            let covered = length_in(rect.expand(LIMB / 2.0), bone);
            assert_eq!(covered, 0.0, "{end}: {rect}");
            assert!(VIEW.contains_rect(rect) && !rect.contains(pointer));
        }
    }

    #[test]
    fn in_a_corner_of_the_view_the_readout_stays_in_it_and_off_the_pointer() {
        for pointer in [VIEW.min, VIEW.max, VIEW.left_bottom(), VIEW.right_top()] {
            let rect = clear_of(&[], pointer, SIZE, VIEW);
            assert!(
                VIEW.contains_rect(rect) && !rect.contains(pointer),
                "{rect}"
            );
        }
    }

    #[test]
    fn the_length_of_a_line_in_a_rectangle_ends_at_its_sides() {
        let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(10.0, 10.0));
        for (line, length) in [
            ([pos2(-5.0, 5.0), pos2(5.0, 5.0)], 5.0),
            ([pos2(5.0, -5.0), pos2(5.0, 20.0)], 10.0),
            ([pos2(11.0, 0.0), pos2(11.0, 9.0)], 0.0),
            ([pos2(2.0, 2.0), pos2(2.0, 2.0)], 0.0),
        ] {
            let found = length_in(rect, line);
            assert!((found - length).abs() < 1e-4, "{line:?}: {found}");
        }
    }
}
