//! Weights that are left out because they are small: below which number is worked out from the mesh.

use super::formula::{Formula, Kept, Rescaled};
use super::made_alone::MadeAlone;
use super::of_weighted_sum::SMALL_WEIGHTS_LEFT_OUT;
use super::search::{AT_ONCE, Explanation};
use super::skin::Skinner;
use crate::steps::Pace;

/// Weights of a vertex of which it is tried where they are cut off; meshes with more are left.
const MOST_WEIGHTS: usize = 64;
/// Digits of the number that is told.
const MOST_DIGITS: usize = 9;

/// What is done with the other weights, in words.
const WAYS: [(Rescaled, &str); 2] = [
    (Rescaled::No, ""),
    (Rescaled::ToOne, ", the others divided by their sum"),
];

/// That weights below a number are left out, if that gives the mesh.
pub(super) async fn find(alone: &MadeAlone<'_>, pace: &Pace) -> Option<Explanation> {
    for (rescaled, others) in WAYS {
        let Some(range) = range(alone, rescaled, pace).await else {
            continue;
        };
        let (least, below) = range.told();
        let formula = kept(alone, Kept::From(least), rescaled);
        let given = alone.given_by(&formula, &SMALL_WEIGHTS_LEFT_OUT, pace);
        if let Some(given) = given.await {
            return Some(Explanation {
                how: Some(format!("those {below}{others}")),
                ..given
            });
        }
    }
    None
}

fn kept(alone: &MadeAlone<'_>, kept: Kept, rescaled: Rescaled) -> Formula {
    let mut formula = alone.formula();
    formula.weights.kept = kept;
    formula.weights.rescaled = rescaled;
    formula
}

/// Numbers of which each gives the same vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Range {
    above: f64,
    up_to: f64,
}

impl Range {
    fn common(self, other: Self) -> Option<Self> {
        let common = Self {
            above: self.above.max(other.above),
            up_to: self.up_to.min(other.up_to),
        };
        (common.above < common.up_to).then_some(common)
    }

    /// One of the numbers, and what is left out in words: those up to the largest weight that is, if that has fewer digits.
    fn told(self) -> (f64, String) {
        let least = self.roundest();
        let largest_out = (self.above as f32).to_string();
        let has_fewer = self.above > 0.0 && largest_out.len() < least.to_string().len();
        let below = match has_fewer {
            true => format!("up to {largest_out}"),
            false => format!("below {least}"),
        };
        (least, below)
    }

    /// Of the numbers that are in it in single precision the one with the fewest digits.
    fn roundest(self) -> f64 {
        let exponent = self.up_to.log10().floor() as i32;
        let with_digits = |digits: usize| {
            let step = 10_f64.powi(exponent + 1 - digits as i32);
            let places = [(self.up_to / step).floor(), (self.up_to / step).ceil()];
            places.map(|place| format!("{:.*e}", digits - 1, place * step))
        };
        let mut texts = (1..=MOST_DIGITS).flat_map(with_digits);
        let is_inside = |number: &f64| {
            let read = f64::from(*number as f32);
            self.above < read && read <= self.up_to
        };
        let found = texts.find_map(|text| text.parse().ok().filter(is_inside));
        found.unwrap_or(self.up_to)
    }
}

/// The numbers below which weights may have been left out, as far as single vertices tell.
async fn range(alone: &MadeAlone<'_>, rescaled: Rescaled, pace: &Pace) -> Option<Range> {
    let search = alone.search;
    let vertices = 0..search.theirs.len();
    let most = vertices.clone().map(|vertex| alone.weights(vertex).count());
    let most = most.max().filter(|most| *most <= MOST_WEIGHTS)?;
    let with = |count: usize| {
        let formula = kept(alone, Kept::Largest(count), rescaled);
        Skinner::new(search.model, search.pose, &formula)
    };
    let mut skinners: Vec<Skinner> = (0..=most).map(with).collect();
    let mut ranges = vec![Range {
        above: 0.0,
        up_to: f64::INFINITY,
    }];
    let mut weights = Vec::with_capacity(most);
    for (done, vertex) in search.sample.iter().copied().chain(vertices).enumerate() {
        weights.clear();
        weights.extend(alone.weights(vertex).map(f64::from));
        weights.sort_by(|a, b| b.total_cmp(a));
        if weights.last().is_some_and(|least| *least < 0.0) {
            return None;
        }
        let theirs = search.theirs[vertex];
        let mut fitting = Vec::new();
        // So many are kept where the number is between the last of them and the next.
        let counts = skinners.iter_mut().take(weights.len() + 1).enumerate();
        for (count, skinner) in counts {
            let range = Range {
                above: weights.get(count).copied().unwrap_or(0.0),
                up_to: (count.checked_sub(1)).map_or(f64::INFINITY, |last| weights[last]),
            };
            let is_some = range.above < range.up_to;
            if is_some && skinner.place(vertex).distance(theirs) <= search.tolerance {
                fitting.push(range);
            }
        }
        if !weights.is_empty() {
            let pairs = ranges
                .iter()
                .flat_map(|one| fitting.iter().map(|other| (*one, *other)));
            ranges = pairs.filter_map(|(one, other)| one.common(other)).collect();
        }
        if ranges.is_empty() {
            return None;
        }
        if done % AT_ONCE == AT_ONCE - 1 {
            pace.after(AT_ONCE * most).await;
        }
    }
    ranges.into_iter().find(|range| range.up_to.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_range_the_number_with_the_fewest_digits_is_told() {
        for (above, up_to, least, told) in [
            (0.0095, f64::from(0.01_f32), 0.01, "below 0.01"),
            (0.0099, 0.0101, 0.01, "below 0.01"),
            (0.012, 0.0138, 0.013, "below 0.013"),
            (f64::from(0.05_f32), 0.0513, 0.051, "up to 0.05"),
            (0.5, f64::from(0.5001_f32), 0.5001, "up to 0.5"),
            (0.0, f64::from(0.4_f32), 0.4, "below 0.4"),
            (0.000_98, 0.001_02, 0.001, "below 0.001"),
        ] {
            assert_eq!(Range { above, up_to }.told(), (least, told.to_owned()));
        }
    }
}
