use super::state::UiState;
use super::{ScenePlaces, ViewInput, axis_ball, compare, first_help, notices, posing};
use crate::editor::Session;
use crate::ui::{Action, CompareSettings};
use egui::{Rect, Response, Sense, Ui, WidgetInfo, WidgetType};

/// What the view leaves to the handle at the panel's edge, in points.
const PANEL_EDGE: f32 = 4.0;

/// Takes what the panels left free as the view, and shows what lies over it. `settings` are those
/// of a comparison, if one is under way, as its panel left them.
///
/// The view is a widget below all others here: egui says which of them the pointer is for.
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
    let mut over = root.new_child(
        egui::UiBuilder::new()
            .id_salt("over the view")
            .max_rect(rect),
    );
    over.set_clip_rect(rect.intersect(root.clip_rect()));

    let places = match (input.compare, settings) {
        (Some(compare), Some(settings)) => {
            compare::pictures(&mut over, &response, compare, settings)
        }
        _ => ScenePlaces::whole(rect),
    };
    posing::show(&mut over, &places, &response, session, state);
    axis_ball::show(&mut over, rect, &session.view().camera, actions);
    notices::show(&mut over, rect, session, &mut state.notices, actions);
    // Nothing hides what went wrong.
    if state.first_help && session.messages.fresh().is_empty() {
        let gesture = response.dragged() || response.clicked() || input.gesture_under_way;
        let closed = first_help::show(&mut over, rect, state.navigation.summary());
        state.first_help = !(closed || gesture);
    }
    (rect, response, places)
}
