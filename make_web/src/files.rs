//! The files that a server shows.

use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use wasm_bindgen_cli_support::Bindgen;

/// Files that are the same for every program.
const PAGE: [(&str, &[u8]); 6] = [
    ("index.html", include_bytes!("../page/index.html")),
    ("start.js", include_bytes!("../page/start.js")),
    ("editor-view.js", include_bytes!("../page/editor-view.js")),
    ("example.html", include_bytes!("../page/example.html")),
    ("icon.svg", include_bytes!("../page/icon.svg")),
    ("README.md", include_bytes!("../page/README.md")),
];

/// The script that keeps the page for times without a network. It gets the version and the files.
const SERVICE_WORKER: &str = include_str!("../page/service-worker.js");

/// Folders of built-in files that the program fetches when they are used. Small ones are inside it.
const ASSETS: [&str; 3] = ["characters", "rigs", "shapes"];

/// Font with signs that the first picture does without.
const FONT: (&str, &[u8]) = (
    "fonts/NotoEmoji-Regular.ttf",
    epaint_default_fonts::NOTO_EMOJI_REGULAR,
);

/// Writes the page of `program`, as the compiler made it, into a new `folder`, with what the program
/// fetches from the folder `assets`.
///
/// # Errors
/// If `program` is no module for a page, or a file cannot be read or written.
pub fn write(program: &Path, assets: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    if folder.is_dir() {
        fs::remove_dir_all(folder)?;
    }
    fs::create_dir_all(folder)?;
    Bindgen::new()
        .input_path(program)
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .out_name("editor")
        .generate(folder)?;
    for (name, bytes) in PAGE.into_iter().chain([FONT]) {
        write_below(folder, Path::new(name), bytes)?;
    }
    for kind in ASSETS {
        for entry in fs::read_dir(assets.join(kind))? {
            let path = entry?.path();
            let name = Path::new("assets").join(path.strip_prefix(assets)?);
            write_below(folder, &name, &fs::read(&path)?)?;
        }
    }
    let worker = service_worker(folder)?;
    write_below(folder, Path::new("service-worker.js"), worker.as_bytes())?;
    Ok(())
}

fn write_below(folder: &Path, name: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = folder.join(name);
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent)?;
    }
    fs::write(path, bytes)
}

/// The script that keeps all files in `folder`, in a version that follows from their bytes.
fn service_worker(folder: &Path) -> io::Result<String> {
    let mut version = crc32fast::Hasher::new();
    let mut names = Vec::new();
    for name in files_below(folder)? {
        let text = with_slashes(&name);
        version.update(text.as_bytes());
        version.update(&fs::read(folder.join(&name))?);
        names.push(format!("{text:?}"));
    }
    let version = format!("{:08x}", version.finalize());
    Ok(SERVICE_WORKER
        .replace("__VERSION__", &format!("{version:?}"))
        .replace("__FILES__", &format!("[{}]", names.join(", "))))
}

/// Names of all files in `folder` and the folders below it, in order.
///
/// # Errors
/// If a folder cannot be read.
pub(super) fn files_below(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(below) = folders.pop() {
        for entry in fs::read_dir(folder.join(&below))? {
            let entry = entry?;
            let name = below.join(entry.file_name());
            if entry.file_type()?.is_dir() {
                folders.push(name);
            } else {
                files.push(name);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// A relative path as addresses and archives have it.
pub(super) fn with_slashes(path: &Path) -> String {
    let parts = path.iter().map(|part| part.to_string_lossy());
    parts.collect::<Vec<_>>().join("/")
}
