//! The shape panel: list, properties, color, display.

use crate::interface::Editor;
use editor_core::editor::{Edit, SCALES};
use editor_core::scene::{
    BoneStyle, COLOR_PRESETS, JointStyle, ModelDisplay, NewShape, ShapeColor, ShapeId, ShapeKind,
};
use editor_core::ui::{DARK, LIGHT};
use egui::{Key, Modifiers};
use glam::Vec3;

fn with_cube() -> Editor {
    let mut editor = Editor::new();
    editor.choose(&["Insert", "Cube"]);
    editor
}

#[test]
fn a_shape_is_selected_in_the_list_by_click_and_by_keyboard() {
    let mut editor = with_cube();
    editor.choose(&["Insert", "Sphere"]);
    editor.choose(&["Insert", "Teapot"]);
    editor.click("[1] Cube (ID: 1)");
    assert_eq!(editor.session().selected(), Some(ShapeId(1)));
    editor.key(Key::ArrowDown);
    assert_eq!(editor.session().selected(), Some(ShapeId(2)));
    editor.key(Key::ArrowDown);
    editor.key(Key::ArrowDown);
    assert_eq!(editor.session().selected(), Some(ShapeId(3)), "the last");
    editor.key(Key::ArrowUp);
    assert_eq!(editor.session().selected(), Some(ShapeId(2)));
}

#[test]
fn delete_takes_the_selected_shape_away_by_button_and_by_key() {
    let mut editor = with_cube();
    editor.choose(&["Insert", "Sphere"]);
    editor.click("Delete");
    assert!(!editor.has("[2] Sphere (ID: 2)"));
    editor.key(Key::Delete);
    assert!(editor.session().scene().shapes().is_empty());
}

#[test]
fn reset_brings_back_placement_color_and_joint_angles() {
    let mut editor = Editor::with_figure();
    let start = editor.shape().placement;
    editor.type_into("Position Y", "1.5");
    editor.type_into("Rotation Z", "90");
    editor.type_into("Neck X", "20");
    assert_ne!(editor.shape().placement, start);
    editor.click("Reset");
    assert_eq!(editor.shape().placement, start);
    assert!(editor.character().pose().is_bind());
}

#[test]
fn typed_numbers_may_be_sums_and_nonsense_changes_nothing() {
    let mut editor = with_cube();
    editor.type_into("Position X", "45/2");
    editor.type_into("Position Y", "-(1+2)*0,5");
    editor.type_into("Position Z", "five");
    let position = editor.shape().placement.transform.position;
    assert_eq!(position, Vec3::new(22.5, -1.5, 0.0));
}

#[test]
fn no_typed_number_is_too_large_to_work_with() {
    let mut editor = with_cube();
    editor.type_into("Position X", &["9999999999"; 4].join("*"));
    let position = editor.shape().placement.transform.position;
    assert_eq!(position, Vec3::X * 1e9);
}

#[test]
fn what_was_typed_counts_when_the_keyboard_goes_elsewhere() {
    let mut editor = with_cube();
    editor.begin_typing("Position X", "3");
    editor.key(Key::Tab);
    assert_eq!(editor.shape().placement.transform.position.x, 3.0);
    editor.begin_typing("Position Y", "4");
    editor.click("Position Z");
    assert_eq!(editor.shape().placement.transform.position.y, 4.0);
}

#[test]
fn dragging_changes_by_a_step_a_pixel_finer_with_shift_and_coarser_with_ctrl() {
    let mut editor = with_cube();
    editor.drag("Position X", 30.0);
    let x = |editor: &Editor| editor.shape().placement.transform.position.x;
    assert!((x(&editor) - 0.3).abs() < 1e-5, "{}", x(&editor));
    editor.drag_with("Position X", 30.0, Modifiers::SHIFT);
    assert!((x(&editor) - 0.33).abs() < 1e-5, "{}", x(&editor));
    editor.right_click("Position X");
    assert_eq!(x(&editor), 0.0, "right click resets");
    editor.drag_with("Position X", 30.0, Modifiers::COMMAND | Modifiers::CTRL);
    assert!((x(&editor) - 3.0).abs() < 1e-4, "{}", x(&editor));
}

