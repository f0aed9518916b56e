//! Inverse kinematics: a chain of joints turns so that a point of it gets to where it is wanted.
//!
//! A chain of two links is solved by the law of cosines; a longer one by FABRIK (Aristidou and
//! Lasenby, *FABRIK: a fast, iterative solver for the Inverse Kinematics problem*, 2011), after
//! which its bends are opened or closed together until the end is exactly as far away as the
//! target. So whatever can be reached is, within a fixed number of steps, and the same input
//! gives the same pose. A target out of reach is pointed at.
//!
//! Joints turn freely about their places: the skeleton's offsets never change. Everything is in
//! the character's model space.

mod bend;
mod chain;
mod closing;
mod fabrik;
mod frames;
mod links;
mod pins;
mod reach;
mod solve;

pub use chain::IkChain;
pub use pins::hold_pins;
pub use solve::{IkGoal, IkSolution};
