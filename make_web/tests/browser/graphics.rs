//! What is drawn, and drawn again.

use super::browser::{Browser, SIZE, VIEW};
use super::picture::{assert_not_blank, difference};

#[test]
fn the_page_starts_with_a_picture_of_the_showcase() {
    let browser = Browser::open();
    assert_not_blank(&browser.picture(), VIEW);
    assert_eq!(browser.script("return document.title"), "Editor");
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
fn a_window_as_small_as_a_telephone_shows_the_scene() {
    let browser = Browser::with_size((420, 700), 1.0);
    let picture = browser.picture();
    assert_eq!(picture.dimensions(), (420, 700));
    assert_not_blank(&picture, (10, 60, 250, 500));
    browser.finish();
}
