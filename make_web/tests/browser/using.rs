//! Work on the page: numbers, undoing, and what a reload leaves.

use super::browser::{Browser, CTRL, ENTER, ESC, SIZE, VIEW};
use super::picture::difference;

/// The field with the rotation about Y of the active shape.
const ROTATION_Y: (u32, u32) = (SIZE.0 - 100, 289);

#[test]
fn dragging_a_number_turns_the_shape_and_undo_turns_it_back() {
    let browser = Browser::open();
    let before = browser.picture();
    let (x, y) = ROTATION_Y;
    browser.drag((x, y), (x - 100, y));
    let turned = browser.picture();
    assert!(difference(&before, &turned, VIEW) > 0.01);
    browser.press(&[CTRL, "z"]);
    assert!(difference(&before, &browser.picture(), VIEW) < 0.001);
    browser.finish();
}

#[test]
fn a_bone_is_dragged_with_the_pose_tool() {
    let browser = Browser::open();
    browser.press(&["b"]);
    let before = browser.picture();
    // The raised hand of the man.
    browser.drag((318, 170), (270, 300));
    assert!(difference(&before, &browser.picture(), VIEW) > 0.005);
    browser.finish();
}

#[test]
fn esc_never_ends_the_page() {
    let browser = Browser::open();
    for _ in 0..4 {
        browser.press(&[ESC]);
    }
    browser.press(&[CTRL, "q"]);
    let before = browser.picture();
    // Still alive: a click on the first shape of the list selects it.
    browser.click(SIZE.0 - 200, 97);
    let whole = (0, 0, SIZE.0, SIZE.1);
    assert!(difference(&before, &browser.picture(), whole) > 0.001);
    browser.finish();
}

#[test]
fn a_reload_in_the_middle_of_work_offers_it_back() {
    let browser = Browser::open();
    let leaves = "return dispatchEvent(new Event('beforeunload', {cancelable: true}))";
    assert_eq!(browser.script(leaves), true, "nothing is unsaved");
    let (x, y) = ROTATION_Y;
    browser.drag((x, y), (x - 100, y));
    assert_eq!(browser.script(leaves), false, "the browser asks first");
    let before = browser.picture();
    browser.go("");
    browser.press(&[ENTER]);
    assert!(difference(&before, &browser.picture(), VIEW) < 0.001);
    browser.finish();
}
