use super::Camera;
use std::f32::consts::{FRAC_PI_2, PI};

/// View: everything about a picture that is not in the scene itself.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub struct ViewSettings {
    /// Camera.
    pub camera: Camera,
    /// Lights and background.
    pub look: Look,
    /// Whether the axes are drawn.
    pub axis: bool,
    /// Whether the Studio look draws its grid on the ground, and the Mannequin look its floor.
    pub grid: bool,
    /// Whether the Mannequin look draws the bones of characters that show their mesh alone, and not only
    /// the one under the pointer.
    pub bones: bool,
    /// Normals that surfaces are shaded with.
    pub shading: Shading,
}

impl Default for ViewSettings {
    fn default() -> Self {
        Self {
            camera: Camera::default(),
            look: Look::Course,
            axis: true,
            grid: true,
            bones: true,
            shading: Shading::AsAuthored,
        }
    }
}

/// How far ahead along Z the camera looks from where it sees the sides of shapes that the Course look leaves dark.
const AGAINST_THE_LIGHT: f32 = 0.5;

impl ViewSettings {
    /// Gives the view another look with the axes as that has them, unless they were shown or hidden otherwise than the look
    /// before has them.
    pub fn choose_look(&mut self, look: Look) {
        if self.axis == self.look.has_axes() {
            self.axis = look.has_axes();
        }
        self.look = look;
    }

    /// Whether a ground is seen, which hides what is below it.
    pub fn has_ground(&self) -> bool {
        self.grid && self.look == Look::Studio
    }

    /// Whether the sides of shapes are seen that the Course look, which has one light from +Z, leaves dark.
    pub fn looks_against_the_light(&self) -> bool {
        self.look == Look::Course && self.camera.forward().z > AGAINST_THE_LIGHT
    }
}

/// Lights with a background.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Look {
    /// The course editor's: one light, and highlights as seen from the world's origin, so that
    /// pictures can be compared with that program.
    #[default]
    Course,
    /// Key, fill and rim light with highlights for the actual eye, and a grid on the ground.
    Studio,
    /// The Virtual Mannequin's: surfaces in the colors of their normals, a checkered floor, and
    /// bones as red lines over everything.
    Mannequin,
}

impl Look {
    /// Whether a new view of it shows the axes. A ground of the look's own stands for them, which would cross what stands on
    /// it.
    pub fn has_axes(self) -> bool {
        self == Self::Course
    }
}

/// Normals that a surface is shaded with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Shading {
    /// The mesh's own normals; flat triangles where it has none, as in characters.
    #[default]
    AsAuthored,
    /// One normal per triangle.
    Flat,
    /// One normal per vertex, the mean of the faces around it where the mesh has none.
    Smooth,
}

/// Processor that skins the meshes of characters for drawing. Both apply every influence and agree
/// up to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Skinning {
    /// The CPU, which uploads the vertices: faster where it also draws them.
    Cpu,
    /// The graphics card, in a vertex shader.
    Gpu,
}

/// Direction of the six views of the View menu, named for the side from which they look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewDirection {
    /// Seen from +X.
    PlusX,
    /// Seen from −X.
    MinusX,
    /// Seen from above, with +X to the right.
    PlusY,
    /// Seen from below, with +X to the right.
    MinusY,
    /// Seen from +Z.
    PlusZ,
    /// Seen from −Z.
    MinusZ,
}

impl ViewDirection {
    /// All six, in the order of the menu.
    pub const ALL: [Self; 6] = [
        Self::PlusX,
        Self::MinusX,
        Self::PlusY,
        Self::MinusY,
        Self::PlusZ,
        Self::MinusZ,
    ];

    /// Name: `+X`, `-X`, ….
    pub fn label(self) -> &'static str {
        match self {
            Self::PlusX => "+X",
            Self::MinusX => "-X",
            Self::PlusY => "+Y",
            Self::MinusY => "-Y",
            Self::PlusZ => "+Z",
            Self::MinusZ => "-Z",
        }
    }

    /// Angles θ and φ of the camera, radians. Seen from straight above or below, θ is the roll of
    /// the picture: at 90° +X is to the right.
    pub(super) fn angles(self) -> (f32, f32) {
        match self {
            Self::PlusX => (0.0, 0.0),
            Self::MinusX => (PI, 0.0),
            Self::PlusY => (FRAC_PI_2, FRAC_PI_2),
            Self::MinusY => (FRAC_PI_2, -FRAC_PI_2),
            Self::PlusZ => (FRAC_PI_2, 0.0),
            Self::MinusZ => (-FRAC_PI_2, 0.0),
        }
    }
}
