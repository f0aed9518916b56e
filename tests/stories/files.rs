//! Files that are dropped, saved, exported and refused.

use super::{STRIP, Story};
use crate::host::MemoryHost;
use editor_core::editor::{Edit, Severity};
use editor_core::program::Purpose;
use editor_core::ui::{Action, Ask};
use egui::{Key, Modifiers};
use glam::Vec3;
use std::path::Path;

#[test]
fn geometry_is_exported_as_it_stands_with_the_vertices_in_the_order_of_the_file() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Z", "90");
    story.click("File");
    story.click("Export Geometry…");
    let request = story.host.requests.last().unwrap();
    assert_eq!(
        (request.purpose, &*request.name),
        (Purpose::ExportGeometry, "strip-posed.obj")
    );
    story.choose("out/scene.obj");
    let text = story.host.text("out/scene.obj");
    let vertices: Vec<Vec3> = text
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| {
            let numbers: Vec<f32> = line.split(' ').map(|n| n.parse().unwrap()).collect();
            Vec3::from_slice(&numbers)
        })
        .collect();
    assert_eq!(vertices.len(), 6);
    assert_eq!(vertices[0], Vec3::new(-0.2, 0.0, 0.0));
    assert!(vertices[4].abs_diff_eq(Vec3::new(-1.0, 1.2, 0.0), 1e-5));
    assert_eq!(
        text.lines().filter(|line| line.starts_with("f ")).count(),
        4
    );
    assert_eq!(story.messages(), [(Severity::Info, "Saved out/scene.obj")]);
}

#[test]
fn all_poses_of_a_file_with_several_are_kept_and_the_first_is_taken() {
    let mut story = Story::start(&["models/strip.obj"]);
    let several = br#"{"euler": "Rx Ry Rz", "poses": {
        "bent": {"2": {"name": "Elbow", "xyz_deg": [0, 0, 50]}},
        "back": {"2": {"name": "Elbow", "xyz_deg": [0, 0, -20]}}}}"#;
    story
        .host
        .files
        .insert("poses.json".into(), several.to_vec());
    let steps = story.session().steps().len();
    story.click("Pose");
    story.click("Load Pose…");
    story.choose("poses.json");
    assert!((story.degrees("Elbow").z - 50.0).abs() < 1e-4);
    let id = story.shape().id;
    let character = story.session().scene().character(id).unwrap();
    let kept: Vec<&str> = character.poses().iter().map(|kept| &*kept.name).collect();
    assert_eq!(kept, ["bent", "back"]);
    assert_eq!(story.session().steps().len(), steps + 1, "one step");
    let told = "poses.json has 2 poses (bent, back): they are in the list Poses of the panel, and the \
                character has bent now";
    assert_eq!(story.messages(), [(Severity::Info, told)]);
    story.click("Poses (2)");
    story.click("back");
    assert!((story.degrees("Elbow").z + 20.0).abs() < 1e-4);
}

#[test]
fn a_file_under_a_wrong_name_is_said_to_be_what_it_is() {
    let mut story = Story::start(&["models/strip.obj"]);
    let picture = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec();
    for (name, bytes) in [
        ("picture.obj", picture),
        ("packed.obj", b"PK\x03\x04\xff".to_vec()),
        ("notes.txt", b"notes".to_vec()),
        ("curve.swp", Vec::new()),
        ("kept.scene", Vec::new()),
    ] {
        story.host.files.insert(name.into(), bytes);
    }
    for (item, file, told) in [
        (
            "Import Shape…",
            "picture.obj",
            "picture.obj: expected text, found a PNG picture",
        ),
        (
            "Import Shape…",
            "packed.obj",
            "packed.obj: expected text, found a .zip archive",
        ),
        (
            "Import Character…",
            "notes.txt",
            "notes.txt: expected a character (.obj, .dae), found .txt",
        ),
        (
            "Import Shape…",
            "notes.txt",
            "notes.txt: expected a shape (.obj, .dae), found .txt",
        ),
        (
            "Import Character…",
            "curve.swp",
            "curve.swp: expected a character (.obj, .dae), found .swp, which Import Curve reads",
        ),
        (
            "Import Curve…",
            "models/strip.obj",
            "models/strip.obj: expected curves (.swp), found .obj, which Import Shape and Import Character read",
        ),
        (
            "Import Shape…",
            "kept.scene",
            "kept.scene: expected a shape (.obj, .dae), found .scene, which Open reads",
        ),
    ] {
        story.click("Insert");
        story.click("Import");
        story.click(item);
        story.choose(file);
        assert_eq!(story.messages().last(), Some(&(Severity::Error, told)));
    }
}

