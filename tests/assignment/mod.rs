//! The assignment "Hierarchical Modeling and SSD", section by section, as sentences that hold.

pub mod characters;

mod s3_1_matrix_stack;
mod s3_2_skeleton;
mod s3_3_stick_figure;
mod s3_4_sliders;
mod s4_1_mesh;
mod s4_2_ssd;
mod s5_scene;
