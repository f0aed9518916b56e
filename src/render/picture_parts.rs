//! Pictures of any size, drawn part by part.

use super::tile::{MARGIN, Tile};
use super::{Background, Frame, RenderError, Renderer};
use crate::geometry::Picture;
use crate::gpu::{Framebuffer, Gl, GpuError, Info};

/// Most pixels of a picture: as many as one of 16384×16384 has, which take 1 GiB.
const MOST_PIXELS: u64 = 1 << 28;

/// Checks that a picture of this width and height in pixels is not larger than can be drawn.
///
/// # Errors
/// If it is, in words.
pub fn check_picture_size((width, height): (u32, u32)) -> Result<(), String> {
    if u64::from(width) * u64::from(height) <= MOST_PIXELS {
        return Ok(());
    }
    Err(format!(
        "expected a picture of at most {MOST_PIXELS} pixels, as of 16384x16384, found {width}x{height}"
    ))
}

/// A picture to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct LargePicture {
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Samples a pixel; 0 for none.
    pub samples: u32,
    /// What is behind the shapes.
    pub background: Background,
    /// Pixels a side of the tiles that it is drawn in; `None` for one piece where that is possible.
    pub tile: Option<u32>,
}

/// A picture that is drawn part by part, so that something else can be done in between. It is beyond
/// the driver's limits, or has so many samples that they would fill the memory, or small enough to
/// be a single part.
#[derive(Debug)]
pub struct PictureParts {
    asked: LargePicture,
    /// Parts of the picture; those of several have a margin when they are drawn.
    tiles: Vec<Tile>,
    /// Number of tiles that are in `rgba`.
    done: usize,
    /// Pixels of the picture, the top row first.
    rgba: Vec<u8>,
}

/// Most samples that are drawn at once: as many as the pixels of a picture of 8192×8192.
const MOST_SAMPLES_AT_ONCE: u64 = 1 << 26;
/// Pixels a side of a tile.
const TILE: u32 = 2048;

impl PictureParts {
    /// The parts of `asked`, none of them drawn yet, for the driver of `info`.
    pub fn new(asked: &LargePicture, info: &Info) -> Self {
        let most = info.max_framebuffer_size;
        let (width, height) = asked.size;
        let samples = u64::from(width) * u64::from(height) * u64::from(asked.samples.max(1));
        let at_once = width.max(height) <= most && samples <= MOST_SAMPLES_AT_ONCE;
        let tiles = if asked.tile.is_none() && at_once {
            vec![Tile::whole(asked.size)]
        } else {
            let side = asked.tile.unwrap_or(TILE);
            Tile::all(asked.size, side.min(most.saturating_sub(2 * MARGIN)))
        };
        Self {
            asked: *asked,
            tiles,
            done: 0,
            rgba: Vec::new(),
        }
    }

    /// Number of parts.
    pub fn count(&self) -> usize {
        self.tiles.len()
    }

    /// Number of parts that are drawn.
    pub fn done(&self) -> usize {
        self.done
    }

    /// Whether all parts are drawn.
    pub fn is_complete(&self) -> bool {
        self.done == self.tiles.len()
    }

    /// Draws the next part, if there is one left, of `frame`, the same for all of them.
    ///
    /// # Errors
    /// When there is no room for the part, or drawing fails.
    pub fn draw_next(
        &mut self,
        gl: &Gl,
        renderer: &mut Renderer,
        frame: &Frame,
    ) -> Result<(), RenderError> {
        let Some(&tile) = self.tiles.get(self.done) else {
            return Ok(());
        };
        let is_whole = tile == Tile::whole(self.asked.size);
        let drawn = if is_whole { tile } else { tile.with_margin() };
        let (width, height) = drawn.size;
        let target = Framebuffer::new(gl, width, height, self.asked.samples)?;
        renderer.draw_tile(frame, &target, drawn, self.asked.background)?;
        let pixels = target.read_rgba()?;
        if is_whole {
            self.rgba = pixels;
        } else {
            let (width, height) = self.asked.size;
            self.rgba.resize(4 * width as usize * height as usize, 0);
            copy_tile(&mut self.rgba, tile, &pixels);
        }
        self.done += 1;
        Ok(())
    }

    /// The picture; what is not drawn yet is transparent.
    pub fn into_picture(mut self) -> Picture {
        let (width, height) = self.asked.size;
        self.rgba.resize(4 * width as usize * height as usize, 0);
        if self.asked.background == Background::Transparent {
            divide_by_alpha(&mut self.rgba);
        }
        Picture {
            width,
            height,
            rgba: self.rgba,
        }
    }
}

/// Copies what of `tile` is in the picture from `drawn`, the tile with its margin. Both have the top
/// row first.
fn copy_tile(picture: &mut [u8], tile: Tile, drawn: &[u8]) {
    let margin = MARGIN as usize;
    let (whole_width, whole_height) = (tile.whole.0 as usize, tile.whole.1 as usize);
    let (width, height) = (tile.size.0 as usize, tile.size.1 as usize);
    let (left, bottom) = (tile.left as usize, tile.bottom as usize);
    let columns = width.min(whole_width - left);
    for up in 0..height.min(whole_height - bottom) {
        let from = (height + margin - 1 - up) * (width + 2 * margin) + margin;
        let to = (whole_height - 1 - bottom - up) * whole_width + left;
        let row = &drawn[4 * from..4 * (from + columns)];
        picture[4 * to..4 * (to + columns)].copy_from_slice(row);
    }
}

/// Makes colors that are multiplied by their alpha those that files have.
fn divide_by_alpha(rgba: &mut [u8]) {
    let (pixels, _) = rgba.as_chunks_mut();
    for [red, green, blue, alpha] in pixels {
        let alpha = u32::from(*alpha);
        for color in [red, green, blue] {
            let divided = (u32::from(*color) * 255 + alpha / 2).checked_div(alpha);
            *color = divided.unwrap_or(0).min(255) as u8;
        }
    }
}

/// Reads a framebuffer into a picture in memory.
///
/// # Errors
/// When a GL error occurred.
pub fn read_picture(target: &Framebuffer) -> Result<Picture, GpuError> {
    Ok(Picture {
        width: target.width(),
        height: target.height(),
        rgba: target.read_rgba()?,
    })
}
