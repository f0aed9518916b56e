//! Skinning by any formula, in double precision.

use super::choices::choices;
use super::formula::{Factors, Formula, Kept, Rescaled, Rounded, Rows, WeightFormula};
use super::joint_transforms::Joints;
use super::model::Model;
use crate::character::{Influence, Pose};
use glam::{DMat3, DMat4, DVec3, DVec4, Vec4Swizzles};
use std::borrow::Cow;

/// Skins the vertices of a character by a formula, one at a time.
#[derive(Debug)]
pub(super) struct Skinner<'a> {
    model: &'a Model<'a>,
    formula: Formula,
    /// What moves vertices, by the index that a weight has; `None` for an index without a joint.
    palette: Vec<Option<DMat4>>,
    /// What the joint of the first weight does to a vertex before all of them, if that is so.
    of_first: Option<Vec<Option<DMat4>>>,
    kept: Vec<(usize, f64)>,
}

/// Where a formula puts a vertex, in model space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placed {
    pub(super) at: DVec3,
    /// Whether the vertex has no weights at all, of which the sum is the origin: programs leave it
    /// there or at rest.
    pub(super) is_unweighted: bool,
}

/// How it is told how far theirs are from a place of ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Metric {
    /// In a straight line.
    Straight,
    /// By the coordinate that differs most, as rounding moves each by itself.
    ByCoordinate,
    /// The same from the middle of all numbers that have the digits of theirs when others are cut off.
    ByCutCoordinate(CutOff),
}

/// Digits that are cut off instead of rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CutOff {
    /// Whether that makes numbers smaller, and not only nearer to 0.
    pub(super) is_down: bool,
    /// Half a unit of the last digit that is left.
    pub(super) half_step: f64,
}

impl CutOff {
    /// How far `ours` is from the middle of the numbers that become `theirs`.
    fn apart(self, ours: f64, theirs: f64) -> f64 {
        let more = ours - theirs;
        if theirs == 0.0 && !self.is_down {
            // Those are twice as many.
            (more.abs() - self.half_step).max(0.0)
        } else if theirs < 0.0 && !self.is_down {
            (more + self.half_step).abs()
        } else {
            (more - self.half_step).abs()
        }
    }
}

impl Metric {
    pub(super) fn between(self, ours: DVec3, theirs: DVec3) -> f64 {
        let largest = |apart: DVec3| match apart.is_nan() {
            true => f64::NAN,
            false => apart.abs().max_element(),
        };
        match self {
            Self::Straight => ours.distance(theirs),
            Self::ByCoordinate => largest(ours - theirs),
            Self::ByCutCoordinate(cut_off) => {
                let [ours, theirs] = [ours, theirs].map(|place| place.to_array());
                largest(DVec3::from_array(
                    [0, 1, 2].map(|axis| cut_off.apart(ours[axis], theirs[axis])),
                ))
            }
        }
    }
}

impl Placed {
    /// How far `theirs` is from it in a straight line; infinite if that is no place.
    pub(super) fn distance(self, theirs: DVec3) -> f64 {
        self.distance_by(Metric::Straight, theirs)
    }

    pub(super) fn distance_by(self, metric: Metric, theirs: DVec3) -> f64 {
        let mut distance = metric.between(self.at, theirs);
        if self.is_unweighted {
            distance = distance.min(metric.between(DVec3::ZERO, theirs));
        }
        if distance.is_nan() {
            f64::INFINITY
        } else {
            distance
        }
    }
}

impl<'a> Skinner<'a> {
    pub(super) fn new(model: &'a Model<'a>, pose: &Pose, formula: &Formula) -> Self {
        Self::after(model, &[], pose, formula)
    }

    /// The same where joints turn on from the rotations that they were given in the poses `before`.
    pub(super) fn after(
        model: &'a Model<'a>,
        before: &[&Pose],
        pose: &Pose,
        formula: &Formula,
    ) -> Self {
        let joints = Joints::after(model, before, pose, formula);
        Self {
            model,
            palette: joints.palette(formula),
            of_first: joints.of_first(formula),
            formula: formula.clone(),
            kept: Vec::new(),
        }
    }

