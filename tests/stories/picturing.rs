//! Pictures that are handed in: of the view, of the window, large, without background, from all
//! around.

use super::Story;
use editor_core::editor::View;
use editor_core::geometry::Picture;
use editor_core::io::image;
use editor_core::ui::Action;
use egui::Key;
use std::path::Path;

fn decoded(story: &Story, path: &str) -> Picture {
    let bytes = &story.host.written[Path::new(path)];
    image::decode(Path::new(path), bytes).expect("a picture")
}

#[test]
fn a_screenshot_of_the_view_has_the_size_that_was_asked_for_and_no_marks() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.save_view((320, 200), "strip.png");
    let picture = decoded(&story, "strip.png");
    assert_eq!((picture.width, picture.height), (320, 200));
    let background = &picture.rgba[..4];
    let drawn = picture.rgba.chunks_exact(4).filter(|p| *p != background);
    assert!(drawn.count() > 500, "the strip is in the picture");

    let nothing = Action::View(View::Select(None));
    story.program.carry_out(vec![nothing], &mut story.host);
    story.key(Key::F12);
    story.click("Save…");
    story.save_picture("unmarked.png");
    let unmarked = decoded(&story, "unmarked.png");
    assert_eq!(super::differing(&picture, &unmarked), 0);

    // A name that says no format is refused before anything is drawn.
    story.key(Key::F12);
    story.click("Save…");
    story.choose("strip.bmp");
    let messages = story.messages();
    assert!(
        messages
            .last()
            .unwrap()
            .1
            .starts_with("Not saved: strip.bmp: expected")
    );
}

#[test]
fn a_screenshot_with_panels_waits_until_the_dialog_is_gone() {
    let mut story = Story::start(&["models/strip.obj"]);
    let shown = story.picture();
    story.key(Key::F12);
    story.click("With panels");
    story.click("Save…");
    story.host.dialog_is_open = true;
    story.choose("window.png");
    assert!(story.host.written.is_empty());
    story.host.dialog_is_open = false;
    story.point(egui::pos2(-10.0, -10.0));
    story.settle();
    story.host.run_jobs();
    story.settle();
    let saved = decoded(&story, "window.png");
    assert_eq!((saved.width, saved.height), (shown.width, shown.height));
    // Where the pointer was, and how often frames came, may show.
    assert!(super::differing(&saved, &shown) < 4_000);
}

#[test]
fn a_picture_without_background_is_transparent_where_nothing_stands_and_a_png() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::F12);
    story.click("Transparent");
    story.click("Save…");
    let offered = story.host.requests.last().unwrap().purpose;
    assert_eq!(offered.written(), [("PNG", "png")]);
    story.save_picture("strip.png");
    let picture = decoded(&story, "strip.png");
    let alphas = || picture.rgba.chunks_exact(4).map(|pixel| pixel[3]);
    assert_eq!(picture.rgba[3], 0, "the corner");
    let opaque = alphas().filter(|&alpha| alpha == 255).count();
    let clear = alphas().filter(|&alpha| alpha == 0).count();
    assert!(opaque > 500 && clear > 10 * opaque, "{opaque} and {clear}");

    story.key(Key::F12);
    story.click("Save…");
    story.choose("strip.jpg");
    let told = story.messages().last().unwrap().1;
    assert!(told.contains("a name that ends in .png"), "{told}");
}

#[test]
fn a_large_picture_is_drawn_part_by_part_and_is_the_picture_of_when_it_was_asked_for() {
    let mut story = Story::start(&["models/strip.obj"]);
    // Lines are as many pixels wide in all sizes.
    story.key(Key::T);
    story.save_view((480, 320), "small.png");
    story.key(Key::F12);
    story.type_into("Picture width", "3360");
    story.type_into("Picture height", "2240");
    story.click("Save…");
    story.host.choose("large.png");
    for _ in 0..3 {
        story.frame(Vec::new());
    }
    assert!(story.has("Drawing large.png"), "and says how far it is");
    // The user goes on meanwhile, and what is done then is not in it.
    story.type_into("Elbow Z", "90");
    story.settle();
    story.host.run_jobs();
    story.settle();
    assert!(!story.has("Drawing large.png"));
    let large = decoded(&story, "large.png");
    assert_eq!((large.width, large.height), (3360, 2240));
    // The middle of seven by seven of its pixels is where one of the small picture is.
    let small = decoded(&story, "small.png");
    let at = |picture: &Picture, x: u32, y: u32| {
        let first = 4 * (y * picture.width + x) as usize;
        let pixel = &picture.rgba[first..first + 4];
        pixel != &picture.rgba[..4]
    };
    let pixels = || (0..320).flat_map(|y| (0..480).map(move |x| (x, y)));
    let drawn = pixels().filter(|&(x, y)| at(&small, x, y)).count();
    let others = pixels().filter(|&(x, y)| at(&small, x, y) != at(&large, 7 * x + 3, 7 * y + 3));
    let others = others.count();
    assert!(drawn > 500 && others * 20 < drawn, "{others} of {drawn}");
}

