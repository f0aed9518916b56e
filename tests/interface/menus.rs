//! Menus, keys and dialogs.

use crate::interface::Editor;
use editor_core::editor::View;
use editor_core::scene::{Camera, Look, Shading, Skinning};
use editor_core::ui::{Ask, Navigation, Screenshot, Turntable};
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

#[test]
fn every_shape_of_the_insert_menu_is_added_and_selected() {
    let mut editor = Editor::new();
    let names = [
        "Cube",
        "Sphere",
        "Pyramid",
        "Teapot",
        "Icosahedron",
        "Custom Shape",
        "Bézier Curve",
        "B-Spline Curve",
        "Circle",
    ];
    for (index, name) in names.into_iter().enumerate() {
        editor.choose(&["Insert", name]);
        assert_eq!(editor.session().scene().shapes().len(), index + 1);
        assert_eq!(editor.shape().name, name);
        assert!(editor.has(&format!("[{0}] {name} (ID: {0})", index + 1)));
    }
}

#[test]
fn imports_and_built_in_characters_are_asked_of_the_program() {
    let mut editor = Editor::new();
    editor.choose(&["Insert", "Import", "Import Shape…"]);
    editor.choose(&["Insert", "Import", "Import Character…"]);
    editor.choose(&["Insert", "Import", "Import Curve…"]);
    editor.choose(&["Insert", "Built-in Character", "Robot"]);
    editor.choose(&["Insert", "Built-in Curve", "Vase"]);
    editor.key_with(Modifiers::COMMAND, Key::I);
    assert_eq!(
        editor.asked(),
        [
            Ask::ImportShape,
            Ask::ImportCharacter,
            Ask::ImportCurve,
            Ask::InsertBuiltin("Robot"),
            Ask::InsertBuiltin("vase"),
            Ask::ImportShape,
        ]
    );
}

#[test]
fn look_shading_and_axis_follow_their_menu_items() {
    let mut editor = Editor::new();
    editor.choose(&["View", "Look", "Studio"]);
    editor.choose(&["View", "Shading", "Smooth"]);
    editor.choose(&["View", "Ground Grid"]);
    let view = editor.session().view();
    assert_eq!(view.look, Look::Studio);
    assert_eq!(view.shading, Shading::Smooth);
    assert!(!view.grid);
    assert!(!view.axis);
    editor.choose(&["View", "Toggle Axis"]);
    assert!(editor.session().view().axis);
}

#[test]
fn a_look_has_the_axes_that_its_new_views_have_unless_they_were_shown_or_hidden() {
    let mut editor = Editor::new();
    let has_axes = |editor: &mut Editor, look: &str| {
        editor.choose(&["View", "Look", look]);
        editor.session().view().axis
    };
    assert!(!has_axes(&mut editor, "Studio"));
    assert!(!has_axes(&mut editor, "Mannequin"));
    assert!(has_axes(&mut editor, "Course"));
    assert!(!has_axes(&mut editor, "Studio"));
    editor.choose(&["View", "Toggle Axis"]);
    assert!(has_axes(&mut editor, "Mannequin"));
}

#[test]
fn the_ground_grid_cannot_be_chosen_without_a_ground() {
    let mut editor = Editor::new();
    editor.choose(&["View", "Ground Grid"]);
    assert!(editor.session().view().grid, "the Course look has none");
    editor.choose(&["View", "Look", "Mannequin"]);
    editor.choose(&["View", "Ground Grid"]);
    assert!(
        !editor.session().view().grid,
        "the Mannequin look has a floor"
    );
}

#[test]
fn the_theme_is_chosen_in_the_menu() {
    let mut editor = Editor::new();
    editor.choose(&["View", "Theme", "Light"]);
    assert!(!editor.harness.ctx.global_style().visuals.dark_mode);
    editor.choose(&["View", "Theme", "Dark"]);
    assert!(editor.harness.ctx.global_style().visuals.dark_mode);
}

#[test]
fn who_skins_is_chosen_in_the_menu() {
    let mut editor = Editor::new();
    assert_eq!(editor.harness.state().state.skinning, None);
    editor.choose(&["View", "Skinning", "Graphics Card"]);
    let chosen = editor.harness.state().state.skinning;
    assert_eq!(chosen, Some(Skinning::Gpu));
    editor.choose(&["View", "Skinning", "Automatic"]);
    assert_eq!(editor.harness.state().state.skinning, None);
}

