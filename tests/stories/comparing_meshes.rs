//! Comparing a character with a mesh that another program posed.

use super::explaining::{self, NO_INVERSE};
use super::{Story, differing, started_before};
use crate::diagnose::figures::{Figure, obj, turned};
use crate::diagnose::student::{RIGHT, Student};
use crate::host::MemoryHost;
use editor_core::character::Pose;
use editor_core::editor::{Edit, Severity, View};
use editor_core::geometry::Picture;
use editor_core::io::{PoseData, export_obj};
use editor_core::math::Euler;
use editor_core::program::{HostEvent, Purpose};
use editor_core::scene::{Camera, SCALE_GRAY, ShapeKind, SkinningMethod, scale_color};
use editor_core::ui::Action;
use egui::accesskit::Node;
use egui::{Event, Key, Modifiers, MouseWheelUnit, Pos2, TouchPhase, pos2, vec2};
use glam::Vec3;
use std::path::Path;

/// A dog in a pose.
fn dog() -> Figure {
    Figure::builtin("dog", turned(7))
}

/// The file that the program of `student` writes.
fn mine(figure: &Figure, student: &Student) -> Vec<u8> {
    obj(&student.skin(figure), figure, |number| {
        format!("{number:.6}")
    })
    .into_bytes()
}

/// A student who takes each column of the weights for the joint of the column before.
fn off_by_one() -> Student {
    Student {
        joint_of_column: |column| column,
        ..RIGHT
    }
}

/// Rotations the wrong way round.
fn transposed() -> Student {
    Student {
        keep_rotation: |rotation| rotation.transpose(),
        ..RIGHT
    }
}

/// A story in which the posed dog is compared with what `student` makes of it.
fn comparing(student: &Student) -> Story {
    let mut story = posed();
    compare(&mut story, student);
    story
}

/// A story with the posed dog.
fn posed() -> Story {
    posed_as(&dog().pose())
}

/// The same in a pose.
fn posed_as(pose: &Pose) -> Story {
    let mut story = Story::start(&["builtin:dog"]);
    story.size = (1280, 800);
    let id = story.session().scene().shapes()[0].id;
    let edit = Edit::SetPose(id, pose.clone());
    story.program.session_mut().edit(edit).expect("a pose");
    story.settle();
    story
}

/// Compares the dog with what `student` makes of it.
fn compare(story: &mut Story, student: &Student) {
    let mesh = mine(&dog(), student);
    compare_with(story, mesh);
}

/// Compares the dog with the mesh in a file.
fn compare_with(story: &mut Story, mesh: Vec<u8>) {
    story.host.files.insert("mine.obj".into(), mesh);
    story.click("View");
    story.click("Compare with Mesh…");
    let id = story.session().scene().shapes()[0].id;
    let asked = story.host.requests.last().map(|request| request.purpose);
    assert_eq!(asked, Some(Purpose::CompareMesh(id)));
    story.choose("mine.obj");
    assert!(story.has("Stop comparing with the mesh"));
}

/// How the button begins that shows the formula of a vertex.
const FORMULA: &str = "Show the Formula of Vertex ";

/// The button that shows the formula of a vertex, as it is called.
fn formula_of(story: &Story) -> String {
    text(story, FORMULA)
}

/// Lets the program find out what is wrong.
fn diagnose(story: &mut Story) {
    story.wait(0.2);
    assert!(story.host.run_jobs() > 0, "a job");
    story.settle();
}

/// What is seen around the middle of the view, marks included.
fn middle_of_view(story: &Story) -> Picture {
    let (whole, middle) = (story.picture(), story.view().center());
    let (width, height) = (480, 420);
    let (left, top) = (middle.x as u32 - width / 2, middle.y as u32 - height / 2);
    let row = |y: u32| {
        let start = 4 * (y * whole.width + left) as usize;
        &whole.rgba[start..start + 4 * width as usize]
    };
    Picture {
        width,
        height,
        rgba: (top..top + height).flat_map(row).copied().collect(),
    }
}

/// The texts and labels that are shown.
fn texts(story: &Story) -> Vec<String> {
    let nodes = story.widgets.iter().flat_map(|update| &update.nodes);
    let text = |node: &egui::accesskit::Node| node.value().or(node.label()).map(str::to_owned);
    nodes.filter_map(|(_, node)| text(node)).collect()
}

/// The text that begins with `start`.
fn text(story: &Story, start: &str) -> String {
    let all = texts(story);
    let found = all.iter().find(|text| text.starts_with(start));
    found
        .unwrap_or_else(|| panic!("no “{start}” in {all:#?}"))
        .clone()
}

/// Pixels of the view with a hue of the scale, and those that are gray.
fn scaled_and_gray(story: &Story) -> (usize, usize) {
    let picture = story.scene_picture();
    let mut counts = (0, 0);
    for pixel in picture.rgba.chunks_exact(4) {
        let seen = Vec3::new(pixel[0].into(), pixel[1].into(), pixel[2].into()) / 255.0;
        let is = |color: Vec3| {
            let lit = color * (seen.length() / color.length());
            let bright = seen.length() / color.length();
            (0.66..1.02).contains(&bright) && (seen - lit).length() < 0.02
        };
        if is(SCALE_GRAY) && seen.x > 0.42 {
            counts.1 += 1;
        } else if (0..=20).any(|part| is(scale_color(part as f32 / 20.0))) {
            counts.0 += 1;
        }
    }
    counts
}

/// Scrolls what is at a place far down.
fn scroll_down(story: &mut Story, at: Pos2) {
    story.point(at);
    for _ in 0..10 {
        story.frame(vec![Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: vec2(0.0, -3.0),
            phase: TouchPhase::Move,
            modifiers: Modifiers::NONE,
        }]);
    }
    story.settle();
}

