//! A small character with the course's eighteen joints, made in code.

use editor_core::character::{
    Attachments, COURSE_JOINT_NAMES, Character, Influence, Joint, SkeletalModel,
};
use editor_core::geometry::{Mesh, Poles, sphere};
use glam::Vec3;
use std::sync::Arc;

/// Parent and offset of every joint, in the course's order.
const JOINTS: [(Option<usize>, [f32; 3]); 18] = [
    (None, [0.0, 0.1, 0.0]),
    (Some(0), [0.0, 0.0, 0.0]),
    (Some(1), [0.0, -0.25, 0.0]),
    (Some(0), [0.0, 0.3, 0.0]),
    (Some(2), [-0.12, -0.05, 0.0]),
    (Some(4), [0.0, -0.05, 0.0]),
    (Some(5), [0.0, -0.35, 0.0]),
    (Some(6), [0.0, -0.35, 0.05]),
    (Some(2), [0.12, -0.05, 0.0]),
    (Some(8), [0.0, -0.05, 0.0]),
    (Some(9), [0.0, -0.35, 0.0]),
    (Some(10), [0.0, -0.35, 0.05]),
    (Some(0), [0.0, 0.0, 0.0]),
    (Some(12), [-0.2, 0.2, 0.0]),
    (Some(13), [-0.3, 0.0, 0.0]),
    (Some(0), [0.0, 0.0, 0.0]),
    (Some(15), [0.2, 0.2, 0.0]),
    (Some(16), [0.3, 0.0, 0.0]),
];

/// A character of one ball a joint, whose joints are called `names`.
pub fn figure_called(names: &[&str; 18]) -> Arc<Character> {
    let joints = JOINTS.iter().zip(names);
    let joints = joints.map(|(&(parent, offset), &name)| Joint {
        name: name.to_owned(),
        parent,
        offset: Vec3::from(offset),
        ..Joint::default()
    });
    let skeleton = SkeletalModel::new(joints.collect()).expect("a tree");
    let ball = sphere(0.1, 12, 8, Poles::Y);
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut attachments = Attachments::new();
    for (joint, at) in skeleton.bind_positions().into_iter().enumerate() {
        let first = positions.len() as u32;
        for &position in ball.positions.iter() {
            positions.push(at + position);
            attachments.push_vertex([Influence {
                joint: joint as u32,
                weight: 1.0,
            }]);
        }
        let moved = |corner: &[u32; 3]| corner.map(|index| index + first);
        triangles.extend(ball.triangles.iter().map(moved));
    }
    let mesh = Mesh::new(positions, triangles);
    Arc::new(Character::new(skeleton, attachments, mesh).expect("counts that agree"))
}

/// [`figure_called`] with the course's names.
pub fn figure() -> Arc<Character> {
    figure_called(&COURSE_JOINT_NAMES)
}

/// A character of these joints without a mesh.
fn bare(joints: Vec<Joint>) -> Arc<Character> {
    let skeleton = SkeletalModel::new(joints).expect("every parent is there");
    let mesh = Mesh::new(Vec::new(), Vec::new());
    Arc::new(Character::new(skeleton, Attachments::new(), mesh).expect("counts that agree"))
}

/// A character that is one chain of `count` joints without a mesh.
pub fn chain(count: usize) -> Arc<Character> {
    let joints = (0..count).map(|joint| Joint {
        name: format!("Joint {joint}"),
        parent: joint.checked_sub(1),
        offset: Vec3::Y * 0.01,
        ..Joint::default()
    });
    bare(joints.collect())
}

/// A character of two bones side by side, each a root.
pub fn forest() -> Arc<Character> {
    let roots = [-0.5, 0.5].map(|x| Joint {
        name: format!("Root at {x}"),
        offset: Vec3::X * x,
        tip: Some(Vec3::Y * 0.6),
        ..Joint::default()
    });
    bare(roots.to_vec())
}

/// An arm with a hand of two fingers, all in a row but for the fingers: shoulder, elbow, wrist,
/// and twice a knuckle and a finger's middle.
pub fn arm() -> Arc<Character> {
    const PARTS: [(&str, Option<usize>, [f32; 3]); 7] = [
        ("Shoulder", None, [-0.4, 0.0, 0.0]),
        ("Elbow", Some(0), [0.35, 0.0, 0.0]),
        ("Wrist", Some(1), [0.35, 0.05, 0.0]),
        ("Knuckle 1", Some(2), [0.06, 0.03, 0.0]),
        ("Finger 1", Some(3), [0.04, 0.0, 0.0]),
        ("Knuckle 2", Some(2), [0.06, -0.03, 0.0]),
        ("Finger 2", Some(5), [0.04, 0.0, 0.0]),
    ];
    let joints = PARTS.iter().map(|&(name, parent, offset)| Joint {
        name: name.to_owned(),
        parent,
        offset: offset.into(),
        ..Joint::default()
    });
    bare(joints.collect())
}
