use crate::curves::support::{Merged, evaluate, flat, half_circle, read, spline, volume};
use editor_core::geometry::{
    Basis, Curve, CurveFrame, CurvePoint, Mesh, Normals, generalized_cylinder,
    surface_of_revolution, wireframe,
};
use glam::Vec3;

fn normals(mesh: &Mesh) -> &[Vec3] {
    match &mesh.normals {
        Normals::PerVertex(normals) => normals,
        Normals::Flat => panic!("a surface has one normal a vertex"),
    }
}

/// Triangles wind counter-clockwise with the normals of their corners.
fn winds_with_normals(mesh: &Mesh) -> bool {
    let normals = normals(mesh);
    mesh.triangles.iter().all(|corners| {
        let [a, b, c] = corners.map(|i| mesh.positions[i as usize]);
        let normal: Vec3 = corners.iter().map(|&i| normals[i as usize]).sum();
        (b - a).cross(c - a).dot(normal) > 0.0
    })
}

fn torus(large: f32, small: f32) -> Mesh {
    let profile = Curve::circle(24, small).unwrap().evaluate();
    let sweep = Curve::circle(48, large).unwrap().evaluate();
    generalized_cylinder(&profile, &sweep)
}

#[test]
fn a_sphere_is_watertight_and_its_normals_point_outward() {
    let sphere = surface_of_revolution(&half_circle(2.0, 16), 24);
    let merged = Merged::new(&sphere);
    assert!(merged.is_watertight() && merged.winds_consistently());
    assert_eq!(merged.euler_characteristic(), 2);
    assert!(winds_with_normals(&sphere));
    for (position, normal) in sphere.positions.iter().zip(normals(&sphere)) {
        assert!((*position / 2.0).distance(*normal) < 1e-5);
    }
}

#[test]
fn a_profile_drawn_the_other_way_or_on_the_other_side_still_points_outward() {
    let mut downward = half_circle(1.0, 16);
    downward.reverse();
    for point in &mut downward {
        point.frame.tangent = -point.frame.tangent;
        point.frame.normal = -point.frame.normal;
    }
    let mut left = half_circle(1.0, 16);
    for point in &mut left {
        point.position.x = -point.position.x;
        point.frame.tangent.x = -point.frame.tangent.x;
        // Z × T, as every flat curve has it.
        point.frame.normal = Vec3::Z.cross(point.frame.tangent);
    }
    for profile in [downward, left] {
        let sphere = surface_of_revolution(&profile, 24);
        assert!(winds_with_normals(&sphere));
        assert!(volume(&sphere.positions, &sphere.triangles) > 4.0);
        for (position, normal) in sphere.positions.iter().zip(normals(&sphere)) {
            assert!(position.distance(*normal) < 1e-5);
        }
    }
}

#[test]
fn a_circle_about_the_axis_turns_into_two_spheres_that_both_point_outward() {
    let circle = Curve::circle(32, 1.0).unwrap().evaluate();
    let sphere = surface_of_revolution(&circle, 32);
    assert!(winds_with_normals(&sphere));
    for (position, normal) in sphere.positions.iter().zip(normals(&sphere)) {
        assert!(position.distance(*normal) < 1e-5);
    }
}

#[test]
fn a_vase_open_at_both_ends_points_outward_as_if_discs_closed_it() {
    for [from, to] in [[[1.0, 0.0], [1.0, 2.0]], [[1.0, 2.0], [1.0, 0.0]]] {
        let [a, b] = [from, to].map(|[x, y]: [f32; 2]| Vec3::new(x, y, 0.0));
        let points = (0..4).map(|i| a.lerp(b, i as f32 / 3.0)).collect();
        let tube = surface_of_revolution(&spline(Basis::Bezier, 5, points).evaluate(), 20);
        assert!(winds_with_normals(&tube));
        for (position, normal) in tube.positions.iter().zip(normals(&tube)) {
            assert!(normal.dot(Vec3::new(position.x, 0.0, position.z)) > 0.99);
        }
    }
}

