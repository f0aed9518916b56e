//! Pictures read from files.

use crate::geometry::Picture;
use crate::io::Diagnostic;
use ::image::error::LimitErrorKind;
use ::image::{ColorType, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};
use std::fmt;
use std::io::Cursor;
use std::path::Path;

/// The most pixels that a picture may have that is read: as many as one of 8192×8192.
const MOST_PIXELS: u64 = 1 << 26;
/// The most pixels that it may have a side.
const MOST_A_SIDE: u32 = 65_535;
/// The most memory that a decoder may take beside the picture, in bytes.
const MOST_ALLOC: u64 = 1 << 28;
/// Bytes a pixel that the decoder of JPEG takes beside the picture, if the picture is stored in
/// several passes: a coefficient of two bytes for each of three colors.
const JPEG_COEFFICIENTS: usize = 6;

/// Bytes that the picture in `bytes` takes when it is decoded, told by its first bytes alone.
///
/// # Errors
/// As [`decode`], as far as can be told.
pub(in crate::io) fn decoded_size(path: &Path, bytes: &[u8]) -> Result<usize, Diagnostic> {
    Ok(4 * open(path, bytes)?.pixels)
}

/// Reads a PNG, JPEG or GIF by its content, not its name; of several frames the first. It takes as
/// much memory as the [`Picture`], or as its pixels as they are stored if these are more.
///
/// # Errors
/// If it is none of these, is damaged or cut off, has too many pixels, or there is not enough memory for it.
pub fn decode(path: &Path, bytes: &[u8]) -> Result<Picture, Diagnostic> {
    let picture = decode_what_is_there(path, bytes)?;
    match format_of(bytes) == Some("JPEG") && !has_end_of_jpeg(bytes) {
        true => Err(Diagnostic::new(path, no_whole("JPEG", "it has no end"))),
        false => Ok(picture),
    }
}

/// Whether the marker of the end comes after the last scan of a JPEG; a picture within it may end before.
fn has_end_of_jpeg(bytes: &[u8]) -> bool {
    let last = |marker: [u8; 2]| bytes.windows(2).rposition(|pair| pair == marker);
    last([0xff, 0xd9]) > last([0xff, 0xda])
}

/// As [`decode`], but of a JPEG that is cut off what is there, as browsers show it: models may have such pictures.
///
/// # Errors
/// As [`decode`], but for that.
pub(in crate::io) fn decode_what_is_there(
    path: &Path,
    bytes: &[u8],
) -> Result<Picture, Diagnostic> {
    let Opened {
        format,
        decoder,
        pixels,
    } = open(path, bytes)?;
    let (width, height) = decoder.dimensions();
    let color = decoder.color_type();
    let stored = usize::from(color.bytes_per_pixel());
    let mut rgba = memory(path, pixels * stored.max(4))?;
    if format == "JPEG" {
        // The decoder ends the program if it gets no memory: better asked before.
        drop(memory(path, pixels * JPEG_COEFFICIENTS)?);
    }
    rgba.resize(pixels * stored.max(4), 0);
    let start = rgba.len() - pixels * stored;
    let read = decoder.read_image(&mut rgba[start..]);
    read.map_err(|error| damaged(path, format, &error))?;
    if !to_rgba(&mut rgba, pixels, color) {
        let message = format!("expected 8 or 16 bits a color, found {color:?}");
        return Err(Diagnostic::new(path, message));
    }
    rgba.truncate(4 * pixels);
    rgba.shrink_to_fit();
    Ok(Picture {
        width,
        height,
        rgba,
    })
}

/// Room for so many bytes.
fn memory(path: &Path, bytes: usize) -> Result<Vec<u8>, Diagnostic> {
    let mut room = Vec::new();
    match room.try_reserve_exact(bytes) {
        Ok(()) => Ok(room),
        Err(_) => Err(Diagnostic::new(path, NO_MEMORY)),
    }
}

