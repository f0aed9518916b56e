use super::{GizmoAxes, GizmoHit, Handle, Nearest, Screen};
use crate::editor::{Constraint, MoveAlong, MoveTarget, Session};
use glam::{Mat3, Vec2, Vec3};

/// Start and end of an arrow, in pixels from the center.
const ARROW_START: f32 = 16.0;
const ARROW_END: f32 = 84.0;
/// Length in the picture, in pixels, below which an arrow that points at the eye cannot be grabbed.
const LEAST_ARROW: f32 = 14.0;
/// Range of the squares between two axes along each axis, in pixels from the center.
const SQUARE: (f32, f32) = (26.0, 44.0);
/// Sine of the angle of view below which a square cannot be grabbed.
const FLATTEST: f32 = 0.15;

/// Gizmo to move a shape or a root: three arrows, three squares between them, and a disc at the
/// center.
#[derive(Clone, Debug)]
pub struct MoveGizmo {
    screen: Screen,
    center: Vec3,
    center_pixel: Vec2,
    axes: [Vec3; 3],
    /// Length of a pixel at the center, in the world.
    per_pixel: f32,
}

impl MoveGizmo {
    /// Radius of the disc at the center, in pixels.
    pub const DISC: f32 = 9.0;

    /// Gizmo of `target`, in a picture of `size` pixels with the session's camera. `None` if it
    /// does not exist, or is not in front of the camera.
    pub fn new(session: &Session, target: MoveTarget, axes: GizmoAxes, size: Vec2) -> Option<Self> {
        let screen = Screen {
            camera: session.view().camera,
            size,
        };
        let center = target.place(session)?;
        let shape = session.scene().shape(target.shape())?;
        let turned = match axes {
            GizmoAxes::World => Mat3::IDENTITY,
            GizmoAxes::Local => shape.placement.transform.rotation.to_mat3(),
        };
        Some(Self {
            screen,
            center,
            center_pixel: screen.pixel(center)?,
            axes: [turned.x_axis, turned.y_axis, turned.z_axis],
            per_pixel: screen.world_per_pixel(center)?,
        })
    }

    /// Position of the center in the picture, in pixels.
    pub fn center_pixel(&self) -> Vec2 {
        self.center_pixel
    }

    pub(super) fn center(&self) -> Vec3 {
        self.center
    }

    /// Both ends of the arrow along an axis, in pixels; `None` if it points at the eye.
    pub fn arrow(&self, axis: usize) -> Option<(Vec2, Vec2)> {
        let (start, end) = self.arrow_in_world(axis);
        let (start, end) = (self.screen.pixel(start)?, self.screen.pixel(end)?);
        (start.distance(end) >= LEAST_ARROW).then_some((start, end))
    }

    /// Corners of the square perpendicular to an axis, in pixels; `None` if it is seen from the
    /// side.
    pub fn square(&self, axis: usize) -> Option<[Vec2; 4]> {
        let to_eye = (self.screen.camera.eye() - self.center).try_normalize()?;
        if to_eye.dot(self.axes[axis]).abs() < FLATTEST {
            return None;
        }
        let (a, b) = (self.axes[(axis + 1) % 3], self.axes[(axis + 2) % 3]);
        let (near, far) = SQUARE;
        let corners = [(near, near), (far, near), (far, far), (near, far)];
        let pixel = |(i, j): (f32, f32)| {
            self.screen
                .pixel(self.center + (a * i + b * j) * self.per_pixel)
        };
        let [p, q, r, s] = corners.map(pixel);
        Some([p?, q?, r?, s?])
    }

    /// Line or plane along which a handle moves the target.
    pub fn along(&self, handle: Handle) -> Option<MoveAlong> {
        match handle {
            Handle::Arrow(axis) => Some(MoveAlong::Line(self.axes[axis])),
            Handle::Plane(normal) => {
                let mut axes = Constraint::Plane(normal).axes();
                let mut next = || Some(self.axes[axes.next()?]);
                Some(MoveAlong::Axes(next()?, next()?))
            }
            Handle::Center => Some(MoveAlong::Plane(self.screen.camera.forward())),
            Handle::Ring(_) | Handle::FreeRing => None,
        }
    }

    /// Handle under `pixel`, with the point where it is grabbed.
    pub fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        let at = |handle| GizmoHit {
            handle,
            point: self.center,
        };
        if pixel.distance(self.center_pixel) <= Self::DISC {
            return Some(at(Handle::Center));
        }
        let mut nearest = Nearest::new(pixel);
        for axis in 0..3 {
            if let Some(pixels) = self.arrow(axis) {
                nearest.segment(Handle::Arrow(axis), pixels, self.arrow_in_world(axis));
            }
        }
        let squares = (0..3).filter(|&axis| self.square(axis).is_some_and(|s| holds(&s, pixel)));
        nearest
            .found()
            .or_else(|| squares.map(|axis| at(Handle::Plane(axis))).next())
    }

    pub(super) fn arrow_in_world(&self, axis: usize) -> (Vec3, Vec3) {
        let point = |pixels: f32| self.center + self.axes[axis] * (pixels * self.per_pixel);
        (point(ARROW_START), point(ARROW_END))
    }
}

/// Whether a convex quadrilateral of either winding contains a point.
fn holds(corners: &[Vec2; 4], point: Vec2) -> bool {
    let sides = [0, 1, 2, 3].map(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        (b - a).perp_dot(point - a)
    });
    sides.iter().all(|&side| side >= 0.0) || sides.iter().all(|&side| side <= 0.0)
}
