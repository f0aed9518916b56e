//! Meshes that no known mistake gives, and what is told of them.

use crate::assignment::characters::character;
use crate::diagnose::figures::{Figure, turned, written};
use crate::diagnose::sorted;
use crate::diagnose::student::{RIGHT, Student, Weights, with};
use crate::work::grows_in_proportion;
use editor_core::character::Pose;
use editor_core::diagnose::{
    DiagnoseError, Formula, Mistake, NearlyRight, Verdict, diagnose, skin_by,
};
use editor_core::geometry::Mesh;
use editor_core::math::Euler;
use glam::{Vec3, Vec3Swizzles};

fn adult() -> Figure {
    Figure::builtin("adult", turned(21))
}

#[test]
fn nonsense_has_no_cause_and_nothing_that_comes_near() {
    let figure = adult();
    let mut random = 1_u32;
    let mut number = || {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (random >> 8) as f32 / (1 << 24) as f32
    };
    let noise = figure
        .positions
        .iter()
        .map(|_| Vec3::new(number(), number(), number()));
    let found = figure.diagnose(&noise.collect::<Vec<_>>());
    assert_eq!(
        (found.verdict, &*found.causes),
        (Verdict::Unexplained, &[][..])
    );
    assert!(
        found.nearest.is_none() && found.findings.is_empty(),
        "{found}"
    );
    assert!(
        found.regions.iter().all(|region| region.share > 0.99),
        "{found}"
    );
}

#[test]
fn a_vertex_far_outside_as_of_memory_that_was_never_set_says_nothing_about_the_others() {
    let figure = adult();
    let right = RIGHT.skin(&figure);
    let swapped = with(&["factors-swapped"]).skin(&figure);
    for (out, digits) in [(1.0e4, 6), (-1.073_741_8e8, 9)] {
        let with_one_out = |places: &[Vec3]| {
            let mut places = places.to_vec();
            *places.last_mut().unwrap() = Vec3::splat(out);
            figure.diagnose(&written(&places, digits))
        };
        let found = with_one_out(&right);
        let nearly = found.nearly_right();
        assert_eq!(
            nearly,
            Some(NearlyRight::ButForFew),
            "{out} {digits}: {found}"
        );
        assert_eq!(found.off, 1, "{out} {digits}: {found}");
        let found = with_one_out(&swapped);
        let Some(NearlyRight::ButForFewWith(mistake)) = found.nearly_right() else {
            panic!("{out} {digits}: {found}");
        };
        assert_eq!(mistake.id, "factors-swapped");
        let found = with_one_out(&figure.positions);
        let Some(NearlyRight::ButForFewWith(mistake)) = found.nearly_right() else {
            panic!("{out} {digits}: {found}");
        };
        assert_eq!(mistake.id, "pose-not-applied");
        let found = with_one_out(&vec![Vec3::ZERO; right.len()]);
        assert_eq!(found.nearly_right(), None, "{out} {digits}: {found}");
    }
    // A third of them, or all.
    for every in [3, 1] {
        let garbage = right
            .iter()
            .enumerate()
            .map(|(index, place)| match index % every {
                0 => Vec3::new(index as f32, -2.0, 1.0) * 1.0e6,
                _ => *place,
            });
        let found = figure.diagnose(&garbage.collect::<Vec<_>>());
        assert_eq!(
            (found.verdict, found.nearly_right()),
            (Verdict::Unexplained, None),
            "{found}"
        );
        assert!(found.agrees < 0.7, "{found}");
    }
}

#[test]
fn vertices_that_are_all_in_one_place_are_said_to_be_and_no_two_mistakes_are_named() {
    for name in ["adult", "robot"] {
        let figure = Figure::builtin(name, turned(11));
        let all_at = |place| vec![place; RIGHT.skin(&figure).len()];
        for (place, told) in [
            (
                Vec3::ZERO,
                "unexplained: all vertices are at the origin: are the joints' matrices filled, and the inverse bind \
                 matrices? New ones are 0, and so are weights below 1 that are read as whole numbers\n",
            ),
            (
                Vec3::new(0.5, -0.7, 0.5),
                "unexplained: all vertices are in one place, (0.5000, -0.7000, 0.5000)\n",
            ),
        ] {
            let found = figure.diagnose(&all_at(place));
            assert_eq!(found.verdict, Verdict::Unexplained, "{name}: {found}");
            let text = found.to_string();
            assert!(text.starts_with(told), "{name}: {text}");
            assert!(
                !text.contains("rounded") && text.lines().count() == 2,
                "{text}"
            );
            assert_eq!((&*found.mistakes, found.coarse), (&[][..], None));
        }
    }
}