#[test]
fn the_selected_shapes_alone_are_exported_where_that_is_asked_for() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key_with(Modifiers::SHIFT, Key::C);
    for (item, title, names) in [
        (
            "Export Geometry…",
            "Export Geometry of All Shapes",
            &["o Strip", "o Cube"][..],
        ),
        (
            "Export Selected Geometry…",
            "Export Geometry of the Selected Shapes",
            &["o Cube"],
        ),
    ] {
        story.click("File");
        story.click(item);
        assert_eq!(story.host.requests.last().unwrap().purpose.title(), title);
        story.choose("out/some.obj");
        let text = story.host.text("out/some.obj");
        let written: Vec<&str> = text.lines().filter(|line| line.starts_with("o ")).collect();
        assert_eq!(written, names);
    }
}

#[test]
fn a_name_that_could_not_be_read_again_is_refused_and_so_is_a_full_disk() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.click("File");
    story.click("Export Geometry…");
    story.choose("scene.txt");
    story.click("Pose");
    story.click("Save Pose…");
    story.choose("walk.obj");
    story.click("File");
    story.click("Export Geometry…");
    story.host.write_fault = Some("the disk is full".into());
    story.choose("scene.obj");
    let expected = [
        "Not saved: scene.txt: expected a name that ends in .obj",
        "Not saved: walk.obj: expected a name that ends in .json",
        "Not saved: scene.obj: the disk is full",
    ];
    let found: Vec<&str> = story.messages().iter().map(|(_, text)| *text).collect();
    assert_eq!(found, expected);
    assert!(story.host.written.is_empty());
}

#[test]
fn a_dropped_file_is_an_import_a_pose_or_a_picture_to_compare_with() {
    let mut story = Story::start(&["models/strip.obj"]);
    let pose = br#"{"joints": {"Elbow": [0, 0, 50], "Tail": [1, 2, 3]}}"#;
    story.host.files.insert("bent.json".into(), pose.to_vec());
    story.host.drop_file("bent.json");
    story.settle();
    assert!(
        story
            .degrees("Elbow")
            .abs_diff_eq(Vec3::new(0.0, 0.0, 50.0), 1e-4)
    );
    let without = "bent.json: applied without Tail, which this character does not have";
    assert_eq!(story.messages(), [(Severity::Warning, without)]);

    story.key_with(Modifiers::ALT | Modifiers::SHIFT, Key::R);
    let same = story.host.files[Path::new("bent.json")].clone();
    story.host.files.insert("LOUD.JSON".into(), same);
    story.host.drop_file("LOUD.JSON");
    story.settle();
    assert!((story.degrees("Elbow").z - 50.0).abs() < 1e-4);

    story.host.drop_file("builtin:gem");
    story.settle();
    assert_eq!(story.names(), ["Strip", "Gem"]);
    assert_eq!(story.shape().name, "Gem");
    assert!(!story.has("Stop comparing"));
}

