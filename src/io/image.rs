//! Pictures as files: PNG, JPEG and GIF; and the pictures that other files name.

use super::{Diagnostic, Files, file_access};
use crate::geometry::Picture;
use ::image::codecs::gif::GifEncoder;
use ::image::codecs::jpeg::JpegEncoder;
use ::image::codecs::png::PngEncoder;
use ::image::{ExtendedColorType, ImageEncoder, ImageError, ImageFormat, ImageReader};
use std::collections::HashMap;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The kinds of picture that this program writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFormat {
    /// `.png`, exact.
    Png,
    /// `.jpg` or `.jpeg`, without transparency.
    Jpeg,
    /// `.gif`, at most 256 colors.
    Gif,
}

/// Of 100; here differences from the original are hardly visible.
const JPEG_QUALITY: u8 = 95;
/// From 1, slow, to 30; below 10 the search for colors takes seconds and gains nothing seen.
const GIF_SPEED: i32 = 10;

impl PictureFormat {
    /// The format that the extension of `path` asks for.
    ///
    /// # Errors
    /// If it is none of those that can be written; the message names them.
    pub fn of(path: &Path) -> Result<Self, Diagnostic> {
        let extension = file_access::extension(path);
        match extension.as_str() {
            "png" => Ok(Self::Png),
            "jpg" | "jpeg" => Ok(Self::Jpeg),
            "gif" => Ok(Self::Gif),
            _ => Err(Diagnostic::new(
                path,
                format!(
                    "expected a picture's name that ends in .png, .jpg or .gif, found {}",
                    file_access::shown_extension(&extension)
                ),
            )),
        }
    }
}

/// `picture` as the content of a file.
///
/// # Errors
/// If the format cannot hold it, as with a JPEG or GIF of more than 65,535 pixels a side.
pub fn encode(picture: &Picture, format: PictureFormat) -> Result<Vec<u8>, String> {
    let (width, height) = (picture.width, picture.height);
    if picture.rgba.len() as u64 != 4 * u64::from(width) * u64::from(height) {
        return Err(format!(
            "expected 4 bytes for each of {width}×{height} pixels, found {}",
            picture.rgba.len()
        ));
    }
    let mut bytes = Vec::new();
    match format {
        PictureFormat::Png => PngEncoder::new(&mut bytes).write_image(
            &picture.rgba,
            width,
            height,
            ExtendedColorType::Rgba8,
        ),
        PictureFormat::Jpeg => {
            let pixels = picture.rgba.chunks_exact(4);
            let rgb: Vec<u8> = pixels
                .flat_map(|rgba| [rgba[0], rgba[1], rgba[2]])
                .collect();
            JpegEncoder::new_with_quality(&mut bytes, JPEG_QUALITY).write_image(
                &rgb,
                width,
                height,
                ExtendedColorType::Rgb8,
            )
        }
        PictureFormat::Gif => GifEncoder::new_with_speed(&mut bytes, GIF_SPEED).encode(
            &picture.rgba,
            width,
            height,
            ExtendedColorType::Rgba8,
        ),
    }
    .map_err(|error| format!("the picture cannot be written: {error}"))?;
    Ok(bytes)
}

/// Reads a PNG, JPEG or GIF by its content, not its name; of several frames the first.
///
/// # Errors
/// If it is none of these, is damaged, or would take an unreasonable amount of memory.
pub fn decode(path: &Path, bytes: &[u8]) -> Result<Picture, Diagnostic> {
    let (name, reader) = open(path, bytes)?;
    let rgba = reader
        .decode()
        .map_err(|error| damaged(path, name, &error))?
        .into_rgba8();
    Ok(Picture {
        width: rgba.width(),
        height: rgba.height(),
        rgba: rgba.into_raw(),
    })
}

/// How many bytes the [`Picture`] of [`decode`] would have, by its head.
///
/// # Errors
/// If it is no picture, or its head is damaged.
fn decoded_size(path: &Path, bytes: &[u8]) -> Result<usize, Diagnostic> {
    let (name, reader) = open(path, bytes)?;
    let size = reader.into_dimensions();
    let (width, height) = size.map_err(|error| damaged(path, name, &error))?;
    let pixels = u64::from(width) * u64::from(height);
    Ok(usize::try_from(pixels.saturating_mul(4)).unwrap_or(usize::MAX))
}

/// The name of a picture's format, and the reader of the picture.
type Opened<'a> = (&'static str, ImageReader<Cursor<&'a [u8]>>);

