//! A small good file of every format, and what happens to it.

use editor_core::editor::{Edit, Session};
use editor_core::io::{Diagnostic, Loaded, PoseFile};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Files in memory.
pub type Table = HashMap<PathBuf, Vec<u8>>;

pub const SCENE: &str = r#"{"format": "editor-scene", "version": 1, "view": {"camera": {"target": [0, 1, 0],
"radius": 4, "theta": 45, "phi": 30}, "look": "studio"}, "shapes": [{"kind": "cube", "scale": [4, 0.1, 4],
"color": "Gray"}, {"source": "man.obj", "color": [0.2, 0.4, 0.6], "pose": {"joints": {"Tip": [0, 0, 30]}},
"display": {"mode": "both", "point_size": 3}}, {"source": "box.obj", "name": "é", "visible": false, "locked": true}]}"#;

const GOOD: &[(&str, &str)] = &[
    ("a.scene", SCENE),
    (
        "man.obj",
        "v 0 0 0\nv 1.5 0 0\nv 0 1e0 0\nv 0 0 -1\nf 1 2 3\nf -1/1 2//1 3 # c\nvt 0 0\nvn 0 1 0\n",
    ),
    (
        "man.skel",
        "# two joints\n0 0 0.5 -1 # Root\r\n0 1 0 0 # Tip\n\n0 1 0 1\n",
    ),
    ("man.attach", "1 0\n0.5 0.5 \n0 1\n\n0 0.25\n"),
    (
        "box.obj",
        "mtllib box.mtl\no é\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0 2\nv 0 1 0\nv 0.2 0.3 0\nvt 0 0\nvn 0 0 1\nusemtl m\nf 1 2 3 4 5\nf 1/1/1 2/1/1 3/-1/-1\nl 1 2\n",
    ),
    (
        "box.mtl",
        "newmtl m\nKa 1 1 1\nKd 1 0.5 0\nNs 30\nd 1\nmap_Kd -s 1 1 1 box.png\nillum 2\n",
    ),
    (
        "wave.json",
        r#"{"joints": {"Tip": [0, 0.5, -5e1], "0": [1, 2, 3]}, "roots": {"Root": [0, 0.2, 0]}}"#,
    ),
];

/// The names of all the files.
pub fn names() -> impl Iterator<Item = &'static str> {
    GOOD.iter().map(|(name, _)| *name)
}

pub fn good() -> Table {
    let entry = |(name, text): &(&str, &str)| (PathBuf::from(name), text.as_bytes().to_vec());
    GOOD.iter().map(entry).collect()
}

/// A session with everything in `files`, and the warnings. The first error is returned.
pub fn open(files: &Table) -> Result<(Session, Vec<Diagnostic>), Diagnostic> {
    let mut loaded = Loaded::default();
    loaded.add(files, Path::new("a.scene"))?;
    let pose = PoseFile::read(Path::new("wave.json"), &files[Path::new("wave.json")])?;
    let mut session = Session::with_shapes(loaded.shapes, loaded.view.unwrap_or_default());
    let poses = pose.poses_for(session.scene())?.into_iter();
    let edits = poses.map(|(id, pose)| Edit::SetPose(id, pose)).collect();
    session.edit(Edit::Together(edits)).expect("poses that fit");
    Ok((session, loaded.warnings))
}

/// The good files with one of them replaced.
pub fn with(name: &str, bytes: impl Into<Vec<u8>>) -> Table {
    let mut files = good();
    files.insert(PathBuf::from(name), bytes.into());
    files
}
