//! Posing by hand as data: what a drag makes of a character, whatever the view and the placement.

mod dragging;
mod ik;
mod mirroring;
mod moving;
mod picking;
mod shapes;
mod support;
