//! 5 The scene: shapes from files beside characters posed together.

use editor_core::editor::Session;
use editor_core::geometry::{Mesh, Normals};
use editor_core::io::{Imported, Loaded, read_shape_obj};
use editor_core::scene::{Look, ShapeColor, ShapeKind};
use glam::{Vec2, Vec3};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

type Table = HashMap<PathBuf, Vec<u8>>;

fn table(files: &[(&str, &str)]) -> Table {
    let entry = |(path, text): &(&str, &str)| (PathBuf::from(path), text.as_bytes().to_vec());
    files.iter().map(entry).collect()
}

fn shape(obj: &str) -> Imported<Mesh> {
    shape_with(obj, &[])
}

fn shape_with(obj: &str, files: &[(&str, &str)]) -> Imported<Mesh> {
    read_shape_obj(&table(files), Path::new("d/a.obj"), obj.as_bytes()).unwrap()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn a_shape_may_have_quads_and_polygons_dents_included() {
    assert_eq!(
        shape(&format!("{SQUARE}f 1 2 3 4\n")).value.triangles.len(),
        2
    );
    let arrow = "v 0 2 0\nv -1 -1 0\nv 0 0 0\nv 1 -1 0\nf -4 -3 -2 -1\n";
    let mesh = shape(arrow).value;
    let area: f32 = mesh
        .triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            (b - a).cross(c - a).z / 2.0
        })
        .sum();
    assert!((area - 2.0).abs() < 1e-6, "{area}");
}

#[test]
fn a_shape_without_normals_is_flat() {
    let mesh = shape(&format!("{SQUARE}vt 0 0\nf 1/1 2/1 3/1\n")).value;
    assert_eq!(mesh.normals, Normals::Flat);
    assert_eq!(mesh.texture_coordinates, vec![Vec2::ZERO; 3]);
}

#[test]
fn a_shape_without_texture_coordinates_keeps_its_normals() {
    let mesh = shape(&format!("{SQUARE}vn 0 0 2\nvn 0 3 4\nf 1//1 2//2 3//1\n")).value;
    let expected = vec![Vec3::Z, Vec3::new(0.0, 0.6, 0.8), Vec3::Z];
    assert_eq!(mesh.normals, Normals::PerVertex(expected));
    assert!(mesh.texture_coordinates.is_empty());
}

#[test]
fn where_only_some_faces_have_normals_the_others_are_flat() {
    let text =
        format!("{SQUARE}vt 0.5 1\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1 3 4\nf 1/1/1 2 3//1\n");
    let mesh = shape(&text).value;
    let Normals::PerVertex(normals) = &mesh.normals else {
        panic!("flat");
    };
    assert_eq!(mesh.positions.len(), 4);
    assert_eq!(normals.len(), mesh.vertex_count());
    assert_eq!(mesh.texture_coordinates.len(), mesh.vertex_count());
    let of = |triangle: usize| mesh.vertex_triangles()[triangle].map(|i| normals[i as usize]);
    assert_eq!(
        [of(0), of(1), of(2)],
        [[Vec3::X; 3], [Vec3::Z; 3], [Vec3::Z; 3]]
    );
}

#[test]
fn several_objects_come_together_with_the_colors_of_their_materials() {
    let obj = format!(
        "mtllib two words.mtl\n{SQUARE}o one\nusemtl Red#1\nf 1 2 3\no two\nf 1 3 4\ng\nusemtl blue\nf 1 2 4\nusemtl none\nf 2 3 4\n"
    );
    let mtl = "# c\nnewmtl Red#1\nKa 1\nKd 1 0 0\nNs x\nnewmtl blue\nKd 0 0 1 \nillum\nd\n";
    let read = shape_with(&obj, &[("d/two words.mtl", mtl)]);
    let groups: Vec<_> = read
        .value
        .groups
        .iter()
        .map(|group| (group.triangles.clone(), group.material.color))
        .collect();
    assert_eq!(groups, [(0..2, Vec3::X), (2..3, Vec3::Z)]);
    assert_eq!(read.value.triangles.len(), 4);
    let warnings: Vec<String> = read.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        ["d/a.obj:14:8: expected a material of the .mtl file, found “none”"]
    );
}

