use super::state::UiState;
use super::theme::Palette;
use super::{ViewInput, posing};
use crate::editor::Session;
use egui::{Align, Frame, Label, Layout, Margin, Panel, RichText, Ui};

/// The line below the view: what the pointer is over and what the next gesture would do; at the
/// right, how fast and by what pictures are drawn.
pub(super) fn show(root: &mut Ui, session: &Session, state: &UiState, input: &ViewInput) {
    let frame = Frame::side_top_panel(root.style()).inner_margin(Margin::symmetric(8, 2));
    Panel::bottom("status line").frame(frame).show(root, |ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let weak = Palette::of(ui.visuals()).weak;
            let machine = machine(input);
            if !machine.is_empty() && ui.available_width() > 480.0 {
                ui.label(RichText::new(machine).small().color(weak));
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let (over, next) = sentence(session, state, input);
                if let Some(over) = over {
                    let color = Palette::of(ui.visuals()).strong;
                    ui.add(Label::new(RichText::new(over).small().color(color)).truncate());
                }
                ui.add(Label::new(RichText::new(next).small().color(weak)).truncate());
            });
        });
    });
}

fn machine(input: &ViewInput) -> String {
    match input.frames_per_second {
        Some(rate) => format!("{rate:.0} fps · {}", input.backend),
        None => input.backend.to_owned(),
    }
}

/// What the pointer is over, if anything, and what gestures do there.
fn sentence(
    session: &Session,
    state: &UiState,
    input: &ViewInput,
) -> (Option<String>, &'static str) {
    let navigation = state.navigation;
    if let Some(point) = hovered_control_point(session) {
        let next = "Drag to move it · Esc or right click cancels";
        return (Some(point), next);
    }
    if let Some((over, next)) = posing::sentence(session, &state.pose) {
        return (over, next);
    }
    if let Some(joint) = hovered_joint(session) {
        let next = "Click to select the joint · drag its numbers to turn it";
        return (Some(joint), next);
    }
    let over = input
        .hovered_shape
        .and_then(|id| session.scene().shape(id))
        .map(|shape| (shape.id, format!("{} (ID: {})", shape.name, shape.id)));
    match over {
        Some((id, name)) if session.selected() != Some(id) => {
            (Some(name), navigation.over_a_shape())
        }
        over => (over.map(|(_, name)| name), navigation.summary()),
    }
}

fn hovered_joint(session: &Session) -> Option<String> {
    let joint = session.hovered_joint()?;
    let character = session.scene().character(session.selected()?)?;
    let joints = character.character.skeleton().joints();
    joints.get(joint).map(|joint| joint.name.clone())
}

fn hovered_control_point(session: &Session) -> Option<String> {
    let (curve, point) = session.hovered_control_point()?;
    let shape = session.scene().curve(session.selected()?)?;
    let item = shape.curves().items().get(curve)?;
    Some(format!("{}, control point {}", item.name, point + 1))
}
