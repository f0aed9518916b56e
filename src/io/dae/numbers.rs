//! Lists of numbers and names between tags.

use super::document::{Dae, Node};
use super::quoted;
use crate::io::{Diagnostic, number};
use glam::DMat4;
use std::str::FromStr;

/// The words in `node`, over comments and CDATA sections.
pub(super) fn words<'a>(node: Node<'a>) -> impl Iterator<Item = &'a str> {
    node.children()
        .filter(Node::is_text)
        .filter_map(|text| text.text())
        .flat_map(str::split_ascii_whitespace)
}

/// The text in `node`, without white space around it; empty if there is none.
pub(super) fn text<'a>(node: Node<'a>) -> &'a str {
    node.text().unwrap_or("").trim()
}

/// The numbers in `node`. Some programs write `nan`, `-inf`, `1.#QNAN` or more than fits: these
/// count as zero, with a warning.
///
/// # Errors
/// At the first word that is no number.
pub(super) fn floats(dae: &Dae, node: Node) -> Result<Vec<f32>, Diagnostic> {
    let mut not_finite = NotFinite::default();
    let numbers = words(node)
        .map(|word| match number::finite(word) {
            Some(number) => Ok(number),
            None => not_finite.zero_for(dae, node, word),
        })
        .collect();
    not_finite.warn(dae, node);
    numbers
}

/// The numbers in `node` at full precision, for matrices; exactly `N`.
///
/// # Errors
/// If there are more or fewer, or a word is no finite number.
pub(super) fn fixed<const N: usize>(dae: &Dae, node: Node) -> Result<[f64; N], Diagnostic> {
    let mut numbers = [0.0; N];
    let mut found = 0;
    for word in words(node) {
        let number = word.parse().ok().filter(|number: &f64| number.is_finite());
        let number = number.ok_or_else(|| expected_number(dae, node, word))?;
        if let Some(place) = numbers.get_mut(found) {
            *place = number;
        }
        found += 1;
    }
    if found == N {
        return Ok(numbers);
    }
    let tag = node.tag_name().name();
    Err(dae.error(
        node,
        format!("expected {N} numbers in <{tag}>, found {found}"),
    ))
}

/// A matrix, which Collada writes row by row.
///
/// # Errors
/// As [`fixed`].
pub(super) fn matrix(dae: &Dae, node: Node) -> Result<DMat4, Diagnostic> {
    Ok(DMat4::from_cols_array(&fixed(dae, node)?).transpose())
}

/// The whole numbers in `node`.
///
/// # Errors
/// At the first word that is none, or is out of the type's range.
pub(super) fn integers<T: FromStr>(dae: &Dae, node: Node) -> Result<Vec<T>, Diagnostic> {
    words(node)
        .map(|word| {
            word.parse().map_err(|_| {
                let message = format!("expected an index, found {}", quoted(word));
                dae.error_at(dae.offset_of(node, word), message)
            })
        })
        .collect()
}

/// Attribute `name` of `node` as a number of things; none if it is missing.
///
/// # Errors
/// If it is no whole number.
pub(super) fn count(dae: &Dae, node: Node, name: &str) -> Result<Option<usize>, Diagnostic> {
    node.attribute(name)
        .map(|value| {
            value.trim().parse().map_err(|_| {
                let message = format!("expected {name}=\"a count\", found {}", quoted(value));
                dae.error(node, message)
            })
        })
        .transpose()
}

#[derive(Default)]
struct NotFinite {
    count: usize,
    first: Option<usize>,
}

impl NotFinite {
    fn zero_for(&mut self, dae: &Dae, node: Node, word: &str) -> Result<f32, Diagnostic> {
        let lower = word.to_ascii_lowercase();
        if word.parse::<f32>().is_err()
            && !["nan", "inf", "#ind"]
                .iter()
                .any(|mark| lower.contains(mark))
        {
            return Err(expected_number(dae, node, word));
        }
        self.count += 1;
        self.first.get_or_insert_with(|| dae.offset_of(node, word));
        Ok(0.0)
    }

    fn warn(self, dae: &Dae, node: Node) {
        if let Some(first) = self.first {
            let (count, tag) = (self.count, node.tag_name().name());
            dae.warn_with(|| {
                let message = format!(
                    "expected finite numbers in <{tag}>, found {count} that are not: taken as 0"
                );
                dae.error_at(first, message)
            });
        }
    }
}

fn expected_number(dae: &Dae, node: Node, word: &str) -> Diagnostic {
    let message = format!("expected a number, found {}", quoted(word));
    dae.error_at(dae.offset_of(node, word), message)
}
