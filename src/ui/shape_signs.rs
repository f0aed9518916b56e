//! The eye and the lock at the end of a shape's row.

use super::keys::{self, Command};
use super::theme::Palette;
use super::widgets::named;
use crate::editor::Edit;
use crate::scene::Shape;
use crate::ui::Action;
use egui::{Color32, Painter, Pos2, Rect, Response, Sense, Stroke, StrokeKind, Ui, vec2};
use egui::{WidgetInfo, WidgetType, pos2};
use std::f32::consts::PI;

/// What each sign takes of a row, in points.
const EACH: f32 = 20.0;
/// What both take.
pub(super) const WIDTH: f32 = 2.0 * EACH;
const LINE: f32 = 1.3;

/// Shows both in `rect`. They are drawn rather than written: no font that egui brings has an eye
/// that is closed.
pub(super) fn show(ui: &Ui, rect: Rect, shape: &Shape, selected: bool, actions: &mut Vec<Action>) {
    let (left, right) = rect.split_left_right_at_fraction(0.5);
    let name = &shape.name;

    let does = if shape.visible { "Hide" } else { "Show" };
    let hint = if shape.visible {
        format!("Hide {name} in the view, not in exports")
    } else {
        format!("Show {name} in the view again")
    };
    let eye = button(ui, left, &format!("{does} {name}"), "eye");
    let color = color(ui, &eye, selected, !shape.visible);
    paint_eye(ui.painter(), left.center(), shape.visible, color);
    if with_hint(eye, Command::ToggleVisible, &hint, selected).clicked() {
        let edit = Edit::SetVisible(shape.id, !shape.visible);
        actions.push(Action::Edit(edit));
    }

    let does = if shape.locked { "Unlock" } else { "Lock" };
    let hint = if shape.locked {
        format!("Let {name} be clicked and moved in the view again")
    } else {
        format!("Keep {name} from being clicked, posed and moved in the view")
    };
    let lock = button(ui, right, &format!("{does} {name}"), "lock");
    let color = self::color(ui, &lock, selected, shape.locked);
    paint_lock(ui.painter(), right.center(), shape.locked, color);
    if with_hint(lock, Command::ToggleLocked, &hint, selected).clicked() {
        let edit = Edit::SetLocked(shape.id, !shape.locked);
        actions.push(Action::Edit(edit));
    }
}

fn button(ui: &Ui, rect: Rect, label: &str, id: &str) -> Response {
    let button = ui.interact(rect, ui.id().with(id), Sense::click());
    let painter = ui.painter();
    let visuals = ui.style().interact(&button);
    if button.hovered() {
        painter.rect_filled(
            rect.shrink(1.0),
            visuals.corner_radius,
            visuals.weak_bg_fill,
        );
    }
    if button.has_focus() {
        let stroke = Stroke::new(1.0, Palette::of(ui.visuals()).accent);
        painter.rect_stroke(rect.shrink(1.0), 2.0, stroke, StrokeKind::Inside);
    }
    button.widget_info(|| WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), label));
    named(button, label)
}

/// With the key, which means the selected shape alone.
fn with_hint(button: Response, command: Command, hint: &str, selected: bool) -> Response {
    if selected {
        let hint = keys::with_key(&button.ctx, command, hint);
        button.on_hover_text(hint)
    } else {
        button.on_hover_text(hint)
    }
}

/// Signs of how shapes usually are stand back.
fn color(ui: &Ui, button: &Response, selected: bool, unusual: bool) -> Color32 {
    let palette = Palette::of(ui.visuals());
    if button.hovered() {
        palette.strong
    } else if selected {
        palette.on_selection
    } else if unusual {
        palette.strong
    } else {
        palette.weak
    }
}

/// An open eye, or one that is crossed out.
fn paint_eye(painter: &Painter, center: Pos2, open: bool, color: Color32) {
    const WIDE: f32 = 6.5;
    const HIGH: f32 = 4.2;
    let stroke = Stroke::new(LINE, color);
    let lid = |side: f32| {
        let points = (0..=12).map(|i| {
            let across = i as f32 / 6.0 - 1.0;
            center + vec2(across * WIDE, side * HIGH * (1.0 - across * across))
        });
        points.collect::<Vec<_>>()
    };
    painter.line(lid(-1.0), stroke);
    painter.line(lid(1.0), stroke);
    if open {
        painter.circle_filled(center, 2.0, color);
    } else {
        let along = vec2(5.5, -5.5);
        painter.line_segment([center - along, center + along], stroke);
    }
}

/// A closed lock, filled, or an open one, hollow.
fn paint_lock(painter: &Painter, center: Pos2, closed: bool, color: Color32) {
    const RADIUS: f32 = 2.8;
    let stroke = Stroke::new(LINE, color);
    let body = Rect::from_center_size(center + vec2(0.0, 2.6), vec2(9.0, 6.4));
    if closed {
        painter.rect_filled(body, 1.5, color);
    } else {
        painter.rect_stroke(body, 1.5, stroke, StrokeKind::Inside);
    }
    // The open one has swung to the side.
    let (middle, right_leg) = if closed {
        (body.center_top() - vec2(0.0, 1.8), body.top())
    } else {
        (body.right_top() - vec2(1.6, 1.8), body.top() - 1.2)
    };
    let mut shackle = vec![pos2(middle.x - RADIUS, body.top())];
    shackle.extend((0..=8).map(|i| {
        let angle = PI * (1.0 + i as f32 / 8.0);
        middle + RADIUS * vec2(angle.cos(), angle.sin())
    }));
    shackle.push(pos2(middle.x + RADIUS, right_leg));
    painter.line(shackle, stroke);
}
