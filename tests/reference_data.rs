//! Where the results of other programs are that ours are compared with. They are not part of this
//! project: `EDITOR_REFERENCE_DATA` names the folder that holds `data`.

use std::fs;
use std::path::PathBuf;

/// The file or folder `name` below `data`; `None`, told on standard error, where there is no
/// reference data.
///
/// # Panics
/// If it is missing although `EDITOR_REQUIRE_REFERENCE=1` says that it must be there.
pub fn reference(name: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("EDITOR_REFERENCE_DATA");
    let path = folder.map(|folder| PathBuf::from(folder).join("data").join(name));
    if let Some(path) = path.filter(|path| path.exists()) {
        return Some(path);
    }
    let required = std::env::var_os("EDITOR_REQUIRE_REFERENCE").is_some_and(|value| value == "1");
    assert!(
        !required,
        "{name} is required but not in EDITOR_REFERENCE_DATA"
    );
    eprintln!("left out: {name}, for EDITOR_REFERENCE_DATA does not lead to it");
    None
}

/// The file `name` below `data/course`, as [`reference`] finds it.
pub fn course(name: &str) -> Option<PathBuf> {
    reference(&format!("course/{name}"))
}

/// Joint and degrees about X, Y and Z of the course's pose `name`.
pub fn course_pose(name: &str) -> Option<Vec<(String, [f32; 3])>> {
    let text = fs::read_to_string(course("poses.json")?).unwrap();
    let poses: serde_json::Value = serde_json::from_str(&text).unwrap();
    let joints = poses["poses"][name].as_object().unwrap();
    let degrees = |value: &serde_json::Value| {
        [0, 1, 2].map(|axis| value["xyz_deg"][axis].as_f64().unwrap() as f32)
    };
    Some(
        joints
            .iter()
            .map(|(joint, value)| (joint.clone(), degrees(value)))
            .collect(),
    )
}

/// The numbers of the lines of `posed/NAME.txt` that start with `key`.
pub fn posed(name: &str, key: &str) -> Option<Vec<Vec<f32>>> {
    let text = fs::read_to_string(course(&format!("posed/{name}.txt"))?).unwrap();
    let lines = text.lines().filter_map(|line| line.strip_prefix(key));
    Some(
        lines
            .map(|line| {
                line.split_whitespace()
                    .map(|n| n.parse().unwrap())
                    .collect()
            })
            .collect(),
    )
}
