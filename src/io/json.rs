//! JSON with places: `jsonc-parser` gives the tree with the bytes that each part comes from, and
//! [`Json`] hands it to serde, so that every error points at the key or value at fault.

use super::encoding::utf8;
use super::json_node::Node;
use super::scanner::quoted;
use super::{Diagnostic, Position};
use jsonc_parser::ast::Value;
use jsonc_parser::errors::{ParseError, ParseErrorKind};
use jsonc_parser::{CollectOptions, ParseOptions, ParseStringErrorKind, parse_to_ast};
use serde::de::{self, DeserializeOwned, Expected, Unexpected};
use std::fmt;
use std::marker::PhantomData;
use std::path::Path;

/// JSON as the standard has it (RFC 8259): the parser's extensions are off.
const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// A JSON file, parsed.
pub(super) struct Json<'a> {
    path: &'a Path,
    text: &'a str,
    root: Value<'a>,
}

impl<'a> Json<'a> {
    /// Parses `bytes`, the content of the file at `path`.
    ///
    /// # Errors
    /// At the first byte that is not JSON. Values more than 512 deep are an error too.
    pub fn parse(path: &'a Path, bytes: &'a [u8]) -> Result<Self, Diagnostic> {
        let text = utf8(path, bytes)?;
        let end = text.trim_end().len();
        let value = parse_to_ast(text, &CollectOptions::default(), &STRICT)
            .map_err(|error| syntax_fault(text, &error))
            .and_then(|parsed| {
                let nothing = || Fault::at(end, "expected a value, found the end of the file");
                parsed.value.ok_or_else(nothing)
            });
        match value {
            Ok(root) => Ok(Self { path, text, root }),
            Err(fault) => Err(fault.diagnostic(path, text)),
        }
    }

    /// The file as a `T`. Every number that `T` takes as an `f32` is finite; no object of the file
    /// has a key twice; a struct is written as an object and never as a list.
    ///
    /// # Errors
    /// At the first key or value that does not fit.
    pub fn read<T: DeserializeOwned>(&self) -> Result<T, Diagnostic> {
        let node = Node {
            text: self.text,
            value: &self.root,
        };
        node.read(PhantomData)
            .map_err(|fault| fault.diagnostic(self.path, self.text))
    }

    /// The whole text, into which the spans of `serde_spanned::Spanned` point.
    pub fn text(&self) -> &'a str {
        self.text
    }
}

/// Why JSON could not be read.
#[derive(Debug)]
pub(super) struct Fault {
    /// The byte of the text at fault; `None` until the innermost value around it is known.
    at: Option<usize>,
    message: String,
}

impl Fault {
    /// A fault at the byte `at`.
    pub fn at(at: usize, message: impl Into<String>) -> Self {
        Self {
            at: Some(at),
            message: message.into(),
        }
    }

    /// The same fault at the byte `at`, if it has no place yet.
    pub fn or_at(self, at: usize) -> Self {
        Self {
            at: self.at.or(Some(at)),
            ..self
        }
    }

    fn diagnostic(self, path: &Path, text: &str) -> Diagnostic {
        Diagnostic {
            position: self.at.map(|at| Position::in_text(text, at)),
            ..Diagnostic::new(path, self.message)
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self {
            at: None,
            message: message.to_string(),
        }
    }

    fn invalid_type(found: Unexpected, expected: &dyn Expected) -> Self {
        let found = match found {
            Unexpected::Bool(value) => value.to_string(),
            Unexpected::Float(number) => number.to_string(),
            Unexpected::Str(text) => quoted(text),
            Unexpected::Unit => "null".to_owned(),
            Unexpected::Seq => "a list".to_owned(),
            Unexpected::Map => "an object".to_owned(),
            other => other.to_string(),
        };
        Self::custom(format!("expected {expected}, found {found}"))
    }

    fn invalid_length(count: usize, expected: &dyn Expected) -> Self {
        Self::custom(format!("expected {expected}, found {count}"))
    }

    fn unknown_variant(found: &str, expected: &'static [&'static str]) -> Self {
        let (expected, found) = (one_of(expected), quoted(found));
        Self::custom(format!("expected {expected}, found {found}"))
    }

    fn unknown_field(found: &str, expected: &'static [&'static str]) -> Self {
        Self::unknown_variant(found, expected)
    }

    fn missing_field(field: &'static str) -> Self {
        Self::custom(format!("expected `{field}`, found none"))
    }
}

