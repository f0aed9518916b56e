//! The XML of a Collada file, with places and warnings, and the limits that keep memory and time
//! in proportion to its size.

use super::quoted;
use crate::geometry::Triangulator;
use crate::io::diagnostic::Warnings;
use crate::io::{Diagnostic, Position};
use roxmltree::{Document, ParsingOptions};
use std::cell::{OnceCell, RefCell};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

pub(super) type Node<'a> = roxmltree::Node<'a, 'a>;

/// A Collada document with its elements by id, places in its text, and the warnings so far.
pub(super) struct Dae<'a> {
    pub path: &'a Path,
    text: &'a str,
    pub root: Node<'a>,
    ids: HashMap<&'a str, Node<'a>>,
    /// Byte at which each line starts, once it is asked for.
    lines: OnceCell<Vec<usize>>,
    notes: RefCell<Notes>,
    /// Cuts the polygons of all its meshes.
    pub cutter: RefCell<Triangulator>,
}

#[derive(Default)]
struct Notes {
    /// By [`Impact`].
    warnings: [Warnings; 3],
    ignored: BTreeMap<String, usize>,
}

/// The effect on the picture of the fault that a warning is about. Warnings are shown in this
/// order.
#[derive(Clone, Copy)]
pub(super) enum Impact {
    /// Something is missing, or is of another shape or at another place than was meant.
    Shape,
    /// Something has another color.
    Color,
    /// Everything looks as it was meant.
    None,
}

/// Parses the XML of the file at `path`.
///
/// # Errors
/// If it is not well-formed, has a document type (entities could make it grow without end), or
/// exceeds the limits below.
pub(super) fn parse_xml<'a>(path: &Path, text: &'a str) -> Result<Document<'a>, Diagnostic> {
    check_limits(path, text)?;
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: MOST_XML_NODES,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        let message = match error {
            roxmltree::Error::DtdDetected => {
                "expected Collada without a document type, found <!DOCTYPE>".to_owned()
            }
            roxmltree::Error::NodesLimitReached => {
                format!("expected at most {MOST_XML_NODES} elements and texts, found more")
            }
            _ if text.trim().is_empty() => "expected Collada, found an empty file".to_owned(),
            // Where the outermost element begins says nothing, and the end of the file has no place.
            roxmltree::Error::UnclosedRootNode | roxmltree::Error::UnexpectedEndOfStream => {
                let line = text.lines().count().max(1);
                let column = text.lines().last().map_or(0, |last| last.chars().count()) + 1;
                let message = "expected the end of the outermost element, found that of the file: it may be cut off";
                return Diagnostic::at(path, line, column, message);
            }
            other => format!("expected well-formed XML: {other}"),
        };
        Diagnostic::at(path, at.row as usize, at.col as usize, message)
    })
}

impl<'a> Dae<'a> {
    /// Looks over `xml`, parsed from `text`.
    ///
    /// # Errors
    /// If the outermost element is not `<COLLADA>`.
    pub fn new(path: &'a Path, text: &'a str, xml: &'a Document<'a>) -> Result<Self, Diagnostic> {
        let dae = Self {
            path,
            text,
            root: xml.root_element(),
            ids: HashMap::new(),
            lines: OnceCell::new(),
            notes: RefCell::default(),
            cutter: RefCell::default(),
        };
        if dae.root.tag_name().name() != "COLLADA" {
            let message = format!("expected <COLLADA>, found {}", label(dae.root));
            return Err(dae.error(dae.root, message));
        }
        Ok(dae.with_ids())
    }

    fn with_ids(mut self) -> Self {
        let mut ids = HashMap::new();
        for node in self.root.descendants().filter(Node::is_element) {
            if let Some(id) = node.attribute("id")
                && ids.insert(id, node).is_some_and(|earlier| earlier != node)
            {
                let message = format!("expected every id once, found “{id}” again");
                self.warn(Impact::None, node, message);
            }
        }
        self.ids = ids;
        self
    }

