use super::Aabb;
use glam::{DMat4, DVec3, Mat4, Vec3};

/// Half-line. `direction` need not be of unit length; distances are multiples of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Starting point.
    pub origin: Vec3,
    /// Direction.
    pub direction: Vec3,
}

/// Intersection of a ray with a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// Distance from the ray's origin, in multiples of its direction.
    pub distance: f32,
    /// Weights of the second and of the third corner; the first has the rest.
    pub barycentric: (f32, f32),
}

impl Ray {
    /// Point at `distance`, in multiples of the direction.
    pub fn at(&self, distance: f32) -> Vec3 {
        self.origin + self.direction * distance
    }

    /// The same half-line in another space. Distances along it stay the same numbers.
    pub fn transformed(&self, to_from_own: Mat4) -> Self {
        Self {
            origin: to_from_own.transform_point3(self.origin),
            direction: to_from_own.transform_vector3(self.direction),
        }
    }

    /// Intersection with either side of a triangle, not behind the origin (Möller and Trumbore,
    /// "Fast, minimum storage ray/triangle intersection", 1997). `None` for a triangle without
    /// area.
    pub fn triangle(&self, [a, b, c]: [Vec3; 3]) -> Option<TriangleHit> {
        let (ab, ac) = (b - a, c - a);
        let p = self.direction.cross(ac);
        let determinant = ab.dot(p);
        if determinant == 0.0 || !determinant.is_finite() {
            return None;
        }
        let to_origin = self.origin - a;
        let u = to_origin.dot(p) / determinant;
        let q = to_origin.cross(ab);
        let v = self.direction.dot(q) / determinant;
        let distance = ac.dot(q) / determinant;
        let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance >= 0.0;
        inside.then_some(TriangleHit {
            distance,
            barycentric: (u, v),
        })
    }

    /// Point of the segment from `a` to `b` that is nearest to the line of the ray; `a` if they are
    /// parallel.
    pub fn nearest_on_segment(&self, a: Vec3, b: Vec3) -> Vec3 {
        let (along, to_start) = (b - a, a - self.origin);
        // Components perpendicular to the ray.
        let across = |v: Vec3| {
            v - self.direction * (v.dot(self.direction) / self.direction.length_squared())
        };
        let (along_across, start_across) = (across(along), across(to_start));
        let t = -start_across.dot(along_across) / along_across.length_squared();
        // A segment along the ray, or without length, divides by zero.
        if t.is_finite() {
            a + along * t.clamp(0.0, 1.0)
        } else {
            a
        }
    }

    /// Distance at which the ray enters a box, in multiples of its direction; 0 if it starts
    /// inside, `None` if it misses (slab method).
    pub fn entry(&self, aabb: &Aabb) -> Option<f32> {
        if aabb.is_empty() {
            return None;
        }
        let (mut near, mut far) = (0.0_f32, f32::INFINITY);
        for axis in 0..3 {
            let (origin, direction) = (self.origin[axis], self.direction[axis]);
            if direction == 0.0 {
                if origin < aabb.min[axis] || origin > aabb.max[axis] {
                    return None;
                }
                continue;
            }
            let a = (aabb.min[axis] - origin) / direction;
            let b = (aabb.max[axis] - origin) / direction;
            near = near.max(a.min(b));
            far = far.min(a.max(b));
        }
        (near <= far).then_some(near)
    }
}

/// [`Ray`] in double precision, for gestures: what follows from a cursor shall not jitter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DRay {
    /// Starting point.
    pub origin: DVec3,
    /// Direction, of any length but zero.
    pub direction: DVec3,
}

impl From<&Ray> for DRay {
    fn from(ray: &Ray) -> Self {
        Self {
            origin: ray.origin.as_dvec3(),
            direction: ray.direction.as_dvec3(),
        }
    }
}

impl DRay {
    /// The same half-line in another space.
    pub fn transformed(&self, to_from_own: DMat4) -> Self {
        Self {
            origin: to_from_own.transform_point3(self.origin),
            direction: to_from_own.transform_vector3(self.direction),
        }
    }

