//! A joint that has a wrong offset from its parent, which is worked out from the mesh.

use super::as_good;
use super::formula::OtherJoint;
use super::found_otherwise::ONE_WRONG_OFFSET;
use super::one_joint::{Lines, TOLD, others};
use super::search::Explanation;
use crate::steps::Pace;
use glam::{DMat3, DVec3};
use std::ops::RangeInclusive;

/// What is left of a direction in which the pose hardly shows an offset, by the one in which it shows it best. An
/// offset is taken as right there.
const HARDLY_SHOWN: f64 = 1e-9;
/// What is left of a direction in which the pose does not show an offset, by all directions.
const NOT_SHOWN: f64 = 1e-6;
/// Share of a direction along an axis below which nothing is moved along that axis to get rid of a change.
const HARDLY_ALONG: f64 = 0.05;
/// Steps after which a direction is found among three.
const STEPS_OF_POWER: usize = 30;
/// How many times what vertices may be apart and agree an offset may leave that nearly gives the mesh, and its numbers may be
/// from those of the right one.
const NEARLY: f64 = 2.0;
/// Digits after the point of offsets as somebody types them.
const DIGITS_TYPED: RangeInclusive<i32> = 1..=4;
/// Steps that are made at most towards an offset with which all vertices agree, …
const STEPS_OF_RELAXATION: usize = 200;
/// … and the part of what they may be apart that is left to each.
const INSIDE: f64 = 0.999;

/// A vertex that moves with the offset of a joint.
struct Moved {
    /// How far along each axis, by what is added to the offset along that.
    along: DMat3,
    /// From there to where it is in the mesh.
    left: DVec3,
}

/// What must be added to the offset of a joint so that the mesh comes nearest.
struct OffBy {
    /// By least squares.
    by: DVec3,
    /// A line along which more can be added without a difference, if there is one, as where a joint is turned about one
    /// axis.
    along: Option<DVec3>,
}

impl OffBy {
    /// What is left where a number is not changed at all, if others can make up for it, and then itself.
    fn all(&self) -> Vec<DVec3> {
        let without = |along: DVec3, axis: usize| {
            let mut other = self.by - along * (self.by[axis] / along[axis]);
            other[axis] = 0.0;
            (along[axis].abs() > HARDLY_ALONG).then_some(other)
        };
        let lines = self.along.into_iter();
        let others = lines.flat_map(|along| (0..3).filter_map(move |axis| without(along, axis)));
        others.chain([self.by]).collect()
    }
}

/// A joint with another offset that gives the mesh.
struct Found {
    explanation: Explanation,
    other: OtherJoint,
    /// Whether there are more that do.
    is_ambiguous: bool,
}

