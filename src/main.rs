//! The program `editor`: see `editor --help`.

use editor_core::{app, cli};

fn main() -> std::process::ExitCode {
    cli::run(|window| {
        let options = app::Options {
            files: window.files,
            title: window.title.as_deref().map(app::globals::title_for),
            skinning: window.skinning.map(Into::into),
        };
        app::run(options).map_err(|error| error.to_string())
    })
}
