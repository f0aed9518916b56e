//! Pictures without a window.

use super::tile::{MARGIN, Tile};
use super::{Background, Frame, RenderError, Renderer};
use crate::geometry::Picture;
use crate::gpu::{Backend, ContextError, Framebuffer, Gl, GpuError, HeadlessContext};

/// Draws pictures without a window.
#[derive(Debug)]
pub struct Offscreen {
    renderer: Renderer,
    context: HeadlessContext,
}

/// Why no picture could be drawn.
#[derive(Debug, thiserror::Error)]
pub enum OffscreenError {
    /// There is no OpenGL to draw with.
    #[error(transparent)]
    Context(#[from] ContextError),
    /// OpenGL refused something.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl Offscreen {
    /// A context of `backend` with a renderer in it.
    ///
    /// # Errors
    /// When there is no such backend or it lacks OpenGL 3.3; the message names the remedy.
    pub fn new(backend: Backend) -> Result<Self, OffscreenError> {
        let context = HeadlessContext::new(backend)?;
        let renderer = Renderer::new(context.gl())?;
        Ok(Self { renderer, context })
    }

    /// The context that pictures are drawn with.
    pub fn gl(&self) -> &Gl {
        self.context.gl()
    }

    /// The renderer, for its settings and notices.
    pub fn renderer(&mut self) -> &mut Renderer {
        &mut self.renderer
    }

    /// The backend that was found.
    pub fn backend(&self) -> Backend {
        self.context.backend()
    }

    /// Draws `frame` in a picture of `width` by `height` pixels with `samples` samples a pixel,
    /// 0 for none.
    ///
    /// # Errors
    /// When the size or the number of samples is beyond the driver's limits, or drawing fails.
    pub fn render(
        &mut self,
        frame: &Frame,
        (width, height): (u32, u32),
        samples: u32,
    ) -> Result<Framebuffer, RenderError> {
        let target = Framebuffer::new(self.context.gl(), width, height, samples)?;
        self.renderer.draw(frame, &target)?;
        target.resolve();
        Ok(target)
    }

    /// As [`Offscreen::render`], read into memory.
    ///
    /// # Errors
    /// As [`Offscreen::render`].
    pub fn picture(
        &mut self,
        frame: &Frame,
        size: (u32, u32),
        samples: u32,
    ) -> Result<Picture, RenderError> {
        Ok(read_picture(&self.render(frame, size, samples)?)?)
    }

    /// As [`Offscreen::picture`], but of any size: one beyond the driver's limits, or of so many
    /// samples that they would fill the memory, is drawn in tiles. `drawn` hears of each tile: how
    /// many there are already, and of how many.
    ///
    /// # Errors
    /// As [`Offscreen::render`], but for the size.
    pub fn large_picture(
        &mut self,
        frame: &Frame,
        asked: &LargePicture,
        mut drawn: impl FnMut(usize, usize),
    ) -> Result<Picture, RenderError> {
        let most = self.gl().info().max_framebuffer_size;
        let (width, height) = asked.size;
        let samples = u64::from(width) * u64::from(height) * u64::from(asked.samples.max(1));
        let at_once = width.max(height) <= most && samples <= MOST_SAMPLES_AT_ONCE;
        if asked.tile.is_none() && at_once {
            return self.in_one_piece(frame, asked);
        }
        let most = asked
            .tile
            .unwrap_or(TILE)
            .min(most.saturating_sub(2 * MARGIN));
        let tiles = Tile::all(asked.size, most);
        let row = 4 * width as usize;
        let mut rgba = vec![0; row * height as usize];
        for (done, tile) in tiles.iter().enumerate() {
            drawn(done, tiles.len());
            copy_tile(
                &mut rgba,
                *tile,
                &self.tile(frame, asked, tile.with_margin())?,
            );
        }
        drawn(tiles.len(), tiles.len());
        Ok(finished(asked, rgba))
    }

    fn in_one_piece(
        &mut self,
        frame: &Frame,
        asked: &LargePicture,
    ) -> Result<Picture, RenderError> {
        let rgba = self.tile(frame, asked, Tile::whole(asked.size))?;
        Ok(finished(asked, rgba))
    }

    fn tile(
        &mut self,
        frame: &Frame,
        asked: &LargePicture,
        tile: Tile,
    ) -> Result<Vec<u8>, RenderError> {
        let (width, height) = tile.size;
        let target = Framebuffer::new(self.gl(), width, height, asked.samples)?;
        self.renderer
            .draw_tile(frame, &target, tile, asked.background)?;
        Ok(target.read_rgba()?)
    }
}

fn finished(asked: &LargePicture, mut rgba: Vec<u8>) -> Picture {
    if asked.background == Background::Transparent {
        divide_by_alpha(&mut rgba);
    }
    let (width, height) = asked.size;
    Picture {
        width,
        height,
        rgba,
    }
}

/// Most samples that are drawn at once: as many as the pixels of a picture of 8192×8192.
const MOST_SAMPLES_AT_ONCE: u64 = 1 << 26;
/// Pixels a side of a tile.
const TILE: u32 = 2048;

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
