use super::ik::{self, IkState};
use crate::character::Facing;
use crate::editor::{IkPole, Session};
use crate::ui::keys::{self, Command};
use crate::ui::number_field::NumberField;
use crate::ui::widgets::named;
use egui::{Button, ComboBox, Ui, vec2};

/// What a number for all joints of a row would be.
const MOST: usize = 999;

/// What the bar is wide in one line, with some to spare.
const ONE_LINE: f32 = 368.0;

/// What can be chosen for the IK tool, in the bar of tools: in a line, or in two if there is not
/// so much room.
pub(super) fn show(ui: &mut Ui, room: f32, session: &Session, state: &mut IkState) {
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

/// How the chain follows.
fn chain(ui: &mut Ui, session: &Session, state: &mut IkState) {
    ui.label("Chain").on_hover_text(
        "How many joints turn: 2 for an arm or a leg, more for a spine or a tail. \
         A root or a pin ends it before.",
    );
    let length = NumberField::new("Chain length", state.chosen.length as f32, 0.05)
        .rest(2.0)
        .range(1.0..=MOST as f64)
        .decimals(0..=0);
    if let Some(length) = length.show(ui, vec2(32.0, 20.0)) {
        state.chosen.length = (length.round() as usize).clamp(1, MOST);
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

/// What holds still.
fn end(ui: &mut Ui, session: &Session, state: &mut IkState) {
    let keep = state.chosen.keep_orientation;
    let flat = named(
        ui.add(Button::selectable(keep, "Flat")),
        "Keep the end's direction",
    );
    let tip = "The joint that is dragged stays turned as it is, as a foot stays flat";
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
    let joint = ik::joint_to_pin(session);
    let pinned = joint.is_some_and(|(shape, joint)| state.is_pinned(shape, joint));
    let pin = Button::selectable(pinned, "Pin");
    let why = "Select a joint first: click it in the view or in the list";
    if button(ui, pin, joint.is_some(), Command::PinJoint, why)
        && let Some((shape, joint)) = joint
    {
        state.toggle_pin(shape, joint);
    }
    let unpin = Button::new("Unpin all");
    let why = "Nothing is pinned";
    if button(ui, unpin, state.has_pins(), Command::UnpinAll, why) {
        state.unpin_all();
    }
}

fn button(ui: &mut Ui, button: Button, enabled: bool, command: Command, why_not: &str) -> bool {
    let button = named(ui.add_enabled(enabled, button), keys::label(command));
    button
        .on_hover_text(keys::tooltip(ui.ctx(), command))
        .on_disabled_hover_text(why_not)
        .clicked()
}
