use super::apply::{EditError, apply};
use super::{Change, Edit, Messages, View};
use crate::math::Aabb;
use crate::revision::Revision;
use crate::scene::{Camera, Evaluated, Evaluator, NewShape, Scene, ShapeId, ViewSettings};

/// Time of playback, in seconds, that is shown: the start, until there is a timeline to move on.
const SHOWN_TIME: f64 = 0.0;

/// One running editor: the scene and all that concerns its user rather than the scene.
#[derive(Debug)]
pub struct Session {
    /// The document. Changed by [`Session::edit`] and the end of a gesture alone.
    scene: Scene,
    /// Revision of `scene`.
    document: Revision,
    gesture: Option<Gesture>,
    selected: Option<ShapeId>,
    selected_joint: Option<usize>,
    hovered_bone: Option<(ShapeId, usize)>,
    hovered_control_point: Option<(usize, usize)>,
    view: ViewSettings,
    /// Revision of the scene as it was opened.
    opened: Revision,
    /// Camera with which the scene was opened.
    start_camera: Camera,
    /// Messages to the user.
    pub messages: Messages,
    evaluator: Evaluator,
    evaluated: Evaluated,
}

/// The document as it was when a gesture began.
#[derive(Debug)]
struct Gesture {
    scene: Scene,
    document: Revision,
}

