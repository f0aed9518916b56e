//! Mistakes of a whole program, which are sought by themselves first.

use super::formula::Formula;
use super::found_otherwise::{ANGLES_SCALED, SUM_NOT_RESET};
use super::made_alone::MadeAlone;
use super::misread_rows;
use super::mistake::Mistake;
use super::of_angles::{ROTATION_REPEATED, TOLD_LAST};
use super::of_weighted_sum::LAST_RESULT_SKINNED;
use super::of_whole_program::OF_WHOLE_PROGRAM;
use super::search::{AT_ONCE, Explanation, Search};
use super::skin::{Placed, Skinner};
use super::small_weights;
use super::ways::Made;
use crate::steps::Pace;
use glam::{DMat3, DVec3};
use std::f64::consts::PI;
use std::iter;

/// Factors of the angles from which on the right one is sought.
const FACTORS: [f64; 3] = [1.0, 2.0, 0.5];
/// Steps towards it.
const STEPS: usize = 12;
/// Angles of which a factor is sought beside another mistake.
const FEWEST_ANGLES: usize = 3;
/// Vertices that tell it then.
const FEW: usize = 96;
/// By how much a factor is changed to see what that moves.
const A_LITTLE: f64 = 1e-4;
/// What single precision and six digits are off by in a sum over all vertices, by the largest that it ever is.
const ROUNDING_OF_SUMS: f64 = 1e-5;

/// The mistakes that give the mesh, which is held against the `exact` one; angles that are scaled give it as in `fits`.
pub(super) async fn find(
    alone: &MadeAlone<'_>,
    fits: &MadeAlone<'_>,
    exact: &[Placed],
    pace: &Pace,
) -> Vec<Explanation> {
    let mut found = Vec::new();
    for mistake in OF_WHOLE_PROGRAM.into_iter().chain([&SUM_NOT_RESET]) {
        let is_last = TOLD_LAST.iter().any(|last| std::ptr::eq(mistake, *last));
        if is_last && !found.is_empty() {
            continue;
        }
        found.extend(made_by(mistake, alone, |_| true, pace).await);
    }
    // Where each joint turns about one axis, what is made twice is angles that are twice as large.
    let is_made_twice = |found: &Explanation| {
        let twice = [ROTATION_REPEATED.id, LAST_RESULT_SKINNED.id];
        found.ids().iter().all(|id| twice.contains(id))
    };
    if found.iter().all(is_made_twice) {
        found.extend(scaled_angles(fits, pace).await);
    }
    if found.is_empty() {
        found.extend(small_weights::find(fits, pace).await);
    }
    if found.is_empty() {
        found.extend(sum_not_reset(alone.search, exact, pace).await);
    }
    if found.is_empty() {
        found.extend(matrix_not_reset(alone.search, pace).await);
    }
    if found.is_empty() {
        found.extend(misread_rows::find(alone, pace).await);
    }
    found
}

/// The ways to make a mistake of such a character that give the mesh, of those whose formula counts.
async fn made_by(
    mistake: &'static Mistake,
    alone: &MadeAlone<'_>,
    counts: impl Fn(&Formula) -> bool,
    pace: &Pace,
) -> Vec<Explanation> {
    let mut found = Vec::new();
    for reading in mistake.readings {
        let mut formula = alone.formula();
        (reading.make)(&mut formula);
        if alone.search.may_be_of(&formula) && counts(&formula) {
            let made = Made { mistake, reading };
            found.extend(alone.made_by(&formula, made, pace).await);
        }
    }
    found
}

/// The mistakes that give the mesh beside another one, or beside none where that is right. Digits that are rounded off are
/// none where there are none.
pub(super) async fn as_well(alone: &MadeAlone<'_>, pace: &Pace) -> Vec<Explanation> {
    let mut found = Vec::new();
    for mistake in OF_WHOLE_PROGRAM {
        found.extend(made_by(mistake, alone, |formula| !formula.rounds_digits(), pace).await);
    }
    found
}

