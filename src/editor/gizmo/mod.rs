//! Gizmos: handles of the selection in the view, of a size in pixels.

mod movement;
mod rotation;
mod scale;

pub use movement::MoveGizmo;
pub use rotation::{RingPoint, RotationGizmo};
pub use scale::ScaleGizmo;

use crate::math::Ray;
use crate::scene::Camera;
use glam::{Vec2, Vec3};

/// Distance, in pixels, from which a handle can be grabbed.
const REACH: f32 = 7.0;

/// Axes of a gizmo.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GizmoAxes {
    /// Axes of the world.
    #[default]
    World,
    /// Current axes of the joint or the shape.
    Local,
}

impl GizmoAxes {
    /// The other kind of axes.
    pub fn other(self) -> Self {
        match self {
            Self::World => Self::Local,
            Self::Local => Self::World,
        }
    }
}

/// Part of a gizmo that can be grabbed. Numbers are axes: 0 for x, 1 for y, 2 for z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// Turns about an axis.
    Ring(usize),
    /// Turns about the direction of view, or scales all axes alike.
    FreeRing,
    /// Moves or scales along an axis.
    Arrow(usize),
    /// Moves in the plane perpendicular to an axis.
    Plane(usize),
    /// Moves in the plane of the view, or scales all axes alike.
    Center,
}

/// Part of a gizmo under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GizmoHit {
    /// Handle.
    pub handle: Handle,
    /// Point on the handle, in the world.
    pub point: Vec3,
}

/// Picture in which a gizmo is seen: the size of a gizmo is in pixels, at any distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// Camera of the picture.
    pub camera: Camera,
    /// Width and height in pixels.
    pub size: Vec2,
}

impl Screen {
    /// Position of a point of the world in the picture, in pixels from the top left; `None` behind
    /// the eye.
    pub fn pixel(&self, world: Vec3) -> Option<Vec2> {
        self.camera.pixel(world, self.size)
    }

    /// Length of a pixel at a point of the world, see [`Camera::world_per_pixel`].
    pub fn world_per_pixel(&self, world: Vec3) -> Option<f32> {
        self.camera.world_per_pixel(world, self.size.y)
    }

    /// Ray in the world through a point of the picture.
    pub fn ray(&self, pixel: Vec2) -> Ray {
        self.camera.ray(pixel, self.size)
    }
}

/// Search for the handle that is nearest to a pixel.
struct Nearest {
    pixel: Vec2,
    /// Pixels that what is considered counts as farther away.
    handicap: f32,
    found: Option<(f32, GizmoHit)>,
}

impl Nearest {
    fn new(pixel: Vec2) -> Self {
        Self {
            pixel,
            handicap: 0.0,
            found: None,
        }
    }

    /// Considers a segment of a handle, given by its ends in the picture and in the world.
    fn segment(&mut self, handle: Handle, pixels: (Vec2, Vec2), points: (Vec3, Vec3)) {
        let along = pixels.1 - pixels.0;
        let squared = along.length_squared();
        let share = if squared > 0.0 {
            ((self.pixel - pixels.0).dot(along) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let distance = self.pixel.distance(pixels.0 + along * share);
        let point = points.0.lerp(points.1, share);
        self.offer(distance, GizmoHit { handle, point });
    }

    /// Considers a handle at a distance in pixels.
    fn offer(&mut self, distance: f32, hit: GizmoHit) {
        let counted = distance + self.handicap;
        let nearer = self.found.is_none_or(|(best, _)| counted < best);
        if distance <= REACH && nearer {
            self.found = Some((counted, hit));
        }
    }

    fn found(self) -> Option<GizmoHit> {
        self.found.map(|(_, hit)| hit)
    }
}
