use super::gesture::{Held, PoseGesture};
use super::{Place, PoseState, gizmos};
use crate::editor::{
    BoneDrag, IkGrip, MoveAlong, MoveDrag, MoveTarget, Session, Tool, View, root_of,
};
use crate::math::Ray;
use crate::revision::Revision;
use crate::scene::{BoneHit, Camera, ModelDisplay, ShapeId, pick_bone, pick_shape};
use crate::ui::pointer_use::PointerUse;
use crate::ui::{Action, GestureStep, ScenePlaces};
use egui::{CursorIcon, PointerButton, Pos2, Response};
use glam::Vec2;

/// What the pointer does to gizmos, bones and, with the Move tool, shapes, in this order: marks
/// what is under it, selects by click, and turns or moves by drag. `list` is the joint of the
/// selected character whose row the pointer is over.
pub(in crate::ui) fn pointer(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut PoseState,
    list: Option<usize>,
    actions: &mut Vec<Action>,
) -> PointerUse {
    state.over_view = view.hovered();
    if view.drag_started_by(PointerButton::Primary) && state.gesture.is_none() {
        state.gesture = begin(view, places, session, state, actions);
        if state.gesture.is_some() {
            actions.push(Action::Gesture(GestureStep::Begin));
        }
    }
    if let Some(gesture) = &mut state.gesture {
        let held = gesture.joint().map(|joint| (gesture.shape(), joint));
        if !gesture.go_on(view, places, session, actions) {
            state.gesture = None;
        }
        view.ctx.set_cursor_icon(CursorIcon::Grabbing);
        mark(session, held, actions);
        return PointerUse::Holding;
    }
    let under = view
        .hover_pos()
        .filter(|_| !view.dragged())
        .map_or(Under::Nothing, |at| under(session, state, places, at));
    let bone = match under {
        Under::Bone(hit, place) => Some((hit, place)),
        _ => None,
    };
    state.hovered = bone.map(|(hit, _)| hit);
    state.ik.hovered = bone
        .filter(|_| state.tool == Tool::Ik)
        .and_then(|(hit, place)| {
            let grip = IkGrip::of(session, &hit, &place.screen(session))?;
            Some((hit.shape, grip))
        });
    let in_list = session.selected().zip(list);
    let in_view = bone.map(|(hit, place)| {
        let joint = target_joint(session, state.tool, &hit, place);
        (hit.shape, joint)
    });
    mark(session, in_view.or(in_list), actions);
    match under {
        Under::Nothing => return PointerUse::Free,
        Under::Shape => {
            view.ctx.set_cursor_icon(CursorIcon::Grab);
            return PointerUse::Free;
        }
        Under::Handle => {}
        Under::Bone(hit, place) if view.clicked() => {
            let joint = target_joint(session, state.tool, &hit, place);
            state.taken = Some(hit);
            state.without_gizmo = None;
            select(session, hit.shape, Some(joint), actions);
        }
        Under::Bone(..) => {}
    }
    if state.tool != Tool::Select {
        view.ctx.set_cursor_icon(CursorIcon::Grab);
    }
    PointerUse::Over
}

/// The shape that was found under the pointer last. It is looked for once, however often it is
/// asked for, until the pointer, the camera or the document changes.
#[derive(Clone, Debug, Default)]
pub(in crate::ui) struct Picked {
    last: Option<(PickedFor, Option<ShapeId>)>,
}

/// What the shape under a pixel follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PickedFor {
    document: Revision,
    camera: Camera,
    pixel: Vec2,
    size: Vec2,
}

impl Picked {
    /// The shape under `pixel`, from the top left of a picture of `size`.
    pub fn shape_at(&mut self, session: &Session, pixel: Vec2, size: Vec2) -> Option<ShapeId> {
        let wanted = PickedFor {
            document: session.document(),
            camera: session.view().camera,
            pixel,
            size,
        };
        if let Some((found_for, shape)) = self.last
            && found_for == wanted
        {
            return shape;
        }
        let ray = wanted.camera.ray(pixel, size);
        let shape = pick_shape(session.evaluated(), &ray).map(|(shape, _)| shape);
        self.last = Some((wanted, shape));
        shape
    }
}

/// What a gesture would take.
enum Under {
    Nothing,
    Handle,
    /// In this picture of the scene.
    Bone(BoneHit, Place),
    /// With the Move tool alone.
    Shape,
}

fn under(session: &Session, state: &mut PoseState, places: &ScenePlaces, at: Pos2) -> Under {
    let Some(place) = Place::at(places, at) else {
        return Under::Nothing;
    };
    let pixel = place.pixel(at);
    let gizmo = gizmos::shown(session, state, place);
    if gizmo.and_then(|gizmo| gizmo.hit(pixel)).is_some() {
        return Under::Handle;
    }
    if let Some(hit) = bone_at(session, state.tool, place, pixel) {
        return Under::Bone(hit, place);
    }
    let mut is_shape = || {
        state
            .picked
            .shape_at(session, pixel, place.size())
            .is_some()
    };
    if state.tool == Tool::Move && is_shape() {
        return Under::Shape;
    }
    Under::Nothing
}