#[test]
fn numbers_with_too_few_digits_are_said_to_be_the_reason() {
    let figure = adult();
    let right = RIGHT.skin(&figure);
    let found = figure.diagnose(&written(&right, 2));
    assert_eq!(found.verdict, Verdict::Unexplained);
    let coarse = found.coarse.unwrap();
    assert!((coarse.rounded_to - 0.01).abs() < 1e-9 && coarse.may_be_right);
    let text = found.to_string();
    let told = "the exact result rounded to 0.01, which is too coarse to tell mistakes apart: write at least 4 digits \
                after the point";
    assert!(text.contains(told), "{text}");
    // One digit is enough for that: all numbers of all vertices are those of the exact result.
    for (points, told) in [
        (written(&right, 1), "the exact result rounded to 0.1, which"),
        (
            cut(&right, 1, f32::trunc),
            "the exact result cut off to 0.1 instead of rounded",
        ),
    ] {
        let found = figure.diagnose(&points);
        assert_eq!(found.nearly_right(), Some(NearlyRight::Rounded), "{found}");
        assert!(found.to_string().contains(told), "{found}");
        let mut off = points;
        off[7].y += 0.1;
        let found = figure.diagnose(&off);
        assert_eq!(found.nearly_right(), None, "{found}");
    }
    // It is not enough to name mistakes, which are not right for it.
    let found = figure.diagnose(&written(&with(&["euler-zyx"]).skin(&figure), 1));
    assert_eq!(
        (found.verdict, found.coarse.unwrap().may_be_right),
        (Verdict::Unexplained, false),
        "{found}"
    );
    // What is far off is not called right for its digits.
    let far: Vec<Vec3> = right.iter().map(|place| *place * 1.5).collect();
    let found = figure.diagnose(&written(&far, 2));
    assert!(!found.coarse.unwrap().may_be_right, "{found}");
    assert_eq!(figure.diagnose(&written(&right, 4)).coarse, None);
    // Whole numbers say nothing of a figure of this size, whatever they are.
    let found = figure.diagnose(&written(&right, 0));
    assert!(!found.coarse.unwrap().may_be_right, "{found}");
}

/// How a program makes a number shorter, after it is multiplied.
type Cut = fn(f32) -> f32;

/// `points` with so many digits after the point, to which a program cuts them.
fn cut(points: &[Vec3], digits: i32, cut: Cut) -> Vec<Vec3> {
    let scale = 10_f32.powi(digits);
    let cut = |number: f32| cut(number * scale) / scale;
    points
        .iter()
        .map(|point| point.to_array().map(cut).into())
        .collect()
}

#[test]
fn digits_that_are_cut_off_are_told_and_mistakes_are_named_beside_them() {
    let figure = adult();
    for (way, name) in [(f32::trunc as Cut, "trunc"), (f32::floor, "floor")] {
        for (digits, step) in [(2, "0.01"), (3, "0.001")] {
            let right = cut(&RIGHT.skin(&figure), digits, way);
            let found = figure.diagnose(&right);
            assert_eq!(found.nearly_right(), Some(NearlyRight::Rounded), "{found}");
            let told = format!(
                "nearly right: the exact result cut off to {step} instead of rounded: write at least 4 digits after the point"
            );
            assert!(found.to_string().starts_with(&told), "{name}: {found}");
            for ids in [&["euler-zyx"][..], &["euler-zyx", "strongest-joint-only"]] {
                let theirs = cut(&with(ids).skin(&figure), digits, way);
                let found = figure.diagnose(&theirs);
                let mistakes = sorted(&found);
                assert_eq!(mistakes, ids, "{name} {digits}: {found}");
                let told = format!("its numbers are cut off to {step} instead of rounded");
                assert!(found.to_string().contains(&told), "{found}");
            }
        }
        // Four digits are enough, however they are written.
        let found = figure.diagnose(&cut(&RIGHT.skin(&figure), 4, way));
        assert_eq!(found.verdict, Verdict::Right, "{found}");
        // More than what is cut off is another matter.
        let mut off = cut(&RIGHT.skin(&figure), 2, way);
        off[7].y += 0.02;
        let found = figure.diagnose(&off);
        assert!(!found.coarse.unwrap().may_be_right, "{found}");
    }
}

