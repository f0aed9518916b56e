//! Animated pictures.

use super::palette::in_few_colors;
use crate::geometry::Picture;
use ::image::codecs::gif::{GifEncoder, Repeat};
use ::image::{Delay, Frame, RgbaImage};
use std::cell::RefCell;
use std::io::Write;
use std::rc::Rc;

/// An animated GIF that starts anew when it ends, written picture by picture.
pub struct Animation {
    encoder: GifEncoder<Bytes>,
    bytes: Bytes,
    delay: Delay,
}

/// Bytes that are written by an encoder, which does not hand back what it writes to.
#[derive(Clone, Debug, Default)]
struct Bytes(Rc<RefCell<Vec<u8>>>);

impl Write for Bytes {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Animation {
    /// An animation without any picture yet, each to be shown for `milliseconds`, in steps of 10.
    ///
    /// # Errors
    /// If it cannot be begun.
    pub fn new(milliseconds: u32) -> Result<Self, String> {
        let bytes = Bytes::default();
        let mut encoder = GifEncoder::new(bytes.clone());
        encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        Ok(Self {
            encoder,
            bytes,
            delay: Delay::from_numer_denom_ms(milliseconds, 1),
        })
    }

    /// Adds a picture, as large as the others.
    ///
    /// # Errors
    /// If the format cannot hold it.
    pub fn add(&mut self, picture: Picture) -> Result<(), String> {
        let (width, height) = (picture.width, picture.height);
        let pixels = in_few_colors(&picture.rgba, width, height)
            .and_then(|pixels| RgbaImage::from_raw(width, height, pixels))
            .ok_or_else(|| format!("expected 4 bytes for each of {width}×{height} pixels"))?;
        let frame = Frame::from_parts(pixels, 0, 0, self.delay);
        self.encoder.encode_frame(frame).map_err(failed)
    }

    /// The content of the file.
    pub fn finish(self) -> Vec<u8> {
        let Self { encoder, bytes, .. } = self;
        // The end of the file is written when the encoder goes.
        drop(encoder);
        bytes.0.take()
    }
}

fn failed(error: ::image::ImageError) -> String {
    format!("the animation cannot be written: {error}")
}
