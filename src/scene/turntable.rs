//! Turntables: the cameras of a turn about what a camera looks at.

use super::{Camera, FitArea};
use crate::math::Aabb;
use std::f32::consts::TAU;
use std::ops::RangeInclusive;

/// Numbers of frames that a turntable may have.
pub const TURNTABLE_FRAMES: RangeInclusive<u32> = 2..=720;

/// Time that a frame of a turntable is shown, in milliseconds: a turn takes four seconds if it has
/// enough frames, and not too many for programs, which show none for less than 20 ms.
pub fn turntable_milliseconds(frames: u32) -> u32 {
    (400 + frames / 2).div_euclid(frames).clamp(2, 50) * 10
}

/// Cameras of a turn about the target, in even steps, the first being `camera`. The scene turns to
/// the right.
pub fn turntable_cameras(camera: Camera, frames: u32) -> impl Iterator<Item = Camera> {
    (0..frames).map(move |frame| Camera {
        theta: camera.theta + TAU * (frame as f32 / frames as f32),
        ..camera
    })
}

/// Fits `bounds`, in world space, into all pictures of a turn: as [`Camera::fit`], with the greatest
/// distance of all. `aspect` is the width of the pictures over their height.
pub fn fit_turntable(camera: &mut Camera, frames: u32, bounds: &Aabb, aspect: f32) {
    let fitted: Vec<Camera> = turntable_cameras(*camera, frames)
        .map(|mut camera| {
            camera.fit(bounds, FitArea::whole(aspect));
            camera
        })
        .collect();
    let farthest = fitted.iter().max_by(|a, b| a.radius.total_cmp(&b.radius));
    let Some(farthest) = farthest else { return };
    let near = fitted.iter().map(|camera| camera.near);
    let far = fitted.iter().map(|camera| camera.far);
    *camera = Camera {
        theta: camera.theta,
        near: near.fold(farthest.near, f32::min),
        far: far.fold(farthest.far, f32::max),
        ..*farthest
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec2, Vec3};

    #[test]
    fn a_turn_takes_about_four_seconds() {
        let times = [2, 8, 36, 100, 720].map(turntable_milliseconds);
        assert_eq!(times, [500, 500, 110, 40, 20]);
    }

    #[test]
    fn a_fitted_turn_shows_every_corner_from_every_side() {
        let bounds = Aabb {
            min: Vec3::new(-4.0, 0.0, -0.1),
            max: Vec3::new(1.0, 1.0, 0.2),
        };
        let mut camera = Camera::default();
        fit_turntable(&mut camera, 12, &bounds, 1.0);
        let mut most = 0.0_f32;
        for turned in turntable_cameras(camera, 12) {
            for corner in bounds.corners() {
                let at = turned.pixel(corner, Vec2::splat(100.0)).unwrap();
                most = most.max((at - Vec2::splat(50.0)).abs().max_element());
            }
        }
        // Of 50 pixels from the middle to the edge.
        assert!((40.0..=50.0).contains(&most), "{most}");
    }
}