#[test]
fn the_panel_of_a_character_leads_to_the_comparison() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.click("Skinning");
    story.click("Compare with a Mesh of Yours…");
    let asked = story.host.requests.last().expect("a file is asked for");
    assert_eq!(asked.purpose, Purpose::CompareMesh(story.shape().id));
}

#[test]
fn an_off_by_one_of_the_weights_is_named_and_its_worst_vertex_found_by_one_click() {
    let mut story = comparing(&off_by_one());
    assert!(
        !texts(&story)
            .iter()
            .any(|text| text.starts_with("weights-shifted"))
    );
    diagnose(&mut story);
    text(&story, "weights-shifted:");
    text(&story, "Section 4.");
    let before = story.session().view().camera;
    story.click("Show the Worst Vertex");
    let camera = story.session().view().camera;
    assert_ne!(before, camera);

    // One of those that are farthest off, by the exact mesh and the file alone, is in the middle.
    let figure = dog();
    let (ours, theirs) = (RIGHT.skin(&figure), off_by_one().skin(&figure));
    let distance = |index: usize| ours[index].distance(theirs[index]);
    let worst = (0..ours.len()).map(distance).fold(0.0, f32::max);
    let farthest = (0..ours.len()).filter(|&index| distance(index) > 0.9999 * worst);
    let world = story.session().evaluated().shapes[0].world_from_model;
    let places = |index: usize| [ours[index], theirs[index]].map(|at| world.transform_point3(at));
    let shown = farthest.map(places).find(|[ours, theirs]| {
        let middle = (*ours + *theirs) / 2.0;
        middle.distance(camera.target) < 1e-3
    });
    let [ours, theirs] = shown.expect("one of the worst vertices");
    let view = story.view().shrink(20.0);
    assert!(view.contains(story.at(ours)) && view.contains(story.at(theirs)));
    // It has a ring of white round it.
    let picture = story.picture();
    let at = story.at(ours);
    let is_white = |x: i32| {
        let index = 4 * (at.y as usize * picture.width as usize + (at.x as i32 + x) as usize);
        picture.rgba[index..index + 3].iter().all(|&c| c > 150)
    };
    assert!((6..=12).any(is_white) && (-12..=-6).any(is_white));
    // Its formula is the one that is explained.
    story.click("View");
    story.click("Explain Skinning");
    let explained = story.node("Vertex").and_then(Node::numeric_value);
    let explained = explained.expect("the number of a vertex") as usize;
    assert!(distance(explained) > 0.9999 * worst);
}

#[test]
fn a_vertex_that_is_off_along_its_normal_is_shown_with_the_line_between_its_places_across_the_view()
{
    let mut story = posed();
    let figure = dog();
    let exact = RIGHT.skin(&figure);
    let size = {
        let bounds = story.session().evaluated().shapes[0].world_bounds();
        bounds.size().length()
    };
    let world = story.session().evaluated().shapes[0].world_from_model;
    let triangles = story.session().evaluated().shapes[0].geometry.mesh.clone();
    for vertex in [40, 1500, 4000] {
        let own = triangles.triangles.iter();
        let own = own.filter(|corners| corners.contains(&(vertex as u32)));
        let normals = own.map(|corners| {
            let [a, b, c] = corners.map(|corner| exact[corner as usize]);
            (b - a).cross(c - a)
        });
        let normal = normals.sum::<Vec3>().try_normalize().expect("a surface");
        for by in [-0.9, -0.1, 0.002, 0.1, 0.9] {
            let mut theirs = exact.clone();
            theirs[vertex] += by * size * normal;
            let mesh = obj(&theirs, &figure, |number| format!("{number:.6}"));
            compare_with(&mut story, mesh.into_bytes());
            story.click("Show the Worst Vertex");
            let ends = [exact[vertex], theirs[vertex]].map(|at| world.transform_point3(at));
            let seen = ends.map(|end| story.at(end));
            let view = story.view().shrink(20.0);
            assert!(
                seen.iter().all(|&end| view.contains(end)),
                "{vertex} {by}: {seen:?}"
            );
            let towards_eye = (story.session().view().camera.eye() - ends[0]).normalize_or_zero();
            let outward = world.transform_vector3(normal).normalize_or_zero();
            let faces = towards_eye.dot(outward);
            if by == 0.002 {
                // What is a point anyway is seen from where the surface looks, though not too steeply.
                assert!(faces > 0.9, "{vertex}: {faces}");
            } else {
                let apart = seen[0].distance(seen[1]);
                assert!(
                    apart > 0.15 * view.height(),
                    "{vertex} {by}: {apart} points"
                );
                assert!(faces > 0.0, "{vertex} {by}: seen from behind");
            }
            story.key(Key::Escape);
        }
    }
}

#[test]
fn the_numbers_are_those_of_the_exact_mesh() {
    let story = comparing(&off_by_one());
    let figure = dog();
    let (ours, theirs) = (RIGHT.skin(&figure), off_by_one().skin(&figure));
    let distances: Vec<f32> = ours
        .iter()
        .zip(&theirs)
        .map(|(a, b)| a.distance(*b))
        .collect();
    let low = ours.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = ours.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let size = low.distance(high);
    let off = distances.iter().filter(|d| **d > 1e-4 * size).count();
    text(&story, &format!("{off} of {} (", ours.len()));
    // Of the numbers in brackets, one is the largest distance and one the mean.
    let told: Vec<f32> = texts(&story)
        .iter()
        .filter_map(|text| text.split_once("% ("))
        .filter_map(|(_, number)| number.trim_end_matches(')').parse().ok())
        .collect();
    let worst = distances.iter().copied().fold(0.0, f32::max);
    let mean = distances.iter().sum::<f32>() / distances.len() as f32;
    for expected in [worst, mean] {
        let is_told = |told: &f32| (told - expected).abs() < 1e-4 * size;
        assert!(told.iter().any(is_told), "{expected}: {told:?}");
    }
}

