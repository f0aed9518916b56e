//! A curve in the shape panel: how it is drawn, and the list of its curves and surfaces.

use super::commands::{REVOLUTION_STEPS, curves};
use super::control_points::{Clicked, Listed};
use super::grab::Grab;
use super::number_field::NumberField;
use super::theme::Palette;
use super::widgets::{labelled, named, titled_choice};
use super::{Action, control_points};
use crate::editor::{ControlPointDrag, Edit, Session};
use crate::geometry::{Basis, Curve, CurveForm, MAX_STEPS};
use crate::scene::{
    CurveItem, CurveItemKind, CurveSet, CurveShape, CurveVisibility, EvaluatedCurves, ShapeId,
    SurfaceVisibility,
};
use egui::{Align, Button, Checkbox, Label, Layout, Rect, RichText, Ui, vec2};
use std::collections::HashMap;

/// State of the list of curves, and of drags of control points.
#[derive(Clone, Debug, Default)]
pub(super) struct CurveState {
    /// Whether a curve or surface is unfolded, by its shape and its index; without an entry, the
    /// only one of a shape is.
    pub unfolded: HashMap<(ShapeId, usize), bool>,
    /// Curve and control point whose row was under the pointer in the last frame.
    pub hovered: Option<(usize, usize)>,
    /// The control point that was clicked or dragged last, if nothing else was since then.
    pub clicked: Option<Clicked>,
    /// The control point that is being dragged.
    pub gesture: Option<Grab<ControlPointDrag>>,
}

/// How curves and surfaces are drawn, and whether the frames of closed sweeps close.
pub(super) fn display(ui: &mut Ui, id: ShapeId, shape: &CurveShape, actions: &mut Vec<Action>) {
    let mut changed = shape.display;
    ui.checkbox(&mut changed.control_points, "Show Control Points")
        .on_hover_text("Show the points that shape the curves; drag them in the view");
    let curves = [
        (CurveVisibility::Off, "Off", "Hide the curves"),
        (CurveVisibility::On, "On", "Show the curves"),
        (
            CurveVisibility::OnWithFrames,
            "On with Normals/Tangents/Binormals",
            "Show the curves with normal (red), tangent (blue) and binormal (green) at each point",
        ),
    ];
    titled_choice(ui, "Curve Visibility", &mut changed.curve, &curves);
    let surfaces = [
        (SurfaceVisibility::Off, "Off", "Hide the surfaces"),
        (
            SurfaceVisibility::WireframeWithNormals,
            "Wireframe with Normals",
            "Show every edge of the surfaces, and the normal of each vertex",
        ),
        (SurfaceVisibility::Shaded, "Shaded", "Show the surfaces lit"),
    ];
    titled_choice(ui, "Surface Visibility", &mut changed.surface, &surfaces);
    if changed != shape.display {
        actions.push(Action::Edit(Edit::SetCurveDisplay(id, changed)));
    }
    frame_closing(ui, id, shape, actions);
}

/// A switch for the frames of closed sweeps.
fn frame_closing(ui: &mut Ui, id: ShapeId, shape: &CurveShape, actions: &mut Vec<Action>) {
    let swept = |item: &CurveItem| matches!(item.kind, CurveItemKind::Sweep { .. });
    let sweeps = shape.curves().items().iter().any(swept);
    let mut closing = shape.frame_closing();
    let checkbox = Checkbox::new(&mut closing, "Close Frames");
    let hint = "Spread the angle by which the frame misses its start along a closed sweep, so \
                that the surface closes without a step";
    let switch = ui
        .add_enabled(sweeps, checkbox)
        .on_hover_text(hint)
        .on_disabled_hover_text("There is no sweep here");
    if switch.changed() {
        actions.push(Action::Edit(Edit::SetFrameClosing(id, closing)));
    }
}

/// Number of rows above which only the rows in view are shown to egui.
const MANY: usize = 256;

/// The curves and surfaces of a shape, each of which unfolds.
pub(super) fn list(
    ui: &mut Ui,
    session: &Session,
    id: ShapeId,
    state: &mut CurveState,
    actions: &mut Vec<Action>,
) {
    let Some(shape) = session.scene().curve(id) else {
        return;
    };
    title(ui, id, actions);
    let items = shape.curves().items();
    if items.is_empty() {
        ui.label(RichText::new("Nothing here yet. Add inserts a curve.").weak());
    }
    let evaluated = session
        .evaluated()
        .shape(id)
        .and_then(|shape| shape.geometry.curves.as_ref());
    let row = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let asked_before = actions.len();
    for index in 0..items.len() {
        let unfolded = *state
            .unfolded
            .get(&(id, index))
            .unwrap_or(&(items.len() == 1));
        let place = Rect::from_min_size(ui.cursor().min, row);
        if items.len() > MANY && !unfolded && !ui.is_rect_visible(place) {
            ui.allocate_space(row);
            continue;
        }
        let item = Item {
            id,
            index,
            shape,
            title: item_title(shape.curves(), index),
            hovered: session
                .hovered_control_point()
                .filter(|&(curve, _)| curve == index)
                .map(|(_, point)| point),
        };
        ui.push_id(index, |ui| {
            if item.header(ui, unfolded, actions) {
                state.unfolded.insert((id, index), !unfolded);
            }
            if unfolded {
                ui.indent("contents", |ui| {
                    let hovered = item.contents(ui, evaluated, actions);
                    state.hovered = hovered.map(|point| (index, point)).or(state.hovered);
                });
            }
        });
    }
    for action in &actions[asked_before..] {
        if let Action::Edit(Edit::RemoveCurveItem { item, .. }) = action {
            // The indices of those after it change.
            let stays = |&(shape, index): &(ShapeId, usize)| shape != id || index < *item;
            state.unfolded.retain(|key, _| stays(key));
        }
    }
}

