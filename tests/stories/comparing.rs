//! Comparing the view with a picture, whose measuring is done beside the program.

use super::Story;
use crate::host::MemoryHost;
use crate::reference_data::{course, reference};
use editor_core::character::Pose;
use editor_core::compare::Area;
use editor_core::editor::{Edit, View};
use editor_core::geometry::Picture;
use editor_core::io::image::{self, PictureFormat};
use editor_core::math::{Euler, Transform};
use editor_core::program::{HostEvent, Purpose, RunningJob};
use editor_core::scene::{
    BoneStyle, Camera, CharacterDisplay, CurveDisplay, Look, ModelDisplay, NewShape, ShapeColor,
    ShapeId, ShapeKind, SurfaceVisibility,
};
use editor_core::ui::{Action, Ask, CompareAction, CompareSettings, course_panels};
use egui::{Key, Modifiers, vec2};
use glam::Vec3;
use std::path::Path;
use std::time::Duration;

/// A story in which the strip is compared with a picture of itself, of 300 by 200 pixels.
fn comparing() -> Story {
    let mut story = compared();
    smooth_edges(&mut story);
    story
}

/// The same with the edges that the program finds.
fn compared() -> Story {
    let mut story = Story::start(&["models/strip.obj"]);
    compare_with_itself(&mut story, (300, 200));
    assert_eq!(
        story.host.requests.last().unwrap().purpose,
        Purpose::Compare
    );
    story
}

/// Shows the scene in a look, in a window in which all that is told of a comparison is seen.
fn show_in(story: &mut Story, look: Look) {
    story.size = (1000, 1300);
    let seen = vec![Action::View(View::SetLook(look))];
    story.program.carry_out(seen, &mut story.host);
    story.settle();
}

/// Keeps a picture of the view of this size as `mine.png`.
fn keep_picture(story: &mut Story, size: (u32, u32)) {
    story.save_view(size, "mine.png");
    let saved = story.host.written[Path::new("mine.png")].clone();
    story.host.files.insert("mine.png".into(), saved);
}

/// Compares the view with a picture of it of this size.
fn compare_with_itself(story: &mut Story, size: (u32, u32)) {
    keep_picture(story, size);
    story.key(Key::F8);
    story.choose("mine.png");
    assert!(story.has("Stop comparing"));
}

const EQUAL: &str = "1.00000, 0.00000";

#[test]
fn a_document_that_is_opened_beside_a_picture_in_another_look_than_the_courses_is_shown_as_it_is_without()
 {
    let mut story = Story::start(&["builtin:robot"]);
    let seen = Action::View(View::SetLook(Look::Mannequin));
    story.program.carry_out(vec![seen], &mut story.host);
    story.settle();
    compare_with_itself(&mut story, (300, 200));
    story.key_with(Modifiers::COMMAND, Key::O);
    story.choose("builtin:rigs/lizard");
    assert!(!story.has("Stop comparing"));
    let alone = Story::start(&["builtin:rigs/lizard"]);
    let [view, expected] = [&story, &alone].map(|story| *story.session().view());
    assert_eq!(view.camera, expected.camera);
    assert_ne!(view.look, Look::Course);
}

/// Gives the live view smooth edges, which pictures that are saved here have.
fn smooth_edges(story: &mut Story) {
    choose_edges(story, true);
}

fn choose_edges(story: &mut Story, smooth_edges: bool) {
    let settings = CompareSettings {
        smooth_edges,
        ..CompareSettings::default()
    };
    let set = Action::Ask(Ask::Compare(CompareAction::Set(settings)));
    story.program.carry_out(vec![set], &mut story.host);
    story.settle();
}

/// Runs the jobs that wait, and lets the program take what came of them.
fn measure(story: &mut Story) -> usize {
    let count = story.host.run_jobs();
    story.settle();
    count
}

/// Measures everything, also what waits until the view stands still.
fn judge(story: &mut Story) {
    while measure(story) > 0 {}
    story.wait(0.2);
    while measure(story) > 0 {}
}

/// A story in which the slower half of a comparison has begun and is a few steps on its way.
fn judging() -> (Story, RunningJob) {
    let mut story = comparing();
    bend(&mut story);
    loop {
        story.wait(0.2);
        let job = story
            .host
            .jobs
            .pop()
            .expect("there is something to measure");
        let mut job = job.begin();
        let result = (0..60).find_map(|_| job.step());
        match result {
            // The quicker half needs fewer steps.
            Some(result) => story.host.events.push_back(HostEvent::Finished(result)),
            None => return (story, job),
        }
    }
}

/// Bends the strip, so that it differs from its picture.
fn bend(story: &mut Story) {
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(40.0, 0.0));
    story.button(false);
    story.settle();
}

#[test]
fn a_picture_that_was_saved_here_is_equal_without_a_choice_of_edges() {
    let mut story = compared();
    judge(&mut story);
    let told = texts(&story);
    let equal = "A and B are equal, pixel by pixel.";
    assert!(told.iter().any(|text| text == equal), "{told:?}");
}

#[test]
fn what_is_off_is_near_the_joint_that_was_turned() {
    for joint in ["Right foot", "Left knee", "Right elbow"] {
        let mut story = Story::start(&["builtin:adult"]);
        // All joints are listed.
        story.size = (1000, 1300);
        story.settle();
        compare_with_itself(&mut story, (600, 450));
        judge(&mut story);
        story.type_into(&format!("{joint} X"), "40");
        judge(&mut story);
        let near = format!("Near {joint}");
        let told = texts(&story);
        assert!(
            told.iter().any(|text| text.starts_with(&near)),
            "{joint}: {told:?}"
        );
    }
}

/// The places that are told, each before its share of the figure.
fn places(story: &Story) -> Vec<String> {
    told_before_shares(story, "Near ")
}

/// The characters that are told as a whole.
fn whole(story: &Story) -> Vec<String> {
    told_before_shares(story, "All of ")
}

fn told_before_shares(story: &Story, begin: &str) -> Vec<String> {
    let texts = texts(story);
    let places = texts.iter().filter_map(|text| text.strip_prefix(begin));
    let places = places.map(|text| text.split_once(", in").unwrap().0.to_owned());
    places.collect()
}

#[test]
fn each_limb_that_is_off_is_told_and_each_other_shape() {
    // Also of a figure that is small in the picture.
    for away in [1.0, 2.5] {
        let mut story = Story::start(&["builtin:adult"]);
        story.size = (1000, 1300);
        let mut camera = story.session().view().camera;
        camera.radius *= away;
        story.program.session_mut().look(View::SetCamera(camera));
        story.settle();
        compare_with_itself(&mut story, (600, 450));
        judge(&mut story);
        for joint in ["Right elbow", "Left foot", "Neck"] {
            story.type_into(&format!("{joint} X"), "40");
        }
        judge(&mut story);
        let mut told = places(&story);
        told.sort_unstable();
        let texts = texts(&story);
        assert_eq!(
            told,
            ["Left foot", "Neck", "Right elbow"],
            "{away}: {texts:?}"
        );
    }
}

#[test]
fn a_limb_of_one_character_among_others_is_told_beside_a_shape_that_is_elsewhere_and_throws_its_shadow_there()
 {
    let mut percents = Vec::new();
    for look in [Look::Course, Look::Studio] {
        let mut story = Story::start(&["builtin:adult", "builtin:adult", "builtin:goblet"]);
        show_in(&mut story, look);
        compare_with_itself(&mut story, (600, 450));
        judge(&mut story);
        let [adult, _, goblet] = <[&str; 3]>::try_from(story.names())
            .unwrap()
            .map(str::to_owned);
        for moves_both in [false, true] {
            story.click(&format!("[3] {goblet} (ID: 3)"));
            story.type_into("Position Y", "0.6");
            let mut expected = vec![goblet.clone()];
            if moves_both {
                story.click(&format!("[1] {adult} (ID: 1)"));
                story.type_into("Neck X", "40");
                expected.push(format!("Neck of {adult}"));
            }
            judge(&mut story);
            let mut told = places(&story);
            told.sort_unstable();
            assert_eq!(told, expected, "{look:?}: {:?}", texts(&story));
            let texts = texts(&story).into_iter();
            let mut of_goblet = texts.filter(|it| it.starts_with(&format!("Near {goblet}")));
            let told = of_goblet.next().expect("it is told");
            let (_, share) = told.split_once("in about ").expect("a share");
            let percent: u32 = share.split(' ').next().unwrap().parse().unwrap();
            percents.push(percent);
        }
    }
    // Of the figures, however large the picture is about them.
    let (course, studio) = (percents[0], percents[2]);
    assert!(course.abs_diff(studio) <= 10, "{percents:?}");
}

/// What is told where the view has turned these joints, in degrees about X, since the picture was saved: each has its angle in
/// the picture and the one in the view.
fn told_of(look: Look, joints: &[(&str, f32, f32)]) -> Vec<String> {
    let mut story = Story::start(&["builtin:adult"]);
    show_in(&mut story, look);
    for (joint, in_picture, _) in joints {
        story.type_into(&format!("{joint} X"), &in_picture.to_string());
    }
    compare_with_itself(&mut story, (800, 600));
    judge(&mut story);
    for (joint, _, in_view) in joints {
        story.type_into(&format!("{joint} X"), &in_view.to_string());
    }
    judge(&mut story);
    places(&story)
}

#[test]
fn a_limb_is_told_whatever_is_before_it_or_was() {
    for look in [Look::Course, Look::Studio] {
        // A leg that was raised before the belly, and that is now.
        assert_eq!(told_of(look, &[("Left leg", -75.0, 0.0)]), ["Left leg"]);
        assert_eq!(told_of(look, &[("Left leg", 0.0, -75.0)]), ["Left leg"]);
        // One that is turned a little covers much of where it was.
        assert_eq!(told_of(look, &[("Right leg", -30.0, 5.0)]), ["Right leg"]);
        // A thigh behind a hand that stays there.
        let hand = ("Right shoulder", -35.0, -35.0);
        let told = told_of(look, &[hand, ("Right leg", 0.0, -30.0)]);
        assert_eq!(told, ["Right leg"]);
        let told = told_of(look, &[hand, ("Right leg", -30.0, 0.0)]);
        assert_eq!(told, ["Right leg"]);
    }
}

/// An adult beside two other shapes in a look, compared with a picture of it.
fn adult_beside_shapes(look: Look) -> Story {
    let mut story = Story::start(&["builtin:adult", "builtin:goblet", "builtin:gem"]);
    show_in(&mut story, look);
    story.click("[1] Adult (ID: 1)");
    compare_with_itself(&mut story, (640, 480));
    judge(&mut story);
    story
}

#[test]
fn a_character_that_is_moved_turned_or_scaled_is_told_as_a_whole_beside_what_stands_still() {
    let limbs = [
        ("Left leg", "20"),
        ("Left shoulder", "25"),
        ("Neck", "25"),
        ("Right leg", "-20"),
        ("Right shoulder", "-25"),
    ];
    for look in [Look::Course, Look::Studio] {
        for (field, value) in [
            ("Position X", "0.05"),
            ("Position Z", "0.3"),
            ("Rotation Y", "60"),
            ("Uniform Scale", "1.15"),
            ("Root Y", "60"),
        ] {
            let mut story = adult_beside_shapes(look);
            story.type_into(field, value);
            judge(&mut story);
            let texts = texts(&story);
            assert_eq!(whole(&story), ["Adult"], "{look:?} {field}: {texts:?}");
            assert_eq!(places(&story), [""; 0], "{look:?} {field}: {texts:?}");
            // Nor is a camera to blame where other shapes stand still.
            let is_of_camera = |text: &String| text.contains("camera that the course's program");
            assert!(!texts.iter().any(is_of_camera), "{texts:?}");
        }
        // A figure all limbs of which are turned stands where it was.
        let mut story = adult_beside_shapes(look);
        for (joint, degrees) in limbs {
            story.type_into(&format!("{joint} Z"), degrees);
        }
        judge(&mut story);
        let mut told = places(&story);
        told.sort_unstable();
        assert_eq!(told, limbs.map(|(joint, _)| joint));
        assert_eq!(whole(&story), [""; 0]);
    }
}

/// The course's character, which is selected, beside another shape in a look; `None` without the reference data. It has no
/// weights for the root, and hardly a vertex that the chest or the waist moves alone.
fn course_character_beside_shape(look: Look) -> Option<Story> {
    course_character(look, &["models/Model1.obj", "builtin:goblet"])
}

/// A host with the files of the course's first character.
fn course_host() -> Option<MemoryHost> {
    let mut host = MemoryHost {
        stored: [crate::stories::started_before()].into(),
        ..MemoryHost::default()
    };
    for extension in ["obj", "skel", "attach"] {
        let name = format!("Model1.{extension}");
        let bytes = std::fs::read(course(&format!("characters/{name}"))?).unwrap();
        host.files.insert(format!("models/{name}").into(), bytes);
    }
    Some(host)
}

