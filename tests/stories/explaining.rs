//! View ▸ Explain Skinning: the formula of a vertex, mistakes on purpose, the matrix stack.

use super::{Story, differing};
use crate::collada::support::{Skin, arm};
use crate::host::MemoryHost;
use editor_core::editor::{Edit, View};
use editor_core::io::image::{self, PictureFormat};
use egui::accesskit::{Action, ActionRequest, TreeId};
use egui::{Event, Key, Pos2, vec2};
use glam::Vec3;
use std::path::PathBuf;

/// The strip with its elbow bent by 90°, and the panel.
fn bent() -> Story {
    let mut story = Story::start(&["models/strip.obj"]);
    story.type_into("Elbow Z", "90");
    story.click("View");
    story.click("Explain Skinning");
    story
}

/// Scrolls to a mistake in the list, and clicks it.
pub(super) fn make(story: &mut Story, sentence: &str) {
    let nodes = story.widgets.iter().flat_map(|update| &update.nodes);
    let mut named = nodes.filter(|(_, node)| node.label() == Some(sentence));
    let target_node = named.next().expect("the mistake is listed").0;
    let request = ActionRequest {
        action: Action::ScrollIntoView,
        target_tree: TreeId::ROOT,
        target_node,
        data: None,
    };
    story.frame(vec![Event::AccessKitActionRequest(request)]);
    story.wait(1.0);
    story.click(sentence);
}

/// A point of the bent strip near its vertex 2, which both joints hold alike.
fn near_vertex_2(story: &Story) -> Pos2 {
    story.at(Vec3::new(0.09, 1.05, 0.0))
}

const ELBOW: &str = "Elbow: w 0.500, B⁻¹ · v (0.200, 0.000, 0.000), \
                     T · B⁻¹ · v (0.000, 1.200, 0.000), w · T · B⁻¹ · v (0.000, 0.600, 0.000)";
const HIP: &str = "Hip: w 0.500, B⁻¹ · v (0.200, 1.000, 0.000), \
                   T · B⁻¹ · v (0.200, 1.000, 0.000), w · T · B⁻¹ · v (0.100, 0.500, 0.000)";
const SUM: &str = "Sum (0.100, 1.100, 0.000)";
pub(super) const NO_INVERSE: &str = "Vertices are moved by T alone, without the inverse of B";

#[test]
fn a_click_on_the_mesh_shows_the_formula_of_the_nearest_vertex_in_numbers() {
    let mut story = bent();
    let document = story.session().document();
    assert!(story.has("v' = Σ w · T · B⁻¹ · v"));
    let at = near_vertex_2(&story);
    story.click_at(at);
    assert!(story.has(HIP) && story.has(ELBOW) && story.has(SUM));
    // The exact path has the vertex there.
    let shape = story.session().evaluated().shape(story.shape().id).unwrap();
    assert!(shape.geometry.positions()[2].abs_diff_eq(Vec3::new(0.1, 1.1, 0.0), 1e-6));
    // A row has its matrices, and lights its joint.
    story.click(ELBOW);
    let of_elbow = "T of Elbow: 0.000 -1.000 0.000 0.000; 1.000 0.000 0.000 1.000; \
                    0.000 0.000 1.000 0.000; 0.000 0.000 0.000 1.000";
    assert!(story.has(of_elbow));
    let inverse = "B⁻¹ of Elbow: 1.000 0.000 0.000 0.000; 0.000 1.000 0.000 -1.000; \
                   0.000 0.000 1.000 0.000; 0.000 0.000 0.000 1.000";
    assert!(story.has(inverse));
    assert_eq!(story.session().hovered_joint(), Some(2));
    let row = story.place(HIP);
    story.point(row);
    story.settle();
    assert_eq!(story.session().hovered_joint(), Some(1));
    // Another vertex is typed as a diagnosis names it.
    story.type_into("Vertex", "4");
    assert!(story.has("Sum (-1.000, 1.200, 0.000)"));
    assert_eq!(story.session().document(), document);
    assert_eq!(story.shape().name, "Strip");
}

