//! What ends the course's own editor, or makes it draw nonsense: here it works, or one error says
//! where the fault is.

use crate::bad_input::everything::{SCENE, Table, good, open, with};
use editor_core::io::{Loaded, import_any, import_character};
use std::path::{Path, PathBuf};

fn error(files: &Table) -> String {
    open(files).map(|_| ()).unwrap_err().to_string()
}

fn import_error(files: &Table, path: &str) -> String {
    import_any(files, Path::new(path))
        .map(|_| ())
        .unwrap_err()
        .to_string()
}

#[test]
fn a_blank_line_at_the_end_of_a_skel_is_none() {
    let skel = "0 0 0 -1 # Root\n0 1 0 0 # Tip\n0 1 0 1\n\n  \n";
    assert!(open(&with("man.skel", skel)).is_ok());
}

#[test]
fn an_empty_skel_is_told() {
    let message = "man.skel:1:1: expected a line `x y z parent` for each joint, found none";
    assert_eq!(error(&with("man.skel", "")), message);
}

#[test]
fn more_than_18_joints_are_welcome() {
    let joints = 500;
    let mut files = good();
    let mut skel = "0 0 0 -1 # Root\n0 1 0 0 # Tip\n".to_owned();
    (2..joints).for_each(|joint| skel.push_str(&format!("0 1 0 {}\n", joint - 1)));
    files.insert(PathBuf::from("man.skel"), skel.into_bytes());
    let row = format!("1{}\n", " 0".repeat(joints - 2));
    files.insert(PathBuf::from("man.attach"), row.repeat(4).into_bytes());
    let (session, _) = open(&files).unwrap();
    let scene = session.scene();
    let man = scene.character(scene.shapes()[1].id).unwrap();
    assert_eq!(man.character.skeleton().joints()[499].name, "Joint 499");
}

#[test]
fn an_attach_shorter_or_longer_than_the_mesh_is_told() {
    let short = error(&with("man.attach", "1 0\n1 0\n"));
    assert_eq!(
        short,
        "man.attach:2:4: expected 4 lines, one a vertex, found 2"
    );
    let long = error(&with("man.attach", "1 0\n".repeat(5)));
    assert_eq!(
        long,
        "man.attach:5:1: expected 4 lines, one a vertex, found one more"
    );
}

#[test]
fn a_shape_may_lack_normals_have_quads_count_backwards_and_name_texture_coordinates() {
    let obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf -4/1 -3/1 -2/1 -1/1\n";
    let files = with("box.obj", obj);
    assert!(import_any(&files, Path::new("box.obj")).is_ok());
}

#[test]
fn an_index_out_of_range_is_told_with_its_column() {
    for (face, message) in [
        (
            "f 1 2 4",
            "box.obj:4:7: expected a vertex from 1 to 3, found 4",
        ),
        (
            "f 1 2 0",
            "box.obj:4:7: expected a vertex counted from 1, found “0”",
        ),
        (
            "f 1 2 -4",
            "box.obj:4:7: expected one of the 3 vertex lines so far, found “-4”",
        ),
        (
            "f 1 2 3/1",
            "box.obj:4:7: expected no texture coordinate, for the file has none, found 1",
        ),
        (
            "f 1 2 3//9",
            "box.obj:4:7: expected no normal, for the file has none, found 9",
        ),
        (
            "f 1 2 3 x",
            "box.obj:4:9: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found “x”",
        ),
    ] {
        let obj = format!("v 0 0 0\nv 1 0 0\nv 1 1 0\n{face}\n");
        assert_eq!(import_error(&with("box.obj", obj), "box.obj"), message);
    }
}

#[test]
fn a_missing_companion_is_named() {
    for (gone, message) in [
        (
            "man.attach",
            "man.obj: expected man.attach beside man.skel, found only the skeleton",
        ),
        (
            "man.skel",
            "man.obj: expected man.skel beside man.attach, found only the weights",
        ),
    ] {
        let mut files = good();
        files.remove(Path::new(gone));
        assert_eq!(import_error(&files, "man.obj"), message);
    }
}

#[test]
fn a_shape_is_no_character() {
    let error = import_character(&good(), Path::new("box.obj"))
        .map(|_| ())
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "box.obj: expected box.skel and box.attach beside it, found neither: without them it is a shape, which Import Shape reads"
    );
}

#[test]
fn files_that_cannot_be_opened_say_which_can() {
    let mut files = with("a.blend", "x");
    files.insert(PathBuf::from("._man.obj"), b"x".to_vec());
    assert_eq!(
        import_error(&files, "a.blend"),
        "a.blend: expected a file that can be imported (.obj, .swp, .dae), found .blend"
    );
    assert_eq!(
        import_error(&files, "man.skel"),
        "man.skel: expected a file that can be imported (.obj, .swp, .dae), found .skel: open the character's .obj file instead"
    );
    assert_eq!(
        import_error(&files, "no.obj"),
        "no.obj: there is no such file"
    );
    assert!(import_error(&files, "._man.obj").contains("notes of macOS"));
    let error = Loaded::default()
        .add(&files, Path::new("a.blend"))
        .unwrap_err();
    assert!(
        error
            .to_string()
            .contains("(.scene, .zip, .obj, .swp, .dae), found .blend"),
        "{error}"
    );
}

/// Where `found` first stands in `text`.
fn place(text: &str, found: &str) -> String {
    let before = &text[..text.find(found).unwrap()];
    let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
    format!("{}:{column}", before.matches('\n').count() + 1)
}

