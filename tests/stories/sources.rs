//! The files that shapes came from: missing, found, changed by others, and taken along.

use super::{STRIP, Story};
use crate::host::MemoryHost;
use editor_core::editor::{Edit, Severity};
use editor_core::geometry::Picture;
use editor_core::io::image::{PictureFormat, encode};
use editor_core::program::{HostEvent, Purpose};
use editor_core::scene::ShapeKind;
use egui::{Key, Modifiers};
use glam::Vec3;
use std::path::{Path, PathBuf};

const CTRL: Modifiers = Modifiers::COMMAND;
const ALT: Modifiers = Modifiers::ALT;

/// A strip with a bent elbow that was moved and saved, as `work/bent.scene`.
fn with_saved_strip() -> Story {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Z", "90");
    story.type_into("Position X", "3");
    story.key_with(CTRL, Key::S);
    story.choose("work/bent.scene");
    story
}

/// Takes the files of the strip away, or to another folder.
fn move_strip(story: &mut Story, folder: Option<&str>) {
    for (path, _) in STRIP {
        let bytes = story.host.files.remove(Path::new(path)).expect("a file");
        if let Some(folder) = folder {
            let name = Path::new(path).file_name().expect("a name");
            story.host.files.insert(Path::new(folder).join(name), bytes);
        }
    }
}

/// Files of a machine that has these and nothing else.
fn elsewhere(files: &[(&str, Vec<u8>)]) -> Story {
    let files = files
        .iter()
        .map(|(path, bytes)| (PathBuf::from(path), bytes.clone()));
    let host = MemoryHost {
        files: files.collect(),
        stored: [super::started_before()].into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, &[]);
    for (path, _) in STRIP {
        story.host.files.remove(Path::new(path));
    }
    story
}

fn file(story: &Story, path: &str) -> Vec<u8> {
    story.host.files[Path::new(path)].clone()
}

fn open(story: &mut Story, path: &str) {
    story.key_with(CTRL, Key::O);
    story.choose(path);
}

fn is_bent(story: &Story) -> bool {
    (story.degrees("Elbow").z - 90.0).abs() < 1e-4
        && story.shape().placement.transform.position == Vec3::X * 3.0
}

#[test]
fn a_file_that_is_missing_is_named_shown_as_a_box_and_kept_by_the_next_save() {
    let mut story = with_saved_strip();
    let saved = file(&story, "work/bent.scene");
    move_strip(&mut story, None);
    story.key_with(CTRL, Key::N);
    open(&mut story, "work/bent.scene");
    assert_eq!(story.names(), ["Strip"]);
    assert!(matches!(story.shape().kind, ShapeKind::Missing(_)));
    let (severity, text) = *story.messages().last().unwrap();
    assert_eq!(severity, Severity::Warning);
    assert!(
        text.contains("strip.obj") && text.contains("there is no such file"),
        "{text}"
    );
    story.type_into("Position X", "4");
    story.key_with(CTRL, Key::S);
    let text = String::from_utf8(file(&story, "work/bent.scene")).unwrap();
    let before = String::from_utf8(saved).unwrap();
    let other = before
        .lines()
        .zip(text.lines())
        .filter(|(was, is)| was != is);
    let other: Vec<(&str, &str)> = other.collect();
    assert_eq!(other.len(), 1, "the position alone: {other:?}");
}