/// Makes `pixels` pixels of the kind `color`, which lie at the end of `bytes`, into RGBA at its
/// start. A pixel is never written over one that is still to be read. False for colors that PNG,
/// JPEG and GIF do not have.
fn to_rgba(bytes: &mut [u8], pixels: usize, color: ColorType) -> bool {
    match color {
        ColorType::L8 => each_pixel(bytes, pixels, |[l]| [l, l, l, 255]),
        ColorType::La8 => each_pixel(bytes, pixels, |[l, a]| [l, l, l, a]),
        ColorType::Rgb8 => each_pixel(bytes, pixels, |[r, g, b]| [r, g, b, 255]),
        ColorType::Rgba8 => {}
        ColorType::L16 => each_pixel(bytes, pixels, |pixel: [u8; 2]| {
            let [l] = of_16_bits(pixel);
            [l, l, l, 255]
        }),
        ColorType::La16 => each_pixel(bytes, pixels, |pixel: [u8; 4]| {
            let [l, a] = of_16_bits(pixel);
            [l, l, l, a]
        }),
        ColorType::Rgb16 => each_pixel(bytes, pixels, |pixel: [u8; 6]| {
            let [r, g, b] = of_16_bits(pixel);
            [r, g, b, 255]
        }),
        ColorType::Rgba16 => each_pixel(bytes, pixels, |pixel: [u8; 8]| of_16_bits(pixel)),
        _ => return false,
    }
    true
}

fn each_pixel<const N: usize>(bytes: &mut [u8], pixels: usize, rgba: impl Fn([u8; N]) -> [u8; 4]) {
    let start = bytes.len() - pixels * N;
    for pixel in 0..pixels {
        let from = start + pixel * N;
        let stored = std::array::from_fn(|byte| bytes[from + byte]);
        bytes[4 * pixel..4 * pixel + 4].copy_from_slice(&rgba(stored));
    }
}

/// The nearest values of 8 bits to `N` of 16 bits, in the machine's order of bytes.
fn of_16_bits<const N: usize, const BYTES: usize>(pixel: [u8; BYTES]) -> [u8; N] {
    std::array::from_fn(|channel| {
        let value = u16::from_ne_bytes([pixel[2 * channel], pixel[2 * channel + 1]]);
        ((u32::from(value) + 128) / 257) as u8
    })
}

/// A picture of which only the head has been read.
struct Opened<D> {
    /// Name of its format.
    format: &'static str,
    decoder: D,
    /// How many it has, within the limits.
    pixels: usize,
}

/// Whether `bytes` begin as a picture that [`decode`] reads.
pub fn is_picture(bytes: &[u8]) -> bool {
    format_of(bytes).is_some()
}

/// Name of the format of the picture that `bytes` begin as, if [`decode`] reads it.
pub(in crate::io) fn format_of(bytes: &[u8]) -> Option<&'static str> {
    match ::image::guess_format(bytes) {
        Ok(ImageFormat::Png) => Some("PNG"),
        Ok(ImageFormat::Jpeg) => Some("JPEG"),
        Ok(ImageFormat::Gif) => Some("GIF"),
        _ => None,
    }
}

fn open<'a>(
    path: &Path,
    bytes: &'a [u8],
) -> Result<Opened<impl ImageDecoder + use<'a>>, Diagnostic> {
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
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_image_width = Some(MOST_A_SIDE);
    limits.max_image_height = Some(MOST_A_SIDE);
    limits.max_alloc = Some(MOST_ALLOC);
    reader.limits(limits);
    let decoder = reader.into_decoder();
    let decoder = decoder.map_err(|error| damaged(path, name, &error))?;
    let (width, height) = decoder.dimensions();
    let pixels = u64::from(width) * u64::from(height);
    if pixels > MOST_PIXELS {
        let message = format!(
            "expected a picture of at most {MOST_PIXELS} pixels, as of 8192×8192, found \
             {width}×{height}"
        );
        return Err(Diagnostic::new(path, message));
    }
    Ok(Opened {
        format: name,
        decoder,
        pixels: pixels as usize,
    })
}