/// Title of the list, with a menu of curves to add.
fn title(ui: &mut Ui, id: ShapeId, actions: &mut Vec<Action>) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        let menu = ui.menu_button("Add", |ui| {
            for (label, set) in [
                ("Add Bézier curve", CurveSet::start_spline(Basis::Bezier)),
                ("Add B-spline", CurveSet::start_spline(Basis::BSpline)),
                ("Add circle", CurveSet::start_circle()),
            ] {
                if let (true, Some(curve)) = (ui.button(label).clicked(), set.curve(0)) {
                    actions.push(Action::Edit(Edit::AddCurve(id, curve.clone())));
                }
            }
        });
        named(menu.response, "Add a curve")
            .on_hover_text("Add a curve to this shape, to sweep or to sweep along");
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let color = Palette::of(ui.visuals()).strong;
            let text = RichText::new("Curves and Surfaces").color(color);
            ui.add(Label::new(text).truncate());
        });
    });
}

/// Title of an item in the list: its number and name, because names need not be unique.
fn item_title(set: &CurveSet, index: usize) -> String {
    let name = set.items().get(index).map_or("", |item| &item.name);
    format!("{}. {name}", index + 1)
}

/// A curve or surface in the list.
struct Item<'a> {
    id: ShapeId,
    index: usize,
    shape: &'a CurveShape,
    title: String,
    /// The control point under the pointer, in the view or in the list.
    hovered: Option<usize>,
}

