//! The joint list.

use crate::interface::{Editor, figure};
use editor_core::character::Pose;
use editor_core::editor::{Edit, View};
use editor_core::math::Euler;
use editor_core::ui::Ask;
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::NodeT;
use glam::Vec3;

const ROOT: usize = 0;
const CHEST: usize = 1;
const WAIST: usize = 2;
const NECK: usize = 3;
const LEFT_ELBOW: usize = 17;

#[test]
fn dragging_a_joints_number_turns_the_joint_and_the_mesh_follows() {
    let mut editor = Editor::with_figure();
    let before = editor.session().evaluated().shapes[0].geometry.clone();
    editor.drag("Chest X", 25.0);
    assert!(
        editor
            .joint(CHEST)
            .abs_diff_eq(Vec3::new(25.0, 0.0, 0.0), 1e-3)
    );
    let after = &editor.session().evaluated().shapes[0].geometry;
    assert_ne!(before.positions(), after.positions());
}

#[test]
fn angles_are_shown_from_minus_180_to_180() {
    let mut editor = Editor::with_figure();
    for (typed, shown) in [
        ("-30", "-30°"),
        ("330", "-30°"),
        ("180", "180°"),
        ("-180", "180°"),
        ("181", "-179°"),
        ("360+45", "45°"),
    ] {
        editor.type_into("Neck Y", typed);
        assert_eq!(editor.value("Neck Y"), shown, "{typed}");
    }
}

#[test]
fn a_drag_past_180_goes_on_from_minus_180() {
    let mut editor = Editor::with_figure();
    editor.type_into("Neck Y", "170");
    editor.drag("Neck Y", 25.0);
    assert_eq!(editor.value("Neck Y"), "-165°");
    editor.drag("Neck Y", -20.0);
    assert_eq!(editor.value("Neck Y"), "175°");
}

#[test]
fn a_turned_joint_offers_its_own_reset() {
    let mut editor = Editor::with_figure();
    assert!(!editor.has("Reset Neck"));
    editor.type_into("Neck Y", "45/2");
    editor.type_into("Chest X", "10");
    editor.click("Reset Neck");
    assert_eq!(editor.joint(NECK), Vec3::ZERO);
    assert!((editor.joint(CHEST).x - 10.0).abs() < 1e-3, "others stay");
    assert!(!editor.has("Reset Neck"));
    editor.click("Reset all");
    assert!(editor.character().pose().is_bind());
}

#[test]
fn below_a_root_stands_how_far_it_has_moved() {
    let mut editor = Editor::with_figure();
    assert_eq!(editor.value("Root Offset Y"), "0");
    editor.type_into("Root Offset Y", "1/4");
    editor.drag("Root Offset X", 20.0);
    let offset = editor.character().pose().root_offset(ROOT);
    assert!(
        offset.abs_diff_eq(Vec3::new(0.2, 0.25, 0.0), 1e-5),
        "{offset}"
    );
    assert_eq!(editor.value("Root Offset Y"), "0.25");
    editor.right_click("Root Offset X");
    let offset = editor.character().pose().root_offset(ROOT);
    assert_eq!(offset, Vec3::new(0.0, 0.25, 0.0));
}

#[test]
fn the_name_of_a_roots_offset_selects_the_root_and_what_is_said_there_is_about_both() {
    let mut editor = Editor::with_figure();
    let mut says = |label: &str| {
        editor.click(label);
        let painted = editor.painted();
        let of_root = "those of its offset to move it";
        let says = painted.iter().any(|(text, _)| text.contains(of_root));
        (editor.session().selected_joint(), says)
    };
    assert_eq!(says("Neck"), (Some(NECK), false));
    assert_eq!(says("Root Offset"), (Some(ROOT), true));
}