#[test]
fn a_turntable_shows_the_scene_from_all_around_and_the_window_goes_on_meanwhile() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::F12);
    story.click("Turntable");
    story.type_into("Turntable pictures", "8");
    story.click("Save…");
    let request = story.host.requests.last().unwrap();
    assert_eq!(request.name, "strip-turntable.gif");
    assert_eq!(request.purpose.written(), [("GIF", "gif")]);
    story.host.choose("strip.gif");
    for _ in 0..3 {
        story.frame(Vec::new());
    }
    assert!(story.has("Drawing strip.gif"));
    story.settle();
    let frames = frames_of(&story.host.written[Path::new("strip.gif")]);
    assert_eq!(frames.len(), 8);
    let widths: Vec<usize> = frames.iter().map(drawn_columns).collect();
    // The strip is flat: broad from the front and from behind, narrow from its sides.
    let (front, side) = (widths[0].max(widths[4]), widths[2].min(widths[6]));
    assert!(front > 4 * side.max(1), "{widths:?}");
    assert!(!story.has("Drawing strip.gif"));
}

#[test]
fn a_turntable_that_takes_too_long_is_cancelled_and_leaves_no_file() {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::F12);
    story.click("Turntable");
    story.type_into("Turntable pictures", "700");
    story.click("Save…");
    story.host.choose("strip.gif");
    for _ in 0..5 {
        story.frame(Vec::new());
    }
    let cancel = story.place("Cancel");
    story.point(cancel);
    story.button(true);
    story.button(false);
    story.settle();
    assert!(!story.has("Drawing strip.gif"));
    assert!(story.host.written.is_empty());
    let told = story.messages().last().unwrap().1;
    assert_eq!(told, "Cancelled: strip.gif is not written");
}

/// A program that was asked for a picture, and then to quit.
fn quitting_with_a_picture_under_way() -> Story {
    let mut story = Story::start(&["models/strip.obj"]);
    story.key(Key::F12);
    story.click("Save…");
    story.host.choose("strip.png");
    story.frame(Vec::new());
    story.key_with(egui::Modifiers::COMMAND, Key::Q);
    story
}

#[test]
fn a_program_that_is_ended_writes_the_picture_that_was_asked_for_first() {
    let mut story = quitting_with_a_picture_under_way();
    assert!(!story.host.quits, "the picture is not written yet");
    story.host.run_jobs();
    story.settle();
    assert!(story.host.quits);
    decoded(&story, "strip.png");
}

#[test]
fn what_is_changed_while_the_program_waits_to_quit_is_asked_about() {
    let mut story = quitting_with_a_picture_under_way();
    story.key_with(egui::Modifiers::SHIFT, Key::C);
    assert_eq!(story.names(), ["Strip", "Cube"]);
    story.host.run_jobs();
    story.settle();
    assert!(!story.host.quits);
    story.click("Don't Save");
    assert!(story.host.quits);
}

#[test]
fn another_document_calls_off_quitting_after_the_picture() {
    let mut story = quitting_with_a_picture_under_way();
    story.key_with(egui::Modifiers::COMMAND, Key::N);
    story.host.run_jobs();
    story.settle();
    assert!(!story.host.quits);
    decoded(&story, "strip.png");
}

/// Pictures of an animated GIF.
fn frames_of(gif: &[u8]) -> Vec<::image::RgbaImage> {
    use ::image::AnimationDecoder;
    let decoder = ::image::codecs::gif::GifDecoder::new(std::io::Cursor::new(gif)).unwrap();
    let frames = decoder.into_frames().collect_frames().unwrap();
    frames
        .into_iter()
        .map(|frame| frame.into_buffer())
        .collect()
}

/// Number of columns in which something else than the background's color of their row is seen.
fn drawn_columns(picture: &::image::RgbaImage) -> usize {
    let differs = |x: u32, y: u32| {
        let (here, edge) = (picture.get_pixel(x, y).0, picture.get_pixel(0, y).0);
        here.iter().zip(edge).any(|(a, b)| a.abs_diff(b) > 40)
    };
    (0..picture.width())
        .filter(|&x| (0..picture.height()).any(|y| differs(x, y)))
        .count()
}
