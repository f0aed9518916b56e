//! The real window under Xvfb, used as a person uses it.

mod desktop;
mod dialogs;
mod documents;
mod places;
mod window;
mod x_client;

use desktop::{Desktop, Program, command};
use std::path::{Path, PathBuf};

/// The middle of the view, in a window of 1280×800 with panels at its right.
const IN_VIEW: (f32, f32) = (400.0, 300.0);

/// Bytes of a picture's last 30 rows.
const STATUS_LINE: usize = 30 * 1280 * 4;

/// A user's folder with a character in it, where the file dialog starts.
fn home_with_character(folder: &Path) -> PathBuf {
    let models = folder.join("models");
    let config = folder.join(".config/skeleton-editor");
    std::fs::create_dir_all(&models).expect("a folder for models");
    std::fs::create_dir_all(&config).expect("a folder for preferences");
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/characters");
    for extension in ["obj", "skel", "attach"] {
        let name = format!("robot.{extension}");
        std::fs::copy(assets.join(&name), models.join(&name)).expect("a copied character");
    }
    // What some systems leave beside the real file; the dialog must not offer it.
    std::fs::write(models.join("._robot.obj"), b"Mac OS X").expect("a companion file");
    let preferences = serde_json::json!({ "last_folder": models, "started_before": true });
    std::fs::write(config.join("preferences.json"), preferences.to_string())
        .expect("written preferences");
    models
}

#[test]
fn a_character_is_imported_through_the_dialog_posed_by_a_slider_and_the_program_quits() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["--title", "My homework"]);
    assert_eq!(program.title(), "Editor — My homework");
    let empty = program.picture();

    program.keys(&["ctrl+shift+i"]);
    let dialog = program.picture();
    assert!(dialog != empty, "the dialog does not show");
    program.keys(&["Down", "Return"]);
    let imported = program.picture();
    assert!(
        imported != empty && imported != dialog,
        "no character was imported"
    );

    let field = places::middle_of("builtin:robot", "Torso Y");
    program.drag("1", field, (field.0 + 60.0, field.1));
    let posed = program.picture();
    assert!(posed != imported, "the slider does nothing");
    program.keys(&["ctrl+p"]);
    program.picture();
    program.keys(&["Return"]);
    program.picture();
    let pose = std::fs::read(models.join("Robot.json")).expect("a saved pose");
    let pose: serde_json::Value = serde_json::from_slice(&pose).expect("JSON");
    let turned = pose["joints"]["Torso"][1].as_f64().expect("an angle");
    assert!((20.0..90.0).contains(&turned), "{pose}");

    let (status, told) = program.terminate();
    assert!(status.success(), "{status}: {told}");
    let kept = home.path().join(".config/skeleton-editor/preferences.json");
    let kept = std::fs::read_to_string(kept).expect("kept preferences");
    assert!(
        kept.contains("models"),
        "the last folder is forgotten: {kept}"
    );
}

/// A scene with a camera of its own, so that it is known where its bones are seen.
const POSED: &str = "builtin:mannequin-5";

#[test]
fn a_bone_is_dragged_and_rolled_by_hand_and_its_pose_goes_over_the_clipboard() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    home_with_character(home.path());
    let mut program = Program::start(&desktop, home.path(), &[POSED]);
    let hand = places::end_of_bone(POSED, "Left forearm");
    let grip = (hand.0 - 2.0, hand.1 - 4.0);
    let far = (hand.0 + 60.0, hand.1 - 80.0);
    program.keys(&["b"]);
    let before = program.picture();
    program.drag("1", grip, far);
    let dragged = program.picture();
    assert!(dragged != before, "the drag does nothing");
    program.keys(&["Right", "Right"]);
    // On a busy machine a picture stands still before the last key is in it.
    let rolled = program.settled_picture();
    assert!(rolled != dragged, "the key does not roll");

    program.keys(&["ctrl+c", "alt+shift+r"]);
    let reset = program.picture();
    assert!(reset != rolled, "the pose is not reset");
    program.keys(&["ctrl+v"]);
    // Angles that went through text may be off by rounding.
    program.wait_for("the pasted pose", |program| {
        let pasted = program.picture();
        // The status line below may show how many pictures a second there are.
        let above = pasted.len().saturating_sub(STATUS_LINE);
        let bytes = pasted[..above].iter();
        let differ = |other: &[u8]| bytes.clone().zip(other).filter(|(a, b)| a != b).count();
        (differ(&rolled) * 10 < differ(&reset)).then_some(())
    });
    let (status, told) = program.terminate();
    assert!(status.success(), "{status}: {told}");
}

#[test]
fn the_mouse_moves_the_camera_and_the_window_stays_still_when_left_alone() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    let mut last = program.picture();
    let (x, y) = IN_VIEW;
    for (what, button) in [("pan", "1"), ("turn", "3")] {
        program.drag(button, (x, y), (x + 80.0, y + 30.0));
        let now = program.picture();
        assert!(now != last, "the {what} does nothing");
        last = now;
    }
    let before = program.processor_time();
    std::thread::sleep(std::time::Duration::from_secs(2));
    let spent = program.processor_time() - before;
    // In hundredths of a second: drawing all the time would take two hundred.
    assert!(
        spent < 20,
        "an idle window spent {spent} hundredths of a second"
    );

    // Without the status line, which may show how many pictures a second there are.
    let above = |picture: Vec<u8>| picture[..picture.len().saturating_sub(STATUS_LINE)].to_vec();
    let before = above(program.picture());
    program.keys(&["ctrl+v"]);
    let told = above(program.picture());
    assert!(told != before, "nothing says that nothing can be pasted");
    program.keys(&["Home", "F12"]);
    assert!(
        above(program.picture()) != told,
        "the screenshot's dialog does not show"
    );
    program.keys(&["Escape", "ctrl+q"]);
    let (status, told) = program.end();
    assert!(status.success(), "{status}: {told}");
}

