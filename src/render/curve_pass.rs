//! Lines and points of shapes made of curves.

use super::frame::{Frame, PassContext};
use super::upload_cache::UploadCache;
use crate::geometry::Normals;
use crate::gpu::{DepthTest, DisplayList, DrawState, Gl, Immediate, Mode, PointShape};
use crate::revision::Revision;
use crate::scene::{
    CurveDisplay, CurveShape, CurveVisibility, EvaluatedCurve, EvaluatedCurves, EvaluatedGeometry,
    EvaluatedShape, Look, Shape, ShapeKind, SurfaceVisibility,
};
use glam::Vec3;

const HOVERED_POINT_SIZE: f32 = 11.0;

/// Draws the lines and points of every shape made of curves: control polygons, curves with their
/// frames, wireframes with normals. The surface pass draws shaded surfaces.
#[derive(Debug, Default)]
pub(super) struct CurvePass {
    /// By what determines the lines: the revision of the geometry, how it is displayed, and colors.
    lines: UploadCache<(Revision, CurveDisplay, LineColors), DisplayList>,
}

impl CurvePass {
    /// Uploads the lines of all visible shapes that have changed.
    pub fn update(&mut self, gl: &Gl, frame: &Frame, immediate: &mut Immediate) {
        self.lines.forget_deleted(frame.evaluated);
        for Shown {
            shape,
            curve,
            curves,
            evaluated,
        } in shown(frame)
        {
            let geometry = &evaluated.geometry;
            let colors = LineColors::of(frame, shape);
            let key = (geometry.revision, curve.display, colors);
            let keep = |_: &mut DisplayList| Ok(());
            self.lines.update(shape.id, key, keep, || {
                immediate.line_width(1.0);
                immediate.begin_list();
                draw_shape(immediate, (curve.display, colors), curves, geometry);
                let list = immediate.end_list()?;
                gl.check("uploading curves")?;
                Ok(list)
            });
        }
    }

    /// Draws the lines that [`CurvePass::update`] uploaded.
    pub fn draw(&self, gl: &Gl, context: &PassContext, frame: &Frame, immediate: &mut Immediate) {
        for Shown {
            shape, evaluated, ..
        } in shown(frame)
        {
            DrawState::opaque(context.width, context.height).apply(gl);
            immediate.load_matrix(context.clip_from_world * evaluated.world_from_model);
            if let Some(list) = self.lines.get(shape.id) {
                immediate.call_list(list);
            }
        }
    }

    /// Draws the control points of the selected shape, where they are shown, over everything that hides
    /// them: they are there to be dragged.
    pub fn draw_marked(gl: &Gl, context: &PassContext, frame: &Frame, immediate: &mut Immediate) {
        let over_all = DrawState {
            depth_test: DepthTest::Off,
            depth_write: false,
            ..DrawState::opaque(context.width, context.height)
        };
        let marked = shown(frame).filter(|shown| frame.marks.selected == Some(shown.shape.id));
        for shown in marked.filter(|shown| shown.curve.display.control_points) {
            over_all.apply(gl);
            immediate.load_matrix(context.clip_from_world * shown.evaluated.world_from_model);
            immediate.line_width(1.0);
            immediate.color(context.colors.control);
            for curve in &shown.curves.curves {
                draw_control_points(immediate, curve);
            }
            if let Some(point) = frame.marks.hovered_control_point {
                draw_hovered_point(immediate, shown.curves, point);
            }
        }
    }

    /// The visible shapes whose lines the driver could not take, in words for the user.
    pub fn left_out(&self, frame: &Frame) -> Vec<String> {
        let refused = self.lines.refused(frame);
        refused
            .map(|(shape, why)| format!("the lines of “{}” ({why})", shape.name))
            .collect()
    }
}

/// A visible shape made of curves, with its evaluation.
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
    immediate.point_size(HOVERED_POINT_SIZE);
    immediate.point_shape(PointShape::Square);
    immediate.begin(Mode::Points);
    immediate.vertex(position);
    immediate.end();
}

/// Draws the curves of a shape in one color and wider, for the mask of outlines.
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

/// Colors of lines that depend on what is behind them.
#[derive(Clone, Copy, Debug, PartialEq)]
struct LineColors {
    curve: Vec3,
    /// Control points and their polygon.
    control: Vec3,
}

impl LineColors {
    /// Those of the backdrop; where a color was chosen for the shape, its curves have that, but in the Course look, whose
    /// original colors surfaces alone.
    fn of(frame: &Frame, shape: &Shape) -> Self {
        let colors = frame.backdrop.colors(frame.view.look);
        let (own, first) = (shape.placement.color, shape.start.color);
        let is_chosen = own != first && frame.view.look != Look::Course;
        Self {
            curve: if is_chosen { own.rgb() } else { colors.curve },
            control: colors.control,
        }
    }
}

const CONTROL_POINT_SIZE: f32 = 5.0;
/// Length of the axes of a frame, in the curve's space.
const FRAME_LENGTH: f32 = 0.2;
const NORMAL: Vec3 = Vec3::X;
const BINORMAL: Vec3 = Vec3::Y;
const TANGENT: Vec3 = Vec3::Z;
const WIREFRAME: Vec3 = Vec3::new(0.27, 0.51, 0.71);
const SURFACE_NORMAL: Vec3 = Vec3::new(0.0, 0.5, 0.5);
const SURFACE_NORMAL_LENGTH: f32 = 0.1;

/// Draws the lines and points of a shape made of curves that `display` asks for, in its space.
fn draw_shape(
    immediate: &mut Immediate,
    (display, colors): (CurveDisplay, LineColors),
    curves: &EvaluatedCurves,
    geometry: &EvaluatedGeometry,
) {
    if display.control_points {
        immediate.color(colors.control);
        curves
            .curves
            .iter()
            .for_each(|curve| draw_control_points(immediate, curve));
    }
    if display.curve != CurveVisibility::Off {
        curves
            .curves
            .iter()
            .for_each(|curve| draw_curve(immediate, curve, colors.curve));
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

/// Draws the control points and their polygon in the color that is set.
fn draw_control_points(immediate: &mut Immediate, curve: &EvaluatedCurve) {
    let points = || curve.control_points.iter().copied();
    draw_group(immediate, Mode::LineStrip, points());
    immediate.point_size(CONTROL_POINT_SIZE);
    immediate.point_shape(PointShape::Square);
    draw_group(immediate, Mode::Points, points());
}

/// Draws the curve as a line.
fn draw_curve(immediate: &mut Immediate, curve: &EvaluatedCurve, color: Vec3) {
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