#[test]
fn the_first_vertex_is_one_that_the_joint_at_hand_moves() {
    let mut story = Story::start(&["builtin:adult"]);
    story.size = (1280, 1000);
    story.settle();
    story.click("Left elbow");
    assert!(story.session().selected_joint().is_some());
    story.click("View");
    story.click("Explain Skinning");
    let numbers = |story: &Story| {
        let mut nodes = story.widgets.iter().flat_map(|update| &update.nodes);
        let row =
            nodes.find_map(|(_, node)| node.label().filter(|it| it.starts_with("Left elbow: w")));
        row.map(str::to_owned)
    };
    let before = numbers(&story);
    story.type_into("Left elbow Z", "60");
    assert!(before.is_some() && numbers(&story).is_some() && numbers(&story) != before);
    // With no joint at hand it is one that the pose moves.
    let mut story = Story::start(&["builtin:adult"]);
    story.size = (1280, 1000);
    story.settle();
    story.type_into("Right knee X", "50");
    story.key(Key::Escape);
    story.click("View");
    story.click("Explain Skinning");
    assert!(story.session().selected_joint().is_none());
    let mut nodes = story.widgets.iter().flat_map(|update| &update.nodes);
    assert!(nodes.any(|(_, node)| {
        let label = node.label().unwrap_or_default();
        label.starts_with("Right knee: w")
    }));
}

#[test]
fn until_the_pose_changes_the_panel_says_that_its_numbers_follow() {
    let says = "Drag a joint's numbers at the right, or its bone with the Pose tool, and watch these change.";
    let first =
        "Select the character, drag a joint's numbers at the right, and watch these change.";
    let mut story = bent();
    assert!(story.has_text(says));
    story.type_into("Vertex", "2");
    assert!(story.has_text(says), "the pose is the same");
    story.type_into("Elbow Z", "60");
    assert!(!story.has_text(says));
    story.key(Key::K);
    story.key(Key::K);
    assert!(story.has_text(says), "it was opened anew");
    let session = story.program.session_mut();
    session.look(editor_core::editor::View::Select(None));
    story.settle();
    assert!(story.has_text(first) && !story.has_text(says));
}

#[test]
fn a_tiny_character_has_its_numbers_in_a_power_of_ten() {
    let host = MemoryHost {
        stored: [super::started_before()].into(),
        files: [
            (
                "tiny.obj",
                "v -2e-4 0 0\nv 2e-4 0 0\nv 2e-4 1e-3 0\nv -2e-4 1e-3 0\n\
                 v 2e-4 2e-3 0\nv -2e-4 2e-3 0\nf 1 2 3\nf 1 3 4\nf 4 3 5\nf 4 5 6\n",
            ),
            (
                "tiny.skel",
                "0 0 0 -1 # Root\n0 0 0 0 # Hip\n0 1e-3 0 1 # Elbow\n",
            ),
            ("tiny.attach", "1 0\n1 0\n0.5 0.5\n0.5 0.5\n0 1\n0 1\n"),
        ]
        .map(|(path, text)| (PathBuf::from(path), text.into()))
        .into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, &["tiny.obj"]);
    story.type_into("Elbow Z", "90");
    story.click("View");
    story.click("Explain Skinning");
    story.type_into("Vertex", "2");
    assert!(story.has_text("Coordinates × 1e-3"));
    // The same numbers as those of the strip, which is a thousand times as large.
    assert!(story.has(HIP) && story.has(ELBOW) && story.has(SUM));
    story.click("Matrix Stack");
    assert!(story.has_text("Coordinates × 1e-3"));
}

#[test]
fn the_numbers_follow_while_a_joint_is_dragged_and_the_arrows_end_at_the_vertex() {
    let mut story = bent();
    let without = story.picture();
    let at = near_vertex_2(&story);
    story.click_at(at);
    let arrows = story.picture();
    assert!(differing(&without, &arrows) > 200);
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(-90.0, 0.0));
    assert!(story.session().is_in_gesture());
    // At rest again: both joints have the vertex at (0.2, 1, 0).
    assert!(story.has("Sum (0.200, 1.000, 0.000)"));
    story.key(Key::Escape);
    story.button(false);
    story.settle();
    assert!(story.has(SUM));
}

#[test]
fn what_is_fitted_into_the_view_is_the_mesh_that_a_mistake_shows() {
    let mut story = bent();
    story.key(Key::F);
    let right = story.session().view().camera;
    story.key(Key::F);
    assert_eq!(story.session().view().camera, right);
    make(&mut story, NO_INVERSE);
    story.key(Key::F);
    let wrong = story.session().view().camera;
    assert_ne!(wrong, right);
    story.key_with(egui::Modifiers::SHIFT, Key::F);
    assert_eq!(
        story.session().view().camera,
        wrong,
        "nothing else is there"
    );
}

