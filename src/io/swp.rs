//! Curves and surfaces as `.swp` files, read and written.

use super::diagnostic::Warnings;
use super::encoding::utf8;
use super::numbers::finite;
use super::scanner::quoted;
use super::{Diagnostic, Imported, Position};
use crate::geometry::{Basis, Curve, CurveForm, MAX_CURVE_POINTS, MAX_STEPS};
use crate::scene::{CurveItemKind, CurveSet};
use glam::Vec3;
use std::collections::HashSet;
use std::fmt::{self, Write};
use std::path::Path;

/// Reads a `.swp` file: curves and surfaces as words between white space, brackets around each
/// control point (course editor, "Formats"):
///
/// - `bez2|bez3|bsp2|bsp3 NAME STEPS N [x y]…`, in space `[x y z]`
/// - `circ NAME STEPS RADIUS`
/// - `srev NAME STEPS PROFILE` and `gcyl NAME PROFILE SWEEP`, where a curve is named that stands
///   before; of several with one name the latest. `.` is a name like any other.
///
/// # Errors
/// At the first word that is not that: wrong counts, a profile that leaves the plane z = 0, a
/// curve that does not exist, numbers too large. And if there is no curve at all.
#[doc(alias = "parseSwp")]
pub fn read_swp(path: &Path, bytes: &[u8]) -> Result<Imported<CurveSet>, Diagnostic> {
    let mut reader = Reader {
        words: Words::new(path, utf8(path, bytes)?),
        set: CurveSet::new(),
        names: HashSet::new(),
        warnings: Warnings::default(),
    };
    while let Some(keyword) = reader.words.next() {
        reader.item(keyword)?;
    }
    if reader.set.items().is_empty() {
        let message = "expected a curve, found none".to_owned();
        return Err(reader.words.error(reader.words.end(), message));
    }
    Ok(Imported {
        value: reader.set,
        warnings: reader.warnings.into_vec(path),
    })
}

/// The name of curves that no surface needs, in files of the course.
const NAMELESS: &str = ".";
const KEYWORDS: &str = "bez2, bez3, bsp2, bsp3, circ, srev or gcyl";

struct Reader<'a> {
    words: Words<'a>,
    set: CurveSet,
    /// Of the curves so far.
    names: HashSet<&'a str>,
    warnings: Warnings,
}

impl<'a> Reader<'a> {
    fn item(&mut self, keyword: Word<'a>) -> Result<(), Diagnostic> {
        let (name, kind) = match keyword.text {
            "bez2" => self.spline(Basis::Bezier, true)?,
            "bez3" => self.spline(Basis::Bezier, false)?,
            "bsp2" => self.spline(Basis::BSpline, true)?,
            "bsp3" => self.spline(Basis::BSpline, false)?,
            "circ" => self.circle()?,
            "srev" => self.revolution()?,
            "gcyl" => self.sweep()?,
            _ => return Err(self.words.expected(KEYWORDS, Some(keyword))),
        };
        let is_curve = matches!(kind, CurveItemKind::Curve(_));
        if is_curve && name.text != NAMELESS && !self.names.insert(name.text) {
            let words = &self.words;
            self.warnings.push_with(|| {
                let message = format!(
                    "expected another name for each curve, found {} again: surfaces after it are \
                     made of this one",
                    quoted(name.text)
                );
                words.error(name, message)
            });
        }
        let pushed = self.set.push(name.text, kind);
        pushed.map_err(|error| self.words.error(name, error.to_string()))?;
        Ok(())
    }

    fn spline(
        &mut self,
        basis: Basis,
        flat: bool,
    ) -> Result<(Word<'a>, CurveItemKind), Diagnostic> {
        let name = self.name("the name of the curve")?;
        let steps = self.steps()?;
        let (count_word, count) = self.count("the number of control points")?;
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        if count > MAX_CURVE_POINTS {
            let most = format!("at most {MAX_CURVE_POINTS} control points");
            return Err(self.words.expected(&most, Some(count_word)));
        }
        basis
            .check_count(count)
            .map_err(|error| self.words.error(count_word, error.to_string()))?;
        // The count is only a claim: a short file must not reserve memory for millions.
        let mut points = Vec::new();
        for index in 0..count {
            points.push(self.control_point(flat, index, count)?);
        }
        let curve = Curve::spline(basis, flat, steps, points)
            .map_err(|error| self.words.error(name, error.to_string()))?;
        Ok((name, CurveItemKind::Curve(curve)))
    }

