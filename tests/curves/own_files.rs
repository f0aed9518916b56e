//! The curves that come with the program.

use crate::curves::support::{Merged, evaluate, read, volume};
use editor_core::scene::EvaluatedGeometry;
use std::path::Path;
use std::sync::Arc;

fn own(name: &str) -> Arc<EvaluatedGeometry> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/curves");
    let path = folder.join(name).with_extension("swp");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path:?}: {e}"));
    evaluate(read(&text).unwrap_or_else(|e| panic!("{name}: {e}")), true)
}

#[test]
fn what_is_turned_is_a_solid_body_the_right_side_out() {
    for name in ["vase", "goblet", "pawn"] {
        let mesh = &own(name).mesh;
        let merged = Merged::new(mesh);
        assert!(
            merged.is_watertight() && merged.winds_consistently(),
            "{name}"
        );
        assert_eq!(merged.euler_characteristic(), 2, "{name}");
        assert!(volume(&mesh.positions, &mesh.triangles) > 0.0, "{name}");
    }
}

#[test]
fn the_knot_and_the_seam_close_although_they_are_not_flat() {
    for name in ["knot", "seam"] {
        let geometry = own(name);
        let merged = Merged::new(&geometry.mesh);
        assert!(
            merged.is_watertight() && merged.winds_consistently(),
            "{name}"
        );
        assert_eq!(merged.euler_characteristic(), 0, "{name}");
        let mesh = &geometry.mesh;
        assert!(volume(&mesh.positions, &mesh.triangles) > 0.0, "{name}");
        let curves = &geometry.curves.as_ref().unwrap().curves;
        let angles: Vec<f32> = curves.iter().filter_map(|c| c.closing_angle).collect();
        assert_eq!(angles.len(), 1, "{name}");
    }
}

#[test]
fn the_spring_is_an_open_tube() {
    let merged = Merged::new(&own("spring").mesh);
    assert!(merged.winds_consistently() && !merged.is_watertight());
    assert_eq!(merged.euler_characteristic(), 0);
}

#[test]
fn all_fit_into_the_first_view() {
    for name in ["vase", "goblet", "pawn", "knot", "seam", "spring"] {
        let bounds = own(name).mesh.bounds();
        assert!(bounds.max.max(-bounds.min).max_element() < 2.0, "{name}");
    }
}
