use super::state::UiState;
use super::{curve_display, curve_list, display, joint_list, pose_list, properties, shape_list};
use crate::editor::{Session, View};
use crate::scene::ShapeKind;
use crate::ui::Action;
use egui::{Frame, Margin, Panel, RichText, ScrollArea, Ui};

/// The course's width, margins included.
const WIDTH: f32 = 280.0;
const NARROWEST: f32 = 248.0;
const WIDEST: f32 = 560.0;

/// The panel at the right: the list of shapes and everything about the selected one.
pub(super) fn show(
    root: &mut Ui,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    let widest = (root.available_width() * 0.7).clamp(NARROWEST, WIDEST);
    let frame = Frame::side_top_panel(root.style()).inner_margin(Margin::symmetric(8, 4));
    Panel::right("shape panel")
        .frame(frame)
        .default_size(WIDTH)
        .size_range(NARROWEST..=widest)
        .show(root, |ui| {
            let title = RichText::new("Shape Selector and Properties").heading();
            ui.add(egui::Label::new(title).truncate());
            ui.separator();
            let newly_selected = session.selected() != state.selected;
            state.selected = session.selected();
            shape_list::show(ui, session, newly_selected, actions);
            ui.separator();
            ScrollArea::vertical()
                .id_salt("properties")
                .auto_shrink(false)
                .show(ui, |ui| selected(ui, session, state, actions));
        });
}

fn selected(ui: &mut Ui, session: &Session, state: &mut UiState, actions: &mut Vec<Action>) {
    state.curves.hovered = None;
    let shape = session.selected().and_then(|id| session.scene().shape(id));
    let Some(shape) = shape else {
        if !session.scene().shapes().is_empty() {
            ui.label(RichText::new("Select a shape in the list or in the view.").weak());
        }
        leave_joints(state, actions);
        return;
    };
    ui.push_id(shape.id, |ui| {
        properties::show(ui, shape, actions);
        if let ShapeKind::Character(character) = &shape.kind {
            ui.separator();
            display::show(ui, shape.id, character.display, actions);
            ui.separator();
            pose_list::show(
                ui,
                shape.id,
                character,
                &mut state.joints.pose_name,
                actions,
            );
            ui.separator();
            joint_list::show(ui, session, shape.id, &mut state.joints, actions);
        } else {
            leave_joints(state, actions);
        }
        if let ShapeKind::Curve(curve) = &shape.kind {
            ui.separator();
            curve_display::show(ui, shape.id, curve, actions);
            ui.separator();
            curve_list::show(ui, session, shape.id, &mut state.curves, actions);
        }
    });
}

/// Where no joints are listed, none is under the pointer.
fn leave_joints(state: &mut UiState, actions: &mut Vec<Action>) {
    if state.joints.hovered.take().is_some() {
        actions.push(Action::View(View::HoverJoint(None)));
    }
}
