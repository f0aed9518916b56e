use crate::work::grows_in_proportion;
use editor_core::compare::{
    Alike, CompareError, MeshComparison, MeshFinding, MeshOptions, MeshParts, SignedAxis, Which,
    compare_meshes,
};
use editor_core::geometry::{Mesh, icosahedron, teapot};
use glam::{Quat, Vec3};

/// A mesh without symmetry.
fn reference() -> Mesh {
    let mut mesh = teapot();
    for position in &mut mesh.positions {
        *position = *position * Vec3::new(1.0, 1.3, 0.8) + Vec3::new(0.4, 0.1, -0.2);
    }
    mesh
}

fn compare(a: &Mesh, b: &Mesh) -> MeshComparison {
    compare_meshes(a, b, &MeshOptions::default()).unwrap()
}

/// What is found in the reference after `change`.
fn findings(change: impl Fn(Vec3) -> Vec3) -> Vec<MeshFinding> {
    let a = reference();
    let mut b = a.clone();
    for position in &mut b.positions {
        *position = change(*position);
    }
    let comparison = compare(&a, &b);
    assert!(!comparison.passed);
    comparison.findings
}

#[test]
fn equal_meshes_pass_and_nothing_is_wrong_with_them() {
    let comparison = compare(&reference(), &reference());
    assert!(comparison.passed && comparison.same_triangles);
    assert_eq!(
        (comparison.max, comparison.mean, comparison.rms),
        (0.0, 0.0, 0.0)
    );
    assert_eq!(comparison.findings, []);
    assert_eq!(comparison.worst, []);
}

#[test]
fn rounding_that_a_tiny_threshold_counts_has_no_movement_scale_or_turn_as_its_cause() {
    let a = reference();
    let options = MeshOptions {
        tolerance: Some(1e-9),
        ..MeshOptions::default()
    };
    let mut noisy = a.clone();
    for (index, position) in noisy.positions.iter_mut().enumerate() {
        // As programs round that write six digits, on the whole a little too low.
        let step = [-6e-7, 2e-7, -4e-7, 5e-7][index * 7 % 4];
        *position += Vec3::new(step, -step, step * 0.5);
    }
    let comparison = compare_meshes(&a, &noisy, &options).unwrap();
    assert!(comparison.differing_vertices > 0);
    assert_eq!(comparison.findings, []);
    // Nor is a movement that would be written as zero one, or the axes as they are.
    let mut small = a.clone();
    small.positions.iter_mut().for_each(|at| *at *= 1e-3);
    let mut moved = small.clone();
    moved.positions.iter_mut().for_each(|at| at.x += 3e-7);
    let comparison = compare_meshes(&small, &moved, &options).unwrap();
    assert!(comparison.differing_vertices > 0);
    assert_eq!(comparison.findings, []);
    // A movement that is more than that is one.
    let mut moved = a.clone();
    for position in &mut moved.positions {
        *position += Vec3::X * 5e-6;
    }
    let comparison = compare_meshes(&a, &moved, &options).unwrap();
    let found = comparison.findings[0].to_string();
    assert_eq!(found, "B is A moved by (0.000005, 0.000000, 0.000000)");
}

#[test]
fn a_single_vertex_or_triangle_is_told_as_one() {
    let a = reference();
    let mut b = a.clone();
    b.positions[3].x = f32::NAN;
    b.triangles[7].swap(0, 1);
    let (last, of) = (b.triangles.len() - 1, b.triangles.len());
    b.triangles[last] = [0, 1, 2];
    let told: Vec<String> = compare(&a, &b)
        .findings
        .iter()
        .map(ToString::to_string)
        .collect();
    assert_eq!(
        told,
        [
            "1 vertex of B has coordinates that are not finite numbers",
            &format!("1 of the {of} triangles of B winds the other way"),
            "1 triangle is only in A, 1 only in B",
        ]
    );
}

