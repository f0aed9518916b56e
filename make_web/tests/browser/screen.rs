//! What the browser tells of its screen and desktop while the page is open.

use super::browser::{Browser, SIZE, VIEW};
use super::keeping::is_dark;
use super::picture::{assert_not_blank, difference};
use serde_json::json;

/// Has the desktop ask for light or dark pages.
fn prefer(browser: &Browser, scheme: &str) {
    let features = json!([{"name": "prefers-color-scheme", "value": scheme}]);
    browser.devtools("Emulation.setEmulatedMedia", &json!({"features": features}));
}

#[test]
fn the_page_is_as_dark_as_the_desktop_until_a_theme_is_chosen() {
    let browser = Browser::open();
    let is_dark = || is_dark(&browser.picture());
    prefer(&browser, "dark");
    browser.wait("the page is dark", is_dark);
    browser.reload();
    assert!(is_dark(), "from the start");
    prefer(&browser, "light");
    browser.wait("the page is light", || !is_dark());
    browser.command("Theme: Dark");
    assert!(is_dark());
    prefer(&browser, "dark");
    browser.command("Theme: Light");
    assert!(!is_dark());
    browser.finish();
}

#[test]
fn a_page_that_is_zoomed_keeps_its_pixels_and_is_as_if_it_had_been_opened_so() {
    let browser = Browser::open();
    browser.go("?open=builtin:showcase");
    let before = browser.picture();
    let pixels = || {
        let canvas = "const at = document.getElementById('editor'); return [at.width, at.height]";
        browser.script(canvas)
    };
    let (width, height) = SIZE;
    browser.zoom(1.25);
    let zoomed = browser.picture();
    assert_eq!(browser.script("return devicePixelRatio"), 1.25);
    assert_eq!(pixels(), json!([width, height]));
    browser.reload();
    let whole = (0, 0, width, height);
    assert!(difference(&before, &zoomed, whole) > 0.05);
    let off = difference(&zoomed, &browser.picture(), whole);
    assert!(off < 0.001, "{off}");
    browser.zoom(1.0);
    assert!(difference(&before, &browser.picture(), whole) < 0.001);
    assert_eq!(pixels(), json!([width, height]));
    browser.finish();
}

#[test]
fn a_page_that_comes_to_a_screen_of_another_resolution_is_drawn_anew() {
    let browser = Browser::open();
    browser.picture();
    browser.resize(SIZE, 1.5);
    let picture = browser.picture();
    assert_eq!(picture.width(), SIZE.0 * 3 / 2);
    assert_not_blank(&picture, VIEW);
    browser.finish();
}
