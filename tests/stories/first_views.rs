//! The first view of what is opened and imported: the look, the colors and the camera.

use super::Story;
use crate::host::MemoryHost;
use editor_core::editor::{Edit, View};
use editor_core::io::image::{self, PictureFormat};
use editor_core::math::Euler;
use editor_core::program::StorageKey;
use editor_core::scene::{Camera, Look, Shape, ShapeColor};
use editor_core::ui::{Action, Ask, Navigation};
use egui::{Event, Key, Modifiers, PointerButton, pos2, vec2};
use glam::{Vec2, Vec3};
use std::path::Path;

const GREEN: ShapeColor = ShapeColor::Preset(12);

/// A strip like [`super::STRIP`], ten times as large, whose left hand is at −X: it faces −Z.
const LARGE: [(&str, &str); 3] = [
    (
        "models/large.obj",
        "v -2 0 0\nv 2 0 0\nv 2 20 0\nv -2 20 0\nf 1 2 3\nf 1 3 4\n",
    ),
    (
        "models/large.skel",
        "0 0 0 -1 # Root\n-2 5 0 0 # Hand.L\n2 5 0 0 # Hand.R\n",
    ),
    ("models/large.attach", "1 0\n0 1\n0 1\n1 0\n"),
];

/// A triangle far to the right.
const FAR: (&str, &str) = ("models/far.obj", "v 90 0 0\nv 91 0 0\nv 90 1 0\nf 1 2 3\n");

fn host() -> MemoryHost {
    let files = LARGE.into_iter().chain([FAR]);
    let mut host = MemoryHost {
        stored: [super::started_before()].into(),
        files: files
            .map(|(path, text)| (path.into(), text.into()))
            .collect(),
        ..MemoryHost::default()
    };
    // The course's background.
    let reference = editor_core::geometry::Picture {
        width: 40,
        height: 30,
        rgba: [26, 26, 26, 255].repeat(40 * 30),
    };
    let bytes = image::encode(&reference, PictureFormat::Png).expect("a picture");
    host.files.insert("reference.png".into(), bytes);
    host
}

fn start(files: &[&str]) -> Story {
    Story::start_at(host(), files)
}

#[test]
fn what_is_inserted_beside_a_figure_stands_on_its_ground_and_all_of_it_is_seen() {
    let mut story = Story::start(&["builtin:showcase"]);
    let ground = |story: &Story| {
        let evaluated = &story.session().evaluated().shapes;
        let lowest = evaluated.iter().map(|shape| shape.world_bounds().min.y);
        lowest.fold(f32::INFINITY, f32::min)
    };
    let before = ground(&story);
    story.key_with(Modifiers::SHIFT, Key::C);
    let cube = story.shape().placement.transform;
    assert!((cube.position.y - 0.5 - before).abs() < 1e-4, "{cube:?}");
    // Its control points are not hidden below the ground either.
    story.key_with(Modifiers::SHIFT, Key::N);
    assert!(story.shape().placement.transform.position.y > 0.5);
    assert!((ground(&story) - before).abs() < 1e-4);
    // In the course's look there is no ground, and the place is the course's.
    story.key(Key::F2);
    story.key_with(Modifiers::SHIFT, Key::C);
    assert_eq!(story.shape().placement.transform.position, Vec3::ZERO);

    // Nor does it hang above the ground of a figure whose feet are lower than it would be.
    let mut story = Story::start(&["builtin:adult"]);
    let before = ground(&story);
    assert!(before < -0.55, "{before}");
    story.key_with(Modifiers::SHIFT, Key::C);
    let cube = story.shape().placement.transform;
    assert!((cube.position.y - 0.5 - before).abs() < 1e-4, "{cube:?}");
}

#[test]
fn shapes_that_are_inserted_one_after_the_other_stand_beside_each_other_unless_the_look_is_the_course_s()
 {
    for (look, is_apart) in [(Key::F3, true), (Key::F2, false)] {
        let mut story = Story::start(&[]);
        story.key(look);
        for key in [Key::C, Key::S, Key::P] {
            story.key_with(Modifiers::SHIFT, key);
        }
        let shapes = story.session().scene().shapes().iter();
        let places: Vec<f32> = shapes
            .map(|shape| shape.placement.transform.position.x)
            .collect();
        let are_apart = places.windows(2).all(|pair| pair[1] > pair[0] + 0.9);
        assert_eq!(are_apart, is_apart, "{places:?}");
        assert!(is_apart || places == [0.0; 3], "{places:?}");
    }
}

#[test]
fn a_figure_that_is_inserted_stands_on_the_ground_of_the_shapes_that_are_there() {
    let mut story = Story::start(&["builtin:gear"]);
    let lowest = |story: &Story, at: usize| {
        let shown = &story.session().evaluated().shapes[at];
        shown.world_bounds().min.y
    };
    let ground = lowest(&story, 0);
    story.click("Insert");
    story.click("Built-in Character");
    story.click("Adult");
    assert!((lowest(&story, 1) - ground).abs() < 1e-4, "at its hips");
    // In the course's look it is where the course's editor has it.
    story.key_with(Modifiers::COMMAND, Key::Z);
    story.key(Key::F2);
    story.click("Insert");
    story.click("Built-in Character");
    story.click("Adult");
    assert!(lowest(&story, 1) < ground - 0.3);
}