#[test]
fn a_mistake_that_agrees_within_the_last_of_few_digits_is_named() {
    let figure = adult();
    for ids in [
        &["euler-zyx"][..],
        &["no-inverse-bind"],
        &["euler-zyx", "strongest-joint-only"],
    ] {
        let theirs = with(ids).skin(&figure);
        let found = figure.diagnose(&written(&theirs, 2));
        assert_eq!(found.verdict, Verdict::Explained, "{ids:?}: {found}");
        let mistakes = sorted(&found);
        assert_eq!((&*mistakes, &*found.same_as), (ids, &[][..]), "{found}");
        assert!(!found.coarse.unwrap().may_be_right);
        let told = "its numbers are rounded to 0.01, which may hide smaller mistakes: write at least 4 digits after the point";
        assert!(found.to_string().contains(told), "{found}");
        // A hundredth more than rounding is no longer that.
        let mut off = written(&theirs, 2);
        off[7].y += 0.01;
        let found = figure.diagnose(&off);
        assert_eq!(found.verdict, Verdict::Unexplained, "{ids:?}: {found}");
    }
}

#[test]
fn a_part_that_is_off_is_told_by_its_joint() {
    let figure = adult();
    let mut theirs = RIGHT.skin(&figure);
    for (vertex, place) in theirs.iter_mut().enumerate() {
        // Column 13 is joint 14, the right elbow.
        if figure.rows[vertex][13] > 0.6 {
            *place += Vec3::new(0.0, 0.1 * (place.x * 40.0).sin(), 0.05);
        }
    }
    let found = figure.diagnose(&theirs);
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
    let joints: Vec<_> = found
        .regions
        .iter()
        .map(|region| region.joint.as_deref())
        .collect();
    assert_eq!(joints, [Some("Right elbow")]);
    let (region, first) = (&found.regions[0], found.first.as_ref().unwrap());
    assert!(region.off > 100 && region.off <= region.vertices && region.worst > 0.02);
    assert_eq!(
        (&first.joint, first.joint_index),
        (&Some("Right elbow".to_owned()), Some(14))
    );
    assert_eq!(first.error, region.worst);
}

#[test]
fn of_several_joints_that_are_off_the_one_next_to_the_root_shows_it() {
    let figure = adult();
    let mut theirs = RIGHT.skin(&figure);
    // The joints after these columns: right shoulder and elbow, left elbow.
    for (vertex, place) in theirs.iter_mut().enumerate() {
        for (column, by) in [(12, 0.02), (13, 0.05), (16, 0.04)] {
            if figure.rows[vertex][column] > 0.6 {
                place.y += by * (place.x * 40.0).sin();
            }
        }
    }
    let found = figure.diagnose(&theirs);
    let first = found.first.as_ref().unwrap();
    assert_eq!(first.joint.as_deref(), Some("Right shoulder"), "{found}");
    let region = found
        .regions
        .iter()
        .find(|region| region.joint_index == Some(13))
        .unwrap();
    assert_eq!(first.error, region.worst);
    assert_eq!(found.regions.len(), 3, "{found}");
}

