//! Vertices that a program's loop does not come to, so that they stay where they were, or that have no weights there.

use super::diagnose_vertices;
use super::diagnosis::{Diagnosis, ToldMistake, Verdict};
use super::findings::{Findings, share_right};
use super::found_otherwise::{VERTICES_NOT_REACHED, VERTICES_WITHOUT_WEIGHTS};
use super::mistake::Mistake;
use super::model::Model;
use super::nearest::NEARLY_ALL;
use super::not_turned::Lacking;
use super::search::Search;
use super::vertex_count::with_vertices;
use crate::character::Pose;
use crate::steps::Pace;
use glam::{DVec3, Vec3};

/// Vertices that are at rest or at the origin, though some of them should not be.
pub(super) struct NotReached {
    /// Whether each vertex is one of them.
    is_left: Vec<bool>,
    /// What leaves them there.
    mistake: &'static Mistake,
    /// Which they are and where, in words.
    pub(super) told: String,
}

/// What leaves vertices there.
const LEAVING: [&Mistake; 2] = [&VERTICES_NOT_REACHED, &VERTICES_WITHOUT_WEIGHTS];

/// Those of a mesh that may be left, of which there are none where all of it is: at one end those that no loop comes to, and
/// then all that are at the origin, as what has no weights is. Where most are, much else can be behind it.
pub(super) fn find(findings: &Findings<'_>) -> impl Iterator<Item = NotReached> {
    let all = findings.theirs.len();
    let at_end = at_one_end(findings);
    let at_origin = |index: usize| findings.theirs[index].length() <= findings.tolerance;
    let is_left: Vec<bool> = (0..all)
        .map(|index| at_origin(index) && findings.is_off(index))
        .collect();
    let left = || (0..all).filter(|&index| is_left[index]);
    let is_same = at_end
        .as_ref()
        .is_some_and(|end| left().all(|index| end.is_left[index]));
    let count = left().count();
    let ends = left().next().zip(left().next_back());
    let anywhere = ends
        .filter(|_| !is_same && 2 * count <= all)
        .map(|(first, last)| {
            let in_all = match count == last - first + 1 {
                true => String::new(),
                false => format!(", {count} in all"),
            };
            NotReached {
                told: format!("from {first} to {last}, counted from 0{in_all}, are at the origin"),
                mistake: &VERTICES_WITHOUT_WEIGHTS,
                is_left,
            }
        });
    at_end.into_iter().chain(anywhere)
}

/// Those at one end of a mesh.
fn at_one_end(findings: &Findings<'_>) -> Option<NotReached> {
    let all = findings.theirs.len();
    let rest = |index: usize| findings.at_rest(index);
    let places: [(&dyn Fn(usize) -> DVec3, &str); 2] =
        [(&rest, "at rest"), (&|_| DVec3::ZERO, "at the origin")];
    places.into_iter().find_map(|(place, told)| {
        let is_there =
            |index: &usize| findings.theirs[*index].distance(place(*index)) <= findings.tolerance;
        let is_off = |index: &usize| findings.is_off(*index);
        let last = (0..all).rev().take_while(is_there).filter(is_off).last();
        let first = (0..all).take_while(is_there).filter(is_off).last();
        let ends = [
            last.map(|from| (from..all, format!("from {from} on"))),
            first.map(|last| (0..last + 1, format!("before {}", last + 1))),
        ];
        let (left, which) = ends
            .into_iter()
            .flatten()
            .find(|(left, _)| left.len() < all)?;
        Some(NotReached {
            is_left: (0..all).map(|index| left.contains(&index)).collect(),
            mistake: &VERTICES_NOT_REACHED,
            told: format!("{which}, counted from 0, are {told}"),
        })
    })
}

impl NotReached {
    /// How many there are.
    fn count(&self) -> usize {
        self.is_left.iter().filter(|is_left| **is_left).count()
    }

    /// The other vertices.
    fn others(&self) -> Vec<usize> {
        let all = 0..self.is_left.len();
        all.filter(|&index| !self.is_left[index]).collect()
    }

    /// Whether all vertices of the mesh that are off are among them.
    pub(super) fn are_all_off(&self, findings: &Findings<'_>) -> bool {
        let others = self.others();
        !others.iter().any(|&index| findings.is_off(index))
    }

    /// Whether they are so few that the mesh is nearly what the others say.
    pub(super) fn are_few(&self) -> bool {
        self.count() as f64 <= (1.0 - NEARLY_ALL) * self.is_left.len() as f64
    }

    /// The diagnosis of the mesh of `search` if the others are right, but for a joint that is not turned.
    pub(super) async fn beside_joint(
        &self,
        search: &Search<'_>,
        findings: &Findings<'_>,
        pace: &Pace,
    ) -> Option<Diagnosis> {
        let lacking = Lacking::new(search)?;
        let others = lacking.giving(|index| !self.is_left[index], pace).await;
        let explained = (!others.is_empty()).then(|| findings.explained(&others))?;
        Some(self.beside(explained))
    }

    /// What else gives the mesh, beside what leaves these.
    fn beside(&self, others: Diagnosis) -> Diagnosis {
        let both = others.beside(ToldMistake {
            how: format!("those {}", self.told).into(),
            ..ToldMistake::whole(self.mistake)
        });
        Diagnosis {
            reached: share_right(self.count(), self.is_left.len()),
            ..both
        }
    }

    /// The diagnosis of the mesh if the others are right, or what mistakes give.
    pub(super) async fn explained(
        &self,
        findings: &Findings<'_>,
        pose: &Pose,
        pace: &Pace,
    ) -> Option<Diagnosis> {
        let reached = self.others();
        let lacking = with_vertices(findings.model.character, &reached)?;
        let theirs = reached
            .iter()
            .map(|&index| findings.theirs[index].as_vec3());
        let theirs: Vec<Vec3> = theirs.collect();
        let model = Model::new(&lacking);
        let others = Box::pin(diagnose_vertices(&model, pose, &theirs, pace)).await;
        let leaves_others = |told: &ToldMistake| LEAVING.iter().any(|known| known.id == told.id);
        let others = others.ok().filter(|others| {
            matches!(others.verdict, Verdict::Right | Verdict::Explained)
                && !others.mistakes.iter().any(leaves_others)
        })?;
        let whole = findings.diagnosis(Verdict::Explained);
        let first = others.first.map(|mut first| {
            first.vertex = reached[first.vertex];
            first
        });
        let explained = Diagnosis {
            first: first.or(whole.first),
            error: others.error,
            mistakes: others.mistakes,
            same_as: others.same_as,
            others: others.others,
            slight: others.slight,
            coarse: others.coarse,
            ..whole
        };
        Some(self.beside(explained))
    }
}
