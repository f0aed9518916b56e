//! Painting of bones, gizmos and inverse kinematics over a picture of the scene.

use super::held::{Held, PoseGesture};
use super::held_name;
use super::ik::{followed, lost_pins, pinned};
use super::shown_gizmo::Gizmo;
use crate::editor::{Handle, IkGrip, MoveGizmo, RotationGizmo, ScaleGizmo, Session, Tool};
use crate::scene::{ModelDisplay, ShapeId, bones_in_world};
use crate::ui::scene_places::Place;
use crate::ui::theme::Palette;
use crate::ui::view_gestures::is_pickable;
use egui::text::{LayoutJob, TextWrapping};
use egui::{Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Ui, Vec2, vec2};

/// Colors of joints, as in the skeleton where that is shown.
const HOVERED: Color32 = Color32::from_rgb(0x1a, 0xd9, 0xff);
const SELECTED: Color32 = Color32::from_rgb(0xff, 0x9e, 0x1c);
const OTHERS: Color32 = Color32::from_rgba_premultiplied(0x60, 0x60, 0x60, 0x60);
const SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 0xa0);

/// With a tool for bones, paints the bones of the selected joint over everything, and thin lines
/// for bones that are hidden by the mesh of the selected character.
pub(super) fn selected_bones(painter: &Painter, place: Place, session: &Session, tool: Tool) {
    if tool.takes_bones() {
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

const AXES: [Color32; 3] = [
    Color32::from_rgb(0xf2, 0x4f, 0x46),
    Color32::from_rgb(0x6c, 0xc4, 0x3c),
    Color32::from_rgb(0x4a, 0x90, 0xf7),
];
const FREE: Color32 = Color32::from_rgb(0xe6, 0xe6, 0xe6);
const HOT: Color32 = Color32::from_rgb(0xff, 0xd8, 0x3d);
const HANDLE_SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 0x78);
/// Length of an arrow's head, in points.
const HEAD: f32 = 12.0;
/// Half the side of the square at the end of a handle that scales, in points.
const SCALE_HANDLE: f32 = 5.0;
/// Least distance of the readout from the edges of the view, in points.
const AWAY_FROM_EDGE: f32 = 4.0;

/// Paints a gizmo; the handle `hot` is highlighted, and the others are dimmed while it is `held`.
pub(super) fn gizmo(
    painter: &Painter,
    place: Place,
    shown: &Gizmo,
    hot: Option<Handle>,
    held: bool,
) {
    let brush = Brush {
        painter,
        place,
        hot,
        held,
    };
    match shown {
        Gizmo::Turn { rings, .. } | Gizmo::TurnShapes(rings) => brush.rings(rings),
        Gizmo::Move { arrows, .. } => brush.arrows(arrows),
        Gizmo::Scale(handles) => brush.scale_handles(handles),
    }
}

/// Paints the line of an axis that was typed, through a point: as much of it as is before the eye.
pub(super) fn axis(
    painter: &Painter,
    place: Place,
    session: &Session,
    (axis, direction, through): (usize, glam::Vec3, glam::Vec3),
) {
    let screen = place.screen(session);
    let reach = direction * (through.distance(screen.camera.eye()) * 0.9);
    let ends = [through - reach, through + reach].map(|end| screen.pixel(end));
    if let [Some(from), Some(to)] = ends {
        let line = [place.position(from), place.position(to)];
        painter.line_segment(line, Stroke::new(1.5, AXES[axis]));
    }
}

/// Paints the readout of a gesture beside the pointer: what it holds, and by how much that has
/// turned or moved.
pub(super) fn readout(ui: &Ui, view: Rect, session: &Session, gesture: &PoseGesture) {
    let pointer = ui.ctx().input(|input| input.pointer.latest_pos());
    let text = gesture.active().map(Held::readout);
    let (Some(text), Some(pointer)) = (text, pointer) else {
        return;
    };
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter();
    let (font, color) = (FontId::proportional(13.0), palette.strong);
    let value = painter.layout_no_wrap(text, font.clone(), color);
    let (margin, gap) = (vec2(6.0, 3.0), 8.0);
    // Names come from files and may be of any length: the value must stay readable.
    let room = view.width() - value.size().x - gap - 2.0 * (margin.x + AWAY_FROM_EDGE);
    let held = gesture.held();
    let name = held_name(session, held).unwrap_or_default();
    let mut line = LayoutJob::simple_singleline(name, font, color);
    line.wrap = TextWrapping::truncate_at_width(room.max(0.0));
    let name = painter.layout_job(line);

    let content = vec2(name.size().x + gap + value.size().x, value.size().y);
    let size = content + 2.0 * margin;
    let first = view.min + Vec2::splat(AWAY_FROM_EDGE);
    let last = (view.max - size - Vec2::splat(AWAY_FROM_EDGE)).max(first);
    let at = (pointer + vec2(18.0, 14.0)).clamp(first, last);
    painter.rect_filled(Rect::from_min_size(at, size), 4.0, palette.panel);
    let after_name = at + margin + vec2(name.size().x + gap, 0.0);
    painter.galley(at + margin, name, color);
    painter.galley(after_name, value, color);
}

/// Painter of a gizmo.
struct Brush<'a> {
    painter: &'a Painter,
    place: Place,
    hot: Option<Handle>,
    held: bool,
}

