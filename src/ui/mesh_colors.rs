//! Meshes in the colors of numbers: what can be chosen, and the legend over the view.

use super::theme::Palette;
use crate::scene::{SCALE_GRAY, scale_color};
use egui::{
    Color32, Frame, Label, Layout, Margin, Mesh, Pos2, Rect, RichText, Sense, Shape, Ui, UiBuilder,
    Vec2, WidgetInfo, WidgetType, pos2, vec2,
};

/// What characters are colored by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshColors {
    /// Their materials.
    #[default]
    Materials,
    /// The weight of the selected joint.
    Weight,
    /// The number of joints that move a vertex.
    Influences,
    /// What is lost where a vertex has at most four influences.
    LostAtFour,
}

/// Words beside the scale of colors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Legend {
    /// What is shown.
    pub title: String,
    /// Numbers at the dark and at the bright end; `None` if nothing is shown by the scale.
    pub ends: Option<[String; 2]>,
    /// Meaning of the gray that is no color of the scale, if there is any.
    pub gray: Option<String>,
    /// What else is to be known.
    pub note: Option<String>,
}

/// Width of the scale, in points, and its height.
const SCALE: Vec2 = vec2(220.0, 12.0);
/// Size of the square of gray, in points.
const SQUARE: f32 = 12.0;
/// Colors of which the scale is made here, between which it is painted evenly.
const STEPS: u16 = 32;

/// Shows the legend at the left of `view`, from `top` points below its upper edge on.
pub(super) fn legend(ui: &mut Ui, view: Rect, top: f32, legend: &Legend) {
    let corner = view.min + vec2(8.0, top);
    let room = Rect::from_min_size(corner, vec2(SCALE.x + 24.0, 120.0));
    // Clicks on it must not reach the scene behind.
    let builder = UiBuilder::new()
        .id_salt("legend")
        .max_rect(room)
        .sense(Sense::click_and_drag());
    let mut inner = ui.new_child(builder);
    let palette = Palette::of(inner.visuals());
    let frame = Frame::new()
        .fill(palette.panel)
        .corner_radius(4)
        .inner_margin(Margin::symmetric(8, 6));
    frame.show(&mut inner, |ui| {
        ui.spacing_mut().item_spacing.y = 2.0;
        ui.set_width(SCALE.x);
        let title = RichText::new(&legend.title).small().color(palette.strong);
        ui.add(Label::new(title).wrap());
        if let Some([low, high]) = &legend.ends {
            scale(ui, &format!("{}: from {low} to {high}", legend.title));
            ui.horizontal(|ui| {
                ui.label(RichText::new(low).small());
                ui.with_layout(Layout::right_to_left(egui::Align::Center), |ui| {
                    ui.label(RichText::new(high).small());
                });
            });
        }
        if let Some(gray) = &legend.gray {
            ui.horizontal(|ui| {
                let (rect, _) = ui.allocate_exact_size(Vec2::splat(SQUARE), Sense::hover());
                ui.painter().rect_filled(rect, 2, color(SCALE_GRAY));
                ui.label(RichText::new(gray).small());
            });
        }
        if let Some(note) = &legend.note {
            let note = RichText::new(note).small().color(palette.weak);
            ui.add(Label::new(note).wrap());
        }
    });
}

/// The scale itself, from dark to bright.
fn scale(ui: &mut Ui, words: &str) {
    let (rect, response) = ui.allocate_exact_size(SCALE, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Image, true, words));
    let mut strip = Mesh::default();
    let at = |step: u16| -> (f32, Color32) {
        let part = f32::from(step) / f32::from(STEPS);
        (rect.left() + part * rect.width(), color(scale_color(part)))
    };
    for step in 0..STEPS {
        let (left, dark) = at(step);
        let (right, bright) = at(step + 1);
        let first = strip.vertices.len() as u32;
        let corners: [(Pos2, Color32); 4] = [
            (pos2(left, rect.top()), dark),
            (pos2(right, rect.top()), bright),
            (pos2(right, rect.bottom()), bright),
            (pos2(left, rect.bottom()), dark),
        ];
        for (corner, color) in corners {
            strip.colored_vertex(corner, color);
        }
        strip.add_triangle(first, first + 1, first + 2);
        strip.add_triangle(first, first + 2, first + 3);
    }
    ui.painter().add(Shape::mesh(strip));
}

fn color(stored: glam::Vec3) -> Color32 {
    let [red, green, blue] = (stored * 255.0).to_array().map(|c| c.round() as u8);
    Color32::from_rgb(red, green, blue)
}
