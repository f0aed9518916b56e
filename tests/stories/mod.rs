//! Stories of users, from the start to the end of the program, in a place of the test's own: real
//! panels and real pictures, without a window, a disk or a clock that goes by itself.

mod autosaving;
mod boxes;
mod choosing;
mod coloring;
mod comparing;
mod comparing_meshes;
mod context_menus;
mod documents;
mod explaining;
mod fetching;
mod files;
mod first_views;
mod hands;
mod hosts;
mod keys;
mod long_imports;
mod looking;
mod methods;
mod navigating;
mod pasting;
mod picturing;
mod posing;
mod scaling;
mod several;
mod several_joints;
mod sources;
mod starting;
mod touching;
mod transforming;
mod typing;
mod undoing;
mod viewing;

use crate::host::MemoryHost;
use crate::keyboard;
use editor_core::editor::{Session, Severity};
use editor_core::geometry::Picture;
use editor_core::gpu::{Backend, HeadlessContext};
use editor_core::program::{Graphics, Options, Program};
use editor_core::render::read_picture;
use editor_core::scene::{CharacterShape, Shape};
use egui::accesskit::{Node, TreeUpdate};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, pos2, vec2};
use std::path::PathBuf;
use std::time::Duration;

/// Size of the window where a story says nothing else, in pixels and points.
const SIZE: (u32, u32) = (1000, 640);

/// A strip that an elbow bends in its middle. Joint 2 is the elbow.
pub const STRIP: [(&str, &str); 3] = [
    (
        "models/strip.obj",
        "v -0.2 0 0\nv 0.2 0 0\nv 0.2 1 0\nv -0.2 1 0\nv 0.2 2 0\nv -0.2 2 0\n\
         f 1 2 3\nf 1 3 4\nf 4 3 5\nf 4 5 6\n",
    ),
    (
        "models/strip.skel",
        "0 0 0 -1 # Root\n0 0 0 0 # Hip\n0 1 0 1 # Elbow\n",
    ),
    (
        "models/strip.attach",
        "1 0\n1 0\n0.5 0.5\n0.5 0.5\n0 1\n0 1\n",
    ),
];

/// One running program with its user.
pub struct Story {
    pub program: Program,
    pub graphics: Graphics,
    pub host: MemoryHost,
    pub context: egui::Context,
    /// Width and height of the window, in pixels and points.
    pub size: (u32, u32),
    pointer: Pos2,
    /// Widgets of the last frame, as assistive technologies see them.
    widgets: Option<TreeUpdate>,
    pub headless: HeadlessContext,
}

impl Story {
    /// The program started with `files` at a place where it has been started before.
    pub fn start(files: &[&str]) -> Self {
        let host = MemoryHost {
            stored: [crate::stories::started_before()].into(),
            ..MemoryHost::default()
        };
        Self::start_at(host, files)
    }

    /// The program started with `files` at `host`.
    fn start_at(host: MemoryHost, files: &[&str]) -> Self {
        Self::start_with(host, Options::default(), files)
    }

    fn start_with(mut host: MemoryHost, options: Options, files: &[&str]) -> Self {
        let strip = STRIP.map(|(path, text)| (PathBuf::from(path), text.into()));
        host.files.extend(strip);
        let headless = HeadlessContext::new(Backend::Auto).expect("a context without a display");
        let graphics = Graphics::new(headless.gl()).expect("the program's graphics");
        let options = Options {
            files: files.iter().map(PathBuf::from).collect(),
            ..options
        };
        let program = Program::start(&options, graphics.info(), &mut host);
        let context = egui::Context::default();
        context.enable_accesskit();
        let mut story = Self {
            program,
            graphics,
            host,
            context,
            size: SIZE,
            pointer: pos2(-10.0, -10.0),
            widgets: None,
            headless,
        };
        story.settle();
        story
    }

