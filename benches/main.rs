//! `make bench`: what things cost, as ratios within one run next to their targets. Times are CPU times of
//! the whole process, threads of the graphics driver included, the least of interleaved rounds.

mod course_editor;
mod crowds;
#[path = "../tests/window/desktop.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod desktop;
mod earlier;
mod frames;
mod graphics_card;
#[path = "../tests/host.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod host;
mod import;
mod moving;
mod picking;
mod report;
mod scaling;
mod skinning;
mod whole;
mod window;

use report::Report;

fn main() {
    if import::is_import_alone() {
        return;
    }
    // Cargo passes options of its own test harness.
    let filter = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    let mut report = Report::new(filter);
    whole::run(&mut report);
    earlier::run(&mut report);
    frames::run(&mut report);
    crowds::run(&mut report);
    moving::run(&mut report);
    picking::run(&mut report);
    import::run(&mut report);
    skinning::run(&mut report);
    scaling::run(&mut report);
    graphics_card::run(&mut report);
    report.finish();
}
