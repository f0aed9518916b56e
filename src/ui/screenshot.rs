//! File ▸ Screenshot: what the picture shows, its size, and turntables.

use super::compare::CompareView;
use super::number_field::NumberField;
use super::widgets::labelled;
use super::{Action, Ask, Screenshot, Turntable, ViewInput};
use crate::scene::TURNTABLE_FRAMES;
use egui::{Align, Button, Frame, Id, Key, Layout, Modal, Modifiers, RichText, Ui, Vec2, vec2};
use std::ops::RangeInclusive;

/// Allowed width and height of a picture, in pixels.
const SIDES: RangeInclusive<f64> = 16.0..=16384.0;

/// Settings of the dialog, which stay as they were when it is opened again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ScreenshotForm {
    with_panels: bool,
    own_size: bool,
    width: u32,
    height: u32,
    transparent: bool,
    turns: bool,
    frames: u32,
    fit: bool,
}

impl Default for ScreenshotForm {
    fn default() -> Self {
        Self {
            with_panels: false,
            own_size: false,
            width: 1920,
            height: 1080,
            transparent: false,
            turns: false,
            frames: 36,
            fit: true,
        }
    }
}

impl ScreenshotForm {
    /// The picture that is asked for, of the size of what it is compared with if it has none of its own.
    /// What does not go with panels or a turntable is left out.
    fn asked(&self, compared: Option<(u32, u32)>) -> Screenshot {
        let own_size = self.own_size && !self.with_panels;
        let turns = self.turns && !self.with_panels;
        Screenshot {
            with_panels: self.with_panels,
            size: if own_size {
                Some((self.width, self.height))
            } else {
                compared.filter(|_| !self.with_panels)
            },
            transparent: self.transparent && !self.with_panels && !turns,
            turntable: turns.then_some(Turntable {
                frames: self.frames,
                fit: self.fit,
            }),
        }
    }

    /// What is saved, and as what.
    fn explanation(&self) -> &'static str {
        let asked = self.asked(None);
        if asked.turntable.is_some() {
            "Saves an animated GIF of the scene, turned once round what the view looks at."
        } else if asked.transparent {
            "Saves a picture as PNG, transparent where nothing stands."
        } else {
            "Saves a picture as PNG, JPEG or GIF."
        }
    }
}

/// Shows the dialog; whether to close it.
pub(super) fn show(
    ui: &Ui,
    input: &ViewInput,
    form: &mut ScreenshotForm,
    actions: &mut Vec<Action>,
) -> bool {
    let compared = input.compare.map(CompareView::size);
    let frame = Frame::popup(ui.style()).inner_margin(16);
    let modal = Modal::new(Id::new("screenshot")).frame(frame);
    let modal = modal.show(ui.ctx(), |ui| {
        ui.set_width(344.0);
        ui.heading("Screenshot");
        ui.label(RichText::new(form.explanation()).weak());
        ui.add_space(8.0);
        // Asked before a field gives up the keyboard because of the same Enter.
        let typing = ui.ctx().text_edit_focused();
        if !input.is_page {
            panels(ui, form);
        }
        contents(ui, form, compared);
        ui.add_space(12.0);
        let asked = form.asked(compared);
        buttons(ui, asked, !typing, actions)
    });
    modal.inner || modal.should_close()
}

fn panels(ui: &mut Ui, form: &mut ScreenshotForm) {
    labelled(ui, "Show", |ui, _| {
        ui.spacing_mut().item_spacing.x = 16.0;
        ui.radio_value(&mut form.with_panels, false, "The view alone");
        ui.add_enabled_ui(!form.turns, |ui| {
            ui.radio_value(&mut form.with_panels, true, "With panels")
                .on_disabled_hover_text("A turntable shows the view alone");
        });
    });
}

fn contents(ui: &mut Ui, form: &mut ScreenshotForm, compared: Option<(u32, u32)>) {
    ui.add_enabled_ui(!form.with_panels, |ui| {
        size(ui, form, compared);
        background(ui, form);
        motion(ui, form);
    });
}

/// Why a picture with panels has no choices of its own.
const WITH_PANELS: &str = "Panels are drawn for the window: the picture shows it as it is";