#[test]
fn a_roots_offset_and_its_angles_are_reset_each_by_its_own_button() {
    let mut editor = Editor::with_figure();
    editor.type_into("Root Offset Z", "-3");
    assert!(!editor.has("Reset Root"), "it has not turned");
    editor.type_into("Root Y", "30");
    editor.click("Reset Root Offset");
    assert_eq!(editor.character().pose().root_offset(ROOT), Vec3::ZERO);
    assert!(
        (editor.joint(ROOT).y - 30.0).abs() < 1e-3,
        "it stays turned"
    );
    assert!(!editor.has("Reset Root Offset"));
    editor.click("Reset Root");
    assert!(editor.character().pose().is_bind());
}

#[test]
fn every_root_has_an_offset_and_no_other_joint() {
    let mut editor = Editor::new();
    editor.add_character(figure::forest());
    let skeleton = editor.character().character.skeleton().clone();
    for (index, joint) in skeleton.joints().iter().enumerate() {
        let has = editor.has(&format!("{} Offset X", joint.name));
        assert_eq!(has, skeleton.roots().contains(&index), "{}", joint.name);
    }
    let root = skeleton.roots()[1];
    let called = format!("{} Offset Y", skeleton.joints()[root].name);
    editor.type_into(&called, "0.5");
    let pose = editor.character().pose();
    assert_eq!(pose.root_offset(root), Vec3::Y * 0.5);
    assert_eq!(pose.root_offset(skeleton.roots()[0]), Vec3::ZERO);
}

#[test]
fn a_right_click_resets_one_angle() {
    let mut editor = Editor::with_figure();
    editor.type_into("Neck X", "10");
    editor.type_into("Neck Y", "20");
    editor.right_click("Neck X");
    assert!(
        editor
            .joint(NECK)
            .abs_diff_eq(Vec3::new(0.0, 20.0, 0.0), 1e-3)
    );
}

#[test]
fn a_search_shows_only_joints_of_that_name() {
    let mut editor = Editor::with_figure();
    editor.click("Find joints");
    editor.harness.event(egui::Event::Text("ELBOW".into()));
    editor.settle();
    assert!(editor.has("Left elbow") && editor.has("Right elbow"));
    assert!(!editor.has("Root"));
    editor.type_into("Left elbow Z", "50");
    assert!((editor.joint(LEFT_ELBOW).z - 50.0).abs() < 1e-3);
    editor.click("Find joints");
    assert!(editor.has("Root"), "closing the search shows all again");
}

#[test]
fn esc_ends_a_search_and_all_joints_are_there_again() {
    let mut editor = Editor::with_figure();
    editor.click("Find joints");
    editor.harness.event(egui::Event::Text("ELBOW".into()));
    editor.settle();
    assert!(!editor.has("Root"));
    editor.key(Key::Escape);
    assert!(editor.has("Root") && !editor.has("Search joints"));
}

#[test]
fn a_joint_is_selected_by_click_and_the_keyboard_goes_on_from_there() {
    let mut editor = Editor::with_figure();
    editor.click("Chest");
    assert_eq!(editor.session().selected_joint(), Some(CHEST));
    editor.key(Key::ArrowDown);
    assert_eq!(editor.session().selected_joint(), Some(WAIST));
    editor.key(Key::ArrowLeft);
    assert!(!editor.has("Right hip"), "← folds");
    editor.key(Key::ArrowLeft);
    assert_eq!(editor.session().selected_joint(), Some(CHEST), "← goes up");
    editor.key(Key::ArrowUp);
    assert_eq!(editor.session().selected_joint(), Some(ROOT));
}

#[test]
fn the_arrow_before_a_joint_folds_it() {
    let mut editor = Editor::with_figure();
    editor.click("Fold Chest");
    assert!(!editor.has("Waist"));
    editor.click("Unfold Chest");
    assert!(editor.has("Waist"));
}

#[test]
fn a_folded_branch_says_that_a_joint_in_it_is_not_at_rest() {
    const HOLDS: &str = "a joint that is folded away in it is not at rest";
    let mut editor = Editor::with_figure();
    editor.type_into("Left elbow Z", "30");
    editor.click("Left shoulder");
    editor.click("Fold Left shoulder");
    let told = |editor: &Editor, name: &str| {
        let value = editor.widget(name).accesskit_node().value();
        value.as_deref() == Some(HOLDS)
    };
    assert!(told(&editor, "Left shoulder"));
    assert!(!told(&editor, "Right shoulder"));
    editor.click("Unfold Left shoulder");
    assert!(!told(&editor, "Left shoulder"), "the joint itself shows it");
    editor.click("Fold Left shoulder");
    editor.click("Reset all");
    assert!(!told(&editor, "Left shoulder"));
}

