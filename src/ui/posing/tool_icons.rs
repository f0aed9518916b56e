//! Icons of the tools, drawn rather than taken from a font: a picture is found faster than a word.

use crate::editor::Tool;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};
use std::f32::consts::{FRAC_PI_2, TAU};

/// Width and height of an icon, in points.
pub(super) const SIZE: Vec2 = Vec2::splat(14.0);

/// Paints the icon of `tool` in `rect`.
pub(super) fn paint(painter: &Painter, rect: Rect, tool: Tool, color: Color32) {
    let brush = Brush {
        painter,
        rect,
        color,
    };
    match tool {
        Tool::Select => brush.arrow(),
        Tool::Pose => brush.bone(),
        Tool::Move => brush.cross(),
        Tool::Rotate => brush.turn(),
        Tool::Scale => brush.growth(),
        Tool::Ik => brush.chain(),
    }
}

struct Brush<'a> {
    painter: &'a Painter,
    rect: Rect,
    color: Color32,
}

impl Brush<'_> {
    /// Position within the icon, whose sides are 1 long.
    fn at(&self, x: f32, y: f32) -> Pos2 {
        self.rect.min + vec2(x, y) * self.rect.size()
    }

    fn stroke(&self) -> Stroke {
        Stroke::new(1.5, self.color)
    }

    fn filled(&self, corners: &[(f32, f32)]) {
        let corners = corners.iter().map(|&(x, y)| self.at(x, y)).collect();
        let shape = Shape::convex_polygon(corners, self.color, Stroke::NONE);
        self.painter.add(shape);
    }

    /// The pointer of a mouse.
    fn arrow(&self) {
        self.filled(&[(0.2, 0.05), (0.82, 0.62), (0.48, 0.62), (0.2, 0.9)]);
        let tail = [self.at(0.45, 0.55), self.at(0.62, 0.95)];
        self.painter
            .line_segment(tail, Stroke::new(2.0, self.color));
    }

    /// A bone that swings about its lower joint.
    fn bone(&self) {
        let joint = self.at(0.2, 0.85);
        let end = self.at(0.45, 0.3);
        self.painter
            .line_segment([joint, end], Stroke::new(2.0, self.color));
        for end in [joint, end] {
            self.painter.circle_filled(end, 2.2, self.color);
        }
        let swing = (0..=8).map(|piece| {
            let angle = -0.2 * TAU + 0.17 * TAU * piece as f32 / 8.0;
            self.at(0.2 + 0.75 * angle.cos(), 0.85 + 0.75 * angle.sin())
        });
        self.painter
            .add(Shape::line(swing.collect(), Stroke::new(1.0, self.color)));
    }

    /// A square that grows along an arrow.
    fn growth(&self) {
        self.filled(&[(0.0, 0.6), (0.4, 0.6), (0.4, 1.0), (0.0, 1.0)]);
        let arrow = [self.at(0.45, 0.55), self.at(0.75, 0.25)];
        self.painter.line_segment(arrow, self.stroke());
        self.filled(&[(1.0, 0.0), (0.95, 0.5), (0.5, 0.05)]);
    }

    /// Three quarters of a circle that end in an arrow.
    fn turn(&self) {
        const PIECES: usize = 24;
        let on_circle = |part: f32| {
            let angle = part * 0.75 * TAU - FRAC_PI_2;
            self.at(0.5 + 0.4 * angle.cos(), 0.5 + 0.4 * angle.sin())
        };
        let points = (0..=PIECES).map(|piece| on_circle(piece as f32 / PIECES as f32));
        self.painter
            .add(Shape::line(points.collect(), self.stroke()));
        self.filled(&[(0.1, 0.22), (0.34, 0.56), (-0.14, 0.56)]);
        self.painter
            .circle_filled(self.rect.center(), 2.0, self.color);
    }

    /// Arrows to all sides.
    fn cross(&self) {
        let ends = [(0.5, 0.0), (1.0, 0.5), (0.5, 1.0), (0.0, 0.5)];
        for (x, y) in ends {
            let end = self.at(x, y);
            let along = (end - self.rect.center()) / 7.0;
            let neck = end - along * 2.6;
            self.painter
                .line_segment([self.rect.center(), neck], self.stroke());
            let across = along.rot90() * 2.2;
            let head = vec![end, neck + across, neck - across];
            self.painter
                .add(Shape::convex_polygon(head, self.color, Stroke::NONE));
        }
    }

    /// Two bones and their joints; a ring round the one that is dragged.
    fn chain(&self) {
        let joints = [self.at(0.12, 0.88), self.at(0.3, 0.3), self.at(0.8, 0.28)];
        for bone in joints.windows(2) {
            self.painter.line_segment([bone[0], bone[1]], self.stroke());
        }
        for joint in &joints[..2] {
            self.painter.circle_filled(*joint, 2.0, self.color);
        }
        self.painter.circle_filled(joints[2], 1.2, self.color);
        self.painter.circle_stroke(joints[2], 3.0, self.stroke());
    }
}
