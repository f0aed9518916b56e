use super::{Camera, EvaluatedShape};
use crate::math::{Aabb, Ray};
use glam::{Vec2, Vec3, Vec4};

/// Least distance between the eye and a target one unit away from the origin: nearer, `f32` could
/// hardly tell the two apart.
const LEAST_RADIUS: f32 = 1e-4;

/// Radius with which something without a size is seen.
const WITHOUT_SIZE: f32 = 0.5;

/// Room for what is fitted, over its size.
const MARGIN: f32 = 1.1;

/// Least share of the width or height of a picture that is left to what stays clear of a corner.
const LEAST_FREE: f32 = 0.4;

/// Rays in each direction of a picture by which it is told how much something that reaches behind the eye takes up.
const ACROSS: usize = 12;

/// Picture that something is fitted into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitArea {
    /// Width of the picture over its height.
    pub aspect: f32,
    /// Shares of its width and height, about its middle, that nothing else covers, …
    pub free: Vec2,
    /// … but for these shares, which something covers in the upper right corner.
    pub corner: Vec2,
}

impl FitArea {
    /// A picture of which nothing is covered.
    pub fn whole(aspect: f32) -> Self {
        Self {
            aspect,
            free: Vec2::ONE,
            corner: Vec2::ZERO,
        }
    }

    /// Parts of the free area of which nothing is covered: all that is below the corner, and all beside it.
    fn beside_corner(self) -> [Self; 2] {
        let Vec2 { x, y } = self.free;
        let beside = (1.0 - 2.0 * self.corner).max(Vec2::splat(LEAST_FREE));
        let with_free = |free| Self {
            free,
            corner: Vec2::ZERO,
            ..self
        };
        [
            with_free(Vec2::new(x, y.min(beside.y))),
            with_free(Vec2::new(x.min(beside.x), y)),
        ]
    }
}

impl Camera {
    /// The same camera turned to look at the side that faces `front`, in the world, from `phi`
    /// radians above; one that faces up or down is looked at from where it was.
    pub fn facing(self, front: Vec3, phi: f32) -> Self {
        let level = front.with_y(0.0);
        let theta = match level.length_squared() > 1e-6 * front.length_squared() {
            true => level.z.atan2(level.x),
            false => self.theta,
        };
        Self { theta, phi, ..self }
    }

    /// Fits all of `bounds`, in the world, into the free part of a picture: moves the camera, keeping
    /// the direction of view, and the near and far plane if necessary. An empty box changes nothing.
    pub fn fit(&mut self, bounds: &Aabb, area: FitArea) {
        if bounds.is_empty() {
            return;
        }
        let half_height = (self.fovy * 0.5).tan();
        let half_width = half_height * area.aspect * area.free.x;
        let half_height = half_height * area.free.y;
        let center = bounds.center();
        let mut radius = 0.0_f32;
        let mut half_depth = 0.0_f32;
        for corner in bounds.corners() {
            let offset = corner - center;
            let towards_eye = offset.dot(self.outward());
            let across = (offset.dot(self.right()).abs() / half_width)
                .max(offset.dot(self.up()).abs() / half_height);
            radius = radius.max(towards_eye + across * MARGIN);
            half_depth = half_depth.max(towards_eye.abs());
        }
        // What has no size can be seen from anywhere.
        if radius == 0.0 {
            radius = WITHOUT_SIZE;
        }
        radius = radius.max(center.abs().max_element() * LEAST_RADIUS);
        self.target = center;
        self.radius = radius;
        let course = Self::default();
        self.far = course.far.max((radius + half_depth) * 2.0);
        self.near = course
            .near
            .min((radius - half_depth).max(radius * 1e-3) * 0.5);
    }

