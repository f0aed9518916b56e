//! Which mistakes a picture shows, by the silhouette of the character.

use super::diagnosis::{ToldMistake, Verdict, all_causes};
use super::diagnosis_words::{fmt_mistakes, fmt_where, together};
use super::elsewhere;
use super::mistakes::MISTAKES;
use super::model::Model;
use super::picture_search::{Closeness, PictureSearch};
use super::search::Explanation;
use super::silhouette::{DRAWN, drawn_border};
use super::turned_picture;
use super::ways::ways_of_whole_program;
use crate::character::{Character, Pose};
use crate::geometry::Picture;
use glam::Mat4;
use serde::Serialize;
use std::fmt;

/// Part of the silhouette that may be off in pictures that agree.
const TOLERANCE: f64 = 0.001;
/// Part of the silhouette up to which a picture is nearly right.
const NEARLY: f64 = 0.005;
/// Difference from the background above which a pixel is drawn where parts of the figure may have nearly its color.
const EXACTLY: u8 = 0;
/// Part by which mistakes may differ and are as good.
const AS_GOOD: f64 = 0.0005;
/// Other explanations that are told in words; the others are counted.
const TOLD: usize = 5;

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
    /// What it shows, as far as the silhouette tells, which shows neither triangles nor other poses.
    pub verdict: Verdict,
    /// Mistakes that together give the silhouette, one or two, the one that accounts for more first, and
    /// then those of [`Self::same_as`], each once.
    pub causes: Vec<&'static str>,
    /// How far the silhouette is from the one with these mistakes; without any, from the exact one.
    pub error: f64,
    /// How far it is from the exact one.
    pub error_from_exact: f64,
    /// Up to which error silhouettes agree.
    pub tolerance: f64,
    /// How sure it is, 0 to 1: of causes one by the number of explanations of the same silhouette,
    /// of a picture that is right the share of mistakes that would show, of others 0.
    pub sure: f64,
    /// In words the mistakes that together give the silhouette, in the same order.
    pub mistakes: Vec<ToldMistake>,
    /// Mistakes that give the same silhouette here, each with those that are made beside it.
    pub same_as: Vec<Vec<&'static str>>,
    /// The box around what is off, as the pixels x, y, width and height; `None` if nothing is.
    pub off_within: Option<[u32; 4]>,
    /// Of a picture that nothing explains, how the exact silhouette is placed in it, in words, if nearly all of it is there but
    /// elsewhere, in another size or turned.
    pub placed: Option<String>,
    /// Whether hardly anything is drawn but lines and specks, which no mistake is looked for in.
    #[serde(skip)]
    pub is_scattered: bool,
    /// Whether what is off is missing from the picture, and nothing is there beside the exact silhouette.
    #[serde(skip)]
    pub only_lacks: bool,
    /// Share of the picture's border that differs from its background.
    #[serde(skip)]
    pub drawn_border: f64,
    /// Of a picture that is nearly right, the mistakes that give it as well as a camera does that is turned a little.
    #[serde(skip)]
    pub or_slight: Option<String>,
}

/// Finds out which mistakes give the silhouette in `picture`, of which the character in `pose` is all
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
    let clip_from_model = clip_from_model.as_dmat4();
    let drawn_border = drawn_border(picture);
    let mut unexplained = None;
    // Of a small figure limbs are lines as seen from afar, and lines beside it are limbs from near. Parts may have nearly
    // the color of the background.
    for noise in [DRAWN, EXACTLY] {
        for closeness in [Closeness::Figure, Closeness::Picture] {
            let at = (noise, closeness);
            let search = PictureSearch::new(&model, pose, picture, clip_from_model, at);
            let Some(search) = search else {
                continue;
            };
            let found = found(&search, drawn_border);
            let is_slight = found.verdict == Verdict::Explained && found.error_from_exact <= NEARLY;
            if is_slight && search.is_of_turned_camera(TOLERANCE) {
                return Ok(found.or_turned_camera());
            }
            if found.verdict != Verdict::Unexplained {
                return Ok(found);
            }
            // What is told is not about lines beside a small figure.
            if at != (DRAWN, Closeness::Figure) {
                unexplained.get_or_insert(found);
            }
        }
    }
    let mut found = unexplained.ok_or(PictureError::Blank)?;
    if !found.is_scattered {
        let at = (DRAWN, Closeness::Picture);
        let search =
            |turned: &Picture| PictureSearch::new(&model, pose, turned, clip_from_model, at);
        let turned = turned_picture::find(picture, TOLERANCE, search);
        if turned.is_empty() {
            found.placed = elsewhere::find(&model, pose, picture, clip_from_model);
        } else {
            found.explain(&turned);
        }
    }
    Ok(found)
}

