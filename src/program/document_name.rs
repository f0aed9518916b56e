//! Names of documents and of their files.

use super::running::Program;
use crate::io::{self, Files};
use std::path::Path;

/// Name of a document that has no file yet.
const UNTITLED: &str = "Untitled";

impl Program {
    /// Name of the document: that of its file, else that of what was opened.
    pub(super) fn document_name(&self) -> String {
        let name = self.document.path.as_deref().and_then(Path::file_name);
        let name = name.map(|name| name.to_string_lossy().into_owned());
        let name = name.or_else(|| self.document.stem.clone());
        name.unwrap_or_else(|| UNTITLED.to_owned())
    }

    /// Name of the document without its extension, for files that are made from it.
    pub(super) fn document_stem(&self) -> String {
        let stem = self.document.path.as_deref().and_then(Path::file_stem);
        let stem = stem.map(|stem| stem.to_string_lossy().into_owned());
        let stem = stem.or_else(|| self.document.stem.clone());
        stem.unwrap_or_else(|| "scene".to_owned())
    }

    /// Title of the window: the document, with a mark if it is modified, and the program. A
    /// document that has no name and is not modified is not mentioned.
    pub(super) fn title(&self) -> String {
        let mark = if self.is_modified() { "*" } else { "" };
        let file = &self.document;
        let is_named = file.path.is_some() || file.stem.is_some();
        let is_nothing_to_tell = !is_named && mark.is_empty();
        // A picture of the panels has no title at all.
        if is_nothing_to_tell || self.program_title.is_empty() {
            return self.program_title.clone();
        }
        format!("{mark}{} — {}", self.document_name(), self.program_title)
    }
}

/// `name`, or with a number, or a higher one, if there is such a file in `folder` already.
pub(super) fn free_name(name: &str, folder: Option<&Path>, files: &dyn Files) -> String {
    let path = Path::new(name);
    let [stem, extension] =
        [path.file_stem(), path.extension()].map(|part| part.unwrap_or_default().to_string_lossy());
    let last = stem.rsplit_once(' ');
    let last = last.and_then(|(words, number)| Some((words, number.parse::<u16>().ok()?)));
    let (words, number) = last.unwrap_or((&stem, 1));
    let higher = (1..1000).map(|more| u32::from(number) + more);
    let numbered = higher.map(|number| format!("{words} {number}.{extension}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    let folder = folder.unwrap_or(Path::new(""));
    let free = names.find(|name| !files.exists(&folder.join(name)));
    free.unwrap_or_else(|| name.to_owned())
}

/// Whether the name of a file is that of a scene or of an archive that may have one.
pub(super) fn holds_document(path: &Path) -> bool {
    io::is_scene(path) || io::is_archive(path)
}