#[test]
fn t_toggles_the_axis_but_not_while_a_number_is_typed() {
    let mut editor = Editor::with_figure();
    editor.key(Key::T);
    assert!(!editor.session().view().axis);
    editor.click("Position X");
    editor.key(Key::T);
    assert!(!editor.session().view().axis);
}

#[test]
fn f_fits_the_selected_shape_into_the_view() {
    let mut editor = Editor::with_figure();
    let before = editor.session().view().camera.radius;
    editor.key(Key::F);
    let camera = editor.session().view().camera;
    assert!(camera.radius < before);
    let center = editor.session().evaluated().world_bounds().center();
    assert!(camera.target.abs_diff_eq(center, 0.1));
}

#[test]
fn esc_leaves_a_field_first_then_closes_windows_from_the_newest_and_pressed_twice_quits() {
    let mut editor = Editor::with_figure();
    editor.key(Key::Questionmark);
    editor.key(Key::F9);
    editor.begin_typing("Position X", "7");
    editor.key(Key::Escape);
    assert_eq!(editor.shape().placement.transform.position.x, 0.0);
    let open = |editor: &Editor| (editor.has("Click the axis ball"), editor.has("Copy all"));
    assert_eq!(open(&editor), (true, true));
    editor.key(Key::Escape);
    assert_eq!(open(&editor), (true, false));
    editor.key(Key::Escape);
    assert_eq!(open(&editor), (false, false));
    editor.key(Key::Escape);
    assert_eq!(editor.session().selected(), None);
    assert!(editor.asked().is_empty());
    editor.wait();
    editor.key(Key::Escape);
    assert!(editor.asked().is_empty(), "once might be once too often");
    editor.key(Key::Escape);
    assert_eq!(editor.asked(), [Ask::Quit]);
}

#[test]
fn a_page_cannot_be_quit_and_takes_no_pictures_of_its_panels() {
    let mut editor = Editor::with_figure();
    editor.harness.state_mut().is_page = true;
    editor.settle();
    editor.click("File");
    assert!(editor.has("Screenshot…"));
    assert!(!editor.has("Quit"));
    editor.click("Screenshot…");
    assert!(editor.has("Transparent"));
    assert!(!editor.has("With panels"));
    editor.key(Key::Escape);
    assert!(!editor.has("Transparent"), "Esc still closes dialogs");
    editor.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    let is_painted =
        |editor: &Editor, label: &str| editor.painted().iter().any(|(text, _)| text == label);
    assert!(
        is_painted(&editor, "Revert") && !is_painted(&editor, "Quit"),
        "{:?}",
        editor.painted()
    );
    editor.key(Key::Escape);
    editor.key(Key::Escape);
    assert_eq!(editor.session().selected(), None, "and deselects");
    for _ in 0..2 {
        editor.wait();
        editor.key(Key::Escape);
    }
    editor.key_with(Modifiers::COMMAND, Key::Q);
    editor.click("Help");
    editor.click("Keys and Mouse");
    assert!(editor.has("Redo") && !editor.has("Quit"));
    assert!(editor.asked().is_empty());
}

#[test]
fn a_page_alone_can_be_had_read_aloud_until_preferences_are_reset() {
    let mut editor = Editor::new();
    let aloud = "Read aloud what is used or has the focus";
    let reads = |editor: &Editor| editor.harness.ctx.options(|options| options.screen_reader);
    editor.choose(&["Edit", "Preferences…"]);
    assert!(!editor.has(aloud), "elsewhere the system reads the widgets");
    editor.harness.state_mut().is_page = true;
    editor.settle();
    assert!(!reads(&editor));
    editor.click(aloud);
    assert!(reads(&editor));
    editor.click("Reset to defaults");
    assert!(!reads(&editor));
}

#[test]
fn of_the_commands_that_are_searched_for_those_that_can_be_run_come_first() {
    let mut editor = Editor::with_figure();
    editor.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    editor.harness.event(egui::Event::Text("pose".into()));
    editor.settle();
    let top = |label: &str| editor.widget(label).rect().top();
    // Every joint is at rest, so that there is nothing to reset or mirror, as the Pose menu has it first.
    let last_that_runs = top("Copy Pose").max(top("Load Pose…"));
    assert!(last_that_runs < top("Reset Pose").min(top("Mirror Pose")));
}

