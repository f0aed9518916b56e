//! Mistakes with what only Collada files have: joints that are turned at rest, and the matrix of a skin.

use crate::collada::support::{
    Skin, controllers, document, geometries, geometry, import_clean, joint, skinned, triangles,
};
use crate::diagnose::sorted;
use editor_core::character::{Character, Pose};
use editor_core::diagnose::{Mistake, ToldFor, Verdict, diagnose};
use editor_core::geometry::Mesh;
use editor_core::math::Euler;
use glam::{Mat3, Mat4, Vec3, Vec4, Vec4Swizzles};

const ASSET: &str = r#"<unit meter="0.5"/><up_axis>Z_UP</up_axis>"#;
const DEGREES: [Vec3; 2] = [Vec3::new(10.0, 20.0, 30.0), Vec3::new(40.0, -20.0, 15.0)];

fn bind_shape() -> Mat4 {
    Mat4::from_translation(Vec3::new(0.1, -1.0, 0.25)) * Mat4::from_rotation_x(-1.2)
}

/// What the asset says of units and axes.
fn ours_from_file() -> Mat4 {
    Mat4::from_scale(Vec3::splat(0.5)) * Mat4::from_rotation_x(-90_f32.to_radians())
}

/// Joints at rest: the first one turned by a quarter about z, the second one about x besides.
fn at_rest() -> [Mat4; 2] {
    let first = Mat4::from_translation(Vec3::Y) * Mat4::from_rotation_z(90_f32.to_radians());
    let second = Mat4::from_translation(Vec3::X) * Mat4::from_rotation_x(30_f32.to_radians());
    [first, first * second]
}

fn positions() -> Vec<Vec3> {
    let at = |at: usize| [7, 11, 13].map(|step| (at * step % 31) as f32 / 40.0 - 0.4);
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
    arm_with_list([0, 1])
}

/// The same whose skin has its joints in this order.
fn arm_with_list(list: [usize; 2]) -> Character {
    arm_of(list, bind_shape())
}

/// The same whose skin places its mesh by `bind_shape`.
fn arm_of(list: [usize; 2], bind_shape: Mat4) -> Character {
    let numbers: Vec<String> = positions()
        .iter()
        .flat_map(|at| at.to_array().map(|number| number.to_string()))
        .collect();
    let shape = geometry("g", &numbers.join(" "), "", &triangles("g", "0 1 2 3 4 5"));
    let inverse_binds = list.map(|joint| rows(at_rest()[joint].inverse())).join(" ");
    let number = |joint: usize| list.iter().position(|it| *it == joint).unwrap();
    let (a, b) = (number(0), number(1));
    let v = (0..24).map(|vertex| match vertex % 3 {
        0 => format!("{a} 2 {b} 0"),
        1 => format!("{a} 3 {b} 1"),
        _ => format!("{a} 0 {b} 2"),
    });
    let skin = Skin {
        bind_shape: &rows(bind_shape),
        joints: &list.map(|joint| ["a", "b"][joint]).join(" "),
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
    let scene = import_clean(&document(ASSET, &libraries, &nodes));
    scene.characters.into_iter().next().unwrap().character
}

/// What the pose moves the root by.
const MOVED: Vec3 = Vec3::new(0.3, -0.2, 0.4);

fn rotation(joint: usize) -> Mat4 {
    Euler::from_degrees(DEGREES[joint]).to_mat4()
}

/// The joints in the pose, with the directions that the file gives them.
fn in_pose() -> [Mat4; 2] {
    in_pose_from(ours_from_file())
}

/// The same in other axes and units.
fn in_pose_from(from_file: Mat4) -> [Mat4; 2] {
    let at_rest = at_rest().map(|matrix| from_file * matrix);
    let places = at_rest.map(|matrix| Mat4::from_translation(matrix.w_axis.xyz()));
    let first = Mat4::from_translation(MOVED) * places[0] * rotation(0);
    let second = first * places[0].inverse() * places[1] * rotation(1);
    let directions = at_rest.map(|matrix| Mat4::from_mat3(Mat3::from_mat4(matrix)));
    [first * directions[0], second * directions[1]]
}

/// The same where each joint is turned by `turns` about its own axes.
fn about_bones(turns: [Mat4; 2]) -> [Mat4; 2] {
    let rest = at_rest();
    let first = Mat4::from_translation(MOVED) * ours_from_file() * rest[0] * turns[0];
    [first, first * rest[0].inverse() * rest[1] * turns[1]]
}

/// Whether a program divides by the fourth coordinate.
#[derive(Clone, Copy)]
enum Divides {
    Yes,
    No,
}

/// What a program writes that moves a vertex by `moved` with each joint.
fn theirs(moved: impl Fn(usize) -> Mat4) -> Mesh {
    theirs_in_four(Divides::No, moved)
}

fn theirs_in_four(divides: Divides, moved: impl Fn(usize) -> Mat4) -> Mesh {
    let places = positions().into_iter().enumerate().map(|(vertex, at)| {
        let [a, b]: [Vec4; 2] = [0, 1].map(|joint| moved(joint) * at.extend(1.0));
        let sum = a.lerp(b, share(vertex));
        match divides {
            Divides::Yes => sum.xyz() / sum.w,
            Divides::No => sum.xyz(),
        }
    });
    Mesh::new(places.collect(), vec![[0, 1, 2], [3, 4, 5]])
}

fn pose() -> Pose {
    let mut pose = Pose::new();
    for (joint, degrees) in DEGREES.into_iter().enumerate() {
        pose.set_joint_transform(joint, Euler::from_degrees(degrees));
    }
    pose.set_root_offset(0, MOVED);
    pose
}

#[test]
fn what_is_left_out_of_a_collada_skin_is_named_though_its_joints_are_turned_at_rest() {
    let character = arm();
    let pose = pose();
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
        let told = sorted(&found);
        assert_eq!(told, ids, "{found}");
        assert!(found.error < 1e-5, "{found}");
    }
}