#[test]
fn no_joint_above_one_that_is_not_turned_shows_it() {
    let all = turned(31);
    for name in ["adult", "dog", "robot"] {
        let figure = Figure::builtin(name, &all);
        let joints = figure.character.skeleton().joints();
        for joint in 0..joints.len() {
            let posed = Figure::builtin(name, &all).without(joint);
            let found = figure.diagnose(&RIGHT.skin(&posed));
            let Some(first) = found.first.as_ref().and_then(|first| first.joint_index) else {
                continue;
            };
            let mut above = std::iter::successors(Some(first), |&one| joints[one].parent);
            let case = format!("{name}, {}: {found}", joints[joint].name);
            assert!(above.any(|one| one == joint), "{case}");
        }
    }
}

#[test]
fn a_joint_shows_it_only_if_its_own_vertices_are_off_and_not_what_a_joint_below_moves_nearly_as_much()
 {
    // A neck and a jaw, and vertices that both move, the neck a little more.
    let mut obj = String::new();
    let mut attach = String::new();
    for vertex in 0..60 {
        let [x, y, z] = [7, 11, 13].map(|step| (vertex * step % 61) as f32 / 61.0);
        obj += &format!("v {x} {y} {}\n", z + 0.5);
        attach += ["1 0\n", "0.51 0.49\n", "0 1\n"][vertex % 3];
    }
    let skel = "0 0 0 -1 # Root\n0 1 0 0 # Neck\n0 0.2 0.1 1 # Jaw\n";
    let body = character(skel, &attach, &(obj + "f 1 2 3\n"));
    let mut pose = Pose::new();
    pose.set_joint_transform(2, Euler::from_degrees(Vec3::new(3.3, -6.8, 24.7)));
    let transposed = Mistake::find("rotation-transposed").unwrap();
    let mut formula = Formula::default();
    (transposed.readings[0].make)(&mut formula);
    let theirs = skin_by(&body, &pose, &formula);
    let theirs = Mesh::new(theirs.positions, body.bind_mesh().triangles.clone());
    let found = diagnose(&body, &pose, &theirs).unwrap();
    assert!(found.causes.contains(&transposed.id), "{found}");
    let first = found.first.as_ref().unwrap();
    assert_eq!(first.joint.as_deref(), Some("Jaw"), "{found}");
}

#[test]
fn a_mistake_that_explains_much_but_not_all_is_told_as_the_nearest() {
    let figure = adult();
    let mut theirs = with(&["weights-shifted"]).skin(&figure);
    for place in &mut theirs {
        place.y += 0.002 * (place.x * 50.0).sin();
    }
    let found = figure.diagnose(&theirs);
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
    let nearest = found.nearest.as_ref().unwrap();
    assert_eq!(nearest.mistake.id, "weights-shifted");
    assert!(nearest.explains > 0.9 && nearest.explains < 1.0, "{found}");
}

#[test]
fn no_mistake_is_the_nearest_to_a_mesh_that_shrinks_to_a_point() {
    // As of `if (weight == 0) break;` in a loop that goes backwards from the last joint but one.
    let leading = |weights: Weights| {
        let weights = weights
            .into_iter()
            .rev()
            .skip_while(|(joint, _)| *joint > 16);
        let joints = weights.zip((1..=16).rev());
        let joints = joints.take_while(|((joint, _), place)| joint == place);
        joints.map(|(weight, _)| weight).collect()
    };
    for seed in 1..4 {
        let figure = Figure::builtin("adult", turned(seed));
        let student = Student {
            weights: leading,
            ..RIGHT
        };
        let found = figure.diagnose(&written(&student.skin(&figure), 6));
        assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
        assert_eq!(found.nearest, None, "{found}");
    }
}

#[test]
fn a_mesh_that_is_moved_or_scaled_as_a_whole_is_told_to_be() {
    let figure = adult();
    let right = RIGHT.skin(&figure);
    let moved: Vec<Vec3> = right.iter().map(|place| *place + Vec3::X).collect();
    let found = figure.diagnose(&moved);
    assert!(
        found.findings[0]
            .to_string()
            .ends_with("the exact result, moved by (1.000000, 0.000000, 0.000000)"),
        "{found}"
    );
    let larger: Vec<Vec3> = right.iter().map(|place| *place * 3.0).collect();
    let found = figure.diagnose(&larger);
    assert!(
        found.findings[0]
            .to_string()
            .ends_with("the exact result, 3 times as large"),
        "{found}"
    );
}

