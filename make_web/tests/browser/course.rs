//! The characters that come with the course, where they are there.

use super::browser::{Browser, CTRL, SHIFT, SIZE, VIEW};
use super::picture::difference;
use super::reference_data::course;

#[test]
fn a_character_of_the_course_is_imported_and_posed_by_a_number() {
    let Some(characters) = course("characters") else {
        return;
    };
    let browser = Browser::open();
    browser.command("New");
    let empty = browser.picture();
    browser.press(&[CTRL, SHIFT, "i"]);
    let files = ["Model1.obj", "Model1.skel", "Model1.attach"];
    browser.choose(&files.map(|name| characters.join(name)));
    browser.wait("the character is there", || {
        difference(&empty, &browser.picture(), VIEW) > 0.02
    });
    let imported = browser.picture();
    // The right hip's rotation about X.
    let (x, y) = (SIZE.0 - 130, 535);
    browser.drag((x, y), (x - 60, y));
    let posed = browser.picture();
    assert!(difference(&imported, &posed, VIEW) > 0.002);
    browser.press(&[CTRL, "z"]);
    assert!(difference(&imported, &browser.picture(), VIEW) < 0.001);
    browser.finish();
}