/// The same of these files.
fn course_character(look: Look, files: &[&str]) -> Option<Story> {
    let mut story = Story::start_at(course_host()?, files);
    show_in(&mut story, look);
    story.click("[1] Model1 (ID: 1)");
    Some(story)
}

#[test]
fn the_courses_character_is_told_as_a_whole_though_nothing_of_its_root_is_seen() {
    for look in [Look::Course, Look::Studio] {
        for (field, value) in [
            ("Position X", "0.04"),
            ("Rotation Y", "30"),
            ("Uniform Scale", "0.8"),
        ] {
            let Some(mut story) = course_character_beside_shape(look) else {
                return;
            };
            compare_with_itself(&mut story, (640, 480));
            judge(&mut story);
            story.type_into(field, value);
            judge(&mut story);
            let texts = texts(&story);
            assert_eq!(whole(&story), ["Model1"], "{look:?} {field}: {texts:?}");
            assert_eq!(places(&story), [""; 0], "{look:?} {field}: {texts:?}");
        }
    }
}

#[test]
fn a_character_that_is_moved_towards_the_eye_is_told_as_a_whole_though_some_of_it_hardly_moves() {
    let Some(mut story) = course_character_beside_shape(Look::Course) else {
        return;
    };
    // One leg points to the eye, so that it stays where it was.
    story.type_into("Left leg X", "-40");
    story.type_into("Right shoulder Z", "40");
    story.type_into("Position X", "-0.2");
    let mut camera = story.session().view().camera;
    camera.target = Vec3::new(0.227, 0.424, 0.282);
    camera.radius = 2.38;
    story.program.session_mut().look(View::SetCamera(camera));
    story.settle();
    compare_with_itself(&mut story, (1000, 750));
    judge(&mut story);
    story.type_into("Position Z", "0.1");
    judge(&mut story);
    let texts = texts(&story);
    assert_eq!(whole(&story), ["Model1"], "{texts:?}");
    assert_eq!(places(&story), [""; 0], "{texts:?}");
}

#[test]
fn edges_are_a_reason_for_differences_where_others_were_chosen_than_the_picture_has() {
    const HARD: &str = "A has smooth edges, and B hard ones: tick Smooth edges.";
    const SMOOTH: &str = "B has smooth edges";
    let is_told = |story: &Story| [HARD, SMOOTH].map(|hint| has_text(story, hint));
    let mut story = Story::start(&["builtin:adult"]);
    show_in(&mut story, Look::Course);
    compare_with_itself(&mut story, (400, 300));
    judge(&mut story);
    story.type_into("Left shoulder Z", "40");
    judge(&mut story);
    assert_eq!(is_told(&story), [false, false], "{:?}", texts(&story));
    choose_edges(&mut story, false);
    judge(&mut story);
    assert_eq!(is_told(&story), [true, false], "{:?}", texts(&story));
    let causes = upper_edge(&story, "If A has the camera");
    assert!(upper_edge(&story, HARD) < causes, "it comes first");
    choose_edges(&mut story, true);
    judge(&mut story);
    assert_eq!(is_told(&story), [false, false], "{:?}", texts(&story));
    // The course's look keeps the edges that the picture has.
    story.click("Studio look");
    judge(&mut story);
    story.click("Course look");
    judge(&mut story);
    assert_eq!(is_told(&story), [false, false], "{:?}", texts(&story));
    assert!(has_text(&story, "Near Left shoulder"));
}

#[test]
fn smooth_edges_are_found_though_the_figure_is_elsewhere_at_first() {
    for look in [Look::Course, Look::Studio, Look::Mannequin] {
        let mut story = Story::start(&["builtin:adult"]);
        show_in(&mut story, look);
        keep_picture(&mut story, (800, 600));
        story.type_into("Position X", "0.2");
        compare_with_kept(&mut story);
        let is_placed = |text: &String| text.to_lowercase().contains("the whole figure is moved ");
        assert!(
            texts(&story).iter().any(is_placed),
            "{look:?} {:?}",
            texts(&story)
        );
        story.type_into("Position X", "0");
        judge(&mut story);
        assert!(has_text(&story, EQUAL), "{look:?} {:?}", texts(&story));
    }
}

#[test]
fn a_character_of_another_color_is_not_said_to_be_elsewhere_or_turned() {
    for look in [Look::Course, Look::Studio] {
        for shapes in [&["builtin:adult"][..], &["builtin:adult", "builtin:goblet"]] {
            let mut story = Story::start(shapes);
            show_in(&mut story, look);
            story.click("[1] Adult (ID: 1)");
            compare_with_itself(&mut story, (800, 600));
            judge(&mut story);
            let adult = story.session().scene().shapes()[0].id;
            let color = Edit::SetColor(adult, ShapeColor::Custom(Vec3::new(0.9, 0.8, 0.1)));
            story
                .program
                .carry_out(vec![Action::Edit(color)], &mut story.host);
            for (turned, how) in [
                (
                    None,
                    "its outline agrees, so that its color, its light or Model Display Mode differs.",
                ),
                (
                    Some("Right knee X"),
                    "its color or light differs, and a part of its outline, or it is turned to another side.",
                ),
            ] {
                if let Some(field) = turned {
                    story.type_into(field, "60");
                }
                judge(&mut story);
                let texts = texts(&story);
                let told: Vec<&String> = texts
                    .iter()
                    .filter(|text| text.starts_with("All of Adult, in about "))
                    .collect();
                assert!(
                    matches!(&told[..], [one] if one.ends_with(how)) && places(&story).is_empty(),
                    "{look:?} {shapes:?} {turned:?}: {texts:?}"
                );
            }
        }
    }
}

#[test]
fn several_characters_that_are_shown_otherwise_are_told_and_no_camera() {
    let outline = "its outline agrees, so that its color, its light or Model Display Mode differs.";
    let shown = [
        (None, outline),
        (Some(ModelDisplay::Both), outline),
        (
            Some(ModelDisplay::Skeleton),
            "A shows its skeleton. Choose Skeletal Model for Model Display Mode to compare that.",
        ),
    ];
    for look in [Look::Course, Look::Studio] {
        for (mode, how) in shown {
            let mut story = Story::start(&["builtin:adult", "builtin:robot"]);
            show_in(&mut story, look);
            let shapes = story.session().scene().shapes().iter();
            let edits = shapes.map(|shape| match mode {
                Some(mode) => shown_as(&story, shape.id, mode, BoneStyle::Lines),
                None => Edit::SetColor(shape.id, ShapeColor::Custom(Vec3::new(0.9, 0.8, 0.1))),
            });
            let edits = edits.collect();
            beside_edits(&mut story, edits);
            let told = texts(&story);
            let mut names = whole(&story);
            names.sort_unstable();
            assert_eq!(names, ["Adult", "Robot"], "{look:?} {how} {told:?}");
            let alike = told.iter().filter(|text| text.starts_with("All of "));
            assert!(
                alike.clone().all(|text| text.ends_with(how)),
                "{look:?} {told:?}"
            );
            let is_wrong = |text: &String| text.contains("another camera");
            assert!(!told.iter().any(is_wrong), "{look:?} {told:?}");
        }
    }
}

#[test]
fn of_two_characters_each_is_told_how_it_differs() {
    let blue = ShapeColor::Custom(Vec3::new(0.1, 0.2, 0.9));
    let skeleton = "A shows its skeleton. Choose";
    let placed = "it is moved, turned or scaled as a whole, or";
    for (aside, [first, second]) in [
        (Some(0.05), [skeleton, placed]),
        (Some(0.4), [skeleton, placed]),
        // Far on the other side, where it lies about the first one and leaves nothing in its place.
        (Some(-1.9), [skeleton, "A shows nothing in its place."]),
        (
            None,
            [
                "",
                "its color or light differs, and it is moved, turned or scaled as a whole.",
            ],
        ),
    ] {
        let mut story = Story::start(&["builtin:adult", "builtin:robot"]);
        show_in(&mut story, Look::Course);
        let shapes = story.session().scene().shapes();
        let [one, other] = [0, 1].map(|at| shapes[at].id);
        let here = shapes[1].placement.transform;
        let mut edits = vec![];
        if let Some(aside) = aside {
            let aside = Transform {
                position: here.position + Vec3::X * aside,
                ..here
            };
            edits.push(shown_as(
                &story,
                one,
                ModelDisplay::Skeleton,
                BoneStyle::Lines,
            ));
            edits.push(Edit::SetTransform(other, aside));
        } else {
            let smaller = Transform {
                scale: 0.9 * here.scale,
                ..here
            };
            edits.push(Edit::SetTransform(other, smaller));
            edits.push(Edit::SetColor(other, blue));
        }
        beside_edits(&mut story, edits);
        let told = texts(&story);
        let how = |at: usize| {
            let name = &story.session().scene().shapes()[at].name;
            let begin = format!("All of {name}, in about ");
            let text = told.iter().find_map(|text| text.strip_prefix(&*begin));
            text.and_then(|text| text.split_once(": "))
                .map_or("", |(_, how)| how)
        };
        assert!(how(0).starts_with(first), "{told:?}");
        assert!(how(1).starts_with(second), "{told:?}");
    }
}

#[test]
fn limbs_that_a_joint_of_the_trunk_may_turn_are_told_with_it() {
    let instead =
        "Right leg and Left leg hang on Waist and Chest: one of these may be turned instead.";
    for (field, value, is_of_trunk) in [
        ("Waist Z", "15", true),
        ("Chest Y", "25", true),
        ("Left leg Z", "25", false),
    ] {
        let Some(mut story) = course_character_beside_shape(Look::Course) else {
            return;
        };
        compare_with_itself(&mut story, (640, 480));
        judge(&mut story);
        story.type_into(field, value);
        judge(&mut story);
        let mut told = places(&story);
        told.sort_unstable();
        let legs: &[&str] = match is_of_trunk {
            true => &["Left leg", "Right leg"],
            false => &["Left leg"],
        };
        let texts = texts(&story);
        assert_eq!(told, legs, "{field}: {texts:?}");
        assert_eq!(has_text(&story, instead), is_of_trunk, "{field}: {texts:?}");
    }
}

#[test]
fn a_limb_and_shapes_are_told_though_together_they_are_half_of_what_is_drawn() {
    for look in [Look::Course, Look::Studio] {
        let mut story = adult_beside_shapes(look);
        story.type_into("Right shoulder Z", "-20");
        story.click("[2] Goblet (ID: 2)");
        story.type_into("Position Y", "0.4");
        let gem = story.session().scene().shapes()[2].id;
        let color = Edit::SetColor(gem, ShapeColor::Custom(Vec3::new(0.9, 0.8, 0.1)));
        story
            .program
            .carry_out(vec![Action::Edit(color)], &mut story.host);
        judge(&mut story);
        let mut told = places(&story);
        told.sort_unstable();
        // In what way shapes differ is said.
        for how in ["Near Gem, in about ", "Near Goblet, in about "] {
            let texts = texts(&story);
            let text = texts.iter().find(|text| text.starts_with(how)).expect(how);
            let is_color =
                text.ends_with(": its outline agrees, so that its color or light differs.");
            let is_place = text
                .ends_with(": it is moved, turned or scaled, or its control points are elsewhere.");
            let expected = (how.contains("Gem"), how.contains("Goblet"));
            assert_eq!((is_color, is_place), expected, "{look:?} {text}");
        }
        assert_eq!(
            told,
            ["Gem", "Goblet", "Right shoulder"],
            "{:?}",
            texts(&story)
        );
    }
}

#[test]
fn a_surface_that_is_shown_as_a_wireframe_is_not_said_to_be_moved_for_sure() {
    for look in [Look::Course, Look::Studio] {
        let mut story = Story::start(&["builtin:adult", "builtin:goblet"]);
        show_in(&mut story, look);
        let goblet = story.session().scene().shapes()[1].id;
        let shown = |story: &mut Story, surface| {
            let curve = story.session().scene().curve(goblet).expect("a surface");
            let display = CurveDisplay {
                surface,
                ..curve.display
            };
            let edit = Edit::SetCurveDisplay(goblet, display);
            story.program.session_mut().edit(edit).unwrap();
            story.settle();
        };
        shown(&mut story, SurfaceVisibility::WireframeWithNormals);
        keep_picture(&mut story, (900, 700));
        shown(&mut story, SurfaceVisibility::Shaded);
        compare_with_kept(&mut story);
        let told = texts(&story);
        let near = told.iter().find(|text| text.starts_with("Near Goblet"));
        let near = near.unwrap_or_else(|| panic!("{told:?}"));
        assert!(near.contains("Surface Visibility"), "{look:?} {near}");
    }
}