#[test]
fn what_is_right_is_gray_and_said_to_be_right_and_what_is_wrong_is_colored() {
    let mut story = comparing(&RIGHT);
    diagnose(&mut story);
    text(&story, "Right: this is the exact result");
    assert!(!story.has("Show the Worst Vertex"));
    let (scaled, gray) = scaled_and_gray(&story);
    assert!(gray > 5000 && scaled * 50 < gray, "{scaled} {gray}");

    let mut story = comparing(&off_by_one());
    story.click("Exact");
    let (scaled, _) = scaled_and_gray(&story);
    assert!(scaled > 5000, "{scaled}");
}

#[test]
fn a_mesh_that_is_cut_off_is_told_to_lack_triangles() {
    let mut story = comparing(&RIGHT);
    diagnose(&mut story);
    assert!(!texts(&story).iter().any(|text| text.contains("missing")));
    let whole = String::from_utf8(mine(&dog(), &RIGHT)).unwrap();
    let lines: Vec<&str> = whole.lines().collect();
    let cut = lines[..lines.len() - 70].join("\n");
    story.host.files.insert("cut.obj".into(), cut.into_bytes());
    story.click("Compare with another mesh");
    story.choose("cut.obj");
    diagnose(&mut story);
    text(
        &story,
        "Right but for its triangles: its vertices are the exact result",
    );
    let told = "In cut.obj 70 of the model's 12558 triangles are missing: the file may be cut off.";
    text(&story, told);
}

#[test]
fn ours_theirs_and_both_are_three_pictures_and_esc_goes_back_to_the_first() {
    let mut story = comparing(&off_by_one());
    let both = story.scene_picture();
    story.click("Exact");
    let ours = story.scene_picture();
    story.click("mine.obj");
    let theirs = story.scene_picture();
    assert!(differing(&both, &ours) > 1000);
    assert!(differing(&both, &theirs) > 1000);
    assert!(differing(&ours, &theirs) > 1000);
    story.key(Key::Escape);
    assert!(!story.has("Stop comparing with the mesh"));
    let id = story.session().scene().shapes()[0].id;
    assert_eq!(
        story.session().selected(),
        Some(id),
        "nothing else has ended"
    );
    assert_eq!(story.session().done_steps(), 1, "the document is as it was");
}

#[test]
fn another_pose_is_measured_at_once_and_diagnosed_anew() {
    let mut story = comparing(&RIGHT);
    diagnose(&mut story);
    text(&story, "Right: this");
    let id = story.session().scene().shapes()[0].id;
    let edit = Edit::SetPose(id, Default::default());
    story.program.session_mut().edit(edit).expect("a pose");
    story.settle();
    text(&story, "Looking for the mistake…");
    assert!(story.has("Show the Worst Vertex"));
    diagnose(&mut story);
    assert!(
        !texts(&story)
            .iter()
            .any(|text| text.starts_with("Right: this"))
    );
    story.key_with(Modifiers::COMMAND, Key::Z);
    diagnose(&mut story);
    text(&story, "Right: this");
}

#[test]
fn a_mesh_of_other_vertices_or_a_file_that_is_none_changes_nothing() {
    let mut story = comparing(&RIGHT);
    let files = &mut story.host.files;
    files.insert(
        "triangle.obj".into(),
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec(),
    );
    files.insert("broken.obj".into(), b"v 0 0 zero\n".to_vec());
    for (path, told) in [
        ("triangle.obj", "this mesh has 3"),
        ("broken.obj", "broken.obj:1:7: expected"),
        ("gone.obj", "gone.obj"),
    ] {
        story.click("Compare with another mesh");
        story.choose(path);
        let messages = story.messages();
        let (severity, message) = messages.last().expect("a message");
        assert_eq!(*severity, Severity::Error);
        assert!(message.contains(told), "{message}");
        text(&story, "mine.obj against the exact Dog");
    }
}

#[test]
fn a_mesh_with_vertices_that_are_no_numbers_is_compared_by_its_others() {
    let mut lines: Vec<String> = String::from_utf8(mine(&dog(), &RIGHT))
        .unwrap()
        .lines()
        .map(String::from)
        .collect();
    for line in &mut lines[40..45] {
        *line = "v nan 1 -nan".to_owned();
    }
    let mut story = posed();
    compare_with(&mut story, lines.join("\n").into_bytes());
    let messages = story.messages();
    let mut texts = messages.iter().map(|(_, text)| text);
    let is_told = texts.any(|text| text.contains("5 vertices are no numbers"));
    assert!(is_told, "{messages:?}");
    diagnose(&mut story);
    text(&story, "All but 5 of its vertices are right.");
    let positions = &story.session().evaluated().shapes[0].world_bounds();
    assert!(positions.size().is_finite());
    // The colors are those of the largest distance that is one, and so is the scale's end.
    assert!(!story.has_text("an infinite distance"));
    let (scaled, _) = scaled_and_gray(&story);
    assert!(scaled > 0);
}

#[test]
fn a_mesh_is_named_with_its_folder_since_those_of_a_class_have_one_name() {
    let mut story = posed();
    let path = "class/bob/mine.obj";
    story.host.files.insert(path.into(), mine(&dog(), &RIGHT));
    story.click("View");
    story.click("Compare with Mesh…");
    story.choose(path);
    text(&story, "bob/mine.obj against the exact Dog");
}

