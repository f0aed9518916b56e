//! Nothing clipped, nothing on top of anything else, nothing without a name.

use crate::interface::{Editor, figure};
use egui::accesskit::Role;
use egui::{Key, Rect, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

const INTERACTIVE: &[Role] = &[
    Role::Button,
    Role::CheckBox,
    Role::ColorWell,
    Role::ComboBox,
    Role::RadioButton,
    Role::SpinButton,
    Role::TextInput,
];

/// Name and place of every widget that can be used.
fn interactive(editor: &Editor) -> Vec<(String, Rect)> {
    editor
        .widgets()
        .iter()
        .filter(|node| INTERACTIVE.contains(&node.accesskit_node().role()))
        .map(|node| {
            let name = node.accesskit_node().label().unwrap_or_default();
            (name, node.rect())
        })
        .collect()
}

fn assert_all_named(editor: &Editor, when: &str) {
    let widgets = interactive(editor);
    assert!(widgets.len() > 4, "{when}: only {} widgets", widgets.len());
    for (name, rect) in widgets {
        assert!(!name.trim().is_empty(), "{when}: no name at {rect}");
    }
}

/// A figure with everything in its panel shown.
fn full() -> Editor {
    let mut editor = Editor::with_figure();
    editor.click("Uniform Scaling");
    editor.click("Skeletal Model");
    editor.click("Points");
    editor.click("Lines");
    editor.type_into("Neck X", "329.57");
    editor.type_into("Root Offset X", "-12.345");
    editor
}

#[test]
fn every_widget_has_a_name() {
    let mut editor = full();
    assert_all_named(&editor, "panel");
    editor.click("Color");
    assert_all_named(&editor, "list of colors");
    editor.key(Key::Escape);
    for menu in ["File", "Insert", "View", "Help"] {
        editor.click(menu);
        assert_all_named(&editor, menu);
        editor.key(Key::Escape);
    }
    for (key, dialog) in [
        (Key::F1, "keys"),
        (Key::F9, "messages"),
        (Key::F12, "screenshot"),
    ] {
        editor.key(key);
        assert_all_named(&editor, dialog);
        editor.key(Key::Escape);
    }
}

/// Curves of every kind with everything in their panel shown, in a window that has room for all.
fn full_of_curves() -> Editor {
    let mut editor = Editor::sized(vec2(800.0, 1400.0));
    editor.choose(&["Insert", "Bézier Curve"]);
    editor.type_into("1. curve point 4 Z", "-12.345");
    editor.choose(&["Add a curve", "Add circle"]);
    editor.choose(&["Insert", "Surface of Revolution from Curve"]);
    editor.choose(&["Insert", "Sweep from Curves"]);
    for item in ["1. curve", "2. curve2", "3. surface", "4. surface2"] {
        editor.click(item);
    }
    editor
}

#[test]
fn everything_about_curves_has_a_name_and_a_place_of_its_own() {
    let mut editor = full_of_curves();
    assert_all_named(&editor, "curves");
    assert_apart(&editor);
    editor.click("Add a curve");
    assert_all_named(&editor, "curves to add");
}

#[test]
fn in_the_courses_window_no_widget_leaves_the_panel_or_covers_another() {
    let mut editor = full();
    editor.reveal("Delete");
    assert_apart(&editor);
}

/// Asserts that widgets of the panel, which is as wide as the course's, stay in it and apart.
fn assert_apart(editor: &Editor) {
    let window = editor.harness.ctx.content_rect();
    let panel = window.with_min_x(window.right() - 280.0);
    let in_panel: Vec<_> = interactive(editor)
        .into_iter()
        .filter(|(_, rect)| rect.center().x > panel.left() && rect.bottom() < panel.bottom())
        .collect();
    assert!(in_panel.len() > 20, "only {}", in_panel.len());
    for (i, (name, rect)) in in_panel.iter().enumerate() {
        assert!(panel.contains_rect(*rect), "{name} at {rect}");
        for (other, place) in &in_panel[i + 1..] {
            let both = rect.shrink(0.5).intersect(place.shrink(0.5));
            assert!(!both.is_positive(), "{name} and {other} at {rect}, {place}");
        }
    }
}

/// Asserts that the row of each joint called `names` is as wide as its text.
fn assert_names_whole(editor: &Editor, names: &[&str]) {
    let font = egui::FontId::proportional(13.0);
    for name in names {
        let galley = editor.harness.ctx.fonts_mut(|fonts| {
            fonts.layout_no_wrap((*name).to_owned(), font.clone(), egui::Color32::WHITE)
        });
        let room = editor.widget(name).rect().width();
        assert!(
            galley.size().x <= room,
            "{name}: {} in {room}",
            galley.size().x
        );
    }
}

#[test]
fn no_name_of_a_joint_is_cut_at_the_courses_width() {
    assert_names_whole(&full(), &editor_core::character::COURSE_JOINT_NAMES);
}

#[test]
fn in_a_large_window_the_numbers_stay_beside_their_names() {
    let mut editor = Editor::sized(vec2(1920.0, 1080.0));
    editor.add_character(figure::figure());
    let name = editor.widget("Left elbow").rect();
    let field = editor.widget("Left elbow X").rect();
    assert!((name.center().y - field.center().y).abs() < 1.0);
    assert!(field.left() >= name.right());
}

#[test]
fn a_tiny_window_is_no_reason_to_panic() {
    for size in [vec2(1.0, 1.0), vec2(60.0, 40.0), vec2(300.0, 80.0)] {
        let mut editor = Editor::sized(size);
        editor.add_character(figure::figure());
        editor.key(Key::F1);
        editor.key(Key::F12);
    }
}

#[test]
fn the_panel_is_made_wider_by_its_edge_and_the_view_narrower() {
    let mut editor = Editor::with_figure();
    let before = editor.harness.state().view;
    let edge = egui::pos2(before.right(), 300.0);
    editor.harness.hover_at(edge);
    editor.harness.drag_at(edge);
    editor.harness.hover_at(edge - vec2(40.0, 0.0));
    editor.harness.hover_at(edge - vec2(80.0, 0.0));
    editor.harness.drop_at(edge - vec2(80.0, 0.0));
    editor.settle();
    let after = editor.harness.state().view;
    assert!(
        (before.right() - after.right() - 80.0).abs() <= 2.0,
        "{after}"
    );
}

#[test]
fn the_tools_stay_in_the_view_and_off_the_axis_ball_in_every_window() {
    for width in [420.0, 560.0, 640.0, 700.0, 760.0, 800.0, 1280.0] {
        for key in [Key::B, Key::I] {
            let mut editor = Editor::sized(vec2(width, 400.0));
            editor.add_character(figure::figure());
            editor.key(key);
            let view = editor.harness.state().view;
            let in_view = interactive(&editor)
                .into_iter()
                .filter(|(_, rect)| view.contains(rect.left_top()));
            let in_view: Vec<_> = in_view.collect();
            assert!(in_view.len() > 10, "{width}: {}", in_view.len());
            for (i, (name, rect)) in in_view.iter().enumerate() {
                assert!(view.contains_rect(*rect), "{width}: {name} at {rect}");
                let is_end = |name: &str| name.starts_with("Look from");
                for (other, place) in &in_view[i + 1..] {
                    let both = rect.shrink(0.5).intersect(place.shrink(0.5));
                    let two_ends = is_end(name) && is_end(other);
                    let apart = !both.is_positive() || two_ends;
                    assert!(apart, "{width}: {name} and {other} at {rect}, {place}");
                }
            }
        }
    }
}

/// The smallest window that the program can have, and another narrow one.
const SMALL: [egui::Vec2; 3] = [vec2(420.0, 400.0), vec2(420.0, 600.0), vec2(640.0, 400.0)];

#[test]
fn in_a_narrow_window_the_panel_is_folded_until_it_is_asked_for() {
    let mut editor = Editor::sized(vec2(420.0, 600.0));
    editor.add_character(figure::figure());
    let view = editor.harness.state().view;
    assert!(view.width() > 380.0 && !editor.has("Delete"), "{view}");
    editor.key(Key::N);
    assert!(editor.has("Delete"));
    let low = editor.harness.state().view;
    assert!(low.height() > 200.0, "the figure is still seen: {low}");
    editor.key(Key::N);
    assert_eq!(editor.harness.state().view, view);
    let handle = editor.widget("Shape Panel").rect();
    assert!(
        handle.width() > 300.0 && handle.height() >= 24.0,
        "{handle}"
    );
    editor.click("Shape Panel");
    assert!(editor.has("Delete"));
    assert!(
        !editor.harness.state().state.panel_folded,
        "wide ones keep theirs"
    );
}

#[test]
fn in_small_windows_menus_and_dialogs_stay_inside() {
    for size in SMALL {
        let mut editor = Editor::sized(size);
        editor.add_character(figure::figure());
        let window = editor.harness.ctx.content_rect();
        let assert_inside = |editor: &Editor, when: &str| {
            for (name, rect) in interactive(editor) {
                let inside = rect.left() >= -0.5 && rect.right() <= window.right() + 0.5;
                assert!(inside, "{when} in {size}: {name} at {rect}");
            }
        };
        for menu in ["File", "Edit", "Insert", "View", "Pose", "Help"] {
            editor.click(menu);
            assert_inside(&editor, menu);
            editor.key(Key::Escape);
        }
        for (key, dialog) in [
            (Key::F1, "keys"),
            (Key::F9, "messages"),
            (Key::F12, "screenshot"),
        ] {
            editor.key(key);
            editor.harness.run_steps(8);
            assert_inside(&editor, dialog);
            editor.key(Key::Escape);
        }
        let ctrl_shift = egui::Modifiers::COMMAND | egui::Modifiers::SHIFT;
        editor.key_with(ctrl_shift, Key::P);
        assert_inside(&editor, "search");
    }
}

#[test]
fn menus_hang_below_their_titles_in_low_windows_too() {
    for height in [420.0, 500.0, 530.0, 560.0, 600.0, 650.0, 700.0] {
        let mut editor = Editor::sized(vec2(1000.0, height));
        editor.add_character(figure::figure());
        for menu in ["File", "Edit", "Insert", "View", "Pose", "Help"] {
            let titles = editor.widget(menu).rect().bottom();
            let before = interactive(&editor);
            editor.click(menu);
            let mut items = interactive(&editor);
            items.retain(|(name, _)| before.iter().all(|(known, _)| known != name));
            assert!(!items.is_empty(), "{menu} of {height}");
            let tops = items.iter().map(|(_, rect)| rect.top());
            let top = tops.fold(f32::INFINITY, f32::min);
            assert!(top >= titles - 0.5, "{menu} of {height}: {top}");
            editor.key(Key::Escape);
        }
    }
}

#[test]
fn a_menu_that_does_not_fit_is_as_high_as_the_window_lets_it() {
    for height in [420.0, 480.0, 530.0] {
        let mut editor = Editor::sized(vec2(1000.0, height));
        editor.click("View");
        editor.harness.run_steps(4);
        let bottom = editor.harness.ctx.memory(|memory| {
            let layers = memory.areas().visible_layer_ids().into_iter();
            let menus = layers.filter(|layer| layer.order == egui::Order::Foreground);
            let bottoms = menus.filter_map(|layer| memory.area_rect(layer.id));
            bottoms.map(|rect| rect.bottom()).fold(0.0, f32::max)
        });
        assert!(
            bottom > height - 30.0 && bottom <= height,
            "{bottom} of {height}"
        );
    }
}

#[test]
fn in_small_windows_the_start_page_offers_all_it_has() {
    for size in SMALL {
        let mut editor = Editor::sized(size);
        let view = editor.harness.state().view;
        for label in ["Begin: Open…", "Begin: Robot", "Begin: Turned"] {
            editor.reveal(label);
            editor.harness.run_steps(20);
            let tile = editor.widget(label).rect();
            assert!(view.contains_rect(tile), "{label} in {size}: {tile}");
        }
    }
}

#[test]
fn the_start_page_is_below_both_rows_of_tools() {
    let mut editor = Editor::sized(vec2(1500.0, 900.0));
    editor.click("IK Tool");
    let tool = editor.widget("Unpin All Joints").rect();
    let heading = editor.harness.get_by_label("Start").rect();
    // Both have a margin.
    assert!(heading.top() > tool.bottom() + 20.0, "{heading} {tool}");
}

#[test]
fn the_name_of_the_driver_leaves_the_status_line_to_the_hint() {
    const WHOLE: &str = "WebGL 2.0 · ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)";
    const SHORT: &str = "WebGL 2.0 · SwiftShader";
    const HINT: &str = "Left drag moves the scene · right drag turns it · wheel zooms";
    let mut widest = 0.0;
    for (width, shown) in [
        (1400.0, Some(WHOLE)),
        (850.0, Some(SHORT)),
        (780.0, Some(SHORT)),
        (430.0, None),
    ] {
        let mut editor = Editor::sized(vec2(width, 600.0));
        editor.harness.state_mut().backend = WHOLE;
        editor.settle();
        let found = [WHOLE, SHORT].into_iter().find(|text| editor.has(text));
        assert_eq!(found, shown, "{width}");
        let hint = editor.harness.get_by_label(HINT).rect();
        if let Some(shown) = shown {
            let machine = editor.harness.get_by_label(shown).rect();
            assert!(hint.right() < machine.left(), "{width}");
        }
        assert!(
            hint.width() >= widest && hint.left() >= 0.0,
            "all of it at {width}"
        );
        widest = hint.width();
    }
}

#[test]
fn files_that_are_dragged_over_the_window_can_be_dropped_and_it_says_so() {
    let mut editor = Editor::new();
    let words = "Drop to open or add";
    assert!(!editor.has(words));
    let dragged = egui::HoveredFile::default();
    editor.harness.input_mut().hovered_files.push(dragged);
    editor.settle();
    assert!(editor.has(words));
    editor.harness.input_mut().hovered_files.clear();
    editor.settle();
    assert!(!editor.has(words));
}
