use super::box_select::BoxSelect;
use super::command_search::CommandSearch;
use super::commands::Command;
use super::compare::{KeptPlaces, Outlined};
use super::context_menu::OpenMenu;
use super::curve_panel::CurveState;
use super::explain::ExplainState;
use super::fingers::SeveralFingers;
use super::joint_list::JointListState;
use super::messages::NoticeState;
use super::method_view::{MethodViewState, ShownScene};
use super::posing::PoseState;
use super::shape_list::Renaming;
use super::windows::Windows;
use super::{MeshColors, Navigation};
use crate::editor::{Session, Tool};
use crate::revision::Revision;
use crate::scene::{Camera, Look, ShapeId, Skinning};
use egui::{Pos2, Rect, ThemePreference, vec2};
use glam::Vec3;

/// State of the panels between frames that is neither scene nor view: searches, folded rows, open
/// windows. Of it only [`UiState::skinning`], [`UiState::colors`], [`UiState::bind_ghost`] and
/// [`UiState::shown_scene`] change how the scene is drawn.
#[derive(Clone, Debug)]
pub struct UiState {
    /// Colors of the panels. Kept by the program from one run to the next.
    pub theme: ThemePreference,
    /// How mouse and keys move the camera. Kept by the program, too.
    pub navigation: Navigation,
    /// The navigation that was chosen; that of the document if `None`.
    pub chosen_navigation: Option<Navigation>,
    /// What deforms characters; automatic if `None`. Kept by the program, too.
    pub skinning: Option<Skinning>,
    /// What characters are colored by.
    pub colors: MeshColors,
    /// Whether characters are shown in their bind pose, too.
    pub bind_ghost: bool,
    /// Look of documents that have none of their own: the one that was chosen last, or whatever suits
    /// them if `None`. Kept by the program, too.
    pub look_of_new: Option<Look>,
    /// Whether the document has a file, as the program knows.
    pub has_file: bool,
    /// Whether the shape panel is folded away. Kept by the program, too.
    pub panel_folded: bool,
    /// Whether the window is so narrow that the shape panel is folded away unless it is asked for.
    pub(super) is_narrow: bool,
    /// Whether the panel was asked for in a narrow window. Not kept: it is in the way there.
    pub(super) unfolded_in_narrow: bool,
    /// Share of a narrow window's height that the panel takes at its bottom.
    pub(super) sheet_share: f32,
    /// Whether a page reads aloud what is used, as windows leave to screen readers. Kept by the program, too.
    pub reads_aloud: bool,
    /// Width of the shape panel in points, once it is known. Kept by the program, too.
    pub panel_width: Option<f32>,
    /// How often the panel got its first width back, which begins its layout anew.
    pub(super) panel_resets: u32,
    /// Whether the machine is made for fingers, so that hints speak of them before anything has pointed.
    pub has_fingers_first: bool,
    /// Whether the first help is shown: lines for newcomers.
    pub first_help: bool,
    pub(super) windows: Windows,
    /// [`Session::opened`] in the last frame.
    opened: Option<Revision>,
    /// The shape that was selected in the last frame, to notice a new selection.
    pub(super) selected: Option<ShapeId>,
    pub(super) joints: JointListState,
    /// Whether the navigation came with the Mannequin look, which the user has chosen, and goes with it.
    navigates_by_look: bool,
    /// Name typed for a pose to keep.
    pub(super) pose_name: String,
    /// Command that waits until what is being typed has been taken over, or a drag has ended.
    pub(super) waiting: Option<Command>,
    /// Whether what is being typed is to be taken over in the next frame.
    pub(super) gives_up_typing: bool,
    /// Whether the menu Insert opens at the pointer in the next frame.
    pub(super) opens_insert_menu: bool,
    /// Where that menu is.
    pub(super) insert_menu_at: Pos2,
    /// Where the pointer was when it was last known.
    pub(super) pointer_was: Option<Pos2>,
    /// Where a finger rests, until it moves or is lifted.
    pub(super) finger_rested: Option<Pos2>,
    /// The menu for what was clicked with the right button last.
    pub(super) context_menu: Option<OpenMenu>,
    /// Search for a command, while it is open.
    pub(super) search: Option<CommandSearch>,
    /// Tool with which a row of the list of shapes has had the keyboard since it was clicked. With another tool it has
    /// it no longer.
    pub(super) shape_row_keys: Option<Tool>,
    /// Name typed for a shape.
    pub(super) renaming: Option<Renaming>,
    pub(super) curves: CurveState,
    pub(super) pose: PoseState,
    pub(super) box_select: BoxSelect,
    pub(super) explain: ExplainState,
    /// How both methods of skinning are shown.
    pub(super) methods: MethodViewState,
    pub(super) notices: NoticeState,
    /// What is outlined in the pictures of a comparison.
    pub(super) outlined: Outlined,
    /// Places in which the pictures of a comparison differ.
    pub(super) kept_places: KeptPlaces,
    /// Vertex that is marked in a comparison with the mesh of this revision.
    pub(super) marked_vertex: Option<(Revision, usize)>,
    /// What several fingers on the screen are for.
    pub(super) fingers: SeveralFingers,
    /// Camera before the drag that moves it now.
    pub(super) camera_before_drag: Option<Camera>,
    /// Point in the world where the drag that moves the camera took a surface.
    pub(super) held_point: Option<Vec3>,
    /// Whether a text field or a popup had the keyboard focus at the end of the last frame. egui
    /// takes it away from them at the start of the frame in which Esc is pressed.
    pub(super) keys_were_taken: bool,
    /// Whether a dialog of the panels that has to be left first was open in the last frame.
    pub(super) was_in_dialog: bool,
    /// Whether such a dialog, or one of the program, was.
    pub(super) was_below_dialog: bool,
    /// Time, in seconds of egui's clock, when something was open or under way last that Esc ends.
    pub(super) busy_at: f64,
    /// When G, R or S was refused last, or what is typed for it was ignored, in seconds of egui's clock.
    pub(super) refused_at: Option<f64>,
    /// Time when Esc was pressed last with nothing left to end but the program, by the same clock.
    pub(super) escaped_at: Option<f64>,
    /// Whether fonts, spacing and colors were set for fingers; `None` before they were set.
    pub(super) styled_for_fingers: Option<bool>,
    /// Whether the view is compared with a picture, and a character with a mesh.
    pub(super) compares: [bool; 2],
    /// Rectangle of the titles in the menu bar in the last frame, in points.
    pub(super) menu_titles: Rect,
    /// Rectangle of the view in the last frame, in points, for menus that are shown before it is
    /// known.
    pub(super) view_rect: Rect,
}

