//! Drives the panels by the names of their widgets, as a person and a screen reader find them,
//! and looks at what became of the scene. No pixels, no window.

mod blender;
mod bones;
mod commands;
mod compare;
mod curves;
mod explaining;
mod figure;
mod fitted_joints;
mod ik;
mod joints;
mod layout;
mod menus;
mod messages;
mod navigation;
mod numbers;
mod pointing;
mod points_by_key;
mod popups;
mod poses;
mod shapes;
mod sweeps;
mod typed_axes;
mod view;
mod visibility;

use crate::host::MemoryHost;
use crate::keyboard;
use editor_core::character::Character;
use editor_core::editor::{Edit, Session, View};
use editor_core::program::{GraphicsInfo, Program};
use editor_core::scene::NewShape;
use editor_core::scene::{CharacterShape, Shape, ShapeId, ShapeKind};
use editor_core::ui::{self, Action, Ask, UiState, ViewInput};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Rect, UiBuilder, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, Node};
use std::sync::Arc;

/// The program behind the panels, of which only what it is asked is noted and not done.
struct Shell {
    program: Program,
    host: MemoryHost,
    state: UiState,
    asked: Vec<Ask>,
    keys_are_taken: bool,
    is_page: bool,
    /// Whether what the pointer does in the view counts, as in the program.
    gestures: bool,
    /// The shape under the pointer in the view, which the program finds out.
    hovered_shape: Option<ShapeId>,
    /// Version and renderer of the graphics driver.
    backend: &'static str,
    /// Where the scene is; while it is compared, its live picture.
    view: Rect,
    comparing: Option<compare::Comparing>,
}

/// The panels in a window of their own, with the program behind them.
struct Editor {
    harness: Harness<'static, Shell>,
}

const BUILT_IN: &[&str] = &["Adult", "Robot"];

impl Editor {
    /// An empty scene in the course's window.
    fn new() -> Self {
        Self::sized(vec2(800.0, 600.0))
    }

    fn sized(size: Vec2) -> Self {
        let graphics = GraphicsInfo {
            description: String::new(),
            max_texture_side: 8192,
        };
        let shell = Shell {
            program: Program::showing(Session::new(), graphics),
            host: MemoryHost::default(),
            state: UiState::new(),
            asked: Vec::new(),
            keys_are_taken: false,
            is_page: false,
            gestures: false,
            hovered_shape: None,
            backend: "OpenGL 3.3",
            view: Rect::NOTHING,
            comparing: None,
        };
        let frame = |root: &mut egui::Ui, shell: &mut Shell| {
            // The harness leaves a margin that a window has not.
            let whole = root.ctx().content_rect();
            let mut root = root.new_child(UiBuilder::new().max_rect(whole));
            root.set_clip_rect(whole);
            shell.frame(&mut root);
        };
        let builder = Harness::builder().with_size(size).with_max_steps(20);
        let mut editor = Self {
            harness: builder.build_ui_state(frame, shell),
        };
        editor.settle();
        editor
    }

    /// A scene with one character of the course's eighteen joints.
    fn with_figure() -> Self {
        let mut editor = Self::new();
        editor.add_character(figure::figure());
        editor
    }

    fn add_character(&mut self, character: Arc<Character>) {
        let kind = ShapeKind::Character(CharacterShape::new(character));
        self.edit(Edit::Insert(vec![NewShape::new("Model1", kind)]));
    }

    fn edit(&mut self, edit: Edit) {
        let session = self.harness.state_mut().program.session_mut();
        session.edit(edit).unwrap();
        self.settle();
    }

    fn view(&mut self, view: View) {
        self.harness.state_mut().program.session_mut().look(view);
        self.settle();
    }

    /// Lets a second and a half pass.
    fn wait(&mut self) {
        for _ in 0..6 {
            self.harness.step();
        }
    }

    /// Lets everything that was started finish.
    fn settle(&mut self) {
        self.harness.run_steps(4);
    }

    fn session(&self) -> &Session {
        self.harness.state().program.session()
    }

    /// The selected shape.
    fn shape(&self) -> &Shape {
        let session = self.session();
        let id = session.selected().expect("a shape is selected");
        session.scene().shape(id).expect("it exists")
    }

    /// The selected character.
    fn character(&self) -> &CharacterShape {
        let shape = self.shape();
        let scene = self.session().scene();
        scene.character(shape.id).expect("it is a character")
    }

    /// The angles of a joint of the selected character, in degrees.
    fn joint(&self, joint: usize) -> glam::Vec3 {
        self.character().pose().rotation(joint).wrapped_degrees()
    }

    fn asked(&self) -> &[Ask] {
        &self.harness.state().asked
    }

