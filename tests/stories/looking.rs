//! Looking: views, mouse and wheel, and every key of the program, by what the course's editor and
//! the assignment say that they do.

use super::{Story, differing};
use editor_core::editor::{GizmoAxes, RotationGizmo, Tool, View};
use editor_core::program::{LastWindow, StorageKey, last_window};
use editor_core::scene::{Camera, Look, Shading, ShapeKind, ViewDirection};
use editor_core::ui::{COMMANDS, Command, Navigation};
use egui::{
    Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, ThemePreference, pos2, vec2,
};
use glam::{Vec2, Vec3};

/// A place in the view over which there is nothing.
const EMPTY: Pos2 = pos2(90.0, 560.0);

impl Story {
    fn camera(&self) -> Camera {
        self.session().view().camera
    }

    /// Where a point of the world is in the view, in points.
    fn pixel(&self, world: Vec3) -> Vec2 {
        let view = self.view();
        let size = Vec2::new(view.width(), view.height());
        self.camera().pixel(world, size).expect("before the eye")
    }

    fn drag_with(&mut self, button: PointerButton, by: egui::Vec2) {
        let event = |pos, pressed| Event::PointerButton {
            pos,
            button,
            pressed,
            modifiers: Modifiers::NONE,
        };
        self.point(EMPTY);
        self.frame(vec![event(EMPTY, true)]);
        self.point(EMPTY + by * 0.5);
        self.point(EMPTY + by);
        self.frame(vec![event(EMPTY + by, false)]);
        self.settle();
    }

    fn wheel(&mut self, notches: f32) {
        self.point(EMPTY);
        self.frame(vec![Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: vec2(0.0, notches),
            modifiers: Modifiers::NONE,
            phase: egui::TouchPhase::Move,
        }]);
        self.settle();
    }
}

#[test]
fn a_window_of_which_parts_were_painted_again_looks_as_one_that_is_painted_as_a_whole() {
    let mut story = Story::start(&["models/strip.obj"]);
    let view = story.place("View of the scene");
    let whole = |story: &mut Story, step: &str| {
        let parts = story.picture();
        let size = story.size;
        for other in [(size.0 + 40, size.1), size] {
            story.size = other;
            story.settle();
        }
        assert_eq!(differing(&parts, &story.picture()), 0, "{step}");
    };
    story.point(view);
    story.settle();
    whole(&mut story, "a shape under the pointer");
    story.click("View");
    whole(&mut story, "a menu");
    story.key(Key::Escape);
    whole(&mut story, "no menu any more");
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(30.0, 0.0));
    whole(&mut story, "a number that is dragged");
    story.button(false);
    story.settle();
    let tool = story.place("Rotate Tool");
    story.point(tool);
    story.wait(1.0);
    whole(&mut story, "a tooltip");
    story.point(view + vec2(0.0, 60.0));
    story.settle();
    whole(&mut story, "no tooltip any more");
    story.key(Key::K);
    whole(&mut story, "a panel below the view");
}

#[test]
fn the_bones_of_the_mannequin_look_are_hidden_and_shown_by_the_view_menu() {
    let mut story = Story::start(&["builtin:mannequin-1"]);
    assert_eq!(story.session().view().look, Look::Mannequin);
    let red = |story: &Story| {
        let picture = story.scene_picture();
        let pixels = picture.rgba.chunks_exact(4);
        pixels.filter(|pixel| *pixel == [255, 0, 0, 255]).count()
    };
    assert!(red(&story) > 50, "{}", red(&story));
    for (shown, step) in [(false, "off"), (true, "on"), (false, "off")] {
        story.click("View");
        story.click("Bones");
        assert_eq!(story.session().view().bones, shown, "{step}");
        assert_eq!(red(&story) > 0, shown, "{step}");
    }
    // In another look there are none: the item does nothing.
    story.key(Key::F2);
    story.click("View");
    story.click("Bones");
    assert!(!story.session().view().bones);
}

