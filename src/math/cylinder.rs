use super::Ray;
use glam::{DVec3, Vec3};

/// A solid cylinder with flat ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Middle of one end.
    pub start: Vec3,
    /// Middle of the other end.
    pub end: Vec3,
    /// Of its round side.
    pub radius: f32,
}

impl Cylinder {
    /// Where `ray` enters, in multiples of its direction. `None` if it misses, if it starts
    /// inside, and for a cylinder without length or radius.
    pub fn entry(&self, ray: &Ray) -> Option<f32> {
        let (start, end) = (self.start.as_dvec3(), self.end.as_dvec3());
        let length = start.distance(end);
        let along = (end - start).try_normalize()?;
        let radius = f64::from(self.radius);
        if radius.is_nan() || radius <= 0.0 {
            return None;
        }
        let origin = ray.origin.as_dvec3() - start;
        let direction = ray.direction.as_dvec3();
        let (near, far) = within_side(along, radius, origin, direction)?;
        let (enter, leave) = within_ends(along, length, origin, direction)?;
        let (near, far) = (near.max(enter), far.min(leave));
        (near <= far && near >= 0.0 && near.is_finite()).then_some(near as f32)
    }
}

/// Where a line is within the round side of an endless cylinder about `along` through the origin.
fn within_side(along: DVec3, radius: f64, origin: DVec3, direction: DVec3) -> Option<(f64, f64)> {
    let across = direction.reject_from_normalized(along);
    let beside = origin.reject_from_normalized(along);
    let a = across.length_squared();
    // Along the axis, but for rounding.
    if a <= 1e-24 * direction.length_squared() {
        let inside = beside.length() <= radius;
        return inside.then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let middle = -beside.dot(across) / a;
    let nearest = beside + across * middle;
    let half = (radius * radius - nearest.length_squared()) / a;
    (half >= 0.0).then(|| (middle - half.sqrt(), middle + half.sqrt()))
}

/// Where a line is between the planes of the two ends.
fn within_ends(along: DVec3, length: f64, origin: DVec3, direction: DVec3) -> Option<(f64, f64)> {
    let (height, speed) = (origin.dot(along), direction.dot(along));
    if speed == 0.0 {
        let between = (0.0..=length).contains(&height);
        return between.then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let (a, b) = (-height / speed, (length - height) / speed);
    Some((a.min(b), a.max(b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const UPRIGHT: Cylinder = Cylinder {
        start: Vec3::ZERO,
        end: Vec3::new(0.0, 2.0, 0.0),
        radius: 0.5,
    };

    fn entry(origin: [f32; 3], direction: [f32; 3]) -> Option<f32> {
        UPRIGHT.entry(&Ray {
            origin: origin.into(),
            direction: direction.into(),
        })
    }

    #[test]
    fn a_ray_enters_through_the_side_or_through_an_end() {
        assert_eq!(entry([-3.0, 1.0, 0.0], [1.0, 0.0, 0.0]), Some(2.5));
        assert_eq!(entry([0.2, 5.0, 0.1], [0.0, -1.0, 0.0]), Some(3.0));
        assert_eq!(entry([0.2, -4.0, 0.1], [0.0, 2.0, 0.0]), Some(2.0));
    }

    #[test]
    fn a_ray_beside_past_the_ends_behind_or_inside_does_not() {
        assert_eq!(entry([-3.0, 1.0, 0.51], [1.0, 0.0, 0.0]), None);
        assert_eq!(entry([-3.0, 2.01, 0.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(entry([-3.0, 1.0, 0.0], [-1.0, 0.0, 0.0]), None);
        assert_eq!(entry([0.1, 1.0, 0.0], [1.0, 0.0, 0.0]), None);
    }

    #[test]
    fn a_cylinder_without_length_or_radius_is_never_entered() {
        let ray = Ray {
            origin: Vec3::new(-3.0, 0.0, 0.0),
            direction: Vec3::X,
        };
        for (end, radius) in [(Vec3::ZERO, 0.5), (Vec3::Y, 0.0), (Vec3::Y, f32::NAN)] {
            let flat = Cylinder {
                end,
                radius,
                ..UPRIGHT
            };
            assert_eq!(flat.entry(&ray), None);
        }
    }
}