#[test]
fn an_open_menu_gives_way_to_the_one_whose_title_the_pointer_comes_to() {
    let mut editor = Editor::new();
    let title = |editor: &Editor, menu: &str| editor.widget(menu).rect().center();
    let edit = title(&editor, "Edit");
    editor.harness.hover_at(edit);
    editor.settle();
    assert!(!editor.has("Select All"), "none is open");
    editor.click("File");
    assert!(editor.has("Save As…"));
    editor.harness.hover_at(edit);
    editor.settle();
    assert!(editor.has("Select All") && !editor.has("Save As…"));
    let insert = title(&editor, "Insert");
    editor.harness.hover_at(insert);
    editor.settle();
    assert!(editor.has("Teapot") && !editor.has("Select All"));
    editor.key(Key::Escape);
    assert!(!editor.has("Teapot"));
}

#[test]
fn the_insert_menu_at_the_pointer_does_not_list_itself() {
    let mut editor = Editor::new();
    editor.click("Insert");
    assert!(editor.has("Insert Menu at Pointer"));
    editor.key(Key::Escape);
    editor.key_with(Modifiers::SHIFT, Key::A);
    assert!(editor.has("Teapot") && editor.has("Import"));
    assert!(!editor.has("Insert Menu at Pointer"));
}

#[test]
fn the_insert_menu_at_the_pointer_is_chosen_from_by_arrow_keys() {
    let mut editor = Editor::new();
    let names = |editor: &Editor| -> Vec<String> {
        let shapes = editor.session().scene().shapes();
        shapes.iter().map(|shape| shape.name.clone()).collect()
    };
    editor.harness.hover_at(egui::pos2(200.0, 300.0));
    editor.key_with(Modifiers::SHIFT, Key::A);
    editor.key(Key::ArrowDown);
    editor.key(Key::Enter);
    assert_eq!(names(&editor), ["Sphere"], "the second item");
    assert!(!editor.has("Teapot"), "the menu is closed");
    editor.key(Key::ArrowDown);
    editor.key(Key::Enter);
    assert_eq!(names(&editor), ["Sphere"], "nothing is left to choose");
    editor.key_with(Modifiers::SHIFT, Key::A);
    editor.key(Key::Escape);
    assert_eq!(names(&editor), ["Sphere"], "Esc chooses nothing");
}

#[test]
fn esc_does_not_quit_while_a_button_is_held() {
    let mut editor = Editor::new();
    editor.harness.state_mut().gestures = true;
    let at = egui::pos2(200.0, 300.0);
    editor.harness.hover_at(at);
    editor.harness.drag_at(at);
    editor.harness.hover_at(at + egui::vec2(30.0, 0.0));
    editor.settle();
    assert_ne!(editor.session().view().camera, Camera::default());
    editor.key(Key::Escape);
    editor.harness.hover_at(at);
    editor.settle();
    assert_eq!(editor.session().view().camera, Camera::default());
    assert!(editor.asked().is_empty());
    editor.harness.drop_at(at);
    editor.settle();
    editor.wait();
    editor.key(Key::Escape);
    editor.key(Key::Escape);
    assert_eq!(editor.asked(), [Ask::Quit]);
}

#[test]
fn esc_closes_an_open_menu_before_it_quits() {
    let mut editor = Editor::new();
    editor.click("Insert");
    editor.key(Key::Escape);
    assert!(!editor.has("Cube"));
    assert!(editor.asked().is_empty());
}

#[test]
fn keys_that_belong_to_the_program_are_left_alone() {
    let mut editor = Editor::new();
    editor.harness.state_mut().keys_are_taken = true;
    editor.key(Key::Escape);
    editor.key(Key::T);
    assert!(editor.asked().is_empty());
    assert!(editor.session().view().axis);
}

#[test]
fn the_window_about_the_keys_lists_every_command_that_has_one() {
    let mut editor = Editor::sized(egui::vec2(900.0, 1400.0));
    editor.key(Key::F1);
    let commands = editor_core::ui::COMMANDS.iter();
    for entry in commands.filter(|entry| !entry.shortcuts.is_empty() && entry.only_in.is_none()) {
        assert!(editor.has(entry.label), "{}", entry.label);
    }
    for gesture in editor_core::ui::GESTURES {
        assert!(editor.has(gesture.gesture), "{}", gesture.gesture);
    }
}

