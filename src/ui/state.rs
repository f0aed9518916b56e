use super::Navigation;
use super::curve_gestures::PointGesture;
use super::posing::PoseState;
use super::screenshot::ScreenshotForm;
use crate::editor::{Session, Tool};
use crate::revision::Revision;
use crate::scene::{Camera, ShapeId, Skinning};
use egui::ThemePreference;
use std::collections::{BTreeSet, HashMap};

/// What panels remember between frames that is neither scene nor view: searches, folded rows,
/// open windows. Nothing in it changes a picture of the scene.
#[derive(Clone, Debug)]
pub struct UiState {
    /// Colors of the panels. Public because the program keeps it from one run to the next.
    pub theme: ThemePreference,
    /// How mouse and keys move the camera. Kept by the program, too.
    pub navigation: Navigation,
    /// What deforms characters; whatever suits the driver if `None`. Kept by the program, too.
    pub skinning: Option<Skinning>,
    /// Whether the three lines for newcomers are shown.
    pub first_help: bool,
    /// Open windows; the one opened last is last, and Esc closes it first.
    pub(super) open: Vec<Dialog>,
    /// See [`Session::opened`], in the last frame.
    opened: Option<Revision>,
    /// The shape that was selected in the last frame, to notice one selected elsewhere.
    pub(super) selected: Option<ShapeId>,
    pub(super) screenshot: ScreenshotForm,
    pub(super) joints: JointListState,
    pub(super) curves: CurveState,
    pub(super) pose: PoseState,
    pub(super) notices: NoticeState,
    /// Where the camera was before the drag that moves it now.
    pub(super) camera_before_drag: Option<Camera>,
    /// Whether a text field or a popup had the keyboard at the end of the last frame. egui takes
    /// the keyboard away from them at the start of the frame in which Esc is pressed.
    pub(super) keys_were_taken: bool,
    pub(super) styled: bool,
    /// The view in the last frame, for menus that are shown before it is known.
    pub(super) view_rect: egui::Rect,
}

/// A window over the view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dialog {
    Keys,
    Messages,
    About,
    Screenshot,
}

/// What the joint list remembers.
#[derive(Clone, Debug, Default)]
pub(super) struct JointListState {
    pub searching: bool,
    /// Whether the search has just begun, so that its field gets the keyboard.
    pub search_opened: bool,
    pub search: String,
    pub folded: HashMap<ShapeId, BTreeSet<usize>>,
    /// The joint that the pointer was over in the list; one hovered in the view is not the
    /// list's to clear.
    pub hovered: Option<usize>,
    /// The joint whose row gets the keyboard once it has been scrolled into sight.
    pub focus: Option<usize>,
    /// The joint that was selected in the last frame, to notice one selected in the view.
    pub selected: Option<(ShapeId, usize)>,
    /// What is typed as the name of a pose to keep.
    pub pose_name: String,
}

/// What the list of curves and the gestures with control points remember.
#[derive(Clone, Debug, Default)]
pub(super) struct CurveState {
    /// Which curves and surfaces are unfolded, where that was ever chosen.
    pub unfolded: HashMap<(ShapeId, usize), bool>,
    /// The control point whose row the pointer was over in the last frame.
    pub hovered: Option<(usize, usize)>,
    /// The control point in the user's hand.
    pub gesture: Option<PointGesture>,
}

/// What the notices over the view remember.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NoticeState {
    /// Length of the history when it last grew, and when that was, in seconds of egui's clock.
    pub seen: Option<(usize, f64)>,
}

impl Default for UiState {
    fn default() -> Self {
        Self {
            theme: ThemePreference::System,
            navigation: Navigation::default(),
            skinning: None,
            first_help: false,
            open: Vec::new(),
            opened: None,
            selected: None,
            screenshot: ScreenshotForm::default(),
            joints: JointListState::default(),
            curves: CurveState::default(),
            pose: PoseState::default(),
            notices: NoticeState::default(),
            camera_before_drag: None,
            keys_were_taken: false,
            styled: false,
            view_rect: egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(4.0, 3.0)),
        }
    }
}

impl UiState {
    /// Everything closed, nothing searched.
    pub fn new() -> Self {
        Self::default()
    }

    /// Moves the camera in this way from now on. In the Virtual Mannequin's a left drag turns
    /// bones, too.
    pub fn set_navigation(&mut self, navigation: Navigation) {
        self.navigation = navigation;
        if navigation == Navigation::Mannequin {
            self.pose.tool = Tool::Pose;
        }
    }

    /// Whether a gesture in the view is under way, so that Esc cancels it and does nothing else.
    pub fn gesture_under_way(&self) -> bool {
        self.curves.gesture.is_some() || self.pose.gesture.is_some()
    }

    /// Forgets what concerned the shapes of a scene that another was opened in the place of.
    pub(super) fn notice_another_scene(&mut self, session: &Session) {
        let opened = Some(session.opened());
        if self.opened == opened {
            return;
        }
        self.opened = opened;
        self.selected = None;
        self.joints = JointListState::default();
        self.curves = CurveState::default();
        self.pose.forget_shapes();
        self.camera_before_drag = None;
    }

    /// Brings a window up, or to the end of the row for Esc if it is up already.
    pub(super) fn open(&mut self, dialog: Dialog) {
        self.close(dialog);
        self.open.push(dialog);
    }

    pub(super) fn close(&mut self, dialog: Dialog) {
        self.open.retain(|&open| open != dialog);
    }

    pub(super) fn is_open(&self, dialog: Dialog) -> bool {
        self.open.contains(&dialog)
    }
}