const NO_MEMORY: &str = "expected a smaller picture, found one too large for the memory";

fn damaged(path: &Path, name: &str, error: &ImageError) -> Diagnostic {
    let message = match error {
        ImageError::Limits(limit) => match limit.kind() {
            LimitErrorKind::DimensionError => {
                format!("expected a picture of at most {MOST_A_SIDE} pixels a side, found more")
            }
            _ => NO_MEMORY.to_owned(),
        },
        error => no_whole(name, error),
    };
    Diagnostic::new(path, message)
}

fn no_whole(name: &str, why: impl fmt::Display) -> String {
    format!("expected a whole {name} picture, found one that is damaged or cut short ({why})")
}

#[cfg(test)]
mod tests {
    use super::super::{PictureFormat, encode};
    use super::*;
    use ::image::codecs::png::PngEncoder;
    use ::image::{ExtendedColorType, ImageEncoder};

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
        // The decoder takes what there is of a JPEG.
        let jpeg = encode(&gradient(), PictureFormat::Jpeg).unwrap();
        let cut = &jpeg[..jpeg.len() - 20];
        assert!(told(cut).ends_with("(it has no end)"), "{}", told(cut));
        let picture = decode_what_is_there(Path::new("a"), cut).unwrap();
        assert_eq!((picture.width, picture.height), (16, 8));
    }

    /// A PNG of these pixels.
    fn png_of(width: u32, height: u32, color: ExtendedColorType, bytes: &[u8]) -> Vec<u8> {
        let mut png = Vec::new();
        let encoder = PngEncoder::new(&mut png);
        encoder.write_image(bytes, width, height, color).unwrap();
        png
    }

    #[test]
    fn a_picture_of_any_kind_of_colors_comes_out_as_the_decoders_own_library_has_it() {
        use ExtendedColorType::{L8, L16, La8, La16, Rgb8, Rgb16, Rgba8, Rgba16};
        let values = (0..1_u64 << 19).map(|i| (i.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 56) as u8);
        let values: Vec<u8> = values.collect();
        for color in [L8, La8, Rgb8, Rgba8, L16, La16, Rgb16, Rgba16] {
            let a_row = 251 * usize::from(color.bits_per_pixel() / 8);
            let png = png_of(251, 257, color, &values[..257 * a_row]);
            let expected = ::image::load_from_memory(&png).unwrap().into_rgba8();
            let picture = decode(Path::new("a.png"), &png).unwrap();
            assert_eq!((picture.width, picture.height), (251, 257), "{color:?}");
            assert!(picture.rgba == expected.into_raw(), "{color:?}");
        }
    }

    #[test]
    fn a_picture_of_too_many_pixels_is_refused_by_its_head() {
        // The size of a GIF has no checksum.
        let gif = |width: u16, height: u16| {
            let mut gif = encode(&gradient(), PictureFormat::Gif).unwrap();
            gif[6..8].copy_from_slice(&width.to_le_bytes());
            gif[8..10].copy_from_slice(&height.to_le_bytes());
            gif
        };
        let told = |bytes: &[u8]| decode(Path::new("a"), bytes).unwrap_err().message;
        let most = "expected a picture of at most 67108864 pixels, as of 8192×8192, found";
        assert_eq!(told(&gif(10_000, 10_000)), format!("{most} 10000×10000"));
        assert_eq!(told(&gif(8193, 8192)), format!("{most} 8193×8192"));
        let wide = png_of(70_000, 1, ExtendedColorType::L8, &[0; 70_000]);
        let a_side = "expected a picture of at most 65535 pixels a side, found more";
        assert_eq!(told(&wide), a_side);
        assert_eq!(
            decode(Path::new("a"), &gif(8192, 1024)).unwrap().width,
            8192
        );
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
}
