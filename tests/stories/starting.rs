//! Starting, choosing how the program looks and works, and leaving.

use super::{Story, differing};
use crate::host::MemoryHost;
use editor_core::editor::Severity;
use editor_core::geometry::Picture;
use editor_core::io::image::{PictureFormat, encode};
use editor_core::program::{FrameInput, Options, StorageKey};
use editor_core::scene::{Look, Skinning, ViewDirection};
use editor_core::ui::Navigation;
use egui::{Key, Modifiers, RawInput};
use std::path::Path;

fn preferences(story: &Story) -> serde_json::Value {
    let stored = &story.host.stored[&StorageKey::Preferences];
    serde_json::from_slice(stored).expect("preferences are JSON")
}

#[test]
fn the_first_start_shows_the_showcase_with_help_and_later_ones_an_empty_scene() {
    let first = Story::start_at(MemoryHost::default(), &[]);
    assert_eq!(first.host.title, "showcase — Editor");
    assert_eq!(first.names(), ["Robot", "Dog", "Plant", "Adult"]);
    assert_eq!(first.session().view().look, Look::Studio);
    assert!(first.has("Close help"));
    assert_eq!(preferences(&first)["started_before"], true);

    let again = MemoryHost {
        stored: first.host.stored.clone(),
        ..MemoryHost::default()
    };
    let second = Story::start_at(again, &[]);
    assert!(second.names().is_empty());
    assert!(!second.has("Close help"));
    assert!(differing(&first.picture(), &second.picture()) > 10_000);
}

#[test]
fn files_that_are_named_at_the_start_are_opened_and_faults_are_messages() {
    let options = Options {
        title: Some("Editor — Ann".into()),
        ..Options::default()
    };
    let files = ["models/strip.obj", "no/such.obj", "builtin:gem"];
    let story = Story::start_with(MemoryHost::default(), options, &files);
    assert_eq!(story.host.title, "strip — Editor — Ann");
    assert_eq!(story.names(), ["Strip", "Gem"]);
    let missing = (Severity::Error, "no/such.obj: there is no such file");
    assert_eq!(story.messages(), [missing]);
}

/// Places of the shapes along x.
fn places(story: &Story) -> Vec<f32> {
    let shapes = story.session().scene().shapes().iter();
    shapes
        .map(|shape| shape.placement.transform.position.x)
        .collect()
}

#[test]
fn figures_that_the_program_starts_with_stand_beside_each_other_and_name_the_document() {
    let story = Story::start(&["builtin:robot", "builtin:robot", "builtin:adult"]);
    assert_eq!(story.names(), ["Robot", "Robot", "Adult"]);
    let places = places(&story);
    assert!(places[0] == 0.0 && places[1].abs() > 0.4, "{places:?}");
    assert!(places[2] != 0.0 && places[2] != places[1], "{places:?}");
    assert_eq!(story.host.title, "robot — Editor");
    assert!(!story.program.is_modified());
    assert_eq!(story.session().done_steps(), 0, "nothing to take back");
}

#[test]
fn a_curve_at_the_start_stands_beside_a_figure_that_was_named_before_it() {
    let story = Story::start(&["builtin:robot", "builtin:vase"]);
    let places = places(&story);
    assert!(places[0] == 0.0 && places[1].abs() > 0.4, "{places:?}");
}

#[test]
fn figures_that_a_picture_is_compared_with_at_the_start_stay_where_their_files_have_them() {
    let picture = Picture {
        width: 8,
        height: 6,
        rgba: [26, 26, 26, 255].repeat(48),
    };
    let host = MemoryHost {
        files: [(
            "a.png".into(),
            encode(&picture, PictureFormat::Png).unwrap(),
        )]
        .into(),
        stored: [super::started_before()].into(),
        ..MemoryHost::default()
    };
    let story = Story::start_at(host, &["builtin:robot", "builtin:robot", "a.png"]);
    assert_eq!(places(&story), [0.0, 0.0]);
}

