//! The field of a shape's color.

use super::menu_keys;
use super::theme::Palette;
use super::widgets::named;
use crate::scene::{COLOR_PRESETS, CUSTOM_PRESET, ShapeColor};
use egui::{Atom, Button, Color32, ComboBox, Id, Rect, Stroke, StrokeKind, Ui, Vec2, vec2};
use glam::Vec3;

/// Size of the sample of a color, in points.
const SWATCH: Vec2 = vec2(24.0, 14.0);

/// A color picker, and the list of presets with their swatches; a picked color is Custom. Returns
/// the color if it was changed.
pub(super) fn show(ui: &mut Ui, color: ShapeColor, width: f32) -> Option<ShapeColor> {
    let mut chosen = None;
    // Eight bits per channel, as on screen: colors of the scene are not linear.
    let [r, g, b, _] = to_color32(color.rgb()).to_array();
    let mut bytes = [r, g, b];
    let picker = ui.color_edit_button_srgb(&mut bytes);
    if picker.changed() {
        let rgb = bytes.map(|channel| f32::from(channel) / 255.0);
        chosen = Some(ShapeColor::Custom(Vec3::from_array(rgb)));
    }
    // A color near the panel's own has an edge by this alone.
    let edge = Palette::of(ui.visuals()).weak;
    ui.painter()
        .rect_stroke(picker.rect, 2.0, Stroke::new(1.0, edge), StrokeKind::Inside);
    named(picker, "Custom color").on_hover_text("Pick a color");
    let used = ui.spacing().interact_size.x + ui.spacing().item_spacing.x;
    let combo = ComboBox::from_id_salt("color")
        .width(width - used)
        .selected_text(COLOR_PRESETS[color.preset_index()].name)
        .show_ui(ui, |ui| {
            menu_keys::level(ui, None, |ui| {
                for index in 0..COLOR_PRESETS.len() {
                    if preset(ui, index, color) {
                        chosen = Some(if index == CUSTOM_PRESET {
                            ShapeColor::Custom(color.rgb())
                        } else {
                            ShapeColor::Preset(index)
                        });
                    }
                }
            });
        });
    named(combo.response, "Color");
    chosen.filter(|&chosen| chosen != color)
}

/// One row of the list of presets; whether it was chosen.
fn preset(ui: &mut Ui, index: usize, color: ShapeColor) -> bool {
    let preset = &COLOR_PRESETS[index];
    let selected = color.preset_index() == index;
    let swatch = Id::new("swatch");
    let line = Button::selectable(selected, (Atom::custom(swatch, SWATCH), preset.name))
        .min_size(vec2(ui.available_width(), 0.0))
        .atom_ui(ui);
    if let Some(rect) = line.rect(swatch) {
        let shown = if index == CUSTOM_PRESET {
            color.rgb()
        } else {
            preset.color
        };
        paint_swatch(ui, rect, shown);
    }
    if line.response.gained_focus() {
        line.response.scroll_to_me(None);
    }
    menu_keys::is_chosen(ui, &line.response, selected)
}

fn paint_swatch(ui: &Ui, rect: Rect, rgb: Vec3) {
    ui.painter().rect(
        rect,
        2.0,
        to_color32(rgb),
        ui.visuals().widgets.noninteractive.bg_stroke,
        StrokeKind::Inside,
    );
}

fn to_color32(rgb: Vec3) -> Color32 {
    let [r, g, b] = rgb
        .to_array()
        .map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}
