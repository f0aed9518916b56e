//! What keys do that a person knows from elsewhere, and what they say where they can do nothing.

use super::Story;
use editor_core::editor::{Severity, View};
use editor_core::ui::{Action, Navigation};
use egui::{Event, Key, Modifiers};

const CTRL: Modifiers = Modifiers::COMMAND;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;

#[test]
fn the_insert_menu_opens_where_the_pointer_was_before_a_file_dialog_that_keys_have_closed() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let middle = story.view().center();
    story.point(middle);
    story.frame(vec![egui::Event::PointerGone]);
    story.key_with(SHIFT, Key::A);
    story.wait(0.3);
    let at = story.place("Cube");
    assert!(at.distance(middle) < 300.0, "{at} beside {middle}");
    story.click("Cube");
    assert_eq!(story.names(), ["Strip", "Cube"]);
}

#[test]
fn while_a_bone_is_posed_in_the_blender_navigation_the_keys_to_hide_and_copy_leave_the_character_alone()
 {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    story.key(Key::J);
    let document = story.session().document();
    for (joint, modifiers, key, told) in [
        (None, Modifiers::NONE, Key::H, "No bone is selected"),
        (None, Modifiers::SHIFT, Key::D, "No bone is selected"),
        (Some(2), Modifiers::NONE, Key::H, "A bone cannot be hidden"),
        (Some(2), Modifiers::SHIFT, Key::D, "A bone cannot be copied"),
    ] {
        let select = Action::View(View::SelectJoint(joint));
        story.program.carry_out(vec![select], &mut story.host);
        story.key_with(modifiers, key);
        assert_eq!(story.session().document(), document);
        let last = story.messages().last().unwrap().1.to_owned();
        assert!(last.starts_with(told), "{last}");
    }
    let find = |story: &mut Story, words: &str| {
        story.key_with(CTRL | Modifiers::SHIFT, Key::P);
        story.frame(vec![Event::Text(words.into())]);
        story.settle();
        story.key(Key::Enter);
    };
    find(&mut story, "duplicate");
    assert_eq!(story.session().document(), document, "nor when it is found");
    story.key(Key::V);
    find(&mut story, "duplicate");
    assert!(
        story.session().is_in_gesture(),
        "the copy follows the pointer"
    );
    story.key(Key::Escape);
    story.key(Key::H);
    assert!(!story.session().scene().shapes()[1].visible);
}

#[test]
fn a_key_that_can_do_nothing_says_why_once() {
    let mut story = Story::start(&[]);
    for _ in 0..3 {
        story.key(Key::Delete);
    }
    let told: Vec<_> = story.messages();
    assert_eq!(told, [(Severity::Info, "No shape is selected")]);
    story.key_with(CTRL, Key::Z);
    let last = story.messages().last().copied();
    assert_eq!(last, Some((Severity::Info, "There is nothing to undo")));
}

#[test]
fn all_that_is_hidden_is_shown_in_one_step() {
    let mut story = Story::start(&[]);
    story.key_with(SHIFT, Key::C);
    story.key_with(SHIFT, Key::S);
    story.key_with(CTRL, Key::A);
    story.key(Key::H);
    let hidden = |story: &Story| {
        let shapes = story.session().scene().shapes().iter();
        shapes.filter(|shape| !shape.visible).count()
    };
    assert_eq!(hidden(&story), 2);
    story.key_with(ALT, Key::H);
    assert_eq!(hidden(&story), 0);
    story.key_with(CTRL, Key::Z);
    assert_eq!(hidden(&story), 2, "it was one step");
}