#[test]
fn a_picture_that_a_model_lacked_is_put_on_it_when_it_comes_and_another_one_is_compared() {
    let red = Picture {
        width: 2,
        height: 2,
        rgba: [255, 0, 0, 255].repeat(4),
    };
    let red = encode(&red, PictureFormat::Png).unwrap();
    let sheet =
        "mtllib sheet.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl sheet\nf 1/1 2/1 3/1\n";
    let material = "newmtl sheet\nKd 1 1 1\nmap_Kd wood.png\n";
    let mut story = elsewhere(&[
        ("models/sheet.obj", sheet.into()),
        ("models/sheet.mtl", material.into()),
    ]);
    story.host.drop_file("models/sheet.obj");
    story.settle();
    let has_picture = |story: &Story| {
        let evaluated = story.session().evaluated();
        let mesh = &evaluated.shapes[0].geometry.mesh;
        mesh.groups
            .iter()
            .any(|group| group.material.texture.is_some())
    };
    assert!(!has_picture(&story));
    let misses = |story: &Story| {
        let fresh = story.session().messages.fresh();
        fresh
            .iter()
            .any(|told| told.text.contains("wood.png") && told.severity == Severity::Warning)
    };
    assert!(misses(&story));
    for path in ["models/wood.png", "models/other.png"] {
        story.host.files.insert(PathBuf::from(path), red.clone());
    }
    story.host.drop_file("models/wood.png");
    story.settle();
    assert!(has_picture(&story));
    assert!(
        !story.has("Stop comparing"),
        "it is no picture to compare with"
    );
    assert!(!misses(&story), "what it lacked is not said any more");
    story.key_with(CTRL, Key::Z);
    assert!(!has_picture(&story), "it is a step");
    story.key_with(CTRL, Key::R);
    assert!(has_picture(&story) && !misses(&story));
    story.key_with(CTRL, Key::Z);
    // Chosen as if it were a model, it is put on as well.
    story.key_with(CTRL, Key::I);
    story.choose("models/wood.png");
    assert!(has_picture(&story));
    assert_eq!(story.names(), ["Sheet"]);
    // One that is on the model already, and one that belongs to none.
    for path in ["models/wood.png", "models/other.png"] {
        story.host.drop_file(path);
        story.settle();
        assert!(story.has("Stop comparing"), "{path}");
        story.key(Key::Escape);
    }
}

#[test]
fn a_missing_file_is_found_elsewhere_with_pose_and_place() {
    let mut story = with_saved_strip();
    move_strip(&mut story, Some("moved"));
    story.key_with(CTRL, Key::N);
    open(&mut story, "work/bent.scene");
    story.click("Find…");
    let request = story.host.requests.last().unwrap();
    assert!(matches!(request.purpose, Purpose::FindSource(_)));
    story.choose("moved/strip.obj");
    assert!(is_bent(&story));
    let source = story.shape().source.as_ref().expect("a source");
    assert_eq!(source.file, "moved/strip.obj");
    story.key_with(CTRL, Key::Z);
    assert!(
        matches!(story.shape().kind, ShapeKind::Missing(_)),
        "it is a step"
    );
}

#[test]
fn one_that_is_found_brings_the_others_that_lie_beside_it() {
    let mut story = Story::start(&["models/strip.obj", "models/strip.obj"]);
    story.key_with(CTRL, Key::S);
    story.choose("work/two.scene");
    move_strip(&mut story, Some("moved"));
    story.key_with(CTRL, Key::N);
    open(&mut story, "work/two.scene");
    story.click("Find…");
    story.choose("moved/strip.obj");
    let shapes = story.session().scene().shapes();
    assert_eq!(shapes.len(), 2);
    let found = shapes
        .iter()
        .all(|shape| matches!(shape.kind, ShapeKind::Character(_)));
    assert!(found, "{shapes:?}");
    assert_eq!(story.session().done_steps(), 1, "all of them together");
}

#[test]
fn a_model_that_another_program_changes_is_noticed_and_reloaded_with_pose_and_place() {
    let mut story = with_saved_strip();
    let watched = story.host.watched.clone();
    for path in ["models/strip.obj", "models/strip.skel", "work/bent.scene"] {
        assert!(watched.contains(&PathBuf::from(path)), "{watched:?}");
    }
    let told = story.messages().len();
    let same = HostEvent::Changed("models/strip.obj".into());
    story.host.events.push_back(same);
    story.settle();
    assert_eq!(
        story.messages().len(),
        told,
        "it was written with the same content"
    );

    // The upper edge is higher now.
    let higher = STRIP[0].1.replace("v 0.2 2 0", "v 0.2 5 0");
    story
        .host
        .files
        .insert("models/strip.obj".into(), higher.into());
    let changed = HostEvent::Changed("models/strip.obj".into());
    story.host.events.push_back(changed);
    story.settle();
    let text = "strip.obj was changed by another program. \
                File ⏵ Reload Models reads it again; poses and places stay";
    assert_eq!(*story.messages().last().unwrap(), (Severity::Warning, text));
    let corner = |story: &Story| {
        let shape = story.session().evaluated().shape(story.shape().id).unwrap();
        shape.geometry.positions()[4]
    };
    assert!((corner(&story).x + 1.0).abs() < 1e-5);
    story.key_with(CTRL, Key::R);
    assert!((corner(&story).x + 4.0).abs() < 1e-5, "{}", corner(&story));
    assert!(is_bent(&story));
    story.key_with(CTRL, Key::R);
    let text = "No model has changed since it was read";
    assert_eq!(*story.messages().last().unwrap(), (Severity::Info, text));
    story.key_with(CTRL, Key::Z);
    assert!((corner(&story).x + 1.0).abs() < 1e-5, "it is a step");
}