#[test]
fn what_is_chosen_is_there_at_the_next_start() {
    let mut story = Story::start(&["builtin:gem"]);
    for (menu, submenu, item) in [
        ("View", "Theme", "Light"),
        ("View", "Navigation", "Blender"),
        ("View", "Skinning", "Processor"),
    ] {
        story.click(menu);
        story.click(submenu);
        story.click(item);
    }
    let kept = preferences(&story);
    assert_eq!(kept["theme"], "Light");
    assert_eq!(kept["navigation"], "blender");
    assert_eq!(kept["skinning"], "cpu");

    let again = MemoryHost {
        stored: story.host.stored.clone(),
        ..MemoryHost::default()
    };
    let mut next = Story::start_at(again, &[]);
    let state = next.program.ui_mut();
    assert_eq!(state.theme, egui::ThemePreference::Light);
    assert_eq!(state.navigation, Navigation::Blender);
    assert_eq!(state.skinning, Some(Skinning::Cpu));
    assert_eq!(preferences(&next), kept, "nothing is forgotten by starting");
}

#[test]
fn a_character_is_opened_by_any_of_its_three_files() {
    for file in [
        "models/strip.obj",
        "models/strip.skel",
        "models/strip.attach",
    ] {
        let story = Story::start(&[file]);
        assert_eq!(story.names(), ["Strip"], "{file}");
        assert!(story.messages().is_empty(), "{:?}", story.messages());
        let source = story.shape().source.as_ref().expect("a source");
        assert!(source.file.ends_with("strip.obj"), "{}", source.file);
        let known = serde_json::json!(["models/strip.obj"]);
        assert_eq!(preferences(&story)["recent"], known, "as one file");
    }
}

#[test]
fn what_is_chosen_in_two_windows_at_once_is_there_at_the_next_start() {
    let choose = |story: &mut Story, submenu: &str, item: &str| {
        story.click("View");
        story.click(submenu);
        story.click(item);
    };
    let mut one = Story::start(&[]);
    let mut other = Story::start(&[]);
    choose(&mut one, "Theme", "Light");
    open(&mut one, "work/one.scene");
    other.host.stored.clone_from(&one.host.stored);
    choose(&mut other, "Navigation", "Blender");
    open(&mut other, "work/other.scene");

    let kept = preferences(&other);
    assert_eq!([&kept["theme"], &kept["navigation"]], ["Light", "blender"]);
    let both = ["work/other.scene", "work/one.scene"];
    assert_eq!(kept["recent"], serde_json::json!(both));
    other.click("File");
    other.click("Open Recent");
    assert!(
        other.has("one.scene"),
        "the other window's document is listed"
    );

    // What a window did not choose itself stays as it was chosen elsewhere later.
    choose(&mut one, "Theme", "Dark");
    other.key(Key::Escape);
    other.host.stored.clone_from(&one.host.stored);
    choose(&mut other, "Navigation", "Orbit");
    assert_eq!(preferences(&other)["theme"], "Dark");
}

/// Opens an empty scene.
fn open(story: &mut Story, path: &str) {
    let scene = br#"{"format": "editor-scene", "version": 1, "shapes": []}"#;
    story.host.files.insert(path.into(), scene.to_vec());
    story.key_with(Modifiers::COMMAND, Key::O);
    story.choose(path);
}

#[test]
fn skinning_asked_for_at_the_start_comes_before_what_was_chosen_earlier() {
    let stored = br#"{"started_before": true, "skinning": "gpu"}"#.to_vec();
    let host = MemoryHost {
        stored: [(StorageKey::Preferences, stored)].into(),
        ..MemoryHost::default()
    };
    let options = Options {
        skinning: Some(Skinning::Cpu),
        ..Options::default()
    };
    let mut story = Story::start_with(host, options, &[]);
    assert_eq!(story.program.ui_mut().skinning, Some(Skinning::Cpu));
    assert_eq!(preferences(&story)["skinning"], "gpu");
}