impl Lines<'_> {
    /// The wrong offsets that give the mesh, as one explanation, the plainest first: where a joint is not turned, its own
    /// offset and those of the joints that hang on it are as good as each other.
    pub(super) async fn wrong_offsets(
        &self,
        joints: &[usize],
        size: f64,
        pace: &Pace,
    ) -> Option<Explanation> {
        let mut found = Vec::new();
        for &joint in joints {
            found.extend(self.wrong_offset(joint, size, pace).await);
        }
        found.sort_by(|a, b| a.explanation.error.total_cmp(&b.explanation.error));
        let enough = as_good(found.first()?.explanation.error, size);
        let good = found.iter().filter(|one| one.explanation.error <= enough);
        let mut good: Vec<&Found> = good.collect();
        good.sort_by_key(|one| (self.strange_numbers(one.other), one.other.joint));
        let told = good.iter().take(TOLD).map(|one| {
            let told = self.with_another_offset(one.other);
            match one.is_ambiguous {
                true => format!("{told}, or another that gives the same in this pose"),
                false => told,
            }
        });
        let told: Vec<String> = told.chain(others(good.len(), "of")).collect();
        let mut explanation = found.swap_remove(0).explanation;
        explanation.how = Some(told.join(", or "));
        Some(explanation)
    }

    /// The offset of `joint` that gives the mesh, if one does: of those that do the one that changes the fewest numbers, and of
    /// those the one that changes them least.
    async fn wrong_offset(&self, joint: usize, size: f64, pace: &Pace) -> Option<Found> {
        let line = self.line(joint);
        let off = self.off_by(line)?;
        let fitted = off.all().into_iter().map(|by| OtherJoint {
            offset: line.offset + by,
            ..line
        });
        let fitted: Vec<OtherJoint> = fitted.filter(|other| self.is_near(*other)).collect();
        let mut given = Vec::new();
        let typed = fitted.iter().flat_map(|other| self.typed_near(*other));
        for other in typed.chain(fitted.iter().copied()) {
            let explained = self.explained(other, &ONE_WRONG_OFFSET, pace).await;
            given.extend(explained.map(|explanation| (explanation, other)));
        }
        if let (true, Some(other)) = (given.is_empty(), fitted.first()) {
            let other = self.within_rounding(*other, pace).await?;
            let explanation = self.explained(other, &ONE_WRONG_OFFSET, pace).await?;
            given.push((explanation, other));
        }
        let errors = given.iter().map(|(explanation, _)| explanation.error);
        let enough = as_good(errors.fold(f64::INFINITY, f64::min), size);
        let good = given.into_iter().filter(|(one, _)| one.error <= enough);
        let best = good.min_by_key(|(_, other)| self.changes(*other));
        best.map(|(explanation, other)| Found {
            explanation,
            other,
            is_ambiguous: off.along.is_some(),
        })
    }

    /// The line of `joint` as it is in the file.
    fn line(&self, joint: usize) -> OtherJoint {
        let own = &self.0.search.model.skeleton().joints()[joint];
        OtherJoint {
            joint,
            parent: own.parent,
            offset: own.offset.as_dvec3(),
        }
    }

    /// Whether an offset gives the mesh, or would but for what rounding does to vertices: that leads to one that is only near
    /// the right one.
    fn is_near(&self, other: OtherJoint) -> bool {
        let search = self.0.search;
        let error = search.error_of_sample(&self.formula_with(other));
        error.is_some_and(|error| error <= NEARLY * search.tolerance)
    }

    /// Offsets near a fitted one as somebody may have typed them: with the numbers of the file, with a slip in these, and
    /// with few digits.
    fn typed_near(&self, fitted: OtherJoint) -> Vec<OtherJoint> {
        let nearly = NEARLY * self.0.search.tolerance;
        let real = self.line(fitted.joint).offset.to_array();
        let number = |axis: usize| {
            let slips = real.iter().flat_map(|number| [*number, -number]);
            let mut plain = [real[axis], 0.0].into_iter().chain(slips);
            plain.find(|number| (number - fitted.offset[axis]).abs() <= nearly)
        };
        let with_digits = |digits: i32| {
            let scale = 10_f64.powi(digits);
            let rounded = |axis: usize| (fitted.offset[axis] * scale).round() / scale;
            DVec3::from_array([0, 1, 2].map(|axis| number(axis).unwrap_or_else(|| rounded(axis))))
        };
        let is_near = |offset: &DVec3| (*offset - fitted.offset).abs().max_element() <= nearly;
        let mut offsets: Vec<DVec3> = DIGITS_TYPED.map(with_digits).filter(is_near).collect();
        offsets.dedup();
        let lines = offsets
            .into_iter()
            .map(|offset| OtherJoint { offset, ..fitted });
        lines.collect()
    }

    /// The offset from a fitted one on at which no vertex is farther off than meshes are that agree, sought by moving it as
    /// much as the vertex needs that is farthest off, again and again (the relaxation method for inequalities, S. Agmon,
    /// Canadian Journal of Mathematics 6, 1954).
    async fn within_rounding(&self, fitted: OtherJoint, pace: &Pace) -> Option<OtherJoint> {
        let search = self.0.search;
        let all: Vec<usize> = (0..search.theirs.len()).collect();
        let moved = self.moved(fitted, &all);
        pace.after(4 * all.len()).await;
        let mut by = DVec3::ZERO;
        for _ in 0..STEPS_OF_RELAXATION {
            let lefts = moved.iter().map(|one| (one, one.left - one.along * by));
            let (worst, left) = lefts.max_by(|(_, a), (_, b)| a.length().total_cmp(&b.length()))?;
            let excess = left.length() - INSIDE * search.tolerance;
            if excess <= 0.0 {
                break;
            }
            let towards = worst.along.transpose() * left.normalize_or_zero();
            by += towards * (excess / towards.length_squared());
            pace.after(moved.len()).await;
        }
        by.is_finite().then(|| OtherJoint {
            offset: fitted.offset + by,
            ..fitted
        })
    }

    /// How many numbers of an offset are not those of the file, and by how much together, in thousandths: less is noise of
    /// the fit.
    fn changes(&self, other: OtherJoint) -> (usize, u64) {
        let by = other.offset - self.line(other.joint).offset;
        let numbers = by.to_array();
        let changed = numbers.iter().filter(|by| rounded(**by) != 0.0).count();
        (changed, (by.length() * 1e3).round() as u64)
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

    /// How vertices move with the offset of `line`, those with weights.
    fn moved(&self, line: OtherJoint, vertices: &[usize]) -> Vec<Moved> {
        let mut before = self.skinner(line);
        let mut along = DVec3::AXES.map(|axis| {
            self.skinner(OtherJoint {
                offset: line.offset + axis,
                ..line
            })
        });
        let moved = vertices.iter().filter_map(|&vertex| {
            let before = before.place(vertex);
            let along = along
                .each_mut()
                .map(|skinner| (skinner.place(vertex).at - before.at).to_array());
            (!before.is_unweighted).then(|| Moved {
                along: DMat3::from_cols_array_2d(&along),
                left: self.0.search.theirs[vertex] - before.at,
            })
        });
        moved.collect()
    }

    /// What must be added to the offset of `line`, the one of the file. `None` if the pose does not show it. A vertex moves in
    /// proportion to what is added, along each axis by itself.
    fn off_by(&self, line: OtherJoint) -> Option<OffBy> {
        let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
        for moved in self.moved(line, &self.0.search.sample) {
            matrix += moved.along.transpose() * moved.along;
            right += moved.along.transpose() * moved.left;
        }
        let shown = matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z;
        let raised = matrix + DMat3::from_diagonal(DVec3::splat(shown * HARDLY_SHOWN));
        let inverse = raised.inverse();
        let by = inverse * right;
        if !(shown > 0.0 && by.is_finite()) {
            return None;
        }
        // The direction that shows least, which the inverse makes longest.
        let along = (0..STEPS_OF_POWER).fold(DVec3::new(0.6, 0.64, 0.48), |along, _| {
            (inverse * along).normalize_or_zero()
        });
        let is_ambiguous = (matrix * along).length() < shown * NOT_SHOWN;
        Some(OffBy {
            by,
            along: is_ambiguous.then_some(along),
        })
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

/// A coordinate in words, without the digits that a mesh does not tell, and a zero without a sign.
fn rounded(coordinate: f64) -> f64 {
    (coordinate * 1e4).round() / 1e4 + 0.0
}
