//! The Compare panel, and the pictures that take the place of the view.

use crate::interface::{Editor, curves};
use editor_core::compare::{Area, CompareError, Differences, Finding, Judgment};
use editor_core::editor::View;
use editor_core::geometry::Picture;
use editor_core::scene::{Camera, Look, Shading};
use editor_core::ui::{
    Ask, CompareAction, CompareMode, CompareReport, CompareSettings, CompareView, DARK, LIGHT,
    ShownPicture, course_panels,
};
use egui::{Color32, Key, Rect, TextureId, Vec2, pos2, vec2};

/// Textures of the reference, of the live view and of their differences.
const TEXTURES: [TextureId; 3] = [TextureId::User(1), TextureId::User(2), TextureId::User(3)];

/// A comparison of a brown live view with a gray picture of the course's size.
pub struct Comparing {
    settings: CompareSettings,
    reference: Picture,
    live: Picture,
    report: CompareReport,
    look: Look,
    is_reference_smooth: Option<bool>,
}

impl Comparing {
    fn new() -> Self {
        let filled = |color: [u8; 4]| Picture {
            width: 800,
            height: 600,
            rgba: color.repeat(800 * 600),
        };
        Self {
            settings: CompareSettings::default(),
            reference: filled([26, 26, 26, 255]),
            live: filled([90, 80, 70, 128]),
            report: CompareReport::default(),
            look: Look::Course,
            is_reference_smooth: None,
        }
    }

    pub fn view(&self) -> CompareView<'_> {
        let shown = |picture, texture| ShownPicture { picture, texture };
        CompareView {
            name: "sample.png",
            look: self.look,
            is_cut: false,
            are_edges_chosen: true,
            is_reference_smooth: self.is_reference_smooth,
            settings: &self.settings,
            reference: shown(&self.reference, TEXTURES[0]),
            live: Some(shown(&self.live, TEXTURES[1])),
            difference: Some(TEXTURES[2]),
            report: &self.report,
            judged_part: None,
        }
    }
}

/// What the program would do.
pub fn carry_out(comparing: &mut Option<Comparing>, ask: &Ask) {
    match (ask, comparing.as_mut()) {
        (Ask::Compare(CompareAction::Set(settings)), Some(comparing)) => {
            comparing.settings = settings.clone();
        }
        (Ask::Compare(CompareAction::Close), _) => *comparing = None,
        _ => {}
    }
}

fn comparing() -> Editor {
    let mut editor = Editor::sized(vec2(1280.0, 800.0));
    editor.choose(&["Insert", "Cube"]);
    editor.view(View::Select(None));
    editor.harness.state_mut().comparing = Some(Comparing::new());
    editor.settle();
    editor
}

fn settings(editor: &Editor) -> &CompareSettings {
    let comparing = &editor.harness.state().comparing;
    &comparing.as_ref().expect("a comparison").settings
}

fn report(editor: &mut Editor, report: CompareReport) {
    let comparing = &mut editor.harness.state_mut().comparing;
    comparing.as_mut().expect("a comparison").report = report;
    editor.settle();
}

fn counts(differing: u64, max: u8) -> Differences {
    Differences {
        compared_pixels: 480_000,
        differing_pixels: differing,
        drawn_pixels: 12_000,
        drawn_differing_pixels: differing / 2,
        max,
        mean: 0.25,
        rmse: 0.5,
        psnr: 31.5,
        differing_area: None,
    }
}

/// Chooses a mode without a click, so that the pointer stays away from the pictures.
fn with_mode(mode: CompareMode) -> Editor {
    let mut editor = comparing();
    let comparing = &mut editor.harness.state_mut().comparing;
    comparing.as_mut().expect("a comparison").settings.mode = mode;
    editor.settle();
    editor
}

/// Pictures on the screen, from the bottom up: texture, place, and opacity of 255.
fn shown(editor: &Editor) -> Vec<(TextureId, Rect, u8)> {
    let shapes = editor.harness.output().shapes.iter();
    let pictures = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Rect(rect) => Some((rect.fill_texture_id(), rect.rect, rect.fill.a())),
        egui::Shape::Mesh(mesh) => {
            let opacity = mesh.vertices.first().map_or(0, |vertex| vertex.color.a());
            Some((mesh.texture_id, mesh.calc_bounds(), opacity))
        }
        _ => None,
    });
    pictures
        .filter(|(texture, ..)| TEXTURES.contains(texture))
        .collect()
}

