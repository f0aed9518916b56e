//! Deflates the large files of `assets/` for `src/io/builtin.rs`, which has the list of those that are
//! inside the program: as they are, they would be a third of it.

use flate2::Compression;
use flate2::write::DeflateEncoder;
use std::io::{Error, Result, Write};
use std::path::Path;
use std::{env, fs};

/// Folders below `assets/` with the large files.
const FOLDERS: [&str; 3] = ["characters", "rigs", "shapes"];

fn main() -> Result<()> {
    println!("cargo::rerun-if-changed=assets");
    let out = env::var_os("OUT_DIR").ok_or_else(|| Error::other("cargo sets OUT_DIR"))?;
    for folder in FOLDERS {
        let target = Path::new(&out).join(folder);
        fs::create_dir_all(&target)?;
        for entry in fs::read_dir(Path::new("assets").join(folder))? {
            let entry = entry?;
            let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
            encoder.write_all(&fs::read(entry.path())?)?;
            fs::write(target.join(entry.file_name()), encoder.finish()?)?;
        }
    }
    Ok(())
}