#[test]
fn a_scene_is_exported_with_its_materials_and_never_over_the_files_it_comes_from() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.click("File");
    story.click("Export with Materials…");
    let proposed = &story.host.requests.last().unwrap().name;
    assert_eq!(proposed, "strip-posed.obj", "it may be written");
    story.choose("out/mine.obj");
    let text = |name: &str| {
        let bytes = story.host.files[Path::new(name)].clone();
        String::from_utf8(bytes).unwrap()
    };
    assert!(text("out/mine.obj").starts_with("mtllib mine.mtl\n"));
    assert!(text("out/mine.mtl").contains("newmtl"));
    let before = story.host.files[Path::new("models/strip.obj")].clone();

    story.click("File");
    story.click("Export with Materials…");
    story.choose("models/strip.obj");
    let told = story.messages().last().unwrap().1;
    assert!(
        told.starts_with("Not saved: models/strip.obj: expected a name"),
        "{told}"
    );
    assert_eq!(story.host.files[Path::new("models/strip.obj")], before);
}

#[test]
fn a_model_is_not_exported_over_itself_whatever_way_leads_to_it() {
    let mut story = Story::start(&[]);
    for (path, text) in STRIP {
        let path = format!("work/../{path}").into();
        story.host.files.insert(path, text.into());
    }
    story.host.drop_file("work/../models/strip.obj");
    story.settle();
    story.click("File");
    story.click("Export Geometry…");
    story.choose("models/strip.obj");
    let told = story.messages().last().unwrap().1;
    assert!(told.starts_with("Not saved: models/strip.obj"), "{told}");
}

#[test]
fn a_character_is_exported_in_the_courses_format_with_its_pose_and_opens_again() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Z", "30");
    story.click("File");
    story.click("Export Character…");
    assert_eq!(story.host.requests.last().unwrap().name, "Strip-copy.skel");
    story.choose("out/mine.skel");
    for name in ["mine.skel", "mine.attach", "mine.obj", "mine.json"] {
        let path = Path::new("out").join(name);
        assert!(story.host.files.contains_key(&path), "{name}");
    }
    let told = story.messages().last().unwrap().1;
    assert!(
        told.starts_with(
            "Its pose is in mine.json, for the character as mine.obj has it: with that open"
        ),
        "{told}"
    );
    story.host.drop_file("out/mine.obj");
    story.settle();
    story.host.drop_file("out/mine.json");
    story.settle();
    assert_eq!(story.names(), ["Strip", "Mine"]);
    assert!((story.degrees("Elbow").z - 30.0).abs() < 1e-4);
    assert_eq!(story.character().character.skeleton().joints().len(), 3);
}

#[test]
fn what_an_exported_character_leaves_out_is_told_once_it_is_written() {
    let mut story = Story::start(&["builtin:crate"]);
    let is_told = |story: &Story| {
        let told = story.messages();
        told.iter()
            .any(|(_, text)| text.starts_with("The course's files have no "))
    };
    let taken = Path::new("out/mine.obj");
    story.host.files.insert(taken.into(), b"theirs".to_vec());
    story.click("File");
    story.click("Export Character…");
    story.choose("out/mine.skel");
    story.click("Cancel");
    assert!(!is_told(&story), "nothing is written");
    story.click("File");
    story.click("Export Character…");
    story.choose("out/mine.skel");
    story.click("Overwrite");
    assert!(is_told(&story), "{:?}", story.messages());
}

#[test]
fn files_beside_an_export_are_replaced_only_after_asking() {
    let mut story = Story::start(&["models/strip.obj"]);
    let theirs = b"theirs".to_vec();
    for name in ["out/mine.attach", "out/mine.json"] {
        story.host.files.insert(name.into(), theirs.clone());
    }
    let export = |story: &mut Story| {
        story.click("File");
        story.click("Export Character…");
        story.choose("out/mine.skel");
    };
    export(&mut story);
    let text = "mine.skel is written together with files that are there already, \
                with other contents: mine.attach, mine.json.";
    assert!(story.has_text(text));
    story.click("Cancel");
    assert!(!story.host.files.contains_key(Path::new("out/mine.skel")));
    assert_eq!(story.host.files[Path::new("out/mine.attach")], theirs);
    export(&mut story);
    story.click("Overwrite");
    assert!(story.host.files.contains_key(Path::new("out/mine.skel")));
    assert_ne!(story.host.files[Path::new("out/mine.attach")], theirs);
    // Its own files are replaced without another word.
    story.type_into("Elbow Z", "30");
    export(&mut story);
    assert!(!story.has("Overwrite"));
    // Not so those that another program has edited since.
    let edited = story
        .host
        .files
        .get_mut(Path::new("out/mine.json"))
        .unwrap();
    edited.extend(b" ");
    story.type_into("Elbow Z", "40");
    export(&mut story);
    assert!(story.has("Overwrite"));
}