#[test]
fn each_mode_shows_the_pictures_that_its_captions_name() {
    let [reference, live, differences] = TEXTURES;
    let editor = with_mode(CompareMode::SideBySide);
    let [(first, left, 255), (second, right, 255)] = shown(&editor)[..] else {
        panic!("{:?}", shown(&editor));
    };
    assert_eq!((first, second), (reference, live));
    assert!(left.right() < right.left() && left.top() == right.top());
    let captions = editor.painted();
    let x = |text: &str| {
        let found = captions.iter().find(|(painted, _)| painted == text);
        found.expect("a caption").1.left()
    };
    assert!(x("A: reference") < left.right() && x("B: live view") >= right.left() - 1.0);

    let mut editor = with_mode(CompareMode::Swipe);
    let whole = editor.harness.state().view;
    let comparing = &mut editor.harness.state_mut().comparing;
    comparing.as_mut().expect("a comparison").settings.swipe = 0.25;
    editor.settle();
    let [(first, left, 255), (second, right, 255)] = shown(&editor)[..] else {
        panic!("{:?}", shown(&editor));
    };
    assert_eq!((first, second), (reference, live));
    assert_eq!((left.left(), right.right()), (whole.left(), whole.right()));
    assert!((left.width() / whole.width() - 0.25).abs() < 0.01 && left.right() == right.left());

    let mut editor = with_mode(CompareMode::OnionSkin);
    let comparing = &mut editor.harness.state_mut().comparing;
    comparing.as_mut().expect("a comparison").settings.onion = 0.2;
    editor.settle();
    let [(first, below, 255), (second, above, opacity)] = shown(&editor)[..] else {
        panic!("{:?}", shown(&editor));
    };
    assert_eq!((first, second, below), (reference, live, above));
    assert_eq!(opacity, 51, "a fifth of 255");

    let only = |editor: &Editor| match shown(editor)[..] {
        [(texture, _, 255)] => texture,
        ref other => panic!("{other:?}"),
    };
    assert_eq!(only(&with_mode(CompareMode::Difference)), differences);
}

#[test]
fn the_reference_is_the_first_of_two_pictures_that_blink() {
    let mut editor = with_mode(CompareMode::Blink);
    for (time, texture, caption) in [
        (12.1, TEXTURES[0], "A: reference"),
        (12.5, TEXTURES[0], "A: reference"),
        (12.7, TEXTURES[1], "B: live view"),
        (13.3, TEXTURES[0], "A: reference"),
    ] {
        editor.harness.input_mut().time = Some(time);
        editor.harness.step();
        let pictures: Vec<_> = shown(&editor).iter().map(|(id, ..)| *id).collect();
        assert_eq!(pictures, [texture], "after {time} seconds");
        let captions = editor.painted();
        assert!(captions.iter().any(|(text, _)| text == caption), "{time}");
    }
}

#[test]
fn the_pixel_under_the_pointer_is_told_with_its_color_in_both_pictures() {
    let hovered = |mode| {
        let mut editor = with_mode(mode);
        let picture = editor.harness.state().view;
        let pixel = picture.width() / 800.0;
        let at = picture.min + vec2(699.5, 123.5) * pixel;
        editor.harness.hover_at(at);
        editor.settle();
        let texts = editor.painted().into_iter().map(|(text, _)| text);
        texts
            .filter(|text| text.contains("· pixel"))
            .collect::<Vec<_>>()
    };
    let (a, b) = ("26 26 26", "90 80 70, opacity 128");
    let mut beside = hovered(CompareMode::SideBySide);
    beside.sort();
    assert_eq!(
        beside,
        [
            format!("A: reference · pixel 699, 123: {a}"),
            format!("B: live view · pixel 699, 123: {b}")
        ]
    );
    assert_eq!(
        hovered(CompareMode::Difference),
        [format!(
            "Differences, lighter where larger · pixel 699, 123: A {a}, B {b}"
        )]
    );
}

