use super::ViewDirection;
use crate::math::Ray;
use glam::camera::rh::{proj::opengl, view};
use glam::{Mat4, Vec2, Vec3, Vec4};
use std::f32::consts::FRAC_PI_2;

/// Least angle, in radians, between the direction of view and ±Y when the camera is turned by hand.
const POLE_MARGIN: f32 = 0.1;
const PAN_PER_PIXEL: f32 = 0.01;
/// Radius from which on the scene moves as fast as in the course's editor.
const NEAR_FOR_COURSE: f32 = 4.0;
const TURN_PER_PIXEL: f32 = 0.005;
const ZOOM_PER_NOTCH: f32 = 0.5;
/// Least distance between eye and target to which the wheel zooms.
pub(super) const NEAREST: f32 = 0.5;

/// Camera that looks at a target from a distance: `eye = target + r (cosφ cosθ, sinφ, cosφ sinθ)`,
/// +Y up. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Camera {
    /// Point that it looks at, in the world.
    pub target: Vec3,
    /// Distance of the eye from the target.
    pub radius: f32,
    /// Angle about +Y, from +X towards +Z, radians.
    pub theta: f32,
    /// Angle above the horizontal plane, radians.
    pub phi: f32,
    /// Vertical field of view, radians.
    pub fovy: f32,
    /// Distance of the near plane.
    pub near: f32,
    /// Distance of the far plane.
    pub far: f32,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            target: Vec3::ZERO,
            radius: 5.0,
            theta: FRAC_PI_2,
            phi: 0.0,
            fovy: 45.0_f32.to_radians(),
            near: 0.1,
            far: 100.0,
        }
    }
}

impl Camera {
    /// One of the six views of the View menu: target at the origin, distance 5.
    pub fn preset(direction: ViewDirection) -> Self {
        let (theta, phi) = direction.angles();
        Self {
            theta,
            phi,
            ..Self::default()
        }
    }

