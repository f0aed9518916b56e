//! Where in a pixel the driver looks for triangles.

use crate::gpu::Info;
use glam::Vec2;

/// Places in each pixel, from its lower left corner, at which a triangle has to be to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Samples {
    pub places: Vec<Vec2>,
    /// Pixels by which the corner of a triangle may be off there.
    pub room: f32,
}

impl Samples {
    /// The middle of the pixel, of pictures without samples.
    pub fn middle(info: &Info) -> Self {
        // OpenGL promises four bits; twice of what rounding to the nearest may do.
        let bits = info.subpixel_bits.clamp(4, 16);
        Self {
            places: vec![Vec2::splat(0.5)],
            room: 0.5_f32.powi(bits.cast_signed()),
        }
    }
}
