//! Documents: begun, opened, saved, and never lost without a question.

use super::Story;
use crate::host::MemoryHost;
use editor_core::editor::{Severity, View};
use editor_core::program::{HostEvent, Purpose, StorageKey};
use editor_core::ui::{Action, MeshColors, Navigation};
use egui::{Key, Modifiers, vec2};
use std::path::Path;

const CTRL: Modifiers = Modifiers::COMMAND;

/// Whether the dialog asks about unsaved changes.
fn is_asked(story: &Story) -> bool {
    story.has("Don't Save")
}

fn title(story: &Story) -> &str {
    &story.host.title
}

/// A document with a cube in it that is saved nowhere.
fn with_unsaved_cube() -> Story {
    let mut story = Story::start(&[]);
    story.key_with(Modifiers::SHIFT, Key::C);
    assert_eq!(story.names(), ["Cube"]);
    story
}

/// A document with a cube, saved as `work/a.scene`.
fn with_saved_cube() -> Story {
    let mut story = with_unsaved_cube();
    story.key_with(CTRL, Key::S);
    story.choose("work/a.scene");
    assert_eq!(title(&story), "a.scene — Editor");
    story
}

fn file(story: &Story, path: &str) -> Vec<u8> {
    story.host.files[Path::new(path)].clone()
}

#[test]
fn a_digit_that_opens_a_scene_of_the_program_says_so_and_enter_after_it_keeps_the_document() {
    let mut story = with_saved_cube();
    story.program.ui_mut().set_navigation(Navigation::Mannequin);
    let saved = file(&story, "work/a.scene");
    story.key_with(CTRL, Key::D);
    story.key(Key::Num3);
    assert!(is_asked(&story));
    assert!(story.has_text(
        "“a.scene” has changes that are not saved. They are lost if you open Mannequin 3: Tentacle without saving."
    ));
    // As at the end of a number that was meant for a field.
    story.key(Key::Enter);
    assert!(!is_asked(&story));
    assert_eq!(title(&story), "*a.scene — Editor");
    assert_eq!(file(&story, "work/a.scene"), saved);

    story.key(Key::Num3);
    story.click("Don't Save");
    assert_eq!(title(&story), "mannequin-3 — Editor");
    story.key(Key::Num2);
    assert_eq!(title(&story), "mannequin-2 — Editor");
    let told = (
        Severity::Info,
        "Opened Mannequin 2: Chain in the place of mannequin-3",
    );
    assert_eq!(story.messages().last(), Some(&told));
}

#[test]
fn the_title_tells_the_document_and_whether_it_is_saved() {
    let mut story = Story::start(&["models/strip.obj"]);
    assert_eq!(
        title(&story),
        "strip — Editor",
        "files at the start are no change"
    );
    story.type_into("Elbow Z", "90");
    assert_eq!(title(&story), "*strip — Editor");
    story.key_with(CTRL, Key::Z);
    assert_eq!(
        title(&story),
        "strip — Editor",
        "taken back, it is as it was"
    );
    story.key_with(CTRL, Key::Y);

    story.key_with(CTRL, Key::S);
    let request = story.host.requests.last().unwrap();
    assert_eq!(request.purpose, Purpose::SaveScene);
    story.choose("work/bent.scene");
    assert_eq!(title(&story), "bent.scene — Editor");
    story.type_into("Elbow Z", "80");
    assert_eq!(title(&story), "*bent.scene — Editor");
    story.key_with(CTRL, Key::S);
    assert_eq!(title(&story), "bent.scene — Editor");
    assert_eq!(story.host.requests.len(), 1, "where to is known");
}

#[test]
fn what_was_saved_is_opened_again_and_the_version_before_is_kept() {
    let mut story = with_saved_cube();
    let first = file(&story, "work/a.scene");
    story.type_into("Position X", "2");
    story.key_with(CTRL, Key::S);
    assert_eq!(file(&story, "work/a.scene~"), first);
    let second = file(&story, "work/a.scene");
    assert_ne!(second, first);

    story.key_with(CTRL, Key::N);
    assert!(story.names().is_empty());
    assert_eq!(title(&story), "Editor");
    story.key_with(CTRL, Key::O);
    assert_eq!(story.host.requests.last().unwrap().purpose, Purpose::Open);
    story.choose("work/a.scene");
    assert_eq!(story.names(), ["Cube"]);
    let cube = &story.session().scene().shapes()[0];
    assert_eq!(cube.placement.transform.position.x, 2.0);
    assert_eq!(title(&story), "a.scene — Editor");
}

