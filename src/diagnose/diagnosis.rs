//! What is found out about a mesh, as data and in words.

use super::faces::FaceDifference;
use super::mistakes::Mistake;
use super::nearest::{NEARLY_ALL, Nearest};
use super::other_pose::OtherPose;
use super::search::Made;
use crate::compare::MeshFinding;
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::fmt;

/// Regions that are told in words; the others are counted.
const TOLD: usize = 5;

/// What to look at where a mesh is right in another pose.
const LOOK_AT_POSE: &str = "whether the mesh was made in the given pose; if it was, how the program comes to \
                            its angles";

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
    /// Of a mesh that is right, mistakes that give it as well here, each by itself: the pose or the character does
    /// not show them.
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
}

/// What gives the whole mesh from the exact one, without a mistake in skinning; in JSON a sentence.
#[derive(Clone, Debug, PartialEq)]
pub struct OfTheWhole(pub MeshFinding);

impl fmt::Display for OfTheWhole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "with A for the exact mesh and B for this one: {}",
            self.0
        )
    }
}

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
    /// Name of the first joint, from the root on, that moves vertices that are off; `None` if no
    /// joint does.
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

impl fmt::Display for ToldMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.id, self.meaning)?;
        match &*self.how {
            "" => Ok(()),
            how => write!(f, " ({how})"),
        }
    }
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(joint) = &self.joint {
            write!(f, "{joint}, ")?;
        }
        let (theirs, exact) = (vector(self.theirs), vector(self.exact));
        write!(
            f,
            "vertex {} (from 0): theirs {theirs}, exact {exact}",
            self.vertex
        )
    }
}

impl Region {
    /// In words which joint it is of, and which part of it is off.
    pub fn extent(&self) -> String {
        let joint = self.joint.as_deref().unwrap_or("vertices without weights");
        format!("{joint}: {}", percent(self.share))
    }
}

impl fmt::Display for Region {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let worst = of_size(self.worst);
        write!(f, "{} of its vertices, by up to {worst}", self.extent())
    }
}

/// A place in words. What rounds to nothing has no sign.
pub(super) fn vector(of: [f64; 3]) -> String {
    let [x, y, z] = of.map(|value| if value.abs() <= 5e-5 { 0.0 } else { value });
    format!("({x:.4}, {y:.4}, {z:.4})")
}

/// A share in words. What is not all is never told as all, nor what is not nothing as nothing.
fn percent(share: f64) -> String {
    match 100.0 * share {
        percent if percent < 1.0 => "less than 1 %".to_owned(),
        percent if percent > 99.0 && percent < 100.0 => "more than 99 %".to_owned(),
        percent => format!("{percent:.0} %"),
    }
}

/// A distance in words, which is given by the size.
pub fn of_size(error: f64) -> String {
    match part_of_size(error) {
        part if part.ends_with('%') => part + " of the size",
        words => words,
    }
}

/// The same where it is said already what it is a part of.
pub fn part_of_size(error: f64) -> String {
    match 100.0 * error {
        percent if percent.is_infinite() => "more than any number".to_owned(),
        percent if percent < 0.001 => "less than 0.001 %".to_owned(),
        percent if percent < 1.0 => format!("{percent:.3} %"),
        percent => format!("{percent:.1} %"),
    }
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

/// Names of mistakes that are made together.
pub(super) fn together(ids: &[&str]) -> String {
    ids.join(" and ")
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.verdict {
            Verdict::Right | Verdict::Triangles => {
                let error = of_size(self.error);
                let what = if self.is_right() {
                    "right: this is"
                } else {
                    "right but for its triangles: its vertices are"
                };
                write!(f, "{what} the exact result, but for {error}")
            }
            Verdict::Explained => self.fmt_explained(f),
            Verdict::OtherPose | Verdict::Unexplained => self.fmt_unexplained(f),
        }?;
        if !self.faces.is_none() {
            write!(f, "\n  but      {}", self.faces)?;
        }
        if self.verdict == Verdict::Triangles {
            fmt_where(&self.mistakes, f)?;
        }
        if !self.unseen.is_empty() {
            let unseen = self.unseen.join(", ");
            write!(
                f,
                "\n  unseen   {unseen}: with these mistakes it would be the same here"
            )?;
        }
        Ok(())
    }
}

impl Diagnosis {
    /// Whether vertices are the exact ones, no triangle is missing and none winds the other way.
    pub fn is_right(&self) -> bool {
        self.verdict == Verdict::Right
    }

