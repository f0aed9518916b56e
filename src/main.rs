//! The program `editor`: see `editor --help`. In a browser it is a page.

#[cfg(target_arch = "wasm32")]
fn main() {
    editor_core::web::run();
}

#[cfg(not(target_arch = "wasm32"))]
use editor_core::program::{Options, globals};
#[cfg(not(target_arch = "wasm32"))]
use editor_core::{app, cli};

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    cli::run(|window| {
        let options = Options {
            files: window.files,
            title: window.title.as_deref().map(globals::title_for),
            skinning: window.skinning.map(Into::into),
            ..Options::default()
        };
        app::run(options).map_err(|error| error.to_string())
    })
}
