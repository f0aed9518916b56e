//! Files in the user's hands: chosen, dropped, saved, and opened again.

use super::browser::{Browser, CTRL, ENTER, F12, SHIFT, VIEW};
use super::picture::{assert_not_blank, difference};
use std::path::{Path, PathBuf};

/// A file of `assets`.
pub fn asset(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../assets")
        .join(name);
    path.canonicalize().unwrap()
}

#[test]
fn a_character_is_opened_from_files_that_are_chosen_together() {
    let browser = Browser::open();
    let before = browser.picture();
    browser.press(&[CTRL, "o"]);
    let files = ["robot.obj", "robot.skel", "robot.attach"];
    browser.choose(&files.map(|name| asset(&format!("characters/{name}"))));
    browser.wait("the figure is read", || {
        difference(&before, &browser.picture(), VIEW) > 0.05
    });
    browser.finish();
}

#[test]
fn models_that_are_chosen_together_are_all_there() {
    let browser = Browser::open();
    browser.press(&[CTRL, "o"]);
    let files = [
        "robot.obj",
        "robot.skel",
        "robot.attach",
        "dog.obj",
        "dog.skel",
        "dog.attach",
    ];
    browser.choose(&files.map(|name| asset(&format!("characters/{name}"))));
    browser.picture();
    browser.press(&[CTRL, "s"]);
    let saved = ["robot.scene", "dog.scene"].map(|name| browser.downloads().join(name));
    browser.wait("the scene is saved", || {
        saved.iter().any(|path| path.is_file())
    });
    let saved = saved
        .iter()
        .find_map(|path| std::fs::read_to_string(path).ok());
    let saved = saved.unwrap();
    assert!(
        saved.contains("robot.obj") && saved.contains("dog.obj"),
        "{saved}"
    );
    browser.finish();
}

#[test]
fn a_file_that_is_dropped_is_added_to_the_scene() {
    let browser = Browser::open();
    let before = browser.picture();
    browser.script(
        "const files = new DataTransfer();
         const cube = 'v -1 0 -1\\nv 3 0 -1\\nv 3 2 3\\nv -1 2 3\\nf 1 2 3\\nf 1 3 4\\nf 3 2 1\\n';
         files.items.add(new File([cube], 'cloth.obj'));
         const at = {dataTransfer: files, clientX: 500, clientY: 300, bubbles: true, cancelable: true};
         document.getElementById('editor').dispatchEvent(new DragEvent('drop', at));",
    );
    browser.wait("the cube is read", || {
        difference(&before, &browser.picture(), VIEW) > 0.01
    });
    browser.finish();
}

#[test]
fn files_that_are_called_the_same_do_not_take_each_other_s_place() {
    let browser = Browser::open();
    // A page that nobody has touched does not ask before it is left.
    browser.click(500, 200);
    for (name, x, color) in [("left", -2, "1 0 0"), ("right", 1, "0 0 1")] {
        let before = browser.picture();
        browser.script(&format!(
            "const files = new DataTransfer();
             const sheet = 'mtllib colors.mtl\\nv {x} 0 2\\nv {} 0 2\\nv {} 2 2\\nusemtl sheet\\nf 1 2 3\\n';
             files.items.add(new File([sheet], '{name}.obj'));
             files.items.add(new File(['newmtl sheet\\nKd {color}\\n'], 'colors.mtl'));
             const at = {{dataTransfer: files, clientX: 500, clientY: 300, bubbles: true, cancelable: true}};
             document.getElementById('editor').dispatchEvent(new DragEvent('drop', at));",
            x + 1,
            x + 1,
        ));
        browser.wait("the sheet is read", || {
            difference(&before, &browser.picture(), VIEW) > 0.01
        });
    }
    let before = browser.picture();
    browser.go("");
    browser.press(&[ENTER]);
    let after = browser.picture();
    let off = difference(&before, &after, VIEW);
    assert!(off < 0.002, "{off}: both have their own color again");
    browser.finish();
}

#[test]
fn a_folder_that_is_dropped_is_read_with_all_that_is_in_it() {
    let browser = Browser::open();
    let before = browser.picture();
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("figure/parts");
    std::fs::create_dir_all(&inner).unwrap();
    for extension in ["obj", "skel", "attach"] {
        let name = format!("robot.{extension}");
        std::fs::copy(asset(&format!("characters/{name}")), inner.join(name)).unwrap();
    }
    browser.drop_files(&[folder.path().join("figure")]);
    browser.wait("the figure is read", || {
        difference(&before, &browser.picture(), VIEW) > 0.01
    });
    browser.finish();
}

#[test]
fn an_export_does_not_take_the_name_of_a_model_that_was_given() {
    let browser = Browser::open();
    browser.press(&[CTRL, "o"]);
    let files = ["robot.obj", "robot.skel", "robot.attach"];
    browser.choose(&files.map(|name| asset(&format!("characters/{name}"))));
    browser.picture();
    browser.press(&[CTRL, SHIFT, "e"]);
    let exported = browser.downloaded("robot-posed.obj");
    assert!(String::from_utf8(exported).unwrap().contains("\nv "));
    browser.finish();
}

#[test]
fn a_screenshot_is_a_download() {
    let browser = Browser::open();
    browser.press(&[F12]);
    browser.press(&[ENTER]);
    let bytes = browser.downloaded("showcase.png");
    let picture = image::load_from_memory(&bytes).unwrap().into_rgb8();
    let (width, height) = picture.dimensions();
    assert!(width > 800 && height > 600, "{width}×{height}");
    assert_not_blank(&picture, VIEW);
    browser.finish();
}

#[test]
fn a_saved_scene_is_a_download_and_can_be_opened_again() {
    let browser = Browser::open();
    browser.press(&[CTRL, "s"]);
    let saved = browser.downloaded("showcase.scene");
    assert!(
        String::from_utf8(saved.clone())
            .unwrap()
            .contains("\"shapes\"")
    );
    browser.wait("the title names the file", || {
        let title = browser.script("return document.title");
        title.as_str().unwrap().starts_with("showcase.scene")
    });
    let before = browser.picture();
    let file = tempfile::Builder::new()
        .suffix(".scene")
        .tempfile()
        .unwrap();
    std::fs::write(file.path(), saved).unwrap();
    browser.go("");
    browser.press(&[CTRL, "o"]);
    browser.choose(&[file.path().to_owned()]);
    let name = file.path().file_name().unwrap().to_string_lossy();
    browser.wait("the title names the opened file", || {
        let title = browser.script("return document.title");
        title.as_str().unwrap().starts_with(&*name)
    });
    // Nothing is selected in a scene that was opened, so the outlines are gone.
    assert!(difference(&before, &browser.picture(), VIEW) < 0.05);
    browser.finish();
}