#[test]
fn a_mistake_is_shown_in_the_view_and_in_the_formula_and_nowhere_else() {
    let mut story = bent();
    story.size = (1280, 1000);
    story.settle();
    let at = near_vertex_2(&story);
    story.click_at(at);
    story.save_view((300, 200), "right.png");
    story.click("File");
    story.click("Export Geometry…");
    story.choose("right.obj");
    let (right, document) = (story.scene_picture(), story.session().document());
    let steps = story.session().done_steps();
    make(&mut story, NO_INVERSE);
    assert!(differing(&right, &story.scene_picture()) > 500);
    assert!(story.has("v' = Σ w · T · v"));
    // T alone takes the vertex to (-1, 1.2, 0) by the elbow.
    let elbow = "Elbow: w 0.500, T · v (-1.000, 1.200, 0.000), w · T · v (-0.500, 0.600, 0.000)";
    assert!(story.has(elbow) && story.has("Sum (-0.400, 1.100, 0.000)"));
    assert!(story.has("Right (0.100, 1.100, 0.000)"));
    assert!(story.has_text("⚠ Shown wrong on purpose"));
    let elsewhere = "It reaches far out of the picture: F fits it, and Shift+F everything.";
    assert!(!story.has_text(elsewhere));

    // Neither the document nor what is written of it knows of the mistake.
    assert_eq!(story.session().document(), document);
    assert_eq!(story.session().done_steps(), steps);
    let shape = story.session().evaluated().shape(story.shape().id).unwrap();
    assert!(shape.geometry.positions()[2].abs_diff_eq(Vec3::new(0.1, 1.1, 0.0), 1e-6));
    story.save_view((300, 200), "wrong.png");
    story.click("File");
    story.click("Export Geometry…");
    story.choose("wrong.obj");
    let written = |name: &str| &story.host.written[std::path::Path::new(name)];
    assert_eq!(written("right.png"), written("wrong.png"));
    assert_eq!(written("right.obj"), written("wrong.obj"));

    // It follows a joint, and its mesh is what is clicked.
    let wrong = story.scene_picture();
    story.type_into("Elbow Z", "60");
    assert!(differing(&wrong, &story.scene_picture()) > 500);
    story.type_into("Elbow Z", "90");
    assert_eq!(differing(&wrong, &story.scene_picture()), 0);
    story.type_into("Vertex", "0");
    assert!(story.has("Sum (-0.200, 0.000, 0.000)"));
    // Where the strip as it is has its vertex 3.
    let wrong = story.at(Vec3::new(-0.49, 1.095, 0.0));
    story.click_at(wrong);
    assert!(story.has("Sum (-0.400, 1.100, 0.000)"), "vertex 2");

    story.click("Back to Correct");
    assert_eq!(differing(&right, &story.scene_picture()), 0);
    assert!(!story.has("Back to Correct") && story.has("v' = Σ w · T · B⁻¹ · v"));
}

#[test]
fn esc_ends_the_mistake_then_the_panel_and_then_what_it_ended_before() {
    let mut story = bent();
    story.click("Close Explain");
    let closed = story.scene_picture();
    story.key(Key::K);
    let right = story.scene_picture();
    make(&mut story, NO_INVERSE);
    story.key(Key::Escape);
    assert_eq!(differing(&right, &story.scene_picture()), 0);
    assert!(story.has("Close Explain") && !story.has("Back to Correct"));
    story.key(Key::Escape);
    assert!(!story.has("Close Explain"));
    assert_eq!(story.shape().name, "Strip");
    // The joint whose number bent it, and the shape.
    story.key(Key::Escape);
    assert!(story.session().selected_joint().is_none());
    story.key(Key::Escape);
    assert!(story.session().selected().is_none());
    story.click("[1] Strip (ID: 1)");
    story.key(Key::K);
    make(&mut story, NO_INVERSE);
    story.click("Close Explain");
    assert_eq!(differing(&closed, &story.scene_picture()), 0);
    story.key(Key::K);
    assert!(!story.has("Back to Correct"), "closing has ended it");
    assert!(!story.host.quits);
}

