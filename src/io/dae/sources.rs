//! Lists of numbers and names between tags, `<source>` (an array with an `<accessor>` that says
//! how rows lie in it) and `<input>`.

use super::document::{Dae, Impact, Node, child, children};
use super::{label, quoted};
use crate::io::Diagnostic;
use crate::io::numbers::{finite, plain_decimal, plain_index};
use glam::DMat4;
use roxmltree::NodeId;
use std::collections::HashMap;
use std::rc::Rc;
use std::str::FromStr;

/// The words in `node`, over comments and CDATA sections.
pub(super) fn words<'a>(node: Node<'a>) -> impl Iterator<Item = &'a str> {
    texts(node).flat_map(str::split_ascii_whitespace)
}

fn texts<'a>(node: Node<'a>) -> impl Iterator<Item = &'a str> {
    let texts = node.children().filter(Node::is_text);
    texts.filter_map(|text| text.text())
}

/// Reads each word in `node` by `plain`, which knows the usual spellings and how long the word is, or else by
/// `other`. Files are numbers mostly, so that words are not looked for before they are read.
fn read_words<T>(
    node: Node,
    plain: impl Fn(&[u8]) -> Option<(T, usize)>,
    mut other: impl FnMut(&str) -> Result<T, Diagnostic>,
) -> Result<Vec<T>, Diagnostic> {
    let mut values = Vec::new();
    for text in texts(node) {
        let mut rest = text.trim_ascii_start();
        while !rest.is_empty() {
            let is_end = |at: usize| {
                let next = rest.as_bytes().get(at);
                next.is_none_or(u8::is_ascii_whitespace)
            };
            let read = plain(rest.as_bytes()).filter(|&(_, length)| is_end(length));
            let (value, length) = match read {
                Some(read) => read,
                None => {
                    let word = rest.split_ascii_whitespace().next().unwrap_or(rest);
                    (other(word)?, word.len())
                }
            };
            values.push(value);
            rest = rest[length..].trim_ascii_start();
        }
    }
    Ok(values)
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
    let numbers = read_words(node, plain_decimal, |word| match finite(word) {
        Some(number) => Ok(number),
        None => not_finite.zero_for(dae, node, word),
    });
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
pub(super) fn integers<T>(dae: &Dae, node: Node) -> Result<Vec<T>, Diagnostic>
where
    T: FromStr + TryFrom<u32>,
{
    let plain = |text: &[u8]| {
        let (index, length) = plain_index(text)?;
        Some((T::try_from(index).ok()?, length))
    };
    read_words(node, plain, |word| {
        word.parse().map_err(|_| {
            let message = format!("expected an index, found {}", quoted(word));
            dae.error_at(dae.offset_of(node, word), message)
        })
    })
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
            dae.warn_with(Impact::Shape, || {
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

/// Rows of numbers.
#[derive(Debug)]
pub(super) struct Source {
    values: Vec<f32>,
    /// Where in a row its named columns are; unnamed ones are padding.
    columns: Vec<usize>,
    offset: usize,
    stride: usize,
    rows: usize,
}

impl Source {
    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// The first `N` columns of each row.
    pub fn rows<const N: usize>(&self) -> impl Iterator<Item = [f32; N]> + '_ {
        (0..self.rows).map(|row| self.row(row))
    }

    /// The first `N` columns of `row`, zero where there are fewer or the row does not exist.
    pub fn row<const N: usize>(&self, row: usize) -> [f32; N] {
        let start = self.offset + row * self.stride;
        std::array::from_fn(|column| {
            let column = self.columns.get(column);
            let value = column.and_then(|column| self.values.get(start + column));
            value.copied().unwrap_or(0.0)
        })
    }
}

/// The sources of a document, each read once however many refer to it.
#[derive(Default)]
pub(super) struct Sources {
    read: HashMap<NodeId, Result<Rc<Source>, Diagnostic>>,
}

impl Sources {
    /// The numbers that `input`'s `source` refers to, with at least `columns` columns.
    ///
    /// # Errors
    /// If there is no such source or it does not fit its array.
    pub fn floats<'a>(
        &mut self,
        dae: &Dae<'a>,
        input: Node<'a>,
        columns: usize,
    ) -> Result<Rc<Source>, Diagnostic> {
        let node = dae.target_called(input, "source", "source")?;
        let source = self
            .read
            .entry(node.id())
            .or_insert_with(|| read(dae, node).map(Rc::new))
            .clone()?;
        if source.columns.len() < columns {
            let found = source.columns.len();
            let message = format!("expected {columns} numbers a row, found {found}");
            return Err(dae.error(node, message));
        }
        Ok(source)
    }
}

/// Names of joints, and whether they are ids of nodes (`IDREF_array`) instead of sids.
pub(super) struct Names<'a> {
    pub names: Vec<&'a str>,
    pub are_ids: bool,
}

/// The names that `input`'s `source` refers to.
///
/// # Errors
/// If it has none.
pub(super) fn names<'a>(dae: &Dae<'a>, input: Node<'a>) -> Result<Names<'a>, Diagnostic> {
    let source = dae.target_called(input, "source", "source")?;
    let array = |tag| child(source, tag);
    let (array, are_ids) = if let Some(array) = array("Name_array") {
        (array, false)
    } else if let Some(array) = array("IDREF_array") {
        (array, true)
    } else {
        let message = format!(
            "expected <Name_array> or <IDREF_array> in {}",
            label(source)
        );
        return Err(dae.error(source, message));
    };
    let names = words(array).collect();
    Ok(Names { names, are_ids })
}

fn read<'a>(dae: &Dae<'a>, source: Node<'a>) -> Result<Source, Diagnostic> {
    let accessor = child(source, "technique_common").and_then(|common| child(common, "accessor"));
    let Some(accessor) = accessor else {
        return whole_array(dae, source);
    };
    let array = match accessor.attribute("source") {
        Some(url) => dae.by_url(accessor, url)?,
        None => dae.child(source, "float_array")?,
    };
    if array.tag_name().name() != "float_array" {
        let message = format!("expected <float_array>, found {}", label(array));
        return Err(dae.error(accessor, message));
    }
    let values = floats(dae, array)?;
    let (columns, params) = columns(accessor);
    let stride = count(dae, accessor, "stride")?.unwrap_or(params.max(1));
    let columns = if columns.is_empty() {
        (0..stride.min(16)).collect()
    } else if params == 1 && stride == 16 {
        // One column of matrices.
        (0..16).collect()
    } else {
        columns
    };
    let offset = count(dae, accessor, "offset")?.unwrap_or(0);
    let needed = columns.last().map_or(1, |last| last + 1);
    if stride < needed {
        let message = format!("expected a stride of at least {needed}, found {stride}");
        return Err(dae.error(accessor, message));
    }
    let fitting = match values.len().checked_sub(offset) {
        Some(left) if left >= needed => (left - needed) / stride + 1,
        _ => 0,
    };
    let promised = count(dae, accessor, "count")?.unwrap_or(fitting);
    if promised > fitting {
        let found = values.len();
        let message =
            format!("expected numbers for {promised} rows, found {found}, enough for {fitting}");
        dae.warn(Impact::Shape, accessor, message);
    }
    Ok(Source {
        values,
        columns,
        offset,
        stride,
        rows: promised.min(fitting),
    })
}

