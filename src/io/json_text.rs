//! JSON as text that people read and version control compares: one member a line, short vectors on
//! one line, numbers with as few digits as it takes to read the same ones back.

use glam::Vec3;
use std::fmt::Display;

/// A value to be written.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Text {
    /// A number, a string, a short vector: what is written on one line. Or text that was read, with
    /// the line breaks and the indentation that it had.
    Plain(String),
    /// A number that JSON cannot have.
    NotFinite,
    /// A list with each value on a line of its own.
    List(Vec<Text>),
    /// An object with each member on a line of its own, in this order.
    Object(Members),
}

/// Members of an object, in the order in which they are written.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Members(Vec<(String, Text)>);

impl Members {
    /// Adds a member.
    pub fn push(&mut self, name: &str, value: impl Into<Text>) {
        self.0.push((name.to_owned(), value.into()));
    }

    /// Adds a member unless its value is the one that is meant where there is none.
    pub fn push_unless<T: PartialEq + Into<Text>>(&mut self, name: &str, value: T, default: T) {
        if value != default {
            self.push(name, value);
        }
    }

    /// Adds an object as a member unless it is empty.
    pub fn push_some(&mut self, name: &str, members: Members) {
        if !members.0.is_empty() {
            self.push(name, members);
        }
    }

    /// Names of the members around the first number that JSON cannot have, from the outermost on,
    /// with dots between; `None` if all can be written.
    pub fn not_finite(&self) -> Option<String> {
        self.0.iter().find_map(|(name, value)| match value {
            Text::NotFinite => Some(name.clone()),
            Text::Object(members) => Some(format!("{name}.{}", members.not_finite()?)),
            Text::Plain(_) | Text::List(_) => None,
        })
    }
}

impl From<Members> for Text {
    fn from(members: Members) -> Self {
        Self::Object(members)
    }
}

impl From<Vec<Text>> for Text {
    fn from(values: Vec<Text>) -> Self {
        Self::List(values)
    }
}

impl From<bool> for Text {
    fn from(value: bool) -> Self {
        Self::Plain(value.to_string())
    }
}

impl From<u32> for Text {
    fn from(value: u32) -> Self {
        Self::Plain(value.to_string())
    }
}

impl From<usize> for Text {
    fn from(value: usize) -> Self {
        Self::Plain(value.to_string())
    }
}

impl From<f32> for Text {
    fn from(value: f32) -> Self {
        if value.is_finite() {
            Self::Plain(number(value))
        } else {
            Self::NotFinite
        }
    }
}

impl From<Vec3> for Text {
    fn from(value: Vec3) -> Self {
        if value.is_finite() {
            Self::Plain(vector(value.to_array().map(number)))
        } else {
            Self::NotFinite
        }
    }
}

impl From<&str> for Text {
    fn from(value: &str) -> Self {
        Self::Plain(string(value))
    }
}

impl Text {
    /// The text of a whole file: this value and the end of its line.
    pub fn to_file(&self) -> String {
        let mut out = String::new();
        self.write(0, &mut out);
        out.push('\n');
        out
    }

    /// The text of this value inside values that are indented by `depth` steps.
    pub fn at_depth(&self, depth: usize) -> String {
        let mut out = String::new();
        self.write(depth, &mut out);
        out
    }

    fn write(&self, depth: usize, out: &mut String) {
        match self {
            Self::Plain(text) => out.push_str(text),
            Self::NotFinite => out.push_str("null"),
            Self::List(values) => {
                let values = values.iter().map(|value| (String::new(), value));
                write_all(['[', ']'], values, depth, out);
            }
            Self::Object(Members(members)) => {
                let before = |name: &str| format!("{}: ", string(name));
                let members = members.iter().map(|(name, value)| (before(name), value));
                write_all(['{', '}'], members, depth, out);
            }
        }
    }
}

/// Writes values, each with what stands before it, on lines of their own.
fn write_all<'a>(
    [open, close]: [char; 2],
    values: impl Iterator<Item = (String, &'a Text)>,
    depth: usize,
    out: &mut String,
) {
    out.push(open);
    let mut any = false;
    for (before, value) in values {
        out.push_str(if any { ",\n" } else { "\n" });
        any = true;
        indent(depth + 1, out);
        out.push_str(&before);
        value.write(depth + 1, out);
    }
    if any {
        out.push('\n');
        indent(depth, out);
    }
    out.push(close);
}

fn indent(depth: usize, out: &mut String) {
    out.extend(std::iter::repeat_n("  ", depth));
}

/// A string in quotes.
pub(super) fn string(text: &str) -> String {
    // Only a type that cannot be written as JSON makes this fail.
    serde_json::to_string(text).unwrap_or_default()
}

/// A list of values that are written already, on one line.
pub(super) fn vector<const N: usize>(values: [String; N]) -> String {
    format!("[{}]", values.join(", "))
}

/// A finite number with as few digits as it takes to read the same one back; 0 has no sign.
pub(super) fn number<F>(value: F) -> String
where
    F: Display + std::fmt::LowerExp + Into<f64> + Copy,
{
    let size = value.into().abs();
    if size == 0.0 {
        "0".to_owned()
    } else if (1e-7..1e16).contains(&size) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}