#[test]
fn the_line_round_the_shape_under_the_pointer_is_as_in_a_picture_that_is_drawn_anew() {
    let mut story = Story::start(&["models/strip.obj", "builtin:gem"]);
    let plain = story.scene_picture();
    let view = story.place("View of the scene");
    for at in [view, view + vec2(30.0, 40.0), view + vec2(300.0, 0.0), view] {
        story.point(at);
        story.settle();
        let hovered = story.scene_picture();
        for _ in 0..2 {
            story.key(Key::F4);
        }
        assert_eq!(differing(&hovered, &story.scene_picture()), 0, "{at}");
    }
    assert!(
        differing(&plain, &story.scene_picture()) > 50,
        "a shape is marked"
    );
}

#[test]
fn the_six_views_look_at_the_origin_from_five_away_along_their_axis() {
    let mut story = Story::start(&["builtin:gem"]);
    // Axis that the eye is on, and the one that points right in the picture.
    let views = [
        (Modifiers::NONE, Key::Num3, Vec3::X, Vec3::NEG_Z),
        (Modifiers::COMMAND, Key::Num3, Vec3::NEG_X, Vec3::Z),
        (Modifiers::NONE, Key::Num7, Vec3::Y, Vec3::X),
        (Modifiers::COMMAND, Key::Num7, Vec3::NEG_Y, Vec3::X),
        (Modifiers::NONE, Key::Num1, Vec3::Z, Vec3::X),
        (Modifiers::COMMAND, Key::Num1, Vec3::NEG_Z, Vec3::NEG_X),
    ];
    for (modifiers, key, eye, right) in views {
        story.key_with(modifiers, key);
        let camera = story.camera();
        assert!(
            camera.eye().abs_diff_eq(eye * 5.0, 1e-4),
            "{eye}: {:?}",
            camera.eye()
        );
        assert!(
            camera.right().abs_diff_eq(right, 1e-4),
            "{eye}: {:?}",
            camera.right()
        );
        assert_eq!(camera.target, Vec3::ZERO);
    }
}

#[test]
fn in_the_course_the_scene_follows_a_left_drag_turns_with_a_right_one_and_comes_with_the_wheel() {
    let mut story = Story::start(&[]);
    // Its exact speed belongs to its look.
    story.key(Key::F2);
    story.key(Key::Num1);
    // Toward the eye, to the right, up: the picture's axes from +Z are the world's.
    let start = story.camera();
    story.drag_with(PointerButton::Primary, vec2(40.0, 30.0));
    let moved = story.camera().target;
    assert!(
        moved.abs_diff_eq(Vec3::new(-0.4, 0.3, 0.0), 1e-5),
        "{moved}"
    );

    story.key(Key::Num1);
    story.drag_with(PointerButton::Secondary, vec2(40.0, 0.0));
    let turned = story.camera();
    assert!(
        (turned.theta - start.theta + 0.2).abs() < 1e-5,
        "{turned:?}"
    );
    // The eye goes with the pointer, so that what is near it moves the other way.
    assert!(turned.eye().x > 0.9, "{}", turned.eye());
    assert!(story.pixel(Vec3::Z).x < story.pixel(Vec3::ZERO).x - 10.0);

    story.key(Key::Num1);
    story.wheel(1.0);
    assert_eq!(story.camera().radius, 4.5);
    story.wheel(-2.0);
    assert_eq!(story.camera().radius, 5.5);
}

#[test]
fn home_is_about_the_view_wherever_the_pointer_is_and_twice_in_the_course_leads_to_its_own_camera()
{
    let mut story = Story::start(&["builtin:adult", "builtin:gear"]);
    story.key(Key::F2);
    let start = *story.session().start_camera();
    assert_ne!(start, Camera::default());
    story.click("[2] Gear (ID: 2)");
    let selected = story.session().selected();
    assert!(selected.is_some());
    story.wheel(1.0);
    assert_ne!(story.camera(), start);
    story.key(Key::Home);
    assert_eq!(story.camera(), start);
    assert_eq!(story.session().selected(), selected);
    story.key(Key::Home);
    assert_eq!(story.camera(), Camera::default());
    // Over the list as well, in which a click has just chosen what to look at.
    story.wheel(1.0);
    story.click("[2] Gear (ID: 2)");
    story.key(Key::Home);
    assert_eq!(story.camera(), start);
    assert_eq!(story.session().selected(), selected);
}

