//! Bones, roots and shapes turned and moved by hand in the view.

use crate::interface::{Editor, figure};
use editor_core::character::COURSE_JOINT_NAMES;
use editor_core::editor::{Edit, GizmoAxes, RotationGizmo, View};
use editor_core::math::Transform;
use editor_core::scene::NewShape;
use editor_core::scene::{CharacterDisplay, Look, ModelDisplay, ShapeKind, bones_in_world};
use editor_core::ui::Navigation;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2, vec2};
use glam::Vec3;

const ROOT: usize = 0;
const NECK: usize = 3;
const LEFT_SHOULDER: usize = 16;
const LEFT_ELBOW: usize = 17;

impl Editor {
    /// A character in a view whose pointer counts, with the tool of a key.
    pub fn with_hands(tool: Key) -> Self {
        let mut editor = Self::with_figure();
        editor.harness.state_mut().gestures = true;
        editor.key(tool);
        editor
    }

    /// Where a point of the world is in the window.
    pub fn place(&self, world: Vec3) -> Pos2 {
        let view = self.harness.state().view;
        let size = glam::vec2(view.width(), view.height());
        let camera = self.session().view().camera;
        let pixel = camera.pixel(world, size).expect("before the eye");
        view.min + vec2(pixel.x, pixel.y)
    }

    /// Where the ring about Z of `joint`, seen from +Z, is at an angle in degrees, counterclockwise from the right.
    fn on_ring(&self, joint: usize, degrees: f32) -> Pos2 {
        let view = self.harness.state().view;
        let size = glam::vec2(view.width(), view.height());
        let (session, shape) = (self.session(), self.shape().id);
        let rings = RotationGizmo::new(session, shape, joint, GizmoAxes::Local, size);
        let rings = rings.expect("it is before the eye");
        let radius = rings.ring(2)[0].pixel.distance(rings.center_pixel());
        self.place(self.bone(joint).0) + radius * Vec2::angled(-degrees.to_radians())
    }

    /// Both ends in the world of the first bone of a joint of the selected character.
    pub fn bone(&self, joint: usize) -> (Vec3, Vec3) {
        let session = self.session();
        let shape = self.shape().id;
        let evaluated = session.evaluated().shape(shape).expect("it is evaluated");
        let mut bones = bones_in_world(session.scene(), evaluated);
        let found = bones.find(|bone| bone.0 == joint);
        let (_, start, end) = found.expect("the joint has a bone");
        (start, end)
    }

    /// A point of the window on the first bone of a joint, near its end.
    pub fn on_bone(&self, joint: usize) -> Pos2 {
        let (start, end) = self.bone(joint);
        self.place(start.lerp(end, 0.7))
    }

    pub fn point(&mut self, at: Pos2) {
        self.harness.hover_at(at);
        self.settle();
    }

    pub fn take(&mut self, at: Pos2) {
        self.point(at);
        self.harness.drag_at(at);
        self.settle();
    }

    pub fn let_go(&mut self, at: Pos2) {
        self.harness.drop_at(at);
        self.settle();
    }

    pub fn hand(&mut self, from: Pos2, to: Pos2) {
        self.take(from);
        self.point(from + (to - from) * 0.5);
        self.point(to);
        self.let_go(to);
    }

    pub fn mouse(&mut self, button: PointerButton, pressed: bool, at: Pos2) {
        self.harness.event(Event::PointerButton {
            pos: at,
            button,
            pressed,
            modifiers: Modifiers::NONE,
        });
        self.settle();
    }

    pub fn click_at(&mut self, at: Pos2) {
        self.point(at);
        // A press that lasts long is no click.
        self.harness.drag_at(at);
        self.harness.step();
        self.let_go(at);
    }

    /// Displays the skeleton of the selected character with its mesh.
    fn show_skeleton(&mut self) {
        let display = CharacterDisplay {
            mode: ModelDisplay::Both,
            ..self.character().display
        };
        self.edit(Edit::SetDisplay(self.shape().id, display));
    }

    fn root_offset(&self, root: usize) -> Vec3 {
        self.character().pose().root_offset(root)
    }
}

