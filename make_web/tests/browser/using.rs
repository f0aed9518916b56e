//! Work on the page: numbers, undoing, and what a reload leaves.

use super::browser::{Browser, CTRL, DELETE, ENTER, ESC, SIZE, VIEW};
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
    // The raised arm of the man.
    browser.drag((271, 185), (215, 300));
    let posed = browser.picture();
    assert!(difference(&before, &posed, (150, 60, 480, 640)) > 0.005);
    // The camera stands still: the robot is where it was.
    assert!(difference(&before, &posed, (560, 100, 900, 640)) < 0.001);
    browser.finish();
}

#[test]
fn keys_of_commands_are_kept_from_the_browser_and_others_are_not() {
    let browser = Browser::open();
    let is_kept = |key: &str, ctrl: bool| {
        let script = format!(
            "const press = new KeyboardEvent('keydown', {{key: '{key}', ctrlKey: {ctrl}, cancelable: true}});
             return !window.dispatchEvent(press)"
        );
        browser.script(&script) == true
    };
    assert!(is_kept("F6", false) && is_kept("s", true) && is_kept("o", true));
    assert!(!is_kept("r", true) && !is_kept("F11", false) && !is_kept("t", true));
    assert!(
        !is_kept("F5", false) && !is_kept("1", true),
        "reloading, and the first tab"
    );
    browser.finish();
}

#[test]
fn each_tab_keeps_its_own_unsaved_work_and_offers_it_again() {
    let browser = Browser::open();
    let first = browser.tab();
    let turn = || {
        let (x, y) = ROTATION_Y;
        browser.drag((x, y), (x - 100, y));
        browser.script("dispatchEvent(new Event('pagehide'))");
    };
    turn();
    let of_first = browser.picture();
    browser.open_tab();
    browser.resize(SIZE, 0.0);
    browser.go("?open=builtin:showcase");
    let kept = "return Object.keys(localStorage).filter((key) => key.includes('autosave')).length";
    browser.picture();
    assert_eq!(browser.script(kept), 1);
    browser.command("Select All");
    browser.press(&[DELETE]);
    browser.script("dispatchEvent(new Event('pagehide'))");
    assert_eq!(
        browser.script(kept),
        2,
        "neither takes the place of the other"
    );
    browser.use_tab(&first);
    browser.reload();
    browser.press(&[ENTER]);
    assert!(difference(&of_first, &browser.picture(), VIEW) < 0.001);
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