#[test]
fn dialogs_open_where_a_file_was_chosen_last_at_the_next_start_too() {
    let mut story = Story::start(&[]);
    story.key_with(Modifiers::COMMAND, Key::I);
    assert_eq!(story.host.requests.last().unwrap().folder, None);
    story.choose("models/strip.obj");
    let again = MemoryHost {
        stored: story.host.stored.clone(),
        ..MemoryHost::default()
    };
    let mut next = Story::start_at(again, &[]);
    next.click("Discard");
    next.key(Key::F8);
    let request = next.host.requests.last().unwrap();
    assert_eq!(request.folder.as_deref(), Some(Path::new("models")));
}

#[test]
fn skinning_asked_for_at_the_start_is_for_that_time_only() {
    let options = Options {
        skinning: Some(Skinning::Cpu),
        ..Options::default()
    };
    let mut story = Story::start_with(MemoryHost::default(), options, &["models/strip.obj"]);
    assert_eq!(preferences(&story)["skinning"], serde_json::Value::Null);
    let mut skinning = |name: &str| {
        for label in ["View", "Skinning", name] {
            story.click(label);
        }
        preferences(&story)["skinning"].clone()
    };
    assert_eq!(skinning("Graphics Card"), "gpu");
    // Back to what it was asked to be for this time.
    assert_eq!(skinning("Processor"), serde_json::Value::Null);
}

#[test]
fn views_and_fit_move_the_camera_and_leave_the_document_alone() {
    let mut story = Story::start(&["models/strip.obj"]);
    let document = story.session().document();
    story.key_with(Modifiers::COMMAND, Key::Num3);
    let camera = story.session().view().camera;
    let preset = editor_core::scene::Camera::preset(ViewDirection::MinusX);
    assert_eq!(camera, preset);
    assert!(camera.eye().x < -4.0, "seen from -X: {}", camera.eye());
    story.key(Key::F);
    let fitted = story.session().view().camera;
    // The strip stands on the origin and is 2 high.
    assert!(fitted.target.abs_diff_eq(glam::Vec3::Y, 1e-4), "{fitted:?}");
    assert_eq!(story.session().document(), document);
}

#[test]
fn esc_ends_the_program_where_nothing_else_is_to_end() {
    let mut story = Story::start(&[]);
    story.key(Key::F12);
    assert!(story.has("Save…"), "the dialog shows");
    story.key(Key::Escape);
    assert!(!story.has("Save…") && !story.host.quits);
    story.key(Key::Escape);
    assert!(!story.host.quits, "once too often, within a second");
    story.wait(1.1);
    story.key(Key::Escape);
    assert!(!story.host.quits);
    assert_eq!(
        story.messages().last().unwrap().1,
        "Esc again ends the program"
    );
    story.wait(5.0);
    story.press_escape();
    assert!(!story.host.quits, "the first press is long ago");
    for _ in 0..5 {
        story.wait(0.2);
        story.press_escape();
        assert!(
            !story.host.quits,
            "who presses it so fast has not read the notice"
        );
    }
    story.wait(0.6);
    story.press_escape();
    assert!(story.host.quits);
}

#[test]
fn the_question_about_unsaved_work_takes_the_place_of_the_notice_about_esc() {
    let mut story = Story::start(&[]);
    story.key_with(Modifiers::SHIFT, Key::C);
    story.key(Key::Escape);
    story.wait(1.1);
    let told = |story: &Story| {
        let mut fresh = story.session().messages.fresh().iter();
        fresh.any(|message| message.text == "Esc again ends the program")
    };
    story.press_escape();
    assert!(told(&story));
    story.wait(0.6);
    story.press_escape();
    assert!(story.has("Don't Save"), "the question");
    assert!(!told(&story) && !story.host.quits);
}

#[test]
fn tab_leads_from_the_answer_that_enter_gives_to_the_next_one() {
    for (tabs, saves) in [(0, true), (1, false)] {
        let mut story = Story::start(&[]);
        story.key_with(Modifiers::SHIFT, Key::C);
        story.key_with(Modifiers::COMMAND, Key::N);
        for _ in 0..tabs {
            story.key(Key::Tab);
        }
        story.key(Key::Enter);
        assert!(!story.has("Don't Save"), "the question is answered");
        assert_eq!(!story.host.requests.is_empty(), saves);
        assert_eq!(story.names().is_empty(), !saves);
    }
}

