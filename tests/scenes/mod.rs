//! Scene files: what is written is read back, in both versions, and what is wrong is told.

mod documents;
mod round_trip;
mod support;
