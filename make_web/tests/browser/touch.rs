//! Fingers, on screens and touchpads, and pens.

use super::browser::{Browser, SIZE, VIEW};
use super::picture::difference;

#[test]
fn one_finger_turns_the_scene() {
    let browser = Browser::open();
    let before = browser.picture();
    browser.touch(&[[(700, 650), (850, 650)]]);
    assert!(difference(&before, &browser.picture(), VIEW) > 0.05);
    browser.finish();
}

#[test]
fn the_tap_that_closes_a_menu_does_nothing_else() {
    let browser = Browser::open();
    let tap = |at| browser.touch(&[[at, at]]);
    // The man is selected at first.
    let selected = browser.picture();
    let help = (273, 12);
    tap(help);
    assert!(difference(&selected, &browser.picture(), VIEW) > 0.005);
    let ground = (700, 650);
    tap(ground);
    assert!(difference(&selected, &browser.picture(), VIEW) < 0.001);
    tap(ground);
    let deselected = difference(&selected, &browser.picture(), VIEW);
    assert!(
        deselected > 0.002,
        "the next one counts again: {deselected}"
    );
    browser.finish();
}

#[test]
fn two_fingers_move_and_zoom() {
    let browser = Browser::open();
    let before = browser.picture();
    browser.touch(&[[(400, 400), (300, 400)], [(600, 400), (700, 400)]]);
    let apart = browser.picture();
    assert!(difference(&before, &apart, VIEW) > 0.05);
    browser.touch(&[[(400, 300), (400, 400)], [(600, 300), (600, 400)]]);
    assert!(difference(&apart, &browser.picture(), VIEW) > 0.05);
    browser.finish();
}

#[test]
fn two_fingers_on_a_bone_zoom_and_do_not_pose() {
    let browser = Browser::open();
    browser.press(&["b"]);
    let before = browser.picture();
    // The raised arm of the man, and beside it.
    browser.touch(&[[(255, 160), (215, 160)], [(300, 170), (340, 170)]]);
    assert!(difference(&before, &browser.picture(), VIEW) > 0.05);
    let leaves = "return dispatchEvent(new Event('beforeunload', {cancelable: true}))";
    assert_eq!(browser.script(leaves), true, "nothing is unsaved");
    browser.finish();
}

#[test]
fn a_bone_is_dragged_by_a_finger_that_only_comes_near_it() {
    let browser = Browser::open();
    browser.press(&["b"]);
    let before = browser.picture();
    // Beside the raised arm of the man, farther than a mouse may be.
    browser.touch(&[[(255, 160), (215, 300)]]);
    let after = browser.picture();
    assert!(difference(&before, &after, (150, 60, 480, 640)) > 0.005);
    // The camera stands still: the robot is where it was.
    assert!(difference(&before, &after, (560, 100, 900, 640)) < 0.001);
    browser.finish();
}

#[test]
fn a_bone_is_selected_by_a_tap_near_it() {
    let browser = Browser::open();
    browser.press(&["b"]);
    // Nowhere, so that nothing is selected.
    browser.touch(&[[(700, 650), (700, 650)]]);
    let before = browser.picture();
    browser.touch(&[[(255, 160), (255, 160)]]);
    browser.wait("the bone is selected", || {
        difference(&before, &browser.picture(), (150, 60, 480, 640)) > 0.005
    });
    browser.finish();
}

#[test]
fn a_long_press_is_the_right_click_that_sets_a_number_back() {
    let browser = Browser::open();
    let before = browser.picture();
    // The rotation of the man about Y.
    let (x, y) = (SIZE.0 - 100, 289);
    browser.touch(&[[(x, y), (x - 60, y)]]);
    assert!(difference(&before, &browser.picture(), VIEW) > 0.005);
    browser.hold(x, y);
    assert!(difference(&before, &browser.picture(), VIEW) < 0.001);
    browser.finish();
}

#[test]
fn two_fingers_on_a_touchpad_zoom_the_view_and_not_the_page() {
    let browser = Browser::open();
    let before = browser.picture();
    let scale = || browser.script("return [visualViewport.scale, devicePixelRatio]");
    let scale_before = scale();
    browser.pinch((560, 300), 60);
    assert!(difference(&before, &browser.picture(), VIEW) > 0.05);
    browser.pinch((560, 300), -60);
    assert!(difference(&before, &browser.picture(), VIEW) < 0.01);
    assert_eq!(scale(), scale_before);
    browser.finish();
}

#[test]
fn a_pen_drags_a_bone_and_beside_it_moves_the_view() {
    let browser = Browser::open();
    browser.press(&["b"]);
    let before = browser.picture();
    // The raised arm of the man.
    browser.drag_pen((271, 185), (215, 300));
    let posed = browser.picture();
    assert!(difference(&before, &posed, (150, 60, 480, 640)) > 0.005);
    // The camera stands still: the robot is where it was.
    let robot = (560, 100, 900, 640);
    assert!(difference(&before, &posed, robot) < 0.001);
    browser.drag_pen((700, 650), (850, 650));
    assert!(difference(&posed, &browser.picture(), robot) > 0.05);
    browser.finish();
}