#[test]
fn a_renumbered_mesh_is_laid_over_ours_without_distances_and_explained() {
    let corners = Student {
        vertices: |figure| {
            let corners = figure.triangles.iter().flatten();
            corners
                .map(|&corner| (corner as usize, corner as usize))
                .collect()
        },
        ..RIGHT
    };
    let mut story = comparing(&RIGHT);
    let file = mine(&dog(), &corners);
    story.host.files.insert("corners.obj".into(), file);
    story.host.drop_file("corners.obj");
    story.settle();
    text(&story, "corners.obj against the exact Dog");
    text(&story, "corners.obj has another number of vertices");
    diagnose(&mut story);
    text(&story, "vertices-renumbered:");
    assert_eq!(story.names(), ["Dog"], "nothing was imported");
}

#[test]
fn a_comparison_ends_the_mistake_that_is_made_and_a_mistake_the_comparison() {
    let mut story = comparing(&RIGHT);
    story.click("Stop comparing with the mesh");
    story.key(Key::K);
    let mistake = text(&story, "Column c");
    story.click(&mistake);
    assert!(story.has("Back to Correct"));
    story.key_with(Modifiers::SHIFT, Key::F8);
    story.choose("mine.obj");
    assert!(
        !story.has("Back to Correct"),
        "the character is shown as it is"
    );
    assert!(story.has("v' = Σ w · T · B⁻¹ · v"));
    text(&story, "Making one ends the comparison");
    explaining::make(&mut story, NO_INVERSE);
    assert!(!story.has("Stop comparing with the mesh"));
    assert!(story.has("Back to Correct") && story.has("v' = Σ w · T · v"));
}

#[test]
fn the_mistake_that_was_found_is_made_by_one_click_in_the_way_that_was_found() {
    let not_at_all = Student {
        row: |row| row.iter().skip(1).copied().chain([0.0]).collect(),
        ..RIGHT
    };
    let mut story = comparing(&not_at_all);
    story.key(Key::K);
    assert!(!story.has_text("Found in mine.obj:"));
    diagnose(&mut story);
    text(&story, "Found in mine.obj:");
    let found = "Column c of the weights is taken for joint c instead of joint c + 1: the first one not at all.";
    story.click(found);
    assert!(!story.has("Stop comparing with the mesh") && story.has("Back to Correct"));
    assert!(story.has_text(found), "what is made");
}

#[test]
fn the_formula_has_the_place_of_the_vertex_in_the_compared_mesh_as_well() {
    let mut story = comparing(&off_by_one());
    diagnose(&mut story);
    // The stack was looked at before.
    story.key(Key::K);
    story.click("Matrix Stack");
    story.key(Key::K);
    story.click(&formula_of(&story));
    let vertex = story.node("Vertex").and_then(Node::numeric_value);
    let vertex = vertex.expect("the number of a vertex") as usize;
    let figure = dog();
    let [ours, theirs] = [RIGHT, off_by_one()].map(|student| student.skin(&figure)[vertex]);
    let row = text(&story, "v' in mine.obj, ");
    let off = format!("v' in mine.obj, {:.3} off (", ours.distance(theirs));
    assert!(row.starts_with(&off), "{row}, not {off}");
    let written = row
        .trim_start_matches(&off)
        .trim_end_matches(')')
        .split(", ");
    let written: Vec<f32> = written.map(|number| number.parse().unwrap()).collect();
    assert!(
        Vec3::from_slice(&written).abs_diff_eq(theirs, 6e-4),
        "{row}"
    );
    // All of it is seen at once.
    let sum = text(&story, "Sum (");
    for row in [sum, row] {
        assert!(story.place(&row).y < 764.0, "{row}");
    }
}

#[test]
fn the_place_of_a_vertex_in_the_compared_mesh_has_the_name_of_its_file() {
    let mut story = comparing(&off_by_one());
    story.click("Show the Worst Vertex");
    let mine = middle_of_view(&story);
    let file = story.host.files[Path::new("mine.obj")].clone();
    story.host.files.insert("alas.obj".into(), file);
    story.click("Compare with another mesh");
    story.choose("alas.obj");
    story.click("Show the Worst Vertex");
    let alas = middle_of_view(&story);
    assert!(differing(&mine, &alas) > 20);
}

#[test]
fn where_a_mistake_begins_is_one_click_away_where_that_is_not_the_worst_vertex() {
    let mut story = comparing(&transposed());
    diagnose(&mut story);
    let begins = text(&story, "Show Vertex ");
    assert!(begins.ends_with(" at Hips, the First Much Off"), "{begins}");
    story.click("Show the Worst Vertex");
    let worst = story.session().view().camera;
    story.click(&begins);
    assert_ne!(story.session().view().camera, worst);
    // One click is enough where both are the same.
    let mut story = comparing(&off_by_one());
    diagnose(&mut story);
    assert!(
        !texts(&story)
            .iter()
            .any(|text| text.starts_with("Show Vertex "))
    );
}

#[test]
fn the_camera_that_went_to_a_vertex_goes_back_when_the_comparison_ends_unless_it_was_moved_by_hand()
{
    let mut story = comparing(&transposed());
    diagnose(&mut story);
    let before = story.session().view().camera;
    story.click("Show the Worst Vertex");
    let farther = story.session().view().camera;
    story.click(&text(&story, "Show Vertex "));
    assert!(![before, farther].contains(&story.session().view().camera));
    story.key(Key::Escape);
    assert!(!story.has("Show the Worst Vertex"));
    assert_eq!(story.session().view().camera, before);

    let mut story = comparing(&off_by_one());
    story.click("Show the Worst Vertex");
    let moved = Camera {
        theta: 1.0,
        ..story.session().view().camera
    };
    let seen = vec![Action::View(View::SetCamera(moved))];
    story.program.carry_out(seen, &mut story.host);
    story.settle();
    story.key(Key::Escape);
    assert_eq!(story.session().view().camera, moved);
}