#[test]
fn a_joint_selected_in_the_view_is_unfolded_in_the_list() {
    let mut editor = Editor::with_figure();
    editor.click("Fold Root");
    assert!(!editor.has("Left elbow"));
    editor.view(View::SelectJoint(Some(LEFT_ELBOW)));
    assert!(editor.has("Left elbow"));
}

#[test]
fn a_joint_selected_in_the_view_is_listed_though_another_was_searched_for() {
    let mut editor = Editor::with_figure();
    editor.click("Find joints");
    editor.harness.event(egui::Event::Text("elbow".into()));
    editor.settle();
    editor.view(View::SelectJoint(Some(LEFT_ELBOW)));
    assert!(!editor.has("Neck"), "it is among those that were found");
    editor.view(View::SelectJoint(Some(NECK)));
    assert!(editor.has("Neck") && editor.has("Root"));
}

#[test]
fn esc_lets_go_of_the_selected_joint_and_then_of_its_shape_before_it_ends_the_program() {
    let mut editor = Editor::with_figure();
    editor.view(View::SelectJoint(Some(NECK)));
    editor.key(Key::Escape);
    assert_eq!(editor.session().selected_joint(), None);
    editor.key(Key::Escape);
    assert_eq!(editor.session().selected(), None);
    assert!(editor.asked().is_empty());
    editor.wait();
    editor.key(Key::Escape);
    editor.key(Key::Escape);
    assert_eq!(editor.asked(), [Ask::Quit]);
}

#[test]
fn the_row_under_the_pointer_marks_its_joint_and_the_view_may_mark_others() {
    let mut editor = Editor::with_figure();
    editor.reveal("Neck");
    editor.widget("Neck").hover();
    editor.settle();
    assert_eq!(editor.session().hovered_joint(), Some(NECK));
    let away = editor.harness.state().view.center();
    editor.harness.hover_at(away);
    editor.settle();
    assert_eq!(editor.session().hovered_joint(), None);
    editor.view(View::HoverJoint(Some(CHEST)));
    editor.settle();
    assert_eq!(editor.session().hovered_joint(), Some(CHEST));
}

#[test]
fn the_status_line_has_the_number_in_the_file_of_the_joint_whose_row_is_pointed_at() {
    let mut editor = Editor::with_figure();
    editor.reveal("Neck");
    assert!(!editor.has("Neck (3)"));
    editor.widget("Neck").hover();
    editor.settle();
    assert!(editor.has("Neck (3)"));
}

#[test]
fn the_question_mark_can_be_typed_into_the_search() {
    let mut editor = Editor::with_figure();
    editor.click("Find joints");
    editor.key_with(Modifiers::SHIFT, Key::Questionmark);
    assert!(!editor.has("Keys and Mouse"));
}

#[test]
fn of_a_very_long_list_only_what_is_in_sight_is_shown_and_keys_still_reach_all_of_it() {
    let mut editor = Editor::new();
    editor.add_character(figure::chain(5000));
    assert!(editor.widgets().len() < 500, "{}", editor.widgets().len());
    editor.click("Joint 0");
    editor.key(Key::ArrowDown);
    assert_eq!(editor.session().selected_joint(), Some(1));
    editor.view(View::SelectJoint(Some(4998)));
    editor.click("Joint 4998");
    editor.key(Key::ArrowDown);
    assert_eq!(editor.session().selected_joint(), Some(4999));
    editor.type_into("Joint 4999 X", "5");
    assert!((editor.joint(4999).x - 5.0).abs() < 1e-3);
    editor.click("Joint 4999");
    editor.view(View::SelectJoint(Some(2500)));
    assert!(editor.has("Joint 2500"));
    editor.key(Key::ArrowUp);
}