#[test]
fn distances_agree_with_a_small_case_by_hand() {
    let corners = [Vec3::ZERO, Vec3::X * 3.0, Vec3::Y * 4.0, Vec3::X];
    let a = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 3, 2]]);
    let mut b = a.clone();
    b.positions[1] += Vec3::new(0.0, 3.0, 4.0);
    b.positions[2].z -= 1.0;
    let comparison = compare(&a, &b);
    assert_eq!(comparison.size, 5.0);
    assert_eq!(comparison.tolerance, 5e-5);
    assert_eq!(comparison.differing_vertices, 2);
    assert_eq!((comparison.max, comparison.max_by_size), (5.0, 1.0));
    assert_eq!(comparison.mean, 6.0 / 4.0);
    assert_eq!(comparison.rms, (26.0_f64 / 4.0).sqrt());
    let worst: Vec<(u64, f64)> = comparison
        .worst
        .iter()
        .map(|w| (w.index, w.distance))
        .collect();
    assert_eq!(worst, [(1, 5.0), (2, 1.0)]);
    assert_eq!(comparison.worst[0].b, [3.0, 3.0, 4.0]);
    assert_eq!(comparison.findings, []);
}

#[test]
fn the_ten_vertices_farthest_apart_are_listed() {
    let a = reference();
    let mut b = a.clone();
    for (index, position) in b.positions.iter_mut().enumerate().take(30) {
        position.y += 1.0 + (index * 7 % 30) as f32;
    }
    let worst: Vec<u64> = compare(&a, &b).worst.iter().map(|w| w.index).collect();
    // Index i is moved by 1 + 7 i modulo 30: by 30 for 17, by 29 for 4, and so on.
    assert_eq!(worst, [17, 4, 21, 8, 25, 12, 29, 16, 3, 20]);
}

#[test]
fn tolerance_and_allowance_decide() {
    let a = reference();
    let mut b = a.clone();
    b.positions[7].y += 0.5;
    b.positions[9].y += 0.125;
    let passes = |tolerance, allowed: &str| {
        let options = MeshOptions {
            tolerance,
            allowed: allowed.parse().unwrap(),
            parts: None,
        };
        compare_meshes(&a, &b, &options).unwrap().passed
    };
    assert!(!passes(None, "1") && passes(None, "2"));
    assert!(passes(Some(0.51), "0") && !passes(Some(0.49), "0") && passes(Some(0.49), "1"));
    assert!(!passes(None, "0%") && passes(None, "50%"));
}

#[test]
fn other_numbers_of_vertices_are_an_error_that_knows_merged_ones() {
    let a = icosahedron();
    let each_corner: Vec<Vec3> = a
        .triangles
        .iter()
        .flatten()
        .map(|&i| a.positions[i as usize])
        .collect();
    let triangles = (0..each_corner.len() as u32)
        .step_by(3)
        .map(|i| [i, i + 1, i + 2]);
    let apart = Mesh::new(each_corner, triangles.collect());
    let size = |alike| CompareError::Vertices {
        a: a.positions.len() as u64,
        b: apart.positions.len() as u64,
        alike,
    };
    let error = |b: &Mesh| compare_meshes(&a, b, &MeshOptions::default()).unwrap_err();
    assert_eq!(error(&apart), size(Alike::Places));
    assert!(error(&apart).to_string().contains("merged"));
    let mut other = apart.clone();
    other.positions[3] *= 1.5;
    assert_eq!(error(&other), size(Alike::Nothing));
    let nothing = Mesh::new(Vec::new(), Vec::new());
    assert_eq!(
        compare_meshes(&nothing, &nothing, &MeshOptions::default()),
        Err(CompareError::NoVertices)
    );
}

#[test]
fn vertices_too_many_at_the_end_are_told() {
    let a = reference();
    let with_more = |more: &[usize]| {
        let added = more.iter().map(|&index| a.positions[index]);
        let positions = a.positions.iter().copied().chain(added);
        Mesh::new(positions.collect(), a.triangles.clone())
    };
    let last = a.positions.len() - 1;
    let error = |a: &Mesh, b: &Mesh| {
        let error = compare_meshes(a, b, &MeshOptions::default()).unwrap_err();
        error.to_string()
    };
    assert!(
        error(&a, &with_more(&[last]))
            .ends_with(" (B has all those of the other first, and 1 more after them)")
    );
    assert!(
        error(&with_more(&[0, 1]), &a)
            .ends_with(" (A has all those of the other first, and 2 more after them)")
    );
}

