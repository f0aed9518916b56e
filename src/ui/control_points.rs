//! Control points of a curve: their rows in the shape panel, and their drags in the view.

use super::Action;
use super::curve_panel::CurveState;
use super::grab::{Follow, Grab, PointerUse};
use super::number_field::NumberField;
use super::pointing::Pointing;
use super::scene_places::{Place, ScenePlaces};
use super::theme::Palette;
use super::widgets::named;
use crate::editor::{ControlPointDrag, Edit, Session, View, control_point_at};
use crate::geometry::{Basis, Curve, CurveForm};
use crate::scene::ShapeId;
use egui::{Button, CursorIcon, Label, Rect, Response, RichText, Stroke, Ui, vec2};
use glam::Vec2;

/// Number of control points above which only the rows in view are shown to egui: the panel must
/// stay fast for any file.
const MANY: usize = 256;
/// Width of a button, in points.
const BUTTON: f32 = 18.0;

/// The curve whose control points are listed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Listed<'a> {
    pub shape: ShapeId,
    /// Index in the [`crate::scene::CurveSet`].
    pub index: usize,
    pub curve: &'a Curve,
    /// Its title in the list.
    pub title: &'a str,
    /// Whether its points cannot leave z = 0.
    pub flat: bool,
    /// The point under the pointer, in the view or in the list.
    pub hovered: Option<usize>,
}

/// One row for each control point: its coordinates, and buttons that add one after it or remove it.
/// Returns the point whose row is under the pointer.
pub(super) fn show(ui: &mut Ui, listed: &Listed, actions: &mut Vec<Action>) -> Option<usize> {
    let points = listed.curve.control_points();
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let mut hovered = None;
    for point in 0..points.len() {
        let place = Rect::from_min_size(ui.cursor().min, size);
        if points.len() > MANY && !ui.is_rect_visible(place) {
            ui.allocate_space(size);
            continue;
        }
        if ui.rect_contains_pointer(place) {
            hovered = Some(point);
        }
        if listed.hovered == Some(point) {
            let color = ui.visuals().widgets.hovered.weak_bg_fill;
            ui.painter().rect_filled(place, 2.0, color);
        }
        ui.push_id(point, |ui| {
            ui.horizontal(|ui| row(ui, listed, point, size.x, actions));
        });
    }
    hovered
}

fn row(ui: &mut Ui, listed: &Listed, point: usize, width: f32, actions: &mut Vec<Action>) {
    ui.spacing_mut().item_spacing.x = 2.0;
    ui.spacing_mut().button_padding.x = 2.0;
    let digits = listed.curve.control_points().len().to_string().len();
    let number = 8.0 * digits.max(2) as f32 + 4.0;
    let height = ui.spacing().interact_size.y;
    let weak = Palette::of(ui.visuals()).weak;
    let text = RichText::new((point + 1).to_string()).small().color(weak);
    ui.add_sized(vec2(number, height), Label::new(text).extend());

    let axes = if listed.flat { 2 } else { 3 };
    let room = width - number - 2.0 * BUTTON - 2.0 * (axes + 2) as f32;
    coordinates(
        ui,
        listed,
        point,
        axes,
        (room / axes as f32).floor(),
        actions,
    );

    let name = |does: &str| format!("{does} {} point {}", listed.title, point + 1);
    let (shape, curve) = (listed.shape, listed.index);
    let (adds, removes) = match listed.curve.form() {
        CurveForm::Spline {
            basis: Basis::Bezier,
            ..
        } => (
            "Add a piece here: three points",
            "Remove this point, and the handles beside it",
        ),
        _ => ("Add a point after this one", "Remove this point"),
    };
    let square = vec2(BUTTON, height);
    let add = ui.add_sized(square, Button::new("+"));
    if named(add, &name("Add behind"))
        .on_hover_text(adds)
        .clicked()
    {
        let after = point;
        actions.push(Action::Edit(Edit::AddControlPoint {
            shape,
            curve,
            after,
        }));
    }
    let can = listed.curve.can_lose_point(point);
    let remove = ui
        .add_enabled_ui(can, |ui| ui.add_sized(square, Button::new("−")))
        .inner;
    let remove = named(remove, &name("Remove"))
        .on_hover_text(removes)
        .on_disabled_hover_text(why_it_stays(listed.curve, point));
    if remove.clicked() {
        actions.push(Action::Edit(Edit::RemoveControlPoint {
            shape,
            curve,
            point,
        }));
    }
}

