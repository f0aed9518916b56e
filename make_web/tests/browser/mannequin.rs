//! The scenes of the Virtual Mannequin, posed as there: any bone with the pointer.

use super::browser::{Browser, CTRL, ESC, VIEW};
use super::picture::difference;
use image::RgbImage;

/// A place on a bone of each scene, in the middle of what moves: of the crate, its lid.
const BONES: [(u32, u32); 7] = [
    (500, 379),
    (496, 382),
    (517, 292),
    (386, 214),
    (498, 260),
    (493, 500),
    (500, 350),
];

/// The page when neither the pointer nor the selection marks a bone.
fn leave_bone(browser: &Browser) -> RgbImage {
    browser.press(&[ESC]);
    browser.point((30, 600));
    browser.picture()
}

#[test]
fn in_all_seven_scenes_a_bone_lights_up_and_is_dragged_and_undo_takes_that_back() {
    let browser = Browser::open();
    browser.go("?open=builtin:mannequin-7");
    let mut before = browser.picture();
    for (number, (x, y)) in (1..).zip(BONES) {
        browser.press(&[&number.to_string()]);
        browser.wait("the scene is open", || {
            browser.title().starts_with(&format!("mannequin-{number}"))
        });
        let opened = browser.picture();
        let off = difference(&before, &opened, VIEW);
        assert!(off > 0.01, "{number} is another scene: {off}");
        // A click makes the figure the active one, which stays so when a drag of it is taken back.
        browser.click(x, y);
        let opened = leave_bone(&browser);
        browser.point((x, y));
        let lit = difference(&opened, &browser.picture(), VIEW);
        assert!(lit > 0.0005, "{number} lights up: {lit}");
        browser.drag((x, y), (x + 60, y + 30));
        let off = difference(&opened, &browser.picture(), VIEW);
        assert!(off > 0.005, "{number} is posed: {off}");
        browser.press(&[CTRL, "z"]);
        before = leave_bone(&browser);
        let off = difference(&opened, &before, VIEW);
        assert!(off < 0.001, "{number} is as it was: {off}");
    }
    browser.finish();
}
