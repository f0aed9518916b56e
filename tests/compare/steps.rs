//! Comparisons in small steps, for threads that must not be held up.

use crate::compare::painter::{HEIGHT, SCENE, Scene, WIDTH};
use crate::work::work;
use editor_core::compare::PictureJob;
use editor_core::geometry::Picture;
use editor_core::steps::Steps;
use std::sync::Arc;
use std::time::Duration;

/// The scene in `times` as many columns and rows.
fn large(scene: &Scene, times: u32) -> Arc<Picture> {
    let small = scene.paint();
    let (pixels, _) = small.rgba.as_chunks::<4>();
    let (width, height) = (WIDTH * times, HEIGHT * times);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x / times, y / times)));
    Arc::new(Picture {
        width,
        height,
        rgba: places
            .flat_map(|(x, y)| pixels[(y * WIDTH + x) as usize])
            .collect(),
    })
}

/// Number of the steps, the time of the processor that the longest took, and that of all.
fn times<T>(mut steps: Steps<T>) -> (usize, Duration, Duration) {
    let (mut count, mut longest, mut all) = (0, Duration::ZERO, Duration::ZERO);
    loop {
        let (result, time) = work(|| steps.step());
        count += 1;
        longest = longest.max(time);
        all += time;
        if result.is_some() {
            return (count, longest, all);
        }
    }
}

#[test]
fn no_step_of_a_comparison_takes_a_large_part_of_its_time() {
    let moved = Scene {
        center: [73.0, 52.0],
        ..SCENE
    };
    let larger = Scene {
        radius: 40.0,
        ..SCENE
    };
    let duller = Scene {
        background: [200, 210, 220],
        specular: 0.2,
        ..SCENE
    };
    for scene in [moved, larger, duller] {
        let job = PictureJob {
            a: large(&SCENE, 4),
            b: large(&scene, 4),
            threshold: 0,
            ignore: Vec::new(),
            ground: None,
        };
        let (count, longest, all) = times(job.clone().measure());
        assert!(
            count > 50 && 5 * longest < all,
            "{count}: {longest:?}, {all:?}"
        );
        let (count, longest, all) = times(job.judge());
        assert!(
            count > 400 && 30 * longest < all,
            "{count}: {longest:?}, {all:?}"
        );
    }
}