    /// Every widget, in the order of the screen.
    fn widgets(&self) -> Vec<Node<'_>> {
        self.harness.root().children_recursive().collect()
    }

    fn has(&self, label: &str) -> bool {
        self.harness.query_all_by_label(label).next().is_some()
    }

    /// The widget of that name that is no mere text.
    fn widget(&self, label: &str) -> Node<'_> {
        let all = self.widgets();
        let found = all.into_iter().find(|node| {
            let node = node.accesskit_node();
            node.role() != Role::Label && node.label().as_deref() == Some(label)
        });
        found.unwrap_or_else(|| panic!("there is no widget “{label}”"))
    }

    /// Scrolls a widget into sight.
    fn reveal(&mut self, label: &str) {
        self.widget(label).scroll_to_me();
        self.settle();
    }

    fn click(&mut self, label: &str) {
        self.reveal(label);
        self.widget(label).click();
        self.settle();
    }

    /// Opens menus one after the other and clicks the last.
    fn choose(&mut self, path: &[&str]) {
        for label in path {
            self.click(label);
        }
    }

    fn right_click(&mut self, label: &str) {
        self.reveal(label);
        self.widget(label).click_secondary();
        self.settle();
    }

    /// Clicks a field, types over what is in it, and presses Enter.
    fn type_into(&mut self, label: &str, text: &str) {
        self.begin_typing(label, text);
        self.key(Key::Enter);
    }

    fn begin_typing(&mut self, label: &str, text: &str) {
        self.click(label);
        self.harness.event(Event::Text(text.to_owned()));
        self.settle();
    }

    /// Drags a widget to the right by so many points.
    fn drag(&mut self, label: &str, by: f32) {
        self.drag_with(label, by, Modifiers::NONE);
    }

    fn drag_with(&mut self, label: &str, by: f32, modifiers: Modifiers) {
        self.reveal(label);
        let from = self.widget(label).rect().center();
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.harness.hover_at(from);
        self.harness.drag_at(from);
        for part in [0.25, 0.5, 1.0] {
            self.harness.hover_at(from + vec2(by * part, 0.0));
        }
        self.harness.drop_at(from + vec2(by, 0.0));
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.settle();
    }

    fn key(&mut self, key: Key) {
        for event in keyboard::press(key, Modifiers::NONE) {
            self.harness.event(event);
        }
        self.harness
            .event(keyboard::key(key, false, Modifiers::NONE));
        self.settle();
    }

    fn key_with(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.settle();
    }

    /// Every text on the screen, with its place.
    fn painted(&self) -> Vec<(String, Rect)> {
        let mut texts = Vec::new();
        let shapes = &self.harness.output().shapes;
        let mut open: Vec<&egui::Shape> = shapes.iter().map(|shape| &shape.shape).collect();
        while let Some(shape) = open.pop() {
            match shape {
                egui::Shape::Vec(shapes) => open.extend(shapes),
                egui::Shape::Text(text) => {
                    let place = text.visual_bounding_rect();
                    texts.push((text.galley.text().to_owned(), place));
                }
                _ => {}
            }
        }
        texts
    }

    /// Every text on the view or below it.
    fn painted_over_view(&self) -> Vec<String> {
        let edge = self.harness.state().view.right();
        let over_view = |(text, place): (String, Rect)| (place.right() <= edge).then_some(text);
        self.painted().into_iter().filter_map(over_view).collect()
    }

    /// What a field shows, or all of it where it shows less.
    fn value(&self, label: &str) -> String {
        self.widget(label).value().unwrap_or_default()
    }
}

impl Shell {
    fn frame(&mut self, root: &mut egui::Ui) {
        let compare = self.comparing.as_ref().map(compare::Comparing::view);
        let input = ViewInput {
            compare: compare.as_ref(),
            progress: None,
            title: "Editor",
            builtin_characters: BUILT_IN,
            builtin_curves: &["vase"],
            builtin_poses: &["robot-greet", "adult-wave"],
            backend: self.backend,
            hovered_shape: self.hovered_shape,
            keys_are_taken: self.keys_are_taken,
            is_below_dialog: self.keys_are_taken,
            is_page: self.is_page,
            ..ViewInput::default()
        };
        let mut output = ui::show(root, self.program.session(), &mut self.state, &input);
        self.view = output.view_rect;
        if let (Some(_), Some(&picture)) = (&compare, output.places.rects.last()) {
            self.view = picture;
        }
        if self.gestures {
            let (session, actions) = (self.program.session(), &mut output.actions);
            let (view, places) = (&output.view, &output.places);
            ui::view_gestures(view, places, session, &mut self.state, actions);
        }
        for action in output.actions {
            match action {
                Action::Ask(ask) => {
                    compare::carry_out(&mut self.comparing, &ask);
                    self.asked.push(ask);
                }
                action => {
                    self.program.carry_out(vec![action], &mut self.host);
                }
            }
        }
    }
}