/// How far `at` is from the half-line from `from` through `through`.
fn beside_half_line(at: Pos2, from: Pos2, through: Pos2) -> f32 {
    let along = (through - from).normalized();
    let offset = at - from;
    let beside = offset - along * offset.dot(along).max(0.0);
    beside.length()
}

#[test]
fn over_a_bone_the_status_line_names_the_key_that_poses_in_the_navigation() {
    let mut editor = Editor::with_hands(Key::V);
    editor.show_skeleton();
    for (navigation, key) in [(Navigation::Course, "B"), (Navigation::Blender, "J")] {
        editor.harness.state_mut().state.set_navigation(navigation);
        let at = editor.on_bone(LEFT_ELBOW);
        editor.point(at);
        let told = format!("Click to select the joint · the Pose tool ({key}) turns it by hand");
        assert!(editor.has(&told), "{told}");
    }
}

#[test]
fn a_joint_with_a_name_longer_than_the_view_is_dragged_like_any_other() {
    let mut names = COURSE_JOINT_NAMES;
    let long = "Left elbow ".repeat(30);
    names[LEFT_ELBOW] = &long;
    let mut editor = Editor::new();
    editor.add_character(figure::figure_called(&names));
    editor.harness.state_mut().gestures = true;
    editor.key(Key::B);
    let from = editor.on_bone(LEFT_ELBOW);
    editor.hand(from, from + vec2(-20.0, 60.0));
    assert!(editor.joint(LEFT_ELBOW) != Vec3::ZERO);
}

#[test]
fn dragging_a_bone_keeps_the_grabbed_point_in_line_with_the_pointer_and_the_sliders_follow() {
    let mut editor = Editor::with_hands(Key::B);
    let from = editor.on_bone(LEFT_ELBOW);
    let to = from + vec2(-20.0, 60.0);
    editor.hand(from, to);
    assert_eq!(editor.session().selected_joint(), Some(LEFT_ELBOW));
    let (start, end) = editor.bone(LEFT_ELBOW);
    let (start, end) = (editor.place(start), editor.place(end));
    let off = beside_half_line(end, start, to);
    assert!(off < 1.5, "the bone is {off} points beside the pointer");
    let shown = editor.value("Left elbow Z");
    let degrees: f32 = shown.trim_end_matches('°').parse().expect("a number");
    let turned = editor.joint(LEFT_ELBOW);
    assert!(
        turned.length() > 1.0 && (degrees.rem_euclid(360.0) - turned.z).abs() < 0.06,
        "{shown} {turned}"
    );
}

#[test]
fn the_way_of_the_pointer_between_start_and_end_does_not_matter() {
    let mut one = Editor::with_hands(Key::B);
    let from = one.on_bone(NECK);
    let to = from + vec2(50.0, 10.0);
    one.hand(from, to);
    let mut other = Editor::with_hands(Key::B);
    other.take(from);
    for at in [vec2(-80.0, 0.0), vec2(0.0, 130.0), vec2(90.0, 90.0)] {
        other.point(from + at);
    }
    other.point(to);
    other.let_go(to);
    let (one, other) = (one.character().pose(), other.character().pose());
    let (a, b) = (one.rotation(NECK).to_mat3(), other.rotation(NECK).to_mat3());
    assert!(a.abs_diff_eq(b, 1e-5), "{a} {b}");
}

#[test]
fn the_bone_stays_where_the_button_went_up_however_fast_the_pointer_goes_on() {
    let mut one = Editor::with_hands(Key::B);
    let from = one.on_bone(NECK);
    let to = from + vec2(50.0, 10.0);
    one.hand(from, to);
    let mut other = Editor::with_hands(Key::B);
    other.take(from);
    other.point(to);
    // All in one frame.
    other.harness.drop_at(to);
    other
        .harness
        .event(Event::PointerMoved(from - vec2(90.0, 0.0)));
    other.settle();
    let (one, other) = (one.character().pose(), other.character().pose());
    assert_eq!(one, other);
}