    /// Fits shapes into the free part of a picture, as [`Camera::fit`] does, but by their vertices: as
    /// near as they let it, in the middle of the picture, and clear of its covered corner. No shapes change nothing.
    pub fn fit_shapes<'a>(
        &mut self,
        shapes: impl Iterator<Item = &'a EvaluatedShape> + Clone,
        area: FitArea,
    ) {
        let before = *self;
        self.fit_all_of(shapes.clone(), area);
        if !self.reach_into_corner(shapes.clone(), area) {
            return;
        }
        let [below, beside] = area.beside_corner().map(|area| {
            let mut camera = before;
            camera.fit_all_of(shapes.clone(), area);
            camera
        });
        *self = if below.radius <= beside.radius {
            below
        } else {
            beside
        };
    }

    /// Whether a vertex of the shapes is in the covered corner of a picture.
    fn reach_into_corner<'a>(
        &self,
        shapes: impl Iterator<Item = &'a EvaluatedShape>,
        area: FitArea,
    ) -> bool {
        if area.corner == Vec2::ZERO {
            return false;
        }
        let clip_from_world = self.clip_from_world(area.aspect);
        let from = 1.0 - 2.0 * area.corner;
        let mut is_in = false;
        for shape in shapes {
            for_each_point(shape, |point| {
                let clip = clip_from_world * point.extend(1.0);
                is_in |= clip.x > from.x * clip.w && clip.y > from.y * clip.w;
            });
        }
        is_in
    }

    /// Fits shapes into the free part of a picture, whether its corner is covered or not.
    fn fit_all_of<'a>(
        &mut self,
        shapes: impl Iterator<Item = &'a EvaluatedShape> + Clone,
        area: FitArea,
    ) {
        let bounds = shapes.clone().map(handled_bounds);
        let bounds = bounds.fold(Aabb::EMPTY, Aabb::union);
        self.fit(&bounds, area);
        if bounds.is_empty() {
            return;
        }
        let half_height = (self.fovy * 0.5).tan();
        let half = Vec2::new(half_height * area.aspect, half_height) * area.free / MARGIN;
        let (right, up, outward) = (self.right(), self.up(), self.outward());
        // A point with the coordinates `at` and `near` along these three is in the picture if
        // |at − middle| ≤ half · (radius − near): the planes farthest out on both sides.
        let (mut most, mut least) = (Vec2::NEG_INFINITY, Vec2::NEG_INFINITY);
        let mut nearest = f32::NEG_INFINITY;
        for shape in shapes {
            for_each_point(shape, |point| {
                let offset = point - self.target;
                let at = Vec2::new(offset.dot(right), offset.dot(up));
                let near = offset.dot(outward);
                most = most.max(at + half * near);
                least = least.max(half * near - at);
                nearest = nearest.max(near);
            });
        }
        let radius = ((most + least) / (2.0 * half)).max_element();
        // Rounding, and what has no size, leave it as it is.
        if radius.is_finite() && radius > nearest && radius < self.radius {
            let middle = (most - least) * 0.5;
            self.target += right * middle.x + up * middle.y;
            self.radius = radius.max(self.target.abs().max_element() * LEAST_RADIUS);
            self.near = self.near.min((radius - nearest).max(radius * 1e-3) * 0.5);
        }
    }

    /// Whether `bounds`, in the world, are seen well enough in a picture of `aspect` (width over height): three quarters
    /// of what they cover are in it, or what is takes up most of it. So is what reaches behind the eye, such as a room,
    /// where half of the rays into the picture meet it, which `meets` tells.
    pub fn sees(&self, bounds: &Aabb, aspect: f32, meets: impl Fn(&Ray) -> bool) -> bool {
        let corners = self.clip_corners(bounds, aspect);
        let beyond = |outside: fn(&Vec4) -> bool| corners.iter().all(outside);
        if corners.is_empty()
            || beyond(|c| c.x < -c.w)
            || beyond(|c| c.x > c.w)
            || beyond(|c| c.y < -c.w)
            || beyond(|c| c.y > c.w)
            || beyond(|c| c.z < -c.w)
            || beyond(|c| c.z > c.w)
        {
            return false;
        }
        if corners.iter().any(|c| c.z < -c.w) {
            let met = self.rays(aspect).filter(meets).count();
            return 2 * met >= ACROSS * ACROSS;
        }
        let [seen, covered] = areas(&corners);
        // The picture's sides are 2 long.
        const MOST: f32 = 0.6 * 2.0 * 2.0;
        seen >= 0.75 * covered || seen >= MOST
    }

    /// Rays from all over a picture of `aspect`, [`ACROSS`] in each direction.
    pub(super) fn rays(&self, aspect: f32) -> impl Iterator<Item = Ray> {
        let pixel = Vec2::new(aspect, 1.0);
        let all = 0..ACROSS * ACROSS;
        all.map(move |at| {
            let at = Vec2::new((at % ACROSS) as f32, (at / ACROSS) as f32);
            self.ray((at + 0.5) * pixel, pixel * ACROSS as f32)
        })
    }

    /// Part of what `bounds`, in the world, cover that is in a picture of `aspect` (width over height), 0 to 1; 0 if
    /// they reach behind the eye.
    pub fn seen_part(&self, bounds: &Aabb, aspect: f32) -> f32 {
        let corners = self.clip_corners(bounds, aspect);
        if corners.is_empty() || corners.iter().any(|c| c.z < -c.w) {
            return 0.0;
        }
        let [seen, covered] = areas(&corners);
        if covered > 0.0 { seen / covered } else { 1.0 }
    }

    /// Share of the height or width of a picture of `aspect` (width over height), whichever is more,
    /// that `bounds`, in the world, takes up; `None` unless all of it is in the picture.
    pub fn share(&self, bounds: &Aabb, aspect: f32) -> Option<f32> {
        let corners = self.clip_corners(bounds, aspect);
        let is_inside = |c: &Vec4| c.truncate().abs().max_element() <= c.w;
        if corners.is_empty() || !corners.iter().all(is_inside) {
            return None;
        }
        let on_picture = || corners.iter().map(|c| c.truncate().truncate() / c.w);
        let least = on_picture().fold(Vec2::INFINITY, Vec2::min);
        let most = on_picture().fold(Vec2::NEG_INFINITY, Vec2::max);
        Some(((most - least) * 0.5).max_element())
    }

    /// Corners of `bounds` in clip space; none of an empty box.
    fn clip_corners(&self, bounds: &Aabb, aspect: f32) -> Vec<Vec4> {
        if bounds.is_empty() {
            return Vec::new();
        }
        let clip_from_world = self.clip_from_world(aspect);
        let corners = bounds.corners().into_iter();
        corners
            .map(|corner| clip_from_world * corner.extend(1.0))
            .collect()
    }
}