#[test]
fn numbers_of_a_skins_list_that_are_taken_for_places_among_all_bones_are_named() {
    let (posed, shape) = (in_pose(), bind_shape());
    let inverse_bind = at_rest().map(|matrix| matrix.inverse());
    let listed_otherwise = arm_with_list([1, 0]);
    let right = theirs(|joint| posed[joint] * inverse_bind[joint] * shape);
    let found = diagnose(&listed_otherwise, &pose(), &right).unwrap();
    assert_eq!(found.verdict, Verdict::Right, "{found}");
    for (of_bone, how) in [
        (true, ""),
        (
            false,
            "while inverse bind matrices are those of the skin's own list",
        ),
    ] {
        let theirs = theirs(|joint| {
            let bone = 1 - joint;
            posed[bone] * inverse_bind[if of_bone { bone } else { joint }] * shape
        });
        let found = diagnose(&listed_otherwise, &pose(), &theirs).unwrap();
        assert_eq!(found.together(), ["skin-list-ignored"], "{found}");
        assert_eq!(found.mistakes[0].how, how, "{found}");
        // Where both lists are one it is another mistake.
        let found = diagnose(&arm(), &pose(), &theirs).unwrap();
        assert!(!found.causes.contains(&"skin-list-ignored"), "{found}");
    }
}

#[test]
fn matrices_of_a_skin_that_are_read_by_columns_are_named() {
    let (posed, rest, shape) = (in_pose(), at_rest(), bind_shape());
    let of_inverse_bind = |joint: usize| posed[joint] * rest[joint].inverse().transpose() * shape;
    let of_both = |joint: usize| (posed[joint] * rest[joint].inverse()).transpose() * shape;
    let of_shape = |joint: usize| posed[joint] * rest[joint].inverse() * shape.transpose();
    let as_points = Mat4::from_mat3(Mat3::from_mat4(shape).transpose());
    let of_points = |joint: usize| posed[joint] * rest[joint].inverse() * as_points;
    let of_skin_as_points =
        |joint: usize| posed[joint] * rest[joint].inverse().transpose() * as_points;
    let of_skin =
        |joint: usize| posed[joint] * rest[joint].inverse().transpose() * shape.transpose();
    for (theirs, told) in [
        (
            theirs(of_inverse_bind),
            "of the inverse of B in a Collada file",
        ),
        (
            theirs_in_four(Divides::Yes, of_inverse_bind),
            "of the inverse of B in a Collada file, and the sum is divided by its fourth coordinate",
        ),
        (
            theirs(of_both),
            "of both with the inverse of B in a Collada file",
        ),
        (
            theirs_in_four(Divides::Yes, of_both),
            "of both with the inverse of B in a Collada file, and the sum is divided by its fourth coordinate",
        ),
        (
            theirs(of_shape),
            "of the skin's own matrix in a Collada file",
        ),
        (
            theirs(of_points),
            "of the skin's own matrix in a Collada file, after which the fourth coordinate is 1 again",
        ),
        (
            theirs(of_skin_as_points),
            "of the skin's own matrix, after which the fourth coordinate is 1 again, and of the inverse of B in a Collada file",
        ),
        (
            theirs(of_skin),
            "of the skin's own matrix and of the inverse of B in a Collada file",
        ),
        (
            theirs_in_four(Divides::Yes, of_skin),
            "of the skin's own matrix and of the inverse of B in a Collada file, and the sum is divided by its fourth coordinate",
        ),
    ] {
        let found = diagnose(&arm(), &pose(), &theirs).unwrap();
        assert_eq!(found.together(), ["matrix-transposed"], "{found}");
        assert_eq!(found.mistakes[0].how, told, "{found}");
    }
}

