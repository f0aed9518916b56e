//! What says in the view that a character is shown wrong on purpose.

use super::Explained;
use super::shown::Mistaken;
use crate::diagnose::ToldFor;
use crate::editor::Session;
use crate::scene::{Shape, ShapeKind};
use crate::ui::aspect;
use crate::ui::theme::Palette;
use egui::{
    Button, Frame, Label, Margin, Rect, RichText, Sense, Stroke, Ui, UiBuilder, Vec2, vec2,
};

/// Widest banner, in points.
const WIDEST: f32 = 336.0;

/// Smallest view of which that does not take too much, in points. In others it only says what must be known, beside the
/// figure.
const ROOMY: Vec2 = vec2(640.0, 360.0);
const BESIDE: f32 = 200.0;

/// Part of a mesh that is in the picture below which it is said how to see it.
const SEEN: f32 = 0.5;

/// The banner as it was shown.
pub(super) struct Shown {
    /// Its height, in points.
    pub height: f32,
    /// Whether to end the mistake.
    pub ends: bool,
}

/// Shows the banner of a mistake from `top` points below the upper edge of `view` on.
pub(super) fn show(
    ui: &mut Ui,
    view: Rect,
    top: f32,
    session: &Session,
    explained: &Explained,
    mistaken: &Mistaken,
) -> Shown {
    let corner = view.min + vec2(8.0, top);
    let is_small = view.width() < ROOMY.x || view.height() < ROOMY.y;
    let widest = if is_small { BESIDE } else { WIDEST };
    let width = (view.right() - corner.x - 128.0).clamp(160.0, widest);
    // Clicks beside the button must not reach the scene behind it.
    let builder = UiBuilder::new()
        .id_salt("shown wrong")
        .max_rect(Rect::from_min_size(corner, vec2(width, 24.0)))
        .sense(Sense::click_and_drag());
    let mut inner = ui.new_child(builder);
    let palette = Palette::of(inner.visuals());
    let frame = Frame::new()
        .fill(palette.panel)
        .stroke(Stroke::new(2.0, palette.warning))
        .corner_radius(4)
        .inner_margin(Margin::symmetric(8, 6));
    let shape = session.scene().shape(explained.id);
    let program = ToldFor::of_file(shape.and_then(Shape::source_file));
    let shown = frame.show(&mut inner, |ui| {
        ui.set_width(width - 16.0);
        let name = shape.map_or("", |shape| &shape.name);
        let shapes = session.scene().shapes().iter();
        let is_character = |shape: &&Shape| matches!(shape.kind, ShapeKind::Character(_));
        let title = match shapes.filter(is_character).count() {
            0 | 1 => "⚠ Shown wrong on purpose".to_owned(),
            _ => format!("⚠ {name} is shown wrong on purpose"),
        };
        let title = Label::new(RichText::new(title).color(palette.warning)).wrap();
        let title = ui.add(title);
        let sentence = mistaken.made.sentence(program);
        if is_small {
            title.on_hover_text(sentence);
        } else {
            ui.add(Label::new(sentence).wrap());
        }
        let hint = why_right(explained, mistaken)
            .or_else(|| where_seen(view, session, explained, mistaken));
        if let Some(hint) = hint {
            ui.add(Label::new(RichText::new(hint).color(palette.weak)).wrap());
        }
        ui.add(Button::new("Back to Correct"))
            .on_hover_text("Show the character as it is (Esc)")
            .clicked()
    });
    Shown {
        height: shown.response.rect.height(),
        ends: shown.inner,
    }
}

/// How the mesh comes into the picture, if the mistake takes most of it elsewhere.
fn where_seen(
    view: Rect,
    session: &Session,
    explained: &Explained,
    mistaken: &Mistaken,
) -> Option<&'static str> {
    let bounds = mistaken.geometry.bounds();
    let bounds = bounds.transformed(explained.evaluated.world_from_model);
    let camera = &session.view().camera;
    let seen = camera.seen_part(&bounds, aspect(view));
    (seen < SEEN).then_some("It reaches far out of the picture: F fits it, and Shift+F everything.")
}

/// Why nothing can be seen of the mistake, if so.
fn why_right(explained: &Explained, mistaken: &Mistaken) -> Option<&'static str> {
    if !explained.evaluated.visible {
        Some("It is hidden: the eye in the Shape Selector shows it.")
    } else if mistaken.is_seen {
        None
    } else if explained.shape.pose().is_bind() {
        Some("At rest it makes no difference: turn some joints.")
    } else {
        Some("It makes no difference to this character in this pose.")
    }
}
