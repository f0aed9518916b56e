//! Writes everything under `assets/` anew: `cargo run --release --example make_assets [FOLDER]`.
//!
//! The characters, rigs, shapes and poses that the program brings along are made by this code alone, and
//! come out the same bit for bit each time.
mod catalog;

use std::path::{Path, PathBuf};

fn main() -> std::io::Result<()> {
    let default = || Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(default, PathBuf::from);
    for file in catalog::files() {
        let path = folder.join(file.path);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(&path, &file.content)?;
        println!("{} ({} bytes)", path.display(), file.content.len());
    }
    Ok(())
}
