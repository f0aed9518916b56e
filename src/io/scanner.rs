//! Words and numbers of text files, each with its line and column.

use super::{Diagnostic, Position};
use std::path::Path;

/// Walks a text file word by word and line by line, and knows where it is, so that an error
/// names line and column. Words are separated by white space; `#` starts a comment that runs to
/// the end of the line. Nothing is copied.
#[derive(Debug)]
pub(super) struct Scanner<'a> {
    path: &'a Path,
    text: &'a str,
    at: usize,
    line: usize,
    line_start: usize,
}

/// A word and where it starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    pub text: &'a str,
    start: usize,
}

/// How much of a wrong word an error repeats, in characters.
const SHOWN: usize = 40;

impl<'a> Scanner<'a> {
    /// At the start of the first line of `bytes`.
    ///
    /// # Errors
    /// If they are no text in UTF-8.
    pub fn new(path: &'a Path, bytes: &'a [u8]) -> Result<Self, Diagnostic> {
        let text = utf8(path, bytes)?;
        Ok(Self {
            path,
            text,
            at: 0,
            line: 1,
            line_start: 0,
        })
    }

    /// All lines.
    pub fn text(&self) -> &'a str {
        self.text
    }

    /// The next word of this line.
    #[inline]
    pub fn word(&mut self) -> Option<Word<'a>> {
        self.skip_blanks();
        let bytes = self.text.as_bytes();
        let start = self.at;
        while self.at < bytes.len() && !is_end_of_word(bytes[self.at]) {
            self.at += 1;
        }
        (self.at > start).then(|| Word {
            text: &self.text[start..self.at],
            start,
        })
    }

    #[inline]
    fn skip_blanks(&mut self) {
        let bytes = self.text.as_bytes();
        while self.at < bytes.len() && is_blank(bytes[self.at]) {
            self.at += 1;
        }
    }

    /// Passes over white space and up to `limit` words that are a lone `0`, and says how many of
    /// these there were; it may leave one for [`Scanner::word`].
    #[inline]
    pub fn skip_zeros(&mut self, limit: usize) -> usize {
        self.skip_blanks();
        let bytes = self.text.as_bytes();
        let mut zeros = 0;
        while zeros < limit && bytes.get(self.at..self.at + 2) == Some(b"0 ") {
            self.at += 2;
            zeros += 1;
        }
        zeros
    }

    /// The words left on this line as they stand, `#` included, without white space around them:
    /// for names, which may hold both.
    pub fn rest(&mut self) -> Option<Word<'a>> {
        let line = &self.text[self.at..];
        let line = &line[..line.find('\n').unwrap_or(line.len())];
        let start = self.at + (line.len() - line.trim_start().len());
        self.at += line.len();
        let text = line.trim();
        (!text.is_empty()).then_some(Word { text, start })
    }

    /// The comment at the end of this line, without its `#`; none if there is none or if words
    /// come before it.
    pub fn comment(&mut self) -> Option<&'a str> {
        let rest = self.rest()?;
        rest.text.strip_prefix('#').map(str::trim)
    }

    /// The part of this line that was read, without a comment.
    pub fn read_of_line(&self) -> &'a str {
        &self.text[self.line_start..self.at]
    }

    /// Goes to the start of the next line; false at the end of the file.
    pub fn next_line(&mut self) -> bool {
        let Some(rest) = self.text.as_bytes().get(self.at..) else {
            return false;
        };
        let Some(length) = rest.iter().position(|&byte| byte == b'\n') else {
            self.at = self.text.len();
            return false;
        };
        self.at += length + 1;
        self.line += 1;
        self.line_start = self.at;
        true
    }

    /// Where `word`, of this line, starts; where the line's last word ends if there is no word.
    pub fn position(&self, word: Option<Word>) -> Position {
        let start = word.map_or_else(
            || {
                let before = self.text[self.line_start..self.at].trim_end();
                self.line_start + before.len()
            },
            |word| word.start,
        );
        Position {
            line: self.line,
            column: self.text[self.line_start..start].chars().count() + 1,
        }
    }

    /// Where the file's last word ends.
    pub fn end(&self) -> Position {
        Position::in_text(self.text, self.text.trim_end().len())
    }

    /// The error that at `word`, of this line, something else was expected.
    pub fn expected(&self, what: &str, word: Option<Word>) -> Diagnostic {
        let found = word.map_or_else(|| "the end of the line".to_owned(), |w| quoted(w.text));
        self.error(
            self.position(word),
            format!("expected {what}, found {found}"),
        )
    }

    /// An error or a warning at `position`.
    pub fn error(&self, position: Position, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            position: Some(position),
            ..Diagnostic::new(self.path, message)
        }
    }

    /// The next word as a finite number.
    ///
    /// # Errors
    /// If it is none or missing; `what` names the number in the error.
    #[inline]
    pub fn number(&mut self, what: &str) -> Result<f32, Diagnostic> {
        if let Some(number) = self.plain_number() {
            return Ok(number);
        }
        let word = self.word();
        word.and_then(|word| finite(word.text))
            .ok_or_else(|| self.expected(what, word))
    }

    /// The next word, if it is a number of the usual spelling; else nothing is read but white space.
    #[inline]
    pub fn plain_number(&mut self) -> Option<f32> {
        self.skip_blanks();
        let (number, length) = plain_decimal(&self.text.as_bytes()[self.at..])?;
        self.at += length;
        Some(number)
    }

    /// The next word, if it is one to three whole numbers from 1 to their share of `most` with `/`
    /// between them, some perhaps left out after the first (0 stands for these); else nothing is read
    /// but white space.
    #[inline]
    pub fn plain_corner(&mut self, most: &[usize; 3]) -> Option<[u32; 3]> {
        self.skip_blanks();
        let (corner, length) = plain_corner(&self.text.as_bytes()[self.at..])?;
        if corner
            .iter()
            .zip(most)
            .any(|(&index, &most)| index as usize > most)
        {
            return None;
        }
        self.at += length;
        Some(corner)
    }

    /// Makes sure that no word is left on this line.
    ///
    /// # Errors
    /// If one is.
    pub fn end_of_line(&mut self) -> Result<(), Diagnostic> {
        match self.word() {
            None => Ok(()),
            word => Err(self.expected("the end of the line", word)),
        }
    }
}