#[test]
fn up_and_down_step_a_number_while_it_is_typed() {
    let mut editor = with_cube();
    editor.click("Position X");
    editor.key(Key::ArrowUp);
    editor.key(Key::ArrowUp);
    editor.key(Key::ArrowDown);
    editor.key(Key::Enter);
    let x = editor.shape().placement.transform.position.x;
    assert!((x - 0.01).abs() < 1e-6, "{x}");
}

#[test]
fn scaling_goes_from_uniform_to_each_axis_and_back() {
    let mut editor = with_cube();
    let scale = |editor: &Editor| editor.shape().placement.transform.scale;
    editor.type_into("Uniform Scale", "2");
    assert_eq!(scale(&editor), Vec3::splat(2.0));
    editor.click("Uniform Scaling");
    editor.type_into("Scale Y", "3");
    assert_eq!(scale(&editor), Vec3::new(2.0, 3.0, 2.0));
    editor.click("Uniform Scaling");
    assert_eq!(scale(&editor), Vec3::splat(2.0));
    // What the Scale tool can do can be typed.
    for (typed, taken) in [
        ("99", 99.0),
        ("0.05", 0.05),
        ("0", SCALES.0),
        ("1e9", SCALES.1),
    ] {
        editor.type_into("Uniform Scale", typed);
        assert!((scale(&editor).x - taken).abs() <= 1e-6 * taken, "{typed}");
    }
}

#[test]
fn the_list_of_colors_has_all_presets_and_chooses_one() {
    let mut editor = with_cube();
    editor.click("Color");
    for preset in COLOR_PRESETS {
        assert!(editor.has(preset.name), "{}", preset.name);
    }
    editor.click("Teal");
    assert_eq!(editor.shape().placement.color, ShapeColor::Preset(14));
}

#[test]
fn custom_starts_from_the_color_there_was_and_a_click_on_the_color_opens_a_picker() {
    let mut editor = with_cube();
    editor.click("Color");
    editor.click("Custom");
    let red = Vec3::new(1.0, 0.0, 0.0);
    assert_eq!(editor.shape().placement.color, ShapeColor::Custom(red));
    for start in ["Custom", "Teal"] {
        editor.click("Color");
        editor.click(start);
        assert!(!egui::Popup::is_any_open(&editor.harness.ctx));
        editor.click("Custom color");
        assert!(egui::Popup::is_any_open(&editor.harness.ctx), "{start}");
        editor.key(Key::Escape);
    }
}

#[test]
fn the_display_mode_and_the_style_of_joints_and_bones_are_chosen_by_button() {
    let mut editor = Editor::with_figure();
    assert_eq!(editor.character().display.mode, ModelDisplay::Mesh);
    assert!(!editor.has("Points"), "a mesh alone has no joints to style");
    editor.click("Skeletal Model");
    editor.click("Points");
    editor.type_into("Point size", "12");
    editor.click("Lines");
    editor.type_into("Line width", "3");
    editor.click("Both");
    let display = editor.character().display;
    assert_eq!(display.mode, ModelDisplay::Both);
    assert_eq!(display.joints, JointStyle::Points);
    assert_eq!(display.bones, BoneStyle::Lines);
    assert_eq!((display.point_size, display.line_width), (12.0, 3.0));
}

#[test]
fn a_new_shape_is_scrolled_into_sight_in_a_long_list() {
    let mut editor = with_cube();
    for _ in 0..14 {
        editor.choose(&["Insert", "Sphere"]);
    }
    let row = editor.widget("[15] Sphere (ID: 15)").rect();
    let below = editor.widget("Delete").rect();
    assert!(row.bottom() <= below.top(), "{row} is below {below}");
}

/// Ends of the lines that show where what is dragged in the list will land.
fn landing_lines(editor: &Editor) -> Vec<[egui::Pos2; 2]> {
    let shapes = editor.harness.output().shapes.iter();
    let lines = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::LineSegment { points, stroke } => {
            let is_level = points[0].y == points[1].y;
            (is_level
                && [DARK, LIGHT]
                    .map(|colors| colors.accent)
                    .contains(&stroke.color))
            .then_some(*points)
        }
        _ => None,
    });
    lines.collect()
}

