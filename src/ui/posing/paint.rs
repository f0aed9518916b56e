//! Painting of bones and inverse kinematics over a picture of the scene.

use super::held::PoseGesture;
use super::ik::{followed, lost_pins, pinned};
use super::{shows_skeleton, takes_bones_of};
use crate::editor::{IkGrip, Session, Tool};
use crate::scene::{Look as SceneLook, ShapeId, bones_in_world};
use crate::ui::grab::is_pickable;
use crate::ui::scene_places::Place;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Theme, Vec2};

/// Colors of joints, as in the skeleton where that is shown.
const HOVERED: Color32 = Color32::from_rgb(0x1a, 0xd9, 0xff);
const SELECTED: Color32 = Color32::from_rgb(0xff, 0x9e, 0x1c);
const OTHERS: Color32 = Color32::from_rgba_premultiplied(0x60, 0x60, 0x60, 0x60);
/// The same before the Studio look's light background.
const OTHERS_IN_LIGHT: Color32 = Color32::from_rgba_premultiplied(0x18, 0x1e, 0x28, 0xb0);
const SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 0xa0);

/// With a tool for bones, paints the bones of the selected joint over everything, and thin lines
/// for bones that are hidden by the mesh of the selected character.
pub(super) fn selected_bones(painter: &Painter, place: Place, session: &Session, tool: Tool) {
    if tool.takes_bones() {
        let selected = session.selected();
        let is_hidden = |id: &ShapeId| {
            takes_bones_of(session, tool, *id)
                && !shows_skeleton(session, *id)
                && is_pickable(session, *id)
        };
        if let Some(shape) = selected.filter(is_hidden) {
            let is_light = painter.ctx().theme() == Theme::Light;
            let is_before_light = is_light && session.view().look == SceneLook::Studio;
            let color = if is_before_light {
                OTHERS_IN_LIGHT
            } else {
                OTHERS
            };
            let thin = Look {
                line: Stroke::new(1.5, color),
                dot: 2.5,
                shade: 0.0,
            };
            bones(painter, place, session, shape, None, thin);
        }
        let joints = selected.into_iter().flat_map(|shape| {
            let joints = session.selected_joints().iter();
            joints.map(move |&joint| (shape, joint))
        });
        for (shape, joint) in joints {
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

/// Paints the bones of the hovered joint over everything, whether it is hovered in the view or in
/// the list.
pub(super) fn hovered_bones(painter: &Painter, place: Place, session: &Session) {
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
    /// Radius of the joint's dot, in points.
    dot: f32,
    /// Width of the dark edge, in points.
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

/// Paints the bones of one joint, or of all joints.
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

const CHAIN: Color32 = HOVERED;
const PIN: Color32 = SELECTED;
const MISSED: Color32 = Color32::from_rgb(0xff, 0x6e, 0x5e);

/// Paints pins as squares, the chain that follows or would follow, the dragged point as a ring, and
/// dashed lines to places that it or a pin cannot reach.
pub(super) fn ik(
    painter: &Painter,
    place: Place,
    session: &Session,
    hovered: Option<(ShapeId, IkGrip)>,
    gesture: Option<&PoseGesture>,
) {
    if let Some(followed) = followed(session, hovered, gesture, place) {
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
    for (now, wanted) in lost_pins(session, gesture, place) {
        dashes(painter, now, wanted);
        let square = Rect::from_center_size(wanted, Vec2::splat(9.0));
        let stroke = Stroke::new(1.5, MISSED);
        painter.rect_stroke(square, 0.0, stroke, StrokeKind::Middle);
    }
    let screen = place.screen(session);
    let evaluated = session.evaluated();
    let is_visible = |id| evaluated.shape(id).is_some_and(|shape| shape.visible);
    for (shape, ik) in pinned(session).filter(|&(id, _)| is_visible(id)) {
        for &joint in &ik.pins {
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