    /// Draws one frame in which `events` happen. Returns how long no other is needed.
    pub fn frame(&mut self, events: Vec<Event>) -> Duration {
        let (program, graphics) = (&mut self.program, &mut self.graphics);
        let wait = self
            .host
            .frame(program, graphics, &self.context, self.size, events);
        if let Some(widgets) = self.host.widgets.take() {
            self.widgets = Some(widgets);
        }
        wait
    }

    /// Draws frames until none is needed any more.
    fn settle(&mut self) {
        for _ in 0..60 {
            if self.frame(Vec::new()) > Duration::from_millis(20) {
                return;
            }
        }
        panic!("frames are drawn without an end");
    }

    /// Lets `seconds` pass.
    fn wait(&mut self, seconds: f64) {
        self.host.time += Duration::from_secs_f64(seconds);
        self.settle();
    }

    fn session(&self) -> &Session {
        self.program.session()
    }

    /// The selected shape.
    fn shape(&self) -> &Shape {
        let id = self.session().selected().expect("a shape is selected");
        self.session().scene().shape(id).expect("it exists")
    }

    /// The selected character.
    fn character(&self) -> &CharacterShape {
        let id = self.shape().id;
        let character = self.session().scene().character(id);
        character.expect("a character is selected")
    }

    /// The angles of a joint of the selected character, in degrees.
    fn degrees(&self, joint: &str) -> glam::Vec3 {
        let character = self.character();
        let joints = character.character.skeleton().joints();
        let index = joints.iter().position(|known| known.name == joint);
        character.pose().rotation(index.expect("a joint")).degrees()
    }

    /// Names of the shapes, in the order of the list.
    fn names(&self) -> Vec<&str> {
        let shapes = self.session().scene().shapes().iter();
        shapes.map(|shape| &*shape.name).collect()
    }

    /// The messages so far, oldest first.
    fn messages(&self) -> Vec<(Severity, &str)> {
        let told = self.session().messages.history().iter();
        told.map(|message| (message.severity, &*message.text))
            .collect()
    }

    /// What the window shows.
    fn picture(&self) -> Picture {
        let window = self.graphics.window_picture().expect("a picture");
        read_picture(window).expect("its pixels")
    }

    /// What the view shows, without the panels.
    fn scene_picture(&self) -> Picture {
        let scene = self.graphics.scene_picture().expect("a picture");
        read_picture(scene).expect("its pixels")
    }

    fn node(&self, label: &str) -> Option<&Node> {
        let update = self.widgets.as_ref()?;
        let mut nodes = update.nodes.iter().map(|(_, node)| node);
        nodes.find(|node| node.label() == Some(label) && node.bounds().is_some())
    }

    fn has(&self, label: &str) -> bool {
        self.node(label).is_some()
    }

    /// Whether a text is shown.
    fn has_text(&self, text: &str) -> bool {
        let nodes = self.widgets.iter().flat_map(|update| &update.nodes);
        nodes
            .into_iter()
            .any(|(_, node)| node.value() == Some(text))
    }

    /// Where a text is shown, in points.
    fn text_place(&self, text: &str) -> Rect {
        let nodes = self.widgets.iter().flat_map(|update| &update.nodes);
        let mut bounds = nodes.filter(|(_, node)| node.value() == Some(text));
        let node = bounds.find_map(|(_, node)| node.bounds());
        let bounds = node.unwrap_or_else(|| panic!("there is no text “{text}”"));
        Rect::from_min_max(
            pos2(bounds.x0 as f32, bounds.y0 as f32),
            pos2(bounds.x1 as f32, bounds.y1 as f32),
        )
    }

    /// The middle of the widget of that name.
    fn place(&self, label: &str) -> Pos2 {
        let node = self.node(label);
        let node = node.unwrap_or_else(|| panic!("there is no widget “{label}”"));
        let bounds = node.bounds().expect("it has a place");
        let (x, y) = ((bounds.x0 + bounds.x1) / 2.0, (bounds.y0 + bounds.y1) / 2.0);
        pos2(x as f32, y as f32)
    }

