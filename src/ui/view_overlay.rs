//! What lies over the view, and the status line below it.

use super::posing::BAR_HEIGHT;
use super::progress;
use super::state::UiState;
use super::theme::Palette;
use super::windows::Dialog;
use super::{
    Action, CompareSettings, HistoryMove, ScenePlaces, ViewInput, axis_ball, box_select, compare,
    control_points, explain, fingers, first_help, look_switch, mesh_colors, messages, method_view,
    posing, start_page,
};
use crate::editor::{Session, Tool, View};
use crate::scene::FitArea;
use crate::ui::machine;
use crate::ui::pointing::Pointing;
use crate::ui::shortened::text_width;
use egui::{
    Align, Button, Context, Frame, Label, Layout, Margin, Panel, Rect, Response, RichText, Sense,
    TextStyle, Ui, UiBuilder, Vec2, WidgetInfo, WidgetType, vec2,
};
use std::borrow::Cow;

/// Width at the right edge left to the handle of the shape panel, in points.
const PANEL_EDGE: f32 = 4.0;
/// Least distance in the status line between what can be done and what draws, in points.
const GAP: f32 = 16.0;

/// Makes the view of what the panels leave free, and shows what lies over it. Returns the view's
/// rectangle in points, its widget, and the pictures of the scene in it. `settings` are those of
/// the comparison under way, as its panel left them.
///
/// The view is a widget below all others here: egui decides which of them the pointer is for.
pub(super) fn show(
    root: &mut Ui,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
    settings: Option<&mut CompareSettings>,
    actions: &mut Vec<Action>,
) -> (Rect, Response, ScenePlaces) {
    let rect = root.available_rect_before_wrap();
    let id = root.id().with("view");
    let mut free = rect;
    free.max.x = (free.max.x - PANEL_EDGE).max(free.min.x);
    let response = root.interact(free, id, Sense::click_and_drag() | Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Other, true, "View of the scene"));
    let response = fingers::drag_after_rest(response, &mut state.finger_rested);
    let mut over = root.new_child(UiBuilder::new().id_salt("over the view").max_rect(rect));
    over.set_clip_rect(rect.intersect(root.clip_rect()));

    let places = match (input.compare, settings) {
        (Some(compare), Some(settings)) => {
            let outlined = state.outlined.area();
            let view = (&response, below_tools(state));
            compare::pictures(&mut over, view, compare, settings, outlined)
        }
        _ => ScenePlaces::whole(rect),
    };
    if input.is_viewer {
        posing::show_hovered(&over, &places, session);
        if viewer_reset(&mut over, rect) {
            actions.push(Action::History(HistoryMove::GoTo(0)));
            actions.push(Action::View(View::Select(None)));
            actions.push(Action::View(View::ResetCamera));
        }
        messages::notices(
            &mut over,
            rect,
            (session, true),
            &mut state.notices,
            actions,
        );
        return (rect, response, places);
    }
    posing::show(
        &mut over,
        &places,
        &response,
        session,
        &mut state.pose,
        actions,
    );
    if let Some((compare, vertex)) = input
        .compare_mesh
        .zip(state.marked_vertex.map(|(_, vertex)| vertex))
    {
        let is_explained = state.explain.tells_of(vertex);
        compare::mesh_marker(&over, &places, session, compare, (vertex, is_explained));
    }
    control_points::show_clicked(&over, &places, session, &state.curves);
    box_select::show(&over, &places, &state.box_select);
    what_is_seen(&mut over, rect, &places, session, state, input);
    // Over the pictures of a comparison they would hide what is compared; its panel has the looks.
    if input.compare.is_none() {
        axis_ball::show(&mut over, rect, &session.view().camera, actions);
    }
    let is_busy = input.compare.is_some() || input.question.is_some() || input.is_starting;
    let is_start = start_page::has_start_page(session, is_busy);
    if is_start {
        // It takes the place of the switch, which has nothing to show here.
        start_page::show(&mut over, (rect, below_tools(state)), input, actions);
    } else if input.compare.is_none() {
        look_switch::show(&mut over, rect, session.view().look, actions);
    }
    messages::notices(
        &mut over,
        rect,
        (session, false),
        &mut state.notices,
        actions,
    );
    if let Some(work) = input.progress {
        progress::show(&mut over, rect, work, actions);
    }
    // It must not hide messages, nor what a panel below the view is about, nor what to begin with.
    let covers = is_start
        || input.compare.is_some()
        || input.compare_mesh.is_some()
        || state.explain.is_open();
    if state.first_help && session.messages.fresh().is_empty() && !covers {
        let gesture = response.dragged() || response.clicked() || input.gesture_under_way;
        let closed = first_help::show(&mut over, rect, session, state);
        state.first_help = !(closed || gesture);
    }
    (rect, response, places)
}

