//! Mistakes at single joints: a joint that hangs on a wrong parent, or has a wrong offset, a root that is turned before it is
//! moved, two that have each other's weights. They are sought only where no mistake of a whole program gives the mesh, since
//! one joint can be off in so many ways.

use super::as_good;
use super::formula::{Columns, Formula, OtherJoint, VertexOrder};
use super::found_otherwise::{
    JOINT_LEFT_OUT, ONE_WRONG_OFFSET, ONE_WRONG_PARENT, ROOT_ROTATED_FIRST, STACK_NOT_POPPED,
    SUM_BEGUN_AT_REST, WEIGHTS_EXCHANGED,
};
use super::mistakes::{Mistake, Reading};
use super::search::{Explanation, Made, Search};
use super::skin::{Placed, Skinner};
use crate::steps::Pace;
use glam::{DMat3, DVec3};
use std::collections::BTreeSet;

/// Joints of the largest skeletons that are tried: every joint above what is off is hung on every other.
const MOST_JOINTS: usize = 256;
/// Vertices that must be off: the offset of a joint that moves fewer would give them any place.
const FEWEST_OFF: usize = 4;
/// What is left of a direction in which the pose hardly shows an offset, by the one in which it shows it best. An
/// offset is taken as right there.
const HARDLY_SHOWN: f64 = 1e-9;
/// What is left of a direction in which the pose does not show an offset, by all directions.
const NOT_SHOWN: f64 = 1e-6;
/// Share of a direction along an axis below which nothing is moved along that axis to get rid of a change.
const HARDLY_ALONG: f64 = 0.05;
/// Steps after which a direction is found among three.
const STEPS_OF_POWER: usize = 30;
/// Parents that are told where several give the same mesh.
const TOLD: usize = 3;

/// The only way to make such a mistake, which is told in words of its own.
static IN_THE_FILE: Reading = Reading {
    how: "",
    make: |_| {},
};

/// The mistakes in one line of the skeleton that give the mesh of `search`, which has its vertices in `order` and is
/// held against `exact`.
pub(super) async fn find(
    search: &Search<'_>,
    order: VertexOrder,
    exact: &[Placed],
    size: f64,
    pace: &Pace,
) -> Vec<Explanation> {
    let lines = Lines {
        search,
        order,
        exact,
    };
    let joints = lines.joints();
    if let Some(whole) = lines.whole_program(pace).await {
        return vec![whole];
    }
    let mut of_weights = lines.exchanged_weights(pace).await;
    of_weights.extend(lines.left_out(pace).await);
    if !of_weights.is_empty() {
        return of_weights;
    }
    let parents = lines.wrong_parents(&joints, size, pace).await;
    let offsets = lines.wrong_offsets(&joints, pace).await;
    parents.into_iter().chain(offsets).collect()
}

/// A skeleton whose lines are tried.
struct Lines<'a> {
    search: &'a Search<'a>,
    order: VertexOrder,
    exact: &'a [Placed],
}

