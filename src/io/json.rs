//! What the formats written as JSON share.

use super::{Diagnostic, scanner};
use glam::Vec3;
use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{
    DeserializeOwned, Deserializer, Error as _, IgnoredAny, MapAccess, SeqAccess, Visitor,
};
use std::fmt;
use std::marker::PhantomData;
use std::path::Path;

/// Reads `bytes` as one object.
///
/// # Errors
/// With line and column, for what is no JSON and for what is no such object.
pub(super) fn read<T: DeserializeOwned>(path: &Path, bytes: &[u8]) -> Result<T, Diagnostic> {
    let text = scanner::utf8(path, bytes)?;
    let read: Result<Object<T>, _> = serde_json::from_str(text);
    read.map(|object| object.0).map_err(|error| {
        let line = text.lines().nth(error.line().saturating_sub(1));
        let line = line.unwrap_or("").as_bytes();
        // The library counts columns in bytes.
        let mut before = error.column().saturating_sub(1).min(line.len());
        if error.is_data() {
            before = start_of_token(line, before);
        }
        let found = String::from_utf8_lossy(&line[before..]).chars().next();
        let column = String::from_utf8_lossy(&line[..before]).chars().count() + 1;
        Diagnostic::at(path, error.line().max(1), column, in_words(&error, found))
    })
}

/// The library's message without the place, which it repeats, turned to what was expected and
/// what was found, which is `found` where it keeps that to itself.
fn in_words(error: &serde_json::Error, found: Option<char>) -> String {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&place).unwrap_or(&message);
    let found = found.map_or("the end of the line".to_owned(), |found| {
        scanner::quoted(&found.to_string())
    });
    if error.is_eof() {
        let expected = match message.strip_prefix("EOF while parsing ") {
            Some(begun @ ("an object" | "a list" | "a string")) => format!("the rest of {begun}"),
            _ => "a value".to_owned(),
        };
        return format!("expected {expected}, found the end of the file");
    }
    if error.is_syntax() && message.starts_with("expected ") {
        return format!("{message}, found {found}");
    }
    if message == "trailing comma" {
        return format!("expected another entry after the comma, found {found}");
    }
    if message == "trailing characters" {
        return format!("expected the end of the file, found {found}");
    }
    if message == "number out of range" {
        return "expected a number below 3.4e38, found a larger one".to_owned();
    }
    if let Some(field) = message.strip_prefix("missing field ") {
        return format!("expected {field}, found none");
    }
    if let Some(field) = message.strip_prefix("duplicate field ") {
        return format!("expected each name once, found {field} again");
    }
    let told = split(message, "invalid type: ", ", expected ")
        .or_else(|| split(message, "invalid value: ", ", expected "))
        .or_else(|| split(message, "invalid length ", ", expected "))
        .or_else(|| split(message, "unknown field ", ", expected "))
        .or_else(|| split(message, "unknown variant ", ", expected "));
    match told {
        Some((found, expected)) => {
            let (expected, found) = (in_plain_words(expected), in_plain_words(found));
            format!("expected {expected}, found {found}")
        }
        None => message.to_owned(),
    }
}

/// The libraries' names for values, as the format's description would have them.
fn in_plain_words(library: &str) -> &str {
    match library {
        "f32" => "a number",
        "u32" => "a whole number from 0",
        "a boolean" => "true or false",
        "sequence" | "a sequence" => "a list",
        "map" | "a map" => "an object",
        _ => library
            .strip_prefix("integer `")
            .or_else(|| library.strip_prefix("floating point `"))
            .or_else(|| library.strip_prefix("boolean `"))
            .and_then(|value| value.strip_suffix('`'))
            .unwrap_or(library),
    }
}

/// What is written as an object. Left to itself the library takes a list of values in the order of
/// the fields as well, which no description of our formats has.
struct Object<T>(T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Object<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Fields<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Fields<T> {
            type Value = T;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
                T::deserialize(MapAccessDeserializer::new(map))
            }
        }
        deserializer.deserialize_any(Fields(PhantomData)).map(Self)
    }
}