#[test]
fn what_is_turned_or_scaled_about_its_middle_is_put_back_where_it_was() {
    let far = "v 4 0 4\nv 5 0 4\nv 5 1 4\nv 4 1 5\nf 1 2 3\nf 1 3 4\n";
    let mut story = Story::start(&["builtin:gem"]);
    story.host.files.insert("far.obj".into(), far.into());
    story.host.drop_file("far.obj");
    story.settle();
    story.program.ui_mut().set_navigation(Navigation::Blender);
    let id = story.session().selected().unwrap();
    let place = |story: &Story| {
        let shape = story.session().scene().shape(id);
        shape.unwrap().placement.transform
    };
    let before = place(&story);
    for (keys, back) in [
        (
            &[Key::R, Key::Z, Key::Num9, Key::Num0, Key::Enter][..],
            Key::R,
        ),
        (&[Key::S, Key::Num2, Key::Enter], Key::S),
    ] {
        for &key in keys {
            story.key(key);
        }
        assert!(place(&story).position.distance(before.position) > 0.5);
        story.key_with(Modifiers::ALT, back);
        let after = place(&story);
        assert!(
            after.position.abs_diff_eq(before.position, 1e-5),
            "{after:?}"
        );
        assert_eq!(
            (after.rotation, after.scale),
            (before.rotation, before.scale)
        );
    }
}

#[test]
fn a_typed_turn_is_about_the_axis_that_one_looks_along_wherever_the_shape_is_in_the_picture() {
    for (direction, axis) in [
        (ViewDirection::PlusZ, Vec3::Z),
        (ViewDirection::PlusX, Vec3::X),
        (ViewDirection::PlusY, Vec3::Y),
    ] {
        let mut story = Story::start(&["builtin:gem"]);
        story.program.ui_mut().set_navigation(Navigation::Blender);
        let id = story.session().selected().unwrap();
        let mut aside = Camera::preset(direction);
        aside.target += Vec3::new(0.7, -0.4, 0.3);
        let seen = View::SetCamera(aside);
        story.program.session_mut().look(seen);
        story.settle();
        for key in [Key::R, Key::Num4, Key::Num5, Key::Enter] {
            story.key(key);
        }
        let shape = story.session().scene().shape(id).unwrap();
        let turned = shape.placement.transform.rotation.degrees();
        assert!(turned.abs().abs_diff_eq(45.0 * axis, 1e-3), "{turned}");
    }
}

#[test]
fn rings_at_a_joint_of_a_small_figure_do_not_reach_over_its_other_limbs() {
    let mut story = Story::start(&["builtin:adult"]);
    let id = story.session().selected().unwrap();
    let radius_and_height = |story: &Story| {
        let session = story.session();
        let size = story.view().size();
        let size = Vec2::new(size.x, size.y);
        let rings = RotationGizmo::new(session, id, 0, GizmoAxes::Local, size).unwrap();
        let bounds = session.evaluated().shape(id).unwrap().world_bounds();
        let [top, bottom] = [bounds.max.y, bounds.min.y].map(|y| {
            let middle = bounds.center().with_y(y);
            session.view().camera.pixel(middle, size).unwrap().y
        });
        (rings.free_radius(), bottom - top)
    };
    let (radius, height) = radius_and_height(&story);
    assert_eq!(radius, RotationGizmo::FREE_RADIUS, "of {height}");
    let mut away = story.session().view().camera;
    away.radius *= 2.5;
    story.program.session_mut().look(View::SetCamera(away));
    story.settle();
    let (radius, height) = radius_and_height(&story);
    assert!(radius < 0.4 * height, "{radius} of {height}");
}