impl Lines<'_> {
    /// Vertices of the sample that are off.
    fn off(&self) -> Vec<usize> {
        let off = |&&vertex: &&usize| {
            self.exact[vertex].distance(self.search.theirs[vertex]) > self.search.tolerance
        };
        self.search.sample.iter().filter(off).copied().collect()
    }

    /// A mistake of the whole program that is hardly ever made beside another one, if one gives the mesh: roots that are
    /// turned before they are moved, a stack that is not popped, a sum that begins with the vertex.
    async fn whole_program(&self, pace: &Pace) -> Option<Explanation> {
        let with = |change: &dyn Fn(&mut Formula)| {
            let mut formula = self.formula();
            change(&mut formula);
            formula
        };
        let visited = |in_each| with(&|formula| formula.hangs_on_visited = in_each);
        for (formula, mistake, how) in [
            (
                with(&|formula| formula.joint.roots_rotate_first = true),
                &ROOT_ROTATED_FIRST,
                None,
            ),
            (visited([true; 2]), &STACK_NOT_POPPED, Some("in T and in B")),
            (visited([true, false]), &STACK_NOT_POPPED, Some("in T")),
            (visited([false, true]), &STACK_NOT_POPPED, Some("in B")),
            (
                with(&|formula| formula.begins_at_rest = true),
                &SUM_BEGUN_AT_REST,
                None,
            ),
        ] {
            if let Some(given) = self.given_by(&formula, mistake, pace).await {
                return Some(Explanation {
                    how: how.map(str::to_owned),
                    ..given
                });
            }
        }
        None
    }

    /// Joints whose weights are left out, where that gives the mesh.
    async fn left_out(&self, pace: &Pace) -> Vec<Explanation> {
        let model = self.search.model;
        let off = self.off();
        let Some(&first) = off.first() else {
            return Vec::new();
        };
        let moving = |vertex: usize| {
            let row = model.source(self.order, vertex).weights;
            model.influences(row).iter().map(|one| one.joint as usize)
        };
        let mut found = Vec::new();
        for joint in moving(first) {
            if !off
                .iter()
                .all(|&vertex| moving(vertex).any(|one| one == joint))
            {
                continue;
            }
            let mut formula = self.formula();
            formula.weights.columns = Columns::Without(joint);
            let given = self.given_by(&formula, &JOINT_LEFT_OUT, pace).await;
            found.extend(given.map(|explanation| Explanation {
                how: Some(self.named(Some(joint))),
                ..explanation
            }));
        }
        found
    }

    /// Joints that have each other's weights, where that gives the mesh.
    async fn exchanged_weights(&self, pace: &Pace) -> Vec<Explanation> {
        let model = self.search.model;
        let joints = model.skeleton().joints();
        let off = self.off();
        let Some(&first) = off.first().filter(|_| joints.len() <= MOST_JOINTS) else {
            return Vec::new();
        };
        let moving = |vertex: usize| {
            let row = model.source(self.order, vertex).weights;
            model.influences(row).iter().map(|one| one.joint as usize)
        };
        let mut found = Vec::new();
        let mut tried = BTreeSet::new();
        for one in moving(first) {
            for other in 0..joints.len() {
                let pair = (one.min(other), one.max(other));
                let is_one = |joint: usize| joint == one || joint == other;
                let may_be = one != other && off.iter().all(|&vertex| moving(vertex).any(is_one));
                if !may_be || !tried.insert(pair) {
                    continue;
                }
                let mut formula = self.formula();
                formula.weights.columns = Columns::Exchanged(one, other);
                let given = self.given_by(&formula, &WEIGHTS_EXCHANGED, pace).await;
                let [one, other] = [pair.0, pair.1].map(|joint| self.named(Some(joint)));
                found.extend(given.map(|explanation| Explanation {
                    how: Some(format!("{one} and {other}")),
                    ..explanation
                }));
            }
        }
        found
    }

    /// An explanation of the mesh by a formula, if that gives it.
    async fn given_by(
        &self,
        formula: &Formula,
        mistake: &'static Mistake,
        pace: &Pace,
    ) -> Option<Explanation> {
        let made = Made {
            mistake,
            reading: &IN_THE_FILE,
        };
        let mut skinner = Skinner::new(self.search.model, self.search.pose, formula);
        (self.search)
            .explained_by(&mut skinner, vec![made], pace)
            .await
    }

    /// The exact formula for vertices in this order.
    fn formula(&self) -> Formula {
        Formula {
            vertex_order: self.order,
            ..Formula::default()
        }
    }

    /// The joints whose line may be wrong: those that move, by themselves or by what hangs on them, all that is off.
    fn joints(&self) -> Vec<usize> {
        let model = self.search.model;
        let joints = model.skeleton().joints().len();
        let off = self.off();
        if joints > MOST_JOINTS || off.len() < FEWEST_OFF {
            return Vec::new();
        }
        let moves = |joint: usize, vertex: usize| {
            let row = model.source(self.order, vertex).weights;
            let mut influences = model.influences(row).iter();
            influences.any(|one| model.hangs_on(one.joint as usize, joint))
        };
        let by_depth = model.by_depth.iter().copied();
        by_depth
            .filter(|&joint| off.iter().all(|&vertex| moves(joint, vertex)))
            .collect()
    }

    /// A skinner of the exact formula, but for one joint.
    fn skinner(&self, other: OtherJoint) -> Skinner<'_> {
        let formula = self.formula_with(other);
        Skinner::new(self.search.model, self.search.pose, &formula)
    }

    fn formula_with(&self, other: OtherJoint) -> Formula {
        Formula {
            other_joint: Some(other),
            ..self.formula()
        }
    }

    /// An explanation of the mesh by `other`, if that gives it.
    async fn explained(
        &self,
        other: OtherJoint,
        mistake: &'static Mistake,
        pace: &Pace,
    ) -> Option<Explanation> {
        self.given_by(&self.formula_with(other), mistake, pace)
            .await
    }

    /// The wrong parents that give the mesh, as one explanation.
    async fn wrong_parents(&self, joints: &[usize], size: f64, pace: &Pace) -> Option<Explanation> {
        let model = self.search.model;
        let all = model.skeleton().joints();
        let mut found = Vec::new();
        for &joint in joints {
            let others = (0..all.len()).filter(|&other| !model.hangs_on(other, joint));
            for parent in others.map(Some).chain([None]) {
                if parent == all[joint].parent {
                    continue;
                }
                let other = OtherJoint {
                    joint,
                    parent,
                    offset: all[joint].offset.as_dvec3(),
                };
                let explained = self.explained(other, &ONE_WRONG_PARENT, pace).await;
                found.extend(explained.map(|explanation| (explanation, other)));
            }
        }
        found.sort_by(|(a, _), (b, _)| a.error.total_cmp(&b.error));
        let least = found.first()?.0.error;
        let enough = as_good(least, size);
        let good = found.iter().filter(|(one, _)| one.error <= enough);
        let told: Vec<String> = good
            .map(|(_, other)| self.on_another_parent(*other))
            .take(TOLD)
            .collect();
        let (mut explanation, _) = found.swap_remove(0);
        explanation.how = Some(told.join(", or "));
        Some(explanation)
    }

    /// The wrong offset that gives the mesh, of the joint with which it agrees best.
    async fn wrong_offsets(&self, joints: &[usize], pace: &Pace) -> Option<Explanation> {
        let mut best: Option<Explanation> = None;
        for &joint in joints {
            let own = &self.search.model.skeleton().joints()[joint];
            let Some((off, is_ambiguous)) = self.off_by(joint) else {
                continue;
            };
            let other = OtherJoint {
                joint,
                parent: own.parent,
                offset: own.offset.as_dvec3() + off,
            };
            let explained = self.explained(other, &ONE_WRONG_OFFSET, pace).await;
            let known = best.as_ref().map_or(f64::INFINITY, |best| best.error);
            if let Some(explained) = explained.filter(|explained| explained.error < known) {
                let mut how = self.with_another_offset(other);
                if is_ambiguous {
                    how.push_str(", or another that gives the same in this pose");
                }
                best = Some(Explanation {
                    how: Some(how),
                    ..explained
                });
            }
        }
        best
    }

    /// What must be added to the offset of `joint` so that the mesh comes nearest, by least squares, and whether more
    /// can be added along a line without a difference, as where a joint is turned about one axis; then it is what
    /// changes the fewest numbers. `None` if the pose does not show it. A vertex moves in proportion to what is added,
    /// along each axis by itself.
    fn off_by(&self, joint: usize) -> Option<(DVec3, bool)> {
        let own = &self.search.model.skeleton().joints()[joint];
        let offset = own.offset.as_dvec3();
        let mut along = DVec3::AXES.map(|axis| {
            self.skinner(OtherJoint {
                joint,
                parent: own.parent,
                offset: offset + axis,
            })
        });
        let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
        for &vertex in &self.search.sample {
            let exact = self.exact[vertex];
            if exact.is_unweighted {
                continue;
            }
            let moved = along
                .each_mut()
                .map(|skinner| skinner.place(vertex).at - exact.at);
            let moved = DMat3::from_cols_array_2d(&moved.map(|column| column.to_array()));
            matrix += moved.transpose() * moved;
            right += moved.transpose() * (self.search.theirs[vertex] - exact.at);
        }
        let shown = matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z;
        let raised = matrix + DMat3::from_diagonal(DVec3::splat(shown * HARDLY_SHOWN));
        let inverse = raised.inverse();
        let off = inverse * right;
        if !(shown > 0.0 && off.is_finite()) {
            return None;
        }
        // The direction that shows least, which the inverse makes longest.
        let along = (0..STEPS_OF_POWER).fold(DVec3::new(0.6, 0.64, 0.48), |along, _| {
            (inverse * along).normalize_or_zero()
        });
        let is_ambiguous = (matrix * along).length() < shown * NOT_SHOWN;
        let off = if is_ambiguous {
            fewest_changes(off, along)
        } else {
            off
        };
        Some((off, is_ambiguous))
    }

    fn on_another_parent(&self, other: OtherJoint) -> String {
        let real = self.search.model.skeleton().joints()[other.joint].parent;
        let [joint, parent, real] =
            [Some(other.joint), other.parent, real].map(|joint| self.named(joint));
        format!("{joint} on {parent} instead of {real}")
    }

    fn with_another_offset(&self, other: OtherJoint) -> String {
        let real = self.search.model.skeleton().joints()[other.joint].offset;
        let [offset, real] = [other.offset, real.as_dvec3()].map(|offset| {
            let [x, y, z] = offset.to_array().map(rounded);
            format!("({x}, {y}, {z})")
        });
        let joint = self.named(Some(other.joint));
        format!("{joint} {offset} instead of {real}")
    }

    /// A joint by name and index, as the file counts them.
    fn named(&self, joint: Option<usize>) -> String {
        match joint {
            Some(index) => {
                let name = &self.search.model.skeleton().joints()[index].name;
                format!("{name} ({index})")
            }
            None => "no joint".to_owned(),
        }
    }
}

/// Of `off` and what differs from it by a multiple of `along`, what has the most zeros, and of those the shortest.
fn fewest_changes(off: DVec3, along: DVec3) -> DVec3 {
    let with_zero = |axis: usize| {
        let by = off[axis] / along[axis];
        let mut other = off - along * by;
        other[axis] = 0.0;
        (along[axis].abs() > HARDLY_ALONG).then_some(other)
    };
    let others = (0..3).filter_map(with_zero).chain([off]);
    let changes = |off: &DVec3| {
        off.to_array()
            .iter()
            .filter(|by| rounded(**by) != 0.0)
            .count()
    };
    let best = others.min_by(|a, b| {
        let by_length = a.length().total_cmp(&b.length());
        changes(a).cmp(&changes(b)).then(by_length)
    });
    best.unwrap_or(off)
}

/// A coordinate in words, without the digits that a mesh does not tell, and a zero without a sign.
fn rounded(coordinate: f64) -> f64 {
    (coordinate * 1e4).round() / 1e4 + 0.0
}
