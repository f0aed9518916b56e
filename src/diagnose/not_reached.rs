//! Vertices that a program's loop does not come to, so that they stay where they were.

use super::diagnose_vertices;
use super::diagnosis::{Diagnosis, ToldMistake, Verdict};
use super::findings::{Findings, share_right};
use super::found_otherwise::VERTICES_NOT_REACHED;
use super::model::Model;
use super::nearest::NEARLY_ALL;
use super::not_turned::Lacking;
use super::search::Search;
use super::vertex_count::with_vertices;
use crate::character::Pose;
use crate::steps::Pace;
use glam::{DVec3, Vec3};
use std::ops::Range;

/// Vertices at one end of the mesh that are at rest or at the origin, though some of them should not be.
pub(super) struct NotReached {
    left: Range<usize>,
    all: usize,
    /// Which they are and where, in words.
    pub(super) told: String,
}

/// Those of a mesh, of which there are none where all of it is at rest.
pub(super) fn find(findings: &Findings<'_>) -> Option<NotReached> {
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
            left,
            all,
            told: format!("{which}, counted from 0, are {told}"),
        })
    })
}

impl NotReached {
    /// Whether all vertices of the mesh that are off are among them.
    pub(super) fn are_all_off(&self, findings: &Findings<'_>) -> bool {
        let is_off = |index: &usize| findings.is_off(*index);
        (0..self.all)
            .filter(is_off)
            .all(|index| self.left.contains(&index))
    }

    /// Whether they are so few that the mesh is nearly what the others say.
    pub(super) fn are_few(&self) -> bool {
        self.left.len() as f64 <= (1.0 - NEARLY_ALL) * self.all as f64
    }

    /// The diagnosis of the mesh of `search` if the others are right, but for a joint that is not turned.
    pub(super) async fn beside_joint(
        &self,
        search: &Search<'_>,
        findings: &Findings<'_>,
        pace: &Pace,
    ) -> Option<Diagnosis> {
        let lacking = Lacking::new(search)?;
        let others = lacking.giving(|index| !self.left.contains(&index), pace);
        let others = others.await;
        let explained = (!others.is_empty()).then(|| findings.explained(&others))?;
        Some(self.beside(explained))
    }

    /// What else gives the mesh, beside that the loop does not come to these.
    fn beside(&self, others: Diagnosis) -> Diagnosis {
        let both = others.beside(ToldMistake {
            how: format!("those {}", self.told).into(),
            ..ToldMistake::whole(&VERTICES_NOT_REACHED)
        });
        Diagnosis {
            reached: share_right(self.left.len(), self.all),
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
        let reached = match self.left.start {
            0 => self.left.end..self.all,
            start => 0..start,
        };
        let lacking = with_vertices(findings.model.character, reached.clone())?;
        let theirs = findings.theirs[reached.clone()].iter();
        let theirs: Vec<Vec3> = theirs.map(|place| place.as_vec3()).collect();
        let model = Model::new(&lacking);
        let others = Box::pin(diagnose_vertices(&model, pose, &theirs, pace)).await;
        let others = others
            .ok()
            .filter(|others| matches!(others.verdict, Verdict::Right | Verdict::Explained))?;
        let whole = findings.diagnosis(Verdict::Explained);
        let first = others.first.map(|mut first| {
            first.vertex += reached.start;
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
