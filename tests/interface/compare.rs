//! The Compare panel, and the pictures that take the place of the view.

use crate::interface::{Editor, curves};
use editor_core::compare::{Area, CompareError, Differences, Finding, Judgment};
use editor_core::editor::View;
use editor_core::geometry::Picture;
use editor_core::scene::{Look, Shading};
use editor_core::ui::{
    Ask, CompareAction, CompareMode, CompareReport, CompareSettings, CompareView, ShownPicture,
    course_panels,
};
use egui::{Key, TextureId, vec2};

/// A comparison with a gray picture of the course's size.
pub struct Comparing {
    settings: CompareSettings,
    picture: Picture,
    report: CompareReport,
}

impl Comparing {
    fn new() -> Self {
        let (width, height) = (800, 600);
        Self {
            settings: CompareSettings::default(),
            picture: Picture {
                width,
                height,
                rgba: vec![26; 4 * (width * height) as usize],
            },
            report: CompareReport::default(),
        }
    }

    pub fn view(&self) -> CompareView<'_> {
        let shown = ShownPicture {
            picture: &self.picture,
            texture: TextureId::default(),
        };
        CompareView {
            name: "sample.png",
            settings: &self.settings,
            reference: shown,
            live: Some(shown),
            difference: None,
            report: &self.report,
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
fn numbers_and_causes_are_told_in_words() {
    let mut editor = comparing();
    assert!(editor.has("Measuring…"));
    let told = CompareReport {
        differences: Some(counts(240, 200)),
        judgment: Some(Judgment {
            ssim: Some(0.5),
            flip: 0.25,
            findings: vec![Finding::Shifted { dx: 1, dy: 0 }],
        }),
        measuring: false,
        problem: None,
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
