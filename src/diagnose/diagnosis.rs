//! What is found out about a mesh, as data.

use super::UNSEEN;
use super::faces::FaceDifference;
use super::mannequin_words::ToldFor;
use super::mistake::Mistake;
use super::nearest::{NEARLY_ALL, Nearest};
use super::other_pose::OtherPose;
use super::precision::Coarse;
use super::ways::Made;
use crate::compare::MeshFinding;
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// What a mesh is, held against the exact one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The exact one, but for rounding.
    Right,
    /// Its vertices are the exact ones, but its triangles are not.
    Triangles,
    /// The one that known mistakes give.
    Explained,
    /// The exact one of another pose.
    OtherPose,
    /// None of these.
    Unexplained,
}

/// What is found out about a posed mesh. Errors are largest distances of two vertices by the size of
/// the exact mesh, the diagonal of its box; where they are not finite they are JSON null.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnosis {
    /// What it is.
    pub verdict: Verdict,
    /// Mistakes that together give the mesh, the one that accounts for more first, and then those of
    /// [`Self::same_as`], each once.
    pub causes: Vec<&'static str>,
    /// How far the mesh is from the one that is made with these mistakes; without any, from the exact
    /// one.
    pub error: f64,
    /// How far it is from the exact one.
    pub error_from_exact: f64,
    /// Up to which error meshes agree.
    pub tolerance: f64,
    /// In words the mistakes that together give the mesh, in the same order.
    pub mistakes: Vec<ToldMistake>,
    /// Mistakes that give the same mesh here, each with those that are made beside it.
    pub same_as: Vec<Vec<&'static str>>,
    /// In words the mistakes that are in [`Self::same_as`] alone, each once, as they are made there.
    #[serde(skip)]
    pub others: Vec<ToldMistake>,
    /// Joints each of which would give the mesh as well if it alone were not turned.
    pub not_turned: Vec<String>,
    /// Mistakes that by themselves would move no vertex by more than [`UNSEEN`].
    pub slight: Vec<&'static str>,
    /// Of a mesh that is right, mistakes that give it as well here, each by itself and made in the usual way: the pose or
    /// the character does not show them.
    pub unseen: Vec<&'static str>,
    /// Where it shows first; `None` if the mesh is right.
    pub first: Option<Shown>,
    /// How its triangles differ, which the verdict counts only where its vertices are right.
    #[serde(flatten)]
    pub faces: FaceDifference,
    /// Number of vertices that are off.
    pub off: usize,
    /// Share of the others, 0 to 1.
    pub agrees: f64,
    /// The same among the vertices that the pose moves; 1 where it moves none.
    pub moved_agree: f64,
    /// Share of the vertices that a loop comes to, or that have weights; 1 unless some are left where they were or at the
    /// origin.
    pub reached: f64,
    /// Whether it is the mesh at rest as the character's file has it, where that is asked for: nearly right, since the
    /// weights do not quite sum to 1.
    pub is_as_in_file: bool,
    /// How many vertices are no numbers (nan or infinite).
    pub no_numbers: usize,
    /// Of a mesh that is nearly right, in words which vertices at an end are where they were before, or which are at the origin.
    pub not_reached: Option<String>,
    /// Where vertices are off, by the joints that move them most, the one with the most first; empty
    /// unless nothing explains the mesh.
    pub regions: Vec<Region>,
    /// The pose of which it is the exact mesh, if there is one.
    pub other_pose: Option<OtherPose>,
    /// The mistake that comes nearest, if it explains at least half of what is off and no other pose all of
    /// it.
    pub nearest: Option<Nearest>,
    /// What else is known of the whole mesh.
    pub findings: Vec<OfTheWhole>,
    /// How its numbers are rounded, if that is too coarse to tell mistakes apart.
    pub coarse: Option<Coarse>,
    /// Whose program it is told for.
    #[serde(skip)]
    pub told_for: ToldFor,
}

/// What a mesh is nearly, which no known mistake gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NearlyRight<'a> {
    /// The exact one, with numbers that are rounded too coarsely.
    Rounded,
    /// One that is off everywhere by so little that nobody sees it.
    Close,
    /// The exact one moved, turned or scaled as a whole.
    Placed,
    /// The one of a mistake, but for few vertices.
    ButForFewWith(&'a ToldMistake),
    /// The exact one, but for few vertices.
    ButForFew,
}

/// What gives the whole mesh from the exact one, without a mistake in skinning; in JSON a sentence.
#[derive(Clone, Debug, PartialEq)]
pub struct OfTheWhole(pub MeshFinding);

impl Serialize for OfTheWhole {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// A mistake in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ToldMistake {
    /// Its name.
    pub id: &'static str,
    /// What the program does.
    pub meaning: &'static str,
    /// Which way of it; empty if there is one only.
    pub how: Cow<'static, str>,
    /// Section of the assignment.
    pub section: &'static str,
    /// What to look at in the code.
    pub look_at: &'static str,
}

impl ToldMistake {
    pub(super) fn new(made: Made) -> Self {
        Self {
            how: made.reading.how.into(),
            ..Self::whole(made.mistake)
        }
    }