#[test]
fn the_lowest_shape_is_told_to_be_hidden_though_the_ground_has_risen_without_it() {
    let mut story = Story::start(&["builtin:adult", "builtin:goblet"]);
    show_in(&mut story, Look::Studio);
    // About its middle, so that its foot comes below the figure's feet.
    let goblet = &story.session().scene().shapes()[1];
    let mut larger = goblet.placement.transform;
    larger.scale *= 1.3;
    let edit = Edit::SetTransform(goblet.id, larger);
    story.program.session_mut().edit(edit).unwrap();
    story.settle();
    keep_picture(&mut story, (900, 700));
    story.click("Hide Goblet");
    compare_with_kept(&mut story);
    let told = texts(&story);
    let is_hidden = |text: &String| text.ends_with("Goblet is hidden there.");
    assert!(told.iter().any(is_hidden), "{told:?}");
}

#[test]
fn a_skeleton_beside_a_picture_of_a_mesh_is_said_to_be_one() {
    for (display, is_told) in [(ModelDisplay::Skeleton, true), (ModelDisplay::Both, false)] {
        let mut story = Story::start(&["builtin:robot", "builtin:goblet"]);
        show_in(&mut story, Look::Course);
        keep_picture(&mut story, (640, 480));
        let shape = story.session().scene().shapes()[0].id;
        let robot = story.session().scene().character(shape).unwrap();
        let display = CharacterDisplay {
            mode: display,
            ..robot.display
        };
        let edit = Edit::SetDisplay(shape, display);
        story.program.session_mut().edit(edit).unwrap();
        story.settle();
        compare_with_kept(&mut story);
        let hint = "B shows Robot as its skeleton: if A shows its mesh, choose Mesh Model";
        let told = texts(&story);
        assert_eq!(has_text(&story, hint), is_told, "{told:?}");
        let is_wrong = |text: &String| text.contains("missing") || text.contains("moved");
        assert!(!told.iter().any(is_wrong), "{told:?}");
    }
}

#[test]
fn all_skeletons_beside_a_picture_of_meshes_are_said_to_be_such() {
    let mut story = Story::start(&["builtin:adult", "builtin:robot"]);
    show_in(&mut story, Look::Course);
    let shapes = story.session().scene().shapes().iter();
    let shapes: Vec<ShapeId> = shapes.map(|shape| shape.id).collect();
    let shown = |story: &Story, mode| -> Vec<Edit> {
        let shapes = shapes.iter();
        let edits = shapes.map(|&shape| shown_as(story, shape, mode, BoneStyle::Lines));
        edits.collect()
    };
    for edit in shown(&story, ModelDisplay::Skeleton) {
        story.program.session_mut().edit(edit).unwrap();
    }
    let edits = shown(&story, ModelDisplay::Mesh);
    beside_edits(&mut story, edits);
    let told = texts(&story);
    let hint = "B shows Adult and Robot as skeletons: if A shows meshes, choose Mesh Model";
    assert!(has_text(&story, hint), "{told:?}");
}

/// Compares with the picture that was kept.
fn compare_with_kept(story: &mut Story) {
    story.key(Key::F8);
    story.choose("mine.png");
    judge(story);
}

/// The comparison with a picture in this look of these shapes, which were changed for that by the `edit` of the first.
fn beside_changed(
    look: Look,
    shapes: &[&str],
    edit: impl FnOnce(&mut Story, ShapeId) -> Edit,
) -> Story {
    let mut story = Story::start(shapes);
    show_in(&mut story, look);
    beside_changed_in(story, edit)
}

/// The same of the first shape in a story.
fn beside_changed_in(mut story: Story, edit: impl FnOnce(&mut Story, ShapeId) -> Edit) -> Story {
    let first = story.session().scene().shapes()[0].id;
    let edit = edit(&mut story, first);
    beside_edits(&mut story, vec![edit]);
    story
}

/// Compares with a picture after these edits, which are taken back.
fn beside_edits(story: &mut Story, edits: Vec<Edit>) {
    let count = edits.len();
    for edit in edits {
        story.program.session_mut().edit(edit).unwrap();
        story.settle();
    }
    keep_picture(story, (800, 600));
    for _ in 0..count {
        story.key_with(Modifiers::COMMAND, Key::Z);
    }
    compare_with_kept(story);
}

/// The edit that shows a character so.
fn shown_as(story: &Story, shape: ShapeId, mode: ModelDisplay, bones: BoneStyle) -> Edit {
    let character = story.session().scene().character(shape).unwrap();
    let display = CharacterDisplay {
        mode,
        bones,
        ..character.display
    };
    Edit::SetDisplay(shape, display)
}

#[test]
fn a_mesh_beside_a_picture_that_has_bones_as_well_may_be_displayed_otherwise() {
    let story = beside_changed(Look::Course, &["builtin:adult"], |story, shape| {
        shown_as(story, shape, ModelDisplay::Both, BoneStyle::Boxes)
    });
    let told = texts(&story);
    let how = ": its outline agrees, so that its color, its light or Model Display Mode differs.";
    let is_told = |text: &String| text.starts_with("All of Adult, ") && text.ends_with(how);
    assert!(told.iter().any(is_told), "{told:?}");
}

#[test]
fn a_mesh_beside_a_picture_of_its_skeleton_is_told_to_be_that_and_nothing_else() {
    for look in [Look::Course, Look::Studio] {
        for (shapes, name) in [
            (&["builtin:robot", "builtin:goblet"][..], "Robot"),
            (&["builtin:adult", "builtin:robot"], "Adult"),
            (&["builtin:adult"], "Adult"),
        ] {
            for bones in [BoneStyle::Boxes, BoneStyle::Lines] {
                let story = beside_changed(look, shapes, |story, shape| {
                    shown_as(story, shape, ModelDisplay::Skeleton, bones)
                });
                let told = texts(&story);
                let begin = format!("All of {name}, in about ");
                // Lines are not told from the ground's.
                let may_be_lines = (look, bones) == (Look::Studio, BoneStyle::Lines);
                let is_told = |text: &&String| {
                    let is_skeleton = text.contains(" of the figure: A shows its skeleton.");
                    let is_lines = || text.ends_with(" in its place, or no more than lines.");
                    text.starts_with(&begin) && (is_skeleton || may_be_lines && is_lines())
                };
                assert_eq!(
                    told.iter().filter(is_told).count(),
                    1,
                    "{look:?} {bones:?} {told:?}"
                );
                let is_wrong = |text: &String| {
                    ["moved", "another camera", "missing", "Near "]
                        .iter()
                        .any(|it| text.contains(it))
                };
                assert!(!told.iter().any(is_wrong), "{look:?} {bones:?} {told:?}");
            }
        }
    }
}

#[test]
fn a_character_that_the_picture_does_not_have_is_told_to_be_missing_there() {
    let hide = |_: &mut Story, shape| Edit::SetVisible(shape, false);
    for look in [Look::Course, Look::Studio] {
        for shapes in [
            ["builtin:adult", "builtin:robot"],
            ["builtin:adult", "builtin:goblet"],
        ] {
            let story = beside_changed(look, &shapes, hide);
            let told = texts(&story);
            // In the Studio look bones that are lines are not told from lines of the ground.
            let how = match look {
                Look::Studio => {
                    " of the figure: A shows nothing in its place, or no more than lines."
                }
                _ => " of the figure: A shows nothing in its place.",
            };
            let is_told =
                |text: &&String| text.starts_with("All of Adult, in about ") && text.ends_with(how);
            assert_eq!(told.iter().filter(is_told).count(), 1, "{look:?} {told:?}");
            let is_wrong =
                |text: &String| text.contains("moved") || text.contains("another camera");
            assert!(!told.iter().any(is_wrong), "{look:?} {told:?}");
        }
    }
    // Of a skeleton, lines may be left.
    let mut story = Story::start(&["builtin:adult", "builtin:goblet"]);
    show_in(&mut story, Look::Course);
    let adult = story.session().scene().shapes()[0].id;
    let edit = shown_as(&story, adult, ModelDisplay::Skeleton, BoneStyle::Boxes);
    story.program.session_mut().edit(edit).unwrap();
    let story = beside_changed_in(story, hide);
    let told = texts(&story);
    let how = " of the figure: A shows nothing in its place, or no more than lines.";
    let is_told =
        |text: &String| text.starts_with("All of Adult, in about ") && text.ends_with(how);
    assert!(told.iter().any(is_told), "{told:?}");
    // Without anything but axes in the picture, it may look elsewhere as well.
    let story = beside_changed(Look::Course, &["builtin:adult"], |story, shape| {
        story.program.session_mut().look(View::SetAxis(true));
        hide(story, shape)
    });
    let told = texts(&story);
    let nothing = "A shows nothing of what B does, or no more than lines: it is missing or hidden there, or A looks elsewhere.";
    assert!(has_text(&story, nothing), "{told:?}");
    assert!(
        !told.iter().any(|text| text.contains("another camera")),
        "{told:?}"
    );
}

#[test]
fn of_a_limb_that_is_turned_nothing_else_is_told() {
    for look in [Look::Course, Look::Studio] {
        for (joint, axis, degrees) in [
            ("Right leg", "X", "-62"),
            ("Left leg", "Z", "25"),
            ("Right knee", "X", "40"),
            ("Left shoulder", "Z", "-50"),
        ] {
            let mut story = Story::start(&["builtin:adult", "builtin:goblet"]);
            show_in(&mut story, look);
            story.click("[1] Adult (ID: 1)");
            compare_with_itself(&mut story, (800, 600));
            judge(&mut story);
            story.type_into(&format!("{joint} {axis}"), degrees);
            judge(&mut story);
            assert_eq!(places(&story), [joint], "{look:?}");
        }
    }
}

#[test]
fn a_joint_that_is_turned_back_is_told_and_not_the_one_above_whose_limb_it_bends() {
    let knee = Vec3::new(-4.0, -10.5, 69.5);
    for (look, joint, [theirs, ours]) in [
        (Look::Course, "Left knee", [-knee, knee]),
        (Look::Studio, "Right knee", [-knee, knee]),
        (
            Look::Course,
            "Right elbow",
            [Vec3::Z * -50.0, Vec3::Z * 50.0],
        ),
        // What looks like it: the beginning of a limb hardly moves where all of it is turned a little.
        (Look::Course, "Left shoulder", [Vec3::Z * 3.0, Vec3::ZERO]),
        (Look::Course, "Left leg", [Vec3::X * 15.0, Vec3::ZERO]),
    ] {
        let Some(mut story) = course_character(look, &["models/Model1.obj"]) else {
            return;
        };
        turn_joints(&mut story, &[(joint, theirs)]);
        keep_picture(&mut story, (800, 600));
        turn_joints(&mut story, &[(joint, ours)]);
        compare_with_kept(&mut story);
        let told = texts(&story);
        assert_eq!(places(&story), [joint], "{look:?} {told:?}");
    }
}

#[test]
fn a_limb_is_told_beside_axes_that_one_picture_alone_shows() {
    for look in [Look::Course, Look::Studio] {
        let mut story = Story::start(&["builtin:adult", "builtin:goblet"]);
        show_in(&mut story, look);
        if story.session().view().axis {
            story.key(Key::T);
        }
        story.click("[1] Adult (ID: 1)");
        keep_picture(&mut story, (800, 600));
        story.key(Key::T);
        turn_joints(&mut story, &[("Left leg", Vec3::X * -45.0)]);
        compare_with_kept(&mut story);
        let told = texts(&story);
        assert!(has_text(&story, "B shows the axes, A does not"), "{told:?}");
        assert_eq!(places(&story), ["Left leg"], "{look:?} {told:?}");
    }
}

#[test]
fn hands_feet_and_a_chest_are_told_by_themselves_and_not_by_what_hangs_on_them() {
    for (look, joint, turned) in [
        (Look::Course, "hand.L", Vec3::Z * 40.0),
        (Look::Course, "hand.L", Vec3::X * 40.0),
        (Look::Course, "hand.L", Vec3::Y * 40.0),
        (Look::Course, "foot.L", Vec3::X * 30.0),
        (Look::Studio, "hand.L", Vec3::Z * 40.0),
        (Look::Studio, "hand.R", Vec3::Y * 70.0),
        (Look::Mannequin, "hand.L", Vec3::Z * 40.0),
        (Look::Mannequin, "hand.L", Vec3::Y * 40.0),
        (Look::Mannequin, "hand.R", Vec3::Y * 30.0),
        (Look::Mannequin, "hand.R", Vec3::X * 60.0),
        (Look::Mannequin, "foot.R", Vec3::Z * 25.0),
        (Look::Mannequin, "foot.L", Vec3::X * 25.0),
        (Look::Mannequin, "chest", Vec3::Y * 30.0),
    ] {
        let turn = |story: &mut Story| turn_joints(story, &[(joint, turned)]);
        let story = changed_beside_its_picture("robot.dae", look, turn);
        let Some(story) = story else { return };
        let told = texts(&story);
        assert_eq!(places(&story), [joint], "{look:?} {turned} {told:?}");
    }
}

