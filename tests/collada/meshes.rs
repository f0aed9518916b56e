//! Geometry: axes, units, sources, primitives, nodes.

use crate::collada::support::*;
use editor_core::geometry::{Mesh, Normals};
use glam::{Vec2, Vec3};

const TRIANGLE: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::new(0.0, 2.0, 3.0)];

fn with_asset(asset: &str) -> Mesh {
    let node = format!("<node>{}</node>", instance("g"));
    only_mesh(&document(asset, &geometries(&triangle("g")), &node))
}

fn under(transforms: &str) -> Vec<Vec3> {
    let node = format!("<node>{transforms}{}</node>", instance("g"));
    only_mesh(&document("", &geometries(&triangle("g")), &node)).positions
}

fn area(mesh: &Mesh) -> f32 {
    let corners = mesh
        .triangles
        .iter()
        .map(|t| t.map(|i| mesh.positions[i as usize]));
    corners
        .map(|[a, b, c]| (b - a).cross(c - a).length() * 0.5)
        .sum()
}

#[test]
fn the_axis_that_points_up_is_turned_to_y() {
    let last = |asset| with_asset(asset).positions[2];
    assert_eq!(last(""), Vec3::new(0.0, 2.0, 3.0));
    assert_eq!(last("<up_axis>Y_UP</up_axis>"), Vec3::new(0.0, 2.0, 3.0));
    assert_eq!(last("<up_axis>Z_UP</up_axis>"), Vec3::new(0.0, 3.0, -2.0));
    assert_eq!(last("<up_axis> X_UP </up_axis>"), Vec3::new(-2.0, 0.0, 3.0));
}

