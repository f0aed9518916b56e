//! The order of warnings, and how many of them there are.

use crate::collada::support::*;
use editor_core::io::Imported;
use editor_core::io::dae::DaeScene;

fn messages(imported: &Imported<DaeScene>) -> Vec<&str> {
    imported
        .warnings
        .iter()
        .map(|w| w.message.as_str())
        .collect()
}

/// A triangle for each of these pictures, colored by it.
fn pictured(pictures: &[&str]) -> String {
    let (mut images, mut effects, mut materials) = (String::new(), String::new(), String::new());
    let (mut corners, mut bindings) = (String::new(), String::new());
    for (at, picture) in pictures.iter().enumerate() {
        images += &format!(r#"<image id="i{at}"><init_from>{picture}</init_from></image>"#);
        effects += &format!(
            r#"<effect id="e{at}"><profile_COMMON><technique><lambert><diffuse><texture texture="i{at}"/></diffuse></lambert></technique></profile_COMMON></effect>"#
        );
        materials +=
            &format!(r##"<material id="m{at}"><instance_effect url="#e{at}"/></material>"##);
        corners += &format!(
            r##"<triangles material="s{at}"><input semantic="VERTEX" source="#g-v" offset="0"/><p>0 1 2</p></triangles>"##
        );
        bindings += &format!(r##"<instance_material symbol="s{at}" target="#m{at}"/>"##);
    }
    let libraries = format!(
        "<library_images>{images}</library_images><library_effects>{effects}</library_effects><library_materials>{materials}</library_materials>"
    ) + &geometries(&geometry("g", "0 0 0 1 0 0 0 1 0", "", &corners));
    let node = format!(
        r##"<node><instance_geometry url="#g"><bind_material><technique_common>{bindings}</technique_common></bind_material></instance_geometry></node>"##
    );
    document("", &libraries, &node)
}

#[test]
fn missing_pictures_are_one_message_that_names_the_first_and_counts_the_others() {
    for (pictures, expected) in [
        (&["a.png"][..], "expected a picture, found no file “a.png”"),
        (
            &["a.png", "b.png"],
            "expected 2 pictures, found no files for “a.png” and 1 other",
        ),
        (
            &["a.png", "b.png", "c.png", "a.png"],
            "expected 3 pictures, found no files for “a.png” and 2 others",
        ),
    ] {
        let imported = import(&pictured(pictures));
        assert_eq!(messages(&imported), [expected]);
        let first = pictured(pictures);
        let line = first[..first.find("a.png").unwrap()].lines().count();
        assert_eq!(imported.warnings[0].position.unwrap().line, line);
    }
}

#[test]
fn warnings_that_change_the_shape_come_first_and_those_that_change_nothing_last() {
    // An id twice, a joint named by its id, a material that is missing, and a joint that is missing.
    let skin = Skin {
        joints: "ID-a gone",
        ..Skin::default()
    };
    let text = arm(&skin)
        .replace("<triangles", "<triangles material=\"s\"")
        .replace("<asset>", "<asset id=\"g\">");
    assert_eq!(
        messages(&import(&text)),
        [
            "expected the joint “gone” below <skeleton>, found none: its weights are left out",
            "expected a material for “s”, found none: the shape's color is used",
            "expected every id once, found “g” again",
            "expected all joints below <skeleton>, found 1 elsewhere",
        ]
    );
}
