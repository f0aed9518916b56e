//! Files in memory, and scenes compared by what is in them.

use crate::collada::support::{Skin, arm, instance};
use editor_core::editor::Session;
use editor_core::io::builtin::WithBuiltin;
use editor_core::io::{Files, Loaded, Missing, scene_text};
use editor_core::scene::{Scene, Shape, ShapeKind, ViewSettings};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Files in memory, and those that are built in.
pub type Table = WithBuiltin<HashMap<PathBuf, Vec<u8>>>;

/// Folder of the scenes, and the scene that tests write.
pub const FOLDER: &str = "/home/ada/scenes";
pub const SCENE: &str = "/home/ada/scenes/a.scene";
/// Place of the scene of version 1.
pub const OLD_SCENE: &str = "/home/ada/old.scene";

/// A character whose joints have names that are hard to tell apart.
pub const MAN: &str = "/home/ada/rigs/man.obj";
/// A shape with a material and a picture beside the scenes.
pub const BOX: &str = "/home/ada/scenes/box.obj";

/// Curves.
pub const VASE: &str = "/home/ada/vase.swp";
/// A character and a shape in one file.
pub const PAIR: &str = "/home/ada/rigs/pair.dae";

pub fn files() -> Table {
    let skel = "0 0 0 -1 # Root\n0 1 0 0 # A\n0 1 0 1 # A\n0 1 0 2 # 2\n0 1 0 3 # #2\n";
    let sword = format!(
        "<node name=\"Sword\">{}</node></visual_scene>",
        instance("g")
    );
    let pair = arm(&Skin::default()).replace("</visual_scene>", &sword);
    let texts = [
        (PAIR, pair.as_str()),
        (MAN, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("/home/ada/rigs/man.skel", skel),
        (
            "/home/ada/rigs/man.attach",
            "1 0 0 0\n0 1 0 0\n0.5 0 0 0.5\n",
        ),
        (
            BOX,
            "mtllib box.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n",
        ),
        ("/home/ada/scenes/box.mtl", "newmtl m\nKd 1 0.5 0\n"),
        (VASE, "bez2 p 4 4 [1 0] [2 1] [1 2] [1 3]\nsrev s 8 p\n"),
    ];
    let entry = |(name, text): (&str, &str)| (PathBuf::from(name), text.as_bytes().to_vec());
    WithBuiltin(texts.into_iter().map(entry).collect())
}

/// The scene of the file at `path`, its view, and warnings about it.
pub fn read(
    files: &dyn Files,
    path: &str,
    missing: Missing,
) -> Result<(Scene, ViewSettings, Vec<String>), String> {
    let mut loaded = Loaded {
        missing,
        ..Loaded::default()
    };
    let added = loaded.add(files, Path::new(path));
    added.map_err(|error| error.to_string())?;
    let warnings = loaded.warnings.iter().map(ToString::to_string).collect();
    let session = Session::with_shapes(loaded.shapes, loaded.view.expect("a scene has a view"));
    Ok((session.scene().clone(), *session.view(), warnings))
}

/// `scene` after it was written to [`SCENE`] and read, its view, and its text.
pub fn saved_and_read(
    files: &mut Table,
    scene: &Scene,
    view: &ViewSettings,
) -> (Scene, ViewSettings, String) {
    let text = scene_text(scene, view, Some(Path::new(FOLDER))).unwrap();
    let bytes = text.clone().into_bytes();
    files.0.insert(PathBuf::from(SCENE), bytes);
    let read = read(files, SCENE, Missing::Refuse);
    let (scene, view, warnings) = read.unwrap_or_else(|error| panic!("{error}\n{text}"));
    let of_names = |warning: &String| warning.contains("man.skel:3:7: expected a name of its own");
    assert!(warnings.iter().all(of_names), "{warnings:?}\n{text}");
    (scene, view, text)
}

/// Checks that two scenes have equal shapes in one order, whatever their identifiers and revisions.
#[track_caller]
pub fn assert_same(one: &Scene, other: &Scene, text: &str) {
    assert_eq!(one.shapes().len(), other.shapes().len(), "{text}");
    for (one, other) in one.shapes().iter().zip(other.shapes()) {
        assert_same_shape(one, other, text);
    }
}

#[track_caller]
fn assert_same_shape(one: &Shape, other: &Shape, text: &str) {
    assert_eq!(one.name, other.name, "{text}");
    assert_eq!(one.source, other.source, "{text}");
    assert_eq!(one.placement, other.placement, "{text}");
    assert_eq!(one.start, other.start, "{text}");
    let flags = |shape: &Shape| [shape.visible, shape.locked];
    assert_eq!(flags(one), flags(other), "{text}");
    match (&one.kind, &other.kind) {
        (ShapeKind::Mesh(one), ShapeKind::Mesh(other)) => assert!(**one == **other, "{text}"),
        (ShapeKind::Character(one), ShapeKind::Character(other)) => {
            let [joints, others] =
                [one, other].map(|shape| shape.character.skeleton().joints().to_vec());
            assert_eq!(joints, others, "{text}");
            assert!(**one.character.bind_mesh() == **other.character.bind_mesh());
            assert_eq!(one.character.attachments(), other.character.attachments());
            assert_eq!(one.pose(), other.pose(), "{text}");
            assert_eq!(one.poses(), other.poses(), "{text}");
            assert_eq!(one.ik, other.ik, "{text}");
            assert_eq!(one.display, other.display, "{text}");
        }
        (one, other) => assert!(one == other, "{one:?} {other:?}\n{text}"),
    }
}
