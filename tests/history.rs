//! Undo and redo: every step of the document can be taken back, one at a time, and done again.

use crate::editing::character;
use editor_core::character::{Mirror, Pose};
use editor_core::editor::{Edit, Session, View};
use editor_core::geometry::{Basis, Curve};
use editor_core::math::{Euler, Transform};
use editor_core::scene::{
    BoneStyle, CharacterDisplay, CurveDisplay, CurveSet, CurveShape, CurveVisibility, IkSettings,
    JointStyle, ModelDisplay, NewShape, Scene, ShapeColor, ShapeId, ShapeKind, SkinningMethod,
    SurfaceVisibility, ViewSettings,
};
use glam::Vec3;
use proptest::prelude::*;

fn man() -> NewShape {
    let joints = ["Left shoulder", "Left elbow", "Right shoulder"];
    NewShape::new("Man", character(joints))
}

const MAN: ShapeId = ShapeId(1);
const CUBE: ShapeId = ShapeId(2);
const CURVES: ShapeId = ShapeId(3);

/// A session with a character, a cube and a curve; the curve is selected.
fn session() -> Session {
    let curves = CurveSet::start_spline(Basis::Bezier);
    let shapes = vec![
        man(),
        NewShape::new("Cube", ShapeKind::Cube),
        NewShape::new("Curve", ShapeKind::Curve(CurveShape::new(curves))),
    ];
    Session::with_shapes(shapes, ViewSettings::default())
}

fn moved(x: f32) -> Transform {
    Transform {
        position: Vec3::X * x,
        ..Transform::IDENTITY
    }
}

fn turned(joint: usize, degrees: f32) -> Edit {
    Edit::SetJointTransform {
        shape: MAN,
        joint,
        rotation: Euler::from_degrees(Vec3::X * degrees),
    }
}

/// The name of the step that `edits` are, as one gesture.
fn name_of(edits: Vec<Edit>) -> String {
    let mut session = session();
    session.begin_gesture();
    for edit in edits {
        session.edit(edit).unwrap();
    }
    session.commit_gesture();
    session.undo().expect("a step")
}