#[test]
fn the_unit_scales_positions() {
    let mesh = with_asset(r#"<unit name="centimeter" meter="1e-2"/>"#);
    assert_near(&mesh.positions, &TRIANGLE.map(|p| p * 0.01));
}

#[test]
fn an_unknown_axis_or_unit_is_a_warning() {
    let node = format!("<node>{}</node>", instance("g"));
    for asset in [
        "<up_axis>UP</up_axis>",
        r#"<unit meter="0"/>"#,
        r#"<unit meter="nan"/>"#,
    ] {
        let imported = import(&document(asset, &geometries(&triangle("g")), &node));
        assert_warns(&imported, "a.dae:3:");
        assert_eq!(imported.value.meshes[0].mesh.positions, TRIANGLE);
    }
}

#[test]
fn matrices_are_written_row_by_row() {
    let moved = under("<matrix>1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1</matrix>");
    assert_eq!(moved[0], Vec3::new(5.0, 6.0, 7.0));
    let turned = under("<matrix>0 -1 0 0 1 0 0 0 0 0 1 0 0 0 0 1</matrix>");
    assert_near(&turned[1..2], &[Vec3::Y]);
}

#[test]
fn transforms_of_a_node_apply_in_the_order_written_last_first() {
    let stack = "<translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 3 4</scale>";
    let expected = [
        Vec3::new(10.0, 0.0, 0.0),
        Vec3::new(10.0, 2.0, 0.0),
        Vec3::new(4.0, 0.0, 12.0),
    ];
    assert_near(&under(stack), &expected);
    let other = "<scale>2 3 4</scale><translate>1e1 0 0</translate>";
    assert_near(&under(other)[..1], &[Vec3::new(20.0, 0.0, 0.0)]);
}

#[test]
fn nodes_stand_in_their_parents_and_instanced_nodes_where_they_are_instanced() {
    let library = geometries(&triangle("g"))
        + &format!(
            r#"<library_nodes><node id="n"><translate>0 0 1</translate>{}</node></library_nodes>"#,
            instance("g")
        );
    let nodes = r##"<node><translate>1 0 0</translate><instance_node url="#n"/><node><translate>0 1 0</translate><instance_node url="#n"/></node></node>"##;
    let scene = import_clean(&document("", &library, nodes));
    let first: Vec<Vec3> = scene.meshes.iter().map(|m| m.mesh.positions[0]).collect();
    assert_eq!(first, [Vec3::new(1.0, 0.0, 1.0), Vec3::new(1.0, 1.0, 1.0)]);
}

#[test]
fn a_mirroring_transform_keeps_triangles_facing_outwards() {
    let node = format!("<node><scale>-1 1 1</scale>{}</node>", instance("g"));
    let normals = source("g-n", 3, "1 0 0");
    let rest = r##"<triangles><input semantic="VERTEX" source="#g-v" offset="0"/><input semantic="NORMAL" source="#g-n" offset="1"/><p>0 0 1 0 2 0</p></triangles>"##;
    let geometry = geometry("g", "0 0 0 0 1 0 0 0 1", &normals, rest);
    let mesh = only_mesh(&document("", &geometries(&geometry), &node));
    assert_eq!(mesh.normals, Normals::PerVertex(vec![-Vec3::X; 3]));
    let [a, b, c] = mesh.triangles[0].map(|i| mesh.positions[i as usize]);
    assert_eq!((b - a).cross(c - a), -Vec3::X);
}

#[test]
fn normals_turn_by_the_inverse_transpose() {
    let node = format!("<node><scale>1 4 1</scale>{}</node>", instance("g"));
    let normals = source("g-n", 3, "1 1 0");
    let rest = r##"<triangles><input semantic="VERTEX" source="#g-v" offset="0"/><input semantic="NORMAL" source="#g-n" offset="1"/><p>0 0 1 0 2 0</p></triangles>"##;
    let geometry = geometry("g", "0 0 0 0 0 1 -1 1 0", &normals, rest);
    let mesh = only_mesh(&document("", &geometries(&geometry), &node));
    let expected = Vec3::new(4.0, 1.0, 0.0).normalize_or_zero();
    assert!(matches!(&mesh.normals, Normals::PerVertex(n) if n[0].abs_diff_eq(expected, 1e-6)));
}

#[test]
fn polygons_of_any_kind_become_triangles() {
    let square = "0 0 0 1 0 0 1 1 0 0 1 0";
    let vertex = r##"<input semantic="VERTEX" source="#g-v" offset="0"/>"##;
    for rest in [
        format!("<polylist>{vertex}<vcount>4</vcount><p>0 1 2 3</p></polylist>"),
        format!("<polylist>{vertex}<vcount>3 3</vcount><p>0 1 2 0 2 3</p></polylist>"),
        format!("<polygons>{vertex}<p>0 1 2 3</p></polygons>"),
        format!("<polygons>{vertex}<p>0 1 2</p><p>0 2 3</p></polygons>"),
        format!("<tristrips>{vertex}<p>0 1 3 2</p></tristrips>"),
        format!("<trifans>{vertex}<p>0 1 2 3</p></trifans>"),
        format!("<triangles>{vertex}<p>0 1 2 0 2 3</p></triangles>"),
    ] {
        let mesh = only_mesh(&static_document(&geometry("g", square, "", &rest)));
        assert_eq!(mesh.triangles.len(), 2, "{rest}");
        assert_eq!(area(&mesh), 1.0, "{rest}");
        for t in &mesh.triangles {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            assert!((b - a).cross(c - a).z > 0.0, "{rest}");
        }
    }
}

#[test]
fn concave_polygons_keep_their_dents() {
    let arrow = "0 0 0 2 -1 0 0 3 0 -2 -1 0";
    for kind in [
        r##"<polygons><input semantic="VERTEX" source="#g-v" offset="0"/><p>1 2 3 0</p></polygons>"##,
        r##"<polylist><input semantic="VERTEX" source="#g-v" offset="0"/><vcount>4</vcount><p>1 2 3 0</p></polylist>"##,
    ] {
        let mesh = only_mesh(&static_document(&geometry("g", arrow, "", kind)));
        assert_eq!(area(&mesh), 6.0);
    }
}

#[test]
fn each_corner_has_its_own_normal_and_texture_coordinates_while_positions_stay_one_each() {
    let sources = source("n", 3, "0 0 1 0 0 -1") + &source("t", 2, "0 0 1 0 1 1 0.5 0.5");
    // Offsets in any order, one that nobody uses (2), and two inputs that share one.
    let rest = r##"<triangles material="m"><input semantic="TEXCOORD" source="#t" offset="0" set="0"/><input semantic="NORMAL" source="#n" offset="3"/><input semantic="VERTEX" source="#g-v" offset="1"/><input semantic="COLOR" source="#n" offset="3"/>
<p>0 0 9 0  1 1 9 0  2 2 9 0   3 0 9 1  2 2 9 1  1 1 9 1</p></triangles>"##;
    let text = static_document(&geometry("g", "0 0 0 1 0 0 0 1 0 7 7 7", &sources, rest));
    let imported = import(&text);
    assert_eq!(imported.value.report.ignored["input COLOR"], 1);
    let mesh = &imported.value.meshes[0].mesh;
    assert_eq!(mesh.positions.len(), 4);
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 1]]);
    assert_eq!(mesh.vertex_count(), 7);
    assert_eq!(mesh.vertex_triangles(), [[0, 1, 2], [4, 5, 6]]);
    assert_eq!(mesh.at_vertices(&mesh.positions)[4], Vec3::ZERO);
    assert_eq!(mesh.texture_coordinates[4], Vec2::splat(0.5));
    assert_eq!(mesh.texture_coordinates[5], Vec2::ONE);
    assert!(matches!(&mesh.normals, Normals::PerVertex(n) if n[0] == Vec3::Z && n[4] == -Vec3::Z));
}