#[test]
fn the_view_that_is_fitted_to_what_is_added_comes_back_when_that_is_taken_back() {
    let mut story = Story::start(&["builtin:robot"]);
    let framed = Camera {
        theta: 0.4,
        radius: 1.0,
        ..story.session().view().camera
    };
    let camera = |story: &Story| story.session().view().camera;
    let look_at = |story: &mut Story, camera| {
        story.program.session_mut().look(View::SetCamera(camera));
        story.settle();
    };
    let start = *story.session().start_camera();
    look_at(&mut story, framed);
    let add_curve = |story: &mut Story| {
        story.key_with(Modifiers::SHIFT, Key::N);
        assert_ne!(camera(story), framed, "it would not be seen");
    };
    add_curve(&mut story);
    // Also after other steps.
    story.type_into("Position X", "3");
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_ne!(camera(&story), framed);
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(story.names().len(), 1);
    assert_eq!(camera(&story), framed);
    assert_eq!(*story.session().start_camera(), start);
    // Who has moved the camera since wants it there.
    add_curve(&mut story);
    let moved = Camera {
        radius: 2.0,
        ..framed
    };
    look_at(&mut story, moved);
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(camera(&story), moved);
}

#[test]
fn a_figure_that_would_fill_the_view_is_seen_whole() {
    let mut story = Story::start(&["builtin:dog"]);
    let mut camera = story.session().view().camera;
    // From where the next one is going to stand.
    camera = camera.facing(Vec3::new(1.0, 0.0, 0.8), 0.2);
    story.program.session_mut().look(View::SetCamera(camera));
    story.settle();
    story.click("Insert");
    story.click("Built-in Character");
    story.click("Adult");
    let bounds = story.session().evaluated().shapes[1].world_bounds();
    let view = story.view();
    let seen = story
        .session()
        .view()
        .camera
        .seen_part(&bounds, view.width() / view.height());
    assert!(seen > 0.94, "{seen}");
}

#[test]
fn a_figure_whose_head_would_be_out_of_the_picture_is_seen_whole() {
    let mut story = Story::start(&["builtin:adult"]);
    let bounds = story.session().evaluated().shapes[0].world_bounds();
    let fitted = story.session().view().camera;
    let camera = Camera {
        // Its shoulders are at the upper edge, and there is room on both sides.
        target: bounds.center() - 0.52 * bounds.size().y * Vec3::Y,
        radius: 1.6 * fitted.radius,
        ..fitted
    };
    story.program.session_mut().look(View::SetCamera(camera));
    story.settle();
    let view = story.view();
    let aspect = view.width() / view.height();
    let seen = |story: &Story, at: usize| {
        let bounds = story.session().evaluated().shapes[at].world_bounds();
        story.session().view().camera.seen_part(&bounds, aspect)
    };
    let before = seen(&story, 0);
    assert!((0.75..0.95).contains(&before), "{before}");
    story.click("Insert");
    story.click("Built-in Character");
    story.click("Adult");
    assert!(seen(&story, 1) > 0.99);
}

#[test]
fn in_the_mannequin_look_a_figure_that_is_imported_is_only_set_aside() {
    let mut story = start(&["builtin:adult"]);
    let look = View::SetLook(Look::Mannequin);
    story.program.session_mut().look(look);
    // The one shows its back, and the other has its feet elsewhere.
    for name in ["models/large.obj", "builtin:robot"] {
        story.import(name);
        let transform = story.shape().placement.transform;
        assert_eq!(transform.rotation, Euler::ZERO, "{name}");
        assert_eq!(transform.position.y, 0.0, "{name}");
        assert_ne!(transform.position, Vec3::ZERO, "{name}");
    }
}

#[test]
fn a_figure_that_is_inserted_while_the_other_is_seen_from_its_side_stands_across_the_view() {
    for (from, is_along_z) in [(Vec3::X, true), (Vec3::NEG_X, true), (Vec3::Z, false)] {
        let mut story = Story::start(&["builtin:adult"]);
        let camera = story.session().view().camera.facing(from, 0.2);
        story.program.session_mut().look(View::SetCamera(camera));
        story.settle();
        story.click("Insert");
        story.click("Built-in Character");
        story.click("Dog");
        let bounds = |at: usize| story.session().evaluated().shapes[at].world_bounds();
        let (adult, dog) = (bounds(0), bounds(1));
        let gap = dog.min - adult.max;
        assert_eq!(
            (gap.z > 0.0, gap.x > 0.0),
            (is_along_z, !is_along_z),
            "{from}"
        );
    }
}