#[test]
fn the_mistake_is_read_without_scrolling_and_its_formula_one_click_away() {
    let mut story = comparing(&off_by_one());
    diagnose(&mut story);
    let formula = story.place(&formula_of(&story));
    assert!(formula.y < 770.0, "above the status line: {formula}");
    // A list that is scrolled takes nothing else away.
    let list = story
        .node("Stop comparing with the mesh")
        .expect("×")
        .bounds();
    let right = list.expect("a place").x0 as f32 - 60.0;
    scroll_down(&mut story, pos2(right, formula.y));
    assert_eq!(story.place(&formula_of(&story)), formula);

    let formula = formula_of(&story);
    story.click(&formula);
    assert!(story.has("v' = Σ w · T · B⁻¹ · v"));
    let explained = story.node("Vertex").and_then(Node::numeric_value);
    let explained = explained.expect("the number of a vertex");
    assert_eq!(formula, format!("{FORMULA}{explained}"));
    assert!(!texts(&story).iter().any(|text| text.starts_with(FORMULA)));
}

#[test]
fn with_skinning_explained_as_well_the_view_keeps_much_of_the_window() {
    for (size, least) in [((1280, 800), 320.0), ((420, 700), 250.0)] {
        let mut story = comparing(&off_by_one());
        story.size = size;
        story.key(Key::K);
        assert!(story.has("v' = Σ w · T · B⁻¹ · v") && story.has("Stop comparing with the mesh"));
        let both = story.view().height();
        assert!(both >= least, "{size:?}: {both}");
        // Each has the height from before when it is alone again.
        story.click("Stop comparing with the mesh");
        let explained = story.view().height();
        story.click("Close Explain");
        let lower = story.view().height() - explained;
        assert!(lower > 250.0, "{size:?}: {lower}");
    }
}

#[test]
fn both_panels_below_the_view_are_made_higher_by_their_upper_edges() {
    let mut story = comparing(&off_by_one());
    story.key(Key::K);
    let before = story.view();
    let edge = pos2(300.0, before.bottom() + 1.0);
    story.drag(edge, edge - vec2(0.0, 40.0));
    let after = story.view();
    assert!(
        (after.height() - before.height() + 40.0).abs() < 4.0,
        "{before} {after}"
    );
    let header = story.place("Close Explain").y;
    let explained = pos2(300.0, header - 17.0);
    story.drag(explained, explained - vec2(0.0, 40.0));
    assert!((story.place("Close Explain").y - header + 40.0).abs() < 4.0);
}

#[test]
fn a_character_at_rest_is_said_to_need_the_pose_first() {
    let mut story = comparing(&RIGHT);
    diagnose(&mut story);
    let is_told = |story: &Story| texts(story).iter().any(|text| text.contains("is at rest"));
    assert!(!is_told(&story), "it is right");
    story.click("Reset all");
    diagnose(&mut story);
    assert!(
        !is_told(&story) && story.has("Take Its Pose"),
        "their pose is known"
    );

    let mut story = comparing(&off_by_one());
    story.click("Reset all");
    diagnose(&mut story);
    assert!(is_told(&story));
    let has_verdict = |story: &Story| {
        let verdicts = ["No known mistake", "Nearest:"];
        let is_one = |text: &String| verdicts.iter().any(|start| text.starts_with(start));
        texts(story).iter().any(is_one)
    };
    assert!(!has_verdict(&story), "the pose comes first");
    story.key_with(Modifiers::COMMAND, Key::Z);
    diagnose(&mut story);
    assert!(!is_told(&story));
}

#[test]
fn the_file_of_a_character_beside_the_character_at_rest_is_said_to_be_that() {
    let mut host = MemoryHost {
        stored: [started_before()].into(),
        ..MemoryHost::default()
    };
    let assets = format!("{}/assets/characters/dog", env!("CARGO_MANIFEST_DIR"));
    for extension in ["obj", "skel", "attach"] {
        let text = std::fs::read_to_string(format!("{assets}.{extension}")).unwrap();
        // The weights of one vertex sum to a little less than 1.
        let text = match extension {
            "attach" => text.replacen("0.9948", "0.97", 1),
            _ => text,
        };
        let path = format!("models/dog.{extension}");
        host.files.insert(path.into(), text.into());
    }
    let mut story = Story::start_at(host, &["models/dog.obj"]);
    let file = story.host.files[Path::new("models/dog.obj")].clone();
    compare_with(&mut story, file);
    diagnose(&mut story);
    text(
        &story,
        "mine.obj is the mesh at rest as the character's file has it.",
    );
    assert!(story.has("Load Its Pose…"));
    assert!(
        !texts(&story)
            .iter()
            .any(|text| text.contains("seems to be posed"))
    );
    assert!(!story.has_text("matrix-transposed:"));
}

#[test]
fn a_mesh_all_vertices_of_which_are_at_the_origin_is_said_to_be_that_in_any_pose() {
    let mesh = obj(&vec![Vec3::ZERO; RIGHT.skin(&dog()).len()], &dog(), |_| {
        "0".to_owned()
    });
    for pose in [dog().pose(), Pose::new()] {
        let mut story = posed_as(&pose);
        compare_with(&mut story, mesh.clone().into_bytes());
        diagnose(&mut story);
        text(
            &story,
            "All vertices are at the origin: are the joints' matrices filled, and the inverse bind matrices?",
        );
        let mut texts = texts(&story).into_iter();
        assert!(!texts.any(|text| text.contains("seems to be posed")));
    }
}

