//! A character in the shape panel: how it is drawn, and its poses.

use super::method_view;
use super::number_field::NumberField;
use super::state::UiState;
use super::theme::Palette;
use super::widgets::{choice, foldable, labelled, named, section};
use super::{Action, Ask, CompareMeshAction};
use crate::editor::{Edit, Session, for_all_selected};
use crate::scene::{
    BoneStyle, CharacterDisplay, CharacterShape, EvaluatedGeometry, JointStyle, Look, ModelDisplay,
    ShapeId, SkinningMethod,
};
use egui::{Button, Label, RichText, TextEdit, Ui, vec2};

/// Diameters of points and widths of lines that can be set, in pixels.
const POINT_SIZES: std::ops::RangeInclusive<f64> = 1.0..=64.0;
const LINE_WIDTHS: std::ops::RangeInclusive<f64> = 1.0..=32.0;

const BONES_OVER_ALL: &str = "The Mannequin look draws bones as red lines, over every mesh: Mesh Model and Both are \
                              the same until View ⏵ Bones hides them.";
const BONES_OF_SKELETONS: &str = "The Mannequin look draws bones as red lines. View ⏵ Bones is off, so that those of \
                                  Mesh Models are hidden.";

/// How a character is drawn: mesh, skeleton or both, and its joints and bones.
pub(super) fn display(
    ui: &mut Ui,
    session: &Session,
    id: ShapeId,
    display: CharacterDisplay,
    actions: &mut Vec<Action>,
) {
    let mut changed = display;
    section(ui, "Model Display Mode");
    choice(
        ui,
        &mut changed.mode,
        &[
            (
                ModelDisplay::Skeleton,
                "Skeletal Model",
                "Show joints and bones",
            ),
            (ModelDisplay::Mesh, "Mesh Model", "Show the deformed mesh"),
            (
                ModelDisplay::Both,
                "Both",
                "Show the mesh with the skeleton seen through it",
            ),
        ],
    );
    let look = session.view().look;
    if display.mode != ModelDisplay::Mesh {
        // The Mannequin look draws bones in one way, which is not to be chosen there.
        ui.add_enabled_ui(look != Look::Mannequin, |ui| {
            skeleton(ui, display, &mut changed);
        });
    }
    if look == Look::Mannequin {
        let bones = if session.view().bones {
            BONES_OVER_ALL
        } else {
            BONES_OF_SKELETONS
        };
        let color = Palette::of(ui.visuals()).weak;
        ui.add(Label::new(RichText::new(bones).small().color(color)).wrap());
    }
    if changed != display {
        let edit = Edit::SetDisplay(id, changed);
        actions.push(Action::Edit(for_all_selected(session, edit)));
    }
}

/// How joints and bones are drawn.
fn skeleton(ui: &mut Ui, display: CharacterDisplay, changed: &mut CharacterDisplay) {
    let default = CharacterDisplay::default();
    labelled(ui, "Joints", |ui, _| {
        let joints = [
            (JointStyle::Points, "Points", "Draw joints as round points"),
            (JointStyle::Spheres, "Spheres", "Draw joints as spheres"),
        ];
        choice(ui, &mut changed.joints, &joints);
        if display.joints == JointStyle::Points {
            let field = NumberField::new("Point size", display.point_size, 0.5)
                .rest(default.point_size)
                .range(POINT_SIZES)
                .unit(" px");
            changed.point_size = beside(ui, field).unwrap_or(changed.point_size);
        }
    });
    labelled(ui, "Bones", |ui, _| {
        let bones = [
            (BoneStyle::Lines, "Lines", "Draw bones as lines"),
            (BoneStyle::Boxes, "Boxes", "Draw bones as boxes"),
        ];
        choice(ui, &mut changed.bones, &bones);
        if display.bones == BoneStyle::Lines {
            let field = NumberField::new("Line width", display.line_width, 0.5)
                .rest(default.line_width)
                .range(LINE_WIDTHS)
                .unit(" px");
            changed.line_width = beside(ui, field).unwrap_or(changed.line_width);
        }
    });
}

/// A field as wide as the rest of the row.
fn beside(ui: &mut Ui, field: NumberField) -> Option<f32> {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    field.show(ui, size)
}

/// How the mesh follows the joints, and how much of its volume is left.
pub(super) fn skinning(
    ui: &mut Ui,
    id: ShapeId,
    character: &CharacterShape,
    session: &Session,
    state: &mut UiState,
    actions: &mut Vec<Action>,
) {
    let method = character.skinning_method();
    foldable(ui, "Skinning", "skinning", |ui| {
        let mut changed = method;
        let methods = [
            (
                SkinningMethod::LinearBlend,
                "Linear Blend",
                "Add up where each joint takes a vertex, by weight: the assignment's formula",
            ),
            (
                SkinningMethod::DualQuaternion,
                "Dual Quaternion",
                "Blend the joints' motions into one that keeps the volume of what is twisted",
            ),
        ];
        choice(ui, &mut changed, &methods);
        if changed != method {
            actions.push(Action::Edit(Edit::SetSkinningMethod(id, changed)));
        }
        let mistaken = state.explain.mistaken(session, id);
        let evaluated = session.evaluated().shape(id);
        let geometry = mistaken.or(evaluated.map(|shape| &*shape.geometry));
        if let Some(kept) = geometry.and_then(EvaluatedGeometry::volume_kept) {
            let by = match mistaken {
                Some(_) => ", with the mistake",
                None => "",
            };
            let volume = format!("Volume {:.1} % of the bind pose{by}", kept * 100.0);
            let volume = ui.label(volume);
            volume.on_hover_text("Signed volume inside the mesh, shown for closed meshes");
        }
        method_view::choice(ui, session, id, &mut state.methods);
        let compare = ui.button("Compare with a Mesh of Yours…");
        let tip =
            "See how far off a mesh is that your program has posed, and which mistake gives it";
        if compare.on_hover_text(tip).clicked() {
            let choose = CompareMeshAction::Choose(id);
            actions.push(Action::Ask(Ask::CompareMesh(choose)));
        }
    });
}

/// Poses kept with a character: a click applies one.
pub(super) fn poses(
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
    foldable(ui, &title, "poses", |ui| {
        for (index, kept) in character.poses().iter().enumerate() {
            ui.horizontal(|ui| {
                let current = kept.pose == *character.pose();
                let take = ui.add(Button::selectable(current, &kept.name).truncate());
                if take.on_hover_text("Apply this pose").clicked() {
                    actions.push(Action::Edit(Edit::SetPose(id, kept.pose.clone())));
                }
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    let forget = named(ui.button("×"), &format!("Forget {}", kept.name));
                    if forget
                        .on_hover_text("Remove this pose from the list")
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

/// A field for a name, and a button that keeps the current pose under it.
fn keep(
    ui: &mut Ui,
    id: ShapeId,
    character: &CharacterShape,
    name: &mut String,
    actions: &mut Vec<Action>,
) {
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        let typed = name.trim();
        let (does, tip) = if character.poses().iter().any(|kept| kept.name == typed) {
            (
                "Replace",
                "Keep the current pose in place of the one of this name",
            )
        } else {
            ("Keep", "Keep the current pose under this name")
        };
        let keep = ui.button(does).on_hover_text(tip);
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