#[test]
fn what_is_hidden_is_not_selected_when_it_is_opened_and_x_deletes_none_of_it() {
    let mut story = Story::start(&["models/strip.obj"]);
    for key in [Key::C, Key::S] {
        story.key_with(Modifiers::SHIFT, key);
    }
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::H);
    story.key_with(CTRL, Key::S);
    story.choose("work/hidden.scene");
    story.key_with(CTRL, Key::N);
    story.key_with(CTRL, Key::O);
    story.choose("work/hidden.scene");
    assert_eq!(story.names(), ["Strip", "Cube", "Sphere"]);
    assert_eq!(story.shape().name, "Cube");
    // Of the list even one that is hidden can be chosen.
    let sphere = story.session().scene().shapes()[2].id;
    let select = |shape| vec![Action::View(View::Select(Some(shape)))];
    story.program.carry_out(select(sphere), &mut story.host);
    let middle = story.view().center();
    story.point(middle);
    story.key(Key::X);
    assert_eq!(story.names(), ["Strip", "Cube", "Sphere"]);
    let told = story.messages().last().unwrap().1.to_owned();
    assert!(
        told.starts_with("X deletes nothing that is hidden"),
        "{told}"
    );
    story.key(Key::A);
    story.key(Key::X);
    assert_eq!(story.names(), ["Sphere"]);
}

#[test]
fn everything_that_would_lose_unsaved_work_asks_first() {
    type Deed = fn(&mut Story);
    let deeds: [(&str, Deed); 6] = [
        ("New", |story| story.key_with(CTRL, Key::N)),
        ("Open", |story| story.key_with(CTRL, Key::O)),
        ("a built-in scene", |story| {
            story
                .program
                .ui_mut()
                .set_navigation(editor_core::ui::Navigation::Mannequin);
            story.key(Key::Num2);
        }),
        ("a dropped scene", |story| {
            story.host.drop_file("builtin:scenes/turned.scene");
            story.settle();
        }),
        ("closing the window", |story| {
            story.host.events.push_back(HostEvent::CloseRequested);
            story.settle();
        }),
        ("Esc", |story| {
            if story.session().selected().is_some() {
                story.key(Key::Escape);
                story.wait(2.0);
            }
            story.press_escape();
            story.wait(0.6);
            story.press_escape();
            story.settle();
        }),
    ];
    for (name, deed) in deeds {
        let mut story = with_unsaved_cube();
        deed(&mut story);
        assert!(is_asked(&story), "{name}");
        assert!(
            !story.host.quits && story.host.requests.is_empty(),
            "{name}"
        );
        story.click("Cancel");
        assert!(!is_asked(&story));
        assert_eq!(story.names(), ["Cube"], "{name}");
        story.wait(2.0);
        deed(&mut story);
        assert!(is_asked(&story), "{name}");
        story.key(Key::Escape);
        assert!(
            !is_asked(&story) && !story.host.quits,
            "{name}: Esc cancels"
        );
        assert_eq!(story.names(), ["Cube"], "{name}");
        story.wait(2.0);
        deed(&mut story);
        story.click("Don't Save");
        assert!(!is_asked(&story));
        let gone = story.names() != ["Cube"] || story.host.quits;
        assert!(gone || story.host.requests.len() == 1, "{name}");
    }
}

#[test]
fn save_in_the_question_saves_first_and_goes_on() {
    let mut story = with_unsaved_cube();
    story.host.events.push_back(HostEvent::CloseRequested);
    story.settle();
    // Enter gives the first answer.
    story.key(Key::Enter);
    assert!(!story.host.quits, "a file has to be chosen");
    story.choose("work/a.scene");
    assert!(story.host.quits);
    assert!(story.host.files.contains_key(Path::new("work/a.scene")));
}

