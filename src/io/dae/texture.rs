//! Pictures that textures name, wherever exporters think these are.

use super::document::{Dae, Node, child};
use super::numbers::text;
use super::quoted;
use crate::geometry::Picture;
use crate::io::pictures::Pictures;
use crate::io::{Diagnostic, Files};
use roxmltree::NodeId;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The pictures of a document, each read once.
pub(super) struct Textures<'a> {
    pictures: Pictures<'a>,
    read: HashMap<NodeId, Option<Arc<Picture>>>,
}

impl<'a> Textures<'a> {
    /// None yet; they will come from `files`.
    pub fn new(files: &'a dyn Files) -> Self {
        Self {
            pictures: Pictures::new(files),
            read: HashMap::new(),
        }
    }

    /// The picture of an `<image>`; `None`, with a warning, if it is missing or cannot be read.
    pub fn picture(&mut self, dae: &Dae<'a>, element: Node<'a>) -> Option<Arc<Picture>> {
        if let Some(known) = self.read.get(&element.id()) {
            return known.clone();
        }
        let picture = dae.or_warn(self.read(dae, element));
        self.read.insert(element.id(), picture.clone());
        picture
    }

    fn read(&mut self, dae: &Dae<'a>, element: Node<'a>) -> Result<Arc<Picture>, Diagnostic> {
        let init = dae.child(element, "init_from")?;
        let url = text(child(init, "ref").unwrap_or(init));
        let folder = dae.path.parent().unwrap_or(Path::new(""));
        let path = candidates(url)
            .into_iter()
            .map(|candidate| folder.join(candidate))
            .find(|path| self.pictures.exists(path));
        let Some(path) = path else {
            let found = quoted(url);
            return Err(dae.error(init, format!("expected a picture, found no file {found}")));
        };
        self.pictures.get(&path)
    }
}

/// Where `url` may mean, best first: as a URL, as a plain path, and, for a path of the author's
/// own machine, the file's name alone.
fn candidates(url: &str) -> Vec<PathBuf> {
    let plain = url.strip_prefix("file://").unwrap_or(url);
    let mut candidates = Vec::new();
    for path in [percent_decoded(plain), plain.to_owned()] {
        let slashes = path.replace('\\', "/");
        let name = slashes.rsplit('/').next().unwrap_or_default().to_owned();
        // `file:///C:/a.png`.
        let drive = slashes
            .strip_prefix('/')
            .filter(|rest| rest.as_bytes().get(1) == Some(&b':'));
        let drive = drive.map(str::to_owned);
        candidates.extend(
            [Some(slashes), drive, Some(path), Some(name)]
                .into_iter()
                .flatten(),
        );
    }
    candidates.retain(|candidate| !candidate.is_empty());
    candidates.into_iter().map(PathBuf::from).collect()
}

/// `%20` and the like as the bytes that they mean; what makes no text stays as it was.
fn percent_decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digit = |at: usize| char::from(*after.get(at)?).to_digit(16);
        match (first, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                rest = &after[2..];
            }
            _ => {
                bytes.push(first);
                rest = after;
            }
        }
    }
    String::from_utf8(bytes).unwrap_or_else(|_| text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_signs_are_decoded_and_broken_ones_kept() {
        assert_eq!(percent_decoded("a%20b%C3%A9.png"), "a bé.png");
        assert_eq!(percent_decoded("100%.png"), "100%.png");
        assert_eq!(percent_decoded("%zz%4"), "%zz%4");
        assert_eq!(percent_decoded("%FF"), "%FF");
    }

    #[test]
    fn a_path_of_the_authors_machine_also_means_the_file_beside_this_one() {
        let windows = candidates("file:///C:/My%20Art/skin.png");
        assert!(windows.contains(&PathBuf::from("C:/My Art/skin.png")));
        assert!(windows.contains(&PathBuf::from("skin.png")));
        assert!(candidates(r"textures\skin.png").contains(&PathBuf::from("textures/skin.png")));
    }
}
