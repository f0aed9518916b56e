//! Several shapes at once: selected, changed, copied, pasted and taken back together.

use super::{Story, differing};
use crate::host::MemoryHost;
use editor_core::editor::{Severity, View};
use editor_core::scene::{ModelDisplay, ShapeId};
use editor_core::ui::{Action, Ask, Navigation};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use glam::Vec3;

const CTRL: Modifiers = Modifiers::COMMAND;

/// A cube, a sphere and a pyramid in one place, in this order, the last of them selected.
fn with_three() -> Story {
    let mut story = Story::start(&[]);
    // In the Studio look they would stand beside each other.
    story.key(Key::F2);
    for key in [Key::C, Key::S, Key::P] {
        story.key_with(Modifiers::SHIFT, key);
    }
    story.key(Key::F3);
    assert_eq!(story.names(), ["Cube", "Sphere", "Pyramid"]);
    story
}

fn selected(story: &Story) -> Vec<&str> {
    let shapes = story.session().selected_shapes();
    shapes.map(|shape| &*shape.name).collect()
}

/// Clicks a widget while `modifiers` are held.
fn click_with(story: &mut Story, modifiers: Modifiers, label: &str) {
    let at = story.place(label);
    click_at_with(story, modifiers, at);
}

fn click_at_with(story: &mut Story, modifiers: Modifiers, at: Pos2) {
    story.frame(vec![Event::ModifiersChanged(modifiers)]);
    story.point(at);
    for pressed in [true, false] {
        story.frame(vec![Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers,
        }]);
    }
    story.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
    story.settle();
}

fn positions(story: &Story) -> Vec<Vec3> {
    let shapes = story.session().scene().shapes().iter();
    shapes
        .map(|shape| shape.placement.transform.position)
        .collect()
}

#[test]
fn ctrl_adds_a_shape_shift_a_range_and_ctrl_a_everything() {
    let mut story = with_three();
    assert_eq!(selected(&story), ["Pyramid"]);
    click_with(&mut story, CTRL, "[1] Cube (ID: 1)");
    assert_eq!(selected(&story), ["Cube", "Pyramid"]);
    assert_eq!(story.shape().name, "Cube", "the last one is active");
    click_with(&mut story, CTRL, "[3] Pyramid (ID: 3)");
    assert_eq!(selected(&story), ["Cube"], "once more takes it out");
    click_with(&mut story, Modifiers::SHIFT, "[3] Pyramid (ID: 3)");
    assert_eq!(selected(&story), ["Cube", "Sphere", "Pyramid"]);
    story.click("[2] Sphere (ID: 2)");
    assert_eq!(selected(&story), ["Sphere"]);
    story.key_with(CTRL, Key::A);
    assert_eq!(selected(&story), ["Cube", "Sphere", "Pyramid"]);
    assert_eq!(story.shape().name, "Sphere", "the active one stays");
    story.key(Key::Escape);
    assert!(selected(&story).is_empty());
}

#[test]
fn what_is_selected_is_moved_turned_scaled_colored_hidden_and_deleted_together() {
    let mut story = with_three();
    story.type_into("Position Y", "1");
    story.key_with(CTRL, Key::A);
    story.type_into("Position X", "2");
    let [a, b, c] = positions(&story)[..] else {
        panic!("three shapes");
    };
    let y = Vec3::Y;
    assert_eq!(
        [a, b, c],
        [Vec3::X * 2.0, Vec3::X * 2.0, Vec3::X * 2.0 + y],
        "by the same vector"
    );
    story.type_into("Rotation Y", "30");
    story.type_into("Uniform Scale", "3");
    for shape in story.session().scene().shapes() {
        let transform = shape.placement.transform;
        assert!((transform.rotation.degrees().y - 30.0).abs() < 1e-4);
        assert!((transform.scale - Vec3::splat(3.0)).length() < 1e-5);
    }
    let steps = story.session().steps().last().map(str::to_owned);
    assert_eq!(steps.as_deref(), Some("Scale 3 shapes"));
    story.key(Key::H);
    assert!(
        story
            .session()
            .scene()
            .shapes()
            .iter()
            .all(|shape| !shape.visible)
    );
    story.key_with(CTRL, Key::Z);
    assert!(
        story
            .session()
            .scene()
            .shapes()
            .iter()
            .all(|shape| shape.visible)
    );
    click_with(&mut story, CTRL, "[1] Cube (ID: 1)");
    story.key(Key::Delete);
    assert_eq!(story.names(), ["Cube"]);
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names(), ["Cube", "Sphere", "Pyramid"]);
    assert_eq!(selected(&story), ["Sphere", "Pyramid"], "as before");
}

