//! Scenes in links and in other pages, and what a link must not do.

use super::browser::{Browser, CTRL, RIGHT, SIZE, VIEW};
use super::picture::{Part, assert_not_blank, difference};
use serde_json::json;
use std::net::TcpListener;

/// Whole page of [`SIZE`].
const WHOLE: (u32, u32, u32, u32) = (0, 0, SIZE.0, SIZE.1);

#[test]
fn a_link_to_a_scene_shows_it_to_whoever_opens_it() {
    let browser = Browser::open();
    let rights = json!({"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]});
    browser.devtools("Browser.grantPermissions", &rights);
    let before = browser.picture();
    // The man, who is selected, is turned.
    browser.drag((SIZE.0 - 100, 289), (SIZE.0 - 200, 289));
    let changed = browser.picture();
    assert!(difference(&before, &changed, VIEW) > 0.01);
    browser.command("Copy Link");
    browser.script("navigator.clipboard.readText().then((text) => { window.link = text })");
    browser.wait("there is a link", || {
        browser.script("return typeof window.link") == "string"
    });
    let link = browser.script("return window.link");
    // What is not saved would be offered instead.
    browser.press(&[CTRL, "z"]);
    browser.picture();
    let (_, fragment) = link
        .as_str()
        .unwrap()
        .split_once('#')
        .expect("a link to a scene");
    browser.go(&format!("?a=1#{fragment}"));
    let shown = browser.picture();
    // Nothing is selected in a scene that was opened, so the outlines are gone.
    assert!(difference(&changed, &shown, VIEW) < 0.05);
    assert!(difference(&changed, &shown, VIEW) < difference(&before, &shown, VIEW));
    // Once another document is open, a reload is not to bring this one.
    let fragment = || browser.script("return location.hash");
    assert_ne!(fragment(), "");
    browser.command("New");
    browser.wait("the scene of the link is left", || fragment() == "");
    browser.finish();
}

#[test]
fn a_link_that_was_cut_off_opens_the_page_with_an_error() {
    let browser = Browser::open();
    browser.go("?a=1");
    let without = browser.picture();
    browser.go("?a=2#scene=q1bKTFGyUjIyVA");
    // The message, where nothing was before.
    assert!(difference(&without, &browser.picture(), WHOLE) > 0.001);
    browser.finish();
}

#[test]
fn files_of_another_host_are_never_asked_for() {
    let browser = Browser::open();
    let other = TcpListener::bind("127.0.0.1:0").unwrap();
    other.set_nonblocking(true).unwrap();
    let port = other.local_addr().unwrap().port();
    for before in [
        "//",
        "%20//",
        "%09//",
        "http://",
        "%20http://",
        "\\\\",
        "/\\",
    ] {
        browser.go(&format!("?open={before}127.0.0.1:{port}/a.obj"));
        assert!(other.accept().is_err(), "{before}");
    }
    // Nor did the page ask its own policy, which would be an error in the console.
    browser.finish();
}

/// Opens the page with the tag, and returns where the character in it is shown.
pub fn open_tag(browser: &Browser) -> Part {
    browser.go_elsewhere("example.html");
    browser.script("document.querySelector('editor-view').scrollIntoView()");
    let frame = "document.querySelector('editor-view').shadowRoot.querySelector('iframe')";
    let shown = format!(
        "return {frame}.contentWindow.performance?.getEntriesByName('editor-shown').length > 0"
    );
    browser.wait("the character is there", || browser.script(&shown) == true);
    let place = browser.script(&format!(
        "const at = {frame}.getBoundingClientRect(); return [at.left, at.top, at.right, at.bottom]"
    ));
    let side = |i: usize| place[i].as_f64().unwrap() as u32;
    (side(0), side(1), side(2), side(3).min(SIZE.1))
}

#[test]
fn a_bone_in_a_tag_is_lit_under_the_pointer_and_rolled_by_an_arrow_key() {
    let browser = Browser::open();
    let part = open_tag(&browser);
    let middle = (part.0.midpoint(part.2), part.1.midpoint(part.3));
    let focused = || browser.script("return document.activeElement.tagName");
    assert_eq!(focused(), "BODY", "the keyboard is the page's");
    // Beside the figure, which gives the frame the keyboard.
    browser.click(part.0 + 60, part.3 - 100);
    assert_eq!(focused(), "EDITOR-VIEW");
    let before = browser.picture();
    browser.point(middle);
    let lit = browser.picture();
    assert!(difference(&before, &lit, part) > 0.0005);
    browser.press(&[RIGHT]);
    browser.press(&[RIGHT]);
    assert!(difference(&lit, &browser.picture(), part) > 0.0005);
    browser.finish();
}

#[test]
fn the_wheel_over_a_tag_scrolls_the_page_around_it_until_a_click_in_it() {
    let browser = Browser::open();
    let part = open_tag(&browser);
    browser.script("document.body.style.paddingBottom = '3000px'");
    let middle = (part.0.midpoint(part.2), part.1.midpoint(part.3));
    let scrolled = || browser.script("return window.scrollY").as_f64().unwrap();
    let before = scrolled();
    browser.wheel(middle, 60);
    assert!(scrolled() > before, "the page goes on");
    browser.script("document.querySelector('editor-view').scrollIntoView()");
    browser.click(part.0 + 60, part.3 - 100);
    let (there, before) = (scrolled(), browser.picture());
    browser.wheel(middle, -200);
    assert_eq!(scrolled(), there);
    assert!(
        difference(&before, &browser.picture(), part) > 0.01,
        "it comes nearer"
    );
    browser.finish();
}

#[test]
fn a_tag_shows_a_character_in_another_page() {
    let browser = Browser::open();
    let part = open_tag(&browser);
    let before = browser.picture();
    assert_not_blank(&before, part);
    // Beside the figure.
    let (x, y) = (part.0 + 60, part.3 - 100);
    browser.drag((x, y), (x + 200, y));
    let turned = browser.picture();
    assert!(difference(&before, &turned, part) > 0.01);
    browser.click(part.0 + 30, part.1 + 20);
    assert!(difference(&before, &browser.picture(), part) < 0.01);
    browser.finish();
}
