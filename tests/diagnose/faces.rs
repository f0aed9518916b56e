//! Meshes whose vertices are told right or wrong, and that lack triangles or have others.

use crate::assignment::characters::character;
use crate::diagnose::figures::{Figure, obj, turned};
use crate::diagnose::sorted;
use crate::diagnose::student::{RIGHT, Student, with};
use editor_core::character::Pose;
use editor_core::diagnose::{DiagnoseError, Diagnosis, FaceDifference, Verdict, diagnose};
use editor_core::geometry::Mesh;
use editor_core::io::{read_character_obj, read_posed_vertices};
use editor_core::math::Euler;
use glam::{Mat3, Mat4, Vec3};
use std::path::Path;

/// What is found out about a file with the content `text`.
fn diagnosed(figure: &Figure, text: &str) -> Diagnosis {
    let theirs = read_character_obj(Path::new("mine.obj"), text.as_bytes()).unwrap();
    diagnose(&figure.character, &figure.pose(), &theirs.value).unwrap()
}

/// A difference from a character of so many triangles.
fn difference(triangles: usize, missing: usize, other: usize) -> FaceDifference {
    FaceDifference {
        triangles,
        missing,
        other,
        turned: 0,
        same: None,
    }
}

/// The lines of faces of `text` that `change` makes others of.
fn with_faces(text: &str, change: impl Fn(Vec<String>) -> Vec<String>) -> String {
    let is_face = |line: &&str| line.starts_with("f ");
    let vertices = text
        .lines()
        .filter(|line| !is_face(line))
        .map(str::to_owned);
    let faces = text.lines().filter(is_face).map(str::to_owned).collect();
    let lines: Vec<String> = vertices.chain(change(faces)).collect();
    lines.join("\n")
}

#[test]
fn a_file_that_is_cut_off_among_its_faces_is_told_how_many_triangles_are_missing() {
    let figure = Figure::builtin("robot", turned(31));
    let all = figure.triangles.len();
    for (ids, verdict) in [
        (&[][..], Verdict::Triangles),
        (&["euler-zyx"], Verdict::Explained),
    ] {
        let whole = obj(&with(ids).skin(&figure), &figure, |number| {
            number.to_string()
        });
        assert_eq!(diagnosed(&figure, &whole).faces, difference(all, 0, 0));
        let left = all / 3;
        let cut = with_faces(&whole, |mut faces| {
            faces.truncate(left + 1);
            // The last one has lost a corner.
            let last = faces.pop().unwrap();
            faces.push(last[..last.rfind(' ').unwrap()].to_owned());
            faces
        });
        let found = diagnosed(&figure, &cut);
        assert_eq!(found.verdict, verdict);
        assert_eq!(found.faces, difference(all, all - left, 0));
        let told = format!("{} of the model's {all} triangles are missing", all - left);
        assert!(found.to_string().contains(&told), "{found}");
        assert!(!found.is_right());
    }
}

#[test]
fn faces_in_another_order_and_from_another_corner_on_are_the_same() {
    let figure = Figure::builtin("robot", turned(32));
    let whole = obj(&RIGHT.skin(&figure), &figure, |number| number.to_string());
    let turned = with_faces(&whole, |faces| {
        let turned = faces.iter().rev().map(|face| {
            let [_, a, b, c] = face.split(' ').collect::<Vec<_>>()[..] else {
                panic!("{face}");
            };
            format!("f {b}/1 {c}/1 {a}/1")
        });
        turned.collect()
    });
    let turned = format!("vt 0 0\n{turned}");
    let found = diagnosed(&figure, &turned);
    assert!(found.is_right() && found.faces.is_none(), "{found}");
    let others = with_faces(&whole, |mut faces| {
        faces[7] = "f 1 2 900".to_owned();
        faces
    });
    let found = diagnosed(&figure, &others);
    assert_eq!(found.faces, difference(figure.triangles.len(), 1, 1));
    let told = "1 of the model's 9580 triangles is missing, and 1 other is there";
    assert!(found.to_string().contains(told), "{found}");
}

#[test]
fn triangles_that_wind_the_other_way_are_not_right_though_their_vertices_are() {
    let figure = Figure::builtin("robot", turned(33));
    let whole = obj(&RIGHT.skin(&figure), &figure, |number| number.to_string());
    for (every, told) in [
        (
            1,
            "all of its triangles wind the other way, so that normals point the other way",
        ),
        (
            2,
            "4790 of its triangles wind the other way, so that normals point the other way",
        ),
    ] {
        let inside_out = with_faces(&whole, |faces| {
            let turned = faces.iter().enumerate().map(|(index, face)| {
                let [_, a, b, c] = face.split(' ').collect::<Vec<_>>()[..] else {
                    panic!("{face}");
                };
                if index % every == 0 {
                    format!("f {c} {b} {a}")
                } else {
                    face.clone()
                }
            });
            turned.collect()
        });
        let found = diagnosed(&figure, &inside_out);
        assert_eq!(
            (found.verdict, found.is_right()),
            (Verdict::Triangles, false)
        );
        assert_eq!(found.causes, ["triangles-turned"]);
        assert!(
            found
                .to_string()
                .starts_with("right but for its triangles: "),
            "{found}"
        );
        assert!(found.to_string().contains(told), "{found}");
    }
}