    /// The element whose id is `id`.
    pub fn by_id(&self, id: &str) -> Option<Node<'a>> {
        self.ids.get(id).copied()
    }

    /// The element that attribute `name` of `node` refers to as `#id`.
    ///
    /// # Errors
    /// If the attribute or the element is missing, or it is in another file.
    pub fn target(&self, node: Node<'a>, name: &str) -> Result<Node<'a>, Diagnostic> {
        let url = node.attribute(name).ok_or_else(|| {
            self.error(node, format!("expected {name}=\"#…\" in {}", label(node)))
        })?;
        self.by_url(node, url)
    }

    /// The element that `url`, found at `node`, refers to as `#id`.
    ///
    /// # Errors
    /// If there is none in this file.
    pub fn by_url(&self, node: Node<'a>, url: &str) -> Result<Node<'a>, Diagnostic> {
        let url = url.trim();
        url.strip_prefix('#')
            .and_then(|id| self.by_id(id))
            .ok_or_else(|| {
                let found = quoted(url);
                self.error(
                    node,
                    format!("expected the id of an element, found {found}"),
                )
            })
    }

    /// The target of `name`, which must be an element called `tag`.
    ///
    /// # Errors
    /// As [`Dae::target`], and if it is called otherwise.
    pub fn target_called(
        &self,
        node: Node<'a>,
        name: &str,
        tag: &str,
    ) -> Result<Node<'a>, Diagnostic> {
        let target = self.target(node, name)?;
        if target.tag_name().name() == tag {
            return Ok(target);
        }
        let message = format!("expected a reference to <{tag}>, found {}", label(target));
        Err(self.error(node, message))
    }

    /// The first child of `node` called `tag`.
    ///
    /// # Errors
    /// If there is none.
    pub fn child(&self, node: Node<'a>, tag: &str) -> Result<Node<'a>, Diagnostic> {
        child(node, tag)
            .ok_or_else(|| self.error(node, format!("expected <{tag}> in {}", label(node))))
    }

    /// An error or a warning about `node`.
    pub fn error(&self, node: Node<'a>, message: impl Into<String>) -> Diagnostic {
        self.error_at(node.range().start, message)
    }

    /// An error or a warning about the byte `offset` of the file.
    pub fn error_at(&self, offset: usize, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            position: Some(self.position(offset)),
            ..Diagnostic::new(self.path, message)
        }
    }

    /// Where `part`, a piece of this document's text, starts; where `node` starts if it is not a
    /// piece of it, as for text with entities.
    pub fn offset_of(&self, node: Node<'a>, part: &str) -> usize {
        let offset = (part.as_ptr() as usize).wrapping_sub(self.text.as_ptr() as usize);
        if offset <= self.text.len() {
            offset
        } else {
            node.range().start
        }
    }

    fn position(&self, offset: usize) -> Position {
        let lines = self.lines.get_or_init(|| {
            let ends = self.text.match_indices('\n');
            let starts = std::iter::once(0).chain(ends.map(|(at, _)| at + 1));
            starts.collect()
        });
        let line = lines.partition_point(|&start| start <= offset).max(1);
        let before = self.text.get(lines[line - 1]..offset).unwrap_or("");
        Position {
            line,
            column: before.chars().count() + 1,
        }
    }

    /// Keeps a warning about `node`.
    pub fn warn(&self, impact: Impact, node: Node<'a>, message: impl Into<String>) {
        self.warn_with(impact, || self.error(node, message));
    }

    /// Keeps a warning.
    pub fn warn_with(&self, impact: Impact, warning: impl FnOnce() -> Diagnostic) {
        self.notes.borrow_mut().warnings[impact as usize].push_with(warning);
    }

    /// The value, or none and its error kept as a warning.
    pub fn or_warn<T>(&self, impact: Impact, result: Result<T, Diagnostic>) -> Option<T> {
        result
            .map_err(|error| self.warn_with(impact, || error))
            .ok()
    }

    /// Counts something in the file that this program has no use for.
    pub fn ignore(&self, what: impl Into<String>) {
        *self
            .notes
            .borrow_mut()
            .ignored
            .entry(what.into())
            .or_default() += 1;
    }

    /// The warnings, those that change the picture most first, and the number of each kind of
    /// content that was ignored.
    pub fn into_notes(self) -> (Vec<Diagnostic>, BTreeMap<String, usize>) {
        let Notes { warnings, ignored } = self.notes.into_inner();
        let mut all = Warnings::default();
        warnings.into_iter().for_each(|some| all.append(some));
        (all.into_vec(self.path), ignored)
    }
}

/// The first child of `node` called `tag`, in any name space.
pub(super) fn child<'a>(node: Node<'a>, tag: &str) -> Option<Node<'a>> {
    children(node, tag).next()
}

/// The children of `node` called `tag`.
pub(super) fn children<'a, 't>(
    node: Node<'a>,
    tag: &'t str,
) -> impl Iterator<Item = Node<'a>> + use<'a, 't> {
    node.children()
        .filter(move |child| child.is_element() && child.tag_name().name() == tag)
}

