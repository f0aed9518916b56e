//! Files that would take for ever if their time grew with the square of their size.

use crate::work::work;
use editor_core::io::read_character_obj;
use std::path::Path;
use std::time::Duration;

#[test]
fn many_large_dented_faces_do_not_take_for_ever() {
    // A spiral, out and back, whose windings lie in the way of each other's ears.
    let around = |i: usize, more: f32| {
        let (angle, radius) = (i as f32 * std::f32::consts::TAU / 12.0, i as f32 * 0.02);
        let radius = 10.0 + radius + more;
        format!("v {} {} 0\n", radius * angle.cos(), radius * angle.sin())
    };
    let out = (0..256).map(|i| around(i, 0.1));
    let back = (0..256).rev().map(|i| around(i, 0.0));
    let mut text: String = out.chain(back).collect();
    let face: String = (1..=512).map(|i| format!(" {i}")).collect();
    text.push_str(&format!("f{face}\n").repeat(1_000));
    let read = || read_character_obj(Path::new("a.obj"), text.as_bytes());
    let (mesh, time) = work(read);
    assert_eq!(mesh.unwrap().value.triangles.len(), 510 * 1_000);
    assert!(time < Duration::from_secs(20), "{time:?}");
}
