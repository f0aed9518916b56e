//! Keys that hands bring along from Blender, in its navigation.

use crate::interface::Editor;
use editor_core::editor::{Edit, View};
use editor_core::math::{Euler, Transform};
use editor_core::scene::{Camera, Look};
use editor_core::ui::Navigation;
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::NodeT;
use glam::Vec3;

const ALT: Modifiers = Modifiers::ALT;
const NECK: usize = 3;

pub fn in_blender(mut editor: Editor) -> Editor {
    let state = &mut editor.harness.state_mut().state;
    state.set_navigation(Navigation::Blender);
    editor.settle();
    editor
}

fn elsewhere() -> Transform {
    Transform {
        position: Vec3::new(1.0, 2.0, 3.0),
        rotation: Euler::from_degrees(Vec3::new(10.0, 20.0, 30.0)),
        scale: Vec3::splat(2.0),
    }
}

impl Editor {
    fn place_of(&self, index: usize) -> Transform {
        let shapes = self.session().scene().shapes();
        shapes[index].placement.transform
    }

    pub fn last_told(&self) -> Option<String> {
        let fresh = self.session().messages.fresh();
        fresh.last().map(|told| told.text.to_string())
    }
}

#[test]
fn alt_and_the_key_of_a_movement_put_back_what_it_changes_of_every_selected_shape() {
    let mut editor = in_blender(Editor::new());
    for name in ["Cube", "Sphere"] {
        editor.choose(&["Insert", name]);
        let id = editor.shape().id;
        editor.edit(Edit::SetTransform(id, elsewhere()));
    }
    editor.view(View::SelectAll);
    let mut expected = elsewhere();
    for (key, back) in [
        (
            Key::G,
            (|to| to.position = Vec3::ZERO) as fn(&mut Transform),
        ),
        (Key::R, |to| to.rotation = Euler::default()),
        (Key::S, |to| to.scale = Vec3::ONE),
    ] {
        editor.key_with(ALT, key);
        back(&mut expected);
        let places = [0, 1].map(|shape| editor.place_of(shape));
        assert_eq!(places, [expected; 2], "Alt+{key:?}");
    }
    editor.key_with(ALT, Key::G);
    assert_eq!(
        editor.last_told().as_deref(),
        Some("It is where it started")
    );
}

#[test]
fn with_a_joint_at_hand_alt_r_puts_that_back_to_rest_and_the_menu_still_turns_the_shape() {
    let mut editor = in_blender(Editor::with_figure());
    let id = editor.shape().id;
    editor.edit(Edit::SetTransform(id, elsewhere()));
    editor.type_into("Neck X", "30");
    editor.key(Key::Escape);
    editor.click("Pose Tool");
    editor.view(View::SelectJoint(Some(NECK)));
    editor.key_with(ALT, Key::R);
    assert!(editor.character().pose().is_bind());
    assert_eq!(editor.place_of(0), elsewhere());
    editor.choose(&["Edit", "Reset Transform", "Reset Rotation"]);
    assert_eq!(editor.place_of(0).rotation, Euler::default());
}

#[test]
fn menus_and_the_search_show_the_keys_of_blender_where_there_are_some() {
    let mut editor = in_blender(Editor::sized(vec2(900.0, 1400.0)));
    editor.add_character(super::figure::figure());
    let is_shown = |editor: &Editor, key: &str| {
        let painted = editor.painted();
        painted.iter().any(|(text, _)| text == key)
    };
    editor.click("Edit");
    for key in ["Shift+D", "X"] {
        assert!(is_shown(&editor, key), "{key}");
    }
    assert!(!is_shown(&editor, "Ctrl+D"));
    editor.key(Key::Escape);
    editor.click("Help");
    assert!(is_shown(&editor, "F3"));
    editor.key(Key::Escape);
    editor.click("File");
    assert!(is_shown(&editor, "Ctrl+Q"));
    editor.key(Key::Escape);
    editor.click("Insert");
    assert!(is_shown(&editor, "Shift+A"));
    for key in ["C", "S", "P", "T", "I", "U", "B", "N", "O"] {
        let key = format!("Shift+{key}");
        assert!(!is_shown(&editor, &key), "{key} adds nothing");
    }
    editor.key(Key::Escape);

    editor.click("Pose Tool");
    editor.type_into("Neck X", "10");
    editor.view(View::SelectJoint(Some(NECK)));
    editor.click("Pose");
    assert!(is_shown(&editor, "Alt+R"), "it puts the joint back to rest");
    editor.key(Key::Escape);
    editor.key(Key::F3);
    editor.harness.event(egui::Event::Text("duplicate".into()));
    editor.settle();
    assert!(is_shown(&editor, "Shift+D"));
}

