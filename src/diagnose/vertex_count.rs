//! Meshes with one vertex more or fewer than the character has.

use super::diagnosis::ToldMistake;
use super::found_otherwise::{VERTEX_MISSING, VERTEX_TOO_MANY};
use super::mistake::Mistake;
use super::{Diagnosis, Verdict};
use crate::character::{Attachments, Character};
use crate::geometry::Mesh;
use glam::Vec3;
use std::ops::Range;

/// Where a program has one vertex too many, or lacks one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Miscount {
    AfterLast,
    BeforeFirst,
    WithoutLast,
    WithoutFirst,
}

impl Miscount {
    /// Where it may be, in the order in which that is tried, if a mesh of `character` has so many vertices.
    pub(super) fn places(character: &Character, found: usize) -> impl Iterator<Item = Self> {
        let expected = character.bind_mesh().positions.len();
        let is_possible = move |place: &Self| match place {
            Self::AfterLast | Self::BeforeFirst => found == expected + 1,
            // What else a Collada file says is of all vertices.
            Self::WithoutLast | Self::WithoutFirst => {
                found > 0 && found + 1 == expected && character.file_frames().is_none()
            }
        };
        let all = [
            Self::AfterLast,
            Self::BeforeFirst,
            Self::WithoutLast,
            Self::WithoutFirst,
        ];
        all.into_iter().filter(is_possible)
    }

    /// Whether it moves the numbers that faces name vertices by.
    pub(super) fn renumbers(self) -> bool {
        matches!(self, Self::BeforeFirst | Self::WithoutFirst)
    }

    /// The vertices without the one too many.
    pub(super) fn without(self, vertices: &[Vec3]) -> &[Vec3] {
        match (self, vertices) {
            (Self::AfterLast, [others @ .., _]) | (Self::BeforeFirst, [_, others @ ..]) => others,
            _ => vertices,
        }
    }

    /// The character without the vertex that is missing; `None` if none is.
    pub(super) fn lacking(self, character: &Character) -> Option<Character> {
        let bind = character.bind_mesh();
        let last = bind.positions.len().saturating_sub(1);
        let kept: Range<usize> = match self {
            Self::AfterLast | Self::BeforeFirst => return None,
            Self::WithoutLast => 0..last,
            Self::WithoutFirst => 1..last + 1,
        };
        with_vertices(character, &kept.collect::<Vec<usize>>())
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
        let (mistake, how): (&Mistake, _) = match self {
            Self::AfterLast => (&VERTEX_TOO_MANY, "after the last"),
            Self::BeforeFirst => (&VERTEX_TOO_MANY, "before the first"),
            Self::WithoutLast => (&VERTEX_MISSING, "the last"),
            Self::WithoutFirst => (&VERTEX_MISSING, "the first"),
        };
        if let (Self::BeforeFirst, Some(first)) = (self, &mut found.first) {
            first.vertex += 1;
        }
        Some(found.beside(ToldMistake {
            how: how.into(),
            ..ToldMistake::whole(mistake)
        }))
    }
}

/// The character with these vertices alone, in this order, and the triangles between them; `None` if that is none.
pub(super) fn with_vertices(character: &Character, kept: &[usize]) -> Option<Character> {
    let bind = character.bind_mesh();
    let mut number = vec![None; bind.positions.len()];
    for (index, &vertex) in (0_u32..).zip(kept) {
        number[vertex] = Some(index);
    }
    let triangles = bind.triangles.iter().filter_map(|corners| {
        let [a, b, c] = corners.map(|corner| number[corner as usize]);
        Some([a?, b?, c?])
    });
    let positions = kept.iter().map(|&vertex| bind.positions[vertex]);
    let mesh = Mesh::new(positions.collect(), triangles.collect());
    let mut attachments = Attachments::new();
    for &vertex in kept {
        let influences = character.attachments().of_vertex(vertex);
        attachments.push_vertex(influences.iter().copied());
    }
    Character::new(character.skeleton().clone(), attachments, mesh).ok()
}
