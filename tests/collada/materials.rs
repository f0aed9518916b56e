//! Materials, groups, textures and where their pictures are.

use crate::collada::support::*;
use editor_core::geometry::{Mesh, Picture};
use editor_core::io::Imported;
use editor_core::io::dae::DaeScene;
use glam::{Vec2, Vec3};
use std::io::Cursor;

/// `<image>`, effect and material; `diffuse` is the content of `<diffuse>`.
fn material(id: &str, params: &str, diffuse: &str) -> String {
    format!(
        r##"<library_effects><effect id="{id}-e"><profile_COMMON>{params}<technique sid="common"><lambert><diffuse>{diffuse}</diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="{id}" name="Named {id}"><instance_effect url="#{id}-e"/></material></library_materials>"##
    )
}

fn bound(geometry: &str, symbol: &str, target: &str, inputs: &str) -> String {
    format!(
        r##"<node><instance_geometry url="#{geometry}"><bind_material><technique_common><instance_material symbol="{symbol}" target="#{target}">{inputs}</instance_material></technique_common></bind_material></instance_geometry></node>"##
    )
}

const TWO_GROUPS: &str = r##"<triangles material="s"><input semantic="VERTEX" source="#g-v" offset="0"/><p>0 1 2</p></triangles>
<triangles><input semantic="VERTEX" source="#g-v" offset="0"/><p>0 2 1</p></triangles>
<triangles material="t"><input semantic="VERTEX" source="#g-v" offset="0"/><p>1 2 0</p></triangles>"##;

fn png(color: [u8; 4]) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image::RgbaImage::from_pixel(2, 3, image::Rgba(color))
        .write_to(&mut bytes, image::ImageFormat::Png)
        .unwrap();
    bytes.into_inner()
}

