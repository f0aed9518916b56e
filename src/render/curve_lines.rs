use crate::geometry::Normals;
use crate::gpu::{Immediate, Mode, PointShape};
use crate::scene::{
    CurveDisplay, CurveVisibility, EvaluatedCurve, EvaluatedCurves, EvaluatedGeometry,
    SurfaceVisibility,
};
use glam::Vec3;

const CURVE: Vec3 = Vec3::ONE;
/// Color of control points and their polygon.
pub(super) const CONTROL: Vec3 = Vec3::new(1.0, 1.0, 0.0);
const CONTROL_POINT_SIZE: f32 = 5.0;
/// Length of the lines that show a frame, in the curve's space.
const FRAME_LENGTH: f32 = 0.2;
const NORMAL: Vec3 = Vec3::X;
const BINORMAL: Vec3 = Vec3::Y;
const TANGENT: Vec3 = Vec3::Z;
const WIREFRAME: Vec3 = Vec3::new(0.27, 0.51, 0.71);
const SURFACE_NORMAL: Vec3 = Vec3::new(0.0, 0.5, 0.5);
const SURFACE_NORMAL_LENGTH: f32 = 0.1;

/// The lines and points of a shape made of curves, in its space, as `display` has them.
pub(super) fn draw_shape(
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

fn draw_control_points(immediate: &mut Immediate, curve: &EvaluatedCurve) {
    let points = || curve.control_points.iter().copied();
    immediate.color(CONTROL);
    draw_group(immediate, Mode::LineStrip, points());
    immediate.point_size(CONTROL_POINT_SIZE);
    immediate.point_shape(PointShape::Square);
    draw_group(immediate, Mode::Points, points());
}

/// The curve as a line.
pub(super) fn draw_curve(immediate: &mut Immediate, curve: &EvaluatedCurve, color: Vec3) {
    immediate.color(color);
    draw_group(immediate, Mode::LineStrip, curve.positions());
}

fn draw_group(immediate: &mut Immediate, mode: Mode, points: impl Iterator<Item = Vec3>) {
    immediate.begin(mode);
    points.for_each(|point| immediate.vertex(point));
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
