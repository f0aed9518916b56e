//! What the file of one test is.

use super::kept::FROM_OTHER_TESTS;
use crate::diagnose::{JOINT_NOT_TURNED, Mistake, POSE_LATE};
use serde::{Deserialize, Serialize};

/// What became of a test.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// The exact result, but for rounding.
    Right,
    /// What known mistakes give.
    Explained,
    /// The exact result of another pose.
    #[serde(rename = "other-pose")]
    OtherPose,
    /// Something else.
    Unexplained,
    /// A file with nothing in it that could be right or wrong.
    Blank,
    /// No file.
    Missing,
    /// A file that cannot be read, or has another number of vertices or pixels.
    Unreadable,
    /// The command failed, took too long or too much memory.
    Failed,
}

impl Outcome {
    /// The word for it, as in `grade.json`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Explained => "explained",
            Self::OtherPose => "other-pose",
            Self::Unexplained => "unexplained",
            Self::Blank => "blank",
            Self::Missing => "missing",
            Self::Unreadable => "unreadable",
            Self::Failed => "failed",
        }
    }
}

/// The result of one test, without points: these follow from the rubric.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Graded {
    /// What the file is.
    pub outcome: Outcome,
    /// The diagnosis in words, or why there is none.
    pub text: String,
    /// What is known of it beyond its outcome, in a few words.
    pub hint: Option<String>,
    /// Mistakes that together give the file, by name; the first are those of the text, the others
    /// give the same.
    pub causes: Vec<Vec<String>>,
    /// Of a file that nothing explains and that is nearly right, what is wrong with it, by name: a mistake,
    /// [`RIGHT_BUT_FOR_FEW`](crate::io::RIGHT_BUT_FOR_FEW),
    /// [`RIGHT_BUT_FOR_DIGITS`](crate::io::RIGHT_BUT_FOR_DIGITS),
    /// [`RIGHT_BUT_FOR_LITTLE`](crate::io::RIGHT_BUT_FOR_LITTLE) or
    /// [`MOVED_AS_A_WHOLE`](crate::diagnose::MOVED_AS_A_WHOLE); of another pose whether its numbers are too coarse as well.
    pub nearly: Vec<String>,
    /// Mistakes of the causes that by themselves would move no vertex by more than 0.1 %, by name.
    pub slight: Vec<String>,
    /// How far the file is from the exact one, by the size; `None` without a diagnosis, and where it
    /// is not finite.
    pub error: Option<f64>,
    /// Share of the vertices or of the silhouette that agrees, 0 to 1.
    pub agrees: f64,
    /// What its vertices count for by how near they are, or the share of the silhouette that agrees, 0 to 1; where a loop leaves
    /// vertices out, no less than the share of the others.
    pub near: f64,
    /// How much of the test's pose another one has, 0 to 1
    /// ([`OtherPose::as_expected`](crate::diagnose::OtherPose::as_expected)); 0 without another pose, and where that is the
    /// one of another test.
    pub posed: f64,
    /// Of a picture that nothing explains, or that is of another pose, the test whose mesh of the submission it shows, by name.
    pub shows: Option<String>,
    /// The other tests of which it is a result.
    pub of_tests: Vec<OfTest>,
    /// A PNG that shows what is off, as Base64.
    pub picture: Option<String>,
}

/// Another test, of which a file is a result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OfTest {
    /// Name of the test.
    pub name: String,
    /// Mistakes that together give the file in it, by name, those that are told first; empty if it is the exact result.
    pub with: Vec<Vec<String>>,
}

impl Graded {
    /// A result without a diagnosis, and why there is none.
    pub fn without(outcome: Outcome, text: impl Into<String>) -> Self {
        Self {
            outcome,
            text: text.into(),
            hint: None,
            causes: Vec::new(),
            nearly: Vec::new(),
            slight: Vec::new(),
            error: None,
            agrees: 0.0,
            near: 0.0,
            posed: 0.0,
            shows: None,
            of_tests: Vec::new(),
            picture: None,
        }
    }
}

