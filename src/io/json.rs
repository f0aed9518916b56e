//! What the formats written as JSON share.

use super::{Diagnostic, scanner};
use glam::Vec3;
use serde::Deserialize;
use serde::de::{DeserializeOwned, Deserializer, Error as _};
use std::path::Path;

/// Reads `bytes` as one value.
///
/// # Errors
/// With line and column, for what is no JSON and for what is no such value.
pub(super) fn read<T: DeserializeOwned>(path: &Path, bytes: &[u8]) -> Result<T, Diagnostic> {
    let text = scanner::utf8(path, bytes)?;
    serde_json::from_str(text).map_err(|error| {
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

/// The library's message without the place, which it repeats, and with what was `found` where it
/// keeps that to itself.
fn in_words(error: &serde_json::Error, found: Option<char>) -> String {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&place).unwrap_or(&message);
    match found {
        Some(found) if error.is_syntax() && message.starts_with("expected ") => {
            format!("{message}, found {}", scanner::quoted(&found.to_string()))
        }
        _ => message.to_owned(),
    }
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
    let at = from + text[from..].find(&spelled)?;
    let before = &text[..at];
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
/// If one does not.
pub(super) fn finite3<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    let numbers = <[Finite; 3]>::deserialize(deserializer)?;
    Ok(numbers.map(|number| number.0).into())
}
