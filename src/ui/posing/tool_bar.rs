use super::ik_bar;
use crate::editor::{GizmoAxes, Session, Tool};
use crate::ui::axis_ball;
use crate::ui::keys::{self, Command};
use crate::ui::state::UiState;
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use egui::{Button, Frame, Margin, Rect, Sense, Ui, UiBuilder, vec2};

/// From the view's top to what may lie below the bar, and of each further line for the IK tool
/// not more.
pub(in crate::ui) const BAR_HEIGHT: f32 = 36.0;

/// The tools, with their words in the bar.
const TOOLS: [(Tool, &str); 4] = [
    (Tool::Select, "Select"),
    (Tool::Pose, "Pose"),
    (Tool::Move, "Move"),
    (Tool::Ik, "IK"),
];

/// The bar of tools in the view's upper left corner.
pub(super) fn show(ui: &mut Ui, view: Rect, session: &Session, state: &mut UiState) {
    let place = Rect::from_min_size(view.min + vec2(8.0, 8.0), vec2(480.0, 24.0));
    // What is pressed between the buttons is not meant for the scene behind them.
    let builder = UiBuilder::new()
        .id_salt("tools")
        .max_rect(place)
        .sense(Sense::click_and_drag());
    let mut inner = ui.new_child(builder);
    let fill = Palette::of(ui.visuals()).panel;
    let frame = Frame::new()
        .fill(fill)
        .corner_radius(4)
        .inner_margin(Margin::same(2));
    frame.show(&mut inner, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            for (tool, word) in TOOLS {
                let command = Command::SetTool(tool);
                if button(ui, word, state.pose.tool == tool, command) {
                    state.pose.tool = tool;
                }
            }
            if matches!(state.pose.tool, Tool::Pose | Tool::Move) {
                ui.separator();
                let local = state.pose.axes == GizmoAxes::Local;
                if button(ui, "Local", local, Command::ToggleLocalAxes) {
                    state.pose.axes = state.pose.axes.other();
                }
            }
        });
        if state.pose.tool == Tool::Ik {
            let room = axis_ball::left(view) - place.left();
            ik_bar::show(ui, room, session, &mut state.pose.ik);
        }
    });
}

fn button(ui: &mut Ui, word: &str, on: bool, command: Command) -> bool {
    let button = ui.add(Button::selectable(on, word));
    let button = named(button, keys::label(command));
    button
        .on_hover_text(keys::tooltip(ui.ctx(), command))
        .clicked()
}
