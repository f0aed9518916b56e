//! Files with several poses, each with a name, as those of the course are:
//! `{"poses": {"walk": {"3": {"name": "Neck", "xyz_deg": [0, 20, 0]}}}}`.

use super::angle::{self, Degrees};
use super::json::Json;
use super::pose_data::{Angles, Entries, Key, PoseData};
use super::{Diagnostic, Files, PoseFile, builtin, scanner};
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::path::{Path, PathBuf};

/// Whatever has several poses.
#[derive(Deserialize)]
struct HasPoses {
    #[serde(rename = "poses")]
    _poses: IgnoredAny,
}

/// Members beside the poses are notes.
#[derive(Deserialize)]
struct Collection {
    poses: Entries<Entries<Turned>>,
}

#[derive(Deserialize)]
struct Turned {
    xyz_deg: Angles<Degrees>,
}

impl PoseFile {
    /// The poses of a file that has several, with their names, in its order; `None` for any other file.
    ///
    /// # Errors
    /// If it is no JSON, or one of its poses is not of that form.
    pub fn read_several(
        path: &Path,
        bytes: &[u8],
    ) -> Result<Option<Vec<(String, Self)>>, Diagnostic> {
        let json = Json::parse(path, bytes)?;
        if json.read::<HasPoses>().is_err() {
            return Ok(None);
        }
        let Collection { poses } = json.read()?;
        let turned = |(key, turned): (Key, Turned)| (key, angle::euler(turned.xyz_deg.0));
        let named = poses.0.into_iter().map(|(name, joints)| {
            let joints = Entries(joints.0.into_iter().map(turned).collect());
            let roots = Entries::default();
            let pose = PoseData { joints, roots };
            (name.as_str().to_owned(), Self::of(&json, path, pose))
        });
        Ok(Some(named.collect()))
    }
}

impl PoseFile {
    /// Reads the pose that an argument or a file of tests names: a file with one pose, `builtin:NAME`, or
    /// `FILE#NAME` for a pose of a file with several.
    ///
    /// # Errors
    /// If the file cannot be read, or has several poses and none is named, or not the one that is.
    pub fn open(files: &dyn Files, named: &Path) -> Result<Self, Diagnostic> {
        let path = builtin::resolve(named)?;
        let Some((path, name)) = pose_of_several(files, &path) else {
            return Self::read(&path, &files.read(&path)?);
        };
        let Some(mut several) = Self::read_several(&path, &files.read(&path)?)? else {
            let message = format!(
                "expected a file with several poses, as {{\"poses\": {{…}}}}, to have one called {name}"
            );
            return Err(Diagnostic::new(&path, message));
        };
        match several.iter().position(|(other, _)| *other == name) {
            Some(place) => Ok(several.swap_remove(place).1),
            None => {
                let message = format!(
                    "expected one of its poses ({}), found {}",
                    names(&several),
                    scanner::quoted(&name)
                );
                Err(Diagnostic::new(&path, message))
            }
        }
    }

    /// The one pose of `several`.
    ///
    /// # Errors
    /// If there are more, or none.
    pub(super) fn only(path: &Path, mut several: Vec<(String, Self)>) -> Result<Self, Diagnostic> {
        if several.len() == 1 {
            return Ok(several.remove(0).1);
        }
        let message = match several.first() {
            None => "expected a pose, found an empty list of poses".to_owned(),
            Some((first, _)) => format!(
                "expected one pose, found {} ({}): one of them is {}#{}",
                several.len(),
                names(&several),
                path.display(),
                scanner::shown(first)
            ),
        };
        Err(Diagnostic::new(path, message))
    }
}

/// The file and the name in `FILE#NAME`; `None` if the whole of it is a file, or there is no such file.
pub fn pose_of_several(files: &dyn Files, path: &Path) -> Option<(PathBuf, String)> {
    if files.exists(path) {
        return None;
    }
    let named = path.to_str()?;
    let parts = named
        .match_indices('#')
        .map(|(at, _)| (&named[..at], &named[at + 1..]));
    let mut found = parts.filter(|(file, _)| files.exists(Path::new(file)));
    found
        .next()
        .map(|(file, name)| (file.into(), name.to_owned()))
}

