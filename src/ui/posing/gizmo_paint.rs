use super::gizmos::Gizmo;
use super::sentence::joint_name;
use super::{Place, PoseGesture};
use crate::editor::{Handle, MoveGizmo, RotationGizmo, Session};
use crate::ui::theme::Palette;
use egui::text::{LayoutJob, TextWrapping};
use egui::{Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Ui, Vec2, vec2};

const AXES: [Color32; 3] = [
    Color32::from_rgb(0xf2, 0x4f, 0x46),
    Color32::from_rgb(0x6c, 0xc4, 0x3c),
    Color32::from_rgb(0x4a, 0x90, 0xf7),
];
const FREE: Color32 = Color32::from_rgb(0xe6, 0xe6, 0xe6);
const HOT: Color32 = Color32::from_rgb(0xff, 0xd8, 0x3d);
const SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 0x78);
const HEAD: f32 = 12.0;
/// How far the readout stays away from the edge of the view.
const AWAY_FROM_EDGE: f32 = 4.0;

/// Paints a gizmo; the handle `hot` stands out, and all others step back while it is held.
pub(super) fn show(
    painter: &Painter,
    place: Place,
    gizmo: &Gizmo,
    hot: Option<Handle>,
    held: bool,
) {
    let brush = Brush {
        painter,
        place,
        hot,
        held,
    };
    match gizmo {
        Gizmo::Turn { rings, .. } => brush.rings(rings),
        Gizmo::Move { arrows, .. } => brush.arrows(arrows),
    }
}

/// The value of what is being turned or moved, beside the pointer.
pub(super) fn readout(ui: &Ui, view: Rect, session: &Session, gesture: &PoseGesture) {
    let pointer = ui.ctx().input(|input| input.pointer.latest_pos());
    let (Some(text), Some(pointer)) = (gesture.readout(), pointer) else {
        return;
    };
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter();
    let (font, color) = (FontId::proportional(13.0), palette.strong);
    let value = painter.layout_no_wrap(text, font.clone(), color);
    let (margin, gap) = (vec2(6.0, 3.0), 8.0);
    // Names come from files and may be as long as they like: the value stays readable.
    let room = view.width() - value.size().x - gap - 2.0 * (margin.x + AWAY_FROM_EDGE);
    let name = joint_name(session, gesture.shape(), gesture.named()).unwrap_or_default();
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
        let shade = Stroke::new(width + 2.0, SHADE.gamma_multiply(color.a() as f32 / 255.0));
        self.painter.add(Shape::line(points.to_vec(), shade));
        self.painter
            .add(Shape::line(points.to_vec(), Stroke::new(width, color)));
    }

    fn rings(&self, rings: &RotationGizmo) {
        let center = self.at(rings.center_pixel());
        let free = self.color(Handle::FreeRing, FREE);
        let radius = RotationGizmo::FREE_RADIUS;
        self.painter
            .circle_stroke(center, radius, Stroke::new(3.5, SHADE));
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
            .circle_stroke(center, MoveGizmo::DISC, Stroke::new(3.5, SHADE));
        self.painter
            .circle_stroke(center, MoveGizmo::DISC, Stroke::new(1.5, free));
    }

    fn arrow(&self, start: Pos2, end: Pos2, color: Color32) {
        let along = (end - start).normalized();
        let neck = end - along * HEAD;
        self.line(&[start, neck], 2.5, color);
        let across: Vec2 = along.rot90() * (HEAD * 0.45);
        let head = vec![end, neck + across, neck - across];
        self.painter
            .add(Shape::convex_polygon(head, color, Stroke::new(1.0, SHADE)));
    }
}
