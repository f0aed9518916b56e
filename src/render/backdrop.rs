//! What is behind the shapes, and the colors that are legible before it.

use super::backdrop_pass::COURSE;
use super::ground_pass::LIT;
use crate::geometry::{GroundColors, Picture};
use crate::scene::Look;
use glam::Vec3;

/// Brightness of the Studio look's background and ground. The other looks have one background each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Backdrop {
    /// Dark gray.
    #[default]
    Dark,
    /// Light gray, for bright rooms and paper.
    Light,
}

/// Colors of a background, and of lines and marks before it.
#[derive(Debug)]
pub(super) struct Colors {
    /// Background at the top of the picture.
    pub top: Vec3,
    /// Background at the bottom.
    pub bottom: Vec3,
    pub ground: Vec3,
    /// Lines of the ground's grid.
    pub grid: Vec3,
    /// Share of its light that the ground loses in the deepest shadow.
    pub darkness: f32,
    /// Axes X, Y and Z.
    pub axes: [Vec3; 3],
    /// Bones and joints that are not marked.
    pub bone: Vec3,
    /// Outline of the shape under the pointer.
    pub hovered: Vec3,
    pub curve: Vec3,
    /// Control points and their polygon.
    pub control: Vec3,
}

const DARK: Colors = Colors {
    top: Vec3::new(0.30, 0.33, 0.37),
    bottom: Vec3::new(0.12, 0.13, 0.15),
    ground: Vec3::new(0.37, 0.39, 0.42),
    grid: Vec3::new(0.72, 0.76, 0.82),
    darkness: 0.6,
    axes: [Vec3::X, Vec3::Y, Vec3::Z],
    bone: Vec3::ONE,
    hovered: Vec3::new(0.85, 0.88, 0.92),
    curve: Vec3::ONE,
    control: Vec3::new(1.0, 1.0, 0.0),
};

const LIGHT: Colors = Colors {
    top: Vec3::new(0.80, 0.84, 0.88),
    bottom: Vec3::new(0.93, 0.94, 0.95),
    ground: Vec3::new(0.88, 0.89, 0.90),
    grid: Vec3::new(0.36, 0.39, 0.44),
    darkness: 0.4,
    axes: [
        Vec3::new(0.80, 0.05, 0.05),
        Vec3::new(0.05, 0.50, 0.05),
        Vec3::new(0.05, 0.20, 0.85),
    ],
    bone: Vec3::new(0.22, 0.27, 0.34),
    hovered: Vec3::new(0.20, 0.24, 0.30),
    curve: Vec3::new(0.10, 0.12, 0.16),
    control: Vec3::new(0.62, 0.38, 0.0),
};

impl Backdrop {
    /// The backdrop of a picture that was drawn in the Studio look, by its uppermost row; `None` of
    /// any other picture.
    pub fn of_studio(picture: &Picture) -> Option<Self> {
        const TOLERANCE: f32 = 3.0;
        let shows = |backdrop: &Self| {
            let top = backdrop.colors(Look::Studio).top;
            shows_behind(picture, 0, top, TOLERANCE)
        };
        [Self::Dark, Self::Light].into_iter().find(shows)
    }

    /// Whether a picture has the background of the course's program and of the Course look, by its uppermost and its lowest row.
    pub fn is_of_course(picture: &Picture) -> bool {
        let rows = [0, (picture.height as usize).saturating_sub(1)];
        rows.into_iter()
            .all(|row| shows_behind(picture, row, Vec3::splat(COURSE), 1.0))
    }

    /// What figures stand on in the Studio look.
    pub fn ground(self) -> GroundColors {
        let colors = self.colors(Look::Studio);
        GroundColors {
            top: colors.top,
            bottom: colors.bottom,
            color: colors.ground,
            lit: LIT,
            darkness: colors.darkness,
        }
    }

    /// The colors of a look before this backdrop.
    pub(super) fn colors(self, look: Look) -> &'static Colors {
        match (look, self) {
            (Look::Studio, Self::Light) => &LIGHT,
            _ => &DARK,
        }
    }
}

/// Whether a row of a picture shows a color of what is behind figures, each channel to within so many of 255.
fn shows_behind(picture: &Picture, row: usize, color: Vec3, tolerance: f32) -> bool {
    // Figures may reach into it.
    const SHARE: f32 = 0.4;
    let pixels: &[[u8; 4]] = picture.rgba.as_chunks().0;
    let width = picture.width as usize;
    let Some(row) = pixels.get(row * width..(row + 1) * width) else {
        return false;
    };
    let is_such = |[r, g, b, _]: &&[u8; 4]| {
        let found = Vec3::new(f32::from(*r), f32::from(*g), f32::from(*b));
        found.abs_diff_eq(color * 255.0, tolerance)
    };
    let count = row.iter().filter(is_such).count();
    count as f32 >= SHARE * row.len().max(1) as f32
}