/// Area of what corners in clip space, before the eye, cover of the picture, and of all that they cover.
fn areas(corners: &[Vec4]) -> [f32; 2] {
    let on_picture = || corners.iter().map(|c| c.truncate().truncate() / c.w);
    let least = on_picture().fold(Vec2::INFINITY, Vec2::min);
    let most = on_picture().fold(Vec2::NEG_INFINITY, Vec2::max);
    let seen = (most.min(Vec2::ONE) - least.max(Vec2::NEG_ONE)).max(Vec2::ZERO);
    [seen, most - least].map(Vec2::element_product)
}

/// Bounds of a shape, in the world, with its control points, which are there to be dragged.
fn handled_bounds(shape: &EvaluatedShape) -> Aabb {
    let curves = shape.geometry.curves.iter().flat_map(|all| &all.curves);
    let points = curves.flat_map(|curve| &curve.control_points);
    let in_world = |&point| shape.world_from_model.transform_point3(point);
    shape
        .world_bounds()
        .union(Aabb::from_points(points.map(in_world)))
}

/// Calls `take` with the vertices of a shape, in the world; with the corners of its box if it shows
/// curves, which lie between few points.
fn for_each_point(shape: &EvaluatedShape, mut take: impl FnMut(Vec3)) {
    let positions = shape.geometry.positions();
    if shape.geometry.curves.is_some() || positions.is_empty() {
        handled_bounds(shape).corners().into_iter().for_each(take);
    } else {
        let in_world = |&point| shape.world_from_model.transform_point3(point);
        positions.iter().for_each(|point| take(in_world(point)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ViewDirection;

    #[test]
    fn what_is_small_is_fitted_with_a_near_plane_half_way_to_it() {
        let bounds = Aabb::from_points([Vec3::splat(-0.01), Vec3::splat(0.01)]);
        let mut camera = Camera::preset(ViewDirection::PlusZ);
        camera.fit(&bounds, FitArea::whole(1.0));
        let nearest = camera.eye().z - 0.01;
        assert!((camera.near - 0.5 * nearest).abs() < 1e-6, "{camera:?}");
    }

    #[test]
    fn fitting_brings_every_corner_into_the_picture() {
        let size = Vec2::new(800.0, 600.0);
        let bounds = Aabb {
            min: Vec3::new(-30.0, 0.0, -2.0),
            max: Vec3::new(10.0, 5.0, 400.0),
        };
        for direction in ViewDirection::ALL {
            let mut camera = Camera::preset(direction);
            camera.fit(&bounds, FitArea::whole(size.x / size.y));
            for corner in bounds.corners() {
                let clip = camera.clip_from_world(size.x / size.y) * corner.extend(1.0);
                let ndc = clip.truncate() / clip.w;
                assert!(
                    clip.w > 0.0 && ndc.abs().max_element() <= 1.0,
                    "{direction:?} {ndc}"
                );
            }
        }
    }

    #[test]
    fn fitting_fills_the_picture_with_things_of_every_size() {
        let aspect = 1.0;
        for (size, place) in [(1e-4, 0.0), (0.02, 3.0), (1.0, -7.0), (3e4, 0.0)] {
            let half = Vec3::splat(size / 2.0);
            let at = Vec3::splat(place);
            let bounds = Aabb {
                min: at - half,
                max: at + half,
            };
            let mut camera = Camera::default();
            camera.fit(&bounds, FitArea::whole(aspect));
            let clip_from_world = camera.clip_from_world(aspect);
            let reach = bounds.corners().into_iter().map(|corner| {
                let clip = clip_from_world * corner.extend(1.0);
                assert!(clip.z.abs() < clip.w, "{size}: {clip}");
                (clip.truncate() / clip.w).truncate().abs().max_element()
            });
            let most = reach.fold(0.0, f32::max);
            assert!((0.8..=1.0).contains(&most), "{size}: {most}");
        }
    }

    #[test]
    fn what_has_no_size_is_looked_at_from_nearby() {
        let mut camera = Camera::default();
        camera.fit(&Aabb::from_points([Vec3::ONE]), FitArea::whole(1.0));
        assert_eq!((camera.target, camera.radius), (Vec3::ONE, 0.5));
    }

    #[test]
    fn what_is_fitted_stays_clear_of_the_covered_edges() {
        let bounds = Aabb::from_points([Vec3::new(-1.0, 0.0, -0.5), Vec3::new(1.0, 3.0, 0.5)]);
        for free in [Vec2::new(1.0, 0.8), Vec2::new(0.3, 1.0)] {
            let mut camera = Camera::default();
            let area = FitArea {
                free,
                ..FitArea::whole(1.5)
            };
            camera.fit(&bounds, area);
            for corner in camera.clip_corners(&bounds, 1.5) {
                let ndc = corner.truncate().truncate() / corner.w;
                assert!(ndc.abs().cmple(free).all(), "{free}: {ndc}");
            }
        }
    }

    #[test]
    fn a_front_is_looked_at_from_before_it() {
        for front in [Vec3::Z, Vec3::NEG_X, Vec3::new(1.0, 5.0, -1.0)] {
            let camera = Camera::default().facing(front, 0.2);
            let level = camera.outward().with_y(0.0);
            let angle = level.angle_between(front.with_y(0.0));
            assert!(angle < 1e-3 && camera.phi == 0.2, "{front}: {angle}");
        }
        let up = Camera::preset(ViewDirection::MinusX).facing(Vec3::Y, 0.1);
        assert_eq!(up.theta, Camera::preset(ViewDirection::MinusX).theta);
    }

    #[test]
    fn what_is_beside_behind_or_beyond_the_picture_is_not_seen() {
        let camera = Camera::default();
        let sees = |bounds: &Aabb| camera.sees(bounds, 1.0, |ray| ray.entry(bounds).is_some());
        let cube_at = |at: Vec3| Aabb::from_points([at - Vec3::splat(0.5), at + Vec3::splat(0.5)]);
        for (at, is_seen, is_whole) in [
            (Vec3::ZERO, true, true),
            (Vec3::X * 1.5, true, false),
            (Vec3::X * 1.8, false, false),
            (Vec3::X * 2.2, false, false),
            (Vec3::X * 9.0, false, false),
            (Vec3::Y * -9.0, false, false),
            (Vec3::Z * 9.0, false, false),
            (Vec3::Z * -200.0, false, false),
        ] {
            let bounds = cube_at(at);
            assert_eq!(sees(&bounds), is_seen, "{at}");
            assert_eq!(camera.share(&bounds, 1.0).is_some(), is_whole, "{at}");
        }
        assert!(!sees(&Aabb::EMPTY));
        let [room, wall] = [Vec3::splat(20.0), Vec3::new(20.0, 1.0, 3.0)];
        for size in [room, wall] {
            let around = Aabb::from_points([-size, size]);
            assert!(sees(&around), "{size}");
        }
        // Of what passes the eye on the right a little is seen.
        let beside = Aabb::from_points([Vec3::new(1.7, -1.0, -1.0), Vec3::new(9.0, 1.0, 9.0)]);
        assert!(!sees(&beside));
        // Its face, at a distance of 4.5, is one high where the picture is 3.7 high.
        let share = camera.share(&cube_at(Vec3::ZERO), 1.0).unwrap();
        assert!((share - 1.0 / 3.73).abs() < 0.01, "{share}");
    }
}