#[test]
fn normals_of_a_glass_stay_where_its_inner_wall_is_dragged_out_through_the_outer_one() {
    let glass = |dragged: f32| {
        let profile = [
            [0.0, 0.0],
            [0.0, 0.0],
            [0.0, 0.0],
            [0.9, 0.3],
            [1.0 + dragged, 1.0],
            [0.9, 2.3],
            [1.0, 2.6],
            [1.1, 2.3],
            [1.2, 1.0],
            [1.0, 0.2],
            [0.1, -0.2],
            [0.1, -1.0],
            [0.8, -1.1],
            [0.0, -1.2],
            [0.0, -1.2],
            [0.0, -1.2],
        ];
        let points = profile.map(|[x, y]| Vec3::new(x, y, 0.0)).to_vec();
        surface_of_revolution(&spline(Basis::BSpline, 8, points).evaluate(), 24)
    };
    let thin = glass(0.0);
    for dragged in [0.3, 0.6, 0.9] {
        let pushed = glass(dragged);
        assert_eq!(pushed.triangles, thin.triangles, "{dragged}");
        let same = normals(&thin).iter().zip(normals(&pushed));
        let turned = same.filter(|(before, after)| before.dot(**after) < -0.99);
        assert_eq!(turned.count(), 0, "{dragged}");
    }
    // The foot is seen from below.
    let lowest = |positions: &[Vec3]| {
        let all = positions.iter().enumerate();
        all.min_by(|(_, a), (_, b)| a.y.total_cmp(&b.y)).unwrap().0
    };
    assert!(normals(&thin)[lowest(&thin.positions)].y < -0.9);
}

#[test]
fn a_torus_is_watertight_with_euler_characteristic_zero() {
    let torus = torus(2.0, 0.5);
    let merged = Merged::new(&torus);
    assert!(merged.is_watertight() && merged.winds_consistently());
    assert_eq!(merged.euler_characteristic(), 0);
    assert_eq!(merged.vertices, 24 * 48);
    assert!(winds_with_normals(&torus));
    for (position, normal) in torus.positions.iter().zip(normals(&torus)) {
        let center = Vec3::new(position.x, position.y, 0.0).normalize_or_zero() * 2.0;
        assert!(((position - center) / 0.5).distance(*normal) < 1e-5);
    }
}

#[test]
fn a_clockwise_profile_is_turned_outward() {
    let mut clockwise = Curve::circle(24, 0.5).unwrap().evaluate();
    clockwise.reverse();
    for point in &mut clockwise {
        point.frame.tangent = -point.frame.tangent;
        point.frame.normal = -point.frame.normal;
    }
    let sweep = Curve::circle(48, 2.0).unwrap().evaluate();
    let torus = generalized_cylinder(&clockwise, &sweep);
    assert!(winds_with_normals(&torus));
    assert!(volume(&torus.positions, &torus.triangles) > 9.0);
}

#[test]
fn a_tube_with_open_ends_points_outward_whichever_way_its_profile_turns() {
    let sweep = flat(&[[5., 0.], [6., 1.], [7., -1.], [8., 0.]]);
    let sweep = spline(Basis::Bezier, 20, sweep).evaluate();
    let ring = flat(&[
        [0.1, 0.],
        [0., 0.1],
        [-0.1, 0.],
        [0., -0.1],
        [0.1, 0.],
        [0., 0.1],
        [-0.1, 0.],
    ]);
    for backwards in [false, true] {
        let mut ring = ring.clone();
        if backwards {
            ring.reverse();
        }
        let ring = spline(Basis::BSpline, 6, ring).evaluate();
        let tube = generalized_cylinder(&ring, &sweep);
        assert!(winds_with_normals(&tube));
        for (i, position) in tube.positions.iter().enumerate() {
            let out = position - sweep[i / ring.len()].position;
            assert!(normals(&tube)[i].dot(out) > 0.0);
        }
    }
}

#[test]
fn a_point_of_the_profile_lies_at_x_along_n_and_y_along_b() {
    let sweep = Curve::circle(8, 2.0).unwrap().evaluate();
    let profile = flat(&[[0.25, -0.5]; 4]);
    let profile = spline(Basis::Bezier, 1, profile).evaluate();
    let surface = generalized_cylinder(&profile, &sweep);
    // At (2, 0, 0): N = −X, B = +Z.
    assert!(surface.positions[0].distance(Vec3::new(1.75, 0.0, -0.5)) < 1e-6);
}

