//! JSON with places: `jsonc-parser` gives the tree with the bytes that each part comes from, and
//! [`Json`] hands it to serde, so that every error points at the key or value at fault.

use super::scanner::{quoted, shown, utf8};
use super::{Diagnostic, Position};
use glam::Vec3;
use jsonc_parser::ast::{Object, ObjectProp, Value};
use jsonc_parser::common::Ranged;
use jsonc_parser::errors::{ParseError, ParseErrorKind};
use jsonc_parser::{CollectOptions, ParseOptions, ParseStringErrorKind, parse_to_ast};
use serde::Deserialize;
use serde::de::value::StrDeserializer;
use serde::de::{
    self, DeserializeOwned, DeserializeSeed, Deserializer, Error as _, Expected, IntoDeserializer,
    MapAccess, SeqAccess, Unexpected, Visitor,
};
use serde_spanned::de::{SpannedDeserializer, is_spanned};
use std::collections::HashSet;
use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;
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
struct Fault {
    /// The byte of the text at fault; `None` until the innermost value around it is known.
    at: Option<usize>,
    message: String,
}

impl Fault {
    fn at(at: usize, message: impl Into<String>) -> Self {
        Self {
            at: Some(at),
            message: message.into(),
        }
    }

    /// The same fault at the byte `at`, if it has no place yet.
    fn or_at(self, at: usize) -> Self {
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

fn one_of(names: &[&str]) -> String {
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
    let (at, expected) = match error.kind() {
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
    let found = match text[at..end].chars().next() {
        Some(found) => quoted(&found.to_string()),
        None => "the end of the file".to_owned(),
    };
    Fault::at(at, format!("expected {expected}, found {found}"))
}

/// A value of the tree, for serde.
#[derive(Clone, Copy)]
struct Node<'n> {
    text: &'n str,
    value: &'n Value<'n>,
}

impl<'n> Node<'n> {
    fn start(self) -> usize {
        self.value.range().start
    }

    fn span(self) -> Range<usize> {
        let range = self.value.range();
        range.start..range.end
    }

    /// Reads the value; a fault without a place of its own is here.
    fn read<'de, S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, Fault> {
        let read = seed.deserialize(self);
        read.map_err(|fault| fault.or_at(self.start()))
    }

    fn wrong(self, expected: &dyn fmt::Display) -> Fault {
        let found = match self.value {
            Value::StringLit(string) => quoted(&string.value),
            Value::NumberLit(number) => shown(number.value),
            Value::BooleanLit(boolean) => boolean.value.to_string(),
            Value::NullKeyword(_) => "null".to_owned(),
            Value::Array(_) => "a list".to_owned(),
            Value::Object(_) => "an object".to_owned(),
        };
        Fault::at(self.start(), format!("expected {expected}, found {found}"))
    }

    /// The number here, as a `T`.
    fn number<T: std::str::FromStr>(self, expected: &str) -> Result<T, Fault> {
        let number = self.value.as_number_lit();
        let number = number.and_then(|number| number.value.parse().ok());
        number.ok_or_else(|| self.wrong(&expected))
    }

    /// The text of a string.
    fn string(self, expected: &dyn fmt::Display) -> Result<&'n str, Fault> {
        let string = self.value.as_string_lit();
        let string = string.ok_or_else(|| self.wrong(expected))?;
        check_string(self.text, self.span())?;
        Ok(&string.value)
    }

    fn fields(self, expected: &dyn fmt::Display) -> Result<Fields<'n>, Fault> {
        let object = self.value.as_object();
        Fields::new(self.text, object.ok_or_else(|| self.wrong(expected))?)
    }

    fn items(self, expected: &dyn fmt::Display) -> Result<Items<'n>, Fault> {
        let list = self.value.as_array().ok_or_else(|| self.wrong(expected))?;
        Ok(Items {
            text: self.text,
            left: list.elements.iter(),
        })
    }
}

/// Refuses line ends and other control characters in a string, as the standard does and the
/// parser does not.
fn check_string(text: &str, span: Range<usize>) -> Result<(), Fault> {
    let control = |byte: &u8| *byte < b' ';
    match text.as_bytes()[span.clone()].iter().position(control) {
        None => Ok(()),
        Some(at) => Err(Fault::at(
            span.start + at,
            "expected an escape such as \\n, found a control character in a string",
        )),
    }
}

impl<'de> Deserializer<'de> for Node<'_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            Value::StringLit(_) => visitor.visit_str(self.string(&"a string")?),
            Value::NumberLit(_) => visitor.visit_f64(self.number("a number")?),
            Value::BooleanLit(boolean) => visitor.visit_bool(boolean.value),
            Value::NullKeyword(_) => visitor.visit_unit(),
            Value::Array(_) => visitor.visit_seq(self.items(&"a list")?),
            Value::Object(_) => visitor.visit_map(self.fields(&"an object")?),
        }
    }

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let number: f32 = self.number("a number")?;
        if number.is_finite() {
            visitor.visit_f32(number)
        } else {
            let message = "expected a number below 3.4e38, found a larger one";
            Err(Fault::custom(message))
        }
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_u32(self.number("a whole number from 0")?)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let boolean = self.value.as_boolean_lit();
        visitor.visit_bool(boolean.ok_or_else(|| self.wrong(&"true or false"))?.value)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_str(self.string(&"a string")?)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            Value::NullKeyword(_) => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_seq(self.items(&"a list")?)
    }

    fn deserialize_tuple<V: Visitor<'de>>(
        self,
        _length: usize,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let items = self.items(&(&visitor as &dyn Expected))?;
        visitor.visit_seq(items)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let fields = self.fields(&(&visitor as &dyn Expected))?;
        visitor.visit_map(fields)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        if is_spanned(name) {
            visitor.visit_map(SpannedDeserializer::new(self, self.span()))
        } else {
            visitor.visit_map(self.fields(&"an object")?)
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let name = self.string(&one_of(variants))?;
        visitor.visit_enum(StrDeserializer::new(name))
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    serde::forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u16 u64 u128 f64 char bytes byte_buf unit unit_struct tuple_struct
        identifier
    }
}