impl Brush<'_> {
    fn color(&self, handle: Handle, plain: Color32) -> Color32 {
        if self.hot == Some(handle) {
            HOT
        } else if self.held {
            plain.gamma_multiply(0.25)
        } else {
            plain
        }
    }

    fn at(&self, pixel: glam::Vec2) -> Pos2 {
        self.place.position(pixel)
    }

    fn line(&self, points: &[Pos2], width: f32, color: Color32) {
        let shade = Stroke::new(
            width + 2.0,
            HANDLE_SHADE.gamma_multiply(color.a() as f32 / 255.0),
        );
        self.painter.add(Shape::line(points.to_vec(), shade));
        self.painter
            .add(Shape::line(points.to_vec(), Stroke::new(width, color)));
    }

    fn rings(&self, rings: &RotationGizmo) {
        let center = self.at(rings.center_pixel());
        let free = self.color(Handle::FreeRing, FREE);
        let radius = RotationGizmo::FREE_RADIUS;
        self.painter
            .circle_stroke(center, radius, Stroke::new(3.5, HANDLE_SHADE));
        self.painter
            .circle_stroke(center, radius, Stroke::new(1.5, free));
        for (axis, color) in AXES.into_iter().enumerate() {
            let color = self.color(Handle::Ring(axis), color);
            let mut front: Vec<Pos2> = Vec::new();
            for piece in rings.ring(axis).windows(2) {
                let ends = [self.at(piece[0].pixel), self.at(piece[1].pixel)];
                if piece[0].front && piece[1].front {
                    if front.last() != Some(&ends[0]) {
                        self.flush(&mut front, color);
                        front.push(ends[0]);
                    }
                    front.push(ends[1]);
                } else {
                    let faint = Stroke::new(1.0, color.gamma_multiply(0.35));
                    self.painter.line_segment(ends, faint);
                }
            }
            self.flush(&mut front, color);
        }
        self.painter.circle_filled(center, 3.0, FREE);
    }

    /// Paints the part of a ring in front, and clears it.
    fn flush(&self, front: &mut Vec<Pos2>, color: Color32) {
        if front.len() > 1 {
            self.line(front, 2.5, color);
        }
        front.clear();
    }

    fn arrows(&self, arrows: &MoveGizmo) {
        for (axis, color) in AXES.into_iter().enumerate() {
            let color = self.color(Handle::Plane(axis), color);
            if let Some(corners) = arrows.square(axis) {
                let corners = corners.map(|pixel| self.at(pixel)).to_vec();
                let fill = color.gamma_multiply(0.45);
                self.painter.add(Shape::convex_polygon(
                    corners,
                    fill,
                    Stroke::new(1.0, color),
                ));
            }
        }
        for (axis, color) in AXES.into_iter().enumerate() {
            let color = self.color(Handle::Arrow(axis), color);
            if let Some((start, end)) = arrows.arrow(axis) {
                self.arrow(self.at(start), self.at(end), color);
            }
        }
        let center = self.at(arrows.center_pixel());
        let free = self.color(Handle::Center, FREE);
        self.painter
            .circle_stroke(center, MoveGizmo::DISC, Stroke::new(3.5, HANDLE_SHADE));
        self.painter
            .circle_stroke(center, MoveGizmo::DISC, Stroke::new(1.5, free));
    }

    fn scale_handles(&self, handles: &ScaleGizmo) {
        let center = self.at(handles.center_pixel());
        let ring = self.color(Handle::FreeRing, FREE);
        let shade = Stroke::new(3.5, HANDLE_SHADE);
        self.painter
            .circle_stroke(center, ScaleGizmo::RADIUS, shade);
        self.painter
            .circle_stroke(center, ScaleGizmo::RADIUS, Stroke::new(1.5, ring));
        for (axis, color) in AXES.into_iter().enumerate() {
            let color = self.color(Handle::Arrow(axis), color);
            if let Some((start, end)) = handles.handle(axis) {
                let (start, end) = (self.at(start), self.at(end));
                self.line(&[start, end], 2.5, color);
                self.square(end, SCALE_HANDLE, color);
            }
        }
        let free = self.color(Handle::Center, FREE);
        self.square(center, ScaleGizmo::SQUARE, free);
    }

    fn square(&self, center: Pos2, half: f32, color: Color32) {
        let square = Rect::from_center_size(center, Vec2::splat(2.0 * half));
        self.painter
            .rect_filled(square.expand(1.0), 1.0, HANDLE_SHADE);
        self.painter.rect_filled(square, 0.0, color);
    }

    fn arrow(&self, start: Pos2, end: Pos2, color: Color32) {
        let along = (end - start).normalized();
        let neck = end - along * HEAD;
        self.line(&[start, neck], 2.5, color);
        let across: Vec2 = along.rot90() * (HEAD * 0.45);
        let head = vec![end, neck + across, neck - across];
        self.painter.add(Shape::convex_polygon(
            head,
            color,
            Stroke::new(1.0, HANDLE_SHADE),
        ));
    }
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