#[test]
fn poses_of_joints_that_a_model_lacks_now_are_kept_until_it_has_them_again() {
    let mut story = with_saved_strip();
    story.key_with(CTRL, Key::K);
    story.key_with(CTRL, Key::S);
    let skel = file(&story, "models/strip.skel");
    let renamed = String::from_utf8(skel.clone()).unwrap();
    let renamed = renamed.replace("Elbow", "Knee");
    story
        .host
        .files
        .insert("models/strip.skel".into(), renamed.into_bytes());
    story.key_with(CTRL, Key::R);
    story.type_into("Position X", "4");
    story.key_with(CTRL, Key::S);
    let text = String::from_utf8(file(&story, "work/bent.scene")).unwrap();
    assert_eq!(
        text.matches("\"Elbow\": [0, 0, 90]").count(),
        2,
        "the pose and the kept one: {text}"
    );

    story.key_with(CTRL, Key::N);
    open(&mut story, "work/bent.scene");
    assert_eq!(story.degrees("Knee"), Vec3::ZERO);
    story.type_into("Position X", "3");
    story.key_with(CTRL, Key::S);
    story.host.files.insert("models/strip.skel".into(), skel);
    story.key_with(CTRL, Key::R);
    assert!(is_bent(&story));
    assert!(!story.character().poses()[0].pose.is_bind());
}

#[test]
fn what_is_saved_of_joints_that_are_gone_goes_by_reset_unpin_and_replacing_a_kept_pose() {
    let mut story = with_saved_strip();
    story.key_with(CTRL, Key::K);
    let strip = story.session().scene().shapes()[0].id;
    let mut ik = story.character().ik.clone();
    ik.pins = [2].into();
    story
        .program
        .session_mut()
        .edit(Edit::SetIk(strip, ik))
        .unwrap();
    story.key_with(CTRL, Key::S);
    let skel = String::from_utf8(file(&story, "models/strip.skel")).unwrap();
    let renamed = skel.replace("Elbow", "Knee").into_bytes();
    story.host.files.insert("models/strip.skel".into(), renamed);
    story.key_with(CTRL, Key::R);
    let elbows = |story: &mut Story| {
        story.key_with(CTRL, Key::S);
        let text = String::from_utf8(file(story, "work/bent.scene")).unwrap();
        text.matches("Elbow").count()
    };
    story.type_into("Position X", "4");
    assert_eq!(elbows(&mut story), 3, "the pose, the kept one, the pin");
    assert!(story.character().pose().is_bind());

    story.click("Reset all");
    let step = story.session().steps().last();
    assert_eq!(step, Some("Reset the pose of Strip"));
    assert_eq!(elbows(&mut story), 2);
    story.key_with(ALT, Key::P);
    assert_eq!(elbows(&mut story), 1);
    let name = story.character().poses()[0].name.clone();
    let keep = Edit::KeepPose { shape: strip, name };
    story.program.session_mut().edit(keep).unwrap();
    assert_eq!(elbows(&mut story), 0);
    for left in [1, 2, 3] {
        story.key_with(CTRL, Key::Z);
        assert_eq!(elbows(&mut story), left, "Undo brings it back");
    }
}

#[test]
fn a_model_that_is_broken_now_stays_as_it_was() {
    let mut story = with_saved_strip();
    let broken = b"v 0 0 0\nf 1 2 3\n".to_vec();
    story.host.files.insert("models/strip.obj".into(), broken);
    story.key_with(CTRL, Key::R);
    let (severity, text) = *story.messages().last().unwrap();
    assert_eq!(severity, Severity::Error);
    assert!(text.starts_with("models/strip.obj:2:5: expected"), "{text}");
    assert!(
        text.ends_with(". What came from it stays as it was"),
        "{text}"
    );
    assert!(is_bent(&story));
}