#[test]
fn a_screenshot_is_asked_for_at_the_size_and_with_the_parts_that_were_chosen() {
    let mut editor = Editor::new();
    editor.key(Key::F12);
    editor.click("Save…");
    assert!(!editor.has("Save…"), "the dialog is closed");

    editor.choose(&["File", "Screenshot…", "Custom"]);
    editor.type_into("Picture width", "640*2");
    editor.type_into("Picture height", "720");
    editor.click("Save…");

    editor.choose(&["File", "Screenshot…", "With panels", "Save…"]);
    let asked: Vec<_> = [(false, None), (false, Some((1280, 720))), (true, None)]
        .into_iter()
        .map(|(with_panels, size)| {
            Ask::Screenshot(Screenshot {
                with_panels,
                size,
                ..Screenshot::default()
            })
        })
        .collect();
    assert_eq!(editor.asked(), asked);
}

#[test]
fn a_turntable_is_asked_for_with_as_many_pictures_as_were_typed_and_never_without_background() {
    let mut editor = Editor::new();
    editor.choose(&["File", "Screenshot…", "Transparent", "Turntable"]);
    editor.type_into("Turntable pictures", "24");
    editor.click("Save…");
    editor.choose(&["File", "Screenshot…", "Still", "Save…"]);
    let turntable = Turntable {
        frames: 24,
        fit: true,
    };
    let [turning, still] =
        [(false, Some(turntable)), (true, None)].map(|(transparent, turntable)| {
            Ask::Screenshot(Screenshot {
                transparent,
                turntable,
                ..Screenshot::default()
            })
        });
    assert_eq!(editor.asked(), [turning, still]);
}

#[test]
fn esc_closes_the_screenshot_dialog_and_no_other_key_works_below_it() {
    let mut editor = Editor::new();
    editor.key(Key::F12);
    editor.key(Key::T);
    assert!(editor.session().view().axis);
    editor.key(Key::Escape);
    assert!(!editor.has("Save…"));
    assert!(editor.asked().is_empty());
}

#[test]
fn no_key_turns_or_walks_the_camera_behind_a_dialog() {
    for (navigation, keys) in [
        (Navigation::Blender, &[Key::Num4, Key::Num8, Key::Num9][..]),
        (Navigation::Mannequin, &[Key::W, Key::ArrowUp]),
    ] {
        let mut editor = Editor::new();
        let state = &mut editor.harness.state_mut().state;
        state.set_navigation(navigation);
        for dialog in ["Screenshot…", "Find Command…"] {
            editor.choose(&[
                if dialog == "Screenshot…" {
                    "File"
                } else {
                    "Help"
                },
                dialog,
            ]);
            let before = editor.session().view().camera;
            for &key in keys {
                editor.key(key);
            }
            assert_eq!(editor.session().view().camera, before, "{dialog}");
            editor.key(Key::Escape);
            editor.key(keys[0]);
            assert_ne!(editor.session().view().camera, before, "it is closed");
        }
    }
}

#[test]
fn arrow_keys_move_no_row_behind_a_dialog_and_ctrl_n_begins_no_document_from_its_fields() {
    let mut editor = Editor::with_figure();
    editor.click("Neck");
    let selected = editor.session().selected_joint();
    assert!(selected.is_some());
    editor.key(Key::F12);
    editor.key(Key::ArrowDown);
    assert_eq!(editor.session().selected_joint(), selected);
    editor.click("Custom");
    editor.begin_typing("Picture width", "800");
    editor.key_with(Modifiers::COMMAND, Key::N);
    assert!(editor.asked().is_empty());
    assert!(editor.has("Save…"), "the dialog is still open");
}

impl Editor {
    /// Whether the item of an open menu can be chosen.
    fn can_choose(&self, item: &str) -> bool {
        !self.widget(item).accesskit_node().is_disabled()
    }
}

#[test]
fn a_joint_at_rest_cannot_be_reset_and_a_turned_one_can() {
    let mut editor = Editor::with_figure();
    editor.click("Neck");
    editor.click("Pose");
    assert!(!editor.can_choose("Reset Joint"));
    editor.key(Key::Escape);
    editor.type_into("Neck X", "10");
    editor.view(View::SelectJoint(Some(3)));
    editor.click("Pose");
    assert!(editor.can_choose("Reset Joint"));
}

