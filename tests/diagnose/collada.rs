//! Mistakes with what only Collada files have: joints that are turned at rest, and the matrix of a skin.

use crate::collada::support::{
    Skin, controllers, document, geometries, geometry, import_clean, joint, skinned, triangles,
};
use editor_core::character::{Character, Pose};
use editor_core::diagnose::{Verdict, diagnose};
use editor_core::geometry::Mesh;
use editor_core::math::Euler;
use glam::{Mat4, Vec3};

const PLACES: [f32; 2] = [1.0, 2.0];
const DEGREES: [Vec3; 2] = [Vec3::new(10.0, 20.0, 30.0), Vec3::new(40.0, -20.0, 15.0)];

fn bind_shape() -> Mat4 {
    Mat4::from_translation(Vec3::new(0.5, -1.0, 0.25)) * Mat4::from_rotation_x(-1.2)
}

/// Joints at rest: the first one turned by a quarter about z, the second one about x besides.
fn at_rest() -> [Mat4; 2] {
    let first = Mat4::from_translation(Vec3::Y) * Mat4::from_rotation_z(90_f32.to_radians());
    let second = Mat4::from_translation(Vec3::X) * Mat4::from_rotation_x(30_f32.to_radians());
    [first, first * second]
}

fn positions() -> Vec<Vec3> {
    let at = |at: usize| [7, 11, 13].map(|step| (at * step % 31) as f32 / 15.0 - 1.0);
    (0..24).map(|vertex| Vec3::from(at(vertex))).collect()
}

/// Share of the second joint.
fn share(vertex: usize) -> f32 {
    [0.0, 0.25, 1.0][vertex % 3]
}

fn rows(matrix: Mat4) -> String {
    let numbers = matrix.transpose().to_cols_array();
    numbers.map(|number| number.to_string()).join(" ")
}

fn arm() -> Character {
    let numbers: Vec<String> = positions()
        .iter()
        .flat_map(|at| at.to_array().map(|number| number.to_string()))
        .collect();
    let shape = geometry("g", &numbers.join(" "), "", &triangles("g", "0 1 2 3 4 5"));
    let inverse_binds = at_rest().map(|matrix| rows(matrix.inverse())).join(" ");
    let v = (0..24).map(|vertex| match vertex % 3 {
        0 => "0 2 1 0".to_owned(),
        1 => "0 3 1 1".to_owned(),
        _ => "0 0 1 2".to_owned(),
    });
    let skin = Skin {
        bind_shape: &rows(bind_shape()),
        joints: "a b",
        inverse_binds: &inverse_binds,
        weights: "0 0.25 1 0.75",
        vcount: &"2 ".repeat(24),
        v: &v.collect::<Vec<_>>().join(" "),
        ..Skin::default()
    };
    let turned = "<rotate>0 0 1 90</rotate>";
    let below = joint("b", "1 0 0", "<rotate>1 0 0 30</rotate>");
    let nodes = joint("a", "0 1 0", &(turned.to_owned() + &below)) + &skinned("c", &["ID-a"]);
    let libraries = geometries(&shape) + &controllers(&skin.xml());
    let scene = import_clean(&document("", &libraries, &nodes));
    scene.characters.into_iter().next().unwrap().character
}

/// The joints in the pose, as the file has them.
fn in_pose() -> [Mat4; 2] {
    let rotation = |joint: usize| Euler::from_degrees(DEGREES[joint]).to_mat4();
    let places = PLACES.map(|y| Mat4::from_translation(Vec3::Y * y));
    let first = places[0] * rotation(0);
    let second = first * places[0].inverse() * places[1] * rotation(1);
    let turn = |joint: usize| places[joint].inverse() * at_rest()[joint];
    [first * turn(0), second * turn(1)]
}

/// What a program writes that moves a vertex by `moved` with each joint.
fn theirs(moved: impl Fn(usize) -> Mat4) -> Mesh {
    let places = positions().into_iter().enumerate().map(|(vertex, at)| {
        let [a, b] = [0, 1].map(|joint| moved(joint).transform_point3(at));
        a.lerp(b, share(vertex))
    });
    Mesh::new(places.collect(), vec![[0, 1, 2], [3, 4, 5]])
}

#[test]
fn what_is_left_out_of_a_collada_skin_is_named_though_its_joints_are_turned_at_rest() {
    let character = arm();
    let mut pose = Pose::new();
    for (joint, degrees) in DEGREES.into_iter().enumerate() {
        pose.set_joint_transform(joint, Euler::from_degrees(degrees));
    }
    let (posed, rest, shape) = (in_pose(), at_rest(), bind_shape());
    let right = theirs(|joint| posed[joint] * rest[joint].inverse() * shape);
    let found = diagnose(&character, &pose, &right).unwrap();
    assert_eq!(found.verdict, Verdict::Right, "{found}");
    for (theirs, ids) in [
        (
            theirs(|joint| posed[joint] * shape),
            vec!["no-inverse-bind"],
        ),
        (
            theirs(|joint| posed[joint] * rest[joint].inverse()),
            vec!["bind-shape-missing"],
        ),
        (
            theirs(|joint| posed[joint]),
            vec!["bind-shape-missing", "no-inverse-bind"],
        ),
    ] {
        let found = diagnose(&character, &pose, &theirs).unwrap();
        let mut told = found.together();
        told.sort_unstable();
        assert_eq!(told, ids, "{found}");
        assert!(found.error < 1e-5, "{found}");
    }
}