/// The bone under the pointer. Without a tool for them only those that show can be clicked.
fn bone_at(session: &Session, tool: Tool, place: Place, pixel: Vec2) -> Option<BoneHit> {
    let camera = &session.view().camera;
    let hit = pick_bone(
        session.scene(),
        session.evaluated(),
        camera,
        pixel,
        place.size(),
    )?;
    let display = session.scene().character(hit.shape)?.display;
    (tool != Tool::Select || display.mode != ModelDisplay::Mesh).then_some(hit)
}

/// The joint that a tool means by a bone.
fn target_joint(session: &Session, tool: Tool, hit: &BoneHit, place: Place) -> usize {
    let meant = match tool {
        Tool::Select | Tool::Pose => None,
        Tool::Move => root_of(session, hit.shape, hit.joint),
        Tool::Ik => IkGrip::of(session, hit, &place.screen(session)).map(IkGrip::joint),
    };
    meant.unwrap_or(hit.joint)
}

/// egui only takes a press for a drag once the pointer has moved; what was grabbed lies where the
/// button went down.
fn begin(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut PoseState,
    actions: &mut Vec<Action>,
) -> Option<PoseGesture> {
    if state.tool == Tool::Select {
        return None;
    }
    let (pressed, all) = view
        .ctx
        .input(|input| (input.pointer.press_origin(), input.modifiers.shift));
    let index = places.index_at(pressed?)?;
    let place = Place::of(places, index)?;
    let pixel = place.pixel(pressed?);
    let screen = place.screen(session);
    let ray = screen.ray(pixel);
    if let Some(gizmo) = gizmos::shown(session, state, place)
        && let Some(hit) = gizmo.hit(pixel)
    {
        return gizmo.take(session, hit, &ray, all, index);
    }
    if let Some(hit) = bone_at(session, state.tool, place, pixel) {
        let held = match state.tool {
            Tool::Pose => turn_bone(session, state, hit)?,
            Tool::Ik => state.ik.take(session, &hit, &screen, &ray)?,
            _ => move_root(session, hit, &ray, all)?,
        };
        state.taken = Some(hit);
        let joint = target_joint(session, state.tool, &hit, place);
        select(session, hit.shape, Some(joint), actions);
        return Some(PoseGesture::new(held, None, index));
    }
    if state.tool != Tool::Move {
        return None;
    }
    let shape = state.picked.shape_at(session, pixel, place.size())?;
    let drag = MoveDrag::begin(
        session,
        MoveTarget::Shape(shape),
        across_view(session),
        &ray,
    )?;
    select(session, shape, None, actions);
    Some(PoseGesture::new(Held::Moved(drag), None, index))
}

fn turn_bone(session: &Session, state: &mut PoseState, hit: BoneHit) -> Option<Held> {
    let eye = session.view().camera.eye();
    let drag = BoneDrag::begin(session, hit.shape, hit.joint, eye, hit.point)?;
    state.without_gizmo = Some((hit.shape, hit.joint));
    Some(Held::Bone(drag))
}

fn move_root(session: &Session, hit: BoneHit, ray: &Ray, all: bool) -> Option<Held> {
    let root = MoveTarget::Root {
        shape: hit.shape,
        joint: root_of(session, hit.shape, hit.joint)?,
    };
    let target = if all { root.all_roots() } else { root };
    let drag = MoveDrag::begin(session, target, across_view(session), ray)?;
    Some(Held::Moved(drag))
}

fn across_view(session: &Session) -> MoveAlong {
    MoveAlong::Plane(session.view().camera.forward())
}

fn select(session: &Session, shape: ShapeId, joint: Option<usize>, actions: &mut Vec<Action>) {
    if session.selected() != Some(shape) {
        actions.push(Action::View(View::Select(Some(shape))));
    }
    if session.selected() != Some(shape) || session.selected_joint() != joint {
        actions.push(Action::View(View::SelectJoint(joint)));
    }
}

/// Tells the session which bone is under the pointer, if that has changed.
fn mark(session: &Session, bone: Option<(ShapeId, usize)>, actions: &mut Vec<Action>) {
    if bone != session.hovered_bone() {
        actions.push(Action::View(View::HoverBone(bone)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::Edit;
    use crate::scene::NewShape;
    use crate::scene::ShapeKind;

    #[test]
    fn a_shape_is_looked_for_again_once_pointer_camera_or_scene_moved_and_not_before() {
        let mut session = Session::new();
        let insert = Edit::Insert(vec![NewShape::new("Cube", ShapeKind::Cube)]);
        session.edit(insert).unwrap();
        let cube = session.selected();
        let (size, middle) = (Vec2::new(800.0, 600.0), Vec2::new(400.0, 300.0));
        let mut picked = Picked::default();
        assert_eq!(picked.shape_at(&session, middle, size), cube);
        // What was found is told again, whatever it was.
        picked.last = picked.last.map(|(found_for, _)| (found_for, None));
        assert_eq!(picked.shape_at(&session, middle, size), None);
        assert_eq!(picked.shape_at(&session, middle + Vec2::X, size), cube);
        assert_eq!(picked.shape_at(&session, Vec2::ONE, size), None);
        let mut camera = session.view().camera;
        camera.pan_with_pointer(Vec2::ONE - middle, size.y);
        session.look(View::SetCamera(camera));
        assert_eq!(picked.shape_at(&session, Vec2::ONE, size), cube);
        if let Some(id) = cube {
            session.edit(Edit::Delete(id)).unwrap();
        }
        assert_eq!(picked.shape_at(&session, Vec2::ONE, size), None);
    }
}
