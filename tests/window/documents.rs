//! Documents of the real window: saved, reopened, and kept through a kill.

use super::desktop::{Desktop, Program, session_folder, temporary_folder};
use super::home_with_character;
use std::path::Path;

#[test]
fn a_program_that_is_ended_says_what_it_could_not_keep() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    std::fs::write(home.path().join(".config"), "no folder").expect("a file in its place");
    let (status, told) = with_a_cube(&desktop, home.path()).terminate();
    assert!(status.success(), "{status}: {told}");
    assert!(told.contains("unsaved work could not be kept"), "{told}");
}

#[test]
fn a_program_that_is_ended_keeps_what_does_not_fit_at_home_in_a_spare_folder() {
    let desktop = Desktop::start();
    for spare in [session_folder, temporary_folder] {
        let home = tempfile::tempdir().expect("a folder");
        let spare = spare(home.path());
        keeps_in_spare_folder(&desktop, home.path(), &spare);
    }
}

fn keeps_in_spare_folder(desktop: &Desktop, home: &Path, spare: &Path) {
    let config = home.join(".config");
    std::fs::write(&config, "no folder").expect("a file in its place");
    let (status, told) = with_a_cube(desktop, home).terminate();
    assert!(status.success(), "{status}: {told}");
    let told_place = format!("unsaved work is in {}", spare.display());
    assert!(told.contains(&told_place), "{told}");

    // There is room again.
    std::fs::remove_file(&config).expect("the file");
    let mut program = Program::start(desktop, home, &[]);
    program.keys(&["Return"]);
    title_is(&mut program, "*robot — Editor");
    let (status, told) = program.terminate();
    assert!(status.success() && told.is_empty(), "{status}: {told}");
    let kept = autosave(home).expect("unsaved work");
    assert!(kept.contains("cube"), "{kept}");
}

/// The program with work that is not saved.
fn with_a_cube<'a>(desktop: &'a Desktop, home: &Path) -> Program<'a> {
    let program = Program::start(desktop, home, &["builtin:robot"]);
    let before = program.picture();
    program.keys(&["shift+c"]);
    assert!(program.picture() != before, "no cube was inserted");
    program
}

fn title_is(program: &mut Program, expected: &str) {
    program.wait_for(expected, |program| {
        (program.title() == expected).then_some(())
    });
}

/// What is kept of unsaved work, if anything.
fn autosave(home: &Path) -> Option<String> {
    let kept = home.join(".config/skeleton-editor/autosave-0.json");
    std::fs::read_to_string(kept).ok()
}

#[test]
fn unsaved_work_outlives_a_kill_is_restored_saved_and_opened_again() {
    let desktop = Desktop::start();
    let home = tempfile::tempdir().expect("a folder");
    let models = home_with_character(home.path());
    let mut program = Program::start(&desktop, home.path(), &[]);
    program.keys(&["shift+c"]);
    title_is(&mut program, "*Untitled — Editor");
    program.wait_for("an autosave", |_| autosave(home.path()));
    program.kill();

    let mut program = Program::start(&desktop, home.path(), &[]);
    assert_eq!(program.title(), "Editor");
    // Restore is the first answer.
    program.keys(&["Return"]);
    title_is(&mut program, "*Untitled — Editor");
    program.keys(&["ctrl+s", "Return"]);
    title_is(&mut program, "scene.scene — Editor");
    let saved = models.join("scene.scene");
    let text = std::fs::read_to_string(&saved).expect("a saved scene");
    assert!(text.contains("\"kind\": \"cube\""), "{text}");
    program.wait_for("the autosave to go", |_| {
        autosave(home.path()).is_none().then_some(())
    });

    program.keys(&["shift+s"]);
    title_is(&mut program, "*scene.scene — Editor");
    let (status, told) = program.terminate();
    assert!(status.success(), "{status}: {told}");
    assert!(
        autosave(home.path()).is_some(),
        "a signal keeps unsaved work"
    );
    assert_eq!(std::fs::read_to_string(&saved).expect("it is there"), text);

    let path = saved.to_str().expect("a path");
    let mut program = Program::start(&desktop, home.path(), &[path]);
    // Discard is the other answer.
    program.keys(&["Tab", "Tab", "space"]);
    title_is(&mut program, "scene.scene — Editor");
    program.keys(&["ctrl+q"]);
    assert!(program.end().0.success());
}
