use super::widgets::{named, section};
use crate::editor::Edit;
use crate::scene::{CurveItemKind, CurveShape, CurveVisibility, ShapeId, SurfaceVisibility};
use crate::ui::Action;
use egui::{Button, Ui};

/// How curves and surfaces are drawn, and whether closed sweeps close.
pub(super) fn show(ui: &mut Ui, id: ShapeId, shape: &CurveShape, actions: &mut Vec<Action>) {
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
    choice(ui, "Curve Visibility", &mut changed.curve, &curves);
    let surfaces = [
        (SurfaceVisibility::Off, "Off", "Hide the surfaces"),
        (
            SurfaceVisibility::WireframeWithNormals,
            "Wireframe with Normals",
            "Show every edge of the surfaces, and the normal of each vertex",
        ),
        (SurfaceVisibility::Shaded, "Shaded", "Show the surfaces lit"),
    ];
    choice(ui, "Surface Visibility", &mut changed.surface, &surfaces);
    if changed != shape.display {
        actions.push(Action::Edit(Edit::SetCurveDisplay(id, changed)));
    }
    frame_closing(ui, id, shape, actions);
}

fn frame_closing(ui: &mut Ui, id: ShapeId, shape: &CurveShape, actions: &mut Vec<Action>) {
    let swept = |item: &crate::scene::CurveItem| matches!(item.kind, CurveItemKind::Sweep { .. });
    let sweeps = shape.curves().items().iter().any(swept);
    let mut closing = shape.frame_closing();
    let checkbox = egui::Checkbox::new(&mut closing, "Close Frames");
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

/// A title, and below it buttons of which one is on, in as many rows as it takes. Their names
/// for assistive technology start with the title, since several titles have an “Off”.
fn choice<T: Copy + PartialEq>(
    ui: &mut Ui,
    title: &str,
    value: &mut T,
    options: &[(T, &str, &str)],
) {
    section(ui, title);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        ui.spacing_mut().button_padding.x = 6.0;
        for &(option, label, hint) in options {
            let button = Button::selectable(*value == option, label)
                .frame_when_inactive(true)
                .wrap_mode(egui::TextWrapMode::Extend);
            let button = named(ui.add(button), &format!("{title}: {label}"));
            if button.on_hover_text(hint).clicked() {
                *value = option;
            }
        }
    });
}
