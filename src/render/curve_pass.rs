use super::frame::{Frame, PassContext};
use crate::geometry::Normals;
use crate::gpu::{DrawState, Gl, Immediate, Mode, PointShape};
use crate::scene::{
    CurveDisplay, CurveVisibility, EvaluatedCurve, EvaluatedCurves, EvaluatedGeometry,
    EvaluatedShape, ShapeKind, SurfaceVisibility,
};
use glam::Vec3;

const CURVE: Vec3 = Vec3::ONE;
const CONTROL: Vec3 = Vec3::new(1.0, 1.0, 0.0);
const CONTROL_POINT_SIZE: f32 = 5.0;
const HOVERED_POINT_SIZE: f32 = 11.0;
/// Length of the lines that show a frame, in the curve's space.
const FRAME_LENGTH: f32 = 0.2;
const NORMAL: Vec3 = Vec3::X;
const BINORMAL: Vec3 = Vec3::Y;
const TANGENT: Vec3 = Vec3::Z;
const WIREFRAME: Vec3 = Vec3::new(0.27, 0.51, 0.71);
const SURFACE_NORMAL: Vec3 = Vec3::new(0.0, 0.5, 0.5);
const SURFACE_NORMAL_LENGTH: f32 = 0.1;

/// Draws the lines and points of every shape made of curves: control polygons, curves with their
/// frames, wireframes with normals. Shaded surfaces are the surface pass's.
pub(super) fn draw_curves(
    gl: &Gl,
    context: &PassContext,
    frame: &Frame,
    immediate: &mut Immediate,
) {
    for (shape, evaluated) in frame.shapes() {
        let ShapeKind::Curve(curve) = &shape.kind else {
            continue;
        };
        let Some(curves) = &evaluated.geometry.curves else {
            continue;
        };
        DrawState::opaque(context.width, context.height).apply(gl);
        immediate.load_matrix(context.clip_from_world * evaluated.world_from_model);
        immediate.line_width(1.0);
        draw_shape(immediate, curve.display, curves, &evaluated.geometry);
        let hovered = frame.marks.hovered_control_point;
        if let Some(point) = hovered.filter(|_| frame.marks.selected == Some(shape.id)) {
            draw_hovered_point(immediate, curves, point);
        }
    }
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

fn draw_shape(
    immediate: &mut Immediate,
    display: CurveDisplay,
    curves: &EvaluatedCurves,
    geometry: &EvaluatedGeometry,
) {
    if display.control_points {
        curves
            .curves
            .iter()
            .for_each(|curve| draw_control_points(immediate, curve));
    }
    if display.curve != CurveVisibility::Off {
        curves
            .curves
            .iter()
            .for_each(|curve| draw_curve(immediate, curve, CURVE));
    }
    if display.curve == CurveVisibility::OnWithFrames {
        curves
            .curves
            .iter()
            .for_each(|curve| draw_frames(immediate, curve));
    }
    if display.surface == SurfaceVisibility::WireframeWithNormals {
        draw_wireframe(immediate, curves, geometry);
    }
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

fn draw_control_points(immediate: &mut Immediate, curve: &EvaluatedCurve) {
    immediate.color(CONTROL);
    immediate.begin(Mode::LineStrip);
    curve
        .control_points
        .iter()
        .for_each(|&point| immediate.vertex(point));
    immediate.end();
    immediate.point_size(CONTROL_POINT_SIZE);
    immediate.point_shape(PointShape::Square);
    immediate.begin(Mode::Points);
    curve
        .control_points
        .iter()
        .for_each(|&point| immediate.vertex(point));
    immediate.end();
}

fn draw_curve(immediate: &mut Immediate, curve: &EvaluatedCurve, color: Vec3) {
    immediate.color(color);
    immediate.begin(Mode::LineStrip);
    curve.positions().for_each(|point| immediate.vertex(point));
    immediate.end();
}

fn draw_frames(immediate: &mut Immediate, curve: &EvaluatedCurve) {
    immediate.begin(Mode::Lines);
    for point in &curve.points {
        for (color, along) in [
            (NORMAL, point.frame.normal),
            (BINORMAL, point.frame.binormal),
            (TANGENT, point.frame.tangent),
        ] {
            immediate.color(color);
            immediate.vertex(point.position);
            immediate.vertex(point.position + along * FRAME_LENGTH);
        }
    }
    immediate.end();
}

fn draw_wireframe(
    immediate: &mut Immediate,
    curves: &EvaluatedCurves,
    geometry: &EvaluatedGeometry,
) {
    let positions = geometry.positions();
    immediate.color(WIREFRAME);
    immediate.begin(Mode::Lines);
    for corner in curves.edges.iter().flatten() {
        immediate.vertex(positions[*corner as usize]);
    }
    immediate.end();
    let Normals::PerVertex(normals) = &geometry.mesh.normals else {
        return;
    };
    immediate.color(SURFACE_NORMAL);
    immediate.begin(Mode::Lines);
    for (&position, &normal) in positions.iter().zip(normals) {
        immediate.vertex(position);
        immediate.vertex(position + normal * SURFACE_NORMAL_LENGTH);
    }
    immediate.end();
}
