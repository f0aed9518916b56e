//! Skinning in the vertex shader held to the exact path: by the numbers that the shader makes, read
//! back bit by bit, and by pictures.

pub mod characters;
mod numbers;
mod pictures;
