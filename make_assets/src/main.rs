//! Writes everything under `assets/` anew: `cargo run --release -p make_assets [FOLDER]`.
//!
//! The characters, rigs, shapes and poses that the program brings along are made by this code alone, and
//! come out the same bit for bit each time.

use std::path::PathBuf;

fn main() -> std::io::Result<()> {
    let folder = std::env::args_os().nth(1);
    let folder = folder.map_or_else(|| PathBuf::from(make_assets::ASSETS), PathBuf::from);
    for file in make_assets::files() {
        let path = folder.join(file.path);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(&path, &file.content)?;
        println!("{} ({} bytes)", path.display(), file.content.len());
    }
    Ok(())
}