#[test]
fn all_characters_that_are_selected_show_their_skeletons_and_each_keeps_how_it_draws_them() {
    let mut story = Story::start(&["builtin:robot", "builtin:gem", "builtin:dog"]);
    let displays = |story: &Story| {
        let ids = story
            .session()
            .scene()
            .shapes()
            .iter()
            .map(|shape| shape.id);
        let characters = ids.filter_map(|id| story.session().scene().character(id));
        let displays: Vec<_> = characters.map(|character| character.display).collect();
        displays
    };
    story.click("Skeletal Model");
    story.click("Points");
    let points = displays(&story)[1].joints;
    story.click("Mesh Model");
    let before = displays(&story);
    assert_ne!(before[0].joints, points);
    story.key_with(CTRL, Key::A);
    story.click("Both");
    let after = displays(&story);
    assert!(
        after
            .iter()
            .all(|display| display.mode == ModelDisplay::Both)
    );
    assert_eq!(
        [after[0].joints, after[1].joints],
        [before[0].joints, points]
    );
    story.key_with(CTRL, Key::Z);
    assert_eq!(displays(&story), before, "in one step");
}

#[test]
fn ctrl_and_a_click_in_the_view_adds_a_shape_and_a_miss_loses_none() {
    let mut story = with_three();
    for (row, x) in [("[1] Cube (ID: 1)", "-1.5"), ("[3] Pyramid (ID: 3)", "1.5")] {
        story.click(row);
        story.type_into("Position X", x);
    }
    let [left, middle, above] =
        [Vec3::X * -1.5, Vec3::ZERO, Vec3::Y * 1.5].map(|world| story.at(world));
    let mut click = |at: Pos2| {
        click_at_with(&mut story, CTRL, at);
        selected(&story).join(" ")
    };
    assert_eq!(click(left), "Cube Pyramid");
    assert_eq!(click(middle), "Cube Sphere Pyramid");
    assert_eq!(click(left), "Sphere Pyramid");
    assert_eq!(click(above), "Sphere Pyramid", "a miss");
}

#[test]
fn a_drag_of_the_move_tool_moves_all_of_them_and_esc_puts_all_back() {
    let mut story = with_three();
    story.type_into("Position X", "1");
    story.key_with(CTRL, Key::A);
    story.key(Key::G);
    let before = positions(&story);
    let pyramid = story.session().scene().shape(ShapeId(3)).unwrap();
    let world = pyramid.placement.transform.position + Vec3::new(0.2, -0.2, 0.4);
    let from = story.at(world);
    story.press_and_drag(from, from + vec2(60.0, -30.0));
    let during = positions(&story);
    let by: Vec<Vec3> = during
        .iter()
        .zip(&before)
        .map(|(now, was)| *now - *was)
        .collect();
    assert!(by[0].length() > 0.05, "{by:?}");
    assert!(
        by.iter().all(|by_one| by_one.abs_diff_eq(by[0], 1e-5)),
        "{by:?}"
    );
    story.key(Key::Escape);
    story.button(false);
    story.settle();
    assert_eq!(positions(&story), before);
}

#[test]
fn a_drag_of_any_of_them_takes_the_others_along_but_none_that_is_locked() {
    let mut story = with_three();
    for (row, x) in [("[1] Cube (ID: 1)", "-1.5"), ("[3] Pyramid (ID: 3)", "1.5")] {
        story.click(row);
        story.type_into("Position X", x);
    }
    story.key_with(Modifiers::SHIFT, Key::L);
    story.key_with(CTRL, Key::A);
    assert_eq!(selected(&story), ["Cube", "Sphere"], "none that is locked");
    click_with(&mut story, CTRL, "[3] Pyramid (ID: 3)");
    story.key(Key::G);
    let before = positions(&story);
    let from = story.at(Vec3::new(-1.3, 0.2, 0.5));
    story.drag(from, from + vec2(0.0, -50.0));
    let by: Vec<Vec3> = positions(&story)
        .iter()
        .zip(&before)
        .map(|(now, was)| *now - *was)
        .collect();
    assert!(by[0].y > 0.1 && by[1].abs_diff_eq(by[0], 1e-5), "{by:?}");
    assert_eq!(by[2], Vec3::ZERO, "locked");
    assert_eq!(selected(&story), ["Cube", "Sphere", "Pyramid"]);
    assert_eq!(story.shape().name, "Cube");
}

