//! From where a line in space is seen whose end should not be behind its start.

use crate::scene::Camera;
use glam::Vec3;
use std::f32::consts::FRAC_PI_3;

/// Part of its length that a line is seen with at least, or the view is turned.
const SHORTEST: f32 = 0.5;
/// Angle between a line and the direction of view that is turned for it, in radians.
const ACROSS: f32 = FRAC_PI_3;
/// Sine of the angle below which a line has no side on which it is looked at.
const END_ON: f32 = 1e-3;
/// Most that the camera looks down, or up, in radians.
const STEEPEST: f32 = 1.2;

/// The camera turned to look from `outward`, a unit vector in the world, as nearly as it is not too steep.
pub(super) fn looking_from(camera: Camera, outward: Vec3) -> Camera {
    let phi = outward.y.clamp(-1.0, 1.0).asin();
    camera.facing(outward, phi.clamp(-STEEPEST, STEEPEST))
}

/// The camera from which `line`, a vector in the world, is not seen end-on: the same where it is seen with half of its
/// length or more, or has none. Else it is turned within the plane of both, or to its right where these are one, so that
/// what faces it still does.
pub(super) fn with_across(camera: Camera, line: Vec3) -> Camera {
    let outward = -camera.forward();
    let Some(line) = line.try_normalize() else {
        return camera;
    };
    let towards_eye = line.dot(outward);
    let aside = outward - line * towards_eye;
    if aside.length() >= SHORTEST {
        return camera;
    }
    let aside = match aside.length() < END_ON {
        true => camera.right(),
        false => aside.normalize_or_zero(),
    };
    let along = line * towards_eye.signum();
    looking_from(camera, along * ACROSS.cos() + aside * ACROSS.sin())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::{FRAC_PI_2, FRAC_PI_6};

    /// Directions all over the sphere, with those that the axes have.
    fn directions() -> impl Iterator<Item = Vec3> {
        let turns = (0..24).map(|turn| turn as f32 * FRAC_PI_6 / 2.0);
        turns.flat_map(|theta| {
            (-6..=6).map(move |rise| {
                let phi = rise as f32 * FRAC_PI_2 / 6.0;
                Vec3::new(phi.cos() * theta.cos(), phi.sin(), phi.cos() * theta.sin())
            })
        })
    }

    /// Angle between a line and the direction of view, 0 where it is seen end-on, in degrees.
    fn angle(camera: &Camera, line: Vec3) -> f32 {
        let cosine = line.normalize_or_zero().dot(camera.forward()).abs();
        cosine.min(1.0).acos().to_degrees()
    }

    #[test]
    fn a_line_towards_the_eye_is_turned_by_60_degrees_and_what_faced_the_camera_still_does() {
        for normal in directions().filter(|normal| normal.y.abs() < 0.9) {
            let camera = looking_from(Camera::default(), normal);
            assert!(angle(&camera, normal) < 0.1);
            for line in [normal, -normal, 0.01 * normal] {
                let turned = with_across(camera, line);
                let (angle, faces) = (angle(&turned, line), -turned.forward().dot(normal));
                assert!((angle - 60.0).abs() < 0.1, "{normal}: {angle}");
                assert!((faces - 0.5).abs() < 1e-2, "{normal}: {faces}");
            }
        }
    }

    #[test]
    fn wherever_lines_run_they_are_seen_with_half_of_their_length() {
        for normal in directions() {
            let camera = looking_from(Camera::default(), normal);
            for line in directions() {
                let turned = with_across(camera, 3.0 * line);
                assert!(angle(&turned, line) > 29.9, "{normal} {line}");
                assert!(turned.phi.abs() <= STEEPEST);
                if normal.y.abs() < 0.9 {
                    let faces = -turned.forward().dot(normal);
                    assert!(faces > 0.1, "{normal} {line}: {faces}");
                }
            }
        }
    }

    #[test]
    fn a_line_that_is_seen_or_has_no_length_turns_nothing() {
        let camera = looking_from(Camera::default(), Vec3::Z);
        let seen = Vec3::new(0.51, 0.0, 0.86);
        for line in [
            seen,
            -seen,
            Vec3::X,
            Vec3::Y,
            Vec3::ZERO,
            Vec3::splat(1e-30),
        ] {
            assert_eq!(with_across(camera, line), camera, "{line}");
        }
        let shorter = Vec3::new(0.49, 0.0, 0.87);
        assert_ne!(with_across(camera, shorter), camera);
        assert_ne!(with_across(camera, -shorter), camera);
    }
}
