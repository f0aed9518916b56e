use super::*;
use crate::character::{Character, Joint, SkeletalModel, Skinned};
use crate::geometry::Seams;
use glam::{EulerRot, Quat};
use proptest::prelude::*;

const JOINTS: u32 = 40;

/// Every level that this processor has, the best one last.
fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let lower = [
        best.as_sse2().map(Level::Sse2),
        best.as_sse4_2().map(Level::Sse4_2),
        best.as_avx2().map(Level::Avx2),
    ];
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    let lower: [Option<Level>; 0] = [];
    lower.into_iter().flatten().chain([best]).collect()
}

fn character(mesh: Mesh, attachments: Attachments) -> Character {
    let mut joints = vec![Joint::default()];
    joints.extend((1..JOINTS).map(|joint| Joint {
        parent: Some(joint as usize - 1),
        offset: Vec3::new(0.1, 0.2, -0.3),
        ..Joint::default()
    }));
    Character::new(SkeletalModel::new(joints).unwrap(), attachments, mesh).unwrap()
}

/// Joints anywhere: frames need not belong to a pose.
fn frames(seed: u32) -> Vec<Mat4> {
    (0..JOINTS)
        .map(|joint| {
            let angle = (joint * 7 + seed) as f32;
            let turn = Quat::from_euler(EulerRot::XYZ, angle, 0.3 * angle, -1.7 * angle);
            Mat4::from_rotation_translation(turn, Vec3::new(angle.sin(), angle, 0.1) * 3.0)
        })
        .collect()
}

/// So many vertices, of which each has as many influences as `counts` says in turn.
fn mesh(vertices: usize, counts: &[usize], with_normals: bool) -> (Mesh, Attachments) {
    let number = |at: usize| (at as f32 * 12.9898).sin();
    let vector = |at: usize| Vec3::new(number(at), number(at + 1), number(at + 2));
    let positions: Vec<Vec3> = (0..vertices).map(|at| vector(at) * 50.0).collect();
    let mut attachments = Attachments::new();
    for vertex in 0..vertices {
        let count = counts[vertex % counts.len()];
        attachments.push_vertex((0..count).map(|k| Influence {
            joint: (vertex / 300 + k * k + vertex % 3) as u32 % JOINTS,
            weight: number(vertex + 31 * k) * 0.5 + 0.3,
        }));
    }
    let mut mesh = Mesh::new(positions, Vec::new());
    if with_normals {
        let copies: Vec<u32> = (0..vertices as u32).step_by(3).collect();
        let normals = (0..vertices + copies.len()).map(|at| vector(7 * at).normalize_or_zero());
        mesh.normals = Normals::PerVertex(normals.collect());
        mesh.seams = Some(Seams {
            copies,
            triangles: Vec::new(),
        });
    }
    (mesh, attachments)
}

/// How two results differ first, bit by bit: unlike `==`, it tells 0 from -0 and takes equal NaN as equal.
fn difference(one: &Skinned, other: &Skinned) -> Option<String> {
    let bits = |of: &Skinned| -> Vec<[u32; 3]> {
        let normals = of.normals.iter().flatten();
        let all = of.positions.iter().chain(normals);
        all.map(|v| v.to_array().map(f32::to_bits)).collect()
    };
    if one.normals.as_ref().map(Vec::len) != other.normals.as_ref().map(Vec::len) {
        return Some("numbers of normals".to_owned());
    }
    let (one, other) = (bits(one), bits(other));
    if one.len() != other.len() {
        return Some(format!("{} and {} vertices", one.len(), other.len()));
    }
    let at = one
        .iter()
        .zip(&other)
        .position(|(one, other)| one != other)?;
    Some(format!("{at}: {:?} and {:?}", one[at], other[at]))
}

/// How `character` differs from the reference in some way to skin it.
fn fault(character: &Character, frames: &[Mat4]) -> Option<String> {
    let expected = character.skin_one_by_one(frames);
    let palette = character.skeleton().palette(frames);
    levels().into_iter().find_map(|level| {
        let blocks =
            SkinningBlocks::new(character.attachments(), character.bind_mesh(), level).unwrap();
        let mut found = Skinned::default();
        blocks.skin(&palette, &mut found);
        let found = difference(&found, &expected);
        found.map(|difference| format!("{level:?}: {difference}"))
    })
}

