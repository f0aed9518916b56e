//! The program `editor`: see `editor --help`.

use editor_core::program::{Options, globals};
use editor_core::{app, cli};

fn main() -> std::process::ExitCode {
    cli::run(|window| {
        let options = Options {
            files: window.files,
            title: window.title.as_deref().map(globals::title_for),
            skinning: window.skinning.map(Into::into),
        };
        app::run(options).map_err(|error| error.to_string())
    })
}