#[test]
fn where_everything_is_hidden_there_is_nothing_to_fit() {
    let mut editor = Editor::new();
    editor.choose(&["Insert", "Cube"]);
    editor.click("View");
    assert!(editor.can_choose("Fit to View"));
    editor.key(Key::Escape);
    editor.click("Hide Cube");
    editor.click("View");
    assert!(!editor.can_choose("Fit to View"));
}

#[test]
fn a_tooltip_of_a_menu_covers_none_of_its_items() {
    for size in [egui::vec2(800.0, 600.0), egui::vec2(420.0, 600.0)] {
        for (menu, item, tip) in [
            (
                "File",
                "Open…",
                "Open a scene, or a model as a new document",
            ),
            (
                "Insert",
                "Cube",
                "Add a cube at the origin, or beside the characters that are there",
            ),
            ("Edit", "Undo", "There is nothing to undo"),
        ] {
            let mut editor = Editor::sized(size);
            editor.click(menu);
            let item = editor.widget(item).rect();
            editor.harness.hover_at(item.center());
            editor.harness.run_steps(20);
            let painted = editor.painted();
            let tip = painted.iter().find(|(text, _)| text == tip);
            let (_, tip) = tip.unwrap_or_else(|| panic!("no tooltip in {menu}: {painted:?}"));
            let apart = tip.left() >= item.right() || tip.right() <= item.left();
            assert!(apart, "{menu} in {size}: {tip} over {item}");
        }
    }
}

#[test]
fn an_ellipsis_says_that_a_dialog_follows_and_nothing_else_has_one() {
    use editor_core::ui::{COMMANDS, Command};
    for entry in COMMANDS {
        let asks = matches!(
            entry.command,
            Command::Open
                | Command::SaveAs
                | Command::SaveWithFiles
                | Command::Screenshot
                | Command::ExportCurve
                | Command::ExportGeometry
                | Command::ExportSelected
                | Command::ExportMaterials
                | Command::ExportCharacter
                | Command::ImportShape
                | Command::ImportCurve
                | Command::ImportCharacter
                | Command::Compare
                | Command::CompareMesh
                | Command::SavePose
                | Command::LoadPose
                | Command::FindCommand
                | Command::Preferences
        );
        assert_eq!(entry.label.ends_with('…'), asks, "{}", entry.label);
    }
}

#[test]
fn copy_in_the_menu_is_named_for_what_its_key_copies_with_each_tool() {
    let mut editor = Editor::with_figure();
    let shape = editor.shape().id;
    let copy = |editor: &mut Editor, name| {
        editor.choose(&["Edit", name]);
        editor.key_with(Modifiers::COMMAND, Key::C);
    };
    copy(&mut editor, "Copy Shape");
    editor.click("Pose Tool");
    copy(&mut editor, "Copy Pose");
    editor.click("IK Tool");
    copy(&mut editor, "Copy Pose");
    editor.choose(&["Insert", "Cube"]);
    copy(&mut editor, "Copy Shape");
    editor.key_with(Modifiers::COMMAND, Key::A);
    editor.click("Select Tool");
    copy(&mut editor, "Copy Shapes");
    let (shapes, pose) = (
        Ask::CopyShapes,
        Ask::CopyPose {
            shape,
            joints: Vec::new(),
        },
    );
    let asked = [&shapes, &pose, &pose, &shapes, &shapes];
    let each_twice = asked.into_iter().flat_map(|ask| [ask.clone(), ask.clone()]);
    assert_eq!(editor.asked(), each_twice.collect::<Vec<_>>());
}

#[test]
fn a_document_without_a_file_cannot_be_reverted() {
    let mut editor = Editor::new();
    editor.choose(&["File", "Revert"]);
    assert_eq!(editor.asked(), []);
    let mut editor = Editor::new();
    editor.harness.state_mut().state.has_file = true;
    editor.settle();
    editor.choose(&["File", "Revert"]);
    assert_eq!(editor.asked(), [Ask::Revert]);
}

