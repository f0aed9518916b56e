//! The files that a server shows.

use flate2::Compression;
use flate2::write::GzEncoder;
use std::error::Error;
use std::fs;
use std::io::Write;
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

/// Files that are the same for every program.
const PAGE: [(&str, &[u8]); 3] = [
    ("index.html", include_bytes!("../page/index.html")),
    ("icon.svg", include_bytes!("../page/icon.svg")),
    ("README.md", include_bytes!("../page/README.md")),
];

/// Files that are worth being packed on their way.
const PACKED: [&str; 2] = ["editor_bg.wasm", "editor.js"];

/// Writes the page of `program`, as the compiler made it, into `folder`.
///
/// # Errors
/// If `program` is no module for a page, or a file cannot be written.
pub fn write(program: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    Bindgen::new()
        .input_path(program)
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .out_name("editor")
        .generate(folder)?;
    for (name, bytes) in PAGE {
        fs::write(folder.join(name), bytes)?;
    }
    for name in PACKED {
        let bytes = fs::read(folder.join(name))?;
        let packed = fs::File::create(folder.join(format!("{name}.gz")))?;
        let mut packed = GzEncoder::new(packed, Compression::best());
        packed.write_all(&bytes)?;
        packed.finish()?;
    }
    Ok(())
}
