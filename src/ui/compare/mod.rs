//! Comparing the view with a picture, or a character with a mesh: the panel below the view, and both
//! pictures or meshes in the view.
//!
//! The measuring is done elsewhere; [`CompareView`] brings its results.

mod absent;
mod across;
mod apart;
mod bones_seen;
mod candidates;
mod cells;
mod clusters;
mod elsewhere;
mod findings;
mod hints;
mod how;
mod limbs;
mod masks;
mod mesh_distances;
mod mesh_marker;
mod mesh_panel;
mod mesh_view;
mod names;
mod other_camera;
mod outlined;
mod owned;
mod page_figure;
mod panel;
mod part;
mod parts;
mod pictures;
mod pixel_map;
mod place;
mod seen_in_cells;
mod settings;
mod shapes_seen;
mod skeleton_shown;
mod surface;
mod turned;

pub(super) use apart::KeptPlaces;
pub(super) use mesh_marker::show as mesh_marker;
pub(super) use mesh_panel::{MeshPanelState, show as mesh_panel};
pub use mesh_view::{CompareMeshAction, CompareMeshView, MeshesShown};
pub(super) use outlined::Outlined;
pub(super) use panel::show as panel;
pub(super) use pictures::show as pictures;
pub use settings::{CompareAction, CompareMode, CompareSettings, course_panels, mannequin_panels};

use crate::compare::{Area, CompareError, Differences, FigureOff, Judgment};
use crate::geometry::Picture;
use crate::scene::Look;
use egui::{ColorImage, Context, TextureFilter, TextureHandle, TextureId, TextureOptions};

/// A comparison as the panels show it. A is the reference, B the live view.
#[derive(Clone, Copy, Debug)]
pub struct CompareView<'a> {
    /// The reference's file.
    pub name: &'a str,
    /// Look of the reference, as far as it can be told.
    pub look: Look,
    /// Whether the panels of the program that it is from were cut off it.
    pub is_cut: bool,
    /// Whether the user has chosen if the live view has smooth edges, and not the program by what agrees better.
    pub are_edges_chosen: bool,
    /// Whether the reference has smooth edges, if that is clear.
    pub is_reference_smooth: Option<bool>,
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
    /// Part of the work on newer similarity and causes that is done, from 0 to 1, while they are
    /// sought.
    pub judged_part: Option<f32>,
}

impl CompareView<'_> {
    /// Width and height of the pictures in pixels.
    pub(super) fn size(&self) -> (u32, u32) {
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

/// Results of a comparison, as far as they are known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CompareReport {
    /// Pixel by pixel.
    pub differences: Option<Differences>,
    /// Similarity and causes, which take longer.
    pub judgment: Option<Judgment>,
    /// Whether a newer comparison is under way than these results are from.
    pub measuring: bool,
    /// Why nothing can be measured.
    pub problem: Option<CompareError>,
    /// The figure in a screenshot of the Virtual Mannequin's page; `None` for other pictures, and before it is known.
    pub page_figure: Option<Box<PageFigure>>,
}

/// Where the figure in a screenshot of the Virtual Mannequin's page is not the one in the live view, whatever differs of
/// floor and bones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PageFigure {
    /// The area round the figure in either.
    pub area: Area,
    /// Whether the camera of the screenshot was rolled, so that no view from a level one matches it.
    pub is_slanted: bool,
    /// How the floors agree.
    pub floor: FloorSeen,
    /// What differs of it; `None` if the figures agree.
    pub off: Option<FigureOff>,
    /// Where all of it is in the live view, if it is elsewhere.
    pub elsewhere: Option<FigureElsewhere>,
}

/// What the floors in two pictures of the Virtual Mannequin's look tell of their cameras.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FloorSeen {
    /// What is behind the figures is the same in both, without any noise: so is the camera.
    Same,
    /// They agree but for the page's noise, and so do the cameras.
    InPlace,
    /// Too little of them is seen, or they differ by hardly more than noise.
    Unknown,
    /// They differ by more than noise near the eye, as where the camera is turned a little.
    Off,
    /// They differ by so much that it is another camera.
    Elsewhere,
}

impl FloorSeen {
    /// Whether the camera is the same.
    pub fn is_in_place(self) -> bool {
        match self {
            Self::Same | Self::InPlace => true,
            Self::Unknown | Self::Off | Self::Elsewhere => false,
        }
    }
}

/// Where a figure is that stands elsewhere in the live view.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureElsewhere {
    /// How it is placed there, in words.
    pub placement: String,
    /// Whether the floor near the eye is the same in both, so that the camera is.
    pub is_floor_right: bool,
    /// Whether it is neither turned nor in another size, as another camera would rather show it.
    pub is_only_moved: bool,
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
