//! Numbers in text files, read without a detour through strings: a character has a quarter of a
//! million of them.

const POWERS_OF_TEN: [f32; 11] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10];
/// Whole numbers up to here are exact in an `f32`.
const EXACT: u32 = 1 << 24;

/// The finite number that all of `word` spells; `None` for anything else, "nan" and "inf" and
/// numbers too large for an `f32` among it. Rounded like the standard library's `parse`.
pub(super) fn finite(word: &str) -> Option<f32> {
    plain_decimal(word.as_bytes())
        .or_else(|| word.parse().ok())
        .filter(|number| number.is_finite())
}

/// Reads `-12.345` when its digits make a whole number that an `f32` holds exactly: one exact
/// number divided by another is rounded once, and so correctly (Clinger 1990). `None` says
/// nothing about the word.
fn plain_decimal(word: &[u8]) -> Option<f32> {
    let (negative, digits) = match word {
        [b'-', rest @ ..] => (true, rest),
        rest => (false, rest),
    };
    if digits.is_empty() || digits.len() > POWERS_OF_TEN.len() {
        return None;
    }
    let mut whole = 0_u32;
    let mut point = None;
    for (at, &byte) in digits.iter().enumerate() {
        match byte {
            b'0'..=b'9' => whole = whole.checked_mul(10)?.checked_add(u32::from(byte - b'0'))?,
            b'.' if point.is_none() => point = Some(at),
            _ => return None,
        }
    }
    let decimals = point.map_or(0, |at| digits.len() - at - 1);
    if whole > EXACT || (point.is_some() && digits.len() == 1) {
        return None;
    }
    let number = whole as f32 / POWERS_OF_TEN[decimals];
    Some(if negative { -number } else { number })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_is_no_finite_number_is_refused() {
        for word in [
            "", "-", ".", "-.", "+", "nan", "inf", "-inf", "1e39", "0x10", "1,5", "1.2.3", "--1",
            "1e", "é",
        ] {
            assert_eq!(finite(word), None, "{word}");
        }
    }

    #[test]
    fn usual_spellings_are_read() {
        for (word, number) in [
            ("0", 0.0),
            ("-1", -1.0),
            ("+1.5", 1.5),
            (".5", 0.5),
            ("5.", 5.0),
            ("0.0829847", 0.0829847),
            ("1e-3", 0.001),
            ("123456789012", 123456789012.0),
        ] {
            assert_eq!(finite(word), Some(number), "{word}");
        }
        assert!(finite("-0").is_some_and(f32::is_sign_negative));
    }

    proptest! {
        #[test]
        fn every_decimal_agrees_with_the_standard_library(word in "-?[0-9]{0,6}\\.?[0-9]{0,7}") {
            prop_assert_eq!(finite(&word), word.parse().ok());
        }
    }
}