    fn control_point(
        &mut self,
        flat: bool,
        index: usize,
        count: usize,
    ) -> Result<Vec3, Diagnostic> {
        let number = index + 1;
        self.bracket("[", || format!("`[` of control point {number} of {count}"))?;
        let mut point = Vec3::ZERO;
        let coordinates = if flat { "xy" } else { "xyz" };
        for (axis, coordinate) in coordinates.chars().enumerate() {
            let what = || format!("{coordinate} of control point {number} of {count}");
            point[axis] = self.number(what)?;
        }
        self.bracket("]", || format!("`]` after {} numbers", coordinates.len()))?;
        Ok(point)
    }

    fn circle(&mut self) -> Result<(Word<'a>, CurveItemKind), Diagnostic> {
        let name = self.name("the name of the circle")?;
        let steps = self.steps()?;
        let radius = self.number(|| "the radius".into())?;
        let curve = Curve::circle(steps, radius)
            .map_err(|error| self.words.error(name, error.to_string()))?;
        Ok((name, CurveItemKind::Curve(curve)))
    }

    fn revolution(&mut self) -> Result<(Word<'a>, CurveItemKind), Diagnostic> {
        let name = self.name("the name of the surface")?;
        let steps = self.steps()?;
        let profile = self.profile()?;
        Ok((name, CurveItemKind::Revolution { steps, profile }))
    }

    fn sweep(&mut self) -> Result<(Word<'a>, CurveItemKind), Diagnostic> {
        let name = self.name("the name of the surface")?;
        let profile = self.profile()?;
        let (_, sweep) = self.known_curve("the name of the curve to sweep along")?;
        Ok((name, CurveItemKind::Sweep { profile, sweep }))
    }

    fn profile(&mut self) -> Result<usize, Diagnostic> {
        let (word, profile) = self.known_curve("the name of the profile")?;
        match self.set.curve(profile) {
            Some(curve) if curve.is_flat() => Ok(profile),
            _ => {
                let what = "a profile in the plane z = 0";
                let found = format!("{}, which leaves it", quoted(word.text));
                let message = format!("expected {what}, found {found}");
                Err(self.words.error(word, message))
            }
        }
    }

    fn known_curve(&mut self, what: &str) -> Result<(Word<'a>, usize), Diagnostic> {
        let word = self.name(what)?;
        let found = self.set.find(word.text).ok_or_else(|| {
            let found = quoted(word.text);
            let message = format!("expected {what}, found {found}: no curve before has this name");
            self.words.error(word, message)
        })?;
        Ok((word, found))
    }

    fn name(&mut self, what: &str) -> Result<Word<'a>, Diagnostic> {
        match self.words.next() {
            Some(word) if !is_bracket(word) => Ok(word),
            word => Err(self.words.expected(what, word)),
        }
    }

    fn steps(&mut self) -> Result<u32, Diagnostic> {
        let (word, steps) = self.count("the number of steps")?;
        match u32::try_from(steps) {
            Ok(steps) if (1..=MAX_STEPS).contains(&steps) => Ok(steps),
            _ => {
                let range = format!("1 to {MAX_STEPS} steps");
                Err(self.words.expected(&range, Some(word)))
            }
        }
    }

    /// A whole number, with its word for complaints.
    fn count(&mut self, what: &str) -> Result<(Word<'a>, u64), Diagnostic> {
        let word = self.words.next();
        let count = word.and_then(|word| Some((word, word.text.parse().ok()?)));
        count.ok_or_else(|| {
            self.words
                .expected(&format!("{what}, a whole number"), word)
        })
    }

    fn number(&mut self, what: impl Fn() -> String) -> Result<f32, Diagnostic> {
        let word = self.words.next();
        word.and_then(|word| finite(word.text))
            .ok_or_else(|| self.words.expected(&format!("{}, a number", what()), word))
    }

    fn bracket(&mut self, text: &str, what: impl Fn() -> String) -> Result<(), Diagnostic> {
        match self.words.next() {
            Some(word) if word.text == text => Ok(()),
            word => Err(self.words.expected(&what(), word)),
        }
    }
}

fn is_bracket(word: Word) -> bool {
    matches!(word.text, "[" | "]")
}

/// A word and the offset where it starts.
#[derive(Clone, Copy)]
struct Word<'a> {
    text: &'a str,
    start: usize,
}

/// Words of the whole file, lines or not; a bracket is a word of its own, so that white space
/// around it does not matter.
struct Words<'a> {
    path: &'a Path,
    text: &'a str,
    at: usize,
}