#[test]
fn every_level_of_the_processor_gives_the_bits_of_the_reference() {
    for with_normals in [false, true] {
        // More than a window, and no multiple of the lanes.
        let (mesh, attachments) = mesh(WINDOW + 77, &[4, 1, 0, 13, 2, 40, 5, 0, 3], with_normals);
        let character = character(mesh, attachments);
        for seed in 0..3 {
            assert_eq!(fault(&character, &frames(seed)), None);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_weights_any_number_of_them_and_none_give_the_bits_of_the_reference(
        weights in prop::collection::vec(
            prop::collection::vec((0..JOINTS, -2.0..2.0_f32), 0..20), 0..60),
        with_normals: bool,
        seed in 0..1000_u32,
    ) {
        let (mesh, _) = mesh(weights.len(), &[0], with_normals);
        let mut attachments = Attachments::new();
        for vertex in &weights {
            let influence = |&(joint, weight)| Influence { joint, weight };
            attachments.push_vertex(vertex.iter().map(influence));
        }
        prop_assert_eq!(fault(&character(mesh, attachments), &frames(seed)), None);
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let many = (3 * WINDOWS_FOR_A_THREAD + 1) * WINDOW + 5;
    let (mesh, attachments) = mesh(many, &[4, 2, 0, 6], true);
    let character = character(mesh, attachments);
    let expected = character.skin_one_by_one(&frames(1));
    for threads in [1, 2, 3, 5] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let skinned = pool.build().unwrap().install(|| character.skin(&frames(1)));
        assert_eq!(difference(&skinned, &expected), None, "{threads} threads");
    }
}

#[test]
fn a_joint_that_is_nowhere_takes_only_its_own_vertices_along() {
    let (mesh, attachments) = mesh(200, &[1, 2, 0], true);
    let character = character(mesh, attachments);
    let mut frames = frames(2);
    frames[1] = Mat4::from_translation(Vec3::INFINITY);
    let skinned = character.skin(&frames);
    assert_eq!(
        difference(&skinned, &character.skin_one_by_one(&frames)),
        None
    );
    assert!(
        skinned
            .positions
            .iter()
            .any(|position| position.is_finite())
    );
    assert!(
        !skinned
            .positions
            .iter()
            .all(|position| position.is_finite())
    );
}

#[test]
fn what_was_skinned_before_is_replaced() {
    let expected = |with_normals| {
        let (mesh, attachments) = mesh(100, &[3, 0], with_normals);
        let character = character(mesh, attachments);
        let blocks =
            SkinningBlocks::new(character.attachments(), character.bind_mesh(), Level::new())
                .unwrap();
        let palette = character.skeleton().palette(&frames(4));
        (blocks, palette, character.skin_one_by_one(&frames(4)))
    };
    let mut skinned = Skinned::default();
    for with_normals in [true, false, true] {
        let (blocks, palette, expected) = expected(with_normals);
        blocks.skin(&palette, &mut skinned);
        blocks.skin(&palette, &mut skinned);
        assert_eq!(difference(&skinned, &expected), None);
    }
}

#[test]
fn fewer_influences_are_skinned_as_such() {
    let (mesh, attachments) = mesh(100, &[5, 3], false);
    let character = character(mesh, attachments);
    let all = character.skin(&frames(0));
    let limited = character.limited(1);
    assert_ne!(limited.skin(&frames(0)), all);
    assert_eq!(
        limited.skin(&frames(0)),
        limited.skin_one_by_one(&frames(0))
    );
}

#[test]
fn vertices_with_nothing_in_common_are_skinned_one_by_one() {
    let (mesh, _) = mesh(20 * WINDOW, &[0], false);
    let mut attachments = Attachments::new();
    for vertex in 0..mesh.positions.len() as u32 {
        // All joints, in an order of its own.
        attachments.push_vertex((0..JOINTS).map(|at| Influence {
            joint: (at * (2 * (vertex % 17) + 1) * 3 + vertex) % JOINTS,
            weight: 1.0 / JOINTS as f32,
        }));
    }
    let level = Level::new();
    let blocks = SkinningBlocks::new(&attachments, &mesh, level);
    // Fewer lanes cannot have more weights than are worth it.
    let may_be_too_many = kernel::lanes(level) > MOST_WEIGHTS;
    assert_eq!(blocks.is_none(), may_be_too_many);
    let character = character(mesh, attachments);
    let skinned = character.skin(&frames(3));
    let expected = character.skin_one_by_one(&frames(3));
    assert_eq!(difference(&skinned, &expected), None);
}