#[test]
fn sliders_move_the_line_and_the_opacity() {
    let mut editor = with_mode(CompareMode::Swipe);
    editor.drag("Swipe position", 30.0);
    assert!(settings(&editor).swipe > 0.6 && settings(&editor).onion == 0.5);
    let mut editor = with_mode(CompareMode::OnionSkin);
    editor.drag("Live view's opacity", -30.0);
    assert!(settings(&editor).onion < 0.4 && settings(&editor).swipe == 0.5);
}

#[test]
fn the_edges_of_a_mask_are_dragged_one_by_one() {
    let before = Area {
        x: 200,
        y: 150,
        width: 400,
        height: 300,
    };
    let dragged = |from: (f32, f32), by: (f32, f32)| {
        let mut editor = with_mode(CompareMode::Difference);
        editor.click("Add mask");
        assert_eq!(settings(&editor).masks, [before]);
        let picture = editor.harness.state().view;
        let pixel = picture.width() / 800.0;
        let at = |(x, y): (f32, f32)| pos2(picture.left() + x * pixel, picture.top() + y * pixel);
        editor.press(at(from));
        editor.release(at((from.0 + by.0, from.1 + by.1)));
        settings(&editor).masks[0]
    };
    let (x, width) = (230, 370);
    assert_eq!(
        dragged((200.0, 300.0), (30.0, 9.0)),
        Area { x, width, ..before }
    );
    let width = 350;
    assert_eq!(
        dragged((600.0, 300.0), (-50.0, 9.0)),
        Area { width, ..before }
    );
    let (y, height) = (130, 320);
    assert_eq!(
        dragged((400.0, 150.0), (9.0, -20.0)),
        Area {
            y,
            height,
            ..before
        }
    );
    let height = 340;
    assert_eq!(
        dragged((400.0, 450.0), (9.0, 40.0)),
        Area { height, ..before }
    );
}

const OTHER_LOOK: &str =
    "B has the Studio look. Course look draws it as the course's program does.";
const SMOOTH: &str =
    "B has smooth edges. If A has none, as the course's program draws it, untick Smooth edges.";
const COVERED: &str = "If A shows the other program's panels, leave them out: Mask its panels.";

#[test]
fn hints_name_what_a_user_can_do_about_the_differences() {
    let hints = |editor: &Editor| [OTHER_LOOK, SMOOTH, COVERED].map(|hint| editor.has(hint));
    let with_background = CompareReport {
        differences: Some(counts(240, 200)),
        ..CompareReport::default()
    };
    let mut editor = comparing();
    editor.view(View::SetLook(Look::Course));
    report(&mut editor, with_background.clone());
    assert_eq!(hints(&editor), [false, false, false]);
    editor.click("Smooth edges");
    assert_eq!(hints(&editor), [false, true, false]);
    editor.view(View::SetLook(Look::Studio));
    assert_eq!(hints(&editor), [true, false, false]);
    // Where the picture's own edges are known, those that were chosen are told by them.
    let has_own_edges = |editor: &mut Editor, own: Option<bool>| {
        let comparing = &mut editor.harness.state_mut().comparing;
        comparing
            .as_mut()
            .expect("a comparison")
            .is_reference_smooth = own;
        editor.settle();
    };
    let chosen = "B has smooth edges, and A hard ones: untick Smooth edges.";
    for (own, is_told) in [(Some(false), true), (Some(true), false), (None, false)] {
        has_own_edges(&mut editor, own);
        assert_eq!(editor.has(chosen), is_told, "{own:?}");
    }
    for (look, is_told) in [(Look::Studio, false), (Look::Course, true)] {
        let comparing = &mut editor.harness.state_mut().comparing;
        comparing.as_mut().expect("a comparison").look = look;
        editor.settle();
        assert_eq!(hints(&editor)[0], is_told, "A has the look {look:?}");
    }
    editor.click("Course look");
    let without_background = CompareReport {
        differences: Some(Differences {
            drawn_pixels: 480_000,
            ..counts(240, 200)
        }),
        ..CompareReport::default()
    };
    report(&mut editor, without_background);
    assert_eq!(hints(&editor), [false, false, true]);
    editor.click("Mask its panels");
    assert_eq!(hints(&editor), [false, false, false]);
}

