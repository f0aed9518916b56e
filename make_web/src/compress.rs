//! Files made smaller for their way, by the two methods that browsers know.

use super::files::files_below;
use brotli::enc::BrotliEncoderParams;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::error::Error;
use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Extensions of files that are compressed in themselves, or that no browser asks for.
const LEFT: [&str; 4] = ["gz", "br", "png", "md"];

/// Files that the first picture of the page needs.
const OF_FIRST_PICTURE: [&str; 16] = [
    "index.html",
    "icon.svg",
    "start.js",
    "editor.js",
    "editor_bg.wasm",
    "assets/characters/adult.attach",
    "assets/characters/adult.obj",
    "assets/characters/adult.skel",
    "assets/characters/dog.attach",
    "assets/characters/dog.obj",
    "assets/characters/dog.skel",
    "assets/characters/robot.attach",
    "assets/characters/robot.obj",
    "assets/characters/robot.skel",
    "assets/shapes/plant.mtl",
    "assets/shapes/plant.obj",
];
/// Bytes that these may take over the wire.
const MOST: u64 = 2_500_000;

/// Writes a `.gz` and a `.br` beside every file in `folder` that becomes smaller.
///
/// # Errors
/// If a file cannot be read or written.
pub fn compress(folder: &Path) -> Result<(), Box<dyn Error>> {
    for name in files_below(folder)? {
        let extension = name.extension().unwrap_or_default();
        if LEFT.iter().any(|left| extension == OsStr::new(left)) {
            continue;
        }
        let path = folder.join(name);
        let bytes = fs::read(&path)?;
        let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
        gzip.write_all(&bytes)?;
        for (extension, packed) in [("gz", gzip.finish()?), ("br", brotli(&bytes)?)] {
            if packed.len() < bytes.len() {
                fs::write(with_extension(&path, extension), packed)?;
            }
        }
    }
    Ok(())
}

/// Bytes that the first picture of the compressed page in `folder` takes over the wire.
///
/// # Errors
/// If one of its files is not there, or they are more than 2.5 MB.
pub fn of_first_picture(folder: &Path) -> Result<u64, Box<dyn Error>> {
    let size = |name: &str| {
        let path = folder.join(format!("{name}.br"));
        let size = fs::metadata(&path).map(|file| file.len());
        size.map_err(|error| format!("{}: {error}", path.display()))
    };
    let sizes = OF_FIRST_PICTURE.iter().map(|name| size(name));
    let needed = sizes.sum::<Result<u64, String>>()?;
    if needed > MOST {
        let message =
            format!("expected {MOST} bytes for the first picture at most, found {needed}");
        return Err(message.into());
    }
    Ok(needed)
}

fn brotli(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let parameters = BrotliEncoderParams {
        quality: 11,
        lgwin: 24,
        size_hint: bytes.len(),
        ..BrotliEncoderParams::default()
    };
    let mut packed = Vec::new();
    brotli::BrotliCompress(&mut &*bytes, &mut packed, &parameters)?;
    Ok(packed)
}

/// `path` with one more extension.
pub(super) fn with_extension(path: &Path, extension: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(extension);
    PathBuf::from(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::File;

    #[test]
    fn a_first_picture_has_a_size_only_if_all_its_files_are_there_and_small_enough() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, size: u64| {
            let path = folder.path().join(format!("{name}.br"));
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            File::create(path).unwrap().set_len(size).unwrap();
        };
        let size = || of_first_picture(folder.path()).map_err(|error| error.to_string());
        let [last, others @ ..] = OF_FIRST_PICTURE;
        for name in others {
            write(name, 2);
        }
        let missing = size().unwrap_err();
        assert!(missing.contains(&format!("{last}.br: ")), "{missing}");
        write(last, MOST - 30);
        assert_eq!(size(), Ok(MOST));
        write(last, MOST - 29);
        let expected = "expected 2500000 bytes for the first picture at most, found 2500001";
        assert_eq!(size(), Err(expected.to_owned()));
    }
}