/// That all angles are multiplied by the same factor, which is worked out by least squares.
async fn scaled_angles(fits: &MadeAlone<'_>, pace: &Pace) -> Vec<Explanation> {
    // A single angle that is another one is another pose, unless by a factor that programs often have.
    if angles(fits).count() < 2 {
        return made_by(&ANGLES_SCALED, fits, |_| true, pace).await;
    }
    for begin in FACTORS {
        let Some(factor) = fitted_factor(fits, begin, &fits.search.sample, pace).await else {
            continue;
        };
        if let Some(given) = given_by_factor(fits, factor, pace).await {
            return vec![given];
        }
    }
    Vec::new()
}

/// The same beside another mistake.
pub(super) async fn scaled_angles_beside(fits: &MadeAlone<'_>, pace: &Pace) -> Option<Explanation> {
    // Fewer could be any others by a factor and a mistake that loses some.
    if angles(fits).count() < FEWEST_ANGLES {
        return None;
    }
    let sample = &fits.search.sample;
    let few = sample.iter().step_by(sample.len().div_ceil(FEW).max(1));
    let few: Vec<usize> = few.copied().collect();
    for begin in FACTORS {
        // One that turns joints the other way would undo a sign.
        let factor = fitted_factor(fits, begin, &few, pace).await;
        if let Some(factor) = factor.filter(|factor| *factor > 0.0) {
            let given = given_by_factor(fits, factor, pace).await;
            if given.is_some() {
                return given;
            }
        }
    }
    None
}

/// The angles that the formula turns joints by.
fn angles(fits: &MadeAlone<'_>) -> impl Iterator<Item = f64> {
    let search = fits.search;
    let factors = DVec3::from_array(fits.formula().joint.angles);
    let joints = 0..search.model.skeleton().joints().len();
    let angles = joints.flat_map(move |joint| {
        let radians = search.pose.rotation(joint).radians.as_dvec3();
        (radians * factors).to_array()
    });
    angles.filter(|angle| *angle != 0.0)
}

fn scaled_by(fits: &MadeAlone<'_>, factor: f64) -> Formula {
    let mut formula = fits.formula();
    for angle in &mut formula.joint.angles {
        *angle *= factor;
    }
    formula
}

/// The factor of all angles with which these vertices come nearest, sought from `begin` on; `None` if they tell none.
async fn fitted_factor(
    fits: &MadeAlone<'_>,
    begin: f64,
    vertices: &[usize],
    pace: &Pace,
) -> Option<f64> {
    let search = fits.search;
    let placed = |factor: f64| {
        let mut skinner = Skinner::new(search.model, search.pose, &scaled_by(fits, factor));
        let placed = vertices.iter().map(|&vertex| skinner.place(vertex).at);
        let placed: Vec<DVec3> = placed.collect();
        placed
    };
    let mut factor = begin;
    for _ in 0..STEPS {
        let at = placed(factor);
        let further = placed(factor + A_LITTLE);
        pace.after(2 * vertices.len()).await;
        let (mut along, mut square) = (0.0, 0.0);
        for ((at, further), &vertex) in at.iter().zip(further).zip(vertices) {
            let by = (further - *at) / A_LITTLE;
            along += by.dot(search.theirs[vertex] - *at);
            square += by.length_squared();
        }
        factor += along / square;
    }
    factor.is_finite().then_some(factor)
}

/// The explanation by a factor of all angles, if one that is there or next to it gives the mesh.
async fn given_by_factor(fits: &MadeAlone<'_>, factor: f64, pace: &Pace) -> Option<Explanation> {
    // Rounded numbers lead to a factor that is only near the right one.
    for factor in coarse_pis_from(factor).chain(iter::once(factor)) {
        let formula = scaled_by(fits, factor);
        if let Some(given) = fits.given_by(&formula, &ANGLES_SCALED, pace).await {
            return Some(Explanation {
                how: Some(told_factor(factor)),
                ..given
            });
        }
    }
    None
}

