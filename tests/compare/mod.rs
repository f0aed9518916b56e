//! Comparing pictures: what is said to be wrong, provoked one by one, and not said of anything
//! else.

mod axes;
mod meshes;
mod painter;
mod pictures;
mod program;
mod steps;