#[test]
fn what_cannot_be_saved_is_said_and_nothing_is_lost() {
    let mut story = with_saved_cube();
    let saved = file(&story, "work/a.scene");
    story.type_into("Position X", "2");
    story.host.write_fault = Some("the disk is full".into());
    story.host.events.push_back(HostEvent::CloseRequested);
    story.settle();
    story.click("Save");
    assert!(!story.host.quits, "not without having saved");
    let last = *story.messages().last().unwrap();
    let expected = "Not saved: work/a.scene: the disk is full";
    assert_eq!(last, (Severity::Error, expected));
    assert_eq!(title(&story), "*a.scene — Editor");
    assert_eq!(file(&story, "work/a.scene"), saved);
}

#[test]
fn a_file_that_another_window_has_written_is_not_overwritten_without_a_question() {
    let mut story = with_saved_cube();
    let theirs = br#"{"format": "editor-scene", "version": 1}"#.to_vec();
    story
        .host
        .files
        .insert("work/a.scene".into(), theirs.clone());
    story.type_into("Position X", "2");
    story.key_with(CTRL, Key::S);
    assert!(story.has("Overwrite"));
    story.click("Cancel");
    assert_eq!(file(&story, "work/a.scene"), theirs);
    story.key_with(CTRL, Key::S);
    story.click("Overwrite");
    assert_ne!(file(&story, "work/a.scene"), theirs);
    assert_eq!(file(&story, "work/a.scene~"), theirs, "theirs is kept");
    story.type_into("Position X", "3");
    story.key_with(CTRL, Key::S);
    assert!(!story.has("Overwrite"), "this one is ours");
}

#[test]
fn a_file_that_is_gone_is_written_anew() {
    let mut story = with_saved_cube();
    story.host.files.remove(Path::new("work/a.scene"));
    story.type_into("Position X", "2");
    story.key_with(CTRL, Key::S);
    assert!(story.host.files.contains_key(Path::new("work/a.scene")));
    assert_eq!(title(&story), "a.scene — Editor");
}

/// The recent documents that the next start finds, newest first.
fn kept_recent(story: &Story) -> Vec<String> {
    let kept = &story.host.stored[&StorageKey::Preferences];
    let kept: serde_json::Value = serde_json::from_slice(kept).unwrap();
    serde_json::from_value(kept["recent"].clone()).unwrap()
}

#[test]
fn a_document_that_the_program_is_started_with_is_a_recent_one_even_if_it_is_killed() {
    let host = crate::host::MemoryHost {
        files: with_saved_cube().host.files,
        stored: [super::started_before()].into(),
        ..Default::default()
    };
    let story = Story::start_at(host, &["work/a.scene"]);
    assert_eq!(kept_recent(&story), ["work/a.scene"]);
}

#[test]
fn recent_documents_are_listed_the_newest_first_and_at_the_next_start_too() {
    let mut story = with_saved_cube();
    story.click("File");
    story.click("Save As…");
    story.choose("work/b.scene");
    story.key_with(CTRL, Key::N);
    story.click("File");
    story.click("Open Recent");
    story.click("a.scene");
    assert_eq!(title(&story), "a.scene — Editor");
    assert_eq!(kept_recent(&story), ["work/a.scene", "work/b.scene"]);

    // Named in another way it is the same file.
    story.click("File");
    story.click("Save As…");
    story.choose("other/../work/a.scene");
    let kept = ["other/../work/a.scene", "work/b.scene"];
    assert_eq!(kept_recent(&story), kept);
    story.click("File");
    story.click("Save As…");
    story.choose("work/a.scene");

    // One that is gone is said, and leaves the list.
    story.host.files.remove(Path::new("work/b.scene"));
    story.click("File");
    story.click("Open Recent");
    story.click("b.scene");
    assert_eq!(title(&story), "a.scene — Editor");
    let (severity, text) = *story.messages().last().unwrap();
    assert!(
        severity == Severity::Error && text.contains("b.scene"),
        "{text}"
    );
    assert_eq!(kept_recent(&story), ["work/a.scene"]);
}

#[test]
fn a_model_opened_is_a_new_document_with_its_name_and_without_a_file() {
    let mut story = with_saved_cube();
    story.key_with(CTRL, Key::O);
    story.choose("models/strip.obj");
    assert_eq!(story.names(), ["Strip"]);
    assert_eq!(title(&story), "strip — Editor");
    story.type_into("Elbow Z", "5");
    story.key_with(CTRL, Key::S);
    let request = story.host.requests.last().unwrap();
    assert_eq!(
        request.purpose,
        Purpose::SaveScene,
        "the model itself is not written to"
    );
}