/// A document whose material's texture is read from `init_from`.
fn textured(init_from: &str) -> String {
    let params = r#"<newparam sid="surf"><surface type="2D"><init_from>img</init_from></surface></newparam><newparam sid="samp"><sampler2D><source>surf</source></sampler2D></newparam>"#;
    let libraries = format!(
        "<library_images><image id=\"img\"><init_from>{init_from}</init_from></image></library_images>"
    ) + &material("m", params, r#"<texture texture="samp" texcoord="UV"/>"#)
        + &geometries(&geometry("g", "0 0 0 1 0 0 0 1 0", "", TWO_GROUPS));
    document("", &libraries, &bound("g", "s", "m", ""))
}

fn read(text: String, files: Memory) -> Imported<DaeScene> {
    crate::collada::support::read(&files.with("models/a.dae", text), "models/a.dae").unwrap()
}

fn picture(mesh: &Mesh) -> Option<&Picture> {
    mesh.groups[0].material.texture.as_deref()
}

#[test]
fn groups_have_the_colors_of_the_materials_bound_to_their_symbols() {
    let libraries = material("m", "", r#"<color sid="diffuse">0.25 0.5 2 1</color>"#)
        + &geometries(&geometry("g", "0 0 0 1 0 0 0 1 0", "", TWO_GROUPS));
    let imported = import(&document("", &libraries, &bound("g", "s", "m", "")));
    assert_warns(&imported, "expected a material for “t”, found none");
    let mesh = &imported.value.meshes[0].mesh;
    assert_eq!(mesh.triangles.len(), 3);
    assert_eq!(mesh.groups.len(), 1);
    let group = &mesh.groups[0];
    assert_eq!(group.triangles, 0..1);
    assert_eq!(group.material.name, "Named m");
    assert_eq!(group.material.color, Vec3::new(0.25, 0.5, 1.0));
    assert_eq!(group.material.texture, None);
}

#[test]
fn a_symbol_that_nothing_binds_may_be_the_material_itself() {
    let geometry = geometry(
        "g",
        "0 0 0 1 0 0 0 1 0",
        "",
        &TWO_GROUPS.replace("\"t\"", "\"s\""),
    );
    let libraries = material("s", "", "<color>1 0 0 1</color>") + &geometries(&geometry);
    let node = format!("<node>{}</node>", instance("g"));
    let mesh = only_mesh(&document("", &libraries, &node));
    assert_eq!(mesh.groups.len(), 2);
    assert_eq!(mesh.groups[1].triangles, 2..3);
    assert_eq!(mesh.groups[1].material.color, Vec3::X);
}

#[test]
fn a_texture_is_found_through_sampler_surface_and_image() {
    let imported = read(
        textured("skin.png"),
        Memory::default().with("models/skin.png", png([1, 2, 3, 4])),
    );
    let picture = picture(&imported.value.meshes[0].mesh).unwrap();
    assert_eq!((picture.width, picture.height), (2, 3));
    assert_eq!(picture.rgba, [1, 2, 3, 4].repeat(6));
}

#[test]
fn a_texture_may_name_its_image_at_once_or_by_instance() {
    let files = || Memory::default().with("models/skin.png", png([9; 4]));
    let at_once = textured("skin.png").replace("texture=\"samp\"", "texture=\"img\"");
    assert!(picture(&read(at_once, files()).value.meshes[0].mesh).is_some());
    let newer = textured("<ref>skin.png</ref>")
        .replace("<source>surf</source>", r##"<instance_image url="#img"/>"##);
    assert!(picture(&read(newer, files()).value.meshes[0].mesh).is_some());
}

#[test]
fn paths_of_pictures_are_urls_relative_to_the_file() {
    for (written, path) in [
        ("my%20skin.png", "models/my skin.png"),
        ("./sub/a.png", "models/./sub/a.png"),
        (r"sub\a.png", "models/sub/a.png"),
        ("100%.png", "models/100%.png"),
        ("file:///home/me/a.png", "/home/me/a.png"),
        ("file:///C:/me/a.png", "models/a.png"),
        ("/gone/a.png", "models/a.png"),
    ] {
        let imported = read(textured(written), Memory::default().with(path, png([0; 4])));
        assert!(
            picture(&imported.value.meshes[0].mesh).is_some(),
            "{written}"
        );
    }
}

#[test]
fn a_missing_or_broken_picture_is_a_warning_and_the_mesh_stays() {
    let missing = read(textured("gone.png"), Memory::default());
    assert_warns(&missing, "expected a picture, found no file “gone.png”");
    assert_eq!(missing.value.meshes[0].mesh.triangles.len(), 3);
    let mut half = png([0; 4]);
    half.truncate(40);
    for (bytes, told) in [
        (half, "expected a whole PNG picture"),
        (b"no picture".to_vec(), "expected a PNG, JPEG or GIF"),
        (Vec::new(), "expected a PNG, JPEG or GIF"),
    ] {
        let broken = read(
            textured("skin.png"),
            Memory::default().with("models/skin.png", bytes),
        );
        assert_warns(&broken, &format!("models/skin.png: {told}"));
        assert_eq!(picture(&broken.value.meshes[0].mesh), None);
    }
}

#[test]
fn a_texture_says_which_set_of_coordinates_it_wants() {
    let sources = source("t0", 2, "0 0 0 0 0 0") + &source("t1", 2, "1 1 1 1 1 1");
    let rest = r##"<triangles material="s"><input semantic="VERTEX" source="#g-v" offset="0"/><input semantic="TEXCOORD" source="#t1" offset="0" set="1"/><input semantic="TEXCOORD" source="#t0" offset="0" set="0"/><p>0 1 2</p></triangles>"##;
    let asks = |inputs: &str| {
        let libraries = r#"<library_images><image id="img"><init_from>a.png</init_from></image></library_images>"#.to_owned()
            + &material("m", "", r#"<texture texture="img" texcoord="UV"/>"#)
            + &geometries(&geometry("g", "0 0 0 1 0 0 0 1 0", &sources, rest));
        let text = document("", &libraries, &bound("g", "s", "m", inputs));
        import(&text).value.meshes[0].mesh.texture_coordinates[0]
    };
    let input = |set| {
        format!(r#"<bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="{set}"/>"#)
    };
    assert_eq!(asks(&input(1)), Vec2::ONE);
    assert_eq!(asks(&input(0)), Vec2::ZERO);
    assert_eq!(asks(""), Vec2::ZERO);
}

#[test]
fn references_of_parameters_in_a_circle_end() {
    let circle = r#"<newparam sid="a"><sampler2D><source>b</source></sampler2D></newparam><newparam sid="b"><sampler2D><source>a</source></sampler2D></newparam>"#;
    let libraries = material("m", circle, r#"<texture texture="a" texcoord="UV"/>"#)
        + &geometries(&geometry("g", "0 0 0 1 0 0 0 1 0", "", TWO_GROUPS));
    let imported = import(&document("", &libraries, &bound("g", "s", "m", "")));
    assert_warns(&imported, "expected the id of an <image>, found “a”");
}
