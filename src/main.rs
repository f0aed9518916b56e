//! The program `editor`: see `editor --help`.

fn main() -> std::process::ExitCode {
    editor_core::cli::run()
}