#[test]
fn what_turns_all_that_is_told_may_be_a_root_that_hardly_moves_itself() {
    let story = robot_changed_beside_its_picture(|story| {
        turn_joints(story, &[("free3dmodel_skeleton", Vec3::Y * 15.0)]);
    });
    let Some(story) = story else { return };
    let told = texts(&story);
    let end = "thigh.L and thigh.R hang on hips: that may be turned instead.";
    let is_told = told.iter().any(|text| text.ends_with(end));
    assert!(is_told, "{told:?}");
}

#[test]
fn joints_of_a_face_are_told_where_the_floor_is_the_same() {
    for turned in [
        &[("jaw", Vec3::X * 8.0)][..],
        &[("jaw", Vec3::X * 23.0), ("UpLid.R", Vec3::X * 25.0)],
    ] {
        let turn = |story: &mut Story| turn_joints(story, turned);
        let story = changed_beside_its_picture("head.dae", Look::Mannequin, turn);
        let Some(story) = story else { return };
        let told = texts(&story);
        assert!(has_text(&story, "Near jaw,"), "{told:?}");
        assert_eq!(places(&story).len(), turned.len(), "{told:?}");
    }
}

#[test]
fn of_two_characters_that_are_each_in_the_pose_of_the_other_one_no_joint_is_blamed() {
    let mut story = Story::start(&["builtin:adult", "builtin:adult"]);
    show_in(&mut story, Look::Studio);
    let poses: [&[(&str, Vec3)]; 2] = [
        &[
            ("Right shoulder", Vec3::Z * 60.0),
            ("Left elbow", Vec3::Y * 50.0),
            ("Right hip", Vec3::X * 40.0),
            ("Left knee", Vec3::X * 40.0),
            ("Neck", Vec3::X * 30.0),
        ],
        &[
            ("Left shoulder", Vec3::Z * 50.0),
            ("Right elbow", Vec3::Y * -60.0),
            ("Left hip", Vec3::X * -40.0),
            ("Right knee", Vec3::X * 60.0),
        ],
    ];
    let shapes: Vec<ShapeId> = story
        .session()
        .scene()
        .shapes()
        .iter()
        .map(|it| it.id)
        .collect();
    let pose = |story: &mut Story, poses: [&[(&str, Vec3)]; 2]| {
        for (&shape, pose) in shapes.iter().zip(poses) {
            turn_joints_of(story, shape, pose);
        }
    };
    pose(&mut story, poses);
    keep_picture(&mut story, (800, 600));
    pose(&mut story, [poses[1], poses[0]]);
    compare_with_kept(&mut story);
    let told = texts(&story);
    assert!(!has_text(&story, "Near "), "{told:?}");
    let reason = "shapes are moved, turned or scaled, several joints are turned, or the skinning";
    let is_told = told.iter().any(|text| text.contains(reason));
    assert!(is_told, "{told:?}");
}

#[test]
fn where_the_weights_of_one_of_two_characters_are_others_no_joint_is_blamed_but_the_skinning() {
    let Some(host) = course_host() else { return };
    let posed = |host: MemoryHost| {
        let mut story = Story::start_at(host, &["models/Model1.obj", "builtin:robot"]);
        show_in(&mut story, Look::Course);
        let model = story.session().scene().shapes()[0].id;
        let pose = [
            ("Right leg", Vec3::X * -27.0),
            ("Right shoulder", Vec3::Z * -44.0),
            ("Right knee", Vec3::X * 39.0),
        ];
        turn_joints_of(&mut story, model, &pose);
        story
    };
    // Each weight is that of the joint before.
    let mut files = host.files.clone();
    let attach = files.get_mut(Path::new("models/Model1.attach")).unwrap();
    let text = String::from_utf8(std::mem::take(attach)).unwrap();
    let shifted = text.lines().map(|line| {
        let (first, others) = line.trim().split_once(' ').unwrap();
        format!("{others} {first}\n")
    });
    *attach = shifted.collect::<String>().into_bytes();
    let stored = host.stored.clone();
    let mut story = posed(host);
    let mut wrong = posed(MemoryHost {
        files,
        stored,
        ..MemoryHost::default()
    });
    keep_picture(&mut wrong, (800, 600));
    let picture = wrong.host.files[Path::new("mine.png")].clone();
    story.host.files.insert("mine.png".into(), picture);
    compare_with_kept(&mut story);
    let told = texts(&story);
    assert!(!has_text(&story, "Near "), "{told:?}");
    let end = "or the skinning differs: Compare with Mesh tells how.";
    assert!(told.iter().any(|text| text.ends_with(end)), "{told:?}");
}

#[test]
fn a_camera_that_is_not_found_may_be_another_one() {
    let in_studio = "All over the figure: A may be seen by another camera than B, or";
    let in_course = "another camera, or the whole figure moved or posed otherwise.";
    for (look, by, told_so) in [
        (Look::Studio, [40.0, 10.0], in_studio),
        (Look::Studio, [90.0, 0.0], in_studio),
        (Look::Course, [90.0, 0.0], in_course),
        (
            Look::Course,
            [40.0, 10.0],
            "A is seen by another camera than B: about 40° farther to the right, 10° farther down.",
        ),
        // In the shade all sides have one color, which tells nothing of the camera.
        (
            Look::Course,
            [-60.0, 12.0],
            "A is seen by another camera than B",
        ),
    ] {
        let turn = |story: &mut Story| turn_camera(story, by);
        let story = changed_beside_its_picture("robot.dae", look, turn);
        let Some(story) = story else { return };
        let told = texts(&story);
        assert!(!has_text(&story, "Near "), "{look:?} {told:?}");
        let is_told = told.iter().any(|text| text.contains(told_so));
        assert!(is_told, "{look:?} {by:?} {told:?}");
    }
}

#[test]
fn a_shape_that_is_moved_behind_a_limb_that_is_turned_as_well_is_not_said_to_be_missing() {
    let Some(mut story) = course_character(Look::Course, &["models/Model1.obj"]) else {
        return;
    };
    let mut cube = NewShape::new("Cube", ShapeKind::Cube);
    cube.placement.transform.scale = Vec3::splat(0.3);
    cube.placement.color = ShapeColor::Custom(Vec3::X);
    let insert = Edit::Insert(vec![cube]);
    story.program.session_mut().edit(insert).unwrap();
    let shapes = story.session().scene().shapes();
    let [model, cube] = [0, 1].map(|at| shapes[at].id);
    let arrange = |story: &mut Story, knee: f32, place: Vec3| {
        let turned = [
            ("Right leg", Vec3::X * -61.0),
            ("Right knee", Vec3::X * knee),
            ("Right shoulder", Vec3::Z * 41.0),
        ];
        turn_joints_of(story, model, &turned);
        let shape = story.session().scene().shape(cube).unwrap();
        let mut transform = shape.placement.transform;
        transform.position = place;
        let edit = Edit::SetTransform(cube, transform);
        story.program.session_mut().edit(edit).unwrap();
        story.settle();
    };
    let camera = Camera {
        target: Vec3::new(0.293, 0.5398, 0.2249),
        radius: 1.7135,
        theta: 60.78_f32.to_radians(),
        phi: -8.88_f32.to_radians(),
        ..Camera::default()
    };
    see_from(&mut story, camera);
    arrange(&mut story, 15.0, Vec3::new(-0.2, 0.3, 0.5));
    keep_picture(&mut story, (1000, 750));
    arrange(&mut story, 51.0, Vec3::new(-0.5, 0.3, 0.0));
    compare_with_kept(&mut story);
    let told = texts(&story);
    assert!(has_text(&story, "Near Right knee,"), "{told:?}");
    let cube = told.iter().find(|text| text.starts_with("Near Cube,"));
    let cube = cube.unwrap_or_else(|| panic!("{told:?}"));
    assert!(cube.ends_with(": it is moved, turned or scaled."), "{cube}");
    assert!(!has_text(&story, "A shows something"), "{told:?}");
}

#[test]
fn a_character_that_stands_before_another_one_in_the_picture_is_told_to_be_moved() {
    for (other, part) in [("builtin:robot", 1.0), ("builtin:adult", 0.9)] {
        let story = beside_changed(Look::Course, &["builtin:adult", other], |story, shape| {
            let shapes = story.session().scene().shapes();
            let [here, there] = [0, 1].map(|shape| shapes[shape].placement.transform);
            let moved = Transform {
                position: here.position.lerp(there.position, part),
                ..here
            };
            Edit::SetTransform(shape, moved)
        });
        let told = texts(&story);
        assert_eq!(whole(&story), ["Adult"], "{other} {told:?}");
        let is_wrong = |text: &String| text.contains("another camera");
        assert!(!told.iter().any(is_wrong), "{other} {told:?}");
    }
}

#[test]
fn edges_that_were_chosen_while_a_figure_was_elsewhere_are_chosen_anew_in_its_place() {
    for (look, by) in [
        (Look::Course, Vec3::Z * -0.8),
        (Look::Course, Vec3::X * 0.6),
        (Look::Course, Vec3::new(0.0, 0.2, 0.3)),
        (Look::Mannequin, Vec3::Z * -0.8),
        (Look::Mannequin, Vec3::X * 0.6),
        (Look::Mannequin, Vec3::Y * 0.3),
    ] {
        let Some(mut story) = of_mannequin("robot.dae") else {
            return;
        };
        show_in(&mut story, look);
        let mut story = beside_changed_in(story, |story, shape| {
            let here = story.shape().placement.transform;
            let moved = Transform {
                position: here.position + by,
                ..here
            };
            Edit::SetTransform(shape, moved)
        });
        story.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
        judge(&mut story);
        let told = texts(&story);
        let equal = has_text(&story, "A and B are equal");
        assert!(equal, "{look:?} {by} {told:?}");
    }
}

#[test]
fn a_limb_of_a_figure_that_is_seen_from_its_unlit_side_is_told() {
    // There it is hardly darker than the background.
    for (joint, turned) in [
        ("upper_arm.L", Vec3::Z * 50.0),
        ("forearm.R", Vec3::Z * -40.0),
        ("thigh.R", Vec3::Z * 20.0),
    ] {
        let turn = |story: &mut Story| turn_joints(story, &[(joint, turned)]);
        let story = changed_beside_its_picture("robot.dae", Look::Course, turn);
        let Some(story) = story else { return };
        assert_eq!(places(&story), [joint], "{:?}", texts(&story));
    }
}

#[test]
fn how_much_of_a_comparison_is_done_is_shown_while_it_goes_on() {
    let (mut story, mut job) = judging();
    let told = |story: &Story| {
        let texts = texts(story);
        let text = texts
            .iter()
            .find_map(|text| text.strip_prefix("Looking for the cause… "));
        let number = text.and_then(|text| text.strip_suffix(" %"))?;
        number.parse::<u32>().ok()
    };
    story.wait(0.1);
    let first = told(&story).expect("a part");
    assert!((1..100).contains(&first), "{first}");
    for _ in 0..40 {
        assert!(job.step().is_none());
    }
    let wait = story.frame(Vec::new());
    assert!(
        wait <= Duration::from_millis(100),
        "looked at again in {wait:?}"
    );
    story.wait(0.1);
    assert!(told(&story) > Some(first), "{:?}", texts(&story));
    let result = std::iter::from_fn(|| Some(job.step())).flatten().next();
    story.host.events.extend(result.map(HostEvent::Finished));
    story.settle();
    assert!(told(&story).is_none());
    assert!(
        !has_text(&story, "Looking for the cause"),
        "{:?}",
        texts(&story)
    );
}

#[test]
fn an_edit_gives_up_what_is_judged_and_the_new_state_is_judged_in_its_place() {
    let (mut story, mut job) = judging();
    bend(&mut story);
    let given_up = job.step().expect("nothing more is done");
    story.host.events.push_back(HostEvent::Finished(given_up));
    story.settle();
    assert!(
        has_text(&story, "Looking for the cause…"),
        "{:?}",
        texts(&story)
    );
    judge(&mut story);
    assert!(
        !has_text(&story, "Looking for the cause"),
        "{:?}",
        texts(&story)
    );
}

#[test]
fn esc_ends_a_comparison_and_all_that_is_done_for_it() {
    let (mut story, mut job) = judging();
    story.key(Key::Escape);
    assert!(!story.has("Stop comparing"));
    let given_up = job.step().expect("nothing more is done");
    story.host.events.push_back(HostEvent::Finished(given_up));
    story.settle();
    assert!(story.host.jobs.is_empty());
}

#[test]
fn the_same_scene_compared_with_its_own_picture_differs_in_no_pixel() {
    let mut story = comparing();
    // Counting first, and the judgment once the view has stood still for a while.
    while measure(&mut story) > 0 {}
    assert!(has_text(&story, "0 of 60000"), "{:?}", texts(&story));
    let wait = story.frame(Vec::new());
    assert!(wait <= Duration::from_millis(150), "{wait:?}");
    story.host.time += Duration::from_millis(200);
    story.settle();
    assert_eq!(measure(&mut story), 1, "the judgment");
    story.host.time += Duration::from_secs(5);
    story.settle();
    assert!(story.host.jobs.is_empty(), "nothing is measured twice");
}

