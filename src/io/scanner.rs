//! Words of text files, each with its line and column.

use super::encoding::{markup, utf8};
use super::numbers::{finite, plain_corner, plain_decimal};
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

/// Bytes of a text that are read between two opportunities to rest.
pub(super) const STRETCH: usize = 1 << 15;
/// Bytes that are only looked over in the time that it takes to read [`STRETCH`] of them.
pub(super) const QUICK_STRETCH: usize = 8 * STRETCH;

/// How much of a wrong word an error repeats, in characters.
const SHOWN: usize = 40;

/// What is said of a file whose last line misses something and does not end.
pub(super) const CUT_OFF: &str = "it seems to be cut off";

impl<'a> Scanner<'a> {
    /// At the start of the first line of `bytes`.
    ///
    /// # Errors
    /// If they are no text in UTF-8, or one in another format.
    pub fn new(path: &'a Path, bytes: &'a [u8]) -> Result<Self, Diagnostic> {
        let text = utf8(path, bytes)?;
        if let Some(found) = markup(text) {
            let message = format!("expected lines of words and numbers, found {found}");
            return Err(Diagnostic::new(path, message));
        }
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

    /// The byte of the text that is read next.
    pub fn at(&self) -> usize {
        self.at
    }

    /// Part of the text that was read, from 0 to 1.
    pub fn part(&self) -> f32 {
        self.at as f32 / self.text.len().max(1) as f32
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

    /// Whether all of the file was read, and its last line does not end as whole ones do.
    #[inline]
    pub fn is_at_open_end(&self) -> bool {
        self.at == self.text.len() && !matches!(self.text.bytes().last(), None | Some(b'\n'))
    }

    /// The error that at `word`, of this line, something else was expected.
    pub fn expected(&self, what: &str, word: Option<Word>) -> Diagnostic {
        let end = match self.is_at_open_end() {
            true => format!("the end of the file: {CUT_OFF}"),
            false => "the end of the line".to_owned(),
        };
        let found = word.map_or(end, |word| quoted(word.text));
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
        self.number_of(word, what)
    }

    /// `word`, of this line, as a finite number.
    ///
    /// # Errors
    /// As [`Scanner::number`].
    pub fn number_of(&self, word: Option<Word>, what: &str) -> Result<f32, Diagnostic> {
        let number = word.and_then(|word| finite(word.text));
        number.ok_or_else(|| match word {
            Some(word) if has_decimal_comma(word.text) => {
                self.expected(&format!("{what} with a decimal point"), Some(word))
            }
            word => self.expected(what, word),
        })
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

/// Whether `word` is a number but for a comma in the place of its point, as programs write it that follow the language of
/// the system.
fn has_decimal_comma(word: &str) -> bool {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let parts = word.split_once(',');
    parts.is_some_and(|(whole, decimals)| {
        is_digit(whole.chars().next_back())
            && is_digit(decimals.chars().next())
            && finite(&format!("{whole}.{decimals}")).is_some()
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

/// Whether a word ends before `byte`.
#[inline]
pub(super) fn is_end_of_word(byte: u8) -> bool {
    is_blank(byte) || matches!(byte, b'\n' | b'#')
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn a_decimal_comma_is_named_and_other_commas_are_not() {
        let error = |text: &str| {
            let mut scanner = Scanner::new(Path::new("a"), text.as_bytes()).unwrap();
            scanner.number("a number").unwrap_err().to_string()
        };
        for text in ["0,58", "-1,0e3", "12,5 1"] {
            let word = text.split(' ').next().unwrap();
            let told = format!("a:1:1: expected a number with a decimal point, found “{word}”");
            assert_eq!(error(text), told);
        }
        for text in ["1,2,3", "1,", ",5", "0.5,1", "a,b"] {
            let told = format!("a:1:1: expected a number, found “{text}”");
            assert_eq!(error(text), told);
        }
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
    fn a_text_with_tags_is_said_to_be_of_another_format() {
        for (text, expected) in [
            (
                "<?xml version=\"1.0\"?>\n<COLLADA>",
                "a: expected lines of words and numbers, found XML: a Collada file has a name that ends in .dae",
            ),
            (
                "\n <!DOCTYPE HTML>\n",
                "a: expected lines of words and numbers, found a web page (HTML)",
            ),
        ] {
            let error = Scanner::new(Path::new("a"), text.as_bytes()).unwrap_err();
            assert_eq!(error.to_string(), expected);
        }
        assert!(Scanner::new(Path::new("a"), b"<3\nv 1 2 3\n").is_ok());
    }

    #[test]
    fn a_long_or_unprintable_word_is_shortened_and_escaped() {
        assert_eq!(quoted("a\0b"), "“a\\u{0}b”");
        assert_eq!(quoted(&"x".repeat(100)).chars().count(), SHOWN + 3);
    }
}
