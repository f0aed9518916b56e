use glam::Vec3;

/// Ten colors of viridis at equal distances, as in its authors' table (S. van der Walt and N. Smith,
/// matplotlib 1.5, dedicated to the public domain under CC0).
const VIRIDIS: [[u8; 3]; 10] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x28, 0x78],
    [0x3e, 0x4a, 0x89],
    [0x31, 0x68, 0x8e],
    [0x26, 0x82, 0x8e],
    [0x1f, 0x9e, 0x89],
    [0x35, 0xb7, 0x79],
    [0x6d, 0xcd, 0x59],
    [0xb4, 0xde, 0x2c],
    [0xfd, 0xe7, 0x25],
];

/// Color of what counts as nothing: none of the scale's.
pub const SCALE_GRAY: Vec3 = Vec3::splat(0.62);

/// Color at a `part` of the scale, from 0 (dark violet) to 1 (yellow), as stored values. Its lightness
/// grows evenly, and people with any kind of color vision can tell its colors apart. What is not a
/// number has the color of 0.
pub fn scale_color(part: f32) -> Vec3 {
    let last = VIRIDIS.len() - 1;
    let part = if part.is_nan() { 0.0 } else { part };
    let at = part.clamp(0.0, 1.0) * last as f32;
    let below = (at as usize).min(last - 1);
    let color = |index: usize| Vec3::from(VIRIDIS[index].map(f32::from)) / 255.0;
    color(below).lerp(color(below + 1), at - below as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lightness L* of CIELAB under D65.
    fn lightness(stored: Vec3) -> f32 {
        let linear = stored.to_array().map(|channel| {
            if channel <= 0.04045 {
                channel / 12.92
            } else {
                ((channel + 0.055) / 1.055).powf(2.4)
            }
        });
        let luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
        116.0 * luminance.cbrt() - 16.0
    }

    #[test]
    fn equal_steps_of_the_number_are_equal_steps_of_lightness() {
        let steps = 20;
        let at = |step: i32| lightness(scale_color(step as f32 / steps as f32));
        let even = (at(steps) - at(0)) / steps as f32;
        for step in 0..steps {
            let rise = at(step + 1) - at(step);
            assert!((rise - even).abs() < 0.3 * even, "{step}: {rise} of {even}");
        }
    }

    #[test]
    fn numbers_beyond_the_ends_have_the_colors_of_the_ends() {
        assert_eq!(scale_color(0.0), Vec3::new(68.0, 1.0, 84.0) / 255.0);
        assert_eq!(scale_color(1.0), Vec3::new(253.0, 231.0, 37.0) / 255.0);
        assert_eq!(scale_color(-3.0), scale_color(0.0));
        assert_eq!(scale_color(7.0), scale_color(1.0));
        assert_eq!(scale_color(f32::INFINITY), scale_color(1.0));
        assert_eq!(scale_color(f32::NAN), scale_color(0.0));
    }
}