/// A box without a front, from −3 to 3 and up to 6, closed or open toward +Z.
fn room(is_open: bool) -> String {
    let mut text = String::new();
    for corner in 0..8 {
        let at = |bit: usize, low: f32, high: f32| if corner >> bit & 1 == 1 { high } else { low };
        text += &format!(
            "v {} {} {}\n",
            at(0, -3.0, 3.0),
            at(1, -1.0, 6.0),
            at(2, -3.0, 3.0)
        );
    }
    text += "f 1 3 4 2\nf 1 2 6 5\nf 1 5 7 3\nf 2 4 8 6\n";
    if !is_open {
        text += "f 3 7 8 4\nf 5 6 8 7\n";
    }
    text
}

#[test]
fn a_shape_that_is_imported_is_set_beside_a_character_that_it_would_hide_and_seen_whole() {
    for (is_open, look, theta) in [
        (false, Key::F3, 90.0_f32),
        (false, Key::F3, 45.0),
        (false, Key::F2, 90.0),
        (true, Key::F3, 90.0),
    ] {
        let mut story = start(&["builtin:adult"]);
        story.key(look);
        let mut camera = story.session().view().camera;
        camera.theta = theta.to_radians();
        story.program.session_mut().look(View::SetCamera(camera));
        let room = room(is_open).into_bytes();
        story.host.files.insert("models/room.obj".into(), room);
        // Near to the figure, in the room.
        story.key(Key::F);
        story.import("models/room.obj");
        let shapes = &story.session().evaluated().shapes;
        let [adult, room] = [&shapes[0], &shapes[1]].map(|shape| shape.world_bounds());
        let messages = story.messages();
        let mut texts = messages.iter().map(|(_, text)| text);
        let is_told = texts.any(|text| text.starts_with("Room is set beside the character"));
        assert_eq!(is_told, !is_open, "{messages:?}");
        if is_open {
            assert_eq!(story.shape().placement.transform.position, Vec3::ZERO);
            continue;
        }
        assert!(room.min.x > adult.max.x, "{look:?}: {room:?}");
        let view = egui::Rect::from_min_size(pos2(0.0, 0.0), story.view().size());
        for shape in story.session().scene().shapes() {
            assert!(
                view.contains_rect(story.on_screen(shape)),
                "{look:?}: {}",
                shape.name
            );
        }
    }
}

#[test]
fn a_character_is_set_beside_a_shape_that_would_hide_it_and_into_an_open_one() {
    for is_open in [false, true] {
        let mut host = host();
        let room = room(is_open).into_bytes();
        host.files.insert("models/room.obj".into(), room);
        let mut story = Story::start_at(host, &["models/room.obj"]);
        let ask = Action::Ask(Ask::InsertBuiltin("adult"));
        story.program.carry_out(vec![ask], &mut story.host);
        story.settle();
        let shapes = &story.session().evaluated().shapes;
        let [room, adult] = [&shapes[0], &shapes[1]].map(|shape| shape.world_bounds());
        assert_eq!(adult.min.x > room.max.x, !is_open, "{adult:?} {room:?}");
    }
}

#[test]
fn a_character_beside_a_shape_that_hovers_stands_on_the_ground_below_that() {
    let mut story = start(&["models/far.obj"]);
    story.key(Key::F3);
    let id = story.shape().id;
    let mut transform = story.shape().placement.transform;
    transform.position.y += 30.0;
    let edit = Edit::SetTransform(id, transform);
    story.program.session_mut().edit(edit).expect("a place");
    story.settle();
    story.import("models/large.obj");
    let lowest = |at: usize| story.session().evaluated().shapes[at].world_bounds().min.y;
    assert!(lowest(0) > 20.0, "it is left where it was put");
    assert!(lowest(1).abs() < 1e-3, "{}", lowest(1));
}

#[test]
fn a_character_that_its_file_has_in_the_air_beside_others_stands_on_their_ground() {
    /// [`LARGE`], 25 higher.
    const UP: [(&str, &str); 3] = [
        (
            "models/up.obj",
            "v -2 25 0\nv 2 25 0\nv 2 45 0\nv -2 45 0\nf 1 2 3\nf 1 3 4\n",
        ),
        (
            "models/up.skel",
            "0 25 0 -1 # Root\n-2 5 0 0 # Hand.L\n2 5 0 0 # Hand.R\n",
        ),
        ("models/up.attach", LARGE[2].1),
    ];
    for (at_x, is_let_down) in [(40.0, true), (0.0, false)] {
        let mut host = host();
        let up = UP.map(|(path, text)| (path.into(), text.into()));
        host.files.extend(up);
        let mut story = Story::start_at(host, &["models/large.obj"]);
        story.key(Key::F3);
        let id = story.shape().id;
        let mut transform = story.shape().placement.transform;
        transform.position.x = at_x;
        let edit = Edit::SetTransform(id, transform);
        story.program.session_mut().edit(edit).expect("a place");
        story.settle();
        story.import("models/up.obj");
        let lowest = |at: usize| story.session().evaluated().shapes[at].world_bounds().min.y;
        let above = lowest(1) - lowest(0);
        // What is above another stays there, as a rider does.
        let expected = if is_let_down { 0.0 } else { 25.0 };
        assert!((above - expected).abs() < 1e-3, "{above}");
    }
}

