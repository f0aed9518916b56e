//! Scene files: what is written is read back, in both versions, and what is wrong is told.

mod archives;
mod documents;
mod faults;
mod missed;
mod missing;
mod round_trip;
mod support;
mod versions;
