//! Hosts of other kinds: one for which egui is run by somebody else, and one that loses its
//! graphics.

use super::{SIZE, Story, differing, started_before};
use crate::host::MemoryHost;
use editor_core::gpu::{Backend, HeadlessContext};
use editor_core::io::image;
use editor_core::program::{Graphics, Options, Pass, Program};
use editor_core::ui::{Action, Ask, Screenshot};
use egui::{Event, Key, Modifiers, RawInput, Rect, pos2, vec2};
use std::time::Duration;

#[test]
fn a_host_for_which_egui_is_run_shows_the_panels_in_its_pass_and_draws_the_scene_after_it() {
    let headless = HeadlessContext::new(Backend::Auto).unwrap();
    let mut graphics = Graphics::new(headless.gl()).unwrap();
    let mut host = MemoryHost {
        stored: [started_before()].into(),
        ..MemoryHost::default()
    };
    let options = Options {
        files: vec!["builtin:robot".into()],
        ..Options::default()
    };
    let mut program = Program::start(&options, graphics.info(), &mut host);
    // A picture without panels is asked for before the first frame.
    let shot = Screenshot {
        size: Some((64, 48)),
        ..Screenshot::default()
    };
    program.carry_out(vec![Action::Ask(Ask::Screenshot(shot))], &mut host);
    host.choose("robot.png");
    let context = egui::Context::default();
    let later = std::cell::Cell::new(0.0);
    let mut frame = |events: Vec<Event>| {
        let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(SIZE.0 as f32, SIZE.1 as f32));
        let raw = RawInput {
            screen_rect: Some(screen),
            time: Some(later.get()),
            events,
            ..RawInput::default()
        };
        let mut view = Rect::NOTHING;
        program.begin_frame(&mut host);
        let mut output = context.run_ui(raw, |root| {
            view = program.show(root, Pass::Input, &mut host).panels.view_rect;
        });
        output.textures_delta.clear();
        let size = (view.width() as u32, view.height() as u32);
        program.draw(&mut graphics, size, None, &mut host).unwrap();
        let wait = program.finish_frame(&mut graphics, &mut host);
        host.run_jobs();
        let picture = graphics.scene_picture().unwrap();
        assert_eq!((picture.width(), picture.height()), size);
        assert!(
            graphics.window_picture().is_none(),
            "the panels are somebody else's"
        );
        (
            editor_core::render::read_picture(picture).unwrap(),
            host.quits,
            wait,
        )
    };
    // The picture is drawn in the frame after its name came, and told in the one after it is a file.
    let (.., named) = frame(Vec::new());
    assert_eq!(named, Duration::ZERO);
    let (before, ..) = frame(Vec::new());
    let key = |key, modifiers| Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    };
    frame(vec![key(Key::Num3, Modifiers::NONE)]);
    let (after, quits, wait) = frame(Vec::new());
    assert_eq!(wait, Duration::MAX, "nothing is left to do");
    assert!(differing(&before, &after) > 1_000, "the camera moved");
    assert!(!quits);
    // Esc deselects, then, pressed twice, ends the program.
    let escape = || vec![key(Key::Escape, Modifiers::NONE)];
    assert!(!frame(escape()).1);
    later.set(2.0);
    assert!(!frame(escape()).1);
    later.set(3.0);
    assert!(frame(escape()).1);
    let saved = &host.written[std::path::Path::new("robot.png")];
    let saved = image::decode(std::path::Path::new("robot.png"), saved).unwrap();
    assert_eq!((saved.width, saved.height), (64, 48));
}

#[test]
fn a_page_that_loses_its_graphics_shows_the_same_in_another_context_of_egui() {
    let mut story = Story::start(&["builtin:robot"]);
    story.save_view((300, 200), "mine.png");
    let saved = story.host.written[std::path::Path::new("mine.png")].clone();
    story.host.files.insert("mine.png".into(), saved);
    story.key(Key::F8);
    story.choose("mine.png");
    // Everything is measured, and notices are gone.
    for _ in 0..4 {
        story.wait(30.0);
        story.host.run_jobs();
    }
    story.settle();
    let (before, document) = (story.picture(), story.session().document());
    let other = HeadlessContext::new(Backend::Auto).unwrap();
    story.graphics = Graphics::new(other.gl()).unwrap();
    story.context = egui::Context::default();
    story.context.enable_accesskit();
    story.program.replace_graphics(story.graphics.info());
    for _ in 0..4 {
        story.wait(30.0);
        story.host.run_jobs();
    }
    story.settle();
    assert_eq!(differing(&before, &story.picture()), 0);
    assert_eq!(story.session().document(), document);
    drop(story);
    drop(other);
}

#[test]
fn graphics_that_are_lost_are_made_again_and_the_picture_comes_back() {
    let mut story = Story::start(&["builtin:robot"]);
    let before = story.scene_picture();
    let other = HeadlessContext::new(Backend::Auto).unwrap();
    story.graphics = Graphics::new(other.gl()).unwrap();
    story.settle();
    assert_eq!(differing(&before, &story.scene_picture()), 0);
    drop(story);
    drop(other);
}