#[test]
fn a_deep_figure_that_is_imported_beside_another_does_not_hide_it() {
    let [robot, cubes] = ["robot", "long_cubes"].map(|name| {
        let path = crate::reference_data::reference(&format!("mannequin/{name}.dae"))?;
        Some((name, std::fs::read(path).unwrap()))
    });
    let (Some(robot), Some(cubes)) = (robot, cubes) else {
        return;
    };
    let files = [robot, cubes].map(|(name, bytes)| (format!("{name}.dae").into(), bytes));
    let host = crate::host::MemoryHost {
        files: files.into(),
        stored: [crate::stories::started_before()].into(),
        ..Default::default()
    };
    let mut story = Story::start_at(host, &["robot.dae"]);
    story.import("long_cubes.dae");
    let front = story.session().scene().shapes()[0].front().unwrap();
    assert!(story.seen_from(front) > 0.95, "as before");
    let shapes = story.session().scene().shapes();
    let [robot, cubes] = [&shapes[0], &shapes[1]].map(|shape| story.on_screen(shape));
    assert!(
        robot.intersect(cubes).width() < 0.2 * robot.width(),
        "{robot} {cubes}"
    );
}

#[test]
fn what_is_inserted_stands_beside_the_figure_that_would_hide_it() {
    for key in [Key::C, Key::S, Key::P] {
        let mut story = Story::start(&["builtin:adult"]);
        story.key_with(Modifiers::SHIFT, key);
        let bounds = |at: usize| story.session().evaluated().shapes[at].world_bounds();
        assert!(bounds(1).min.x > bounds(0).max.x, "{key:?}");
    }
    // Nothing hides it in an empty document.
    let mut story = Story::start(&[]);
    story.key(Key::F3);
    story.key_with(Modifiers::SHIFT, Key::C);
    assert_eq!(story.shape().placement.transform.position, Vec3::ZERO);
}

#[test]
fn a_copy_that_would_be_out_of_sight_is_brought_into_the_view() {
    let mut story = Story::start(&["builtin:gem"]);
    let is_seen = |story: &Story| {
        let session = story.session();
        let copy = session.evaluated().shapes.last().expect("a shape");
        let view = story.view();
        let aspect = view.width() / view.height();
        let camera = session.view().camera;
        camera.sees(&copy.world_bounds(), aspect, |ray| copy.is_met_by(ray))
    };
    let camera = story.session().view().camera;
    story.key_with(Modifiers::COMMAND, Key::D);
    assert!(is_seen(&story));
    for _ in 0..8 {
        story.key_with(Modifiers::COMMAND, Key::D);
        assert!(is_seen(&story));
    }
    assert_ne!(story.session().view().camera, camera);
}

impl Story {
    fn look(&self) -> Look {
        self.session().view().look
    }

    fn color(&self) -> ShapeColor {
        self.shape().placement.color
    }

    fn import(&mut self, path: &str) {
        self.host.drop_file(path);
        self.settle();
    }

    /// The rectangle that a shape takes up in the view, in points from the view's corner.
    fn on_screen(&self, shape: &Shape) -> egui::Rect {
        egui::Rect::from_points(&self.pixels(shape).collect::<Vec<_>>())
    }

    /// Where the vertices of a shape are in the view, in points from the view's corner.
    fn pixels(&self, shape: &Shape) -> impl Iterator<Item = egui::Pos2> {
        let view = self.view();
        let size = Vec2::new(view.width(), view.height());
        let camera = self.session().view().camera;
        let evaluated = self
            .session()
            .evaluated()
            .shape(shape.id)
            .expect("it is evaluated");
        evaluated.geometry.positions().iter().map(move |&position| {
            let world = evaluated.world_from_model.transform_point3(position);
            let pixel = camera.pixel(world, size).expect("before the eye");
            pos2(pixel.x, pixel.y)
        })
    }

    /// Checks that the selected shape is whole in the view, clear of the tool bar, and as large as
    /// there is room.
    fn assert_fills_the_view(&self) {
        let (rect, view) = (self.on_screen(self.shape()), self.view());
        let bar = self.place("Select Tool").y + 12.0 - view.top();
        let is_inside = rect.left() >= 0.0 && rect.right() <= view.width();
        assert!(is_inside && rect.top() > bar, "{rect:?} in {view:?}");
        assert!(rect.bottom() < view.height() - bar / 2.0, "{rect:?}");
        let share = (rect.height() / view.height()).max(rect.width() / view.width());
        assert!(share > 0.6, "{share} of the view");
    }

    /// Cosine of the angle between the direction to the eye and `front`.
    fn seen_from(&self, front: Vec3) -> f32 {
        let camera = self.session().view().camera;
        (camera.eye() - camera.target).angle_between(front).cos()
    }
}

