use super::Edit;
use crate::geometry::Curve;
use crate::scene::{CurveItemKind, CurveSet, CurveSetError, CurveShape, Scene, ShapeId};

/// The circle that a sweep without a profile gets: a tube.
const TUBE_RADIUS: f32 = 0.1;
const TUBE_STEPS: u32 = 20;

/// Carries out the edits that concern curves; all others, and those to a shape that is not made
/// of curves, do nothing.
///
/// # Errors
/// If the change would not leave valid curves; nothing is changed then.
pub(super) fn apply_curve_edit(scene: &mut Scene, edit: Edit) -> Result<(), CurveSetError> {
    match edit {
        Edit::SetControlPoint {
            shape,
            curve,
            point,
            position,
        } => change(scene, shape, |set| {
            set.with_control_point(curve, point, position)
        }),
        Edit::AddControlPoint {
            shape,
            curve,
            after,
        } => change(scene, shape, |set| set.with_point_after(curve, after)),
        Edit::RemoveControlPoint {
            shape,
            curve,
            point,
        } => change(scene, shape, |set| set.without_point(curve, point)),
        Edit::AddCurve(shape, curve) => change(scene, shape, |set| {
            let mut set = set.clone();
            let name = set.free_name("curve");
            set.push(&name, CurveItemKind::Curve(curve))?;
            Ok(set)
        }),
        Edit::RemoveCurveItem { shape, item } => {
            change(scene, shape, |set| Ok(set.without_item(item)))
        }
        Edit::SetSteps { shape, item, steps } => {
            change(scene, shape, |set| set.with_steps(item, steps))
        }
        Edit::SetRadius {
            shape,
            curve,
            radius,
        } => change(scene, shape, |set| set.with_radius(curve, radius)),
        Edit::SetFrameClosing(shape, closing) => {
            with_shape(scene, shape, |curve| curve.set_frame_closing(closing));
            Ok(())
        }
        Edit::SetCurveDisplay(shape, display) => {
            with_shape(scene, shape, |curve| curve.display = display);
            Ok(())
        }
        Edit::MakeSurfaceOfRevolution {
            shape,
            profile,
            steps,
        } => change(scene, shape, |set| {
            let mut set = set.clone();
            let name = set.free_name("surface");
            set.push(&name, CurveItemKind::Revolution { steps, profile })?;
            Ok(set)
        }),
        Edit::MakeSweep {
            shape,
            profile,
            sweep,
        } => change(scene, shape, |set| swept(set, profile, sweep)),
        _ => Ok(()),
    }
}

fn swept(set: &CurveSet, profile: Option<usize>, sweep: usize) -> Result<CurveSet, CurveSetError> {
    let mut set = set.clone();
    let profile = match profile {
        Some(profile) => profile,
        None => {
            let name = set.free_name("tube");
            let circle = Curve::circle(TUBE_STEPS, TUBE_RADIUS)?;
            set.push(&name, CurveItemKind::Curve(circle))?
        }
    };
    let name = set.free_name("surface");
    set.push(&name, CurveItemKind::Sweep { profile, sweep })?;
    Ok(set)
}

fn change(
    scene: &mut Scene,
    id: ShapeId,
    change: impl FnOnce(&CurveSet) -> Result<CurveSet, CurveSetError>,
) -> Result<(), CurveSetError> {
    if let Some(curve) = scene.curve_mut(id) {
        let changed = change(curve.curves())?;
        curve.set_curves(changed);
    }
    Ok(())
}

fn with_shape(scene: &mut Scene, id: ShapeId, change: impl FnOnce(&mut CurveShape)) {
    if let Some(curve) = scene.curve_mut(id) {
        change(curve);
    }
}
