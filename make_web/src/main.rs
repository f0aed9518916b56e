//! Writes, compresses, packs or serves the files of the page: see `USAGE`.

use std::error::Error;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

const USAGE: &str = "usage: make_web write PROGRAM.wasm ASSETS FOLDER
       make_web compress FOLDER
       make_web package FOLDER ARCHIVE.zip
       make_web serve FOLDER [PORT]";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        ["write", program, assets, folder] => {
            make_web::write(Path::new(program), Path::new(assets), Path::new(folder))
        }
        ["compress", folder] => compress(Path::new(folder)),
        ["package", folder, archive] => make_web::package(Path::new(folder), Path::new(archive)),
        ["serve", folder] => serve(folder, "8080"),
        ["serve", folder, port] => serve(folder, port),
        _ => Err(USAGE.into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn compress(folder: &Path) -> Result<(), Box<dyn Error>> {
    make_web::compress(folder)?;
    let needed = make_web::of_first_picture(folder)?;
    println!("The first picture needs {:.2} MB.", needed as f64 / 1e6);
    Ok(())
}

fn serve(folder: &str, port: &str) -> Result<(), Box<dyn Error>> {
    let port = port.parse().map_err(|_| USAGE)?;
    let server = make_web::Server::new(Path::new(folder), port)?;
    println!(
        "The page is at {} until you press Ctrl+C.",
        server.address()
    );
    open(&server.address());
    make_web::serve(&server);
    Ok(())
}

/// Opens `address` in the browser, where there is a desktop that knows one; else the address was printed.
fn open(address: &str) {
    let has = |name: &str| std::env::var_os(name).is_some();
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        Command::new("explorer")
    } else if has("DISPLAY") || has("WAYLAND_DISPLAY") {
        Command::new("xdg-open")
    } else {
        return;
    };
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
    let _ = quiet.arg(address).spawn();
}
