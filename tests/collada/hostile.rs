//! Files that are broken or mean harm: an error or a warning, in bounded time and memory.

use crate::collada::support::*;
use crate::work::{grows_in_proportion, work};
use editor_core::character::Pose;
use editor_core::io::dae::DaeScene;
use proptest::prelude::*;
use std::time::Duration;

/// What holds of whatever an importer hands out.
fn check(scene: &DaeScene) {
    let bound = scene.characters.iter().map(|c| c.character.bind_mesh());
    for mesh in bound
        .map(|mesh| &**mesh)
        .chain(scene.meshes.iter().map(|mesh| &mesh.mesh))
    {
        assert!(mesh.positions.iter().all(|p| p.is_finite()));
        let below = |triangles: &[[u32; 3]], count: usize| {
            triangles.iter().flatten().all(|&i| (i as usize) < count)
        };
        assert!(below(&mesh.triangles, mesh.positions.len()));
        assert!(below(mesh.vertex_triangles(), mesh.vertex_count()));
        assert_eq!(mesh.triangles.len(), mesh.vertex_triangles().len());
        let texture = mesh.texture_coordinates.len();
        assert!(texture == 0 || texture == mesh.vertex_count());
        for group in &mesh.groups {
            assert!(group.triangles.end <= mesh.triangles.len());
        }
    }
    for character in &scene.characters {
        let posed = character.character.skin_pose(&Pose::new());
        assert_eq!(posed.len(), character.character.bind_mesh().positions.len());
    }
}

/// Imports what may be anything, in a time of the processor that says "no loop".
fn survive(bytes: impl Into<Vec<u8>>) -> String {
    let (said, time) = work(|| match import_bytes(bytes) {
        Ok(imported) => {
            check(&imported.value);
            let warnings = imported.warnings.iter().map(|w| format!("{w}\n"));
            warnings.collect()
        }
        Err(error) => format!("error {error}"),
    });
    assert!(time < Duration::from_secs(20), "{time:?} {said}");
    said
}

#[track_caller]
fn says(text: impl Into<Vec<u8>>, part: &str) {
    let said = survive(text);
    assert!(said.contains(part), "no “{part}” in: {said}");
}

fn good() -> String {
    let skin = Skin {
        joints: "a b",
        weights: "0.5 1",
        vcount: "2 1 1",
        v: "0 0 1 0 0 1 1 1",
        ..Skin::default()
    };
    arm(&skin)
}

#[test]
fn errors_name_line_and_column() {
    let empty = document("", "", "");
    let word = static_document(&geometry("g", "0 0 0 1 0\n zero", "", ""));
    for (text, part) in [
        ("", "1:1: expected Collada, found an empty file"),
        (
            "<COLLADA>\n  <a b=\"c",
            "2:10: expected the end of the outermost element, found that of the file: it may be cut off",
        ),
        ("not xml at all", "1:1:"),
        (
            "<COLLADA>\n  <a>\n</COLLADA>",
            "3:1: expected well-formed XML",
        ),
        (
            "<COLLADA>\n  <a>\n  </a>\n<b",
            "4:3: expected the end of the outermost element",
        ),
        (
            "<COLLADA>\n  <a>\n  </a>\n",
            "3:7: expected the end of the outermost element, found that of the file: it may be cut off",
        ),
        ("<svg/>", "1:1: expected <COLLADA>, found <svg>"),
        (
            "<COLLADA/>",
            "1:1: expected <library_visual_scenes> in <COLLADA>",
        ),
        (
            &word,
            "5:2: expected a number, found “zero”: the mesh is left out",
        ),
    ] {
        says(text, &format!("error a.dae:{part}"));
    }
    says(
        empty,
        "error a.dae:5:26: expected meshes or joints in the scene, found none",
    );
}

#[test]
fn a_document_type_is_refused_so_that_entities_cannot_grow() {
    let bomb = r#"<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]><COLLADA>&b;</COLLADA>"#;
    says(bomb, "expected Collada without a document type");
    says("<COLLADA>&undefined;</COLLADA>", "expected well-formed XML");
}