#[test]
fn joints_are_listed_with_the_worst_first_and_another_mesh_begins_at_the_top() {
    let mut story = comparing(&off_by_one());
    text(
        &story,
        "Vertices off, by the joint that moves them most (distances in % of the size):",
    );
    let rows = |story: &Story| -> Vec<String> {
        let all = texts(story).into_iter();
        let mut rows: Vec<_> = all.filter(|text| text.contains(" %, by up to ")).collect();
        rows.sort_by(|a, b| story.place(a).y.total_cmp(&story.place(b).y));
        rows
    };
    let worst: Vec<f32> = rows(&story)
        .iter()
        .filter_map(|row| row.rsplit_once("by up to ")?.1.strip_suffix(" %"))
        .filter_map(|number| number.parse().ok())
        .collect();
    assert!(worst.len() > 5, "{:?}", rows(&story));
    assert!(worst.is_sorted_by(|a, b| a >= b), "{worst:?}");
    let first = rows(&story)[0].clone();
    let top = story.place(&first);
    scroll_down(&mut story, top);
    assert!(story.node(&first).is_none() || story.place(&first).y < top.y - 20.0);
    story.click("Compare with another mesh");
    story.choose("mine.obj");
    assert_eq!(story.place(&first), top);
}

#[test]
fn the_pose_is_loaded_where_it_is_missing_and_the_mistake_named_then() {
    let mut story = comparing(&off_by_one());
    let id = story.session().scene().shapes()[0].id;
    let dog = dog();
    let pose = PoseData::new(dog.character.skeleton(), &dog.pose()).to_json();
    story.host.files.insert("walk.json".into(), pose.into());
    story.click("Reset all");
    diagnose(&mut story);
    assert!(
        !texts(&story)
            .iter()
            .any(|text| text.starts_with("weights-shifted"))
    );
    story.click("Load Its Pose…");
    let asked = story.host.requests.last().map(|request| request.purpose);
    assert_eq!(asked, Some(Purpose::LoadPose(id)));
    story.choose("walk.json");
    diagnose(&mut story);
    text(&story, "weights-shifted:");
    assert!(!story.has("Load Its Pose…"), "it is loaded");
}

#[test]
fn a_mesh_of_another_pose_is_said_to_be_one_and_its_pose_taken_by_one_click() {
    let mut story = comparing(&RIGHT);
    let id = story.session().scene().shapes()[0].id;
    let other = Figure::builtin("dog", turned(3)).pose();
    let edit = Edit::SetPose(id, other);
    story.program.session_mut().edit(edit).expect("a pose");
    story.settle();
    diagnose(&mut story);
    text(&story, "This is the exact result, but of another pose.");
    text(
        &story,
        "If that is the pose that mine.obj was made in, load it",
    );
    assert!(
        !texts(&story)
            .iter()
            .any(|text| text.starts_with("No known mistake"))
    );
    let has = |story: &Story, words: &str| texts(story).iter().any(|text| text.contains(words));
    story.click("Take Its Pose");
    assert!(!has(&story, "share a turn"), "no two are in one place");
    diagnose(&mut story);
    text(&story, "Right: this is the exact result");
    assert!(!story.has("Take Its Pose"));
    story.key_with(Modifiers::COMMAND, Key::Z);
    diagnose(&mut story);
    assert!(story.has("Take Its Pose"));
}

#[test]
fn a_pose_that_is_taken_is_said_to_be_one_of_several_where_joints_are_in_one_place() {
    let mut host = MemoryHost {
        stored: [started_before()].into(),
        ..MemoryHost::default()
    };
    let vertices = (0..40).map(|at| {
        let [x, y, z] = [7, 11, 13].map(|step| (at * step % 41) as f32 / 41.0);
        format!("v {x} {} {z}\n", 2.0 * y)
    });
    let weights = (0..40).map(|at| if at % 2 == 0 { "1 0\n" } else { "0.2 0.8\n" });
    // The base is where the root is, which moves no vertex by itself.
    for (path, text) in [
        (
            "body.obj",
            vertices.chain(["f 1 2 3\n".to_owned()]).collect(),
        ),
        ("body.attach", weights.collect()),
        (
            "body.skel",
            "0 0 0 -1 # Root\n0 0 0 0 # Base\n0 1 0 1 # Tip\n".to_owned(),
        ),
    ] {
        let text: String = text;
        host.files.insert(path.into(), text.into());
    }
    let mut story = Story::start_at(host, &["body.obj"]);
    for (field, degrees) in [("Base X", "20"), ("Base Y", "30"), ("Tip Z", "50")] {
        story.type_into(field, degrees);
    }
    let session = story.session();
    let posed = export_obj(session.scene(), session.evaluated()).expect("a mesh");
    story.type_into("Base Y", "0");
    story.type_into("Tip Z", "0");
    story.type_into("Tip X", "40");
    compare_with(&mut story, posed.into_bytes());
    diagnose(&mut story);
    let has = |story: &Story, words: &str| texts(story).iter().any(|text| text.contains(words));
    assert!(has(&story, ", or others that give the same"));
    story.click("Take Its Pose");
    assert!(has(&story, "share a turn, and this mesh does not tell how"));
}