#[test]
fn the_files_of_a_character_that_are_dropped_together_are_one_and_each_of_them_is_it() {
    let mut story = Story::start(&["builtin:vase"]);
    for (path, _) in STRIP {
        story.host.drop_file(path);
    }
    story.settle();
    assert_eq!(story.names(), ["Vase", "Strip"], "{:?}", story.messages());
    story.host.drop_file("models/strip.skel");
    story.settle();
    assert_eq!(story.names(), ["Vase", "Strip", "Strip"]);
    assert!(story.messages().is_empty(), "{:?}", story.messages());
}

#[test]
fn curves_are_exported_under_the_name_of_their_shape_and_read_back() {
    let mut story = Story::start(&["builtin:vase"]);
    story.click("File");
    story.click("Export Curve…");
    assert_eq!(story.host.requests.last().unwrap().name, "Vase.swp");
    story.choose("mine.swp");
    let bytes = story.host.written[Path::new("mine.swp")].clone();
    story.host.files.insert("mine.swp".into(), bytes);
    story.host.drop_file("mine.swp");
    story.settle();
    let scene = story.session().scene();
    let [vase, mine] = scene.shapes() else {
        panic!("{:?}", story.names());
    };
    let curves = |id| scene.curve(id).expect("curves").curves();
    assert_eq!(curves(vase.id), curves(mine.id));
}

#[test]
fn kept_poses_are_saved_under_their_names_and_loaded() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow X", "15");
    story.key_with(Modifiers::COMMAND, Key::K);
    let kept = story.character().poses();
    assert_eq!(kept.len(), 1);
    let name = kept[0].name.clone();
    story.click("Poses (1)");
    story.click(&format!("Save {name}"));
    assert_eq!(story.host.requests.last().unwrap().name, "Pose-1.json");
    story.choose("p.json");
    assert!(story.host.text("p.json").contains("\"Elbow\": [15, 0, 0]"));

    story.key_with(Modifiers::ALT | Modifiers::SHIFT, Key::R);
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    let bytes = story.host.written[Path::new("p.json")].clone();
    story.host.files.insert("p.json".into(), bytes);
    story.click("Pose");
    story.click("Load Pose…");
    story.choose("p.json");
    assert_eq!(story.degrees("Elbow"), Vec3::new(15.0, 0.0, 0.0));

    let shape = story.shape().id;
    let waving = Edit::KeepPose {
        shape,
        name: "Waving!".into(),
    };
    let save = Ask::SavePose(shape, Some(1));
    let actions = vec![Action::Edit(waving), Action::Ask(save)];
    story.program.carry_out(actions, &mut story.host);
    assert_eq!(story.host.requests.last().unwrap().name, "Waving.json");
}

#[test]
fn a_pose_of_another_character_than_the_selected_one_goes_to_that_which_is_selected_then() {
    let mut story = Story::start(&["models/strip.obj", "builtin:robot"]);
    let robot = story.session().scene().shapes()[1].id;
    let select = Action::View(editor_core::editor::View::Select(Some(robot)));
    story.program.carry_out(vec![select], &mut story.host);
    story.settle();
    let pose = br#"{"joints": {"Elbow": [0, 0, 50]}}"#;
    story.host.files.insert("bent.json".into(), pose.to_vec());
    story.click("Pose");
    story.click("Load Pose…");
    story.choose("bent.json");
    let strip = story.session().scene().shapes()[0].id;
    assert_eq!(story.session().selected(), Some(strip));
    assert!((story.degrees("Elbow").z - 50.0).abs() < 1e-3);
    let told = "bent.json: taken by Strip, which has its joints";
    assert_eq!(story.messages(), [(Severity::Info, told)]);
}

