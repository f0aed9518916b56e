//! Curves and surfaces as the assignment has them: Bézier curves, B-splines and circles with
//! frames, surfaces of revolution, generalized cylinders, and the `.swp` files that describe
//! them.

mod degenerate;
mod dragging;
mod editing;
mod export;
mod frames;
mod own_files;
mod points;
mod reference;
mod support;
mod surfaces;
mod swp;
mod volumes;