#[test]
fn esc_or_the_right_button_puts_a_dragged_number_back() {
    for cancel in ["Esc", "right button"] {
        let mut editor = Editor::with_figure();
        editor.type_into("Chest X", "12");
        let at = editor.widget("Chest X").rect().center();
        editor.harness.hover_at(at);
        editor.harness.drag_at(at);
        editor.harness.hover_at(at + egui::vec2(30.0, 0.0));
        editor.settle();
        assert_eq!(editor.joint(CHEST).x, 42.0);
        if cancel == "Esc" {
            editor.key(Key::Escape);
        } else {
            editor.mouse(egui::PointerButton::Secondary, true, at);
        }
        assert_eq!(editor.joint(CHEST).x, 12.0, "{cancel}");
        editor.harness.hover_at(at + egui::vec2(60.0, 0.0));
        editor.settle();
        editor.harness.drop_at(at);
        editor.settle();
        assert_eq!(editor.joint(CHEST).x, 12.0, "{cancel}");
        assert!(editor.asked().is_empty());
    }
}

#[test]
fn what_is_typed_right_after_a_click_on_a_number_goes_there_and_nowhere_else() {
    let mut editor = Editor::with_figure();
    let camera = editor.session().view().camera;
    editor.widget("Chest X").click();
    editor.harness.step();
    // Digits are keys of the views, too.
    editor.harness.key_press(Key::Num3);
    editor.harness.event(egui::Event::Text("3".into()));
    editor.settle();
    editor.key(Key::Enter);
    assert_eq!(editor.joint(CHEST).x, 3.0);
    assert_eq!(editor.session().view().camera, camera);
}

#[test]
fn a_field_into_which_a_number_is_typed_covers_its_neighbor_only_for_a_sum() {
    let mut editor = Editor::with_figure();
    let neighbor = editor.widget("Chest Y").rect();
    editor.begin_typing("Chest Z", "45");
    assert!(editor.widget("Chest Z").rect().left() >= neighbor.right());
    editor.harness.event(egui::Event::Text("/2 + 10".into()));
    editor.settle();
    assert!(editor.widget("Chest Z").rect().left() < neighbor.right());
    editor.key(Key::Enter);
    assert_eq!(editor.joint(CHEST).z, 32.5);
}

/// What the field of that name shows.
fn shown(editor: &Editor, field: &str) -> String {
    let place = editor.widget(field).rect();
    let inside = |text: &(String, egui::Rect)| {
        place.contains(text.1.center()) && !["X", "Y", "Z"].contains(&text.0.as_str())
    };
    let found = editor.painted().into_iter().find(inside);
    found.map(|(text, _)| text).unwrap_or_default()
}

#[test]
fn angles_have_one_decimal_at_most_and_their_sign_at_every_width_of_the_panel() {
    for width in [640.0, 800.0, 1000.0, 1280.0, 1920.0] {
        for wider in [-32.0, -16.0, -9.0, -4.0, 0.0, 30.0, 60.0, 120.0] {
            let mut editor = Editor::sized(egui::vec2(width, 1400.0));
            editor.add_character(figure::figure());
            let edge = egui::pos2(editor.harness.state().view.right(), 300.0);
            editor.press(edge);
            editor.point(edge - egui::vec2(wider, 0.0));
            editor.release(edge - egui::vec2(wider, 0.0));
            editor.type_into("Neck X", "354.744");
            editor.type_into("Neck Y", "350.66");
            editor.type_into("Neck Z", "8.125");
            editor.type_into("Waist X", "-0.04");
            editor.type_into("Rotation Y", "299.96");
            let fields = [
                "Neck X",
                "Neck Y",
                "Neck Z",
                "Waist X",
                "Chest X",
                "Rotation Y",
            ];
            let shown = fields.map(|field| shown(&editor, field));
            let bare = shown.each_ref().map(|text| text.trim_end_matches('°'));
            let expected = ["-5.3", "-9.3", "8.1", "0", "0", "-60"];
            assert_eq!(bare, expected, "{width} {wider}");
            let all = shown.iter().all(|text| text.ends_with('°'));
            assert!(all, "{width} {wider}: {shown:?}");
            let whole = editor.value("Neck X");
            assert!(whole.starts_with("-5.25"), "{whole}: all of it is kept");
        }
    }
}