#[test]
fn a_left_drag_keeps_what_it_takes_under_the_pointer_but_in_the_look_of_the_course() {
    let mut story = Story::start(&[]);
    story.key(Key::F3);
    story.key(Key::Num1);
    let start = story.pixel(Vec3::ZERO);
    story.drag_with(PointerButton::Primary, vec2(40.0, 30.0));
    let moved = story.pixel(Vec3::ZERO) - start;
    assert!(moved.distance(Vec2::new(40.0, 30.0)) < 0.5, "{moved}");
}

#[test]
fn a_turn_goes_with_the_pointer_or_in_the_course_against_it_and_the_wheel_brings_the_scene_nearer()
{
    // The course's editor has θ −= 0.005 dx and φ −= 0.005 dy: the eye follows the pointer.
    for (menu, button, sign) in [
        ("As the course's editor", PointerButton::Secondary, -1.0),
        ("Orbit", PointerButton::Primary, 1.0),
        ("Blender", PointerButton::Middle, 1.0),
    ] {
        let mut story = Story::start(&[]);
        story.click("View");
        story.click("Navigation");
        story.click(menu);
        story.key_with(Modifiers::NONE, Key::Home);
        let near = story.camera().eye() * 0.2;
        let before = story.pixel(near);
        story.drag_with(button, vec2(30.0, -24.0));
        let after = story.pixel(near);
        let moved = (after - before) * sign;
        assert!(moved.x > 2.0 && moved.y < -2.0, "{menu}: {moved}");
        let radius = story.camera().radius;
        story.wheel(1.0);
        assert!(
            story.camera().radius < radius,
            "{menu}: the wheel brings the scene nearer"
        );
    }
}

#[test]
fn fitting_fills_the_selected_shape_into_the_view_whatever_its_aspect() {
    // Lower than wide and wider than low: the strip is 0.4 wide and 2 high.
    let mut story = Story::start(&["models/strip.obj", "builtin:gem"]);
    let strip = story.session().scene().shapes()[0].id;
    story.key(Key::Num1);
    story.key(Key::F);
    let gem = story.camera();
    story.click_at_world(Vec3::new(0.0, 1.6, 0.0), strip);
    story.key(Key::F);
    assert_ne!(story.camera(), gem, "another shape, another place");
    let height = story.view().height();
    let (top, bottom) = (story.pixel(Vec3::Y * 2.0).y, story.pixel(Vec3::ZERO).y);
    assert!(top > 0.0 && bottom < height);
    let share = (bottom - top) / height;
    // Nine tenths of what the tool bar, and as much at the bottom, leave of it.
    let free = share * height / (height - 72.0);
    assert!((0.85..0.95).contains(&free), "{free} of the free height");
}

impl Story {
    /// Clicks what is drawn of a point of the world, and checks which shape that selects.
    fn click_at_world(&mut self, world: Vec3, shape: editor_core::scene::ShapeId) {
        self.key(Key::Home);
        self.key(Key::Num1);
        let pixel = self.pixel(world);
        let at = self.view().min + vec2(pixel.x, pixel.y);
        self.click_at(at);
        assert_eq!(self.session().selected(), Some(shape));
    }
}

/// What a key does, beyond what other stories show: the key, and whether it has happened.
type Effect = (Modifiers, Key, Command, fn(&Story) -> bool);