#[test]
fn a_movement_is_measured() {
    let found = findings(|p| p + Vec3::new(0.0, -2.0, 0.25));
    let [MeshFinding::Offset { by: [x, y, z] }] = found[..] else {
        panic!("{found:?}");
    };
    assert!(x.abs() < 1e-6 && (y + 2.0).abs() < 1e-6 && (z - 0.25).abs() < 1e-6);
}

#[test]
fn a_scale_is_measured_about_the_origin_or_elsewhere() {
    let found = findings(|p| p * 0.01);
    let [MeshFinding::Scaled { factor, offset }] = found[..] else {
        panic!("{found:?}");
    };
    assert!((factor - 0.01).abs() < 1e-7);
    assert_eq!(offset, [0.0; 3]);
    let found = findings(|p| (p - Vec3::X) * 2.0 + Vec3::X);
    let [
        MeshFinding::Scaled {
            factor,
            offset: [x, y, z],
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    assert!((factor - 2.0).abs() < 1e-6);
    assert!((x + 1.0).abs() < 1e-5 && y.abs() < 1e-5 && z.abs() < 1e-5);
}

/// A number in millimeters as a program writes it in meters, or the other way round: worked out
/// from the file's number, not from the one that was read.
fn rescaled(mesh: &Mesh, factor: f64) -> Mesh {
    let scaled = |v: f32| (f64::from((v * 1e6).round()) * 1e-6 * factor) as f32;
    let of = |p: &Vec3| Vec3::from_array(p.to_array().map(scaled));
    Mesh::new(
        mesh.positions.iter().map(of).collect(),
        mesh.triangles.clone(),
    )
}

#[test]
fn a_large_scale_leaves_room_for_rounding_as_large() {
    let a = reference();
    for expected in [0.001, 0.0254, 25.4, 100.0, 1000.0, 1e6] {
        let found = compare(&a, &rescaled(&a, expected)).findings;
        let [MeshFinding::Scaled { factor, .. }] = found[..] else {
            panic!("{expected}: {found:?}");
        };
        assert!((factor / expected - 1.0).abs() < 1e-6, "{factor}");
    }
    let mut b = rescaled(&a, 1000.0);
    b.positions[9].x += 0.2;
    assert_eq!(compare(&a, &b).findings, []);
}

#[test]
fn other_axes_are_named_one_by_one() {
    let axes = |from_a: [&str; 3], mirrored| {
        [MeshFinding::Axes {
            from_a: from_a.map(|name| SignedAxis {
                axis: "xyz".find(&name[name.len() - 1..]).unwrap(),
                is_reversed: name.len() > 1,
            }),
            mirrored,
            factor: 1.0,
            offset: [0.0; 3],
        }]
    };
    assert_eq!(
        findings(|p| Vec3::new(p.x, -p.z, p.y)),
        axes(["x", "-z", "y"], false)
    );
    assert_eq!(
        findings(|p| Vec3::new(p.x, p.z, p.y)),
        axes(["x", "z", "y"], true)
    );
    assert_eq!(
        findings(|p| Vec3::new(-p.x, p.y, p.z)),
        axes(["-x", "y", "z"], true)
    );
    assert_eq!(
        findings(|p| Vec3::new(p.y, p.z, p.x)),
        axes(["y", "z", "x"], false)
    );
    assert_eq!(
        findings(|p| Vec3::new(-p.x, p.y, -p.z)),
        axes(["-x", "y", "-z"], false)
    );
}

fn near(found: [f64; 3], expected: [f64; 3], tolerance: f64) -> bool {
    let pairs = found.iter().zip(expected);
    pairs.into_iter().all(|(a, b)| (a - b).abs() <= tolerance)
}

#[test]
fn other_axes_are_named_together_with_a_scale_and_a_movement() {
    // As programs write whose units are centimeters and whose z points up.
    let found = findings(|p| Vec3::new(p.x, -p.z, p.y) * 100.0);
    let [
        MeshFinding::Axes {
            from_a,
            mirrored: false,
            factor,
            offset,
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    let from_a = from_a.map(SignedAxis::name);
    assert_eq!((from_a, offset), (["x", "-z", "y"], [0.0; 3]));
    assert!((factor / 100.0 - 1.0).abs() < 1e-6, "{factor}");
    let told = "B's x, y, z are x, -z, y of A: turned, or another axis points up, \
                and 100 times as large";
    assert_eq!(found[0].to_string(), told);

    let found = findings(|p| Vec3::new(1.0 - p.x, p.y, p.z));
    let [
        MeshFinding::Axes {
            from_a,
            mirrored: true,
            factor,
            offset,
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    let from_a = from_a.map(SignedAxis::name);
    assert_eq!((from_a, factor), (["-x", "y", "z"], 1.0));
    assert!(near(offset, [1.0, 0.0, 0.0], 1e-6), "{offset:?}");

    let found = findings(|p| Vec3::new(p.z, p.y, p.x) * 0.5 + Vec3::Y);
    let [
        MeshFinding::Axes {
            from_a,
            mirrored: true,
            factor,
            offset,
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    assert_eq!(from_a.map(SignedAxis::name), ["z", "y", "x"]);
    assert!((factor - 0.5).abs() < 1e-6 && near(offset, [0.0, 1.0, 0.0], 1e-6));
}

#[test]
fn a_turn_is_measured_with_a_mirror_a_scale_and_a_movement() {
    let turn = |degrees: f32| glam::Quat::from_rotation_y(degrees.to_radians());
    let measured = |found: &[MeshFinding]| match *found {
        [
            MeshFinding::Turned {
                mirrored,
                degrees,
                axis,
                factor,
                offset,
            },
        ] => (mirrored, degrees, axis, factor, offset),
        _ => panic!("{found:?}"),
    };
    let found = findings(|p| turn(30.0) * p);
    let (mirrored, degrees, axis, factor, offset) = measured(&found);
    assert_eq!((mirrored, factor, offset), (None, 1.0, [0.0; 3]));
    assert!((degrees - 30.0).abs() < 1e-4 && near(axis, [0.0, 1.0, 0.0], 1e-6));
    assert!(
        found[0]
            .to_string()
            .starts_with("B is A turned by 30.0000 degrees about")
    );

    let found = findings(|p| turn(-170.0) * p * 1000.0 + Vec3::new(3.0, -2.0, 1.0));
    let (mirrored, degrees, axis, factor, offset) = measured(&found);
    assert_eq!(mirrored, None);
    assert!((degrees - 170.0).abs() < 1e-4 && near(axis, [0.0, -1.0, 0.0], 1e-6));
    assert!((factor - 1000.0).abs() < 1e-3 && near(offset, [3.0, -2.0, 1.0], 1e-3));

    let found = findings(|p| turn(20.0) * (p * Vec3::new(1.0, 1.0, -1.0)) * 2.0);
    let (mirrored, degrees, axis, factor, offset) = measured(&found);
    assert_eq!((mirrored, offset), (Some("z"), [0.0; 3]));
    assert!((degrees - 20.0).abs() < 1e-4 && near(axis, [0.0, 1.0, 0.0], 1e-6));
    assert!((factor - 2.0).abs() < 1e-6);
}

#[test]
fn a_mesh_that_is_nearly_the_turned_one_is_said_to_be() {
    let a = reference();
    let turned = |by: f32| {
        let mut b = a.clone();
        for (index, position) in b.positions.iter_mut().enumerate() {
            let off = Vec3::splat(by * (index as f32 * 1.7).sin());
            *position = Quat::from_rotation_y(0.5) * *position + off;
        }
        compare(&a, &b)
    };
    let found = turned(0.001);
    assert_eq!(found.findings, []);
    assert!(
        matches!(found.nearly, Some(MeshFinding::Turned { degrees, .. }) if (degrees - 28.65).abs() < 0.05)
    );
    let told = "nearly, to within 0.1 % of the size: B is A turned by 28.6";
    assert!(found.to_string().contains(told), "{found}");
    // What is off by more is not, nor what is not much farther apart without the turn.
    assert_eq!(turned(0.05).nearly, None);
    let mut b = a.clone();
    for position in &mut b.positions {
        *position += Vec3::X * 0.02;
    }
    b.positions[7].y += 0.001;
    assert_eq!(compare(&a, &b).nearly, None);
}

#[test]
fn a_flat_mesh_was_turned_before_it_was_mirrored() {
    let grid = (0..30).map(|i| Vec3::new((i % 6) as f32, (i * i % 7) as f32, 0.0));
    let a = Mesh::new(grid.collect(), vec![[0, 1, 2]]);
    let turn = glam::Quat::from_axis_angle(Vec3::new(1.0, 2.0, 2.0) / 3.0, 0.7);
    let turned = a.positions.iter().map(|p| turn * *p).collect();
    let found = compare(&a, &Mesh::new(turned, a.triangles.clone())).findings;
    let [
        MeshFinding::Turned {
            mirrored: None,
            degrees,
            axis,
            ..
        },
    ] = found[..]
    else {
        panic!("{found:?}");
    };
    assert!((degrees.to_radians() - 0.7).abs() < 1e-6, "{degrees}");
    assert!(
        near(axis, [1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0], 1e-6),
        "{axis:?}"
    );
}

#[test]
fn a_mesh_that_shrank_to_a_point_is_told_to_lie_in_one_place() {
    assert_eq!(
        findings(|_| Vec3::ZERO),
        [MeshFinding::OnePlace { at: [0.0; 3] }]
    );
    assert_eq!(
        findings(|_| Vec3::Y),
        [MeshFinding::OnePlace {
            at: [0.0, 1.0, 0.0]
        }]
    );
    assert_eq!(
        findings(|p| if p.x > 0.4 { Vec3::ZERO } else { Vec3::Y }),
        []
    );
}

#[test]
fn what_is_neither_moved_nor_scaled_nor_turned_has_no_such_cause() {
    assert_eq!(findings(|p| p * Vec3::new(1.0, 1.1, 1.0)), []);
    assert_eq!(findings(|p| p + Vec3::X * p.y * 0.01), []);
    let sheared = |p: Vec3| glam::Quat::from_rotation_y(0.3) * p + Vec3::X * p.y * 0.01;
    assert_eq!(findings(sheared), []);
    let almost = findings(|p| if p.y > 0.5 { p + Vec3::Y } else { p });
    assert_eq!(almost, []);
}

#[test]
fn vertices_in_another_order_are_told_from_other_vertices() {
    let a = reference();
    let last = a.positions.len() as u32 - 1;
    let turned_round = |mesh: &Mesh| {
        let positions = mesh.positions.iter().rev().copied().collect();
        let triangles = mesh.triangles.iter().map(|t| t.map(|i| last - i)).collect();
        Mesh::new(positions, triangles)
    };
    let comparison = compare(&a, &turned_round(&a));
    assert!(!comparison.passed && comparison.same_triangles);
    assert!(
        matches!(comparison.findings[..], [MeshFinding::Permuted { vertices }] if vertices > 100),
        "{:?}",
        comparison.findings
    );
    let mut b = turned_round(&a);
    b.positions[3] += Vec3::ONE;
    let found = compare(&a, &b).findings;
    assert!(
        !found
            .iter()
            .any(|f| matches!(f, MeshFinding::Permuted { .. })),
        "{found:?}"
    );
}

#[test]
fn winding_is_compared_whichever_corner_comes_first() {
    let a = reference();
    let count = a.triangles.len() as u64;
    let with = |change: &dyn Fn(usize, [u32; 3]) -> [u32; 3]| {
        let triangles = a.triangles.iter().enumerate().map(|(i, &t)| change(i, t));
        compare(&a, &Mesh::new(a.positions.clone(), triangles.collect()))
    };
    let rolled = with(&|_, [i, j, k]| [j, k, i]);
    assert!(rolled.passed && rolled.findings.is_empty());
    let all = with(&|_, [i, j, k]| [i, k, j]);
    assert!(!all.passed);
    let winding = |reversed| MeshFinding::Winding {
        reversed,
        of: count,
    };
    assert_eq!(all.findings, [winding(count)]);
    assert!(all.findings[0].to_string().starts_with("all triangles"));
    let two = with(&|index, [i, j, k]| if index < 2 { [k, j, i] } else { [i, j, k] });
    assert_eq!(two.findings, [winding(2)]);
}

#[test]
fn triangles_of_other_corners_are_not_said_to_wind_the_other_way() {
    let a = reference();
    // All corners are others, but for two triangles.
    let count = a.positions.len() as u32;
    let triangles = a.triangles.iter().enumerate().map(|(index, &[i, j, k])| {
        if (200..202).contains(&index) {
            [i, k, j]
        } else {
            [i, j, k].map(|corner| (7 * corner + 1) % count)
        }
    });
    let comparison = compare(&a, &Mesh::new(a.positions.clone(), triangles.collect()));
    assert!(
        matches!(comparison.findings[..], [MeshFinding::Triangles { .. }]),
        "{:?}",
        comparison.findings
    );
}

#[test]
fn other_triangles_are_counted_and_another_order_passes() {
    let a = reference();
    let with = |triangles| compare(&a, &Mesh::new(a.positions.clone(), triangles));
    let fewer = with(a.triangles[3..].to_vec());
    assert!(!fewer.passed);
    assert_eq!(
        fewer.findings,
        [MeshFinding::Triangles {
            only_a: 3,
            only_b: 0
        }]
    );
    let more = with([&a.triangles[..], &[[0, 1, 200]]].concat());
    let only_b = MeshFinding::Triangles {
        only_a: 0,
        only_b: 1,
    };
    assert!(!more.passed && !more.same_triangles);
    assert_eq!(more.findings, [only_b]);
    let other_order = with(a.triangles.iter().rev().copied().collect());
    assert!(other_order.passed);
    assert_eq!(other_order.findings, [MeshFinding::TriangleOrder]);
}

#[test]
fn coordinates_that_are_no_numbers_differ_and_are_counted() {
    let a = reference();
    let mut b = a.clone();
    b.positions[5].x = f32::NAN;
    b.positions[6].y = f32::INFINITY;
    let comparison = compare(&a, &b);
    assert_eq!(comparison.differing_vertices, 2);
    assert_eq!(comparison.max, f64::INFINITY);
    let not_finite = MeshFinding::NotFinite {
        mesh: Which::B,
        vertices: 2,
    };
    assert_eq!(comparison.findings, [not_finite]);
    let other_way = compare(&b, &a);
    assert!(!other_way.passed && other_way.size.is_finite());
    assert_eq!(other_way.differing_vertices, 2);
    let json = serde_json::to_value(&comparison).unwrap();
    assert!(json["max"].is_null());
    assert_eq!(json["findings"][0]["kind"], "not_finite");
    assert_eq!(
        json["findings"][0]["message"],
        "2 vertices of B have coordinates that are not finite numbers"
    );
}

#[test]
fn a_threshold_larger_than_the_distances_of_vertices_does_not_take_for_ever() {
    let random = |count: usize| -> Vec<Vec3> {
        let mut random = 1_u32;
        let mut number = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 8) as f32 / (1 << 24) as f32
        };
        (0..count)
            .map(|_| Vec3::new(number(), number(), number()))
            .collect()
    };
    let in_one_place = |count: usize| vec![Vec3::ZERO; count];
    let compared = |mut positions: Vec<Vec3>| {
        let a = Mesh::new(positions.clone(), vec![[0, 1, 2]]);
        let more = Mesh::new(positions[1..].to_vec(), vec![[0, 1, 2]]);
        positions[7] += 2.0;
        let b = Mesh::new(positions, vec![[0, 1, 2]]);
        let options = MeshOptions {
            tolerance: Some(0.5),
            ..MeshOptions::default()
        };
        let comparison = compare_meshes(&a, &b, &options).unwrap();
        assert_eq!(comparison.differing_vertices, 1);
        assert!(compare_meshes(&a, &more, &options).is_err());
    };
    grows_in_proportion(7_500, random, compared);
    grows_in_proportion(7_500, in_one_place, compared);
}

#[test]
fn differences_without_a_cause_are_told_by_how_many_vertices_agree_and_where_the_others_lie() {
    let a = reference();
    let mut b = a.clone();
    let moved = |p: Vec3| p.y > 0.5 && p.x > 0.4;
    for position in b.positions.iter_mut().filter(|p| moved(**p)) {
        position.x *= 1.1;
    }
    let comparison = compare(&a, &b);
    assert_eq!(comparison.findings, []);
    let differing = || a.positions.iter().copied().filter(|p| moved(*p));
    let min = differing().reduce(Vec3::min).unwrap().as_dvec3();
    let max = differing().reduce(Vec3::max).unwrap().as_dvec3();
    let bounds = [min.to_array(), max.to_array()];
    assert_eq!(comparison.differing_bounds, Some(bounds));
    let all = a.positions.len();
    let agreeing = all - differing().count();
    let told = format!(
        "B is not A moved, turned, scaled, rounded or in another order: {agreeing} of {all} vertices agree; \
         those that differ lie in A within ({:.6}, {:.6}, {:.6}) to ({:.6}, {:.6}, {:.6})\n",
        min.x, min.y, min.z, max.x, max.y, max.z
    );
    assert!(comparison.to_string().contains(&told), "{comparison}");

    let unknown = "B is not A moved";
    let text = |b: &Mesh| compare(&a, b).to_string();
    assert!(!text(&a).contains(unknown));
    assert_eq!(compare(&a, &a).differing_bounds, None);
    let with = |change: fn(Vec3) -> Vec3| {
        let positions = a.positions.iter().map(|p| change(*p)).collect();
        text(&Mesh::new(positions, a.triangles.clone()))
    };
    assert!(!with(|p| p + Vec3::X).contains(unknown));
    let none = with(|p| p * Vec3::new(1.1, 1.2, 1.3));
    let told = "B is not A moved, turned, scaled, rounded or in another order: no vertex agrees\n";
    assert!(none.contains(told), "{none}");
    // Neither other triangles nor a vertex that is no number account for the others.
    b.triangles.pop();
    assert!(text(&b).contains(unknown));
    b.positions[0].x = f32::NAN;
    assert!(text(&b).contains(unknown));
    let mut hole = a.clone();
    hole.positions[0].x = f32::NAN;
    assert!(!text(&hole).contains(unknown));
}

#[test]
fn what_rounds_to_nothing_has_no_sign() {
    let offset = MeshFinding::Offset {
        by: [0.1, -4e-7, -0.0],
    };
    let told = "B is A moved by (0.100000, 0.000000, 0.000000)";
    assert_eq!(offset.to_string(), told);
}

#[test]
fn vertices_that_differ_are_placed_by_the_parts_that_they_belong_to() {
    let a = reference();
    let mut b = a.clone();
    for index in [1, 2, 3, 8, 9] {
        b.positions[index].x += 0.5;
    }
    let of = |index: usize| match index {
        0..8 => Some(0),
        8 => Some(1),
        _ => None,
    };
    let parts = MeshParts {
        names: vec!["Lid".to_owned(), "Spout".to_owned()],
        of_vertex: (0..a.positions.len()).map(of).collect(),
    };
    let options = MeshOptions {
        parts: Some(&parts),
        ..MeshOptions::default()
    };
    let comparison = compare_meshes(&a, &b, &options).unwrap();
    let places = comparison.places.iter();
    let places: Vec<_> = places.map(|p| (p.place.as_str(), p.vertices)).collect();
    let expected = [
        ("near Lid", 3),
        ("near Spout", 1),
        ("where no joint moves them", 1),
    ];
    assert_eq!(places, expected);
    assert!(
        comparison
            .to_string()
            .contains("  near Lid: less than 1 % of the vertices (3)")
    );
}

#[test]
fn without_parts_they_are_placed_by_the_sides_of_the_mesh_and_a_cause_needs_no_place() {
    let a = reference();
    let (mut b, mut moved) = (a.clone(), a.clone());
    let highest = a.positions.iter().map(|p| p.y).fold(f32::MIN, f32::max);
    for position in &mut b.positions {
        position.y += if position.y > highest - 0.05 {
            0.2
        } else {
            0.0
        };
    }
    for position in &mut moved.positions {
        position.y += 0.2;
    }
    let comparison = compare(&a, &b);
    let [place] = &comparison.places[..] else {
        panic!("{:?}", comparison.places);
    };
    assert_eq!(place.place, "at the top of the mesh");
    assert_eq!(place.vertices, comparison.differing_vertices);
    assert_eq!(compare(&a, &moved).places, []);
}
