//! Which mistake a picture shows, by the silhouette of the character.

use super::diagnosis::{ToldMistake, Verdict, all_causes, together};
use super::formula::{Formula, VertexOrder};
use super::mistakes::MISTAKES;
use super::model::Model;
use super::search::{Made, formula, ways};
use super::silhouette::{Samples, Silhouette};
use super::skin::Skinner;
use crate::character::{Character, Pose};
use crate::geometry::Picture;
use glam::{DVec3, Mat4};
use serde::Serialize;
use std::fmt;

/// Part of the silhouette that may be off in pictures that agree.
const TOLERANCE: f64 = 0.002;
/// Part by which mistakes may differ and are as good.
const AS_GOOD: f64 = 0.0005;

/// Reason why a picture cannot be one of a character.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PictureError {
    /// Nothing in it differs from its background.
    #[error("expected a picture of the character, found nothing but the background")]
    Blank,
}

/// What is found out about a picture. Errors are the pixels that only one of two silhouettes has,
/// without those at their edges, by the area of the picture's silhouette and the exact one together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PictureDiagnosis {
    /// What it shows, as far as the silhouette tells.
    pub verdict: Verdict,
    /// The mistakes of which each gives the silhouette, the most telling first.
    pub causes: Vec<&'static str>,
    /// How far the silhouette is from the one with this mistake; without one, from the exact one.
    pub error: f64,
    /// How far it is from the exact one.
    pub error_from_exact: f64,
    /// Up to which error silhouettes agree.
    pub tolerance: f64,
    /// How sure it is, 0 to 1: of a cause one by the number of mistakes that give the same silhouette,
    /// of a picture that is right the share of mistakes that would show, of others 0.
    pub sure: f64,
    /// The cause in words.
    pub mistakes: Vec<ToldMistake>,
    /// Other mistakes that give the same silhouette here.
    pub same_as: Vec<Vec<&'static str>>,
    /// The box around what is off, as the pixels x, y, width and height; `None` if nothing is.
    pub off_within: Option<[u32; 4]>,
}

/// Finds out which mistake gives the silhouette in `picture`, of which the character in `pose` is all
/// that is drawn, seen with `clip_from_model`.
///
/// # Errors
/// If nothing is drawn.
pub fn diagnose_picture(
    character: &Character,
    pose: &Pose,
    picture: &Picture,
    clip_from_model: Mat4,
) -> Result<PictureDiagnosis, PictureError> {
    let model = Model::new(character);
    let samples = Samples::new(picture.width, picture.height);
    let theirs = Silhouette::of_picture(picture, samples);
    if theirs.area_with(&theirs) == 0 {
        return Err(PictureError::Blank);
    }
    let seen = |formula: &Formula| {
        let mut skinner = Skinner::new(&model, pose, formula);
        let points: Vec<DVec3> = (0..skinner.count())
            .map(|at| skinner.place(at).at)
            .collect();
        let triangles = &character.bind_mesh().triangles;
        Silhouette::of_mesh(&points, triangles, clip_from_model.as_dmat4(), samples)
    };
    let exact = seen(&Formula::default());
    let area = theirs.area_with(&exact) as f64;
    let error_of = |silhouette: &Silhouette| theirs.off(silhouette).count() as f64 / area;
    let error = error_of(&exact);
    let mut found = PictureDiagnosis {
        verdict: Verdict::Right,
        causes: Vec::new(),
        error,
        error_from_exact: error,
        tolerance: TOLERANCE,
        sure: 0.0,
        mistakes: Vec::new(),
        same_as: Vec::new(),
        off_within: exact.bounds(theirs.off(&exact)),
    };
    let tried: Vec<(Made, f64)> = ways()
        .filter_map(|made| {
            let formula = formula(&[made]);
            // The picture is the same whatever the order in which vertices are kept.
            let is_in_order = formula.vertex_order == VertexOrder::File
                || formula.vertex_order == VertexOrder::FirstUseInside;
            is_in_order.then(|| (made, error_of(&seen(&formula))))
        })
        .collect();
    found.explain(&tried);
    Ok(found)
}

impl PictureDiagnosis {
    /// Takes the mistakes that were tried, each with its error, into account.
    fn explain(&mut self, tried: &[(Made, f64)]) {
        let least = tried
            .iter()
            .map(|(_, error)| *error)
            .fold(f64::INFINITY, f64::min);
        let is_right = self.error <= TOLERANCE;
        let enough = if is_right { self.error } else { least } + AS_GOOD;
        let mut alike: Vec<(Made, f64)> = Vec::new();
        for &(made, error) in tried.iter().filter(|(_, error)| *error <= enough) {
            if alike
                .iter()
                .all(|(known, _)| known.mistake.id != made.mistake.id)
            {
                alike.push((made, error));
            }
        }
        if is_right {
            self.sure = 1.0 - alike.len() as f64 / MISTAKES.len() as f64;
        } else if least <= TOLERANCE {
            self.verdict = Verdict::Explained;
            self.sure = 1.0 / alike.len() as f64;
            let mut alike = alike.into_iter();
            if let Some((made, error)) = alike.next() {
                self.mistakes.push(ToldMistake::new(made));
                self.error = error;
            }
            self.same_as = alike.map(|(made, _)| vec![made.mistake.id]).collect();
            self.causes = all_causes(&self.mistakes, &self.same_as);
        } else {
            self.verdict = Verdict::Unexplained;
        }
    }
}

impl fmt::Display for PictureDiagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (error, exact) = (percent(self.error), percent(self.error_from_exact));
        match (self.verdict, &self.mistakes[..]) {
            (Verdict::Explained, [mistake, ..]) => {
                write!(f, "{mistake}")?;
                write!(
                    f,
                    "\n  agrees   but for {error} of the silhouette; the exact one is {exact} off"
                )?;
                mistake.fmt_where(f)?;
                if !self.same_as.is_empty() {
                    let others: Vec<String> =
                        self.same_as.iter().map(|ids| together(ids)).collect();
                    write!(f, "\n  or, with the same silhouette: {}", others.join(", "))?;
                }
            }
            (Verdict::Right, _) => {
                let sure = 100.0 * self.sure;
                write!(
                    f,
                    "right, as far as the silhouette tells: {error} of it is off; {sure:.0} % of the \
                     known mistakes would show"
                )?;
            }
            _ => write!(
                f,
                "unexplained: {error} of the silhouette is off, and no known mistake gives this one"
            )?,
        }
        match self.off_within.filter(|_| self.verdict != Verdict::Right) {
            Some([x, y, width, height]) => {
                write!(f, "\n  shown by the pixels within {x},{y},{width},{height}")
            }
            None => Ok(()),
        }
    }
}

/// A share in words.
fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}
