//! The triangles of a mesh, held against those of the character.

use super::found_otherwise::{TRIANGLES_DIFFER, TRIANGLES_TURNED};
use super::mistake::Mistake;
use super::model::Model;
use super::search::AT_ONCE;
use super::triangles::{Triangle, Wound, cut_otherwise, sorted, take, wound};
use super::{Diagnosis, Verdict};
use crate::character::Character;
use crate::geometry::Mesh;
use crate::steps::{Pace, at_once};
use serde::Serialize;
use std::collections::{HashMap, HashSet};
use std::fmt;
use std::iter::repeat_n;

/// The mistake with which vertices have other numbers.
const RENUMBERED: &str = "vertices-renumbered";

/// How the triangles of a mesh differ from those of the character. Their order and the corner that comes
/// first do not count, nor along which diagonals polygons are cut; triangles with the same corner twice
/// show nothing and are left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct FaceDifference {
    /// Triangles of the character.
    pub triangles: usize,
    /// How many of them the mesh lacks.
    #[serde(rename = "triangles_missing")]
    pub missing: usize,
    /// Triangles of the mesh that the character does not have.
    #[serde(rename = "triangles_other")]
    pub other: usize,
    /// Triangles that both have and that wind the other way, so that their normals point the other way. Those of
    /// polygons that are cut along other diagonals are not known to.
    #[serde(rename = "triangles_turned")]
    pub turned: usize,
    /// Of a mesh that nothing explains, how many of its triangles are the character's, if hardly any is.
    #[serde(rename = "triangles_same", skip_serializing_if = "Option::is_none")]
    pub same: Option<usize>,
}

/// Share of the character's triangles below which a mesh hardly has any of them.
const HARDLY_ANY: f64 = 0.05;
/// Fewest triangles of which a few are hardly any.
const FEWEST: usize = 40;

impl FaceDifference {
    /// The difference of `theirs`, about whose vertices so much is `found`, from a model. Where these are
    /// not so many as the model's, as one for each corner, it is not known which is which.
    pub(super) async fn find(
        model: &Model<'_>,
        found: &Diagnosis,
        theirs: &Mesh,
        pace: &Pace,
    ) -> Self {
        let are_as_many = theirs.positions.len() == model.positions.len();
        let knows_which_is_which = match found.verdict {
            Verdict::Right | Verdict::Triangles => true,
            Verdict::Explained => !found.causes.contains(&RENUMBERED),
            Verdict::OtherPose => are_as_many,
            Verdict::Unexplained => are_as_many && found.nearly_right().is_some(),
        };
        let (model, theirs) = (model.triangles(), &theirs.triangles);
        if knows_which_is_which {
            Self::of_same_vertices(model, theirs, pace).await
        } else {
            let same = match found.verdict {
                Verdict::Unexplained => same_if_hardly_any(model, theirs, pace).await,
                _ => None,
            };
            Self {
                same,
                ..Self::of_counts(model, theirs)
            }
        }
    }

    /// The difference of meshes that have the same vertices in the same order.
    async fn of_same_vertices(model: &[Triangle], theirs: &[Triangle], pace: &Pace) -> Self {
        let mut left: HashMap<Wound, usize> = HashMap::new();
        for part in model.chunks(AT_ONCE) {
            for triangle in wound(part) {
                *left.entry(triangle).or_default() += 1;
            }
            pace.after(part.len()).await;
        }
        let triangles = left.values().sum();
        let mut other = Vec::new();
        for part in theirs.chunks(AT_ONCE) {
            other.extend(wound(part).filter(|triangle| !take(&mut left, triangle)));
            pace.after(part.len()).await;
        }
        // Those that both sides of a sheet have are known by the way they wind: it counts first.
        let both = other.len();
        other.retain(|&(corners, way)| !take(&mut left, &(corners, !way)));
        let turned = both - other.len();
        let other: Vec<Triangle> = other.into_iter().map(|(corners, _)| corners).collect();
        let missing = left
            .into_iter()
            .flat_map(|((corners, _), count)| repeat_n(corners, count));
        let missing: Vec<Triangle> = missing.collect();
        let same = match missing.is_empty() || other.is_empty() {
            true => 0,
            false => cut_otherwise((&missing, model), (&other, theirs)),
        };
        Self {
            triangles,
            missing: missing.len() - same,
            other: other.len() - same,
            turned,
            same: None,
        }
    }