#[test]
fn nodes_that_hold_themselves_are_left_out() {
    let library = geometries(&triangle("g"));
    let node = format!(
        r##"<node id="n">{}<instance_node url="#n"/></node>"##,
        instance("g")
    );
    says(document("", &library, &node), "found one that holds itself");
    let ring = format!(
        r##"<library_nodes><node id="x"><instance_node url="#y"/></node><node id="y">{}<instance_node url="#x"/></node></library_nodes>"##,
        instance("g")
    );
    says(
        document(
            "",
            &(library + &ring),
            r##"<instance_node url="#x"/><node/>"##,
        ),
        "holds itself",
    );
}

#[test]
fn instances_of_instances_cannot_multiply_without_end() {
    let levels: String = (0..40)
        .map(|i| format!(r##"<node id="n{i}"><instance_node url="#n{next}"/><instance_node url="#n{next}"/></node>"##, next = i + 1))
        .collect();
    let library = format!("<library_nodes>{levels}<node id=\"n40\"/></library_nodes>");
    says(
        document("", &library, r##"<node><instance_node url="#n0"/></node>"##),
        "expected at most 100000 nodes in a scene",
    );
}

#[test]
fn one_mesh_instanced_often_cannot_fill_the_memory() {
    let many = "0 1 2 ".repeat(20_000);
    let mesh = geometry("g", "0 0 0 1 0 0 0 1 0", "", &triangles("g", &many));
    let node = format!("<node>{}</node>", instance("g").repeat(1_000));
    says(
        document("", &geometries(&mesh), &node),
        "positions and triangles, found more",
    );
}

#[test]
fn meshes_instanced_without_end_are_refused() {
    // Without positions they would pass the count of these.
    let library = |mesh: &str, inside: &str| {
        geometries(mesh) + &format!("<library_nodes><node id=\"n\">{inside}</node></library_nodes>")
    };
    let unfolded = r##"<instance_node url="#n"/>"##.repeat(20_000);
    let empty = geometry("g", "", "", "");
    says(
        document("", &library(&empty, &instance("g").repeat(200)), &unfolded),
        "expected positions, found none",
    );
    let point = geometry("g", "0 0 0", "", "");
    says(
        document("", &library(&point, &instance("g").repeat(200)), &unfolded),
        "expected at most 100000 meshes in a scene, found more",
    );
    // Nodes are few here, and what is in them is nothing to show, but looked at each time.
    says(
        document("", &library(&point, &"<extra/>".repeat(50_000)), &unfolded),
        "expected at most 4000000 elements in the nodes of a scene, found more",
    );
}

#[test]
fn a_skin_instanced_without_end_is_refused() {
    let joints = "a ".repeat(20_000);
    let skin = Skin {
        joints: &joints,
        ..Skin::default()
    };
    let nodes = joint("a", "0 1 0", "") + &skinned("c", &["ID-a"]).repeat(5_000);
    let libraries = geometries(&triangle("g")) + &controllers(&skin.xml());
    says(
        document("", &libraries, &nodes),
        "expected at most 32000000 joints and weights, found more",
    );
}

#[test]
fn primitives_without_triangles_cost_nothing() {
    let instanced = |count: usize| {
        let none = triangles("g", "").repeat(count);
        let last = triangles("g", "0 1 2");
        let mesh = geometry("g", "0 0 0 1 0 0 0 1 0", "", &(none + &last));
        let node = format!("<node>{}</node>", instance("g").repeat(count));
        document("", &geometries(&mesh), &node)
    };
    grows_in_proportion(2_500, instanced, |text| {
        survive(text);
    });
}

#[test]
fn deep_nesting_is_refused_without_recursion() {
    let deep = |tag: &str, depth: usize| {
        let close = tag.split(' ').next().unwrap_or(tag);
        format!(
            "{}{}",
            format!("<{tag}>").repeat(depth),
            format!("</{close}>").repeat(depth)
        )
    };
    says(
        document("", "", &deep("node", 200_000)),
        "1000 inside one another, found more",
    );
    survive(document("", &deep("library_x", 200_000), ""));
    survive(static_document(&deep("geometry id=\"g\"", 50_000)));
    survive("<a>".repeat(500_000));
}

#[test]
fn what_makes_the_xml_reader_slow_is_refused() {
    let attributes: String = (0..100_000).map(|i| format!(" a{i}=\"\"")).collect();
    says(
        format!("<COLLADA{attributes}/>"),
        "expected at most 256 attributes",
    );
    let attributes: String = (0..60_000).map(|i| format!(" a{i}=\"\"")).collect();
    for before in ["x='>'", "x='<!--'", "x='a=b=c'"] {
        says(
            format!("<COLLADA {before}{attributes}/>"),
            "error a.dae:1:1: expected at most 256 attributes",
        );
    }
    for before in ["<!-- ' -->", "<?a ' ?>", "<?a <b ' ?>"] {
        says(
            format!("{before}<COLLADA{attributes}/>"),
            "error a.dae:1:1: expected at most 256 attributes",
        );
    }
    says(
        format!("<COLLADA><![CDATA[<a ']]><b{attributes}/></COLLADA>"),
        "error a.dae:1:1: expected at most 256 attributes",
    );
    let equal = format!("<COLLADA x='{}'/>", "=".repeat(1_000));
    says(equal, "expected <library_visual_scenes>");
    let spaces: String = (0..20_000)
        .map(|i| format!("<a xmlns:p{i}=\"u\">"))
        .collect();
    says(format!("<COLLADA>{spaces}"), "name spaces, found more");
}

#[test]
fn counts_in_attributes_reserve_nothing() {
    let huge = "18446744073709551615";
    let text = static_document(&triangle("g"));
    let changed = |from: &str, to: &str| text.replace(from, &to.replace("HUGE", huge));
    for (from, to, part) in [
        (
            "count=\"3\" stride",
            "count=\"HUGE\" stride",
            "expected numbers for 18446744073709551615 rows, found 9, enough for 3",
        ),
        (
            "stride=\"3\"",
            "stride=\"HUGE\"",
            "expected numbers for 3 rows",
        ),
        (
            "stride=\"3\"",
            "stride=\"0\"",
            "error a.dae:5:19: expected a stride of at least 3, found 0",
        ),
        (
            "stride=\"3\"",
            "stride=\"-1\"",
            "expected stride=\"a count\", found “-1”",
        ),
        (
            "offset=\"0\"",
            "offset=\"HUGE\"",
            "expected an offset of at most 64",
        ),
    ] {
        says(changed(from, to), part);
    }
    survive(changed("<accessor", "<accessor offset=\"HUGE\""));
    survive(changed("count=\"1\"", "count=\"HUGE\""));
    let skin = Skin {
        vcount: "4294967295 1 1",
        ..Skin::default()
    };
    says(arm(&skin), "expected <v> as long as <vcount> says");
    let polygons = r##"<polylist><input semantic="VERTEX" source="#g-v" offset="0"/><vcount>4294967295 3</vcount><p>0 1 2</p></polylist>"##;
    says(
        static_document(&geometry("g", "0 0 0 1 0 0 0 1 0", "", polygons)),
        "expected <p> as long as <vcount> says, found 3 vertices",
    );
}

#[test]
fn indices_out_of_range_leave_their_triangle_or_weight_out() {
    for (corners, part) in [
        (
            "0 1 2 0 1 3 0 4294967295 2",
            "found others in 2 triangles: left out",
        ),
        ("0 1 -2", "expected an index, found “-2”"),
    ] {
        let corners = triangles("g", corners);
        says(
            static_document(&geometry("g", "0 0 0 1 0 0 0 1 0", "", &corners)),
            part,
        );
    }
    for (vcount, v, part) in [
        (
            "1 1 1",
            "0 0 2 0 0 1",
            "found others 2 times, first joint 2 with weight 0 at position 1 (from 0): left out",
        ),
        (
            "1 1 1",
            "-1 0 0 0 0 0",
            "found others 1 time, first joint -1 with weight 0 at position 0 (from 0): left out",
        ),
        ("1 1 1", "0 0 0", "expected <v> as long as <vcount> says"),
        (
            "1 1",
            "0 0 0 0",
            "expected weights for 3 positions, found 2",
        ),
        ("1 1 1 1", "0 0 0 0 0 0 0 0", "found 4"),
    ] {
        let skin = Skin {
            joints: "a b",
            vcount,
            v,
            ..Skin::default()
        };
        says(arm(&skin), part);
    }
}

#[test]
fn numbers_that_are_not_finite_count_as_zero() {
    for word in [
        "nan",
        "-NaN",
        "inf",
        "-Infinity",
        "1.#QNAN",
        "-1.#IND",
        "1e999",
    ] {
        let text = static_document(&geometry(
            "g",
            &format!("0 0 0 {word} 0 0 0 1 0"),
            "",
            &triangles("g", "0 1 2"),
        ));
        says(
            text,
            "expected finite numbers in <float_array>, found 1 that are not: taken as 0",
        );
    }
    let weights = Skin {
        weights: "nan 1",
        v: "0 0 0 1 0 1",
        ..Skin::default()
    };
    says(arm(&weights), "a.dae:");
    let weights = good().replacen("0.5 1", "half 1", 1);
    says(
        weights,
        "expected a number, found “half”: the weights are left out",
    );
    let matrix = good().replacen(IDENTITY, "nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", 1);
    says(matrix, "expected a number, found “nan”");
    for numbers in ["1e30 0 0", "1e308 0 0"] {
        let far = format!(
            "<node><translate>{numbers}</translate>{}</node>",
            instance("g")
        );
        says(
            document("", &geometries(&triangle("g")), &far),
            "found 3 others: put there",
        );
        says(
            good().replacen("<translate>0 1 0", &format!("<translate>{numbers}"), 1),
            "error a.dae",
        );
    }
    let overflow = "<scale>1e300 1 1</scale>".repeat(2);
    says(
        good().replacen("<translate>", &(overflow + "<translate>"), 1),
        "expected a transform with finite numbers",
    );
}

#[test]
fn a_missing_or_mistaken_reference_is_told_where_it_is() {
    for (from, to, part) in [
        (
            "#g-p\"",
            "#gone\"",
            "expected the id of an element, found “#gone”",
        ),
        (
            "url=\"#c\"",
            "url=\"#g\"",
            "expected a reference to <controller>, found <geometry> “g”",
        ),
        ("url=\"#c\"", "url=\"other.dae#c\"", "found “other.dae#c”"),
        (
            "url=\"#c\"",
            "",
            "expected url=\"#…\" in <instance_controller>",
        ),
        (
            "skin source=\"#g\"",
            "skin source=\"#c\"",
            "expected a reference to <geometry>",
        ),
        (
            "semantic=\"WEIGHT\"",
            "semantic=\"W\"",
            "expected an <input> with the WEIGHT",
        ),
        (
            "semantic=\"POSITION\"",
            "semantic=\"P\"",
            "expected an <input> with the POSITION",
        ),
        ("mesh>", "spline>", "expected <mesh>"),
        ("url=\"#Scene\"", "url=\"#x\"", "found “#x”"),
        (
            "<skeleton>#ID-a",
            "<skeleton>#c-w",
            "expected a node of the scene",
        ),
        (
            "id=\"ID-b\"",
            "id=\"ID-a\"",
            "expected every id once, found “ID-a” again",
        ),
    ] {
        says(good().replace(from, to), part);
    }
}

#[test]
fn large_concave_polygons_do_not_take_for_ever() {
    let comb = |teeth: usize| -> (String, String) {
        let zigzag = (0..teeth).map(|i| format!("{i} {} 0 ", (i % 2) * 10));
        let numbers: String = zigzag.chain(["0 -1 0".to_owned()]).collect();
        let indices: String = (0..=teeth).rev().map(|i| format!("{i} ")).collect();
        (numbers, indices)
    };
    for (teeth, copies) in [(400, 200), (100_000, 1)] {
        let (numbers, indices) = comb(teeth);
        let polygons = format!(
            r##"<polygons><input semantic="VERTEX" source="#g-v" offset="0"/>{}</polygons>"##,
            format!("<p>{indices}</p>").repeat(copies)
        );
        survive(static_document(&geometry("g", &numbers, "", &polygons)));
    }
}

#[test]
fn many_warnings_are_counted_and_not_kept() {
    let nodes = r##"<instance_node url="#gone"/>"##.repeat(5_000);
    let text = document(
        "",
        &geometries(&triangle("g")),
        &format!("<node>{nodes}{}</node>", instance("g")),
    );
    let imported = import(&text);
    assert_eq!(imported.warnings.len(), 101);
    assert_warns(&imported, "4900 more warnings are not shown");
}

#[test]
fn text_that_is_not_utf8_spoils_names_only() {
    let text = good().replace("Name a", "N\u{e9}");
    let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let imported = import_bytes(latin).unwrap();
    assert_eq!(
        imported.value.characters[0].character.skeleton().joints()[0].name,
        "N\u{fffd}"
    );
}

#[test]
fn every_prefix_of_a_good_file_is_an_error() {
    let text = good();
    assert_eq!(survive(text.as_str()), "");
    for end in 0..text.trim_end().len() {
        let said = survive(&text.as_bytes()[..end]);
        assert!(said.starts_with("error a.dae:"), "{end}: {said}");
    }
}

#[test]
fn every_missing_line_or_word_is_survived() {
    let text = good();
    let words: Vec<&str> = text.split_inclusive(['>', ' ']).collect();
    for left_out in 0..words.len() {
        let mut words = words.clone();
        words.remove(left_out);
        survive(words.concat());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn bytes_changed_at_random_are_survived(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6)
    ) {
        let mut bytes = good().into_bytes();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        survive(bytes);
    }

    #[test]
    fn numbers_changed_at_random_are_survived(
        changes in prop::collection::vec(
            (any::<prop::sample::Index>(), prop::sample::select(vec![
                "-1", "0", "7", "4294967295", "18446744073709551615", "1e38", "nan", "", "#a", "99999999",
            ])),
            1..4,
        )
    ) {
        let text = good();
        let mut words: Vec<&str> = text.split_inclusive([' ', '"', '>', '<']).collect();
        let numbers: Vec<usize> = (0..words.len())
            .filter(|&at| words[at].starts_with(|c: char| c.is_ascii_digit()))
            .collect();
        let swapped: Vec<(usize, String)> = changes
            .iter()
            .map(|(at, number)| {
                let at = numbers[at.index(numbers.len())];
                let end = words[at].chars().last().filter(|c| !c.is_ascii_digit());
                (at, format!("{number}{}", end.map(String::from).unwrap_or_default()))
            })
            .collect();
        for (at, word) in &swapped {
            words[*at] = word;
        }
        survive(words.concat());
    }
}

#[test]
fn a_picture_or_an_archive_under_the_name_of_a_model_is_said_to_be_one() {
    for (bytes, found) in [
        (&b"\xff\xd8\xff\xe0\0\x10JFIF\0"[..], "a JPEG picture"),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "a PNG picture"),
        (b"PK\x03\x04rest", "a .zip archive"),
    ] {
        let said = survive(bytes);
        assert!(
            said.contains(&format!("expected Collada, found {found}")),
            "{said}"
        );
    }
}
