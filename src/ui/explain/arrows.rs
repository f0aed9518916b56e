//! The sum of a vertex over the view: what each joint adds as an arrow, from the model's origin to the
//! vertex, and where each joint alone would take it as a dot.

use super::Explained;
use super::vertex::Told;
use crate::diagnose::Term;
use crate::editor::Session;
use crate::ui::scene_places::Place;
use crate::ui::widgets::{SHADE, word_over_scene};
use egui::{Color32, Painter, Pos2, Shape, Stroke, vec2};
use glam::DVec3;

/// Colors of joints, which are told apart by the color-blind as well: Okabe and Ito, "Color universal
/// design" (2008), without black.
const COLORS: [Color32; 7] = [
    Color32::from_rgb(0xe6, 0x9f, 0x00),
    Color32::from_rgb(0x56, 0xb4, 0xe9),
    Color32::from_rgb(0xcc, 0x79, 0xa7),
    Color32::from_rgb(0x00, 0x9e, 0x73),
    Color32::from_rgb(0xf0, 0xe4, 0x42),
    Color32::from_rgb(0xd5, 0x5e, 0x00),
    Color32::from_rgb(0x00, 0x72, 0xb2),
];

/// Color of terms beyond those with the largest weights.
const OTHERS: Color32 = Color32::from_gray(0xa0);

/// Indices of the terms, those with the largest weights first.
pub(super) fn heaviest_first(terms: &[Term]) -> Vec<usize> {
    let mut indices: Vec<usize> = (0..terms.len()).collect();
    let weight = |&index: &usize| terms[index].weight.abs();
    indices.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    indices
}

/// Color of each of the terms, in its row and in the view: those with the largest weights are told apart.
pub(super) fn colors(terms: &[Term]) -> Vec<Color32> {
    let mut colors = vec![OTHERS; terms.len()];
    for (index, color) in heaviest_first(terms).into_iter().zip(COLORS) {
        colors[index] = color;
    }
    colors
}

/// Paints the sum of the vertex that is `told`. The arrow of the joint `hovered` is wider.
pub(super) fn paint(
    painter: &Painter,
    place: Place,
    session: &Session,
    explained: &Explained,
    told: &Told,
    hovered: Option<usize>,
) {
    let screen = place.screen(session);
    let world_from_model = explained.evaluated.world_from_model;
    let at = |model: DVec3| {
        let world = world_from_model.transform_point3(model.as_vec3());
        Some(place.position(screen.pixel(world)?))
    };
    let formula = &told.vertex;
    let colors = colors(&formula.terms);
    let vertex = at(formula.sum);
    let mut sum = DVec3::ZERO;
    // As the rows are.
    for index in heaviest_first(&formula.terms) {
        let term = &formula.terms[index];
        let from = at(sum);
        sum += term.weighted * formula.written;
        let width = if hovered == Some(term.joint) {
            5.0
        } else {
            2.5
        };
        if let (Some(from), Some(to)) = (from, at(sum)) {
            arrow(painter, from, to, Stroke::new(width, colors[index]));
        }
    }
    for (index, term) in formula.terms.iter().enumerate() {
        let Some(alone) = at(term.moved * formula.written) else {
            continue;
        };
        if let Some(vertex) = vertex {
            let thin = Stroke::new(1.0, colors[index]);
            painter.extend(Shape::dashed_line(&[alone, vertex], thin, 3.0, 3.0));
        }
        let radius = if hovered == Some(term.joint) {
            6.0
        } else {
            4.0
        };
        painter.circle_filled(alone, radius + 1.5, SHADE);
        painter.circle_filled(alone, radius, colors[index]);
    }
    if let Some(origin) = at(DVec3::ZERO).filter(|_| !formula.terms.is_empty()) {
        painter.circle_filled(origin, 4.5, SHADE);
        painter.circle_filled(origin, 3.0, Color32::WHITE);
        letter(painter, origin, "0");
    }
    if let Some(vertex) = vertex {
        painter.circle_stroke(vertex, 7.0, Stroke::new(4.5, SHADE));
        painter.circle_stroke(vertex, 7.0, Stroke::new(2.0, Color32::WHITE));
        letter(painter, vertex, "v'");
    }
}

fn arrow(painter: &Painter, from: Pos2, to: Pos2, stroke: Stroke) {
    let along = to - from;
    let length = along.length();
    if length < 1.0 {
        return;
    }
    let along = along / length;
    let head = (stroke.width * 4.0).min(length);
    let across = vec2(-along.y, along.x) * head * 0.45;
    let neck = to - along * head;
    let wide = Stroke::new(stroke.width + 2.5, SHADE);
    painter.line_segment([from, to], wide);
    painter.line_segment([from, neck + along], stroke);
    let corners = vec![to, neck + across, neck - across];
    painter.add(Shape::convex_polygon(
        corners,
        stroke.color,
        Stroke::new(0.5, SHADE),
    ));
}

/// A letter beside a point.
fn letter(painter: &Painter, at: Pos2, text: &str) {
    word_over_scene(painter, at + vec2(10.0, -6.0), text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_terms_with_the_largest_weights_have_colors_of_their_own() {
        let weights = [0.01, 0.3, 0.002, 0.02, 0.003, 0.004, 0.2, 0.005, 0.4];
        let terms = weights.map(|weight| Term {
            joint: 0,
            weight_of: 0,
            weight,
            steps: Vec::new(),
            moved: DVec3::ZERO,
            weighted: DVec3::ZERO,
        });
        assert_eq!(heaviest_first(&terms), [8, 1, 6, 3, 0, 7, 5, 4, 2]);
        let colors = colors(&terms);
        assert_eq!(
            [8, 1, 6].map(|index| colors[index]),
            [COLORS[0], COLORS[1], COLORS[2]]
        );
        assert_eq!([2, 4].map(|index| colors[index]), [OTHERS; 2]);
    }
}
