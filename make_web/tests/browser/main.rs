//! The page in headless Chromium, used as a person would. `make test-web` builds what it needs. Each
//! test fails on an error in the console, which is also where requests that failed and errors of
//! WebGL are, and on a blank picture.

mod beside;
mod browser;
mod comparing;
mod explaining;
mod files;
mod graphics;
mod native;
mod offline;
mod picture;
mod sharing;
mod touch;
mod using;
mod web_driver;
