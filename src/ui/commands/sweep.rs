//! Insert ▸ Sweep from Curves: which curve is carried along which.

use super::run::curves;
use crate::editor::{Edit, Session, View};
use crate::geometry::{Curve, CurveForm};
use crate::scene::{CurveSet, Shape, ShapeId, ShapeKind};
use crate::ui::Action;
use glam::Vec3;

/// The actions that make the surface, or why there is none.
///
/// # Errors
/// As text for a tooltip.
pub(super) fn sweep(session: &Session) -> Result<Vec<Action>, &'static str> {
    let selected: Vec<(&Shape, &CurveSet)> =
        session.selected_shapes().filter_map(with_set).collect();
    match selected[..] {
        [] => Err("No curve is selected"),
        [(shape, set)] => within(shape.id, set),
        [one, other] => {
            let is_active = |(shape, _): (&Shape, _)| session.selected() == Some(shape.id);
            let (active, other) = if is_active(one) {
                (one, other)
            } else {
                (other, one)
            };
            between(active, other)
        }
        _ => Err("More than two curves are selected: one is carried along the other"),
    }
}

/// A sweep of the first flat curve of a shape along its first curve in space, or along its last curve if
/// all are flat; a tube along the only curve.
fn within(shape: ShapeId, set: &CurveSet) -> Result<Vec<Action>, &'static str> {
    let sweep = path_of(set).ok_or("The selected shape has no curve")?;
    let profile = curves(set).find(|&(index, curve)| index != sweep && curve.is_flat());
    Ok(vec![Action::Edit(Edit::MakeSweep {
        shape,
        profile: profile.map(|(index, _)| index),
        sweep,
    })])
}

/// A sweep of a flat curve of one shape along a curve of the other: the one that leaves the plane is the
/// path, and of two that both do not or both have either kind the active one, as in Blender, where the active
/// curve gets the other one for its bevel. The path's shape gets a copy of the profile.
fn between(
    active: (&Shape, &CurveSet),
    other: (&Shape, &CurveSet),
) -> Result<Vec<Action>, &'static str> {
    let is_all_flat = |(_, set): (&Shape, &CurveSet)| curves(set).all(|(_, curve)| curve.is_flat());
    let flat_of = |(_, set): (&Shape, &CurveSet)| {
        let flat = curves(set).find(|(_, curve)| curve.is_flat());
        flat.map(|(_, curve)| curve.clone())
    };
    let turned = flat_of(other).is_none() || is_all_flat(active) && !is_all_flat(other);
    let (path, carried) = if turned {
        (other, active)
    } else {
        (active, other)
    };
    let profile = flat_of(carried).ok_or(
        "Neither of the selected curves lies in the plane z = 0, as the one that is carried must",
    )?;
    let profile = scaled(&profile, carried.0.placement.transform.scale)?;
    let (shape, set) = (path.0.id, path.1);
    let sweep = path_of(set).ok_or("One of the selected shapes has no curve")?;
    let copied = Edit::AddCurve(shape, profile);
    let made = Edit::MakeSweep {
        shape,
        profile: Some(set.items().len()),
        sweep,
    };
    let edit = Action::Edit(Edit::Together(vec![copied, made]));
    // The panel shows the shape that has the surface.
    let select = turned.then_some(Action::View(View::Select(Some(shape))));
    Ok(std::iter::once(edit).chain(select).collect())
}

/// The curve of a set that another one is carried along.
fn path_of(set: &CurveSet) -> Option<usize> {
    let in_space = curves(set).find(|(_, curve)| !curve.is_flat());
    in_space.or(curves(set).last()).map(|(index, _)| index)
}

/// A flat curve as large as its shape shows it: how wide a tube becomes is what its user sees. Where the
/// shape stands and how it is turned does not matter to a profile.
fn scaled(curve: &Curve, scale: Vec3) -> Result<Curve, &'static str> {
    let scaled = match curve.form() {
        CurveForm::Circle { radius } if scale.x.abs() == scale.y.abs() => {
            Curve::circle(curve.steps(), radius * scale.x.abs())
        }
        CurveForm::Circle { .. } => {
            return Err("The circle is scaled in X otherwise than in Y, and would not be round");
        }
        CurveForm::Spline {
            basis,
            flat,
            control_points,
        } => {
            let points = control_points.iter().map(|point| *point * scale);
            Curve::spline(*basis, *flat, curve.steps(), points.collect())
        }
    };
    scaled.map_err(|_| "The curve that is carried is too large")
}

fn with_set(shape: &Shape) -> Option<(&Shape, &CurveSet)> {
    match &shape.kind {
        ShapeKind::Curve(curve) => Some((shape, curve.curves())),
        _ => None,
    }
}
