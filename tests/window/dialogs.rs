//! The file dialog: where it opens, what it writes, and what it asks before.

use crate::desktop::{Desktop, Program};
use crate::{home_with_character, places};
use std::path::Path;

/// Names of the `.json` files in a folder.
fn poses_in(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).expect("a folder").flatten();
    let names = files.map(|file| file.file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = names.filter(|name| name.ends_with(".json")).collect();
    names.sort();
    names
}

/// Presses keys, each once the one before has been shown.
fn press(program: &Program, keys: &[&str]) {
    for key in keys {
        program.picture();
        program.keys(&[key]);
    }
    program.picture();
}

#[test]
fn a_pose_is_written_to_the_last_folder_and_over_a_file_only_after_asking() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    let field = places::middle_of("builtin:robot", "Torso Y");
    program.drag("1", field, (field.0 + 60.0, field.1));
    let before = program.settled_picture();
    press(&program, &["ctrl+p", "Return"]);
    assert_eq!(poses_in(&models), ["Robot.json"]);
    assert!(program.settled_picture() != before, "nothing is told");
    let file = models.join("Robot.json");
    let pose = std::fs::read(&file).expect("a pose");
    let written: serde_json::Value = serde_json::from_slice(&pose).expect("JSON");
    let turned = written["joints"]["Torso"][1].as_f64().expect("an angle");
    assert!((20.0..90.0).contains(&turned), "{written}");

    // Without its extension the name is that of a file that is there.
    std::fs::write(&file, "mine").expect("another file");
    let kept = || std::fs::read(&file).expect("a file") == b"mine";
    press(&program, &["ctrl+p", "ctrl+a"]);
    program.write("Robot");
    press(&program, &["Return"]);
    assert!(kept(), "it is replaced without asking");
    press(&program, &["Return"]);
    assert!(kept(), "it is replaced without asking again");
    press(&program, &["Return"]);
    assert_eq!(std::fs::read(&file).expect("a pose"), pose);
    assert_eq!(poses_in(&models), ["Robot.json"]);

    // A name that no file has is not asked about.
    press(&program, &["ctrl+p", "ctrl+a"]);
    program.write("other");
    press(&program, &["Return"]);
    assert_eq!(poses_in(&models), ["Robot.json", "other.json"]);
}

#[test]
fn text_is_cut_and_pasted_in_the_name_of_a_file() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    press(&program, &["ctrl+p", "ctrl+a"]);
    program.write("up");
    press(
        &program,
        &["ctrl+a", "ctrl+x", "ctrl+v", "ctrl+v", "Return"],
    );
    assert_eq!(poses_in(&models), ["upup.json"]);
}

#[test]
fn a_path_is_typed_after_ctrl_l_and_its_folder_is_kept() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let other = home.path().join("other");
    std::fs::rename(&models, &other).expect("another folder");
    std::fs::create_dir(&models).expect("an empty folder");
    let program = Program::start(&desktop, home.path(), &[]);
    let empty = program.picture();
    press(&program, &["ctrl+shift+i", "ctrl+l"]);
    // Only one file of that name is a character.
    program.write(&other.join("robot").display().to_string());
    press(&program, &["Return"]);
    assert!(program.picture() != empty, "no character was imported");
    // What was imported is selected, and so has a pose to save where it came from.
    press(&program, &["ctrl+p", "Return"]);
    assert_eq!(poses_in(&other), ["Robot.json"]);
    assert!(poses_in(&models).is_empty());

    // Where a file is written, too; the name comes after the folder.
    press(&program, &["ctrl+p", "ctrl+l"]);
    program.write(&models.display().to_string());
    press(&program, &["Return"]);
    program.write("raised");
    press(&program, &["Return"]);
    assert_eq!(poses_in(&other), ["Robot.json"]);
    assert_eq!(poses_in(&models), ["raised.json"]);
    press(&program, &["ctrl+p", "ctrl+l"]);
    program.write(&models.join("lowered").display().to_string());
    press(&program, &["Return"]);
    assert_eq!(poses_in(&models), ["lowered.json", "raised.json"]);

    // A path that does not begin at the root begins in the folder that the dialog shows.
    press(&program, &["ctrl+p", "ctrl+l"]);
    program.write("../models/v1.bent");
    press(&program, &["Return"]);
    assert_eq!(
        poses_in(&models),
        ["lowered.json", "raised.json", "v1.bent.json"]
    );
    let preferences = home.path().join(".config/skeleton-editor/preferences.json");
    let preferences = std::fs::read(preferences).expect("kept preferences");
    let preferences: serde_json::Value = serde_json::from_slice(&preferences).expect("JSON");
    assert_eq!(
        preferences["last_folder"],
        serde_json::json!(models.display().to_string())
    );
}

