//! Inverse kinematics: chains reach what they can, point at what they cannot, and stay whole.

mod chains;
mod characters;
mod pins;
mod posing;
mod reaching;