#[test]
fn esc_or_a_right_click_puts_everything_back_and_nothing_moves_until_all_buttons_are_up() {
    for right in [false, true] {
        let mut editor = Editor::with_hands(Key::B);
        editor.type_into("Left elbow Z", "30");
        let before = editor.character().pose().clone();
        let camera = editor.session().view().camera;
        let from = editor.on_bone(LEFT_ELBOW);
        let to = from + vec2(10.0, 70.0);
        editor.take(from);
        editor.point(to);
        assert_ne!(editor.character().pose(), &before);
        if right {
            editor.mouse(PointerButton::Secondary, true, to);
            editor.mouse(PointerButton::Secondary, false, to);
        } else {
            editor.key(Key::Escape);
        }
        assert_eq!(editor.character().pose(), &before);
        editor.point(to + vec2(30.0, 30.0));
        editor.let_go(to);
        assert_eq!(editor.character().pose(), &before);
        assert_eq!(editor.session().view().camera, camera);
        assert!(editor.asked().is_empty(), "Esc ends more than the gesture");
        editor.hand(from, to);
        assert_ne!(editor.character().pose(), &before, "the next gesture works");
    }
}

#[test]
fn a_bone_that_points_at_the_eye_and_is_short_in_the_picture_says_how_it_is_turned() {
    let mut editor = Editor::with_hands(Key::B);
    let (start, end) = editor.bone(LEFT_ELBOW);
    let height = editor.harness.state().view.height();
    // Of the same direction, the bone is short from afar and long enough for a hand from close by.
    for (raised, zoom, points_at_eye) in [
        (0.8, 1.0, false),
        (0.3, 1.0, true),
        (0.3, 0.08, false),
        (0.1, 0.08, true),
    ] {
        let mut camera = editor.session().view().camera;
        camera.target = start.midpoint(end);
        let mut camera = camera.facing(end - start, raised);
        camera.radius *= zoom;
        editor.view(View::SetCamera(camera));
        let at = editor.on_bone(LEFT_ELBOW);
        editor.point(at);
        assert_eq!(editor.session().hovered_joint(), Some(LEFT_ELBOW));
        let [from, to] = [start, end].map(|at| editor.place(at));
        let length = from.distance(to) / height;
        let painted = editor.painted_over_view();
        let says = |words: &str| painted.iter().any(|text| text.contains(words));
        assert_eq!(says("It points at you"), points_at_eye, "{raised} {length}");
        assert!(says("Left, Right roll"), "{painted:?}");
        camera.radius /= zoom;
        editor.view(View::SetCamera(camera));
    }
}

#[test]
fn ctrl_turns_a_bone_in_steps_of_15_degrees() {
    let mut editor = Editor::with_hands(Key::B);
    let from = editor.on_bone(LEFT_ELBOW);
    editor.take(from);
    editor
        .harness
        .event(Event::ModifiersChanged(Modifiers::COMMAND));
    editor.point(from + vec2(-15.0, 45.0));
    let (axis, angle) =
        glam::Quat::from_mat3(&editor.character().pose().rotation(LEFT_ELBOW).to_mat3())
            .to_axis_angle();
    let steps = angle.to_degrees() / 15.0;
    assert!(
        steps > 0.5 && (steps - steps.round()).abs() < 1e-3,
        "{axis} {angle}"
    );
}

#[test]
fn the_bone_under_the_pointer_is_marked_in_the_list_and_a_row_marks_its_bone() {
    let mut editor = Editor::with_hands(Key::B);
    let at = editor.on_bone(LEFT_ELBOW);
    editor.point(at);
    assert_eq!(editor.session().hovered_joint(), Some(LEFT_ELBOW));
    let empty = editor.harness.state().view.left_bottom() + vec2(20.0, -20.0);
    editor.point(empty);
    assert_eq!(editor.session().hovered_bone(), None);
    editor.reveal("Neck");
    editor.widget("Neck").hover();
    editor.settle();
    assert_eq!(editor.session().hovered_joint(), Some(NECK));
    editor.point(empty);
    assert_eq!(editor.session().hovered_joint(), None);
}

