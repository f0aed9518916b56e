//! Collada files as the program imports them.

use crate::collada::support::*;
use editor_core::editor::{Edit, Session};
use editor_core::io::{Loaded, import_any, import_character, import_shape};
use editor_core::scene::{COLOR_PRESETS, NewShape, ShapeColor, ShapeKind, ViewSettings};
use std::path::Path;

/// A skinned arm and a static mesh beside it.
fn both() -> Memory {
    let mesh = format!(
        "<node name=\"Sword\">{}</node></visual_scene>",
        instance("g")
    );
    let text = arm(&Skin::default()).replace("</visual_scene>", &mesh);
    Memory::default().with("my_arm.dae", text)
}

fn names(shapes: &[NewShape]) -> Vec<(&str, &str)> {
    shapes
        .iter()
        .map(|shape| (shape.name.as_str(), shape.kind.label()))
        .collect()
}

#[test]
fn a_file_brings_in_its_characters_and_then_its_meshes() {
    let files = both();
    let path = Path::new("my_arm.dae");
    let expected = [("My_arm Name a", "Character"), ("My_arm Sword", "Shape")];
    assert_eq!(
        names(&import_any(files.files(), path).unwrap().value),
        expected
    );
    assert_eq!(
        names(&import_character(files.files(), path).unwrap().value),
        expected
    );
    let shapes = import_shape(files.files(), path).unwrap();
    // Who has chosen Import Shape may have meant the character.
    let told = shapes.warnings.last().map(ToString::to_string);
    assert!(
        told.is_some_and(|told| told.ends_with("Import Character… brings them along")),
        "{:?}",
        shapes.warnings
    );
    let shapes = shapes.value;
    assert!(
        shapes
            .iter()
            .all(|shape| matches!(shape.kind, ShapeKind::Mesh(_)))
    );
    assert_eq!(shapes.len(), 2);
}

#[test]
fn what_is_alone_in_its_file_has_the_files_name() {
    let files = Memory::default().with("a/vase.DAE", static_document(&triangle("g")));
    let path = Path::new("a/vase.DAE");
    let imported = import_any(files.files(), path).unwrap().value;
    assert_eq!(names(&imported), [("Vase", "Shape")]);
    let error = import_character(files.files(), path)
        .unwrap_err()
        .to_string();
    assert_eq!(
        error,
        "a/vase.DAE: expected a character, found only shapes, which Import Shape reads"
    );
}

#[test]
fn a_scene_can_be_cut_to_four_influences() {
    let skin = Skin {
        joints: "a b",
        weights: "1 3",
        vcount: "2 0 0",
        v: "0 0 1 1",
        ..Skin::default()
    };
    let files = Memory::default().with("a.dae", arm(&skin));
    let mut loaded = Loaded::default();
    loaded.add(files.files(), Path::new("a.dae")).unwrap();
    let mut session = Session::with_shapes(loaded.shapes, ViewSettings::default());
    let id = session.scene().shapes()[0].id;
    session.edit(Edit::LimitInfluences(id, 1)).unwrap();
    let shape = session.scene().character(id).unwrap();
    let kept = shape.character.attachments().of_vertex(0);
    assert_eq!((kept.len(), kept[0].joint, kept[0].weight), (1, 1, 1.0));
}

#[test]
fn a_character_with_materials_starts_white_so_that_these_show_as_they_are() {
    let white = |text: String| {
        let files = Memory::default().with("a.dae", text);
        let mut loaded = Loaded::default();
        loaded.add(files.files(), Path::new("a.dae")).unwrap();
        let color = loaded.shapes[0].placement.color;
        matches!(color, ShapeColor::Preset(preset) if COLOR_PRESETS[preset].name == "White")
    };
    let plain = arm(&Skin::default());
    let library = r##"<library_effects><effect id="e"><profile_COMMON><technique><lambert/></technique></profile_COMMON></effect></library_effects><library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>"##;
    let colored = plain
        .replace(
            "<library_geometries>",
            &format!("{library}<library_geometries>"),
        )
        .replace("<triangles", "<triangles material=\"m\"");
    assert!(white(colored));
    assert!(!white(plain));
}

/// Two characters, with the joints `a` and `b`, and `c`; and a scene that gives them `pose`.
fn posed_pair(pose: &str) -> Result<Loaded, String> {
    let other = Skin {
        id: "c2",
        joints: "c",
        ..Skin::default()
    };
    let controllers = format!("{}</library_controllers>", other.xml());
    let nodes = joint("c", "5 0 0", "") + &skinned("c2", &["ID-c"]) + "</visual_scene>";
    let pair = arm(&Skin::default())
        .replace("</library_controllers>", &controllers)
        .replace("</visual_scene>", &nodes);
    let scene = format!(
        r#"{{"format": "editor-scene", "version": 1, "shapes": [{{"source": "pair.dae", "pose": {pose}}}]}}"#
    );
    let files = Memory::default()
        .with("pair.dae", pair)
        .with("bend.json", r#"{"joints": {"Name c": [0, 0, 70]}}"#)
        .with("a.scene", scene);
    let mut loaded = Loaded::default();
    let added = loaded.add(files.files(), Path::new("a.scene"));
    added.map(|()| loaded).map_err(|error| error.to_string())
}

#[test]
fn a_pose_in_a_scene_goes_to_those_characters_of_its_file_that_have_the_joints() {
    let degrees = |pose: &str| {
        let loaded = posed_pair(pose).unwrap();
        let shapes = loaded.shapes.iter();
        let posed = shapes.map(|shape| match &shape.kind {
            ShapeKind::Character(character) => {
                let last = character.character.skeleton().joints().len() - 1;
                character.pose().rotation(last).degrees().z.round()
            }
            _ => panic!("expected two characters"),
        });
        posed.collect::<Vec<_>>()
    };
    let both = r#"{"joints": {"Name b": [0, 0, 50], "Name c": [0, 0, 60]}}"#;
    assert_eq!(degrees(both), [50.0, 60.0]);
    assert_eq!(degrees("\"bend.json\""), [0.0, 70.0]);
    let none = posed_pair(r#"{"joints": {"Name d": [0, 0, 50]}}"#).unwrap_err();
    assert_eq!(
        none,
        "a.scene:1:96: shape 1: expected the name or index of a joint, such as “Name a”, “Name b”, “Name c”, found “Name d”"
    );
}