#[test]
fn all_of_them_have_an_outline() {
    let mut story = with_three();
    story.type_into("Position X", "2");
    let one = story.scene_picture();
    story.key_with(CTRL, Key::A);
    assert!(differing(&one, &story.scene_picture()) > 200);
}

#[test]
fn copies_stand_beside_and_are_one_step() {
    let mut story = with_three();
    story.key_with(CTRL, Key::A);
    story.key_with(CTRL, Key::D);
    assert_eq!(
        story.names(),
        ["Cube", "Sphere", "Pyramid", "Cube", "Sphere", "Pyramid"]
    );
    let positions = positions(&story);
    let copies: Vec<ShapeId> = story.session().selected_shapes().map(|s| s.id).collect();
    assert_eq!(
        copies,
        [ShapeId(4), ShapeId(5), ShapeId(6)],
        "to be moved together"
    );
    // The pyramid is the widest: its base is 1.4 wide.
    assert!((positions[3].x - 1.54).abs() < 1e-4, "{positions:?}");
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names().len(), 3);
}

#[test]
fn a_tool_that_poses_cuts_no_character() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.click("Pose Tool");
    story.key_with(CTRL, Key::X);
    assert_eq!(story.names(), ["Strip"]);
    let told = story.messages().last().unwrap().1.to_owned();
    assert!(told.starts_with("The Pose and IK tools copy"), "{told}");
    story.click("Select Tool");
    story.key_with(CTRL, Key::X);
    assert!(story.names().is_empty());
}

#[test]
fn in_the_blender_navigation_nothing_is_selected_after_a_cut_that_another_one_would_take() {
    for navigation in [Navigation::Course, Navigation::Blender] {
        let mut story = with_three();
        story.program.ui_mut().set_navigation(navigation);
        story.key_with(CTRL, Key::X);
        assert_eq!(story.names(), ["Cube", "Sphere"]);
        let is_selected = story.session().selected().is_some();
        assert_eq!(is_selected, navigation == Navigation::Course);
    }
}

#[test]
fn shapes_go_over_the_clipboard_from_window_to_window_with_pose_and_place() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Z", "90");
    story.type_into("Position X", "3");
    story.frame(vec![Event::Cut]);
    story.settle();
    assert!(story.names().is_empty());
    assert_eq!(story.messages().last().unwrap().1, "Cut Strip");
    let text = story.host.clipboard.clone();
    assert!(
        text.contains("\"editor-scene\"") && text.contains("strip.obj"),
        "{text}"
    );
    let host = MemoryHost {
        files: story.host.files.clone(),
        clipboard: text,
        stored: [super::started_before()].into(),
        ..MemoryHost::default()
    };
    let mut other = Story::start_at(host, &[]);
    for count in 1..=2 {
        other.key_with(CTRL, Key::V);
        assert_eq!(other.names().len(), count);
        assert!((other.degrees("Elbow").z - 90.0).abs() < 1e-4);
        let place = other.shape().placement.transform.position;
        // The second one stands beside the first.
        assert!(
            if count == 1 {
                place == Vec3::X * 3.0
            } else {
                place.x > 3.5
            },
            "{place}"
        );
    }
    let steps: Vec<&str> = other.session().steps().collect();
    assert_eq!(steps, ["Paste Strip", "Paste Strip"], "not imported");
    let copies = |story: &mut Story, key| {
        story.key_with(CTRL, key);
        story.session().selected_shapes().count()
    };
    assert_eq!(copies(&mut other, Key::A), 2);
    other.frame(vec![Event::Copy]);
    assert_eq!(copies(&mut other, Key::V), 2);
    assert_eq!(other.session().steps().last(), Some("Paste 2 shapes"));
    story.key_with(CTRL, Key::Z);
    assert_eq!(story.names(), ["Strip"], "the cut is taken back");
}