#[test]
fn what_is_done_with_the_frames_of_a_collada_file_is_named() {
    let (posed, rest, shape) = (in_pose(), at_rest(), bind_shape());
    let inverse_bind = rest.map(|matrix| matrix.inverse());
    let from_file = ours_from_file();
    let own = [0, 1].map(rotation);
    let from_file_first = own.map(|turn| from_file.inverse() * turn * from_file);
    let (about_bones, from_file_first) = (about_bones(own), about_bones(from_file_first));
    let in_file = in_pose_from(Mat4::IDENTITY);
    for (theirs, id, how) in [
        (
            theirs(|joint| {
                from_file * inverse_bind[joint] * from_file.inverse() * posed[joint] * shape
            }),
            "factors-swapped",
            "with those of a Collada file, whose axes are converted last",
        ),
        (
            theirs(|joint| inverse_bind[joint] * posed[joint] * shape),
            "factors-swapped",
            "with those of a Collada file, whose axes are converted in T",
        ),
        (
            theirs(|joint| about_bones[joint] * inverse_bind[joint] * shape),
            "angles-about-bones",
            "",
        ),
        (
            theirs(|joint| from_file_first[joint] * inverse_bind[joint] * shape),
            "angles-about-bones",
            "after they are brought into the axes of the file",
        ),
        (
            theirs(|joint| in_file[joint] * inverse_bind[joint] * shape),
            "axes-not-converted",
            "",
        ),
    ] {
        let found = diagnose(&arm(), &pose(), &theirs).unwrap();
        assert_eq!(found.together(), [id], "{found}");
        assert_eq!(found.mistakes[0].how, how, "{found}");
        assert!(found.error < 1e-5, "{found}");
    }
}

#[test]
fn angles_about_a_bones_own_axes_are_named_beside_another_mistake() {
    let (rest, shape) = (at_rest(), bind_shape());
    let about_bones = about_bones([0, 1].map(rotation));
    let theirs = theirs(|joint| about_bones[joint] * rest[joint].inverse().transpose() * shape);
    let found = diagnose(&arm(), &pose(), &theirs).unwrap();
    let told = sorted(&found);
    assert_eq!(told, ["angles-about-bones", "matrix-transposed"], "{found}");
}

#[test]
fn a_skins_own_matrix_that_only_moves_is_missing_and_not_transposed_where_it_does_nothing() {
    let shape = Mat4::from_translation(Vec3::new(0.1, -1.0, 0.25));
    let (posed, rest) = (in_pose(), at_rest());
    let theirs = theirs(|joint| posed[joint] * rest[joint].inverse());
    let found = diagnose(&arm_of([0, 1], shape), &pose(), &theirs).unwrap();
    assert_eq!(found.together(), ["bind-shape-missing"], "{found}");
    assert!(found.causes.contains(&"matrix-transposed"), "{found}");
}

#[test]
fn mistakes_that_give_the_same_are_told_by_what_a_collada_file_has_as_well() {
    let (posed, shape) = (in_pose(), bind_shape());
    let theirs = theirs(|joint| posed[joint] * shape);
    let mut found = diagnose(&arm(), &pose(), &theirs).unwrap();
    let shifted = Mistake::find("weights-shifted").unwrap();
    found.same_as = vec![vec![shifted.id]];
    found.others = vec![shifted.told_for(ToldFor::CourseEditor)];
    assert!(found.to_string().contains("column c"), "{found}");
    let told = found.told_for(ToldFor::VirtualMannequin).to_string();
    let same = "weights-shifted: the weights of each joint are taken for the joint before it";
    assert!(told.ends_with(same), "{told}");
}