    /// Intersection with the plane through `point` across `normal`, which has any length but zero.
    /// `None` where the plane is parallel or behind the origin.
    pub fn meet_plane(&self, point: DVec3, normal: DVec3) -> Option<DVec3> {
        let distance = (point - self.origin).dot(normal) / self.direction.dot(normal);
        let in_front = distance > 0.0 && distance.is_finite();
        in_front.then(|| self.origin + self.direction * distance)
    }

    /// Position, as a distance from `point` in the unit direction `along`, at which that line comes
    /// nearest to this one. `None` if they are parallel.
    pub fn nearest_on_line(&self, point: DVec3, along: DVec3) -> Option<f64> {
        let direction = self.direction.try_normalize()?;
        let between = direction.dot(along);
        let across = 1.0 - between * between;
        let offset = self.origin - point;
        let at = (offset.dot(along) - offset.dot(direction) * between) / across;
        (across > 1e-9 && at.is_finite()).then_some(at)
    }
}

/// Solid cylinder with flat ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Center of one end.
    pub start: Vec3,
    /// Center of the other end.
    pub end: Vec3,
    /// Radius of the round side.
    pub radius: f32,
}

impl Cylinder {
    /// Distance at which `ray` enters, in multiples of its direction. `None` if it misses, if it
    /// starts inside, and for a cylinder without length or radius.
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

/// Interval in which a line is inside an infinite cylinder about the unit vector `along` through
/// the origin.
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

/// Interval in which a line is between the planes of the two ends.
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

    const TRIANGLE: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

    #[test]
    fn a_plane_behind_the_eye_is_not_met() {
        let ray = DRay {
            origin: DVec3::new(0.0, 1.0, 5.0),
            direction: DVec3::new(0.0, 0.5, -1.0),
        };
        let wall = ray.meet_plane(DVec3::ZERO, DVec3::Z * -3.0);
        assert_eq!(wall, Some(DVec3::new(0.0, 3.5, 0.0)));
        // The ground is below, and the ray goes up.
        assert_eq!(ray.meet_plane(DVec3::ZERO, DVec3::Y), None);
        let along = DVec3::new(0.0, 1.0, 0.5);
        assert_eq!(ray.meet_plane(DVec3::ZERO, along), None, "it is parallel");
    }

    #[test]
    fn a_ray_meets_a_triangle_from_either_side_but_not_behind_itself() {
        let at = Vec3::new(0.25, 0.5, 0.0);
        for z in [2.0, -2.0] {
            let ray = Ray {
                origin: at + Vec3::Z * z,
                direction: Vec3::Z * -z,
            };
            let hit = ray.triangle(TRIANGLE).unwrap();
            assert!((hit.distance - 1.0).abs() < 1e-6);
            assert!((hit.barycentric.0 - 0.25).abs() < 1e-6);
            let away = Ray {
                direction: -ray.direction,
                ..ray
            };
            assert!(away.triangle(TRIANGLE).is_none());
        }
    }

    #[test]
    fn a_ray_beside_a_triangle_or_along_its_plane_misses() {
        let beside = Ray {
            origin: Vec3::new(0.6, 0.6, 1.0),
            direction: -Vec3::Z,
        };
        let along = Ray {
            origin: Vec3::new(-1.0, 0.2, 0.0),
            direction: Vec3::X,
        };
        assert!(beside.triangle(TRIANGLE).is_none());
        assert!(along.triangle(TRIANGLE).is_none());
    }

    #[test]
    fn a_ray_comes_into_a_box_it_starts_in_or_points_at() {
        let aabb = Aabb {
            min: -Vec3::ONE,
            max: Vec3::ONE,
        };
        let entry = |origin: Vec3| {
            let direction = Vec3::X;
            Ray { origin, direction }.entry(&aabb)
        };
        assert_eq!(entry(Vec3::ZERO), Some(0.0));
        assert_eq!(entry(Vec3::X * -3.0), Some(2.0));
        assert_eq!(entry(Vec3::X * 3.0), None);
        assert_eq!(entry(Vec3::Y * 1.5), None);
    }

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
