use super::theme::DARK;
use super::widgets::named;
use crate::editor::View;
use crate::scene::{Camera, ViewDirection};
use crate::ui::Action;
use egui::{Align2, Color32, CursorIcon, FontId, Pos2, Rect, Sense, Stroke, Ui, Vec2, pos2, vec2};
use egui::{WidgetInfo, WidgetType};
use glam::Vec3;

/// Distance from the center of the ball to the center of an end, in points.
const ARM: f32 = 32.0;
/// Radius of an end, in points.
const END: f32 = 9.0;
/// Distance from the view's edges to the center of the ball, in points.
const INSET: f32 = ARM + END + 8.0;
/// Views narrower or lower than these, in points, have no ball: it would be in the way.
const ROOM: Vec2 = vec2(256.0, 160.0);

/// Height of the part of the view that the ball takes, in points.
pub(in crate::ui) const HEIGHT: f32 = 2.0 * INSET;

/// Left edge of the ball, in points; right edge of the view if there is no ball.
pub(in crate::ui) fn left(view: Rect) -> f32 {
    if has_room(view) {
        view.right() - 2.0 * INSET
    } else {
        view.right()
    }
}

/// Lower edge of the ball, in points; upper edge of the view if there is no ball.
pub(in crate::ui) fn bottom(view: Rect) -> f32 {
    if has_room(view) {
        view.top() + 2.0 * INSET
    } else {
        view.top()
    }
}

fn has_room(view: Rect) -> bool {
    view.width() >= ROOM.x && view.height() >= ROOM.y
}

/// The axis ball in the upper right corner of the view: shows the camera's orientation, and a click
/// on an end looks from that side, at the same target and distance.
pub(super) fn show(ui: &mut Ui, view: Rect, camera: &Camera, actions: &mut Vec<Action>) {
    if !has_room(view) {
        return;
    }
    let middle = pos2(view.right() - INSET, view.top() + INSET);
    let mut ends = ends(camera, middle);
    // From back to front, so that the nearer of two ends is drawn last and wins the click.
    ends.sort_by(|a, b| a.nearness.total_cmp(&b.nearness));
    for end in &ends {
        if let Some(direction) = show_end(ui, end, middle, camera) {
            let camera = camera.looking_from(direction);
            actions.push(Action::View(View::SetCamera(camera)));
        }
    }
}

struct End {
    direction: ViewDirection,
    axis: usize,
    positive: bool,
    at: Pos2,
    /// Cosine of the angle to the direction of the eye: 1 towards it, -1 away from it.
    nearness: f32,
}

fn ends(camera: &Camera, middle: Pos2) -> Vec<End> {
    let (right, up) = (camera.right(), camera.up());
    let outward = right.cross(up);
    ViewDirection::ALL
        .into_iter()
        .map(|direction| {
            let (axis, positive) = axis_of(direction);
            let sign = if positive { 1.0 } else { -1.0 };
            let pointing = Vec3::AXES[axis] * sign;
            End {
                direction,
                axis,
                positive,
                at: middle + vec2(pointing.dot(right), -pointing.dot(up)) * ARM,
                nearness: pointing.dot(outward),
            }
        })
        .collect()
}

fn axis_of(direction: ViewDirection) -> (usize, bool) {
    match direction {
        ViewDirection::PlusX => (0, true),
        ViewDirection::MinusX => (0, false),
        ViewDirection::PlusY => (1, true),
        ViewDirection::MinusY => (1, false),
        ViewDirection::PlusZ => (2, true),
        ViewDirection::MinusZ => (2, false),
    }
}

/// Draws one end; if it was clicked, the side to look from. The end that the camera looks from
/// already leads to the opposite side.
fn show_end(ui: &Ui, end: &End, middle: Pos2, camera: &Camera) -> Option<ViewDirection> {
    let rect = Rect::from_center_size(end.at, Vec2::splat(2.0 * END));
    let id = ui.id().with(("axis ball", end.direction.label()));
    let response = ui
        .interact(rect, id, Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand);
    let lit = response.hovered() || response.has_focus();
    // The view is dark in every theme, so the ball keeps the colors of the dark one.
    let bright = DARK.axes[end.axis];
    let fade = 0.55 + 0.45 * (end.nearness + 1.0) / 2.0;
    let color = if lit {
        bright
    } else {
        bright.gamma_multiply(fade)
    };
    let painter = ui.painter();
    let letter_color = Color32::from_gray(16);
    if end.positive {
        painter.line_segment([middle, end.at], Stroke::new(2.0, color));
        painter.circle_filled(end.at, END, color);
    } else {
        let ground = Color32::from_black_alpha(150);
        painter.circle(end.at, END - 1.0, ground, Stroke::new(1.5, color));
    }
    if lit {
        let ring = Stroke::new(1.5, Color32::WHITE);
        painter.circle_stroke(end.at, END, ring);
    }
    let letter = ["X", "Y", "Z"][end.axis];
    let font = FontId::proportional(12.0);
    if end.positive {
        painter.text(end.at, Align2::CENTER_CENTER, letter, font, letter_color);
    } else if lit {
        let text = end.direction.label();
        painter.text(end.at, Align2::CENTER_CENTER, text, font, Color32::WHITE);
    }

    let leads_to = if end.nearness > 0.999 && is_at(camera, end.direction) {
        opposite(end.direction)
    } else {
        end.direction
    };
    let label = format!("Look from {}", end.direction.label());
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), &label));
    let tooltip = format!("Look from {}", leads_to.label());
    named(response, &label)
        .on_hover_text(tooltip)
        .clicked()
        .then_some(leads_to)
}

fn is_at(camera: &Camera, direction: ViewDirection) -> bool {
    let there = camera.looking_from(direction);
    (there.eye() - camera.eye()).length() < 1e-3 * camera.radius
}

fn opposite(direction: ViewDirection) -> ViewDirection {
    match direction {
        ViewDirection::PlusX => ViewDirection::MinusX,
        ViewDirection::MinusX => ViewDirection::PlusX,
        ViewDirection::PlusY => ViewDirection::MinusY,
        ViewDirection::MinusY => ViewDirection::PlusY,
        ViewDirection::PlusZ => ViewDirection::MinusZ,
        ViewDirection::MinusZ => ViewDirection::PlusZ,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn end(ends: &[End], direction: ViewDirection) -> &End {
        let found = ends.iter().find(|end| end.direction == direction);
        found.expect("all six are there")
    }

    #[test]
    fn from_the_first_view_x_points_right_y_up_and_z_at_the_eye() {
        let ends = ends(&Camera::default(), Pos2::ZERO);
        let at = |direction| end(&ends, direction).at;
        assert!((at(ViewDirection::PlusX) - pos2(ARM, 0.0)).length() < 1e-4);
        assert!((at(ViewDirection::PlusY) - pos2(0.0, -ARM)).length() < 1e-4);
        assert!((at(ViewDirection::MinusX) - pos2(-ARM, 0.0)).length() < 1e-4);
        assert!((end(&ends, ViewDirection::PlusZ).nearness - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_end_that_the_camera_looks_from_is_nearest_in_every_preset() {
        for direction in ViewDirection::ALL {
            let ends = ends(&Camera::preset(direction), Pos2::ZERO);
            assert!(end(&ends, direction).nearness > 0.999_9, "{direction:?}");
        }
    }
}
