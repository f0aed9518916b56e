//! The first help: what newcomers do first.

use super::Navigation;
use super::pointing::Pointing;
use super::posing::BAR_HEIGHT;
use super::state::UiState;
use super::theme::Palette;
use super::widgets::named;
use crate::editor::{Session, Tool};
use crate::scene::ShapeKind;
use egui::{
    Align, Button, Frame, Grid, Label, Layout, Margin, Rect, RichText, Ui, UiBuilder, pos2, vec2,
};

/// Width of the first help, and height of its frame and of each line, in points; in narrow views each line
/// of it is two.
const WIDTH: f32 = 388.0;
const NARROW_WIDTH: f32 = 264.0;
const FRAME_HEIGHT: f32 = 16.0;
/// Distance between what can be done and how, in points.
const GAP: f32 = 12.0;
const LINE_HEIGHT: f32 = 24.0;
const NARROW_LINE_HEIGHT: f32 = 52.0;

/// First help: lines for newcomers in the lower left corner of the view; whether their × was clicked.
pub(super) fn show(ui: &mut Ui, view: Rect, session: &Session, state: &UiState) -> bool {
    let lines = first_steps(session, state, Pointing::of(ui.ctx()));
    let is_narrow = view.width() < WIDTH + 24.0;
    let (width, line_height) = match is_narrow {
        true => (NARROW_WIDTH, NARROW_LINE_HEIGHT),
        false => (WIDTH, LINE_HEIGHT),
    };
    let size = vec2(width, FRAME_HEIGHT + line_height * lines.len() as f32);
    if view.width() < size.x + 24.0 || view.height() < size.y + 3.0 * BAR_HEIGHT {
        return false;
    }
    let corner = pos2(view.left() + 12.0, view.bottom() - size.y - 12.0);
    let builder = UiBuilder::new()
        .id_salt("first help")
        .max_rect(Rect::from_min_size(corner, size));
    let mut inner = ui.new_child(builder);
    let mut closed = false;
    Frame::popup(ui.style())
        .inner_margin(Margin::symmetric(12, 8))
        .show(&mut inner, |ui| {
            ui.with_layout(Layout::left_to_right(Align::TOP), |ui| {
                let columns = if is_narrow { 1 } else { 2 };
                let grid = Grid::new("first help").num_columns(columns);
                grid.spacing(vec2(GAP, 4.0)).show(ui, |ui| {
                    for (what, how) in lines {
                        let strong = Palette::of(ui.visuals()).strong;
                        ui.label(RichText::new(what).color(strong));
                        if is_narrow {
                            ui.end_row();
                            ui.set_max_width(size.x - 48.0);
                        }
                        let how = Label::new(RichText::new(how).small());
                        ui.add(if is_narrow { how.wrap() } else { how.extend() });
                        ui.end_row();
                    }
                });
                let close = ui.add(Button::new("×").frame_when_inactive(false));
                closed = named(close, "Close help")
                    .on_hover_text("Hide these lines")
                    .clicked();
            });
        });
    closed
}

/// What newcomers do first, and how.
fn first_steps(
    session: &Session,
    state: &UiState,
    pointing: Pointing,
) -> Vec<(&'static str, &'static str)> {
    let mut lines = vec![("Look around", state.navigation.summary(pointing))];
    let shapes = session.scene().shapes();
    let with_keys = match state.navigation {
        Navigation::Blender => "press J and drag a bone, or drag a number at the right",
        _ => "press B and drag a bone, or drag a number at the right",
    };
    lines.push(match state.pose.tool {
        Tool::Pose => ("Pose", "drag a bone, or a number at the right"),
        _ => (
            "Pose",
            pointing.words(with_keys, "tap Pose, the second tool, and drag a bone"),
        ),
    });
    if shapes
        .iter()
        .any(|shape| matches!(shape.kind, ShapeKind::Character(_)))
    {
        lines.push((
            "Check",
            "View ⏵ Compare with Mesh… tells what is wrong in yours",
        ));
    }
    lines.push((
        "More",
        pointing.words(
            "Insert adds shapes · ? shows every key",
            "Insert adds shapes · Help tells the rest",
        ),
    ));
    lines
}