#[test]
fn polygons_that_a_pose_makes_concave_are_those_of_the_model() {
    // A strip of squares and a pentagon at its end, whose corners are moved by the tip.
    let mut model = String::new();
    for y in 0..6 {
        model += &format!("v 0 {y} 0\nv 1 {y} 0\n");
    }
    model += "v 0.5 6 0\n";
    let mut faces: Vec<String> = (0..4)
        .map(|at| [1, 2, 4, 3].map(|corner| (2 * at + corner).to_string()))
        .map(|corners| format!("f {}", corners.join(" ")))
        .collect();
    faces.push("f 9 10 12 13 11".to_owned());
    let body = character(
        "0 0 0 -1 # Root\n0 0 0 0 # Base\n0 5 0 1 # Tip\n",
        &("1 0\n".repeat(12) + "0 1\n"),
        &(model + &faces.join("\n")),
    );
    let mut pose = Pose::new();
    pose.set_joint_transform(2, Euler::from_degrees(Vec3::new(0.0, 0.0, 175.0)));
    let written = |faces: &[String]| {
        let places = body.skin_pose(&pose).into_iter();
        let lines = places.map(|at| format!("v {} {} {}\n", at.x, at.y, at.z));
        let text = lines.collect::<String>() + &faces.join("\n");
        let read = read_character_obj(Path::new("mine.obj"), text.as_bytes()).unwrap();
        diagnose(&body, &pose, &read.value).unwrap()
    };
    let found = written(&faces);
    assert_eq!(found.faces, difference(11, 0, 0), "{found}");
    let turned: Vec<String> = faces
        .iter()
        .map(|face| {
            let mut corners: Vec<&str> = face.split(' ').skip(1).collect();
            corners.rotate_left(1);
            format!("f {}", corners.join(" "))
        })
        .collect();
    assert_eq!(written(&turned).faces, difference(11, 0, 0));
    assert_eq!(written(&turned[..3]).faces, difference(11, 5, 0));
    assert_eq!(written(&turned[2..]).faces, difference(11, 4, 0));
}

#[test]
fn of_vertices_that_an_importer_repeats_the_number_of_triangles_tells() {
    let figure = Figure::builtin("robot", turned(33));
    let right = RIGHT.skin(&figure);
    let corners = figure.triangles.iter().flatten();
    let repeated: Vec<Vec3> = corners.map(|&corner| right[corner as usize]).collect();
    let found = figure.diagnose(&repeated);
    assert_eq!(found.causes, ["vertices-renumbered"]);
    let all = figure.triangles.len();
    assert_eq!(found.faces, difference(all, 0, 0));
    let mut cut = figure.mesh(&repeated);
    cut.triangles.truncate(all - 10);
    let found = diagnose(&figure.character, &figure.pose(), &cut).unwrap();
    assert_eq!(found.faces, difference(all, 10, 0));
}

#[test]
fn faces_that_count_from_0_or_from_2_are_one_mistake_though_some_are_by_chance_turned_ones() {
    for name in ["adult", "dog", "robot"] {
        let figure = Figure::builtin(name, turned(33));
        let right = obj(&RIGHT.skin(&figure), &figure, |number| number.to_string());
        for off in [-1, 1] {
            let text = with_faces(&right, |faces| {
                let index = |word: &str| word.parse().map(|index: i64| (index + off).to_string());
                let shifted = |face: &String| {
                    let words = face.split(' ').skip(1).map(|word| index(word).unwrap());
                    format!("f {}", words.collect::<Vec<_>>().join(" "))
                };
                faces.iter().map(shifted).collect()
            });
            let path = Path::new("mine.obj");
            let model = figure.character.bind_mesh();
            let read = read_posed_vertices(path, text.as_bytes(), model).unwrap();
            assert_eq!(read.warnings.len(), 1, "{name}");
            let found = diagnose(&figure.character, &figure.pose(), &read.value).unwrap();
            assert_eq!(found.verdict, Verdict::Triangles, "{name}: {found}");
            assert_eq!(found.causes, ["triangles-differ"], "{name}: {found}");
        }
    }
}