#[test]
fn a_screenshot_with_panels_shows_the_window_without_the_dialogs_that_asked_for_it() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    let plain = program.picture();
    program.keys(&["F12"]);
    for button in ["With panels", "Save…"] {
        program.picture();
        program.click(places::middle_after(
            egui::Key::F12,
            "builtin:robot",
            button,
        ));
    }
    program.picture();
    program.keys(&["Return"]);
    program.picture();
    let saved = image::open(models.join("robot.png")).expect("a saved picture");
    let saved = saved.to_rgb8();
    let plain = Program::colors(&plain, saved.width(), saved.height());
    let differ = saved
        .pixels()
        .zip(&plain)
        .filter(|(a, b)| a.0 != **b)
        .count();
    // The pointer is elsewhere, so another button and status line show.
    assert!(differ * 50 < plain.len(), "{differ} pixels differ");

    program.keys(&["ctrl+q"]);
    let (status, told) = program.end();
    assert!(status.success(), "{status}: {told}");
}

#[test]
fn a_picture_of_the_same_scene_is_compared_and_not_a_pixel_differs() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let reference = models.join("reference.png");
    let rendered = command(home.path())
        .args(["render", "builtin:showcase", "-o"])
        .arg(&reference)
        .output()
        .expect("the program runs");
    assert!(rendered.status.success(), "{rendered:?}");

    let program = Program::start(&desktop, home.path(), &["builtin:showcase"]);
    let alone = program.picture();
    program.keys(&["F8"]);
    let dialog = program.settled_picture();
    assert!(dialog != alone, "the dialog does not show");
    program.keys(&["Down", "Return"]);
    // On a busy machine a picture stands still before the last key or click is in it.
    let compared = program.settled_picture();
    assert!(compared != dialog, "the comparison does not show");
    program.click(places::middle_of_comparing("builtin:showcase", "Save…"));
    program.settled_picture();
    program.keys(&["Return"]);
    program.settled_picture();
    let saved = image::open(models.join("showcase-comparison.png")).expect("a saved comparison");
    let saved = saved.to_rgba8();
    let part = |x: u32| image::imageops::crop_imm(&saved, x, 0, 800, 600).to_image();
    assert_eq!((saved.width() % 800, saved.height()), (16, 600));
    let (reference, live) = (part(0), part(808));
    assert!(
        reference == live,
        "the live view is not the rendered picture"
    );
    assert!(
        reference
            .pixels()
            .any(|pixel| pixel != reference.get_pixel(0, 0))
    );

    // Esc leaves the comparison first.
    program.keys(&["Escape"]);
    program.picture();
    program.keys(&["ctrl+q"]);
    let (status, told) = program.end();
    assert!(status.success(), "{status}: {told}");
}

#[test]
fn the_first_start_opens_the_showcase_and_later_ones_do_not() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let first = Program::start(&desktop, home.path(), &[]);
    let showcase = first.picture();
    first.keys(&["ctrl+q"]);
    assert!(first.end().0.success());
    let second = Program::start(&desktop, home.path(), &[]);
    assert!(second.picture() != showcase, "the showcase comes back");
    second.keys(&["ctrl+q"]);
    assert!(second.end().0.success());
}

#[test]
fn preferences_that_are_a_pipe_do_not_keep_the_window_from_opening() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let config = home.path().join(".config/skeleton-editor");
    std::fs::create_dir_all(&config).expect("a folder for preferences");
    let pipe = config.join("preferences.json");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo runs").success());
    let program = Program::start(&desktop, home.path(), &[]);
    program.keys(&["ctrl+q"]);
    assert!(program.end().0.success());
}

#[test]
fn a_file_that_cannot_be_opened_is_told_in_the_window_which_stays() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    home_with_character(home.path());
    let good = Program::start(&desktop, home.path(), &[]);
    let plain = good.picture();
    good.keys(&["ctrl+q"]);
    assert!(good.end().0.success());
    let program = Program::start(&desktop, home.path(), &["no/such/file.obj"]);
    assert!(program.picture() != plain, "no message shows");
    program.keys(&["ctrl+q"]);
    assert!(program.end().0.success());
}

#[test]
fn a_window_larger_than_the_driver_draws_ends_nothing_and_is_told() {
    let desktop = Desktop::of_size(17_000, 900);
    let home = tempfile::tempdir().expect("a folder");
    home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    let before = program.picture();
    program.resize(17_000, 500);
    program.picture();
    program.resize(1280, 800);
    let after = program.picture();
    assert!(
        after.len() == before.len() && after != before,
        "nothing is told"
    );
    program.keys(&["shift+c"]);
    assert!(program.picture() != after, "it does not draw any more");
    let (status, told) = program.terminate();
    assert!(status.success(), "{status}: {told}");
}

#[test]
fn without_a_display_the_program_says_what_to_do_and_exits_with_1() {
    let home = tempfile::tempdir().expect("a folder");
    let output = command(home.path()).output().expect("the program runs");
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.contains("editor render"), "{told}");
    assert!(!told.contains("panicked"), "{told}");
}
