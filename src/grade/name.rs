//! Names of submissions, in the order in which people count.

use serde::{Serialize, Serializer};
use std::fmt;

/// A name. S2 comes before S10, and capitals count only where nothing else differs.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Name {
    parts: Vec<Part>,
    text: String,
}

/// A part of a name that is all digits or has none.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    /// How many digits there are without zeros before them, and which: a name may have more than
    /// fit into a number.
    Number(usize, String),
    /// In small letters.
    Text(String),
}

impl From<&str> for Name {
    fn from(text: &str) -> Self {
        let (mut parts, mut rest) = (Vec::new(), text);
        while let Some(first) = rest.chars().next() {
            let is_number = first.is_ascii_digit();
            let is_other = |c: char| c.is_ascii_digit() != is_number;
            let (part, after) = rest.split_at(rest.find(is_other).unwrap_or(rest.len()));
            let digits = part.trim_start_matches('0');
            parts.push(match is_number {
                true => Part::Number(digits.len(), digits.to_owned()),
                false => Part::Text(part.to_lowercase()),
            });
            rest = after;
        }
        Self {
            parts,
            text: text.to_owned(),
        }
    }
}

impl Name {
    /// The name as it is written.
    pub fn as_str(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Serialize for Name {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_names_count_by_their_value() {
        let sorted = [
            "",
            "2",
            "10",
            "a",
            "a1b2",
            "a1b10",
            "A2",
            "a02",
            "a2",
            "a2 b",
            "a10",
            "a99999999999999999999",
            "a100000000000000000000",
            "b",
            "Chen",
            "chen",
            "é",
        ];
        let names: Vec<Name> = sorted.into_iter().map(Name::from).collect();
        assert!(names.is_sorted(), "{names:?}");
    }
}