impl<'a> Words<'a> {
    fn new(path: &'a Path, text: &'a str) -> Self {
        Self { path, text, at: 0 }
    }

    fn next(&mut self) -> Option<Word<'a>> {
        let rest = &self.text[self.at..];
        let trimmed = rest.trim_start();
        let start = self.text.len() - trimmed.len();
        let ends = |c: char| c.is_whitespace() || c == '[' || c == ']';
        let length = match trimmed.find(ends) {
            // It starts with a bracket: one byte.
            Some(0) => 1,
            Some(length) => length,
            None => trimmed.len(),
        };
        self.at = start + length;
        let text = &trimmed[..length];
        (length > 0).then_some(Word { text, start })
    }

    fn expected(&self, what: &str, word: Option<Word>) -> Diagnostic {
        let found = word.map_or_else(|| "the end of the file".to_owned(), |w| quoted(w.text));
        self.error(
            word.unwrap_or_else(|| self.end()),
            format!("expected {what}, found {found}"),
        )
    }

    /// The empty word where the last one ends.
    fn end(&self) -> Word<'a> {
        Word {
            text: "",
            start: self.text.trim_end().len(),
        }
    }

    fn error(&self, word: Word, message: String) -> Diagnostic {
        Diagnostic {
            position: Some(Position::in_text(self.text, word.start)),
            ..Diagnostic::new(self.path, message)
        }
    }
}

/// `set` as the text of a `.swp` file. Numbers are written with as many digits as it takes to
/// read the same ones back.
///
/// A surface finds its curves by name, the latest of several. Where a curve is meant that a
/// later one of the same name hides, it is written under a name of its own.
pub fn to_swp(set: &CurveSet) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write_items(&mut text, set);
    text
}

fn write_items(text: &mut String, set: &CurveSet) -> fmt::Result {
    let names = names(set);
    for (item, name) in set.items().iter().zip(&names) {
        if !text.is_empty() {
            text.push('\n');
        }
        match &item.kind {
            CurveItemKind::Curve(curve) => write_curve(text, name, curve)?,
            CurveItemKind::Revolution { steps, profile } => {
                writeln!(text, "srev {name} {steps} {}", names[*profile])?;
            }
            CurveItemKind::Sweep { profile, sweep } => {
                writeln!(text, "gcyl {name} {} {}", names[*profile], names[*sweep])?;
            }
        }
    }
    Ok(())
}

fn write_curve(text: &mut String, name: &str, curve: &Curve) -> fmt::Result {
    let steps = curve.steps();
    match curve.form() {
        CurveForm::Circle { radius } => writeln!(text, "circ {name} {steps} {radius}"),
        CurveForm::Spline {
            basis,
            flat,
            control_points,
        } => {
            let basis = match basis {
                Basis::Bezier => "bez",
                Basis::BSpline => "bsp",
            };
            let dimension = if *flat { 2 } else { 3 };
            let count = control_points.len();
            writeln!(text, "{basis}{dimension} {name} {steps} {count}")?;
            for point in control_points {
                if *flat {
                    writeln!(text, "[{} {}]", point.x, point.y)?;
                } else {
                    writeln!(text, "[{} {} {}]", point.x, point.y, point.z)?;
                }
            }
            Ok(())
        }
    }
}

/// The name under which each item is written.
fn names(set: &CurveSet) -> Vec<String> {
    let items = set.items();
    let mut names: Vec<String> = items.iter().map(|item| item.name.clone()).collect();
    let mut taken: HashSet<String> = names.iter().cloned().collect();
    for (index, item) in items.iter().enumerate() {
        let used = match item.kind {
            CurveItemKind::Curve(_) => vec![],
            CurveItemKind::Revolution { profile, .. } => vec![profile],
            CurveItemKind::Sweep { profile, sweep } => vec![profile, sweep],
        };
        for curve in used {
            let hidden = (curve + 1..index)
                .any(|later| items[later].curve().is_some() && names[later] == names[curve]);
            if hidden {
                names[curve] = free_name(&items[curve].name, &taken);
                taken.insert(names[curve].clone());
            }
        }
    }
    names
}

fn free_name(base: &str, taken: &HashSet<String>) -> String {
    let base = if base == "." { "curve" } else { base };
    (1..)
        .map(|number| format!("{base}{number}"))
        .find(|name| !taken.contains(name))
        .unwrap_or_else(|| base.to_owned())
}
