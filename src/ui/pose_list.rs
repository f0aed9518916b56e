use super::widgets::named;
use crate::editor::Edit;
use crate::scene::{CharacterShape, ShapeId};
use crate::ui::{Action, Ask};
use egui::{Button, CollapsingHeader, TextEdit, Ui};

/// The poses kept with a character: a click takes one on.
pub(super) fn show(
    ui: &mut Ui,
    id: ShapeId,
    character: &CharacterShape,
    name: &mut String,
    actions: &mut Vec<Action>,
) {
    let count = character.poses().len();
    let title = match count {
        0 => "Poses".to_owned(),
        count => format!("Poses ({count})"),
    };
    let header = CollapsingHeader::new(title).id_salt("poses");
    header.show(ui, |ui| {
        for (index, kept) in character.poses().iter().enumerate() {
            ui.horizontal(|ui| {
                let current = kept.pose == *character.pose();
                let take = ui.add(Button::selectable(current, &kept.name).truncate());
                if take.on_hover_text("Take on this pose").clicked() {
                    actions.push(Action::Edit(Edit::SetPose(id, kept.pose.clone())));
                }
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    let forget = named(ui.button("×"), &format!("Forget {}", kept.name));
                    if forget
                        .on_hover_text("Take this pose off the list")
                        .clicked()
                    {
                        actions.push(Action::Edit(Edit::ForgetPose(id, index)));
                    }
                    let save = named(ui.button("Save…"), &format!("Save {}", kept.name));
                    if save
                        .on_hover_text("Write this pose as a .json file")
                        .clicked()
                    {
                        actions.push(Action::Ask(Ask::SavePose(id, Some(index))));
                    }
                });
            });
        }
        ui.horizontal(|ui| keep(ui, id, character, name, actions));
    });
}

/// The field for a name, and the button that keeps the current pose under it.
fn keep(
    ui: &mut Ui,
    id: ShapeId,
    character: &CharacterShape,
    name: &mut String,
    actions: &mut Vec<Action>,
) {
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        let keep = ui
            .button("Keep")
            .on_hover_text("Keep the current pose under this name");
        let free = character.free_pose_name();
        let field = TextEdit::singleline(name)
            .hint_text(&free)
            .desired_width(f32::INFINITY);
        let field = named(ui.add(field), "Name of the pose");
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
        if keep.clicked() || entered {
            let typed = name.trim();
            let name_it = if typed.is_empty() {
                free
            } else {
                typed.to_owned()
            };
            name.clear();
            actions.push(Action::Edit(Edit::KeepPose {
                shape: id,
                name: name_it,
            }));
        }
    });
}
