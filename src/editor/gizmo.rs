use crate::math::Ray;
use crate::scene::Camera;
use glam::{Vec2, Vec3};

/// A handle can be taken from this many pixels away.
const REACH: f32 = 7.0;

/// Whose axes a gizmo shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GizmoAxes {
    /// The world's.
    #[default]
    World,
    /// The joint's or the shape's own, as it stands.
    Local,
}

impl GizmoAxes {
    /// The other choice.
    pub fn other(self) -> Self {
        match self {
            Self::World => Self::Local,
            Self::Local => Self::World,
        }
    }
}

/// A part of a gizmo that can be taken. Numbers are axes: 0 for x, 1 for y, 2 for z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// Turns about an axis.
    Ring(usize),
    /// Turns about the line of sight.
    FreeRing,
    /// Moves along an axis.
    Arrow(usize),
    /// Moves across an axis.
    Plane(usize),
    /// Moves in the plane of the view.
    Center,
}

/// The part of a gizmo under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GizmoHit {
    /// Which part.
    pub handle: Handle,
    /// Where on it, in the world.
    pub point: Vec3,
}

/// The picture that a gizmo is seen in: a gizmo's size is in its pixels, however far it is away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// Where from.
    pub camera: Camera,
    /// Width and height in pixels.
    pub size: Vec2,
}

impl Screen {
    /// Where a point of the world is in the picture, from the top left; `None` behind the eye.
    pub fn pixel(&self, world: Vec3) -> Option<Vec2> {
        self.camera.pixel(world, self.size)
    }

    /// How long something of this length of the world is in the picture where it is seen from its
    /// side, at a point of the world; `None` behind the eye.
    pub fn length(&self, world: Vec3, length: f32) -> Option<f32> {
        let beside = world + self.camera.right() * length;
        Some(self.pixel(world)?.distance(self.pixel(beside)?))
    }

    /// The ray under a point of the picture.
    pub fn ray(&self, pixel: Vec2) -> Ray {
        self.camera.ray(pixel, self.size)
    }
}

/// Keeps the nearest of several handles within reach of a pixel.
pub(super) struct Nearest {
    pixel: Vec2,
    found: Option<(f32, GizmoHit)>,
}

impl Nearest {
    pub fn new(pixel: Vec2) -> Self {
        Self { pixel, found: None }
    }

    /// A handle of which a part lies between two pixels, which are those of two points.
    pub fn segment(&mut self, handle: Handle, pixels: (Vec2, Vec2), points: (Vec3, Vec3)) {
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

    /// A handle that is so many pixels away.
    pub fn offer(&mut self, distance: f32, hit: GizmoHit) {
        let nearer = self.found.is_none_or(|(best, _)| distance < best);
        if distance <= REACH && nearer {
            self.found = Some((distance, hit));
        }
    }

    pub fn found(self) -> Option<GizmoHit> {
        self.found.map(|(_, hit)| hit)
    }
}
