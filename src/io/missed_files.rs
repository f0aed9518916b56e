//! Files that are read with others and are not there, for hosts that can bring them.

use super::builtin::{WithBuiltin, is_builtin};
use super::{Diagnostic, Files, Loaded, Missing, WithArchives, file_access};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Files that are looked for when all of `paths` are opened, and that `files` does not have, in the order
/// in which they are looked for: models of scenes, skeletons, materials, pictures. Built-in ones are left
/// out. What these files name in turn is known once they are there.
pub fn missed_files(files: &dyn Files, paths: &[PathBuf]) -> Vec<PathBuf> {
    let missed = Mutex::default();
    let noting = Noting {
        files,
        missed: &missed,
    };
    let noting = WithBuiltin(WithArchives::new(noting));
    let mut loaded = Loaded {
        missing: Missing::StandIn,
        ..Loaded::default()
    };
    for path in paths {
        // Whoever opens it is told what is wrong with it.
        let _ = loaded.add(&noting, path);
    }
    missed.into_inner().unwrap_or_else(PoisonError::into_inner)
}

/// Files that take note of those that are looked for and are not there.
struct Noting<'a> {
    files: &'a dyn Files,
    missed: &'a Mutex<Vec<PathBuf>>,
}

impl Noting<'_> {
    fn look_for(&self, path: &Path) {
        // A file in an archive comes with all of it.
        let is_archive = |folder: &&Path| file_access::is_archive(folder);
        let path = path.ancestors().find(is_archive).unwrap_or(path);
        if self.files.exists(path) || is_builtin(path) {
            return;
        }
        let mut missed = self.missed.lock().unwrap_or_else(PoisonError::into_inner);
        if !missed.iter().any(|known| known == path) {
            missed.push(path.to_owned());
        }
    }
}

impl Files for Noting<'_> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Diagnostic> {
        self.look_for(path);
        let bytes = self.files.read(path)?;
        match &*file_access::extension(path) {
            "obj" => Ok(without_geometry(&bytes)),
            _ => Ok(bytes),
        }
    }

    fn exists(&self, path: &Path) -> bool {
        self.look_for(path);
        self.files.exists(path)
    }

    fn absolute(&self, path: &Path) -> PathBuf {
        self.files.absolute(path)
    }

    fn real(&self, path: &Path) -> PathBuf {
        self.files.real(path)
    }
}

/// An `.obj` file that names and uses the same materials as `obj`, on a single triangle. Reading all of the
/// geometry would take as long as opening the file does afterwards, and nothing in it names a file.
fn without_geometry(obj: &[u8]) -> Vec<u8> {
    const TRIANGLE: &[u8] = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let mut kept = TRIANGLE.to_vec();
    for line in obj.split(|&byte| byte == b'\n') {
        let words = line.trim_ascii_start();
        let uses = words.starts_with(b"usemtl");
        if uses || words.starts_with(b"mtllib") {
            kept.extend(line);
            kept.push(b'\n');
        }
        if uses {
            // Materials that no face has are not looked for.
            kept.extend(b"f 1 2 3\n");
        }
    }
    kept
}
