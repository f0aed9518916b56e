//! Selection of the shapes in a box that is drawn over the view.

use super::grab::{PointerUse, released_at};
use super::posing::posed;
use super::scene_places::ScenePlaces;
use super::theme::Palette;
use super::widgets::forget_buttons;
use super::{Action, Navigation};
use crate::editor::{BoxMode, Session, Tool, View};
use crate::scene::{pick_in_box, pick_joints_in_box};
use crate::ui::pointing::Pointing;
use egui::{Context, CursorIcon, Key, Modifiers, PointerButton, Pos2, Rect, Response, Stroke};
use egui::{StrokeKind, Ui};

/// State of the box.
#[derive(Clone, Debug, Default)]
pub(super) struct BoxSelect {
    /// Whether the next left drag in the view draws a box, whatever the tool and the navigation.
    pub armed: bool,
    drawn: Option<Drawn>,
}

/// A box that is being drawn, in points of the window.
#[derive(Clone, Copy, Debug)]
struct Drawn {
    from: Pos2,
    to: Pos2,
    /// Index of the picture of the scene in which it began.
    index: usize,
    /// A box that was cancelled waits for the button to be released.
    cancelled: bool,
}

impl BoxSelect {
    /// Whether a box is being drawn.
    pub(super) fn is_drawing(&self) -> bool {
        self.drawn.is_some()
    }

    /// Ends the box that is being drawn, which selects nothing.
    pub(super) fn put_back(&mut self) {
        self.drawn = None;
    }

    /// What the status line says while a box is to be drawn, which with a tool that poses is one of joints.
    pub(super) fn status(&self, pointing: Pointing, is_of_joints: bool) -> Option<&'static str> {
        let next = match is_of_joints {
            true => pointing.words(
                "Drag a box round joints · Shift adds · Ctrl takes out · Esc cancels",
                "Drag a box round joints",
            ),
            false => pointing.words(
                "Drag a box · Shift adds · Ctrl takes out · Esc cancels",
                "Drag a box",
            ),
        };
        (self.armed || self.is_drawing()).then_some(next)
    }
}

/// Esc cancels the box, and does nothing else. To be called before the panels.
pub(super) fn cancel_by_esc(ctx: &Context, state: &mut BoxSelect) {
    if !state.armed && state.drawn.is_none_or(|drawn| drawn.cancelled) {
        return;
    }
    let escape = ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
    if escape {
        state.armed = false;
        if let Some(drawn) = &mut state.drawn {
            drawn.cancelled = true;
        }
    }
}

/// Draws a box with the pointer, and selects by it when the button is released. A drag begins one
/// if that was asked for, or, with `under` nothing that takes the pointer, in a navigation whose
/// left drags do not move the camera.
pub(super) fn pointer(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    (state, navigation, tool): (&mut BoxSelect, Navigation, Tool),
    under: Option<PointerUse>,
    actions: &mut Vec<Action>,
) -> PointerUse {
    let alt = view.ctx.input(|input| input.modifiers.alt);
    let begins = match under {
        None => state.armed,
        Some(under) => under == PointerUse::Free && navigation == Navigation::Blender && !alt,
    };
    if state.drawn.is_none() && begins && view.drag_started_by(PointerButton::Primary) {
        state.drawn = begin(view, places);
    }
    if state.armed && view.clicked() {
        state.armed = false;
    }
    let Some(drawn) = &mut state.drawn else {
        if state.armed && view.hovered() {
            view.ctx.set_cursor_icon(CursorIcon::Crosshair);
        }
        return PointerUse::Free;
    };
    state.armed = false;
    let (left_down, any_down, secondary, at) = view.ctx.input(|input| {
        let pointer = &input.pointer;
        let secondary = pointer.button_pressed(PointerButton::Secondary);
        let at = released_at(input).or(pointer.latest_pos());
        (pointer.primary_down(), pointer.any_down(), secondary, at)
    });
    let to = at.unwrap_or(drawn.to);
    if to != drawn.to {
        // The box is shown in the next frame.
        drawn.to = to;
        view.ctx.request_repaint();
    }
    if secondary {
        drawn.cancelled = true;
        forget_buttons(&view.ctx);
    }
    view.ctx.set_cursor_icon(CursorIcon::Crosshair);
    let drawn = *drawn;
    if drawn.cancelled && !any_down {
        state.drawn = None;
    } else if !drawn.cancelled && !left_down {
        state.drawn = None;
        actions.extend(selection(view, places, (session, tool), drawn));
    }
    PointerUse::Holding
}

fn begin(view: &Response, places: &ScenePlaces) -> Option<Drawn> {
    let from = view.ctx.input(|input| input.pointer.press_origin())?;
    Some(Drawn {
        from,
        to: from,
        index: places.live_index_at(from)?,
        cancelled: false,
    })
}

/// What the box selects: Shift adds it to what is selected, Ctrl takes it out. While a figure is posed these are its
/// joints.
fn selection(
    view: &Response,
    places: &ScenePlaces,
    (session, tool): (&Session, Tool),
    drawn: Drawn,
) -> Option<Action> {
    let place = places.get(drawn.index)?;
    let corners = (place.pixel(drawn.from), place.pixel(drawn.to));
    let camera = &session.view().camera;
    let (scene, evaluated) = (session.scene(), session.evaluated());
    let held = view.ctx.input(|input| input.modifiers);
    let mode = match (held.command, held.shift) {
        (true, _) => BoxMode::TakeOut,
        (false, true) => BoxMode::Add,
        (false, false) => BoxMode::Replace,
    };
    let Some(posed) = posed(session, tool) else {
        let shapes = pick_in_box(scene, evaluated, camera, corners, place.size());
        return Some(Action::View(View::SelectInBox(shapes, mode)));
    };
    let shape = evaluated.shape(posed)?;
    let boxed = pick_joints_in_box(scene, shape, camera, corners, place.size());
    let before = session.selected_joints().iter().copied();
    let outside = before.filter(|joint| !boxed.contains(joint));
    let joints = match mode {
        BoxMode::TakeOut => outside.collect(),
        BoxMode::Add => outside.chain(boxed.iter().copied()).collect(),
        BoxMode::Replace => boxed,
    };
    Some(Action::View(View::SelectJoints(joints)))
}

/// Shows the box that is being drawn.
pub(super) fn show(ui: &Ui, places: &ScenePlaces, state: &BoxSelect) {
    let Some(drawn) = state.drawn.filter(|drawn| !drawn.cancelled) else {
        return;
    };
    let Some(place) = places.get(drawn.index) else {
        return;
    };
    let painter = ui.painter().with_clip_rect(place.rect);
    let color = Palette::of(ui.visuals()).accent;
    let drawn = Rect::from_two_pos(drawn.from, drawn.to);
    painter.rect_filled(drawn, 0.0, color.gamma_multiply(0.15));
    painter.rect_stroke(drawn, 0.0, Stroke::new(1.0, color), StrokeKind::Inside);
}