#[test]
fn b_selects_in_a_box_and_j_poses_and_tab_still_goes_to_the_panels() {
    let mut editor = in_blender(Editor::with_figure());
    editor.key(Key::B);
    assert!(editor.has("Drag a box · Shift adds · Ctrl takes out · Esc cancels"));
    editor.key(Key::Escape);
    editor.key(Key::J);
    editor.key(Key::B);
    assert!(editor.has("Drag a box round joints · Shift adds · Ctrl takes out · Esc cancels"));
    editor.key(Key::Escape);
    let has_pose_tool = |editor: &Editor| {
        let tool = editor.widget("Pose Tool");
        tool.accesskit_node().toggled() == Some(egui::accesskit::Toggled::True)
    };
    for (modifiers, key) in [(Modifiers::NONE, Key::J), (Modifiers::COMMAND, Key::Tab)] {
        editor.key(Key::V);
        assert!(!has_pose_tool(&editor));
        editor.key_with(modifiers, key);
        assert!(has_pose_tool(&editor), "{key:?}");
    }
    let has_focus = |editor: &Editor| {
        editor
            .harness
            .ctx
            .memory(|memory| memory.focused())
            .is_some()
    };
    // Over the view it is the key of Blender's Edit Mode.
    let over_the_view = editor.harness.state().view.center();
    editor.harness.hover_at(over_the_view);
    editor.key(Key::Tab);
    assert!(!has_focus(&editor));
    let told = editor.painted();
    let mut told = told.iter().map(|(text, _)| text);
    assert!(told.any(|text| text.starts_with("There is no Edit Mode")));
    editor.key_with(Modifiers::SHIFT, Key::Tab);
    assert!(has_focus(&editor));
    editor.key(Key::Tab);
    assert!(has_focus(&editor), "once the keyboard is there");
}

#[test]
fn with_a_bone_at_hand_g_moves_a_root_or_turns_the_bone_and_no_key_the_whole_character() {
    const ROOT: usize = 0;
    let mut editor = in_blender(Editor::with_figure());
    editor.harness.state_mut().gestures = true;
    editor.click("Pose Tool");
    let drag_by_key = |editor: &mut Editor, joint: usize, key: Key| {
        editor.view(View::SelectJoint(Some(joint)));
        let from = editor.harness.state().view.center();
        editor.harness.hover_at(from);
        editor.settle();
        editor.key(key);
        editor.harness.hover_at(from + vec2(40.0, 20.0));
        editor.settle();
        editor.key(Key::Enter);
    };
    drag_by_key(&mut editor, NECK, Key::S);
    let last = editor.last_told().unwrap_or_default();
    assert!(last.starts_with("A bone only turns"), "{last}");
    assert!(editor.character().pose().is_bind());
    drag_by_key(&mut editor, ROOT, Key::G);
    assert_ne!(editor.character().pose().root_offset(ROOT), Vec3::ZERO);
    assert_eq!(editor.place_of(0), Transform::default());
    // As in Blender, a bone that hangs on another one turns.
    for key in [Key::R, Key::G] {
        let before = (
            editor.joint(NECK),
            editor.character().pose().root_offset(ROOT),
        );
        drag_by_key(&mut editor, NECK, key);
        let after = (
            editor.joint(NECK),
            editor.character().pose().root_offset(ROOT),
        );
        assert!(after.0 != before.0 && after.1 == before.1, "{key:?}");
    }

    editor.view(View::SelectJoint(None));
    let before = editor.place_of(0);
    let from = editor.harness.state().view.center();
    editor.harness.hover_at(from);
    editor.settle();
    editor.key(Key::G);
    editor.harness.hover_at(from + vec2(40.0, 20.0));
    editor.settle();
    editor.key(Key::Enter);
    assert_eq!(editor.place_of(0), before, "and without a joint nothing");
    let last = editor.last_told().unwrap_or_default();
    assert!(last.starts_with("No joint is selected"), "{last}");
}

