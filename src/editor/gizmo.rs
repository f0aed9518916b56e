use super::rotate_tool::JointTurn;
use super::{MoveAlong, MoveTarget, Session};
use crate::math::Ray;
use crate::scene::{Camera, ShapeId};
use glam::{Mat3, Vec2, Vec3};

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
    /// Turns about the line of sight.
    FreeRing,
    /// Moves along an axis.
    Arrow(usize),
    /// Moves in the plane perpendicular to an axis.
    Plane(usize),
    /// Moves in the plane of the view.
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
    found: Option<(f32, GizmoHit)>,
}

impl Nearest {
    fn new(pixel: Vec2) -> Self {
        Self { pixel, found: None }
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
        let nearer = self.found.is_none_or(|(best, _)| distance < best);
        if distance <= REACH && nearer {
            self.found = Some((distance, hit));
        }
    }

    fn found(self) -> Option<GizmoHit> {
        self.found.map(|(_, hit)| hit)
    }
}

/// Number of segments of a ring, which is drawn and hit as a polygon.
const PIECES: usize = 64;
/// Cosine of the angle between a ring's axis and the line of sight above which the whole ring is in
/// front.
const FACING: f32 = 0.9;

/// Gizmo to rotate a joint: three rings about its axes, and one about the line of sight.
///
/// Rotations happen in the character's space, so if the shape is scaled non-uniformly, a ring is
/// the ellipse along which a point would really move.
#[derive(Clone, Debug)]
pub struct RotationGizmo {
    screen: Screen,
    center: Vec3,
    center_pixel: Vec2,
    rings: [Option<Ring>; 3],
}

#[derive(Clone, Debug)]
struct Ring {
    /// Axis in the character's space, of unit length.
    axis: Vec3,
    points: Vec<RingPoint>,
}

/// Point of a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RingPoint {
    /// Position in the world.
    pub world: Vec3,
    /// Position in the picture, in pixels from the top left.
    pub pixel: Vec2,
    /// Whether it is on the half that faces the eye: the other half cannot be grabbed.
    pub front: bool,
}

impl RotationGizmo {
    /// Radius of the rings, in pixels.
    pub const RADIUS: f32 = 72.0;
    /// Radius of the ring about the line of sight, in pixels.
    pub const FREE_RADIUS: f32 = 88.0;

    /// Gizmo of `joint`, in a picture of `size` pixels with the session's camera. `None` if there
    /// is no such joint, or it is not in front of the camera.
    pub fn new(
        session: &Session,
        shape: ShapeId,
        joint: usize,
        axes: GizmoAxes,
        size: Vec2,
    ) -> Option<Self> {
        let screen = Screen {
            camera: session.view().camera,
            size,
        };
        let turn = JointTurn::begin(session, shape, joint)?;
        let evaluated = session.evaluated().shape(shape)?;
        let figure = evaluated.geometry.figure.as_ref()?;
        let frame = Mat3::from_mat4(*figure.model_from_joint.get(joint)?);
        let stretch = Mat3::from_mat4(evaluated.world_from_model);
        let center = turn.world_center().as_vec3();
        let radius = Self::RADIUS * screen.world_per_pixel(center)?;
        let rings = [0, 1, 2].map(|axis| {
            let axis = match axes {
                GizmoAxes::Local => frame.col(axis),
                // Normal, in the character's space, of the plane perpendicular to an axis of the
                // world.
                GizmoAxes::World => stretch.transpose().col(axis),
            };
            ring(&screen, center, stretch, axis.try_normalize()?, radius)
        });
        Some(Self {
            screen,
            center,
            center_pixel: screen.pixel(center)?,
            rings,
        })
    }

    /// Position of the joint in the picture, in pixels.
    pub fn center_pixel(&self) -> Vec2 {
        self.center_pixel
    }

