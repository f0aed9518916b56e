use super::{GizmoAxes, GizmoHit, Handle, Nearest, Screen};
use crate::editor::rotate_tool::{JointTurn, Together};
use crate::editor::{Session, ShapeGroup};
use crate::scene::ShapeId;
use glam::{Mat3, Vec2, Vec3};

/// Number of segments of a ring, which is drawn and hit as a polygon.
const PIECES: usize = 64;
/// Cosine of the angle between a ring's axis and the line of sight above which the whole ring is in
/// front.
const FACING: f32 = 0.9;
/// Cosine of the angle between the normal of a ring's plane and the line of sight below which it looks like a line.
const EDGE_ON: f32 = 0.3;
/// Share of the radius from which on a ring that looks like a line is at its end.
const END: f32 = 0.85;
/// Pixels by which a ring that is seen edge-on counts as farther from the pointer than one that faces the eye: where two
/// cross, the latter is the one along which the pointer can go.
const EDGE_ON_HANDICAP: f32 = 6.0;

/// Gizmo to rotate a joint or shapes: three rings about axes, and one about the direction of view.
///
/// Rotations of a joint happen in the character's space, so if the shape is scaled non-uniformly,
/// a ring is the ellipse along which a point would really move. Shapes turn in the world.
#[derive(Clone, Debug)]
pub struct RotationGizmo {
    screen: Screen,
    center: Vec3,
    center_pixel: Vec2,
    /// Radius of the rings, in pixels.
    radius: f32,
    rings: [Option<Ring>; 3],
}

#[derive(Clone, Debug)]
struct Ring {
    /// Axis in the character's space, or for shapes in the world, of unit length.
    axis: Vec3,
    /// Cosine of the angle between the normal of its plane in the world and the line of sight: 0 for a ring that is seen
    /// edge-on.
    facing: f32,
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
    /// Largest radius of the rings, in pixels.
    pub const RADIUS: f32 = 72.0;
    /// Largest radius of the ring about the direction of view, in pixels.
    pub const FREE_RADIUS: f32 = 88.0;
    /// Radius of the rings at a joint of a small figure, as a share of the figure's diagonal: larger ones lie over other
    /// limbs and are grabbed in place of these.
    const OF_FIGURE: f32 = 0.2;
    /// Smallest radius of the rings, in pixels.
    const SMALLEST: f32 = 36.0;

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
        let turn = JointTurn::begin(session, shape, joint, Together::Every)?;
        let evaluated = session.evaluated().shape(shape)?;
        let figure = evaluated.geometry.figure.as_ref()?;
        let frame = Mat3::from_mat4(*figure.model_from_joint.get(joint)?);
        let stretch = Mat3::from_mat4(evaluated.world_from_model);
        let center = turn.world_center().as_vec3();
        let per_pixel = screen.world_per_pixel(center)?;
        let diagonal = evaluated.world_bounds().size().length() / per_pixel;
        let pixels = (Self::OF_FIGURE * diagonal).clamp(Self::SMALLEST, Self::RADIUS);
        let radius = pixels * per_pixel;
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
            radius: pixels,
            rings,
        })
    }

    /// Gizmo of the selected shapes, about their pivot (see [`ShapeGroup`]), like
    /// [`RotationGizmo::new`].
    pub fn of_shapes(session: &Session, axes: GizmoAxes, size: Vec2) -> Option<Self> {
        let screen = Screen {
            camera: session.view().camera,
            size,
        };
        let group = ShapeGroup::of_selected(session)?;
        let center = group.pivot();
        let radius = Self::RADIUS * screen.world_per_pixel(center)?;
        let rings = [0, 1, 2].map(|axis| {
            let axis = group.axis(axes, axis);
            ring(&screen, center, Mat3::IDENTITY, axis, radius)
        });
        Some(Self {
            screen,
            center,
            center_pixel: screen.pixel(center)?,
            radius: Self::RADIUS,
            rings,
        })
    }

    /// Position of what turns in the picture, in pixels: of the joint, or of the shapes' pivot.
    pub fn center_pixel(&self) -> Vec2 {
        self.center_pixel
    }

    /// Radius of the ring about the direction of view, in pixels.
    pub fn free_radius(&self) -> f32 {
        self.radius * (Self::FREE_RADIUS / Self::RADIUS)
    }

    /// Points of the ring about an axis, the last one equal to the first; empty if the shape is
    /// scaled to zero.
    pub fn ring(&self, axis: usize) -> &[RingPoint] {
        self.rings[axis].as_ref().map_or(&[], |ring| &ring.points)
    }

    /// Axis of a ring, a unit vector in the character's space, or for shapes in the world.
    pub fn axis(&self, axis: usize) -> Option<Vec3> {
        self.rings[axis].as_ref().map(|ring| ring.axis)
    }

    /// Whether a handle looks like a line through the middle at `pixel`, as a bone does: a ring that is seen edge-on, but
    /// for its ends.
    pub fn looks_like_bone(&self, handle: Handle, pixel: Vec2) -> bool {
        let Handle::Ring(axis) = handle else {
            return false;
        };
        let is_edge_on = |ring: &Ring| ring.facing < EDGE_ON;
        let is_end = pixel.distance(self.center_pixel) > END * self.radius;
        self.rings[axis].as_ref().is_some_and(is_edge_on) && !is_end
    }

    /// Handle under `pixel`, with the point where it is grabbed.
    pub fn hit(&self, pixel: Vec2) -> Option<GizmoHit> {
        let mut nearest = Nearest::new(pixel);
        for axis in 0..3 {
            let facing = self.rings[axis].as_ref().map_or(0.0, |ring| ring.facing);
            nearest.handicap = EDGE_ON_HANDICAP * (1.0 - facing);
            for piece in self.ring(axis).windows(2) {
                let (a, b) = (piece[0], piece[1]);
                if a.front && b.front {
                    let handle = Handle::Ring(axis);
                    nearest.segment(handle, (a.pixel, b.pixel), (a.world, b.world));
                }
            }
        }
        nearest.handicap = 0.0;
        let distance = pixel.distance(self.center_pixel);
        let ray = self.screen.ray(pixel);
        let hit = GizmoHit {
            handle: Handle::FreeRing,
            point: ray.at(self.center.distance(ray.origin)),
        };
        nearest.offer((distance - self.free_radius()).abs(), hit);
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
        facing,
        points: points.collect::<Option<_>>()?,
    })
}

/// Semi-major axis of the ellipse `u cos + v sin`.
fn longest_axis(u: Vec3, v: Vec3) -> f32 {
    let (a, b) = (u.length_squared(), v.length_squared());
    let mean = (a + b) * 0.5;
    (mean + ((a - b) * 0.5).hypot(u.dot(v))).sqrt()
}
