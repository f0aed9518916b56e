use super::{GizmoAxes, GizmoHit, Handle, MoveGizmo, Nearest, RotationGizmo};
use crate::editor::{MoveTarget, Session};
use glam::Vec2;

/// Gizmo to scale the selected shapes: three handles along the axes of the active one, a ring and a
/// square in the middle that scale all axes alike.
#[derive(Clone, Debug)]
pub struct ScaleGizmo {
    handles: MoveGizmo,
}

impl ScaleGizmo {
    /// Half the side of the square in the middle, in pixels.
    pub const SQUARE: f32 = 7.0;
    /// Radius of the ring, in pixels.
    pub const RADIUS: f32 = RotationGizmo::FREE_RADIUS + 12.0;

    /// Gizmo of the active shape, in a picture of `size` pixels with the session's camera. `None`
    /// if there is none, or it is not in front of the camera.
    pub fn new(session: &Session, size: Vec2) -> Option<Self> {
        let target = MoveTarget::Shape(session.selected()?);
        let handles = MoveGizmo::new(session, target, GizmoAxes::Local, size)?;
        Some(Self { handles })
    }

    /// Position of the pivot in the picture, in pixels.
    pub fn center_pixel(&self) -> Vec2 {
        self.handles.center_pixel()
    }

    /// Both ends of the handle along an axis, in pixels; `None` if it points at the eye.
    pub fn handle(&self, axis: usize) -> Option<(Vec2, Vec2)> {
        self.handles.arrow(axis)
    }

    /// Handle under `pixel`, with the point where it is grabbed.
    pub fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        let at = |handle| GizmoHit {
            handle,
            point: self.handles.center(),
        };
        let from_center = (pixel - self.center_pixel()).abs();
        if from_center.max_element() <= Self::SQUARE + 2.0 {
            return Some(at(Handle::Center));
        }
        let mut nearest = Nearest::new(pixel);
        for axis in 0..3 {
            if let Some(pixels) = self.handle(axis) {
                let points = self.handles.arrow_in_world(axis);
                nearest.segment(Handle::Arrow(axis), pixels, points);
            }
        }
        let beside_ring = (from_center.length() - Self::RADIUS).abs();
        nearest.offer(beside_ring, at(Handle::FreeRing));
        nearest.found()
    }
}
