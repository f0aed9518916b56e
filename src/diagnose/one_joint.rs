//! Mistakes in one line of a skeleton: a joint that hangs on a wrong parent, or has a wrong offset.

use super::as_good;
use super::formula::{Formula, OtherJoint};
use super::found_otherwise::{ONE_WRONG_OFFSET, ONE_WRONG_PARENT};
use super::made_alone::MadeAlone;
use super::mistake::Mistake;
use super::search::Explanation;
use super::skin::Skinner;
use crate::steps::Pace;
use glam::{DMat3, DVec3};

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
/// Lines that are told where several give the same mesh.
const TOLD: usize = 3;

/// The mistakes in one line of the skeleton that give the mesh, of this size.
pub(super) async fn find(alone: &MadeAlone<'_>, size: f64, pace: &Pace) -> Vec<Explanation> {
    let lines = Lines(alone);
    let joints = lines.joints();
    let parents = lines.wrong_parents(&joints, size, pace).await;
    let offsets = lines.wrong_offsets(&joints, size, pace).await;
    parents.into_iter().chain(offsets).collect()
}

/// The lines of a skeleton, which are tried.
struct Lines<'a>(&'a MadeAlone<'a>);

impl Lines<'_> {
    /// The joints whose line may be wrong: those that move, by themselves or by what hangs on them, all that is off.
    fn joints(&self) -> Vec<usize> {
        let model = self.0.search.model;
        let off = &self.0.off;
        if self.0.has_many_joints() || off.len() < FEWEST_OFF {
            return Vec::new();
        }
        let moves = |joint: usize, vertex: usize| {
            let mut moving = self.0.moving(vertex);
            moving.any(|one| model.hangs_on(one, joint))
        };
        let by_depth = model.by_depth.iter().copied();
        by_depth
            .filter(|&joint| off.iter().all(|&vertex| moves(joint, vertex)))
            .collect()
    }

    /// A skinner of the formula, but for one joint.
    fn skinner(&self, other: OtherJoint) -> Skinner<'_> {
        let formula = self.formula_with(other);
        Skinner::new(self.0.search.model, self.0.search.pose, &formula)
    }

    fn formula_with(&self, other: OtherJoint) -> Formula {
        Formula {
            other_joint: Some(other),
            ..self.0.formula()
        }
    }

    /// An explanation of the mesh by `other`, if that gives it.
    async fn explained(
        &self,
        other: OtherJoint,
        mistake: &'static Mistake,
        pace: &Pace,
    ) -> Option<Explanation> {
        (self.0)
            .given_by(&self.formula_with(other), mistake, pace)
            .await
    }

    /// The wrong parents that give the mesh, as one explanation.
    async fn wrong_parents(&self, joints: &[usize], size: f64, pace: &Pace) -> Option<Explanation> {
        let model = self.0.search.model;
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
        let mut good: Vec<OtherJoint> = good.map(|(_, other)| *other).collect();
        // Stable: a line is mistaken for one near by.
        good.sort_by_key(|other| self.steps_from_parent(*other));
        let told = good.iter().take(TOLD);
        let told = told.map(|other| self.on_another_parent(*other));
        let told: Vec<String> = told.chain(others(good.len(), "on")).collect();
        let (mut explanation, _) = found.swap_remove(0);
        explanation.how = Some(told.join(", or "));
        Some(explanation)
    }

    /// The wrong offsets that give the mesh, as one explanation, the plainest first: where a joint is not turned, its own
    /// offset and those of the joints that hang on it are as good as each other.
    async fn wrong_offsets(&self, joints: &[usize], size: f64, pace: &Pace) -> Option<Explanation> {
        let mut found = Vec::new();
        for &joint in joints {
            let own = &self.0.search.model.skeleton().joints()[joint];
            let Some((off, is_ambiguous)) = self.off_by(joint) else {
                continue;
            };
            let other = OtherJoint {
                joint,
                parent: own.parent,
                offset: own.offset.as_dvec3() + off,
            };
            let explained = self.explained(other, &ONE_WRONG_OFFSET, pace).await;
            found.extend(explained.map(|explanation| (explanation, other, is_ambiguous)));
        }
        found.sort_by(|(a, ..), (b, ..)| a.error.total_cmp(&b.error));
        let enough = as_good(found.first()?.0.error, size);
        let good = found.iter().filter(|(one, ..)| one.error <= enough);
        let mut good: Vec<(OtherJoint, bool)> = good.map(|(_, other, is)| (*other, *is)).collect();
        good.sort_by_key(|(other, _)| (self.strange_numbers(*other), other.joint));
        let told = good.iter().take(TOLD).map(|(other, is_ambiguous)| {
            let told = self.with_another_offset(*other);
            match is_ambiguous {
                true => format!("{told}, or another that gives the same in this pose"),
                false => told,
            }
        });
        let told: Vec<String> = told.chain(others(good.len(), "of")).collect();
        let (mut explanation, ..) = found.swap_remove(0);
        explanation.how = Some(told.join(", or "));
        Some(explanation)
    }

    /// How many numbers of an offset are neither those of the file nor what a slip makes of them: 0, the same with the other
    /// sign, or the number of another axis.
    fn strange_numbers(&self, other: OtherJoint) -> usize {
        let real = self.0.search.model.skeleton().joints()[other.joint].offset;
        let real = real.to_array().map(|number| rounded(f64::from(number)));
        let is_strange = |number: &f64| {
            let number = rounded(*number);
            number != 0.0 && real.iter().all(|real| number.abs() != real.abs())
        };
        let numbers = other.offset.to_array();
        numbers.iter().filter(|number| is_strange(number)).count()
    }

    /// What must be added to the offset of `joint` so that the mesh comes nearest, by least squares, and whether more
    /// can be added along a line without a difference, as where a joint is turned about one axis; then it is what
    /// changes the fewest numbers. `None` if the pose does not show it. A vertex moves in proportion to what is added,
    /// along each axis by itself.
    fn off_by(&self, joint: usize) -> Option<(DVec3, bool)> {
        let own = &self.0.search.model.skeleton().joints()[joint];
        let offset = own.offset.as_dvec3();
        let mut along = DVec3::AXES.map(|axis| {
            self.skinner(OtherJoint {
                joint,
                parent: own.parent,
                offset: offset + axis,
            })
        });
        let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
        for (&vertex, before) in self.0.search.sample.iter().zip(&self.0.at_sample) {
            if before.is_unweighted {
                continue;
            }
            let moved = along
                .each_mut()
                .map(|skinner| skinner.place(vertex).at - before.at);
            let moved = DMat3::from_cols_array_2d(&moved.map(|column| column.to_array()));
            matrix += moved.transpose() * moved;
            right += moved.transpose() * (self.0.search.theirs[vertex] - before.at);
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

    /// Number of joints on the way from the right parent to the wrong one.
    fn steps_from_parent(&self, other: OtherJoint) -> usize {
        let joints = self.0.search.model.skeleton().joints();
        let up = |joint: Option<usize>| {
            let line = std::iter::successors(joint, |&joint| joints[joint].parent);
            line.map(Some).chain([None]).collect::<Vec<_>>()
        };
        let (wrong, right) = (up(other.parent), up(joints[other.joint].parent));
        let common = wrong.iter().rev().zip(right.iter().rev());
        let common = common.take_while(|(a, b)| a == b).count();
        wrong.len() + right.len() - 2 * common
    }

    fn on_another_parent(&self, other: OtherJoint) -> String {
        let real = self.0.search.model.skeleton().joints()[other.joint].parent;
        let [joint, parent, real] =
            [Some(other.joint), other.parent, real].map(|joint| self.0.named(joint));
        format!("{joint} on {parent} instead of {real}")
    }

    fn with_another_offset(&self, other: OtherJoint) -> String {
        let real = self.0.search.model.skeleton().joints()[other.joint].offset;
        let [offset, real] = [other.offset, real.as_dvec3()].map(|offset| {
            let [x, y, z] = offset.to_array().map(rounded);
            format!("({x}, {y}, {z})")
        });
        let joint = self.0.named(Some(other.joint));
        format!("{joint} {offset} instead of {real}")
    }
}

/// How many more than those that are told give the same, if more do.
fn others(count: usize, on: &str) -> Option<String> {
    let more = count.saturating_sub(TOLD);
    let others = if more == 1 { "other" } else { "others" };
    (more > 0).then(|| format!("{on} {more} {others} that give the same in this pose"))
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