    /// Number of vertices that it writes.
    pub(super) fn count(&self) -> usize {
        self.model.count(self.formula.vertex_order)
    }

    /// What turns and stretches the surface at the vertex at `index` of those that it writes: the
    /// weighted sum without the translations.
    pub(super) fn linear(&mut self, index: usize) -> DMat3 {
        let source = self.model.source(self.formula.vertex_order, index);
        let influences = self
            .model
            .influences_by(self.formula.weights.rows, source.weights);
        let influences = self.counted(influences);
        let written = DMat3::from_diagonal(DVec3::from_array(self.formula.written));
        if influences.is_empty() || self.formula.factors == Factors::Nothing {
            return written;
        }
        self.keep(&influences);
        let parts = self
            .kept
            .iter()
            .filter_map(|&(index, weight)| Some(DMat3::from_mat4(self.palette[index]?) * weight));
        let begun = DMat3::IDENTITY * self.begun(&self.kept);
        let before = DMat3::from_mat4(self.before_all(&self.kept));
        let once = parts.fold(begun, |sum, part| sum + part * before);
        let moved = if self.formula.moves_twice {
            once * once
        } else {
            once
        };
        written * moved
    }

    /// The vertex at `index` of those that it writes.
    pub(super) fn place(&mut self, index: usize) -> Placed {
        let source = self.model.source(self.formula.vertex_order, index);
        let bind = self.model.positions[source.position];
        let influences = self
            .model
            .influences_by(self.formula.weights.rows, source.weights);
        let is_unweighted = influences.is_empty();
        let at = if is_unweighted || self.formula.factors == Factors::Nothing {
            bind
        } else {
            self.keep(&self.counted(influences));
            self.sum(bind, &self.kept)
        };
        Placed {
            at: at * DVec3::from_array(self.formula.written),
            is_unweighted,
        }
    }

