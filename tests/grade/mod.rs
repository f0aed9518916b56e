//! Grading a class: folders of solutions, made by the student's program of `tests/diagnose`.

mod class;
#[cfg(unix)]
mod commands;
mod documents;
mod files;
mod hostile;
mod late;
mod near;
mod parts;
mod report;
mod support;