impl Graded {
    /// The same, where it is a picture of the mesh of the test `name` in the submission, which has the result `mesh`.
    pub(super) fn showing(self, name: &str, mesh: &Self) -> Self {
        let shown = format!("it shows {name}.obj of the submission");
        if mesh.outcome == Outcome::Unexplained && mesh.nearly.is_empty() {
            return Self {
                text: format!("{shown}, which nothing explains either\n{}", self.text),
                ..self
            };
        }
        Self {
            text: format!("{shown}:\n{}", mesh.text),
            picture: self.picture,
            error: self.error,
            agrees: self.agrees,
            shows: self.shows,
            ..mesh.clone()
        }
    }

    /// The same, where it is known to be the exact result of another test.
    pub(super) fn of_other_test(self, name: &str) -> Self {
        self.posed_by_other(
            format!(
                "another test: this is exactly the result of {name}, so that the file may have the wrong name"
            ),
            format!("the result of {name}"),
        )
    }

    /// The same, where it is known to be what mistakes give in the test `other`.
    pub(super) fn of_other_test_with(self, other: &OfTest) -> Self {
        let name = &other.name;
        let ids = other
            .with
            .first()
            .map_or(String::new(), |ids| ids.join(" and "));
        self.posed_by_other(
            format!(
                "another test: this is the result of {name}, with {ids}, so that the file may have the wrong name, or \
                 the program may read that pose for every test"
            ),
            format!("the result of {name}, with {ids}"),
        )
    }

    /// The same, where all meshes of the character that are handed in are a result of the test `other`.
    pub(super) fn of_one_test(self, other: &OfTest) -> Self {
        let what = match other.with.first() {
            None => other.name.clone(),
            Some(ids) => format!("{}, with {}", other.name, ids.join(" and ")),
        };
        self.posed_by_other(
            format!(
                "another test: this is the result of {what}, as all meshes of this character are, so that the program \
                 may go on with one pose, or write one mesh, for every test"
            ),
            format!("the result of {what}, as in all tests"),
        )
    }

    /// The same, where it is known to be the exact result in the pose of another test, of another character.
    pub(super) fn in_pose_of_other_test(self, name: &str) -> Self {
        self.posed_by_other(
            format!(
                "another pose: this is exactly the character in the pose of {name}, so that the program may read \
                 that pose for every test"
            ),
            format!("the pose of {name}"),
        )
    }

    fn posed_by_other(self, text: String, hint: String) -> Self {
        Self {
            outcome: Outcome::OtherPose,
            text,
            hint: Some(hint),
            nearly: Vec::new(),
            posed: 0.0,
            ..self
        }
    }

    /// Whether nothing tells against another pose than that of its test: it is wrong, and not by mistakes that no pose
    /// makes.
    pub(super) fn may_be_of_other_pose(&self) -> bool {
        let is_of_angles =
            |id: &String| Mistake::find(id).is_some_and(|it| it.section == POSE_LATE.section);
        let lacks_joint = |ids: &[String]| ids.iter().any(|id| *id == JOINT_NOT_TURNED.id);
        match self.outcome {
            Outcome::OtherPose | Outcome::Unexplained => true,
            Outcome::Explained => {
                let mut causes = self.causes.iter();
                causes.any(|ids| ids.iter().all(is_of_angles) || lacks_joint(ids))
            }
            _ => false,
        }
    }

    /// Whether it follows from all tests, and not from its own alone.
    pub fn is_of_all_tests(&self) -> bool {
        let is_of_others = |ids: &Vec<String>| {
            let mut ids = ids.iter();
            ids.any(|id| FROM_OTHER_TESTS.iter().any(|mistake| mistake.id == id))
        };
        self.may_be_of_other_pose() || self.causes.iter().any(is_of_others)
    }
}

/// A measure with nine digits after the point, which reads back to itself; `None` if it is not finite.
pub(super) fn rounded(measure: f64) -> Option<f64> {
    measure.is_finite().then(|| (measure * 1e9).round() / 1e9)
}
