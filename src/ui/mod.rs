//! Panels, menus, windows and gestures, with egui, over an editing session that they only read.
//!
//! [`show`] is called once a frame with the root `Ui` of `egui::Context::run_ui`, and then
//! [`view_gestures`] with what it returned. Everything a user does comes back as [`Action`]s.

mod action;
mod axis_ball;
mod below_view;
mod blender_keys;
mod box_select;
mod character_panel;
mod color_field;
mod command_search;
mod commands;
mod compare;
mod context_menu;
mod control_points;
mod curve_panel;
mod dropping;
mod elsewhere;
mod explain;
mod fingers;
mod first_help;
mod grab;
mod history;
mod joint_columns;
mod joint_list;
mod joint_marks;
mod joint_rows;
mod joint_tree;
mod key_commands;
mod look_switch;
mod machine;
mod menu_bar;
mod menu_keys;
mod mesh_colors;
mod messages;
mod method_view;
mod navigation;
mod number_field;
mod pointing;
mod popups;
mod posing;
mod preferences;
mod progress;
mod question;
mod scene_places;
mod screenshot;
mod shape_list;
mod shape_panel;
mod shape_properties;
mod shortened;
mod start_page;
mod state;
mod swipe_line;
mod theme;
mod turning_keys;
mod view_gestures;
mod view_overlay;
mod widgets;
mod windows;

pub use action::{Action, Answer, Ask, GestureStep, HistoryMove, Question, Screenshot, Turntable};
pub use commands::{
    COMMANDS, Command, Entry, GESTURES, Gesture, Menu, Primitive, is_kept_by_browsers, scene_label,
};
pub use compare::{
    CompareAction, CompareMeshAction, CompareMeshView, CompareMode, CompareReport, CompareSettings,
    CompareView, FigureElsewhere, FloorSeen, MeshesShown, PageFigure, ShownPicture, course_panels,
    mannequin_panels, picture_texture,
};
pub use mesh_colors::{Legend, MeshColors};
pub use method_view::ShownScene;
pub use navigation::Navigation;
pub use number_field::evaluate;
pub use scene_places::ScenePlaces;
pub use start_page::{START_SCENES, StartPicture, has_start_page};
pub use state::UiState;
pub use theme::{DARK, LIGHT, Palette, in_colors_of_file_dialogs};
pub use view_gestures::view_gestures;

use crate::editor::{Session, View};
use crate::scene::{FitArea, ShapeId};
use egui::{Rect, Response, Ui};
use key_commands::{KeyPress, press, run_waiting, takes_keys};
use std::path::PathBuf;

/// Input to the panels besides the session and their own state.
#[derive(Clone, Copy, Debug, Default)]
pub struct ViewInput<'a> {
    /// The window's title.
    pub title: &'a str,
    /// Whether a browser shows the program as a page, which cannot be quit, and takes pictures of the
    /// panels.
    pub is_page: bool,
    /// Whether there is only the scene, to be turned, posed and reset, without panels and other keys than
    /// those that roll bones.
    pub is_viewer: bool,
    /// Documents for File ▸ Open Recent, the newest first.
    pub recent: &'a [PathBuf],
    /// Question that has to be answered before anything else.
    pub question: Option<&'a Question>,
    /// Whether the first document is still being read.
    pub is_starting: bool,
    /// Names for Insert ▸ Built-in Character; if empty, there is no such menu.
    pub builtin_characters: &'a [&'static str],
    /// Names for Insert ▸ Built-in Curve; if empty, there is no such menu.
    pub builtin_curves: &'a [&'static str],
    /// Names for Pose ▸ Built-in Pose, each beginning with that of its character and a hyphen.
    pub builtin_poses: &'a [&'static str],
    /// Pictures for the start page, as far as they have been drawn.
    pub start_pictures: &'a [StartPicture],
    /// The shape under the pointer in the view.
    pub hovered_shape: Option<ShapeId>,
    /// Pictures per second, while pictures are drawn.
    pub frames_per_second: Option<f32>,
    /// Version and renderer of the graphics driver.
    pub backend: &'a str,
    /// Whether a gesture in the view is under way: it closes the first help.
    pub gesture_under_way: bool,
    /// Whether the program uses the keyboard itself, such as for a file dialog or a gesture that
    /// Esc cancels. The panels then ignore all keys.
    pub keys_are_taken: bool,
    /// Whether a dialog of the program lies over the panels, such as one for files.
    pub is_below_dialog: bool,
    /// The comparison under way: its pictures replace the view of the scene.
    pub compare: Option<&'a CompareView<'a>>,
    /// The comparison of a character with a mesh, while there is one.
    pub compare_mesh: Option<&'a CompareMeshView<'a>>,
    /// Words about the colors of meshes, if they are those of numbers.
    pub legend: Option<&'a Legend>,
    /// Work that takes a while: what is done, and how much of it, from 0 to 1.
    pub progress: Option<(&'a str, f32)>,
}

