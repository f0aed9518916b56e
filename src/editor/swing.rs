use crate::math::DRay;
use glam::DVec3;

/// `angle` in radians, rounded to whole steps of 15° if `snap`.
pub(super) fn snapped(angle: f64, snap: bool) -> f64 {
    let step = 15.0_f64.to_radians();
    if snap {
        (angle / step).round() * step
    } else {
        angle
    }
}

/// Angle about the unit vector `axis`, in radians from -π to π, by which `from` turns to `to`; both
/// are of unit length and across the axis.
pub(super) fn angle_about(axis: DVec3, from: DVec3, to: DVec3) -> f64 {
    axis.dot(from.cross(to)).atan2(from.dot(to))
}

/// `angle` in radians, moved by whole turns as near to `to` as possible, so that a gesture can go
/// around more than once.
pub(super) fn unwound(angle: f64, to: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle + ((to - angle) / turn).round() * turn
}

/// Sine of the angle of view below which a ring is pulled along the line that it looks like, since the intersection
/// of its plane with the cursor's ray is badly conditioned.
const EDGE_ON: f64 = 0.2;

/// Cosine of the angle to the line of sight from which on a point of a ring is on its far side, not at its end.
const BEHIND: f64 = 0.1;

/// Radius of a ring that is not shown, relative to the distance of the eye: about that of the gizmo's.
const FRONT: f64 = 0.1;

/// Turn about an axis by the cursor, which has grabbed a ring around it. The angle follows from the
/// start and the cursor alone, up to whole turns. Rays and points are in the space of the axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Swing {
    center: DVec3,
    /// Of unit length.
    axis: DVec3,
    how: How,
}

/// Way to find an angle from the cursor.
#[derive(Clone, Copy, Debug)]
enum How {
    /// By the direction from the center to the point of the ring's plane under the cursor.
    Plane {
        /// That direction at the start, of unit length.
        from: DVec3,
    },
    /// By the distance along the ring's tangent where it is nearest to the eye, or farthest from it: that at the grabbed
    /// point may run along the line of sight.
    Tangent {
        grabbed: DVec3,
        tangent: DVec3,
        radius: f64,
        start: f64,
    },
}

impl Swing {
    /// Begins at the point `grabbed` with the cursor on `ray`. `None` if no angle follows from the
    /// cursor.
    pub fn begin(center: DVec3, axis: DVec3, grabbed: DVec3, ray: &DRay) -> Option<Self> {
        let axis = axis.try_normalize()?;
        let flat = ray.direction.try_normalize()?.dot(axis).abs();
        let on_plane = in_plane(center, axis, ray);
        let how = match on_plane.filter(|_| flat > EDGE_ON) {
            Some(from) => How::Plane { from },
            None => {
                let arm = (grabbed - center).reject_from_normalized(axis);
                let towards = (ray.origin - center).reject_from_normalized(axis);
                let towards = towards.try_normalize()?;
                let is_behind = arm.dot(towards) < -BEHIND * arm.length();
                let tangent = axis.cross(if is_behind { -towards } else { towards });
                How::Tangent {
                    grabbed,
                    tangent,
                    radius: arm.length(),
                    start: ray.nearest_on_line(grabbed, tangent)?,
                }
            }
        };
        Some(Self { center, axis, how })
    }

    /// Begins where a ring around the axis is nearest to the eye, from which `ray` comes, for a cursor
    /// that has grabbed nothing of it, wherever it is. `None` if no angle follows from the cursor.
    pub fn begin_in_front(center: DVec3, axis: DVec3, ray: &DRay) -> Option<Self> {
        let towards = (ray.origin - center).reject_from(axis);
        Self::begin(center, axis, center + towards * FRONT, ray)
    }

    /// Axis, of unit length.
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Angle for the cursor on `ray` in radians, of those that mean the same the nearest to `near`.
    pub fn angle(&self, ray: &DRay, near: f64) -> Option<f64> {
        match self.how {
            How::Plane { from } => {
                let to = in_plane(self.center, self.axis, ray)?;
                Some(unwound(angle_about(self.axis, from, to), near))
            }
            How::Tangent {
                grabbed,
                tangent,
                radius,
                start,
            } => Some((ray.nearest_on_line(grabbed, tangent)? - start) / radius),
        }
    }
}

/// Direction, of unit length, from the center to the point where the ray meets the plane
/// perpendicular to `axis`; `None` if it does not, or meets the center itself.
fn in_plane(center: DVec3, axis: DVec3, ray: &DRay) -> Option<DVec3> {
    let arm = ray.meet_plane(center, axis)? - center;
    arm.reject_from_normalized(axis).try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_about_an_axis_across_the_view_is_as_large_wherever_the_cursor_is() {
        let eye = DVec3::Z * 5.0;
        let ray = |x: f64, y: f64| DRay {
            origin: eye,
            direction: DVec3::new(x, y, 0.0) - eye,
        };
        for (x, y) in [(0.0, 0.0), (0.0, 0.1), (0.5, 0.0), (1.0, 0.5)] {
            let swing = Swing::begin_in_front(DVec3::ZERO, DVec3::X, &ray(x, y)).unwrap();
            assert_eq!(swing.angle(&ray(x, y), 0.0), Some(0.0));
            // 0.05 upwards at the center are 0.045 at the front of a ring of radius 0.5.
            let turned = swing.angle(&ray(x, y + 0.05), 0.0).unwrap();
            assert!((turned + 0.09).abs() < 0.005, "{x} {y}: {turned}");
        }
    }

    #[test]
    fn a_ring_that_is_seen_edge_on_turns_as_much_wherever_along_its_line_it_is_grabbed() {
        let eye = DVec3::Z * 5.0;
        let ray = |y: f64| DRay {
            origin: eye,
            direction: DVec3::new(0.0, y, 0.0) - eye,
        };
        for degrees in [0.0_f64, 45.0, 80.0, 89.0, 90.0, 91.0] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let grabbed = DVec3::new(0.0, sin, cos) * 0.3;
            // Where its point is seen in the plane through the center.
            let seen = grabbed.y * 5.0 / (5.0 - grabbed.z);
            let swing = Swing::begin(DVec3::ZERO, DVec3::X, grabbed, &ray(seen)).unwrap();
            let turned = swing.angle(&ray(seen + 0.03), 0.0).unwrap();
            assert!((turned + 0.1).abs() < 0.01, "{degrees}: {turned}");
        }
    }

    #[test]
    fn an_angle_snaps_to_the_nearest_fifteen_degrees_on_either_side() {
        for (degrees, expected) in [(7.0, 0.0), (8.0, 15.0), (-8.0, -15.0), (52.0, 45.0)] {
            let found = snapped(f64::to_radians(degrees), true).to_degrees();
            assert!((found - expected).abs() < 1e-9, "{degrees}: {found}");
            assert_eq!(snapped(degrees, false), degrees);
        }
    }

    #[test]
    fn an_angle_that_goes_round_more_than_once_does_not_jump_back() {
        let near = |degrees: f64, to: f64| unwound(degrees.to_radians(), to.to_radians());
        for (degrees, to, expected) in [
            (-170.0, 175.0, 190.0),
            (10.0, 355.0, 370.0),
            (170.0, -175.0, -190.0),
            (0.0, 719.0, 720.0),
        ] {
            let found = near(degrees, to).to_degrees();
            assert!(
                (found - expected).abs() < 1e-9,
                "{degrees} near {to}: {found}"
            );
        }
    }
}