#[test]
fn nothing_is_drawn_and_nothing_waits_while_nothing_changes() {
    let mut story = Story::start(&["models/strip.obj"]);
    let before = story.scene_picture();
    let wait = story.frame(Vec::new());
    assert!(wait.as_secs() > 1_000, "{wait:?}");
    assert!(story.host.jobs.is_empty() && story.host.events.is_empty());
    assert_eq!(differing(&before, &story.scene_picture()), 0);
}

#[test]
fn keys_belong_to_the_dialog_of_the_host_while_it_is_open() {
    let mut story = Story::start(&["models/strip.obj"]);
    let start = story.session().view().camera;
    for (is_open, direction) in [(true, None), (false, Some(ViewDirection::MinusX))] {
        story.host.dialog_is_open = is_open;
        story.key_with(Modifiers::COMMAND, Key::Num3);
        let expected = direction.map_or(start, editor_core::scene::Camera::preset);
        assert_eq!(story.session().view().camera, expected, "{is_open}");
    }
}

#[test]
fn a_window_too_large_to_be_drawn_is_one_message_however_its_size_changes() {
    let mut story = Story::start(&["models/strip.obj"]);
    // No driver draws a hundred thousand pixels in a row.
    for width in [100_000, 100_001, 100_002] {
        let input = FrameInput {
            context: story.context.clone(),
            raw: RawInput::default(),
            size: (width, 640),
        };
        story
            .program
            .frame(&mut story.graphics, input, &mut story.host)
            .expect("the program goes on");
    }
    let messages = story.messages();
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(messages[0].1.contains("100000"), "{messages:?}");
}

#[test]
fn an_empty_document_offers_what_to_begin_with() {
    let mut story = Story::start(&[]);
    story.click("Begin: Robot");
    assert_eq!(story.names(), ["Robot"]);
    assert!(
        !story.has("Begin: Robot"),
        "it is gone where there is something"
    );
    story.key_with(egui::Modifiers::COMMAND, Key::S);
    story.choose("work/robot.scene");
    story.key_with(egui::Modifiers::COMMAND, Key::N);
    story.click("Begin: robot.scene");
    assert_eq!(story.host.title, "robot.scene — Editor");
    story.key_with(egui::Modifiers::COMMAND, Key::N);
    story.click("Begin: Showcase");
    assert!(story.names().len() > 2);
}

#[test]
fn an_empty_scene_shows_pictures_of_what_can_be_begun_with() {
    let mut story = Story::start(&[]);
    let place = |story: &Story, label: &str| {
        let at = story.place(label);
        let picture = story.picture();
        // The upper half of a tile is the middle of its picture.
        let colors = (-16..16).map(|x| {
            let pixel = (at.y as usize - 10) * picture.width as usize;
            let first = 4 * (pixel + (at.x as i32 + x) as usize);
            picture.rgba[first..first + 3].to_vec()
        });
        let colors: std::collections::HashSet<_> = colors.collect();
        colors.len()
    };
    for label in ["Begin: Adult", "Begin: Robot", "Begin: Showcase"] {
        assert!(place(&story, label) > 8, "{label} has no picture");
    }
    story.click("Begin: Robot");
    assert_eq!(story.names(), ["Robot"]);
    assert!(!story.has("Begin: Adult"), "the page is gone");
}

#[test]
fn recent_documents_are_on_the_start_page() {
    let mut story = Story::start(&["builtin:gem"]);
    story.key_with(Modifiers::COMMAND, Key::S);
    story.choose("work/stone.scene");
    story.key_with(Modifiers::COMMAND, Key::N);
    assert!(story.names().is_empty());
    assert!(story.has_text("or drop a file here"));
    story.click("Begin: stone.scene");
    assert_eq!(story.names(), ["Gem"]);
    assert_eq!(story.host.title, "stone.scene — Editor");
}