#[test]
fn a_row_that_is_dragged_shows_by_a_line_where_it_will_land() {
    let mut editor = with_cube();
    editor.choose(&["Insert", "Sphere"]);
    editor.choose(&["Insert", "Teapot"]);
    let row = |editor: &Editor, label| editor.widget(label).rect();
    let last = row(&editor, "[3] Teapot (ID: 3)");
    let from = row(&editor, "[1] Cube (ID: 1)").center();
    assert!(landing_lines(&editor).is_empty());
    editor.take(from);
    for (y, edge) in [
        (last.top() + 3.0, last.top()),
        (last.bottom() - 3.0, last.bottom()),
    ] {
        editor.point(egui::pos2(from.x, y));
        let lines = landing_lines(&editor);
        let [line] = lines[..] else {
            panic!("{lines:?}");
        };
        assert_eq!(line[0].y, edge);
        assert!(line[0].x <= last.left() && line[1].x >= last.right());
    }
    editor.let_go(egui::pos2(from.x, last.bottom() - 3.0));
    assert!(editor.has("[3] Cube (ID: 1)"));
    assert!(landing_lines(&editor).is_empty());
}

#[test]
fn a_right_click_puts_a_number_back_to_where_the_shape_started() {
    let mut editor = Editor::new();
    let mut shape = NewShape::new("Cube", ShapeKind::Cube);
    shape.placement.transform.position = Vec3::new(1.0, 2.0, 3.0);
    shape.start = shape.placement;
    editor.edit(Edit::Insert(vec![shape]));
    editor.type_into("Position X", "7");
    editor.type_into("Position Y", "8");
    editor.right_click("Position Y");
    let position = editor.shape().placement.transform.position;
    assert_eq!(position, Vec3::new(7.0, 2.0, 3.0));
}

/// Names and colors of the course's editor, in its order, in eighths; Light Gray is 0.825.
#[rustfmt::skip]
const COURSE_COLORS: [(&str, [u8; 3]); 30] = [
    ("Black", [0, 0, 0]), ("White", [8, 8, 8]), ("Red", [8, 0, 0]), ("Lime", [0, 8, 0]),
    ("Blue", [0, 0, 8]), ("Yellow", [8, 8, 0]), ("Cyan", [0, 8, 8]), ("Magenta", [8, 0, 8]),
    ("Silver", [6, 6, 6]), ("Gray", [4, 4, 4]), ("Maroon", [4, 0, 0]), ("Olive", [4, 4, 0]),
    ("Green", [0, 4, 0]), ("Purple", [4, 0, 4]), ("Teal", [0, 4, 4]), ("Navy", [0, 0, 4]),
    ("Orange", [8, 4, 0]), ("Rose", [8, 0, 4]), ("Light Green", [0, 8, 4]), ("Gold", [4, 8, 0]),
    ("Violet", [4, 0, 8]), ("Light Blue", [0, 4, 8]), ("Pink", [8, 4, 4]), ("Mint", [4, 8, 4]),
    ("Lavender", [4, 4, 8]), ("Fuchsia", [8, 4, 8]), ("Baby Blue", [8, 8, 4]), ("Canary", [4, 8, 8]),
    ("Dark Gray", [2, 2, 2]), ("Nero", [1, 1, 1]),
];

#[test]
fn presets_have_the_names_and_colors_of_the_courses_editor() {
    for (index, (name, eighths)) in COURSE_COLORS.into_iter().enumerate() {
        let rgb = Vec3::from(eighths.map(f32::from)) / 8.0;
        assert_eq!(COLOR_PRESETS[index].name, name);
        assert_eq!(ShapeColor::Preset(index).rgb(), rgb, "{name}");
    }
    assert_eq!(COLOR_PRESETS[30].name, "Light Gray");
    assert_eq!(ShapeColor::Preset(30).rgb(), Vec3::splat(0.825));
    assert_eq!(COLOR_PRESETS[31].name, "Custom");
}

#[test]
fn new_shapes_have_the_colors_of_the_courses_editor() {
    let mut editor = Editor::new();
    for (item, color) in [
        ("Cube", "Red"),
        ("Sphere", "Lime"),
        ("Pyramid", "Yellow"),
        ("Teapot", "Blue"),
        ("Icosahedron", "Cyan"),
        ("Custom Shape", "Olive"),
    ] {
        editor.choose(&["Insert", item]);
        let preset = editor.shape().placement.color.preset_index();
        assert_eq!(COLOR_PRESETS[preset].name, color, "{item}");
    }
}