#[test]
fn normals_and_texture_coordinates_may_hang_on_the_vertices() {
    let text = static_document(&geometry(
        "g",
        "0 0 0 1 0 0 0 1 0",
        &(source("n", 3, "0 0 1 0 0 1 0 0 1") + &source("t", 2, "0 0 1 0 0 1")),
        &triangles("g", "0 1 2"),
    ))
    .replace(
        "</vertices>",
        r##"<input semantic="NORMAL" source="#n"/><input semantic="TEXCOORD" source="#t"/></vertices>"##,
    );
    let mesh = only_mesh(&text);
    assert_eq!(mesh.normals, Normals::PerVertex(vec![Vec3::Z; 3]));
    assert_eq!(mesh.texture_coordinates[2], Vec2::Y);
    assert_eq!(mesh.seams, None);
}

#[test]
fn a_mesh_without_normals_and_texture_coordinates_is_flat_and_has_none() {
    let mesh = only_mesh(&static_document(&triangle("g")));
    assert_eq!(mesh.normals, Normals::Flat);
    assert!(mesh.texture_coordinates.is_empty());
    assert!(mesh.groups.is_empty());
}

#[test]
fn accessors_say_how_rows_lie_in_their_array() {
    let padded = r##"<source id="g-p"><float_array id="f" count="14">99 0 0 0 8 1 0 0 8 0 1 0 8 9</float_array>
<technique_common><accessor source="#f" offset="1" stride="4" count="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/><param type="float"/></accessor></technique_common></source>"##;
    let rest = triangles("g", "0 1 2");
    let geometry = format!(
        r##"<geometry id="g"><mesh>{padded}<vertices id="g-v"><input semantic="POSITION" source="#g-p"/></vertices>{rest}</mesh></geometry>"##
    );
    let mesh = only_mesh(&static_document(&geometry));
    assert_eq!(mesh.positions, [Vec3::ZERO, Vec3::X, Vec3::Y]);
}

#[test]
fn unnamed_columns_are_padding() {
    let sparse = r##"<source id="g-p"><float_array id="f" count="12">0 7 0 0 1 7 0 0 0 7 1 0</float_array>
<technique_common><accessor source="#f" stride="4" count="3"><param name="X" type="float"/><param type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>"##;
    let rest = triangles("g", "0 1 2");
    let geometry = format!(
        r##"<geometry id="g"><mesh>{sparse}<vertices id="g-v"><input semantic="POSITION" source="#g-p"/></vertices>{rest}</mesh></geometry>"##
    );
    let mesh = only_mesh(&static_document(&geometry));
    assert_eq!(mesh.positions, [Vec3::ZERO, Vec3::X, Vec3::Y]);
}

#[test]
fn line_ends_exponents_comments_and_empty_libraries_are_no_matter() {
    let plain = static_document(&geometry(
        "g",
        "0e0 -0.0 +0\n1.0E+0 0 0\t1e-1 <!---->20.0e-1 3",
        "",
        &triangles("g", "0 1\n2"),
    ))
    .replace(
        "<library_geometries>",
        "<library_images/><library_lights/><library_geometries>",
    );
    let windows = plain.replace('\n', "\r\n");
    let expected = [Vec3::ZERO, Vec3::X, Vec3::new(0.1, 2.0, 3.0)];
    assert_eq!(only_mesh(&plain).positions, expected);
    assert_eq!(only_mesh(&windows).positions, expected);
    let marked = [b"\xEF\xBB\xBF".as_slice(), plain.as_bytes()].concat();
    assert_eq!(import_bytes(marked).unwrap().warnings, []);
}

#[test]
fn what_is_not_shown_is_counted() {
    let text = static_document(&geometry(
        "g",
        "0 0 0 1 0 0 0 1 0",
        "",
        &(triangles("g", "0 1 2") + "<lines><p>0 1</p></lines>"),
    ))
    .replace(
        "<library_geometries>",
        "<library_cameras><camera/></library_cameras><library_geometries>",
    );
    let ignored = import_clean(&text).report.ignored;
    let found: Vec<_> = ignored
        .iter()
        .map(|(what, count)| (what.as_str(), *count))
        .collect();
    assert_eq!(found, [("library_cameras", 1), ("lines", 1)]);
}

#[test]
fn several_meshes_stay_apart_in_the_order_of_the_scene() {
    let node = |name: &str, g: &str| format!(r#"<node name="{name}">{}</node>"#, instance(g));
    let libraries = geometries(&(triangle("g") + &triangle("h")));
    let scene = import_clean(&document(
        "",
        &libraries,
        &(node("B", "h") + &node("A", "g")),
    ));
    let names: Vec<&str> = scene.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["B", "A"]);
    assert!(scene.characters.is_empty());
}
