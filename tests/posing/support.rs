//! Characters, cameras and placements at random.

use editor_core::character::{Attachments, Character, Joint, Pose, SkeletalModel};
use editor_core::editor::{Edit, Session, View};
use editor_core::geometry::Mesh;
use editor_core::math::{Euler, Transform};
use editor_core::scene::NewShape;
use editor_core::scene::{Camera, CharacterShape, ShapeId, ShapeKind};
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use std::sync::Arc;

pub const SIZE: Vec2 = Vec2::new(800.0, 600.0);

pub fn vector(range: std::ops::Range<f32>) -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(range).prop_map(Vec3::from_array)
}

pub fn cameras() -> impl Strategy<Value = Camera> {
    (
        vector(-0.5..0.5),
        4.0..20.0_f32,
        -3.1..3.1_f32,
        -1.47..1.47_f32,
    )
        .prop_map(|(target, radius, theta, phi)| Camera {
            target,
            radius,
            theta,
            phi,
            ..Camera::default()
        })
}

/// Unevenly scaled and turned.
pub fn transforms() -> impl Strategy<Value = Transform> {
    (vector(-0.5..0.5), vector(-180.0..180.0), vector(0.3..1.5)).prop_map(
        |(position, degrees, scale)| Transform {
            position,
            rotation: Euler::from_degrees(degrees),
            scale,
        },
    )
}

/// Angles in degrees of the four joints of [`figure`].
pub fn poses() -> impl Strategy<Value = Pose> {
    prop::array::uniform4(vector(-180.0..180.0)).prop_map(|degrees| {
        let mut pose = Pose::new();
        for (joint, degrees) in degrees.into_iter().enumerate() {
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        pose
    })
}

/// A root, a chain of two joints on it, and a second root; every joint has a bone.
pub fn figure() -> Arc<Character> {
    let joint = |parent, offset: [f32; 3], tip: [f32; 3]| Joint {
        parent,
        offset: offset.into(),
        tip: Some(tip.into()),
        ..Joint::default()
    };
    let joints = vec![
        joint(None, [0.1, -0.2, 0.0], [0.1, 0.5, 0.0]),
        joint(Some(0), [0.1, 0.5, 0.0], [0.4, 0.1, 0.2]),
        joint(Some(1), [0.4, 0.1, 0.2], [0.0, -0.3, 0.4]),
        joint(None, [-0.6, 0.0, 0.3], [0.0, 0.7, 0.1]),
    ];
    let skeleton = SkeletalModel::new(joints).expect("a forest");
    let mesh = Mesh::new(Vec::new(), Vec::new());
    Arc::new(Character::new(skeleton, Attachments::new(), mesh).expect("counts that agree"))
}

pub fn session(camera: Camera, transform: Transform, pose: &Pose) -> (Session, ShapeId) {
    let mut session = Session::new();
    let kind = ShapeKind::Character(CharacterShape::new(figure()));
    let insert = Edit::Insert(vec![NewShape::new("Figure", kind)]);
    session.edit(insert).unwrap();
    let id = session.selected().expect("it is selected");
    session.edit(Edit::SetTransform(id, transform)).unwrap();
    session.edit(Edit::SetPose(id, pose.clone())).unwrap();
    session.look(View::SetCamera(camera));
    (session, id)
}

/// A point of the world in a joint's frame, and back.
pub fn world_from_joint(session: &Session, id: ShapeId, joint: usize) -> glam::Mat4 {
    let shape = session.evaluated().shape(id).expect("it is evaluated");
    let figure = shape.geometry.figure.as_ref().expect("a character");
    shape.world_from_model * figure.model_from_joint[joint]
}

pub fn pixel(session: &Session, world: Vec3) -> Option<Vec2> {
    session.view().camera.pixel(world, SIZE)
}
