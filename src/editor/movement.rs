use crate::math::{DRay, Ray};
use glam::{DVec3, Vec3};

/// Step of a movement that snaps, in the world.
const SNAP: f64 = 0.1;

/// Cosine of the angle to a plane's normal from which on an axis counts as being that normal.
const ACROSS: f32 = 0.99;

/// Constraint of a movement. Directions are in the world, of any length but zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoveAlong {
    /// Along a line in this direction.
    Line(Vec3),
    /// In a plane with this normal.
    Plane(Vec3),
    /// In the plane of two axes that are perpendicular to each other.
    Axes(Vec3, Vec3),
}

/// Movement of a point by the cursor, along a line or in a plane through where it was.
#[derive(Clone, Debug)]
pub(super) struct Movement {
    /// Point of the line or plane, in the world.
    anchor: DVec3,
    along: MoveAlong,
    /// The cursor at the start.
    grabbed_by: Ray,
    /// Point that was grabbed, in the world.
    from: DVec3,
    moved: DVec3,
}

impl Movement {
    /// Movement from `anchor`, in the world, with the cursor on `ray`; `None` if that is parallel to the line or plane.
    pub fn begin(anchor: DVec3, along: MoveAlong, ray: &Ray) -> Option<Self> {
        Some(Self {
            anchor,
            along,
            grabbed_by: *ray,
            from: meeting(ray, anchor, along)?,
            moved: DVec3::ZERO,
        })
    }

    /// The same movement from its start, along another line or plane.
    pub fn constrained(&self, along: MoveAlong) -> Self {
        Self {
            along,
            // A cursor that is parallel to it has grabbed the point itself.
            from: meeting(&self.grabbed_by, self.anchor, along).unwrap_or(self.anchor),
            moved: DVec3::ZERO,
            ..self.clone()
        }
    }

    /// Follows the cursor on `ray`; with `snap` in steps of 0.1 along the line or the two axes, or else along the world's
    /// axes.
    pub fn follow(&mut self, ray: &Ray, snap: bool) {
        let Some(to) = meeting(ray, self.anchor, self.along) else {
            return;
        };
        self.moved = to - self.from;
        let step = |length: f64| match snap {
            true => (length / SNAP).round() * SNAP,
            false => length,
        };
        self.moved = match self.along {
            MoveAlong::Line(_) => {
                let length = self.moved.length();
                self.moved.normalize_or_zero() * step(length)
            }
            MoveAlong::Plane(_) => self.moved.map(step),
            // Also without steps, so that what is perpendicular to both stays exactly.
            MoveAlong::Axes(first, second) => {
                let axes = [first, second].map(|axis| axis.as_dvec3().normalize_or_zero());
                axes.map(|axis| axis * step(self.moved.dot(axis)))
                    .iter()
                    .sum()
            }
        };
    }

    /// Moves by exactly this length along the line or the first of the two axes; in a plane, along the first axis of the
    /// world that is not its normal.
    pub fn move_by(&mut self, length: f64) {
        let direction = match self.along {
            MoveAlong::Line(line) => line,
            MoveAlong::Axes(first, _) => first,
            MoveAlong::Plane(normal) => {
                let is_across = |axis: &Vec3| axis.dot(normal.normalize_or_zero()).abs() < ACROSS;
                Vec3::AXES.into_iter().find(is_across).unwrap_or(Vec3::X)
            }
        };
        self.moved = direction.as_dvec3().normalize_or_zero() * length;
    }

    /// Line or plane that it goes along.
    pub fn along(&self) -> MoveAlong {
        self.along
    }

    /// By how much the point has moved, in the world.
    pub fn moved(&self) -> DVec3 {
        self.moved
    }

    /// Where the point is now, in the world.
    pub fn place(&self) -> DVec3 {
        self.anchor + self.moved
    }
}

/// Sine of the angle at which a plane of two axes is seen, below which it is seen from its edge: the cursor's rays meet it
/// far away, behind the eye or not at all.
const FROM_ITS_EDGE: f64 = 0.15;

/// Point where the ray meets the plane, or comes nearest to the line, through `anchor`. In a plane that is seen from its
/// edge, the point below or above the one across the view.
fn meeting(ray: &Ray, anchor: DVec3, along: MoveAlong) -> Option<DVec3> {
    let ray = DRay::from(ray);
    match along {
        MoveAlong::Line(line) => {
            let line = line.as_dvec3().try_normalize()?;
            Some(anchor + line * ray.nearest_on_line(anchor, line)?)
        }
        MoveAlong::Plane(normal) => ray.meet_plane(anchor, normal.as_dvec3()),
        MoveAlong::Axes(first, second) => {
            let normal = first.as_dvec3().cross(second.as_dvec3()).try_normalize()?;
            let sight = (anchor - ray.origin).try_normalize()?;
            if sight.dot(normal).abs() >= FROM_ITS_EDGE {
                return ray.meet_plane(anchor, normal);
            }
            let across = ray.meet_plane(anchor, sight)?;
            Some(across - normal * (across - anchor).dot(normal))
        }
    }
}
