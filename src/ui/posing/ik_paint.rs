use super::Place;
use super::gesture::PoseGesture;
use super::ik::{self, IkState};
use crate::editor::{IkGrip, Session};
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2};

const CHAIN: Color32 = Color32::from_rgb(0x1a, 0xd9, 0xff);
const PIN: Color32 = Color32::from_rgb(0xff, 0x9e, 0x1c);
const MISSED: Color32 = Color32::from_rgb(0xff, 0x6e, 0x5e);
const SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 0xa0);

/// Paints pins as squares, the chain that would follow or does, the point that is brought
/// somewhere as a ring, and dashed lines to where it or a pin cannot get.
pub(super) fn show(
    painter: &Painter,
    place: Place,
    session: &Session,
    state: &IkState,
    gesture: Option<&PoseGesture>,
) {
    if let Some(followed) = ik::followed(session, state, gesture, place) {
        let mut line = followed.chain;
        line.push(followed.grip);
        painter.add(Shape::line(line.clone(), Stroke::new(6.0, SHADE)));
        painter.add(Shape::line(line.clone(), Stroke::new(3.0, CHAIN)));
        for &joint in &line[..line.len() - 1] {
            dot(painter, joint, 4.5);
        }
        if let Some(target) = followed.missed {
            dashes(painter, followed.grip, target);
            painter.circle_stroke(target, 5.0, Stroke::new(1.5, MISSED));
        }
        painter.circle_stroke(followed.grip, 7.5, Stroke::new(4.0, SHADE));
        painter.circle_stroke(followed.grip, 7.5, Stroke::new(2.0, CHAIN));
    }
    for (now, wanted) in ik::lost_pins(session, gesture, place) {
        dashes(painter, now, wanted);
        let square = Rect::from_center_size(wanted, Vec2::splat(9.0));
        let stroke = Stroke::new(1.5, MISSED);
        painter.rect_stroke(square, 0.0, stroke, StrokeKind::Middle);
    }
    let screen = place.screen(session);
    let evaluated = session.evaluated();
    let is_visible = |id| evaluated.shape(id).is_some_and(|shape| shape.visible);
    for (shape, pins) in state.pinned().filter(|&(id, _)| is_visible(id)) {
        for &joint in pins {
            let world = IkGrip::Joint(joint).place(session, shape);
            let pixel = world.and_then(|world| screen.pixel(world));
            if let Some(pixel) = pixel {
                pin(painter, place.position(pixel));
            }
        }
    }
}

fn dashes(painter: &Painter, from: Pos2, to: Pos2) {
    let stroke = Stroke::new(1.5, MISSED);
    painter.extend(Shape::dashed_line(&[from, to], stroke, 5.0, 4.0));
}

fn dot(painter: &Painter, at: Pos2, radius: f32) {
    painter.circle_filled(at, radius + 1.5, SHADE);
    painter.circle_filled(at, radius, CHAIN);
}

fn pin(painter: &Painter, at: Pos2) {
    let square = Rect::from_center_size(at, Vec2::splat(9.0));
    painter.rect_filled(square.expand(1.5), 1.0, SHADE);
    painter.rect_filled(square, 0.0, PIN);
    let white = Stroke::new(1.0, Color32::WHITE);
    painter.rect_stroke(square, 0.0, white, StrokeKind::Inside);
}
