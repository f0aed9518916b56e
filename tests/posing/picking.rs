//! The bone under the pointer, against brute force.

use crate::posing::support::{SIZE, cameras, poses, session, transforms};
use editor_core::math::Ray;
use editor_core::scene::{bones_in_world, pick_bone};
use glam::{Vec2, Vec3};
use proptest::prelude::*;

/// Walks along the ray in small steps until a point lies in the cylinder.
fn first_point_inside(ray: &Ray, start: Vec3, end: Vec3, radius: f32, step: f32) -> Option<f32> {
    let along = (end - start).try_normalize()?;
    let inside = |point: Vec3| {
        let offset = point - start;
        let height = offset.dot(along);
        let beside = (offset - along * height).length();
        (0.0..=start.distance(end)).contains(&height) && beside <= radius
    };
    (0..12_000)
        .map(|i| i as f32 * step)
        .find(|&at| inside(ray.at(at)))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn the_nearest_cylinder_along_the_ray_is_picked(
        camera in cameras(), transform in transforms(), pose in poses(),
        at in (0.1..0.9_f32, 0.1..0.9_f32), aim in 0..4_usize, share in 0.0..1.0_f32, aimed in any::<bool>(),
    ) {
        let (session, id) = session(camera, transform, &pose);
        let shape = session.evaluated().shape(id).unwrap();
        let bones: Vec<_> = bones_in_world(session.scene(), shape).collect();
        let mut pixel = SIZE * Vec2::from(at);
        if aimed {
            let (_, start, end) = bones[aim];
            let on_bone = camera.pixel(start.lerp(end, share), SIZE);
            prop_assume!(on_bone.is_some());
            pixel = on_bone.unwrap() + (Vec2::from(at) - 0.5) * 40.0;
        }
        let ray = camera.ray(pixel, SIZE);
        let scale = shape.world_from_model.determinant().abs().cbrt();
        let per_pixel = 2.0 * (camera.fovy * 0.5).tan() / SIZE.y;
        let step = 0.002;
        let walked = bones.iter().filter_map(|&(joint, start, end)| {
            let plain = (0.1 * scale).min(0.4 * start.distance(end));
            // The least radius grows with depth, which is that of the bone where the ray passes.
            let near = ray_depth(&ray, start, end);
            let radius = plain.max(8.0 * per_pixel * near);
            first_point_inside(&ray, start, end, radius, step).map(|at| (at, joint))
        });
        let expected = walked.min_by(|a, b| a.0.total_cmp(&b.0));
        let found = pick_bone(session.scene(), session.evaluated(), &camera, pixel, SIZE, 8.0);
        match (expected, found) {
            (Some((at, joint)), Some(hit)) => {
                prop_assert!(hit.distance <= at + 1e-3);
                // Corners that are thinner than a step are walked past.
                prop_assert!(hit.joint == joint || hit.distance <= at + step);
                prop_assert!(hit.point.abs_diff_eq(ray.at(hit.distance), 1e-6));
            }
            (Some((at, joint)), None) => prop_assert!(false, "missed {joint} at {at}"),
            (None, Some(hit)) => {
                let past = ray.at(hit.distance + step);
                let (_, start, end) = bones[hit.bone];
                // Only a graze is walked past.
                prop_assert!(ray_leaves_soon(&ray, hit.distance, start, end, step), "{past}");
            }
            (None, None) => {}
        }
    }
}

/// Depth along the ray of the bone's point nearest to it, by trial.
fn ray_depth(ray: &Ray, start: Vec3, end: Vec3) -> f32 {
    let beside = |share: f32| {
        let offset = start.lerp(end, share) - ray.origin;
        (offset - ray.direction * offset.dot(ray.direction)).length()
    };
    let shares = (0..=4000).map(|i| i as f32 / 4000.0);
    let nearest = shares.min_by(|&a, &b| beside(a).total_cmp(&beside(b)));
    let point = start.lerp(end, nearest.unwrap_or(0.0));
    (point - ray.origin).dot(ray.direction).max(0.0)
}

/// Whether the ray is within the cylinder for less than a step, by the change of what it passes.
fn ray_leaves_soon(ray: &Ray, at: f32, start: Vec3, end: Vec3, step: f32) -> bool {
    let along = (end - start).normalize_or_zero();
    let height = |t: f32| (ray.at(t) - start).dot(along);
    let ends = |h: f32| h < 1e-3 || h > start.distance(end) - 1e-3;
    let beside = |t: f32| (ray.at(t) - start).reject_from(along).length();
    ends(height(at)) || ends(height(at + step)) || beside(at + step) >= beside(at) - 1e-3
}
