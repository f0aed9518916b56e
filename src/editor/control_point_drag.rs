use super::{Edit, Session};
use crate::geometry::Curve;
use crate::scene::{self, CurveSet, ShapeId};
use glam::{Mat3, Mat4, Vec2, Vec3};

/// Sine of the angle (about 1°) between the ray and a plane below which the pointer does not move a
/// point in that plane.
const EDGE_ON: f32 = 0.02;
/// The same of the angle (30°) below which points of a curve that is flat for now leave its plane.
const OBLIQUE: f32 = 0.5;
/// Rounding error of a coordinate, relative to the distance from the eye: well below a pixel.
const ROUNDING: f32 = 4e-6;

/// Drag of a control point, which stays under the pointer: points of flat curves and of profiles in
/// the plane of their curve, others in the plane through them that is parallel to the picture. A curve
/// that could leave its plane, but lies in it still, does so only in a view from the side: a new curve is
/// drawn flat, as a surface of revolution needs it, though the first view looks down a little.
#[derive(Clone, Debug)]
pub struct ControlPointDrag {
    shape: ShapeId,
    curve: usize,
    point: usize,
    /// Vector from the pointer to the point in the picture, pixels.
    grip: Vec2,
    /// Position of the point at the start, in the shape's model space.
    start: Vec3,
    plane: Plane,
}

/// Plane in the world; `normal` has unit length.
#[derive(Clone, Copy, Debug)]
struct Plane {
    origin: Vec3,
    normal: Vec3,
}

/// Picks the control point of the selected shape at `pixel` in a picture of `size` (see
/// [`scene::pick_control_point`]): the indices of curve and point. `None` if control points are not
/// displayed.
pub fn control_point_at(session: &Session, pixel: Vec2, size: Vec2) -> Option<(usize, usize)> {
    let id = session.selected()?;
    if !session.scene().curve(id)?.display.control_points {
        return None;
    }
    let shape = session.evaluated().shape(id)?;
    scene::pick_control_point(shape, &session.view().camera, pixel, size)
}

impl ControlPointDrag {
    /// Begins a drag of the control point at `pixel`, if there is one (see [`control_point_at`]).
    pub fn begin(session: &Session, pixel: Vec2, size: Vec2) -> Option<Self> {
        let (curve, point) = control_point_at(session, pixel, size)?;
        let shape = session.selected()?;
        let world_from_model = session.evaluated().shape(shape)?.world_from_model;
        let grabbed = session.scene().curve(shape)?.curves().curve(curve)?;
        let start = *grabbed.control_points().get(point)?;
        let origin = world_from_model.transform_point3(start);
        let camera = &session.view().camera;
        let normal = plane_normal(session, shape, curve)?;
        Some(Self {
            shape,
            curve,
            point,
            grip: camera.pixel(origin, size)? - pixel,
            start,
            plane: Plane { origin, normal },
        })
    }

    /// Shape whose point is dragged.
    pub fn shape(&self) -> ShapeId {
        self.shape
    }

    /// Indices of the curve and of the point in it.
    pub fn control_point(&self) -> (usize, usize) {
        (self.curve, self.point)
    }

    /// Edit that moves the point under the pointer, which is at `pixel` in a picture of `size`.
    /// `None` if the pointer does not meet the plane of the point, which then stays where it is.
    pub fn moved_to(&self, session: &Session, pixel: Vec2, size: Vec2) -> Option<Edit> {
        let camera = &session.view().camera;
        let ray = camera.ray(pixel + self.grip, size);
        let towards = ray.direction.dot(self.plane.normal);
        if towards.abs() < EDGE_ON {
            return None;
        }
        let distance = (self.plane.origin - ray.origin).dot(self.plane.normal) / towards;
        let world = ray.at(distance);
        if !camera.is_in_depth(world) {
            return None;
        }
        let world_from_model = session.evaluated().shape(self.shape)?.world_from_model;
        let position = world_from_model.inverse().transform_point3(world);
        let rounding = rounding(world_from_model, ray.origin.distance(self.plane.origin));
        let position = without_rounding(position, self.start, rounding);
        position.is_finite().then_some(Edit::SetControlPoint {
            shape: self.shape,
            curve: self.curve,
            point: self.point,
            position,
        })
    }
}

/// Normal, in the world, of the plane in which points of a curve follow the pointer: see [`ControlPointDrag`].
pub(super) fn plane_normal(session: &Session, shape: ShapeId, curve: usize) -> Option<Vec3> {
    let world_from_model = session.evaluated().shape(shape)?.world_from_model;
    let flat = flat_normal(world_from_model);
    let curves = session.scene().curve(shape)?.curves();
    if cannot_leave_plane(curves, curve) {
        return flat;
    }
    let camera = &session.view().camera;
    let backward = camera.right().cross(camera.up());
    let is_flat = curves.curve(curve)?.is_flat();
    let flat = flat.filter(|normal| is_flat && normal.dot(backward).abs() > OBLIQUE);
    Some(flat.unwrap_or(backward))
}

/// Whether the points of a curve cannot leave z = 0: it says so itself, or a surface needs it.
pub(super) fn cannot_leave_plane(curves: &CurveSet, curve: usize) -> bool {
    let stays_flat = curves.curve(curve).is_some_and(Curve::stays_flat);
    stays_flat || curves.is_profile(curve)
}

/// Rounding error of a point that the pointer has moved, along each axis of its model, whose lengths in the world
/// may differ; `distance` from the eye.
pub(super) fn rounding(world_from_model: Mat4, distance: f32) -> Vec3 {
    let axes = Mat3::from_mat4(world_from_model);
    let lengths = [axes.x_axis, axes.y_axis, axes.z_axis].map(Vec3::length);
    ROUNDING * distance / Vec3::from(lengths)
}

/// Unit normal, in the world, of the model's plane z = 0; `None` if the shape is scaled to a line.
fn flat_normal(world_from_model: Mat4) -> Option<Vec3> {
    let (x, y) = (world_from_model.x_axis, world_from_model.y_axis);
    x.truncate().cross(y.truncate()).try_normalize()
}

/// `position` with the coordinates of `start` where they differ by rounding alone, so that a curve
/// that is edited in a view along an axis stays flat.
pub(super) fn without_rounding(position: Vec3, start: Vec3, rounding: Vec3) -> Vec3 {
    let same = (position - start).abs().cmple(rounding);
    Vec3::select(same, start, position)
}
