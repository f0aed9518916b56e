//! Numbers of joints that are off by one in a Collada skin's own list, which begins after the root.

use crate::collada::support::{
    Skin, controllers, document, geometries, geometry, import_clean, joint, skinned, triangles,
};
use editor_core::character::{Character, Pose};
use editor_core::diagnose::diagnose;
use editor_core::geometry::Mesh;
use editor_core::math::Euler;
use glam::{Mat4, Vec3};

/// The root, which the skin's list lacks, and three joints each of which hangs on the one before it.
const OFFSETS: [Vec3; 4] = [Vec3::Y, Vec3::X, Vec3::new(0.5, 0.5, 0.0), Vec3::Z];
const LISTED: usize = 3;
const VERTICES: usize = 24;

fn positions() -> Vec<Vec3> {
    let at = |at: usize| [7, 11, 13].map(|step| (at * step % 31) as f32 / 20.0 - 0.7);
    (0..VERTICES).map(|vertex| Vec3::from(at(vertex))).collect()
}

/// Places in the skin's list of the two joints that move a vertex, each by half.
fn places(vertex: usize) -> [usize; 2] {
    [vertex % LISTED, (vertex + 1) % LISTED]
}

fn figure() -> Character {
    let numbers: Vec<String> = positions()
        .iter()
        .flat_map(|at| at.to_array().map(|number| number.to_string()))
        .collect();
    let shape = geometry("g", &numbers.join(" "), "", &triangles("g", "0 1 2 3 4 5"));
    let v = (0..VERTICES).flat_map(places).map(|place| format!("{place} 0"));
    let skin = Skin {
        joints: "a b c",
        weights: "0.5",
        vcount: &"2 ".repeat(VERTICES),
        v: &v.collect::<Vec<_>>().join(" "),
        ..Skin::default()
    };
    let offset = |joint: usize| OFFSETS[joint].to_array().map(|number| number.to_string()).join(" ");
    let node = ["r", "a", "b", "c"].into_iter().enumerate().rev();
    let nodes = node.fold(String::new(), |below, (index, name)| joint(name, &offset(index), &below));
    let libraries = geometries(&shape) + &controllers(&skin.xml());
    let scene = import_clean(&document("", &libraries, &(nodes + &skinned("c", &["ID-r"]))));
    scene.characters.into_iter().next().unwrap().character
}

fn turned(joint: usize) -> Euler {
    Euler::from_degrees(Vec3::new(20.0, -15.0, 35.0) * (joint as f32 - 0.5))
}

/// The transforms of all joints to model space, each turned as `turned` says.
fn model_from_joints(turned: impl Fn(usize) -> Euler) -> Vec<Mat4> {
    let mut above = Mat4::IDENTITY;
    let joints = OFFSETS.into_iter().enumerate().map(|(joint, offset)| {
        above *= Mat4::from_translation(offset) * turned(joint).to_mat4();
        above
    });
    joints.collect()
}

/// What a program writes that takes the joint at another `place` of the list, without the inverse of B if it has none.
fn theirs(has_inverse_bind: bool, place: impl Fn(usize) -> usize) -> Mesh {
    let posed = model_from_joints(turned);
    let bind = model_from_joints(|_| Euler::default());
    let moved = |place: usize, at: Vec3| {
        let inverse_bind = if has_inverse_bind { bind[place + 1].inverse() } else { Mat4::IDENTITY };
        (posed[place + 1] * inverse_bind).transform_point3(at)
    };
    let vertices = positions().into_iter().enumerate().map(|(vertex, at)| {
        let [one, other] = places(vertex).map(|own| moved(place(own), at));
        one.midpoint(other)
    });
    Mesh::new(vertices.collect(), vec![[0, 1, 2], [3, 4, 5]])
}

#[test]
fn numbers_that_are_off_by_one_in_a_skins_list_are_named_by_what_becomes_of_the_one_at_its_end() {
    let (character, mut pose) = (figure(), Pose::new());
    for joint in 0..OFFSETS.len() {
        pose.set_joint_transform(joint, turned(joint));
    }
    type Off = fn(usize) -> usize;
    let ways: [(Off, &str, &str); 4] = [
        (|at| (at + 1) % LISTED, "weights-shifted-on", "the last one for the joint that has the first"),
        (|at| (at + 1).min(LISTED - 1), "weights-shifted-on", "the last one for itself"),
        (|at| (at + LISTED - 1) % LISTED, "weights-shifted", "the first one for the last joint"),
        (|at| at.saturating_sub(1), "weights-shifted", "the first one for itself"),
    ];
    for (off, id, how) in ways {
        let found = diagnose(&character, &pose, &theirs(true, off)).unwrap();
        assert_eq!(found.together(), [id], "{how}: {found}");
        assert_eq!(found.mistakes[0].how, how, "{found}");
        let found = diagnose(&character, &pose, &theirs(false, off)).unwrap();
        let together = sorted(&found);
        assert_eq!(together, ["no-inverse-bind", id], "{how}: {found}");
        let shifted = found.mistakes.iter().find(|mistake| mistake.id == id).unwrap();
        assert_eq!(shifted.how, how, "{found}");
    }
}