#[test]
fn beside_a_picture_of_the_course_s_program_another_camera_is_told_with_the_key_to_its_first_one() {
    const ONCE: &str =
        "If A has the camera that the course's program starts with, Home gives it to B.";
    const TWICE: &str = "If A has the camera that the course's program starts with, Home, pressed twice, gives it to B.";
    let told = |editor: &Editor| [ONCE, TWICE].map(|hint| editor.has(hint));
    let judged = |findings: Vec<Finding>| CompareReport {
        differences: Some(counts(240, 200)),
        judgment: Some(Judgment {
            ssim: None,
            flip: 0.125,
            findings,
            figure: None,
            off: None,
        }),
        ..CompareReport::default()
    };
    let placed = judged(vec![Finding::Placed {
        dx: 0,
        dy: 0,
        factor: 2.0,
        degrees: 0.0,
        unexplained: 0.0,
    }]);
    let mut editor = comparing();
    editor.view(View::SetLook(Look::Course));
    editor.view(View::SetCamera(Camera::default()));
    report(&mut editor, placed.clone());
    assert_eq!(told(&editor), [false, false], "it is that camera");
    let mut closer = Camera::default();
    closer.radius *= 0.5;
    editor.view(View::SetCamera(closer));
    for found in [placed.clone(), judged(Vec::new())] {
        report(&mut editor, found);
        assert_eq!(told(&editor), [true, false]);
    }
    editor.key(Key::Home);
    assert_eq!(editor.session().view().camera, Camera::default());
    // Where the document begins with another camera that comes first.
    let mut begins = Camera::default();
    begins.radius *= 2.0;
    editor.view(View::BeginAt(begins));
    assert_eq!(told(&editor), [true, false]);
    editor.view(View::SetCamera(closer));
    assert_eq!(told(&editor), [false, true]);
    editor.key(Key::Home);
    editor.key(Key::Home);
    assert_eq!(editor.session().view().camera, Camera::default());
    editor.view(View::SetCamera(closer));
    report(&mut editor, judged(vec![Finding::Gray]));
    assert_eq!(told(&editor), [false, false], "nothing is elsewhere");
    editor.view(View::SetLook(Look::Studio));
    report(&mut editor, placed);
    assert_eq!(
        told(&editor),
        [false, false],
        "it is no camera of this look"
    );
}

#[test]
fn differences_below_the_threshold_are_not_called_equal() {
    let mut editor = comparing();
    let below = CompareReport {
        differences: Some(counts(0, 5)),
        ..CompareReport::default()
    };
    report(&mut editor, below);
    assert!(editor.has("No pixel differs by more than the threshold."));
    assert!(!editor.has("A and B are equal, pixel by pixel."));
    assert!(editor.has("Looking for the cause…"));
    let judged = CompareReport {
        differences: Some(counts(3, 5)),
        judgment: Some(Judgment {
            ssim: None,
            flip: 0.125,
            findings: Vec::new(),
            figure: None,
            off: None,
        }),
        ..CompareReport::default()
    };
    report(&mut editor, judged.clone());
    assert!(editor.has("No single cause explains the differences."));
    // Where they are is said all the same.
    let area = |x, y, width, height| Area {
        x,
        y,
        width,
        height,
    };
    let (some, figure) = (area(180, 180, 20, 20), area(0, 0, 200, 200));
    let placed = CompareReport {
        differences: Some(Differences {
            differing_area: Some(some),
            ..counts(3, 5)
        }),
        judgment: judged.judgment.map(|judgment| Judgment {
            figure: Some(figure),
            ..judgment
        }),
        ..CompareReport::default()
    };
    report(&mut editor, placed);
    let place = "At the bottom right of the figure, about 1 % of it.";
    assert!(editor.has(place));
    assert!(editor.has("none below 11×11 pixels, 0.12500"));
}

