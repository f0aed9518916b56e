//! Comparing: two pictures or two meshes, by numbers, as a picture of the differences, and in
//! sentences that say what is wrong. Nothing here draws, opens a file or a window.
//!
//! A is the reference and B what is compared with it. [`Pair::compare`] and [`compare_meshes`] do
//! everything at once; a [`PictureJob`] does it in two halves, the quick one first, for a view that
//! must stay live, and each of them in small
//! [`Steps`](crate::steps::Steps), for threads that must not be held up.

mod allowance;
mod area;
mod diagnosis;
mod differences;
mod exactly_same;
mod faint;
mod figure_off;
mod filters;
mod flip;
mod mesh;
mod other_background;
mod outlines;
mod pair;
mod picture_comparison;
mod pixel_grid;
mod place;
mod rules;
mod smooth_edges;
mod ssim;
#[cfg(test)]
mod test_pictures;

pub use allowance::Allowance;
pub use area::Area;
pub use diagnosis::{Finding, HighlightChange, Which};
pub(crate) use differences::difference;
pub use differences::{Differences, side_by_side};
pub use figure_off::FigureOff;
pub use flip::{Flip, PIXELS_PER_DEGREE};
pub use mesh::{
    MESH_TOLERANCE, MeshComparison, MeshFinding, MeshOptions, MeshParts, MeshPlace, SignedAxis,
    WorstVertex, compare_meshes, permutation,
};
pub(crate) use mesh::{nearest_rotation, placement};
pub use outlines::{WholePlaced, outline_placement, whole_outline_placed};
pub use pair::{DRAWN_THRESHOLD, Pair};
pub use picture_comparison::{Judgment, Measured, PictureComparison, PictureJob, PictureOptions};
pub use pixel_grid::PixelGrid;
pub use place::about;
pub use rules::sentence;
pub use smooth_edges::has_smooth_edges;

/// Why two things cannot be compared at all.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CompareError {
    /// Pictures of different sizes. Sizes are width and height in pixels.
    #[error("the pictures differ in size: A is {}×{}, B is {}×{}{}", .a[0], .a[1], .b[0], .b[1], size_hint(*.a, *.b))]
    Size {
        /// Size of A.
        a: [u32; 2],
        /// Size of B.
        b: [u32; 2],
    },
    /// A picture whose bytes do not fill its rows.
    #[error("picture {which} should have {expected} bytes for its size but has {found}")]
    Bytes {
        /// `A` or `B`.
        which: char,
        /// Four bytes a pixel.
        expected: u64,
        /// What is there.
        found: u64,
    },
    /// An area to ignore that no pixel lies in.
    #[error("the area to ignore {area} lies outside of the {}×{} pictures", .size[0], .size[1])]
    AreaOutside {
        /// The area.
        area: Area,
        /// Size of the pictures.
        size: [u32; 2],
    },
    /// Empty pictures, or areas to ignore that cover everything.
    #[error("no pixel is left to compare")]
    NothingToCompare,
    /// Meshes of different numbers of vertices.
    #[error("the meshes differ in size: A has {a} vertices, B has {b}{}", in_common(*.a, *.b, *.alike))]
    Vertices {
        /// Vertices of A.
        a: u64,
        /// Vertices of B.
        b: u64,
        /// What they have in common.
        alike: Alike,
    },
    /// Meshes without vertices.
    #[error("the meshes have no vertices")]
    NoVertices,
}

/// What meshes of different numbers of vertices have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alike {
    /// The larger mesh begins with all vertices of the smaller one.
    Beginning,
    /// The vertices of each lie where some of the other do.
    Places,
    /// None of that.
    Nothing,
}

/// What a difference in the number of vertices comes from; empty if unknown.
fn in_common(a: u64, b: u64, alike: Alike) -> String {
    let more = if a < b { 'B' } else { 'A' };
    match alike {
        Alike::Beginning => format!(
            " ({more} has all those of the other first, and {} more after them)",
            a.abs_diff(b)
        ),
        Alike::Places => {
            " (at the same places: vertices were merged, or repeated for each face)".to_owned()
        }
        Alike::Nothing => String::new(),
    }
}

/// What a difference in size most likely comes from; empty if unknown.
fn size_hint(a: [u32; 2], b: [u32; 2]) -> String {
    let [width, height] = a.map(u64::from);
    let [other_width, other_height] = b.map(u64::from);
    if a[0] == b[1] && a[1] == b[0] {
        return " (width and height are exchanged)".to_owned();
    }
    let same_shape = width * other_height == height * other_width;
    if !same_shape || a.contains(&0) || b.contains(&0) {
        return String::new();
    }
    let factor = other_width as f64 / width as f64;
    if factor > 1.0 {
        format!(" (B is A's shape, {factor:.4} times as large: taken on a scaled screen?)")
    } else {
        let factor = 1.0 / factor;
        format!(" (A is B's shape, {factor:.4} times as large: taken on a scaled screen?)")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(a: [u32; 2], b: [u32; 2]) -> String {
        CompareError::Size { a, b }.to_string()
    }

    #[test]
    fn exchanged_width_and_height_are_named() {
        assert!(message([800, 600], [600, 800]).contains("exchanged"));
        assert!(!message([800, 600], [640, 800]).contains("exchanged"));
    }

    #[test]
    fn a_picture_of_a_scaled_screen_is_named_with_its_factor() {
        assert!(message([800, 600], [1600, 1200]).contains("B is A's shape, 2.0000 times"));
        assert!(message([1000, 750], [800, 600]).contains("A is B's shape, 1.2500 times"));
        assert!(message([800, 600], [801, 600]).ends_with("B is 801×600"));
        assert!(message([0, 600], [0, 300]).ends_with("B is 0×300"));
    }
}
