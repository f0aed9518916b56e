//! What menu items and keys do with the curves of the selected shape, which they choose
//! themselves; the list of curves offers the same for any of them.

use super::keys::Command;
use crate::editor::{Edit, Session};
use crate::geometry::{Curve, CurveForm};
use crate::scene::{CurveSet, ShapeId};
use crate::ui::{Action, Ask};

/// Steps of a new surface of revolution.
pub(super) const STEPS: u32 = 48;

/// A profile to turn: the last flat spline, or the last circle where there is no spline.
pub(super) fn revolution(session: &Session) -> Option<Action> {
    let (shape, set) = selected(session)?;
    let spline = |curve: &Curve| matches!(curve.form(), CurveForm::Spline { .. });
    let flat = || curves(set).filter(|(_, curve)| curve.is_flat());
    let (profile, _) = flat().filter(|(_, c)| spline(c)).last().or(flat().last())?;
    Some(Action::Edit(Edit::MakeSurfaceOfRevolution {
        shape,
        profile,
        steps: STEPS,
    }))
}

/// The first flat curve carried along the first curve in space, or along the last of the others
/// if all are flat; a tube along the only curve.
pub(super) fn sweep(session: &Session) -> Option<Action> {
    let (shape, set) = selected(session)?;
    let in_space = curves(set).find(|(_, curve)| !curve.is_flat());
    let (sweep, _) = in_space.or(curves(set).last())?;
    let profile = curves(set)
        .find(|&(index, curve)| index != sweep && curve.is_flat())
        .map(|(index, _)| index);
    Some(Action::Edit(Edit::MakeSweep {
        shape,
        profile,
        sweep,
    }))
}

/// The selected curves into a file.
pub(super) fn export(session: &Session) -> Option<Action> {
    let (shape, _) = selected(session)?;
    Some(Action::Ask(Ask::ExportCurve(shape)))
}

/// Why one of the commands above cannot be used now.
pub(super) fn why_disabled(command: Command, session: &Session) -> Option<&'static str> {
    let Some((_, set)) = selected(session) else {
        return Some("No curve is selected");
    };
    if command == Command::ExportCurve {
        return None;
    }
    if curves(set).next().is_none() {
        return Some("The selected shape has no curve");
    }
    let flat = curves(set).any(|(_, curve)| curve.is_flat());
    (command == Command::MakeSurfaceOfRevolution && !flat)
        .then_some("No curve of the selected shape lies in the plane z = 0")
}

fn selected(session: &Session) -> Option<(ShapeId, &CurveSet)> {
    let id = session.selected()?;
    Some((id, session.scene().curve(id)?.curves()))
}

/// The curves of `set` with their indices.
pub(super) fn curves(set: &CurveSet) -> impl Iterator<Item = (usize, &Curve)> {
    let items = set.items().iter().enumerate();
    items.filter_map(|(index, item)| Some((index, item.curve()?)))
}
