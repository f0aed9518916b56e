//! The document: every change goes through one function, which says what changed, and gestures are
//! kept or cancelled as a whole.

use editor_core::character::{Attachments, Character, Joint, Pose, SkeletalModel};
use editor_core::editor::{Change, Edit, Session, View, apply};
use editor_core::geometry::Mesh;
use editor_core::math::Euler;
use editor_core::scene::{
    Camera, CharacterShape, FitArea, NewShape, Scene, ShapeColor, ShapeId, ShapeKind, ViewSettings,
};
use glam::Vec3;
use proptest::prelude::*;
use std::sync::Arc;

/// Two roots; an elbow hangs on the first. `names` are those of the first, the elbow and the second.
pub fn character(names: [&str; 3]) -> ShapeKind {
    let joints = names.into_iter().zip([None, Some(0), None]);
    let joints = joints.map(|(name, parent)| Joint {
        name: name.to_owned(),
        parent,
        offset: Vec3::Y,
        ..Joint::default()
    });
    let skeleton = SkeletalModel::new(joints.collect()).unwrap();
    let character = Character::new(skeleton, Attachments::new(), Mesh::default()).unwrap();
    ShapeKind::Character(CharacterShape::new(Arc::new(character)))
}

/// A session with two characters and a cube, in this order.
fn session() -> (Session, [ShapeId; 3]) {
    let shapes = vec![
        NewShape::new("One", character(["Left", "Elbow", "Right"])),
        NewShape::new("Other", character(["Left", "Elbow", "Right"])),
        NewShape::new("Cube", ShapeKind::Cube),
    ];
    let session = Session::with_shapes(shapes, ViewSettings::default());
    let [one, other, cube] = session.scene().shapes() else {
        panic!("three shapes");
    };
    let ids = [one.id, other.id, cube.id];
    (session, ids)
}

/// A pose with an angle and an offset at every joint that can have one.
fn posed() -> Pose {
    let mut pose = Pose::new();
    for joint in 0..3 {
        let degrees = Vec3::new(10.0, -20.0, 30.0) * (joint + 1) as f32;
        pose.set_joint_transform(joint, Euler::from_degrees(degrees));
    }
    pose.set_root_offset(0, Vec3::new(1.0, 2.0, 3.0));
    pose.set_root_offset(2, Vec3::new(-4.0, 0.0, 0.5));
    pose
}

fn pose_of(session: &Session, id: ShapeId) -> &Pose {
    session.scene().character(id).expect("a character").pose()
}

#[test]
fn an_edit_says_which_shapes_it_added_removed_and_altered() {
    let (mut session, [one, other, cube]) = session();
    let inserted = vec![
        NewShape::new("A", ShapeKind::Sphere),
        NewShape::new("B", ShapeKind::Pyramid),
    ];
    let change = session.edit(Edit::Insert(inserted)).unwrap();
    let added = vec![ShapeId(4), ShapeId(5)];
    let expected = Change {
        added: added.clone(),
        ..Change::default()
    };
    assert_eq!(change, expected);
    assert_eq!(session.selected(), Some(ShapeId(5)));

    let both = Edit::Together(vec![Edit::Delete(other), Edit::SetVisible(one, false)]);
    let expected = Change {
        removed: vec![other],
        altered: vec![one],
        ..Change::default()
    };
    assert_eq!(session.edit(both).unwrap(), expected);
    let change = session.edit(Edit::SetVisible(cube, true)).unwrap();
    assert!(change.is_nothing(), "it was visible before: {change:?}");
}

#[test]
fn an_edit_that_changes_nothing_leaves_the_revision_of_the_document() {
    let (mut session, [one, _, cube]) = session();
    let document = session.document();
    for edit in [
        Edit::SetPose(one, Pose::new()),
        Edit::SetVisible(cube, true),
        Edit::Delete(ShapeId(99)),
        Edit::Together(Vec::new()),
        Edit::ResetJoint(one, 7),
    ] {
        session.edit(edit).unwrap();
        assert_eq!(session.document(), document);
    }
    for view in [
        View::SetCamera(Camera::default()),
        View::Select(Some(one)),
        View::SelectJoint(Some(1)),
        View::HoverBone(Some((one, 1))),
        View::SetAxis(false),
    ] {
        session.look(view);
        assert_eq!(session.document(), document);
    }
    session.edit(Edit::SetVisible(cube, false)).unwrap();
    assert_ne!(session.document(), document);
}

#[test]
fn a_bone_of_another_character_under_the_pointer_is_no_joint_of_the_selected_one() {
    let (mut session, [one, other, _]) = session();
    session.look(View::Select(Some(one)));
    session.look(View::HoverBone(Some((other, 1))));
    assert_eq!(session.hovered_bone(), Some((other, 1)));
    assert_eq!(session.hovered_joint(), None);
    session.look(View::HoverJoint(Some(2)));
    assert_eq!(session.hovered_bone(), Some((one, 2)));
    assert_eq!(session.hovered_joint(), Some(2));
}

