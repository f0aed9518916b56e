//! What is drawn, and drawn again.

use super::browser::{Browser, SIZE, VIEW};
use super::picture::{assert_not_blank, difference};

#[test]
fn the_page_starts_with_a_picture_of_the_showcase() {
    let browser = Browser::open();
    assert_not_blank(&browser.picture(), VIEW);
    assert_eq!(browser.script("return document.title"), "showcase — Editor");
    browser.finish();
}

#[test]
fn a_lost_context_comes_back_with_the_same_picture() {
    let browser = Browser::open();
    let before = browser.picture();
    browser.script(
        "window.taken = document.getElementById('editor').getContext('webgl2')
            .getExtension('WEBGL_lose_context'); taken.loseContext()",
    );
    let note = "return document.getElementById('note').hidden";
    browser.wait("the page says so", || browser.script(note) == false);
    browser.script("taken.restoreContext()");
    browser.wait_for_program();
    let whole = (0, 0, SIZE.0, SIZE.1);
    assert_eq!(difference(&before, &browser.picture(), whole), 0.0);
    browser.finish();
}

#[test]
fn screens_with_finer_pixels_are_drawn_with_all_of_them() {
    let browser = Browser::with_size(SIZE, 2.0);
    let canvas = browser.script("return document.getElementById('editor').width");
    assert_eq!(canvas, 2 * SIZE.0);
    browser.finish();
}

#[test]
fn a_window_as_small_as_a_telephone_shows_the_scene_with_the_panel_as_a_sheet_below_it() {
    let browser = Browser::with_size((420, 700), 1.0);
    let closed = browser.picture();
    assert_eq!(closed.dimensions(), (420, 700));
    assert_not_blank(&closed, (10, 60, 250, 500));
    let (sheet, above) = ((0, 370, 420, 690), (0, 60, 420, 300));
    browser.touch(&[[(210, 684); 2]]);
    let open = browser.picture();
    assert!(difference(&closed, &open, sheet) > 0.5);
    assert_not_blank(&open, (10, 60, 400, 300));
    // Fingers on it are not for the view.
    browser.touch(&[[(150, 447), (150, 400)], [(350, 447), (350, 400)]]);
    assert_eq!(difference(&open, &browser.picture(), above), 0.0);
    browser.touch(&[[(210, 346); 2]]);
    // Above the first help, which speaks of fingers from the first touch on.
    assert!(difference(&closed, &browser.picture(), (0, 60, 420, 480)) < 0.01);
    browser.finish();
}