#[test]
fn a_picture_to_compare_with_is_asked_for_by_menu_and_key() {
    let mut editor = Editor::new();
    editor.choose(&["View", "Compare with Picture…"]);
    editor.key(Key::F8);
    let choose = Ask::Compare(CompareAction::Choose);
    assert_eq!(editor.asked(), [choose.clone(), choose]);
}

#[test]
fn the_key_that_begins_a_comparison_ends_it() {
    let mut editor = comparing();
    editor.key(Key::F8);
    assert_eq!(editor.asked(), [Ask::Compare(CompareAction::Close)]);
}

#[test]
fn the_entry_of_the_menu_ends_a_comparison_as_its_key_does() {
    let mut editor = comparing();
    editor.click("View");
    assert!(!editor.has("Compare with Picture…"));
    editor.click("End Comparison with Picture");
    assert_eq!(editor.asked(), [Ask::Compare(CompareAction::Close)]);
}

#[test]
fn every_mode_is_one_click_and_shows_what_is_what() {
    let mut editor = comparing();
    for mode in CompareMode::ALL {
        editor.click(mode.label());
        assert_eq!(settings(&editor).mode, mode);
    }
    editor.click("Side by side");
    assert!(editor.has("A: reference") && editor.has("B: live view"));
    editor.click("Difference");
    assert!(!editor.has("A: reference"));
}

#[test]
fn the_line_between_the_pictures_is_dragged_in_the_view() {
    let mut editor = comparing();
    editor.click("Swipe");
    editor.drag("Line between the pictures", 200.0);
    // The picture is shown pixel by pixel, 800 wide.
    assert!((settings(&editor).swipe - 0.75).abs() < 0.01);
}

#[test]
fn masks_are_added_for_the_courses_panels_and_by_hand_and_taken_away() {
    let mut editor = comparing();
    editor.click("Mask its panels");
    assert_eq!(settings(&editor).masks, course_panels((800, 600)));
    editor.click("Add mask");
    editor.type_into("Mask 3 X", "100");
    editor.type_into("Mask 3 Y", "600/4");
    editor.type_into("Mask 3 width", "5000");
    editor.type_into("Mask 3 height", "0");
    let third = Area {
        x: 100,
        y: 150,
        width: 700,
        height: 1,
    };
    assert_eq!(settings(&editor).masks[2], third);
    editor.type_into("Mask 3 X", "790");
    assert_eq!(settings(&editor).masks[2], third, "it keeps its size");
    editor.click("Remove mask 1");
    assert_eq!(settings(&editor).masks.len(), 2);
    assert_eq!(settings(&editor).masks[1], third);
    // The next picture may be one without panels.
    editor.click("Mask its panels");
    assert_eq!(settings(&editor).masks.len(), 3);
    editor.click("Unmask its panels");
    assert_eq!(settings(&editor).masks, [third]);
    assert!(editor.has("Mask its panels"));
}

#[test]
fn in_the_look_of_the_mannequin_its_keyframes_are_masked() {
    let mut editor = comparing();
    editor.view(View::SetLook(Look::Mannequin));
    editor.click("Mask its panels");
    let masks = settings(&editor).masks.clone();
    let masks: Vec<String> = masks.iter().map(ToString::to_string).collect();
    assert_eq!(masks, ["0,400,800,200"]);
}

#[test]
fn a_mask_is_moved_by_its_label() {
    let mut editor = comparing();
    editor.click("Difference");
    editor.click("Add mask");
    let before = settings(&editor).masks[0];
    editor.drag("Move mask 1", 50.0);
    let after = settings(&editor).masks[0];
    assert_eq!(
        after,
        Area {
            x: before.x + 50,
            ..before
        }
    );
}

#[test]
fn the_course_look_is_one_click() {
    let mut editor = comparing();
    editor.view(View::SetLook(Look::Studio));
    editor.view(View::SetShading(Shading::Smooth));
    editor.click("Smooth edges");
    assert!(settings(&editor).smooth_edges);
    editor.click("Course look");
    assert!(!settings(&editor).smooth_edges);
    let view = editor.session().view();
    assert_eq!(
        (view.look, view.shading),
        (Look::Course, Shading::AsAuthored)
    );
}