fn coordinates(
    ui: &mut Ui,
    listed: &Listed,
    point: usize,
    axes: usize,
    width: f32,
    actions: &mut Vec<Action>,
) {
    let now = listed.curve.control_points()[point];
    let size = vec2(width, ui.spacing().interact_size.y);
    for axis in 0..axes {
        let letter = ["X", "Y", "Z"][axis];
        let name = format!("{} point {} {letter}", listed.title, point + 1);
        let field = NumberField::new(&name, now[axis], 0.01)
            .decimals(2..=4)
            .axis(axis);
        if let Some(value) = field.show(ui, size) {
            let mut position = now;
            position[axis] = value;
            actions.push(Action::Edit(Edit::SetControlPoint {
                shape: listed.shape,
                curve: listed.index,
                point,
                position,
            }));
        }
    }
}

/// Why a control point cannot be removed.
fn why_it_stays(curve: &Curve, point: usize) -> &'static str {
    if is_handle(curve, point) {
        "A handle goes with the point on the curve beside it"
    } else {
        "This is the last piece"
    }
}

impl Follow for ControlPointDrag {
    fn shape(&self) -> ShapeId {
        self.shape()
    }

    fn follow(
        &mut self,
        session: &Session,
        place: Place,
        pixel: Vec2,
        _snap: bool,
    ) -> Option<Edit> {
        self.moved_to(session, pixel, place.size())
    }
}

/// A control point that was clicked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Clicked {
    shape: ShapeId,
    curve: usize,
    point: usize,
    /// Control points that each curve of the shape had then. With others the indices may mean another point.
    counts: Vec<usize>,
}

impl Clicked {
    /// A control point of a shape, if it exists.
    fn of(session: &Session, shape: ShapeId, curve: usize, point: usize) -> Option<Self> {
        let curves = session.scene().curve(shape)?.curves();
        let items = 0..curves.items().len();
        let count = |index| {
            curves
                .curve(index)
                .map_or(0, |it| it.control_points().len())
        };
        let counts: Vec<usize> = items.map(count).collect();
        (point < *counts.get(curve)?).then_some(Self {
            shape,
            curve,
            point,
            counts,
        })
    }
}

/// Drags control points of the selected curves in the view, and marks the one under the pointer.
pub(super) fn pointer(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut CurveState,
    actions: &mut Vec<Action>,
) -> PointerUse {
    if state.gesture.is_none() {
        state.gesture = Grab::begin(view, places, actions, |place, pixel, _| {
            ControlPointDrag::begin(session, pixel, place.size())
        });
    }
    if let Some(gesture) = &mut state.gesture {
        let (curve, point) = gesture.held().control_point();
        state.clicked = Clicked::of(session, gesture.held().shape(), curve, point);
        let goes_on = gesture.follow(view, places, session, actions);
        let point = gesture.active().map(ControlPointDrag::control_point);
        if !goes_on {
            state.gesture = None;
        }
        view.ctx.set_cursor_icon(CursorIcon::Grabbing);
        mark(session, point, actions);
        return PointerUse::Holding;
    }
    let in_view = hovered(view, places, session);
    mark(session, in_view.or(state.hovered), actions);
    let Some((curve, point)) = in_view else {
        return PointerUse::Free;
    };
    if view.clicked() {
        let shape = session.selected();
        state.clicked = shape.and_then(|shape| Clicked::of(session, shape, curve, point));
    }
    view.ctx.set_cursor_icon(CursorIcon::Grab);
    PointerUse::Over
}

/// Puts back what is dragged, and marks no control point.
pub(super) fn put_back(session: &Session, state: &mut CurveState, actions: &mut Vec<Action>) {
    if let Some(gesture) = state.gesture.take() {
        gesture.put_back(actions);
    }
    mark(session, None, actions);
}

/// Name of the control point under the pointer, and what can be done with it, for the status line.
pub(super) fn status(session: &Session, pointing: Pointing) -> Option<(String, &'static str)> {
    let (index, point) = session.hovered_control_point()?;
    let shape = session.scene().curve(session.selected()?)?;
    let item = shape.curves().items().get(index)?;
    let curve = shape.curves().curve(index)?;
    let with_mouse = if curve.can_lose_point(point) {
        "Drag to move it · click it, and Delete removes it"
    } else if is_handle(curve, point) {
        "Drag to move it · it is deleted with the point on the curve beside it"
    } else {
        "Drag to move it · a curve of this kind cannot have fewer points"
    };
    let name = format!("{}, control point {}", item.name, point + 1);
    Some((name, pointing.words(with_mouse, "Drag to move it")))
}