/// Says over the view what it shows otherwise than the scene is: what is explained, methods of skinning, and
/// the colors of meshes, one below the other.
fn what_is_seen(
    over: &mut Ui,
    rect: Rect,
    places: &ScenePlaces,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
) {
    let below_tools = below_tools(state);
    let explain = &mut state.explain;
    let top = explain::over_view(over, (rect, below_tools), places, session, explain);
    // The mistake is what is seen then.
    if !state.explain.makes_mistake() {
        method_view::over_view(over, (rect, below_tools), &mut state.methods);
    }
    let is_empty = session.scene().shapes().is_empty();
    if let Some(legend) = input
        .legend
        .filter(|_| input.compare.is_none() && !is_empty)
    {
        mesh_colors::legend(over, rect, top, legend);
    }
}

/// The one button of a scene without panels; whether it was clicked.
fn viewer_reset(ui: &mut Ui, view: Rect) -> bool {
    let size = vec2(64.0, 24.0);
    let place = Rect::from_min_size(view.min + Vec2::splat(8.0), size);
    let button = ui.put(place, Button::new("Reset"));
    button
        .on_hover_text("Show the scene as it was at first")
        .clicked()
}

/// Picture that things are fitted into, `aspect` times as wide as high: what the tool bar leaves free
/// of it, and as much at the bottom, so that what is fitted is in the middle, but for the corner with the switch of the
/// looks. Of a picture that is higher than wide, it is what that leaves free.
pub(super) fn fit_area(state: &UiState, aspect: f32) -> FitArea {
    const LEAST: f32 = 0.5;
    let size = state.view_rect.size().max(Vec2::splat(1.0));
    let corner = look_switch::corner(state.view_rect);
    let corner = corner.map_or(Vec2::ZERO, |corner| corner.size());
    let (below, corner) = match aspect < 1.0 {
        true => (corner.y, Vec2::ZERO),
        false => (0.0, corner / size),
    };
    let covered = 2.0 * below.max(tool_rows(state) * BAR_HEIGHT) / size.y;
    FitArea {
        aspect,
        free: glam::Vec2::new(1.0, (1.0 - covered).max(LEAST)),
        corner: glam::Vec2::new(corner.x, corner.y),
    }
}

/// Height at the top of the view that the tool bar takes, in points.
fn below_tools(state: &UiState) -> f32 {
    let usual = tool_rows(state) * BAR_HEIGHT;
    usual.max(state.pose.bar_bottom) + 8.0
}

/// Rows of the tool bar.
fn tool_rows(state: &UiState) -> f32 {
    if state.pose.tool == Tool::Ik {
        2.0
    } else {
        1.0
    }
}

