use super::Camera;

/// How the scene is looked at: everything about a picture that is not in the scene itself.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub struct ViewSettings {
    /// Where from.
    pub camera: Camera,
    /// Light and background.
    pub look: Look,
    /// Whether the axes are drawn.
    pub axis: bool,
    /// Whether the Studio look draws its grid on the ground, and the Mannequin look its floor.
    pub grid: bool,
    /// Facetted, smooth, or as the mesh has it.
    pub shading: Shading,
}

impl Default for ViewSettings {
    fn default() -> Self {
        Self {
            camera: Camera::default(),
            look: Look::Course,
            axis: true,
            grid: true,
            shading: Shading::AsAuthored,
        }
    }
}

/// A set of lights with a background.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Look {
    /// The course's: one light, and highlights as seen from the world's origin, so that pictures
    /// can be compared with the course's program.
    #[default]
    Course,
    /// Key, fill and rim light with highlights for the real eye, and a grid on the ground.
    Studio,
    /// The Virtual Mannequin's: surfaces in the colors of their normals, a checkered floor, and
    /// bones as red lines over everything.
    Mannequin,
}

/// Which normals a surface is lit with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Shading {
    /// The mesh's own normals; facetted where it has none, as characters have it.
    #[default]
    AsAuthored,
    /// One normal a triangle.
    Flat,
    /// One normal a vertex, the mean of the faces around it where the mesh has none.
    Smooth,
}

/// Where the meshes of characters are deformed for drawing. Both ways apply every influence and
/// agree to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Skinning {
    /// On the processor, which uploads the vertices: faster where it draws them, too.
    Cpu,
    /// On the graphics card, in a vertex shader.
    Gpu,
}