/// How messages call an element.
pub(super) fn label(node: Node) -> String {
    let tag = node.tag_name().name();
    match node.attribute("id").or_else(|| node.attribute("name")) {
        Some(id) => format!("<{tag}> {}", quoted(id)),
        None => format!("<{tag}>"),
    }
}

/// Positions and triangles of one file, counted as often as they are instanced.
pub(super) const MOST_ELEMENTS: usize = 8_000_000;
/// Nodes of the scene, counted as often as they are instanced.
pub(super) const MOST_NODES: usize = 100_000;
/// Meshes in nodes of the scene, counted alike.
pub(super) const MOST_INSTANCES: usize = 100_000;
/// Elements and texts in nodes of the scene, counted alike: as many as a whole file may have.
pub(super) const MOST_CHILDREN: usize = MOST_XML_NODES as usize;
/// Joints and weights of skins, and elements that bind materials, counted alike.
pub(super) const MOST_BOUND: usize = 32_000_000;
/// Elements and texts of a file: enough for two million triangles written as `<polygons>`; memory
/// for others.
pub(super) const MOST_XML_NODES: u32 = 4_000_000;
/// Nodes inside one another.
pub(super) const MOST_DEPTH: usize = 1_000;
/// A coordinate beyond this is a fault: its square must stay finite.
pub(super) const FARTHEST: f64 = 1e15;

/// The XML reader compares each attribute of an element with all others.
const MOST_ATTRIBUTES: usize = 256;
/// It copies the name spaces in force to every element that declares one.
const MOST_NAME_SPACES: usize = 2_000;

/// Refuses text on which the XML reader's time or memory would grow with the square of its
/// length.
fn check_limits(path: &Path, text: &str) -> Result<(), Diagnostic> {
    let mut name_spaces = 0;
    let mut rest = text;
    while let Some(start) = rest.find('<') {
        rest = &rest[start..];
        let after = match markup_without_attributes(rest) {
            Some(end) => rest.find(end).map(|at| at + end.len()),
            None => {
                let (attributes, length) = count_attributes(rest);
                if attributes > MOST_ATTRIBUTES {
                    let before = &text[..text.len() - rest.len()];
                    let line = before.matches('\n').count() + 1;
                    let message = format!(
                        "expected at most {MOST_ATTRIBUTES} attributes in an element, found more"
                    );
                    return Err(Diagnostic::at(path, line, 1, message));
                }
                if attributes > 0 {
                    name_spaces += rest[..length].matches("xmlns").count();
                }
                Some(length)
            }
        };
        // What has no end is told by the XML reader.
        let Some(after) = after else { break };
        rest = &rest[after..];
    }
    if name_spaces > MOST_NAME_SPACES {
        let message = format!("expected at most {MOST_NAME_SPACES} name spaces, found more");
        return Err(Diagnostic::new(path, message));
    }
    Ok(())
}

/// The end mark of the comment, CDATA section or instruction at the start of `rest`; `None` for a
/// tag. A document type is none of these: the reader refuses it.
fn markup_without_attributes(rest: &str) -> Option<&'static str> {
    let kinds = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
    let found = kinds.iter().find(|(start, _)| rest.starts_with(start));
    found.map(|(_, end)| *end)
}

/// The attributes of the tag at the start of `rest`, and its length in bytes. What stands in
/// quotes is a value, `>` included.
fn count_attributes(rest: &str) -> (usize, usize) {
    let mut attributes = 0;
    let mut quote = None;
    for (at, &byte) in rest.as_bytes().iter().enumerate() {
        match (quote, byte) {
            (Some(open), _) if open == byte => quote = None,
            (Some(_), _) => {}
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'=') => attributes += 1,
            (None, b'>') => return (attributes, at + 1),
            (None, _) => {}
        }
    }
    (attributes, rest.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_lines_and_characters_from_1() {
        let text = "<COLLADA><a/>\n<b>é</b> <c/></COLLADA>";
        let path = Path::new("a.dae");
        let xml = parse_xml(path, text).unwrap();
        let dae = Dae::new(path, text, &xml).unwrap();
        for (tag, told) in [
            ("a", "a.dae:1:10: x"),
            ("b", "a.dae:2:1: x"),
            ("c", "a.dae:2:10: x"),
        ] {
            let node = child(dae.root, tag).unwrap();
            assert_eq!(dae.error(node, "x").to_string(), told);
        }
    }
}