    /// The camera that options and files describe by three numbers, THETA, PHI and RADIUS, or by six
    /// with the target TX, TY, TZ; angles in degrees.
    ///
    /// # Errors
    /// If there are more or fewer numbers, one is not finite, or the radius is not above 0.
    pub fn from_numbers(numbers: &[f32]) -> Result<Self, String> {
        let (theta, phi, radius, target) = match *numbers {
            [theta, phi, radius] => (theta, phi, radius, Vec3::ZERO),
            [theta, phi, radius, x, y, z] => (theta, phi, radius, Vec3::new(x, y, z)),
            _ => {
                let found = numbers.len();
                return Err(format!(
                    "expected three numbers THETA, PHI, RADIUS or six with TX, TY, TZ, found {found}"
                ));
            }
        };
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            return Err(format!("expected finite numbers, found {number}"));
        }
        if radius <= 0.0 {
            return Err(format!("expected a distance above 0, found {radius}"));
        }
        Ok(Self {
            target,
            radius,
            theta: theta.to_radians(),
            phi: phi.to_radians(),
            ..Self::default()
        })
    }

    /// The same camera turned to look from `direction`, with target and distance kept.
    pub fn looking_from(self, direction: ViewDirection) -> Self {
        let (theta, phi) = direction.angles();
        Self { theta, phi, ..self }
    }

    /// Unit vector from the target to the eye.
    pub(super) fn outward(&self) -> Vec3 {
        let (sin_theta, cos_theta) = self.theta.sin_cos();
        let (sin_phi, cos_phi) = self.phi.sin_cos();
        Vec3::new(cos_phi * cos_theta, sin_phi, cos_phi * sin_theta)
    }

    /// Unit vector to the right of the picture. It follows from θ alone and so is defined at the
    /// poles too.
    pub fn right(&self) -> Vec3 {
        Vec3::new(self.theta.sin(), 0.0, -self.theta.cos())
    }

    /// Unit vector to the top of the picture, in the world.
    pub fn up(&self) -> Vec3 {
        self.outward().cross(self.right())
    }

    /// Position of the eye, in the world.
    pub fn eye(&self) -> Vec3 {
        self.target + self.outward() * self.radius
    }

    /// Matrix from the world to the eye's space (x right, y up, looking along −z).
    pub fn view_from_world(&self) -> Mat4 {
        view::look_at_mat4(self.eye(), self.target, self.up())
    }

    /// Matrix from the eye's space to clip space; `aspect` is width over height of the picture.
    pub fn clip_from_view(&self, aspect: f32) -> Mat4 {
        opengl::perspective(self.fovy, aspect, self.near, self.far)
    }

    /// Matrix from the world to clip space; `aspect` is width over height of the picture.
    pub fn clip_from_world(&self, aspect: f32) -> Mat4 {
        self.clip_from_view(aspect) * self.view_from_world()
    }

    /// Ray, in the world, through a point of the picture: `pixel` from the top left, in a picture
    /// of `size` pixels. Starts at the eye; its direction has unit length.
    pub fn ray(&self, pixel: Vec2, size: Vec2) -> Ray {
        let half_height = (self.fovy * 0.5).tan();
        let x = (2.0 * pixel.x / size.x - 1.0) * half_height * size.x / size.y;
        let y = (1.0 - 2.0 * pixel.y / size.y) * half_height;
        let direction = self.right() * x + self.up() * y - self.outward();
        Ray {
            origin: self.eye(),
            direction: direction.normalize_or(-self.outward()),
        }
    }

    /// Position of a point of the world in a picture of `size` pixels, from the top left; `None`
    /// behind the eye.
    pub fn pixel(&self, world: Vec3, size: Vec2) -> Option<Vec2> {
        let clip: Vec4 = self.clip_from_world(size.x / size.y) * world.extend(1.0);
        (clip.w > 0.0).then(|| {
            let ndc = clip.truncate() / clip.w;
            Vec2::new((ndc.x + 1.0) * 0.5 * size.x, (1.0 - ndc.y) * 0.5 * size.y)
        })
    }

    /// Distance of a point of the world from the eye along the direction of view; negative behind
    /// the eye.
    pub fn depth(&self, world: Vec3) -> f32 {
        (self.eye() - world).dot(self.outward())
    }

    /// Whether a point of the world lies between the near and the far plane.
    pub fn is_in_depth(&self, world: Vec3) -> bool {
        (self.near..=self.far).contains(&self.depth(world))
    }

    /// Unit vector from the eye into the picture.
    pub fn forward(&self) -> Vec3 {
        -self.outward()
    }

    /// Length of a pixel, in the world, at the depth of `world`, in a picture `height` pixels high;
    /// `None` for a point nearer than the near plane.
    pub fn world_per_pixel(&self, world: Vec3, height: f32) -> Option<f32> {
        let depth = self.depth(world);
        (depth > self.near).then(|| self.pixel_at_depth(depth, height))
    }

    /// Length of a pixel, in the world, at a distance from the eye along the direction of view, in
    /// a picture `height` pixels high.
    pub(super) fn pixel_at_depth(&self, depth: f32, height: f32) -> f32 {
        2.0 * (self.fovy * 0.5).tan() * depth / height
    }

    /// Pans by a drag of `delta` pixels (y down): the scene moves with the pointer. The vertical
    /// part runs along the world's +Y, as in the course's editor. Its speed is the same there however near the scene is,
    /// which soon throws that out of the picture; nearer than at a radius of 4 it is slower here.
    pub fn pan(&mut self, delta: Vec2) {
        let per_pixel = PAN_PER_PIXEL * (self.radius / NEAR_FOR_COURSE).min(1.0);
        self.target -= self.right() * (delta.x * per_pixel);
        self.target += Vec3::Y * (delta.y * per_pixel);
    }

    /// Turns about the target by a drag of `delta` pixels (y down).
    pub fn turn(&mut self, delta: Vec2) {
        let limit = FRAC_PI_2 - POLE_MARGIN;
        self.theta -= TURN_PER_PIXEL * delta.x;
        self.phi = (self.phi - TURN_PER_PIXEL * delta.y).clamp(-limit, limit);
    }

    /// Pans by a drag of `delta` pixels (y down) in a picture `height` pixels high, so that the point
    /// `held`, in the world, stays under the pointer.
    pub fn pan_with_pointer(&mut self, delta: Vec2, height: f32, held: Vec3) {
        let depth = self.depth(held);
        let depth = if depth > self.near {
            depth
        } else {
            self.radius
        };
        let world_per_pixel = self.pixel_at_depth(depth, height);
        self.target += (self.up() * delta.y - self.right() * delta.x) * world_per_pixel;
    }

    /// Orbits about the target: turns the scene by `angles` in radians to the right and down, up to
    /// straight above and below.
    pub fn orbit(&mut self, angles: Vec2) {
        self.theta += angles.x;
        self.phi = (self.phi + angles.y).clamp(-FRAC_PI_2, FRAC_PI_2);
    }

    /// The point of the world under a pixel that is as far away as the target, along the direction of view.
    pub fn point_at_target(&self, pixel: Vec2, size: Vec2) -> Vec3 {
        let ray = self.ray(pixel, size);
        ray.at(self.radius / self.depth(ray.at(1.0)))
    }

    /// Multiplies the distance of the eye from the target by `exp(away)`, within limits.
    pub fn dolly(&mut self, away: f32) {
        self.radius = (self.radius * away.exp()).clamp(2.0 * self.near, self.far * 10.0);
    }

    /// As [`Camera::dolly`], with the scene growing or shrinking about `held`, a point in the world, which stays where
    /// it is in the picture.
    pub fn dolly_about(&mut self, away: f32, held: Vec3) {
        let before = self.radius;
        self.dolly(away);
        self.target = held + (self.target - held) * (self.radius / before);
    }

    /// Moves eye and target by `by`, in the world: along the picture's right, the world's up, and
    /// forward.
    pub fn walk(&mut self, by: Vec3) {
        self.target += self.right() * by.x + Vec3::Y * by.y - self.outward() * by.z;
    }

    /// Moves the eye towards the target by `notches` of the wheel. Its steps are all alike in the course's editor, as here
    /// from a radius of 4 on; nearer, where they would soon be too large, they are parts of the radius.
    pub fn zoom(&mut self, notches: f32) {
        // Of a notch nearer, as a part of the radius in logarithms.
        let nearer = (1.0 - ZOOM_PER_NOTCH / NEAR_FOR_COURSE).ln();
        if notches > 0.0 {
            let far = (self.radius - NEAR_FOR_COURSE) / ZOOM_PER_NOTCH;
            let far = far.clamp(0.0, notches);
            self.radius -= ZOOM_PER_NOTCH * far;
            let before = self.radius;
            self.dolly(nearer * (notches - far));
            // As after a fit of something small, where it is nearer already than it may come.
            self.radius = self.radius.min(before);
        } else {
            let near = (self.radius / NEAR_FOR_COURSE).ln() / nearer;
            let near = near.clamp(0.0, -notches);
            self.dolly(-nearer * near);
            self.radius += ZOOM_PER_NOTCH * (-notches - near);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_through_a_pixel_comes_back_to_that_pixel() {
        let size = Vec2::new(800.0, 600.0);
        for direction in ViewDirection::ALL {
            let camera = Camera {
                target: Vec3::new(0.3, -0.2, 0.7),
                ..Camera::preset(direction)
            };
            for pixel in [Vec2::ZERO, Vec2::new(13.0, 577.0), size * 0.5] {
                let ray = camera.ray(pixel, size);
                let back = camera.pixel(ray.at(3.7), size).unwrap();
                assert!(
                    back.abs_diff_eq(pixel, 1e-2),
                    "{direction:?} {pixel} {back}"
                );
            }
        }
    }

    #[test]
    fn seen_from_above_and_below_plus_x_is_to_the_right() {
        for direction in [
            ViewDirection::PlusY,
            ViewDirection::MinusY,
            ViewDirection::PlusZ,
        ] {
            let camera = Camera::preset(direction);
            let pixel = camera.pixel(Vec3::X, Vec2::new(800.0, 600.0)).unwrap();
            assert!(pixel.x > 450.0, "{direction:?} {pixel}");
        }
    }

    #[test]
    fn a_pan_moves_the_scene_with_the_pointer() {
        let size = Vec2::new(800.0, 600.0);
        let mut camera = Camera::default();
        let before = camera.pixel(Vec3::ZERO, size).unwrap();
        camera.pan(Vec2::new(50.0, 40.0));
        let after = camera.pixel(Vec3::ZERO, size).unwrap();
        assert!(after.x > before.x && after.y > before.y);
    }

    #[test]
    fn what_is_dragged_stays_under_the_pointer_however_near_it_is() {
        let size = Vec2::new(800.0, 600.0);
        let start = Camera {
            phi: 0.7,
            theta: -2.0,
            target: Vec3::new(1.0, 2.0, 3.0),
            ..Camera::default()
        };
        let pointer = Vec2::new(650.0, 120.0);
        for distance in [0.3, 2.0, 5.0, 60.0] {
            let held = start.ray(pointer, size).at(distance);
            let mut camera = start;
            // A drag of many small movements.
            for _ in 0..100 {
                camera.pan_with_pointer(Vec2::new(-5.0, 3.0), size.y, held);
            }
            let now = camera.pixel(held, size).unwrap();
            let apart = now.distance(Vec2::new(150.0, 420.0));
            assert!(apart < 0.1, "{distance}: {now}");
        }
    }

    #[test]
    fn orbiting_turns_the_near_side_with_the_pointer() {
        let size = Vec2::new(800.0, 600.0);
        let mut camera = Camera::default();
        camera.orbit(Vec2::new(0.2, 0.1));
        // A point before the target, as seen at first, went to the right and down.
        let near = camera.pixel(Vec3::Z, size).unwrap();
        assert!(near.x > 410.0 && near.y > 310.0, "{near}");
        camera.orbit(Vec2::new(0.0, 100.0));
        assert_eq!(camera.phi, FRAC_PI_2);
    }

    #[test]
    fn a_dolly_goes_there_and_back_and_never_through_the_target() {
        let mut camera = Camera::default();
        camera.dolly(0.7);
        camera.dolly(-0.7);
        assert!((camera.radius - 5.0).abs() < 1e-5);
        camera.dolly(-1000.0);
        assert_eq!(camera.radius, 0.2);
    }

    #[test]
    fn a_dolly_about_a_point_keeps_it_where_it_is_in_the_picture() {
        let size = Vec2::new(800.0, 600.0);
        let mut camera = Camera {
            theta: 0.4,
            ..Camera::default()
        };
        let held = camera.ray(Vec2::new(650.0, 120.0), size).at(3.0);
        let before = camera.pixel(held, size).unwrap();
        for away in [0.3, -0.9] {
            camera.dolly_about(away, held);
            let now = camera.pixel(held, size).unwrap();
            assert!(now.abs_diff_eq(before, 1e-2), "{away}: {now}");
        }
        assert!((camera.radius - 5.0 * (-0.6_f32).exp()).abs() < 1e-5);
        assert!(camera.target.distance(held) > 0.1);
        let nearest = camera.target;
        camera.dolly(-1000.0);
        let there = camera;
        camera.dolly_about(-1.0, held);
        assert_eq!(camera, there, "as near as it may be");
        assert_eq!(camera.target, nearest);
    }

    #[test]
    fn walking_takes_the_target_along() {
        let mut camera = Camera::default();
        camera.walk(Vec3::new(1.0, 2.0, 3.0));
        assert!(camera.target.distance(Vec3::new(1.0, 2.0, -3.0)) < 1e-6);
        assert_eq!(camera.radius, 5.0);
    }

    #[test]
    fn turning_stops_short_of_the_poles_and_zooming_before_the_target() {
        let mut camera = Camera::default();
        camera.turn(Vec2::new(0.0, -10_000.0));
        assert!((camera.phi - (FRAC_PI_2 - 0.1)).abs() < 1e-6);
        camera.zoom(1000.0);
        assert_eq!(camera.radius, 2.0 * camera.near);
    }

    #[test]
    fn the_wheel_goes_in_steps_of_a_half_far_away_and_of_an_eighth_nearer_and_back() {
        let mut camera = Camera::default();
        let mut radii = vec![camera.radius];
        for _ in 0..6 {
            camera.zoom(1.0);
            radii.push(camera.radius);
        }
        assert_eq!(radii[..3], [5.0, 4.5, 4.0]);
        let are_even = radii[2..]
            .windows(2)
            .all(|pair| (pair[1] / pair[0] - 0.875).abs() < 1e-5);
        assert!(are_even, "{radii:?}");
        camera.zoom(-6.0);
        assert!((camera.radius - 5.0).abs() < 1e-5, "{}", camera.radius);
    }

    #[test]
    fn the_wheel_never_moves_the_eye_away_when_it_should_come_nearer() {
        let mut camera = Camera {
            radius: 0.05,
            ..Camera::default()
        };
        camera.zoom(1.0);
        assert_eq!(camera.radius, 0.05);
        camera.zoom(-1.0);
        assert!(camera.radius > 0.05);
    }
}