#[test]
fn a_joint_selected_in_the_view_has_its_row_where_nothing_dims_it() {
    // As much of the panel fades out.
    const FADE: f32 = 20.0;
    let mut editor = Editor::new();
    editor.add_character(figure::chain(60));
    // Below the list of shapes and above the window's edge.
    let top = editor.widget("[1] Model1 (ID: 1)").rect().bottom() + 12.0;
    let bottom = editor.harness.ctx.content_rect().bottom() - 4.0;
    for joint in [40, 10, 50, 30, 5] {
        editor.view(View::SelectJoint(Some(joint)));
        editor.harness.run_steps(40);
        let row = editor.widget(&format!("Joint {joint}")).rect();
        assert!(row.bottom() + FADE <= bottom, "{joint}: {row}");
        assert!(row.top() >= top + FADE, "{joint}: {row}");
    }
}

#[test]
fn resetting_the_angles_of_a_root_leaves_its_offset() {
    let mut editor = Editor::with_figure();
    editor.type_into("Root Offset Z", "-3");
    editor.type_into("Root Y", "30");
    editor.click("Reset Root");
    let pose = editor.character().pose();
    assert_eq!(pose.root_offset(ROOT), Vec3::Z * -3.0);
    assert_eq!(editor.joint(ROOT), Vec3::ZERO);
}

#[test]
fn right_goes_to_the_first_of_several_children() {
    const RIGHT_HIP: usize = 4;
    let mut editor = Editor::with_figure();
    editor.click("Waist");
    editor.key(Key::ArrowRight);
    assert_eq!(editor.session().selected_joint(), Some(RIGHT_HIP));
}

/// Asserts that name and numbers of each joint stand beside each other, in the panel.
fn assert_one_line_a_joint(editor: &mut Editor) {
    let joints = editor.character().character.skeleton().joints().to_vec();
    let window = editor.harness.ctx.content_rect();
    for joint in joints {
        editor.reveal(&joint.name);
        let name = editor.widget(&joint.name).rect();
        let mut left = name.right();
        for axis in ["X", "Y", "Z"] {
            let field = editor.widget(&format!("{} {axis}", joint.name)).rect();
            let is_beside = (field.center().y - name.center().y).abs() < 1.0;
            assert!(is_beside && field.left() >= left, "{}", joint.name);
            assert!(field.width() >= 36.0 && field.right() <= window.right());
            left = field.right();
        }
    }
}

#[test]
fn each_joint_has_one_line_whatever_its_name_and_however_many_there_are() {
    for (size, panel) in [((800.0, 600.0), 280.0), ((800.0, 2400.0), 280.0)] {
        let mut editor = Editor::sized(egui::vec2(size.0, size.1));
        editor.add_character(figure::figure());
        let view = editor.harness.state().view;
        assert!((size.0 - view.right() - panel).abs() < 1.0, "{view}");
        assert_one_line_a_joint(&mut editor);
        editor.add_character(figure::chain(60));
        assert_one_line_a_joint(&mut editor);
        let mut names = editor_core::character::COURSE_JOINT_NAMES;
        names[1] = "mixamorig:Spine.001_twist";
        names[7] = "mixamorig:RightToeBase_End_of_a_very_long_name";
        editor.add_character(figure::figure_called(&names));
        assert_one_line_a_joint(&mut editor);
    }
}

#[test]
fn a_namespace_that_all_joints_share_is_left_out_in_the_list_and_kept_in_their_names() {
    let names: Vec<String> = editor_core::character::COURSE_JOINT_NAMES
        .iter()
        .map(|name| format!("mixamorig:{name}"))
        .collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut editor = Editor::new();
    editor.add_character(figure::figure_called(names[..].try_into().unwrap()));
    assert!(editor.has("mixamorig:Neck"), "for who hears it");
    let painted: Vec<String> = editor.painted().into_iter().map(|(text, _)| text).collect();
    assert!(painted.iter().any(|text| text == "Waist"), "{painted:?}");
    assert!(!painted.iter().any(|text| text.starts_with("mixamorig")));
}