/// Whether a control point is a handle beside one that is on a Bézier curve.
fn is_handle(curve: &Curve, point: usize) -> bool {
    let is_bezier = matches!(
        curve.form(),
        CurveForm::Spline {
            basis: Basis::Bezier,
            ..
        }
    );
    is_bezier && !point.is_multiple_of(3)
}

/// Deletes the control point that was clicked last, or tells why it has to stay; `None` if none was,
/// or it does not exist any more.
pub(super) fn delete_clicked(
    session: &Session,
    state: &CurveState,
) -> Option<Result<Edit, &'static str>> {
    let (shape, curve, point) = clicked(session, state)?;
    let points = session.scene().curve(shape)?.curves().curve(curve)?;
    Some(if points.can_lose_point(point) {
        Ok(Edit::RemoveControlPoint {
            shape,
            curve,
            point,
        })
    } else {
        Err(why_it_stays_in_words(points, point))
    })
}

/// Why Delete leaves a control point, as a sentence.
fn why_it_stays_in_words(curve: &Curve, point: usize) -> &'static str {
    if is_handle(curve, point) {
        "A handle is not deleted by itself: it goes with the point on the curve beside it"
    } else {
        "This point stays: a curve of this kind cannot have fewer points. To delete all of the shape, use Delete in \
         the panel"
    }
}

/// The control point that was clicked last, if the shape is still the only one selected.
pub(super) fn clicked(session: &Session, state: &CurveState) -> Option<(ShapeId, usize, usize)> {
    let clicked = state.clicked.as_ref()?;
    let &Clicked {
        shape,
        curve,
        point,
        ..
    } = clicked;
    let is_only = session.selected() == Some(shape) && session.selected_shapes().count() == 1;
    let is_there = Clicked::of(session, shape, curve, point).as_ref() == Some(clicked);
    (is_only && is_there).then_some((shape, curve, point))
}

/// Forgets the control point that was clicked last once something else is selected or edited:
/// Delete is about that then.
pub(super) fn forget_clicked(state: &mut CurveState, actions: &[Action]) {
    let is_other = |action: &Action| match action {
        Action::Edit(edit) => !matches!(
            edit,
            Edit::SetControlPoint { .. } | Edit::RemoveControlPoint { .. }
        ),
        Action::View(view) => matches!(
            view,
            View::Select(_)
                | View::ToggleSelected(_)
                | View::SelectTo(_)
                | View::SelectAll
                | View::SelectInBox(..)
        ),
        // Undoing brings back the same points; a shape with others is seen to have them.
        Action::History(_) | Action::Gesture(_) | Action::Ask(_) => false,
    };
    if actions.iter().any(is_other) {
        state.clicked = None;
    }
}

/// Marks the control point that was clicked last, which Delete is about.
pub(super) fn show_clicked(ui: &Ui, places: &ScenePlaces, session: &Session, state: &CurveState) {
    let place_in_world = || {
        let (shape, curve, point) = clicked(session, state)?;
        let is_shown = session.scene().curve(shape)?.display.control_points;
        let evaluated = session.evaluated().shape(shape)?;
        let curves = session.scene().curve(shape)?.curves();
        let position = *curves.curve(curve)?.control_points().get(point)?;
        let world = evaluated.world_from_model.transform_point3(position);
        (is_shown && evaluated.visible).then_some(world)
    };
    let Some(world) = place_in_world() else {
        return;
    };
    let color = Palette::of(ui.visuals()).accent;
    for place in places.iter() {
        if let Some(pixel) = place.screen(session).pixel(world) {
            let painter = ui.painter().with_clip_rect(place.seen);
            painter.circle_stroke(place.position(pixel), 8.0, Stroke::new(2.0, color));
        }
    }
}

/// Marks a control point as hovered, or none.
fn mark(session: &Session, point: Option<(usize, usize)>, actions: &mut Vec<Action>) {
    if point != session.hovered_control_point() {
        actions.push(Action::View(View::HoverControlPoint(point)));
    }
}

fn hovered(view: &Response, places: &ScenePlaces, session: &Session) -> Option<(usize, usize)> {
    let position = view.hover_pos().filter(|_| !view.dragged())?;
    let place = places.live_at(position)?;
    control_point_at(session, place.pixel(position), place.size())
}
