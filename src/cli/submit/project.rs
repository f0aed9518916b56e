//! The files of the project's folder that belong into a submission.

use super::archive::Entry;
use crate::cli::output::eprint_line;
use crate::disk::{self, Disk};
use crate::io::{Diagnostic, Files};
use ignore::WalkBuilder;
use std::fs::Metadata;
use std::path::{Path, PathBuf};

/// Files without which a folder is not the project's.
const NEEDED: [&str; 3] = ["Cargo.toml", "Cargo.lock", "src/main.rs"];
/// Largest sum of the sizes of all files, in bytes: what most course sites take is less.
const LARGEST: usize = 512 << 20;

/// Refuses a folder that is not the project's.
///
/// # Errors
/// If it lacks a file that the project has.
pub(super) fn check(folder: &Path) -> Result<(), Diagnostic> {
    let Some(missing) = NEEDED.iter().find(|name| !folder.join(name).is_file()) else {
        return Ok(());
    };
    let message = format!(
        "expected the folder of the project, found no {missing} in it: go there, or name it \
         with --project"
    );
    Err(Diagnostic::new(folder, message))
}

/// Name of the package in `folder`, if its Cargo.toml says so.
pub(super) fn package(folder: &Path) -> Option<String> {
    let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).ok()?;
    let manifest: toml::Table = manifest.parse().ok()?;
    Some(manifest.get("package")?.get("name")?.as_str()?.to_owned())
}

/// All files of the project in `folder`, by their paths in it and in their order, except what
/// `.gitignore` names, what is made anew or only of use on this machine, and the files `except`.
///
/// # Errors
/// If a file cannot be read, or they are too large.
pub(super) fn files(folder: &Path, except: &[PathBuf]) -> Result<Vec<Entry>, Diagnostic> {
    let walk = WalkBuilder::new(folder)
        .standard_filters(false)
        .git_ignore(true)
        .require_git(false)
        .follow_links(false)
        .sort_by_file_name(Ord::cmp)
        .filter_entry(|entry| !is_left_out(entry.path(), entry.depth()))
        .build();
    let mut entries = Vec::new();
    let mut size = 0;
    for found in walk {
        let found = found.map_err(|error| Diagnostic::new(folder, error.to_string()))?;
        let path = found.path();
        let kind = found.file_type();
        if kind.is_none_or(|kind| kind.is_dir()) {
            continue;
        }
        if except.iter().any(|file| disk::is_same_file(file, path)) {
            continue;
        }
        if !kind.is_some_and(|kind| kind.is_file()) {
            let path = path.display();
            eprint_line(format_args!("warning: {path}: left out, for it is no file"));
            continue;
        }
        let bytes = Disk.read(path)?;
        size += bytes.len();
        if size > LARGEST {
            let message = format!(
                "expected files of at most {} MiB in all, found more: name in .gitignore what \
                 need not be handed in",
                LARGEST >> 20
            );
            return Err(Diagnostic::new(folder, message));
        }
        let inside = path.strip_prefix(folder).unwrap_or(path);
        let mut entry = Entry::new(inside, bytes);
        if let Ok(known) = found.metadata() {
            entry.is_executable = is_executable(&known);
            entry.modified = known.modified().unwrap_or(entry.modified);
        }
        entries.push(entry);
    }
    Ok(entries)
}

/// Whether a file or folder, `depth` folders below the project's own, is never handed in: what git,
/// macOS and editors keep beside the files, what is built, and submissions made before.
fn is_left_out(path: &Path, depth: usize) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let of_tools = [".git", ".DS_Store", "__MACOSX"].contains(&&*name)
        || name.starts_with("._")
        || name.ends_with('~')
        || name.starts_with(".editor-") && name.ends_with(".part");
    let is_target = name == "target" && depth == 1 || path.join("CACHEDIR.TAG").is_file();
    let is_archive = [".zip", ".tar.gz", ".tgz"]
        .iter()
        .any(|end| name.to_lowercase().ends_with(end));
    depth > 0 && (of_tools || is_target || depth == 1 && is_archive)
}

#[cfg(unix)]
fn is_executable(file: &Metadata) -> bool {
    use std::os::unix::fs::PermissionsExt;
    file.permissions().mode() & 0o111 != 0
}

/// Files have no such mark there.
#[cfg(not(unix))]
fn is_executable(_: &Metadata) -> bool {
    false
}
