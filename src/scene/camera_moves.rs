//! Movements of the camera by hand.

use super::Camera;
use glam::{Vec2, Vec3};
use std::f32::consts::FRAC_PI_2;

/// Least angle, in radians, between the direction of view and ±Y when the camera is turned by hand.
const POLE_MARGIN: f32 = 0.1;
const PAN_PER_PIXEL: f32 = 0.01;
/// Radius from which on the scene moves as fast as in the course's editor.
const NEAR_FOR_COURSE: f32 = 4.0;
const TURN_PER_PIXEL: f32 = 0.005;
const ZOOM_PER_NOTCH: f32 = 0.5;

impl Camera {
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
            let far = far.max(0.0).min(notches);
            self.radius -= ZOOM_PER_NOTCH * far;
            let before = self.radius;
            self.dolly(nearer * (notches - far));
            // As after a fit of something small, where it is nearer already than it may come.
            self.radius = self.radius.min(before);
        } else if notches < 0.0 {
            let near = (self.radius / NEAR_FOR_COURSE).ln() / nearer;
            let near = near.max(0.0).min(-notches);
            self.dolly(-nearer * near);
            self.radius += ZOOM_PER_NOTCH * (-notches - near);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let there = camera;
        camera.zoom(f32::NAN);
        assert_eq!(camera, there, "what is no number moves nothing");
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
        assert_eq!(camera.radius, 2.0 * camera.near);
    }
}
