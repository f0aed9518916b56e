//! Skeletal subspace deformation: `v' = Σ wᵢ Tᵢ Bᵢ⁻¹ v` over every joint with a weight
//! (assignment, "SSD").

mod exact;

pub use exact::skin_positions;