    /// Mistakes, each made in the way that stands with it.
    pub(super) fn all_made(mistakes: Vec<(&'static Mistake, String)>) -> Vec<Self> {
        let told = mistakes.into_iter().map(|(mistake, how)| Self {
            how: how.into(),
            ..Self::whole(mistake)
        });
        told.collect()
    }

    /// A mistake that is made in one way.
    pub(super) fn whole(mistake: &Mistake) -> Self {
        Self {
            id: mistake.id,
            meaning: mistake.meaning,
            how: "".into(),
            section: mistake.section,
            look_at: mistake.look_at,
        }
    }
}

/// A vertex that shows what is wrong.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shown {
    /// Name of the first joint, from the root on, whose own vertices are much off; `None` if vertices without weights are.
    pub joint: Option<String>,
    /// Its index.
    pub joint_index: Option<usize>,
    /// Of its vertices the one that is farthest off, from 0.
    pub vertex: usize,
    /// How far, by the size.
    pub error: f64,
    /// Where it is, in model space.
    pub theirs: [f64; 3],
    /// Where it should be.
    pub exact: [f64; 3],
}

/// What a joint moves, as far as it is off.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Region {
    /// Name of the joint; `None` for vertices without weights.
    pub joint: Option<String>,
    /// Its index.
    pub joint_index: Option<usize>,
    /// Number of vertices that it moves more than any other joint.
    pub vertices: usize,
    /// How many of them are off.
    pub off: usize,
    /// The same by their number, 0 to 1.
    pub share: f64,
    /// How far at most, by the size.
    pub worst: f64,
    /// The vertex that is so far off, from 0.
    pub worst_vertex: usize,
}

/// Names of the mistakes in words, and then all others of those that give the same, each once.
pub(super) fn all_causes(
    mistakes: &[ToldMistake],
    same_as: &[Vec<&'static str>],
) -> Vec<&'static str> {
    let mut causes: Vec<&'static str> = Vec::new();
    let told = mistakes.iter().map(|mistake| mistake.id);
    for id in told.chain(same_as.iter().flatten().copied()) {
        if !causes.contains(&id) {
            causes.push(id);
        }
    }
    causes
}

impl Diagnosis {
    /// Whether vertices are the exact ones, no triangle is missing and none winds the other way.
    pub fn is_right(&self) -> bool {
        self.verdict == Verdict::Right
    }

    /// What a mesh that nothing explains is nearly; `None` for one that is explained, and for one that is far off.
    pub fn nearly_right(&self) -> Option<NearlyRight<'_>> {
        if self.verdict != Verdict::Unexplained {
            return None;
        }
        let nearest = self.nearest.as_ref();
        let mut findings = self.findings.iter();
        if self.coarse.is_some_and(|coarse| coarse.may_be_right) {
            Some(NearlyRight::Rounded)
        } else if self.error_from_exact <= UNSEEN {
            Some(NearlyRight::Close)
        } else if findings.any(|finding| finding.0.is_placement()) {
            Some(NearlyRight::Placed)
        } else if let Some(nearest) = nearest.filter(|nearest| nearest.is_nearly_all()) {
            Some(NearlyRight::ButForFewWith(&nearest.mistake))
        } else {
            let is_nearly_all = self.findings.is_empty() && self.agrees >= NEARLY_ALL;
            is_nearly_all.then_some(NearlyRight::ButForFew)
        }
    }

    /// The same, where mistakes, each made in the way that stands with it, together give the mesh but for `error`, by the
    /// size.
    pub fn explained_by(self, mistakes: Vec<(&'static Mistake, String)>, error: f64) -> Self {
        let mistakes = ToldMistake::all_made(mistakes);
        Self {
            verdict: Verdict::Explained,
            causes: mistakes.iter().map(|mistake| mistake.id).collect(),
            error,
            mistakes,
            regions: Vec::new(),
            other_pose: None,
            nearest: None,
            findings: Vec::new(),
            not_turned: Vec::new(),
            no_numbers: 0,
            not_reached: None,
            is_as_in_file: false,
            ..self
        }
    }

    /// The same with another mistake beside what gives the mesh.
    pub(super) fn beside(mut self, mistake: ToldMistake) -> Self {
        self.verdict = Verdict::Explained;
        // In the pose that lacks a joint it is no longer right, either.
        self.not_turned.clear();
        for same in &mut self.same_as {
            same.push(mistake.id);
        }
        self.mistakes.push(mistake);
        self.causes = all_causes(&self.mistakes, &self.same_as);
        self.unseen.clear();
        self
    }

    /// Whether all vertices are in one place.
    pub fn is_in_one_place(&self) -> bool {
        let mut findings = self.findings.iter();
        findings.any(|finding| matches!(finding.0, MeshFinding::OnePlace { .. }))
    }

    /// Takes into account how triangles differ.
    pub(super) fn judge(&mut self, faces: FaceDifference) {
        self.faces = faces;
        if self.verdict == Verdict::Right && faces.mistakes().next().is_some() {
            self.verdict = Verdict::Triangles;
            self.mistakes = faces.mistakes().map(ToldMistake::whole).collect();
            self.causes = self.together();
        }
    }

    /// Names of the mistakes that together give the mesh.
    pub fn together(&self) -> Vec<&'static str> {
        self.mistakes.iter().map(|mistake| mistake.id).collect()
    }
}