impl<'de> IntoDeserializer<'de, Fault> for Node<'_> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// The values of a list.
struct Items<'n> {
    text: &'n str,
    left: std::slice::Iter<'n, Value<'n>>,
}

impl<'de> SeqAccess<'de> for Items<'_> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Fault> {
        let text = self.text;
        let next = self.left.next();
        next.map(|value| Node { text, value }.read(seed))
            .transpose()
    }
}

/// The keys and values of an object.
struct Fields<'n> {
    text: &'n str,
    left: std::slice::Iter<'n, ObjectProp<'n>>,
    value: Option<&'n Value<'n>>,
}

impl<'n> Fields<'n> {
    /// # Errors
    /// At the first key that is there again.
    fn new(text: &'n str, object: &'n Object<'n>) -> Result<Self, Fault> {
        let mut seen = HashSet::with_capacity(object.properties.len());
        for property in &object.properties {
            let name = property.name.as_str();
            if !seen.insert(name) {
                let message = format!("expected each name once, found {} again", quoted(name));
                return Err(Fault::at(property.name.range().start, message));
            }
        }
        Ok(Self {
            text,
            left: object.properties.iter(),
            value: None,
        })
    }
}

impl<'de> MapAccess<'de> for Fields<'_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Fault> {
        let Some(property) = self.left.next() else {
            return Ok(None);
        };
        self.value = Some(&property.value);
        let range = property.name.range();
        check_string(self.text, range.start..range.end)?;
        let key = Key {
            text: property.name.as_str(),
            span: range.start..range.end,
        };
        let read = seed.deserialize(key);
        read.map(Some).map_err(|fault| fault.or_at(range.start))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Fault> {
        let value = self.value.take();
        let value = value.ok_or_else(|| Fault::custom("expected a key before its value"))?;
        let text = self.text;
        Node { text, value }.read(seed)
    }
}

/// The key of an object.
struct Key<'n> {
    text: &'n str,
    span: Range<usize>,
}

impl<'de> Deserializer<'de> for Key<'_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_str(self.text)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        if is_spanned(name) {
            visitor.visit_map(SpannedDeserializer::new(self.text, self.span))
        } else {
            self.deserialize_any(visitor)
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option
        unit unit_struct newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

/// Three numbers `[x, y, z]`, each of which `check` accepts.
///
/// # Errors
/// If there are more or fewer; at the first that is no finite number, or for which `check` says
/// what is wrong.
pub(super) fn vec3<'de, D: Deserializer<'de>>(
    deserializer: D,
    check: fn(f32) -> Result<(), String>,
) -> Result<Vec3, D::Error> {
    deserializer.deserialize_tuple(3, Three { check })
}

struct Three {
    check: fn(f32) -> Result<(), String>,
}

impl<'de> Visitor<'de> for Three {
    type Value = Vec3;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("three numbers [x, y, z]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Vec3, A::Error> {
        let mut vector = Vec3::ZERO;
        let mut count = 0;
        while let Some(number) = numbers.next_element_seed(Checked(self.check))? {
            if count < 3 {
                vector[count] = number;
            }
            count += 1;
        }
        if count == 3 {
            Ok(vector)
        } else {
            Err(A::Error::invalid_length(count, &self))
        }
    }
}

/// Reads a finite number that the check accepts; the check returns the message for others.
struct Checked(fn(f32) -> Result<(), String>);

impl<'de> DeserializeSeed<'de> for Checked {
    type Value = f32;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f32, D::Error> {
        let number = f32::deserialize(deserializer)?;
        (self.0)(number).map_err(D::Error::custom)?;
        Ok(number)
    }
}

/// A number that `check` accepts.
///
/// # Errors
/// If it is no finite number; what `check` says is wrong with it.
pub(super) fn checked<'de, D: Deserializer<'de>>(
    deserializer: D,
    check: fn(f32) -> Result<(), String>,
) -> Result<f32, D::Error> {
    Checked(check).deserialize(deserializer)
}

/// A number above 0.
///
/// # Errors
/// If it is not.
pub(super) fn positive<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f32, D::Error> {
    checked(deserializer, |number| match number {
        _ if number > 0.0 => Ok(()),
        _ => Err(format!("expected a number above 0, found {number}")),
    })
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
            ("{\"a\": [tru]}", "1:8: expected a value, found “t”"),
            (
                "{\"a\": [.5]}",
                "1:8: expected a number such as -1.5 or 2e3, found “.”",
            ),
            ("{\"a\": [NaN]}", "1:8: expected a value, found “N”"),
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
