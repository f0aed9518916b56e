use super::{Constraint, Edit, GizmoAxes, ShapeGroup};
use crate::math::{DRay, Ray};
use glam::{DVec3, Vec3};

/// Step of a factor that snaps.
const SNAP: f64 = 0.1;
/// Least factor that the cursor gives: what is smaller has to be typed.
const LEAST: f64 = 0.01;
/// Distance from the pivot, relative to that from the eye (about a pixel), below which the cursor
/// gives no factor.
const ON_THE_PIVOT: f64 = 1e-3;

/// Way in which the cursor gives a factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScaleBy {
    /// By the place along an axis of the active shape: 0 for x, 1 for y, 2 for z.
    Axis(usize),
    /// By the distance from the pivot across the view.
    Distance,
    /// Twice for each such distance, in the world at the pivot, to the right or up.
    Doubling(f32),
}

/// Scaling of the selected shapes about the pivot of their [`ShapeGroup`], along the axes of each.
#[derive(Clone, Debug)]
pub struct ShapeScale {
    group: ShapeGroup,
    by: ScaleBy,
    /// The axes that alone are scaled; `None` for all.
    constraint: Option<Constraint>,
    /// Directions across the view, in the world, of unit length.
    right: DVec3,
    up: DVec3,
    /// What the factor is relative to; unknown while the cursor has not left the pivot.
    start: Option<f64>,
    factor: f64,
}

impl ShapeScale {
    /// Begins to scale `group` with the cursor on `ray`; `right` and `up` are the camera's.
    pub fn begin(group: ShapeGroup, by: ScaleBy, (right, up): (Vec3, Vec3), ray: &Ray) -> Self {
        let mut scale = Self {
            group,
            by,
            constraint: match by {
                ScaleBy::Axis(axis) => Some(Constraint::Axis(axis)),
                ScaleBy::Distance | ScaleBy::Doubling(_) => None,
            },
            right: right.as_dvec3(),
            up: up.as_dvec3(),
            start: None,
            factor: 1.0,
        };
        scale.start = scale.measured(ray);
        scale
    }

    /// The same scaling along some axes alone, or along all.
    pub fn along(&self, constraint: Option<Constraint>) -> Self {
        Self {
            constraint,
            ..self.clone()
        }
    }

    /// Edit that scales the shapes for the cursor on `ray`; with `snap` by factors in steps of 0.1.
    pub fn update(&mut self, ray: &Ray, snap: bool) -> Edit {
        if let Some(now) = self.measured(ray) {
            let start = *self.start.get_or_insert(now);
            let factor = match self.by {
                ScaleBy::Doubling(length) => ((now - start) / f64::from(length)).exp2(),
                ScaleBy::Axis(_) | ScaleBy::Distance => now / start,
            };
            self.factor = if snap {
                (factor / SNAP).round().max(1.0) * SNAP
            } else {
                factor.max(LEAST)
            };
        }
        self.edit()
    }

    /// Edit that scales the shapes by exactly this factor, wherever the cursor is; a scale stays
    /// away from 0 all the same.
    pub fn scaled_by(&mut self, factor: f64) -> Edit {
        self.factor = factor;
        self.edit()
    }

    /// Factor by which the shapes are scaled.
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// See [`ShapeGroup::stays_on_ground`].
    pub fn stays_on_ground(&self) -> bool {
        self.group.stays_on_ground()
    }

    /// The axes that alone are scaled; `None` for all.
    pub fn constraint(&self) -> Option<Constraint> {
        self.constraint
    }

    /// The shapes that are scaled.
    pub fn group(&self) -> &ShapeGroup {
        &self.group
    }

    fn edit(&self) -> Edit {
        let mut factors = DVec3::splat(self.factor);
        if let Some(constraint) = self.constraint {
            factors = DVec3::ONE;
            for axis in constraint.axes() {
                factors[axis] = self.factor;
            }
        }
        self.group.scaled(factors)
    }

    /// What the factor follows from, for the cursor on `ray`.
    fn measured(&self, ray: &Ray) -> Option<f64> {
        let ray = DRay::from(ray);
        let pivot = self.group.pivot().as_dvec3();
        let least = ON_THE_PIVOT * pivot.distance(ray.origin);
        let across = || {
            let met = ray.meet_plane(pivot, self.right.cross(self.up))?;
            Some(met - pivot)
        };
        match self.by {
            ScaleBy::Axis(axis) => {
                let line = self.group.axis(GizmoAxes::Local, axis).as_dvec3();
                let place = ray.nearest_on_line(pivot, line)?;
                (self.start.is_some() || place.abs() > least).then_some(place)
            }
            ScaleBy::Distance => {
                let distance = across()?.length();
                (self.start.is_some() || distance > least).then_some(distance)
            }
            ScaleBy::Doubling(_) => Some(across()?.dot(self.right + self.up)),
        }
    }
}
