use super::Messages;
use crate::revision::Revision;
use crate::scene::{Camera, Evaluated, Evaluator, Scene, ShapeId, ViewSettings};

/// One running editor: the scene and all that concerns its user rather than the scene.
#[derive(Debug)]
pub struct Session {
    /// What is edited. Changed by [`super::apply_edit`] alone.
    pub(super) scene: Scene,
    pub(super) selected: Option<ShapeId>,
    pub(super) selected_joint: Option<usize>,
    pub(super) hovered_bone: Option<(ShapeId, usize)>,
    pub(super) hovered_control_point: Option<(usize, usize)>,
    pub(super) view: ViewSettings,
    /// Of the scene as it was opened.
    opened: Revision,
    /// How the scene was looked at when it was opened.
    start_camera: Camera,
    /// What was told to the user.
    pub messages: Messages,
    evaluator: Evaluator,
    evaluated: Evaluated,
    revision: Revision,
}

impl Default for Session {
    fn default() -> Self {
        Self {
            scene: Scene::new(),
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
            revision: Revision::new(),
        }
    }
}

impl Session {
    /// An empty scene under the course's first view.
    pub fn new() -> Self {
        Self::default()
    }

    /// A session that starts with `scene` seen through `view`; its last shape is selected.
    pub fn with_scene(scene: Scene, view: ViewSettings) -> Self {
        let mut session = Self::default();
        session.open(scene, view);
        session
    }

    /// Puts `scene`, seen through `view`, in the place of what was there; its last shape is
    /// selected. What was told to the user stays.
    pub fn open(&mut self, scene: Scene, view: ViewSettings) {
        self.selected = scene.shapes().last().map(|shape| shape.id);
        self.scene = scene;
        self.view = view;
        self.opened = Revision::new();
        self.start_camera = view.camera;
        self.forget_parts();
        self.refresh();
    }

    /// What is edited.
    pub fn scene(&self) -> &Scene {
        &self.scene
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

    /// How the scene is looked at.
    pub fn view(&self) -> &ViewSettings {
        &self.view
    }

    /// Changes when another scene is opened. Its ids start again, so what is kept by
    /// [`ShapeId`] outside of the session holds only for as long as this stays the same.
    pub fn opened(&self) -> Revision {
        self.opened
    }

    /// Where the camera stood when the scene was opened.
    pub fn start_camera(&self) -> &Camera {
        &self.start_camera
    }

    /// All that follows from the scene as it is now.
    pub fn evaluated(&self) -> &Evaluated {
        &self.evaluated
    }

    /// Changes whenever anything that a picture depends on may have changed.
    pub fn revision(&self) -> Revision {
        self.revision
    }

    /// Forgets which part of the selected shape was selected or under the pointer.
    pub(super) fn forget_parts(&mut self) {
        self.selected_joint = None;
        self.hovered_bone = None;
        self.hovered_control_point = None;
    }

    /// Works out anew what changed. Both apply functions end with this.
    pub(super) fn refresh(&mut self) {
        self.revision = Revision::new();
        self.evaluated = self.evaluator.evaluate(&self.scene);
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
}
