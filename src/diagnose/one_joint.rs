//! Mistakes in one line of a skeleton: a joint that hangs on a wrong parent, or has a wrong offset.

use super::as_good;
use super::formula::{Formula, OtherJoint};
use super::found_otherwise::ONE_WRONG_PARENT;
use super::made_alone::MadeAlone;
use super::mistake::Mistake;
use super::search::Explanation;
use super::skin::Skinner;
use crate::steps::Pace;

/// Vertices that must be off: the offset of a joint that moves fewer would give them any place.
const FEWEST_OFF: usize = 4;
/// Lines that are told where several give the same mesh.
pub(super) const TOLD: usize = 3;

/// The mistakes in one line of the skeleton that give the mesh, of this size.
pub(super) async fn find(alone: &MadeAlone<'_>, size: f64, pace: &Pace) -> Vec<Explanation> {
    let lines = Lines(alone);
    let joints = lines.joints();
    let parents = lines.wrong_parents(&joints, size, pace).await;
    let offsets = lines.wrong_offsets(&joints, size, pace).await;
    parents.into_iter().chain(offsets).collect()
}

/// The wrong parents of one joint that give the mesh, of this size.
pub(super) async fn wrong_parents(
    alone: &MadeAlone<'_>,
    size: f64,
    pace: &Pace,
) -> Option<Explanation> {
    let lines = Lines(alone);
    lines.wrong_parents(&lines.joints(), size, pace).await
}

/// The lines of a skeleton, which are tried.
pub(super) struct Lines<'a>(pub(super) &'a MadeAlone<'a>);

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
    pub(super) fn skinner(&self, other: OtherJoint) -> Skinner<'_> {
        let formula = self.formula_with(other);
        Skinner::new(self.0.search.model, self.0.search.pose, &formula)
    }

    pub(super) fn formula_with(&self, other: OtherJoint) -> Formula {
        Formula {
            other_joint: Some(other),
            ..self.0.formula()
        }
    }

    /// An explanation of the mesh by `other`, if that gives it.
    pub(super) async fn explained(
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
}

/// How many more than those that are told give the same, if more do.
pub(super) fn others(count: usize, on: &str) -> Option<String> {
    let more = count.saturating_sub(TOLD);
    let others = if more == 1 { "other" } else { "others" };
    (more > 0).then(|| format!("{on} {more} {others} that give the same in this pose"))
}