/// A value that is written as an object.
///
/// # Errors
/// If it is something else, or a wrong one.
pub(super) fn object<'de, T, D>(deserializer: D) -> Result<T, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    Object::deserialize(deserializer).map(|object| object.0)
}

/// The same where it may be left out.
///
/// # Errors
/// See [`object`].
pub(super) fn optional_object<'de, T, D>(deserializer: D) -> Result<Option<T>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    object(deserializer).map(Some)
}

/// A list of such values.
///
/// # Errors
/// See [`object`].
pub(super) fn objects<'de, T, D>(deserializer: D) -> Result<Vec<T>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    let objects: Vec<Object<T>> = Vec::deserialize(deserializer)?;
    Ok(objects.into_iter().map(|object| object.0).collect())
}

/// What stands in `message` between `before` and `between`, and what after.
fn split<'a>(message: &'a str, before: &str, between: &str) -> Option<(&'a str, &'a str)> {
    message.strip_prefix(before)?.rsplit_once(between)
}

/// Where the string, number or word starts whose last byte is `end` of `line`.
fn start_of_token(line: &[u8], end: usize) -> usize {
    let before = &line[..end.min(line.len())];
    if line.get(end) == Some(&b'"') {
        // A quote within a string has a backslash before it.
        (0..before.len())
            .rev()
            .find(|&at| before[at] == b'"' && (at == 0 || before[at - 1] != b'\\'))
            .unwrap_or(end)
    } else {
        let in_word = |byte: &&u8| byte.is_ascii_alphanumeric() || b"+-.".contains(byte);
        let up_to_end = line.get(..=end).unwrap_or(line).iter().rev();
        end - up_to_end.take_while(in_word).count().saturating_sub(1)
    }
}

/// Where the key `key` first stands in the text after `after`, itself a key; for faults that
/// show only when the whole file is known.
pub(super) fn position_of_key(text: &str, after: &str, key: &str) -> Option<super::Position> {
    let spelled = serde_json::to_string(key).ok()?;
    let from = text.find(&format!("\"{after}\""))? + after.len() + 2;
    position_of_byte(text, from + text[from..].find(&spelled)?)
}

/// Where the value at `index` begins in the list that follows the first key `list`; for faults
/// that show only when the whole file is known.
pub(super) fn position_of_item(text: &str, list: &str, index: usize) -> Option<super::Position> {
    let key = text.find(&format!("\"{list}\""))?;
    let mut at = key + text[key..].find('[')? + 1;
    let between = |c: char| c.is_whitespace() || c == ',';
    for _ in 0..index {
        at = text.len() - text[at..].trim_start_matches(between).len();
        let mut values = serde_json::Deserializer::from_str(&text[at..]).into_iter::<IgnoredAny>();
        values.next()?.ok()?;
        at += values.byte_offset();
    }
    at = text.len() - text[at..].trim_start_matches(between).len();
    position_of_byte(text, at)
}

fn position_of_byte(text: &str, at: usize) -> Option<super::Position> {
    let before = text.get(..at)?;
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    Some(super::Position {
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
    })
}

/// A number that an `f32` holds: JSON has larger ones.
#[derive(Clone, Copy)]
struct Finite(f32);

impl<'de> Deserialize<'de> for Finite {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let number = f32::deserialize(deserializer)?;
        if number.is_finite() {
            Ok(Self(number))
        } else {
            let message = "expected a number below 3.4e38, found a larger one";
            Err(D::Error::custom(message))
        }
    }
}

/// A number that an `f32` holds.
///
/// # Errors
/// If it does not.
pub(super) fn finite<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f32, D::Error> {
    Finite::deserialize(deserializer).map(|number| number.0)
}

/// Three numbers that an `f32` holds.
///
/// # Errors
/// If one does not, or there are more or fewer.
pub(super) fn finite3<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    deserializer.deserialize_seq(Three)
}

struct Three;

impl<'de> Visitor<'de> for Three {
    type Value = Vec3;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("three numbers [x, y, z]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Vec3, A::Error> {
        let mut vector = Vec3::ZERO;
        let mut count = 0;
        while let Some(Finite(number)) = numbers.next_element()? {
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