#[test]
fn what_is_odd_in_a_file_is_told_and_the_file_is_used() {
    let mut story = Story::start(&[]);
    for (name, text) in [
        ("man.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3\n"),
        ("man.skel", "0 0 0 -1 # Root\n0 1 0 0 # Tip\n"),
        ("man.attach", "1\n0.25\n1\n"),
    ] {
        story.host.files.insert(name.into(), text.into());
    }
    story.host.drop_file("man.obj");
    story.settle();
    assert_eq!(story.names(), ["Man"]);
    let odd = "man.attach:2:1: 1 vertex with weights that do not sum up to 1";
    assert_eq!(story.messages(), [(Severity::Warning, odd)]);
}

#[test]
fn a_clipboard_with_nothing_but_white_space_has_no_pose() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.host.clipboard = " \n".into();
    let paste = Action::Ask(Ask::PastePose(story.shape().id));
    story.program.carry_out(vec![paste], &mut story.host);
    story.settle();
    let none = "There is nothing on the clipboard: Copy and Copy Pose put something there";
    assert_eq!(story.messages(), [(Severity::Warning, none)]);
}

#[test]
fn a_pose_that_is_pasted_mirrored_is_the_mirrored_pose_and_one_step() {
    let mut story = Story::start(&["models/strip.obj"]);
    let (id, steps) = (story.shape().id, story.session().steps().len());
    story.host.clipboard = r#"{"joints": {"Elbow": [10, 20, 50]}}"#.into();
    let mut paste = |ask| {
        story
            .program
            .carry_out(vec![Action::Ask(ask)], &mut story.host);
        story.settle();
        (story.degrees("Elbow"), story.session().steps().len())
    };
    let (mirrored, steps_after) = paste(Ask::PastePoseMirrored(id));
    let (plain, _) = paste(Ask::PastePose(id));
    assert_ne!(plain, mirrored);
    story.key(Key::M);
    assert_eq!(story.degrees("Elbow"), mirrored);
    assert_eq!(steps_after, steps + 1);
}

#[test]
fn the_pose_of_another_character_on_the_clipboard_is_refused_in_plain_words() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.host.clipboard = r#"{"joints": {"Left wing": [0, 0, 50]}}"#.into();
    let paste = Action::Ask(Ask::PastePose(story.shape().id));
    story.program.carry_out(vec![paste], &mut story.host);
    story.settle();
    let words = "The pose on the clipboard is another character's: Strip has none of the joints \
                 that it turns, such as Left wing";
    assert_eq!(story.messages(), [(Severity::Warning, words)]);
    assert!(!story.program.is_modified());
}

#[test]
fn keeping_a_pose_says_under_which_name() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key_with(Modifiers::COMMAND, Key::K);
    let words = "Kept the pose as Pose 1";
    assert_eq!(story.messages(), [(Severity::Info, words)]);
}

#[test]
fn opening_a_file_without_a_camera_of_its_own_shows_it_from_the_front() {
    let mut story = Story::start(&["builtin:gem"]);
    story.key_with(Modifiers::COMMAND, Key::Num3);
    let camera = story.session().view().camera;
    let open = Action::Ask(Ask::OpenBuiltin("robot"));
    story.program.carry_out(vec![open], &mut story.host);
    story.settle();
    assert_eq!(story.names(), ["Robot"]);
    let now = story.session().view().camera;
    assert_ne!(now, camera);
    assert!(now.eye().z > 1.0, "{now:?}");
}

#[test]
fn an_answer_that_comes_after_another_scene_was_opened_touches_none_of_its_shapes() {
    let mut story = Story::start(&["models/strip.obj"]);
    let pose = br#"{"joints": {"Elbow": [0, 0, 50]}}"#;
    story.host.files.insert("bent.json".into(), pose.to_vec());
    story.click("Pose");
    story.click("Load Pose…");
    let view = *story.session().view();
    let (kind, source) = (story.shape().kind.clone(), story.shape().source.clone());
    let other = editor_core::scene::NewShape::new("Other", kind);
    let again = vec![other.from_source(source.expect("it was imported"))];
    story.program.session_mut().open(again, view);
    story.choose("bent.json");
    assert_eq!(story.shape().name, "Other");
    assert_eq!(story.degrees("Elbow"), Vec3::ZERO);
    let late = "Nothing was done: another scene has been opened in the meantime";
    assert_eq!(story.messages(), [(Severity::Warning, late)]);
}