#[test]
fn another_order_that_no_importer_is_known_for_is_told_as_one() {
    let figure = adult();
    let mut theirs = RIGHT.skin(&figure);
    theirs.rotate_left(1000);
    let found = figure.diagnose(&theirs);
    assert_eq!(found.causes, ["vertices-renumbered"]);
    assert_eq!(found.mistakes[0].how, "in another order");
    assert!(found.error < 1e-5, "{found}");
}

#[test]
fn vertices_that_a_loop_does_not_come_to_are_told_with_where_it_ends() {
    let figure = adult();
    let right = RIGHT.skin(&figure);
    let half = right.len() / 2;
    let without = |left: std::ops::Range<usize>, at: &dyn Fn(usize) -> Vec3| {
        let mut theirs = right.clone();
        left.for_each(|index| theirs[index] = at(index));
        figure.diagnose(&written(&theirs, 6))
    };
    let at_rest = |index: usize| figure.positions[index];
    for (found, how) in [
        (
            without(half..right.len(), &at_rest),
            format!("those from {half} on, counted from 0, are at rest"),
        ),
        (
            without(half..right.len(), &|_| Vec3::ZERO),
            format!("those from {half} on, counted from 0, are at the origin"),
        ),
        (
            without(0..half, &at_rest),
            format!("those before {half}, counted from 0, are at rest"),
        ),
    ] {
        assert_eq!(found.together(), ["vertices-not-reached"], "{found}");
        assert_eq!(found.mistakes[0].how, how);
        assert!(found.error < 1e-5 && found.same_as.is_empty(), "{found}");
    }
    // Beside another mistake as well.
    let mut theirs = with(&["euler-zyx"]).skin(&figure);
    theirs[half..].copy_from_slice(&figure.positions[half..]);
    let found = figure.diagnose(&written(&theirs, 6));
    assert_eq!(
        found.together(),
        ["euler-zyx", "vertices-not-reached"],
        "{found}"
    );
    assert!(
        found
            .first
            .as_ref()
            .is_some_and(|first| first.vertex < half)
    );
    // Beside a joint that is not turned, which few of them leave nearly right.
    let weights = figure.rows[0].iter().zip(1..);
    let (_, joint) = weights.max_by(|a, b| a.0.total_cmp(b.0)).unwrap();
    let name = format!(
        "{} ({joint})",
        figure.character.skeleton().joints()[joint].name
    );
    let mut theirs = RIGHT.skin(&adult().without(joint));
    let last = theirs.len() - 1;
    theirs[last] = figure.positions[last];
    let found = figure.diagnose(&written(&theirs, 6));
    let Some(NearlyRight::ButForFewWith(mistake)) = found.nearly_right() else {
        panic!("{found}");
    };
    assert_eq!((mistake.id, &*mistake.how), ("joint-not-turned", &*name));
    assert_eq!(found.nearest.as_ref().unwrap().off, 1, "{found}");
    theirs[half..].copy_from_slice(&figure.positions[half..]);
    let found = figure.diagnose(&written(&theirs, 6));
    assert_eq!(
        found.together(),
        ["joint-not-turned", "vertices-not-reached"],
        "{found}"
    );
    assert_eq!(found.mistakes[0].how, name);
    // Vertices in between are no loop's, and few of them are told as what is nearly right.
    let found = without(half..half + 500, &at_rest);
    assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
    assert_eq!(found.not_reached, None);
    let last = right.len() - 1;
    let found = without(last..last + 1, &at_rest);
    assert_eq!(
        found.nearly_right(),
        Some(NearlyRight::ButForFew),
        "{found}"
    );
    let left = format!("from {last} on, counted from 0, are at rest");
    assert_eq!(found.not_reached.as_ref(), Some(&left));
    assert!(found.to_string().contains(&left), "{found}");
    // Where vertices all over the mesh are at rest, the last one says nothing.
    let mut theirs = right.clone();
    for index in (1..theirs.len()).step_by(2) {
        theirs[index] = figure.positions[index];
    }
    let found = figure.diagnose(&written(&theirs, 6));
    assert_eq!(
        (found.verdict, found.not_reached),
        (Verdict::Unexplained, None)
    );
}