#[test]
fn a_turntable_says_why_it_cannot_be_transparent() {
    let mut editor = Editor::new();
    editor.choose(&["File", "Screenshot…", "Turntable"]);
    let transparent = editor.widget("Transparent").rect().center();
    editor.harness.hover_at(transparent);
    editor.harness.run_steps(20);
    let why = "Turntables are GIFs, which have no smooth transparency";
    let painted = editor.painted();
    assert!(painted.iter().any(|(text, _)| text == why), "{painted:?}");
}

/// The label of what has the keyboard.
fn focused(editor: &Editor) -> Option<String> {
    let mut nodes = editor.harness.root().children_recursive();
    let focused = nodes.find(|node| node.is_focused())?;
    focused.accesskit_node().label()
}

#[test]
fn arrow_keys_stay_in_a_menu_go_around_and_into_its_submenus_and_change_nothing_else() {
    let mut editor = Editor::with_figure();
    let figure = editor.session().scene().clone();
    editor.harness.hover_at(egui::pos2(200.0, 300.0));
    editor.key_with(Modifiers::SHIFT, Key::A);
    assert_eq!(focused(&editor).as_deref(), Some("Cube"));
    editor.key(Key::ArrowUp);
    assert_eq!(focused(&editor).as_deref(), Some("Import"), "around");
    editor.key(Key::ArrowRight);
    assert_eq!(focused(&editor).as_deref(), Some("Import Shape…"));
    editor.key(Key::ArrowDown);
    assert_eq!(focused(&editor).as_deref(), Some("Import Curve…"));
    editor.key(Key::ArrowLeft);
    assert_eq!(focused(&editor).as_deref(), Some("Import"));
    assert!(!editor.has("Import Curve…"), "the submenu is closed");
    editor.key(Key::Enter);
    assert_eq!(focused(&editor).as_deref(), Some("Import Shape…"));
    editor.key(Key::ArrowLeft);
    for _ in 0..3 {
        editor.key(Key::ArrowLeft);
        editor.key(Key::ArrowRight);
        editor.key(Key::ArrowDown);
    }
    editor.key(Key::Escape);
    assert!(!editor.has("Import") && !editor.has("Import Curve…"));
    assert_eq!(editor.session().scene(), &figure, "no number has changed");
}

#[test]
fn a_submenu_that_a_key_opened_stays_while_the_pointer_moves_until_it_is_over_another_item() {
    let mut editor = Editor::with_figure();
    editor.click("Insert");
    let away = egui::pos2(20.0, 500.0);
    editor.harness.hover_at(away);
    editor.harness.run_steps(2);
    editor.key(Key::ArrowUp);
    editor.key(Key::ArrowRight);
    assert!(editor.has("Import Curve…"));
    let inside = editor.harness.get_by_label("Import Curve…").rect().center();
    for at in [
        away - egui::vec2(4.0, 4.0),
        inside,
        inside + egui::vec2(2.0, 0.0),
    ] {
        editor.harness.hover_at(at);
        editor.harness.run_steps(4);
        assert!(editor.has("Import Curve…"), "{at}");
    }
    let other = editor.harness.get_by_label("Cube").rect().center();
    for at in [other, other + egui::vec2(1.0, 0.0)] {
        editor.harness.hover_at(at);
        editor.harness.run_steps(30);
    }
    assert!(!editor.has("Import Curve…"));
}

#[test]
fn the_first_arrow_key_in_a_menu_goes_to_its_first_or_its_last_item() {
    for (key, expected) in [(Key::ArrowDown, "Cube"), (Key::ArrowUp, "Import")] {
        let mut editor = Editor::new();
        editor.click("Insert");
        editor.key(key);
        assert_eq!(focused(&editor).as_deref(), Some(expected));
    }
}

#[test]
fn arrow_keys_go_along_the_menu_bar() {
    let mut editor = Editor::new();
    editor.click("Edit");
    editor.key(Key::ArrowDown);
    editor.key(Key::ArrowRight);
    assert!(editor.has("Cube") && !editor.has("Select All"), "Insert");
    assert_eq!(focused(&editor).as_deref(), Some("Cube"));
    editor.key(Key::ArrowLeft);
    editor.key(Key::ArrowLeft);
    assert!(editor.has("New") && !editor.has("Cube"), "File");
    editor.key(Key::ArrowLeft);
    assert!(editor.has("Keys and Mouse"), "around to Help");
}