#[test]
fn what_is_shown_again_leaves_the_active_shape_active_and_a_posed_figure_alone() {
    let mut story = Story::start(&["models/strip.obj"]);
    let figure = story.shape().id;
    story.key_with(SHIFT, Key::C);
    story.key(Key::H);
    let select = Action::View(View::Select(Some(figure)));
    story.program.carry_out(vec![select], &mut story.host);
    story.settle();
    story.key_with(ALT, Key::H);
    assert_eq!(story.session().selected(), Some(figure), "still active");
    assert_eq!(story.session().selected_shapes().count(), 2);
    story.key_with(CTRL, Key::Z);
    let select = Action::View(View::Select(Some(figure)));
    story.program.carry_out(vec![select], &mut story.host);
    story.key(Key::B);
    story.key_with(ALT, Key::H);
    assert_eq!(story.session().selected_shapes().count(), 1, "it is posed");
}

#[test]
fn keys_of_blender_that_do_nothing_here_say_where_that_is() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let placed = story.shape().placement;
    for (modifiers, key, told) in [
        (
            Modifiers::NONE,
            Key::Num5,
            "The camera is always in perspective",
        ),
        (
            Modifiers::NONE,
            Key::Z,
            "Shading, colors and looks are chosen in View",
        ),
        (
            Modifiers::NONE,
            Key::Slash,
            "There is no local view: Edit ⏵ Hide Others",
        ),
        (Modifiers::NONE, Key::C, "There is no circle to select with"),
        (Modifiers::ALT, Key::Z, "There is no X-ray"),
        (SHIFT, Key::Z, "There is no wireframe"),
        (SHIFT, Key::R, "Nothing repeats what was done last"),
        (SHIFT, Key::S, "There is no Snap menu"),
        (SHIFT, Key::B, "There is no zoom into a box"),
        (SHIFT, Key::N, "Normals are not recalculated"),
        (SHIFT, Key::O, "There is no proportional editing"),
        (SHIFT, Key::I, "Bones take no constraints"),
        (SHIFT, Key::P, "This key adds no shape"),
    ] {
        story.key_with(modifiers, key);
        let (severity, last) = *story.messages().last().unwrap();
        assert_eq!(severity, Severity::Info);
        assert!(last.starts_with(told), "{key:?}: {last}");
    }
    // These have the words of the last one, which are told once.
    for key in [Key::T, Key::U] {
        story.key_with(SHIFT, key);
    }
    assert_eq!(story.names(), ["Strip"], "no shape is added");
    assert_eq!(story.shape().placement, placed);
}

#[test]
fn everything_is_fitted_whatever_is_selected_and_by_home_and_shift_c_in_blenders_navigation() {
    let mut story = Story::start(&[]);
    story.key_with(SHIFT, Key::C);
    story.type_into("Position X", "20");
    story.key_with(SHIFT, Key::S);
    story.key_with(SHIFT | CTRL, Key::A);
    assert_eq!(story.session().selected(), None, "Select None");
    story.key(Key::F);
    let all = story.session().view().camera;
    story.key_with(CTRL, Key::A);
    let sphere = story.session().scene().shapes()[1].id;
    let select = Action::View(View::Select(Some(sphere)));
    story.program.carry_out(vec![select], &mut story.host);
    story.key(Key::F);
    assert_ne!(story.session().view().camera, all, "the sphere alone");
    story.key_with(SHIFT, Key::F);
    assert_eq!(story.session().view().camera, all);

    story.program.ui_mut().set_navigation(Navigation::Blender);
    for (modifiers, key) in [(Modifiers::NONE, Key::Home), (SHIFT, Key::C)] {
        story.key(Key::Period);
        assert_ne!(story.session().view().camera, all);
        story.key_with(modifiers, key);
        assert_eq!(story.session().view().camera, all);
    }
    assert_eq!(story.names(), ["Cube", "Sphere"], "no shape is added");
}

#[test]
fn shift_a_inserts_where_the_pointer_is() {
    let mut story = Story::start(&[]);
    story.point(egui::pos2(300.0, 200.0));
    story.key_with(SHIFT, Key::A);
    let item = story.place("Sphere");
    assert!(
        (item - egui::pos2(300.0, 200.0)).length() < 150.0,
        "{item:?}"
    );
    story.click("Sphere");
    assert_eq!(story.names(), ["Sphere"]);
}
