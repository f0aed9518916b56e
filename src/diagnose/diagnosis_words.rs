//! What is found out about a mesh, in words.

use super::diagnosis::{Diagnosis, NearlyRight, OfTheWhole, Region, Shown, ToldMistake, Verdict};
use super::mistake::{LOOK_AT_PLACE, Mistake};
use super::no_numbers;
use super::other_pose::OtherPose;
use super::precision::Coarse;
use crate::compare::MeshFinding;
use std::fmt;

/// Regions that are told in words; the others are counted.
const TOLD: usize = 5;

/// What to look at where a mesh is right in another pose.
const LOOK_AT_POSE: &str = "whether the mesh was made in the given pose; if it was, how the program comes to \
                            its angles";

/// Many mistakes give that; these are the likely ones.
const ALL_AT_ORIGIN: &str = "all vertices are at the origin: are the joints' matrices filled, and the inverse bind matrices? \
                             New ones are 0, and so are weights below 1 that are read as whole numbers";

impl fmt::Display for OfTheWhole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.0, self.0.brief()) {
            (MeshFinding::OnePlace { at }, _) if *at == [0.0; 3] => f.write_str(ALL_AT_ORIGIN),
            (MeshFinding::OnePlace { at }, _) => {
                write!(f, "all vertices are in one place, {}", vector(*at))
            }
            (MeshFinding::Scaled { offset, .. }, Some(brief)) if *offset == [0.0; 3] => {
                f.write_str(&brief)
            }
            (finding, _) => match finding.to_string().strip_prefix("B is A ") {
                Some(how) => write!(f, "the exact result, {how}"),
                None => write!(f, "with A for the exact mesh and B for this one: {finding}"),
            },
        }
    }
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

impl fmt::Display for Coarse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what = match self.may_be_right {
            true => "the exact result",
            false => "numbers",
        };
        write!(f, "{what} {}", self.how())?;
        if !self.is_cut_off {
            f.write_str(", which is too coarse to tell mistakes apart")?;
        }
        let enough = self.enough_digits;
        write!(f, ": write at least {enough} digits after the point")
    }
}

impl Coarse {
    fn how(&self) -> String {
        let step = self.rounded_to;
        match self.is_cut_off {
            true => format!("cut off to {step} instead of rounded"),
            false => format!("rounded to {step}"),
        }
    }

    /// In words what it means for a mesh that mistakes give.
    pub fn beside_mistakes(&self) -> String {
        let (how, enough) = (self.how(), self.enough_digits);
        format!(
            "its numbers are {how}, which may hide smaller mistakes: write at least {enough} digits after the point"
        )
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

/// In words that nothing is farther off than `error`, by the size.
pub fn within_everywhere(error: f64) -> String {
    format!("within {} everywhere", of_size(error))
}

/// Percent of the size from which on it does not matter how far away a vertex is.
const FAR_OUT: f64 = 1e5;

/// The same where it is said already what it is a part of.
pub fn part_of_size(error: f64) -> String {
    match 100.0 * error {
        percent if percent.is_infinite() => "an infinite distance".to_owned(),
        percent if percent > FAR_OUT => "more than a thousand times the size".to_owned(),
        percent if percent < 0.001 => "less than 0.001 %".to_owned(),
        percent if percent < 1.0 => format!("{percent:.3} %"),
        percent => format!("{percent:.1} %"),
    }
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
                "\n  unseen   {unseen}: with these mistakes, made in the usual way, it would be the same here"
            )?;
        }
        Ok(())
    }
}

impl Diagnosis {
    /// What is known of a mesh as a whole that nothing explains, a sentence each.
    pub fn found(&self) -> Vec<String> {
        let close = self.nearly_right() == Some(NearlyRight::Close);
        let close = close.then(|| within_everywhere(self.error_from_exact));
        let mut found: Vec<String> = close.into_iter().collect();
        let as_in_file = "it is the mesh at rest as the character's file has it, not skinned";
        found.extend(self.is_as_in_file.then(|| as_in_file.to_owned()));
        found.extend(self.findings.iter().map(ToString::to_string));
        found.extend(self.coarse.map(|coarse| match self.other_pose {
            Some(_) => coarse.beside_mistakes(),
            None => coarse.to_string(),
        }));
        if let Some(same) = self.faces.same {
            let few = match same {
                0 => "none of its triangles is".to_owned(),
                1 => "only one of its triangles is".to_owned(),
                _ => format!("only {same} of its triangles are"),
            };
            found.push(format!(
                "{few} the model's: it may be of another model, or have its vertices in another order"
            ));
        }
        if self.nearly_right() == Some(NearlyRight::ButForFew) {
            found.push(format!("all but {} of its vertices are right", self.off));
        }
        if self.no_numbers > 0 {
            let are_all = self.nearly_right().is_none() && self.no_numbers == self.off;
            let others = if are_all {
                ", and all others are right"
            } else {
                ""
            };
            found.push(format!("{}{others}", no_numbers::in_words(self.no_numbers)));
        }
        found.extend(self.not_reached.as_ref().map(|left| {
            format!("the vertices {left}, as where the loop over them does not come to all, or some have no weights")
        }));
        found
    }

