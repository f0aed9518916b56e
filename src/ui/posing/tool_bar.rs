//! The tool bar: tools, and the settings of the IK tool.

use super::ik::{self, joints_to_pin};
use super::{PoseState, tool_icons};
use crate::character::Facing;
use crate::editor::{Edit, GizmoAxes, Session, Tool};
use crate::scene::{CharacterShape, IkPole, IkSettings, ShapeId};
use crate::ui::Action;
use crate::ui::commands::Command;
use crate::ui::number_field::NumberField;
use crate::ui::pointing::Pointing;
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use crate::ui::{axis_ball, commands, menu_keys};
use egui::{
    Atom, Button, Color32, ComboBox, Context, Frame, Id, Margin, Rect, Sense, TextStyle, Ui,
    UiBuilder, vec2,
};

/// Height of the tool bar with its margins, in points; a second line for the IK tool adds at most
/// as much.
pub(in crate::ui) const BAR_HEIGHT: f32 = 36.0;

/// The tools, with their labels in the bar.
const TOOLS: [(Tool, &str); 6] = [
    (Tool::Select, "Select"),
    (Tool::Pose, "Pose"),
    (Tool::Ik, "IK"),
    (Tool::Move, "Move"),
    (Tool::Rotate, "Rotate"),
    (Tool::Scale, "Scale"),
];

/// The tool bar in the upper left corner of the view.
pub(super) fn show(
    ui: &mut Ui,
    view: Rect,
    session: &Session,
    state: &mut PoseState,
    actions: &mut Vec<Action>,
) {
    let corner = view.min + vec2(8.0, 8.0);
    let room = (axis_ball::left(view) - corner.x - 8.0).max(0.0);
    let place = Rect::from_min_size(corner, vec2(room.min(480.0), 24.0));
    // Clicks between the buttons must not reach the scene behind them.
    let builder = UiBuilder::new()
        .id_salt("tools")
        .max_rect(place)
        .sense(Sense::click_and_drag());
    let mut inner = ui.new_child(builder);
    let room = axis_ball::left(view) - place.left();
    let has_axes = matches!(state.tool, Tool::Pose | Tool::Move | Tool::Rotate);
    let fill = Palette::of(ui.visuals()).panel;
    let frame = Frame::new()
        .fill(fill)
        .corner_radius(4)
        .inner_margin(Margin::same(2));
    let bar = frame.show(&mut inner, |ui| {
        let has_words = width_with_words(ui) <= room;
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            if !has_words {
                ui.spacing_mut().button_padding.x = 6.0;
            }
            for (tool, word) in TOOLS {
                if tool_button(ui, tool, has_words.then_some(word), state.tool == tool) {
                    state.tool = tool;
                }
            }
            if has_axes && room >= WITH_AXES {
                ui.separator();
                local_axes(ui, state);
            }
        });
        if has_axes && room < WITH_AXES {
            ui.horizontal(|ui| local_axes(ui, state));
        }
        if state.tool == Tool::Ik {
            ik_settings(ui, room, session, actions);
        }
    });
    state.bar_bottom = bar.response.rect.bottom() - view.top();
}

/// Width of the bar in points if all of it has words. It is the same for all tools, so that buttons
/// stay where they are.
fn width_with_words(ui: &Ui) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let width = |word: &str| {
        let painter = ui.painter();
        let text = painter.layout_no_wrap(word.to_owned(), font.clone(), Color32::WHITE);
        text.size().x + 2.0 * ui.spacing().button_padding.x + 2.0
    };
    let icon = tool_icons::SIZE.x + ui.spacing().icon_spacing;
    let tools: f32 = TOOLS.iter().map(|(_, word)| icon + width(word)).sum();
    tools + width("Local") + 16.0
}

/// Button of a tool, with a word beside its icon if there is room for it.
fn tool_button(ui: &mut Ui, tool: Tool, word: Option<&str>, on: bool) -> bool {
    let command = Command::SetTool(tool);
    let icon = Id::new("icon of a tool");
    let atom = Atom::custom(icon, tool_icons::SIZE);
    let button = match word {
        Some(word) => Button::selectable(on, (atom, word)),
        None => Button::selectable(on, atom),
    };
    let shown = button.atom_ui(ui);
    if let Some(rect) = shown.rect(icon) {
        let color = if on {
            ui.visuals().selection.stroke.color
        } else {
            ui.style().interact(&shown.response).text_color()
        };
        tool_icons::paint(ui.painter(), rect, tool, color);
    }
    named(shown.response, commands::label(command))
        .on_hover_text(tip(ui.ctx(), command))
        .clicked()
}

/// Name of a tool and what it does, in words for what points: where there is little room, no word stands beside its icon.
fn tip(ctx: &Context, command: Command) -> String {
    let label = commands::label(command);
    match Pointing::of(ctx) {
        Pointing::Mouse => format!("{label}: {}", commands::tooltip(ctx, command)),
        Pointing::Fingers => {
            let tip = commands::entry_of(command).map_or("", |entry| entry.tooltip);
            let tip = tip
                .replace("Left drag", "a finger")
                .replace("the pointer", "it");
            format!("{label}: {tip}")
        }
    }
}

/// The switch between the axes of the world and those of the joint or shape.
fn local_axes(ui: &mut Ui, state: &mut PoseState) {
    let local = state.axes == GizmoAxes::Local;
    if button(ui, "Local", local, Command::ToggleLocalAxes) {
        state.axes = state.axes.other();
    }
}

fn button(ui: &mut Ui, word: &str, on: bool, command: Command) -> bool {
    let button = ui.add(Button::selectable(on, word));
    let button = named(button, commands::label(command));
    button
        .on_hover_text(commands::tooltip(ui.ctx(), command))
        .clicked()
}

