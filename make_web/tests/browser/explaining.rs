//! Mistakes on the page: the formula at work, and another program's mesh beside the exact one.

use super::browser::{Browser, F8, SHIFT};
use super::comparing::jobs;
use super::picture::{Part, difference};
use image::RgbImage;
use std::path::Path;
use std::process::Command;

/// The figure, above the panels.
const FIGURE: Part = (330, 60, 670, 460);
/// The rows of the formula.
const ROWS: Part = (0, 610, 680, 760);

#[test]
fn the_formula_of_a_clicked_vertex_moves_with_its_joint_and_a_mistake_breaks_the_figure() {
    let browser = Browser::open();
    browser.go("?open=builtin:adult");
    browser.press(&["k"]);
    let opened = browser.picture();
    browser.click(598, 222);
    let clicked = browser.picture();
    assert!(
        difference(&opened, &clicked, ROWS) > 0.005,
        "other joints move it"
    );

    browser.press(&["b"]);
    let before = browser.picture();
    browser.drag((612, 242), (660, 190));
    let posed = browser.picture();
    assert!(
        difference(&before, &posed, FIGURE) > 0.005,
        "the forearm is turned"
    );
    assert!(
        difference(&before, &posed, ROWS) > 0.005,
        "the numbers follow"
    );

    // The first of the mistakes, and back.
    browser.click(760, 628);
    let wrong = browser.picture();
    assert!(
        difference(&posed, &wrong, FIGURE) > 0.02,
        "the figure is broken"
    );
    browser.click(760, 628);
    let right = browser.picture();
    assert!(difference(&wrong, &right, FIGURE) > 0.02);
    assert!(
        difference(&posed, &right, ROWS) < 0.001,
        "it is right again"
    );
    browser.finish();
}

#[test]
fn a_mesh_of_another_pose_is_compared_and_its_pose_taken() {
    let browser = Browser::open();
    browser.go("?open=builtin:adult");
    let folder = tempfile::tempdir().unwrap();
    let (pose, theirs) = (
        folder.path().join("bent.json"),
        folder.path().join("theirs.obj"),
    );
    std::fs::write(
        &pose,
        r#"{"joints": {"Left elbow": [0, 0, 40], "Waist": [10, 0, 0]}}"#,
    )
    .unwrap();
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/debug/editor");
    let mut export = Command::new(program);
    export
        .args(["export", "builtin:adult", "--pose"])
        .arg(&pose)
        .arg("-o")
        .arg(&theirs);
    assert!(export.status().expect("run `make test-web`").success());

    assert_eq!(violet(&browser.picture()), 0);
    let before = jobs(&browser);
    browser.press(&[SHIFT, F8]);
    browser.choose(&[theirs]);
    browser.wait("the distances are shown", || {
        violet(&browser.picture()) > 5000
    });
    browser.wait("the mistake is sought", || jobs(&browser) > before);
    browser.picture();
    // Take Its Pose.
    browser.click(57, 680);
    browser.wait("theirs is right in its pose", || {
        violet(&browser.picture()) == 0
    });
    browser.finish();
}

/// Pixels of the figure in the violet of small distances.
fn violet(picture: &RgbImage) -> usize {
    let (left, top, right, bottom) = FIGURE;
    let pixels = (top..bottom).flat_map(|y| (left..right).map(move |x| (x, y)));
    let is_violet = |(x, y)| {
        let [red, green, blue] = picture.get_pixel(x, y).0;
        red > 40 && green < 40 && blue > 60
    };
    pixels.filter(|&at| is_violet(at)).count()
}