#[test]
fn every_key_of_the_views_tools_and_insert_menus_does_what_its_entry_says() {
    use editor_core::ui::Primitive;
    let (none, shift, ctrl) = (Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND);
    fn newest(story: &Story) -> &ShapeKind {
        &story
            .session()
            .scene()
            .shapes()
            .last()
            .expect("a shape")
            .kind
    }
    let effects: &[Effect] = &[
        (none, Key::F3, Command::SetLook(Look::Studio), |s| {
            s.session().view().look == Look::Studio
        }),
        (none, Key::F4, Command::ToggleGrid, |s| {
            !s.session().view().grid
        }),
        (none, Key::F2, Command::SetLook(Look::Course), |s| {
            s.session().view().look == Look::Course
        }),
        (none, Key::F6, Command::SetShading(Shading::Flat), |s| {
            s.session().view().shading == Shading::Flat
        }),
        (none, Key::F7, Command::SetShading(Shading::Smooth), |s| {
            s.session().view().shading == Shading::Smooth
        }),
        (
            none,
            Key::F5,
            Command::SetShading(Shading::AsAuthored),
            |s| s.session().view().shading == Shading::AsAuthored,
        ),
        (none, Key::T, Command::ToggleAxis, |s| {
            !s.session().view().axis
        }),
        (none, Key::H, Command::ToggleVisible, |s| !s.shape().visible),
        (shift, Key::L, Command::ToggleLocked, |s| s.shape().locked),
        (shift, Key::C, Command::Insert(Primitive::Cube), |s| {
            matches!(newest(s), ShapeKind::Cube)
        }),
        (shift, Key::S, Command::Insert(Primitive::Sphere), |s| {
            matches!(newest(s), ShapeKind::Sphere)
        }),
        (shift, Key::P, Command::Insert(Primitive::Pyramid), |s| {
            matches!(newest(s), ShapeKind::Pyramid)
        }),
        (shift, Key::T, Command::Insert(Primitive::Teapot), |s| {
            matches!(newest(s), ShapeKind::Teapot)
        }),
        (
            shift,
            Key::I,
            Command::Insert(Primitive::Icosahedron),
            |s| matches!(newest(s), ShapeKind::Icosahedron),
        ),
        (shift, Key::U, Command::Insert(Primitive::Custom), |s| {
            matches!(newest(s), ShapeKind::Custom)
        }),
        (
            shift,
            Key::B,
            Command::Insert(Primitive::BezierCurve),
            |s| s.shape().name == "Bézier Curve",
        ),
        (
            shift,
            Key::N,
            Command::Insert(Primitive::BSplineCurve),
            |s| s.shape().name == "B-Spline Curve",
        ),
        (shift, Key::O, Command::Insert(Primitive::Circle), |s| {
            s.shape().name == "Circle"
        }),
        (ctrl, Key::I, Command::ImportShape, |s| {
            s.asks_for("Import Shape")
        }),
        (
            ctrl.plus(Modifiers::ALT),
            Key::I,
            Command::ImportCurve,
            |s| s.asks_for("Import Curve"),
        ),
        (ctrl.plus(shift), Key::I, Command::ImportCharacter, |s| {
            s.asks_for("Import Character (.dae, or .obj with .skel and .attach beside it)")
        }),
        (ctrl.plus(shift), Key::E, Command::ExportGeometry, |s| {
            s.asks_for("Export Geometry of All Shapes")
        }),
        (none, Key::G, Command::SetTool(Tool::Move), |s| {
            s.has_selected("Move Tool")
        }),
        (none, Key::I, Command::SetTool(Tool::Ik), |s| {
            s.has_selected("IK Tool")
        }),
        (none, Key::V, Command::SetTool(Tool::Select), |s| {
            s.has_selected("Select Tool")
        }),
        (none, Key::F9, Command::Messages, |s| s.has("Messages")),
        (none, Key::F1, Command::Keys, |s| s.has("Keys and Mouse")),
    ];
    let mut story = Story::start(&["builtin:gem"]);
    let course = editor_core::editor::View::SetLook(Look::Course);
    story.program.session_mut().look(course);
    story
        .program
        .session_mut()
        .look(editor_core::editor::View::SetAxis(true));
    for (modifiers, key, command, has_happened) in effects {
        let entry = COMMANDS
            .iter()
            .find(|entry| entry.command == *command)
            .expect("an entry");
        let shortcut = entry
            .shortcuts
            .iter()
            .any(|shortcut| shortcut.logical_key == *key);
        assert!(shortcut, "{command:?} has another key");
        assert!(
            !has_happened(&story),
            "{command:?} has happened before its key"
        );
        story.key_with(*modifiers, *key);
        assert!(has_happened(&story), "{command:?} has not happened");
    }
}

