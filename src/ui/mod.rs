//! The panels: one a file, drawn with egui over an editing session that they only read.
//!
//! [`show`] is called once a frame with the root `Ui` that `egui::Context::run_ui` hands out.
//! Everything a user does comes back as [`Action`]s.

mod about;
mod action;
mod axis_ball;
mod color_field;
mod compare;
mod control_points;
mod curve_commands;
mod curve_display;
mod curve_gestures;
mod curve_list;
mod display;
mod expression;
mod first_help;
mod help;
mod joint_columns;
mod joint_list;
mod joint_row;
mod joint_tree;
mod keys;
mod menu_bar;
mod messages;
mod navigation;
mod notices;
mod number_field;
mod number_text;
mod pointer_use;
mod pose_commands;
mod pose_list;
mod posing;
mod properties;
mod root_row;
mod run_command;
mod scene_places;
mod screenshot;
mod shape_list;
mod shape_panel;
mod shape_signs;
mod state;
mod status_line;
mod theme;
mod view_gestures;
mod view_overlay;
mod widgets;
mod windows;

pub use action::{Action, Ask, GestureStep, Screenshot};
pub use compare::{
    CompareAction, CompareMode, CompareReport, CompareSettings, CompareView, ShownPicture,
    course_panels, picture_texture,
};
pub use expression::evaluate;
pub use keys::{COMMANDS, Command, Entry, GESTURES, Gesture, Menu, Primitive};
pub use navigation::Navigation;
pub use scene_places::ScenePlaces;
pub use state::UiState;
pub use theme::{DARK, LIGHT, Palette, in_colors_of_file_dialogs};
pub use view_gestures::view_gestures;

use crate::editor::{Session, View};
use crate::scene::{Look, ShapeId};
use egui::{Rect, Response, Ui};

/// What the panels show that neither session nor their own state knows.
#[derive(Clone, Copy, Debug, Default)]
pub struct ViewInput<'a> {
    /// The window's title.
    pub title: &'a str,
    /// Names for Insert ▸ Built-in Character; none, no such menu.
    pub builtin_characters: &'a [&'static str],
    /// Names for Insert ▸ Built-in Curve; none, no such menu.
    pub builtin_curves: &'a [&'static str],
    /// The shape under the pointer in the view.
    pub hovered_shape: Option<ShapeId>,
    /// How fast pictures are drawn, while they are.
    pub frames_per_second: Option<f32>,
    /// What draws them: version and renderer.
    pub backend: &'a str,
    /// Whether a gesture in the view is under way. It takes away the help for newcomers.
    pub gesture_under_way: bool,
    /// Whether the keyboard belongs to something of the program's own, such as a file dialog or
    /// a gesture that Esc cancels. The panels then leave all keys alone.
    pub keys_are_taken: bool,
    /// The comparison that is under way: it takes the place of the view alone.
    pub compare: Option<&'a CompareView<'a>>,
}

/// What came of one frame of panels.
#[derive(Clone, Debug)]
pub struct UiOutput {
    /// What the user wants done, in order.
    pub actions: Vec<Action>,
    /// What the panels leave free, in points: where the scene belongs.
    pub view_rect: Rect,
    /// The view as a widget below everything that lies over it: `hovered()`, `clicked()`,
    /// `dragged_by(…)` and `drag_delta()` say what the pointer does to the scene.
    pub view: Response,
    /// Where in the view the scene is shown: all of it, or the pictures of a comparison.
    pub places: ScenePlaces,
}

impl UiOutput {
    /// Width over height of the view, never zero or infinite.
    pub fn aspect(&self) -> f32 {
        aspect(self.view_rect)
    }
}

fn aspect(rect: Rect) -> f32 {
    rect.width().max(1.0) / rect.height().max(1.0)
}

/// Width and height in points that the panels need: in less, they lie over each other.
pub const LEAST_SIZE: (u32, u32) = (640, 400);