fn names(several: &[(String, PoseFile)]) -> String {
    let names: Vec<&str> = several.iter().map(|(name, _)| &**name).collect();
    scanner::shown(&names.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    const SEVERAL: &str = r#"{"euler": "Rx Ry Rz", "poses": {
        "walk": {"3": {"name": "Neck", "xyz_deg": [0, 20, 0]}},
        "kick": {"0": {"xyz_deg": [0, 0, 30]}, "Left knee": {"xyz_deg": [50, 0, 0]}}}}"#;

    fn read(text: &str) -> Result<Option<Vec<(String, PoseFile)>>, Diagnostic> {
        PoseFile::read_several(Path::new("p.json"), text.as_bytes())
    }

    #[test]
    fn each_pose_has_its_name_and_its_joints() {
        let poses = read(SEVERAL).unwrap().unwrap();
        let written: Vec<(&str, String)> = poses
            .iter()
            .map(|(name, pose)| (&**name, pose.data().to_json()))
            .collect();
        let expected = [
            ("walk", r#"{"joints": {"3": [0, 20, 0]}}"#),
            (
                "kick",
                r#"{"joints": {"0": [0, 0, 30], "Left knee": [50, 0, 0]}}"#,
            ),
        ];
        let expected = expected.map(|(name, text)| {
            let pose = PoseFile::read(Path::new("p.json"), text.as_bytes()).unwrap();
            (name, pose.data().to_json())
        });
        assert_eq!(written, expected);
    }

    #[test]
    fn a_file_with_one_pose_is_another_matter_and_a_wrong_one_tells_where() {
        assert!(read(r#"{"joints": {}}"#).unwrap().is_none());
        let error = read(r#"{"poses": {"walk": {"3": {"xyz_deg": [0, 20]}}}}"#).unwrap_err();
        assert!(error.to_string().starts_with("p.json:1:"), "{error}");
    }

    #[test]
    fn where_one_pose_is_expected_the_names_of_several_are_told_and_one_of_them_can_be_named() {
        let files: HashMap<PathBuf, Vec<u8>> = [
            ("p.json", SEVERAL),
            ("p#kick.json", r#"{"joints": {"Neck": [1, 2, 3]}}"#),
            (
                "one.json",
                r#"{"poses": {"bow": {"2": {"xyz_deg": [7, 0, 0]}}}}"#,
            ),
            ("none.json", r#"{"poses": {}}"#),
        ]
        .map(|(path, text)| (path.into(), text.as_bytes().to_vec()))
        .into();
        let open = |named: &str| {
            let pose = PoseFile::open(&files, Path::new(named));
            let pose = pose.map(|pose| pose.data().to_json());
            pose.map_err(|error| error.to_string())
        };
        for (named, expected) in [
            ("p.json#walk", Ok(r#"{"joints": {"3": [0, 20, 0]}}"#)),
            ("p#kick.json", Ok(r#"{"joints": {"Neck": [1, 2, 3]}}"#)),
            ("one.json", Ok(r#"{"joints": {"2": [7, 0, 0]}}"#)),
            ("one.json#bow", Ok(r#"{"joints": {"2": [7, 0, 0]}}"#)),
            (
                "p.json",
                Err("p.json: expected one pose, found 2 (walk, kick): one of them is p.json#walk"),
            ),
            (
                "p.json#wlak",
                Err("p.json: expected one of its poses (walk, kick), found “wlak”"),
            ),
            (
                "p#kick.json#a",
                Err(
                    "p#kick.json: expected a file with several poses, as {\"poses\": {…}}, to have one called a",
                ),
            ),
            (
                "none.json",
                Err("none.json: expected a pose, found an empty list of poses"),
            ),
            ("q.json#walk", Err("q.json#walk: there is no such file")),
        ] {
            let found = open(named);
            let expected = expected.map(|text| {
                let pose = PoseFile::read(Path::new("p.json"), text.as_bytes()).unwrap();
                pose.data().to_json()
            });
            assert_eq!(found, expected.map_err(str::to_owned), "{named}");
        }
    }
}