#[test]
fn a_path_is_typed_at_once_where_a_name_would_be_searched_for() {
    let desktop = Desktop::start();
    for start in ["/", "~/", "../"] {
        let home = tempfile::tempdir().expect("a folder");
        let models = home_with_character(home.path());
        let other = home.path().join("other");
        std::fs::rename(&models, &other).expect("another folder");
        std::fs::create_dir(&models).expect("an empty folder");
        let program = Program::start(&desktop, home.path(), &[]);
        press(&program, &["ctrl+shift+i"]);
        program.write(&match start {
            "/" => other.join("robot.obj").display().to_string(),
            _ => format!("{start}other/robot.obj"),
        });
        press(&program, &["Return"]);
        // What was imported is selected, and so has a pose to save where it came from.
        press(&program, &["ctrl+p", "Return"]);
        assert_eq!(poses_in(&other), ["Robot.json"], "{start}");
        assert!(poses_in(&models).is_empty());
    }
    // Anything else is a search still, of which a dot may be the first letter.
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &[]);
    press(&program, &["ctrl+shift+i"]);
    program.write(".obj");
    press(&program, &["Return", "ctrl+p", "Return"]);
    assert_eq!(poses_in(&models), ["Robot.json"]);
}

#[test]
fn esc_closes_the_dialog_first_and_then_the_program() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    press(&program, &["ctrl+shift+i", "Escape"]);
    // Keys are the program's again.
    press(&program, &["ctrl+p", "Return"]);
    assert_eq!(poses_in(&models), ["Robot.json"]);
    // Once is enough, though the name of the file has the keyboard.
    press(&program, &["ctrl+p", "Escape", "ctrl+q"]);
    let (status, told) = program.end();
    assert!(status.success(), "{status}: {told}");
}

#[test]
fn the_dialog_and_its_fields_are_light_where_the_panels_are() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let preferences = serde_json::json!({
        "last_folder": models, "started_before": true, "theme": "Light"
    });
    let file = home.path().join(".config/skeleton-editor/preferences.json");
    std::fs::write(file, preferences.to_string()).expect("written preferences");
    let program = Program::start(&desktop, home.path(), &["builtin:robot"]);
    press(&program, &["ctrl+p"]);
    let colors = Program::colors(&program.picture(), 1280, 800);
    let dark = |x: std::ops::Range<usize>, y: std::ops::Range<usize>| {
        let all = y.flat_map(|y| x.clone().map(move |x| 1280 * y + x));
        let (dark, light): (Vec<_>, Vec<_>) =
            all.partition(|&at| colors[at].iter().all(|&c| c < 100));
        dark.len() as f32 / (dark.len() + light.len()) as f32
    };
    // The dialog of 640×440 is in the middle of the window, the name of the file at its bottom.
    let (dialog, field) = (dark(400..880, 190..610), dark(480..760, 560..590));
    assert!(dialog < 0.2 && field < 0.2, "{dialog} {field}");
    press(&program, &["Escape", "ctrl+o"]);
    // Above its folders are the path, which is typed now, and the search.
    press(&program, &["ctrl+l"]);
    let colors = Program::colors(&program.picture(), 1280, 800);
    let black = (190..300).flat_map(|y| (320..960).map(move |x| 1280 * y + x));
    let black = black.filter(|&at| colors[at].iter().all(|&c| c < 8));
    assert!(black.count() < 200, "a field is black");
}
