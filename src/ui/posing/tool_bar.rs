//! The tool bar: tools, and the settings of the IK tool.

use super::PoseState;
use super::ik::{IkState, joint_to_pin};
use crate::character::Facing;
use crate::editor::{GizmoAxes, IkPole, Session, Tool};
use crate::ui::commands::Command;
use crate::ui::number_field::NumberField;
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use crate::ui::{axis_ball, commands};
use egui::{Button, ComboBox, Frame, Margin, Rect, Sense, Ui, UiBuilder, vec2};

/// Height of the tool bar with its margins, in points; a second line for the IK tool adds at most
/// as much.
pub(in crate::ui) const BAR_HEIGHT: f32 = 36.0;

/// The tools, with their labels in the bar.
const TOOLS: [(Tool, &str); 4] = [
    (Tool::Select, "Select"),
    (Tool::Pose, "Pose"),
    (Tool::Move, "Move"),
    (Tool::Ik, "IK"),
];

/// The tool bar in the upper left corner of the view.
pub(super) fn show(ui: &mut Ui, view: Rect, session: &Session, state: &mut PoseState) {
    let place = Rect::from_min_size(view.min + vec2(8.0, 8.0), vec2(480.0, 24.0));
    // Clicks between the buttons must not reach the scene behind them.
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
                if button(ui, word, state.tool == tool, command) {
                    state.tool = tool;
                }
            }
            if matches!(state.tool, Tool::Pose | Tool::Move) {
                ui.separator();
                let local = state.axes == GizmoAxes::Local;
                if button(ui, "Local", local, Command::ToggleLocalAxes) {
                    state.axes = state.axes.other();
                }
            }
        });
        if state.tool == Tool::Ik {
            let room = axis_ball::left(view) - place.left();
            ik_settings(ui, room, session, &mut state.ik);
        }
    });
}

fn button(ui: &mut Ui, word: &str, on: bool, command: Command) -> bool {
    let button = ui.add(Button::selectable(on, word));
    let button = named(button, commands::label(command));
    button
        .on_hover_text(commands::tooltip(ui.ctx(), command))
        .clicked()
}

/// Greatest length of a chain, in joints.
const LONGEST: usize = 999;

/// Width of the bar from which on the settings fit on one line, in points.
const ONE_LINE: f32 = 368.0;

/// Settings of the IK tool, in one line, or in two if there is no room for that. `room` is in
/// points.
fn ik_settings(ui: &mut Ui, room: f32, session: &Session, state: &mut IkState) {
    let in_line = |ui: &mut Ui, show: &mut dyn FnMut(&mut Ui)| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            show(ui);
        });
    };
    if room < ONE_LINE {
        in_line(ui, &mut |ui| chain(ui, session, state));
        in_line(ui, &mut |ui| end(ui, session, state));
    } else {
        in_line(ui, &mut |ui| {
            chain(ui, session, state);
            end(ui, session, state);
        });
    }
}

/// Length and bend of the chain.
fn chain(ui: &mut Ui, session: &Session, state: &mut IkState) {
    ui.label("Chain").on_hover_text(
        "How many joints turn: 2 for an arm or a leg, more for a spine or a tail. \
         A root or a pin ends it before.",
    );
    let length = NumberField::new("Chain length", state.chosen.length as f32, 0.05)
        .rest(2.0)
        .range(1.0..=LONGEST as f64)
        .decimals(0..=0);
    if let Some(length) = length.show(ui, vec2(32.0, 20.0)) {
        state.chosen.length = (length.round() as usize).clamp(1, LONGEST);
    }
    ui.label("Bend").on_hover_text(
        "Where knees and elbows point to, as the character stands at rest. Its front follows from \
         which joints are left and right, by name or place; +Z where nothing says.",
    );
    let selected = session
        .selected()
        .and_then(|id| session.scene().character(id));
    let facing = selected.map(|shape| shape.character.skeleton().facing());
    pole(ui, facing.unwrap_or_default(), &mut state.chosen.pole);
}

/// Orientation of the end, and pins.
fn end(ui: &mut Ui, session: &Session, state: &mut IkState) {
    let keep = state.chosen.keep_orientation;
    let flat = named(
        ui.add(Button::selectable(keep, "Flat")),
        "Keep the end's direction",
    );
    let tip = "The dragged joint keeps its orientation, as a foot stays flat";
    if flat.on_hover_text(tip).clicked() {
        state.chosen.keep_orientation = !keep;
    }
    pins(ui, session, state);
}

fn pole(ui: &mut Ui, facing: Facing, pole: &mut IkPole) {
    let combo = ComboBox::from_id_salt("bend")
        .selected_text(pole.label(facing))
        .width(88.0)
        .show_ui(ui, |ui| {
            for choice in IkPole::ALL {
                ui.selectable_value(pole, choice, choice.label(facing));
            }
        });
    named(combo.response, "Bend direction");
}

fn pins(ui: &mut Ui, session: &Session, state: &mut IkState) {
    let joint = joint_to_pin(session);
    let pinned = joint.is_some_and(|(shape, joint)| state.is_pinned(shape, joint));
    let pin = Button::selectable(pinned, "Pin");
    let why = "Select a joint first: click it in the view or in the list";
    if pin_button(ui, pin, joint.is_some(), Command::PinJoint, why)
        && let Some((shape, joint)) = joint
    {
        state.toggle_pin(shape, joint);
    }
    let unpin = Button::new("Unpin all");
    let why = "Nothing is pinned";
    if pin_button(ui, unpin, state.has_pins(), Command::UnpinAll, why) {
        state.unpin_all();
    }
}

fn pin_button(ui: &mut Ui, button: Button, enabled: bool, command: Command, why_not: &str) -> bool {
    let button = named(ui.add_enabled(enabled, button), commands::label(command));
    button
        .on_hover_text(commands::tooltip(ui.ctx(), command))
        .on_disabled_hover_text(why_not)
        .clicked()
}
