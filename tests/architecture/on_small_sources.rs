//! The rules themselves: each is broken by a small source, which must be seen.

use super::table::Table;
use super::{faults, names::names};

const TABLE: &str = "
# Layers

| layer | holds | may use | may name |
|---|---|---|---|
| `math` | numbers | – | – |
| `scene` | shapes | `math` | – |
| `gpu` | OpenGL | – | `glow`, `unsafe`, `winit` |
| `ui` | panels | `scene` and below | `egui` |
| `disk` | files | – | `std::fs`, `tempfile` |
| `app`, `cli` | hosts | everything below | `egui`, `std::fs`, `std::time::Instant`, `std::thread` |

Text after it.
";

/// What is wrong with `code` in the file `path` of a library with the layers above.
#[track_caller]
fn wrong(path: &str, code: &str) -> Vec<String> {
    faults(&Table::read(TABLE), path, code)
}

#[test]
fn a_row_says_what_a_layer_may_use_and_name() {
    let table = Table::read(TABLE);
    let uses = |name: &str| Vec::from_iter(table.layer(name).unwrap().uses.clone());
    assert_eq!(uses("math"), <[&str; 0]>::default());
    assert_eq!(uses("ui"), ["math", "scene"]);
    assert_eq!(uses("cli"), ["disk", "gpu", "math", "scene", "ui"]);
    assert_eq!(
        Vec::from_iter(&table.layer("gpu").unwrap().names),
        ["glow", "unsafe", "winit"]
    );
}

#[test]
fn a_new_layer_is_one_more_row() {
    let row = "| `program` | – | `ui`, `gpu` and below | `egui` |\n| `app`";
    let table = Table::read(&TABLE.replace("| `app`", row));
    assert_eq!(
        faults(&table, "program/a.rs", "use crate::{gpu, scene, ui};"),
        [""; 0]
    );
    assert_eq!(
        faults(&table, "program/a.rs", "use crate::disk;"),
        ["program/a.rs:1: `program` must not use `disk`"]
    );
    assert_eq!(faults(&table, "app/a.rs", "use crate::program;"), [""; 0]);
}

#[test]
#[should_panic(expected = "has no row above")]
fn a_layer_that_is_to_use_one_above_it_is_no_rule() {
    Table::read(&TABLE.replace("| numbers | –", "| numbers | `scene`"));
}

#[test]
#[should_panic(expected = "expected names in backticks or a dash")]
fn a_cell_of_other_words_is_no_rule() {
    Table::read(&TABLE.replace("| shapes | `math`", "| shapes | `math` mostly"));
}

#[test]
fn a_layer_above_is_seen_however_it_is_named() {
    for code in [
        "use crate::ui;",
        "use crate::ui::Panel;",
        "use crate::{math::Ray, ui::{self, Panel}};",
        "use crate::{\n    math::{Ray, area::{Area, Side}},\n    ui,\n};",
        "use crate::{math as numbers, ui as panels};",
        "use {crate::math, crate::{ui}};",
        "pub use crate::ui::*;",
        "pub(in crate::ui) fn f() {}",
        "use super::super::ui::Panel;",
        "use super::{super::ui};",
        "mod tests { use super::super::super::ui; }",
        "use self::super::super::ui;",
        "fn f() -> u8 { crate::ui::f() }",
        "fn f(panel: &crate::ui::Panel) {}",
        "fn f() { vec![1, crate::ui::f()]; }",
        "fn f() { g::<crate::ui::Panel>() }",
        "macro_rules! m { () => { $crate::ui::f() } }",
        "impl<T> From<T> for crate :: ui :: Panel {}",
        "use crate /* of ours */ :: // here\n ui;",
        "use crate::r#ui;",
        "impl dyn ::a::B for crate::ui::Panel {}",
    ] {
        let found = wrong("scene/shape.rs", code);
        assert!(
            found.len() == 1 && found[0].ends_with("`scene` must not use `ui`"),
            "{code}: {found:?}"
        );
    }
}

#[test]
fn the_line_is_told() {
    assert_eq!(
        wrong(
            "scene/shape.rs",
            "use crate::{\n    math,\n    ui,\n};\n\nfn f(_: crate::gpu::Gl) {}"
        ),
        [
            "scene/shape.rs:3: `scene` must not use `ui`",
            "scene/shape.rs:6: `scene` must not use `gpu`",
        ]
    );
}

