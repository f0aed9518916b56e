//! The page in headless Chromium, used as a person would. `make test-web` builds what it needs. Each
//! test fails on an error in the console, which is also where requests that failed and errors of
//! WebGL are, and on a blank picture.

mod beside;
mod browser;
mod comparing;
mod course;
mod dropping;
mod explaining;
mod files;
mod graphics;
mod keeping;
mod mannequin;
mod native;
mod offline;
mod picture;
mod screen;
mod sharing;
mod skinning;
mod subfolder;
mod touch;
mod using;
mod web_driver;

#[path = "../../../tests/reference_data.rs"]
#[expect(dead_code, reason = "the page is tried with the characters alone")]
mod reference_data;
