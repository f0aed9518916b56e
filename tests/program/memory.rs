//! Files of a few bytes that ask for much memory, where there is little of it.

use crate::program::{Ran, folder};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Runs `editor` with `arguments` in `folder` and no more than `mib` MiB of memory, its own code
/// included.
fn editor_within(mib: u32, folder: &Path, arguments: &[&str]) -> Ran {
    let script = format!("ulimit -v {}; exec \"$0\" \"$@\"", mib * 1024);
    let output = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_editor")])
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// A GIF of one pixel whose head says that it has so many.
fn gif(width: u16, height: u16) -> Vec<u8> {
    let [width, height] = [width, height].map(u16::to_le_bytes);
    let tail = b"\x80\0\0\0\0\0\xff\xff\xff\x2c\0\0\0\0\x01\0\x01\0\0\x02\x02\x44\x01\0\x3b";
    [b"GIF89a", &width[..], &height, tail].concat()
}

#[test]
fn a_library_that_is_named_a_hundred_times_is_kept_once() {
    let folder = folder();
    let materials = (0..20_000).map(|number| format!("newmtl m{number}\nKd 1 0 0\n"));
    let libraries = (0..100).map(|number| format!("mtllib l{number}.mtl\n"));
    let square = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m7\nf 1 2 3\n";
    let obj = "mtllib a.mtl\n".repeat(100) + &libraries.collect::<String>() + square;
    fs::write(folder.path().join("a.obj"), obj).unwrap();
    let library = materials.collect::<String>();
    fs::write(folder.path().join("a.mtl"), &library).unwrap();
    for number in 0..100 {
        fs::write(folder.path().join(format!("l{number}.mtl")), &library).unwrap();
    }
    let ran = editor_within(400, folder.path(), &["check", "a.obj"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    assert!(ran.out.contains("  materials      m7\n"), "{}", ran.out);
}

#[test]
fn a_picture_larger_than_the_memory_is_refused_and_one_larger_than_any_is_so_by_its_size() {
    let folder = folder();
    let mtl = "newmtl a\nmap_Kd large.gif\nnewmtl b\nmap_Kd huge.gif\n";
    let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n";
    for (name, bytes) in [
        ("large.gif", gif(8192, 8192)),
        ("huge.gif", gif(10_000, 10_000)),
        ("a.mtl", mtl.into()),
        ("a.obj", obj.into()),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    let memory = "large.gif: expected a smaller picture, found one too large for the memory\n";
    let ran = editor_within(250, folder.path(), &["compare", "large.gif", "large.gif"]);
    let told = (ran.code, &*ran.err);
    assert_eq!(told, (Some(1), &*format!("error: {memory}")));
    let huge = "huge.gif: expected a picture of at most 67108864 pixels, as of 8192×8192, found \
                10000×10000\n";
    let ran = editor_within(250, folder.path(), &["compare", "huge.gif", "large.gif"]);
    let told = (ran.code, &*ran.err);
    assert_eq!(told, (Some(1), &*format!("error: {huge}")));
    let ran = editor_within(250, folder.path(), &["check", "a.obj"]);
    assert_eq!((ran.code, &*ran.err), (Some(0), ""));
    for warning in [memory, huge] {
        assert!(
            ran.out.contains(&format!("warning          {warning}")),
            "{}",
            ran.out
        );
    }
}