impl Default for UiState {
    fn default() -> Self {
        Self {
            theme: ThemePreference::System,
            navigation: Navigation::default(),
            chosen_navigation: None,
            skinning: None,
            colors: MeshColors::default(),
            bind_ghost: false,
            look_of_new: None,
            has_file: false,
            panel_folded: false,
            is_narrow: false,
            unfolded_in_narrow: false,
            sheet_share: 0.5,
            reads_aloud: false,
            panel_width: None,
            panel_resets: 0,
            has_fingers_first: false,
            first_help: false,
            windows: Windows::default(),
            opened: None,
            selected: None,
            joints: JointListState::default(),
            navigates_by_look: false,
            pose_name: String::new(),
            waiting: None,
            gives_up_typing: false,
            opens_insert_menu: false,
            insert_menu_at: Pos2::ZERO,
            pointer_was: None,
            finger_rested: None,
            context_menu: None,
            search: None,
            shape_row_keys: None,
            renaming: None,
            curves: CurveState::default(),
            pose: PoseState::default(),
            box_select: BoxSelect::default(),
            explain: ExplainState::default(),
            methods: MethodViewState::default(),
            notices: NoticeState::default(),
            outlined: Outlined::default(),
            kept_places: KeptPlaces::default(),
            marked_vertex: None,
            fingers: SeveralFingers::default(),
            camera_before_drag: None,
            held_point: None,
            keys_were_taken: false,
            was_in_dialog: false,
            was_below_dialog: false,
            busy_at: f64::NEG_INFINITY,
            refused_at: None,
            escaped_at: None,
            styled_for_fingers: None,
            compares: [false; 2],
            menu_titles: Rect::NOTHING,
            view_rect: Rect::from_min_size(Pos2::ZERO, vec2(4.0, 3.0)),
        }
    }
}

impl UiState {
    /// Sets everything up for a scene without panels: a drag turns a bone or else the scene.
    pub fn become_viewer(&mut self) {
        self.pose.tool = Tool::Pose;
        self.first_help = false;
        self.set_navigation(Navigation::Orbit);
    }

    /// A state with all windows closed and no search.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the navigation for all documents.
    pub fn set_navigation(&mut self, navigation: Navigation) {
        self.chosen_navigation = Some(navigation);
        self.navigate_by(navigation);
    }

    /// Leaves the navigation to the documents that are opened.
    pub fn reset_navigation(&mut self) {
        self.chosen_navigation = None;
        self.navigate_by(Navigation::default());
    }