    /// Points of the ring about an axis, the last one equal to the first; empty if the shape is
    /// scaled to zero.
    pub fn ring(&self, axis: usize) -> &[RingPoint] {
        self.rings[axis].as_ref().map_or(&[], |ring| &ring.points)
    }

    /// Axis of a ring, a unit vector in the character's space.
    pub fn axis(&self, axis: usize) -> Option<Vec3> {
        self.rings[axis].as_ref().map(|ring| ring.axis)
    }

    /// Handle under `pixel`, with the point where it is grabbed.
    pub fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        let mut nearest = Nearest::new(pixel);
        for axis in 0..3 {
            for piece in self.ring(axis).windows(2) {
                let (a, b) = (piece[0], piece[1]);
                if a.front && b.front {
                    let handle = Handle::Ring(axis);
                    nearest.segment(handle, (a.pixel, b.pixel), (a.world, b.world));
                }
            }
        }
        let distance = pixel.distance(self.center_pixel);
        let ray = self.screen.ray(pixel);
        let hit = GizmoHit {
            handle: Handle::FreeRing,
            point: ray.at(self.center.distance(ray.origin)),
        };
        nearest.offer((distance - Self::FREE_RADIUS).abs(), hit);
        nearest.found()
    }
}

fn ring(screen: &Screen, center: Vec3, stretch: Mat3, axis: Vec3, radius: f32) -> Option<Ring> {
    let (u, v) = axis.any_orthonormal_pair();
    let (u, v) = (stretch * u, stretch * v);
    let widest = longest_axis(u, v);
    let share = radius / widest;
    if !share.is_finite() {
        return None;
    }
    let to_eye = (screen.camera.eye() - center).try_normalize()?;
    let facing = u.cross(v).normalize_or_zero().dot(to_eye).abs();
    // No part of a ring that faces the eye is behind the joint.
    let slack = if facing > FACING { -1.0 } else { -0.02 };
    let points = (0..=PIECES).map(|i| {
        let angle = i as f32 / PIECES as f32 * std::f32::consts::TAU;
        let (sin, cos) = angle.sin_cos();
        let arm = (u * cos + v * sin) * share;
        Some(RingPoint {
            world: center + arm,
            pixel: screen.pixel(center + arm)?,
            front: arm.dot(to_eye) >= slack * radius,
        })
    });
    Some(Ring {
        axis,
        points: points.collect::<Option<_>>()?,
    })
}

/// Semi-major axis of the ellipse `u cos + v sin`.
fn longest_axis(u: Vec3, v: Vec3) -> f32 {
    let (a, b) = (u.length_squared(), v.length_squared());
    let mean = (a + b) * 0.5;
    (mean + ((a - b) * 0.5).hypot(u.dot(v))).sqrt()
}

/// Start and end of an arrow, in pixels from the center.
const ARROW_START: f32 = 16.0;
const ARROW_END: f32 = 84.0;
/// Length in the picture, in pixels, below which an arrow that points at the eye cannot be grabbed.
const LEAST_ARROW: f32 = 14.0;
/// Range of the squares between two axes along each axis, in pixels from the center.
const SQUARE: (f32, f32) = (26.0, 44.0);
/// Sine of the angle of view below which a square cannot be grabbed.
const FLATTEST: f32 = 0.15;

/// Gizmo to move a shape or a root: three arrows, three squares between them, and a disc at the
/// center.
#[derive(Clone, Debug)]
pub struct MoveGizmo {
    screen: Screen,
    center: Vec3,
    center_pixel: Vec2,
    axes: [Vec3; 3],
    /// Length of a pixel at the center, in the world.
    per_pixel: f32,
}

impl MoveGizmo {
    /// Radius of the disc at the center, in pixels.
    pub const DISC: f32 = 9.0;

