//! Painting of gizmos over a picture of the scene.

use super::shown_gizmo::Gizmo;
use crate::editor::{Handle, MoveGizmo, RotationGizmo, ScaleGizmo, Session};
use crate::ui::scene_places::Place;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2};

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
        let radius = rings.free_radius();
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