#[test]
fn a_document_that_another_window_changes_is_noticed_and_opened_as_it_is_now() {
    let mut story = with_saved_strip();
    let told = story.messages().len();
    story
        .host
        .events
        .push_back(HostEvent::Changed("work/bent.scene".into()));
    story.settle();
    assert_eq!(story.messages().len(), told, "it was this window");
    let text = String::from_utf8(file(&story, "work/bent.scene")).unwrap();
    let theirs = text.replace("\"name\": \"Strip\"", "\"name\": \"Theirs\"");
    assert_ne!(theirs, text);
    story
        .host
        .files
        .insert("work/bent.scene".into(), theirs.into());
    story
        .host
        .events
        .push_back(HostEvent::Changed("work/bent.scene".into()));
    story.settle();
    let text = "bent.scene was changed by another program. \
                File ⏵ Revert opens it as it is now";
    assert_eq!(*story.messages().last().unwrap(), (Severity::Warning, text));
    assert_eq!(story.names(), ["Strip"], "nothing happens by itself");
    story.click("File");
    story.click("Revert");
    assert_eq!(story.names(), ["Theirs"]);
}

#[test]
fn an_archive_with_all_files_opens_where_nothing_else_is() {
    let mut story = with_saved_strip();
    story.click("File");
    story.click("Save with Files…");
    let request = story.host.requests.last().unwrap();
    assert_eq!(
        (request.purpose, &*request.name),
        (Purpose::SaveWithFiles, "bent.zip")
    );
    story.choose("out/bent.zip");
    assert_eq!(
        story.messages().last(),
        Some(&(Severity::Info, "Saved out/bent.zip"))
    );
    let archive = file(&story, "out/bent.zip");
    let mut other = elsewhere(&[("mail/bent.zip", archive)]);
    open(&mut other, "mail/bent.zip");
    assert!(is_bent(&other));
    assert!(other.messages().is_empty(), "{:?}", other.messages());
}

#[test]
fn saving_with_files_replaces_no_model_that_the_document_has_from_there() {
    let mut story = with_saved_strip();
    story.click("File");
    story.click("Save with Files…");
    story.choose("out/taken.scene");
    open(&mut story, "out/taken.scene");
    let before = story.host.files.clone();
    // Another model of the same name takes the place of the first among the files.
    let taller = STRIP[0].1.replace("0.2 2 0", "0.2 3 0");
    story.host.files.insert(STRIP[0].0.into(), taller.into());
    story.host.drop_file(STRIP[0].0);
    story.settle();
    story.click("File");
    story.click("Save with Files…");
    story.choose("out/taken.scene");
    for (path, bytes) in before.iter().filter(|(path, _)| path.starts_with("out")) {
        assert_eq!(&story.host.files[path], bytes, "{}", path.display());
    }
    let told = story.messages().last().unwrap().1;
    assert!(told.starts_with("Not saved: out/taken.scene: "), "{told}");
}

#[test]
fn after_saving_with_files_over_its_own_file_the_document_uses_those_files() {
    let mut story = with_saved_strip();
    story.click("File");
    story.click("Save with Files…");
    story.choose("work/bent.scene");
    assert_eq!(story.host.title, "bent.scene — Editor");
    story.type_into("Elbow Z", "10");
    story.key_with(CTRL, Key::S);
    let scene = file(&story, "work/bent.scene");
    let scene = String::from_utf8(scene).unwrap();
    assert!(scene.contains("bent files/models/strip.obj"), "{scene}");
    let before = story.session().steps().len();
    story.key_with(CTRL, Key::Z);
    story.key_with(CTRL, Key::Z);
    assert_eq!(
        story.session().steps().nth(before - 2),
        Some("Relink Strip")
    );
    story.key_with(CTRL, Key::S);
    let scene = String::from_utf8(file(&story, "work/bent.scene")).unwrap();
    assert!(!scene.contains("bent files"), "{scene}");
}

#[test]
fn an_untitled_document_that_is_saved_with_files_is_saved() {
    for name in ["out/a.scene", "out/a.zip"] {
        let mut story = Story::start(&["models/strip.obj"]);
        story.type_into("Elbow Z", "10");
        story.click("File");
        story.click("Save with Files…");
        story.choose(name);
        story.key_with(CTRL, Key::Q);
        assert!(story.host.quits, "{name}");
    }
}