#[test]
fn a_closed_sweep_that_is_not_flat_closes_only_when_its_frames_are_closed() {
    let text = "circ ring 12 0.2
        bsp3 way 12 11 [2 1 0] [1 -1 1] [0 1 2] [-1 -1 1] [-2 1 0] [-1 0 -1] [0 1 -2] [1 0 -1.5]
                       [2 1 0] [1 -1 1] [0 1 2]
        gcyl tube ring way";
    let closed = Merged::new(&evaluate(read(text).unwrap(), true).mesh);
    assert!(closed.is_watertight() && closed.winds_consistently());
    assert_eq!(closed.euler_characteristic(), 0);
    let left = Merged::new(&evaluate(read(text).unwrap(), false).mesh);
    assert!(left.winds_consistently() && !left.is_watertight());
}

#[test]
fn poles_have_no_triangles_without_area() {
    let sphere = surface_of_revolution(&half_circle(1.0, 8), 12);
    assert_eq!(sphere.triangles.len(), 2 * 12 * (8 - 1));
}

#[test]
fn a_wireframe_has_every_edge_once() {
    let torus = torus(2.0, 0.5);
    let edges = wireframe(&torus.triangles);
    // A grid of 24 × 48 cells: along, across and diagonal.
    assert_eq!(edges.len(), 24 * 49 + 25 * 48 + 24 * 48);
    assert!(edges.iter().all(|[a, b]| a < b));
}

#[test]
fn several_surfaces_of_a_file_share_one_mesh_and_know_their_parts() {
    let text = "circ a 8 0.5 circ b 16 2 gcyl one a b srev two 10 a";
    let geometry = evaluate(read(text).unwrap(), true);
    let surfaces = &geometry.curves.as_ref().unwrap().surfaces;
    assert_eq!(surfaces.len(), 2);
    assert_eq!((surfaces[0].item, surfaces[1].item), (2, 3));
    assert_eq!(surfaces[0].vertices, 0..9 * 17);
    assert_eq!(surfaces[1].vertices, 9 * 17..9 * 17 + 9 * 11);
    assert_eq!(surfaces[1].triangles.end, geometry.mesh.triangles.len());
    let own = &geometry.mesh.triangles[surfaces[1].triangles.clone()];
    assert!(
        own.iter()
            .flatten()
            .all(|&i| surfaces[1].vertices.contains(&(i as usize)))
    );
    assert_eq!(normals(&geometry.mesh).len(), geometry.mesh.positions.len());
}

#[test]
fn bounds_are_around_curves_and_surfaces_but_not_around_control_points() {
    let bounds = evaluate(read("bez2 a 8 4 [0 0] [0 4] [1 4] [1 0]").unwrap(), true).bounds();
    assert_eq!(
        (bounds.min, bounds.max),
        (Vec3::ZERO, Vec3::new(1.0, 3.0, 0.0))
    );
    let bounds = evaluate(read("circ a 8 1 srev s 8 a").unwrap(), true).bounds();
    assert!(bounds.min.distance(-Vec3::ONE) < 1e-6 && bounds.max.distance(Vec3::ONE) < 1e-6);
}

#[test]
fn a_profile_that_ends_on_the_axis_but_for_rounding_ends_in_one_point() {
    let point = |x, y| CurvePoint {
        position: Vec3::new(x, y, 0.0),
        frame: CurveFrame {
            tangent: Vec3::Y,
            normal: Vec3::NEG_X,
            binormal: Vec3::Z,
        },
    };
    // A cone 2 high with three sides; a ten-millionth of its size is 2e-7.
    for (beside, triangles) in [(0.0, 3), (1.9e-7, 3), (-1.9e-7, 3), (1e-5, 6)] {
        let cone = surface_of_revolution(&[point(0.1, -1.0), point(beside, 1.0)], 3);
        assert_eq!(cone.triangles.len(), triangles, "{beside}");
        let mut tips = cone.positions.iter().filter(|position| position.y > 0.0);
        let is_one = tips.all(|&tip| tip == Vec3::Y);
        assert_eq!(is_one, triangles == 3, "{beside}");
    }
}