    /// The difference of meshes of which it is not known which vertex is which: their numbers alone tell.
    fn of_counts(model: &[Triangle], theirs: &[Triangle]) -> Self {
        let triangles = wound(model).count();
        Self {
            triangles,
            missing: triangles.saturating_sub(wound(theirs).count()),
            ..Self::default()
        }
    }

    /// The mistakes that it is. Triangles that are there besides those of the model are none.
    pub fn mistakes(&self) -> impl Iterator<Item = &'static Mistake> {
        let differ = (self.missing > 0).then_some(&TRIANGLES_DIFFER);
        let turned = (self.turned > 0 && self.turned >= self.other).then_some(&TRIANGLES_TURNED);
        differ.into_iter().chain(turned)
    }

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        self.missing == 0 && self.other == 0 && self.turned == 0
    }
}

impl fmt::Display for FaceDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            triangles,
            missing,
            other,
            turned,
            same: _,
        } = *self;
        let is = |count: usize| if count == 1 { "is" } else { "are" };
        if missing > 0 {
            let are = is(missing);
            write!(
                f,
                "{missing} of the model's {triangles} triangles {are} missing"
            )?;
            // Some that have wrong indices may be left out.
            if other * 2 < missing {
                f.write_str(": the file may be cut off")?;
            } else {
                let others = if other == 1 { "other" } else { "others" };
                write!(f, ", and {other} {others} {} there", is(other))?;
            }
            if other > FEWEST && other * 2 > triangles {
                f.write_str(": corners count from 1")?;
            }
        } else if other > 0 {
            let triangles = if other == 1 { "triangle" } else { "triangles" };
            let are = is(other);
            write!(
                f,
                "{other} {triangles} {are} there besides the model's, or a second time"
            )?;
        }
        // Of others, such as those with wrong indices, some are by chance what turned ones would be.
        if turned == 0 || turned < other {
            return Ok(());
        }
        if missing + other > 0 {
            f.write_str("; ")?;
        }
        let (all, wind) = match turned {
            _ if turned == triangles => ("all of its triangles".to_owned(), "wind"),
            1 => ("1 of its triangles".to_owned(), "winds"),
            _ => (format!("{turned} of its triangles"), "wind"),
        };
        write!(
            f,
            "{all} {wind} the other way, so that normals point the other way"
        )
    }
}

/// How many triangles of `theirs` are the character's, however they wind, if that is hardly any: it is hardly a mesh of it.
pub fn hardly_any_triangles(character: &Character, theirs: &Mesh) -> Option<usize> {
    let (model, theirs) = (&character.bind_mesh().triangles, &theirs.triangles);
    at_once(|pace| async move { same_if_hardly_any(model, theirs, &pace).await })
}

/// How many triangles both meshes have, however they wind, if that is hardly any of the model's.
async fn same_if_hardly_any(model: &[Triangle], theirs: &[Triangle], pace: &Pace) -> Option<usize> {
    let known = different(model, pace).await;
    let has = different(theirs, pace).await;
    let same = known.intersection(&has).count();
    let is_another = has.len() >= FEWEST && (same as f64) < HARDLY_ANY * known.len() as f64;
    is_another.then_some(same)
}