#[test]
fn the_marked_bone_stays_marked_while_it_is_dragged_over_others() {
    let mut editor = Editor::with_hands(Key::B);
    let from = editor.on_bone(LEFT_ELBOW);
    editor.take(from);
    let over = editor.on_bone(NECK);
    editor.point(over);
    assert_eq!(editor.session().hovered_joint(), Some(LEFT_ELBOW));
}

#[test]
fn left_and_right_roll_the_bone_under_the_pointer_about_itself() {
    let mut editor = Editor::with_hands(Key::B);
    let before = editor.bone(LEFT_ELBOW);
    let at = editor.on_bone(LEFT_ELBOW);
    editor.point(at);
    for _ in 0..3 {
        editor.key(Key::ArrowRight);
    }
    editor.key(Key::ArrowLeft);
    let rotation = editor.character().pose().rotation(LEFT_ELBOW).to_mat3();
    let (axis, angle) = glam::Quat::from_mat3(&rotation).to_axis_angle();
    assert!((angle - 0.2).abs() < 1e-5, "{angle}");
    let along = (before.1 - before.0).normalize_or(Vec3::X);
    assert!(axis.abs_diff_eq(along, 1e-4), "{axis} {along}");
    let after = editor.bone(LEFT_ELBOW);
    assert!(after.1.abs_diff_eq(before.1, 1e-5));
}

#[test]
fn keys_that_roll_the_bone_under_the_pointer_turn_the_camera_elsewhere_and_never_both() {
    let mut editor = Editor::with_hands(Key::B);
    let ui = &mut editor.harness.state_mut().state;
    ui.set_navigation(Navigation::Mannequin);
    let camera = editor.session().view().camera;
    let at = editor.on_bone(LEFT_ELBOW);
    editor.point(at);
    editor.key(Key::ArrowRight);
    assert!(!editor.character().pose().is_bind());
    assert_eq!(editor.session().view().camera, camera);
    editor.point(editor.harness.state().view.left_bottom() + vec2(20.0, -20.0));
    editor.view(View::SelectJoint(Some(LEFT_ELBOW)));
    let posed = editor.character().pose().clone();
    editor.key(Key::ArrowRight);
    assert_ne!(editor.session().view().camera, camera);
    assert_eq!(*editor.character().pose(), posed, "it is selected only");
}

#[test]
fn keys_that_turn_the_camera_go_on_until_the_pointer_moves_though_a_bone_comes_below_it() {
    let mut editor = Editor::with_hands(Key::B);
    let ui = &mut editor.harness.state_mut().state;
    ui.set_navigation(Navigation::Mannequin);
    let on_bone = editor.session().view().camera;
    let at = editor.on_bone(LEFT_ELBOW);
    let mut elsewhere = on_bone;
    elsewhere.target += Vec3::Y * 50.0;
    editor.view(View::SetCamera(elsewhere));
    editor.point(at);
    editor.key(Key::ArrowRight);
    assert_ne!(editor.session().view().camera, elsewhere);
    // As a turn of it brings the bone there.
    editor.view(View::SetCamera(on_bone));
    editor.key(Key::ArrowRight);
    assert!(editor.character().pose().is_bind());
    assert_ne!(editor.session().view().camera, on_bone);
    editor.view(View::SetCamera(on_bone));
    editor.point(at + vec2(1.0, 0.0));
    editor.key(Key::ArrowRight);
    assert!(!editor.character().pose().is_bind(), "it was pointed at");
    assert_eq!(editor.session().view().camera, on_bone);
}

#[test]
fn arrow_keys_elsewhere_do_not_roll() {
    let mut editor = Editor::with_hands(Key::B);
    editor.click("Left elbow");
    editor.key(Key::ArrowRight);
    assert!(
        editor.character().pose().is_bind(),
        "the pointer is over the list"
    );
    let at = editor.on_bone(NECK);
    editor.key(Key::V);
    editor.point(at);
    editor.key(Key::ArrowRight);
    assert!(
        editor.character().pose().is_bind(),
        "the Select tool does not pose"
    );
}