/// What a search for one picture finds, of whose border this share is drawn.
fn found(search: &PictureSearch<'_>, drawn_border: f64) -> PictureDiagnosis {
    let error = search.error_from_exact;
    let mut found = PictureDiagnosis {
        verdict: Verdict::Right,
        causes: Vec::new(),
        error,
        error_from_exact: error,
        tolerance: TOLERANCE,
        sure: 0.0,
        mistakes: Vec::new(),
        same_as: Vec::new(),
        off_within: search.off_within,
        placed: None,
        is_scattered: false,
        only_lacks: search.only_lacks,
        drawn_border,
        or_slight: None,
    };
    if error > TOLERANCE && search.is_scattered {
        found.verdict = Verdict::Unexplained;
        found.is_scattered = true;
        return found;
    }
    let singles = search.singles();
    if error <= TOLERANCE {
        let unseen = alike(&singles, error).len();
        found.sure = 1.0 - unseen as f64 / MISTAKES.len() as f64;
        return found;
    }
    if least(&singles) <= TOLERANCE {
        found.explain(&singles);
        return found;
    }
    let of_whole = search.within(TOLERANCE, ways_of_whole_program());
    if of_whole.is_empty() {
        found.explain(&search.pairs(&singles, TOLERANCE));
    } else {
        found.explain(&of_whole);
    }
    found
}

/// Whether the silhouette in `picture` is the exact one, as by [`diagnose_picture`].
pub fn has_silhouette(
    character: &Character,
    pose: &Pose,
    picture: &Picture,
    clip_from_model: Mat4,
) -> bool {
    let model = Model::new(character);
    [DRAWN, EXACTLY].into_iter().any(|noise| {
        let clip_from_model = clip_from_model.as_dmat4();
        let mut closest = [Closeness::Figure, Closeness::Picture].into_iter();
        let search = closest.find_map(|closeness| {
            PictureSearch::new(&model, pose, picture, clip_from_model, (noise, closeness))
        });
        search.is_some_and(|search| search.error_from_exact <= TOLERANCE)
    })
}

/// The least that is left.
fn least(explanations: &[Explanation]) -> f64 {
    let errors = explanations.iter().map(|explanation| explanation.error);
    errors.fold(f64::INFINITY, f64::min)
}

/// Those that are as good as one that leaves `error`, each once, whatever the way in which it is made.
fn alike(explanations: &[Explanation], error: f64) -> Vec<&Explanation> {
    let mut alike: Vec<&Explanation> = Vec::new();
    for one in explanations {
        let ids = one.ids();
        let is_same = |known: &&Explanation| ids.iter().all(|id| known.ids().contains(id));
        if one.error <= error + AS_GOOD && !alike.iter().any(is_same) {
            alike.push(one);
        }
    }
    alike
}

impl PictureDiagnosis {
    /// Whether nothing explains what is off, which is little, such as a speck beside the figure.
    pub fn is_nearly_right(&self) -> bool {
        self.verdict == Verdict::Unexplained && self.error_from_exact <= NEARLY
    }

    /// The same where a camera that is turned a little gives the silhouette as well, so that no mistake is to blame.
    fn or_turned_camera(self) -> Self {
        let slight: Vec<&str> = self.mistakes.iter().map(|mistake| mistake.id).collect();
        Self {
            or_slight: Some(together(&slight)),
            verdict: Verdict::Unexplained,
            causes: Vec::new(),
            error: self.error_from_exact,
            sure: 0.0,
            mistakes: Vec::new(),
            same_as: Vec::new(),
            ..self
        }
    }

