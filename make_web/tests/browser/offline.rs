//! The page without a network, and newer versions of it: served by the program that `make serve` runs.

use super::browser::{Browser, SIZE, VIEW, page_folder};
use super::picture::{assert_not_blank, difference};
use std::fs;
use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// `make_web serve`, which ends with it.
struct Served(Child, String);

impl Served {
    fn new(folder: &Path) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_make_web"));
        let command = command.arg("serve").arg(folder).arg("0");
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        let mut said = BufReader::new(child.stdout.take().unwrap());
        said.read_line(&mut line).unwrap();
        let address = line
            .split_whitespace()
            .find(|word| word.starts_with("http"));
        let address = address.unwrap().to_owned();
        Self(child, address)
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

const IS_KEPT: &str = "return navigator.serviceWorker.controller !== null";

#[test]
fn a_page_that_was_loaded_once_works_without_its_server() {
    let served = Served::new(&page_folder());
    let browser = Browser::at(served.1.clone(), SIZE, 1.0);
    browser.wait("the page is kept", || browser.script(IS_KEPT) == true);
    drop(served);
    // A scene with a character that has not been shown yet.
    browser.go("?open=builtin:mannequin-4");
    assert_not_blank(&browser.picture(), VIEW);
    browser.finish();
}

#[test]
fn a_newer_version_takes_the_place_of_the_older_at_the_next_start() {
    let folder = tempfile::tempdir().unwrap();
    copy(&page_folder(), folder.path());
    let served = Served::new(folder.path());
    let browser = Browser::at(served.1.clone(), SIZE, 1.0);
    browser.wait("the page is kept", || browser.script(IS_KEPT) == true);
    let edit = |name: &str, from: &str, to: &str| {
        let path = folder.path().join(name);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(from), "{name}");
        fs::write(path, text.replacen(from, to, 1)).unwrap();
    };
    edit(
        "index.html",
        "<html lang=\"en\">",
        "<html lang=\"en\" data-newer>",
    );
    edit(
        "service-worker.js",
        "OF_THIS_PAGE + ",
        "OF_THIS_PAGE + \"newer-\" + ",
    );
    let is_newer = "return 'newer' in document.documentElement.dataset";
    browser.reload();
    assert_eq!(browser.script(is_newer), false, "what is kept comes first");
    browser.script(
        "navigator.serviceWorker.getRegistration().then((found) => { window.found = found })",
    );
    let waits = "return Boolean(window.found?.waiting)";
    browser.wait("the newer version is there", || {
        browser.script(waits) == true
    });
    browser.reload();
    browser.wait("the newer version is used", || {
        browser.script(is_newer) == true
    });
    browser.wait_for_program();
    browser.finish();
}

#[test]
fn characters_are_fetched_when_they_are_used() {
    let browser = Browser::open();
    let fetched = |name: &str| {
        let script = format!(
            "return performance.getEntriesByType('resource').some((entry) => entry.name.endsWith('{name}'))"
        );
        browser.script(&script) == true
    };
    assert!(fetched("assets/characters/robot.obj"));
    assert!(!fetched("assets/rigs/humanoid.dae"));
    let before = browser.picture();
    browser.go("?open=builtin:humanoid");
    assert!(fetched("assets/rigs/humanoid.dae"));
    assert!(difference(&before, &browser.picture(), VIEW) > 0.05);
    browser.finish();
}

/// Copies a folder with all that is in it.
pub fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}
