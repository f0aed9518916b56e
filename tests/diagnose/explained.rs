//! The formula at work on one vertex, and meshes with a mistake made on purpose.

use crate::diagnose::figures::{Figure, turned};
use crate::diagnose::named;
use editor_core::diagnose::{
    Factor, Factors, Formula, MISTAKES, Reading, Verdict, VertexFormula, skin_by,
};
use editor_core::io::builtin::{BuiltinKind, catalogue};
use glam::{DVec3, Vec3};
use std::collections::BTreeSet;

/// Every built-in character, all joints of which are turned.
fn characters() -> impl Iterator<Item = Figure> {
    let all = catalogue().into_iter();
    let characters = all.filter(|builtin| builtin.kind == BuiltinKind::Character);
    characters
        .zip(1..)
        .map(|(builtin, seed)| Figure::builtin(builtin.name, turned(seed)))
}

fn size(points: &[Vec3]) -> f32 {
    let low = points.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    low.distance(high)
}

fn made(reading: &Reading) -> Formula {
    let mut formula = Formula::default();
    (reading.make)(&mut formula);
    formula
}

#[test]
fn the_numbers_of_every_vertex_lead_to_where_the_exact_path_puts_it() {
    for figure in characters() {
        let exact = figure.character.skin_pose(&figure.pose());
        let (size, joints) = (size(&exact), figure.character.skeleton());
        let model_from_joint = joints.update_current_joint_to_world_transforms(&figure.pose());
        for (vertex, exact) in exact.iter().enumerate().step_by(97) {
            let pose = figure.pose();
            let formula = Formula::default();
            let told = VertexFormula::new(&figure.character, &pose, &formula, vertex).unwrap();
            let case = format!("{} vertex {vertex}: {told:?}", figure.name);
            assert!(told.sum.as_vec3().distance(*exact) < 2e-6 * size, "{case}");
            assert_eq!(told.rest.as_vec3(), figure.positions[vertex], "{case}");
            let influences = figure.character.attachments().of_vertex(vertex);
            let weights = influences
                .iter()
                .map(|one| (one.joint as usize, f64::from(one.weight)));
            let shown = told.terms.iter().map(|term| (term.joint, term.weight));
            assert!(weights.eq(shown), "{case}");
            assert_eq!(told.left_out, [], "{case}");
            let mut sum = DVec3::ZERO;
            for term in &told.terms {
                let [inverse, current] = &term.steps[..] else {
                    panic!("{case}");
                };
                assert_eq!(inverse.factor, Factor::InverseBind);
                assert_eq!(current.factor, Factor::Current);
                let exact = model_from_joint[term.joint];
                let is_exact = current
                    .matrix
                    .as_mat4()
                    .abs_diff_eq(exact, 1e-5 * size.max(1.0));
                assert!(is_exact, "{case}");
                let exact = joints.bind_joint_from_model()[term.joint];
                let is_exact = inverse
                    .matrix
                    .as_mat4()
                    .abs_diff_eq(exact, 1e-5 * size.max(1.0));
                assert!(is_exact, "{case}");
                assert_eq!(inverse.at, inverse.matrix.transform_point3(told.rest));
                assert_eq!(current.at, current.matrix.transform_point3(inverse.at));
                assert_eq!(term.weighted, current.at * term.weight);
                sum += term.weighted;
            }
            assert!(told.terms.is_empty() || sum == told.sum, "{case}");
        }
    }
}

