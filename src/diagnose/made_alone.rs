//! Mistakes that are sought by themselves where none of those of [`super::mistakes`] gives the mesh: of a whole program,
//! in the weights of one joint or two, and, last, since one joint can be off in so many ways, in one line of the skeleton.

use super::formula::{Columns, Formula, VertexOrder};
use super::found_otherwise::{JOINT_LEFT_OUT, WEIGHTS_EXCHANGED};
use super::joint_list::JointList;
use super::mistake::Mistake;
use super::of_whole_program::PARENTS_MISREAD;
use super::search::{Explanation, Search};
use super::skin::{Placed, Skinner};
use super::ways::{Made, formula};
use super::{one_joint, whole_program};
use crate::character::Influence;
use crate::steps::Pace;
use std::collections::BTreeSet;

/// Joints of the largest skeletons of which every two are tried.
const MOST_JOINTS: usize = 256;

/// The mistakes that give the mesh of `search`, of this size, which has its vertices in `order` and is held against
/// `exact`. Where numbers are worked out from the mesh, it has to agree with it as in `fits`.
pub(super) async fn find(
    search: &Search<'_>,
    fits: &Search<'_>,
    order: VertexOrder,
    exact: &[Placed],
    size: f64,
    pace: &Pace,
) -> Vec<Explanation> {
    let alone = MadeAlone::new(search, order);
    let fits = MadeAlone::new(fits, order);
    let mut of_whole = whole_program::find(&alone, &fits, exact, pace).await;
    if !of_whole.is_empty() {
        // A pose that turns few joints shows few parents, and that one is wrong is no rarer than that all are.
        if of_whole.iter().any(|it| it.ids() == [PARENTS_MISREAD.id]) {
            of_whole.extend(one_joint::wrong_parents(&fits, size, pace).await);
        }
        return of_whole;
    }
    let mut of_weights = alone.exchanged_weights(pace).await;
    of_weights.extend(alone.left_out(pace).await);
    if !of_weights.is_empty() {
        return of_weights;
    }
    one_joint::find(&fits, size, pace).await
}

/// Those of a whole program that give the mesh of `search` as well as another one does, or as none does.
pub(super) async fn as_well(
    search: &Search<'_>,
    order: VertexOrder,
    pace: &Pace,
) -> Vec<Explanation> {
    let alone = MadeAlone::new(search, order);
    whole_program::as_well(&alone, pace).await
}

/// A mesh that one such mistake may give, or one beside another mistake.
pub(super) struct MadeAlone<'a> {
    pub(super) search: &'a Search<'a>,
    /// The other mistake.
    other: Option<Made>,
    /// The formula without the mistake that is sought.
    formula: Formula,
    /// Vertices of the sample that are off from there.
    pub(super) off: Vec<usize>,
    /// Which joint each index of a weight means.
    joints: JointList<'a>,
}

impl<'a> MadeAlone<'a> {
    fn new(search: &'a Search<'a>, order: VertexOrder) -> Self {
        let formula = Formula {
            vertex_order: order,
            ..Formula::default()
        };
        Self::by(search, None, formula)
    }

    /// The same beside another mistake; `None` if that cannot be made of the character.
    pub(super) fn beside(search: &'a Search<'a>, other: Made) -> Option<Self> {
        let formula = formula(&[other]);
        search
            .may_be_of(&formula)
            .then(|| Self::by(search, Some(other), formula))
    }

    fn by(search: &'a Search<'a>, other: Option<Made>, formula: Formula) -> Self {
        let mut skinner = Skinner::new(search.model, search.pose, &formula);
        let sample = search.sample.iter();
        let is_off = |&&vertex: &&usize| search.distance(&mut skinner, vertex) > search.tolerance;
        let off = sample.clone().filter(is_off).copied().collect();
        Self {
            search,
            other,
            off,
            joints: JointList::new(search.model, &formula),
            formula,
        }
    }

    /// Joints whose weights are left out, where that gives the mesh.
    pub(super) async fn left_out(&self, pace: &Pace) -> Vec<Explanation> {
        let mut found = Vec::new();
        for joint in self.moving_first() {
            if !self.moves_all_off(|one| one == joint) {
                continue;
            }
            let given = self.with_columns(Columns::Without(joint), &JOINT_LEFT_OUT, pace);
            found.extend(given.await.map(|explanation| Explanation {
                how: Some(self.named(Some(joint))),
                ..explanation
            }));
        }
        found
    }

