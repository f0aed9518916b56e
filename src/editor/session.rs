use super::apply::{EditError, apply};
use super::history::{History, State};
use super::messages::{Messages, Severity};
use super::selection::Selection;
use super::step_name::{pasting_name, step_name};
use super::{Change, Edit, View};
use crate::revision::Revision;
use crate::scene::{
    Camera, Evaluated, EvaluatedShape, Evaluator, NewShape, Scene, Shape, ShapeId, ViewSettings,
};

mod steps;

/// Displayed time of playback, in seconds: there is no timeline yet.
const SHOWN_TIME: f64 = 0.0;

/// Editing session: a document, with the view, the selection, the gesture and the messages of its
/// user.
#[derive(Debug)]
pub struct Session {
    /// Document, changed by [`Session::edit`] and the end of a gesture alone.
    scene: Scene,
    /// Revision of `scene`.
    document: Revision,
    gesture: Option<Gesture>,
    history: History,
    selection: Selection,
    hovered_bone: Option<(ShapeId, usize)>,
    hovered_control_point: Option<(usize, usize)>,
    view: ViewSettings,
    /// Document as it was opened.
    opened: State,
    /// Camera with which the document was opened.
    start_camera: Camera,
    /// Messages to the user.
    pub messages: Messages,
    evaluator: Evaluator,
    evaluated: Evaluated,
}

/// Gesture in progress: document and selection as they were when it began.
#[derive(Debug)]
struct Gesture {
    state: State,
    selection: Selection,
    /// Document that canceling goes back to, if that is another one than before the gesture: one step has led there.
    canceled: Option<State>,
}

impl Default for Session {
    fn default() -> Self {
        let state = State {
            scene: Scene::new(),
            document: Revision::new(),
        };
        Self {
            scene: state.scene.clone(),
            document: state.document,
            gesture: None,
            opened: state.clone(),
            history: History::new(state),
            selection: Selection::default(),
            hovered_bone: None,
            hovered_control_point: None,
            view: ViewSettings::default(),
            start_camera: Camera::default(),
            messages: Messages::default(),
            evaluator: Evaluator::new(),
            evaluated: Evaluated::default(),
        }
    }
}

impl Session {
    /// An empty scene under the course's first view.
    pub fn new() -> Self {
        Self::default()
    }

    /// A session with a document of `shapes`, seen through `view`; the last shape that is shown is
    /// selected.
    pub fn with_shapes(shapes: Vec<NewShape>, view: ViewSettings) -> Self {
        let mut session = Self::default();
        session.open(shapes, view);
        session
    }

    /// Replaces the document by one of `shapes`, seen through `view`, and selects the last shape.
    /// Messages stay.
    pub fn open(&mut self, shapes: Vec<NewShape>, view: ViewSettings) {
        // Opening shapes is never refused.
        let _ = self.edit(Edit::Open(shapes));
        self.view = view;
        self.start_camera = view.camera;
    }

    /// Edits the document: the one way to do so, for panels, gestures, imports and commands. Outside
    /// of a gesture it is a step that can be undone. Returns what changed; the shapes that were
    /// added are selected, the last of them as the active one.
    ///
    /// # Errors
    /// If the edit would not leave a valid document; then nothing has changed.
    pub fn edit(&mut self, edit: Edit) -> Result<Change, EditError> {
        let place = self.selected().and_then(|id| self.index_of(id));
        let before = self.present();
        let selection = self.selection.clone();
        let pasted = matches!(edit, Edit::Paste(_));
        let change = apply(&mut self.scene, edit)?;
        if change.is_nothing() {
            return Ok(change);
        }
        self.document = Revision::new();
        if let Some(&added) = change.added.last() {
            if change.opened {
                // What is not shown is not for the next key.
                let mut shapes = self.scene.shapes().iter().rev();
                let shown = shapes.find(|shape| shape.visible);
                self.select(shown.map(|shape| shape.id));
            } else {
                self.select(Some(added));
                self.selection = Selection::all(change.added.iter().copied(), Some(added));
            }
        } else if self
            .selected()
            .is_some_and(|id| self.index_of(id).is_none())
        {
            // The shape that takes the deleted one's place in the list, as in the course's editor.
            let last = self.scene.shapes().len().checked_sub(1);
            let next = place.zip(last).map(|(place, last)| place.min(last));
            self.select(next.map(|next| self.scene.shapes()[next].id));
        }
        if change.opened {
            self.opened = self.present();
            self.gesture = None;
            self.history = History::new(self.opened.clone());
        } else if self.gesture.is_none() {
            match pasted {
                true => self.record_as(pasting_name(&self.scene, &change), selection),
                false => self.record(&before, selection),
            }
        } else if !change.added.is_empty() || !change.removed.is_empty() {
            // A gesture is about shapes that exist from its beginning to its end.
            self.commit_gesture();
        }
        self.evaluate();
        Ok(change)
    }