#[test]
fn the_mannequin_look_is_one_click_and_the_hint_names_the_look_that_the_view_has() {
    let mut editor = comparing();
    let began_in = |editor: &mut Editor, look| {
        let comparing = &mut editor.harness.state_mut().comparing;
        comparing.as_mut().expect("a comparison").look = look;
        editor.settle();
    };
    let with_background = CompareReport {
        differences: Some(counts(240, 200)),
        ..CompareReport::default()
    };
    report(&mut editor, with_background);
    editor.click("Mannequin look");
    assert_eq!(editor.session().view().look, Look::Mannequin);
    let other = "B has the Mannequin look. Course look draws it as the course's program does.";
    assert!(editor.has(other));
    began_in(&mut editor, Look::Mannequin);
    assert!(!editor.has(other));
    editor.view(View::SetLook(Look::Course));
    assert!(
        editor.has("B has the Course look. Mannequin look draws it as the Virtual Mannequin does.")
    );
}

#[test]
fn numbers_and_causes_are_told_in_words() {
    let mut editor = comparing();
    assert!(editor.has("Measuring…"));
    let told = CompareReport {
        differences: Some(counts(240, 200)),
        judgment: Some(Judgment {
            ssim: Some(0.5),
            flip: 0.25,
            findings: vec![Finding::Shifted { dx: 1, dy: 0 }],
            figure: None,
            off: None,
        }),
        measuring: false,
        problem: None,
        page_figure: None,
    };
    report(&mut editor, told.clone());
    for text in [
        "240 of 480000 (0.050 %)",
        "120 of 12000 (1.000 %)",
        "at most 200, mean 0.250 of 255",
        "31.50 dB",
        "0.50000, 0.25000",
        "B is A moved 1 pixel right.",
    ] {
        assert!(editor.has(text), "{text}");
    }
    let newer = CompareReport {
        measuring: true,
        ..told
    };
    report(&mut editor, newer);
    assert!(
        !editor.has("B is A moved 1 pixel right."),
        "a cause of older pictures is told"
    );
    let equal = CompareReport {
        differences: Some(counts(0, 0)),
        ..CompareReport::default()
    };
    report(&mut editor, equal);
    assert!(editor.has("A and B are equal, pixel by pixel."));
    let problem = CompareReport {
        problem: Some(CompareError::NothingToCompare),
        ..CompareReport::default()
    };
    report(&mut editor, problem);
    assert!(editor.has("no pixel is left to compare"));
}

#[test]
fn a_control_point_is_dragged_in_the_live_picture_of_either_arrangement() {
    for mode in [CompareMode::SideBySide, CompareMode::OnionSkin] {
        let mut editor = curves::with_curve("Bézier Curve");
        let mut comparing = Comparing::new();
        comparing.settings.mode = mode;
        editor.harness.state_mut().comparing = Some(comparing);
        editor.settle();
        let camera = editor.session().view().camera;
        let from = curves::place(&editor, 3);
        let to = from + vec2(-20.0, 15.0);
        editor.press(from);
        editor.release(to);
        let off = curves::place(&editor, 3) - to;
        assert!(off.length() < 0.05, "{mode:?}: {off:?}");
        assert_eq!(editor.session().view().camera, camera);
    }
}

#[test]
fn a_pixel_of_the_picture_pans_as_far_as_a_pixel_of_the_view() {
    let panned = |comparing: Option<Comparing>| {
        let mut editor = Editor::sized(vec2(1280.0, 800.0));
        editor.harness.state_mut().comparing = comparing;
        editor.settle();
        let picture = editor.harness.state().view;
        let shown = if editor.harness.state().comparing.is_some() {
            picture.width() / 800.0
        } else {
            1.0
        };
        let from = picture.center();
        editor.press(from);
        editor.release(from + vec2(40.0, 0.0) * shown);
        editor.session().view().camera.target
    };
    let (plain, compared) = (panned(None), panned(Some(Comparing::new())));
    assert!(plain.length() > 1e-3, "nothing moved");
    assert!(plain.distance(compared) < 1e-5, "{plain} {compared}");
}

