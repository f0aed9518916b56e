//! Numbers in text, with the bits of the standard library and, in the usual spellings, faster.

use super::scanner::is_end_of_word;

/// Powers of ten that are exact in an `f64`.
const POWERS_OF_TEN: [f64; MOST_DIGITS + 1] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19,
];
/// Whole numbers up to here are exact in an `f64`.
const EXACT: u64 = 1 << 53;
/// The most digits that a `u64` holds, whichever they are.
const MOST_DIGITS: usize = 19;

/// The finite number that all of `word` spells; `None` for anything else, "nan" and "inf" and
/// numbers too large for an `f32` included. The bits are those of the standard library's `parse`.
pub(super) fn finite(word: &str) -> Option<f32> {
    match plain_decimal(word.as_bytes()) {
        Some((number, length)) if length == word.len() => Some(number),
        _ => word.parse().ok().filter(|number: &f32| number.is_finite()),
    }
}

/// Reads a number such as `-12.345` at the start of `text`, up to the end of its word, and says how
/// long it is. Its digits make a whole number that an `f64` holds exactly, which is divided by an
/// exact power of ten, and so rounded once (Clinger 1990). Rounding to an `f32` then is a second
/// time, which only goes wrong where the first has led to the middle between two of these. Such
/// numbers, and all other spellings, are `None` here: `parse` reads them, but looks at each digit
/// twice after the search for the word's end, and files are numbers mostly.
#[inline]
pub(super) fn plain_decimal(text: &[u8]) -> Option<(f32, usize)> {
    let start = usize::from(text.first() == Some(&b'-'));
    let mut at = start;
    let mut whole = 0_u64;
    let digits = |at: &mut usize, whole: &mut u64| {
        while let Some(digit) = digit(text, *at) {
            *whole = whole.wrapping_mul(10).wrapping_add(digit);
            *at += 1;
        }
    };
    digits(&mut at, &mut whole);
    let mut count = at - start;
    let mut decimals = 0;
    if text.get(at) == Some(&b'.') {
        at += 1;
        let point = at;
        digits(&mut at, &mut whole);
        decimals = at - point;
        count += decimals;
    }
    let ends = text.get(at).is_none_or(|&byte| is_end_of_word(byte));
    if !ends || count == 0 || count > MOST_DIGITS || whole > EXACT {
        return None;
    }
    let number = whole as f64 / POWERS_OF_TEN[decimals];
    // Of the 52 bits after the point an `f32` keeps 23; half of its last is the next one alone.
    let is_between = number.to_bits() & ((1 << 29) - 1) == 1 << 28;
    let number = if start == 1 { -number } else { number };
    (!is_between).then_some((number as f32, at))
}

#[inline]
fn digit(text: &[u8], at: usize) -> Option<u64> {
    let digit = text.get(at)?.wrapping_sub(b'0');
    (digit < 10).then_some(u64::from(digit))
}

/// The most digits that a `u32` holds, whichever they are.
const MOST_INDEX_DIGITS: usize = 9;

/// Reads digits at the start of `text`, and says how many they are; `None` if there are none, or more than a
/// `u32` is sure to hold.
#[inline]
pub(super) fn plain_index(text: &[u8]) -> Option<(u32, usize)> {
    let (mut index, mut length) = (0, 0);
    while let Some(digit) = digit(text, length) {
        index = u32::wrapping_add(u32::wrapping_mul(index, 10), digit as u32);
        length += 1;
    }
    (1..=MOST_INDEX_DIGITS)
        .contains(&length)
        .then_some((index, length))
}

/// Reads `1`, `1/2`, `1//3` or `1/2/3` at the start of `text`, up to the end of its word, and says how
/// long it is. Zeros, signs and whatever else are `None`.
#[inline]
pub(super) fn plain_corner(text: &[u8]) -> Option<([u32; 3], usize)> {
    let mut corner = [0; 3];
    let mut at = 0;
    for (kind, index) in corner.iter_mut().enumerate() {
        let start = at;
        while let Some(digit) = digit(text, at) {
            *index = u32::wrapping_add(u32::wrapping_mul(*index, 10), digit as u32);
            at += 1;
        }
        let is_left_out = at == start && kind > 0;
        if at - start > MOST_INDEX_DIGITS || (*index == 0 && !is_left_out) {
            return None;
        }
        match text.get(at) {
            Some(b'/') if kind < 2 => at += 1,
            Some(&byte) if !is_end_of_word(byte) => return None,
            _ => break,
        }
    }
    Some((corner, at))
}