    /// Changes the view, the selection or the messages.
    pub fn look(&mut self, view: View) {
        match view {
            View::SetCamera(camera) => self.view.camera = camera,
            View::From(direction) => self.view.camera = Camera::preset(direction),
            View::ResetCamera => self.view.camera = self.start_camera,
            View::Fit(area) => {
                let is_selected = |shape: &&EvaluatedShape| self.selection.has(shape.id);
                let visible = self.evaluated.shapes.iter().filter(|shape| shape.visible);
                let selected = visible.clone().filter(is_selected);
                let camera = &mut self.view.camera;
                if selected.clone().next().is_some() {
                    camera.fit_shapes(selected, area);
                } else {
                    camera.fit_shapes(visible, area);
                }
            }
            View::FitAll(area) => {
                let visible = self.evaluated.shapes.iter().filter(|shape| shape.visible);
                self.view.camera.fit_shapes(visible, area);
            }
            View::BeginAt(camera) => {
                self.view.camera = camera;
                self.start_camera = camera;
            }
            View::SetAxis(axis) => self.view.axis = axis,
            View::SetGrid(grid) => self.view.grid = grid,
            View::SetBones(bones) => self.view.bones = bones,
            View::SetLook(look) => self.view.look = look,
            View::ChooseLook(look) => self.view.choose_look(look),
            View::SetShading(shading) => self.view.shading = shading,
            View::Select(selected) => {
                if selected != self.selected() || !self.selection.others.is_empty() {
                    self.select(selected);
                }
            }
            View::ToggleSelected(shape) => self.selection.toggle(shape),
            View::SelectTo(shape) => self.select_to(shape),
            View::SelectAll => {
                let shown = self.scene.shapes().iter().filter(|shape| shape.visible);
                // What is locked would keep the others from being moved and deleted.
                let free = shown.filter(|shape| !shape.locked);
                let all: Vec<ShapeId> = free.map(|shape| shape.id).collect();
                let active = self.selected().filter(|active| all.contains(active));
                self.selection = Selection::all(all.into_iter(), active);
            }
            View::SelectInBox(shapes, mode) => self.selection.join(&shapes, mode),
            View::Tell(why) => self.messages.tell(Severity::Info, why),
            View::SelectJoint(joint) => self.selection.joints = Vec::from_iter(joint),
            View::SelectJoints(joints) => self.selection.joints = joints,
            View::ToggleJoint(joint) => self.selection.toggle_joint(joint),
            View::HoverJoint(joint) => self.hovered_bone = self.selected().zip(joint),
            View::HoverBone(bone) => self.hovered_bone = bone,
            View::HoverControlPoint(point) => self.hovered_control_point = point,
            View::DismissMessage(index) => self.messages.dismiss(index),
        }
        self.forget_what_is_gone();
    }

    /// Document.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Revision of the document. Changes with every edit that changes something, and returns to its
    /// old value when a gesture is canceled, a step undone, or the scene as it was opened made again. The
    /// camera, the selection and the pointer do not affect it.
    pub fn document(&self) -> Revision {
        self.document
    }

    /// Active shape: the selected one, or of several the one that was selected last, whose
    /// properties are shown. Always one that exists.
    pub fn selected(&self) -> Option<ShapeId> {
        self.selection.shape
    }

    /// All selected shapes, the one of [`Session::selected`] among them, in the order of the scene.
    pub fn selected_shapes(&self) -> impl Iterator<Item = &Shape> {
        let shapes = self.scene.shapes().iter();
        shapes.filter(|shape| self.selection.has(shape.id))
    }

    /// Whether a shape is among those that are selected.
    pub fn is_selected(&self, shape: ShapeId) -> bool {
        self.selection.has(shape)
    }

    /// Active joint of the selected shape: the selected one, or of several the one that was selected last; always one
    /// that exists.
    pub fn selected_joint(&self) -> Option<usize> {
        self.selection.joints.last().copied()
    }

    /// All selected joints of the selected shape, in the order in which they were selected, the active one last.
    pub fn selected_joints(&self) -> &[usize] {
        &self.selection.joints
    }