#[test]
fn fitting_means_the_selected_shape_or_everything_that_is_visible_where_it_is_hidden() {
    let (mut session, [_, _, cube]) = session();
    let far = editor_core::math::Transform {
        position: Vec3::X * 50.0,
        ..editor_core::math::Transform::IDENTITY
    };
    let shapes = vec![NewShape::new("Sphere", ShapeKind::Sphere)];
    session.edit(Edit::Insert(shapes)).unwrap();
    let sphere = session.selected().unwrap();
    session.edit(Edit::SetTransform(sphere, far)).unwrap();
    let fit = |session: &mut Session| {
        session.look(View::Fit(FitArea::whole(1.0)));
        session.view().camera.target
    };
    assert!(fit(&mut session).abs_diff_eq(Vec3::X * 50.0, 1e-3));
    session.edit(Edit::SetVisible(sphere, false)).unwrap();
    let target = fit(&mut session);
    assert!(
        target.x.abs() < 1.0,
        "the others are about the origin: {target}"
    );
    session.look(View::Select(Some(cube)));
    assert!(fit(&mut session).abs_diff_eq(Vec3::ZERO, 1e-3));
}

#[test]
fn together_means_all_or_none() {
    let (mut session, [one, _, _]) = session();
    let document = session.document();
    let curves = "circ a 4 0.5";
    let circle = editor_core::io::read_swp(std::path::Path::new("a.swp"), curves.as_bytes());
    let kind = ShapeKind::Curve(editor_core::scene::CurveShape::new(circle.unwrap().value));
    session
        .edit(Edit::Insert(vec![NewShape::new("Circle", kind)]))
        .unwrap();
    let curve = session.selected().unwrap();
    let before = session.document();
    assert_ne!(before, document);
    let refused = Edit::Together(vec![
        Edit::SetVisible(one, false),
        Edit::SetRadius {
            shape: curve,
            curve: 0,
            radius: f32::NAN,
        },
    ]);
    assert!(session.edit(refused).is_err());
    assert!(session.scene().shape(one).unwrap().visible);
    assert_eq!(session.document(), before);
}

#[test]
fn opening_replaces_everything_and_says_so() {
    let (mut session, [one, ..]) = session();
    session.look(View::SelectJoint(Some(0)));
    let opened = session.opened();
    let mut scene = session.scene().clone();
    let change = apply(
        &mut scene,
        Edit::Open(vec![NewShape::new("New", ShapeKind::Cube)]),
    )
    .unwrap();
    assert!(change.opened && change.added == [one]);
    assert_eq!(scene.shapes().len(), 1);

    session.open(
        vec![NewShape::new("New", ShapeKind::Cube)],
        ViewSettings::default(),
    );
    assert_ne!(session.opened(), opened);
    assert_eq!(session.scene().shapes()[0].name, "New");
    assert_eq!(
        (session.selected(), session.selected_joint()),
        (Some(one), None)
    );
}

#[test]
fn resets_put_back_angles_and_offsets_of_what_they_name_and_of_nothing_else() {
    let (mut session, [one, other, _]) = session();
    let all_posed = |session: &mut Session| {
        session.edit(Edit::SetPose(one, posed())).unwrap();
        session.edit(Edit::SetPose(other, posed())).unwrap();
    };
    all_posed(&mut session);
    session.edit(Edit::ResetJoint(one, 0)).unwrap();
    let pose = pose_of(&session, one);
    assert_eq!(
        (pose.rotation(0), pose.root_offset(0)),
        (Euler::ZERO, Vec3::ZERO)
    );
    assert_eq!(pose.rotation(1), posed().rotation(1));
    assert_eq!(pose.root_offset(2), Vec3::new(-4.0, 0.0, 0.5));
    assert_eq!(pose_of(&session, other), &posed());

    all_posed(&mut session);
    session
        .edit(Edit::SetColor(other, ShapeColor::Preset(3)))
        .unwrap();
    session.edit(Edit::Reset(other)).unwrap();
    assert!(pose_of(&session, other).is_bind());
    let shape = session.scene().shape(other).unwrap();
    assert_eq!(shape.placement, shape.start);
    assert_eq!(pose_of(&session, one), &posed());
}

#[test]
fn replacing_one_angle_leaves_the_others_bit_for_bit() {
    let (mut session, [one, ..]) = session();
    let rotation = Euler::from_radians(Vec3::new(0.1, -7.3, 400.25));
    session
        .edit(Edit::SetJointTransform {
            shape: one,
            joint: 1,
            rotation,
        })
        .unwrap();
    let edit = Edit::SetJointAngle {
        shape: one,
        joint: 1,
        axis: 0,
        radians: -0.5,
    };
    session.edit(edit).unwrap();
    let now = pose_of(&session, one).rotation(1).radians;
    assert_eq!(now.to_array(), [-0.5, -7.3, 400.25]);
}