#[test]
fn an_archive_that_is_saved_over_itself_keeps_what_undoing_brings_back() {
    let mut story = with_saved_strip();
    story.click("File");
    story.click("Save with Files…");
    story.choose("out/bent.zip");
    let archive = file(&story, "out/bent.zip");
    let mut other = elsewhere(&[("mail/bent.zip", archive)]);
    open(&mut other, "mail/bent.zip");
    other.key(Key::Delete);
    other.click("File");
    other.click("Save with Files…");
    other.choose("mail/bent.zip");
    other.key_with(CTRL, Key::Z);
    other.key_with(CTRL | Modifiers::SHIFT, Key::S);
    other.choose("mail/mine.scene");
    let told = other.messages();
    let warnings = told
        .iter()
        .filter(|(severity, _)| *severity != Severity::Info);
    let warnings: Vec<&str> = warnings.map(|(_, text)| *text).collect();
    let needs = "mine.scene needs mail/bent.zip, where its models are: \
                 File ⏵ Save with Files… keeps everything together";
    assert_eq!(warnings, [needs]);
    open(&mut other, "mail/mine.scene");
    assert!(is_bent(&other));
}

#[test]
fn an_archive_is_a_document_that_save_writes_again() {
    let mut story = with_saved_strip();
    story.click("File");
    story.click("Save with Files…");
    story.choose("out/bent.zip");
    assert_eq!(story.host.title, "bent.scene — Editor", "it is a copy");
    let archive = file(&story, "out/bent.zip");
    let mut other = elsewhere(&[("mail/bent.zip", archive.clone())]);
    open(&mut other, "mail/bent.zip");
    assert_eq!(other.host.title, "bent.zip — Editor");
    other.type_into("Elbow Z", "77");
    assert_eq!(other.host.title, "*bent.zip — Editor");
    other.key_with(CTRL, Key::S);
    assert_eq!(other.host.title, "bent.zip — Editor");
    assert!(
        other
            .messages()
            .iter()
            .all(|(severity, _)| *severity == Severity::Info)
    );
    assert_eq!(file(&other, "mail/bent.zip~"), archive);
    let saved = file(&other, "mail/bent.zip");
    let mut third = elsewhere(&[("usb/bent.zip", saved)]);
    open(&mut third, "usb/bent.zip");
    assert!((third.degrees("Elbow").z - 77.0).abs() < 1e-3);

    // What another program has written is not overwritten without a question.
    other.type_into("Elbow Z", "66");
    other
        .host
        .files
        .insert("mail/bent.zip".into(), archive.clone());
    other.key_with(CTRL, Key::S);
    assert!(other.has("Overwrite"));
    assert_eq!(file(&other, "mail/bent.zip"), archive);
    other.click("Overwrite");
    assert_ne!(file(&other, "mail/bent.zip"), archive);
    assert_eq!(other.host.title, "bent.zip — Editor");
}

#[test]
fn a_model_that_undoing_brings_back_is_not_replaced_by_an_export() {
    let mut story = with_saved_strip();
    story.key(Key::Delete);
    story.key_with(Modifiers::SHIFT, Key::C);
    let before = file(&story, STRIP[0].0);
    story.click("File");
    story.click("Export Geometry…");
    story.choose(STRIP[0].0);
    assert_eq!(file(&story, STRIP[0].0), before);
    let told = story.messages().last().unwrap().1;
    assert!(told.starts_with("Not saved: models/strip.obj"), "{told}");
}

#[test]
fn a_scene_with_a_folder_opens_where_nothing_else_is() {
    let mut story = with_saved_strip();
    story.click("File");
    story.click("Save with Files…");
    story.choose("out/taken.scene");
    let taken: Vec<(String, Vec<u8>)> = story
        .host
        .files
        .iter()
        .filter_map(|(path, bytes)| {
            let path = path.to_str()?.strip_prefix("out/")?;
            Some((format!("usb/{path}"), bytes.clone()))
        })
        .collect();
    assert_eq!(taken.len(), 4, "a scene and three files");
    let taken: Vec<(&str, Vec<u8>)> = taken.iter().map(|(p, b)| (&**p, b.clone())).collect();
    let mut other = elsewhere(&taken);
    open(&mut other, "usb/taken.scene");
    assert!(is_bent(&other));
    assert_eq!(other.host.title, "taken.scene — Editor");
}

