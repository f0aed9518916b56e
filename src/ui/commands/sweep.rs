//! Insert ▸ Surface of Revolution from Curve and Sweep from Curves: which curve is turned, or carried along which.

use super::run::{curves, selected_curves};
use crate::editor::{Edit, Session, View};
use crate::geometry::{Curve, CurveForm};
use crate::scene::{CurveItemKind, CurveSet, Shape, ShapeId, ShapeKind};
use crate::ui::Action;
use glam::Vec3;

/// Steps of a new surface of revolution, per turn.
pub(in crate::ui) const REVOLUTION_STEPS: u32 = 48;

const IS_THERE: &str = "The curve has this surface already";

/// The action that turns the last flat spline, or the last circle if there is no spline, or why there is none.
///
/// # Errors
/// As text for a tooltip.
pub(super) fn revolution(session: &Session) -> Result<Action, &'static str> {
    let (shape, set) = selected_curves(session).ok_or("No curve is selected")?;
    if curves(set).next().is_none() {
        return Err("The selected shape has no curve");
    }
    let is_spline = |curve: &Curve| matches!(curve.form(), CurveForm::Spline { .. });
    let flat = || curves(set).filter(|(_, curve)| curve.is_flat());
    let spline = flat().filter(|(_, curve)| is_spline(curve)).last();
    let (profile, _) = spline
        .or(flat().last())
        .ok_or("No curve of the selected shape lies in the plane z = 0")?;
    let is_there = set.items().iter().any(|item| match item.kind {
        CurveItemKind::Revolution { profile: of, .. } => of == profile,
        _ => false,
    });
    if is_there {
        return Err(IS_THERE);
    }
    Ok(Action::Edit(Edit::MakeSurfaceOfRevolution {
        shape,
        profile,
        steps: REVOLUTION_STEPS,
    }))
}

/// The actions that make the surface of a curve that is carried along another, or why there is none.
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
    if let Some((_, profile)) = profile {
        check_is_new(set, profile, sweep)?;
    }
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
    check_is_new(set, &profile, sweep)?;
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

/// Refuses a surface that a set has already: of a curve like `profile` that is carried along the curve `sweep`.
fn check_is_new(set: &CurveSet, profile: &Curve, sweep: usize) -> Result<(), &'static str> {
    let items = set.items();
    let is_there = items.iter().any(|item| match item.kind {
        CurveItemKind::Sweep {
            profile: of,
            sweep: along,
        } => along == sweep && items.get(of).and_then(|item| item.curve()) == Some(profile),
        _ => false,
    });
    match is_there {
        true => Err(IS_THERE),
        false => Ok(()),
    }
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