#[test]
fn a_left_drag_beside_bones_still_moves_the_camera() {
    let mut editor = Editor::with_hands(Key::B);
    let camera = editor.session().view().camera;
    let from = editor.harness.state().view.left_bottom() + vec2(30.0, -30.0);
    editor.hand(from, from + vec2(40.0, 0.0));
    assert_ne!(editor.session().view().camera, camera);
    assert!(editor.character().pose().is_bind());
}

#[test]
fn the_select_tool_moves_the_camera_on_bones_too_and_clicks_those_that_show() {
    let mut editor = Editor::with_hands(Key::V);
    let at = editor.on_bone(LEFT_ELBOW);
    editor.click_at(at);
    assert_eq!(
        editor.session().selected_joint(),
        None,
        "bones in a mesh do not show"
    );
    let id = editor.shape().id;
    let display = CharacterDisplay {
        mode: ModelDisplay::Skeleton,
        ..editor.character().display
    };
    editor.edit(Edit::SetDisplay(id, display));
    editor.click_at(at);
    assert_eq!(editor.session().selected_joint(), Some(LEFT_ELBOW));
    let camera = editor.session().view().camera;
    editor.hand(at, at + vec2(40.0, 20.0));
    assert!(editor.character().pose().is_bind());
    assert_ne!(editor.session().view().camera, camera);
}

#[test]
fn the_move_tool_moves_a_root_one_to_one_under_the_pointer() {
    let mut editor = Editor::with_hands(Key::G);
    editor.show_skeleton();
    let before = editor.bone(NECK).0;
    let from = editor.on_bone(NECK);
    let by = vec2(37.0, -21.0);
    // A gizmo that is nearer than the bone would be taken instead.
    editor.view(View::Select(None));
    editor.hand(from, from + by);
    assert_eq!(editor.session().selected_joint(), Some(ROOT));
    assert_ne!(editor.root_offset(ROOT), Vec3::ZERO);
    let after = editor.bone(NECK).0;
    assert!(
        (before.z - after.z).abs() < 1e-6,
        "in the plane of the view"
    );
    let moved = editor.place(after) - editor.place(before);
    assert!((moved - by).length() < 0.05, "{moved:?}");
    assert_eq!(editor.shape().placement.transform, Transform::default());
}

#[test]
fn the_move_tool_moves_a_mesh_as_a_whole_until_its_root_is_selected_or_the_look_shows_bones() {
    let mut editor = Editor::with_hands(Key::G);
    let id = editor.shape().id;
    let mut moves_root = |prepare: &dyn Fn(&mut Editor)| {
        let (neck, _) = editor.bone(NECK);
        let from = editor.place(neck);
        editor.view(View::Select(None));
        prepare(&mut editor);
        editor.hand(from, from + vec2(37.0, -21.0));
        editor.view(View::Select(Some(id)));
        let moved = editor.shape().placement.transform.position;
        let offset = editor.root_offset(ROOT);
        assert!(
            (moved == Vec3::ZERO) != (offset == Vec3::ZERO),
            "{moved} {offset}"
        );
        editor.edit(Edit::SetTransform(id, Transform::default()));
        editor.edit(Edit::ResetPose(id));
        offset != Vec3::ZERO
    };
    assert!(!moves_root(&|_| {}));
    assert!(moves_root(&|editor| {
        editor.view(View::Select(Some(id)));
        editor.view(View::SelectJoint(Some(ROOT)));
    }));
    assert!(!moves_root(&|editor| {
        editor.view(View::Select(Some(id)));
        editor.view(View::SelectJoint(Some(NECK)));
    }));
    assert!(moves_root(
        &|editor| editor.view(View::SetLook(Look::Mannequin))
    ));
    assert!(!moves_root(&|editor| editor.view(View::SetBones(false))));
}