#[test]
fn a_folded_branch_says_which_joint_in_it_is_selected_or_under_the_pointer() {
    const HOLDS: &str = "Left elbow is folded away in it";
    let mut editor = Editor::with_figure();
    editor.view(View::SelectJoint(Some(LEFT_ELBOW)));
    editor.click("Fold Left shoulder");
    let texts: Vec<String> = editor.painted().into_iter().map(|(text, _)| text).collect();
    let is_it = |text: &String| text.ends_with("› Left elbow");
    assert!(texts.iter().any(is_it), "{texts:?}");
    assert_eq!(editor.value("Left shoulder"), HOLDS);
    editor.view(View::SelectJoint(None));
    assert_eq!(editor.value("Left shoulder"), "");
    let id = editor.shape().id;
    editor.view(View::HoverBone(Some((id, LEFT_ELBOW))));
    assert_eq!(editor.value("Left shoulder"), HOLDS);
}

#[test]
fn the_joint_that_is_taken_in_the_view_scrolls_into_sight_and_one_under_the_pointer_moves_nothing()
{
    let mut editor = Editor::new();
    editor.add_character(figure::chain(60));
    editor.reveal("Joint 5");
    let window = editor.harness.ctx.content_rect();
    let id = editor.shape().id;
    let place = |editor: &Editor, joint| editor.widget(&format!("Joint {joint}")).rect();
    for joint in [50, 8, 30] {
        let before = place(&editor, joint);
        editor.view(View::HoverBone(Some((id, joint))));
        editor.harness.run_steps(40);
        assert_eq!(place(&editor, joint), before, "rows wander under the eye");
        editor.view(View::SelectJoint(Some(joint)));
        editor.harness.run_steps(40);
        let row = place(&editor, joint);
        assert!(window.contains_rect(row), "{joint}: {row}");
    }
}

#[test]
fn the_list_stays_where_it_is_while_the_pointer_is_over_it() {
    let mut editor = Editor::new();
    editor.add_character(figure::chain(60));
    editor.reveal("Joint 20");
    let before = editor.widget("Joint 20").rect();
    for joint in [20, 22, 19] {
        editor.widget(&format!("Joint {joint}")).hover();
        editor.harness.run_steps(20);
        assert_eq!(editor.session().hovered_joint(), Some(joint));
    }
    assert_eq!(editor.widget("Joint 20").rect(), before);
}

#[test]
fn delete_is_about_the_shape_after_a_click_on_its_row_and_about_the_joint_after_one_on_a_bone() {
    const LEFT_KNEE: usize = 10;
    let mut editor = Editor::with_hands(Key::B);
    let shape = editor.shape().id;
    let mut pose = Pose::new();
    pose.set_joint_transform(LEFT_KNEE, Euler::from_degrees(Vec3::X * 30.0));
    editor.edit(Edit::SetPose(shape, pose));
    editor.view(View::SelectJoint(Some(LEFT_KNEE)));
    editor.click("[1] Model1 (ID: 1)");
    // A press in the view takes the keyboard from the row again.
    let empty = editor.harness.state().view.left_top() + vec2(30.0, 120.0);
    editor.press(empty);
    editor.release(empty);
    editor.view(View::Select(Some(shape)));
    editor.view(View::SelectJoint(Some(LEFT_KNEE)));
    editor.key(Key::Delete);
    let posed = editor.session().scene().character(shape).unwrap();
    assert!(posed.pose().is_bind(), "the joint is put back");
    editor.click("[1] Model1 (ID: 1)");
    assert_eq!(editor.session().selected_joint(), Some(LEFT_KNEE));
    editor.key(Key::Delete);
    assert!(editor.session().scene().shapes().is_empty());
}