/// A π that programs have, in words, and by how much it is another one than π. One of 3.1416 or more digits cannot be told
/// from π.
#[expect(clippy::approx_constant, reason = "they are meant to be coarse")]
const COARSE_PIS: [(&str, f64); 6] = [
    ("3", 3.0),
    ("3.1", 3.1),
    ("3.14", 3.14),
    ("3.141", 3.141),
    ("3.142", 3.142),
    ("22/7", 22.0 / 7.0),
];
/// How many units of the last digit that a factor has in words are 1.
const UNITS_OF_FACTOR: f64 = 1e5;

/// The factors by the coarse πs, the nearest first.
fn coarse_pis_from(factor: f64) -> impl Iterator<Item = f64> {
    let mut factors = COARSE_PIS.map(|(_, pi)| pi / PI);
    let away = |other: &f64| (other - factor).abs();
    factors.sort_by(|one, other| away(one).total_cmp(&away(other)));
    factors.into_iter()
}

/// The factor of angles in words, with the coarse π that makes it, if one does.
fn told_factor(factor: f64) -> String {
    let rounded = (factor * UNITS_OF_FACTOR).round() / UNITS_OF_FACTOR;
    let is_by = |pi: f64| (pi / PI - factor).abs() * UNITS_OF_FACTOR <= 0.5;
    let by = COARSE_PIS.iter().find(|(_, pi)| is_by(*pi));
    let by = by.map_or(String::new(), |(name, _)| format!(", as by a π of {name}"));
    format!("each is {rounded} times as large{by}")
}

/// That the sum goes on from vertex to vertex.
async fn sum_not_reset(search: &Search<'_>, exact: &[Placed], pace: &Pace) -> Option<Explanation> {
    let mut before = DVec3::ZERO;
    let distance = |vertex: usize, theirs: DVec3| {
        let own = theirs - std::mem::replace(&mut before, theirs);
        exact[vertex].distance(own)
    };
    goes_on(search, distance, "from vertex to vertex", pace).await
}

/// That the weighted sum of matrices, by which a vertex is multiplied then, goes on from vertex to vertex.
async fn matrix_not_reset(search: &Search<'_>, pace: &Pace) -> Option<Explanation> {
    let exact = Formula::default();
    let mut skinner = search.skinner(&exact)?;
    let (mut linear, mut translation) = (DMat3::ZERO, DVec3::ZERO);
    let distance = |vertex: usize, theirs: DVec3| {
        let bind = search.model.positions[search.model.source(exact.vertex_order, vertex).position];
        let (own, placed) = (skinner.linear(vertex), skinner.place(vertex));
        if !placed.is_unweighted {
            linear += own;
            translation += placed.at - own * bind;
        }
        theirs.distance(linear * bind + translation)
    };
    let how = "that of matrices, from vertex to vertex";
    goes_on(search, distance, how, pace).await
}

/// That something goes on from vertex to vertex, if by `distance` each is as near to where that puts it as rounding leaves it.
async fn goes_on(
    search: &Search<'_>,
    mut distance: impl FnMut(usize, DVec3) -> f64,
    how: &str,
    pace: &Pace,
) -> Option<Explanation> {
    let (mut largest, mut error) = (0.0_f64, 0.0_f64);
    for (vertex, &theirs) in search.theirs.iter().enumerate() {
        largest = largest.max(theirs.abs().max_element());
        let distance = distance(vertex, theirs) - ROUNDING_OF_SUMS * largest;
        if distance.is_nan() || distance > search.tolerance {
            return None;
        }
        error = error.max(distance);
        if vertex % AT_ONCE == AT_ONCE - 1 {
            pace.after(AT_ONCE).await;
        }
    }
    Some(Explanation {
        made: vec![Made::by_numbers(&SUM_NOT_RESET)],
        error,
        how: Some(how.to_owned()),
    })
}
