//! Comparing: two pictures or two meshes, by numbers, as a picture of the differences, and in
//! words that say *what* is wrong. Nothing here draws, opens a file or a window.
//!
//! A is the reference and B what is held against it. [`Pair::compare`] and [`compare_meshes`] do
//! everything at once; a [`Pair`] of pictures also gives each measure alone, for a view that must
//! stay live.

mod convolve;
mod diagnosis;
mod differences;
mod error;
mod flip;
mod heat;
mod mesh;
mod pair;
mod picture;
mod ssim;
#[cfg(test)]
mod test_pictures;
mod told;

pub use crate::math::Area;
pub use diagnosis::{Finding, HighlightChange, Which};
pub use differences::Differences;
pub use error::CompareError;
pub use flip::{Flip, PIXELS_PER_DEGREE};
pub use heat::side_by_side;
pub use mesh::{
    MESH_TOLERANCE, MeshComparison, MeshFinding, MeshOptions, WorstVertex, compare_meshes,
};
pub use pair::{DRAWN_THRESHOLD, Pair};
pub use picture::{Allowance, PictureComparison, PictureOptions};