#[test]
fn a_pose_dropped_where_no_character_is_selected_is_refused_with_its_reason() {
    let mut story = Story::start(&["builtin:gem"]);
    story.host.files.insert("bent.json".into(), b"{}".to_vec());
    story.host.drop_file("bent.json");
    story.settle();
    let [(Severity::Error, message)] = story.messages()[..] else {
        panic!("{:?}", story.messages());
    };
    assert!(message.starts_with("bent.json: expected"), "{message}");
}

#[test]
fn what_is_written_is_called_like_the_shape_or_the_document() {
    let mut story = Story::start(&["builtin:adult"]);
    let mut suggested = |keys: &[(Modifiers, Key)], labels: &[&str]| {
        keys.iter()
            .for_each(|&(modifiers, key)| story.key_with(modifiers, key));
        labels.iter().for_each(|label| story.click(label));
        story.host.requests.last().expect("a request").name.clone()
    };
    let ctrl = Modifiers::COMMAND;
    assert_eq!(suggested(&[(ctrl, Key::P)], &[]), "Adult.json");
    let with_shift = ctrl | Modifiers::SHIFT;
    assert_eq!(suggested(&[(with_shift, Key::E)], &[]), "adult.obj");
    let picture = suggested(&[(Modifiers::NONE, Key::F12)], &["Save…"]);
    assert_eq!(picture, "adult.png");
}

#[test]
fn each_kind_of_files_has_a_folder_of_its_own_and_all_are_offered_as_recent() {
    let mut story = Story::start(&["models/strip.obj"]);
    let folder = |story: &Story| {
        let request = story.host.requests.last().expect("a request");
        request.folder.clone().map(|f| f.display().to_string())
    };
    story.key_with(Modifiers::COMMAND, Key::P);
    story.choose("poses/bent.json");
    story.key_with(Modifiers::COMMAND, Key::S);
    assert_eq!(folder(&story).as_deref(), Some("poses"), "the last of any");
    story.choose("scenes/bent.scene");
    story.key(Key::F12);
    story.click("Save…");
    story.choose("pictures/bent.png");

    story.key_with(Modifiers::COMMAND, Key::P);
    assert_eq!(folder(&story).as_deref(), Some("poses"));
    story.key_with(Modifiers::COMMAND, Key::O);
    assert_eq!(folder(&story).as_deref(), Some("scenes"));
    story.key(Key::F8);
    assert_eq!(
        folder(&story).as_deref(),
        Some("scenes"),
        "references are kept elsewhere, so that it is the last of any"
    );
    let recent = &story.host.requests.last().expect("a request").recent;
    let recent: Vec<_> = recent.iter().map(|folder| folder.display()).collect();
    let recent: Vec<_> = recent.iter().map(ToString::to_string).collect();
    assert_eq!(recent, ["pictures", "scenes", "models", "poses"]);

    let host = MemoryHost {
        stored: story.host.stored,
        ..MemoryHost::default()
    };
    let mut next = Story::start_at(host, &["models/strip.obj"]);
    next.key_with(Modifiers::COMMAND, Key::P);
    assert_eq!(folder(&next).as_deref(), Some("poses"), "at the next start");
}