#[test]
fn a_number_that_is_being_typed_is_saved_and_closing_asks_about_it() {
    let mut story = with_saved_cube();
    story.click("Position X");
    story.frame(vec![egui::Event::Text("2".into())]);
    story.key_with(CTRL, Key::S);
    let x = |story: &Story| story.shape().placement.transform.position.x;
    assert_eq!(x(&story), 2.0);
    assert_eq!(title(&story), "a.scene — Editor");
    let text = String::from_utf8(file(&story, "work/a.scene")).unwrap();
    assert!(text.contains("\"position\": [2, 0, 0]"), "{text}");

    story.click("Position X");
    story.frame(vec![egui::Event::Text("3".into())]);
    story.host.events.push_back(HostEvent::CloseRequested);
    story.settle();
    assert_eq!(x(&story), 3.0);
    assert!(is_asked(&story) && !story.host.quits);
    story.click("Cancel");

    story.click("Edit");
    story.click("Rename");
    story.frame(vec![egui::Event::Text("Box".into())]);
    story.host.events.push_back(HostEvent::CloseRequested);
    story.settle();
    assert_eq!(story.names(), ["Box"]);
    assert!(is_asked(&story));
}

#[test]
fn going_back_to_the_file_does_not_offer_to_overwrite_it() {
    let mut story = with_saved_cube();
    story.type_into("Position X", "2");
    story.click("File");
    story.click("Revert");
    assert!(!story.has("Save") && !story.has("Don't Save"));
    story.key(Key::Enter);
    assert_eq!(
        story.shape().placement.transform.position.x,
        2.0,
        "Enter changes nothing"
    );
    story.click("File");
    story.click("Revert");
    story.click("Go Back");
    assert_eq!(
        story.session().scene().shapes()[0]
            .placement
            .transform
            .position
            .x,
        0.0
    );
    assert_eq!(title(&story), "a.scene — Editor");
}

#[test]
fn changes_that_are_not_wanted_are_asked_about_once_and_again_if_nothing_was_opened() {
    let mut story = with_saved_cube();
    story.type_into("Position X", "5");
    story.key_with(CTRL, Key::O);
    story.click("Don't Save");
    story.choose("builtin:robot");
    assert!(!is_asked(&story));
    assert_eq!(story.names(), ["Robot"]);

    story.key_with(Modifiers::SHIFT, Key::C);
    story.key_with(CTRL, Key::O);
    story.click("Don't Save");
    // The dialog is closed without a choice.
    story.key_with(CTRL, Key::N);
    assert!(is_asked(&story), "the changes are still there");
}

#[test]
fn everything_that_was_cut_is_asked_about_and_what_was_never_there_is_not() {
    let mut story = Story::start(&[]);
    story.key_with(CTRL, Key::N);
    assert!(!is_asked(&story));
    story.key_with(Modifiers::SHIFT, Key::C);
    story.key_with(CTRL, Key::A);
    story.key_with(CTRL, Key::X);
    story.key_with(CTRL, Key::Q);
    assert!(is_asked(&story));
}

#[test]
fn a_document_whose_file_has_gone_is_not_saved_any_more_until_it_is_back() {
    let mut story = with_saved_cube();
    let path = Path::new("work/a.scene");
    let saved = story.host.files.remove(path).expect("the file");
    story
        .host
        .events
        .push_back(HostEvent::Changed(path.to_owned()));
    story.settle();
    assert!(title(&story).starts_with('*'), "{}", title(&story));
    story.host.files.insert(path.to_owned(), saved);
    story
        .host
        .events
        .push_back(HostEvent::Changed(path.to_owned()));
    story.settle();
    assert!(!title(&story).starts_with('*'), "{}", title(&story));
}

#[test]
fn the_version_before_survives_a_save_in_which_only_the_view_differs() {
    let mut story = with_saved_cube();
    story.type_into("Position X", "5");
    story.key_with(CTRL, Key::S);
    let before = file(&story, "work/a.scene~");
    story.key(Key::Num3);
    story.key_with(CTRL, Key::S);
    assert_eq!(file(&story, "work/a.scene~"), before);
}

