use glam::Vec3;

/// Named color.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorPreset {
    /// Name in the panel. Some do not match their color: they are the course's.
    pub name: &'static str,
    /// Red, green, blue in 0..1.
    pub color: Vec3,
}

/// Index in [`COLOR_PRESETS`] of the entry that stands for a color picked by hand.
pub const CUSTOM_PRESET: usize = 31;

const fn preset(name: &'static str, r: f32, g: f32, b: f32) -> ColorPreset {
    ColorPreset {
        name,
        color: Vec3::new(r, g, b),
    }
}

/// Colors of the course's editor, in its order; the last, Custom, starts white.
#[doc(alias = "ColorPresets")]
pub const COLOR_PRESETS: [ColorPreset; 32] = [
    preset("Black", 0.0, 0.0, 0.0),
    preset("White", 1.0, 1.0, 1.0),
    preset("Red", 1.0, 0.0, 0.0),
    preset("Lime", 0.0, 1.0, 0.0),
    preset("Blue", 0.0, 0.0, 1.0),
    preset("Yellow", 1.0, 1.0, 0.0),
    preset("Cyan", 0.0, 1.0, 1.0),
    preset("Magenta", 1.0, 0.0, 1.0),
    preset("Silver", 0.75, 0.75, 0.75),
    preset("Gray", 0.5, 0.5, 0.5),
    preset("Maroon", 0.5, 0.0, 0.0),
    preset("Olive", 0.5, 0.5, 0.0),
    preset("Green", 0.0, 0.5, 0.0),
    preset("Purple", 0.5, 0.0, 0.5),
    preset("Teal", 0.0, 0.5, 0.5),
    preset("Navy", 0.0, 0.0, 0.5),
    preset("Orange", 1.0, 0.5, 0.0),
    preset("Rose", 1.0, 0.0, 0.5),
    preset("Light Green", 0.0, 1.0, 0.5),
    preset("Gold", 0.5, 1.0, 0.0),
    preset("Violet", 0.5, 0.0, 1.0),
    preset("Light Blue", 0.0, 0.5, 1.0),
    preset("Pink", 1.0, 0.5, 0.5),
    preset("Mint", 0.5, 1.0, 0.5),
    preset("Lavender", 0.5, 0.5, 1.0),
    preset("Fuchsia", 1.0, 0.5, 1.0),
    preset("Baby Blue", 1.0, 1.0, 0.5),
    preset("Canary", 0.5, 1.0, 1.0),
    preset("Dark Gray", 0.25, 0.25, 0.25),
    preset("Nero", 0.125, 0.125, 0.125),
    preset("Light Gray", 0.825, 0.825, 0.825),
    preset("Custom", 1.0, 1.0, 1.0),
];

/// Color of a shape: one of the presets, or any other.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ShapeColor {
    /// Index into [`COLOR_PRESETS`].
    Preset(usize),
    /// Red, green, blue in 0..1.
    Custom(Vec3),
}

impl ShapeColor {
    /// Red, green, blue in 0..1.
    pub fn rgb(self) -> Vec3 {
        match self {
            Self::Preset(index) => COLOR_PRESETS[index.min(CUSTOM_PRESET)].color,
            Self::Custom(rgb) => rgb,
        }
    }

    /// Index of the entry of [`COLOR_PRESETS`] that the panel shows.
    pub fn preset_index(self) -> usize {
        match self {
            Self::Preset(index) => index.min(CUSTOM_PRESET),
            Self::Custom(_) => CUSTOM_PRESET,
        }
    }
}