fn size(ui: &mut Ui, form: &mut ScreenshotForm, compared: Option<(u32, u32)>) {
    let given = match compared {
        Some((width, height)) => &format!("As compared ({width} × {height})"),
        None => "As in the window",
    };
    labelled(ui, "Size", |ui, _| {
        ui.spacing_mut().item_spacing.x = 16.0;
        ui.radio_value(&mut form.own_size, false, given)
            .on_disabled_hover_text(WITH_PANELS);
        ui.radio_value(&mut form.own_size, true, "Custom")
            .on_disabled_hover_text(WITH_PANELS);
    });
    ui.add_enabled_ui(form.own_size, |ui| {
        labelled(ui, "", |ui, size| {
            let each = vec2((size.x - 20.0) / 2.0, size.y);
            side(ui, "Picture width", &mut form.width, 1920.0, each);
            ui.label("×");
            side(ui, "Picture height", &mut form.height, 1080.0, each);
        });
    });
}

fn side(ui: &mut Ui, name: &str, value: &mut u32, rest: f32, size: Vec2) {
    let field = NumberField::new(name, *value as f32, 1.0)
        .rest(rest)
        .range(SIDES)
        .decimals(0..=0)
        .unit(" px");
    if let Some(given) = field.show(ui, size) {
        *value = given.round() as u32;
    }
}

fn background(ui: &mut Ui, form: &mut ScreenshotForm) {
    // Where there is no choice, what is marked is what is saved.
    let is_free = !form.turns && !form.with_panels;
    let mut transparent = form.transparent && is_free;
    ui.add_enabled_ui(!form.turns, |ui| {
        let why = if form.with_panels {
            WITH_PANELS
        } else {
            "Turntables are GIFs, which have no smooth transparency"
        };
        labelled(ui, "Background", |ui, _| {
            ui.spacing_mut().item_spacing.x = 16.0;
            ui.radio_value(&mut transparent, false, "As shown")
                .on_disabled_hover_text(why);
            ui.radio_value(&mut transparent, true, "Transparent")
                .on_disabled_hover_text(why);
        });
    });
    if is_free {
        form.transparent = transparent;
    }
}

fn motion(ui: &mut Ui, form: &mut ScreenshotForm) {
    labelled(ui, "Motion", |ui, _| {
        ui.spacing_mut().item_spacing.x = 16.0;
        ui.radio_value(&mut form.turns, false, "Still")
            .on_disabled_hover_text(WITH_PANELS);
        ui.radio_value(&mut form.turns, true, "Turntable")
            .on_disabled_hover_text(WITH_PANELS);
    });
    ui.add_enabled_ui(form.turns, |ui| {
        labelled(ui, "", |ui, size| {
            let (least, most) = TURNTABLE_FRAMES.into_inner();
            let field = NumberField::new("Turntable pictures", form.frames as f32, 1.0)
                .rest(36.0)
                .range(f64::from(least)..=f64::from(most))
                .decimals(0..=0)
                .unit(" pictures");
            if let Some(given) = field.show(ui, vec2(112.0, size.y)) {
                form.frames = given.round() as u32;
            }
            ui.checkbox(&mut form.fit, "Fit everything")
                .on_hover_text("Move the camera so that nothing is cut off in any picture");
        });
    });
}

/// Save and Cancel; whether one of them was used.
fn buttons(ui: &mut Ui, asked: Screenshot, enter_saves: bool, actions: &mut Vec<Action>) -> bool {
    let elsewhere = ui.memory(|memory| memory.focused().is_some());
    let enter_saves = enter_saves && !elsewhere;
    let enter = enter_saves && ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Enter));
    // At the right, as in the file dialog that follows.
    let line = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let layout = Layout::right_to_left(Align::Center);
    ui.allocate_ui_with_layout(line, layout, |ui| {
        let save = ui
            .add(Button::new("Save…"))
            .on_hover_text("Choose where to save (Enter)");
        let cancel = ui.add(Button::new("Cancel")).on_hover_text("Close (Esc)");
        if save.clicked() || enter {
            actions.push(Action::Ask(Ask::Screenshot(asked)));
            return true;
        }
        cancel.clicked()
    })
    .inner
}
