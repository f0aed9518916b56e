//! Files that lie beside the page and are named in its address, with what they name in turn.

use super::browser::{Browser, SIZE, VIEW, page_folder};
use super::offline::copy;
use super::picture::difference;
use std::fs;
use std::thread;
use tempfile::TempDir;

/// The crate whose picture lies beside it, in a scene that lies elsewhere.
const SCENE: &str = r#"{
  "format": "editor-scene",
  "version": 1,
  "view": {
    "camera": { "target": [0, 0.5, 0], "radius": 4, "theta": 82, "phi": 8, "fovy": 40 },
    "look": "studio", "axis": false, "grid": true, "shading": "smooth"
  },
  "shapes": [{ "source": "SOURCE" }]
}"#;

/// A copy of the page beside which two scenes lie: one of the crate beside it, and one of the crate that
/// is built in.
fn site() -> (TempDir, Browser) {
    let folder = tempfile::tempdir().unwrap();
    copy(&page_folder(), folder.path());
    fs::create_dir(folder.path().join("scenes")).unwrap();
    for (name, source) in [
        ("near", "../assets/rigs/crate.dae"),
        ("builtin", "builtin:crate"),
    ] {
        let text = SCENE.replace("SOURCE", source);
        fs::write(folder.path().join(format!("scenes/{name}.scene")), text).unwrap();
    }
    let server = make_web::Server::new(folder.path(), 0).unwrap();
    let address = server.address();
    thread::spawn(move || make_web::serve(&server));
    (folder, Browser::at(address, SIZE, 1.0))
}

#[test]
fn a_scene_beside_the_page_comes_with_its_models_and_their_pictures() {
    let (_folder, browser) = site();
    browser.go("?open=scenes/builtin.scene");
    let builtin = browser.picture();
    browser.go("?open=scenes/near.scene");
    let near = browser.picture();
    assert!(difference(&builtin, &near, VIEW) < 0.001);
    browser.finish();
}

#[test]
fn a_model_beside_the_page_comes_with_its_picture() {
    let (_folder, browser) = site();
    browser.go("?open=builtin:crate");
    let builtin = browser.picture();
    browser.go("?open=assets/rigs/crate.dae");
    assert!(difference(&builtin, &browser.picture(), VIEW) < 0.001);
    browser.finish();
}

#[test]
fn a_tag_shows_nothing_in_place_of_files_that_are_not_there() {
    let browser = Browser::open();
    browser.go("?view&open=//elsewhere.invalid/a.scene");
    let empty = browser.picture();
    browser.go("?view");
    assert!(difference(&empty, &browser.picture(), VIEW) > 0.05);
    browser.finish();
}