#[test]
fn the_robot_opens_lit_in_a_neutral_color_whole_and_from_the_front() {
    let story = start(&["builtin:robot"]);
    assert_eq!(story.look(), Look::Studio);
    let color = story.color().rgb();
    assert!(color == Vec3::splat(color.x) && color.x > 0.5, "{color}");
    assert!(story.seen_from(Vec3::Z) > 0.95);
    story.assert_fills_the_view();
    // On a ground that is seen from a little above, rather than as a line.
    assert!(story.session().view().camera.phi > 0.1);
}

#[test]
fn a_head_and_a_gem_a_curve_and_the_lizard_are_whole_too() {
    for name in [
        "face", "gem", "spring", "lizard", "chain", "goblet", "humanoid",
    ] {
        let story = start(&[&format!("builtin:{name}")]);
        assert_eq!(story.look(), Look::Studio, "{name}");
        story.assert_fills_the_view();
    }
}

#[test]
fn what_reaches_wide_is_fitted_clear_of_the_switch_of_the_looks() {
    let mut story = start(&["builtin:robot"]);
    let size = story.view().size();
    for file in ["builtin:robot", "builtin:adult"] {
        story.import(file);
        story.key_with(Modifiers::SHIFT, Key::F);
        let button = story.node("Course look").and_then(|node| node.bounds());
        let button = button.expect("it has a place");
        let lower_left = pos2(button.x0 as f32, button.y1 as f32) - story.view().min.to_vec2();
        let corner = egui::Rect::from_two_pos(lower_left, pos2(size.x, 0.0));
        let reaches = |shape: &Shape| story.pixels(shape).any(|pixel| corner.contains(pixel));
        assert!(!story.session().scene().shapes().iter().any(reaches));
    }
}

#[test]
fn the_faces_of_the_mannequins_are_seen() {
    for name in ["head", "robot"] {
        let Some(path) = crate::reference_data::reference(&format!("mannequin/{name}.dae")) else {
            return;
        };
        let mut host = host();
        let bytes = std::fs::read(path).expect("the reference data");
        host.files.insert("head.dae".into(), bytes);
        let story = Story::start_at(host, &["head.dae"]);
        // Both look along −Z.
        assert!(story.seen_from(Vec3::NEG_Z) > 0.95, "{name}");
        story.assert_fills_the_view();
    }
}

#[test]
fn a_character_in_the_course_s_format_is_seen_as_in_the_course_s_editor() {
    let story = start(&["models/strip.obj"]);
    assert_eq!(story.look(), Look::Course);
    assert_eq!(story.session().view().camera, Camera::default());
    assert!(story.session().view().axis);
    assert_eq!(story.color(), GREEN);
}

#[test]
fn one_that_would_be_cut_off_there_is_fitted_and_seen_from_its_own_front() {
    let story = start(&["models/large.obj"]);
    assert_eq!(story.look(), Look::Studio);
    assert_ne!(story.color(), GREEN);
    assert!(story.seen_from(Vec3::NEG_Z) > 0.95);
    story.assert_fills_the_view();
    assert_eq!(
        story.session().start_camera(),
        &story.session().view().camera
    );
}