    /// What may be behind a silhouette that nothing explains, after a semicolon.
    fn what_it_may_be(&self) -> String {
        if let Some(placed) = &self.placed {
            format!(
                "; it is the exact one {placed}: the picture is seen through another camera, or the character stands elsewhere or \
                 otherwise"
            )
        } else if self.drawn_border > FLOOR {
            let share = 100.0 * self.drawn_border;
            format!(
                "; {share:.0} % of the picture's edge differ from the background: a floor, for one, is taken for a part of \
                 the figure, so that the character has to be drawn alone, before one color"
            )
        } else if self.only_lacks {
            "; all of it is missing from the picture, where the figure may have the color of the background: draw it before \
             another one"
                .to_owned()
        } else if self.error_from_exact > MUCH {
            "; where so much is off, the picture may be seen through another camera, or have more around the view"
                .to_owned()
        } else {
            String::new()
        }
    }

    /// Where it is off.
    fn fmt_off_within(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.off_within.filter(|_| self.verdict != Verdict::Right) {
            Some([x, y, width, height]) => {
                write!(f, "\n  shown by the pixels within {x},{y},{width},{height}")
            }
            None => Ok(()),
        }
    }

    /// Takes what gives the silhouette, if anything does, into account.
    fn explain(&mut self, explanations: &[Explanation]) {
        // A silhouette is rough: what hardly any program does is not named beside what is done often. Stable: otherwise the
        // order of the tables decides.
        let mut usual_first = explanations.to_vec();
        usual_first.sort_by_key(Explanation::rare);
        let mut alike = alike(&usual_first, least(explanations));
        let least_rare = alike.first().map(|one| one.rare());
        alike.retain(|one| Some(one.rare()) == least_rare);
        let Some((first, others)) = alike.split_first() else {
            self.verdict = Verdict::Unexplained;
            return;
        };
        self.verdict = Verdict::Explained;
        self.sure = 1.0 / alike.len() as f64;
        self.error = first.error;
        self.mistakes = first.told();
        self.same_as = others.iter().map(|other| other.ids()).collect();
        self.causes = all_causes(&self.mistakes, &self.same_as);
    }
}

impl fmt::Display for PictureDiagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (error, exact) = (percent(self.error), percent(self.error_from_exact));
        if let Some(slight) = &self.or_slight {
            write!(
                f,
                "nearly right: {exact} of the silhouette is off, as through a camera that is turned by a few degrees; {slight} \
                 gives the same"
            )?;
            return self.fmt_off_within(f);
        }
        match self.verdict {
            Verdict::Explained => {
                fmt_mistakes(&self.mistakes, f)?;
                write!(
                    f,
                    "\n  agrees   with what that gives, but for {error} of the silhouette; the exact one is {exact} off"
                )?;
                fmt_where(&self.mistakes, f)?;
                if !self.same_as.is_empty() {
                    let others = self.same_as.iter().take(TOLD);
                    let others: Vec<String> = others.map(|ids| together(ids)).collect();
                    write!(f, "\n  or, with the same silhouette: {}", others.join(", "))?;
                }
                match self.same_as.len().saturating_sub(TOLD) {
                    0 => {}
                    more => write!(f, ", and {more} more")?,
                }
            }
            Verdict::Right | Verdict::Triangles => {
                let sure = 100.0 * self.sure;
                write!(
                    f,
                    "right, as far as the silhouette tells: {error} of it is off, its edge left out; {sure:.0} % of the \
                     known mistakes would show"
                )?;
            }
            Verdict::OtherPose | Verdict::Unexplained if self.is_scattered => write!(
                f,
                "unexplained: {exact} of the silhouette is off, and what is drawn are hardly more than lines and specks, \
                 which tell no mistake"
            )?,
            Verdict::OtherPose | Verdict::Unexplained => write!(
                f,
                "{}: {error} of the silhouette is off, and none of the mistakes that are sought in pictures gives this \
                 one, nor do two of those that are tried together{}",
                if self.is_nearly_right() {
                    "nearly right"
                } else {
                    "unexplained"
                },
                self.what_it_may_be()
            )?,
        }
        self.fmt_off_within(f)
    }
}

/// Share of a picture's border beyond which there is more before the background than a figure: one that the border cuts
/// off covers less of it.
const FLOOR: f64 = 0.15;
/// Share of the silhouette beyond which it is hardly the figure alone that is off.
const MUCH: f64 = 0.3;

/// A share in words.
fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}
