use glam::{Mat4, Vec3};

/// Axis-aligned bounding box. The empty box holds no point and has `min > max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Smallest coordinates.
    pub min: Vec3,
    /// Largest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// The empty box.
    pub const EMPTY: Self = Self {
        min: Vec3::INFINITY,
        max: Vec3::NEG_INFINITY,
    };

    /// Whether a point lies in it, or on a side.
    pub fn contains(&self, point: Vec3) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max).all()
    }

    /// The smallest box around `points`, all in one space.
    pub fn from_points(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |aabb, point| Self {
            min: aabb.min.min(point),
            max: aabb.max.max(point),
        })
    }

    /// Whether the box holds no point.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// The smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Center; the origin for an empty box.
    pub fn center(&self) -> Vec3 {
        if self.is_empty() {
            Vec3::ZERO
        } else {
            (self.min + self.max) * 0.5
        }
    }

    /// Edge lengths; zero for an empty box.
    pub fn size(&self) -> Vec3 {
        if self.is_empty() {
            Vec3::ZERO
        } else {
            self.max - self.min
        }
    }

    /// The eight corners, in the box's own space; none for an empty box.
    pub fn corners(&self) -> Vec<Vec3> {
        if self.is_empty() {
            return Vec::new();
        }
        let ends = [self.min, self.max];
        (0..8)
            .map(|i| Vec3::new(ends[i & 1].x, ends[(i >> 1) & 1].y, ends[(i >> 2) & 1].z))
            .collect()
    }

    /// The box around this one after `to_from_own`; larger than the tightest one if it turns.
    pub fn transformed(&self, to_from_own: Mat4) -> Self {
        Self::from_points(
            self.corners()
                .into_iter()
                .map(|p| to_from_own.transform_point3(p)),
        )
    }
}