/// `bytes` as text, without the mark that some editors put before it.
///
/// # Errors
/// If they are not UTF-8, with the place of the first that is not.
pub(super) fn utf8<'a>(path: &Path, bytes: &'a [u8]) -> Result<&'a str, Diagnostic> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    std::str::from_utf8(bytes).map_err(|error| {
        let good = &bytes[..error.valid_up_to()];
        let line = good.iter().filter(|&&byte| byte == b'\n').count() + 1;
        let last = good.rsplit(|&byte| byte == b'\n').next().unwrap_or(good);
        let column = String::from_utf8_lossy(last).chars().count() + 1;
        let found = bytes[error.valid_up_to()];
        let message = format!("expected text in UTF-8, found the byte 0x{found:02x}");
        Diagnostic::at(path, line, column, message)
    })
}

/// `text` in quotes, shortened and without control characters, fit for a message.
pub(super) fn quoted(text: &str) -> String {
    format!("“{}”", shown(text))
}

/// `text` shortened and without control characters.
pub(super) fn shown(text: &str) -> String {
    let mut shown = String::new();
    for (index, c) in text.chars().enumerate() {
        if index == SHOWN {
            shown.push('…');
            break;
        }
        if c.is_control() {
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
    }
    shown
}

#[inline]
fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | 0x0b | 0x0c)
}

#[inline]
fn is_end_of_word(byte: u8) -> bool {
    is_blank(byte) || matches!(byte, b'\n' | b'#')
}

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
fn plain_decimal(text: &[u8]) -> Option<(f32, usize)> {
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

/// Reads `1`, `1/2`, `1//3` or `1/2/3` at the start of `text`, up to the end of its word, and says how
/// long it is. Zeros, signs and whatever else are `None`.
#[inline]
fn plain_corner(text: &[u8]) -> Option<([u32; 3], usize)> {
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
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn columns_count_characters_and_not_bytes() {
        let path = Path::new("a.skel");
        let mut scanner = Scanner::new(path, "x\nüü  b".as_bytes()).unwrap();
        assert!(scanner.next_line());
        scanner.word();
        let word = scanner.word();
        let error = scanner.expected("c", word);
        assert_eq!(error.to_string(), "a.skel:2:5: expected c, found “b”");
    }

    #[test]
    fn a_missing_word_is_told_at_the_end_of_the_line() {
        let mut scanner = Scanner::new(Path::new("a"), b"1 2  \r\n3").unwrap();
        scanner.word();
        scanner.word();
        let error = scanner.number("z").unwrap_err();
        assert_eq!(
            error.to_string(),
            "a:1:4: expected z, found the end of the line"
        );
    }

    #[test]
    fn bytes_that_are_no_text_are_told_with_their_place() {
        let error = Scanner::new(Path::new("a"), b"1\n\xC3\xA4\xFF").unwrap_err();
        assert_eq!(
            error.to_string(),
            "a:2:2: expected text in UTF-8, found the byte 0xff"
        );
    }

    #[test]
    fn a_long_or_unprintable_word_is_shortened_and_escaped() {
        assert_eq!(quoted("a\0b"), "“a\\u{0}b”");
        assert_eq!(quoted(&"x".repeat(100)).chars().count(), SHOWN + 3);
    }

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