    fn fmt_explained(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt_mistakes(&self.mistakes, f)?;
        let (error, exact) = (of_size(self.error), of_size(self.error_from_exact));
        write!(
            f,
            "\n  agrees   with what that gives, but for {error}; the exact result is {exact} away"
        )?;
        if let Some(coarse) = &self.coarse {
            write!(f, "\n  digits   {}", coarse.beside_mistakes())?;
        }
        fmt_where(&self.mistakes, f)?;
        if let Some(first) = &self.first {
            write!(f, "\n  shown by {first}")?;
        }
        if !self.same_as.is_empty() {
            let all: Vec<String> = self.same_as.iter().map(|ids| together(ids)).collect();
            write!(f, "\n  indistinguishable here: {}", all.join(", "))?;
            if self.same_as.len() == 1 {
                for other in &self.others {
                    write!(f, "\n           {other}")?;
                }
            }
        }
        match self.without_joint() {
            Some(pose) => write!(f, "\n  or       {pose}"),
            None => Ok(()),
        }
    }

    /// In words of which pose the mesh would be right as well, if it only lacks a joint of the one that was given.
    pub fn without_joint(&self) -> Option<String> {
        let (last, others) = self.not_turned.split_last()?;
        let joints = match others {
            [] => last.clone(),
            _ => format!("{} or {last}", others.join(", ")),
        };
        Some(format!(
            "it is right, but of a pose in which {joints} is not turned"
        ))
    }

    /// What is told of a mesh that is right in another pose.
    fn fmt_other_pose(&self, f: &mut fmt::Formatter<'_>, other: &OtherPose) -> fmt::Result {
        let (error, but_for) = (of_size(self.error), other.but_for(self.tolerance));
        let what = but_for.map_or_else(
            || "this is the exact result, but of".to_owned(),
            |but_for| format!("{but_for}, this is the exact result of"),
        );
        write!(
            f,
            "another pose: {what} a pose that is not the given one, in which it is {error} away"
        )?;
        if let Some(mistake) = &other.besides {
            write!(f, "\n  besides  {mistake}")?;
        }
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

    fn fmt_unexplained(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let error = of_size(self.error);
        let found = self.found();
        let mut found = found.iter();
        let nearly_right = self.nearly_right();
        let verdict = match nearly_right {
            Some(NearlyRight::ButForFewWith(_)) | None => "unexplained",
            Some(_) => "nearly right",
        };
        if let Some(other) = &self.other_pose {
            self.fmt_other_pose(f, other)?;
        } else if let Some(first) = found.next() {
            write!(
                f,
                "{verdict}: {first}\n  away     {error}, from the exact result in this pose"
            )?;
        } else {
            write!(
                f,
                "unexplained: {error} away from the exact result in this pose, and no known mistake \
                 gives this mesh, nor do two of those that are tried together"
            )?;
        }
        for found in found {
            write!(f, "\n  found    {found}")?;
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
                write!(f, ", and gives all but {} {vertices}", nearest.off)?;
            }
            fmt_where(std::slice::from_ref(mistake), f)?;
        }
        // Where every vertex is off, which ones are says nothing.
        if nearly_right == Some(NearlyRight::Placed) {
            return write!(f, "\n  look at  {LOOK_AT_PLACE}");
        }
        if self.is_in_one_place() {
            return Ok(());
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

/// Mistakes that are made together, and where to look for them.
struct Together(Vec<ToldMistake>);

impl fmt::Display for Together {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt_mistakes(&self.0, f)?;
        fmt_where(&self.0, f)
    }
}

/// Mistakes that are made together, each in the way that stands with it, in words, with where to look for them.
pub fn in_words(mistakes: Vec<(&'static Mistake, String)>) -> String {
    Together(ToldMistake::all_made(mistakes)).to_string()
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