/// Shows all panels in `root`, the `Ui` of the whole window.
pub fn show(root: &mut Ui, session: &Session, state: &mut UiState, input: &ViewInput) -> UiOutput {
    let ctx = root.ctx().clone();
    if !state.styled {
        theme::apply(&ctx);
        state.styled = true;
    }
    if ctx.options(|options| options.theme_preference) != state.theme {
        ctx.set_theme(state.theme);
    }
    // The root was made before, with the style of then.
    root.set_style(ctx.global_style());
    state.notice_another_scene(session);
    let mut actions = Vec::new();
    let keys_taken = input.keys_are_taken
        || state.keys_were_taken
        || state.gesture_under_way()
        || takes_keys(&ctx);

    if !keys_taken {
        posing::roll_by_keys(&ctx, session, state, &mut actions);
    }
    let last_view = state.view_rect;
    menu_bar::show(root, session, state, input, aspect(last_view), &mut actions);
    shape_panel::show(root, session, state, &mut actions);
    posing::notice_selection(&mut state.pose, &actions);
    status_line::show(root, session, state, input);
    let mut settings = input.compare.map(|compare| compare.settings.clone());
    if let (Some(compare), Some(settings)) = (input.compare, &mut settings) {
        let look_is_course = session.view().look == Look::Course;
        compare::panel(root, look_is_course, compare, settings, &mut actions);
    }
    let (view_rect, view, places) =
        view_overlay::show(root, session, state, input, settings.as_mut(), &mut actions);
    if let (Some(compare), Some(settings)) = (input.compare, settings)
        && settings != *compare.settings
    {
        actions.push(Action::Ask(Ask::Compare(CompareAction::Set(settings))));
    }
    windows::show(root, session, state, input, &mut actions);
    add_gestures_of_fields(&ctx, &mut actions);
    state.view_rect = view_rect;

    // Last, so that a list or a field that has the keyboard comes first, even if it only got it.
    if !keys_taken && !takes_keys(&ctx) {
        let camera = state.navigation.walked(session.view().camera, &ctx);
        if camera != session.view().camera {
            actions.push(Action::View(View::SetCamera(camera)));
        }
        for command in keys::pressed(&ctx, state.navigation) {
            let comparing = input.compare.is_some();
            press(
                command,
                session,
                state,
                comparing,
                aspect(view_rect),
                &mut actions,
            );
            ctx.request_repaint();
        }
    }
    state.keys_were_taken = takes_keys(&ctx);
    UiOutput {
        actions,
        view_rect,
        view,
        places,
    }
}

/// Puts the beginnings of drags of number fields before what the panels ask for in this frame, and
/// their ends behind it.
fn add_gestures_of_fields(ctx: &egui::Context, actions: &mut Vec<Action>) {
    for step in number_field::take_gestures(ctx) {
        let place = match step {
            GestureStep::Begin => 0,
            GestureStep::Commit | GestureStep::Cancel => actions.len(),
        };
        actions.insert(place, Action::Gesture(step));
    }
}

/// Whether a text field or a popup has the keyboard.
fn takes_keys(ctx: &egui::Context) -> bool {
    ctx.text_edit_focused() || egui::Popup::is_any_open(ctx)
}

/// What a key does: Esc closes the window opened last, then ends a comparison, then lets go of the
/// selected joint, then ends the program; and nothing else works below a dialog.
fn press(
    command: Command,
    session: &Session,
    state: &mut UiState,
    comparing: bool,
    aspect: f32,
    actions: &mut Vec<Action>,
) {
    if command == Command::Quit && state.open.pop().is_some() {
        return;
    }
    if matches!(command, Command::Quit | Command::Compare) && comparing {
        actions.push(Action::Ask(Ask::Compare(CompareAction::Close)));
        return;
    }
    if command == Command::Quit && session.selected_joint().is_some() {
        actions.push(Action::View(View::SelectJoint(None)));
        return;
    }
    if state.is_open(state::Dialog::Screenshot) {
        return;
    }
    actions.extend(run_command::run(command, session, state, aspect));
}