fn open<'a>(path: &Path, bytes: &'a [u8]) -> Result<Opened<'a>, Diagnostic> {
    let (name, format) = match ::image::guess_format(bytes) {
        Ok(format @ ImageFormat::Png) => ("PNG", format),
        Ok(format @ ImageFormat::Jpeg) => ("JPEG", format),
        Ok(format @ ImageFormat::Gif) => ("GIF", format),
        _ => {
            let found = if bytes.is_empty() {
                "an empty file"
            } else {
                "a file of another kind"
            };
            let message = format!("expected a PNG, JPEG or GIF picture, found {found}");
            return Err(Diagnostic::new(path, message));
        }
    };
    Ok((name, ImageReader::with_format(Cursor::new(bytes), format)))
}

fn damaged(path: &Path, name: &str, error: &ImageError) -> Diagnostic {
    let message = match error {
        ImageError::Limits(_) => {
            "expected a smaller picture, found one too large for the memory".to_owned()
        }
        error => format!(
            "expected a whole {name} picture, found one that is damaged or cut short ({error})"
        ),
    };
    Diagnostic::new(path, message)
}

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
        let size = decoded_size(path, &bytes)?;
        let Some(left) = self.left.checked_sub(size) else {
            let message = format!(
                "expected at most {MOST_BYTES} bytes of pictures, found more: this one is left out"
            );
            return Err(Diagnostic::new(path, message));
        };
        let picture = decode(path, &bytes)?;
        self.left = left;
        Ok(Arc::new(picture))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gradient() -> Picture {
        let (width, height) = (16, 8);
        let pixel = |i: u32| [(i % width * 16) as u8, (i / width * 32) as u8, 128, 255];
        Picture {
            width,
            height,
            rgba: (0..width * height).flat_map(pixel).collect(),
        }
    }

    #[test]
    fn a_png_comes_back_exactly() {
        let bytes = encode(&gradient(), PictureFormat::Png).unwrap();
        assert_eq!(decode(Path::new("a.png"), &bytes), Ok(gradient()));
    }

    #[test]
    fn what_is_no_picture_or_only_a_part_of_one_is_told() {
        let told = |bytes: &[u8]| decode(Path::new("a"), bytes).unwrap_err().to_string();
        let no_picture = "a: expected a PNG, JPEG or GIF picture, found";
        assert_eq!(told(b""), format!("{no_picture} an empty file"));
        assert_eq!(
            told(b"v 0 0 0\n"),
            format!("{no_picture} a file of another kind")
        );
        for (name, format) in [
            ("PNG", PictureFormat::Png),
            ("JPEG", PictureFormat::Jpeg),
            ("GIF", PictureFormat::Gif),
        ] {
            let bytes = encode(&gradient(), format).unwrap();
            let start = format!(
                "a: expected a whole {name} picture, found one that is damaged or cut short ("
            );
            let told = told(&bytes[..bytes.len() / 3]);
            assert!(told.starts_with(&start), "{told}");
        }
    }

    #[test]
    fn a_jpeg_and_a_gif_come_back_nearly() {
        for (format, tolerance) in [(PictureFormat::Jpeg, 12), (PictureFormat::Gif, 12)] {
            let bytes = encode(&gradient(), format).unwrap();
            let back = decode(Path::new("a"), &bytes).unwrap();
            assert_eq!((back.width, back.height), (16, 8));
            let pairs = back.rgba.iter().zip(gradient().rgba);
            let worst = pairs.map(|(&a, b)| a.abs_diff(b)).max();
            assert!(worst <= Some(tolerance), "{format:?} {worst:?}");
        }
    }

    #[test]
    fn the_extension_chooses_the_format_and_a_wrong_one_names_the_three() {
        assert_eq!(
            PictureFormat::of(Path::new("a.PNG")),
            Ok(PictureFormat::Png)
        );
        assert_eq!(
            PictureFormat::of(Path::new("a.jpeg")),
            Ok(PictureFormat::Jpeg)
        );
        let error = PictureFormat::of(Path::new("a.bmp")).unwrap_err();
        assert_eq!(
            error.to_string(),
            "a.bmp: expected a picture's name that ends in .png, .jpg or .gif, found .bmp"
        );
    }

    #[test]
    fn what_does_not_fit_is_an_error() {
        let wrong = Picture {
            width: 1,
            ..gradient()
        };
        assert!(encode(&wrong, PictureFormat::Png).is_err());
        let wide = Picture {
            width: 70_000,
            height: 1,
            rgba: vec![0; 280_000],
        };
        assert!(encode(&wide, PictureFormat::Gif).is_err());
        assert!(encode(&wide, PictureFormat::Jpeg).is_err());
        assert!(decode(Path::new("a.png"), b"no picture").is_err());
    }

    #[test]
    fn pictures_are_shared_and_what_exceeds_the_limit_is_left_out() {
        let png = |width: u32| {
            let picture = Picture {
                width,
                height: 1,
                rgba: vec![7; width as usize * 4],
            };
            encode(&picture, PictureFormat::Png).unwrap()
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
