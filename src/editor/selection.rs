use super::among::{bounds_of, figures_of};
use super::standing::{moved, way_out};
use super::{Edit, Session};
use crate::math::{Euler, Transform};
use crate::scene::{CharacterDisplay, NewShape, Scene, Shape, ShapeId, ShapeKind};
use glam::Vec3;

/// What the shapes in a box become.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoxMode {
    /// The selection, instead of what was selected.
    Replace,
    /// Selected, with what was selected.
    Add,
    /// Not selected any more.
    TakeOut,
}

/// Selected shapes, and the joints of the active one that are selected.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Selection {
    /// Active shape: the one whose properties are shown.
    pub shape: Option<ShapeId>,
    /// The others, in the order in which they were selected.
    pub others: Vec<ShapeId>,
    /// Joints of the active shape, the active one last.
    pub joints: Vec<usize>,
}

impl Selection {
    /// Selects this shape alone, or none.
    pub fn only(shape: Option<ShapeId>) -> Self {
        Self {
            shape,
            ..Self::default()
        }
    }

    /// Adds a shape, which becomes the active one, or takes it out if it is selected.
    pub fn toggle(&mut self, shape: ShapeId) {
        if self.shape == Some(shape) {
            *self = Self {
                shape: self.others.pop(),
                others: std::mem::take(&mut self.others),
                joints: Vec::new(),
            };
        } else if let Some(place) = self.others.iter().position(|other| *other == shape) {
            self.others.remove(place);
        } else {
            self.others.extend(self.shape);
            self.shape = Some(shape);
            self.joints.clear();
        }
    }

    /// Selects `shapes`, of which `active` is the active one.
    pub fn all(shapes: impl Iterator<Item = ShapeId>, active: Option<ShapeId>) -> Self {
        let mut others: Vec<ShapeId> = shapes.filter(|&shape| Some(shape) != active).collect();
        Self {
            shape: active.or_else(|| others.pop()),
            others,
            joints: Vec::new(),
        }
    }

    /// Changes the selection by the shapes in a box. The active shape stays active, with its
    /// joints, if it stays selected.
    pub fn join(&mut self, shapes: &[ShapeId], mode: BoxMode) {
        let before: Vec<ShapeId> = self.others.iter().copied().chain(self.shape).collect();
        let is_in = |shape: &ShapeId| shapes.contains(shape);
        let selected: Vec<ShapeId> = match mode {
            BoxMode::Replace => shapes.to_vec(),
            BoxMode::Add => {
                let more = shapes.iter().filter(|shape| !before.contains(shape));
                before.iter().chain(more).copied().collect()
            }
            BoxMode::TakeOut => before.into_iter().filter(|shape| !is_in(shape)).collect(),
        };
        let active = self.shape.filter(|shape| selected.contains(shape));
        let joints = match active {
            Some(_) => std::mem::take(&mut self.joints),
            None => Vec::new(),
        };
        *self = Self {
            joints,
            ..Self::all(selected.into_iter(), active)
        };
    }

    /// Adds a joint of the active shape, which becomes the active one, or takes it out if it is selected.
    pub fn toggle_joint(&mut self, joint: usize) {
        match self.joints.iter().position(|selected| *selected == joint) {
            Some(place) => {
                self.joints.remove(place);
            }
            None => self.joints.push(joint),
        }
    }

    pub fn has(&self, shape: ShapeId) -> bool {
        self.shape == Some(shape) || self.others.contains(&shape)
    }
}

/// `edit` of the active shape, done to every selected shape: all are moved by the same vector,
/// turned by the same angles about their own origins and scaled by the same factors. An edit that
/// is about one shape alone stays as it is.
pub fn for_all_selected(session: &Session, edit: Edit) -> Edit {
    for_selected_where(session, edit, |_| true)
}

/// The same for an edit by a drag in the view, where shapes that are hidden or locked stay as they
/// are.
pub fn for_all_in_view(session: &Session, edit: Edit) -> Edit {
    for_selected_where(session, edit, |id| {
        let shape = session.evaluated().shape(id);
        shape.is_some_and(|shape| shape.pickable)
    })
}

fn for_selected_where(session: &Session, edit: Edit, takes_part: impl Fn(ShapeId) -> bool) -> Edit {
    let scene = session.scene();
    let Some(active) = session.selected().and_then(|id| scene.shape(id)) else {
        return edit;
    };
    let others = session
        .selected_shapes()
        .filter(|shape| shape.id != active.id && takes_part(shape.id))
        .filter(|shape| !matches!(edit, Edit::SetDisplay(..)) || display_of(shape).is_some());
    let same: Option<Vec<Edit>> = others.map(|other| same_of(&edit, active, other)).collect();
    match same {
        Some(same) if !same.is_empty() => {
            Edit::Together(std::iter::once(edit).chain(same).collect())
        }
        _ => edit,
    }
}

