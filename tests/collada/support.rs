//! Small Collada files to write tests with.

use editor_core::geometry::Mesh;
use editor_core::io::dae::{DaeScene, read_dae};
use editor_core::io::{Diagnostic, Files, Imported};
use glam::Vec3;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Files in memory.
#[derive(Default)]
pub struct Memory(HashMap<PathBuf, Vec<u8>>);

impl Memory {
    pub fn with(mut self, path: &str, bytes: impl Into<Vec<u8>>) -> Self {
        self.0.insert(path.into(), bytes.into());
        self
    }

    pub fn files(&self) -> &dyn Files {
        &self.0
    }
}

/// What `path` reads among `files`.
pub fn read(files: &Memory, path: &str) -> Result<Imported<DaeScene>, Diagnostic> {
    read_dae(files.files(), Path::new(path))
}

pub fn import_bytes(bytes: impl Into<Vec<u8>>) -> Result<Imported<DaeScene>, Diagnostic> {
    read(&Memory::default().with("a.dae", bytes), "a.dae")
}

/// Imports `text`, which must be good.
#[track_caller]
pub fn import(text: &str) -> Imported<DaeScene> {
    import_bytes(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Imports `text`, which must be good and without a fault.
#[track_caller]
pub fn import_clean(text: &str) -> DaeScene {
    let imported = import(text);
    assert_eq!(imported.warnings, [], "{text}");
    imported.value
}

/// The only static mesh of `text`.
#[track_caller]
pub fn only_mesh(text: &str) -> Mesh {
    let mut scene = import_clean(text);
    assert_eq!(scene.meshes.len(), 1);
    scene.meshes.remove(0).mesh
}

/// Whether any warning says `part`; prints them all if not.
#[track_caller]
pub fn assert_warns(imported: &Imported<DaeScene>, part: &str) {
    let warnings: Vec<String> = imported.warnings.iter().map(|w| w.to_string()).collect();
    assert!(
        warnings.iter().any(|warning| warning.contains(part)),
        "no “{part}” in {warnings:#?}"
    );
}

#[track_caller]
pub fn assert_near(found: &[Vec3], expected: &[Vec3]) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (found_one, expected_one) in found.iter().zip(expected) {
        assert!(
            found_one.abs_diff_eq(*expected_one, 1e-6),
            "{found:?}, expected {expected:?}"
        );
    }
}

/// A whole document of its libraries and the nodes of its scene.
pub fn document(asset: &str, libraries: &str, nodes: &str) -> String {
    format!(
        r##"<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset>{asset}</asset>
  {libraries}
  <library_visual_scenes><visual_scene id="Scene">{nodes}</visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#Scene"/></scene>
</COLLADA>
"##
    )
}

/// A `<source>` of rows of `stride` numbers.
pub fn source(id: &str, stride: usize, numbers: &str) -> String {
    let count = numbers.split_whitespace().count();
    let rows = count / stride;
    let params: String = (0..stride)
        .map(|column| format!(r#"<param name="C{column}" type="float"/>"#))
        .collect();
    format!(
        r##"<source id="{id}"><float_array id="{id}-array" count="{count}">{numbers}</float_array>
<technique_common><accessor source="#{id}-array" count="{rows}" stride="{stride}">{params}</accessor></technique_common></source>"##
    )
}

/// A `<geometry>` with positions and whatever follows its `<vertices>`. In `rest` the inputs
/// refer to `#ID-v`.
pub fn geometry(id: &str, positions: &str, more_sources: &str, rest: &str) -> String {
    let positions = source(&format!("{id}-p"), 3, positions);
    format!(
        r##"<geometry id="{id}" name="{id}"><mesh>{positions}{more_sources}
<vertices id="{id}-v"><input semantic="POSITION" source="#{id}-p"/></vertices>
{rest}</mesh></geometry>"##
    )
}

/// `<triangles>` by position alone.
pub fn triangles(geometry: &str, indices: &str) -> String {
    let count = indices.split_whitespace().count() / 3;
    format!(
        r##"<triangles count="{count}"><input semantic="VERTEX" source="#{geometry}-v" offset="0"/><p>{indices}</p></triangles>"##
    )
}

/// One triangle with corners at (0,0,0), (1,0,0), (0,2,3).
pub fn triangle(id: &str) -> String {
    geometry(id, "0 0 0 1 0 0 0 2 3", "", &triangles(id, "0 1 2"))
}

pub fn geometries(content: &str) -> String {
    format!("<library_geometries>{content}</library_geometries>")
}

pub fn instance(geometry: &str) -> String {
    format!(r##"<instance_geometry url="#{geometry}"/>"##)
}

/// A document that shows `content`'s geometry `g` at the origin.
pub fn static_document(content: &str) -> String {
    let node = format!(r#"<node name="N">{}</node>"#, instance("g"));
    document("", &geometries(content), &node)
}

pub const IDENTITY: &str = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";

/// What a `<controller>` says.
pub struct Skin<'a> {
    pub id: &'a str,
    pub geometry: &'a str,
    pub bind_shape: &'a str,
    /// `Name_array` or `IDREF_array`.
    pub array: &'a str,
    pub joints: &'a str,
    /// Empty for a skin without any.
    pub inverse_binds: &'a str,
    pub weights: &'a str,
    pub vcount: &'a str,
    pub v: &'a str,
}

impl Default for Skin<'_> {
    fn default() -> Self {
        Self {
            id: "c",
            geometry: "g",
            bind_shape: IDENTITY,
            array: "Name_array",
            joints: "a",
            inverse_binds: "",
            weights: "1",
            vcount: "1 1 1",
            v: "0 0 0 0 0 0",
        }
    }
}

impl Skin<'_> {
    pub fn xml(&self) -> String {
        let Self {
            id,
            geometry,
            bind_shape,
            array,
            joints,
            inverse_binds,
            weights,
            vcount,
            v,
        } = self;
        let (mut binds, mut bind_input) = (String::new(), String::new());
        if !inverse_binds.is_empty() {
            binds = source(&format!("{id}-b"), 16, inverse_binds);
            bind_input = format!(r##"<input semantic="INV_BIND_MATRIX" source="#{id}-b"/>"##);
        }
        let weights = source(&format!("{id}-w"), 1, weights);
        let count = vcount.split_whitespace().count();
        format!(
            r##"<controller id="{id}"><skin source="#{geometry}"><bind_shape_matrix>{bind_shape}</bind_shape_matrix>
<source id="{id}-j"><{array}>{joints}</{array}></source>{binds}{weights}
<joints><input semantic="JOINT" source="#{id}-j"/>{bind_input}</joints>
<vertex_weights count="{count}"><input semantic="JOINT" source="#{id}-j" offset="0"/><input semantic="WEIGHT" source="#{id}-w" offset="1"/>
<vcount>{vcount}</vcount><v>{v}</v></vertex_weights></skin></controller>"##
        )
    }
}

pub fn controllers(content: &str) -> String {
    format!("<library_controllers>{content}</library_controllers>")
}

/// A joint called `sid`, with id `ID-sid` and name `Name sid`.
pub fn joint(sid: &str, at: &str, inside: &str) -> String {
    format!(
        r#"<node id="ID-{sid}" sid="{sid}" name="Name {sid}" type="JOINT"><translate>{at}</translate>{inside}</node>"#
    )
}

/// A node that shows controller `controller` on the skeletons with these ids.
pub fn skinned(controller: &str, skeletons: &[&str]) -> String {
    let skeletons: String = skeletons
        .iter()
        .map(|id| format!("<skeleton>#{id}</skeleton>"))
        .collect();
    format!(
        r##"<node name="Skin"><instance_controller url="#{controller}">{skeletons}</instance_controller></node>"##
    )
}

/// Joint `a` at (0,1,0) with child `b` one up, and a triangle skinned as `skin` says.
pub fn arm(skin: &Skin) -> String {
    let libraries = geometries(&triangle("g")) + &controllers(&skin.xml());
    let nodes = joint("a", "0 1 0", &joint("b", "0 1 0", "")) + &skinned("c", &["ID-a"]);
    document("", &libraries, &nodes)
}