#[test]
fn the_keys_around_5_turn_the_camera_by_15_degrees_to_the_side_they_lie_on() {
    let mut editor = in_blender(Editor::new());
    let right = editor.session().view().camera.right();
    for (key, toward) in [
        (Key::Num4, -right),
        (Key::Num6, right),
        (Key::Num8, Vec3::Y),
        (Key::Num2, Vec3::NEG_Y),
    ] {
        editor.view(View::SetCamera(Camera::default()));
        let before = editor.session().view().camera.eye();
        editor.key(key);
        let after = editor.session().view().camera.eye();
        let angle = before.angle_between(after).to_degrees();
        assert!((angle - 15.0).abs() < 1e-3, "{key:?} turns by {angle}°");
        assert!((after - before).dot(toward) > 0.0, "{key:?}");
    }
    editor.view(View::SetCamera(Camera::default()));
    editor.key(Key::Num9);
    let eye = editor.session().view().camera.eye();
    assert!(eye.abs_diff_eq(Vec3::NEG_Z * 5.0, 1e-4), "{eye}");
}

#[test]
fn plus_and_minus_zoom_by_a_notch_of_the_wheel() {
    let mut editor = in_blender(Editor::new());
    let radius = |editor: &Editor| editor.session().view().camera.radius;
    let before = radius(&editor);
    editor.key(Key::Plus);
    let near = radius(&editor);
    assert!(near < 0.95 * before && near > 0.8 * before, "{near}");
    editor.key(Key::Minus);
    assert!((radius(&editor) - before).abs() < 1e-5);
}

#[test]
fn five_says_that_there_is_no_orthographic_view_and_no_other_key_calls_for_the_mannequin() {
    let mut editor = in_blender(Editor::new());
    editor.view(View::SetLook(Look::Mannequin));
    editor.key(Key::Num4);
    assert_eq!(editor.last_told(), None);
    editor.key(Key::Num5);
    let told = editor.last_told().unwrap_or_default();
    assert!(told.contains("no orthographic view"), "{told}");
    editor.key(Key::Z);
    let told = editor.last_told().unwrap_or_default();
    assert!(told.contains("are chosen in View"), "{told}");
}

#[test]
fn keys_for_a_camera_a_menu_of_views_and_mirrored_shapes_say_what_is_there_instead() {
    let mut editor = in_blender(Editor::with_figure());
    for (modifiers, key, expected) in [
        (Modifiers::NONE, Key::Space, "no animation"),
        (
            Modifiers::NONE,
            Key::Num0,
            "a picture shows what the view shows",
        ),
        (
            Modifiers::NONE,
            Key::Backtick,
            "1, 3 and 7 look from the front",
        ),
        (Modifiers::COMMAND, Key::M, "Shift+M"),
        (Modifiers::NONE, Key::OpenBracket, "parent or children"),
    ] {
        editor.key_with(modifiers, key);
        let told = editor.last_told().unwrap_or_default();
        assert!(told.contains(expected), "{key:?}: {told}");
    }
    // What has the keyboard is pressed by Space.
    let mut editor = in_blender(Editor::with_figure());
    editor.widget("Pose Tool").focus();
    editor.settle();
    editor.key(Key::Space);
    assert_eq!(editor.last_told(), None);
}

