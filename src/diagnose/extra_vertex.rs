//! Meshes with one vertex more than the character has.

use super::diagnosis::{ToldMistake, all_causes};
use super::found_otherwise::VERTEX_TOO_MANY;
use super::{Diagnosis, Verdict};
use glam::Vec3;

/// Where a program has one vertex too many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extra {
    AfterLast,
    BeforeFirst,
}

impl Extra {
    /// Where it may be, in the order in which that is tried, if the mesh has one vertex more than the `expected` ones.
    pub(super) fn places(expected: usize, found: usize) -> impl Iterator<Item = Self> {
        let is_one = found == expected + 1;
        let all = [Self::AfterLast, Self::BeforeFirst];
        all.into_iter().filter(move |_| is_one)
    }

    /// The vertices without it.
    pub(super) fn without(self, vertices: &[Vec3]) -> &[Vec3] {
        let last = vertices.len().saturating_sub(1);
        match self {
            Self::AfterLast => &vertices[..last],
            Self::BeforeFirst => &vertices[vertices.len() - last..],
        }
    }

    /// The diagnosis of a mesh with it, from that of the others: where these are known to be right or what a mistake
    /// gives.
    pub(super) fn added_to(self, mut found: Diagnosis) -> Option<Diagnosis> {
        if !matches!(
            found.verdict,
            Verdict::Right | Verdict::Triangles | Verdict::Explained
        ) {
            return None;
        }
        let how = match self {
            Self::AfterLast => "after the last",
            Self::BeforeFirst => "before the first",
        };
        found.verdict = Verdict::Explained;
        found.mistakes.push(ToldMistake {
            how: how.into(),
            ..ToldMistake::whole(&VERTEX_TOO_MANY)
        });
        for same in &mut found.same_as {
            same.push(VERTEX_TOO_MANY.id);
        }
        found.causes = all_causes(&found.mistakes, &found.same_as);
        if let (Self::BeforeFirst, Some(first)) = (self, &mut found.first) {
            first.vertex += 1;
        }
        found.unseen.clear();
        Some(found)
    }
}
