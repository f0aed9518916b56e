//! What the window hands on to the program, and what it does by itself.

use crate::desktop::{Desktop, Program, command};
use crate::x_client::XClient;
use crate::{home_with_character, places};

#[test]
fn a_dropped_pose_is_applied() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let file = home.path().join("sideways.json");
    std::fs::write(&file, r#"{"joints": {"Torso": [0, 0, 25]}}"#).expect("a pose");
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    XClient::connect(&desktop.display).drop(&file, &program.window);
    program.picture();
    program.keys(&["ctrl+p"]);
    program.picture();
    program.keys(&["Return"]);
    program.picture();
    let saved = std::fs::read(models.join("Robot.json")).expect("a saved pose");
    let saved: serde_json::Value = serde_json::from_slice(&saved).expect("JSON");
    assert_eq!(saved["joints"], serde_json::json!({"Torso": [0, 0, 25]}));
}

#[test]
fn the_close_button_ends_the_program() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    XClient::connect(&desktop.display).close(&program.window);
    let (status, told) = program.end();
    assert!(status.success(), "{status}: {told}");
}

#[test]
fn the_window_has_a_least_size() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &[]);
    let least = XClient::connect(&desktop.display).least_size(&program.window);
    assert_eq!(least, Some((420, 400)));
}

#[test]
fn without_opengl_3_3_the_program_says_so_and_exits_with_1() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let output = command(home.path())
        .env("DISPLAY", &desktop.display)
        .env("MESA_GL_VERSION_OVERRIDE", "2.1")
        .env("MESA_GLES_VERSION_OVERRIDE", "2.0")
        .output()
        .expect("the program runs");
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.contains("3.3 is needed"), "{told}");
    assert!(!told.contains("panicked"), "{told}");
}

#[test]
fn the_report_of_the_machine_names_the_driver_of_the_window_or_what_helps() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let doctor = |version: Option<&str>| {
        let mut command = command(home.path());
        command.env("DISPLAY", &desktop.display);
        command.envs(version.map(|version| ("MESA_GL_VERSION_OVERRIDE", version)));
        command.envs(version.map(|_| ("MESA_GLES_VERSION_OVERRIDE", "2.0")));
        let output = command.args(["doctor", "--json"]).output();
        let out = output.expect("the program runs").stdout;
        serde_json::from_slice::<serde_json::Value>(&out).expect("one object")
    };
    let report = doctor(None);
    assert_eq!(report["display"]["server"], "x11");
    assert_eq!(report["window"]["works"]["software"], true, "{report}");
    let report = doctor(Some("2.1"));
    assert_eq!(report["window"]["fails"]["kind"], "too-old", "{report}");
    let help = report["help"].to_string();
    assert!(help.contains("The window has no OpenGL 3.3"), "{help}");
}

#[test]
fn what_a_comparison_finds_comes_by_itself() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let reference = models.join("reference.png");
    let rendered = command(home.path())
        .args(["render", "builtin:robot", "--axis", "off", "-o"])
        .arg(&reference)
        .output()
        .expect("the program runs");
    assert!(rendered.status.success(), "{rendered:?}");
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    for key in ["F8", "Down", "Return"] {
        program.keys(&[key]);
        program.picture();
    }
    let colors = Program::colors(&program.settled_picture(), 1280, 800);
    // One is counted at once, the other once the view has stood still.
    for name in ["Differing pixels", "SSIM, FLIP"] {
        let (x, y) = places::middle_of_comparing("builtin:robot", name);
        let (x, y) = (x as usize, y as usize);
        let background = colors[1280 * (y - 8) + x];
        let rows = (y - 6..y + 6).map(|y| &colors[1280 * y + x + 60..1280 * y + x + 200]);
        let letters = rows.flatten().filter(|&&color| color != background);
        // Three dots have a few pixels, a number has a hundred.
        let count = letters.count();
        assert!(count > 60, "{name}: {count} pixels");
    }
}

#[test]
fn a_hint_comes_when_the_pointer_rests_on_a_button_without_anything_more() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    let before = Program::colors(&program.settled_picture(), 1280, 800);
    let (x, y) = places::middle_of("builtin:robot", "Move Tool");
    program.point((x, y));
    let after = Program::colors(&program.settled_picture(), 1280, 800);
    // The button itself changes under the pointer; the hint lies below it, over the scene.
    let rows = (y as usize + 24..y as usize + 60).map(|y| 1280 * y);
    let places = rows.flat_map(|row| row + x as usize..row + x as usize + 150);
    let count = places.filter(|&at| before[at] != after[at]).count();
    assert!(count > 500, "{count} pixels");
}