#[test]
fn vertices_at_the_origin_are_told_as_those_without_weights_wherever_they_are() {
    let figure = adult();
    let right = RIGHT.skin(&figure);
    let without = |meshes: &[Vec3], left: &mut dyn Iterator<Item = usize>| {
        let mut theirs = meshes.to_vec();
        left.for_each(|index| theirs[index] = Vec3::ZERO);
        figure.diagnose(&written(&theirs, 6))
    };
    let half = right.len() / 2;
    let thirds = (1..right.len()).step_by(3);
    for (found, how) in [
        (
            without(&right, &mut (half..half + 500)),
            format!(
                "those from {half} to {}, counted from 0, are at the origin",
                half + 499
            ),
        ),
        (
            without(&right, &mut thirds.clone()),
            format!(
                "those from 1 to {}, counted from 0, {} in all, are at the origin",
                thirds.clone().next_back().unwrap(),
                thirds.len()
            ),
        ),
    ] {
        assert_eq!(found.together(), ["vertices-without-weights"], "{found}");
        assert_eq!(found.mistakes[0].how, how);
        assert!(found.error < 1e-5 && found.same_as.is_empty(), "{found}");
    }
    let share = 1.0 - thirds.len() as f64 / right.len() as f64;
    let found = without(&right, &mut thirds.clone());
    assert!((found.reached - share).abs() < 1e-12, "{}", found.reached);
    // Beside another mistake as well.
    let zyx = with(&["euler-zyx"]).skin(&figure);
    let found = without(&zyx, &mut (half..half + 500));
    assert_eq!(
        found.together(),
        ["euler-zyx", "vertices-without-weights"],
        "{found}"
    );
    assert!(
        found
            .first
            .as_ref()
            .is_some_and(|first| first.theirs != [0.0; 3])
    );
    // A few are told beside what is nearly right.
    let found = without(&right, &mut (half..half + 2));
    assert_eq!(
        found.nearly_right(),
        Some(NearlyRight::ButForFew),
        "{found}"
    );
    let left = format!(
        "from {half} to {}, counted from 0, are at the origin",
        half + 1
    );
    assert_eq!(found.not_reached.as_ref(), Some(&left));
}

#[test]
fn a_mistake_is_named_beside_vertices_in_any_order() {
    for figure in [adult(), Figure::posed("adult", "adult-walk")] {
        for (id, student) in [
            (
                "euler-zyx",
                Student {
                    rotation: |x, y, z| z * y * x,
                    ..RIGHT
                },
            ),
            (
                "no-inverse-bind",
                Student {
                    product: |t, _| t,
                    ..RIGHT
                },
            ),
            (
                "angles-scaled",
                Student {
                    to_radians: |degrees| degrees * 22.0 / 7.0 / 180.0,
                    ..RIGHT
                },
            ),
        ] {
            let mut theirs = student.skin(&figure);
            theirs.rotate_left(1000);
            theirs[..500].reverse();
            let found = figure.diagnose(&written(&theirs, 6));
            assert_eq!(found.together(), [id, "vertices-renumbered"], "{found}");
            assert_eq!(found.mistakes[1].how, "in another order");
            assert!(found.same_as.is_empty(), "{found}");
        }
    }
}

#[test]
fn the_search_for_a_cause_grows_in_proportion_to_the_mesh() {
    let noise = |vertices: usize| {
        let mut skel = "0 0 0 -1\n".to_owned();
        (1..8).for_each(|joint| skel += &format!("0.1 0.2 0.3 {}\n", joint - 1));
        let (mut obj, mut attach) = (String::new(), String::new());
        for vertex in 0..vertices {
            let [x, y, z] = [7, 11, 13].map(|step| (vertex * step % 1009) as f32 / 1009.0);
            obj += &format!("v {x} {y} {z}\n");
            attach += "0 0.5 0 0.25 0 0.125 0.125\n";
        }
        let body = character(&skel, &attach, &(obj + "f 1 2 3\n"));
        let mut theirs = body.bind_mesh().positions.clone();
        theirs.iter_mut().for_each(|place| place.x *= place.y);
        let triangles = body.bind_mesh().triangles.clone();
        (body, Mesh::new(theirs, triangles))
    };
    let mut pose = Pose::new();
    pose.set_joint_transform(3, Euler::from_degrees(Vec3::new(30.0, 20.0, 10.0)));
    grows_in_proportion(5_000, noise, |(body, theirs)| {
        assert_eq!(
            diagnose(&body, &pose, &theirs).unwrap().verdict,
            Verdict::Unexplained
        );
    });
}

