//! The rubric in the file that a class is graded by: points and sections.

use super::scanner::quoted;
use crate::diagnose::Mistake;
use serde::de::{Deserializer, Error as _};
use serde::{Deserialize, Serialize};
use serde_spanned::Spanned;
use std::borrow::Borrow;
use std::collections::BTreeMap;

/// Points that can be given at most.
const MOST_POINTS: f64 = 1e6;

/// A number of points, 0 or more.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd, Serialize)]
#[serde(transparent)]
pub struct Points(pub f64);

/// A part of a whole, 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Share(pub f64);

/// Name of a mesh that is right but for few vertices, or of a picture that is but for few pixels, which nothing explains.
pub const RIGHT_BUT_FOR_FEW: &str = "right-but-for-few";
/// Name of the exact mesh with numbers that are rounded too coarsely to tell mistakes apart.
pub const RIGHT_BUT_FOR_DIGITS: &str = "right-but-for-digits";
/// Name of a mesh that is off everywhere by so little that nobody sees it, and that nothing explains.
pub const RIGHT_BUT_FOR_LITTLE: &str = "right-but-for-little";
/// Name of the exact result of a pose in which few joints are not as asked.
pub const RIGHT_BUT_FOR_JOINTS: &str = "right-but-for-joints";
/// Name of the exact result of another pose.
pub const OTHER_POSE: &str = "other-pose";

/// Name of a mistake that is known, of a file that is nearly right, or of another pose.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(try_from = "String")]
pub struct MistakeName(String);

impl Borrow<str> for MistakeName {
    fn borrow(&self) -> &str {
        &self.0
    }
}

/// How points are given.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RubricData {
    /// Sections by number or name; those of tests need not be here.
    pub sections: BTreeMap<String, SectionData>,
    /// Part of a section's points that is left for each mistake in it.
    pub mistake: Share,
    /// The same for some mistakes by name.
    pub mistakes: BTreeMap<MistakeName, Share>,
    /// Part of a test's points that is given where no known mistake explains it, for the share that vertices count for by how
    /// near they are.
    pub unexplained: Share,
    /// Points that a person gives, by submission and section.
    pub given: BTreeMap<String, BTreeMap<String, Spanned<Points>>>,
}

impl Default for RubricData {
    fn default() -> Self {
        Self {
            sections: BTreeMap::new(),
            mistake: Share(0.5),
            mistakes: BTreeMap::new(),
            unexplained: Share(0.5),
            given: BTreeMap::new(),
        }
    }
}

/// A section of the assignment.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SectionData {
    /// What it is called beside its number.
    pub title: String,
    /// What it is worth; without it as much as its tests are together.
    pub points: Option<Points>,
    /// Whether its points come on top of what is possible.
    pub extra: bool,
}

impl TryFrom<String> for MistakeName {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        let others = [
            RIGHT_BUT_FOR_FEW,
            RIGHT_BUT_FOR_DIGITS,
            RIGHT_BUT_FOR_LITTLE,
            RIGHT_BUT_FOR_JOINTS,
            OTHER_POSE,
        ];
        if Mistake::find(&name).is_some() || others.contains(&&*name) {
            return Ok(Self(name));
        }
        let ids = Mistake::all().map(|mistake| mistake.id);
        let ids = ids.chain(others);
        let nearest = ids.min_by_key(|id| strsim::levenshtein(id, &name));
        Err(format!(
            "expected the name of a mistake such as {}, found {}",
            nearest.unwrap_or_default(),
            quoted(&name)
        ))
    }
}

impl<'de> Deserialize<'de> for Points {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        number_up_to(deserializer, MOST_POINTS).map(Self)
    }
}

impl<'de> Deserialize<'de> for Share {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        number_up_to(deserializer, 1.0).map(Self)
    }
}

fn number_up_to<'de, D: Deserializer<'de>>(deserializer: D, most: f64) -> Result<f64, D::Error> {
    let number = f64::deserialize(deserializer)?;
    if (0.0..=most).contains(&number) {
        return Ok(number);
    }
    let message = format!("expected a number from 0 to {most}, found {number}");
    Err(D::Error::custom(message))
}