#[test]
fn while_a_figure_is_posed_its_joints_are_inverted_and_not_the_figures() {
    let mut editor = in_blender(Editor::with_figure());
    let figure = editor.shape().id;
    editor.choose(&["Insert", "Cube"]);
    editor.view(View::Select(Some(figure)));
    editor.key(Key::J);
    editor.view(View::SelectJoint(Some(NECK)));
    editor.key_with(Modifiers::COMMAND, Key::I);
    let count = editor.character().character.skeleton().joints().len();
    let others: Vec<usize> = (0..count).filter(|&joint| joint != NECK).collect();
    let selected = |editor: &Editor| {
        let mut joints = editor.session().selected_joints().to_vec();
        joints.sort_unstable();
        (editor.session().selected(), joints)
    };
    assert_eq!(selected(&editor), (Some(figure), others));
    editor.key_with(Modifiers::COMMAND, Key::I);
    assert_eq!(selected(&editor), (Some(figure), vec![NECK]));
    editor.key(Key::A);
    editor.key_with(Modifiers::COMMAND, Key::I);
    assert_eq!(selected(&editor), (Some(figure), Vec::new()));
}

#[test]
fn an_axis_and_a_number_that_follow_a_refused_movement_do_nothing_else() {
    let typed = [Key::X, Key::Num1, Key::Num4, Key::Num5, Key::Enter];
    let mut editor = in_blender(Editor::new());
    editor.choose(&["Insert", "Cube"]);
    let id = editor.shape().id;
    editor.edit(Edit::SetVisible(id, false));
    let camera = editor.session().view().camera;
    editor.key(Key::G);
    typed.into_iter().for_each(|key| editor.key(key));
    assert_eq!(editor.session().scene().shapes().len(), 1);
    assert_eq!(editor.session().view().camera, camera);
    let told = editor.last_told().unwrap_or_default();
    assert!(!told.contains("orthographic"), "{told}");
    // Enter and Esc end that, and so does any other key.
    for end in [Key::Enter, Key::Escape] {
        editor.key(Key::G);
        editor.key(end);
        editor.key(Key::Num3);
        assert_ne!(editor.session().view().camera, camera, "{end:?}");
        editor.view(View::SetCamera(camera));
        editor.view(View::Select(Some(id)));
        editor.settle();
    }
    editor.key(Key::G);
    editor.key(Key::F);
    editor.key(Key::X);
    let told = editor.last_told().unwrap_or_default();
    assert!(
        told.starts_with("X deletes nothing that is hidden"),
        "{told}"
    );

    let mut editor = in_blender(Editor::with_figure());
    editor.type_into("Neck Z", "20");
    editor.key(Key::J);
    editor.view(View::SelectJoint(Some(NECK)));
    editor.settle();
    let bent = editor.character().pose().clone();
    assert!(!bent.is_bind());
    editor.key(Key::G);
    typed.into_iter().for_each(|key| editor.key(key));
    assert_eq!(*editor.character().pose(), bent);
}

#[test]
fn what_is_hidden_is_no_longer_selected_nor_selected_with_all() {
    let mut editor = in_blender(Editor::new());
    for name in ["Cube", "Sphere"] {
        editor.choose(&["Insert", name]);
    }
    editor.key(Key::H);
    assert_eq!(editor.session().selected(), None);
    editor.view(View::SelectAll);
    let selected: Vec<&str> = (editor.session().selected_shapes().map(|it| &*it.name)).collect();
    assert_eq!(selected, ["Cube"]);
    editor.key(Key::X);
    let names: Vec<&str> = (editor.session().scene().shapes().iter().map(|it| &*it.name)).collect();
    assert_eq!(names, ["Sphere"]);
}

#[test]
fn after_a_deletion_nothing_is_selected_that_the_next_one_would_delete() {
    let mut editor = in_blender(Editor::new());
    for name in ["Cube", "Sphere"] {
        editor.choose(&["Insert", name]);
    }
    editor.key(Key::X);
    editor.key(Key::X);
    let names: Vec<&str> = (editor.session().scene().shapes().iter().map(|it| &*it.name)).collect();
    assert_eq!(names, ["Cube"]);
    assert_eq!(editor.last_told().as_deref(), Some("No shape is selected"));
}

#[test]
fn the_key_that_enters_posing_leaves_it_again() {
    let mut editor = in_blender(Editor::with_figure());
    for tool in ["Pose Tool", "Select Tool", "Pose Tool"] {
        editor.key_with(Modifiers::COMMAND, Key::Tab);
        let button = editor.widget(tool);
        let is_on = button.accesskit_node().toggled();
        assert_eq!(is_on, Some(egui::accesskit::Toggled::True), "{tool}");
    }
}