/// Output of one frame of the panels.
#[derive(Clone, Debug)]
pub struct UiOutput {
    /// Requests of the user, in order.
    pub actions: Vec<Action>,
    /// Rectangle that the panels leave to the view of the scene, in points.
    pub view_rect: Rect,
    /// The view as a widget below everything that lies over it, for [`view_gestures`].
    pub view: Response,
    /// Pictures of the scene in the view: all of it, or those of a comparison.
    pub places: ScenePlaces,
}

impl UiOutput {
    /// Width of the view over its height, always positive and finite.
    pub fn aspect(&self) -> f32 {
        aspect(self.view_rect)
    }

    /// The picture that the camera fits things into, clear of what lies over the view.
    pub fn fit_area(&self, state: &UiState) -> FitArea {
        view_overlay::fit_area(state, self.aspect())
    }
}

fn aspect(rect: Rect) -> f32 {
    rect.width().max(1.0) / rect.height().max(1.0)
}

/// Least width and height of the window, in points: in smaller ones, panels overlap.
pub const LEAST_SIZE: (u32, u32) = (420, 400);

/// Shows all panels in `root`, the `Ui` of the whole window, and handles keys.
pub fn show(root: &mut Ui, session: &Session, state: &mut UiState, input: &ViewInput) -> UiOutput {
    let ctx = root.ctx().clone();
    if state.styled_for_fingers != Some(state.has_fingers_first) {
        theme::apply(&ctx, state.has_fingers_first);
        state.styled_for_fingers = Some(state.has_fingers_first);
    }
    if ctx.options(|options| options.theme_preference) != state.theme {
        ctx.set_theme(state.theme);
    }
    if ctx.options(|options| options.screen_reader) != state.reads_aloud {
        ctx.options_mut(|options| options.screen_reader = state.reads_aloud);
    }
    // The root was made before the style was set.
    root.set_style(ctx.global_style());
    state.notice_another_scene(session);
    commands::remember_for_keys(&ctx, state.navigation, input.is_page);
    state.compares = [input.compare.is_some(), input.compare_mesh.is_some()];
    popups::close_by_press_outside(&ctx, state.menu_titles);
    pointing::notice(&ctx, state.has_fingers_first);
    let mut turns_freely = false;
    if !input.keys_are_taken {
        turns_freely = posing::take_keys(&ctx, &mut state.pose);
        box_select::cancel_by_esc(&ctx, &mut state.box_select);
    }
    let holding = is_holding(&ctx);
    let dragging = session.is_in_gesture() && ctx.input(|input| input.pointer.any_down());
    let reorders = shape_list::cancel_drag_by_undo(&ctx, input.keys_are_taken);
    let in_drag = dragging || reorders || state.gesture_under_way();
    let in_dialog = popups::leave_to_dialog(&ctx, state, input);
    let mut actions = run_waiting(&ctx, session, state, input, in_drag);
    if turns_freely {
        actions.push(Action::View(View::Tell(NO_TRACKBALL.into())));
    }
    let keys_taken = input.keys_are_taken
        || in_drag
        || state.is_beginning()
        || in_dialog
        || state.keys_were_taken
        || takes_keys(&ctx);

    let now = ctx.input(|input| input.time);
    if keys_taken
        || input.compare.is_some()
        || input.compare_mesh.is_some()
        || state.windows.is_any_open()
        || state.explain.is_open()
        || state.camera_before_drag.is_some()
        || session.is_in_gesture()
    {
        state.busy_at = now;
    }
    // A bone that is rolled is selected without rings.
    let mut rolls = Vec::new();
    if !keys_taken {
        posing::roll_by_keys(&ctx, session, state, &mut rolls);
        actions.extend(key_commands::tab_over_the_view(&ctx, session, state));
    }
    let last_view = state.view_rect;
    if !input.is_viewer {
        menu_bar::show(root, session, state, input, aspect(last_view), &mut actions);
        shape_panel::show(root, session, state, &mut actions);
    }
    posing::notice_selection(&mut state.pose, &actions);
    actions.append(&mut rolls);
    if !input.is_viewer {
        view_overlay::status_line(root, session, state, input);
    }
    let mut settings = input.compare.map(|compare| compare.settings.clone());
    if let (Some(compare), Some(settings)) = (input.compare, &mut settings) {
        let (outlined, kept) = (&mut state.outlined, &mut state.kept_places);
        compare::panel(
            root,
            session,
            compare,
            settings,
            outlined,
            kept,
            &mut actions,
        );
    }
    if input.compare.is_some() && state.explain.is_open() {
        state.explain.set_open(false);
        let why = "Skinning is not explained while the view is compared with a picture";
        actions.push(Action::View(View::Tell(why.into())));
    }
    state.explain.set_compares(input.compare_mesh.is_some());
    if input.compare.is_some() || input.compare_mesh.is_some() {
        state.methods.end();
    }
    explain::show(
        root,
        session,
        input.compare_mesh,
        &mut state.explain,
        &mut actions,
    );
    match input.compare_mesh {
        Some(compare) => {
            let area = view_overlay::fit_area(state, aspect(last_view));
            // One of another mesh says nothing of this one.
            let marked = state.marked_vertex.filter(|(of, _)| *of == compare.mesh);
            let before = compare::MeshPanelState {
                marked: marked.map(|(_, vertex)| vertex),
                explains: state.explain.is_open(),
            };
            let after = compare::mesh_panel(root, session, compare, area, before, &mut actions);
            state.marked_vertex = after.marked.map(|vertex| (compare.mesh, vertex));
            if after.explains && !before.explains {
                state.explain.show_formula();
            }
            // What is wrong there is seen in its formula.
            if let Some(vertex) = after.marked.filter(|_| after != before) {
                state.explain.pick(compare.shape, vertex);
            }
        }
        None => state.marked_vertex = None,
    }
    let (view_rect, view, places) =
        view_overlay::show(root, session, state, input, settings.as_mut(), &mut actions);
    if let (Some(compare), Some(settings)) = (input.compare, settings)
        && settings != *compare.settings
    {
        actions.push(Action::Ask(Ask::Compare(CompareAction::Set(settings))));
    }
    windows::show(root, session, state, input, aspect(last_view), &mut actions);
    command_search::show(root, session, state, input, aspect(last_view), &mut actions);
    if let Some(question) = input.question {
        question::show(root, question, &mut actions);
    }
    dropping::show(&ctx, input.question.is_some());
    add_gestures_of_panels(&ctx, holding, session, state, &mut actions);
    let wrong = number_field::take_wrong(&ctx);
    actions.extend(wrong.map(|why| Action::View(View::Tell(why.into()))));
    state.view_rect = view_rect;

    // Last, so that a list or a field with the keyboard focus comes first, even if it only just got
    // the focus.
    if !keys_taken && !input.is_viewer && !takes_keys(&ctx) {
        // What is typed for a drag that was refused turns no camera.
        let is_ignored = key_commands::ignores_typed(&ctx, state, now);
        let ends_typed = key_commands::ends_typed(&ctx);
        if !is_ignored {
            let camera = state.navigation.walked(session.view().camera, &ctx);
            if camera != session.view().camera {
                actions.push(Action::View(View::SetCamera(camera)));
            }
        }
        for (command, key) in commands::pressed(&ctx, state.navigation) {
            let key = KeyPress {
                key,
                is_plain: ctx.input(|input| !input.modifiers.command && !input.modifiers.alt),
                at: now,
            };
            press(
                command,
                session,
                state,
                input,
                aspect(view_rect),
                key,
                &mut actions,
            );
            ctx.request_repaint();
        }
        if ends_typed {
            state.refused_at = None;
        }
        // Once is enough while it can be read.
        let is_told = |why: &str| session.messages.fresh().iter().any(|told| told.text == why);
        if let Some(why) = state.navigation.why_nothing(&ctx, session.view().look)
            && !is_told(why)
            && !is_ignored
        {
            actions.push(Action::View(View::Tell(why.into())));
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

/// Whether a button or an arrow key is held, so that edits go on in the next frames.
fn is_holding(ctx: &egui::Context) -> bool {
    use egui::Key::{ArrowDown, ArrowLeft, ArrowRight, ArrowUp};
    ctx.input(|input| {
        let arrows = [ArrowDown, ArrowLeft, ArrowRight, ArrowUp];
        input.pointer.any_down() || arrows.iter().any(|key| input.keys_down.contains(key))
    })
}

const NO_TRACKBALL: &str = "There is no trackball rotation: X, Y and Z turn about an axis, pressed again about a local one";

/// Makes edits of the panels that belong together a gesture: number fields say when their drags
/// begin and end; all else that edits while a button or an arrow key is held, such as a choice of
/// color, is one gesture until it is released.
fn add_gestures_of_panels(
    ctx: &egui::Context,
    holding: bool,
    session: &Session,
    state: &UiState,
    actions: &mut Vec<Action>,
) {
    let steps = number_field::take_gestures(ctx);
    if steps.is_empty() && !state.gesture_under_way() {
        let edits = actions
            .iter()
            .any(|action| matches!(action, Action::Edit(_)));
        let has_begun = |action: &Action| {
            use GestureStep::{Begin, BeginOnLastStep};
            matches!(action, Action::Gesture(Begin | BeginOnLastStep))
        };
        if holding && edits && !session.is_in_gesture() && !actions.iter().any(has_begun) {
            actions.insert(0, Action::Gesture(GestureStep::Begin));
        }
        // Also for a field that is not shown any more, which cannot end its drag.
        if !holding && session.is_in_gesture() {
            actions.push(Action::Gesture(GestureStep::Commit));
        }
    }
    for step in steps {
        let place = match step {
            GestureStep::Begin | GestureStep::BeginOnLastStep => 0,
            GestureStep::Commit | GestureStep::Cancel => actions.len(),
        };
        actions.insert(place, Action::Gesture(step));
    }
}
