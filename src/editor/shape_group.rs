use super::ground::ground_below;
use super::{Edit, GizmoAxes, Session};
use crate::math::{Euler, Transform};
use crate::scene::{EvaluatedShape, Placement, ShapeId};
use glam::{DMat3, DVec3, Vec3};

/// Least and greatest scale along an axis: a shape must neither vanish nor leave what can be drawn.
pub const SCALES: (f32, f32) = (0.001, 10_000.0);

/// The selected shapes as they were when a gesture began, to be turned or scaled together about the
/// middle of their pivots. Those that are hidden or locked stay as they are.
#[derive(Clone, Debug)]
pub struct ShapeGroup {
    active: ShapeId,
    pivot: Vec3,
    /// Height that stays when all are scaled: the pivot's, or that of the ground on which the active shape, a figure,
    /// stands.
    floor: f32,
    /// Own axes of the active shape.
    own: DMat3,
    shapes: Vec<(ShapeId, Placement)>,
}

impl ShapeGroup {
    /// The selected shapes; `None` if there is no active one, or it is hidden or locked.
    pub fn of_selected(session: &Session) -> Option<Self> {
        let active = session.scene().shape(session.selected()?)?;
        let is_free = |id| {
            let shape = session.evaluated().shape(id);
            shape.is_some_and(|shape| shape.pickable)
        };
        let rotation = active.placement.transform.rotation;
        let free = || session.selected_shapes().filter(|shape| is_free(shape.id));
        let shown = free().filter_map(|shape| session.evaluated().shape(shape.id));
        let pivots: Vec<Vec3> = shown
            .map(|shown| shown.world_from_model.transform_point3(pivot_of(shown)))
            .collect();
        // Exactly the pivot of one alone.
        let pivot = match pivots[..] {
            [] => return None,
            [one] => one,
            _ => pivots.iter().sum::<Vec3>() / pivots.len() as f32,
        };
        is_free(active.id).then(|| Self {
            active: active.id,
            pivot,
            floor: ground_below(session, active.id).unwrap_or(pivot.y),
            own: rotation.to_dmat3(),
            shapes: free().map(|shape| (shape.id, shape.placement)).collect(),
        })
    }

    /// The active shape.
    pub fn active(&self) -> ShapeId {
        self.active
    }

    /// Whether all that is scaled stays on the ground that the active shape stands on, so that its position changes.
    pub fn stays_on_ground(&self) -> bool {
        self.floor != self.pivot.y
    }

    /// Middle of the pivots of all, in the world: they turn and grow about it. Exactly the pivot of one alone.
    pub fn pivot(&self) -> Vec3 {
        self.pivot
    }

    /// Axis of the world, or of the active shape: 0 for x, 1 for y, 2 for z; of unit length, in the
    /// world.
    pub fn axis(&self, axes: GizmoAxes, axis: usize) -> Vec3 {
        match axes {
            GizmoAxes::World => Vec3::AXES[axis],
            GizmoAxes::Local => self.own.col(axis).as_vec3(),
        }
    }

    /// Whether the active shape's own axes, along which all are scaled, are not those of the world.
    pub fn is_turned(&self) -> bool {
        self.own != DMat3::IDENTITY
    }

    /// 1 if a turn about `axis`, in the world, makes the angle of the active shape larger that it
    /// changes most, or else -1.
    pub fn panel_sign(&self, axis: DVec3) -> f64 {
        let active = self.shapes.iter().find(|(id, _)| *id == self.active);
        let rotation = active.map_or(Euler::ZERO, |(_, start)| start.transform.rotation);
        f64::from(rotation.sign_of_turn(axis.as_vec3()))
    }

    /// Edit that turns all by `angle` radians about the line through the pivot along `axis`, a unit
    /// vector in the world. The angles are the nearest to those that the shapes have in `shown`, or
    /// else to those at the start.
    pub fn turned(&self, axis: DVec3, angle: f64, shown: Option<&Session>) -> Edit {
        let turn = DMat3::from_axis_angle(axis, angle);
        let turned = |&(id, start): &(ShapeId, Placement)| {
            let from = start.transform;
            let shape = shown.and_then(|session| session.scene().shape(id));
            let near = shape.map_or(from.rotation, |shape| shape.placement.transform.rotation);
            let rotation = match angle {
                0.0 => from.rotation,
                _ => Euler::nearest((turn * from.rotation.to_dmat3()).as_mat3(), near),
            };
            let transform = Transform {
                position: about(self.pivot, from.position, turn),
                rotation,
                ..from
            };
            Edit::SetTransform(id, transform)
        };
        Edit::Together(self.shapes.iter().map(turned).collect())
    }

