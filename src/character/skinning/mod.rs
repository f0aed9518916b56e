//! Skeletal subspace deformation: `v' = Σ wᵢ Tᵢ Bᵢ⁻¹ v` over every joint with a weight
//! (assignment, "SSD").

mod exact;
mod normals;

pub use exact::skin_positions;
pub use normals::skin_normals;
