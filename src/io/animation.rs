use crate::geometry::Picture;
use ::image::codecs::gif::{GifEncoder, Repeat};
use ::image::{Delay, Frame, RgbaImage};

/// From 1, slow, to 30, as for single pictures.
const SPEED: i32 = 10;

/// Pictures of one size as an animated GIF that starts anew when it ends, each shown for
/// `milliseconds`, in steps of 10.
///
/// # Errors
/// The first of a frame, or if the format cannot hold a picture.
pub fn animated_gif<E: From<String>>(
    pictures: impl Iterator<Item = Result<Picture, E>>,
    milliseconds: u32,
) -> Result<Vec<u8>, E> {
    let mut bytes = Vec::new();
    let mut encoder = GifEncoder::new_with_speed(&mut bytes, SPEED);
    let failed = |error| E::from(format!("the animation cannot be written: {error}"));
    encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
    for picture in pictures {
        let picture = picture?;
        let (width, height) = (picture.width, picture.height);
        let Some(pixels) = RgbaImage::from_raw(width, height, picture.rgba) else {
            let message = format!("expected 4 bytes for each of {width}×{height} pixels");
            return Err(E::from(message));
        };
        let delay = Delay::from_numer_denom_ms(milliseconds, 1);
        let frame = Frame::from_parts(pixels, 0, 0, delay);
        encoder.encode_frame(frame).map_err(failed)?;
    }
    drop(encoder);
    Ok(bytes)
}