#[test]
fn an_archive_that_is_replaced_stays_beside_and_its_name_is_offered() {
    let mut story = with_saved_strip();
    story.click("File");
    story.click("Save with Files…");
    story.choose("out/bent.zip");
    let archive = file(&story, "out/bent.zip");
    let mut other = elsewhere(&[("mail/bent.zip", archive.clone())]);
    open(&mut other, "mail/bent.zip");
    other.key_with(CTRL | Modifiers::SHIFT, Key::S);
    assert_eq!(other.host.requests.last().unwrap().name, "bent.scene");
    other.key(Key::Delete);
    other.click("File");
    other.click("Save with Files…");
    other.choose("mail/bent.zip");
    assert_ne!(file(&other, "mail/bent.zip"), archive);
    assert_eq!(
        file(&other, "mail/bent.zip~"),
        archive,
        "the models are not lost"
    );
}

#[test]
fn going_back_to_a_scene_whose_model_is_gone_leaves_what_is_there() {
    let mut story = with_saved_strip();
    move_strip(&mut story, None);
    story
        .host
        .events
        .push_back(HostEvent::Changed("models/strip.obj".into()));
    story.settle();
    let text = "strip.obj is gone: another program has moved or deleted it. \
                Shapes stay as they are";
    assert_eq!(*story.messages().last().unwrap(), (Severity::Warning, text));
    story.click("File");
    story.click("Revert");
    assert!(is_bent(&story));
    let (severity, text) = *story.messages().last().unwrap();
    assert!(
        severity == Severity::Error && text.contains("strip.obj"),
        "{text}"
    );
    story.key_with(CTRL, Key::R);
    let text = "models/strip.obj: there is no such file. What came from it stays as it was";
    assert_eq!(*story.messages().last().unwrap(), (Severity::Error, text));
}

#[test]
fn a_folder_whose_name_is_no_unicode_keeps_the_names_of_models_beside_its_scene() {
    use std::os::unix::ffi::OsStrExt;
    let folder = Path::new(std::ffi::OsStr::from_bytes(b"bad\xff dir"));
    let mut story = Story::start(&[]);
    for (path, text) in STRIP {
        let name = Path::new(path).file_name().unwrap();
        story.host.files.insert(folder.join(name), text.into());
    }
    let scene = br#"{"format": "editor-scene", "version": 1, "shapes": [{"source": "strip.obj"}]}"#;
    story
        .host
        .files
        .insert(folder.join("a.scene"), scene.to_vec());
    story.host.events.push_back(HostEvent::Dropped {
        path: folder.join("a.scene"),
        files: editor_core::program::Host::files(&story.host),
    });
    story.settle();
    story.type_into("Elbow Z", "10");
    story.key_with(CTRL, Key::S);
    let saved = String::from_utf8(story.host.files[&folder.join("a.scene")].clone()).unwrap();
    assert!(saved.contains("\"strip.obj\""), "{saved}");
}

#[test]
fn a_missing_model_that_is_dropped_takes_the_place_of_its_box() {
    let scene = br#"{"format": "editor-scene", "version": 1, "shapes": [
        {"source": "old/strip.obj"}, {"source": "old/flag.obj"}]}"#;
    let mut story = Story::start(&[]);
    story.host.files.insert("a.scene".into(), scene.to_vec());
    open(&mut story, "a.scene");
    let is_missing = |story: &Story| -> Vec<bool> {
        let shapes = story.session().scene().shapes().iter();
        shapes
            .map(|shape| matches!(shape.kind, ShapeKind::Missing(_)))
            .collect()
    };
    assert_eq!(is_missing(&story), [true, true]);
    let flag = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec();
    story.host.files.insert("models/flag.obj".into(), flag);
    for path in ["models/strip.obj", "models/strip.skel", "models/flag.obj"] {
        story.host.drop_file(path);
    }
    story.settle();
    assert_eq!(is_missing(&story), [false, false], "and nothing is added");
    let told = (Severity::Info, "strip.obj is where it was missing");
    assert_eq!(story.messages().last(), Some(&told));
    // Once it is there, the same file is one more.
    story.host.drop_file("models/flag.obj");
    story.settle();
    assert_eq!(is_missing(&story), [false; 3]);
}
