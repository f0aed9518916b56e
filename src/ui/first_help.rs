//! The first help: what newcomers do first.

use super::Navigation;
use super::pointing::Pointing;
use super::posing::BAR_HEIGHT;
use super::state::UiState;
use super::theme::Palette;
use super::widgets::{cover, named};
use crate::editor::{Session, Tool};
use crate::scene::ShapeKind;
use egui::{
    Align, Button, Color32, Frame, Label, Layout, Margin, Rect, RichText, TextStyle, Ui, UiBuilder,
    pos2, vec2,
};

/// Width of what can be done and of how, in points; how is below it in narrow views. Wider ones would reach the figure in
/// the middle of the view.
const WHAT: f32 = 80.0;
const HOW: f32 = 236.0;
/// Distance between both, and between lines, in points.
const GAP: f32 = 12.0;
const LINE_GAP: f32 = 4.0;
/// Width of the ×, in points.
const CLOSE: f32 = 24.0;
const MARGIN: Margin = Margin::symmetric(12, 8);

/// First help: lines for newcomers in the lower left corner of the view; whether their × was clicked.
pub(super) fn show(ui: &mut Ui, view: Rect, session: &Session, state: &UiState) -> bool {
    let lines = first_steps(session, state, Pointing::of(ui.ctx()));
    let wide = MARGIN.sum().x + WHAT + GAP + HOW + CLOSE;
    let is_narrow = view.width() < wide + 24.0;
    let width = if is_narrow { wide - WHAT - GAP } else { wide };
    let height = |how: &str| {
        let font = TextStyle::Small.resolve(ui.style());
        let how = ui
            .painter()
            .layout(how.to_owned(), font, Color32::WHITE, HOW);
        let what = ui.text_style_height(&TextStyle::Body);
        LINE_GAP
            + match is_narrow {
                true => what + LINE_GAP + how.size().y,
                false => what.max(how.size().y),
            }
    };
    let heights = lines.iter().map(|(_, how)| height(how)).sum::<f32>();
    let size = vec2(width, MARGIN.sum().y + heights);
    if view.width() < size.x + 24.0 || view.height() < size.y + 3.0 * BAR_HEIGHT {
        return false;
    }
    let corner = pos2(view.left() + 12.0, view.bottom() - size.y - 12.0);
    let place = Rect::from_min_size(corner, size);
    let builder = UiBuilder::new().id_salt("first help").max_rect(place);
    let mut inner = ui.new_child(builder);
    cover(&inner, place);
    let mut closed = false;
    Frame::popup(ui.style())
        .inner_margin(MARGIN)
        .show(&mut inner, |ui| {
            ui.with_layout(Layout::left_to_right(Align::TOP), |ui| {
                ui.vertical(|ui| {
                    ui.spacing_mut().item_spacing = vec2(GAP, LINE_GAP);
                    for (what, how) in lines {
                        let strong = Palette::of(ui.visuals()).strong;
                        let what = RichText::new(what).color(strong);
                        let how = Label::new(RichText::new(how).small()).wrap();
                        if is_narrow {
                            ui.set_width(HOW);
                            ui.label(what);
                            ui.add(how);
                            continue;
                        }
                        ui.horizontal_top(|ui| {
                            in_column(ui, WHAT, Label::new(what).extend());
                            in_column(ui, HOW, how);
                        });
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

fn in_column(ui: &mut Ui, width: f32, label: Label) {
    ui.vertical(|ui| {
        ui.set_width(width);
        ui.add(label);
    });
}

/// What newcomers do first, and how.
fn first_steps(
    session: &Session,
    state: &UiState,
    pointing: Pointing,
) -> Vec<(&'static str, &'static str)> {
    let mut lines = vec![("Look around", state.navigation.summary(pointing))];
    let shapes = session.scene().shapes();
    let is_any = |is: fn(&ShapeKind) -> bool| shapes.iter().any(|shape| is(&shape.kind));
    let has_character = is_any(|kind| matches!(kind, ShapeKind::Character(_)));
    let has_curve = is_any(|kind| matches!(kind, ShapeKind::Curve(_)));
    lines.push(match has_curve && !has_character {
        true => ("Shape", "drag a control point, or a number at the right"),
        false => ("Pose", posing(state, pointing)),
    });
    if has_character {
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

/// How a character is posed.
fn posing(state: &UiState, pointing: Pointing) -> &'static str {
    let with_keys = match state.navigation {
        Navigation::Blender => "press J and drag a bone, or drag a number at the right",
        _ => "press B and drag a bone, or drag a number at the right",
    };
    match state.pose.tool {
        Tool::Pose => "drag a bone, or a number at the right",
        _ => pointing.words(with_keys, "tap Pose, the second tool, and drag a bone"),
    }
}