#[test]
fn with_a_root_at_hand_alt_g_and_alt_r_put_back_its_offset_and_its_angles_each_alone() {
    let mut editor = in_blender(Editor::with_figure());
    let shape = editor.shape().id;
    editor.edit(Edit::SetTransform(shape, elsewhere()));
    editor.key(Key::J);
    let pose = |editor: &Editor| {
        let pose = editor.character().pose();
        (pose.rotation(0).degrees().round(), pose.root_offset(0))
    };
    let (angles, offset) = (Vec3::new(10.0, 20.0, 30.0), Vec3::new(0.5, 0.25, 0.0));
    let mut back = |key: Key| {
        editor.edit(Edit::SetJointTransform {
            shape,
            joint: 0,
            rotation: Euler::from_degrees(angles),
        });
        editor.edit(Edit::SetRootOffset {
            shape,
            root: 0,
            offset,
        });
        editor.view(View::SelectJoint(Some(0)));
        editor.key_with(ALT, key);
        assert_eq!(editor.place_of(0), elsewhere(), "the character stays");
        pose(&editor)
    };
    assert_eq!(back(Key::G), (angles, Vec3::ZERO));
    assert_eq!(back(Key::R), (Vec3::ZERO, offset));
    editor.view(View::SelectJoint(Some(NECK)));
    editor.key_with(ALT, Key::G);
    let told = editor.last_told().expect("a message");
    assert!(told.contains("Only roots have an offset"), "{told}");
}

#[test]
fn with_bones_at_hand_the_key_that_fits_fits_these() {
    let mut editor = in_blender(Editor::with_figure());
    let whole = {
        editor.choose(&["View", "Fit to View"]);
        editor.session().view().camera
    };
    editor.key(Key::J);
    editor.view(View::SelectJoint(Some(NECK)));
    editor.choose(&["View", "Fit to View"]);
    let close = editor.session().view().camera;
    assert!(close.radius < 0.5 * whole.radius, "{close:?} {whole:?}");
    // It begins in the middle of the ball that is its skin, and ends in there.
    let (start, _) = editor.bone(NECK);
    assert!(close.target.abs_diff_eq(start, 1e-3), "{close:?}");
    editor.view(View::SelectJoint(None));
    editor.choose(&["View", "Fit to View"]);
    assert_eq!(editor.session().view().camera, whole);
}

#[test]
fn r_pressed_twice_says_that_there_is_no_trackball() {
    let mut editor = in_blender(Editor::with_figure());
    editor.harness.state_mut().gestures = true;
    editor.key(Key::J);
    let at = editor.on_bone(NECK);
    editor.click_at(at);
    editor.key(Key::R);
    assert_eq!(editor.last_told(), None);
    editor.key(Key::R);
    let told = editor.last_told().expect("a message");
    assert!(told.contains("no trackball"), "{told}");
    editor.key(Key::Escape);
    assert!(editor.character().pose().is_bind());
}

#[test]
fn a_drag_that_scales_a_figure_says_that_this_stays_on_its_ground() {
    let mut editor = in_blender(Editor::with_figure());
    editor.harness.state_mut().gestures = true;
    for (look, is_told) in [(Look::Studio, true), (Look::Course, false)] {
        editor.view(View::SetLook(look));
        let figure = editor.session().evaluated().shapes[0].world_bounds();
        assert!(figure.min.y != 0.0, "its origin is not on the ground");
        let from = editor.harness.state().view.center();
        editor.harness.hover_at(from);
        editor.settle();
        for key in [Key::S, Key::Num2] {
            editor.key(key);
        }
        let painted = editor.painted_over_view();
        let readout = painted.iter().find(|text| text.starts_with("× 2|"));
        let readout = readout.unwrap_or_else(|| panic!("{painted:?}"));
        assert_eq!(readout.contains("on its ground"), is_told, "{readout}");
        editor.key(Key::Escape);
    }
}