    /// Where a point of the world is in the window, in points.
    fn at(&self, world: glam::Vec3) -> Pos2 {
        let view = self.view();
        let size = glam::Vec2::new(view.width(), view.height());
        let pixel = self.session().view().camera.pixel(world, size);
        let pixel = pixel.expect("it is in sight");
        view.min + vec2(pixel.x, pixel.y)
    }

    /// The rectangle of the view, in points.
    fn view(&self) -> Rect {
        let bounds = self.node("View of the scene").and_then(Node::bounds);
        let bounds = bounds.expect("the view has a place");
        Rect::from_min_max(
            pos2(bounds.x0 as f32, bounds.y0 as f32),
            pos2(bounds.x1 as f32, bounds.y1 as f32),
        )
    }

    fn point(&mut self, at: Pos2) {
        self.pointer = at;
        self.frame(vec![Event::PointerMoved(at)]);
    }

    fn button(&mut self, pressed: bool) {
        self.frame(vec![Event::PointerButton {
            pos: self.pointer,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }]);
    }

    fn click_at(&mut self, at: Pos2) {
        self.point(at);
        self.button(true);
        self.button(false);
        self.settle();
    }

    fn click(&mut self, label: &str) {
        let at = self.place(label);
        self.click_at(at);
    }

    /// Presses the left button at `from` and drags to `to`, without letting go.
    fn press_and_drag(&mut self, from: Pos2, to: Pos2) {
        self.point(from);
        self.button(true);
        for part in [0.25, 0.5, 1.0] {
            self.point(from + (to - from) * part);
        }
        self.settle();
    }

    fn drag(&mut self, from: Pos2, to: Pos2) {
        self.press_and_drag(from, to);
        self.button(false);
        self.settle();
    }

    fn key_with(&mut self, modifiers: Modifiers, key: Key) {
        self.frame(vec![Event::ModifiersChanged(modifiers)]);
        self.frame(keyboard::press(key, modifiers));
        self.frame(vec![keyboard::key(key, false, modifiers)]);
        self.frame(vec![Event::ModifiersChanged(Modifiers::NONE)]);
        self.settle();
    }

    fn key(&mut self, key: Key) {
        self.key_with(Modifiers::NONE, key);
    }

    /// Presses Esc, and waits for nothing: notices fade meanwhile.
    fn press_escape(&mut self) {
        self.frame(keyboard::press(Key::Escape, Modifiers::NONE));
        self.frame(vec![keyboard::key(Key::Escape, false, Modifiers::NONE)]);
    }

    /// Clicks a field, types over what is in it, and presses Enter.
    fn type_into(&mut self, label: &str, text: &str) {
        self.click(label);
        self.frame(vec![Event::Text(text.to_owned())]);
        self.key(Key::Enter);
    }

    /// Saves a picture of the view alone in a size of its own, by the dialog.
    fn save_view(&mut self, (width, height): (u32, u32), path: &str) {
        self.key(Key::F12);
        self.click("Custom");
        self.type_into("Picture width", &width.to_string());
        self.type_into("Picture height", &height.to_string());
        self.click("Save…");
        self.save_picture(path);
    }

    /// Answers the request for a picture's file, and waits until the picture is written.
    fn save_picture(&mut self, path: &str) {
        self.choose(path);
        self.host.run_jobs();
        self.settle();
    }

    /// Answers the newest request for a file, and lets the program use it.
    fn choose(&mut self, path: &str) {
        self.host.choose(path);
        self.settle();
    }
}

/// Preferences of somebody who has started the program before.
fn started_before() -> (editor_core::program::StorageKey, Vec<u8>) {
    let key = editor_core::program::StorageKey::Preferences;
    (key, br#"{"started_before": true}"#.to_vec())
}

/// Pixels of two pictures of one size that differ.
fn differing(a: &Picture, b: &Picture) -> usize {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let pixels = a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4));
    pixels.filter(|(a, b)| a != b).count()
}