impl Item<'_> {
    fn set(&self) -> &CurveSet {
        self.shape.curves()
    }

    fn kind(&self) -> &CurveItemKind {
        &self.set().items()[self.index].kind
    }

    fn title_of(&self, index: usize) -> String {
        item_title(self.set(), index)
    }

    /// The row that unfolds the item; whether it was clicked.
    fn header(&self, ui: &mut Ui, unfolded: bool, actions: &mut Vec<Action>) -> bool {
        let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
        let layout = Layout::right_to_left(Align::Center);
        let header = ui.allocate_ui_with_layout(size, layout, |ui| {
            let remove = ui.add(Button::new("×").frame_when_inactive(false));
            let remove = named(remove, &format!("Remove {}", self.title));
            if remove.on_hover_text(self.removal()).clicked() {
                actions.push(Action::Edit(Edit::RemoveCurveItem {
                    shape: self.id,
                    item: self.index,
                }));
            }
            let color = Palette::of(ui.visuals()).weak;
            ui.label(RichText::new(self.kind_name()).small().color(color));
            ui.with_layout(Layout::top_down_justified(Align::LEFT), |ui| {
                let arrow = if unfolded { "⏷" } else { "⏵" };
                let text = format!("{arrow} {}", self.title);
                let button = Button::selectable(false, text).truncate();
                named(ui.add(button), &self.title)
            })
            .inner
        });
        let hint = if unfolded {
            "Hide the details"
        } else {
            "Show the details"
        };
        header.inner.on_hover_text(hint).clicked()
    }

    /// Tooltip of the button that removes it.
    fn removal(&self) -> &'static str {
        if self.set().is_profile(self.index) || self.set().is_sweep(self.index) {
            "Remove this curve, and the surfaces made from it"
        } else {
            "Remove this"
        }
    }

    fn kind_name(&self) -> &'static str {
        match self.kind() {
            CurveItemKind::Curve(curve) => match curve.form() {
                CurveForm::Circle { .. } => "circle",
                CurveForm::Spline {
                    basis: Basis::Bezier,
                    flat: true,
                    ..
                } => "Bézier, flat",
                CurveForm::Spline {
                    basis: Basis::Bezier,
                    ..
                } => "Bézier",
                CurveForm::Spline { flat: true, .. } => "B-spline, flat",
                CurveForm::Spline { .. } => "B-spline",
            },
            CurveItemKind::Revolution { .. } => "revolution",
            CurveItemKind::Sweep { .. } => "sweep",
        }
    }

    /// Properties of the item; returns the control point whose row is under the pointer.
    fn contents(
        &self,
        ui: &mut Ui,
        evaluated: Option<&EvaluatedCurves>,
        actions: &mut Vec<Action>,
    ) -> Option<usize> {
        match *self.kind() {
            CurveItemKind::Curve(ref curve) => return self.curve(ui, curve, actions),
            CurveItemKind::Revolution { steps, profile } => {
                note(ui, &format!("{} about the Y axis", self.title_of(profile)));
                self.steps(ui, "Steps of turn", steps, REVOLUTION_STEPS, actions);
            }
            CurveItemKind::Sweep { profile, sweep } => {
                let (profile, along) = (self.title_of(profile), self.title_of(sweep));
                note(ui, &format!("{profile} along {along}"));
                let curves = evaluated.map_or(&[] as &[_], |all| &all.curves);
                let along = curves.iter().find(|curve| curve.item == sweep);
                if let Some(angle) = along.and_then(|curve| curve.closing_angle) {
                    let degrees = angle.to_degrees();
                    note(ui, &format!("Frames turned by {degrees:.1}° to close"));
                }
            }
        }
        None
    }

    /// Properties of a curve; returns as [`Self::contents`].
    fn curve(&self, ui: &mut Ui, curve: &Curve, actions: &mut Vec<Action>) -> Option<usize> {
        let (label, start) = match curve.form() {
            CurveForm::Circle { .. } => ("Steps around", 60),
            CurveForm::Spline { .. } => ("Steps a piece", 20),
        };
        self.steps(ui, label, curve.steps(), start, actions);
        if let CurveForm::Circle { radius } = *curve.form() {
            let name = format!("{} radius", self.title);
            let radius = labelled(ui, "Radius", |ui, size| {
                NumberField::new(&name, radius, 0.01)
                    .rest(1.0)
                    .decimals(2..=4)
                    .show(ui, size)
            });
            actions.extend(radius.map(|radius| {
                Action::Edit(Edit::SetRadius {
                    shape: self.id,
                    curve: self.index,
                    radius,
                })
            }));
        }
        let listed = Listed {
            shape: self.id,
            index: self.index,
            curve,
            title: &self.title,
            flat: curve.stays_flat() || self.set().is_profile(self.index),
            hovered: self.hovered,
        };
        let hovered = control_points::show(ui, &listed, actions);
        self.make_surfaces(ui, curve, actions);
        hovered
    }

    /// A field for the number of steps.
    fn steps(&self, ui: &mut Ui, label: &str, now: u32, rest: u32, actions: &mut Vec<Action>) {
        let name = format!("{} steps", self.title);
        let steps = labelled(ui, label, |ui, size| {
            NumberField::new(&name, now as f32, 0.2)
                .rest(rest as f32)
                .range(1.0..=f64::from(MAX_STEPS))
                .decimals(0..=0)
                .show(ui, size)
        });
        // From 1 to 10,000: fits.
        let steps = steps.map(|steps| steps.round() as u32);
        if let Some(steps) = steps.filter(|&steps| steps != now) {
            actions.push(Action::Edit(Edit::SetSteps {
                shape: self.id,
                item: self.index,
                steps,
            }));
        }
    }

    /// Buttons that make surfaces from this curve.
    fn make_surfaces(&self, ui: &mut Ui, curve: &Curve, actions: &mut Vec<Action>) {
        ui.horizontal_wrapped(|ui| {
            let turn = ui.add_enabled(curve.is_flat(), Button::new("Revolve"));
            let turn = named(turn, &format!("Revolve {}", self.title))
                .on_hover_text("Make the surface that this curve sweeps about the Y axis")
                .on_disabled_hover_text("Only a curve in the plane z = 0 can be turned");
            if turn.clicked() {
                actions.push(Action::Edit(Edit::MakeSurfaceOfRevolution {
                    shape: self.id,
                    profile: self.index,
                    steps: REVOLUTION_STEPS,
                }));
            }
            let menu = ui.menu_button("Sweep along this ⏷", |ui| {
                let profiles = curves(self.set())
                    .filter(|&(index, curve)| index != self.index && curve.is_flat())
                    .map(|(index, _)| (Some(index), format!("Carry {}", self.title_of(index))));
                for (profile, label) in
                    profiles.chain([(None, "Carry a new small circle".to_owned())])
                {
                    if ui.button(label).clicked() {
                        actions.push(Action::Edit(Edit::MakeSweep {
                            shape: self.id,
                            profile,
                            sweep: self.index,
                        }));
                    }
                }
            });
            named(menu.response, &format!("Sweep along {}", self.title))
                .on_hover_text("Make the surface of a flat curve that is carried along this one");
        });
    }
}

fn note(ui: &mut Ui, text: &str) {
    ui.add(Label::new(RichText::new(text).small()).wrap());
}
