//! Importing a large file, while the page goes on.

use super::browser::Browser;
use super::comparing::{LONGEST, WATCH, jobs};
use std::fmt::Write;

/// Squares a side of the field that is imported: 21 MB.
const SIDE: usize = 600;

/// An `.obj` file of a hilly field of so many squares a side.
fn field(side: usize) -> String {
    let mut text = String::new();
    let at = |i: usize| i as f32 / side as f32 - 0.5;
    for (x, z) in (0..=side).flat_map(|z| (0..=side).map(move |x| (x, z))) {
        let height = ((x as f32 / 9.0).sin() + (z as f32 / 7.0).cos()) / 40.0;
        let _ = writeln!(text, "v {:.6} {height:.6} {:.6}", at(x), at(z));
    }
    for (x, z) in (0..side).flat_map(|z| (0..side).map(move |x| (x, z))) {
        let first = z * (side + 1) + x + 1;
        let below = first + side + 1;
        let _ = writeln!(text, "f {first} {below} {} {}", below + 1, first + 1);
    }
    text
}

/// The longest time, in milliseconds, for which the page stood still after the last job.
const AFTER: &str = "
    const [job] = performance.getEntriesByName('editor-job', 'measure').slice(-1);
    const inside = held.filter(([_, to]) => to > job.startTime + job.duration);
    return Math.max(...inside.map(([from, to]) => to - from));";

#[test]
fn the_page_goes_on_while_a_large_file_is_imported() {
    let browser = Browser::open();
    let file = tempfile::Builder::new()
        .prefix("field")
        .suffix(".obj")
        .tempfile()
        .unwrap();
    std::fs::write(file.path(), field(SIDE)).unwrap();
    let without = browser.picture();
    let before = jobs(&browser);
    browser.script(WATCH);
    browser.command("Import Shape");
    browser.choose(&[file.path().to_owned()]);
    browser.wait("the file is read", || jobs(&browser) > before);
    let [whole, longest, frames] = [0, 1, 2].map(|index| {
        let numbers = browser.script(&format!("const before = {before}; {LONGEST}"));
        numbers[index].as_f64().unwrap()
    });
    let with_field = browser.picture();
    let after = browser.script(AFTER);
    eprintln!("read in {whole:.0} ms with {frames} frames, the longest stop {longest:.0} ms");
    eprintln!("the longest stop until it is shown {after} ms");
    assert!(frames >= 5.0, "{frames} frames in {whole} ms");
    assert!(
        longest < whole / 2.0,
        "{longest} of {whole} ms in one piece"
    );
    assert_ne!(with_field, without);
    browser.finish();
}
