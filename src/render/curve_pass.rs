use super::curve_lines::{CONTROL, draw_curve, draw_shape};
use super::frame::{Frame, PassContext};
use crate::gpu::{DisplayList, DrawState, Gl, GpuError, Immediate, Mode, PointShape};
use crate::revision::Revision;
use crate::scene::{
    CurveDisplay, CurveShape, EvaluatedCurves, EvaluatedShape, Shape, ShapeId, ShapeKind,
};
use glam::Vec3;
use std::collections::{HashMap, HashSet};

const HOVERED_POINT_SIZE: f32 = 11.0;

/// Draws the lines and points of every shape made of curves: control polygons, curves with their
/// frames, wireframes with normals. Shaded surfaces are the surface pass's.
#[derive(Debug, Default)]
pub(super) struct CurvePass {
    lines: HashMap<ShapeId, KeptLines>,
}

/// The lines of one shape in the memory of the graphics card, for as long as they stay the same.
#[derive(Debug)]
struct KeptLines {
    revision: Revision,
    display: CurveDisplay,
    /// Or why the driver could not take them; they are not tried again.
    list: Result<DisplayList, GpuError>,
}

impl CurvePass {
    /// Brings the lines of all visible shapes up to date and forgets those of shapes that are gone.
    pub fn update(&mut self, gl: &Gl, frame: &Frame, immediate: &mut Immediate) {
        let there: HashSet<ShapeId> = frame.evaluated.shapes.iter().map(|s| s.id).collect();
        self.lines.retain(|id, _| there.contains(id));
        for Shown {
            shape,
            curve,
            curves,
            evaluated,
        } in shown(frame)
        {
            let geometry = &evaluated.geometry;
            let revision = geometry.revision;
            let is_same =
                |known: &KeptLines| known.revision == revision && known.display == curve.display;
            if self.lines.get(&shape.id).is_some_and(is_same) {
                continue;
            }
            // Before there are new ones.
            self.lines.remove(&shape.id);
            immediate.line_width(1.0);
            immediate.begin_list();
            draw_shape(immediate, curve.display, curves, geometry);
            let list = immediate.end_list();
            let list = list.and_then(|list| gl.check("uploading curves").map(|()| list));
            let lines = KeptLines {
                revision,
                display: curve.display,
                list,
            };
            self.lines.insert(shape.id, lines);
        }
    }

    /// Draws what [`CurvePass::update`] brought up to date.
    pub fn draw(&self, gl: &Gl, context: &PassContext, frame: &Frame, immediate: &mut Immediate) {
        for Shown {
            shape,
            curves,
            evaluated,
            ..
        } in shown(frame)
        {
            DrawState::opaque(context.width, context.height).apply(gl);
            immediate.load_matrix(context.clip_from_world * evaluated.world_from_model);
            if let Some(Ok(list)) = self.lines.get(&shape.id).map(|lines| &lines.list) {
                immediate.call_list(list);
            }
            let hovered = frame.marks.hovered_control_point;
            if let Some(point) = hovered.filter(|_| frame.marks.selected == Some(shape.id)) {
                draw_hovered_point(immediate, curves, point);
            }
        }
    }

    /// The visible shapes whose lines the driver could not take, in words for the user.
    pub fn left_out(&self, frame: &Frame) -> Vec<String> {
        let told = |(shape, _): (&Shape, &EvaluatedShape)| {
            let why = self.lines.get(&shape.id)?.list.as_ref().err()?;
            Some(format!("the lines of “{}” ({why})", shape.name))
        };
        frame.shapes().filter_map(told).collect()
    }
}

/// A visible shape made of curves, and what follows from it.
struct Shown<'a> {
    shape: &'a Shape,
    curve: &'a CurveShape,
    curves: &'a EvaluatedCurves,
    evaluated: &'a EvaluatedShape,
}

/// The visible shapes made of curves.
fn shown<'a>(frame: &Frame<'a>) -> impl Iterator<Item = Shown<'a>> {
    frame.shapes().filter_map(|(shape, evaluated)| {
        let ShapeKind::Curve(curve) = &shape.kind else {
            return None;
        };
        Some(Shown {
            shape,
            curve,
            curves: evaluated.geometry.curves.as_ref()?,
            evaluated,
        })
    })
}

fn draw_hovered_point(
    immediate: &mut Immediate,
    curves: &EvaluatedCurves,
    (item, point): (usize, usize),
) {
    let curve = curves.curves.iter().find(|curve| curve.item == item);
    let Some(&position) = curve.and_then(|curve| curve.control_points.get(point)) else {
        return;
    };
    immediate.color(CONTROL);
    immediate.point_size(HOVERED_POINT_SIZE);
    immediate.point_shape(PointShape::Square);
    immediate.begin(Mode::Points);
    immediate.vertex(position);
    immediate.end();
}

/// The curves and control polygons of a shape in one color and wider, for the mask of outlines.
pub(super) fn draw_curve_mask(
    immediate: &mut Immediate,
    context: &PassContext,
    evaluated: &EvaluatedShape,
    color: Vec3,
) {
    let Some(curves) = &evaluated.geometry.curves else {
        return;
    };
    immediate.load_matrix(context.clip_from_world * evaluated.world_from_model);
    immediate.line_width(3.0);
    for curve in &curves.curves {
        draw_curve(immediate, curve, color);
    }
    immediate.line_width(1.0);
}
