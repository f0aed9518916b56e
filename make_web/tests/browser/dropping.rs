//! Archives and pictures that are dropped on the page, and characters that are imported.

use super::browser::{Browser, CTRL, ENTER, ESC, F12, SHIFT, SIZE, VIEW};
use super::comparing::jobs;
use super::files::asset;
use super::picture::difference;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// The files of a character, which belong together.
const ROBOT: [&str; 3] = ["robot.obj", "robot.skel", "robot.attach"];

/// An archive in `folder` with a robot in the folder `models`, and with `scene` beside that if there is one.
fn archive(folder: &Path, scene: Option<&str>) -> PathBuf {
    let path = folder.join("robots.zip");
    let mut zip = ZipWriter::new(fs::File::create(&path).unwrap());
    let mut add = |name: String, bytes: &[u8]| {
        zip.start_file(name, SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    };
    for name in ROBOT {
        let bytes = fs::read(asset(&format!("characters/{name}"))).unwrap();
        add(format!("robots/models/{name}"), &bytes);
    }
    if let Some(scene) = scene {
        add("robots/two.scene".to_owned(), scene.as_bytes());
    }
    zip.finish().unwrap();
    path
}

#[test]
fn a_scene_in_an_archive_that_is_dropped_is_opened_with_the_models_beside_it() {
    const TWO: &str = r#"{
      "format": "editor-scene",
      "version": 1,
      "shapes": [
        { "source": "models/robot.obj", "position": [-1, 0, 0] },
        { "source": "models/robot.obj", "position": [1, 0, 0] }
      ]
    }"#;
    let folder = tempfile::tempdir().unwrap();
    let archive = archive(folder.path(), Some(TWO));
    let browser = Browser::open();
    let before = browser.picture();
    browser.drop_files(&[archive]);
    browser.wait("the scene is open", || {
        browser.title().contains("robots.zip")
    });
    let opened = browser.picture();
    assert!(difference(&before, &opened, VIEW) > 0.05);
    browser.finish();
}

#[test]
fn a_model_in_an_archive_that_is_dropped_is_added_to_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let archive = archive(folder.path(), None);
    let browser = Browser::open();
    let before = browser.picture();
    browser.drop_files(&[archive]);
    browser.wait("the robot is there", || {
        difference(&before, &browser.picture(), VIEW) > 0.01
    });
    browser.finish();
}

#[test]
fn a_character_is_imported_from_files_that_are_chosen_together() {
    let browser = Browser::open();
    let before = browser.picture();
    browser.press(&[CTRL, SHIFT, "i"]);
    browser.choose(&ROBOT.map(|name| asset(&format!("characters/{name}"))));
    browser.wait("the robot is there", || {
        difference(&before, &browser.picture(), VIEW) > 0.01
    });
    // It was added to what was there, as one step.
    browser.press(&[CTRL, "z"]);
    let list = (SIZE.0 - 270, 60, SIZE.0, SIZE.1);
    assert!(difference(&before, &browser.picture(), list) < 0.001);
    browser.finish();
}

#[test]
fn a_picture_that_is_dropped_is_compared_with_and_another_one_takes_its_place() {
    let browser = Browser::open();
    browser.press(&[F12]);
    browser.picture();
    browser.press(&[ENTER]);
    let shown = browser.downloaded("showcase.png");
    let folder = tempfile::tempdir().unwrap();
    let [same, white] = ["same.png", "white.png"].map(|name| folder.path().join(name));
    fs::write(&same, &shown).unwrap();
    let size = image::load_from_memory(&shown).unwrap().into_rgb8();
    let size = size.dimensions();
    image::RgbImage::from_pixel(size.0, size.1, image::Rgb([255; 3]))
        .save(&white)
        .unwrap();

    let before = browser.picture();
    browser.drop_files(&[same]);
    browser.wait("the pictures are compared", || jobs(&browser) >= 2);
    let equal = browser.picture();
    assert!(difference(&before, &equal, VIEW) > 0.05);
    let done = jobs(&browser);
    browser.drop_files(&[white]);
    browser.wait("the other one is compared", || jobs(&browser) >= done + 2);
    let other = browser.picture();
    assert!(difference(&equal, &other, VIEW) > 0.1);
    browser.press(&[ESC]);
    assert!(difference(&before, &browser.picture(), VIEW) < 0.001);
    browser.finish();
}