#[test]
fn deleting_takes_the_shape_that_was_named_and_selects_its_successor() {
    let (mut session, [one, other, cube]) = session();
    session.look(View::Select(Some(one)));
    session.edit(Edit::Delete(cube)).unwrap();
    assert_eq!(session.selected(), Some(one), "another shape was deleted");
    session.edit(Edit::Delete(one)).unwrap();
    assert_eq!(session.selected(), Some(other));
    let left: Vec<ShapeId> = session
        .scene()
        .shapes()
        .iter()
        .map(|shape| shape.id)
        .collect();
    assert_eq!(left, [other]);
}

#[test]
fn the_next_shape_is_selected_after_a_deleted_one_and_a_joint_stays_selected_with_its_shape() {
    let (mut session, [one, other, _]) = session();
    session.look(View::Select(Some(one)));
    session.look(View::SelectJoint(Some(1)));
    session.look(View::Select(Some(one)));
    assert_eq!(session.selected_joint(), Some(1));
    session.edit(Edit::Delete(one)).unwrap();
    assert_eq!(session.selected(), Some(other));
}

#[test]
fn the_camera_of_the_start_is_that_of_the_document_and_only_500_messages_are_kept() {
    let view = ViewSettings {
        camera: Camera {
            radius: 7.0,
            ..Camera::default()
        },
        ..ViewSettings::default()
    };
    let mut session = Session::with_shapes(Vec::new(), view);
    session.look(View::ResetCamera);
    assert_eq!(*session.start_camera(), view.camera);
    for number in 0..502 {
        let severity = editor_core::editor::Severity::Info;
        session.messages.tell(severity, number.to_string());
    }
    let told = session.messages.history();
    assert_eq!(
        (told.len(), &*told[0].text, &*told[499].text),
        (500, "2", "501")
    );
}

#[test]
fn a_gesture_ends_when_shapes_come_or_go_and_a_second_one_begins_anew() {
    let (mut session, [one, ..]) = session();
    session.begin_gesture();
    session.edit(Edit::SetPose(one, posed())).unwrap();
    session
        .edit(Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]))
        .unwrap();
    assert!(!session.is_in_gesture());
    session.cancel_gesture();
    assert_eq!(
        pose_of(&session, one),
        &posed(),
        "nothing was left to cancel"
    );

    session.begin_gesture();
    session.edit(Edit::SetPose(one, Pose::new())).unwrap();
    session.commit_gesture();
    let document = session.document();
    assert_eq!(session.done_steps(), 2, "a pose with a cube, and a pose");
    session.begin_gesture();
    session.commit_gesture();
    assert_eq!((session.done_steps(), session.document()), (2, document));
}

/// Edits of every kind that a gesture makes.
fn edits() -> impl Strategy<Value = Edit> {
    let angle = -7.0..7.0_f32;
    prop_oneof![
        (1..=2_u32, 0..3_usize, 0..3_usize, angle.clone()).prop_map(
            |(shape, joint, axis, radians)| {
                Edit::SetJointAngle {
                    shape: ShapeId(shape),
                    joint,
                    axis,
                    radians,
                }
            }
        ),
        (1..=2_u32, -5.0..5.0_f32).prop_map(|(shape, x)| Edit::SetRootOffset {
            shape: ShapeId(shape),
            root: 0,
            offset: Vec3::X * x
        }),
        (1..=3_u32, angle).prop_map(|(shape, x)| {
            let mut transform = editor_core::math::Transform::IDENTITY;
            transform.position = Vec3::splat(x);
            Edit::SetTransform(ShapeId(shape), transform)
        }),
        (1..=3_u32, any::<bool>()).prop_map(|(shape, on)| Edit::SetVisible(ShapeId(shape), on)),
        (1..=2_u32).prop_map(|shape| Edit::KeepPose {
            shape: ShapeId(shape),
            name: "Kept".into()
        }),
        (1..=3_u32).prop_map(|shape| Edit::Reset(ShapeId(shape))),
    ]
}

proptest! {
    #[test]
    fn a_cancelled_gesture_gives_back_the_document_whatever_was_edited(
        before in prop::collection::vec(edits(), 0..4), during in prop::collection::vec(edits(), 0..12),
    ) {
        let (mut session, _) = session();
        for edit in before {
            session.edit(edit).unwrap();
        }
        let (scene, document): (Scene, _) = (session.scene().clone(), session.document());
        session.begin_gesture();
        for edit in during {
            session.edit(edit).unwrap();
        }
        session.cancel_gesture();
        prop_assert_eq!(session.scene(), &scene);
        prop_assert_eq!(session.document(), document);
    }
}
