//! The pictures that other files name.

use super::scanner::quoted;
use super::{Diagnostic, Files, image};
use crate::geometry::Picture;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Bytes of all pictures of a file together, when decoded.
const MOST_BYTES: usize = 1 << 29;

/// The pictures that a file names, each read once and shared by all that show it.
pub(super) struct Pictures<'a> {
    files: &'a dyn Files,
    read: HashMap<PathBuf, Result<Arc<Picture>, Diagnostic>>,
    /// Bytes that may still be read.
    left: usize,
}

impl<'a> Pictures<'a> {
    /// None yet; they will come from `files`.
    pub fn new(files: &'a dyn Files) -> Self {
        Self {
            files,
            read: HashMap::new(),
            left: MOST_BYTES,
        }
    }

    /// Whether there is a file at `path`.
    pub fn exists(&self, path: &Path) -> bool {
        self.files.exists(path)
    }

    /// The picture at `path`.
    ///
    /// # Errors
    /// If it cannot be read, or all pictures together would have too many bytes. Asking again
    /// gives the same error.
    pub fn get(&mut self, path: &Path) -> Result<Arc<Picture>, Diagnostic> {
        if let Some(known) = self.read.get(path) {
            return known.clone();
        }
        let read = self.read(path);
        self.read.insert(path.to_owned(), read.clone());
        read
    }

    fn read(&mut self, path: &Path) -> Result<Arc<Picture>, Diagnostic> {
        let bytes = self.files.read(path)?;
        // Asked before it is decoded, which takes time and that much memory.
        let size = image::decoded_size(path, &bytes)?;
        let Some(left) = self.left.checked_sub(size) else {
            let message = format!(
                "expected at most {MOST_BYTES} bytes of pictures, found more: this one is left out"
            );
            return Err(Diagnostic::new(path, message));
        };
        let picture = image::decode_what_is_there(path, &bytes)?;
        self.left = left;
        Ok(Arc::new(picture))
    }
}

/// The names of pictures that are not there, so that a file has one warning about all of them.
#[derive(Debug, Default)]
pub(super) struct MissingPictures {
    first: Option<String>,
    names: HashSet<String>,
}

impl MissingPictures {
    /// Adds the picture that the file calls `name`.
    pub fn add(&mut self, name: &str) {
        self.names.insert(name.to_owned());
        self.first.get_or_insert_with(|| name.to_owned());
    }

    /// The warning, which names the first; `None` if no picture is missing.
    pub fn warning(&self) -> Option<String> {
        let first = quoted(self.first.as_deref()?);
        Some(match self.names.len() {
            1 => format!("expected a picture, found no file {first}"),
            2 => format!("expected 2 pictures, found no files for {first} and 1 other"),
            count => {
                let others = count - 1;
                format!("expected {count} pictures, found no files for {first} and {others} others")
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::image::PictureFormat;

    #[test]
    fn pictures_are_shared_and_what_exceeds_the_limit_is_left_out() {
        let png = |width: u32| {
            let picture = Picture {
                width,
                height: 1,
                rgba: vec![7; width as usize * 4],
            };
            image::encode(&picture, PictureFormat::Png).unwrap()
        };
        let paths = ["a.png", "b.png", "c.png"].map(PathBuf::from);
        let widths = [20, 5, 4];
        let files = HashMap::from_iter(paths.iter().cloned().zip(widths.map(png)));
        let mut pictures = Pictures {
            left: 97,
            ..Pictures::new(&files)
        };
        let [a, b, c] = &paths;
        let first = pictures.get(a).unwrap();
        assert!(Arc::ptr_eq(&first, &pictures.get(a).unwrap()));
        let error = pictures.get(b).unwrap_err().to_string();
        let expected = "b.png: expected at most 536870912 bytes of pictures, found more";
        assert!(error.starts_with(expected), "{error}");
        // Smaller ones still have room.
        assert_eq!(pictures.get(c).unwrap().width, 4);
        assert_eq!(pictures.left, 1);
    }
}
