//! First steps in an empty document: recent files, built-in characters and scenes.

use super::theme::Palette;
use super::widgets::named;
use super::{Action, Ask, ViewInput, axis_ball};
use crate::editor::Session;
use crate::scene::name_of_import;
use egui::{
    Align, Button, Color32, CornerRadius, Frame, Image, Label, Layout, Margin, Rect, RichText,
    ScrollArea, Sense, StrokeKind, TextureId, Ui, UiBuilder, Vec2, WidgetInfo, WidgetType, pos2,
    vec2,
};

/// Built-in scenes that the page offers, with their labels.
pub const START_SCENES: &[(&str, &str)] = &[
    ("showcase", "Showcase"),
    ("turned", "Turned"),
    ("mannequin-1", "Mannequin 1"),
    ("mannequin-2", "Mannequin 2"),
    ("mannequin-3", "Mannequin 3"),
    ("mannequin-4", "Mannequin 4"),
    ("mannequin-5", "Mannequin 5"),
    ("mannequin-6", "Mannequin 6"),
    ("mannequin-7", "Mannequin 7"),
];

/// Picture of a built-in character or scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StartPicture {
    /// Name of the built-in file.
    pub name: &'static str,
    /// Texture that shows it, four wide and three high.
    pub texture: TextureId,
}

/// Greatest width of the page, in points.
const WIDEST: f32 = 588.0;
/// Least width and height of a view that has room for the page, in points.
const LEAST: Vec2 = vec2(140.0, 80.0);
/// Distance from the edges of the view, in points.
const MARGIN: f32 = 12.0;
/// Size of a picture, in points.
const PICTURE: Vec2 = vec2(88.0, 66.0);
/// Height of the name below a picture, in points.
const NAME: f32 = 20.0;
/// Recent documents that are offered, at most.
const RECENT: usize = 6;

/// Whether there is a start page: the scene is empty, and the view is not busy with a comparison or a
/// question.
pub fn has_start_page(session: &Session, is_busy: bool) -> bool {
    session.scene().shapes().is_empty() && !is_busy
}

/// Offers what to begin with, below the axis ball and the tools, which take so many points at the top of the view. It
/// scrolls where there is no room for all of it.
pub(super) fn show(
    ui: &mut Ui,
    (view, below_tools): (Rect, f32),
    input: &ViewInput,
    actions: &mut Vec<Action>,
) {
    let width = (view.width() - 2.0 * MARGIN).min(WIDEST);
    let left = view.center().x - width / 2.0;
    let is_below_ball = left + width > axis_ball::left(view);
    let below_ball = if is_below_ball {
        axis_ball::HEIGHT
    } else {
        0.0
    };
    let top = view.top() + below_ball.max(below_tools);
    let room = vec2(width, view.bottom() - MARGIN - top);
    if room.x < LEAST.x || room.y < LEAST.y {
        return;
    }
    let place = Rect::from_min_size(pos2(left, top), vec2(width, room.y));
    let builder = UiBuilder::new().id_salt("start page").max_rect(place);
    let mut inner = ui.new_child(builder);
    let margin = Margin::symmetric(16, 12);
    let frame = Frame::popup(ui.style()).inner_margin(margin);
    frame.show(&mut inner, |ui| {
        let size = vec2(width - 32.0, room.y - 24.0);
        ui.set_width(size.x);
        ScrollArea::vertical()
            .id_salt("start page")
            .max_height(size.y)
            .show(ui, |ui| contents(ui, input, actions));
    });
}