#[test]
fn a_layer_below_its_own_and_mere_words_are_no_fault() {
    assert_eq!(wrong("math.rs", "pub struct Ray;"), [""; 0]);
    for code in [
        "use crate::math::{Ray, area::Area};",
        "use crate::scene::Shape;",
        "use super::camera::{self, Camera};",
        "mod tests { use super::*; }",
        "pub(crate) fn f() {}",
        "//! See crate::ui.\n/// And [`crate::ui::Panel`].\nfn f() {} // crate::ui",
        "const TEXT: &str = \"crate::ui, std::fs and unsafe\";",
        "fn f(ui: u8) -> u8 { ui }",
        "use std::{collections::BTreeMap, time::Duration};",
        "fn f(files: &Files) { files.exists(path); }",
    ] {
        assert_eq!(wrong("scene/shape.rs", code), [""; 0], "{code}");
    }
}

#[test]
fn hosts_do_not_use_each_other() {
    assert_eq!(
        wrong("app/mod.rs", "use crate::cli;"),
        ["app/mod.rs:1: `app` must not use `cli`"]
    );
    assert_eq!(
        wrong("cli/mod.rs", "use super::app;"),
        ["cli/mod.rs:1: `cli` must not use `app`"]
    );
}

#[test]
fn what_hides_the_layers_is_refused() {
    for (code, name) in [
        ("use crate::*;", "*"),
        ("use super::super::*;", "*"),
        ("use crate as all;", "*"),
        ("use crate::{self as all};", "*"),
        ("use crate::Panel;", "Panel"),
    ] {
        assert_eq!(
            wrong("scene/shape.rs", code),
            [format!("scene/shape.rs:1: `crate::{name}` is in no layer")],
            "{code}"
        );
    }
    assert_eq!(
        wrong("widgets/mod.rs", ""),
        ["widgets/mod.rs: `widgets` is in no row of the table"]
    );
}

#[test]
fn unsafe_code_crates_files_clocks_and_threads_stay_where_the_table_has_them() {
    for (code, name) in [
        ("fn f() { unsafe { g() } }", "unsafe"),
        ("unsafe impl Send for A {}", "unsafe"),
        ("use glow::HasContext;", "glow::HasContext"),
        (
            "fn f(_: &winit::window::Window) {}",
            "winit::window::Window",
        ),
        ("use ::egui::Ui;", "egui::Ui"),
        ("use std::fs;", "std::fs"),
        ("use std::{fs::File, io};", "std::fs::File"),
        ("use {std::{io, fs as files}};", "std::fs"),
        ("use {::std::fs};", "std::fs"),
        ("fn f() { std::thread::spawn(g); }", "std::thread::spawn"),
        ("use std::time::{Duration, Instant};", "std::time::Instant"),
        ("use std::{time::{self, Duration}};", "std::time"),
        ("use std::time::*;", "std::time::*"),
        ("use std::*;", "std::*"),
        ("use std as library;", "std::*"),
        (
            "fn f() { assert!(std::fs::exists(\"a\").is_ok()); }",
            "std::fs::exists",
        ),
    ] {
        assert_eq!(
            wrong("scene/shape.rs", code),
            [format!("scene/shape.rs:1: `scene` must not name `{name}`")],
            "{code}"
        );
    }
    let tests = "#[cfg(test)]\nmod tests { fn f() { tempfile::tempdir(); } }";
    assert_eq!(wrong("app/storage.rs", tests), [""; 0]);
    assert_eq!(
        wrong(
            "app/storage.rs",
            &format!("use tempfile::tempdir;\n{tests}")
        ),
        ["app/storage.rs:1: `app` must not name `tempfile::tempdir`"]
    );
    assert_eq!(
        wrong("gpu/gl.rs", "use glow::Context; fn f() { unsafe {} }"),
        [""; 0]
    );
    assert_eq!(
        wrong("disk/mod.rs", "use std::fs; fn f(p: &Path) { p.exists(); }"),
        [""; 0]
    );
    assert_eq!(
        wrong("app/mod.rs", "use std::{fs, thread, time::Instant};"),
        [""; 0]
    );
}

#[test]
fn methods_of_paths_that_ask_the_disk_are_seen() {
    assert_eq!(
        wrong(
            "ui/mod.rs",
            "fn f(path: &Path) -> bool {\n    path\n        .is_file()\n}"
        ),
        ["ui/mod.rs:3: `is_file()` asks the disk"]
    );
}

#[test]
fn a_path_is_read_as_it_is_meant() {
    let paths = |code: &str| -> Vec<String> {
        let named = names(code, &["ui", "joints"]).paths;
        named.iter().map(|named| named.path.join("::")).collect()
    };
    assert_eq!(paths("self::a::b"), ["crate::ui::joints::a::b"]);
    assert_eq!(paths("super::a"), ["crate::ui::a"]);
    assert_eq!(
        paths("a::{b::{c, d::*}, self}"),
        ["a::b::c", "a::b::d::*", "a"]
    );
    assert_eq!(paths("mod m { super::a }"), ["crate::ui::joints::a"]);
}