#[test]
fn a_missing_mtl_file_or_picture_is_a_warning_and_the_shape_stays() {
    let triangle = SQUARE.replace("v 0 1 0\n", "");
    let obj = format!("mtllib a.mtl\n{triangle}usemtl m\nf 1 2 3\n");
    let read = shape(&obj);
    assert_eq!(read.value.triangles.len(), 1);
    let warnings: Vec<String> = read.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        ["d/a.obj:1:8: materials left out: d/a.mtl: there is no such file"]
    );

    let read = shape_with(&obj, &[("d/a.mtl", "newmtl m\nmap_Kd tex\\no.png\n")]);
    assert_eq!(read.value.groups[0].material.texture, None);
    assert_eq!(
        read.warnings[0].to_string(),
        "d/a.obj: expected a picture, found no file “tex\\no.png”"
    );
}

const SCENE: &str = r#"{
  "format": "editor-scene", "version": 1,
  "view": {"camera": {"target": [0, 1, 0], "theta": 45, "phi": 30}, "look": "studio", "axis": false},
  "shapes": [
    {"kind": "cube", "name": "Floor", "position": [0, -1, 0], "scale": [4, 0.1, 4], "color": "light gray"},
    {"source": "man.obj", "rotation": [0, 90, 0], "color": [0.2, 0.4, 0.6],
     "pose": {"joints": {"1": [0, 0, 30]}}, "display": {"mode": "both"}},
    {"source": "man.obj", "name": "Twin", "pose": "wave.json", "visible": false, "locked": true}
  ]
}"#;

fn scene_files() -> Table {
    table(&[
        ("d/a.scene", SCENE),
        ("d/man.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("d/man.skel", "0 0 0 -1\n0 1 0 0\n"),
        ("d/man.attach", "1\n1\n1\n"),
        ("d/wave.json", r#"{"joints": {"Joint 1": [0, 0, 60]}}"#),
    ])
}

#[test]
fn a_scene_file_holds_posed_characters_on_a_flattened_cube() {
    let mut loaded = Loaded::default();
    loaded.add(&scene_files(), Path::new("d/a.scene")).unwrap();
    let view = loaded.view.unwrap();
    assert_eq!((view.look, view.axis), (Look::Studio, false));
    assert!((view.camera.theta.to_degrees() - 45.0).abs() < 1e-4);
    assert_eq!(view.camera.radius, 5.0);

    let session = Session::with_shapes(loaded.shapes, view);
    let [floor, man, twin] = session.scene().shapes() else {
        panic!("{:?}", session.scene());
    };
    assert_eq!(
        (&*floor.name, &*man.name, &*twin.name),
        ("Floor", "Man", "Twin")
    );
    assert_eq!(floor.placement.color, ShapeColor::Preset(30));
    assert!(!floor.placement.uniform_scaling);
    assert_eq!((floor.visible, floor.locked), (true, false));
    assert_eq!((twin.visible, twin.locked), (false, true));
    assert_eq!(floor.start, floor.placement, "what Reset brings back");
    assert_eq!(
        man.placement.color,
        ShapeColor::Custom(Vec3::new(0.2, 0.4, 0.6))
    );
    assert!((man.placement.transform.rotation.degrees().y - 90.0).abs() < 1e-4);
    for (shape, degrees) in [(man, 30.0), (twin, 60.0)] {
        let ShapeKind::Character(character) = &shape.kind else {
            panic!("{shape:?}");
        };
        let angles = character.pose().rotation(1).degrees();
        assert!(angles.abs_diff_eq(Vec3::Z * degrees, 1e-4), "{angles}");
    }
}

#[test]
fn several_files_make_one_scene() {
    let mut loaded = Loaded::default();
    let files = scene_files();
    loaded.add(&files, Path::new("d/man.obj")).unwrap();
    loaded.add(&files, Path::new("d/a.scene")).unwrap();
    let session = Session::with_shapes(loaded.shapes, loaded.view.unwrap());
    let ids: Vec<u32> = session
        .scene()
        .shapes()
        .iter()
        .map(|shape| shape.id.0)
        .collect();
    assert_eq!(ids, [1, 2, 3, 4]);
}