#[test]
fn the_move_tool_moves_a_shape_one_to_one_and_esc_brings_it_back() {
    let mut editor = Editor::with_hands(Key::G);
    editor.edit(Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]));
    let id = editor.shape().id;
    let far = Transform {
        position: Vec3::new(-1.0, -0.8, 0.0),
        ..Transform::default()
    };
    editor.edit(Edit::SetTransform(id, far));
    editor.view(View::Select(None));
    let from = editor.place(far.position + Vec3::new(0.3, -0.3, 0.5));
    let by = vec2(-25.0, -40.0);
    editor.hand(from, from + by);
    assert_eq!(editor.session().selected(), Some(id));
    let position = editor.shape().placement.transform.position;
    let moved = editor.place(position) - editor.place(far.position);
    assert!((moved - by).length() < 0.05, "{moved:?}");
    let here = from + by;
    editor.take(here);
    editor.point(here + vec2(0.0, 60.0));
    assert_ne!(editor.shape().placement.transform.position, position);
    editor.key(Key::Escape);
    assert_eq!(editor.shape().placement.transform.position, position);
    editor.let_go(here);
}

#[test]
fn of_several_roots_one_moves_or_with_shift_all() {
    let mut editor = Editor::new();
    editor.add_character(figure::forest());
    editor.harness.state_mut().gestures = true;
    editor.key(Key::G);
    let by = vec2(0.0, -30.0);
    editor.view(View::Select(None));
    let from = editor.on_first_bone(1);
    editor.hand(from, from + by);
    let one = editor.root_offset(1);
    assert!(one.y > 0.0);
    assert_eq!(editor.root_offset(0), Vec3::ZERO, "the other stays");
    editor
        .harness
        .event(Event::ModifiersChanged(Modifiers::SHIFT));
    editor.view(View::Select(None));
    let from = editor.on_first_bone(1);
    editor.hand(from, from + by);
    let all = (editor.root_offset(0), editor.root_offset(1) - one);
    assert!(all.0.y > 0.0 && all.0.abs_diff_eq(all.1, 1e-6), "{all:?}");
}

#[test]
fn a_bone_of_a_character_that_is_not_selected_can_be_dragged_at_once() {
    let mut editor = Editor::with_hands(Key::B);
    let id = editor.shape().id;
    let from = editor.on_bone(LEFT_SHOULDER);
    editor.view(View::Select(None));
    editor.point(from);
    assert_eq!(editor.session().hovered_bone(), Some((id, LEFT_SHOULDER)));
    editor.hand(from, from + vec2(0.0, 50.0));
    assert_eq!(editor.session().selected(), Some(id));
    assert_eq!(editor.session().selected_joint(), Some(LEFT_SHOULDER));
    assert!(!editor.character().pose().is_bind());
}

impl Editor {
    /// On the bone of `joint`, of the only character, selected or not.
    fn on_first_bone(&self, joint: usize) -> Pos2 {
        let session = self.session();
        let evaluated = &session.evaluated().shapes[0];
        let mut bones = bones_in_world(session.scene(), evaluated);
        let found = bones.find(|bone| bone.0 == joint);
        let (_, start, end) = found.expect("the joint has a bone");
        self.place(start.lerp(end, 0.7))
    }
}

#[test]
fn a_click_on_a_bone_shows_rings_that_turn_it_about_one_axis() {
    let mut editor = Editor::with_hands(Key::B);
    let at = editor.on_bone(LEFT_ELBOW);
    editor.click_at(at);
    assert_eq!(editor.session().selected_joint(), Some(LEFT_ELBOW));
    // Seen from +Z the ring about Z is a circle about the joint.
    let [from, to] = [80.0, 110.0].map(|degrees| editor.on_ring(LEFT_ELBOW, degrees));
    editor.hand(from, to);
    let turned = editor.joint(LEFT_ELBOW);
    assert!(
        turned.abs_diff_eq(Vec3::new(0.0, 0.0, 30.0), 1.5),
        "{turned}"
    );
}

#[test]
fn arrows_move_a_shape_along_one_axis() {
    let mut editor = Editor::with_hands(Key::G);
    editor.edit(Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]));
    let middle = editor.place(Vec3::ZERO);
    editor.hand(middle + vec2(60.0, 0.0), middle + vec2(110.0, 0.0));
    let position = editor.shape().placement.transform.position;
    assert_eq!((position.y, position.z), (0.0, 0.0));
    let moved = editor.place(position) - middle;
    assert!((moved.x - 50.0).abs() < 0.05, "{moved:?}");
}