#[test]
fn esc_ends_the_comparison_before_the_program_and_so_does_its_cross() {
    let mut editor = comparing();
    editor.key(Key::Escape);
    assert!(editor.harness.state().comparing.is_none());
    assert!(!editor.has("Stop comparing"));
    editor.wait();
    editor.key(Key::Escape);
    editor.key(Key::Escape);
    let close = Ask::Compare(CompareAction::Close);
    assert_eq!(editor.asked(), [close.clone(), Ask::Quit]);

    let mut editor = comparing();
    editor.click("Save…");
    editor.click("Compare with another picture");
    editor.click("Stop comparing");
    let asked = [CompareAction::Save, CompareAction::Choose].map(Ask::Compare);
    assert_eq!(editor.asked(), [asked[0].clone(), asked[1].clone(), close]);
}

#[test]
fn everything_is_there_in_a_small_window_too() {
    let mut editor = Editor::new();
    editor.harness.state_mut().comparing = Some(Comparing::new());
    editor.settle();
    editor.click("Onion skin");
    editor.click("Add mask");
    editor.type_into("Threshold", "8");
    assert_eq!(settings(&editor).threshold, 8);
    assert_eq!(settings(&editor).masks.len(), 1);
    editor.click("Stop comparing");
    assert!(editor.harness.state().comparing.is_none());
}

/// Rectangles over the pictures with an edge of the color of what is chosen.
fn outlines(editor: &Editor) -> Vec<Rect> {
    let pictures: Vec<Rect> = shown(editor).iter().map(|shown| shown.1).collect();
    let accents = [DARK, LIGHT].map(|palette| palette.accent);
    let shapes = editor.harness.output().shapes.iter();
    let outlines = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Rect(rect) if accents.contains(&rect.stroke.color) => Some(rect.rect),
        _ => None,
    });
    let is_over_one = |rect: &Rect| pictures.iter().any(|picture| picture.intersects(*rect));
    outlines.filter(is_over_one).collect()
}

/// Moves the pointer to where nothing is.
fn away(editor: &mut Editor) {
    editor.harness.hover_at(pos2(5.0, 5.0));
    editor.settle();
}

#[test]
fn the_place_of_a_finding_is_outlined_in_both_pictures() {
    let mut editor = comparing();
    let area = |text: &str| text.parse().ok();
    let told = CompareReport {
        differences: Some(counts(240, 200)),
        judgment: Some(Judgment {
            ssim: Some(0.5),
            flip: 0.25,
            findings: vec![Finding::Outline {
                only_a: 240,
                area_a: area("600,450,80,60"),
                only_b: 0,
                area_b: None,
                everywhere: false,
            }],
            figure: area("200,150,500,400"),
            off: None,
        }),
        measuring: false,
        problem: None,
        page_figure: None,
    };
    report(&mut editor, told.clone());
    let place = "At the bottom right of the figure, about 2 % of it.";
    assert_eq!(outlines(&editor), []);
    editor.click(place);
    let pictures: Vec<Rect> = shown(&editor).iter().map(|shown| shown.1).collect();
    let check = |editor: &Editor| {
        let outlines = outlines(editor);
        assert_eq!(outlines.len(), 2, "{outlines:?}");
        for (outline, picture) in outlines.iter().zip(&pictures) {
            let scale = picture.width() / 800.0;
            let expected = picture.min + vec2(600.0, 450.0) * scale;
            assert!(
                (outline.min + vec2(3.0, 3.0)).distance(expected) < 1.0,
                "{outline}"
            );
            assert!(
                (outline.width() - 80.0 * scale - 6.0).abs() < 1.0,
                "{outline}"
            );
        }
    };
    check(&editor);
    away(&mut editor);
    check(&editor);
    editor.click(place);
    away(&mut editor);
    assert_eq!(outlines(&editor), []);
    let link = editor.widget(place).rect().center();
    editor.harness.hover_at(link);
    editor.settle();
    check(&editor);
    report(&mut editor, CompareReport::default());
    assert_eq!(outlines(&editor), [], "what is not told any more");
}

