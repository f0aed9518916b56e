//! Comparing the view with a picture: the panel below the view, and both pictures in the view.
//!
//! The measuring is done elsewhere; [`CompareView`] brings its results.

mod captions;
mod fitting;
mod mask_list;
mod mask_overlay;
mod panel;
mod pictures;
mod report;
mod settings;

pub(super) use panel::show as panel;
pub(super) use pictures::show as pictures;
pub use settings::{CompareAction, CompareMode, CompareSettings, course_panels};

use crate::geometry::Picture;
use egui::{ColorImage, Context, TextureFilter, TextureHandle, TextureId, TextureOptions};

/// A comparison as the panels show it. A is the reference, B the live view.
#[derive(Clone, Copy, Debug)]
pub struct CompareView<'a> {
    /// The reference's file.
    pub name: &'a str,
    /// What is chosen now.
    pub settings: &'a CompareSettings,
    /// A.
    pub reference: ShownPicture<'a>,
    /// B, of the same size, once it has been drawn.
    pub live: Option<ShownPicture<'a>>,
    /// The picture of their differences, once it has been made.
    pub difference: Option<TextureId>,
    /// What was measured.
    pub report: &'a CompareReport,
}

impl CompareView<'_> {
    /// Width and height of the pictures in pixels.
    fn size(&self) -> (u32, u32) {
        (self.reference.picture.width, self.reference.picture.height)
    }
}

/// A picture with the texture that shows it.
#[derive(Clone, Copy, Debug)]
pub struct ShownPicture<'a> {
    /// Its pixels.
    pub picture: &'a Picture,
    /// See [`picture_texture`].
    pub texture: TextureId,
}

/// What was measured, as far as it has been.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CompareReport {
    /// Pixel by pixel.
    pub counts: Option<CompareCounts>,
    /// How alike they look, and why they differ; it takes longer than the counts.
    pub judgment: Option<CompareJudgment>,
    /// Whether something newer is being measured than what is here.
    pub measuring: bool,
    /// Why nothing can be measured.
    pub problem: Option<String>,
}

/// Differences pixel by pixel, in the 0..=255 steps of the channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompareCounts {
    /// All pixels that are not masked.
    pub compared: u64,
    /// Of these, those that differ by more than the threshold.
    pub differing: u64,
    /// Compared pixels that are not background, in either picture.
    pub drawn: u64,
    /// Of these, those that differ by more than the threshold.
    pub drawn_differing: u64,
    /// Largest difference of a channel.
    pub max: u8,
    /// Mean difference of the color channels.
    pub mean: f64,
    /// Peak signal to noise ratio in dB, infinite if equal.
    pub psnr: f64,
}

/// What takes a while to find out.
#[derive(Clone, Debug, PartialEq)]
pub struct CompareJudgment {
    /// Structural similarity, 1 if equal; `None` for pictures too small.
    pub ssim: Option<f64>,
    /// Mean perceived difference, 0 if equal, at most 1.
    pub flip: f64,
    /// What is wrong, a sentence each.
    pub findings: Vec<String>,
}

/// Makes a texture that shows `picture`: smooth where smaller, and pixel by pixel where larger.
/// A malformed picture is shown as nothing. Its sides must be within egui's `max_texture_side`.
pub fn picture_texture(ctx: &Context, name: &str, picture: &Picture) -> TextureHandle {
    let size = [picture.width as usize, picture.height as usize];
    let image = if picture.rgba.len() == 4 * size[0] * size[1] {
        ColorImage::from_rgba_unmultiplied(size, &picture.rgba)
    } else {
        ColorImage::default()
    };
    let options = TextureOptions {
        magnification: TextureFilter::Nearest,
        minification: TextureFilter::Linear,
        ..TextureOptions::default()
    };
    ctx.load_texture(name, image, options)
}