#[test]
fn saving_with_files_over_the_documents_own_file_saves_it() {
    let mut story = with_saved_cube();
    story.type_into("Position X", "5");
    story.click("File");
    story.click("Save with Files…");
    story.choose("work/a.scene");
    assert!(!title(&story).starts_with('*'), "{}", title(&story));
    story.key_with(CTRL, Key::Z);
    assert!(title(&story).starts_with('*'), "{}", title(&story));
    story.key_with(CTRL, Key::S);
    assert!(!is_asked(&story), "nobody else has changed the file");
}

#[test]
fn ctrl_and_s_in_the_middle_of_a_drag_saves_when_it_has_ended() {
    let mut story = with_saved_cube();
    let before = file(&story, "work/a.scene");
    let field = story.place("Position X");
    story.press_and_drag(field, field + vec2(40.0, 0.0));
    story.key_with(CTRL, Key::S);
    assert_eq!(file(&story, "work/a.scene"), before);
    story.button(false);
    story.settle();
    assert_ne!(file(&story, "work/a.scene"), before);
    assert!(!title(&story).starts_with('*'), "{}", title(&story));

    story.program.ui_mut().set_navigation(Navigation::Blender);
    let view = story.view();
    story.point(view.center());
    story.key(Key::G);
    story.point(view.center() + vec2(50.0, 0.0));
    story.key_with(CTRL, Key::S);
    let saved = file(&story, "work/a.scene");
    let told = "It is saved once this movement has ended · Esc cancels the movement";
    assert!(story.has_text(told));
    story.key(Key::Enter);
    story.settle();
    assert_ne!(file(&story, "work/a.scene"), saved);
    assert!(!title(&story).starts_with('*'), "{}", title(&story));
}

#[test]
fn commands_about_documents_do_nothing_behind_the_file_dialog() {
    let mut story = with_unsaved_cube();
    let field = story.place("Position X");
    story.click_at(field);
    story.host.dialog_is_open = true;
    story.key_with(CTRL, Key::N);
    story.host.dialog_is_open = false;
    story.settle();
    assert!(!is_asked(&story));
    assert_eq!(story.names(), ["Cube"]);
}

#[test]
fn a_document_whose_file_another_program_has_replaced_is_asked_about() {
    let mut story = with_saved_cube();
    let path = Path::new("work/a.scene");
    story
        .host
        .files
        .insert(path.to_owned(), b"garbage".to_vec());
    story
        .host
        .events
        .push_back(HostEvent::Changed(path.to_owned()));
    story.settle();
    story.key_with(CTRL, Key::Q);
    assert!(is_asked(&story) && !story.host.quits);
}

#[test]
fn what_is_typed_in_the_frame_of_a_shortcut_is_taken_in_before_it() {
    let key = |key, modifiers| egui::Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    };
    let x = |story: &Story| story.shape().placement.transform.position.x;
    for enters in [true, false] {
        let mut story = with_saved_cube();
        let field = story.place("Position X");
        story.click_at(field);
        let enter = enters.then(|| key(Key::Enter, Modifiers::NONE));
        let typed = [egui::Event::Text("4".into()), egui::Event::Text("3".into())];
        let events = typed.into_iter().chain(enter);
        story.frame(events.chain([key(Key::S, CTRL)]).collect());
        story.settle();
        assert_eq!(x(&story), 43.0);
        let saved = String::from_utf8(file(&story, "work/a.scene")).unwrap();
        assert!(saved.contains("[43, 0, 0]"), "{saved}");
        assert!(!title(&story).starts_with('*'), "{}", title(&story));

        story.click_at(field);
        story.frame(vec![egui::Event::Text("7".into()), key(Key::Q, CTRL)]);
        story.settle();
        assert!(is_asked(&story) && !story.host.quits);
        assert_eq!(x(&story), 7.0);
    }
}

#[test]
fn a_scene_is_never_suggested_the_name_of_another_one() {
    let mut story = with_unsaved_cube();
    let other = b"{}".to_vec();
    story.host.files.insert("scene.scene".into(), other.clone());
    story.key_with(CTRL, Key::S);
    assert_eq!(story.host.requests.last().unwrap().name, "scene 2.scene");
    story.choose("scene 2.scene");
    assert_eq!(file(&story, "scene.scene"), other);
    story.key_with(CTRL | Modifiers::SHIFT, Key::S);
    assert_eq!(story.host.requests.last().unwrap().name, "scene 3.scene");
}