#[test]
fn the_first_file_of_its_kind_is_saved_beside_the_scene_wherever_others_were_read() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key_with(Modifiers::COMMAND, Key::S);
    story.choose("scenes/bent.scene");
    story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::I);
    story.choose("models/strip.obj");
    assert_eq!(story.names().len(), 2);
    story.key(Key::F12);
    story.click("Save…");
    let folder = |story: &Story| {
        let request = story.host.requests.last().expect("a request");
        request.folder.clone()
    };
    assert_eq!(folder(&story).as_deref(), Some(Path::new("scenes")));
    // Models that are written do not come among those that were read.
    let with_shift = Modifiers::COMMAND | Modifiers::SHIFT;
    story.key_with(with_shift, Key::E);
    assert_eq!(folder(&story).as_deref(), Some(Path::new("scenes")));
    story.choose("mine/party.obj");
    story.key_with(with_shift, Key::I);
    assert_eq!(folder(&story).as_deref(), Some(Path::new("models")));
    story.choose("models/strip.obj");
    story.key_with(with_shift, Key::E);
    assert_eq!(folder(&story).as_deref(), Some(Path::new("mine")));
}

#[test]
fn a_folder_that_nothing_could_be_saved_in_is_not_where_the_next_dialog_begins() {
    let mut story = Story::start(&["models/strip.obj"]);
    let save = |story: &mut Story, path: &str| {
        story.key_with(Modifiers::COMMAND, Key::P);
        let request = story.host.requests.last().expect("a request");
        let folder = request.folder.clone().map(|f| f.display().to_string());
        story.choose(path);
        folder
    };
    save(&mut story, "poses/bent.json");
    story.host.write_fault = Some("Permission denied".to_owned());
    assert_eq!(
        save(&mut story, "locked/bent.json").as_deref(),
        Some("poses")
    );
    story.host.write_fault = None;
    let folder = save(&mut story, "other/bent.json");
    assert_eq!(folder.as_deref(), Some("poses"), "the last that worked");
    let folder = save(&mut story, "other/more.json");
    assert_eq!(folder.as_deref(), Some("other"));
}

#[test]
fn models_that_come_with_a_scene_are_added_to_it_unless_it_names_them() {
    let scene =
        br#"{"format": "editor-scene", "version": 1, "shapes": [{"source": "models/strip.obj"}]}"#;
    for dropped in [true, false] {
        let mut story = Story::start(&[]);
        let files = &mut story.host.files;
        files.insert("two.scene".into(), scene.to_vec());
        files.insert(
            "flag.obj".into(),
            b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec(),
        );
        files.insert("bent.json".into(), b"{\"joints\": {}}".to_vec());
        if dropped {
            for path in [
                "flag.obj",
                "models/strip.attach",
                "models/strip.obj",
                "two.scene",
                "bent.json",
            ] {
                story.host.drop_file(path);
            }
        } else {
            story
                .program
                .carry_out(vec![Action::Ask(Ask::Open)], &mut story.host);
            story
                .host
                .choose_together("two.scene", &["models/strip.obj", "flag.obj"]);
        }
        story.settle();
        assert_eq!(story.names(), ["Strip", "Flag"], "{dropped}");
        let unused = (Severity::Warning, "Not used: bent.json");
        assert_eq!(story.messages(), Vec::from_iter(dropped.then_some(unused)));
        assert_eq!(story.session().messages.fresh().len(), usize::from(dropped));
    }
}

#[test]
fn of_two_scenes_that_come_together_the_second_is_added_to_the_first() {
    for dropped in [true, false] {
        let mut story = Story::start(&[]);
        for (name, kind) in [("a.scene", "gem"), ("b.scene", "vase")] {
            let scene = format!(
                r#"{{"format": "editor-scene", "version": 1, "shapes": [{{"source": "builtin:{kind}"}}]}}"#
            );
            story.host.files.insert(name.into(), scene.into_bytes());
        }
        if dropped {
            story.host.drop_file("a.scene");
            story.host.drop_file("b.scene");
        } else {
            story
                .program
                .carry_out(vec![Action::Ask(Ask::Open)], &mut story.host);
            story.host.choose_together("a.scene", &["b.scene"]);
        }
        story.settle();
        assert_eq!(story.host.title, "*a.scene — Editor");
        assert_eq!(story.messages(), []);
        assert_eq!(story.names(), ["Gem", "Vase"], "{dropped}");
    }
}