#[test]
fn moving_a_joint_is_measured_again_and_only_the_newest_state_is_judged() {
    let mut story = comparing();
    judge(&mut story);
    let field = story.place("Elbow Z");
    story.press_and_drag(field, field + vec2(40.0, 0.0));
    assert_eq!(
        story.host.jobs.len(),
        1,
        "one at a time, however many states there were"
    );
    measure(&mut story);
    story.host.time += Duration::from_millis(100);
    story.button(false);
    while measure(&mut story) > 0 {}
    assert!(!has_text(&story, "0 of 60000"), "{:?}", texts(&story));
}

const BENT: &str = r#"{"joints": {"Left elbow": [0, 0, 25]}}"#;

#[test]
fn a_difference_is_placed_by_the_joint_next_to_it() {
    let mut story = Story::start(&["builtin:adult"]);
    story.key(Key::F2);
    story.save_view((600, 450), "rest.png");
    let saved = story.host.written[Path::new("rest.png")].clone();
    story.host.files.insert("rest.png".into(), saved);
    story.host.files.insert("bent.json".into(), BENT.into());
    story.host.drop_file("bent.json");
    story.settle();
    story.key(Key::F8);
    story.choose("rest.png");
    smooth_edges(&mut story);
    while measure(&mut story) > 0 {}
    story.host.time += Duration::from_millis(200);
    story.settle();
    while measure(&mut story) > 0 {}
    assert!(
        has_text(&story, "Near Left elbow, in about"),
        "{:?}",
        texts(&story)
    );
}

#[test]
fn where_everything_is_left_out_no_number_is_told() {
    let mut story = comparing();
    // Structural similarity and visible difference of equal pictures.
    while measure(&mut story) > 0 {}
    story.host.time += Duration::from_millis(200);
    story.settle();
    while measure(&mut story) > 0 {}
    assert!(has_text(&story, EQUAL), "{:?}", texts(&story));
    let all = Area {
        x: 0,
        y: 0,
        width: 300,
        height: 200,
    };
    let settings = CompareSettings {
        masks: vec![all],
        smooth_edges: true,
        ..CompareSettings::default()
    };
    let set = Action::Ask(Ask::Compare(CompareAction::Set(settings)));
    story.program.carry_out(vec![set], &mut story.host);
    story.settle();
    while measure(&mut story) > 0 {}
    assert!(has_text(&story, "no pixel is left"), "{:?}", texts(&story));
    assert!(!has_text(&story, EQUAL), "{:?}", texts(&story));
}

#[test]
fn masks_of_panels_stay_for_the_next_picture_if_that_has_them_too() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.size = (1400, 1300);
    story.settle();
    compare_with_itself(&mut story, (800, 600));
    let plain = story.host.files[Path::new("mine.png")].clone();
    let panels = course_panels((800, 600));
    let with_panels = |of_fields: u8| {
        let mut picture = image::decode(Path::new("mine.png"), &plain).unwrap();
        for panel in panels {
            for y in panel.y..panel.y + panel.height {
                for x in panel.x..panel.x + panel.width {
                    let color = if y % 40 >= 30 { of_fields } else { 40 };
                    let at = 4 * (y * picture.width + x) as usize;
                    picture.rgba[at..at + 4].copy_from_slice(&[color, color, color, 255]);
                }
            }
        }
        image::encode(&picture, PictureFormat::Png).unwrap()
    };
    story.host.files.insert("one.png".into(), with_panels(90));
    story.host.files.insert("two.png".into(), with_panels(200));
    story.host.drop_file("one.png");
    story.settle();
    story.click("Mask its panels");
    story.click("Add mask");
    let is_masked = |story: &Story| story.has("Unmask its panels");
    assert!(
        is_masked(&story) && story.has("Remove mask 3"),
        "{:?}",
        texts(&story)
    );
    story.host.drop_file("two.png");
    story.settle();
    assert!(is_masked(&story));
    story.host.drop_file("mine.png");
    story.settle();
    assert!(!is_masked(&story));
    assert!(story.has("Remove mask 1"), "the user's own stays");
    assert!(!story.has("Remove mask 2"));
}

#[test]
fn an_area_that_is_left_out_is_measured_anew_and_kept_for_the_next_picture() {
    let mut story = comparing();
    while measure(&mut story) > 0 {}
    let settings = CompareSettings {
        masks: vec![Area {
            x: 0,
            y: 0,
            width: 300,
            height: 50,
        }],
        smooth_edges: true,
        ..CompareSettings::default()
    };
    let set = Action::Ask(Ask::Compare(CompareAction::Set(settings)));
    story.program.carry_out(vec![set], &mut story.host);
    story.settle();
    while measure(&mut story) > 0 {}
    assert!(has_text(&story, "0 of 45000"), "{:?}", texts(&story));

    story.host.drop_file("mine.png");
    story.settle();
    while measure(&mut story) > 0 {}
    assert!(has_text(&story, "0 of 45000"), "{:?}", texts(&story));
}

#[test]
fn of_several_pictures_at_the_start_the_last_is_compared_with() {
    let picture = |width| {
        let picture = Picture {
            width,
            height: 10,
            rgba: vec![7; 40 * width as usize],
        };
        image::encode(&picture, PictureFormat::Png).unwrap()
    };
    let host = MemoryHost {
        files: [
            ("first.png".into(), picture(20)),
            ("last.png".into(), picture(30)),
        ]
        .into(),
        ..MemoryHost::default()
    };
    let mut story = Story::start_at(host, &["first.png", "models/strip.obj", "last.png"]);
    while measure(&mut story) > 0 {}
    assert!(has_text(&story, "300 of 300"), "{:?}", texts(&story));
}

#[test]
fn a_screenshot_in_a_comparison_has_the_size_of_what_is_compared() {
    let mut story = comparing();
    story.key(Key::F12);
    assert!(story.has("As compared (300 × 200)"));
    story.key(Key::Enter);
    story.save_picture("again.png");
    let [again, mine] = ["again.png", "mine.png"].map(|name| {
        let path = Path::new(name);
        let bytes = story.host.written.get(path).expect("it was written");
        image::decode(path, bytes).expect("a picture")
    });
    assert_eq!(again, mine, "of the same scene");
}

#[test]
fn a_comparison_is_saved_side_by_side_and_ends_with_esc() {
    let mut story = comparing();
    while measure(&mut story) > 0 {}
    story.click("Save…");
    let suggested = &story.host.requests.last().unwrap().name;
    assert_eq!(suggested, "strip-comparison.png");
    story.choose("three.png");
    let bytes = &story.host.written[Path::new("three.png")];
    let three = image::decode(Path::new("three.png"), bytes).unwrap();
    assert_eq!((three.width, three.height), (3 * 300 + 2 * 8, 200));
    let part = |x: u32| -> Vec<u8> {
        let rows = three.rgba.chunks_exact(4 * three.width as usize);
        let (from, to) = (4 * x as usize, 4 * (x + 300) as usize);
        rows.flat_map(|row| row[from..to].to_vec()).collect()
    };
    assert!(part(0) == part(308), "the live view is the saved picture");
    story.key(Key::Escape);
    assert!(!story.has("Stop comparing") && !story.host.quits);
}

#[test]
fn the_view_is_the_same_after_a_comparison_as_before() {
    let mut story = Story::start(&["builtin:robot"]);
    let before = story.scene_picture();
    let picture = image::encode(&before, PictureFormat::Png).unwrap();
    story.host.files.insert("robot.png".into(), picture);
    story.host.drop_file("robot.png");
    story.settle();
    let beside = story.graphics.scene_picture().unwrap().height();
    assert!(beside < before.height, "the panel takes room from the view");
    story.key(Key::Escape);
    assert_eq!(super::differing(&before, &story.scene_picture()), 0);
}

#[test]
fn a_picture_larger_than_a_texture_and_one_that_is_none_are_refused_with_their_reason() {
    let mut story = Story::start(&[]);
    let wide = Picture {
        width: 5000,
        height: 1,
        rgba: vec![7; 4 * 5000],
    };
    let tall = Picture {
        width: 1,
        height: 5000,
        ..wide.clone()
    };
    for (name, picture) in [("wide.png", wide), ("tall.png", tall)] {
        let bytes = image::encode(&picture, PictureFormat::Png).unwrap();
        story.host.files.insert(name.into(), bytes);
    }
    story.host.files.insert("none.png".into(), b"none".to_vec());
    for name in ["wide.png", "none.png", "tall.png"] {
        story.host.drop_file(name);
        story.settle();
    }
    let messages = story.messages();
    let expected = "wide.png: expected a picture of at most 4096 pixels a side, found 5000×1";
    assert_eq!(messages[0].1, expected);
    assert!(messages[1].1.starts_with("none.png: "), "{messages:?}");
    assert!(messages[2].1.ends_with("found 1×5000"), "{messages:?}");
    assert!(!story.has("Stop comparing"));
}

/// Upper edge of the widget whose text begins with `words`.
fn upper_edge(story: &Story, words: &str) -> f64 {
    let update = story.widgets.as_ref().expect("a frame");
    let is_meant = |text: Option<&str>| text.is_some_and(|text| text.starts_with(words));
    let mut nodes = update.nodes.iter().map(|(_, node)| node);
    let found = nodes.find_map(|node| {
        let meant = is_meant(node.value()) || is_meant(node.label());
        node.bounds().filter(|_| meant)
    });
    found.expect("it is told").y0
}

/// All texts that assistive technologies see.
fn texts(story: &Story) -> Vec<String> {
    let update = story.widgets.as_ref().expect("a frame");
    let nodes = update.nodes.iter();
    let text = |node: &egui::accesskit::Node| {
        let value = node.value().or(node.label());
        value.map(str::to_owned)
    };
    nodes.filter_map(|(_, node)| text(node)).collect()
}

fn has_text(story: &Story, part: &str) -> bool {
    texts(story).iter().any(|text| text.starts_with(part))
}

#[test]
fn a_document_in_the_mannequin_look_is_compared_in_it() {
    let mut story = Story::start(&["models/strip.obj"]);
    let set = Action::View(View::SetLook(Look::Mannequin));
    story.program.carry_out(vec![set], &mut story.host);
    compare_with_itself(&mut story, (300, 200));
    assert_eq!(story.session().view().look, Look::Mannequin);
    smooth_edges(&mut story);
    judge(&mut story);
    assert!(has_text(&story, "0 of 60000"), "{:?}", texts(&story));
    story.click("Stop comparing");
    assert_eq!(story.session().view().look, Look::Mannequin);
}

#[test]
fn a_picture_in_the_course_look_is_compared_in_that_though_the_document_is_in_the_mannequin_look() {
    let mut story = Story::start(&["models/strip.obj"]);
    show_in(&mut story, Look::Course);
    keep_picture(&mut story, (300, 200));
    show_in(&mut story, Look::Mannequin);
    story.key(Key::F8);
    story.choose("mine.png");
    assert_eq!(story.session().view().look, Look::Course);
    judge(&mut story);
    assert!(has_text(&story, "A and B are equal"), "{:?}", texts(&story));
    story.click("Stop comparing");
    assert_eq!(story.session().view().look, Look::Mannequin);
}

/// A picture of what is seen as the Virtual Mannequin's page has it, with its keyframes below.
fn screenshot_of_page(story: &mut Story) -> Vec<u8> {
    story.save_view((300, 200), "page.png");
    let saved = &story.host.written[Path::new("page.png")];
    let mut page = image::decode(Path::new("page.png"), saved).unwrap();
    page.height += 200;
    page.rgba.extend([26, 26, 26, 255].repeat(300 * 200));
    image::encode(&page, PictureFormat::Png).unwrap()
}