/// Width of the bar from which on the switch between axes fits beside the tools, in points.
const WITH_AXES: f32 = 360.0;
/// Width of the bar from which on the settings fit on one line, in points.
const ONE_LINE: f32 = 368.0;
/// The same for two lines; below it there are three.
const TWO_LINES: f32 = 212.0;

/// Settings of the IK tool for the selected character, or for all if none is selected: in one line,
/// or in more if there is no room for that. `room` is in points.
fn ik_settings(ui: &mut Ui, room: f32, session: &Session, actions: &mut Vec<Action>) {
    let characters = characters(session);
    let shown = characters.first().map(|(_, shape)| &shape.ik);
    let mut ik = shown.cloned().unwrap_or_default();
    let facing = characters
        .first()
        .map(|(_, shape)| shape.character.skeleton().facing())
        .unwrap_or_default();
    let in_line = |ui: &mut Ui, show: &mut dyn FnMut(&mut Ui)| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            show(ui);
        });
    };
    if room < TWO_LINES {
        in_line(ui, &mut |ui| chain_length(ui, &mut ik));
        in_line(ui, &mut |ui| bend(ui, facing, &mut ik));
    } else if room < ONE_LINE {
        in_line(ui, &mut |ui| {
            chain_length(ui, &mut ik);
            bend(ui, facing, &mut ik);
        });
    }
    in_line(ui, &mut |ui| {
        if room >= ONE_LINE {
            chain_length(ui, &mut ik);
            bend(ui, facing, &mut ik);
        }
        keep_orientation(ui, &mut ik);
        pins(ui, session, actions);
    });
    if shown.is_some_and(|shown| *shown != ik) {
        let with_own_pins = |(id, shape): &(ShapeId, &CharacterShape)| {
            let pins = shape.ik.pins.clone();
            Edit::SetIk(*id, IkSettings { pins, ..ik.clone() })
        };
        let edits = characters.iter().map(with_own_pins).collect();
        actions.push(Action::Edit(Edit::Together(edits)));
    }
}

/// The selected character, or all characters.
fn characters(session: &Session) -> Vec<(ShapeId, &CharacterShape)> {
    let scene = session.scene();
    let character = |id| Some((id, scene.character(id)?));
    match session.selected().and_then(character) {
        Some(selected) => vec![selected],
        None => {
            let ids = scene.shapes().iter().map(|shape| shape.id);
            ids.filter_map(character).collect()
        }
    }
}

fn chain_length(ui: &mut Ui, ik: &mut IkSettings) {
    ui.label("Chain").on_hover_text(
        "How many joints turn: 2 for an arm or a leg, more for a spine or a tail. \
         A root or a pin ends it before.",
    );
    let length = NumberField::new("Chain length", ik.length as f32, 0.05)
        .rest(2.0)
        .range(1.0..=IkSettings::LONGEST as f64)
        .decimals(0..=0);
    if let Some(length) = length.show(ui, vec2(32.0, 20.0)) {
        ik.length = (length.round() as usize).clamp(1, IkSettings::LONGEST);
    }
}

fn bend(ui: &mut Ui, facing: Facing, ik: &mut IkSettings) {
    ui.label("Bend").on_hover_text(
        "Where knees and elbows point to, as the character stands at rest. Its front follows from \
         which joints are left and right, by name or place; +Z where nothing says.",
    );
    pole(ui, facing, &mut ik.pole);
}

fn keep_orientation(ui: &mut Ui, ik: &mut IkSettings) {
    let flat = named(
        ui.add(Button::selectable(ik.keep_orientation, "Flat")),
        "Keep the end's direction",
    );
    let tip = "The dragged joint keeps its orientation, as a foot stays flat";
    if flat.on_hover_text(tip).clicked() {
        ik.keep_orientation = !ik.keep_orientation;
    }
}

fn pole(ui: &mut Ui, facing: Facing, pole: &mut IkPole) {
    let combo = ComboBox::from_id_salt("bend")
        .selected_text(pole.label(facing))
        .width(88.0)
        .show_ui(ui, |ui| {
            menu_keys::level(ui, None, |ui| {
                for choice in IkPole::ALL {
                    let is_current = *pole == choice;
                    let item = ui.selectable_label(is_current, choice.label(facing));
                    if menu_keys::is_chosen(ui, &item, is_current) {
                        *pole = choice;
                    }
                }
            });
        });
    named(combo.response, "Bend direction");
}

fn pins(ui: &mut Ui, session: &Session, actions: &mut Vec<Action>) {
    let joints = joints_to_pin(session);
    let joints = joints.as_ref();
    let pinned = joints.is_some_and(|(shape, joints)| ik::are_pinned(session, *shape, joints));
    let pin = Button::selectable(pinned, "Pin");
    let why = Pointing::of(ui.ctx()).words(
        "Select a joint first: click it in the view or in the list",
        "Select a joint first: tap it in the view or in the list",
    );
    if pin_button(ui, pin, joints.is_some(), Command::PinJoint, why)
        && let Some((shape, joints)) = joints
    {
        actions.extend(ik::toggle_pins(session, *shape, joints).map(Action::Edit));
    }
    let unpin = Button::new("Unpin all");
    let why = "Nothing is pinned";
    if pin_button(ui, unpin, ik::has_pins(session), Command::UnpinAll, why) {
        actions.push(Action::Edit(ik::unpin_all(session)));
    }
}

fn pin_button(ui: &mut Ui, button: Button, enabled: bool, command: Command, why_not: &str) -> bool {
    let button = named(ui.add_enabled(enabled, button), commands::label(command));
    button
        .on_hover_text(commands::tooltip(ui.ctx(), command))
        .on_disabled_hover_text(why_not)
        .clicked()
}