#[test]
fn where_no_mistake_is_found_the_pose_is_to_be_checked() {
    let bent = Student {
        write: |at| at + Vec3::Y * 0.02 * (at.x * 40.0).sin(),
        ..RIGHT
    };
    let mut story = comparing(&bent);
    diagnose(&mut story);
    text(&story, "No known mistake gives this mesh in this pose");
    text(
        &story,
        "Was mine.obj made from this character, in this pose?",
    );
    // Where most of it is right there is no doubt about that.
    let partly = Student {
        write: |at| match at.z > 0.2 {
            true => at + Vec3::Y * 0.02 * (at.x * 40.0).sin(),
            false => at,
        },
        ..RIGHT
    };
    let mut story = comparing(&partly);
    diagnose(&mut story);
    text(&story, "No known mistake gives this mesh in this pose");
    let has = |words: &str| texts(&story).iter().any(|text| text.contains(words));
    assert!(has(
        "% of its vertices are right, so mine.obj is in this pose"
    ));
    assert!(!has("Was mine.obj made from"));
}

#[test]
fn vertices_that_the_pose_does_not_move_tell_nothing_of_the_pose() {
    let figure = dog();
    let tip = figure.character.skeleton().joints().len() - 1;
    let turned = |degrees: Vec3| {
        let mut pose = Pose::new();
        pose.set_joint_transform(tip, Euler::from_degrees(degrees));
        pose
    };
    let rest = figure.character.skin_pose(&Pose::new());
    let posed = figure
        .character
        .skin_pose(&turned(Vec3::new(0.0, 0.0, -30.0)));
    let lines = rest.iter().zip(&posed).map(|(rest, posed)| {
        let at = match rest.distance(*posed) > 1e-6 {
            true => *posed + Vec3::Y * 0.02 * (posed.x * 40.0).sin(),
            false => *posed,
        };
        format!("v {} {} {}\n", at.x, at.y, at.z)
    });
    let mesh: String = lines.collect();
    let mut story = posed_as(&turned(Vec3::new(50.0, 0.0, 0.0)));
    compare_with(&mut story, mesh.into_bytes());
    diagnose(&mut story);
    text(&story, "No known mistake gives this mesh in this pose");
    text(
        &story,
        "Was mine.obj made from this character, in this pose?",
    );
}

#[test]
fn a_comparison_is_with_linear_blending_alone() {
    let mut story = comparing(&RIGHT);
    let id = story.session().scene().shapes()[0].id;
    let edit = Edit::SetSkinningMethod(id, SkinningMethod::DualQuaternion);
    story.program.session_mut().edit(edit).expect("a method");
    story.settle();
    assert!(!story.has("Stop comparing with the mesh"), "it has ended");
    let (severity, text) = story.messages()[0];
    assert_eq!(severity, Severity::Info);
    assert!(text.contains("it is about linear blending"), "{text}");
    story.key_with(Modifiers::SHIFT, Key::F8);
    story.choose("mine.obj");
    assert!(!story.has("Stop comparing with the mesh"));
    let (severity, text) = story.messages()[story.messages().len() - 1];
    assert_eq!(severity, Severity::Error);
    assert!(text.contains("is skinned with dual quaternions"), "{text}");
}

#[test]
fn of_two_characters_the_one_is_compared_that_the_mesh_is_far_nearer_to() {
    let mut story = Story::start(&["builtin:dog", "builtin:dog"]);
    let shapes = story.session().scene().shapes().iter();
    let ids: Vec<_> = shapes.map(|shape| shape.id).collect();
    let rename = Edit::Rename(ids[0], "Rex".to_owned());
    let pose = Edit::SetPose(ids[0], dog().pose());
    let session = story.program.session_mut();
    session.edit(Edit::Together(vec![rename, pose])).unwrap();
    session.look(View::Select(Some(ids[1])));
    story.settle();
    let mesh = mine(&dog(), &RIGHT);
    story.host.files.insert("mine.obj".into(), mesh);
    story.key_with(Modifiers::SHIFT, Key::F8);
    story.choose("mine.obj");
    diagnose(&mut story);
    text(&story, "Right: this is the exact result");
    assert!(story.has_text("mine.obj is compared with Rex, to which it is far nearer than to Dog"));
    text(&story, "mine.obj against the exact Rex");
}

#[test]
fn without_its_character_the_comparison_ends() {
    let mut story = comparing(&RIGHT);
    story.key(Key::Delete);
    assert!(!story.has("Stop comparing with the mesh"));
    story.key_with(Modifiers::COMMAND, Key::Z);
    assert!(!story.has("Stop comparing with the mesh"), "it has ended");
    let shapes = story.session().scene().shapes();
    assert!(matches!(shapes[0].kind, ShapeKind::Character(_)));
}

#[test]
fn a_mesh_that_lands_elsewhere_comes_into_the_picture_and_is_fitted_by_the_keys() {
    // All of the dog's vertices are moved by more than its own length.
    let figure = dog();
    let apart = Vec3::new(2.5, 0.0, 0.0);
    let moved: Vec<Vec3> = RIGHT
        .skin(&figure)
        .into_iter()
        .map(|at| at + apart)
        .collect();
    let text = obj(&moved, &figure, |number| format!("{number:.6}"));
    let mut story = posed();
    let before = story.session().view().camera;
    story
        .host
        .files
        .insert("mine.obj".into(), text.into_bytes());
    story.click("View");
    story.click("Compare with Mesh…");
    story.choose("mine.obj");
    let sees = |story: &Story, theirs: bool| {
        let shape = &story.session().evaluated().shapes[0];
        let mut bounds = shape.world_bounds();
        if theirs {
            let by = shape.world_from_model.transform_vector3(apart);
            bounds.min += by;
            bounds.max += by;
        }
        let aspect = story.view().width() / story.view().height();
        story.session().view().camera.share(&bounds, aspect)
    };
    assert_ne!(story.session().view().camera, before);
    assert!(sees(&story, true).is_some() && sees(&story, false).is_some());
    for fits in [Modifiers::NONE, Modifiers::SHIFT] {
        story.key_with(fits, Key::F);
        assert!(sees(&story, true).is_some() && sees(&story, false).is_some());
    }
    // Alone it fills the picture.
    story.click("mine.obj");
    story.key(Key::F);
    assert!(sees(&story, true).unwrap() > 0.6);
    story.click("Exact");
    story.key(Key::F);
    assert!(sees(&story, false).unwrap() > 0.6);
}