    /// Gizmo of `target`, in a picture of `size` pixels with the session's camera. `None` if it
    /// does not exist, or is not in front of the camera.
    pub fn new(session: &Session, target: MoveTarget, axes: GizmoAxes, size: Vec2) -> Option<Self> {
        let screen = Screen {
            camera: session.view().camera,
            size,
        };
        let center = target.place(session)?;
        let shape = session.scene().shape(target.shape())?;
        let turned = match axes {
            GizmoAxes::World => Mat3::IDENTITY,
            GizmoAxes::Local => shape.placement.transform.rotation.to_mat3(),
        };
        Some(Self {
            screen,
            center,
            center_pixel: screen.pixel(center)?,
            axes: [turned.x_axis, turned.y_axis, turned.z_axis],
            per_pixel: screen.world_per_pixel(center)?,
        })
    }

    /// Position of the center in the picture, in pixels.
    pub fn center_pixel(&self) -> Vec2 {
        self.center_pixel
    }

    /// Both ends of the arrow along an axis, in pixels; `None` if it points at the eye.
    pub fn arrow(&self, axis: usize) -> Option<(Vec2, Vec2)> {
        let (start, end) = self.arrow_in_world(axis);
        let (start, end) = (self.screen.pixel(start)?, self.screen.pixel(end)?);
        (start.distance(end) >= LEAST_ARROW).then_some((start, end))
    }

    /// Corners of the square perpendicular to an axis, in pixels; `None` if it is seen from the
    /// side.
    pub fn square(&self, axis: usize) -> Option<[Vec2; 4]> {
        let to_eye = (self.screen.camera.eye() - self.center).try_normalize()?;
        if to_eye.dot(self.axes[axis]).abs() < FLATTEST {
            return None;
        }
        let (a, b) = (self.axes[(axis + 1) % 3], self.axes[(axis + 2) % 3]);
        let (near, far) = SQUARE;
        let corners = [(near, near), (far, near), (far, far), (near, far)];
        let pixel = |(i, j): (f32, f32)| {
            self.screen
                .pixel(self.center + (a * i + b * j) * self.per_pixel)
        };
        let [p, q, r, s] = corners.map(pixel);
        Some([p?, q?, r?, s?])
    }

    /// Line or plane along which a handle moves the target.
    pub fn along(&self, handle: Handle) -> Option<MoveAlong> {
        match handle {
            Handle::Arrow(axis) => Some(MoveAlong::Line(self.axes[axis])),
            Handle::Plane(axis) => Some(MoveAlong::Plane(self.axes[axis])),
            Handle::Center => Some(MoveAlong::Plane(self.screen.camera.forward())),
            Handle::Ring(_) | Handle::FreeRing => None,
        }
    }

    /// Handle under `pixel`, with the point where it is grabbed.
    pub fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        let at = |handle| GizmoHit {
            handle,
            point: self.center,
        };
        if pixel.distance(self.center_pixel) <= Self::DISC {
            return Some(at(Handle::Center));
        }
        let mut nearest = Nearest::new(pixel);
        for axis in 0..3 {
            if let Some(pixels) = self.arrow(axis) {
                nearest.segment(Handle::Arrow(axis), pixels, self.arrow_in_world(axis));
            }
        }
        let squares = (0..3).filter(|&axis| self.square(axis).is_some_and(|s| holds(&s, pixel)));
        nearest
            .found()
            .or_else(|| squares.map(|axis| at(Handle::Plane(axis))).next())
    }

    fn arrow_in_world(&self, axis: usize) -> (Vec3, Vec3) {
        let point = |pixels: f32| self.center + self.axes[axis] * (pixels * self.per_pixel);
        (point(ARROW_START), point(ARROW_END))
    }
}

/// Whether a convex quadrilateral of either winding contains a point.
fn holds(corners: &[Vec2; 4], point: Vec2) -> bool {
    let sides = [0, 1, 2, 3].map(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        (b - a).perp_dot(point - a)
    });
    sides.iter().all(|&side| side >= 0.0) || sides.iter().all(|&side| side <= 0.0)
}
