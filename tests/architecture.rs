//! Keeps the layers that ARCHITECTURE.md describes: what a layer may use is written here once,
//! and every `use` and path in the sources is held against it.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Our layers, from the bottom up, each with those it may use. Every layer may use itself.
const LAYERS: &[(&str, &[&str])] = &[
    ("math", &[]),
    ("geometry", &["math"]),
    ("character", &["geometry", "math"]),
    ("scene", &["character", "geometry", "math"]),
    ("io", &["scene", "character", "geometry", "math"]),
    ("editor", &["scene", "character", "geometry", "math"]),
    ("compare", &["geometry", "math"]),
    ("gpu", &[]),
    ("render", &["gpu", "scene", "character", "geometry", "math"]),
    (
        "ui",
        &[
            "editor",
            "compare",
            "scene",
            "character",
            "geometry",
            "math",
        ],
    ),
    ("disk", &["io"]),
    (
        "app",
        &[
            "disk",
            "ui",
            "render",
            "gpu",
            "compare",
            "editor",
            "io",
            "scene",
            "character",
            "geometry",
            "math",
        ],
    ),
    (
        "cli",
        &[
            "disk",
            "ui",
            "render",
            "gpu",
            "compare",
            "editor",
            "io",
            "scene",
            "character",
            "geometry",
            "math",
        ],
    ),
];

/// Crates of windows, graphics and user interfaces.
const OUTER_CRATES: &[&str] = &[
    "glow",
    "glutin",
    "glutin_winit",
    "winit",
    "egui",
    "egui_file_dialog",
    "egui_glow",
    "egui_winit",
    "libloading",
    "raw_window_handle",
];

/// The layers in which none of [`OUTER_CRATES`] may be named.
const INNER_LAYERS: &[&str] = &[
    "math",
    "geometry",
    "character",
    "scene",
    "io",
    "editor",
    "compare",
];

struct Source {
    path: PathBuf,
    layer: String,
    code: String,
}

fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    let mut open = vec![root.clone()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let inside = path.strip_prefix(&root).unwrap();
            let layer = inside
                .components()
                .next()
                .unwrap()
                .as_os_str()
                .to_str()
                .unwrap();
            if path.extension().is_some_and(|e| e == "rs") && inside.components().count() > 1 {
                let code = without_comments(&fs::read_to_string(&path).unwrap());
                found.push(Source {
                    layer: layer.to_owned(),
                    path: path.clone(),
                    code,
                });
            }
        }
    }
    assert!(found.len() > 40, "the sources were not found");
    found
}

fn without_comments(code: &str) -> String {
    code.lines()
        .map(|line| line.split("//").next().unwrap_or(""))
        .collect::<Vec<_>>()
        .join("\n")
}

/// Keywords and names in `code`, and words of its texts.
fn names(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !(c.is_alphanumeric() || c == '_'))
}

/// The layers that `code` names after `crate::`, in braces as well.
fn layers_used(code: &str) -> BTreeSet<&str> {
    code.split("crate::")
        .skip(1)
        .flat_map(|rest| {
            let names = match rest.strip_prefix('{') {
                Some(list) => list.split('}').next().unwrap_or(""),
                None => rest,
            };
            names
                .split(',')
                .take(if rest.starts_with('{') { usize::MAX } else { 1 })
        })
        .map(|name| {
            let name = name.trim_start();
            &name[..name
                .find(|c: char| !(c.is_alphanumeric() || c == '_'))
                .unwrap_or(name.len())]
        })
        .filter(|name| LAYERS.iter().any(|(layer, _)| layer == name))
        .collect()
}

#[test]
fn each_layer_uses_only_what_lies_below_it() {
    for source in sources() {
        let allowed = LAYERS
            .iter()
            .find(|(layer, _)| *layer == source.layer)
            .unwrap_or_else(|| panic!("{} is in no known layer", source.path.display()))
            .1;
        for used in layers_used(&source.code) {
            assert!(
                used == source.layer || allowed.contains(&used),
                "{}: `{}` must not use `{used}`",
                source.path.display(),
                source.layer,
            );
        }
    }
}

#[test]
fn the_inner_layers_name_no_window_graphics_or_interface_crate() {
    for source in sources() {
        if !INNER_LAYERS.contains(&source.layer.as_str()) {
            continue;
        }
        for outer in OUTER_CRATES {
            assert!(
                !names(&source.code).any(|name| name == *outer),
                "{}: `{}` must not use the crate `{outer}`",
                source.path.display(),
                source.layer,
            );
        }
    }
}

#[test]
fn unsafe_code_is_in_gpu_alone() {
    for source in sources() {
        let has_unsafe = names(&source.code).any(|name| name == "unsafe");
        assert!(
            !has_unsafe || source.layer == "gpu",
            "{} holds unsafe code",
            source.path.display()
        );
    }
}

#[test]
fn files_clocks_and_threads_stay_at_the_edge() {
    for source in sources() {
        if ["app", "cli", "disk"].contains(&source.layer.as_str()) {
            continue;
        }
        for name in [
            "std::fs",
            "std::thread",
            "std::time::Instant",
            "std::process",
        ] {
            assert!(
                !source.code.contains(name),
                "{} uses {name}",
                source.path.display()
            );
        }
    }
}

#[test]
fn no_sentence_is_left_for_later() {
    for source in sources() {
        let text = fs::read_to_string(&source.path).unwrap();
        for word in [
            "TODO",
            "FIXME",
            "todo!(",
            "unimplemented!(",
            "allow(dead_code)",
        ] {
            assert!(
                !text.contains(word),
                "{} holds {word}",
                source.path.display()
            );
        }
    }
}