/// `names` as alternatives in a message.
pub(super) fn one_of(names: &[&str]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match names.as_slice() {
        [] => "nothing".to_owned(),
        [only] => only.clone(),
        [one, other] => format!("{one} or {other}"),
        _ => format!("one of {}", names.join(", ")),
    }
}

/// The parser's error in the words of this program, with its place.
fn syntax_fault(text: &str, error: &ParseError) -> Fault {
    use ParseErrorKind as Kind;
    use ParseStringErrorKind as StringKind;
    let range = error.range();
    let end = text.trim_end().len();
    let next = |from: usize| {
        let rest = text.get(from..).unwrap_or("");
        from + (rest.len() - rest.trim_start().len())
    };
    let begin = next(0);
    let (at, expected) = match error.kind() {
        // Text of another kind, as of a mesh or a skeleton.
        _ if text[begin..].starts_with(|c: char| c.is_alphanumeric() || "+-.#<".contains(c)) => {
            (begin, "JSON, which begins with `{`")
        }
        Kind::UnterminatedObject => (end, "the rest of an object"),
        Kind::UnterminatedArray => (end, "the rest of a list"),
        Kind::TrailingCommasNotAllowed => (next(range.end), "another entry after the comma"),
        Kind::ExpectedComma => (next(range.start), "a comma"),
        Kind::ExpectedColonAfterObjectKey => (range.start, "a colon after the key"),
        Kind::ExpectedObjectValue => (range.start, "a value after the colon"),
        Kind::UnexpectedTokenInObject | Kind::ExpectedStringObjectProperty => {
            (range.start, "a key in double quotes, a comma or `}`")
        }
        Kind::MultipleRootJsonValues => (range.start, "the end of the file"),
        Kind::CommentsNotAllowed | Kind::UnterminatedCommentBlock => {
            (range.start, "JSON, which has no comments")
        }
        Kind::SingleQuotedStringsNotAllowed => (range.start, "double quotes"),
        Kind::NestingDepthExceeded => (range.start, "at most 512 values inside one another"),
        Kind::String(StringKind::UnterminatedStringLiteral) => {
            return Fault::at(range.start, "expected the closing quote, found none");
        }
        Kind::String(_) => (range.start, "an escape such as \\n or \\u00e9"),
        Kind::ExpectedDigit
        | Kind::ExpectedDigitFollowingNegativeSign
        | Kind::ExpectedPlusMinusOrDigitInNumberLiteral
        | Kind::BareDecimalPointNumbersNotAllowed
        | Kind::HexadecimalNumbersNotAllowed
        | Kind::NonFiniteNumbersNotAllowed
        | Kind::UnaryPlusNumbersNotAllowed => (range.start, "a number such as -1.5 or 2e3"),
        Kind::UnexpectedCloseBrace
        | Kind::UnexpectedCloseBracket
        | Kind::UnexpectedColon
        | Kind::UnexpectedComma
        | Kind::UnexpectedToken
        | Kind::UnexpectedWord => (range.start, "a value"),
    };
    let at = at.min(end);
    let found = match word(&text[at..end]) {
        "" => "the end of the file".to_owned(),
        found => quoted(found),
    };
    Fault::at(at, format!("expected {expected}, found {found}"))
}