    /// Joint of the selected shape that the pointer is over, in the view or in the panel.
    pub fn hovered_joint(&self) -> Option<usize> {
        self.hovered_bone
            .filter(|&(shape, _)| Some(shape) == self.selected())
            .map(|(_, joint)| joint)
    }

    /// Character and joint whose bone the pointer is over, in the view or in the panel; always one
    /// that exists.
    pub fn hovered_bone(&self) -> Option<(ShapeId, usize)> {
        self.hovered_bone
    }

    /// Control point of the selected shape that the pointer is over, in the view or in the panel:
    /// the indices of its curve in the [`crate::scene::CurveSet`] and of the point in the curve.
    /// Always one that exists.
    pub fn hovered_control_point(&self) -> Option<(usize, usize)> {
        self.hovered_control_point
    }

    /// View of the document.
    pub fn view(&self) -> &ViewSettings {
        &self.view
    }

    /// Revision that changes when another document is opened. Identifiers start again then, so what
    /// is stored by [`ShapeId`] outside of the session is valid only until this changes.
    pub fn opened(&self) -> Revision {
        self.opened.document
    }

    /// Camera with which the document was opened.
    pub fn start_camera(&self) -> &Camera {
        &self.start_camera
    }

    /// Scene as it was opened.
    pub fn start_scene(&self) -> &Scene {
        &self.opened.scene
    }

    /// Evaluated document: matrices, deformed meshes and bounds.
    pub fn evaluated(&self) -> &Evaluated {
        &self.evaluated
    }

    fn index_of(&self, id: ShapeId) -> Option<usize> {
        self.scene.shapes().iter().position(|shape| shape.id == id)
    }

    /// Selects a shape, or none, and no part of it.
    fn select(&mut self, selected: Option<ShapeId>) {
        self.selection = Selection::only(selected);
        self.hovered_bone = None;
        self.hovered_control_point = None;
    }

    fn present(&self) -> State {
        State {
            scene: self.scene.clone(),
            document: self.document,
        }
    }

    fn restore(&mut self, state: &State) {
        self.scene.go_to(&state.scene);
        self.document = state.document;
        self.evaluate();
    }

    /// Makes the change from an earlier state a step that can be undone, named for its result.
    fn record(&mut self, before: &State, selection: Selection) {
        let name = step_name(&before.scene, &self.scene);
        self.record_as(name, selection);
    }

    /// Makes the change to the present scene a step that can be undone. A scene that is as it was
    /// opened has that revision again.
    fn record_as(&mut self, name: String, selection: Selection) {
        if self.scene.is_back_at(&self.opened.scene) {
            self.document = self.opened.document;
        }
        let present = self.present();
        let after = self.selection.clone();
        self.history.push(name, selection, after, present);
    }

    /// Selects the shapes of the list from the active one to `shape`, which becomes active.
    fn select_to(&mut self, shape: ShapeId) {
        let from = self.selected().and_then(|id| self.index_of(id));
        let (Some(from), Some(to)) = (from, self.index_of(shape)) else {
            return self.select(Some(shape));
        };
        let range = from.min(to)..=from.max(to);
        let between = self.scene.shapes()[range].iter().map(|shape| shape.id);
        self.selection = Selection::all(between, Some(shape));
    }

    fn evaluate(&mut self) {
        self.evaluated = self.evaluator.evaluate(&self.scene, SHOWN_TIME);
        self.forget_what_is_gone();
    }

    /// Clears the parts of the selection and of what the pointer is over that do not exist.
    fn forget_what_is_gone(&mut self) {
        let exists = |&id: &ShapeId| self.scene.shape(id).is_some();
        self.selection.others.retain(exists);
        let active = self.selection.shape.filter(exists);
        self.selection.shape = active.or_else(|| self.selection.others.pop());
        let scene = &self.scene;
        let has = |shape: ShapeId, joint: usize| {
            scene
                .character(shape)
                .is_some_and(|shape| joint < shape.character.skeleton().joints().len())
        };
        let selected = self.selection.shape;
        let is_there = |&joint: &usize| selected.is_some_and(|shape| has(shape, joint));
        self.selection.joints.retain(is_there);
        self.hovered_bone = self
            .hovered_bone
            .filter(|&(shape, joint)| has(shape, joint));
        let curves = selected
            .and_then(|id| self.scene.curve(id))
            .map(|shape| shape.curves());
        self.hovered_control_point = self.hovered_control_point.filter(|&(curve, point)| {
            curves
                .and_then(|curves| curves.curve(curve))
                .is_some_and(|curve| point < curve.control_points().len())
        });
    }
}
