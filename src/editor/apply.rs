use super::Edit;
use crate::character::Pose;
use crate::geometry::Curve;
use crate::scene::{
    CharacterShape, CurveItemKind, CurveSet, CurveSetError, CurveShape, Scene, Shape, ShapeId,
};
use glam::Vec3;

/// Radius and steps of the circle that a sweep without a profile gets: a tube.
const TUBE_RADIUS: f32 = 0.1;
const TUBE_STEPS: u32 = 20;

/// Reason why an edit was refused.
pub type EditError = CurveSetError;

/// Change of the document by an edit or a gesture: the shapes concerned.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Change {
    /// Whether another document replaced the previous one: all identifiers are new, though their
    /// numbers may have been in use.
    pub opened: bool,
    /// Shapes that did not exist before, in the order of the scene.
    pub added: Vec<ShapeId>,
    /// Shapes that no longer exist, in the order of the scene before.
    pub removed: Vec<ShapeId>,
    /// Shapes that existed before and differ now, in the order of the scene.
    pub altered: Vec<ShapeId>,
    /// Whether those that were there before come in another order.
    pub reordered: bool,
}

impl Change {
    /// Change by which a scene replaces any other.
    fn opened(scene: &Scene) -> Self {
        Self {
            opened: true,
            added: scene.shapes().iter().map(|shape| shape.id).collect(),
            ..Self::default()
        }
    }

    /// Change from one state of a scene to a later one.
    pub fn between(before: &Scene, after: &Scene) -> Self {
        let mut change = Self::default();
        for shape in after.shapes() {
            match before.shape(shape.id) {
                None => change.added.push(shape.id),
                Some(was) if was != shape => change.altered.push(shape.id),
                Some(_) => {}
            }
        }
        let gone = |id: &ShapeId| after.shape(*id).is_none();
        let shapes = before.shapes().iter();
        change.removed = shapes.map(|shape| shape.id).filter(gone).collect();
        let common = |scene: &Scene, other: &Scene| {
            let ids = scene.shapes().iter().map(|shape| shape.id);
            ids.filter(|&id| other.shape(id).is_some())
                .collect::<Vec<_>>()
        };
        change.reordered = common(before, after) != common(after, before);
        change
    }

    /// Whether nothing changed.
    pub fn is_nothing(&self) -> bool {
        *self == Self::default()
    }
}

/// Carries out an edit: the only function that changes a scene, and it does nothing else. An edit
/// of a shape or joint that does not exist does nothing.
///
/// # Errors
/// If the edit would not leave a valid scene; then the scene is as it was.
pub fn apply(scene: &mut Scene, edit: Edit) -> Result<Change, EditError> {
    let before = scene.clone();
    let opens = matches!(edit, Edit::Open(_));
    if let Err(error) = carry_out(scene, edit) {
        *scene = before;
        return Err(error);
    }
    Ok(if opens {
        Change::opened(scene)
    } else {
        Change::between(&before, scene)
    })
}