#[test]
fn a_character_that_is_imported_beside_a_picture_has_the_look_that_this_is_compared_in() {
    let seen = |story: &mut Story, view| {
        let view = vec![Action::View(view)];
        story.program.carry_out(view, &mut story.host);
    };
    let imported_beside = |picture: Vec<u8>| {
        let mut story = Story::start(&[]);
        story.host.files.insert("theirs.png".into(), picture);
        story.key(Key::F8);
        story.choose("theirs.png");
        judge(&mut story);
        let empty = "B is empty: Insert ⏵ Import adds what is to be compared.";
        assert!(has_text(&story, empty));
        story.host.drop_file("builtin:rigs/lizard");
        story.settle();
        assert!(story.has("Stop comparing") && story.names() == ["Lizard"]);
        story
    };
    let mut theirs = Story::start(&["builtin:rigs/lizard"]);
    let alone = theirs.session().view().camera;
    theirs.save_view((300, 200), "theirs.png");
    let of_studio = theirs.host.written[Path::new("theirs.png")].clone();
    seen(&mut theirs, View::SetLook(Look::Mannequin));
    seen(&mut theirs, View::SetCamera(Camera::of_mannequin()));
    let of_page = screenshot_of_page(&mut theirs);
    seen(&mut theirs, View::SetLook(Look::Course));
    theirs.save_view((300, 200), "theirs.png");
    let of_course = theirs.host.written[Path::new("theirs.png")].clone();

    let mut story = imported_beside(of_page);
    assert_eq!(story.session().view().look, Look::Mannequin);
    assert_eq!(story.session().view().camera, Camera::of_mannequin());
    story.click("Stop comparing");
    assert_ne!(story.session().view().camera, Camera::of_mannequin());

    let story = imported_beside(of_course);
    assert_eq!(story.session().view().look, Look::Course);
    assert_eq!(story.session().view().camera, Camera::default());

    let story = imported_beside(of_studio);
    assert_eq!(story.session().view().look, Look::Studio);
    let Camera { theta, phi, .. } = story.session().view().camera;
    assert_eq!((theta, phi), (alone.theta, alone.phi), "from the front");
}

#[test]
fn a_screenshot_of_the_mannequins_page_is_compared_without_its_keyframes_from_where_the_page_starts()
 {
    for is_moved in [false, true] {
        let mut story = Story::start(&["models/strip.obj"]);
        let before = story.session().view().look;
        let look = |look| vec![Action::View(View::SetLook(look))];
        story
            .program
            .carry_out(look(Look::Mannequin), &mut story.host);
        let start = story.session().view().camera;
        let moved = Camera {
            radius: 7.0,
            ..start
        };
        let seen = |camera| vec![Action::View(View::SetCamera(camera))];
        let of_page = if is_moved {
            moved
        } else {
            Camera::of_mannequin()
        };
        story.program.carry_out(seen(of_page), &mut story.host);
        let page = screenshot_of_page(&mut story);
        story.host.files.insert("page.png".into(), page);
        let camera = if is_moved { moved } else { start };
        story.program.carry_out(seen(camera), &mut story.host);
        story.program.carry_out(look(before), &mut story.host);

        story.key(Key::F8);
        story.choose("page.png");
        assert_eq!(story.session().view().look, Look::Mannequin);
        assert_eq!(story.session().view().camera, of_page);
        smooth_edges(&mut story);
        judge(&mut story);
        assert!(has_text(&story, "0 of 60000"), "{:?}", texts(&story));
        story.click("Stop comparing");
        assert_eq!(story.session().view().look, before);
        assert_eq!(story.session().view().camera, camera);
    }
}

#[test]
fn home_in_the_mannequin_look_leads_to_where_that_program_starts_the_second_time() {
    let mut story = Story::start(&["models/strip.obj"]);
    let start = story.session().view().camera;
    let look = Action::View(View::SetLook(Look::Mannequin));
    story.program.carry_out(vec![look], &mut story.host);
    let moved = Camera {
        radius: 7.0,
        ..start
    };
    see_from(&mut story, moved);
    story.key(Key::Home);
    assert_eq!(story.session().view().camera, start);
    let (_, told) = *story.messages().last().expect("what Home does next");
    assert!(told.starts_with("Home once more"), "{told}");
    story.key(Key::Home);
    let camera = story.session().view().camera;
    assert!(camera.eye().abs_diff_eq(Vec3::new(0.0, 0.0, -6.0), 1e-5));
    let (_, told) = *story.messages().last().expect("where that is");
    assert!(told.starts_with("This is where the Virtual Mannequin's page starts"));
}

/// A story in which the robot is compared with a screenshot of the page; `None` without the reference data.
fn robot_beside(shot: &str) -> Option<Story> {
    robot_beside_what_becomes_of(shot, |shot| shot)
}

/// The same with a picture that is made of the screenshot.
fn robot_beside_what_becomes_of(
    shot: &str,
    change: impl FnOnce(Picture) -> Picture,
) -> Option<Story> {
    let shot = reference(&format!("mannequin/shots/{shot}.png"))?;
    let robot = reference("mannequin/robot.dae")?;
    let shot = image::decode(&shot, &std::fs::read(&shot).unwrap()).unwrap();
    let shot = image::encode(&change(shot), PictureFormat::Png).unwrap();
    let mut host = MemoryHost::default();
    host.files.insert("page.png".into(), shot);
    host.files
        .insert("robot.dae".into(), std::fs::read(robot).unwrap());
    let mut story = Story::start_at(host, &["robot.dae"]);
    story.key(Key::F8);
    story.choose("page.png");
    judge(&mut story);
    Some(story)
}

/// A picture of this size with `inside` at a place, on white.
fn on_white((width, height): (u32, u32), (left, top): (u32, u32), inside: &Picture) -> Picture {
    let mut rgba = vec![255; 4 * (width * height) as usize];
    let row_of = 4 * inside.width as usize;
    for (y, row) in (top..).zip(inside.rgba.chunks(row_of)) {
        let begin = 4 * (y * width + left) as usize;
        rgba[begin..begin + row_of].copy_from_slice(row);
    }
    Picture {
        width,
        height,
        rgba,
    }
}

/// A picture whose pixels are each `times` as wide and high.
fn enlarged(picture: &Picture, times: u32) -> Picture {
    let (width, height) = (times * picture.width, times * picture.height);
    let rgba = (0..width * height).flat_map(|at| {
        let (x, y) = (at % width / times, at / width / times);
        let at = 4 * (y * picture.width + x) as usize;
        <[u8; 4]>::try_from(&picture.rgba[at..at + 4]).unwrap()
    });
    Picture {
        width,
        height,
        rgba: rgba.collect(),
    }
}

#[test]
fn a_screenshot_of_the_page_is_found_in_that_of_a_screen_and_as_large_as_it_is_shown() {
    let of_screen = |shot: Picture| on_white((1280, 960), (237, 121), &shot);
    let by_hand = |shot: Picture| on_white((812, 811), (6, 5), &shot);
    let on_dense_screen = |shot: Picture| enlarged(&shot, 2);
    let Some(alone) = robot_beside("robot_start_camera") else {
        return;
    };
    let of_view = |text: &String| text.contains(" of 480000");
    let differing = texts(&alone).into_iter().find(of_view).expect("the view");
    for (what, change) in [
        ("screen", &of_screen as &dyn Fn(Picture) -> Picture),
        ("by hand", &by_hand),
        ("dense", &on_dense_screen),
    ] {
        let Some(story) = robot_beside_what_becomes_of("robot_start_camera", change) else {
            return;
        };
        let told = texts(&story);
        assert!(told.contains(&differing), "{what}: {differing} {told:?}");
        assert!(has_text(&story, "The figure agrees"), "{what}: {told:?}");
    }
}

#[test]
fn a_picture_of_the_pages_view_alone_is_compared_by_its_figure_in_the_look_of_the_page() {
    let view = |shot: Picture| {
        let rows = shot.rgba.chunks(4 * 800).skip(1).take(600);
        let rgba = rows.flat_map(|row| [&row[4..], &row[4 * 799..]].concat());
        Picture {
            width: 800,
            height: 600,
            rgba: rgba.collect(),
        }
    };
    let Some(mut story) = robot_beside_what_becomes_of("robot_start_camera", view) else {
        return;
    };
    assert_eq!(story.session().view().look, Look::Mannequin);
    // The floor tells, and Home helps.
    let told = texts(&story);
    let is_camera = |text: &String| {
        text.starts_with("A is seen by another camera than B")
            || text.ends_with("so that it is another camera.")
    };
    assert!(told.iter().any(is_camera), "{told:?}");
    assert!(has_text(&story, "Home leads B's camera to"), "{told:?}");
    story.key(Key::Home);
    judge(&mut story);
    assert!(has_text(&story, "The figure agrees"), "{:?}", texts(&story));
    assert!(has_text(
        &story,
        "If A is the Virtual Mannequin's page, the noise"
    ));
    turn_joints(&mut story, &[("upper_arm.R", Vec3::Z * 30.0)]);
    judge(&mut story);
    assert!(has_text(&story, "Near upper_arm.R"), "{:?}", texts(&story));
}

#[test]
fn a_screenshot_of_the_page_whose_horizon_is_slanted_is_said_to_match_no_view() {
    for (shot, is_slanted) in [
        ("robot_start_camera", false),
        ("robot_rest", true),
        ("robot_arm_dragged", true),
    ] {
        let Some(story) = robot_beside(shot) else {
            return;
        };
        let told = [
            "The horizon of A is slanted",
            "The figure differs",
            "The figure agrees",
        ];
        let told = told.map(|words| has_text(&story, words));
        assert_eq!(
            told,
            [is_slanted, false, !is_slanted],
            "{:?}",
            texts(&story)
        );
    }
}

/// Turns joints of the selected character from its bind pose, each by so many degrees about X, Y and Z.
fn turn_joints(story: &mut Story, turned: &[(&str, Vec3)]) {
    turn_joints_of(story, story.shape().id, turned);
}

/// The same of one of several characters.
fn turn_joints_of(story: &mut Story, shape: ShapeId, turned: &[(&str, Vec3)]) {
    let character = story.session().scene().character(shape).unwrap();
    let skeleton = character.character.skeleton();
    let mut pose = Pose::new();
    for (joint, degrees) in turned {
        let joint = Pose::find_joint(skeleton, joint).unwrap();
        pose.set_joint_transform(joint, Euler::from_degrees(*degrees));
    }
    let edit = Edit::SetPose(shape, pose);
    story.program.session_mut().edit(edit).unwrap();
    story.settle();
}

/// Shows the scene from this camera.
fn see_from(story: &mut Story, camera: Camera) {
    let seen = vec![Action::View(View::SetCamera(camera))];
    story.program.carry_out(seen, &mut story.host);
}

/// Shows the scene from a camera that is turned by so many degrees to the left and up.
fn turn_camera(story: &mut Story, [around, above]: [f32; 2]) {
    let here = story.session().view().camera;
    let turned = Camera {
        theta: here.theta + around.to_radians(),
        phi: here.phi + above.to_radians(),
        ..here
    };
    see_from(story, turned);
}

/// A story with a file of the Virtual Mannequin.
fn of_mannequin(file: &str) -> Option<Story> {
    let found = reference(&format!("mannequin/{file}"))?;
    let mut host = MemoryHost::default();
    host.files
        .insert(file.into(), std::fs::read(found).unwrap());
    Some(Story::start_at(host, &[file]))
}

/// The Virtual Mannequin's robot in its look, which was changed after a picture of it was kept that it is compared with.
fn robot_changed_beside_its_picture(change: impl FnOnce(&mut Story)) -> Option<Story> {
    changed_beside_its_picture("robot.dae", Look::Mannequin, change)
}

/// The same of another file of the Virtual Mannequin.
fn changed_beside_its_picture(
    file: &str,
    look: Look,
    change: impl FnOnce(&mut Story),
) -> Option<Story> {
    let mut story = of_mannequin(file)?;
    show_in(&mut story, look);
    keep_picture(&mut story, (800, 600));
    change(&mut story);
    compare_with_kept(&mut story);
    assert_eq!(story.session().view().look, look);
    Some(story)
}

#[test]
fn limbs_as_thin_as_lines_of_bones_are_named_where_the_floor_is_the_same() {
    let elbow = ("forearm.L", Vec3::Z * 40.0);
    for turned in [
        [elbow, ("shin.R", Vec3::X * 30.0)],
        [elbow, ("head", Vec3::Y * 30.0)],
    ] {
        let story = robot_changed_beside_its_picture(|story| turn_joints(story, &turned));
        let Some(story) = story else { return };
        let told = texts(&story);
        for (joint, _) in turned {
            assert!(has_text(&story, &format!("Near {joint},")), "{told:?}");
        }
        let near = told.iter().filter(|text| text.starts_with("Near "));
        assert_eq!(near.count(), turned.len(), "{told:?}");
        // It is no screenshot of the page, nor is the camera elsewhere.
        assert!(!told.iter().any(|text| text.contains("page")), "{told:?}");
    }
}

#[test]
fn other_edges_alone_neither_move_nor_turn_a_figure_with_thin_lines() {
    for turned in [None, Some(("upper_arm.L", Vec3::Z * 40.0))] {
        let story = robot_changed_beside_its_picture(|story| {
            turned
                .iter()
                .for_each(|joint| turn_joints(story, &[*joint]));
        });
        let Some(mut story) = story else { return };
        choose_edges(&mut story, false);
        judge(&mut story);
        let told = texts(&story);
        assert!(
            has_text(&story, "A has smooth edges, and B hard ones"),
            "{told:?}"
        );
        let agrees = has_text(&story, "The figure agrees but for its edges");
        assert_eq!(agrees, turned.is_none(), "{told:?}");
        let places = told.iter().filter(|text| text.contains("of the figure"));
        let places: Vec<_> = places.collect();
        let is_right = match (turned, &places[..]) {
            (None, []) => true,
            (Some((joint, _)), [place]) => place.starts_with(&format!("Near {joint},")),
            _ => false,
        };
        assert!(is_right, "{told:?}");
    }
}

