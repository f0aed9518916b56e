//! All tests that need no window, one folder for each part, in one program: each program of tests
//! links the whole library. `tests/window` and `tests/gpu_window` are programs of their own,
//! because they take turns at a display and want the processor for themselves.

mod host;
mod keyboard;
mod reference_data;

mod architecture;
mod assets;
mod assignment;
mod bad_input;
mod builtin;
mod collada;
mod compare;
mod curves;
mod diagnose;
mod editing;
mod exporting;
mod grade;
mod history;
mod ik;
mod interface;
mod long;
mod offscreen;
mod pictures;
mod posing;
mod program;
mod reference;
mod scenes;
mod skinning;
mod stories;
mod work;
