//! Pictures of the page beside those that the program draws without a browser.

use super::browser::{Browser, ENTER, F12};
use image::RgbImage;
use std::path::Path;
use std::process::Command;

/// Most by which a channel may differ between two drivers.
const MOST: u8 = 8;

#[test]
fn pictures_of_the_page_are_those_of_the_program_but_for_edges() {
    for name in ["showcase", "mannequin-4", "turned"] {
        let browser = Browser::open();
        browser.go(&format!("?open=builtin:{name}"));
        browser.picture();
        browser.press(&[F12]);
        browser.press(&[ENTER]);
        let page = browser.downloaded(&format!("{name}.png"));
        let page = image::load_from_memory(&page).unwrap().into_rgb8();
        let native = native(name, page.dimensions());
        let (at_edges, elsewhere) = off(&page, &native);
        println!("{name}: {at_edges:.5} of the pixels are off at edges, {elsewhere:.5} elsewhere");
        assert!(elsewhere < 0.002 && at_edges < 0.01, "{name}");
        browser.finish();
    }
}

/// The picture of a built-in scene by the program of `cargo build`.
fn native(name: &str, (width, height): (u32, u32)) -> RgbImage {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("native.png");
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/debug/editor");
    let drawn = Command::new(program)
        .args(["render", &format!("builtin:{name}"), "--theme", "light"])
        .args([
            "--samples",
            "4",
            "--size",
            &format!("{width}x{height}"),
            "-o",
        ])
        .arg(&picture)
        .status();
    assert!(drawn.expect("run `make test-web`").success());
    image::open(picture).unwrap().into_rgb8()
}

/// Shares of all pixels that are off where the program's picture has an edge, and elsewhere.
fn off(page: &RgbImage, native: &RgbImage) -> (f64, f64) {
    let (width, height) = native.dimensions();
    let differ = |a: [u8; 3], b: [u8; 3]| (0..3).any(|i| a[i].abs_diff(b[i]) > MOST);
    let is_edge = |x: u32, y: u32| {
        let here = native.get_pixel(x, y).0;
        let around = (x.saturating_sub(1)..(x + 2).min(width))
            .flat_map(|x| (y.saturating_sub(1)..(y + 2).min(height)).map(move |y| (x, y)));
        around
            .into_iter()
            .any(|(x, y)| differ(here, native.get_pixel(x, y).0))
    };
    let all = native.enumerate_pixels();
    let off = all.filter(|(x, y, pixel)| differ(pixel.0, page.get_pixel(*x, *y).0));
    let (edges, others): (Vec<_>, Vec<_>) = off.partition(|(x, y, _)| is_edge(*x, *y));
    let share = |count: usize| count as f64 / f64::from(width * height);
    (share(edges.len()), share(others.len()))
}
