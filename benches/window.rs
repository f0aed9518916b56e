//! The program's window in memory, with a user who drags.

use crate::host::MemoryHost;
use cpu_time::ProcessTime;
use editor_core::gpu::{Backend, HeadlessContext};
use editor_core::program::{Graphics, Options, Program, StorageKey};
use editor_core::scene::bones_in_world;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, pos2, vec2};
use std::path::PathBuf;

/// Width and height in pixels.
const SIZE: (u32, u32) = (1280, 800);

/// Frames of a round.
const FRAMES: usize = 6;

pub struct Window {
    program: Program,
    graphics: Graphics,
    host: MemoryHost,
    context: egui::Context,
    /// Number of frames dragged so far.
    dragged: usize,
    /// Keeps the context alive.
    headless: HeadlessContext,
}

impl Window {
    /// The program with `file`, a scene of the text `scene` unless it is built in, as it is after its
    /// first frames.
    pub fn start(file: &str, scene: &str) -> Self {
        let headless = HeadlessContext::new(Backend::Auto).expect("a context without a display");
        let graphics = Graphics::new(headless.gl()).expect("the program's graphics");
        let preferences = br#"{"started_before": true}"#.to_vec();
        let mut host = MemoryHost {
            stored: [(StorageKey::Preferences, preferences)].into(),
            ..MemoryHost::default()
        };
        let path = PathBuf::from(file);
        host.files.insert(path.clone(), scene.as_bytes().to_vec());
        let options = Options {
            files: vec![path],
            ..Options::default()
        };
        let program = Program::start(&options, graphics.info(), &mut host);
        let context = egui::Context::default();
        context.enable_accesskit();
        let mut window = Self {
            program,
            graphics,
            host,
            context,
            dragged: 0,
            headless,
        };
        for _ in 0..10 {
            window.frame(Vec::new());
        }
        window
    }

    fn frame(&mut self, events: Vec<Event>) {
        let (program, graphics) = (&mut self.program, &mut self.graphics);
        self.host
            .frame(program, graphics, &self.context, SIZE, events);
        // What the driver puts off would be counted to the next round.
        self.headless.gl().finish();
    }

    pub fn key(&mut self, key: Key) {
        for pressed in [true, false] {
            self.frame(vec![Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::NONE,
            }]);
        }
    }

    fn button(&mut self, pos: Pos2, pressed: bool) {
        self.frame(vec![Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }]);
    }

    fn view(&self) -> Rect {
        let tree = self.host.widgets.as_ref().expect("widgets");
        let is_view = |node: &egui::accesskit::Node| node.label() == Some("View of the scene");
        let view = tree.nodes.iter().find(|(_, node)| is_view(node));
        let bounds = view.and_then(|(_, node)| node.bounds()).expect("the view");
        let corner = |x: f64, y: f64| pos2(x as f32, y as f32);
        Rect::from_min_max(corner(bounds.x0, bounds.y0), corner(bounds.x1, bounds.y1))
    }

    /// Where the bone of a joint of the selected character ends.
    pub fn end_of_bone(&self, name: &str) -> Pos2 {
        let session = self.program.session();
        let id = session.selected().expect("a selected shape");
        let character = session.scene().character(id).expect("a character");
        let mut joints = character.character.skeleton().joints().iter();
        let joint = joints
            .position(|joint| joint.name == name)
            .expect("a joint");
        let shape = session.evaluated().shape(id).expect("it is in the scene");
        let mut bones = bones_in_world(session.scene(), shape);
        let (.., end) = bones.find(|bone| bone.0 == joint).expect("a bone");
        let view = self.view();
        let size = glam::Vec2::new(view.width(), view.height());
        let at = session
            .view()
            .camera
            .pixel(end, size)
            .expect("it is in sight");
        view.min + vec2(at.x, at.y)
    }

    /// A place in the view where nothing is.
    pub fn empty_place(&self) -> Pos2 {
        self.view().left_bottom() + vec2(30.0, -30.0)
    }

    /// Presses the button at `from`, and begins to drag.
    pub fn press(&mut self, from: Pos2) {
        self.frame(vec![Event::PointerMoved(from)]);
        self.button(from, true);
        self.frame(vec![Event::PointerMoved(from + vec2(20.0, 0.0))]);
    }

    pub fn release(&mut self, at: Pos2) {
        self.button(at, false);
    }

    /// CPU time of a frame of the drag about `from` that is under way, in milliseconds.
    pub fn drag(&mut self, from: Pos2) -> f64 {
        let start = ProcessTime::now();
        for _ in 0..FRAMES {
            self.dragged += 1;
            let angle = self.dragged as f32 * 0.3;
            let to = from + vec2(40.0 * angle.sin(), 30.0 * angle.cos());
            self.frame(vec![Event::PointerMoved(to)]);
        }
        start.elapsed().as_secs_f64() * 1e3 / FRAMES as f64
    }

    /// Number of steps that were done, and whether something is selected.
    pub fn state(&self) -> (usize, bool) {
        let session = self.program.session();
        (session.done_steps(), session.selected().is_some())
    }
}