impl Story {
    /// Whether the newest request for a file has this title.
    fn asks_for(&self, title: &str) -> bool {
        let newest = self.host.requests.last();
        newest.is_some_and(|request| request.purpose.title() == title)
    }

    /// Whether the button of that name is on.
    fn has_selected(&self, label: &str) -> bool {
        let node = self.node(label).expect("a button");
        node.is_selected() == Some(true) || node.toggled() == Some(egui::accesskit::Toggled::True)
    }
}

#[test]
fn the_panel_folds_away_leaves_a_handle_and_stays_so_at_the_next_start() {
    let mut story = Story::start(&["models/strip.obj"]);
    let narrow = story.view().width();
    story.key(Key::N);
    assert!(!story.has("Elbow Z"));
    let wide = story.view().width();
    assert!(wide > narrow + 200.0, "{narrow} {wide}");
    let again = crate::host::MemoryHost {
        stored: story.host.stored.clone(),
        ..crate::host::MemoryHost::default()
    };
    let mut next = Story::start_at(again, &["models/strip.obj"]);
    assert_eq!(next.view().width(), wide);
    next.click("Shape Panel");
    assert!(next.has("Elbow Z"));
    assert_eq!(next.view().width(), narrow);
}

#[test]
fn the_width_of_the_panel_is_kept_for_the_next_start() {
    let mut story = Story::start(&["models/strip.obj"]);
    let before = story.view();
    let edge = egui::pos2(before.right() + 1.0, before.center().y);
    story.drag(edge, edge - vec2(90.0, 0.0));
    let narrower = story.view().width();
    assert!((before.width() - narrower - 90.0).abs() < 4.0, "{narrower}");
    story.key_with(Modifiers::COMMAND, Key::Q);
    let again = crate::host::MemoryHost {
        stored: story.host.stored.clone(),
        ..crate::host::MemoryHost::default()
    };
    let next = Story::start_at(again, &["models/strip.obj"]);
    assert!((next.view().width() - narrower).abs() < 1.0);
}

#[test]
fn in_a_narrow_window_the_panel_is_a_sheet_below_the_view() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.size = (390, 700);
    story.settle();
    let (view, camera) = (story.view(), story.session().view().camera);
    assert!(!story.has("Elbow Z"), "it is closed at first");
    story.click("Shape Panel");
    let (smaller, field) = (story.view(), story.place("Rotation Y"));
    assert_eq!(smaller.min, view.min);
    assert_eq!(smaller.width(), view.width());
    assert!(smaller.height() > 0.4 * view.height());
    assert!(smaller.bottom() < field.y && field.y < view.bottom());
    story.drag(field, field + vec2(30.0, 0.0));
    assert_ne!(
        story.session().scene().shapes()[0]
            .placement
            .transform
            .rotation
            .radians
            .y,
        0.0
    );
    assert_eq!(story.session().view().camera, camera, "all of it is seen");
    story.click("Shape Panel");
    assert!(!story.has("Elbow Z"));
    assert_eq!(story.view(), view);
    // Windows that are wider have their panel beside the view.
    story.size = (1000, 640);
    story.settle();
    assert!(story.has("Elbow Z") && story.place("Elbow Z").x > story.view().right());
}

#[test]
fn the_sheet_is_as_high_as_its_handle_is_dragged_and_folds_at_the_bottom() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.size = (390, 700);
    story.settle();
    let view = story.view();
    for (y, unfolded) in [(400.0, true), (200.0, true), (690.0, false), (400.0, true)] {
        let handle = story.place("Shape Panel");
        story.drag(handle, egui::pos2(handle.x, y));
        assert_eq!(story.has("Elbow Z"), unfolded, "{y}");
        let handle = story.place("Shape Panel").y;
        if unfolded {
            assert!((handle - y).abs() < 8.0, "{handle} {y}");
        } else {
            assert_eq!(story.view(), view);
        }
    }
    // Something of the view is left however high the handle is taken.
    let handle = story.place("Shape Panel");
    story.drag(handle, egui::pos2(handle.x, 0.0));
    assert!(story.view().height() > 100.0);
}