/// Triangles each once, however they wind.
async fn different(triangles: &[Triangle], pace: &Pace) -> HashSet<Triangle> {
    let mut different = HashSet::new();
    for part in triangles.chunks(AT_ONCE) {
        different.extend(sorted(part));
        pace.after(part.len()).await;
    }
    different
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(model: &[Triangle], theirs: &[Triangle]) -> FaceDifference {
        at_once(|pace| async move { FaceDifference::of_same_vertices(model, theirs, &pace).await })
    }

    fn difference(model: &[Triangle], theirs: &[Triangle]) -> (usize, usize) {
        let found = found(model, theirs);
        (found.missing, found.other)
    }

    fn turned(model: &[Triangle], theirs: &[Triangle]) -> usize {
        found(model, theirs).turned
    }

    #[test]
    fn triangles_that_wind_the_other_way_are_counted_and_not_missing() {
        let model = [[0, 1, 2], [2, 1, 3], [3, 4, 5]];
        let theirs = [[0, 2, 1], [2, 1, 3], [4, 3, 5]];
        assert_eq!(difference(&model, &theirs), (0, 0));
        assert_eq!(turned(&model, &theirs), 2);
        // A sheet that is seen from both sides has each triangle both ways.
        let sheet = [[0, 1, 2], [2, 1, 0]];
        assert_eq!(turned(&sheet, &[[1, 0, 2], [1, 2, 0]]), 0);
        assert_eq!(turned(&sheet, &[[0, 1, 2], [1, 2, 0]]), 1);
    }

    /// Triangles of a row of squares above one another, each cut along one of its diagonals.
    fn squares(is_cut_up: impl Fn(u32) -> bool, count: u32) -> Vec<Triangle> {
        let cut = |at: u32| {
            let [a, b, c, d] = [0, 1, 3, 2].map(|corner| 2 * at + corner);
            match is_cut_up(at) {
                true => [[a, b, c], [a, c, d]],
                false => [[d, a, b], [b, c, d]],
            }
        };
        (0..count).flat_map(cut).collect()
    }

    #[test]
    fn triangles_are_the_same_in_any_order_and_from_any_corner_on() {
        let model = [[0, 1, 2], [2, 1, 3], [4, 4, 5]];
        assert_eq!(difference(&model, &[[3, 2, 1], [1, 2, 0]]), (0, 0));
        assert_eq!(turned(&model, &[[3, 2, 1], [1, 2, 0]]), 0);
        assert_eq!(difference(&model, &[[3, 2, 1]]), (1, 0));
        assert_eq!(difference(&model, &[[3, 2, 1], [3, 2, 1]]), (1, 1));
        let more = [[0, 1, 2], [2, 1, 3], [0, 1, 3]];
        assert_eq!(difference(&model, &more), (0, 1));
    }

    #[test]
    fn polygons_are_the_same_along_whatever_diagonals_they_are_cut() {
        let model = squares(|_| true, 100);
        for theirs in [squares(|_| false, 100), squares(|at| at % 3 == 0, 100)] {
            assert_eq!(difference(&model, &theirs), (0, 0));
            assert_eq!(difference(&model, &theirs[..120]), (80, 0));
            let mut wrong = theirs[..119].to_vec();
            wrong.push([0, 7, 90]);
            assert_eq!(
                difference(&model, &wrong).1,
                1 + usize::from(theirs[118] != model[118])
            );
        }
    }

    #[test]
    fn a_folded_polygon_that_both_sides_of_a_sheet_have_may_be_cut_otherwise_on_one() {
        let sheet = [[0, 1, 2], [0, 2, 3], [0, 2, 1], [0, 3, 2]];
        assert_eq!(
            difference(&sheet, &[[0, 1, 3], [1, 2, 3], [0, 2, 1], [0, 3, 2]]),
            (0, 0)
        );
    }

    #[test]
    fn indices_that_are_off_by_one_are_other_triangles_of_a_closed_mesh_too() {
        let model = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
        let shifted = model.map(|corners| corners.map(|index| index + 1));
        assert_eq!(difference(&model, &shifted), (3, 3));
    }

    #[test]
    fn what_differs_is_told_in_one_line() {
        let told = |missing, other, turned| {
            let triangles = 70;
            let difference = FaceDifference {
                triangles,
                missing,
                other,
                turned,
                same: None,
            };
            difference.to_string()
        };
        assert_eq!(
            told(30, 1, 0),
            "30 of the model's 70 triangles are missing: the file may be cut off"
        );
        assert_eq!(
            told(2, 2, 0),
            "2 of the model's 70 triangles are missing, and 2 others are there"
        );
        // As where they count from 0: those with an index of 0 are left out, and one turned triangle is chance.
        assert_eq!(
            told(69, 67, 1),
            "69 of the model's 70 triangles are missing, and 67 others are there: corners count from 1"
        );
        assert_eq!(
            told(0, 1, 0),
            "1 triangle is there besides the model's, or a second time"
        );
        assert_eq!(
            told(0, 0, 70),
            "all of its triangles wind the other way, so that normals point the other way"
        );
        assert_eq!(
            told(30, 0, 1),
            "30 of the model's 70 triangles are missing: the file may be cut off; \
             1 of its triangles winds the other way, so that normals point the other way"
        );
    }
}