    /// Whether this navigation is in use for the document's sake alone.
    pub fn has_navigation_of_document(&self, navigation: Navigation) -> bool {
        self.chosen_navigation.is_none() && self.navigation == navigation
    }

    /// Takes the navigation of a document that is shown in `look`, unless one was chosen: who opens a
    /// scene of the Virtual Mannequin has its keys in the fingers.
    pub fn suit_navigation(&mut self, look: Look) {
        self.navigates_by_look = false;
        let suiting = match look {
            Look::Mannequin => Navigation::Mannequin,
            Look::Course | Look::Studio => Navigation::default(),
        };
        if self.chosen_navigation.is_none() && suiting != self.navigation {
            self.navigate_by(suiting);
            if suiting != Navigation::Mannequin {
                self.pose.tool = Tool::default();
            }
        }
    }

    /// Has the Virtual Mannequin's navigation go with its look while the user chooses that, unless another one was
    /// chosen: who knows the one expects the other.
    pub fn follow_look(&mut self, look: Look) {
        let is_mannequin = look == Look::Mannequin;
        if is_mannequin && self.navigation != Navigation::Mannequin || self.navigates_by_look {
            self.suit_navigation(look);
            self.navigates_by_look = is_mannequin && self.chosen_navigation.is_none();
        }
    }

    /// Takes a navigation. That of the Virtual Mannequin also chooses the Pose tool, because there a left
    /// drag turns bones.
    fn navigate_by(&mut self, navigation: Navigation) {
        self.navigation = navigation;
        if navigation == Navigation::Mannequin {
            self.pose.tool = Tool::Pose;
        }
    }

    /// Whether the shape panel is folded away now.
    pub(super) fn is_panel_folded(&self) -> bool {
        if self.is_narrow {
            !self.unfolded_in_narrow
        } else {
            self.panel_folded
        }
    }

    /// Folds the shape panel away, or unfolds it. What is done in a narrow window is not for others.
    pub(super) fn fold_panel(&mut self, fold: bool) {
        if self.is_narrow {
            self.unfolded_in_narrow = !fold;
            // In what is left of the view it would cover the figures.
            self.first_help &= fold;
        } else {
            self.panel_folded = fold;
        }
    }

    /// Asks to quit, as the window's close button does, once what is being typed has been taken
    /// over.
    pub fn close(&mut self) {
        self.waiting = Some(Command::Quit);
    }

    /// Has the next frame take over what is being typed, since there may be none after it.
    pub fn give_up_typing(&mut self) {
        self.gives_up_typing = true;
    }

    /// Goes on in another context of egui, which knows nothing of fonts and colors yet.
    pub fn replace_context(&mut self) {
        self.styled_for_fingers = None;
    }

    /// The scene as the view shows it while a mistake in skinning is made on purpose, or else while
    /// methods of skinning are blended or split; `None` while it shows what is in the document.
    pub fn shown_scene(&mut self, session: &Session) -> Option<ShownScene> {
        match self.explain.evaluated(session) {
            Some(evaluated) => Some(ShownScene {
                evaluated,
                right: None,
            }),
            None => self.methods.shown(session),
        }
    }

    /// Whether the camera is being turned or moved by a drag, or by fingers.
    pub fn is_moving_camera(&self) -> bool {
        self.camera_before_drag.is_some() || self.fingers.move_view()
    }

    /// Whether something is being dragged in the view, so that Esc cancels that and does nothing
    /// else.
    pub fn gesture_under_way(&self) -> bool {
        self.curves.gesture.is_some() || self.pose.gesture.is_some() || self.box_select.is_drawing()
    }

    /// Whether saving waits until what is dragged is let go of.
    pub(super) fn saves_later(&self) -> bool {
        self.gesture_under_way() && matches!(self.waiting, Some(Command::Save | Command::SaveAs))
    }

    /// Whether a gesture in the view begins in the next frame, which keys after it belong to.
    pub fn is_beginning(&self) -> bool {
        self.pose.asked.is_some()
    }

    /// Drops everything about shapes if another scene was opened.
    pub(super) fn notice_another_scene(&mut self, session: &Session) {
        let opened = Some(session.opened());
        if self.opened == opened {
            return;
        }
        self.opened = opened;
        self.selected = None;
        self.joints = JointListState::default();
        self.pose_name.clear();
        self.renaming = None;
        self.curves = CurveState::default();
        self.pose.forget_shapes();
        self.box_select = BoxSelect::default();
        self.explain.forget_shapes();
        self.methods.end();
        self.camera_before_drag = None;
    }
}