/// The word or number that `text` begins with, or else its first character.
fn word(text: &str) -> &str {
    let is_part = |c: char| c.is_alphanumeric() || "_+-.".contains(c);
    match text.find(|c| !is_part(c)).unwrap_or(text.len()) {
        0 => &text[..text.chars().next().map_or(0, char::len_utf8)],
        end => &text[..end],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_spanned::Spanned;
    use std::collections::BTreeMap;

    fn read<T: DeserializeOwned>(text: &str) -> Result<T, String> {
        Json::parse(Path::new("a.json"), text.as_bytes())
            .and_then(|json| json.read())
            .map_err(|error| error.to_string())
    }

    type Lists = BTreeMap<String, Vec<f32>>;

    #[test]
    fn what_is_no_json_is_told_where_it_is() {
        for (text, error) in [
            ("", "1:1: expected a value, found the end of the file"),
            (
                "\n {\n",
                "2:3: expected the rest of an object, found the end of the file",
            ),
            (
                "{\"a\": [1,\n2",
                "2:2: expected the rest of a list, found the end of the file",
            ),
            (
                "{\"a\": [1,\n ]}",
                "2:2: expected another entry after the comma, found “]”",
            ),
            ("{\"é\": [1 2]}", "1:10: expected a comma, found “2”"),
            (
                "{\"é\" [1]}",
                "1:6: expected a colon after the key, found “[”",
            ),
            (
                "{\"a\":",
                "1:6: expected a value after the colon, found the end of the file",
            ),
            (
                "{a: [1]}",
                "1:2: expected a key in double quotes, a comma or `}`, found “a”",
            ),
            (
                "{\"a\": [1]} {}",
                "1:12: expected the end of the file, found “{”",
            ),
            (
                "{\"a\": [1]} // 1",
                "1:12: expected JSON, which has no comments, found “/”",
            ),
            ("{'a': [1]}", "1:2: expected double quotes, found “'”"),
            (
                "{\"a\": [\"b\n",
                "1:8: expected the closing quote, found none",
            ),
            (
                "v 1 0 0\nv 2 0 0\n",
                "1:1: expected JSON, which begins with `{`, found “v”",
            ),
            (
                "\n0 0.5 0 -1 # Root\n",
                "2:1: expected JSON, which begins with `{`, found “0”",
            ),
            ("{\"a\": [tru]}", "1:8: expected a value, found “tru”"),
            (
                "{\"a\": [.5]}",
                "1:8: expected a number such as -1.5 or 2e3, found “.5”",
            ),
            ("{\"a\": [NaN]}", "1:8: expected a value, found “NaN”"),
            ("{\"a\": [,]}", "1:8: expected a value, found “,”"),
            ("{\"a\": [01]}", "1:9: expected a comma, found “1”"),
            (
                "{\"a\\q\": [1]}",
                "1:4: expected an escape such as \\n or \\u00e9, found “\\”",
            ),
            (
                "{\"a\tb\": [1]}",
                "1:4: expected an escape such as \\n, found a control character in a string",
            ),
        ] {
            assert_eq!(
                read::<Lists>(text),
                Err(format!("a.json:{error}")),
                "{text}"
            );
        }
    }

    #[test]
    fn what_does_not_fit_is_told_at_its_first_byte() {
        for (text, error) in [
            ("[1]", "1:1: expected a map, found a list"),
            (
                "{\"a\": [1], \"b\":\n  {}}",
                "2:3: expected a list, found an object",
            ),
            ("{\"a\": [1, null]}", "1:11: expected a number, found null"),
            ("{\"a\": [1, \"2\"]}", "1:11: expected a number, found “2”"),
            (
                "{\"a\": [1, -1e39]}",
                "1:11: expected a number below 3.4e38, found a larger one",
            ),
            (
                "{\"é\": [], \"b\": [], \"\\u00e9\": []}",
                "1:20: expected each name once, found “é” again",
            ),
        ] {
            assert_eq!(
                read::<Lists>(text),
                Err(format!("a.json:{error}")),
                "{text}"
            );
        }
    }

    #[test]
    fn numbers_are_rounded_once_to_the_nearest_f32() {
        // Rounded to an `f64` first this lies halfway between two `f32`, and would round down.
        let lists: Lists = read("{\"a\": [1.00000017881393432617187499, -0.1, 1E2]}").unwrap();
        assert_eq!(lists["a"], [1.000_000_1, -0.1, 100.0]);
    }

    #[test]
    fn spans_are_bytes_of_the_text() {
        let text = "{\"é\":  [1, 25]}";
        let lists: BTreeMap<Spanned<String>, Spanned<Vec<f32>>> = read(text).unwrap();
        let (key, list) = lists.first_key_value().unwrap();
        assert_eq!(&text[key.span()], "\"é\"");
        assert_eq!(&text[list.span()], "[1, 25]");
    }

    #[test]
    fn neither_depth_nor_length_stops_the_program() {
        let deep = "[".repeat(1_000_000);
        let error = read::<Lists>(&deep).unwrap_err();
        assert!(
            error.contains("at most 512 values inside one another"),
            "{error}"
        );
        let long = format!("{{\"a\": [{}1, x]}}", "1, ".repeat(1_000_000));
        let error = read::<Lists>(&long).unwrap_err();
        assert_eq!(error, "a.json:1:3000011: expected a value, found “x”");
    }
}