#[test]
fn a_step_is_named_for_what_it_changed() {
    let pins = |pins: &[usize]| IkSettings {
        pins: pins.iter().copied().collect(),
        ..IkSettings::default()
    };
    let point = |x| Edit::SetControlPoint {
        shape: CURVES,
        curve: 0,
        point: 0,
        position: Vec3::X * x,
    };
    let display = |change: fn(&mut CharacterDisplay)| {
        let mut display = CharacterDisplay::default();
        change(&mut display);
        Edit::SetDisplay(MAN, display)
    };
    let curves = |change: fn(&mut CurveDisplay)| {
        let mut display = CurveDisplay::default();
        change(&mut display);
        Edit::SetCurveDisplay(CURVES, display)
    };
    let root = |x| Edit::SetRootOffset {
        shape: MAN,
        root: 0,
        offset: Vec3::X * x,
    };
    let circle = Curve::circle(8, 1.0).unwrap();
    let keep = Edit::KeepPose {
        shape: MAN,
        name: "Wave".into(),
    };
    let sphere = NewShape::new("Ball", ShapeKind::Sphere);
    let scaled = Transform {
        scale: Vec3::splat(2.0),
        ..Transform::IDENTITY
    };
    for (edits, name) in [
        (vec![turned(1, 10.0), turned(1, 50.0)], "Rotate Left elbow"),
        (vec![turned(1, 10.0), turned(0, 5.0)], "Pose Man"),
        (vec![root(2.0)], "Move Left shoulder"),
        (vec![Edit::SetTransform(CUBE, moved(1.0))], "Move Cube"),
        (vec![Edit::SetTransform(CUBE, scaled)], "Scale Cube"),
        (
            vec![Edit::SetColor(CUBE, ShapeColor::Preset(7))],
            "Color Cube",
        ),
        (
            vec![Edit::SetUniformScaling(CUBE, false)],
            "Change the scaling of Cube",
        ),
        (vec![Edit::SetVisible(CUBE, false)], "Hide Cube"),
        (vec![Edit::SetLocked(MAN, true)], "Lock Man"),
        (vec![Edit::Rename(CUBE, "Box".into())], "Rename to Box"),
        (vec![Edit::Delete(CUBE)], "Delete Cube"),
        (vec![Edit::Insert(vec![sphere.clone()])], "Insert Ball"),
        (
            vec![Edit::Insert(vec![sphere.clone(), sphere])],
            "Insert 2 shapes",
        ),
        (vec![keep], "Keep Wave"),
        (vec![Edit::SetIk(MAN, pins(&[1]))], "Pin Left elbow"),
        (
            vec![display(|d| d.mode = ModelDisplay::Skeleton)],
            "Show the skeleton of Man",
        ),
        (
            vec![display(|d| d.mode = ModelDisplay::Both)],
            "Show mesh and skeleton of Man",
        ),
        (
            vec![display(|d| d.joints = JointStyle::Points)],
            "Show points as joints of Man",
        ),
        (
            vec![display(|d| d.bones = BoneStyle::Lines)],
            "Show lines as bones of Man",
        ),
        (
            vec![display(|d| d.point_size = 12.0)],
            "Change the point size of Man",
        ),
        (
            vec![display(|d| d.line_width = 3.0)],
            "Change the line width of Man",
        ),
        (
            vec![curves(|d| d.control_points = false)],
            "Hide the control points of Curve",
        ),
        (
            vec![curves(|d| d.curve = CurveVisibility::Off)],
            "Hide the curves of Curve",
        ),
        (
            vec![curves(|d| d.curve = CurveVisibility::OnWithFrames)],
            "Show curves with frames of Curve",
        ),
        (
            vec![curves(|d| d.surface = SurfaceVisibility::Off)],
            "Hide the surfaces of Curve",
        ),
        (
            vec![curves(|d| {
                d.surface = SurfaceVisibility::WireframeWithNormals
            })],
            "Show the wireframe of Curve",
        ),
        (
            vec![Edit::SetFrameClosing(CURVES, false)],
            "Change the frames of Curve",
        ),
        (
            vec![Edit::SetSkinningMethod(MAN, SkinningMethod::DualQuaternion)],
            "Change the skinning of Man",
        ),
        (vec![point(0.25)], "Edit curve"),
        (vec![Edit::AddCurve(CURVES, circle)], "Add curve2"),
        (
            vec![Edit::SetVisible(CUBE, false), Edit::SetVisible(MAN, false)],
            "Hide 2 shapes",
        ),
        (
            vec![Edit::SetVisible(CUBE, false), turned(1, 4.0)],
            "Change 2 shapes",
        ),
    ] {
        assert_eq!(name_of(edits), name);
    }
    let mut session = session();
    session.edit(turned(1, 20.0)).unwrap();
    session.edit(turned(1, 0.0)).unwrap();
    assert_eq!(session.undo().as_deref(), Some("Reset Left elbow"));
    session.edit(turned(0, 20.0)).unwrap();
    session.edit(Edit::SetPose(MAN, Pose::new())).unwrap();
    assert_eq!(session.undo().as_deref(), Some("Reset the pose of Man"));
    let man = session.scene().character(MAN).unwrap();
    let mirrored = Mirror::new(man.character.skeleton()).pose(man.pose());
    session.edit(Edit::SetPose(MAN, mirrored)).unwrap();
    assert_eq!(session.undo().as_deref(), Some("Mirror the pose of Man"));
}

#[test]
fn the_selection_comes_back_with_its_step() {
    let mut session = session();
    session.look(View::Select(Some(MAN)));
    session.look(View::SelectJoint(Some(1)));
    session.edit(turned(1, 30.0)).unwrap();
    session.look(View::Select(Some(CUBE)));
    session.edit(Edit::Delete(CUBE)).unwrap();
    session.look(View::Select(None));

    session.undo();
    assert_eq!(session.selected(), Some(CUBE));
    session.undo();
    let joint = (session.selected(), session.selected_joint());
    assert_eq!(joint, (Some(MAN), Some(1)));
    session.redo();
    session.redo();
    assert_eq!(session.selected(), Some(CURVES), "as after the deletion");
}

#[test]
fn undo_in_the_middle_of_a_gesture_cancels_it_and_nothing_else() {
    let mut session = session();
    session.edit(turned(1, 30.0)).unwrap();
    let before = session.document();
    for undo in [Session::undo, Session::redo] {
        session.begin_gesture();
        session.edit(turned(1, 80.0)).unwrap();
        assert_eq!(undo(&mut session), None);
        assert!(!session.is_in_gesture());
        assert_eq!((session.document(), session.done_steps()), (before, 1));
    }
}

#[test]
fn a_gesture_that_ends_where_it_began_is_no_step_and_no_change() {
    let mut session = session();
    let document = session.document();
    session.begin_gesture();
    session.edit(turned(1, 80.0)).unwrap();
    session.edit(turned(1, 0.0)).unwrap();
    session.commit_gesture();
    assert_eq!((session.document(), session.done_steps()), (document, 0));
    assert_eq!(session.undo(), None);
}