#[test]
fn one_vertex_too_many_is_named_beside_what_the_others_are() {
    let figure = Figure::builtin("adult", turned(90));
    for (ids, section) in [(&[][..], 0), (&["euler-zyx"], 1), (&["factors-swapped"], 1)] {
        let places = with(ids).skin(&figure);
        for (how, extra) in [("after the last", places.len()), ("before the first", 0)] {
            let mut theirs = places.clone();
            let doubled = if extra == 0 {
                Vec3::ZERO
            } else {
                places[extra - 1]
            };
            theirs.insert(extra, doubled);
            let mesh = Mesh::new(theirs, figure.triangles.clone());
            let found = diagnose(&figure.character, &figure.pose(), &mesh).unwrap();
            assert_eq!(found.verdict, Verdict::Explained, "{found}");
            let expected: Vec<&str> = ids.iter().copied().chain(["vertex-too-many"]).collect();
            assert_eq!(found.together(), expected, "{found}");
            let told = &found.mistakes[section];
            assert_eq!((&*told.how, told.section), (how, "4.1 Mesh"));
        }
    }
    // Two, or one beside what nothing explains.
    let right = RIGHT.skin(&figure);
    let two = [&right[..], &[Vec3::ZERO; 2]].concat();
    let noise = figure
        .positions
        .iter()
        .map(|at| Vec3::new(at.y, at.x * at.z, 1.0));
    let noise: Vec<Vec3> = noise.chain([Vec3::ZERO]).collect();
    for theirs in [two, noise] {
        let found = theirs.len();
        let mesh = Mesh::new(theirs, Vec::new());
        let error = diagnose(&figure.character, &figure.pose(), &mesh).unwrap_err();
        let expected = figure.positions.len();
        assert_eq!(error, DiagnoseError::Vertices { expected, found });
    }
}

#[test]
fn one_vertex_too_few_is_named_beside_what_the_others_are() {
    let figure = Figure::builtin("adult", turned(90));
    let model = figure.character.bind_mesh();
    let read = |text: &str| read_posed_vertices(Path::new("mine.obj"), text.as_bytes(), model);
    for (ids, section) in [(&[][..], 0), (&["euler-zyx"], 1), (&["factors-swapped"], 1)] {
        let places = with(ids).skin(&figure);
        let last = places.len() - 1;
        for (how, left) in [("the last", &places[..last]), ("the first", &places[1..])] {
            let vertices: String = left
                .iter()
                .map(|at| format!("v {:.6} {:.6} {:.6}\n", at.x, at.y, at.z))
                .collect();
            let faces: String = figure
                .triangles
                .iter()
                .map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1))
                .collect();
            // With the faces of all vertices, and without any.
            for text in [vertices.clone() + &faces, vertices] {
                let mesh = read(&text).unwrap().value;
                let found = diagnose(&figure.character, &figure.pose(), &mesh).unwrap();
                assert_eq!(found.verdict, Verdict::Explained, "{found}");
                let expected: Vec<&str> = ids.iter().copied().chain(["vertex-missing"]).collect();
                assert_eq!(found.together(), expected, "{found}");
                let told = &found.mistakes[section];
                assert_eq!((&*told.how, told.section), (how, "4.1 Mesh"));
            }
        }
    }
    // One in the middle is not.
    let mut right = RIGHT.skin(&figure);
    right.remove(700);
    let mesh = Mesh::new(right, Vec::new());
    assert!(diagnose(&figure.character, &figure.pose(), &mesh).is_err());
}

#[test]
fn of_a_mesh_with_a_vertex_for_each_corner_no_triangle_is_missing_whatever_else_is_wrong() {
    let figure = Figure::builtin("robot", turned(88));
    let at_corners = |student: &Student| -> Vec<Vec3> {
        let skinned = student.skin(&figure);
        let corners = figure.triangles.as_flattened().iter();
        corners.map(|&corner| skinned[corner as usize]).collect()
    };
    let right = at_corners(&RIGHT);
    let found = figure.diagnose(&right);
    assert_eq!(found.causes, ["vertices-renumbered"], "{found}");
    for id in ["no-inverse-bind", "parent-rotation-order"] {
        let student = match id {
            "parent-rotation-order" => Student {
                push: |parent, own| {
                    let at = (parent * own).transform_point3(Vec3::ZERO);
                    Mat4::from_translation(at) * without_place(own * parent)
                },
                ..RIGHT
            },
            id => with(&[id]),
        };
        let found = figure.diagnose(&at_corners(&student));
        let told = sorted(&found);
        assert_eq!(told, [id, "vertices-renumbered"], "{found}");
        assert_eq!((found.faces.missing, found.faces.other), (0, 0), "{found}");
    }
    // In another pose it is still one for each corner.
    let other = Figure::builtin("robot", turned(89)).pose();
    let found = figure.diagnose_in(&other, &right);
    assert_eq!(found.verdict, Verdict::OtherPose, "{found}");
    assert_eq!((found.faces.missing, found.faces.other), (0, 0), "{found}");
}

fn without_place(transform: Mat4) -> Mat4 {
    Mat4::from_mat3(Mat3::from_mat4(transform))
}