#[test]
fn a_click_above_the_sheet_is_about_the_scene_and_leaves_the_sheet_open() {
    let mut story = Story::start(&["builtin:robot"]);
    story.size = (412, 780);
    story.settle();
    story.click("Shape Panel");
    let beside = story.view().left_center() + vec2(20.0, 0.0);
    story.click_at(beside);
    assert_eq!(story.session().selected(), None);
    assert!(story.has("Hide Robot"));
}

#[test]
fn the_size_of_the_window_is_kept_for_the_next_start_and_whether_it_was_maximized() {
    let mut story = Story::start(&[]);
    let kept = |story: &Story| last_window(&story.host.stored[&StorageKey::Preferences]);
    assert_eq!(kept(&story), LastWindow::default());
    // The size to which it goes back is the one before.
    story.host.is_maximized = true;
    story.size = (1400, 800);
    story.settle();
    story.key_with(Modifiers::COMMAND, Key::Q);
    assert!(story.host.quits);
    let last = LastWindow {
        size: Some((1000.0, 640.0)),
        is_maximized: true,
    };
    assert_eq!(kept(&story), last);
    story.host.is_maximized = false;
    story.size = (1200, 700);
    story.settle();
    story.key_with(Modifiers::COMMAND, Key::Q);
    let last = LastWindow {
        size: Some((1200.0, 700.0)),
        is_maximized: false,
    };
    assert_eq!(kept(&story), last);
    for odd in [&b"{}"[..], b"", br#"{"window_size": [1e9, 3]}"#] {
        assert_eq!(last_window(odd), LastWindow::default());
    }
}

#[test]
fn the_look_that_was_chosen_last_is_that_of_documents_without_one_of_their_own() {
    let mut story = Story::start(&[]);
    story.key(Key::F3);
    story.key_with(Modifiers::COMMAND, Key::N);
    assert_eq!(story.session().view().look, Look::Studio);
    let again = crate::host::MemoryHost {
        stored: story.host.stored.clone(),
        ..crate::host::MemoryHost::default()
    };
    let next = Story::start_at(again, &["models/strip.obj"]);
    assert_eq!(next.session().view().look, Look::Studio);
}

#[test]
fn preferences_are_chosen_in_one_window_kept_and_put_back_to_the_defaults() {
    let next_start = |story: &Story, files: &[&str]| {
        let host = crate::host::MemoryHost {
            stored: story.host.stored.clone(),
            ..crate::host::MemoryHost::default()
        };
        Story::start_at(host, files)
    };
    let mut story = Story::start(&[]);
    story.key_with(Modifiers::COMMAND, Key::Comma);
    for choice in [
        "Theme: Light",
        "New views: Mannequin",
        "Navigation: Blender",
        "Shown",
    ] {
        story.click(choice);
    }
    let mut next = next_start(&story, &["models/strip.obj"]);
    assert_eq!(next.session().view().look, Look::Mannequin);
    let ui = next.program.ui_mut();
    assert_eq!(
        (ui.theme, ui.navigation),
        (ThemePreference::Light, Navigation::Blender)
    );
    assert!(ui.panel_folded);

    next.key_with(Modifiers::COMMAND, Key::Comma);
    next.click("Reset to defaults");
    assert!(next.has("Theme: Light"), "the window stays");
    next.key(Key::Escape);
    assert!(!next.has("Theme: Light"));
    let mut last = next_start(&next, &["models/strip.obj"]);
    let look = last.session().view().look;
    assert_eq!(look, Look::Course, "that of such a character");
    let ui = last.program.ui_mut();
    assert_eq!(
        (ui.theme, ui.navigation),
        (ThemePreference::System, Navigation::default())
    );
    assert!(!ui.panel_folded);
}