#[test]
fn the_look_that_was_chosen_is_that_of_all_that_is_opened_then() {
    for (look, name) in [(Look::Course, "course"), (Look::Studio, "studio")] {
        for file in ["builtin:robot", "models/strip.obj"] {
            let mut host = host();
            let preferences = format!(r#"{{"started_before": true, "look": "{name}"}}"#);
            host.stored
                .insert(StorageKey::Preferences, preferences.into_bytes());
            let story = Story::start_at(host, &[file]);
            assert_eq!(story.look(), look, "{file}");
            // Neutral colors are for the Studio look, and not for the course's characters.
            let is_neutral = look == Look::Studio && file == "builtin:robot";
            assert_eq!(story.color() != GREEN, is_neutral, "{file} {name}");
            // The course's camera is for the course's characters in its look: elsewhere all is fitted.
            let has_its_camera = story.session().view().camera == Camera::default();
            let is_of_the_course = look == Look::Course && file == "models/strip.obj";
            assert_eq!(has_its_camera, is_of_the_course, "{file} {name}");
        }
    }
}

#[test]
fn textures_are_seen_from_their_lit_side_in_the_mannequin_look() {
    let brightness = |camera: Option<Camera>| {
        let mut host = host();
        let preferences = br#"{"started_before": true, "look": "mannequin"}"#;
        host.stored
            .insert(StorageKey::Preferences, preferences.to_vec());
        let mut story = Story::start_at(host, &["builtin:crate"]);
        assert_eq!(story.look(), Look::Mannequin);
        if let Some(camera) = camera {
            story.program.session_mut().look(View::SetCamera(camera));
            story.settle();
        }
        // Around the middle, where the crate is.
        let picture = story.scene_picture();
        let (width, height) = (picture.width as usize, picture.height as usize);
        let rows = picture.rgba.chunks_exact(4 * width);
        let rows = rows.skip(height * 2 / 5).take(height / 5);
        let middle = rows.flat_map(|row| &row[4 * (width * 2 / 5)..4 * (width * 3 / 5)]);
        let colors = middle.zip([true, true, true, false].iter().cycle());
        let bytes = colors.filter_map(|(&byte, is_color)| is_color.then_some(u64::from(byte)));
        bytes.sum::<u64>()
    };
    let from_the_front = Camera::from_numbers(&[0.0, 10.0, 5.0]).unwrap();
    let [ours, front] = [None, Some(from_the_front)].map(brightness);
    assert!(ours > front * 3, "{ours} {front}");
}

#[test]
fn what_is_started_with_a_picture_is_seen_as_in_the_course_s_editor() {
    let story = start(&["builtin:robot", "reference.png"]);
    assert!(story.has("Stop comparing"));
    assert_eq!(story.look(), Look::Course);
    assert_eq!(story.session().view().camera, Camera::default());
    assert_eq!(story.color(), GREEN);
}

#[test]
fn a_comparison_is_in_the_course_look_and_that_look_is_gone_with_it() {
    let mut story = start(&["builtin:robot"]);
    for another_look in [false, true] {
        story.key(Key::F8);
        story.choose("reference.png");
        assert_eq!(story.look(), Look::Course);
        if another_look {
            story.key(Key::F10);
        }
        story.key(Key::F8);
        let expected = [Look::Studio, Look::Mannequin][usize::from(another_look)];
        assert_eq!(story.look(), expected);
    }
    // The look of a comparison is not one that was chosen for good.
    let stored = String::from_utf8(story.host.stored[&StorageKey::Preferences].clone()).unwrap();
    assert!(stored.contains(r#""look": null"#), "{stored}");
}

#[test]
fn a_picture_taken_in_the_studio_is_compared_in_the_studio_whatever_the_theme_is_by_then() {
    for theme in ["Light", "Dark"] {
        let mut story = start(&["builtin:robot"]);
        let choose_theme = |story: &mut Story, theme: &str| {
            for label in ["View", "Theme", theme] {
                story.click(label);
            }
        };
        choose_theme(&mut story, theme);
        story.save_view((120, 80), "mine.png");
        let saved = story.host.written[Path::new("mine.png")].clone();
        story.host.files.insert("mine.png".into(), saved);
        choose_theme(&mut story, "Dark");
        story.key(Key::F2);
        story.key(Key::F8);
        story.choose("mine.png");
        assert_eq!(story.look(), Look::Studio, "{theme}");
        story.key(Key::F8);
        assert_eq!(story.look(), Look::Course, "{theme}");
    }
}

#[test]
fn a_picture_of_the_studio_is_compared_in_it_though_a_figure_covers_its_upper_corner() {
    let mut story = start(&["builtin:robot"]);
    let mut camera = story.session().view().camera;
    camera.radius *= 0.3;
    camera.target += camera.radius * (0.5 * camera.right() - 0.25 * camera.up());
    let look = vec![Action::View(View::SetCamera(camera))];
    story.program.carry_out(look, &mut story.host);
    story.save_view((120, 80), "mine.png");
    let saved = story.host.written[Path::new("mine.png")].clone();
    story.host.files.insert("mine.png".into(), saved);
    story.key(Key::F8);
    story.choose("mine.png");
    assert_eq!(story.look(), Look::Studio);
}

#[test]
fn the_first_import_is_fitted_and_others_move_the_camera_only_if_they_are_out_of_view() {
    let mut story = start(&[]);
    assert_eq!(story.look(), Look::Studio);
    story.import("models/large.obj");
    story.assert_fills_the_view();
    let camera = story.session().view().camera;
    assert!(story.seen_from(Vec3::NEG_Z) > 0.95);

    let gem = Action::Ask(Ask::InsertBuiltin("gem"));
    story.program.carry_out(vec![gem], &mut story.host);
    story.settle();
    assert_eq!(story.names(), ["Large", "Gem"]);
    assert_eq!(story.session().view().camera, camera);

    story.import("models/far.obj");
    assert_ne!(story.session().view().camera, camera);
    let view = egui::Rect::from_min_size(pos2(0.0, 0.0), story.view().size());
    for shape in story.session().scene().shapes() {
        assert!(view.contains_rect(story.on_screen(shape)), "{}", shape.name);
    }
}

#[test]
fn a_curve_that_is_imported_swallows_no_character_and_stays_with_other_curves() {
    let mut story = start(&["builtin:adult"]);
    let insert = |story: &mut Story, name| {
        let ask = Action::Ask(Ask::InsertBuiltin(name));
        story.program.carry_out(vec![ask], &mut story.host);
        story.settle();
        story.shape().placement
    };
    let vase = insert(&mut story, "vase").transform.position;
    let shapes = &story.session().evaluated().shapes;
    let [adult, curve] = [&shapes[0], &shapes[1]].map(|shape| shape.world_bounds());
    assert!(curve.min.x > adult.max.x, "{curve:?} beside {adult:?}");
    assert!((curve.min.y - adult.min.y).abs() < 1e-4, "on one ground");
    assert_eq!(story.shape().placement, story.shape().start);
    assert_eq!(insert(&mut story, "vase").transform.position, vase);

    let mut story = start(&["builtin:vase"]);
    let alone = insert(&mut story, "goblet").transform.position;
    assert_eq!(alone, Vec3::ZERO, "no character is there");
}

#[test]
fn a_figure_that_is_imported_stands_beside_others_and_faces_as_they_do() {
    let mut story = start(&["builtin:adult"]);
    let insert = |story: &mut Story, name| {
        let ask = Action::Ask(Ask::InsertBuiltin(name));
        story.program.carry_out(vec![ask], &mut story.host);
        story.settle();
    };
    insert(&mut story, "robot");
    insert(&mut story, "adult");
    let bounds: Vec<_> = {
        let shapes = story.session().evaluated().shapes.iter();
        shapes.map(|shape| shape.world_bounds()).collect()
    };
    assert!(bounds[0].max.x < bounds[1].min.x && bounds[1].max.x < bounds[2].min.x);
    assert!(
        bounds[2].min.x < bounds[1].max.x + 0.5,
        "no farther than needed"
    );
    let lowest: Vec<f32> = bounds.iter().map(|bounds| bounds.min.y).collect();
    let apart = lowest.iter().map(|y| (y - lowest[0]).abs());
    assert!(
        apart.fold(0.0, f32::max) < 1e-5,
        "on one ground: {lowest:?}"
    );
    let place = story.shape().placement;
    assert_eq!(place, story.shape().start, "Reset leaves it there");
    assert_eq!(place.transform.position.with_x(0.0), Vec3::ZERO);
    // Its left hand is at −X: alone it shows its back to whoever sees the others' faces.
    story.import("models/large.obj");
    let front = |story: &Story| story.shape().front().expect("a character");
    assert!(front(&story).distance(Vec3::Z * front(&story).length()) < 1e-5);

    let mut story = start(&["models/large.obj"]);
    insert(&mut story, "adult");
    assert!(front(&story).z < -0.9, "with the one that is there");

    let mut story = start(&["models/far.obj"]);
    story
        .program
        .session_mut()
        .look(View::SetCamera(Camera::default()));
    story.import("models/large.obj");
    assert!(front(&story).z > 0.9, "to the viewer, where no other is");
}

#[test]
fn a_figure_stays_where_its_file_has_it_while_it_is_compared_or_where_nothing_is() {
    let mut story = start(&["models/far.obj"]);
    let insert = Action::Ask(Ask::InsertBuiltin("adult"));
    story
        .program
        .carry_out(vec![insert.clone()], &mut story.host);
    story.settle();
    // Lifted onto the ground, if that.
    let place = story.shape().placement.transform.position;
    assert_eq!(place.with_y(0.0), Vec3::ZERO);
    story.key(Key::F8);
    story.choose("reference.png");
    story.program.carry_out(vec![insert], &mut story.host);
    story.settle();
    assert_eq!(story.names().len(), 3);
    assert_eq!(story.shape().placement.transform.position, Vec3::ZERO);
}

#[test]
fn the_course_s_character_is_imported_into_an_empty_scene_as_it_is_opened() {
    let mut story = start(&[]);
    assert!(!story.session().view().axis);
    story.import("models/strip.obj");
    assert!(story.session().view().axis);
    assert_eq!(story.look(), Look::Course);
    assert_eq!(story.session().view().camera, Camera::default());
    assert_eq!(story.color(), GREEN);
}

#[test]
fn a_point_that_is_dragged_stays_under_the_pointer_to_half_a_pixel() {
    let mut story = start(&["builtin:robot"]);
    for navigation in [
        Navigation::Orbit,
        Navigation::Mannequin,
        Navigation::Blender,
    ] {
        story.program.ui_mut().set_navigation(navigation);
        let camera = Camera {
            phi: 0.6,
            ..*story.session().start_camera()
        };
        story.program.session_mut().look(View::SetCamera(camera));
        story.settle();
        let view = story.view();
        let size = Vec2::new(view.width(), view.height());
        // Somewhere on its chest, which is nearer than the target.
        let from = view.center() + vec2(10.0, -60.0);
        let ray = camera.ray(Vec2::new(from.x - view.left(), from.y - view.top()), size);
        let session = story.session();
        let hit = editor_core::scene::pick_shape(session.evaluated(), &ray);
        let held = ray.at(hit.expect("the robot").1);
        let to = from + vec2(137.0, 91.0);

        let modifiers = match navigation {
            Navigation::Blender => Modifiers::SHIFT,
            _ => Modifiers::NONE,
        };
        let button = |pos, pressed| Event::PointerButton {
            pos,
            button: PointerButton::Middle,
            pressed,
            modifiers,
        };
        story.frame(vec![Event::ModifiersChanged(modifiers)]);
        story.point(from);
        story.frame(vec![button(from, true)]);
        for part in [0.02, 0.05, 0.3, 0.31, 1.0] {
            story.point(from + (to - from) * part);
        }
        story.frame(vec![button(to, false)]);
        story.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
        story.settle();
        let now = story.session().view().camera.pixel(held, size);
        let now = now.expect("before the eye") + Vec2::new(view.left(), view.top());
        let apart = now.distance(Vec2::new(to.x, to.y));
        assert!(apart < 0.5, "{navigation:?}: {apart} pixels");
    }
}

#[test]
fn f_fits_what_is_selected_clear_of_the_tool_bar_even_with_its_second_row() {
    let mut story = start(&["builtin:robot"]);
    for tool in [Key::V, Key::I] {
        story.key(tool);
        story.program.session_mut().look(View::ResetCamera);
        story.key(Key::F);
        story.assert_fills_the_view();
    }
    let below = story.place("Bend direction").y + 12.0 - story.view().top();
    let top = story.on_screen(story.shape()).top();
    assert!(top > below, "{top} {below}");
}

#[test]
fn the_light_theme_has_a_light_view() {
    let mut story = start(&["builtin:robot"]);
    let brightness = |story: &Story| {
        let picture = story.scene_picture();
        let sum: u64 = picture.rgba.iter().map(|&byte| u64::from(byte)).sum();
        sum as f32 / picture.rgba.len() as f32
    };
    for (theme, range) in [("Light", 190.0..245.0), ("Dark", 60.0..140.0)] {
        for label in ["View", "Theme", theme] {
            story.click(label);
        }
        let found = brightness(&story);
        assert!(range.contains(&found), "{theme}: {found}");
    }
}

#[test]
fn the_course_s_look_is_one_click_away_and_so_is_the_way_back() {
    let mut story = start(&["builtin:robot"]);
    // Files are opened in a look that was tried only as long as it stays.
    for (name, look, of_new) in [
        ("Course look", Look::Course, "course".into()),
        ("Studio look", Look::Studio, serde_json::Value::Null),
    ] {
        story.click(name);
        assert_eq!(story.look(), look);
        let stored = &story.host.stored[&StorageKey::Preferences];
        let stored: serde_json::Value = serde_json::from_slice(stored).expect("preferences");
        assert_eq!(stored["look"], of_new);
    }
    assert_eq!(story.names(), ["Robot"], "the view got no click");
}

#[test]
fn a_scene_that_was_saved_in_a_window_is_seen_whole_where_the_picture_is_higher_than_wide() {
    let radius_in = |size: (u32, u32)| {
        let mut story = Story::start(&[]);
        story.size = size;
        let open = Action::Ask(Ask::OpenBuiltin("showcase"));
        story.program.carry_out(vec![open], &mut story.host);
        story.settle();
        story
    };
    let [wide, tall] = [(1000, 640), (420, 800)].map(radius_in);
    let camera = |story: &Story| story.session().view().camera;
    assert!(camera(&tall).radius > 1.2 * camera(&wide).radius);
    let aspect = tall.view().width() / tall.view().height();
    assert!(aspect < 1.0);
    let cut_off = |camera: Camera| {
        let clip_from_world = camera.clip_from_world(aspect);
        let shapes = tall.session().evaluated().shapes.iter();
        let mut points = shapes.flat_map(|shape| {
            let clip_from_model = clip_from_world * shape.world_from_model;
            let points = shape.geometry.mesh.positions.iter();
            points.map(move |&point| clip_from_model.project_point3(point))
        });
        points.any(|point| point.x.abs() > 1.0 || point.y.abs() > 1.0)
    };
    assert!(cut_off(camera(&wide)) && !cut_off(camera(&tall)));
    assert!(!tall.program.is_modified());
}

#[test]
fn a_figure_that_is_imported_stands_beside_a_shape_of_its_size_and_on_its_ground_but_not_a_small_one()
 {
    let bounds =
        |story: &Story, index: usize| story.session().evaluated().shapes[index].world_bounds();
    for (scale, is_beside) in [(1.0, true), (0.05, false)] {
        let mut story = start(&[]);
        story.key_with(Modifiers::SHIFT, Key::S);
        let shape = story.shape().id;
        let mut transform = story.shape().placement.transform;
        transform.scale = Vec3::splat(scale);
        transform.position = Vec3::ZERO;
        let edit = Edit::SetTransform(shape, transform);
        story.program.session_mut().edit(edit).expect("it is there");
        story.import("builtin:adult");
        let [sphere, adult] = [0, 1].map(|index| bounds(&story, index));
        assert_eq!(
            adult.min.x > sphere.max.x,
            is_beside,
            "{scale} {sphere:?} {adult:?}"
        );
        if is_beside {
            let gap = adult.min.y - sphere.min.y;
            assert!(gap.abs() < 0.02, "{gap} above the ground");
        }
    }
}