    /// Edit that scales each by `factors` along its own axes, and its distance from the pivot along
    /// those of the active shape; figures stay on the ground. Scales stay away from 0. Uneven factors turn uniform
    /// scaling off.
    pub fn scaled(&self, factors: DVec3) -> Edit {
        let spread = self.own * DMat3::from_diagonal(factors) * self.own.transpose();
        let is_even = factors.x == factors.y && factors.y == factors.z;
        let pivot = self.pivot.with_y(self.floor);
        let mut edits = Vec::new();
        for &(id, start) in &self.shapes {
            let from = start.transform;
            let scales = [0, 1, 2].map(|axis| scaled(from.scale[axis], factors[axis]));
            let transform = Transform {
                position: about(pivot, from.position, spread),
                scale: Vec3::from(scales),
                ..from
            };
            // Also back on where the factors have become even again.
            if start.uniform_scaling {
                edits.push(Edit::SetUniformScaling(id, is_even));
            }
            edits.push(Edit::SetTransform(id, transform));
        }
        Edit::Together(edits)
    }
}

/// A point of the world after a linear map about `pivot`, which itself stays exactly.
fn about(pivot: Vec3, position: Vec3, map: DMat3) -> Vec3 {
    let arm = (position - pivot).as_dvec3();
    pivot + (map * arm).as_vec3()
}

/// Point of a shape, in its model space, about which it is turned and scaled, and where its handles
/// are: its origin, or the middle of its bounds if the origin is outside of them, as in files whose
/// figures stand side by side.
pub(super) fn pivot_of(shape: &EvaluatedShape) -> Vec3 {
    let bounds = shape.geometry.bounds();
    let margin = (bounds.max - bounds.min).max_element() * AROUND;
    let (least, greatest) = (bounds.min - margin, bounds.max + margin);
    let is_near = Vec3::ZERO.cmpge(least).all() && Vec3::ZERO.cmple(greatest).all();
    if is_near || !bounds.center().is_finite() {
        Vec3::ZERO
    } else {
        bounds.center()
    }
}

/// `transform` of a shape, moved so that its pivot is where it is now.
pub fn kept_at_pivot(session: &Session, id: ShapeId, transform: Transform) -> Transform {
    let Some(shape) = session.evaluated().shape(id) else {
        return transform;
    };
    let pivot = pivot_of(shape);
    if pivot == Vec3::ZERO {
        return transform;
    }
    kept_at(shape, pivot, transform)
}

/// `transform` of the shape `shown`, moved so that `point`, in its model space, is where it is now.
pub(super) fn kept_at(shown: &EvaluatedShape, point: Vec3, transform: Transform) -> Transform {
    let now = shown.world_from_model.transform_point3(point);
    let then = transform.world_from_model().transform_point3(point);
    // What rounding leaves of a shape that is back where it started is not to be seen in its numbers.
    let position = transform.position + now - then;
    let is_nothing = position
        .abs()
        .cmplt(Vec3::splat(1e-6 * now.abs().max_element().max(1.0)));
    Transform {
        position: Vec3::select(is_nothing, Vec3::ZERO, position),
        ..transform
    }
}

/// How far outside the bounds an origin may be, by their longest side.
const AROUND: f32 = 0.1;

/// A scale times a factor, with the sign of the product, within [`SCALES`]; a scale of 0 stays.
fn scaled(scale: f32, factor: f64) -> f32 {
    let product = (f64::from(scale) * factor) as f32;
    if scale == 0.0 || product.is_nan() || factor == 1.0 {
        return scale;
    }
    let (least, greatest) = SCALES;
    // A scale that was beyond the bounds before must not jump.
    let size = product
        .abs()
        .clamp(least.min(scale.abs()), greatest.max(scale.abs()));
    size.copysign(product)
}
