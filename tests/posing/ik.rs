//! A hand held by the pointer, and the chain that follows it.

use crate::posing::support::{SIZE, cameras, pixel, poses, session, transforms};
use editor_core::character::Facing;
use editor_core::editor::{Edit, IkDrag, IkGrip, Screen, Session};
use editor_core::scene::{BoneHit, Camera, IkPole, IkSettings, ShapeId, bones_in_world};
use glam::{Vec2, Vec3};
use proptest::prelude::*;

/// A hit of the bone of a joint, this share of the way to its end.
fn hit(session: &Session, id: ShapeId, joint: usize, along: f32) -> BoneHit {
    let shape = session.evaluated().shape(id).expect("it is evaluated");
    let mut bones = bones_in_world(session.scene(), shape);
    let (_, start, end) = bones.nth(joint).expect("every joint has a bone");
    BoneHit {
        shape: id,
        joint,
        bone: joint,
        distance: 1.0,
        point: start.lerp(end, along),
    }
}

fn drag(
    session: &mut Session,
    id: ShapeId,
    grip: IkGrip,
    at: Vec2,
    length: usize,
) -> Option<IkDrag> {
    let settings = IkSettings {
        length,
        ..IkSettings::default()
    };
    session.edit(Edit::SetIk(id, settings)).unwrap();
    let ray = session.view().camera.ray(at, SIZE);
    IkDrag::begin(session, id, grip, &ray)
}

fn screen(session: &Session) -> Screen {
    Screen {
        camera: session.view().camera,
        size: SIZE,
    }
}

fn is_near(length: f32, to: f32) -> bool {
    (length - to).abs() < 1e-3
}

#[test]
fn the_nearer_end_of_a_bone_is_taken_and_a_joint_where_there_is_one() {
    let (session, id) = session(Camera::default(), Default::default(), &Default::default());
    let grip = |joint, along| {
        let hit = hit(&session, id, joint, along);
        IkGrip::of(&session, &hit, &screen(&session)).expect("there is such a bone")
    };
    assert_eq!(grip(0, 0.2), IkGrip::Joint(0));
    assert_eq!(grip(0, 0.8), IkGrip::Joint(1));
    assert_eq!(grip(1, 0.1), IkGrip::Joint(1));
    let tip = Vec3::new(0.0, -0.3, 0.4);
    assert_eq!(grip(2, 0.9), IkGrip::Tip { joint: 2, tip });
}

#[test]
fn a_pin_that_is_dragged_itself_is_not_lost_and_one_that_is_left_behind_is() {
    let (mut session, id) = session(Camera::default(), Default::default(), &Default::default());
    let lost = |session: &mut Session, pin: usize| {
        let settings = IkSettings {
            pins: [pin].into(),
            ..IkSettings::default()
        };
        session.edit(Edit::SetIk(id, settings)).unwrap();
        let middle = SIZE * 0.5;
        let ray = session.view().camera.ray(middle, SIZE);
        let root = IkGrip::Joint(0);
        let mut held = IkDrag::begin(session, id, root, &ray).expect("a root");
        let far = session.view().camera.ray(middle + Vec2::X * 300.0, SIZE);
        let edit = held.update(session, &far, false).expect("it follows");
        session.begin_gesture();
        session.edit(edit).unwrap();
        let lost: Vec<usize> = held.lost_pins().iter().map(|(joint, _)| *joint).collect();
        session.cancel_gesture();
        lost
    };
    // The root is the pin, and goes where it is led.
    assert_eq!(lost(&mut session, 0), [0; 0]);
    // The end of its arm is pinned where no arm reaches to any more.
    assert_eq!(lost(&mut session, 2), [2]);
}

#[test]
fn only_a_root_moves_and_every_pole_is_a_direction_of_its_own() {
    let (mut session, id) = session(Camera::default(), Default::default(), &Default::default());
    let middle = SIZE * 0.5;
    let mut held =
        drag(&mut session, id, IkGrip::Joint(3), middle, 2).expect("a root can be moved");
    assert!(held.chain().is_none());
    let ray = session.view().camera.ray(middle + Vec2::X * 30.0, SIZE);
    let edit = held.update(&session, &ray, false).expect("it follows");
    session.edit(edit).unwrap();
    let pose = session.scene().character(id).expect("it is there").pose();
    assert!(pose.root_offset(3).length() > 0.01);
    assert_eq!(pose.root_offset(0), Vec3::ZERO, "other roots stay");

    let facing = Facing::default();
    for (index, pole) in IkPole::ALL.iter().enumerate() {
        let same = |other: &&IkPole| other.direction(facing) == pole.direction(facing);
        assert_eq!(IkPole::ALL.iter().position(|p| same(&p)), Some(index));
    }
}

#[test]
fn what_does_not_exist_is_not_taken() {
    let (mut session, id) = session(Camera::default(), Default::default(), &Default::default());
    let tip = Vec3::Y;
    for grip in [IkGrip::Joint(9), IkGrip::Tip { joint: 9, tip }] {
        assert!(drag(&mut session, id, grip, SIZE * 0.5, 2).is_none());
    }
    let nowhere = BoneHit {
        bone: 9,
        ..hit(&session, id, 0, 0.5)
    };
    assert!(IkGrip::of(&session, &nowhere, &screen(&session)).is_none());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(800) })]

    #[test]
    fn the_hand_stays_under_the_pointer_where_it_can_and_esc_puts_all_back(
        camera in cameras(), transform in transforms(), pose in poses(), is_joint in any::<bool>(),
        length in 1..4_usize, moves in prop::collection::vec((-150.0..150.0_f32, -150.0..150.0_f32), 1..5),
    ) {
        let (mut session, id) = session(camera, transform, &pose);
        let grip = if is_joint {
            IkGrip::Joint(2)
        } else {
            IkGrip::of(&session, &hit(&session, id, 2, 0.9), &screen(&session)).unwrap()
        };
        let held_at = grip.place(&session, id).and_then(|world| pixel(&session, world));
        prop_assume!(held_at.is_some());
        let from = held_at.unwrap();
        let Some(mut held) = drag(&mut session, id, grip, from, length) else {
            return Ok(());
        };
        let rest = session.scene().character(id).unwrap().pose().clone();
        session.begin_gesture();
        for by in moves {
            let cursor = from + Vec2::from(by);
            let Some(edit) = held.update(&session, &camera.ray(cursor, SIZE), false) else {
                continue;
            };
            session.edit(edit).unwrap();
            let world = grip.place(&session, id).unwrap();
            prop_assert!(world.is_finite());
            let wanted = pixel(&session, held.target());
            let off = wanted.map(|wanted| wanted.distance(cursor));
            prop_assert!(off.is_none_or(|off| off < 0.2), "the target is {off:?} pixels off");
            if held.off() < 1e-5 {
                let off = world.distance(held.target());
                prop_assert!(off < 1e-4, "the hand is {off} off");
            }
            let shape = session.evaluated().shape(id).unwrap();
            let figure = shape.geometry.figure.as_ref().unwrap();
            let joints = &figure.joints;
            for (a, b, length) in [(0, 1, Vec3::new(0.1, 0.5, 0.0)), (1, 2, Vec3::new(0.4, 0.1, 0.2))] {
                prop_assert!(is_near(joints[a].distance(joints[b]), length.length()));
            }
        }
        session.cancel_gesture();
        prop_assert_eq!(session.scene().character(id).unwrap().pose(), &rest);
    }
}
