//! A mistake that is made on purpose, and the mesh with it.

use super::Explained;
use crate::diagnose::{Formula, Mistake, Reading, ToldFor, ToldMistake, skin_by};
use crate::math::Aabb;
use crate::revision::Revision;
use crate::scene::EvaluatedGeometry;
use std::sync::Arc;

/// Distance up to which two meshes look the same, by the size.
const SEEN: f32 = 1e-4;

/// A mistake, and the way in which it is made.
#[derive(Clone, Copy, Debug)]
pub(super) struct Made {
    pub mistake: &'static Mistake,
    pub reading: &'static Reading,
}

impl PartialEq for Made {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.reading, other.reading)
    }
}

impl Made {
    /// One that was found in a mesh.
    pub(super) fn told(told: &ToldMistake) -> Option<Self> {
        let mistake = Mistake::find(told.id)?;
        let mut readings = mistake.readings.iter();
        let reading = readings.find(|reading| reading.how == told.how)?;
        Some(Self { mistake, reading })
    }

    /// The formula with the mistake.
    pub(super) fn formula(self) -> Formula {
        let mut formula = Formula::default();
        (self.reading.make)(&mut formula);
        formula
    }

    /// What a `program` does that makes it, in a sentence.
    pub(super) fn sentence(self, program: ToldFor) -> String {
        let meaning = capitalized(self.mistake.told_for(program).meaning);
        match self.reading.how {
            "" => format!("{meaning}."),
            how => format!("{meaning}: {how}."),
        }
    }
}

/// `text` with a capital at the beginning.
pub(super) fn capitalized(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// The mesh of a character with a mistake.
#[derive(Clone, Debug)]
pub(super) struct Mistaken {
    pub made: Made,
    /// Revision of the mesh without it.
    exact: Revision,
    pub geometry: Arc<EvaluatedGeometry>,
    /// Whether anything of it can be seen.
    pub is_seen: bool,
}

impl Mistaken {
    pub(super) fn new(made: Made, explained: &Explained) -> Option<Self> {
        let shape = explained.shape;
        let mesh = skin_by(&shape.character, shape.pose(), &made.formula());
        let exact = &explained.evaluated.geometry;
        let size = Aabb::from_points(exact.positions().iter().copied()).size();
        let mut pairs = exact.positions().iter().zip(&mesh.positions);
        let seen = SEEN * size.length();
        let is_seen = pairs.any(|(exact, mistaken)| {
            let distance = exact.distance(*mistaken);
            distance > seen || distance.is_nan()
        });
        Some(Self {
            made,
            exact: explained.revision(),
            geometry: Arc::new(exact.with_vertices(mesh.positions, mesh.normals)?),
            is_seen,
        })
    }

    /// Whether it is the mesh of this character in this pose.
    pub(super) fn is_of(&self, explained: &Explained) -> bool {
        self.exact == explained.revision()
    }
}
