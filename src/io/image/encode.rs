//! Pictures written as files.

use crate::geometry::Picture;
use crate::io::palette::in_few_colors;
use crate::io::{Diagnostic, file_access};
use ::image::codecs::gif::GifEncoder;
use ::image::codecs::jpeg::JpegEncoder;
use ::image::codecs::png::PngEncoder;
use ::image::{ExtendedColorType, ImageEncoder};
use std::path::Path;

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
        PictureFormat::Gif => {
            let rgba = in_few_colors(&picture.rgba, width, height)
                .ok_or_else(|| format!("expected 4 bytes for each of {width}×{height} pixels"))?;
            let rgba8 = ExtendedColorType::Rgba8;
            GifEncoder::new(&mut bytes).encode(&rgba, width, height, rgba8)
        }
    }
    .map_err(|error| format!("the picture cannot be written: {error}"))?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let black = |width, bytes| Picture {
            width,
            height: 1,
            rgba: vec![0; bytes],
        };
        assert!(encode(&black(1, 8), PictureFormat::Png).is_err());
        let wide = black(70_000, 280_000);
        assert!(encode(&wide, PictureFormat::Gif).is_err());
        assert!(encode(&wide, PictureFormat::Jpeg).is_err());
    }
}