impl Default for Session {
    fn default() -> Self {
        Self {
            scene: Scene::new(),
            document: Revision::new(),
            gesture: None,
            selected: None,
            selected_joint: None,
            hovered_bone: None,
            hovered_control_point: None,
            view: ViewSettings::default(),
            opened: Revision::new(),
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

    /// A session that starts with `shapes` seen through `view`; the last shape is selected.
    pub fn with_shapes(shapes: Vec<NewShape>, view: ViewSettings) -> Self {
        let mut session = Self::default();
        session.open(shapes, view);
        session
    }

    /// Replaces the scene by one of `shapes`, seen through `view`, and selects the last shape.
    /// Messages stay.
    pub fn open(&mut self, shapes: Vec<NewShape>, view: ViewSettings) {
        // Shapes as they are replace a scene whatever they are.
        let _ = self.edit(Edit::Open(shapes));
        self.view = view;
        self.start_camera = view.camera;
    }

    /// Changes the document: the one way to do so, for panels, gestures, imports and commands.
    /// Says what changed; what was added is selected.
    ///
    /// # Errors
    /// If the edit would not leave a valid document; then nothing has changed.
    pub fn edit(&mut self, edit: Edit) -> Result<Change, EditError> {
        let place = self.selected.and_then(|id| self.index_of(id));
        let change = apply(&mut self.scene, edit)?;
        if change.is_nothing() {
            return Ok(change);
        }
        self.document = Revision::new();
        if change.opened {
            self.opened = self.document;
        }
        if change.opened || !change.added.is_empty() || !change.removed.is_empty() {
            // A gesture is about shapes that are there from its beginning to its end.
            self.gesture = None;
        }
        if let Some(&added) = change.added.last() {
            self.select(Some(added));
        } else if self.selected.is_some_and(|id| self.index_of(id).is_none()) {
            // The shape that takes the deleted one's place in the list, as in the course's editor.
            let last = self.scene.shapes().len().checked_sub(1);
            let next = place.zip(last).map(|(place, last)| place.min(last));
            self.select(next.map(|next| self.scene.shapes()[next].id));
        }
        self.evaluate();
        Ok(change)
    }

    /// Begins a gesture: the edits that follow can be cancelled together. A gesture that is under
    /// way is committed.
    pub fn begin_gesture(&mut self) {
        self.gesture = Some(Gesture {
            scene: self.scene.clone(),
            document: self.document,
        });
    }

    /// Ends the gesture and keeps what it changed, which is returned.
    pub fn commit_gesture(&mut self) -> Change {
        self.gesture.take().map_or_else(Change::default, |gesture| {
            Change::between(&gesture.scene, &self.scene)
        })
    }

    /// Ends the gesture and puts the document back to how it was when it began; nothing if none is
    /// under way.
    pub fn cancel_gesture(&mut self) {
        if let Some(gesture) = self.gesture.take() {
            self.scene = gesture.scene;
            self.document = gesture.document;
            self.evaluate();
        }
    }

    /// Whether a gesture is under way.
    pub fn is_in_gesture(&self) -> bool {
        self.gesture.is_some()
    }

    /// Changes how the document is looked at, and what in it is selected or under the pointer.
    pub fn look(&mut self, view: View) {
        match view {
            View::SetCamera(camera) => self.view.camera = camera,
            View::From(direction) => self.view.camera = Camera::preset(direction),
            View::ResetCamera => self.view.camera = Camera::default(),
            View::Fit { aspect } => {
                let bounds = self.bounds_to_fit();
                self.view.camera.fit(&bounds, aspect);
            }
            View::SetAxis(axis) => self.view.axis = axis,
            View::SetGrid(grid) => self.view.grid = grid,
            View::SetLook(look) => self.view.look = look,
            View::SetShading(shading) => self.view.shading = shading,
            View::Select(selected) => {
                if selected != self.selected {
                    self.select(selected);
                }
            }
            View::SelectJoint(joint) => self.selected_joint = joint,
            View::HoverJoint(joint) => self.hovered_bone = self.selected.zip(joint),
            View::HoverBone(bone) => self.hovered_bone = bone,
            View::HoverControlPoint(point) => self.hovered_control_point = point,
            View::DismissMessage(index) => self.messages.dismiss(index),
            View::DismissMessages => self.messages.dismiss_all(),
        }
        self.forget_what_is_gone();
    }

    /// The document.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Revision of the document: changes with every edit that changes something, and comes back
    /// when a gesture is cancelled. The camera, the selection and the pointer do not touch it.
    pub fn document(&self) -> Revision {
        self.document
    }

    /// The selected shape; always one that exists.
    pub fn selected(&self) -> Option<ShapeId> {
        self.selected
    }

    /// The selected joint of the selected shape; always one that exists.
    pub fn selected_joint(&self) -> Option<usize> {
        self.selected_joint
    }

    /// The joint of the selected shape that the pointer is over, in the view or in the panel.
    pub fn hovered_joint(&self) -> Option<usize> {
        self.hovered_bone
            .filter(|&(shape, _)| Some(shape) == self.selected)
            .map(|(_, joint)| joint)
    }

    /// The character and joint whose bone the pointer is over, in the view or in the panel;
    /// always one that exists.
    pub fn hovered_bone(&self) -> Option<(ShapeId, usize)> {
        self.hovered_bone
    }

    /// The control point of the selected shape that the pointer is over, in the view or in the
    /// panel: the indices of its curve in the [`crate::scene::CurveSet`] and of the point in the
    /// curve. Always one that exists.
    pub fn hovered_control_point(&self) -> Option<(usize, usize)> {
        self.hovered_control_point
    }

    /// How the document is looked at.
    pub fn view(&self) -> &ViewSettings {
        &self.view
    }

    /// Changes when another scene is opened. Its ids start again, so what is kept by
    /// [`ShapeId`] outside of the session holds only for as long as this stays the same.
    pub fn opened(&self) -> Revision {
        self.opened
    }

    /// Camera with which the scene was opened.
    pub fn start_camera(&self) -> &Camera {
        &self.start_camera
    }

    /// Matrices, deformed meshes and bounds that follow from the document as it is now.
    pub fn evaluated(&self) -> &Evaluated {
        &self.evaluated
    }

    fn index_of(&self, id: ShapeId) -> Option<usize> {
        self.scene.shapes().iter().position(|shape| shape.id == id)
    }

    /// Selects a shape, or none, and no part of it.
    fn select(&mut self, selected: Option<ShapeId>) {
        self.selected = selected;
        self.selected_joint = None;
        self.hovered_bone = None;
        self.hovered_control_point = None;
    }

    fn evaluate(&mut self) {
        self.evaluated = self.evaluator.evaluate(&self.scene, SHOWN_TIME);
        self.forget_what_is_gone();
    }

    /// Clears whatever of the selection and the hovered parts does not exist (any more).
    fn forget_what_is_gone(&mut self) {
        self.selected = self.selected.filter(|&id| self.scene.shape(id).is_some());
        let scene = &self.scene;
        let has = |shape: ShapeId, joint: usize| {
            scene
                .character(shape)
                .is_some_and(|shape| joint < shape.character.skeleton().joints().len())
        };
        self.selected_joint = self
            .selected_joint
            .filter(|&joint| self.selected.is_some_and(|shape| has(shape, joint)));
        self.hovered_bone = self
            .hovered_bone
            .filter(|&(shape, joint)| has(shape, joint));
        let curves = self
            .selected
            .and_then(|id| self.scene.curve(id))
            .map(|shape| shape.curves());
        self.hovered_control_point = self.hovered_control_point.filter(|&(curve, point)| {
            curves
                .and_then(|curves| curves.curve(curve))
                .is_some_and(|curve| point < curve.control_points().len())
        });
    }

    fn bounds_to_fit(&self) -> Aabb {
        self.selected
            .and_then(|id| self.evaluated.shape(id))
            .filter(|shape| shape.visible)
            .map_or_else(
                || self.evaluated.world_bounds(),
                |shape| shape.world_bounds(),
            )
    }
}
