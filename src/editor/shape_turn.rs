use super::swing::{Swing, snapped};
use super::{Edit, Session, ShapeGroup};
use crate::math::{DRay, Ray};
use glam::{DVec3, Vec3};

/// Turn of the selected shapes about the pivot of their [`ShapeGroup`], by a ring or by the cursor
/// anywhere around the pivot.
#[derive(Clone, Debug)]
pub struct ShapeTurn {
    group: ShapeGroup,
    /// In the world, of unit length.
    axis: DVec3,
    /// Unknown while the cursor has not left the pivot.
    swing: Option<Swing>,
    /// Angle of the cursor, in radians.
    wanted: f64,
    /// Angle of the shapes, in radians: in steps if it snaps.
    angle: f64,
}

impl ShapeTurn {
    /// Begins a turn of `group` about `axis` in the world, with the cursor on `ray`, which grabs
    /// the point `grabbed`. `None` if the axis has no direction.
    pub fn begin(group: ShapeGroup, axis: Vec3, grabbed: Vec3, ray: &Ray) -> Option<Self> {
        let axis = axis.as_dvec3().try_normalize()?;
        let pivot = group.pivot().as_dvec3();
        let swing = Swing::begin(pivot, axis, grabbed.as_dvec3(), &DRay::from(ray));
        Some(Self::with(group, axis, swing))
    }

    /// The same for the cursor anywhere on `ray`, which comes from the eye.
    pub fn in_front(group: ShapeGroup, axis: Vec3, ray: &Ray) -> Option<Self> {
        let pivot = group.pivot().as_dvec3();
        let axis = axis.as_dvec3().try_normalize()?;
        let swing = Swing::begin_in_front(pivot, axis, &DRay::from(ray));
        Some(Self::with(group, axis, swing))
    }

    fn with(group: ShapeGroup, axis: DVec3, swing: Option<Swing>) -> Self {
        Self {
            group,
            axis,
            swing,
            wanted: 0.0,
            angle: 0.0,
        }
    }

    /// The same about the direction in which a camera looks, `forward`, which is an axis of the world in a view along that,
    /// wherever in the picture the pivot is. The cursor grabs the point beside the pivot. `None` if the ray does not lead
    /// there.
    pub fn about_view(group: ShapeGroup, forward: Vec3, ray: &Ray) -> Option<Self> {
        let away = (group.pivot() - ray.origin).dot(forward) / ray.direction.dot(forward);
        let grabbed = ray.at(away);
        grabbed
            .is_finite()
            .then(|| Self::begin(group, forward, grabbed, ray))?
    }

    /// Edit that turns the shapes for the cursor on `ray`; with `snap` in steps of 15° from the
    /// start.
    pub fn update(&mut self, session: &Session, ray: &Ray, snap: bool) -> Edit {
        let (pivot, ray) = (self.group.pivot().as_dvec3(), DRay::from(ray));
        let begun = || Swing::begin_in_front(pivot, self.axis, &ray);
        self.swing = self.swing.or_else(begun);
        let angle = self.swing.and_then(|swing| swing.angle(&ray, self.wanted));
        self.wanted = angle.unwrap_or(self.wanted);
        self.angle = snapped(self.wanted, snap);
        self.group.turned(self.axis, self.angle, Some(session))
    }

    /// Edit that turns the shapes by exactly this angle in radians about the axis, wherever the
    /// cursor is.
    pub fn turned_by(&mut self, angle: f64) -> Edit {
        self.angle = angle;
        self.group.turned(self.axis, angle, None)
    }

    /// The axis in the world, of unit length.
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Angle by which the shapes have turned about the axis, in radians.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// 1 if the angle has the sign of the angle in the panel that changes most, or else -1.
    pub fn panel_sign(&self) -> f64 {
        self.group.panel_sign(self.axis)
    }

    /// The shapes that turn.
    pub fn group(&self) -> &ShapeGroup {
        &self.group
    }
}
