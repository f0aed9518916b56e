//! Collada files: every rule of the reader on files written for it, files of real exporters
//! against golden poses, and files that mean harm.

mod characters;
mod hostile;
mod importing;
mod materials;
mod meshes;
mod reference;
mod rest_pose;
pub mod support;
mod warnings;