#[test]
fn a_scene_file_is_held_to_its_schema() {
    for (good, bad, at, message) in [
        (
            "\"version\": 1",
            "\"version\": 3",
            "3,",
            "expected version 1 or 2, found 3: it needs a newer editor",
        ),
        (
            "editor-scene",
            "blender",
            "\"blender",
            "expected the format “editor-scene”, found “blender”",
        ),
        (
            "\"cube\"",
            "\"cub\"",
            "\"cub\"",
            "expected one of `cube`, `sphere`, `pyramid`, `teapot`, `icosahedron`, `custom`, found “cub”",
        ),
        (
            "\"radius\"",
            "\"distance\"",
            "\"distance",
            "expected one of `target`, `radius`, `theta`, `phi`, `fovy`, `near`, `far`, found “distance”",
        ),
        (
            "\"Gray\"",
            "\"Grey\"",
            "\"Grey",
            "expected a color of the panel's list, found “Grey”",
        ),
        (
            "[0.2, 0.4, 0.6]",
            "[2, 0.4, 0.6]",
            "2, 0.4, 0.6]",
            "expected a number from 0 to 1, found 2",
        ),
        (
            "[4, 0.1, 4]",
            "[4, 0, 4]",
            "0, 4],\n\"color",
            "expected a scale other than 0, found 0",
        ),
        (
            "\"radius\": 4",
            "\"radius\": -4",
            "-4",
            "expected a number above 0, found -4",
        ),
        (
            "\"shapes\": [{",
            "\"shapes\": [[], {",
            "[], {",
            "expected an object, found a list",
        ),
        (
            "\"phi\": 30",
            "\"theta\": 30",
            "\"theta\": 30",
            "expected each name once, found “theta” again",
        ),
        (
            "\"name\": \"é\"",
            "\"name\": true",
            "true",
            "expected a string, found true",
        ),
        (
            "\"mode\": \"both\"",
            "\"mode\": 7",
            "7",
            "expected one of `skeleton`, `mesh`, `both`, found 7",
        ),
        (
            "\"radius\": 4",
            "\"near\": 5, \"far\": 5",
            "{\"target\"",
            "expected near < far, found 5 and 5",
        ),
        (
            "\"theta\": 45",
            "\"fovy\": 171",
            "171",
            "expected a fovy from 1 to 170, found 171",
        ),
        (
            "\"locked\": true",
            "\"locked\": 1",
            "1}]",
            "expected true or false, found 1",
        ),
        (
            "[0, 1, 0]",
            "[0, 1, 1e39]",
            "1e39",
            "expected a number below 3.4e38, found a larger one",
        ),
        (
            "\"version\": 1",
            "\"version\": 1.0",
            "1.0",
            "expected a whole number from 0, found 1.0",
        ),
    ] {
        let text = SCENE.replacen(good, bad, 1);
        assert_ne!(text, SCENE, "{good}");
        let told = error(&with("a.scene", text.as_str()));
        assert_eq!(told, format!("a.scene:{}: {message}", place(&text, at)));
    }
}

#[test]
fn what_does_not_fit_together_in_a_scene_is_told_by_shape_and_place() {
    for (good, bad, message) in [
        (
            "\"kind\": \"cube\"",
            "\"kind\": \"cube\", \"source\": \"box.obj\"",
            "2:69: shape 1: expected a kind or a source, found both",
        ),
        (
            "\"source\": \"box.obj\", ",
            "",
            "4:48: shape 3: expected a kind or a source, found neither",
        ),
        (
            "\"source\": \"man.obj\"",
            "\"source\": \"box.obj\"",
            "3:19: shape 2: expected a character, for it has a pose or display, found a shape",
        ),
        (
            "\"name\": \"é\"",
            "\"curves\": {\"curve\": \"off\"}",
            "4:48: shape 3: expected curves, for it says how they are drawn, found a shape",
        ),
        (
            "\"Tip\"",
            "\"Top\"",
            "3:87: shape 2: expected the name or index of a joint, such as “Tip”, “Root”, “Joint 2”, found “Top”",
        ),
    ] {
        let text = SCENE.replacen(good, bad, 1);
        assert_ne!(text, SCENE, "{good}");
        let expected = format!("a.scene:{message}");
        assert_eq!(error(&with("a.scene", text)), expected);
    }
    for (missing, told) in [
        (
            "a.scene",
            "a.scene:3:19: shape 2: a.scene: expected a file that can be imported (.obj, .swp, .dae), found .scene",
        ),
        (
            "",
            "a.scene:3:19: shape 2: expected the name of a file, found an empty one",
        ),
        (
            "none.obj",
            "a.scene:3:19: shape 2: none.obj: there is no such file",
        ),
    ] {
        let text = SCENE.replacen("man.obj", missing, 1);
        let error = error(&with("a.scene", text));
        assert!(error.contains(told), "{error}");
    }
    let told = error(&with(
        "a.scene",
        SCENE.replacen("box.obj", "builtin:none", 1),
    ));
    let start = "a.scene:4:48: shape 3: builtin:none: expected one of ";
    assert!(told.starts_with(start), "{told}");
    let told = error(&with(
        "a.scene",
        SCENE.replacen("{\"joints\": {\"Tip\": [0, 0, 30]}}", "\"gone.json\"", 1),
    ));
    let expected = "a.scene:3:19: shape 2: gone.json: there is no such file";
    assert_eq!(told, expected, "the file of a pose");
}