#[test]
fn a_pose_is_pasted_by_the_same_key_and_what_is_neither_is_refused() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.host.clipboard = r#"{"joints": {"Elbow": [0, 0, 50]}}"#.into();
    story.key_with(CTRL, Key::V);
    assert!((story.degrees("Elbow").z - 50.0).abs() < 1e-4);
    story.key(Key::B);
    story.frame(vec![Event::Copy]);
    story.settle();
    assert!(
        story.host.clipboard.starts_with("{\n  \"joints\""),
        "with the Pose tool, the pose"
    );

    story.key(Key::V);
    story.frame(vec![Event::Copy]);
    story.settle();
    story.click("Pose");
    story.click("Paste Pose");
    let shapes = "There are shapes on the clipboard and no pose: Copy Pose puts one there, Paste adds the shapes";
    assert_eq!(story.messages().last(), Some(&(Severity::Warning, shapes)));
    assert_eq!(story.names(), ["Strip"]);

    let neither = "There are no shapes and no pose on the clipboard";
    let pose = r#"{"joints": {"Elbow": [0, 0, 20]}}"#;
    let whose = "There is a pose on the clipboard, no shape: select the character that takes it";
    story.host.clipboard = "hello".into();
    story.key_with(CTRL, Key::V);
    assert_eq!(story.messages().last(), Some(&(Severity::Warning, neither)));
    story.key_with(Modifiers::SHIFT, Key::C);
    for selected in [story.session().selected(), None] {
        let select = Action::View(View::Select(selected));
        story.program.carry_out(vec![select], &mut story.host);
        for (text, told) in [("{", neither), ("hello", neither), (pose, whose)] {
            story.host.clipboard = text.into();
            story.key_with(CTRL, Key::V);
            let last = story.messages().last().copied();
            assert_eq!(last, Some((Severity::Warning, told)), "{text} {selected:?}");
        }
    }
    story.key_with(CTRL, Key::Z);
    story.host.clipboard = r#"{"format": "editor-scene", "version": 3}"#.into();
    story.key_with(CTRL, Key::V);
    let (severity, text) = *story.messages().last().unwrap();
    assert!(
        severity == Severity::Error && text.starts_with("clipboard.scene:1:"),
        "{text}"
    );
    assert_eq!(story.names(), ["Strip"]);
}

#[test]
fn in_a_drag_of_the_list_esc_and_ctrl_z_cancel_it_and_delete_does_nothing() {
    let mut story = with_three();
    let to = |story: &Story| story.place("[1] Cube (ID: 1)") - vec2(0.0, 8.0);
    let drag = |story: &mut Story| {
        let (from, to) = (story.place("[3] Pyramid (ID: 3)"), to(story));
        story.press_and_drag(from, to);
    };
    let before = story.session().done_steps();
    for (modifiers, key) in [(Modifiers::NONE, Key::Escape), (CTRL, Key::Z)] {
        drag(&mut story);
        story.key_with(modifiers, key);
        story.button(false);
        story.settle();
        assert_eq!(story.names(), ["Cube", "Sphere", "Pyramid"], "{key:?}");
        assert_eq!(story.session().done_steps(), before, "{key:?}");
    }
    drag(&mut story);
    story.key(Key::Delete);
    story.button(false);
    story.settle();
    assert_eq!(story.names(), ["Pyramid", "Cube", "Sphere"]);
    assert_eq!(story.session().done_steps(), before + 1);
}

#[test]
fn a_copy_of_a_figure_stands_in_no_other_one() {
    let mut story = Story::start(&["builtin:adult"]);
    let insert = Action::Ask(Ask::InsertBuiltin("robot"));
    story.program.carry_out(vec![insert], &mut story.host);
    story.settle();
    let first = story.session().scene().shapes()[0].id;
    story.program.session_mut().look(View::Select(Some(first)));
    story.settle();
    story.key_with(CTRL, Key::D);
    story.key_with(CTRL, Key::D);
    let shapes = story.session().evaluated().shapes.iter();
    let mut bounds: Vec<_> = shapes.map(|shape| shape.world_bounds()).collect();
    bounds.sort_by(|a, b| a.min.x.total_cmp(&b.min.x));
    for pair in bounds.windows(2) {
        let overlap = pair[0].max.x - pair[1].min.x;
        let narrower = pair[0].size().x.min(pair[1].size().x);
        assert!(overlap < 0.5 * narrower, "{pair:?}");
    }
}