#[test]
fn a_mistake_looks_the_same_whoever_skins_and_a_mistake_that_makes_no_difference_says_so() {
    let mut story = bent();
    let right = story.scene_picture();
    make(&mut story, NO_INVERSE);
    let mut pictures = Vec::new();
    for skinning in ["Processor", "Graphics Card"] {
        story.click("View");
        story.click("Skinning");
        story.click(skinning);
        pictures.push(story.scene_picture());
    }
    assert!(differing(&right, &pictures[0]) > 500);
    assert_eq!(differing(&pictures[0], &pictures[1]), 0);
    story.click("Back to Correct");
    story.click("Reset all");
    let right = story.scene_picture();
    make(
        &mut story,
        "Rotations are transposed, so that joints turn the other way",
    );
    assert_eq!(differing(&right, &story.scene_picture()), 0);
    assert!(story.has_text("At rest it makes no difference: turn some joints."));
}

#[test]
fn a_collada_character_has_its_formula_and_mistakes_too() {
    let mut story = Story::start(&["builtin:lizard"]);
    story.key(Key::K);
    let right = story.scene_picture();
    make(&mut story, NO_INVERSE);
    assert!(differing(&right, &story.scene_picture()) > 500);
    story.key(Key::Escape);
    assert_eq!(differing(&right, &story.scene_picture()), 0);
}

#[test]
fn the_matrix_stack_goes_over_the_skeleton_step_by_step() {
    let mut story = bent();
    story.click("Matrix Stack");
    assert!(
        story.has_text(
            "Step 0 of 9: Nothing is pushed yet: top() of an empty stack is the identity"
        )
    );
    for _ in 0..7 {
        story.click("Step");
    }
    // Root, hip and elbow were pushed; root, hip and elbow drawn; the elbow popped.
    assert!(story.has_text("Step 7 of 9: pop: all that hangs on Elbow is done, take its T off"));
    assert!(story.has("Elbow, drawn") && story.has("Hip, on the stack"));
    assert_eq!(story.session().hovered_joint(), Some(2));
    // The pointer is on the button, and not on the joint that this has lit.
    assert!(named(&story, "Click to select the joint").is_empty());
    for _ in 0..2 {
        story.click("Back");
    }
    let words = "push: multiply the top by Elbow's own transform and put the product on top";
    assert!(story.has_text(&format!("Step 5 of 9: {words}")));
    let top = "Top of the stack, Elbow: 0.000 -1.000 0.000 0.000; 1.000 0.000 0.000 1.000; \
               0.000 0.000 1.000 0.000; 0.000 0.000 0.000 1.000";
    assert!(story.has(top));
    story.click("To Start");
    story.click("Play");
    for done in 1..=9 {
        story.wait(0.7);
        let nodes = story.widgets.iter().flat_map(|update| &update.nodes);
        let said = nodes.filter_map(|(_, node)| node.value());
        let begins = format!("Step {done} of 9");
        assert!(
            said.into_iter().any(|text| text.starts_with(&begins)),
            "{begins}"
        );
    }
    story.click("Formula");
    assert!(story.has("v' = Σ w · T · B⁻¹ · v"));
}

#[test]
fn whose_formula_it_is_stands_beside_the_tabs_and_is_none() {
    let story = bent();
    assert!(story.has("Formula") && story.has("Matrix Stack"));
    assert!(story.has_text("of Strip"));
    assert!(!story.has_text("Strip"), "it would be taken for a tab");
}

#[test]
fn the_heading_of_a_matrix_is_one_line_however_many_are_on_the_stack() {
    let mut story = bent();
    story.click("Matrix Stack");
    for _ in 0..5 {
        story.click("Step");
    }
    for heading in ["Top: Elbow", "Elbow, own"] {
        let height = story.text_place(heading).height();
        assert!(height < 20.0, "{heading}: {height}");
    }
}

#[test]
fn the_row_of_the_joint_of_a_step_is_in_sight() {
    let mut story = Story::start(&["builtin:adult"]);
    story.key(Key::K);
    story.click("Matrix Stack");
    for _ in 0..40 {
        story.click("Step");
    }
    story.wait(1.0);
    let room = |story: &Story| story.place("Step").y + 40.0..story.size.1 as f32 - 24.0;
    let joint = story
        .session()
        .hovered_joint()
        .expect("the joint of the step");
    let name = &story.character().character.skeleton().joints()[joint].name;
    let states = ["on the stack", "drawn"].map(|state| format!("{name}, {state}"));
    let row = states.iter().find(|row| story.has(row)).expect("its row");
    let at = story.place(row).y;
    assert!(room(&story).contains(&at), "{row}: {at}");
    story.click("To Start");
    story.wait(1.0);
    let at = story.place("Root, not yet").y;
    assert!(room(&story).contains(&at), "{at}");
}

