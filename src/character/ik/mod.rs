//! Inverse kinematics: a chain of joints turns so that its end reaches a target.
//!
//! A chain of two links is solved by the law of cosines; a longer one by FABRIK (Aristidou and
//! Lasenby, *FABRIK: a fast, iterative solver for the Inverse Kinematics problem*, 2011), after
//! which its bends are opened or closed together until the end is exactly as far away as the
//! target. So every target within reach is reached, in a bounded number of steps, and the same
//! input gives the same pose. The chain points at a target out of reach.
//!
//! Joints turn freely: there are no limits, and the skeleton's offsets never change. Everything is
//! in the character's model space.

mod chain;
mod links;
mod pins;

pub use chain::{IkChain, IkGoal, IkSolution};
pub use pins::hold_pins;