    /// Whether nothing explains the few vertices that are off.
    pub fn is_right_but_for_few(&self) -> bool {
        let is_nearest = self.nearest.as_ref().is_some_and(Nearest::is_nearly_all);
        self.verdict == Verdict::Unexplained
            && self.findings.is_empty()
            && !is_nearest
            && self.agrees >= NEARLY_ALL
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

    fn fmt_explained(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt_mistakes(&self.mistakes, f)?;
        let (error, exact) = (of_size(self.error), of_size(self.error_from_exact));
        write!(
            f,
            "\n  agrees   but for {error}; the exact result is {exact} away"
        )?;
        fmt_where(&self.mistakes, f)?;
        if let Some(first) = &self.first {
            write!(f, "\n  shown by {first}")?;
        }
        if !self.same_as.is_empty() {
            let all: Vec<String> = self.same_as.iter().map(|ids| together(ids)).collect();
            write!(f, "\n  indistinguishable here: {}", all.join(", "))?;
        }
        Ok(())
    }

    fn fmt_unexplained(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let error = of_size(self.error);
        match &self.other_pose {
            Some(other) => fmt_other_pose(f, other, &error)?,
            None => write!(
                f,
                "unexplained: {error} away from the exact result in this pose, and no known mistake \
                 gives this mesh, nor do two of them"
            )?,
        }
        for finding in &self.findings {
            write!(f, "\n  found    {finding}")?;
        }
        if self.is_right_but_for_few() {
            let vertices = if self.off == 1 { "vertex" } else { "vertices" };
            write!(f, "\n  found    right but for {} {vertices}", self.off)?;
        }
        if let Some(nearest) = &self.nearest {
            let mistake = &nearest.mistake;
            let explains = percent(nearest.explains);
            write!(f, "\n  nearest  {mistake}; that explains {explains} of it")?;
            if nearest.is_nearly_all() {
                let vertices = if nearest.off == 1 {
                    "vertex"
                } else {
                    "vertices"
                };
                write!(f, ", all but {} {vertices}", nearest.off)?;
            }
            fmt_where(std::slice::from_ref(mistake), f)?;
        }
        if let Some(first) = &self.first {
            write!(f, "\n  shown by {first}")?;
        }
        for region in self.regions.iter().take(TOLD) {
            write!(f, "\n  off      {region}")?;
        }
        match self.regions.len().saturating_sub(TOLD) {
            0 => Ok(()),
            1 => write!(f, "\n  off      and at 1 more joint"),
            more => write!(f, "\n  off      and at {more} more joints"),
        }
    }
}

/// What is told of a mesh that is right in another pose, and `error` away from the one that was expected.
fn fmt_other_pose(f: &mut fmt::Formatter<'_>, other: &OtherPose, error: &str) -> fmt::Result {
    write!(
        f,
        "another pose: this is the exact result, but of a pose that is not the given one, in which it is \
         {error} away"
    )?;
    let (told, more) = other.told();
    for joint in told {
        match joint.moved {
            Some(moved) if !joint.is_turned() => {
                write!(
                    f,
                    "\n  moved    {} by {}",
                    joint.joint,
                    vector(moved.map(f64::from))
                )?;
            }
            _ => write!(f, "\n  turned   {joint}")?,
        }
    }
    match more {
        0 => {}
        1 => f.write_str("\n  turned   and 1 more joint")?,
        more => write!(f, "\n  turned   and {more} more joints")?,
    }
    write!(f, "\n  look at  {LOOK_AT_POSE}")
}

/// Mistakes that are made together, in words.
pub(super) fn fmt_mistakes(mistakes: &[ToldMistake], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if let [mistake] = mistakes {
        return write!(f, "{mistake}");
    }
    let ids: Vec<&str> = mistakes.iter().map(|mistake| mistake.id).collect();
    write!(f, "{} mistakes: {}", ids.len(), together(&ids))?;
    mistakes
        .iter()
        .try_for_each(|mistake| write!(f, "\n  {mistake}"))
}

/// Lines that tell where to look for mistakes, each once.
pub(super) fn fmt_where(mistakes: &[ToldMistake], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (index, mistake) in mistakes.iter().enumerate() {
        let mut before = mistakes[..index].iter();
        if before.all(|told| told.look_at != mistake.look_at) {
            write!(f, "\n  section  {}", mistake.section)?;
            write!(f, "\n  look at  {}", mistake.look_at)?;
        }
    }
    Ok(())
}
