//! What the browser keeps from one visit to the next.

use super::browser::{Browser, CTRL, ESC, VIEW};
use super::files::asset;
use super::picture::difference;
use image::RgbImage;

/// Whether the panels are dark.
pub fn is_dark(picture: &RgbImage) -> bool {
    // The menu bar, right of its titles.
    picture
        .get_pixel(500, 12)
        .0
        .iter()
        .all(|&channel| channel < 100)
}

#[test]
fn a_theme_and_a_navigation_that_were_chosen_are_there_after_a_reload() {
    let browser = Browser::open();
    assert!(!is_dark(&browser.picture()));
    browser.command("Theme: Dark");
    browser.command("Navigation: Mannequin");
    assert!(is_dark(&browser.picture()));
    browser.reload();
    assert!(is_dark(&browser.picture()));
    // A key that opens a scene in this navigation alone.
    browser.press(&["2"]);
    browser.wait("the scene is open", || {
        browser.title().starts_with("mannequin-2")
    });
    browser.command("Theme: System");
    browser.reload();
    assert!(!is_dark(&browser.picture()));
    browser.finish();
}

#[test]
fn a_file_that_was_opened_is_among_the_recent_ones_after_a_reload() {
    let browser = Browser::open();
    browser.press(&[CTRL, "o"]);
    let files = ["robot.obj", "robot.skel", "robot.attach"];
    browser.choose(&files.map(|name| asset(&format!("characters/{name}"))));
    browser.wait("the robot is open", || browser.title().starts_with("robot"));
    let robot = browser.picture();
    browser.reload();
    assert!(!browser.title().starts_with("robot"));
    // File ▸ Open Recent, and what is first there.
    browser.click(25, 12);
    browser.click(60, 215);
    browser.click(290, 215);
    browser.wait("the robot is open", || browser.title().starts_with("robot"));
    assert!(difference(&robot, &browser.picture(), VIEW) < 0.01);
    browser.finish();
}

#[test]
fn a_page_that_is_to_be_read_aloud_speaks_and_still_does_after_a_reload() {
    let browser = Browser::open();
    let listen = || {
        browser.script(
            "window.spoken = [];
             speechSynthesis.speak = (utterance) => spoken.push(utterance.text)",
        );
    };
    let has_spoken = || browser.script("return spoken.join(' ').includes('button')") == true;
    let use_button = || browser.click(35, 45);
    listen();
    use_button();
    browser.picture();
    assert!(!has_spoken(), "nobody has asked for it");
    browser.command("Preferences");
    browser.picture();
    // The checkbox of the part on speech.
    browser.click(421, 586);
    browser.press(&[ESC]);
    use_button();
    browser.wait("a button is read aloud", has_spoken);
    browser.reload();
    listen();
    use_button();
    browser.wait("a button is read aloud", has_spoken);
    browser.finish();
}