/// The status line below the view: what is under the pointer and what gestures do there; at the
/// right, pictures per second and the graphics driver.
pub(super) fn status_line(
    root: &mut Ui,
    session: &Session,
    state: &mut UiState,
    input: &ViewInput,
) {
    let frame = Frame::side_top_panel(root.style()).inner_margin(Margin::symmetric(8, 2));
    Panel::bottom("status line").frame(frame).show(root, |ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let weak = Palette::of(ui.visuals()).weak;
            if state.windows.is_open(Dialog::Messages) {
                state.notices.faded = 0;
            } else if messages::faded(ui, &state.notices) {
                state.windows.open(Dialog::Messages);
            }
            let (over, mut next) = status(session, state, input, ui.ctx());
            if state.explain.takes_clicks() && is_over_character(session, state, input) {
                next = format!("Click to explain the vertex there · {next}").into();
            }
            let strong = Palette::of(ui.visuals()).strong;
            let over = over.as_deref().map(|over| (over, strong));
            let texts = || over.into_iter().chain([(&*next, weak)]);
            // What can be done comes before what draws.
            let font = TextStyle::Small.resolve(ui.style());
            let gap = ui.spacing().item_spacing.x;
            let hint: f32 = texts()
                .map(|(text, _)| text_width(ui, text, &font) + gap)
                .sum();
            machine::show(ui, input, ui.available_width() - hint - GAP);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                for (text, color) in texts() {
                    ui.add(Label::new(RichText::new(text).small().color(color)).truncate());
                }
            });
        });
    });
}

/// Whether a character is under the pointer in the view.
fn is_over_character(session: &Session, state: &UiState, input: &ViewInput) -> bool {
    let bone = state.pose.hovered.as_ref();
    let shape = bone.map(|hit| hit.shape).or(input.hovered_shape);
    shape.is_some_and(|shape| session.scene().character(shape).is_some())
}

/// Name of what is under the pointer, if anything, and what gestures do there.
fn status(
    session: &Session,
    state: &UiState,
    input: &ViewInput,
    ctx: &Context,
) -> (Option<String>, Cow<'static, str>) {
    let (navigation, pointing) = (state.navigation, Pointing::of(ctx));
    if state.saves_later() {
        let next = pointing.words(
            "It is saved once this movement has ended · Esc cancels the movement",
            "It is saved once this movement has ended",
        );
        return (None, next.into());
    }
    let is_of_joints = posing::posed(session, state.pose.tool).is_some();
    if let Some(next) = state.box_select.status(pointing, is_of_joints) {
        return (None, next.into());
    }
    if let Some((point, next)) = control_points::status(session, pointing) {
        return (Some(point), next.into());
    }
    if let Some((over, next)) = posing::status(session, &state.pose, pointing, ctx) {
        return (over, next);
    }
    if let Some((joint, is_root)) = hovered_joint(session) {
        // What is pointed at is a row or a button of the panel that explains.
        if state.explain.lit() == session.hovered_joint() {
            return (Some(joint), "".into());
        }
        let mut next = pointing
            .words(
                "Click to select the joint · drag its numbers to turn it",
                "Tap to select the joint · drag its numbers to turn it",
            )
            .to_owned();
        if is_root {
            next += ", those of its offset to move it";
        }
        return (Some(joint), next.into());
    }
    let over = input
        .hovered_shape
        .and_then(|id| session.scene().shape(id))
        .map(|shape| (shape.id, format!("{} (ID: {})", shape.name, shape.id)));
    match over {
        Some((_, name)) if state.pose.tool == Tool::Move => {
            (Some(name), "Drag to move it · Ctrl snaps".into())
        }
        Some((id, name)) if session.selected() != Some(id) => {
            let curves = session.scene().curve(id);
            let has_points = curves.is_some_and(|curves| curves.display.control_points);
            let next = match has_points {
                true => pointing.words(
                    "Click to select it, then drag its control points",
                    "Tap to select it, then drag its control points",
                ),
                false => navigation.over_a_shape(pointing),
            };
            (Some(name), next.into())
        }
        over => {
            let summary = navigation.summary(pointing);
            let next = match posing::beside_bones(session, state.pose.tool) {
                Some(does) => format!("{does} · {summary}").into(),
                None => summary.into(),
            };
            (over.map(|(_, name)| name), next)
        }
    }
}

/// The joint whose row is under the pointer, by name and number, as the file counts from 0, and whether it is a root.
fn hovered_joint(session: &Session) -> Option<(String, bool)> {
    let joint = session.hovered_joint()?;
    let character = session.scene().character(session.selected()?)?;
    let joints = character.character.skeleton().joints();
    let hovered = joints.get(joint)?;
    let name = &hovered.name;
    Some((format!("{name} ({joint})"), hovered.parent.is_none()))
}