#[test]
fn every_mistake_that_is_made_on_purpose_is_the_one_that_a_diagnosis_finds() {
    let mut seen = BTreeSet::new();
    for figure in characters() {
        let exact = figure.character.skin_pose(&figure.pose());
        for mistake in MISTAKES {
            for reading in mistake.readings {
                let formula = made(reading);
                if !formula.is_of(&figure.character) {
                    continue;
                }
                let mesh = skin_by(&figure.character, &figure.pose(), &formula);
                let found = figure.diagnose(&mesh.positions);
                let case = format!("{} {} on {}: {found}", mistake.id, reading.how, figure.name);
                let pairs = exact.iter().zip(&mesh.positions);
                let apart = pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f32::max);
                // Where nothing can be seen of it, nothing is wrong.
                if apart < 1e-5 * size(&exact) {
                    assert_eq!(found.verdict, Verdict::Right, "{case}");
                } else {
                    assert_eq!(found.verdict, Verdict::Explained, "{case}");
                    assert!(named(&found).contains(&vec![mistake.id]), "{case}");
                    seen.insert(mistake.id);
                }
            }
        }
    }
    // The weights of no built-in character sum to anything but 1.
    let all = MISTAKES.iter().map(|mistake| mistake.id);
    let all: BTreeSet<_> = all.filter(|id| *id != "weights-normalized").collect();
    assert_eq!(seen, all, "these make a difference on no character");
}

#[test]
fn the_formula_of_a_vertex_leads_to_where_the_mesh_with_that_mistake_has_it() {
    for figure in characters() {
        for mistake in MISTAKES {
            for reading in mistake.readings {
                let (formula, pose) = (made(reading), figure.pose());
                let mesh = skin_by(&figure.character, &pose, &formula);
                for vertex in [0, mesh.positions.len() / 2, mesh.positions.len() - 1] {
                    let told = VertexFormula::new(&figure.character, &pose, &formula, vertex);
                    let told = told.unwrap().sum.as_vec3();
                    let case = format!("{} {} of {}", mistake.id, reading.how, figure.name);
                    let error = told.distance(mesh.positions[vertex]);
                    assert!(error <= 1e-5 * size(&mesh.positions), "{case}: {told}");
                }
            }
        }
    }
}

#[test]
fn the_exact_formula_gives_the_positions_and_normals_of_the_exact_path() {
    for figure in characters() {
        let pose = figure.pose();
        let skeleton = figure.character.skeleton();
        let joints = skeleton.update_current_joint_to_world_transforms(&pose);
        let exact = figure.character.skin_one_by_one(&joints);
        let (positions, normals) = (exact.positions, exact.normals);
        let mesh = skin_by(&figure.character, &pose, &Formula::default());
        let size = size(&positions);
        assert!(
            positions
                .iter()
                .zip(&mesh.positions)
                .all(|(a, b)| a.distance(*b) < 2e-6 * size)
        );
        assert_eq!(normals.is_some(), mesh.normals.is_some());
        for (a, b) in normals.iter().flatten().zip(mesh.normals.iter().flatten()) {
            assert!(a.distance(*b) < 1e-2, "{}: {a} {b}", figure.name);
        }
    }
}

#[test]
fn weights_that_do_not_count_are_told_and_a_formula_that_moves_nothing_has_no_terms() {
    let figure = Figure::builtin("adult", turned(5));
    let (character, pose) = (&figure.character, figure.pose());
    let attachments = character.attachments();
    let vertices = 0..attachments.vertex_count();
    let most = vertices
        .max_by_key(|&vertex| attachments.of_vertex(vertex).len())
        .unwrap();
    let influences = attachments.of_vertex(most).len();
    let mut one = Formula::default();
    let strongest = MISTAKES
        .iter()
        .find(|m| m.id == "strongest-joint-only")
        .unwrap();
    (strongest.readings[0].make)(&mut one);
    let told = VertexFormula::new(character, &pose, &one, most).unwrap();
    assert_eq!((told.terms.len(), told.left_out.len()), (1, influences - 1));
    assert_eq!(told.terms[0].weight, 1.0);
    let nothing = Formula {
        factors: Factors::Nothing,
        ..Formula::default()
    };
    let told = VertexFormula::new(character, &pose, &nothing, most).unwrap();
    assert_eq!((told.terms.len(), told.sum), (0, told.rest));
    let count = attachments.vertex_count();
    assert_eq!(VertexFormula::new(character, &pose, &one, count), None);
}
