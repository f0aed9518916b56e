//! The letters of matrices.

use crate::diagnose::{Factor, Formula, Shaped};

/// A matrix of a joint, as it is written: its letter and its exponent.
pub(super) fn letter(factor: Factor) -> (&'static str, &'static str) {
    match factor {
        Factor::Current => ("T", ""),
        Factor::Bind => ("B", ""),
        Factor::InverseBind | Factor::InverseBindOfFile | Factor::InverseBindOfNumber => {
            ("B", "-1")
        }
        Factor::InverseBindOfFirst => ("B₁", "-1"),
        Factor::CurrentTransposed => ("T", "T"),
        Factor::InverseBindTransposed | Factor::InverseBindOfFileTransposed => ("B", "-T"),
        Factor::BindTransposed => ("B", "T"),
        Factor::InverseCurrent => ("T", "-1"),
        Factor::ToFile => ("A", "-1"),
        Factor::FromFile => ("A", ""),
        Factor::FromFileTransposed => ("A", "T"),
        Factor::DirectionsInFile => ("R", ""),
    }
}

/// An exponent in letters of its own.
pub(super) fn raised(above: &str) -> &'static str {
    match above {
        "-1" => "⁻¹",
        "T" => "ᵀ",
        "-T" => "⁻ᵀ",
        _ => "",
    }
}

/// What the letters of `formula` mean that only characters of Collada files have; empty of others.
pub(super) fn of_file(formula: &Formula) -> String {
    let has = |name: &str| {
        let mut factors = formula.factors.in_order().iter();
        factors.any(|factor| letter(*factor).0 == name)
    };
    let told = [
        (
            has("A"),
            "A leads from the file's axes and units to the program's.",
        ),
        (has("R"), "R has the directions of the bone in the file."),
        (
            formula.shaped != Shaped::Exactly,
            "M is the skin's own matrix.",
        ),
    ];
    let told = told
        .into_iter()
        .filter_map(|(is_there, text)| is_there.then_some(text));
    told.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::{Factors, Formula, Mistake};
    use egui::{Context, FontId, RawInput};

    #[test]
    fn mistakes_are_told_in_letters_that_the_window_has() {
        let context = Context::default();
        let mut texts = vec![letter(Factor::InverseBindOfFirst).0];
        for mistake in Mistake::all() {
            texts.extend([mistake.meaning, mistake.look_at]);
            texts.extend(mistake.readings.iter().map(|reading| reading.how));
        }
        context.begin_pass(RawInput::default());
        let has =
            |text: &str| context.fonts_mut(|fonts| fonts.has_glyphs(&FontId::default(), text));
        for text in texts {
            assert!(has(text), "{text}");
        }
        assert!(!has("ᵀ"), "an exponent is raised, not written");
    }

    #[test]
    fn letters_are_told_that_a_formula_has_of_a_collada_file() {
        let exact = Formula::default();
        assert_eq!(of_file(&exact), "");
        let axes = "A leads from the file's axes and units to the program's.";
        let in_file = Formula {
            factors: Factors::ExactInFile,
            ..exact.clone()
        };
        assert_eq!(of_file(&in_file), axes);
        let all = Formula {
            factors: Factors::NoInverseBindOfFile,
            shaped: Shaped::Transposed,
            ..exact
        };
        let others = "R has the directions of the bone in the file. M is the skin's own matrix.";
        assert_eq!(of_file(&all), format!("{axes} {others}"));
    }
}