#[test]
fn an_edit_after_undo_ends_what_could_be_redone() {
    let mut session = session();
    session.edit(turned(1, 30.0)).unwrap();
    session.edit(turned(1, 40.0)).unwrap();
    session.undo();
    session.edit(Edit::SetVisible(CUBE, false)).unwrap();
    assert_eq!(session.redo(), None);
    let steps: Vec<&str> = session.steps().collect();
    assert_eq!(steps, ["Rotate Left elbow", "Hide Cube"]);
}

#[test]
fn an_identifier_is_not_used_again_though_its_shape_was_undone() {
    let mut session = session();
    let insert = |session: &mut Session| {
        let shapes = vec![NewShape::new("Ball", ShapeKind::Sphere)];
        session.edit(Edit::Insert(shapes)).unwrap().added[0]
    };
    let first = insert(&mut session);
    session.undo();
    assert_ne!(insert(&mut session), first);
}

#[test]
fn a_document_that_is_opened_begins_its_own_history() {
    let mut session = session();
    session.edit(turned(1, 30.0)).unwrap();
    session.open(Vec::new(), ViewSettings::default());
    assert_eq!(session.undo(), None);
    assert_eq!(session.steps().len(), 0);
}

/// Something that a user does to the document.
#[derive(Clone, Debug)]
enum Deed {
    Edit(Box<Edit>),
    Begin,
    Commit,
    Cancel,
    Undo,
    Redo,
}

fn edits() -> impl Strategy<Value = Edit> {
    let id = || (1..=6_u32).prop_map(ShapeId);
    prop_oneof![
        (0..3_usize, -7.0..7.0_f32).prop_map(|(joint, x)| turned(joint, x)),
        (id(), -5.0..5.0_f32).prop_map(|(id, x)| Edit::SetTransform(id, moved(x))),
        (id(), any::<bool>()).prop_map(|(id, on)| Edit::SetVisible(id, on)),
        (id(), "[a-z]{1,4}").prop_map(|(id, name)| Edit::Rename(id, name)),
        (id(), 0..3_usize).prop_map(|(id, pin)| {
            let pins = [pin].into();
            Edit::SetIk(
                id,
                IkSettings {
                    pins,
                    ..IkSettings::default()
                },
            )
        }),
        (id(), "[a-c]").prop_map(|(shape, name)| Edit::KeepPose { shape, name }),
        (id(), 0..2_usize).prop_map(|(id, kept)| Edit::ForgetPose(id, kept)),
        (0..4_usize, -2.0..2.0_f32).prop_map(|(point, x)| Edit::SetControlPoint {
            shape: CURVES,
            curve: 0,
            point,
            position: Vec3::new(x, 0.5, 0.0),
        }),
        id().prop_map(Edit::Reset),
        id().prop_map(Edit::ResetPose),
        id().prop_map(Edit::UnpinAll),
        id().prop_map(Edit::Delete),
        (1..3_usize).prop_map(|count| { Edit::Insert(vec![man(); count]) }),
    ]
}

fn deeds() -> impl Strategy<Value = Vec<Deed>> {
    let deed = prop_oneof![
        8 => edits().prop_map(|edit| Deed::Edit(Box::new(edit))),
        2 => Just(Deed::Begin),
        2 => Just(Deed::Commit),
        1 => Just(Deed::Cancel),
        2 => Just(Deed::Undo),
        1 => Just(Deed::Redo),
    ];
    prop::collection::vec(deed, 0..60)
}

proptest! {
    #[test]
    fn any_list_of_commands_is_undone_to_the_first_document_and_redone_to_the_last(
        deeds in deeds(),
    ) {
        let mut session = session();
        let first: (Scene, _) = (session.scene().clone(), session.document());
        for deed in deeds {
            match deed {
                Deed::Edit(edit) => drop(session.edit(*edit).unwrap()),
                Deed::Begin => session.begin_gesture(),
                Deed::Commit => session.commit_gesture(),
                Deed::Cancel => session.cancel_gesture(),
                Deed::Undo => drop(session.undo()),
                Deed::Redo => drop(session.redo()),
            }
        }
        session.commit_gesture();
        while session.redo().is_some() {}
        let last: (Scene, _) = (session.scene().clone(), session.document());
        let steps = session.steps().len();
        let mut undone = 0;
        while session.undo().is_some() {
            undone += 1;
        }
        prop_assert_eq!(undone, steps);
        prop_assert_eq!(session.scene(), &first.0);
        prop_assert_eq!(session.document(), first.1);
        while session.redo().is_some() {}
        prop_assert_eq!(session.scene(), &last.0);
        prop_assert_eq!(session.document(), last.1);
    }
}