#[test]
fn another_document_has_no_mistake_and_a_scene_without_characters_nothing_to_explain() {
    let mut story = bent();
    make(&mut story, NO_INVERSE);
    assert!(story.has("Back to Correct"));
    let top = story.place("Close Explain");
    story.click("Delete");
    assert!(!story.has("Back to Correct"));
    story.settle();
    assert_eq!(story.place("Close Explain"), top, "as high as before");
    assert!(story.has_text("There is no character to explain. Insert one."));
    story.click("Close Explain");
    story.key(Key::K);
    assert!(!story.has("Close Explain"), "the command is disabled");

    let mut story = bent();
    make(&mut story, NO_INVERSE);
    story.host.drop_file("models/strip.obj");
    story.settle();
    assert!(
        story.has("Back to Correct"),
        "an import is no other document"
    );
    story.click("File");
    story.click("New");
    story.click("Don't Save");
    story.host.drop_file("models/strip.obj");
    story.settle();
    assert!(!story.has("Back to Correct"));
}

#[test]
fn a_comparison_with_a_picture_closes_the_panel_and_ends_the_mistake() {
    let mut story = bent();
    make(&mut story, NO_INVERSE);
    let reference = story.scene_picture();
    let bytes = image::encode(&reference, PictureFormat::Png).expect("a picture");
    story.host.files.insert("reference.png".into(), bytes);
    story.key(Key::F8);
    story.choose("reference.png");
    assert!(!story.has("Back to Correct") && !story.has("Close Explain"));
    let told = story.messages();
    assert!(
        told.iter()
            .any(|(_, text)| text.starts_with("Skinning is not explained"))
    );
}

/// Labels with `words` in them, and where they are.
fn named(story: &Story, words: &str) -> Vec<(String, egui::accesskit::Rect)> {
    let nodes = story.widgets.iter().flat_map(|update| &update.nodes);
    let labels = nodes.filter_map(|(_, node)| {
        let text = node.label().or(node.value())?;
        Some((text.to_owned(), node.bounds()?))
    });
    labels.filter(|(label, _)| label.contains(words)).collect()
}

#[test]
fn of_several_characters_the_banner_of_a_mistake_names_the_one_that_is_shown_wrong_and_says_if_it_is_hidden()
 {
    let mut story = bent();
    let strip = story.shape().id;
    story.host.drop_file("builtin:adult");
    story.settle();
    let seen = |story: &mut Story, view| {
        story.program.session_mut().look(view);
        story.settle();
    };
    seen(&mut story, View::Select(Some(strip)));
    make(&mut story, NO_INVERSE);
    assert!(story.has_text("⚠ Strip is shown wrong on purpose"));
    let adult = story.session().scene().shapes()[1].id;
    let hides = Edit::SetVisible(adult, false);
    story
        .program
        .session_mut()
        .edit(hides)
        .expect("it is there");
    seen(&mut story, View::Select(Some(adult)));
    assert!(story.has_text("⚠ Adult is shown wrong on purpose"));
    let hidden = "It is hidden: the eye in the Shape Selector shows it.";
    assert!(story.has_text(hidden));
    seen(&mut story, View::Select(Some(strip)));
    assert!(!story.has_text(hidden));
}

#[test]
fn in_a_small_view_the_banner_of_a_mistake_leaves_the_figure_in_sight() {
    let mut story = bent();
    story.size = (1280, 1000);
    story.settle();
    make(&mut story, NO_INVERSE);
    let sentence = "Vertices are moved by T alone, without the inverse of B.";
    assert!(story.has_text(sentence));
    story.size = (800, 600);
    story.settle();
    assert!(!story.has_text(sentence));
    // Beside its words the figure can be reached: a drag there is one in the view.
    let [(_, title)] = &named(&story, "Shown wrong on purpose")[..] else {
        panic!("{:?}", named(&story, "Shown wrong on purpose"));
    };
    let figure = egui::pos2(story.view().center().x, (title.y0 + title.y1) as f32 / 2.0);
    let before = story.session().view().camera;
    story.drag(figure, figure + egui::vec2(0.0, 30.0));
    assert_ne!(story.session().view().camera, before);
    story.click("Back to Correct");
    assert!(!story.has("Back to Correct"));
}