#[test]
fn save_as_begins_in_the_folder_of_the_document_and_not_in_that_of_another() {
    let mut story = with_saved_cube();
    story.click("File");
    story.click("Save with Files…");
    story.choose("elsewhere/b.zip");
    story.key_with(CTRL | Modifiers::SHIFT, Key::S);
    let request = story.host.requests.last().unwrap();
    assert_eq!(request.folder.as_deref(), Some(Path::new("work")));
    assert_eq!(request.name, "a 2.scene");
}

#[test]
fn what_another_window_has_saved_is_not_replaced_by_save_as_or_with_files_without_a_word() {
    let mut story = with_saved_cube();
    let theirs = br#"{"format": "editor-scene", "version": 1}"#.to_vec();
    let path = Path::new("work/a.scene");
    story.host.files.insert(path.to_owned(), theirs.clone());
    story.key_with(CTRL | Modifiers::SHIFT, Key::S);
    story.choose("work/../work/a.scene");
    assert!(story.has("Overwrite"));
    story.click("Cancel");
    story.click("File");
    story.click("Save with Files…");
    story.choose("work/a.scene");
    let told = story.messages().last().unwrap().1;
    assert!(
        told.contains("another program or window has changed it"),
        "{told}"
    );
    assert_eq!(file(&story, "work/a.scene"), theirs);
}

#[test]
fn a_document_is_saved_with_its_own_look_while_it_is_compared_in_another() {
    let mut story = with_saved_cube();
    let before = file(&story, "work/a.scene");
    let picture = story.picture();
    let png = editor_core::io::image::PictureFormat::Png;
    let bytes = editor_core::io::image::encode(&picture, png).unwrap();
    story.host.files.insert("a.png".into(), bytes);
    story.host.drop_file("a.png");
    story.settle();
    assert!(story.has("Stop comparing"));
    story.key_with(CTRL, Key::S);
    assert_eq!(file(&story, "work/a.scene"), before);
}

#[test]
fn a_second_click_on_discard_is_not_an_answer_to_the_next_question() {
    let mut story = with_unsaved_cube();
    story.wait(11.0);
    let kept = story.host.stored[&StorageKey::Autosave].clone();
    let host = MemoryHost {
        stored: story.host.stored.clone(),
        more: [kept].into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, &[]);
    let discard = story.place("Discard");
    story.point(discard);
    for pressed in [true, false, true, false] {
        story.button(pressed);
    }
    story.settle();
    assert!(
        story.has("Discard"),
        "the second run's work is still asked about"
    );
}

#[test]
fn ctrl_s_and_ctrl_z_work_while_a_color_is_chosen_and_end_the_choice() {
    let mut story = with_saved_cube();
    let before = story.shape().placement;
    story.type_into("Position X", "2");
    story.click("Custom color");
    assert_eq!(title(&story), "*a.scene — Editor");
    story.key_with(CTRL, Key::S);
    assert_eq!(title(&story), "a.scene — Editor", "it is saved");

    story.click("Custom color");
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.shape().placement, before);
    // The keys after it are commands again.
    story.key(Key::Delete);
    assert!(story.names().is_empty());
}

#[test]
fn messages_and_colors_of_a_document_go_with_it() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.host.drop_file("models/gone.obj");
    story.settle();
    assert_eq!(story.session().messages.fresh().len(), 1);
    story.program.ui_mut().colors = MeshColors::Weight;
    story.key_with(CTRL, Key::N);
    assert!(story.session().messages.fresh().is_empty());
    assert_eq!(
        story.session().messages.history().len(),
        1,
        "they are in the list"
    );
    assert_eq!(story.program.ui_mut().colors, MeshColors::default());
    story.host.drop_file("models/gone.obj");
    story.settle();
    assert_eq!(story.session().messages.fresh().len(), 1);
    story.program.ui_mut().colors = MeshColors::Weight;
    story.key_with(CTRL, Key::O);
    story.choose("models/strip.obj");
    assert!(story.session().messages.fresh().is_empty());
    assert_eq!(story.program.ui_mut().colors, MeshColors::default());
}