/// What `edit` of the shape `active` is for `other`; `None` for one that is about another shape, or
/// about one alone.
fn same_of(edit: &Edit, active: &Shape, other: &Shape) -> Option<Edit> {
    let (id, same) = match *edit {
        Edit::SetTransform(id, to) => {
            let (from, own) = (active.placement.transform, other.placement.transform);
            let to = carried_over(from, to, own);
            (id, Edit::SetTransform(other.id, to))
        }
        Edit::SetColor(id, color) => (id, Edit::SetColor(other.id, color)),
        Edit::SetUniformScaling(id, on) => (id, Edit::SetUniformScaling(other.id, on)),
        Edit::SetVisible(id, on) => (id, Edit::SetVisible(other.id, on)),
        Edit::SetLocked(id, on) => (id, Edit::SetLocked(other.id, on)),
        Edit::SetDisplay(id, to) => {
            let (from, own) = (display_of(active)?, display_of(other)?);
            (id, Edit::SetDisplay(other.id, shown_as(from, to, own)))
        }
        Edit::Delete(id) => (id, Edit::Delete(other.id)),
        Edit::Reset(id) => (id, Edit::Reset(other.id)),
        _ => return None,
    };
    (id == active.id).then_some(same)
}

fn display_of(shape: &Shape) -> Option<CharacterDisplay> {
    match &shape.kind {
        ShapeKind::Character(character) => Some(character.display),
        _ => None,
    }
}

/// `own` with what differs between `from` and `to` as `to` has it.
fn shown_as(
    from: CharacterDisplay,
    to: CharacterDisplay,
    own: CharacterDisplay,
) -> CharacterDisplay {
    fn changed<T: PartialEq>(from: T, to: T, own: T) -> T {
        if from == to { own } else { to }
    }
    CharacterDisplay {
        mode: changed(from.mode, to.mode, own.mode),
        joints: changed(from.joints, to.joints, own.joints),
        bones: changed(from.bones, to.bones, own.bones),
        point_size: changed(from.point_size, to.point_size, own.point_size),
        line_width: changed(from.line_width, to.line_width, own.line_width),
    }
}

/// `own` changed as `from` was to become `to`.
fn carried_over(from: Transform, to: Transform, own: Transform) -> Transform {
    let factor = |axis: usize| {
        let factor = to.scale[axis] / from.scale[axis];
        if factor.is_finite() { factor } else { 1.0 }
    };
    let turned = to.rotation.radians - from.rotation.radians;
    Transform {
        position: own.position + (to.position - from.position),
        rotation: Euler::from_radians(own.rotation.radians + turned),
        scale: own.scale * Vec3::from([0, 1, 2].map(factor)),
    }
}

/// The selected shapes as a scene of their own, for the clipboard.
pub fn scene_of_selected(session: &Session) -> Scene {
    session.selected_shapes().map(copy).collect()
}

/// Copies of the selected shapes, beside them in the direction of X; farther away where an earlier
/// copy stands already.
pub fn duplicates(session: &Session) -> Vec<NewShape> {
    let mut copies = duplicates_in_place(session);
    set_apart(session, &mut copies);
    copies
}

/// Copies of the selected shapes where they are.
pub fn duplicates_in_place(session: &Session) -> Vec<NewShape> {
    session.selected_shapes().map(copy).collect()
}

/// Moves shapes that are to be added in the direction of X, all by the same way, until none of them
/// stands where one like it stands already, and then past the figures in which they would stand there.
pub fn set_apart(session: &Session, shapes: &mut [NewShape]) {
    /// Gap between a shape and its copy, relative to the width of both.
    const GAP: f32 = 0.1;
    /// Distance, relative to that width, below which two shapes of a kind look like one.
    const TOO_NEAR: f32 = 0.01;
    let there = session.scene().shapes();
    let bounds = bounds_of(shapes);
    let width = if bounds.is_empty() {
        1.0
    } else {
        bounds.size().x
    };
    let is_taken = |beside: Vec3| {
        shapes.iter().any(|shape| {
            let place = shape.placement.transform.position + beside;
            there.iter().any(|other| {
                let off = other.placement.transform.position - place;
                is_alike(shape, other) && off.length() < width * TOO_NEAR
            })
        })
    };
    // Each shape takes at most one place of each new one, so one of these is free.
    let most = there.len() * shapes.len() + 1;
    let step = Vec3::X * width * (1.0 + GAP);
    let mut places = (0..=most).map(|count| step * count as f32);
    let mut beside = places.find(|&place| !is_taken(place)).unwrap_or(step);
    if beside != Vec3::ZERO {
        let figures = figures_of(session);
        beside += way_out(&moved(&bounds, beside), &figures, Vec3::X);
    }
    for shape in shapes {
        shape.placement.transform.position += beside;
        shape.start.transform.position += beside;
    }
}

/// Whether two shapes look alike but for their places: of one kind, or from one file.
fn is_alike(one: &NewShape, other: &Shape) -> bool {
    let is_from_one_file = one.source.is_some() && one.source == other.source;
    one.kind == other.kind || is_from_one_file
}

fn copy(shape: &Shape) -> NewShape {
    NewShape {
        name: shape.name.clone(),
        kind: shape.kind.clone(),
        source: shape.source.clone(),
        placement: shape.placement,
        start: shape.start,
        visible: shape.visible,
        locked: shape.locked,
    }
}
