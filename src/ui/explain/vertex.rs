//! The vertex that is explained: which it is, and its formula in numbers.

use super::digits::Digits;
use super::shown::Made;
use super::{ExplainState, Explained};
use crate::diagnose::{Formula, VertexFormula};
use crate::editor::{Session, View};
use crate::math::Aabb;
use crate::revision::Revision;
use crate::scene::{ShapeId, pick_shape};
use crate::ui::Action;
use crate::ui::scene_places::ScenePlaces;
use egui::{Pos2, Response};

/// Number of weights that make a vertex worth explaining, and how large they have to be.
const ENOUGH: usize = 3;
const HEAVY: f32 = 0.1;

/// The formula at work on a vertex, in numbers.
#[derive(Clone, Debug)]
pub(super) struct Told {
    /// Revision of the mesh that it is one of.
    of: Revision,
    made: Option<Made>,
    pub formula: Formula,
    pub vertex: VertexFormula,
    /// Where the exact formula takes the vertex.
    pub exact: VertexFormula,
    /// Number of vertices.
    pub count: usize,
    /// How coordinates are written.
    pub digits: Digits,
}

impl Told {
    /// The formula of `vertex`, with the mistake that is made; `None` if there is no such vertex.
    pub(super) fn new(explained: &Explained, vertex: usize, made: Option<Made>) -> Option<Self> {
        let formula = made.map_or_else(Formula::default, Made::formula);
        let (character, pose) = (&explained.shape.character, explained.shape.pose());
        let told = |formula| VertexFormula::new(character, pose, formula, vertex);
        let positions = &character.bind_mesh().positions;
        let size = Aabb::from_points(positions.iter().copied()).size().length();
        Some(Self {
            of: explained.revision(),
            made,
            vertex: told(&formula)?,
            exact: told(&Formula::default())?,
            formula,
            count: positions.len(),
            digits: Digits::of_size(f64::from(size)),
        })
    }

    /// Whether it is the formula of this vertex in this pose, with this mistake.
    pub(super) fn is_of(&self, explained: &Explained, vertex: usize, made: Option<Made>) -> bool {
        self.of == explained.revision() && self.vertex.vertex == vertex && self.made == made
    }
}

impl ExplainState {
    /// The vertex that is explained: the one that was picked, or one where there is much to see: one that
    /// `joint` moves, or else a joint that the pose turns, and of those with several weights the farthest from the origin.
    pub(super) fn vertex(&mut self, explained: &Explained, joint: Option<usize>) -> usize {
        let attachments = explained.shape.character.attachments();
        let picked = self.picked.filter(|&(shape, vertex)| {
            shape == explained.id && vertex < attachments.vertex_count()
        });
        if let Some((_, vertex)) = picked {
            return vertex;
        }
        let mesh = explained.shape.character.bind_mesh();
        let of = mesh.revision();
        if let Some((_, vertex)) = self.first_vertex.filter(|(known, _)| *known == of) {
            return vertex;
        }
        let positions = &mesh.positions;
        let tells = |vertex: &usize| {
            let influences = attachments.of_vertex(*vertex).iter();
            let heavy = influences.filter(|one| one.weight.abs() >= HEAVY);
            heavy.count().min(ENOUGH)
        };
        let pose = explained.shape.pose();
        let moved_by = |vertex: &usize, is_one: &dyn Fn(usize) -> bool| {
            let mut influences = attachments.of_vertex(*vertex).iter();
            influences.any(|one| is_one(one.joint as usize) && one.weight.abs() >= HEAVY)
        };
        let is_moved = |vertex: &usize| {
            let by_joint = moved_by(vertex, &|one| joint == Some(one));
            (by_joint, moved_by(vertex, &|one| pose.is_changed(one)))
        };
        let far = |vertex: &usize| positions[*vertex].length();
        let most = (0..attachments.vertex_count()).max_by(|a, b| {
            let told = (is_moved(a), tells(a)).cmp(&(is_moved(b), tells(b)));
            told.then(far(a).total_cmp(&far(b)))
        });
        let vertex = most.unwrap_or(0);
        self.first_vertex = Some((of, vertex));
        vertex
    }

    /// Chooses a vertex of a character by its number.
    pub(super) fn choose(&mut self, character: ShapeId, vertex: usize) {
        self.picked = Some((character, vertex));
        self.unfolded.clear();
    }

    /// Picks a vertex of a character in the view or in a comparison.
    pub(in crate::ui) fn pick(&mut self, character: ShapeId, vertex: usize) {
        self.choose(character, vertex);
        self.picks += 1;
    }
}

/// Picks the vertex of a character that is clicked in the view, and selects that character, unless the
/// click is on a bone, which `selects` itself, and beside which the nearest vertex is meant; whether one was. With Ctrl or
/// Shift a click is about the selection alone.
pub(in crate::ui) fn pointer(
    view: &Response,
    places: &ScenePlaces,
    session: &Session,
    state: &mut ExplainState,
    selects: bool,
    actions: &mut Vec<Action>,
) -> bool {
    let adds = view.ctx.input(|i| i.modifiers.command || i.modifiers.shift);
    if !state.takes_clicks() || adds || !view.clicked() {
        return false;
    }
    let clicked = view.interact_pointer_pos();
    let bone = session.hovered_bone().filter(|_| selects);
    let bone = bone.map(|(shape, _)| shape);
    let picked = clicked.and_then(|at| vertex_at(places, session, state, at, bone));
    let Some((shape, vertex)) = picked else {
        return false;
    };
    state.pick(shape, vertex);
    if !selects && session.selected() != Some(shape) {
        actions.push(Action::View(View::Select(Some(shape))));
    }
    true
}

/// The vertex of a character at a point of the window, of the mesh that is shown there, or else of the one with the `bone`
/// there.
fn vertex_at(
    places: &ScenePlaces,
    session: &Session,
    state: &mut ExplainState,
    at: Pos2,
    bone: Option<ShapeId>,
) -> Option<(ShapeId, usize)> {
    let place = places.at(at)?;
    let ray = session.view().camera.ray(place.pixel(at), place.size());
    let mistaken = state.evaluated(session);
    let evaluated = mistaken.as_ref().unwrap_or(session.evaluated());
    let in_model = |id: ShapeId| {
        let shape = evaluated.shape(id)?;
        let ray = ray.transformed(shape.world_from_model.inverse());
        Some((&shape.geometry, ray))
    };
    let met = pick_shape(evaluated, &ray).map(|(id, _)| id);
    let met = met.filter(|&id| session.scene().character(id).is_some());
    let on_mesh = met.and_then(|id| {
        let (geometry, ray) = in_model(id)?;
        Some((id, geometry.nearest_vertex(&ray)?))
    });
    on_mesh.or_else(|| {
        let (geometry, ray) = in_model(bone?)?;
        Some((bone?, geometry.vertex_beside(&ray)?))
    })
}