#[test]
fn a_character_that_is_small_in_the_view_is_seen_large_beside_a_mesh_and_one_that_is_not_as_it_was()
{
    let mut story = posed();
    let before = story.session().view().camera;
    compare(&mut story, &off_by_one());
    assert_eq!(story.session().view().camera, before, "it is large already");
    story.click("Stop comparing with the mesh");

    let far = Camera {
        radius: 5.0 * before.radius,
        ..before
    };
    // The view is about twice as wide as high.
    let share = |story: &Story, camera: Camera| {
        let bounds = story.session().evaluated().shapes[0].world_bounds();
        camera.share(&bounds, 2.0).unwrap()
    };
    assert!(share(&story, far) < 0.3);
    story.program.session_mut().look(View::SetCamera(far));
    compare(&mut story, &off_by_one());
    let near = story.session().view().camera;
    assert!(share(&story, near) > 0.6, "{near:?}");
    assert_eq!((near.theta, near.phi), (far.theta, far.phi));
    story.program.session_mut().look(View::SetCamera(far));
    story.click("Compare with another mesh");
    story.choose("mine.obj");
    assert_eq!(story.session().view().camera, far, "it was chosen anew");
    story.key(Key::Home);
    assert_eq!(story.session().view().camera, before);
}

#[test]
fn the_entry_of_the_menu_ends_a_comparison_with_a_mesh_as_its_key_does() {
    let mut story = comparing(&RIGHT);
    let asked = story.host.requests.len();
    story.click("View");
    story.click("End Comparison with Mesh");
    assert!(!story.has("Stop comparing with the mesh"));
    assert_eq!(story.host.requests.len(), asked, "no file is asked for");
    story.click("View");
    assert!(story.has("Compare with Mesh…"));
}

#[test]
fn a_mesh_that_its_program_writes_anew_is_compared_anew() {
    let mut story = comparing(&off_by_one());
    diagnose(&mut story);
    text(&story, "weights-shifted:");
    let write = |story: &mut Story, mesh: Vec<u8>| {
        story.host.files.insert("mine.obj".into(), mesh);
        let changed = HostEvent::Changed("mine.obj".into());
        story.host.events.push_back(changed);
        story.settle();
    };
    write(&mut story, mine(&dog(), &RIGHT));
    diagnose(&mut story);
    text(&story, "Right: this is the exact result");
    // One that cannot be read, or is gone, is no right one any more.
    write(&mut story, b"v 1 2".to_vec());
    text(&story, "mine.obj:1:6: expected");
    let says_right = |story: &Story| texts(story).iter().any(|text| text.starts_with("Right: "));
    assert!(!says_right(&story) && !story.has("Every vertex is in its place."));
    let right = String::from_utf8(mine(&dog(), &RIGHT)).unwrap();
    let lost = right.splitn(3, '\n').last().unwrap();
    write(&mut story, lost.into());
    let is_told = |text: &String| text.contains(": the file lacks 2 of ");
    assert!(texts(&story).iter().any(is_told), "{:?}", texts(&story));
    story.host.files.remove(Path::new("mine.obj"));
    let changed = HostEvent::Changed("mine.obj".into());
    story.host.events.push_back(changed);
    story.settle();
    text(&story, "mine.obj is gone.");
    write(&mut story, mine(&dog(), &RIGHT));
    diagnose(&mut story);
    assert!(says_right(&story));
    // Vertices are enough, as other programs may write them.
    let vertices = right.lines().filter(|line| line.starts_with("v "));
    let vertices = vertices.collect::<Vec<_>>().join("\n");
    write(&mut story, vertices.into());
    diagnose(&mut story);
    assert!(says_right(&story));
    // Reload Models reads it, too.
    let wrong = mine(&dog(), &off_by_one());
    story.host.files.insert("mine.obj".into(), wrong);
    story.click("File");
    story.click("Reload Models");
    diagnose(&mut story);
    text(&story, "weights-shifted:");
}

#[test]
fn a_mesh_that_was_exported_where_the_character_stands_is_compared_without_that() {
    let mut story = posed();
    let id = story.shape().id;
    let mut transform = story.shape().placement.transform;
    transform.position += Vec3::new(0.5, -0.25, 1.0);
    transform.scale *= 1.5;
    transform.rotation = Euler::from_degrees(Vec3::new(10.0, 30.0, -5.0));
    let edit = Edit::SetTransform(id, transform);
    story.program.session_mut().edit(edit).expect("a place");
    story.settle();
    let session = story.session();
    let exported = export_obj(session.scene(), session.evaluated()).expect("a mesh");
    compare_with(&mut story, exported.into_bytes());
    diagnose(&mut story);
    text(&story, "Right: this is the exact result");
    assert!(story.has_text(
        "mine.obj has the position, rotation and scale of Dog: it is compared without them"
    ));
    // One that another program made in the space of the model is compared as it is.
    story.click("Stop comparing with the mesh");
    compare(&mut story, &RIGHT);
    diagnose(&mut story);
    text(&story, "Right: this is the exact result");
}
