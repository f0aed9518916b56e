/// What deforms the meshes that are drawn. Both ways count every influence and agree to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Skinning {
    /// The processor, which then hands the vertices over: faster where it draws them, too.
    Cpu,
    /// The graphics card, in a vertex shader.
    Gpu,
}