#[test]
fn a_mistake_that_takes_the_figure_away_says_how_to_see_it_and_the_stack_that_it_has_no_part_in_it()
{
    let mut story = bent();
    story.size = (1280, 1000);
    story.settle();
    let elsewhere = "It reaches far out of the picture: F fits it, and Shift+F everything.";
    make(&mut story, NO_INVERSE);
    assert!(!story.has_text(elsewhere), "it is in sight");
    // As who looks at another part of it.
    let at = story.view().center();
    story.point(at);
    let mut camera = story.session().view().camera;
    camera.target += Vec3::X * 9.0;
    story.program.session_mut().look(View::SetCamera(camera));
    story.settle();
    assert!(story.has_text(elsewhere));
    story.key(Key::F);
    assert!(!story.has_text(elsewhere));
    story.click("Matrix Stack");
    let right = "These are the right matrices; what the mistake changes is in the formula.";
    assert!(story.has_text(right));
    story.click("Back to Correct");
    assert!(!story.has_text(right));
}

/// A story with a character of a Collada file, and the panel.
fn of_collada_file() -> Story {
    let mut host = MemoryHost::default();
    let file = arm(&Skin::default()).into_bytes();
    host.files.insert("arm.dae".into(), file);
    let mut story = Story::start_at(host, &["arm.dae"]);
    story.key(Key::K);
    story
}

#[test]
fn the_matrices_of_a_term_are_in_sight_however_many_there_are() {
    let mut story = of_collada_file();
    story.size = (1280, 1000);
    story.settle();
    make(
        &mut story,
        "The inverse of B and T are multiplied the wrong way round",
    );
    let last = "with those of a Collada file, whose axes are converted last";
    story.click(last);
    let letters = "A leads from the file's axes and units to the program's. R has the directions of the bone in the file.";
    assert!(story.has_text(letters));
    let row = named(&story, ", A⁻¹ · v (")[0].0.clone();
    story.click(&row);
    let matrices = named(&story, " of Name a: ");
    assert_eq!(matrices.len(), 7, "six factors and their product");
    let list = named(&story, last)[0].1.x0;
    for (matrix, bounds) in matrices {
        assert!(bounds.x1 <= list, "{matrix} ends at {}", bounds.x1);
    }
}

#[test]
fn of_a_collada_file_mistakes_are_told_by_what_such_a_file_has() {
    let mut story = of_collada_file();
    story.size = (1280, 1000);
    story.settle();
    let shifted = "The weights of each joint are taken for the joint before it";
    make(&mut story, shifted);
    assert!(story.has_text("⚠ Shown wrong on purpose"));
    let banner = format!("{shifted}: the first one for the root.");
    assert!(story.has_text(&banner), "in words without columns");
}

#[test]
fn a_click_on_a_bone_selects_its_joint_and_explains_the_vertex_there_or_the_nearest_one() {
    let mut story = Story::start(&["builtin:adult"]);
    story.size = (800, 600);
    story.settle();
    story.click("Both");
    story.click("View");
    story.click("Explain Skinning");
    let number = |story: &Story| {
        let field = story.node("Vertex").and_then(|node| node.value());
        field.expect("the number of the vertex").to_owned()
    };
    let skeleton = story.character().character.skeleton();
    let places = skeleton.bind_positions();
    let index = |name: &str| {
        let mut joints = skeleton.joints().iter();
        joints.position(|joint| joint.name == name).unwrap()
    };
    let [knee, foot] = ["Left knee", "Left foot"].map(index);
    let middle = story.at(places[knee].lerp(places[foot], 0.5));
    let mut known = vec![number(&story)];
    let beside = story.at(places[knee].lerp(places[foot], 0.6)) + vec2(11.0, 0.0);
    story.point(middle);
    let nodes = story.widgets.iter().flat_map(|update| &update.nodes);
    let mut texts = nodes.filter_map(|(_, node)| node.value());
    assert!(texts.any(|text| text.starts_with("Click to explain the vertex there")));
    for at in [middle, beside] {
        story.click_at(at);
        assert!(story.session().selected_joint().is_some());
        let explained = number(&story);
        assert!(!known.contains(&explained), "{explained} {known:?}");
        known.push(explained);
    }
}
