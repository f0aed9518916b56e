//! Turntables: pictures from all around, as an animated GIF or as numbered files.

use super::CliError;
use crate::scene::TURNTABLE_FRAMES;
use std::path::{Path, PathBuf};

/// Number of frames, such as `36`.
pub(super) fn frames(text: &str) -> Result<u32, String> {
    let number = text.parse().ok();
    let number = number.filter(|number| TURNTABLE_FRAMES.contains(number));
    let (least, most) = TURNTABLE_FRAMES.into_inner();
    number.ok_or_else(|| {
        format!("expected a whole number of frames from {least} to {most}, found {text}")
    })
}

/// Names of numbered pictures, such as `OUT-%03d.png`: number 7 is `OUT-007.png`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Numbered {
    folder: PathBuf,
    before: String,
    digits: usize,
    after: String,
}

impl Numbered {
    /// The names that `path` stands for; `None` without `%d`, or `%03d` and the like, in its name.
    pub fn new(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let (before, rest) = name.split_once('%')?;
        let (digits, after) = rest.split_once('d')?;
        let digits = match digits.strip_prefix('0') {
            None if digits.is_empty() => 1,
            Some(digits) => digits
                .parse()
                .ok()
                .filter(|digits| (1..=9).contains(digits))?,
            None => return None,
        };
        Some(Self {
            folder: path.parent().unwrap_or(Path::new("")).to_owned(),
            before: before.to_owned(),
            digits,
            after: after.to_owned(),
        })
    }

    /// Path of picture `number`.
    pub fn path(&self, number: usize) -> PathBuf {
        let (before, after, digits) = (&self.before, &self.after, self.digits);
        self.folder
            .join(format!("{before}{number:0digits$}{after}"))
    }
}

/// What a turntable is written as.
pub(super) enum Output {
    /// One file.
    Gif,
    /// One file a frame.
    Frames(Numbered),
}

impl Output {
    /// What `path` asks for; its extension is one of a picture.
    ///
    /// # Errors
    /// If it is neither: wrong usage.
    pub fn of(path: &Path) -> Result<Self, CliError> {
        if let Some(numbered) = Numbered::new(path) {
            return Ok(Self::Frames(numbered));
        }
        if crate::io::expect_extension(path, "gif").is_ok() {
            return Ok(Self::Gif);
        }
        Err(CliError::Usage(format!(
            "{}: expected a name that ends in .gif with --turntable, or has a place for numbers, \
             such as OUT-%03d.png",
            path.display()
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_the_place_that_the_name_has_for_them() {
        let path = |name: &str, number| Some(Numbered::new(Path::new(name))?.path(number));
        assert_eq!(path("a/b-%03d.png", 7), Some("a/b-007.png".into()));
        assert_eq!(path("%d.png", 12), Some("12.png".into()));
        assert_eq!(path("%02d.png", 123), Some("123.png".into()));
        for none in [
            "a.png", "%x.png", "%3d.png", "%00d.png", "%0d.png", "100%.png",
        ] {
            assert_eq!(Numbered::new(Path::new(none)), None, "{none}");
        }
    }
}