    /// The weights of a vertex of which some are kept.
    fn counted(&self, influences: &'a [Influence]) -> Cow<'a, [Influence]> {
        if !self.formula.weights.unused_first {
            return Cow::Borrowed(influences);
        }
        let is_used = |one: &&Influence| self.palette[one.joint as usize].is_some();
        influences.iter().filter(is_used).copied().collect()
    }

    /// Keeps the weights of a vertex that count.
    fn keep(&mut self, influences: &[Influence]) {
        keep(influences, self.formula.weights, &mut self.kept);
        // Only here it is known which columns are taken for no joint.
        if self.formula.weights.rescaled == Rescaled::ToOneOfUsed {
            self.kept
                .retain(|&(index, _)| self.palette[index].is_some());
            scale_to(self.formula.weights.factor, &mut self.kept);
        }
    }

    /// Where the weighted sum has `bind`, or what comes of it the second time.
    fn sum(&self, bind: DVec3, weights: &[(usize, f64)]) -> DVec3 {
        let once = self.sum_once(bind, weights);
        if self.formula.moves_twice {
            self.sum_once(once, weights)
        } else {
            once
        }
    }

    /// The weighted sum of where joints move `bind`, from where the formula begins it.
    fn sum_once(&self, bind: DVec3, weights: &[(usize, f64)]) -> DVec3 {
        let divided = self.formula.divided;
        let vertex = self.before_all(weights) * bind.extend(1.0);
        let moved = weights.iter().filter_map(|&(index, weight)| {
            Some(divided.each(self.palette[index]? * vertex) * weight)
        });
        let sum: DVec4 = moved.sum();
        let begun = bind * self.begun(weights);
        begun + sum.xyz() * divided.factor(sum)
    }

    /// What comes to a vertex with these `weights` before the matrices of its joints.
    fn before_all(&self, weights: &[(usize, f64)]) -> DMat4 {
        let of_first = self.of_first.as_ref().zip(weights.first());
        of_first
            .and_then(|(matrices, &(index, _))| matrices[index])
            .unwrap_or_default()
    }

    /// How many times the vertex at rest is in what the sum of these `weights` begins with.
    fn begun(&self, weights: &[(usize, f64)]) -> f64 {
        let sum = weights.iter().map(|(_, weight)| weight).sum();
        self.formula.begun.times(sum)
    }

    /// How far `theirs` is from the vertex at `index` of those that it writes; from the nearest place where programs
    /// have it that differ in which of equal weights they keep, or in what they take beyond an end of the weights.
    pub(super) fn distance(&mut self, index: usize, theirs: DVec3, metric: Metric) -> f64 {
        let usual = self.place(index).distance_by(metric, theirs);
        let weights = self.formula.weights;
        let is_one_way = weights.rows == Rows::Exact
            && !matches!(weights.kept, Kept::Largest(_))
            && !matches!(weights.rounded, Rounded::ToDigits(..));
        if is_one_way || self.formula.factors == Factors::Nothing {
            return usual;
        }
        let source = self.model.source(self.formula.vertex_order, index);
        let bind = self.model.positions[source.position];
        let written = DVec3::from_array(self.formula.written);
        let own = self.model.influences_by(weights.rows, source.weights);
        let beyond = self.model.rows_beyond(weights.rows, source.weights);
        let beyond = beyond.into_iter().map(|row| self.model.influences(row));
        let rows = [own].into_iter().chain(beyond);
        let weighted = rows.filter(|row| !row.is_empty());
        let kept = weighted.flat_map(|row| choices(&self.counted(row), weights));
        let places = kept.map(|kept| self.sum(bind, &kept) * written);
        let distances = places.map(|place| metric.between(place, theirs));
        // What is no number is no nearer.
        distances.fold(usual, f64::min)
    }
}

/// Index of the root, which comes first in a file.
const ROOT: usize = 0;

/// The weights of a vertex that count, in `kept`.
pub(super) fn keep(influences: &[Influence], formula: WeightFormula, kept: &mut Vec<(usize, f64)>) {
    kept.clear();
    let of_file = influences.iter();
    kept.extend(of_file.map(|one| {
        let weight = formula.rounded.weight(f64::from(one.weight));
        (one.joint as usize, weight)
    }));
    if formula.is_normalized {
        scale_to(1.0, kept);
    }
    if formula.is_completed {
        kept.push((ROOT, 1.0 - sum(kept)));
    }
    let (count, sum_of_all) = (kept.len(), sum(kept));
    match formula.kept {
        Kept::All => {}
        // Stable: equals stay in order.
        Kept::Largest(most) => {
            kept.sort_by(|a, b| b.1.total_cmp(&a.1));
            kept.truncate(most);
        }
        Kept::First(most) => kept.truncate(most),
        Kept::BeforeZero => {
            // The first column is that of joint 1.
            let columns = kept.iter().zip(1..);
            let before =
                columns.take_while(|((joint, weight), column)| joint == column && *weight != 0.0);
            let before = before.count();
            kept.truncate(before);
        }
        Kept::From(least) => {
            let least = f64::from(least as f32);
            kept.retain(|(_, weight)| *weight >= least);
        }
    }
    match formula.rescaled {
        Rescaled::No => {}
        Rescaled::ToOneWhereCut if kept.len() == count => {}
        Rescaled::ToOne | Rescaled::ToOneOfUsed | Rescaled::ToOneWhereCut => scale_to(1.0, kept),
        Rescaled::ToSumOfAll => scale_to(sum_of_all, kept),
        Rescaled::ToOnes => each(kept, |_| 1.0),
        Rescaled::ToMean => each(kept, |_| 1.0 / count as f64),
        Rescaled::ByCount => each(kept, |weight| weight / count as f64),
    }
    if formula.is_overwritten {
        let last = kept.iter().copied().max_by_key(|(joint, _)| *joint);
        kept.clear();
        kept.extend(last);
    }
    for (_, weight) in kept {
        *weight *= formula.factor;
    }
}

/// Sets every weight to what comes of it.
fn each(weights: &mut [(usize, f64)], set: impl Fn(f64) -> f64) {
    for (_, weight) in weights {
        *weight = set(*weight);
    }
}

fn sum(weights: &[(usize, f64)]) -> f64 {
    weights.iter().map(|(_, weight)| weight).sum()
}

/// Scales weights so that they sum to `total`, unless they cancel each other.
fn scale_to(total: f64, weights: &mut [(usize, f64)]) {
    let sum = sum(weights);
    if sum != 0.0 {
        for (_, weight) in weights {
            *weight *= total / sum;
        }
    }
}