#[test]
fn where_bones_show_the_middle_of_a_figures_arrows_is_the_root_that_it_lies_over() {
    let mut editor = Editor::with_hands(Key::G);
    let id = editor.shape().id;
    let middle = editor.place(Vec3::ZERO);
    for shows_bones in [false, true] {
        if shows_bones {
            editor.show_skeleton();
        }
        editor.view(View::Select(Some(id)));
        editor.view(View::SelectJoint(None));
        editor.hand(middle, middle + vec2(30.0, -20.0));
        let moved = editor.shape().placement.transform.position;
        let offset = editor.root_offset(ROOT);
        assert_eq!(
            (moved != Vec3::ZERO, offset != Vec3::ZERO),
            (!shows_bones, shows_bones),
            "{moved} {offset}"
        );
        editor.edit(Edit::SetTransform(id, Transform::default()));
    }
}

#[test]
fn the_tools_have_buttons_keys_and_a_menu() {
    let mut editor = Editor::with_figure();
    for (key, label) in [
        (Key::B, "Pose Tool"),
        (Key::G, "Move Tool"),
        (Key::V, "Select Tool"),
    ] {
        editor.key(key);
        editor.click(label);
        editor.choose(&["Pose", label]);
    }
}

#[test]
fn the_move_tool_names_the_root_that_moves_and_not_the_bone_under_the_hand() {
    let mut editor = Editor::with_hands(Key::G);
    editor.show_skeleton();
    let from = editor.on_bone(LEFT_ELBOW);
    editor.point(from);
    let names = |editor: &Editor, name: &str| {
        let texts = editor.painted_over_view();
        texts.iter().filter(|&text| text == name).count()
    };
    assert_eq!(
        (names(&editor, "Root"), names(&editor, "Left elbow")),
        (1, 0)
    );
    editor.take(from);
    editor.point(from + vec2(20.0, 10.0));
    // Beside the pointer and in the status line.
    assert_eq!(
        (names(&editor, "Root"), names(&editor, "Left elbow")),
        (2, 0)
    );
}

#[test]
fn with_shift_the_arrows_of_a_root_move_every_root() {
    let mut editor = Editor::new();
    editor.add_character(figure::forest());
    editor.harness.state_mut().gestures = true;
    editor.key(Key::G);
    editor.view(View::SelectJoint(Some(1)));
    let from = editor.place(Vec3::X * 0.5) + vec2(60.0, 0.0);
    editor
        .harness
        .event(Event::ModifiersChanged(Modifiers::SHIFT));
    editor.hand(from, from + vec2(50.0, 0.0));
    let (one, other) = (editor.root_offset(1), editor.root_offset(0));
    assert!(one.x > 0.1 && one.with_x(0.0) == Vec3::ZERO, "{one}");
    assert_eq!(one, other);
}

#[test]
fn of_the_bones_of_a_joint_the_one_that_was_clicked_is_rolled() {
    const WAIST: usize = 2;
    let mut editor = Editor::with_hands(Key::B);
    let session = editor.session();
    let evaluated = &session.evaluated().shapes[0];
    let bones = bones_in_world(session.scene(), evaluated);
    let ends: Vec<_> = bones.filter(|bone| bone.0 == WAIST).collect();
    assert_eq!(ends.len(), 2, "to the right and to the left hip");
    for (_, start, end) in ends {
        // Without rings in the way.
        editor.view(View::SelectJoint(None));
        let at = editor.place(start.lerp(end, 0.7));
        editor.click_at(at);
        assert_eq!(editor.session().selected_joint(), Some(WAIST));
        editor.point(editor.harness.state().view.left_bottom() + vec2(20.0, -20.0));
        editor.key(Key::ArrowRight);
        let rotation = editor.character().pose().rotation(WAIST).to_mat3();
        let along = end - start;
        assert!((rotation * along).abs_diff_eq(along, 1e-5), "{along}");
        assert!(!editor.character().pose().is_bind());
        editor.key(Key::ArrowLeft);
    }
}

