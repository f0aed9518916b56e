//! The shapes: polygons that a reader may cut into triangles as it likes.
use crate::assets::asset;
use crate::assets::surface::Surface;
use std::collections::BTreeSet;

#[test]
fn gear_and_gem_are_closed_and_face_outward() {
    for name in ["gear", "gem"] {
        let shape = Surface::read(&asset(&format!("shapes/{name}.obj")));
        shape.assert_closed(name);
        assert!(shape.volume() > 0.05, "{name}");
    }
}

#[test]
fn faces_are_flat_enough_and_convex() {
    for name in ["gear", "gem", "plant"] {
        let shape = Surface::read(&asset(&format!("shapes/{name}.obj")));
        for face in &shape.faces {
            let n = face.len();
            let corner =
                |i: usize| shape.cross([face[(i + n - 1) % n], face[i], face[(i + 1) % n]]);
            let normal = (0..n).map(corner).sum::<glam::DVec3>();
            for i in 0..n {
                let turn = corner(i);
                assert!(turn.dot(normal) > 0.0, "{name}: corner {i} of {face:?}");
            }
        }
    }
}

#[test]
fn there_are_triangles_quads_and_larger_polygons() {
    let sizes = |name: &str| -> BTreeSet<usize> {
        let shape = Surface::read(&asset(&format!("shapes/{name}.obj")));
        shape.faces.iter().map(Vec::len).collect()
    };
    assert_eq!(sizes("gear"), BTreeSet::from([4, 6]));
    assert_eq!(sizes("gem"), BTreeSet::from([3, 4, 8]));
    assert!(sizes("plant").contains(&32));
}

#[test]
fn the_plant_uses_every_material_of_its_library() {
    let words = |text: &str, key: &str| -> BTreeSet<String> {
        let after = |line: &str| line.strip_prefix(key).map(|name| name.trim().to_owned());
        text.lines().filter_map(after).collect()
    };
    let plant = asset("shapes/plant.obj");
    assert_eq!(
        words(&plant, "mtllib "),
        BTreeSet::from(["plant.mtl".to_owned()])
    );
    let made = words(&asset("shapes/plant.mtl"), "newmtl ");
    assert_eq!(made.len(), 4);
    assert_eq!(words(&plant, "usemtl "), made);
}

#[test]
fn the_plants_normals_are_unit_vectors() {
    let text = asset("shapes/plant.obj");
    let normals = text.lines().filter_map(|line| line.strip_prefix("vn "));
    let lengths = normals.map(|n| {
        n.split_whitespace()
            .map(crate::assets::surface::float)
            .map(|x| x * x)
            .sum::<f64>()
    });
    let lengths: Vec<f64> = lengths.collect();
    assert!(lengths.len() > 1000);
    assert!(lengths.iter().all(|l| (l - 1.0).abs() < 1e-3));
}