/// Joints that are marked over the pictures, as far as they are seen.
fn marks(editor: &Editor) -> Vec<Rect> {
    const SELECTED: Color32 = Color32::from_rgb(0xff, 0x9e, 0x1c);
    let shapes = editor.harness.output().shapes.iter();
    let dots = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Circle(dot) if dot.fill == SELECTED => {
            let place = Rect::from_center_size(dot.center, Vec2::splat(2.0 * dot.radius));
            Some(place.intersect(clipped.clip_rect))
        }
        _ => None,
    });
    dots.filter(|seen| seen.is_positive()).collect()
}

/// A comparison with a selected joint, in hands that pose.
fn posing(joint: usize) -> Editor {
    let mut editor = Editor::with_hands(Key::B);
    editor.view(View::SelectJoint(Some(joint)));
    editor.harness.state_mut().comparing = Some(Comparing::new());
    editor.settle();
    editor
}

const LEFT_SHOULDER: usize = 16;

#[test]
fn bones_are_marked_where_the_live_view_is_seen_and_nowhere_else() {
    let mut editor = posing(LEFT_SHOULDER);
    let choose = |editor: &mut Editor, mode, swipe| {
        let comparing = &mut editor.harness.state_mut().comparing;
        let settings = &mut comparing.as_mut().expect("a comparison").settings;
        (settings.mode, settings.swipe) = (mode, swipe);
        editor.settle();
    };
    choose(&mut editor, CompareMode::SideBySide, 0.5);
    let live = shown(&editor)[1].1;
    let seen = marks(&editor);
    assert!(!seen.is_empty() && seen.iter().all(|mark| live.contains_rect(*mark)));
    for (mode, swipe, is_marked) in [
        (CompareMode::Swipe, 0.0, true),
        (CompareMode::Swipe, 1.0, false),
        (CompareMode::OnionSkin, 0.5, true),
        (CompareMode::Difference, 0.5, false),
    ] {
        choose(&mut editor, mode, swipe);
        assert_eq!(!marks(&editor).is_empty(), is_marked, "{mode:?} {swipe}");
    }
    choose(&mut editor, CompareMode::Blink, 0.5);
    for (time, is_marked) in [(12.1, false), (12.7, true)] {
        editor.harness.input_mut().time = Some(time);
        editor.harness.step();
        assert_eq!(
            !marks(&editor).is_empty(),
            is_marked,
            "after {time} seconds"
        );
    }
}

#[test]
fn a_bone_is_turned_in_the_live_view_and_not_in_the_picture_beside_it() {
    let mut editor = posing(LEFT_SHOULDER);
    let pictures: Vec<Rect> = shown(&editor).iter().map(|shown| shown.1).collect();
    let before = editor.joint(LEFT_SHOULDER);
    let live = editor.on_bone(LEFT_SHOULDER);
    let reference = pictures[0].min + (live - pictures[1].min);
    let by = vec2(-10.0, 30.0);
    editor.hand(reference, reference + by);
    assert_eq!(editor.joint(LEFT_SHOULDER), before);
    let live = editor.on_bone(LEFT_SHOULDER);
    editor.hand(live, live + by);
    assert_ne!(editor.joint(LEFT_SHOULDER), before);
}

#[test]
fn the_bar_of_tools_hides_no_caption_in_a_small_window() {
    for mode in CompareMode::ALL {
        let mut editor = Editor::sized(vec2(640.0, 400.0));
        editor.harness.state_mut().comparing = Some(Comparing::new());
        editor.settle();
        let comparing = &mut editor.harness.state_mut().comparing;
        comparing.as_mut().expect("a comparison").settings.mode = mode;
        editor.settle();
        let tools = ["Select Tool", "Scale Tool"].map(|tool| editor.widget(tool).rect());
        let bar = tools[0].union(tools[1]);
        let panel = editor.widget("Stop comparing").rect();
        let captions = ["A: ", "B: ", "A left of", "Differences, "];
        let mut count = 0;
        for (text, rect) in editor.painted() {
            if captions.iter().any(|start| text.starts_with(start)) {
                count += 1;
                assert!(!rect.intersects(bar), "{text} at {rect}, the bar at {bar}");
                assert!(rect.bottom() <= panel.top(), "{text} at {rect}");
            }
        }
        assert!(count > 0, "{mode:?}");
    }
}