#[test]
fn a_joint_clicked_in_the_list_shows_its_rings_though_its_bone_was_just_turned() {
    let mut editor = Editor::with_hands(Key::B);
    let from = editor.on_bone(LEFT_ELBOW);
    editor.hand(from, from + vec2(-20.0, 60.0));
    editor.click("Reset Left elbow");
    editor.click("Left elbow");
    let [from, to] = [80.0, 110.0].map(|degrees| editor.on_ring(LEFT_ELBOW, degrees));
    editor.hand(from, to);
    let turned = editor.joint(LEFT_ELBOW);
    let expected = Vec3::new(0.0, 0.0, 30.0);
    assert!(turned.abs_diff_eq(expected, 1.5), "{turned}");
}

#[test]
fn the_angle_beside_the_pointer_has_the_sign_of_the_number_in_the_panel() {
    for by in [vec2(-20.0, 60.0), vec2(10.0, -60.0)] {
        let mut editor = Editor::with_hands(Key::B);
        let before = editor.character().pose().rotation(LEFT_ELBOW).degrees();
        let from = editor.on_bone(LEFT_ELBOW);
        editor.take(from);
        editor.point(from + by);
        let turned = editor.character().pose().rotation(LEFT_ELBOW).degrees() - before;
        let most = turned[turned.abs().max_position()];
        let painted = editor.painted_over_view();
        let label = painted.iter().find_map(|text| text.strip_suffix('°'));
        let label: f32 = label.expect("a readout").parse().expect("a number");
        assert!(
            label.signum() == most.signum() && label != 0.0,
            "{label} {turned}"
        );
        editor.let_go(from + by);
    }
}

#[test]
fn a_number_typed_while_a_bone_is_dragged_is_shown_and_turns_it_by_exactly_that() {
    let mut editor = Editor::with_hands(Key::B);
    let from = editor.on_bone(LEFT_ELBOW);
    editor.take(from);
    editor.point(from + vec2(-20.0, 60.0));
    for key in [Key::Z, Key::Num4, Key::Num5, Key::Period, Key::Num5] {
        editor.key(key);
    }
    let painted = editor.painted_over_view();
    assert!(painted.iter().any(|text| text == "z 45.5|°"), "{painted:?}");
    editor.key(Key::Enter);
    let turned = editor.joint(LEFT_ELBOW);
    editor.point(from + vec2(50.0, 10.0));
    assert_eq!(editor.joint(LEFT_ELBOW), turned, "Enter has ended it");
    editor.let_go(from);
    let matrix = editor.character().pose().rotation(LEFT_ELBOW).to_mat3();
    let (_, angle) = glam::Quat::from_mat3(&matrix).to_axis_angle();
    assert!((angle.to_degrees() - 45.5).abs() < 1e-2, "{turned}");
    assert_eq!(editor.session().done_steps(), 2);
}

#[test]
fn thin_lines_for_bones_stand_out_from_a_light_background_as_from_a_dark_one() {
    use editor_core::scene::Look;
    let mut editor = Editor::with_figure();
    editor.click("Pose Tool");
    let brightness = |editor: &Editor| {
        let shapes = editor.harness.output().shapes.iter();
        let thin = shapes.filter_map(|clipped| match &clipped.shape {
            egui::Shape::LineSegment { stroke, .. } if stroke.width == 1.5 => Some(stroke.color),
            _ => None,
        });
        let colors: Vec<egui::Color32> = thin.collect();
        assert!(colors.len() > 10, "the bones of the figure");
        let [r, g, b, _] = colors[0].to_srgba_unmultiplied();
        r.max(g).max(b)
    };
    for (theme, look, is_light_line) in [
        ("Dark", Look::Studio, true),
        ("Light", Look::Studio, false),
        // Its background is dark whatever the theme.
        ("Light", Look::Course, true),
    ] {
        editor.choose(&["View", "Theme", theme]);
        editor.view(View::SetLook(look));
        let found = brightness(&editor);
        assert_eq!(found > 200, is_light_line, "{theme}, {look:?}: {found}");
        assert!(is_light_line || found < 80, "{theme}, {look:?}: {found}");
    }
}