fn contents(ui: &mut Ui, input: &ViewInput, actions: &mut Vec<Action>) {
    ui.heading("Start");
    ui.horizontal_wrapped(|ui| {
        offer(ui, "Open…", "Open a scene or a model", Ask::Open, actions);
        let tip = "Add a character from a .dae file, or from .obj, .skel and .attach files";
        offer(ui, "Import Character…", tip, Ask::ImportCharacter, actions);
        let color = Palette::of(ui.visuals()).weak;
        let drop = RichText::new("or drop a file here").color(color);
        // All of it goes to the next line where there is no room for it.
        ui.add(Label::new(drop).extend());
    });
    if !input.recent.is_empty() {
        title(ui, "Recent");
        ui.horizontal_wrapped(|ui| {
            for path in input.recent.iter().take(RECENT) {
                let name = path.file_name().unwrap_or(path.as_os_str());
                let (name, tip) = (name.to_string_lossy(), path.to_string_lossy());
                offer(ui, &name, &tip, Ask::OpenRecent(path.clone()), actions);
            }
        });
    }
    title(ui, "Characters");
    let characters = input.builtin_characters.iter().map(|&name| Tile {
        name,
        label: name_of_import(name),
        tip: "Add it at the origin",
        ask: Ask::InsertBuiltin(name),
    });
    tiles(ui, characters, input.start_pictures, actions);
    title(ui, "Scenes");
    let scenes = START_SCENES.iter().map(|&(name, label)| Tile {
        name,
        label: label.to_owned(),
        tip: "Open it as a new document",
        ask: Ask::OpenBuiltin(name),
    });
    tiles(ui, scenes, input.start_pictures, actions);
}

fn title(ui: &mut Ui, text: &str) {
    ui.add_space(4.0);
    let color = Palette::of(ui.visuals()).weak;
    ui.label(RichText::new(text).small().color(color));
}

fn offer(ui: &mut Ui, label: &str, tip: &str, ask: Ask, actions: &mut Vec<Action>) {
    let button = ui.add(Button::new(label).truncate());
    if named(button, &format!("Begin: {label}"))
        .on_hover_text(tip)
        .clicked()
    {
        actions.push(Action::Ask(ask));
    }
}

/// A built-in file that is offered with its picture.
struct Tile {
    name: &'static str,
    label: String,
    tip: &'static str,
    ask: Ask,
}

/// Tiles in as many rows as they need.
fn tiles(
    ui: &mut Ui,
    tiles: impl Iterator<Item = Tile>,
    pictures: &[StartPicture],
    actions: &mut Vec<Action>,
) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
        for tile in tiles {
            let picture = pictures.iter().find(|picture| picture.name == tile.name);
            if show_tile(ui, &tile, picture.map(|picture| picture.texture)) {
                actions.push(Action::Ask(tile.ask));
            }
        }
    });
}

/// One picture with its name below it; whether it was clicked.
fn show_tile(ui: &mut Ui, tile: &Tile, texture: Option<TextureId>) -> bool {
    let size = PICTURE + vec2(0.0, NAME);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| {
        let name = format!("Begin: {}", tile.label);
        WidgetInfo::labeled(WidgetType::Button, ui.is_enabled(), name)
    });
    let visuals = *ui.style().interact(&response);
    let radius = CornerRadius::same(3);
    let (fill, stroke) = (visuals.weak_bg_fill, visuals.bg_stroke);
    ui.painter().rect_filled(rect, radius, fill);
    let (picture, name) = rect.split_top_bottom_at_y(rect.top() + PICTURE.y);
    if let Some(texture) = texture {
        let top = CornerRadius {
            sw: 0,
            se: 0,
            ..radius
        };
        Image::new((texture, PICTURE))
            .corner_radius(top)
            .paint_at(ui, picture);
    }
    ui.painter()
        .rect_stroke(rect, radius, stroke, StrokeKind::Inside);
    let color: Color32 = visuals.text_color();
    let builder = UiBuilder::new()
        .max_rect(name.shrink2(vec2(4.0, 0.0)))
        .layout(Layout::centered_and_justified(egui::Direction::TopDown));
    let mut below = ui.new_child(builder);
    let text = RichText::new(&tile.label).small().color(color);
    below.add(
        Label::new(text)
            .truncate()
            .halign(Align::Center)
            .selectable(false),
    );
    response.on_hover_text(tile.tip).clicked()
}
