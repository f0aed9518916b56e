use super::Aabb;
use glam::{Mat4, Vec3};

/// A half-line. `direction` need not be of unit length; distances are in its multiples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes.
    pub direction: Vec3,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// In multiples of the ray's direction.
    pub distance: f32,
    /// Weight of the second and of the third corner; the first has the rest.
    pub barycentric: (f32, f32),
}

impl Ray {
    /// The point `distance` directions away from the origin.
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

    /// The nearest crossing of either side of a triangle, not behind the origin (Möller and
    /// Trumbore, "Fast, minimum storage ray/triangle intersection", 1997). `None` for a
    /// triangle without area.
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

    /// Where the half-line comes into the box, in multiples of its direction; 0 if it starts in
    /// it, `None` if it passes (slab method).
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

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

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
}
