//! The vertex that is marked in a comparison with a mesh.

use super::CompareMeshView;
use crate::editor::Session;
use crate::ui::ScenePlaces;
use crate::ui::widgets::word_over_scene;
use egui::{Color32, Stroke, Ui, vec2};

/// Radius of the ring round our place of the vertex, in points, and of the dot at theirs.
const RING: f32 = 9.0;
const DOT: f32 = 4.0;
/// How far below a place the words below it end, in points, and from where on two places have room for words between them.
const BELOW: f32 = 26.0;
const CLOSE: f32 = 24.0;

/// Marks `vertex` where ours has it and where theirs does, with a line from one to the other, with the name
/// of their file, and with its number unless it `is_explained`: the words of its formula are in that place
/// then.
pub(in crate::ui) fn show(
    ui: &Ui,
    places: &ScenePlaces,
    session: &Session,
    compare: &CompareMeshView,
    (vertex, is_explained): (usize, bool),
) {
    let Some(at) = compare.places(session, vertex) else {
        return;
    };
    let camera = &session.view().camera;
    for place in places.iter() {
        let painter = ui.painter().with_clip_rect(place.rect);
        let [ours, theirs] = at.map(|at| {
            let pixel = camera.pixel(at, place.size())?;
            Some(place.position(pixel))
        });
        let (Some(ours), Some(theirs)) = (ours, theirs) else {
            continue;
        };
        // Each over a dark rim, so that it stands out from any color of the scale.
        for (color, wider) in [(Color32::BLACK, 2.0), (Color32::WHITE, 0.0)] {
            let stroke = Stroke::new(1.5 + wider, color);
            painter.circle_stroke(ours, RING, stroke);
            let apart = theirs - ours;
            if apart.length() > RING {
                let from = ours + apart.normalized() * RING;
                painter.line_segment([from, theirs], stroke);
            }
            painter.circle_filled(theirs, DOT + wider / 2.0, color);
        }
        // Words stand on sides that are away from each other. Those of the formula are above our place.
        let is_above = theirs.y < ours.y - if is_explained { CLOSE } else { 0.0 };
        let (own, beside) = if is_above {
            (RING + BELOW, -6.0)
        } else {
            (-RING - 6.0, BELOW)
        };
        if !is_explained {
            let corner = ours + vec2(RING + 6.0, own);
            word_over_scene(&painter, corner, &format!("vertex {vertex}"));
        }
        word_over_scene(&painter, theirs + vec2(10.0, beside), compare.name);
    }
}