/// A source without an accessor is taken as rows of three.
fn whole_array<'a>(dae: &Dae<'a>, source: Node<'a>) -> Result<Source, Diagnostic> {
    let values = floats(dae, dae.child(source, "float_array")?)?;
    let message = "expected an <accessor>, found none: taken as rows of three".to_owned();
    dae.warn(Impact::Shape, source, message);
    Ok(Source {
        rows: values.len() / 3,
        values,
        columns: vec![0, 1, 2],
        offset: 0,
        stride: 3,
    })
}

/// Which columns have a name, and how many there are with those that have none.
fn columns(accessor: Node) -> (Vec<usize>, usize) {
    let params = || children(accessor, "param");
    let named = params()
        .enumerate()
        .filter(|(_, param)| param.has_attribute("name"))
        .map(|(column, _)| column);
    let named: Vec<usize> = named.collect();
    let count = params().count();
    // Some exporters name no column and mean all of them.
    if named.is_empty() {
        ((0..count).collect(), count)
    } else {
        (named, count)
    }
}

/// An `<input>`: its semantic, and the offset of its index among those of a vertex.
pub(super) struct Input<'a> {
    pub node: Node<'a>,
    pub semantic: &'a str,
    pub offset: usize,
    pub set: usize,
}

/// Offsets beyond this are a fault of the file: a vertex has a handful of indices.
const MOST_OFFSET: usize = 64;

/// The inputs of `node`.
///
/// # Errors
/// If one has a bad offset.
pub(super) fn inputs<'a>(dae: &Dae<'a>, node: Node<'a>) -> Result<Vec<Input<'a>>, Diagnostic> {
    children(node, "input")
        .take(MOST_OFFSET)
        .map(|input| {
            let offset = count(dae, input, "offset")?.unwrap_or(0);
            if offset > MOST_OFFSET {
                let found = quoted(input.attribute("offset").unwrap_or_default());
                let message = format!("expected an offset of at most {MOST_OFFSET}, found {found}");
                return Err(dae.error(input, message));
            }
            Ok(Input {
                node: input,
                semantic: input.attribute("semantic").unwrap_or_default(),
                offset,
                set: count(dae, input, "set")?.unwrap_or(0),
            })
        })
        .collect()
}