#[test]
fn a_limb_that_lies_beside_its_bone_is_named_where_the_floor_is_the_same() {
    for bone in ["Bone.001", "Bone.002"] {
        let turned = [(bone, Vec3::X * 30.0)];
        let story = changed_beside_its_picture("split_cube.dae", Look::Mannequin, |story| {
            turn_joints(story, &turned)
        });
        let Some(story) = story else { return };
        let told = texts(&story);
        let near = told.iter().filter(|text| text.starts_with("Near "));
        let near: Vec<_> = near.collect();
        assert!(
            matches!(near[..], [one] if one.starts_with(&format!("Near {bone},"))),
            "{told:?}"
        );
    }
}

#[test]
fn a_root_that_is_turned_is_told_where_the_floor_is_the_same_and_no_camera_is_blamed() {
    let story = robot_changed_beside_its_picture(|story| {
        let skeleton = story.character().character.skeleton();
        let root = skeleton.joints()[skeleton.roots()[0]].name.clone();
        turn_joints(story, &[(&root, Vec3::Y * 30.0)]);
    });
    let Some(story) = story else { return };
    let told = texts(&story);
    let root =
        "All over the figure: the floor is where A has it, so that the shape or its root is turned";
    assert!(has_text(&story, root), "{told:?}");
    assert!(
        !told.iter().any(|text| text.contains("camera to")),
        "{told:?}"
    );
}

#[test]
fn a_floor_that_is_elsewhere_tells_of_another_camera_and_no_joint_is_blamed() {
    for by in [[15.0, 0.0], [0.0, 15.0], [5.0, 0.0]] {
        let story = robot_changed_beside_its_picture(|story| turn_camera(story, by));
        let Some(story) = story else { return };
        let told = texts(&story);
        assert!(
            has_text(&story, "A is seen by another camera than B: its floor is"),
            "{told:?}"
        );
        assert!(!has_text(&story, "Near "), "{told:?}");
    }
}

#[test]
fn what_differs_from_the_mannequins_own_page_is_a_part_of_the_floor_and_of_edges() {
    let Some(mut story) = robot_beside("robot_start_camera") else {
        return;
    };
    let of_pixels = texts(&story)
        .into_iter()
        .find(|text| text.contains(" of 480000"));
    let text = of_pixels.expect("the view without the keyframes");
    let differing: u32 = text.split(' ').next().unwrap().parse().unwrap();
    // With the fitted view, or with the strip, more than half do.
    assert!(differing < 480_000 / 4, "{text}");
    assert!(has_text(&story, "The figure agrees"), "{:?}", texts(&story));
    // Seen from elsewhere, or in another pose, it does not; Home leads back.
    let page = story.session().view().camera;
    let moved = Camera {
        radius: 6.4,
        ..page
    };
    see_from(&mut story, moved);
    judge(&mut story);
    assert!(!has_text(&story, "The figure agrees"));
    assert!(
        has_text(&story, "In B the whole figure is"),
        "{:?}",
        texts(&story)
    );
    // How to get there comes first: below the causes it is out of sight.
    let words = [
        "A is the Virtual Mannequin's page. If all",
        "The figure differs",
    ];
    let [hint, cause] = words.map(|words| upper_edge(&story, words));
    assert!(hint < cause, "{hint} {cause}");
    // Nor is a bone to blame, though one is nearest to the middle of what differs, or part of the figure lies on itself.
    for (nearer, turned, aside) in [(0.0, 0.8, 0.0), (1.2, 0.2, -1.0), (1.2, 0.0, -0.3)] {
        let elsewhere = Camera {
            radius: page.radius - nearer,
            theta: page.theta + turned,
            target: page.target + aside * Vec3::X,
            ..page
        };
        see_from(&mut story, elsewhere);
        judge(&mut story);
        assert!(!has_text(&story, "Near "), "{:?}", texts(&story));
        assert!(has_text(
            &story,
            "A is the Virtual Mannequin's page. If all"
        ));
    }
    story.key(Key::Home);
    assert_eq!(story.session().view().camera, page);
    let is_once_more = |(_, text): &(_, &str)| text.starts_with("Home once more");
    assert!(!story.messages().iter().any(is_once_more), "it is there");
    judge(&mut story);
    assert!(has_text(&story, "The figure agrees"));
    let id = story.session().scene().shapes()[0].id;
    // A root that is turned looks as a camera does that is elsewhere, even if half of the figure lies on itself.
    let character = &story.session().scene().character(id).unwrap().character;
    let mut joints = character.skeleton().joints().iter();
    let root = joints.position(|joint| joint.parent.is_none()).unwrap();
    let mut pose = Pose::new();
    pose.set_joint_transform(root, Euler::from_degrees(Vec3::Y * 40.0));
    let turned = Edit::SetPose(id, pose);
    story.program.session_mut().edit(turned).unwrap();
    story.settle();
    judge(&mut story);
    assert!(!has_text(&story, "Near "), "{:?}", texts(&story));
    turn_joints(&mut story, &[("forearm.L", Vec3::Z * 25.0)]);
    judge(&mut story);
    assert!(!has_text(&story, "The figure agrees"));
    assert!(has_text(
        &story,
        "The figure differs, not only by its edges"
    ));
    // The place is that of the arm, however far the lines of bones reach that differ as well.
    assert!(has_text(&story, "Near forearm.L"), "{:?}", texts(&story));
    let seldom = "A is the Virtual Mannequin's page. If all";
    assert!(!has_text(&story, seldom));
    // Each of several limbs is named by the joint that was turned, whatever hangs on it.
    let z = Vec3::Z;
    for (turned, named) in [
        (
            &[
                ("forearm.R", Vec3::new(-11.2, 3.0, -89.4)),
                ("thigh.L", Vec3::new(6.3, 1.9, -109.0)),
            ][..],
            &["forearm.R", "thigh.L"][..],
        ),
        (&[("shin.R", Vec3::X * 90.0)], &["shin.R"]),
        (&[("head", z * 50.0)], &["head"]),
        (&[("hand.L", z * 45.0)], &["hand.L"]),
        (&[("hand.L", z * -80.0)], &["hand.L"]),
        (&[("upper_arm.R", z * 60.0)], &["upper_arm.R"]),
        (
            &[("thigh.L", z * 20.0), ("thigh.R", z * -20.0)],
            &["thigh.L", "thigh.R"],
        ),
        (
            &[
                ("upper_arm.L", z * 40.0),
                ("forearm.L", z * 30.0),
                ("shin.R", z * 40.0),
            ],
            &["shin.R", "upper_arm.L"],
        ),
    ] {
        turn_joints(&mut story, turned);
        judge(&mut story);
        let all = texts(&story).into_iter();
        let near = all.filter_map(|text| {
            let named = text.strip_prefix("Near ")?.split_once(',')?.0;
            Some(named.to_owned())
        });
        let mut near: Vec<String> = near.collect();
        near.sort();
        assert_eq!(near, named, "{turned:?}");
    }
}

#[test]
fn a_root_that_is_moved_a_little_is_told_by_the_floor_of_the_page_from_a_camera_that_is() {
    let Some(mut story) = robot_beside("robot_start_camera") else {
        return;
    };
    let told = |story: &Story, moved: &str, reason: &str| {
        let texts = texts(story);
        let begins = format!("In B the whole figure is moved {moved}");
        let mut whole = texts.iter().filter(|text| text.starts_with(&begins));
        let is_told = whole.any(|text| text.contains(reason));
        let turn_camera = "A is the Virtual Mannequin's page. If all";
        (is_told, has_text(story, turn_camera), texts)
    };
    let id = story.session().scene().shapes()[0].id;
    let character = &story.session().scene().character(id).unwrap().character;
    let mut joints = character.skeleton().joints().iter();
    let root = joints.position(|joint| joint.parent.is_none()).unwrap();
    for (offset, moved) in [
        (Vec3::new(0.15, 0.0, 0.0), "18 pixels left"),
        (Vec3::new(0.25, 0.0, 0.0), "30 pixels left"),
        (Vec3::new(0.0, 0.2, 0.0), "24 pixels up"),
        (Vec3::new(0.1, 0.1, 0.1), "12 pixels left and 13 pixels up"),
    ] {
        let mut pose = Pose::new();
        pose.set_root_offset(root, offset);
        let moves = Edit::SetPose(id, pose);
        story.program.session_mut().edit(moves).unwrap();
        story.settle();
        judge(&mut story);
        let (is_told, is_camera_blamed, texts) = told(&story, moved, "the floor is where A has it");
        assert!(is_told && !is_camera_blamed, "{offset}: {texts:?}");
    }
    let still = Edit::SetPose(id, Pose::new());
    story.program.session_mut().edit(still).unwrap();
    let page = story.session().view().camera;
    for (nearer, aside, moved, reason) in [
        (0.0, 0.1, "12 pixels right", "another camera, or"),
        // Its floor is clearly elsewhere.
        (
            0.3,
            0.0,
            "2 pixels down, 1.05",
            "so that it is another camera",
        ),
    ] {
        let elsewhere = Camera {
            radius: page.radius - nearer,
            target: page.target + aside * Vec3::X,
            ..page
        };
        see_from(&mut story, elsewhere);
        story.settle();
        judge(&mut story);
        let (is_told, is_camera_blamed, texts) = told(&story, moved, reason);
        assert!(is_told && is_camera_blamed, "{nearer} {aside}: {texts:?}");
    }
}

/// What is said first of another camera, …
const OTHER_CAMERA: &str = "A is seen by another camera than B: ";
/// … and where it alone explains what differs.
const ALL_AGREES: &str = ". From there all of the outline is where A has it.";

#[test]
fn beside_another_camera_limbs_that_are_turned_are_not_said_to_agree() {
    // From elsewhere, and from where Home leads to, which shows them.
    let homes = [
        ([8.0, 4.0], ", but not all: "),
        ([0.0, 0.0], ". Home leads there, "),
    ];
    for (from, besides) in homes {
        let agrees = format!(". From there most of the outline is where A has it{besides}");
        for (limb, degrees, by, away) in [
            ("Left elbow", -40.0, [25.0, 0.0], 1.25),
            ("Right leg", 8.0, [25.0, 0.0], 1.25),
            ("Left elbow", 25.0, [20.0, 10.0], 1.0),
        ] {
            let mut story = Story::start(&["builtin:adult", "builtin:robot"]);
            show_in(&mut story, Look::Course);
            turn_camera(&mut story, from);
            keep_picture(&mut story, (980, 736));
            turn_camera(&mut story, by);
            look_aside(&mut story, Vec3::ZERO, away);
            story.click("[1] Adult (ID: 1)");
            turn_joints(&mut story, &[(limb, Vec3::Z * degrees)]);
            compare_with_kept(&mut story);
            let told = texts(&story);
            let is_camera = |text: &&String| text.starts_with(OTHER_CAMERA);
            let camera = told.iter().find(is_camera);
            let camera = camera.unwrap_or_else(|| panic!("{told:?}"));
            assert!(camera.contains(&agrees), "{camera}");
            assert!(camera.contains("limbs are turned"), "{camera}");
        }
    }
}

/// What is said of the other picture's camera beside a story whose view is turned by so many degrees, after a picture of it was
/// kept.
fn told_of_camera(story: &mut Story, turned_by: [f32; 2]) -> String {
    keep_picture(story, (800, 600));
    turn_camera(story, turned_by);
    compare_with_kept(story);
    let told = texts(story);
    assert!(!has_text(story, "Near "), "{told:?}");
    let camera = told.iter().find_map(|text| text.strip_prefix(OTHER_CAMERA));
    let camera = camera.unwrap_or_else(|| panic!("{told:?}"));
    let (camera, _) = camera.split_once(ALL_AGREES).expect("a sentence");
    camera.to_owned()
}

#[test]
fn a_camera_that_is_turned_is_told_and_no_joint_is_blamed() {
    for (files, look, around, above) in [
        (&["builtin:adult"][..], Look::Course, -12.0, 0.0),
        (&["builtin:adult"], Look::Course, 8.0, 6.0),
        (&["builtin:adult"], Look::Studio, -14.0, 0.0),
        (&["builtin:robot", "builtin:dog"], Look::Course, -12.0, 0.0),
        (&["builtin:robot", "builtin:dog"], Look::Studio, 8.0, 6.0),
    ] {
        let mut story = Story::start(files);
        show_in(&mut story, look);
        let camera = told_of_camera(&mut story, [around, above]);
        let sides = [
            (around, ["to the left", "to the right"]),
            (above, ["up", "down"]),
        ];
        for (by, ways) in sides.into_iter().filter(|(by, _)| *by != 0.0) {
            // From B back to A.
            let way = ways[usize::from(by > 0.0)];
            assert!(camera.contains(way), "{by}: {camera}");
        }
    }
}