#[test]
fn another_number_of_vertices_is_an_error() {
    let figure = adult();
    let counts = |theirs: &[Vec3]| {
        diagnose(&figure.character, &figure.pose(), &figure.mesh(theirs)).unwrap_err()
    };
    let expected = figure.positions.len();
    assert_eq!(
        counts(&figure.positions[2..]),
        DiagnoseError::Vertices {
            expected,
            found: expected - 2
        }
    );
    assert_eq!(counts(&[]), DiagnoseError::Vertices { expected, found: 0 });
}

#[test]
fn coordinates_that_are_no_numbers_are_off_by_more_than_anything() {
    let figure = adult();
    let mut theirs = RIGHT.skin(&figure);
    theirs[100].y = f32::NAN;
    let found = figure.diagnose(&theirs);
    assert_eq!(
        (found.verdict, found.error),
        (Verdict::Unexplained, f64::INFINITY)
    );
    assert_eq!(found.first.unwrap().vertex, 100);
}

#[test]
fn a_mistake_of_a_whole_program_that_gives_nearly_all_of_a_mesh_is_named_as_well() {
    let figure = Figure::builtin("adult", turned(90));
    let rest = figure.positions.iter();
    let right = RIGHT.skin(&figure);
    let begun_at_rest = rest.zip(&right).map(|(rest, at)| *rest + *at).collect();
    let ignores_weights = Student {
        weights: |weights| {
            let share = 1.0 / weights.len() as f32;
            weights.iter().map(|(joint, _)| (*joint, share)).collect()
        },
        ..RIGHT
    };
    let exchanges_angles = Student {
        slider: |angles| angles.yxz(),
        ..RIGHT
    };
    let meshes: [(&str, Vec<Vec3>); 3] = [
        ("sum-begun-at-rest", begun_at_rest),
        ("weights-ignored", ignores_weights.skin(&figure)),
        ("angles-exchanged", exchanges_angles.skin(&figure)),
    ];
    for (id, mut theirs) in meshes {
        let step = theirs.len() / 20;
        for at in theirs.iter_mut().step_by(step) {
            at.y += 0.01;
        }
        let found = figure.diagnose(&theirs);
        assert_eq!(found.verdict, Verdict::Unexplained, "{found}");
        let nearest = found.nearest.as_ref().expect("the nearest one");
        assert_eq!(nearest.mistake.id, id, "{found}");
        assert!(nearest.is_nearly_all(), "{found}");
    }
}

#[test]
fn with_two_digits_a_joint_that_is_left_out_is_named_without_what_makes_no_difference() {
    let figure = Figure::builtin("adult", turned(91));
    let joints = figure.parents.len();
    let last = Student {
        row: |row| {
            let mut row = row.to_vec();
            row.pop();
            row
        },
        ..RIGHT
    };
    let elbow = Student {
        row: |row| {
            let mut row = row.to_vec();
            row[ELBOW - 1] = 0.0;
            row
        },
        ..RIGHT
    };
    let joint = &figure.character.skeleton().joints()[ELBOW];
    assert!(
        joint.name.contains("elbow") && ELBOW + 1 < joints,
        "{}",
        joint.name
    );
    for student in [last, elbow] {
        let found = figure.diagnose(&written(&student.skin(&figure), 2));
        assert_eq!(found.together(), ["joint-left-out"], "{found}");
    }
}

/// Index of a joint of the adult that is not the last one.
const ELBOW: usize = 14;
