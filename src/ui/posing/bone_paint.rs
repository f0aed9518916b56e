use super::{Place, is_pickable};
use crate::editor::{Session, Tool};
use crate::scene::{ModelDisplay, ShapeId, bones_in_world};
use egui::{Color32, Painter, Pos2, Stroke};

/// As the skeleton itself is marked where it shows.
const HOVERED: Color32 = Color32::from_rgb(0x1a, 0xd9, 0xff);
const SELECTED: Color32 = Color32::from_rgb(0xff, 0x9e, 0x1c);
const OTHERS: Color32 = Color32::from_rgba_premultiplied(0x60, 0x60, 0x60, 0x60);
const SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 0xa0);

/// With a tool for bones, paints those of the selected joint over everything, and thin lines for
/// those that hide in the mesh of the selected character.
pub(super) fn show(painter: &Painter, place: Place, session: &Session, tool: Tool) {
    if tool != Tool::Select {
        let selected = session.selected();
        let shown = |id: ShapeId| {
            let character = session.scene().character(id);
            character.is_some_and(|shape| shape.display.mode != ModelDisplay::Mesh)
        };
        if let Some(shape) = selected.filter(|&id| !shown(id) && is_pickable(session, id)) {
            let thin = Look {
                line: Stroke::new(1.5, OTHERS),
                dot: 2.5,
                shade: 0.0,
            };
            bones(painter, place, session, shape, None, thin);
        }
        if let Some((shape, joint)) = selected.zip(session.selected_joint()) {
            bones(
                painter,
                place,
                session,
                shape,
                Some(joint),
                Look::strong(SELECTED),
            );
        }
    }
}

/// Paints the bones of the joint under the pointer over everything, wherever the pointer is.
pub(super) fn hovered(painter: &Painter, place: Place, session: &Session) {
    if let Some((shape, joint)) = session.hovered_bone() {
        bones(
            painter,
            place,
            session,
            shape,
            Some(joint),
            Look::strong(HOVERED),
        );
    }
}

#[derive(Clone, Copy)]
struct Look {
    line: Stroke,
    /// Radius of the joint's dot.
    dot: f32,
    /// Width of the dark edge.
    shade: f32,
}

impl Look {
    fn strong(color: Color32) -> Self {
        Self {
            line: Stroke::new(3.0, color),
            dot: 4.5,
            shade: 1.5,
        }
    }
}

/// The bones of one joint, or of all.
fn bones(
    painter: &Painter,
    place: Place,
    session: &Session,
    shape: ShapeId,
    joint: Option<usize>,
    look: Look,
) {
    let evaluated = session.evaluated().shape(shape);
    let Some(evaluated) = evaluated.filter(|shape| shape.visible) else {
        return;
    };
    let screen = place.screen(session);
    let position = |world| Some(place.position(screen.pixel(world)?));
    let lines: Vec<[Pos2; 2]> = bones_in_world(session.scene(), evaluated)
        .filter(|(of, ..)| joint.is_none_or(|joint| joint == *of))
        .filter_map(|(_, start, end)| Some([position(start)?, position(end)?]))
        .collect();
    let joints = evaluated
        .geometry
        .figure
        .iter()
        .flat_map(|figure| &figure.joints);
    let dots: Vec<Pos2> = joints
        .enumerate()
        .filter(|(of, _)| joint.is_none_or(|joint| joint == *of))
        .filter_map(|(_, &at)| position(evaluated.world_from_model.transform_point3(at)))
        .collect();
    if look.shade > 0.0 {
        let wide = Stroke::new(look.line.width + 2.0 * look.shade, SHADE);
        lines
            .iter()
            .for_each(|&line| _ = painter.line_segment(line, wide));
        dots.iter()
            .for_each(|&dot| _ = painter.circle_filled(dot, look.dot + look.shade, SHADE));
    }
    lines
        .iter()
        .for_each(|&line| _ = painter.line_segment(line, look.line));
    dots.iter()
        .for_each(|&dot| _ = painter.circle_filled(dot, look.dot, look.line.color));
}