#[test]
fn no_camera_is_blamed_where_a_part_of_a_figure_is_exactly_the_same() {
    // The trunk moves with a hip, and both legs differ.
    let Some(mut story) = course_character(Look::Course, &["models/Model1.obj"]) else {
        return;
    };
    turn_joints(
        &mut story,
        &[
            ("Right leg", Vec3::X * -60.0),
            ("Right knee", Vec3::X * 50.0),
            ("Right elbow", Vec3::new(-40.0, 0.0, 22.5)),
            ("Left shoulder", Vec3::Z * 48.0),
        ],
    );
    let nearer = Camera {
        target: Vec3::new(0.46, 0.49, 0.5),
        radius: 1.41,
        ..story.session().view().camera
    };
    see_from(&mut story, nearer);
    keep_picture(&mut story, (1000, 750));
    story.type_into("Right knee X", "30");
    story.type_into("Left hip X", "25");
    compare_with_kept(&mut story);
    let told = texts(&story);
    assert!(has_text(&story, "Near Right knee"), "{told:?}");
    let is_camera = |text: &String| text.contains("another camera");
    assert!(!told.iter().any(is_camera), "{told:?}");
}

#[test]
fn the_camera_is_not_asked_about_where_a_part_of_the_figure_is_exactly_the_same() {
    let Some(mut story) = course_character(Look::Course, &["models/Model1.obj"]) else {
        return;
    };
    let camera = Camera {
        target: Vec3::new(0.458_573, 0.490_991, 0.499_982),
        radius: 1.843_88,
        theta: 92.578_3_f32.to_radians(),
        phi: 0.1,
        ..story.session().view().camera
    };
    see_from(&mut story, camera);
    let bend = |story: &mut Story, elbow: f32| {
        let turned = [
            ("Neck", Vec3::X * 20.0),
            ("Right leg", Vec3::Z * 15.0),
            ("Right knee", Vec3::X * 45.0),
            ("Right shoulder", Vec3::Z * 49.0),
            ("Right elbow", Vec3::Z * elbow),
        ];
        turn_joints(story, &turned);
    };
    bend(&mut story, 20.0);
    keep_picture(&mut story, (1000, 750));
    bend(&mut story, 60.0);
    compare_with_kept(&mut story);
    let told = texts(&story);
    assert!(has_text(&story, "Near Right elbow,"), "{told:?}");
    let is_of_camera = |text: &String| text.to_lowercase().contains("camera ");
    assert!(!told.iter().any(is_of_camera), "{told:?}");
}

#[test]
fn a_camera_that_is_turned_is_told_where_all_of_the_outline_differs() {
    let mut story = Story::start(&["builtin:adult"]);
    show_in(&mut story, Look::Course);
    let mut aside = story.session().view().camera;
    aside.target += 0.6 * Vec3::X;
    see_from(&mut story, aside);
    story.settle();
    let camera = told_of_camera(&mut story, [20.0, 0.0]);
    assert!(camera.contains("farther to the right"), "{camera}");
    // It is known, so that no pose is suspected as well.
    let told = texts(&story);
    let is_vague = |text: &String| text.contains("posed otherwise");
    assert!(!told.iter().any(is_vague), "{told:?}");
}

#[test]
fn no_joint_is_blamed_for_much_of_a_figure_where_a_shape_is_hidden_as_well() {
    let mut story = Story::start(&["builtin:adult", "builtin:adult", "builtin:gem"]);
    show_in(&mut story, Look::Course);
    keep_picture(&mut story, (1000, 700));
    let here = story.session().view().camera;
    let turned = Camera {
        theta: here.theta + 0.16,
        phi: here.phi + 0.08,
        ..here
    };
    see_from(&mut story, turned);
    story.click("Hide Gem");
    compare_with_kept(&mut story);
    assert!(!has_text(&story, "Near "), "{:?}", texts(&story));
}

/// Shows the scene from a camera that looks so far beside where it does, and is so many times as far away.
fn look_aside(story: &mut Story, aside: Vec3, away: f32) {
    let mut camera = story.session().view().camera;
    camera.target += aside;
    camera.radius *= away;
    see_from(story, camera);
    story.settle();
}

/// The comparison with a picture from much farther away that looks aside, and is turned by so many degrees.
fn beside_far_camera(turned: f32) -> Story {
    let mut story = Story::start(&["builtin:adult", "builtin:gem"]);
    show_in(&mut story, Look::Course);
    turn_camera(&mut story, [20.0, 8.0]);
    look_aside(&mut story, Vec3::new(0.3, -0.4, 0.2), 2.0);
    keep_picture(&mut story, (800, 600));
    look_aside(&mut story, Vec3::new(-0.5, 0.5, 0.4), 0.45);
    turn_camera(&mut story, [turned, 0.0]);
    compare_with_kept(&mut story);
    story
}

#[test]
fn a_camera_that_is_much_farther_away_and_looks_aside_is_told() {
    let told = texts(&beside_far_camera(25.0));
    let camera = told.iter().find_map(|text| text.strip_prefix(OTHER_CAMERA));
    let camera = camera.unwrap_or_else(|| panic!("{told:?}"));
    let (camera, _) = camera.split_once(ALL_AGREES).expect("a sentence");
    for differs in ["farther to the right", "farther away", "looking farther"] {
        assert!(camera.contains(differs), "{camera}");
    }
}

#[test]
fn where_all_of_the_outline_differs_a_figure_that_is_only_placed_elsewhere_is_told_by_that() {
    let told = texts(&beside_far_camera(12.0));
    let is_placed = |text: &String| text.starts_with("In B the whole figure is moved ");
    assert!(told.iter().any(is_placed), "{told:?}");
    let is_vague = |text: &String| text.contains("posed otherwise");
    assert!(!told.iter().any(is_vague), "{told:?}");
}

#[test]
fn a_camera_to_which_home_leads_is_told_with_that() {
    let elbow = &[("Left elbow", Vec3::Z * 40.0)];
    for (turned, presses) in [(&[][..], 1), (elbow, 1), (&[], 2)] {
        let mut story = Story::start(&["builtin:adult"]);
        show_in(&mut story, Look::Course);
        (1..presses).for_each(|_| story.key(Key::Home));
        keep_picture(&mut story, (800, 600));
        look_aside(&mut story, Vec3::new(0.4, 0.3, 0.5), 0.4);
        turn_joints(&mut story, turned);
        compare_with_kept(&mut story);
        let told = texts(&story);
        let is_told = |text: &String| text.starts_with(OTHER_CAMERA);
        let camera = told.iter().find(|text| is_told(text));
        let camera = camera.unwrap_or_else(|| panic!("{told:?}"));
        let leads = match presses {
            1 => "Home leads there",
            _ => "Home, pressed twice, leads there",
        };
        assert!(camera.contains(leads), "{camera}");
        assert_eq!(
            camera.contains("limbs are turned"),
            !turned.is_empty(),
            "{camera}"
        );
        // It is not said once more of the course's program.
        assert!(!has_text(&story, "If A has the camera"), "{told:?}");
        (0..presses).for_each(|_| story.key(Key::Home));
        judge(&mut story);
        let told = texts(&story);
        match turned {
            [] => assert!(
                has_text(&story, "A and B are equal, pixel by pixel."),
                "{told:?}"
            ),
            _ => assert_eq!(places(&story), ["Left elbow"], "{told:?}"),
        }
    }
}

#[test]
fn how_far_a_camera_is_turned_is_told_where_outlines_tell_it_well() {
    for look in [Look::Course, Look::Studio] {
        let Some(mut story) = course_character_beside_shape(look) else {
            return;
        };
        let camera = told_of_camera(&mut story, [-10.0, 0.0]);
        let degrees = camera
            .strip_prefix("about ")
            .and_then(|camera| camera.split_once("° farther to the left"));
        let (degrees, _) = degrees.unwrap_or_else(|| panic!("{look:?}: {camera}"));
        let degrees: f32 = degrees.parse().unwrap();
        assert!((degrees - 10.0).abs() <= 2.0, "{look:?}: {camera}");
    }
}

#[test]
fn several_joints_that_are_turned_are_told_and_no_camera() {
    for look in [Look::Course, Look::Studio] {
        let mut story = Story::start(&["builtin:adult"]);
        show_in(&mut story, look);
        keep_picture(&mut story, (800, 600));
        let id = story.session().scene().shapes()[0].id;
        let turned = [
            ("Left elbow", 40.0),
            ("Right elbow", -40.0),
            ("Right leg", 25.0),
        ];
        let mut pose = Pose::new();
        for (name, degrees) in turned {
            let character = story.session().scene().character(id).unwrap();
            let joint = Pose::find_joint(character.character.skeleton(), name).unwrap();
            pose.set_joint_transform(joint, Euler::from_degrees(Vec3::Z * degrees));
        }
        let edit = Edit::SetPose(id, pose);
        story.program.session_mut().edit(edit).unwrap();
        story.settle();
        compare_with_kept(&mut story);
        let told = texts(&story);
        assert!(!has_text(&story, "A is seen by another camera"), "{told:?}");
        for (name, _) in turned {
            assert!(has_text(&story, &format!("Near {name}")), "{told:?}");
        }
    }
}

#[test]
fn a_shape_that_the_picture_has_and_the_live_view_has_not_is_told_as_missing_or_hidden() {
    const ABSENT: &str = "A shows something where B has nothing, in about ";
    let absent = |story: &Story| -> Vec<String> {
        let told = texts(story).into_iter();
        let mut told: Vec<String> = told.filter(|text| text.starts_with(ABSENT)).collect();
        told.sort_unstable();
        told.dedup();
        told
    };
    for look in [Look::Course, Look::Studio] {
        let mut story = adult_beside_shapes(look);
        story.click("Hide Goblet");
        judge(&mut story);
        let told = absent(&story);
        let is_told = matches!(&told[..], [one] if one.ends_with(": Goblet is hidden there."));
        assert!(is_told, "{look:?} {:?}", texts(&story));
        assert_eq!(places(&story), [""; 0], "{look:?} {:?}", texts(&story));
        // Beside another one that is elsewhere, and without it.
        story.click("[3] Gem (ID: 3)");
        story.type_into("Position Y", "0.3");
        story.click("[2] Goblet (ID: 2)");
        story.key(Key::Delete);
        judge(&mut story);
        let told = absent(&story);
        let missing = ": a shape is missing there, or hidden.";
        assert!(
            matches!(&told[..], [one] if one.ends_with(missing)),
            "{look:?} {:?}",
            texts(&story)
        );
        assert_eq!(places(&story), ["Gem"], "{look:?} {:?}", texts(&story));
    }
}

#[test]
fn a_camera_of_the_page_that_is_turned_by_less_than_its_figure_shows_is_told_by_its_floor() {
    let Some(mut story) = robot_beside("robot_start_camera") else {
        return;
    };
    let page = story.session().view().camera;
    for (theta, phi, is_turned) in [(0.0, 0.0, false), (0.06, 0.0, true), (0.0, 0.05, true)] {
        let turned = Camera {
            theta: page.theta + theta,
            phi: page.phi + phi,
            ..page
        };
        see_from(&mut story, turned);
        judge(&mut story);
        assert!(has_text(&story, "The figure agrees"), "{:?}", texts(&story));
        let floor = "The floor differs by more than the page's noise";
        assert_eq!(has_text(&story, floor), is_turned, "{theta} {phi}");
    }
}

#[test]
fn a_shape_that_is_alone_and_larger_in_the_picture_is_not_said_to_be_missing() {
    for (key, look) in [
        // Its front has one color, so that the smaller one is nowhere off.
        (Key::C, Look::Studio),
        (Key::S, Look::Course),
        (Key::S, Look::Studio),
    ] {
        let mut story = Story::start(&[]);
        story.key_with(Modifiers::SHIFT, key);
        show_in(&mut story, look);
        story.type_into("Uniform Scale", "1.3");
        compare_with_itself(&mut story, (640, 480));
        judge(&mut story);
        story.type_into("Uniform Scale", "1");
        judge(&mut story);
        let told = texts(&story);
        assert!(
            !has_text(&story, "A shows something"),
            "{key:?} {look:?} {told:?}"
        );
        let is_larger = |text: &&String| text.contains("times as large") || text.contains("nearer");
        let larger = told.iter().find(is_larger);
        let larger = larger.unwrap_or_else(|| panic!("{key:?} {look:?} {told:?}"));
        // Round a sphere no camera shows anything else.
        let is_turned = larger.contains("to the left") || larger.contains("to the right");
        assert!(key == Key::C || !is_turned, "{look:?} {larger}");
    }
}
