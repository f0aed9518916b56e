//! Holds the sources to what ARCHITECTURE.md says about the layers. Its table is the rule: a new
//! layer is a row there.

mod names;
mod on_small_sources;
mod table;

use names::{Named, Names, names};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use table::{Layer, Table};

/// Methods of `std::path::Path` that ask the file system without naming `std::fs`. Our own of
/// these names take arguments.
const ASKING_THE_DISK: &[&str] = &[
    "canonicalize",
    "exists",
    "is_dir",
    "is_file",
    "is_symlink",
    "metadata",
    "read_dir",
    "read_link",
    "symlink_metadata",
    "try_exists",
];

/// What may not stand in a source.
const LEFT_FOR_LATER: &[&str] = &[
    "TODO",
    "FIXME",
    "XXX",
    "todo!(",
    "unimplemented!(",
    "allow(dead_code)",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn table() -> Table {
    Table::read(&fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap())
}

/// All files below `folder` of the checkout, by their paths in it.
fn files(folder: &str) -> Vec<PathBuf> {
    let (mut found, mut open) = (Vec::new(), vec![root().join(folder)]);
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                found.push(path.strip_prefix(root()).unwrap().to_owned());
            }
        }
    }
    found.sort();
    found
}

/// What is wrong with the source at `path` below `src`, each as `path:line: …`.
fn faults(table: &Table, path: &str, code: &str) -> Vec<String> {
    let stem = path.strip_suffix(".rs").unwrap();
    let stem = stem.strip_suffix("/mod").unwrap_or(stem);
    let module: Vec<&str> = stem.split('/').collect();
    let Some(layer) = table.layer(module[0]) else {
        return vec![format!("{path}: `{}` is in no row of the table", module[0])];
    };
    let Names { paths, bare_calls } = names(code, &module);
    // Tests stand at the end of a file.
    let tests = code.lines().position(|line| line == "#[cfg(test)]");
    let is_folder_of_tests = |named: &Named| {
        named.path[0] == "tempfile" && tests.is_some_and(|tests| named.line > tests)
    };
    let used = paths.iter().flat_map(|named| {
        let of_path = [
            layer_fault(table, layer, &named.path),
            guard_fault(table, layer, &named.path).filter(|_| !is_folder_of_tests(named)),
        ];
        of_path
            .into_iter()
            .flatten()
            .map(|fault| (named.line, fault))
    });
    let called = bare_calls.into_iter().filter_map(|(method, line)| {
        let asks = ASKING_THE_DISK.contains(&&*method) && !layer.names.contains("std::fs");
        asks.then(|| (line, format!("`{method}()` asks the disk")))
    });
    let found: BTreeSet<(usize, String)> = used.chain(called).collect();
    let told = |(line, fault)| format!("{path}:{line}: {fault}");
    found.into_iter().map(told).collect()
}

/// Why `layer` may not name the item of ours at `path`.
fn layer_fault(table: &Table, layer: &Layer, path: &[String]) -> Option<String> {
    let [root, name, ..] = path else { return None };
    if root != "crate" || *name == layer.name || layer.uses.contains(name) {
        return None;
    }
    Some(match table.layer(name) {
        Some(_) => format!("`{}` must not use `{name}`", layer.name),
        None => format!("`crate::{name}` is in no layer"),
    })
}

/// Why `layer` may not name `path`, which leads out of the library.
fn guard_fault(table: &Table, layer: &Layer, path: &[String]) -> Option<String> {
    let path: Vec<&str> = path.iter().map(|name| &**name).collect();
    let (inside, all) = match &path[..] {
        [inside @ .., "*"] => (inside, true),
        // A module of the standard library that is imported lets what is in it be named.
        ["std", _] => (&path[..], true),
        path => (path, false),
    };
    let reaches = |guarded: &str| {
        let guarded: Vec<&str> = guarded.split("::").collect();
        inside.starts_with(&guarded) || all && guarded.starts_with(inside)
    };
    let mut refused = table
        .guarded()
        .into_iter()
        .filter(|name| !layer.names.contains(*name));
    refused
        .any(reaches)
        .then(|| format!("`{}` must not name `{}`", layer.name, path.join("::")))
}

#[test]
fn every_source_keeps_to_its_layer() {
    let table = table();
    let sources = files("src");
    assert!(sources.len() > 100, "the sources were not found");
    let mut found = Vec::new();
    for path in &sources {
        let inside = path.strip_prefix("src").unwrap().to_str().unwrap();
        if !["lib.rs", "main.rs"].contains(&inside) {
            let code = fs::read_to_string(root().join(path)).unwrap();
            found.extend(faults(&table, inside, &code));
        }
    }
    assert_eq!(found, <[String; 0]>::default());
}

#[test]
fn every_layer_of_the_table_is_a_module_of_the_library() {
    let library = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    for layer in table().layers {
        let module = format!("\npub mod {};", layer.name);
        assert!(library.contains(&module), "{}", layer.name);
    }
}

#[test]
fn every_file_that_the_notes_name_is_there() {
    let mut named = 0;
    for notes in ["ARCHITECTURE.md", "CONTRIBUTING.md", "README.md"] {
        let text = fs::read_to_string(root().join(notes)).unwrap();
        // Every other part stands between backticks.
        for part in text.split('`').skip(1).step_by(2) {
            let is_file = [".rs", ".glsl", ".py", ".sh"]
                .iter()
                .any(|end| part.ends_with(end));
            if is_file && !part.contains(['*', '<', ' ']) {
                let is_there = |folder: &str| root().join(folder).join(part).is_file();
                assert!(is_there("") || is_there("src"), "{notes} names {part}");
                named += 1;
            }
        }
    }
    assert!(named > 20, "{named}");
}

#[test]
fn unsafe_code_windows_and_files_are_guarded() {
    let table = table();
    let who = |name: &str| -> Vec<&str> {
        let may = table
            .layers
            .iter()
            .filter(|layer| layer.names.contains(name));
        may.map(|layer| &*layer.name).collect()
    };
    assert_eq!(who("unsafe"), ["gpu"]);
    assert_eq!(who("glow"), ["gpu"]);
    assert_eq!(who("egui_glow"), ["gpu"]);
    assert_eq!(who("winit"), ["gpu", "app", "cli"]);
    assert_eq!(who("std::fs"), ["disk", "app", "cli"]);
    for name in [
        "std::thread",
        "std::time::Instant",
        "std::time::SystemTime",
        "std::process",
    ] {
        assert_eq!(who(name), ["app", "cli"], "{name}");
    }
}

#[test]
fn no_sentence_is_left_for_later() {
    for path in ["src", "shaders", "make_assets", "make_web"]
        .into_iter()
        .flat_map(files)
    {
        let text = fs::read_to_string(root().join(&path)).unwrap();
        for word in LEFT_FOR_LATER {
            assert!(!text.contains(word), "{} holds {word}", path.display());
        }
    }
}