/// Carries out an edit, in part where it is refused.
fn carry_out(scene: &mut Scene, edit: Edit) -> Result<(), EditError> {
    match edit {
        Edit::Together(edits) => carry_out_all(scene, edits)?,
        Edit::Open(shapes) => *scene = shapes.into_iter().collect(),
        Edit::Insert(shapes) | Edit::Paste(shapes) => scene.extend(shapes),
        Edit::Delete(id) => drop(scene.delete(id)),
        Edit::Reset(id) => scene.reset(id),
        Edit::SetTransform(id, to) => on_shape(scene, id, |s| s.placement.transform = to),
        Edit::SetUniformScaling(id, on) => on_shape(scene, id, |s| set_uniform_scaling(s, on)),
        Edit::SetColor(id, color) => on_shape(scene, id, |s| s.placement.color = color),
        Edit::SetVisible(id, visible) => on_shape(scene, id, |s| s.visible = visible),
        Edit::SetLocked(id, locked) => on_shape(scene, id, |s| s.locked = locked),
        Edit::SetDisplay(id, display) => on_character(scene, id, |c| c.display = display),
        Edit::SetSkinningMethod(id, method) => {
            on_character(scene, id, |c| c.set_skinning_method(method));
        }
        Edit::LimitInfluences(id, most) => on_character(scene, id, |c| c.limit_influences(most)),
        Edit::SetJointAngle {
            shape,
            joint,
            axis,
            radians,
        } => on_pose(scene, shape, joint, |p| set_angle(p, joint, axis, radians)),
        Edit::SetJointTransform {
            shape,
            joint,
            rotation,
        } => on_pose(scene, shape, joint, |p| {
            p.set_joint_transform(joint, rotation)
        }),
        Edit::SetRootOffset {
            shape,
            root,
            offset,
        } => on_pose(scene, shape, root, |p| p.set_root_offset(root, offset)),
        Edit::ResetJoint(id, joint) => on_pose(scene, id, joint, |p| p.reset_joint(joint)),
        Edit::SetPose(id, pose) => on_character(scene, id, |c| c.set_pose(pose)),
        Edit::ResetPose(id) => on_character(scene, id, CharacterShape::reset_pose),
        Edit::KeepPose { shape, name } => on_character(scene, shape, |c| c.keep_pose(name)),
        Edit::ForgetPose(id, index) => on_character(scene, id, |c| c.forget_pose(index)),
        Edit::SetIk(id, ik) => on_character(scene, id, |c| c.ik = ik),
        Edit::UnpinAll(id) => on_character(scene, id, CharacterShape::unpin_all),
        Edit::MoveInList(id, index) => scene.move_in_list(id, index),
        Edit::Replace(id, kind, source) => on_shape(scene, id, |s| {
            s.kind = kind;
            s.source = Some(source);
        }),
        Edit::Rename(id, name) => on_shape(scene, id, |s| s.name = name),
        Edit::SetControlPoint {
            shape,
            curve,
            point,
            position,
        } => on_set(scene, shape, |s| {
            s.with_control_point(curve, point, position)
        })?,
        Edit::AddControlPoint {
            shape,
            curve,
            after,
        } => on_set(scene, shape, |s| s.with_point_after(curve, after))?,
        Edit::RemoveControlPoint {
            shape,
            curve,
            point,
        } => on_set(scene, shape, |s| s.without_point(curve, point))?,
        Edit::AddCurve(id, curve) => on_set(scene, id, |s| with_curve(s, curve))?,
        Edit::RemoveCurveItem { shape, item } => {
            on_set(scene, shape, |s| Ok(s.without_item(item)))?
        }
        Edit::SetSteps { shape, item, steps } => {
            on_set(scene, shape, |s| s.with_steps(item, steps))?
        }
        Edit::SetRadius {
            shape,
            curve,
            radius,
        } => on_set(scene, shape, |s| s.with_radius(curve, radius))?,
        Edit::SetFrameClosing(id, on) => on_curves(scene, id, |c| c.set_frame_closing(on)),
        Edit::SetCurveDisplay(id, display) => on_curves(scene, id, |c| c.display = display),
        Edit::MakeSurfaceOfRevolution {
            shape,
            profile,
            steps,
        } => on_set(scene, shape, |s| with_revolution(s, profile, steps))?,
        Edit::MakeSweep {
            shape,
            profile,
            sweep,
        } => on_set(scene, shape, |s| with_sweep(s, profile, sweep))?,
    }
    Ok(())
}

fn carry_out_all(scene: &mut Scene, edits: Vec<Edit>) -> Result<(), EditError> {
    edits
        .into_iter()
        .try_for_each(|edit| carry_out(scene, edit))
}

fn set_uniform_scaling(shape: &mut Shape, uniform: bool) {
    shape.placement.uniform_scaling = uniform;
    if uniform {
        let scale = &mut shape.placement.transform.scale;
        *scale = Vec3::splat(scale.x);
    }
}

fn set_angle(pose: &mut Pose, joint: usize, axis: usize, radians: f32) {
    let mut rotation = pose.rotation(joint);
    rotation.radians[axis.min(2)] = radians;
    pose.set_joint_transform(joint, rotation);
}

fn with_curve(set: &CurveSet, curve: Curve) -> Result<CurveSet, CurveSetError> {
    let mut set = set.clone();
    let name = set.free_name("curve");
    set.push(&name, CurveItemKind::Curve(curve))?;
    Ok(set)
}

fn with_revolution(set: &CurveSet, profile: usize, steps: u32) -> Result<CurveSet, CurveSetError> {
    let mut set = set.clone();
    let name = set.free_name("surface");
    set.push(&name, CurveItemKind::Revolution { steps, profile })?;
    Ok(set)
}

fn with_sweep(
    set: &CurveSet,
    profile: Option<usize>,
    sweep: usize,
) -> Result<CurveSet, CurveSetError> {
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

/// Changes a shape; nothing if there is none of this identifier.
fn on_shape(scene: &mut Scene, id: ShapeId, change: impl FnOnce(&mut Shape)) {
    if let Some(shape) = scene.shape_mut(id) {
        change(shape);
    }
}

/// Changes a character; nothing if the shape is none.
fn on_character(scene: &mut Scene, id: ShapeId, change: impl FnOnce(&mut CharacterShape)) {
    if let Some(character) = scene.character_mut(id) {
        change(character);
    }
}

/// Changes the pose of a character; nothing if it does not have `joint`.
fn on_pose(scene: &mut Scene, id: ShapeId, joint: usize, change: impl FnOnce(&mut Pose)) {
    on_character(scene, id, |character| {
        if joint < character.character.skeleton().joints().len() {
            let mut pose = character.pose().clone();
            change(&mut pose);
            character.set_pose(pose);
        }
    });
}

/// Changes a shape made of curves; nothing if the shape is none.
fn on_curves(scene: &mut Scene, id: ShapeId, change: impl FnOnce(&mut CurveShape)) {
    if let Some(curve) = scene.curve_mut(id) {
        change(curve);
    }
}

/// Replaces the curves of a shape made of curves; nothing if the shape is none.
fn on_set(
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
