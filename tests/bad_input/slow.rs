//! Files that would take forever if their time grew with the square of their size.

use crate::work::work;
use editor_core::io::{PoseFile, read_character_obj};
use std::path::Path;
use std::time::Duration;

#[test]
fn many_large_concave_faces_do_not_take_forever() {
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

#[test]
fn a_face_of_a_hundred_thousand_corners_does_not_take_forever() {
    let corner = |i: usize| format!("v {i} {} 0\n", if i.is_multiple_of(2) { 1000 } else { 1 });
    let mut text: String = (0..100_000).map(corner).collect();
    text.push('f');
    (1..=100_000).for_each(|i| text.push_str(&format!(" {i}")));
    let mesh = read_character_obj(Path::new("a.obj"), text.as_bytes()).unwrap();
    assert_eq!(mesh.value.triangles.len(), 99_998);
}

#[test]
fn a_pose_file_with_many_joints_that_do_not_exist_does_not_take_forever() {
    let joints: Vec<String> = (0..200_000)
        .map(|i| format!("\"{i}\": [0, 0, 0]"))
        .collect();
    let text = format!("{{\"joints\": {{{}, 7: 0}}}}", joints.join(","));
    let error = PoseFile::read(Path::new("p.json"), text.as_bytes()).unwrap_err();
    assert_eq!(error.position.unwrap().column, text.len() - 5);
}
