//! The colors of a ground with shadows, by which what is drawn before it in a picture is told from it.

use glam::Vec3;

/// Shares of the ground's light that are tried.
const SHARES: [f32; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
/// How far each channel of a pixel may be from one of the ground, 0 to 1: rounding, and a share of light between two.
const NEAR: f32 = 4.5 / 255.0;

/// The colors of a background that goes from one color at the bottom to another at the top, of a ground before it that has
/// some light of its own, and of the shadows that darken both. Red, green and blue, 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundColors {
    /// Background at the top of the picture.
    pub top: Vec3,
    /// Background at the bottom.
    pub bottom: Vec3,
    /// Color of the ground's light.
    pub color: Vec3,
    /// Share of the background that this covers where it is strongest.
    pub lit: f32,
    /// Share of all light that is missing in the deepest shadow.
    pub darkness: f32,
}

impl GroundColors {
    /// Whether a pixel may be one of the ground, in the shade or not, `up` of the picture's height above its bottom.
    pub fn may_be(&self, [r, g, b, alpha]: [u8; 4], up: f32) -> bool {
        if alpha < u8::MAX {
            return false;
        }
        let pixel = Vec3::new(f32::from(r), f32::from(g), f32::from(b)) / 255.0;
        let smooth = up * up * (3.0 - 2.0 * up);
        let background = self.bottom.lerp(self.top, smooth);
        SHARES.into_iter().any(|share| {
            let lit = background.lerp(self.color, share * self.lit);
            let light = pixel.dot(lit) / lit.length_squared();
            let light = light.clamp(1.0 - self.darkness, 1.0);
            pixel.abs_diff_eq(light * lit, NEAR)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GROUND: GroundColors = GroundColors {
        top: Vec3::new(0.3, 0.33, 0.37),
        bottom: Vec3::new(0.12, 0.13, 0.15),
        color: Vec3::new(0.37, 0.39, 0.42),
        lit: 0.6,
        darkness: 0.6,
    };

    fn pixel(color: Vec3) -> [u8; 4] {
        let [r, g, b] = (color * 255.0)
            .to_array()
            .map(|channel| channel.round() as u8);
        [r, g, b, 255]
    }

    #[test]
    fn light_and_shadows_of_every_strength_are_the_grounds_and_figures_are_not() {
        for up in [0.0, 0.2, 0.5, 0.9, 1.0_f32] {
            let background = GROUND.bottom.lerp(GROUND.top, up * up * (3.0 - 2.0 * up));
            for tenth in 0..=10 {
                let lit = background.lerp(GROUND.color, 0.06 * tenth as f32);
                for light in [1.0, 0.93, 0.7, 0.4] {
                    assert!(
                        GROUND.may_be(pixel(light * lit), up),
                        "{up} {tenth} {light}"
                    );
                }
            }
            let darkest = GROUND.may_be(pixel(0.2 * background), up);
            assert!(!darkest, "{up}: darker than any shadow");
            let lit = background.lerp(GROUND.color, GROUND.lit);
            let brightest = GROUND.may_be(pixel(1.15 * lit + 0.05), up);
            assert!(!brightest, "{up}: brighter than any light");
            for figure in [
                Vec3::splat(0.8),
                Vec3::new(0.0, 0.4, 0.0),
                Vec3::new(0.3, 0.28, 0.2),
            ] {
                assert!(!GROUND.may_be(pixel(figure), up), "{figure}");
            }
        }
    }
}
