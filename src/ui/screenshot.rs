use super::number_field::NumberField;
use super::properties::labelled;
use crate::ui::{Action, Ask, Screenshot};
use egui::{Align, Button, Frame, Id, Key, Layout, Modal, Modifiers, RichText, Ui, vec2};

/// The smallest and largest side of a picture, in pixels.
const SIDES: std::ops::RangeInclusive<f64> = 16.0..=8192.0;

/// What the dialog of File ▸ Screenshot was last set to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ScreenshotForm {
    with_panels: bool,
    own_size: bool,
    width: u32,
    height: u32,
}

impl Default for ScreenshotForm {
    fn default() -> Self {
        Self {
            with_panels: false,
            own_size: false,
            width: 1920,
            height: 1080,
        }
    }
}

impl ScreenshotForm {
    fn asked(&self) -> Screenshot {
        let own_size = self.own_size && !self.with_panels;
        Screenshot {
            with_panels: self.with_panels,
            size: own_size.then_some((self.width, self.height)),
        }
    }
}

/// The dialog; whether it is to be closed.
pub(super) fn show(ui: &Ui, form: &mut ScreenshotForm, actions: &mut Vec<Action>) -> bool {
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(Id::new("screenshot")).frame(frame);
    let modal = modal.show(ui.ctx(), |ui| {
        ui.set_width(344.0);
        ui.heading("Screenshot");
        ui.label(RichText::new("Saves a picture as PNG, JPEG or GIF.").weak());
        ui.add_space(8.0);
        // Before a field gives the keyboard away because of the same Enter.
        let typing = ui.ctx().text_edit_focused();
        contents(ui, form);
        ui.add_space(12.0);
        buttons(ui, form, !typing, actions)
    });
    modal.inner || modal.should_close()
}

fn contents(ui: &mut Ui, form: &mut ScreenshotForm) {
    labelled(ui, "Show", |ui, _| {
        ui.spacing_mut().item_spacing.x = 16.0;
        ui.radio_value(&mut form.with_panels, false, "The view alone");
        ui.radio_value(&mut form.with_panels, true, "With panels");
    });
    ui.add_enabled_ui(!form.with_panels, |ui| {
        const WHY: &str = "Panels are drawn for the window, so the picture has its size";
        labelled(ui, "Size", |ui, _| {
            ui.spacing_mut().item_spacing.x = 16.0;
            ui.radio_value(&mut form.own_size, false, "As in the window")
                .on_disabled_hover_text(WHY);
            ui.radio_value(&mut form.own_size, true, "Custom")
                .on_disabled_hover_text(WHY);
        });
        ui.add_enabled_ui(form.own_size, |ui| {
            labelled(ui, "", |ui, size| {
                let each = vec2((size.x - 20.0) / 2.0, size.y);
                side(ui, "Picture width", &mut form.width, 1920.0, each);
                ui.label("×");
                side(ui, "Picture height", &mut form.height, 1080.0, each);
            });
        });
    });
}

fn side(ui: &mut Ui, name: &str, value: &mut u32, rest: f32, size: egui::Vec2) {
    let field = NumberField::new(name, *value as f32, 1.0)
        .rest(rest)
        .range(SIDES)
        .decimals(0..=0)
        .unit(" px");
    if let Some(given) = field.show(ui, size) {
        *value = given.round() as u32;
    }
}

/// Whether one of the two was used.
fn buttons(
    ui: &mut Ui,
    form: &ScreenshotForm,
    enter_saves: bool,
    actions: &mut Vec<Action>,
) -> bool {
    let elsewhere = ui.memory(|memory| memory.focused().is_some());
    let enter_saves = enter_saves && !elsewhere;
    let enter = enter_saves && ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Enter));
    // From the right, as in the dialog that comes next.
    let line = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let layout = Layout::right_to_left(Align::Center);
    ui.allocate_ui_with_layout(line, layout, |ui| {
        let save = ui
            .add(Button::new("Save…"))
            .on_hover_text("Choose where to save (Enter)");
        let cancel = ui.add(Button::new("Cancel")).on_hover_text("Close (Esc)");
        if save.clicked() || enter {
            actions.push(Action::Ask(Ask::Screenshot(form.asked())));
            return true;
        }
        cancel.clicked()
    })
    .inner
}