    /// Joints that have each other's weights, where that gives the mesh.
    pub(super) async fn exchanged_weights(&self, pace: &Pace) -> Vec<Explanation> {
        if self.has_many_joints() {
            return Vec::new();
        }
        let joints = self.search.model.skeleton().joints().len();
        let mut known = BTreeSet::new();
        let pairs = self.moving_first().flat_map(|one| {
            let others = (0..joints).filter(move |&other| other != one);
            others.map(move |other| (one.min(other), one.max(other)))
        });
        // The root has no column in an .attach file, and a joint that is not turned looks as if it had the root's weights:
        // only joints that move something are tried.
        let moves = &self.search.model.moves;
        let both_move = |(one, other): (usize, usize)| moves[one] && moves[other];
        let pairs: Vec<_> = pairs
            .filter(|&pair| both_move(pair) && known.insert(pair))
            .collect();
        let mut found = Vec::new();
        for (one, other) in pairs {
            if !self.moves_all_off(|joint| joint == one || joint == other) {
                continue;
            }
            let columns = Columns::Exchanged(one, other);
            let given = self.with_columns(columns, &WEIGHTS_EXCHANGED, pace).await;
            let [one, other] = [one, other].map(|joint| self.named(Some(joint)));
            found.extend(given.map(|explanation| Explanation {
                how: Some(format!("{one} and {other}")),
                ..explanation
            }));
        }
        found
    }

    /// Whether so many joints are there that not every two are tried.
    pub(super) fn has_many_joints(&self) -> bool {
        self.search.model.skeleton().joints().len() > MOST_JOINTS
    }

    /// Joints that move `vertex`.
    pub(super) fn moving(&self, vertex: usize) -> impl Iterator<Item = usize> + '_ {
        let influences = self.influences(vertex).iter();
        let columns = self.formula.weights.columns;
        influences.filter_map(move |one| self.joints.joint(columns, one.joint as usize))
    }

    /// Weights of `vertex`.
    pub(super) fn weights(&self, vertex: usize) -> impl Iterator<Item = f32> + '_ {
        self.influences(vertex).iter().map(|one| one.weight)
    }

    fn influences(&self, vertex: usize) -> &[Influence] {
        let model = self.search.model;
        let row = model.source(self.formula.vertex_order, vertex).weights;
        model.influences_by(self.formula.weights.rows, row)
    }

    /// Joints that move the first vertex that is off: one of them is in every mistake with the weights of joints.
    fn moving_first(&self) -> impl Iterator<Item = usize> + '_ {
        let first = self.off.first();
        first.into_iter().flat_map(|&vertex| self.moving(vertex))
    }

    /// Whether every vertex that is off is moved by such a joint.
    fn moves_all_off(&self, is_such: impl Fn(usize) -> bool) -> bool {
        (self.off.iter()).all(|&vertex| self.moving(vertex).any(&is_such))
    }

    /// An explanation of the mesh by weights in other columns, if they give it.
    async fn with_columns(
        &self,
        columns: Columns,
        mistake: &'static Mistake,
        pace: &Pace,
    ) -> Option<Explanation> {
        let mut formula = self.formula();
        formula.weights.columns = columns;
        self.given_by(&formula, mistake, pace).await
    }

    /// An explanation of the mesh by a formula with numbers from the mesh, if that gives it.
    pub(super) async fn given_by(
        &self,
        formula: &Formula,
        mistake: &'static Mistake,
        pace: &Pace,
    ) -> Option<Explanation> {
        self.made_by(formula, Made::by_numbers(mistake), pace).await
    }

    /// The explanation of the mesh by a mistake that is `made`, if the formula gives it.
    pub(super) async fn made_by(
        &self,
        formula: &Formula,
        made: Made,
        pace: &Pace,
    ) -> Option<Explanation> {
        let mut skinner = Skinner::new(self.search.model, self.search.pose, formula);
        let made = self.other.into_iter().chain([made]).collect();
        self.search.explained_by(&mut skinner, made, pace).await
    }

    /// The formula without the mistake that is sought.
    pub(super) fn formula(&self) -> Formula {
        self.formula.clone()
    }

    /// A joint by name and index, as the file counts them.
    pub(super) fn named(&self, joint: Option<usize>) -> String {
        match joint {
            Some(index) => self.search.model.named(index),
            None => "no joint".to_owned(),
        }
    }
}
