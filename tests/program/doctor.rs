//! `editor doctor`: with what this machine has, and with what it pretends to lack.

use super::{editor_in, folder};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Exit code and output of `editor doctor` without a display and with the variables `set`.
fn doctor(json: bool, set: &[(&str, &Path)]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_editor"));
    command.arg("doctor").args(json.then_some("--json"));
    for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(variable);
    }
    let output = command.envs(set.iter().copied()).output().unwrap();
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    let out = String::from_utf8(output.stdout).unwrap();
    (output.status.code(), out)
}

fn doctor_json(set: &[(&str, &Path)]) -> (Option<i32>, Value) {
    let (code, out) = doctor(true, set);
    (code, serde_json::from_str(&out).unwrap())
}

/// Sentence of the help that has `words` in it.
fn help_about<'a>(report: &'a Value, words: &str) -> Option<&'a str> {
    let help = report["help"].as_array().unwrap().iter();
    help.map(|help| help.as_str().unwrap())
        .find(|help| help.contains(words))
}

#[test]
fn it_succeeds_exactly_where_a_picture_can_be_drawn_and_names_the_driver() {
    let folder = folder();
    let line = ["render", "man.obj", "--size", "8x8", "-o", "a.png"];
    let draws = editor_in(folder.path(), &line).code == Some(0);
    let (code, report) = doctor_json(&[]);
    assert_eq!((code == Some(0), report["render"] == "egl"), (draws, draws));
    assert_eq!(report["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(report["display"]["server"], "none");
    assert_eq!(report["window"], Value::Null);
    let driver = &report["egl"]["works"];
    assert!(driver["max_texture_side"].as_u64() >= Some(1024));
    assert!(help_about(&report, "There is no display").is_some());
    let software = driver["software"] == true;
    let advised = help_about(&report, "drawn on the processor").is_some();
    assert_eq!(software, advised);

    let (code, words) = doctor(false, &[]);
    assert_eq!(code == Some(0), draws);
    for said in [
        "renderer",
        "samples",
        "settings",
        "There is no display",
        "render, export, check, compare, diagnose and grade need none",
    ] {
        assert!(words.contains(said), "{said} in {words}");
    }
    assert!(words.contains(driver["renderer"].as_str().unwrap()));
}

#[test]
fn a_display_that_does_not_answer_is_no_reason_that_pictures_cannot_be_drawn() {
    let nobody = Path::new(":98765");
    let (code, report) = doctor_json(&[("DISPLAY", nobody)]);
    assert_eq!(code, Some(0));
    assert_eq!(report["display"]["name"], "DISPLAY=:98765");
    assert_eq!(report["window"]["fails"]["kind"], "no-display");
    assert!(help_about(&report, "The display does not answer").is_some());
}

#[test]
fn a_folder_of_settings_that_cannot_be_written_is_said() {
    let folder = folder();
    let (_, report) = doctor_json(&[("XDG_CONFIG_HOME", folder.path())]);
    let settings = &report["settings"];
    let expected = folder.path().join("skeleton-editor");
    assert_eq!(settings["folder"], expected.to_str().unwrap());
    assert_eq!(settings["writable"], true);
    assert!(help_about(&report, "XDG_CONFIG_HOME").is_none());
    assert!(!expected.exists(), "it looks, and makes nothing");

    fs::write(&expected, "a file in its place").unwrap();
    let (code, report) = doctor_json(&[("XDG_CONFIG_HOME", folder.path())]);
    assert_eq!(code, Some(0));
    assert_eq!(report["settings"]["writable"], false);
    assert!(help_about(&report, "XDG_CONFIG_HOME").is_some());
}

/// Names under which EGL and OSMesa are loaded.
#[cfg(target_os = "linux")]
const LIBRARIES: [&str; 5] = [
    "libEGL.so.1",
    "libEGL.so",
    "libOSMesa.so.8",
    "libOSMesa.so.6",
    "libOSMesa.so",
];

#[cfg(target_os = "linux")]
#[test]
fn without_egl_and_osmesa_it_fails_and_names_the_packages_to_install() {
    let folder = folder();
    let path = folder.path();
    let break_all = |names: &[&str]| {
        for name in names {
            fs::write(path.join(name), "not a library").unwrap();
        }
    };
    break_all(&LIBRARIES[..2]);
    let (code, report) = doctor_json(&[("LD_LIBRARY_PATH", path)]);
    assert_eq!((code, &report["render"]), (Some(0), &"osmesa".into()));
    assert_eq!(report["egl"]["fails"]["kind"], "no-library");
    assert!(help_about(&report, "apt-get install libegl1").is_some());
    assert!(help_about(&report, "apt-get install libosmesa6").is_none());

    break_all(&LIBRARIES);
    let (code, report) = doctor_json(&[("LD_LIBRARY_PATH", path)]);
    assert_eq!((code, &report["render"]), (Some(1), &Value::Null));
    assert!(help_about(&report, "Pictures cannot be drawn").is_some());
    assert!(help_about(&report, "apt-get install libosmesa6").is_some());
    let (code, words) = doctor(false, &[("LD_LIBRARY_PATH", path)]);
    assert_eq!(code, Some(1));
    assert!(words.contains("editor render    does not work"), "{words}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_driver_that_is_too_old_is_said() {
    let old = [
        ("MESA_GL_VERSION_OVERRIDE", Path::new("2.1")),
        ("MESA_GLES_VERSION_OVERRIDE", Path::new("2.0")),
        ("LIBGL_ALWAYS_SOFTWARE", Path::new("1")),
    ];
    let (code, report) = doctor_json(&old);
    assert_eq!(code, Some(1));
    assert!(help_about(&report, "no driver with OpenGL 3.3").is_some());
    assert!(help_about(&report, "OSMesa has no OpenGL 3.3").is_some());
}

#[cfg(target_os = "linux")]
#[test]
fn a_driver_that_crashes_takes_only_its_own_trial_with_it() {
    let folder = folder();
    let source = folder.path().join("crash.c");
    let code = "#include <stdlib.h>\n__attribute__((constructor)) void start(void) { abort(); }\n";
    fs::write(&source, code).unwrap();
    let library = folder.path().join(LIBRARIES[0]);
    let compiled = Command::new("cc")
        .args(["-shared", "-fPIC", "-o"])
        .args([&library, &source])
        .status();
    assert!(compiled.unwrap().success());
    let (code, report) = doctor_json(&[("LD_LIBRARY_PATH", folder.path())]);
    assert_eq!((code, &report["render"]), (Some(0), &"osmesa".into()));
    assert_eq!(report["egl"]["fails"]["kind"], "crashed");
    assert!(help_about(&report, "The EGL driver crashes").is_some());
}