#[cfg(test)]
mod tests {
    use super::super::scanner::Scanner;
    use super::*;
    use proptest::prelude::*;
    use std::path::Path;

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

    /// What [`finite`] must find: the bits of the standard library.
    fn parsed(word: &str) -> Option<u32> {
        let number: Option<f32> = word.parse().ok();
        number.filter(|n| n.is_finite()).map(f32::to_bits)
    }

    /// The number of `word` alone, of it as the next word of a line, and whether the rest is left.
    fn read(word: &str) -> [Option<u32>; 2] {
        let text = format!(" {word}\t# 1");
        let mut scanner = Scanner::new(Path::new("a"), text.as_bytes()).unwrap();
        let next = scanner.number("a number").ok();
        if next.is_some() {
            assert!(scanner.end_of_line().is_ok(), "{word}");
        }
        [finite(word), next].map(|number| number.map(f32::to_bits))
    }

    #[test]
    fn numbers_between_two_neighbors_are_rounded_as_the_standard_library_does() {
        // 2^24 + 1 and 3 lie in the middle. Those of 16 digits are in an `f64` as if they did.
        for word in [
            "16777217",
            "16777219",
            "16777217.00000001",
            "16777217.000000001",
            "16777216.99999999",
            "1.000000059604644775390625",
            "1.00000005960464477",
            "9007199254740993",
            "0.5254458487033844",
            "0.0898476280272007",
            "0.08984762802720070",
            "0.6343642175197601",
            "0.7099548280239105",
            "0.4406021088361740",
            "0.5000000298023224",
            "0.1000000014901161",
        ] {
            for word in [word.to_owned(), format!("-{word}")] {
                assert_eq!(read(&word), [parsed(&word); 2], "{word}");
            }
        }
    }

    proptest! {
        #[test]
        fn every_decimal_agrees_with_the_standard_library(word in "[-+]?[0-9]{0,12}\\.?[0-9]{0,14}") {
            prop_assume!(!word.is_empty());
            prop_assert_eq!(read(&word), [parsed(&word); 2]);
        }

        #[test]
        fn every_word_agrees_with_the_standard_library(
            word in "[-+]{0,2}[0-9]{0,3}\\.{0,2}[0-9]{0,25}([eE][-+]?[0-9]{0,2})?[a-z/,é]?",
        ) {
            prop_assume!(!word.is_empty());
            prop_assert_eq!(read(&word), [parsed(&word); 2]);
        }

        /// As other programs write them: the shortest, with so many decimals, and with an exponent.
        #[test]
        fn every_number_that_is_printed_comes_back(bits: u32, decimals in 0..12_usize) {
            let number = f32::from_bits(bits);
            prop_assume!(number.is_finite());
            for word in [
                format!("{number}"),
                format!("{number:.decimals$}"),
                format!("{number:e}"),
                format!("{:.decimals$}", number % 100.0),
                format!("{:.decimals$}", f64::from(number % 100.0) * (1.0 + 0.5_f64.powi(24))),
            ] {
                prop_assert_eq!(read(&word), [parsed(&word); 2], "{}", word);
            }
        }

        #[test]
        fn corners_are_plain_or_left_to_others(word in "[0-9]{0,10}(/[-0-9]{0,2}){0,3}", most in prop::array::uniform3(0..200_usize)) {
            prop_assume!(!word.is_empty());
            let text = format!(" {word} 7");
            let mut scanner = Scanner::new(Path::new("a"), text.as_bytes()).unwrap();
            let found = scanner.plain_corner(&most);
            let parts: Vec<&str> = word.split('/').collect();
            let mut expected = [0; 3];
            let mut is_plain = parts.len() <= 3 && !parts[0].is_empty();
            for ((part, index), most) in parts.iter().zip(&mut expected).zip(most) {
                let number = part.parse().ok().filter(|number| (1..=most as u32).contains(number));
                *index = number.unwrap_or_default();
                is_plain &= part.is_empty() || number.is_some();
            }
            prop_assert_eq!(found, is_plain.then_some(expected), "{}", word);
            // What was no plain corner can still be read otherwise.
            let next = scanner.word().map(|word| word.text);
            let rest = if is_plain { "7" } else { &word };
            prop_assert_eq!(next, Some(rest));
        }
    }
}