#[test]
fn a_built_in_character_is_found_by_its_name_and_inserted() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    // A command mentions robots, but opens another document.
    story.frame(vec![Event::Text("robo".into())]);
    story.settle();
    story.key(Key::Enter);
    assert_eq!(story.names(), ["Strip", "Robot"]);

    // All of them are found by what they are, after commands.
    story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    story.frame(vec![Event::Text("character".into())]);
    story.settle();
    let [import, builtin] =
        ["Import Character…", "Built-in Character: Adult"].map(|label| story.place(label).y);
    assert!(import < builtin);

    // What a name only has in its midst, as a humanoid's, comes after commands, too.
    story.key(Key::Escape);
    story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    story.frame(vec![Event::Text("man".into())]);
    story.settle();
    let [look, builtin] =
        ["Look: Mannequin", "Built-in Character: Humanoid"].map(|label| story.place(label).y);
    assert!(look < builtin);
}

#[test]
fn a_command_is_found_by_its_name_and_run() {
    let mut story = Story::start(&["models/strip.obj"]);
    let find = Modifiers::COMMAND | Modifiers::SHIFT;
    story.key_with(find, Key::P);
    story.frame(vec![Event::Text("icosa".into())]);
    story.settle();
    story.key(Key::Enter);
    assert_eq!(story.names(), ["Strip", "Icosahedron"]);

    story.key_with(find, Key::P);
    story.frame(vec![Event::Text("add origin".into())]);
    story.settle();
    // The first is the cube, the next the sphere.
    story.key(Key::ArrowDown);
    story.key(Key::Enter);
    assert_eq!(story.names(), ["Strip", "Icosahedron", "Sphere"]);

    for (words, named) in [
        ("theme light", "Theme: Light"),
        ("course look", "Look: Course"),
        ("prefer", "Preferences…"),
    ] {
        story.key_with(find, Key::P);
        story.frame(vec![Event::Text(words.into())]);
        story.settle();
        assert!(story.has(named), "{words}");
        story.key(Key::Escape);
    }
    story.key_with(find, Key::P);
    story.key(Key::Escape);
    assert!(!story.has("Find a command"));
    assert!(story.session().selected().is_some(), "Esc did nothing else");
}

#[test]
fn of_a_command_that_cannot_be_run_the_search_says_why() {
    let mut story = Story::start(&[]);
    let why = "No character is selected.";
    story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    story.frame(vec![Event::Text("export character".into())]);
    story.settle();
    assert!(story.has_text(why));
    story.key(Key::Enter);
    assert!(story.has_text(why), "it stays open");
    assert!(!story.host.dialog_is_open);
}

#[test]
fn on_software_a_picture_that_moves_has_no_samples_and_the_full_one_comes_as_soon_as_it_rests() {
    let mut story = Story::start(&["models/strip.obj"]);
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(33.0, 0.0));
    let moving = story.scene_picture();
    // The drag goes on, but the hand rests.
    story.wait(0.1);
    let resting = story.scene_picture();
    let software = story.headless.gl().info().is_software;
    assert_eq!(differing(&moving, &resting) > 0, software);
    story.button(false);
    story.settle();
    assert_eq!(differing(&resting, &story.scene_picture()), 0);
    let kept = story.graphics.scene_picture().unwrap();
    assert_eq!(
        kept.samples() == 0,
        software,
        "samples take no memory at rest"
    );

    // Turning the camera moves everything.
    let middle = story.view().center();
    story.press_and_drag(middle, middle + vec2(50.0, 20.0));
    let moving = story.scene_picture();
    story.button(false);
    story.settle();
    assert_eq!(differing(&moving, &story.scene_picture()) > 0, software);
}

#[test]
fn the_course_look_says_why_shapes_are_dark_from_the_side_that_its_light_does_not_reach() {
    let mut story = Story::start(&["builtin:adult"]);
    for (from, says_so) in [(ViewDirection::PlusZ, false), (ViewDirection::MinusZ, true)] {
        let view = View::SetCamera(Camera::preset(from));
        story.program.session_mut().look(view);
        story.key(Key::F3);
        let before = story.messages().len();
        story.key(Key::F2);
        let told = story.messages();
        let is_told = told[before..]
            .iter()
            .any(|(_, text)| text.contains("from +Z"));
        assert_eq!(is_told, says_so, "{from:?} {told:?}");
    }
}
